//! Limit cycles: against values from outside, long simulations and finite differences.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{linear::gear, random::Random, reference};
use nalgebra::{Complex, DMatrix};
use shimmy::{
    Code, Run,
    cycles::{Guess, LimitCycle},
    outlook::Verdict,
    stability::eigenvalues,
};

fn cycle(parameters: &[(&str, f64)]) -> LimitCycle {
    gear(parameters).limit_cycle(None).unwrap().expect("a limit cycle")
}

/// A state on the cycle, as a guess for another.
fn guess(cycle: &LimitCycle) -> Guess {
    Guess { period: cycle.period, state: first(cycle) }
}

fn first(cycle: &LimitCycle) -> Vec<f64> {
    cycle.orbit.states.iter().map(|column| column[0]).collect()
}

fn trivial(cycle: &LimitCycle) -> f64 {
    cycle.multipliers.iter().fold(f64::INFINITY, |near, value| near.min((value - 1.0).norm()))
}

#[test]
fn reference_cycles_are_met() {
    let file = reference::handed_over();
    let cases = file["cycles"].as_array().unwrap();
    assert_eq!(cases.len(), 4);
    for case in cases {
        let run = reference::run(&case["run"]);
        let found = run.limit_cycle(None).unwrap().expect("a limit cycle");
        // `drift`: how far the reference itself still was from repeating.
        let allowed = reference::number(&case["drift"]).max(1e-6);
        assert!(allowed < 1e-5);
        let near = |got: f64, expected: f64| assert!((got / expected - 1.0).abs() < allowed, "{got} {expected}");
        near(found.period, reference::number(&case["period"]));
        near(found.frequency, 1.0 / reference::number(&case["period"]));
        for (state, amplitude) in run.description().state.iter().zip(&found.amplitude) {
            near(*amplitude, reference::number(&case["amplitude"][state.name]));
        }
        assert!(found.stable && found.symmetric);
        assert!(trivial(&found) < 1e-6);
    }
}

/// theory.md, sections 3 and 4: computed independently, to half a unit of the last digit given.
#[test]
fn known_cycles_are_met() {
    let near = |got: f64, expected: f64, digit: f64| assert!((got - expected).abs() < 0.6 * digit, "{got} {expected}");
    let strong = cycle(&[("velocity", 80.0), ("dampingConstant", 10.0)]);
    near(strong.frequency, 51.215, 1e-3);
    near(strong.amplitude[0], 0.392_38, 1e-5);
    near(strong.amplitude[1], 124.89, 1e-2);
    near(strong.amplitude[2], 0.074_90, 1e-5);
    let weak = cycle(&[("velocity", 80.0), ("dampingConstant", 30.0)]);
    near(weak.frequency, 52.517, 1e-3);
    near(weak.amplitude[0], 0.206_32, 1e-5);
    near(weak.amplitude[1], 67.23, 1e-2);
    let slow = cycle(&[("velocity", 40.0), ("dampingConstant", 20.0)]);
    near(slow.amplitude[0].to_degrees(), 18.057, 1e-3);
    near(slow.amplitude[1], 100.65, 1e-2);
    near(slow.amplitude[2], 0.036_12, 1e-5);
    let gap = |degrees: f64, c: f64| {
        cycle(&[("velocity", 50.0), ("dampingConstant", c), ("freeplayAngle", degrees.to_radians())]).amplitude[0]
    };
    for (degrees, amplitude) in [(0.5, 0.011_171), (1.0, 0.022_268), (1.5, 0.033_219)] {
        near(gap(degrees, 100.0), amplitude, 1e-6);
    }
    for (degrees, amplitude) in [(0.0, 0.222_54), (0.5, 0.229_58), (1.0, 0.235_77), (1.5, 0.241_34)] {
        near(gap(degrees, 30.0), amplitude, 1e-5);
    }
}

