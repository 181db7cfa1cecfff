//! Force laws one by one, at a state and as curves, against the printed equations.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

use common::linear::gear_of;
use shimmy::{
    Run,
    model::laws::{Curves, ForceLaws},
    run::Value,
};

const DEGREE: f64 = PI / 180.0;

fn curves_of(run: &Run, slip: f64, torsion: f64, samples: f64) -> ForceLaws {
    run.force_laws(&Curves::new(slip, torsion, samples).unwrap()).unwrap()
}

/// theory.md, section 1, with the default constants: F_y and M_z.
fn printed(alpha: f64) -> (f64, f64) {
    let force = if alpha.abs() <= 5.0 * DEGREE { 180_000.0 * alpha } else { 180_000.0 * 5.0 * DEGREE * alpha.signum() };
    let limit = 10.0 * DEGREE;
    let moment = if alpha.abs() <= limit { -18_000.0 * (limit / PI) * (PI * alpha / limit).sin() } else { 0.0 };
    (force, moment)
}

#[test]
fn curves_are_the_printed_laws_with_their_kinks_among_the_points() {
    let gap = 1.0 * DEGREE;
    let laws = curves_of(&gear_of("torsional", &[("freeplayAngle", gap)]), 20.0 * DEGREE, 4.0 * DEGREE, 100.0);
    for ((alpha, force), moment) in laws.slip_angle.iter().zip(&laws.side_force).zip(&laws.aligning_moment) {
        let expected = printed(*alpha);
        assert!((force - expected.0).abs() < 1e-10 && (moment - expected.1).abs() < 1e-11, "α = {alpha}");
    }
    for (psi, restoring) in laws.torsion_angle.iter().zip(&laws.restoring_moment) {
        let wound = psi.signum() * (psi.abs() - gap).max(0.0);
        assert!((restoring + 1e5 * wound).abs() < 1e-9, "ψ = {psi}");
    }
    for (column, kinks) in [(&laws.slip_angle, [5.0 * DEGREE, 10.0 * DEGREE].as_slice()), (&laws.torsion_angle, &[gap])]
    {
        assert_eq!(column.len(), 100 + 2 * kinks.len());
        assert!(column.windows(2).all(|pair| pair[0] < pair[1]));
        for kink in kinks {
            assert!(column.contains(kink) && column.contains(&-kink));
        }
        assert_eq!(column[0], -column[column.len() - 1]);
    }
    assert_eq!(laws.slip_angle[0], -20.0 * DEGREE);
    let kinks = laws.kinks;
    assert_eq!(kinks.side_force_limit_angle, Some(5.0 * DEGREE));
    assert_eq!((kinks.aligning_moment_limit_angle, kinks.freeplay_angle), (Some(10.0 * DEGREE), Some(gap)));
}

#[test]
fn a_kink_that_is_a_sample_or_out_of_sight_makes_no_other_point() {
    // ±10° with 5 points: −10, −5, 0, 5, 10; δ = 5° is one of them, α_g = 10° the end.
    let laws = curves_of(&gear_of("torsional", &[]), 10.0 * DEGREE, 0.1, 5.0);
    assert_eq!(laws.slip_angle.len(), 5);
    assert_eq!(laws.torsion_angle.len(), 5);
    assert_eq!(laws.kinks.freeplay_angle, None);
    let never = curves_of(&gear_of("torsional", &[("sideForceLimitAngle", 2.0)]), 1.5, 0.1, 2.0);
    assert_eq!(never.kinks.side_force_limit_angle, None);
    assert_eq!(never.slip_angle.len(), 4, "α_g is left");
}

#[test]
fn the_linear_gear_has_straight_laws() {
    let linear = gear_of("torsional-linear", &[]);
    let laws = curves_of(&linear, 20.0 * DEGREE, 0.2, 11.0);
    for i in 0..11 {
        let (alpha, psi) = (laws.slip_angle[i], laws.torsion_angle[i]);
        assert!((laws.side_force[i] - 180_000.0 * alpha).abs() < 1e-9);
        assert!((laws.aligning_moment[i] + 18_000.0 * alpha).abs() < 1e-10);
        assert!((laws.restoring_moment[i] + 1e5 * psi).abs() < 1e-9);
    }
    let forces = linear.forces(&[0.02, 3.0, 0.03]).unwrap();
    assert_eq!((forces.slip_angle, forces.side_force_limited, forces.spring_angle), (0.03 / 0.3, false, 0.02));
    assert!((forces.side_force - 18_000.0).abs() < 1e-9 && (forces.aligning_moment + 1_800.0).abs() < 1e-10);
    assert!((forces.spring_torque + 2_000.0).abs() < 1e-9);
}

/// At every point of the curves the moving point of a motion lies on them.
#[test]
fn forces_at_a_state_lie_on_the_curves() {
    for run in [gear_of("torsional", &[("freeplayAngle", 0.01)]), gear_of("torsional-linear", &[])] {
        let laws = curves_of(&run, 15.0 * DEGREE, 0.03, 31.0);
        for (i, alpha) in laws.slip_angle.iter().enumerate() {
            let slip_ratio = if run.description().name == "torsional" { alpha.tan() } else { *alpha };
            let forces = run.forces(&[0.0, 0.0, 0.3 * slip_ratio]).unwrap();
            assert!((forces.side_force - laws.side_force[i]).abs() < 1e-9);
            assert!((forces.aligning_moment - laws.aligning_moment[i]).abs() < 1e-9);
        }
        for (i, psi) in laws.torsion_angle.iter().enumerate() {
            assert!((run.forces(&[*psi, 0.0, 0.0]).unwrap().spring_torque - laws.restoring_moment[i]).abs() < 1e-9);
        }
    }
}

#[test]
fn what_cannot_be_drawn_is_refused() {
    let field = |slip, torsion, samples| Curves::new(slip, torsion, samples).unwrap_err().field.clone();
    assert_eq!(field(0.0, 1.0, 10.0), "slipAngle");
    assert_eq!(field(FRAC_PI_2, 1.0, 10.0), "slipAngle");
    assert_eq!(field(1.0, f64::NAN, 10.0), "torsionAngle");
    for samples in [1.0, 2.5, 1e6, f64::INFINITY] {
        assert_eq!(field(1.0, 1.0, samples), "samples");
    }
    assert_eq!(Curves::read(&Value::Absent).unwrap(), Curves::new(20.0 * DEGREE, 20.0 * DEGREE, 201.0).unwrap());
    // A tire so short that a swing of a centimetre is an infinite slip.
    let short = gear_of("torsional-linear", &[("relaxationLength", 1e-320)]);
    assert_eq!(short.forces(&[0.0, 0.0, 0.01]).unwrap_err().code.name(), "not-finite");
    assert_eq!(gear_of("torsional", &[]).forces(&[0.0; 2]).unwrap_err().field, "state");
    assert_eq!(gear_of("torsional", &[]).forces(&[0.0, f64::NAN, 0.0]).unwrap_err().field, "torsionRate");
}
