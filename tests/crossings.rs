//! Where eigenvalues cross the axis: the search for any model against the closed form of the torsional gear.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::TAU;

use common::{
    linear::{gear, largest, random_gear},
    random::Random,
};
use shimmy::{
    Run,
    parameter::Parameter,
    stability::{CurveKind, EndKind, Variation},
};

/// theory.md, section 2, once more, by the search that knows nothing of the gear.
#[test]
fn the_search_meets_the_published_critical_values() {
    let by_numbers = |parameters: &[(&str, f64)]| gear(parameters).routh_hurwitz_by_numbers().unwrap();
    for (c, expected) in [
        (0.0, vec![15.2593]),
        (10.0, vec![20.511, 1040.97]),
        (20.0, vec![27.600, 501.75]),
        (30.0, vec![37.263, 311.77]),
        (40.0, vec![51.881, 205.13]),
        (49.7926, vec![100.70, 100.70]),
        (49.7928, vec![]),
    ] {
        let got = by_numbers(&[("dampingConstant", c)]).critical_velocities;
        assert_eq!(got.len(), expected.len(), "{c}: {got:?}");
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < if c > 49.0 { 3e-3 } else { 3e-5 }, "{c}: {got} {expected}");
        }
    }
    for (v, expected) in [(30.0, 22.808), (80.0, 48.530)] {
        let got = by_numbers(&[("velocity", v)]).critical_damping.unwrap();
        assert!((got / expected - 1.0).abs() < 3e-5, "{got}");
    }
}

/// Neighbours in a list that are nearer to each other than this, relatively, may be hidden by rounding.
const HIDDEN: f64 = 1e-5;

#[test]
fn the_search_finds_what_the_closed_form_says() {
    let mut random = Random::seeded(11);
    let mut found = 0;
    for case in 0..600 {
        let run = random_gear(&mut random, ["torsional", "torsional-linear"][case % 2]);
        let (exact, searched) = (run.routh_hurwitz().unwrap(), run.routh_hurwitz_by_numbers().unwrap());
        let mut expected = exact.critical_velocities;
        expected.retain(|v| (0.1..=2000.0).contains(v));
        if expected.windows(2).any(|pair| pair[1] / pair[0] - 1.0 < HIDDEN) {
            continue;
        }
        let got = searched.critical_velocities;
        assert_eq!(got.len(), expected.len(), "{run:?}: {got:?} {expected:?}");
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < 1e-8, "{run:?}: {got} {expected}");
            found += 1;
        }
        match (searched.critical_damping, exact.critical_damping.filter(|c| (1e-3..=1e6).contains(c))) {
            (Some(got), Some(expected)) => assert!((got / expected - 1.0).abs() < 1e-8, "{run:?}: {got} {expected}"),
            (got, expected) => assert_eq!(got, expected, "{run:?}"),
        }
    }
    assert!(found > 200, "{found}");
}

/// Along any parameter, in any range: crossings are the ends of the closed form's intervals.
#[test]
fn crossings_are_the_ends_of_intervals() {
    let table = Run::of("torsional").unwrap().description().parameters;
    let mut random = Random::seeded(12);
    let mut found = [0; 2];
    for case in 0..1_500 {
        let run = random_gear(&mut random, "torsional");
        let Parameter { name, min, max, .. } = table[case % table.len()];
        let (a, b) = (random.between(min, max), random.between(min, max));
        let (from, to) = if random.once_in(2) { (min, max) } else { (a.min(b), a.max(b)) };
        let variation = Variation::of(name, from, to);
        let intervals = run.unstable_intervals(&variation).unwrap();
        let mut expected: Vec<(f64, EndKind)> =
            intervals.iter().flat_map(|part| [(part.from, part.from_kind), (part.to, part.to_kind)]).collect();
        expected.retain(|end| end.1 != EndKind::Range);
        let crossings = run.crossings(&variation).unwrap();
        let width = to - from;
        if expected.windows(2).any(|pair| pair[1].0 - pair[0].0 < HIDDEN * width) {
            continue;
        }
        for (value, kind) in &expected {
            let near =
                crossings.iter().find(|c| (c.value - value).abs() < 1e-8 * width && c.kind.name() == kind.name());
            assert!(near.is_some(), "{name} {from} … {to} of {run:?}: {expected:?} {crossings:?}");
            found[usize::from(*kind == EndKind::Hopf)] += 1;
        }
        // What else crosses does so where another eigenvalue is unstable already; all are on the axis there.
        for crossing in &crossings {
            let values = run.clone().with(name, crossing.value).unwrap().eigenvalues().unwrap();
            let on_axis = values.iter().find(|value| match crossing.kind {
                CurveKind::Hopf => (value.im - TAU * crossing.frequency).abs() < 1e-9 * largest(&values),
                CurveKind::Divergence => value.norm() < 1e-9 * largest(&values),
            });
            assert!(on_axis.unwrap().re.abs() < 1e-9 * largest(&values), "{name}: {crossing:?} {values:?}");
        }
    }
    assert!(found.iter().all(|count| *count > 30), "{found:?}");
}