#[test]
fn where_there_is_none_there_is_none() {
    let degree = 1_f64.to_radians();
    for parameters in [
        [("velocity", 80.0), ("dampingConstant", 60.0), ("freeplayAngle", 0.0)],
        [("velocity", 80.0), ("dampingConstant", 48.54), ("freeplayAngle", 0.0)],
        [("velocity", 80.0), ("dampingConstant", 100.0), ("freeplayAngle", degree)],
        // It comes to rest against the end of its gap.
        [("velocity", 30.0), ("casterLength", -0.2), ("freeplayAngle", degree)],
    ] {
        assert_eq!(gear(&parameters).limit_cycle(None).unwrap(), None, "{parameters:?}");
    }
    // A linear gear swings as largely as it was pushed, or grows for ever; at the Hopf point, too.
    let linear = Run::of("torsional-linear").unwrap().with("dampingConstant", 20.0).unwrap();
    let hopf = linear.routh_hurwitz().unwrap().critical_velocities[0];
    for velocity in [15.0, hopf, 80.0] {
        let run = linear.clone().with("velocity", velocity).unwrap();
        assert_eq!(run.limit_cycle(None).unwrap(), None, "{velocity}");
        assert_eq!(run.starting("torsionAngle", 0.1).unwrap().limit_cycle(None).unwrap(), None, "{velocity}");
    }
}

/// Multipliers by central differences of motions that know nothing of variational equations.
#[test]
fn multipliers_are_those_of_finite_differences() {
    for (v, c, gap) in [(80.0, 10.0, 0.0), (50.0, 30.0, 1.0), (50.0, 100.0, 0.5), (80.0, 48.0, 0.0), (110.0, 5.0, 2.0)]
    {
        let run = gear(&[("velocity", v), ("dampingConstant", c), ("freeplayAngle", f64::to_radians(gap))]);
        let found = run.limit_cycle(None).unwrap().expect("a limit cycle");
        let start = first(&found);
        let after = |component: usize, push: f64| {
            let mut run = run.clone().within(1e-13).unwrap().at(vec![found.period]).unwrap();
            for (i, state) in run.description().state.iter().enumerate() {
                run = run.starting(state.name, start[i] + if i == component { push } else { 0.0 }).unwrap();
            }
            run.simulate().unwrap().states.iter().map(|column| column[0]).collect::<Vec<_>>()
        };
        // Balanced: 10⁻¹³/10⁻⁵ of rounding, (10⁻⁵)² of bending, and the corners of the laws' slopes.
        let columns: Vec<Vec<f64>> = (0..3)
            .map(|j| {
                let h = 1e-5 * found.amplitude[j];
                after(j, h).iter().zip(after(j, -h)).map(|(up, down)| (up - down) / (2.0 * h)).collect()
            })
            .collect();
        let expected = eigenvalues(&DMatrix::from_fn(3, 3, |i, j| columns[j][i])).unwrap();
        for value in &found.multipliers {
            let nearest = expected.iter().fold(f64::INFINITY, |near, other| near.min((value - other).norm()));
            assert!(nearest < 1e-5, "v {v} c {c} gap {gap}: {:?} {expected:?}", found.multipliers);
        }
        assert!(trivial(&found) < 1e-6, "{:?}", found.multipliers);
    }
}

#[test]
fn a_neighbour_comes_nearer_by_the_multiplier() {
    let run = gear(&[("velocity", 80.0), ("dampingConstant", 10.0)]);
    let found = run.limit_cycle(None).unwrap().unwrap();
    let mut pushed = run.clone().within(1e-12).unwrap();
    for (state, value) in run.description().state.iter().zip(first(&found)) {
        pushed = pushed.starting(state.name, 1.001 * value).unwrap();
    }
    // The state after each period, from when the quickly fading direction is gone.
    let periods: Vec<f64> = (0..14).map(|k| f64::from(k) * found.period).collect();
    let motion = pushed.at(periods).unwrap().simulate().unwrap();
    // Steps from period to period: along the cycle nothing changes any more, and they fade as the neighbour does.
    let step = |k: usize| motion.states[1][k + 1] - motion.states[1][k];
    for k in 6..12 {
        let ratio = step(k + 1) / step(k);
        assert!((ratio - found.multipliers[1].re).abs() < 2e-4, "{k}: {ratio} {:?}", found.multipliers);
    }
}

