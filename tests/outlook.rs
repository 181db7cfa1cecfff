//! What becomes of a motion, where it is hard to say: near the Hopf points, at rest away from the middle, in the gap.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::linear;
use shimmy::{
    Run,
    cycles::BifurcationSpec,
    outlook::{Outlook, Trend, Verdict},
    stability::Variation,
};

/// The gear at 80 m/s with damping `c`, from the torsion angle `psi`.
fn at_80(c: f64, psi: f64) -> Outlook {
    at_80_run(c).starting("torsionAngle", psi).unwrap().outlook().unwrap()
}

fn at_80_run(c: f64) -> Run {
    linear::gear(&[("velocity", 80.0), ("dampingConstant", c)])
}

fn gear(parameters: &[(&str, f64)], psi: f64) -> Outlook {
    linear::gear(parameters).starting("torsionAngle", psi).unwrap().outlook().unwrap()
}

#[test]
fn the_verdict_changes_at_the_critical_damping() {
    // Closed form (a₂a₁ = a₀ of the linear gear): 48.530 N m s/rad at 80 m/s. Growth there is 0.003 a second: nothing
    // that six seconds could show.
    for psi in [0.002, 0.05, 0.3] {
        assert_eq!(at_80(48.52, psi).verdict, Verdict::Shimmies, "from {psi}");
        assert_eq!(at_80(48.54, psi).verdict, Verdict::DiesOut, "from {psi}");
    }
}

#[test]
fn on_the_boundary_itself_a_swing_dies_out() {
    // There the linear gear swings on for ever, and the tire, whose forces grow less than the slip, takes from any larger swing.
    let critical = at_80_run(20.0).routh_hurwitz().unwrap().critical_damping.unwrap();
    for psi in [0.02, 0.05, 0.3] {
        let outlook = at_80(critical, psi);
        assert_eq!(outlook.verdict, Verdict::DiesOut, "from {psi}: heads for {}", outlook.amplitude[0]);
    }
}

#[test]
fn the_verdict_changes_at_the_critical_speeds() {
    // Published linear theory, defaults with c = 20: unstable between 27.600 and 501.75 m/s.
    for (v, verdict) in
        [(27.58, Verdict::DiesOut), (27.62, Verdict::Shimmies), (501.0, Verdict::Shimmies), (502.5, Verdict::DiesOut)]
    {
        assert_eq!(gear(&[("velocity", v), ("dampingConstant", 20.0)], 0.02).verdict, verdict, "at {v} m/s");
    }
}

#[test]
fn near_the_boundary_the_cycle_is_the_same_from_inside_and_outside() {
    // 2.145° at c = 48: fixed-step RK4 of the printed equations over 200 s, from either side.
    for c in [46.0, 48.0, 48.4] {
        let (inside, outside) = (at_80(c, 0.003), at_80(c, 0.2));
        assert!((inside.amplitude[0] / outside.amplitude[0] - 1.0).abs() < 1e-5, "c = {c}");
        assert!((inside.frequency.unwrap() - outside.frequency.unwrap()).abs() < 1e-4);
    }
    assert!((at_80(48.0, 0.05).amplitude[0].to_degrees() - 2.145).abs() < 1e-3);
}

#[test]
fn a_long_run_agrees_with_the_shortcut() {
    // c = 47: slow enough that the shortcut is taken (growth 0.08 a second), fast enough that 120 s arrive.
    let told = at_80(47.0, 0.05).amplitude[0];
    let run = Run::of("torsional").unwrap().with("velocity", 80.0).unwrap().with("dampingConstant", 47.0).unwrap();
    let run = run.starting("torsionAngle", 0.05).unwrap().lasting(120.0).unwrap().sampled(2_400_001.0).unwrap();
    let psi = &run.simulate().unwrap().states[0];
    let late = psi[psi.len() - 10_000..].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    // Samples 50 µs apart miss a peak by up to (ω Δt/2)²/2 = 3.5e-5 of it.
    assert!((late / told - 1.0).abs() < 1e-4, "{late} {told}");
}

#[test]
fn a_wheel_that_stops_at_an_angle_rests() {
    // A wheel that leads its axis, in a gap of ± 1°: the tire holds it against the end of the gap.
    let parameters =
        [("velocity", 30.0), ("dampingConstant", 20.0), ("casterLength", -0.2), ("freeplayAngle", 1_f64.to_radians())];
    for psi in [0.1, 0.001] {
        let outlook = gear(&parameters, psi);
        assert_eq!(outlook.verdict, Verdict::Rests, "from {psi}");
        assert!((outlook.amplitude[0] - 0.02140).abs() < 1e-4, "{}", outlook.amplitude[0]);
        assert_eq!(outlook.frequency, None);
    }
}

