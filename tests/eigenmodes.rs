//! What a gear does at an eigenvalue, and where the energy of that comes from.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::{LN_2, TAU};

use common::{
    linear::{gear, gear_of, random_gear, value_of},
    random::Random,
};
use nalgebra::Complex;
use shimmy::model;

#[test]
fn a_mode_solves_the_equations_and_its_energy_adds_up() {
    let mut random = Random::seeded(13);
    let models = model::list();
    let mut flows = 0;
    for case in 0..4_000 {
        let run = random_gear(&mut random, models[case % models.len()].name);
        let jacobian = run.linearised().unwrap().jacobian;
        let (modes, values) = (run.eigenmodes().unwrap(), run.eigenvalues().unwrap());
        assert_eq!(modes.iter().map(|mode| mode.eigenvalue).collect::<Vec<_>>(), values);
        for mode in modes {
            let (lambda, shape) = (mode.eigenvalue, &mode.shape);
            assert_eq!(shape[mode.reference], Complex::from(1.0));
            for row in 0..shape.len() {
                let terms: Vec<Complex<f64>> = (0..shape.len()).map(|i| shape[i] * jacobian[(row, i)]).collect();
                let sum: Complex<f64> = terms.iter().sum();
                let size = terms.iter().fold((lambda * shape[row]).norm(), |most, term| most.max(term.norm()));
                assert!((sum - lambda * shape[row]).norm() <= 1e-9 * size.max(1.0), "{run:?}: {mode:?} row {row}");
            }
            assert!((mode.natural_frequency * TAU - lambda.norm()).abs() <= 1e-12 * lambda.norm());
            if let Some(time) = mode.time_to_half {
                assert!(mode.time_to_double.is_none() && (time * lambda.re + LN_2).abs() < 1e-12);
            }
            if let Some(time) = mode.time_to_double {
                assert!((time * lambda.re - LN_2).abs() < 1e-12);
            }
            let Some(flow) = mode.energy_flow else { continue };
            let parts = [flow.tire, -flow.damper, -flow.tread_width];
            let scale = parts.iter().fold(1.0, |most: f64, part| most.max(part.abs()));
            assert!((parts.iter().sum::<f64>() - lambda.re).abs() < 1e-9 * scale, "{run:?}: {mode:?}");
            assert!((flow.stored - lambda.re).abs() < 1e-12 * scale && flow.stored == flow.kinetic + flow.spring);
            // What a damper takes of a swing's energy: c|ψ̇|² over I_z|ψ̇|² + k|ψ|², with |ψ̇| = |λ||ψ|.
            let free = run.description().name == "torsional" && value_of(&run, "freeplayAngle") > 0.0;
            let k = if free { 0.0 } else { value_of(&run, "torsionalStiffness") };
            let (rate, i_z) = (lambda.norm_sqr(), value_of(&run, "momentOfInertia"));
            let damper = value_of(&run, "dampingConstant") * rate / (i_z * rate + k);
            assert!((flow.damper - damper).abs() < 1e-9 * scale, "{run:?}: {mode:?} {damper}");
            flows += 1;
        }
    }
    assert!(flows > 8_000, "{flows}");
}

#[test]
fn a_mode_is_what_the_gear_does() {
    // theory.md, section 3: |ψ|/|y| = |λ + v/σ|/|v + λ(e − a)|. At the boundary a cycle of the linear gear is the mode.
    let gear_at = |e: f64| gear_of("torsional-linear", &[("dampingConstant", 20.0), ("casterLength", e)]);
    for e in [0.05, 0.1, 0.2] {
        let v = gear_at(e).routh_hurwitz().unwrap().critical_velocities[0];
        let run = gear_at(e).with("velocity", v).unwrap();
        let [mode, other, _] = &run.eigenmodes().unwrap()[..] else { panic!() };
        let (lambda, y) = (mode.eigenvalue, mode.shape[2]);
        assert_eq!((mode.reference, other.shape[2]), (0, y.conj()));
        let expected = (lambda * (e - 0.1) + v) / (lambda + v / 0.3);
        assert!((y - expected).norm() < 1e-12 * y.norm(), "{y} {expected}");

        let period = TAU / lambda.im;
        let run = run.starting("torsionAngle", 0.01).unwrap();
        let run =
            run.starting("lateralDeformation", 0.01 * y.re).unwrap().lasting(period).unwrap().within(1e-12).unwrap();
        let start = mode.shape[1].re * 0.01;
        let energy = run.starting("torsionRate", start).unwrap().energy().unwrap().unwrap();
        let flow = mode.energy_flow.unwrap();
        // Half of ½k|ψ|² + ½I_z|ψ̇|² is the mean; the mean power over twice of it is the rate.
        let mean = 0.25e-4 * (1e5 + lambda.norm_sqr());
        for (rate, total) in
            [(flow.tire, energy.tire), (flow.damper, energy.damper), (flow.tread_width, energy.tread_width)]
        {
            assert!((rate - total / period / (2.0 * mean)).abs() < 1e-7 * rate.abs(), "{flow:?} {energy:?}");
        }
        assert!(mode.damping_ratio.unwrap().abs() < 1e-12);
    }
}

#[test]
fn a_state_that_the_wheel_does_not_move_is_its_own_reference() {
    // Without a load the tire does not turn the wheel: its deformation fades by itself, and takes no energy with it.
    let modes = gear(&[("verticalForce", 0.0)]).eigenmodes().unwrap();
    let tire = modes.iter().find(|mode| mode.eigenvalue.im == 0.0).unwrap();
    assert_eq!((tire.reference, tire.energy_flow), (2, None));
    assert!((tire.eigenvalue.re + 50.0 / 0.3).abs() < 1e-11 && tire.damping_ratio == Some(1.0));
    assert!(
        modes.iter().filter(|mode| mode.eigenvalue.im != 0.0).all(|mode| mode.energy_flow.unwrap().tire.abs() < 1e-12)
    );
}