#[test]
fn rest_is_not_mistaken_for_none() {
    // A wheel that leads its axis: the side force calms it until it grows no more, and the aligning moment, which goes on
    // growing up to 40°, makes it shake.
    let lead = [("casterLength", -0.1), ("aligningMomentLimitAngle", 40_f64.to_radians())];
    let run = gear(&[[("velocity", 80.0), ("dampingConstant", 10.0)], lead].concat());
    assert!(run.eigenvalues().unwrap().iter().all(|value| value.re < 0.0));
    let large = run.limit_cycle(None).unwrap().expect("a limit cycle");
    assert!(large.stable && large.amplitude[0] > 0.1);
    // What is asked for from a small start gets to rest.
    assert_eq!(run.clone().starting("torsionAngle", 1e-3).unwrap().limit_cycle(None).unwrap(), None);
    // Between the two lies an unstable cycle: found near a motion that stays there for a while.
    let from = |psi: f64| run.clone().starting("torsionAngle", psi).unwrap();
    let (mut below, mut above) = (1e-3, 0.5);
    for _ in 0..30 {
        let middle = 0.5 * (below + above);
        let dies = from(middle).outlook().unwrap().verdict == Verdict::DiesOut;
        *(if dies { &mut below } else { &mut above }) = middle;
    }
    let motion = from(below).lasting(0.2).unwrap().sampled(2.0).unwrap().simulate().unwrap();
    let near = Guess { period: 1.0 / 30.0, state: motion.states.iter().map(|column| column[1]).collect() };
    let edge = [1.0, 0.9, 0.8, 0.7, 0.6, 1.15, 1.3].iter().find_map(|part| {
        let guess = Guess { period: part * near.period, ..near.clone() };
        run.limit_cycle(Some(&guess)).unwrap().filter(|found| !found.stable)
    });
    let edge = edge.expect("an unstable cycle");
    assert!(edge.multipliers[0].re > 1.0 && edge.symmetric && trivial(&edge) < 1e-6, "{edge:?}");
    // It is what divides the starts.
    for (part, verdict) in [(0.999, Verdict::DiesOut), (1.001, Verdict::Grows)] {
        let mut start = run.clone();
        for (state, value) in run.description().state.iter().zip(first(&edge)) {
            start = start.starting(state.name, part * value).unwrap();
        }
        assert_eq!(start.outlook().unwrap().verdict, verdict, "{part}");
    }
}

#[test]
fn a_guess_leads_to_the_same_cycle() {
    let base = cycle(&[("velocity", 80.0), ("dampingConstant", 30.0)]);
    for (v, c) in [(80.0, 30.0), (80.0, 31.0), (82.0, 30.0), (80.0, 40.0), (60.0, 25.0)] {
        let run = gear(&[("velocity", v), ("dampingConstant", c)]);
        let (warm, cold) =
            (run.limit_cycle(Some(&guess(&base))).unwrap().unwrap(), run.limit_cycle(None).unwrap().unwrap());
        for (a, b) in warm.amplitude.iter().zip(&cold.amplitude).chain([(&warm.period, &cold.period)]) {
            assert!((a / b - 1.0).abs() < 1e-8, "{v} {c}: {a} {b}");
        }
    }
    // One that leads nowhere is not the last word.
    let run = gear(&[("velocity", 80.0), ("dampingConstant", 30.0)]);
    for (period, psi) in [(1e-9, 0.0), (1e9, 1e9), (0.003, 1e-6), (1.0, 30.0)] {
        let found = run.limit_cycle(Some(&Guess { period, state: vec![psi, 0.0, 0.0] })).unwrap().unwrap();
        assert!((found.amplitude[0] / base.amplitude[0] - 1.0).abs() < 1e-8, "{period} {psi}: {:?}", found.amplitude);
    }
    let refused = |guess: Guess| run.limit_cycle(Some(&guess)).unwrap_err();
    assert_eq!(refused(Guess { period: -1.0, state: vec![0.0; 3] }).field, "period");
    assert_eq!(refused(Guess { period: 1.0, state: vec![0.0; 2] }).field, "state");
    assert_eq!(refused(Guess { period: 1.0, state: vec![0.0, f64::NAN, 0.0] }).code, Code::NotFinite);
}

/// Any gear: a long simulation settles on what was found, and on nothing that was not.
#[test]
fn a_guess_of_some_rounds_is_taken_for_one() {
    for parameters in [
        &[("velocity", 80.0), ("dampingConstant", 30.0)][..],
        &[("velocity", 50.0), ("dampingConstant", 100.0), ("freeplayAngle", 0.0175)],
        &[("velocity", 80.0), ("dampingConstant", 20.0), ("friction.moment", 80.0)],
    ] {
        let run = gear(parameters);
        let one = run.limit_cycle(None).unwrap().unwrap();
        for rounds in [2.0, 3.0, 4.0, 6.0] {
            let state = first(&one).iter().map(|x| 1.001 * x).collect();
            let found = run.limit_cycle(Some(&Guess { period: 0.9997 * rounds * one.period, state })).unwrap().unwrap();
            assert!((found.period / one.period - 1.0).abs() < 1e-7, "{rounds}: {} {}", found.period, one.period);
            assert!(found.symmetric && found.stable);
            for (found, one) in found.multipliers.iter().zip(&one.multipliers) {
                assert!((found - one).norm() < 1e-5, "{rounds}: {found} {one}");
            }
        }
    }
}