#[test]
fn a_wheel_that_stands_at_an_angle_rests_however_little_it_still_moves() {
    // What is left of the motion is no faster at the start of the look than rounding leaves it at the end.
    let run = || {
        linear::gear(&[("velocity", 80.0), ("dampingConstant", 100.0), ("casterLength", -0.3), ("freeplayAngle", 0.3)])
            .starting("torsionAngle", 0.05)
            .unwrap()
    };
    let stands = run().outlook().unwrap().amplitude;
    // The tire's lateral deformation stays where v sin ψ = v y/σ, in the small-angle kinematics: y = σψ.
    assert!((stands[2] / (0.3 * stands[0]) - 1.0).abs() < 1e-6, "{stands:?}");
    for time in (1..60).map(|count| 0.03 * f64::from(count)) {
        let come = run().lasting(time).unwrap().simulate().unwrap();
        let now = come.states.iter().map(|column| *column.last().unwrap()).collect::<Vec<_>>();
        let from = ["torsionAngle", "torsionRate", "lateralDeformation"].iter().zip(&now);
        let outlook = from.fold(run(), |run, (name, value)| run.starting(name, *value).unwrap()).outlook().unwrap();
        assert_eq!(outlook.verdict, Verdict::Rests, "after {time} s");
        assert!((outlook.amplitude[0] - stands[0]).abs() < 1e-6, "after {time} s: {}", outlook.amplitude[0]);
    }
}

#[test]
fn a_rattle_is_told_from_a_shimmy_by_taking_the_gap_away() {
    let gap = ("freeplayAngle", 1_f64.to_radians());
    let rattle = gear(&[("velocity", 50.0), ("dampingConstant", 100.0), gap], 0.05);
    assert_eq!(rattle.verdict, Verdict::Rattles);
    assert!((rattle.amplitude[0] - 0.022_268).abs() < 1e-6);
    let shimmy = gear(&[("velocity", 50.0), ("dampingConstant", 30.0), gap], 0.05);
    assert_eq!(shimmy.verdict, Verdict::Shimmies);
    assert!((shimmy.amplitude[0] - 0.235_77).abs() < 1e-5);
}

/// theory.md, section 3: computed independently, to half a unit of the last digit given.
#[test]
fn every_state_has_its_amplitude() {
    let near = |outlook: &Outlook, state: usize, value: f64, digit: f64| {
        let got = outlook.amplitude[state];
        assert!((got - value).abs() < 0.6 * digit, "state {state}: {got} for {value}");
    };
    let strong = at_80(10.0, 0.05);
    near(&strong, 0, 0.392_38, 1e-5);
    near(&strong, 1, 124.89, 1e-2);
    near(&strong, 2, 0.074_90, 1e-5);
    let weak = at_80(30.0, 0.05);
    near(&weak, 0, 0.206_32, 1e-5);
    near(&weak, 1, 67.23, 1e-2);
    let slow = gear(&[("velocity", 40.0), ("dampingConstant", 20.0)], 0.05);
    near(&slow, 1, 100.65, 1e-2);
    near(&slow, 2, 0.036_12, 1e-5);
    // The orbit is one round of the same motion: its points lie within, and come near.
    for (column, amplitude) in strong.orbit.states.iter().zip(&strong.amplitude) {
        let most = column.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!(most <= amplitude * (1.0 + 1e-12) && most > 0.999 * amplitude);
    }
}

#[test]
fn on_an_unstable_cycle_nothing_is_settled() {
    let trailing = [
        ("velocity", 102.0),
        ("dampingConstant", 29.0),
        ("casterLength", -0.2),
        ("aligningMomentDerivative", 4.8),
        ("sideForceLimitAngle", 0.047),
        ("aligningMomentLimitAngle", 0.29),
    ];
    let rubbed = [("velocity", 80.0), ("dampingConstant", 20.0), ("friction.moment", 80.0)];
    for (parameters, inside) in [(&trailing[..], Verdict::DiesOut), (&rubbed[..], Verdict::Rests)] {
        let run = linear::gear(parameters);
        let velocity = parameters[0].1;
        let diagram =
            BifurcationSpec::of(run.clone(), Variation::of("velocity", velocity, velocity + 5.0)).made().unwrap();
        for branch in diagram.cycles() {
            let point = branch.points.iter().find(|point| point.value == velocity).unwrap();
            let from = |factor: f64| {
                let states = run.description().state.iter().zip(&point.state);
                let start = states.fold(run.clone(), |run, (state, x)| run.starting(state.name, factor * x).unwrap());
                start.outlook().unwrap()
            };
            let there = from(1.0);
            let stable = point.unstable == 0;
            assert_eq!((there.stable, there.settled), (Some(stable), stable), "{parameters:?}");
            assert_eq!(there.trend, Trend::Steady);
            assert!((there.amplitude[0] / point.amplitude[0] - 1.0).abs() < 1e-5);
            let (less, more) = (from(0.98), from(1.02));
            assert_eq!((less.stable, more.stable), (None, None));
            if !stable {
                assert_eq!((less.verdict, more.verdict), (inside, Verdict::Shimmies));
                assert_eq!((less.trend, more.trend), (Trend::Falling, Trend::Growing));
            }
        }
        assert!(diagram.cycles().iter().any(|branch| branch.points[0].unstable == 1), "{parameters:?}");
    }
}

#[test]
fn a_swing_beside_others_is_not_unstable() {
    // Off the ground and without damping every swing goes on as it is, whatever its size.
    let free = [("verticalForce", 0.0), ("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
    let state = |run: Run| run.starting("torsionAngle", 0.1).unwrap().within(1e-12).unwrap();
    let outlook = state(linear::gear(&free)).outlook().unwrap();
    assert_eq!((outlook.stable, outlook.settled), (Some(true), true), "{outlook:?}");
}
