//! Poincaré's section against closed forms and limit cycles.
#![cfg(not(target_arch = "wasm32"))]

use shimmy::{Run, section::SectionSpec};

fn run(v: f64, c: f64) -> Run {
    Run::of("torsional").unwrap().with("velocity", v).unwrap().with("dampingConstant", c).unwrap()
}

/// Once the real eigenvalue's part has died out, a linear motion is e^{λt}: it passes each 2π/ω, and every turn is e^{2π re/ω}
/// times the one before.
#[test]
fn a_linear_motion_returns_in_geometric_series() {
    let linear =
        Run::of("torsional-linear").unwrap().with("velocity", 30.0).unwrap().with("dampingConstant", 30.0).unwrap();
    let linear = linear.starting("torsionAngle", 0.05).unwrap().within(1e-12).unwrap().lasting(1.0).unwrap();
    let pair = linear.eigenvalues().unwrap()[0];
    let period = std::f64::consts::TAU / pair.im;
    for (rising, level_state) in [(true, 0), (false, 0), (true, 1), (false, 2)] {
        let spec = SectionSpec { state: level_state, rising, after: 0.3, ..SectionSpec::default() };
        let section = linear.section(&spec).unwrap();
        // 0.7 s of some fifty swings a second.
        assert!((0.7 / period - section.time.len() as f64).abs() <= 1.0);
        assert_eq!(section.amplitude.len(), section.time.len() - 1);
        for passage in section.time.windows(2) {
            assert!((passage[1] - passage[0] - period).abs() < 1e-9);
        }
        let ratio = (pair.re * period).exp();
        for amplitudes in section.amplitude.windows(2) {
            assert!((amplitudes[1] / amplitudes[0] / ratio - 1.0).abs() < 1e-6, "{amplitudes:?} {ratio}");
        }
        assert!(section.states[level_state].iter().all(|value| value.abs() < 1e-9));
    }
}

#[test]
fn a_limit_cycle_is_a_point_of_the_map() {
    let gear = run(80.0, 30.0);
    let cycle = gear.limit_cycle(None).unwrap().unwrap();
    let motion = gear.clone().starting("torsionAngle", 0.05).unwrap().within(1e-10).unwrap().lasting(6.0).unwrap();
    let section = motion.section(&SectionSpec { after: 5.0, ..SectionSpec::default() }).unwrap();
    for passage in section.time.windows(2) {
        assert!((passage[1] - passage[0] - cycle.period).abs() < 1e-8);
    }
    for amplitude in &section.amplitude {
        assert!((amplitude / cycle.amplitude[0] - 1.0).abs() < 1e-6, "{amplitude}");
    }
    // The orbit begins where ψ rises through zero.
    for (column, orbit) in section.states.iter().zip(&cycle.orbit.states).skip(1) {
        assert!(column.iter().all(|value| (value / orbit[0] - 1.0).abs() < 1e-5), "{} {}", column[0], orbit[0]);
    }
    // The return map's points lie on a curve that meets the diagonal there: from below it goes up, from above down.
    for start in [0.05, 0.5] {
        let motion = gear.clone().starting("torsionAngle", start).unwrap().lasting(3.0).unwrap();
        let amplitude = motion.section(&SectionSpec::default()).unwrap().amplitude;
        let towards = |pair: &[f64]| {
            let gap = [pair[0], pair[1]].map(|amplitude| (amplitude - cycle.amplitude[0]).abs());
            gap[1] <= gap[0] || gap[0] < 1e-5
        };
        assert!(amplitude.windows(2).skip(2).all(towards), "from {start}: {amplitude:?}");
    }
}

#[test]
fn levels_beyond_the_motion_are_not_passed() {
    let motion = run(80.0, 30.0).starting("torsionAngle", 0.05).unwrap().lasting(1.0).unwrap();
    let high = SectionSpec { level: 0.3, ..SectionSpec::default() };
    let section = motion.section(&high).unwrap();
    assert!(section.time.is_empty() && section.amplitude.is_empty());
    let within = motion.section(&SectionSpec { level: 0.1, after: 0.5, ..SectionSpec::default() }).unwrap();
    assert!(
        within.states[0].iter().all(|psi| (psi - 0.1).abs() < 1e-9) && within.states[1].iter().all(|rate| *rate > 0.0)
    );
    assert_eq!(motion.at_most(10.0).unwrap().section(&high).unwrap_err().field, "maxSteps");
}