#[test]
fn random_gears_settle_on_the_cycle_found() {
    let mut random = Random::seeded(20);
    let (mut found_some, mut with_gap) = (0, 0);
    for _ in 0..60 {
        let gap = if random.once_in(2) { random.between(1e-3, 0.03) } else { 0.0 };
        let run = gear(&[
            ("velocity", random.between(20.0, 110.0)),
            ("casterLength", random.between(0.0, 0.25)),
            ("relaxationLength", random.between(0.15, 0.5)),
            ("momentOfInertia", random.between(0.5, 2.0)),
            ("torsionalStiffness", random.between(4e4, 2e5)),
            ("dampingConstant", random.between(5.0, 80.0)),
            ("sideForceLimitAngle", random.between(0.05, 0.15)),
            ("aligningMomentLimitAngle", random.between(0.1, 0.3)),
            ("freeplayAngle", gap),
        ]);
        let run = run.starting("torsionAngle", 0.1).unwrap();
        let motion =
            run.clone().within(1e-10).unwrap().lasting(8.0).unwrap().sampled(400_001.0).unwrap().simulate().unwrap();
        // Peaks of the last stretches, each by the parabola through three samples 20 µs apart.
        let psi = &motion.states[0];
        let peak = |from: usize, to: usize| {
            (from..to).fold(0.0_f64, |most, i| {
                let [a, b, c] = [psi[i - 1], psi[i], psi[i + 1]].map(f64::abs);
                let top = if b >= a && b >= c && a + c < 2.0 * b {
                    b + (c - a).powi(2) / (8.0 * (2.0 * b - a - c))
                } else {
                    b
                };
                most.max(top)
            })
        };
        let n = psi.len() - 1;
        let (before, late) = (peak(n - 100_000, n - 50_000), peak(n - 50_000, n));
        let found = run.limit_cycle(None).unwrap();
        if late < 1e-6 {
            assert_eq!(found, None, "{:?}", run.parameters());
        } else if (late / before - 1.0).abs() < 1e-7 && run.outlook().unwrap().frequency.is_some() {
            let found = found.unwrap_or_else(|| panic!("{:?} settles at {late}", run.parameters()));
            assert!(
                (found.amplitude[0] / late - 1.0).abs() < 1e-5,
                "{} {late} {:?}",
                found.amplitude[0],
                run.parameters()
            );
            assert!(found.stable && trivial(&found) < 1e-6, "{:?}", found.multipliers);
            found_some += 1;
            with_gap += u32::from(gap > 0.0);
        }
    }
    assert!(found_some > 15 && with_gap > 5, "{found_some} {with_gap}");
}

#[test]
fn the_orbit_is_one_period_and_closes() {
    for gap in [0.0, 0.01] {
        let found = cycle(&[("velocity", 50.0), ("dampingConstant", 30.0), ("freeplayAngle", gap)]);
        let orbit = &found.orbit;
        let last = orbit.time.len() - 1;
        assert_eq!((orbit.time[0], orbit.time[last]), (0.0, found.period));
        assert!(
            orbit.states[0][0].abs() < 1e-12 && orbit.states[0][1] > 0.0,
            "starts where the angle rises through zero"
        );
        for (column, amplitude) in orbit.states.iter().zip(&found.amplitude) {
            assert!((column[last] - column[0]).abs() < 1e-7 * amplitude);
            let most = column.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            assert!(most <= amplitude * (1.0 + 1e-9) && most > 0.999 * amplitude);
            // Symmetric: after half a period its mirror image.
            let half = last / 2;
            (0..=half).for_each(|i| assert!((column[i] + column[i + half]).abs() < 1e-7 * amplitude));
        }
        let product = found.multipliers.iter().fold(Complex::from(1.0), |product, value| product * value);
        // Liouville: the product is e^(∫ trace J) = e^(−(c + κ/v)T/I_z − vT/σ), in every piece of the laws the same.
        let expected = (-(30.0 + 270.0 / 50.0 + 50.0 / 0.3) * found.period).exp();
        assert!((product / expected - 1.0).norm() < 1e-6, "{product} {expected}");
    }
}
