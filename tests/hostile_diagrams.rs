//! Whatever is handed over as a bifurcation diagram or as folds in a plane: it is made in finite numbers, or refused in words
//! that name a field; and no step of it takes long.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::time::{Duration, Instant};

use common::hostile::{assert_finite, assert_speaks};
use proptest::prelude::*;
use shimmy::{
    cycles::{BifurcationSpec, FoldSpec},
    model::{Model, Torsional},
    run::Value,
};

const TABLE: &[shimmy::parameter::Parameter] = Torsional::PARAMETERS;

/// A step is a hundred milliseconds at worst; beside other tests, on a slow machine, several times that.
const PATIENCE: Duration = Duration::from_secs(5);

fn named(key: &str, value: Value) -> (String, Value) {
    (key.to_owned(), value)
}

/// The ends of what a parameter can be, what no number is, and any other bits.
fn number() -> impl Strategy<Value = f64> {
    let edges =
        vec![f64::NAN, f64::INFINITY, -1.0, 0.0, 5e-324, 1e-300, 1e-12, 1e-3, 1.0, 2.5, 1e3, 1e12, 1.1e12, f64::MAX];
    prop_oneof![4 => prop::sample::select(edges), 1 => prop::num::f64::ANY]
}

/// Somewhere on a parameter's slider, or anywhere.
fn value_of(index: usize) -> impl Strategy<Value = f64> {
    let (min, max) = (TABLE[index].min, TABLE[index].max);
    prop_oneof![9 => (0.0..=1.0_f64).prop_map(move |part| min + (max - min) * part), 1 => number()]
}

fn parameters() -> impl Strategy<Value = Value> {
    let one = (0..TABLE.len()).prop_flat_map(|i| value_of(i).prop_map(move |value| (i, value)));
    prop::collection::vec(one, 0..6).prop_map(|values| {
        Value::Record(values.into_iter().map(|(i, value)| named(TABLE[i].name, Value::Number(value))).collect())
    })
}

/// A parameter with the ends of a range.
fn range() -> impl Strategy<Value = Vec<(String, Value)>> {
    (0..TABLE.len()).prop_flat_map(|i| {
        (value_of(i), value_of(i)).prop_map(move |(from, to)| {
            let ends = [("from", from), ("to", to)].map(|(key, end)| named(key, Value::Number(end)));
            [named("parameter", Value::Text(TABLE[i].name.into()))].into_iter().chain(ends).collect()
        })
    })
}

fn stranger() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Absent),
        any::<bool>().prop_map(Value::Bool),
        number().prop_map(Value::Number),
        prop::sample::select(vec!["torsional", "velocty", ""]).prop_map(|text| Value::Text(text.into())),
        prop::collection::vec(number(), 0..3).prop_map(Value::Numbers),
        any::<usize>().prop_map(Value::List),
        number().prop_map(|value| Value::Record(vec![named("period", Value::Number(value))])),
        Just(Value::Other("a function")),
    ]
}

fn cycle() -> impl Strategy<Value = Value> {
    let part = || prop_oneof![4 => -1.0..1.0_f64, 1 => number()];
    (prop_oneof![3 => 1e-3..0.5_f64, 1 => number()], part(), part(), part()).prop_map(|(period, psi, rate, y)| {
        let state = [("torsionAngle", psi), ("torsionRate", 30.0 * rate), ("lateralDeformation", 0.05 * y)];
        let state = state.map(|(name, value)| named(name, Value::Number(value))).to_vec();
        Value::Record(vec![named("period", Value::Number(period)), named("state", Value::Record(state))])
    })
}

/// A record that looks like a diagram's, short ones, at times with something in it that does not belong there.
fn diagram() -> impl Strategy<Value = Value> {
    let damage = prop_oneof![4 => Just(None), 1 => (0_usize..9, stranger()).prop_map(Some)];
    let cycle = prop_oneof![2 => Just(Value::Absent), 1 => cycle()];
    (parameters(), range(), cycle, 2..12_u8, 0..2_u8, 1e-3..0.1_f64, damage).prop_map(
        |(parameters, range, cycle, points, probes, step, damage)| {
            let mut entries = vec![
                named("model", Value::Text("torsional".into())),
                named("parameters", parameters),
                named("cycle", cycle),
                named("points", Value::Number(points.into())),
                named("probes", Value::Number(probes.into())),
                named("step", Value::Number(step)),
            ];
            entries.extend(range);
            if let Some((index, value)) = damage {
                entries[index].1 = value;
            }
            Value::Record(entries)
        },
    )
}

/// Makes a diagram of a value; whether it could be made.
fn made(input: &Value) -> bool {
    let mut diagram = match BifurcationSpec::read(input).and_then(BifurcationSpec::begin) {
        Ok(diagram) => diagram,
        Err(error) => {
            assert_speaks(&error);
            return false;
        }
    };
    let mut fraction = 0.0;
    while !diagram.done() {
        let start = Instant::now();
        if let Err(error) = diagram.advance() {
            assert_speaks(&error);
            return false;
        }
        assert!(start.elapsed() < PATIENCE, "{:?} took {:?}", diagram.spec(), start.elapsed());
        assert!((fraction..=1.0).contains(&diagram.fraction()), "{} after {fraction}", diagram.fraction());
        fraction = diagram.fraction();
    }
    let rest = diagram.rest();
    assert_finite("rest", &[rest.value.clone(), rest.growth_rate.clone(), rest.frequency.clone()].concat());
    for branch in diagram.cycles() {
        for point in &branch.points {
            assert_finite("a cycle", &[&[point.value, point.period], &point.amplitude[..], &point.state].concat());
            point.multipliers.iter().for_each(|value| assert_finite("a multiplier", &[value.re, value.im]));
            assert!((point.multipliers[0] - 1.0).norm() < 1e-6, "{point:?}");
        }
    }
    for point in diagram.points() {
        assert_finite("a point", &[point.value, point.amplitude, point.frequency, point.lyapunov.unwrap_or(0.0)]);
    }
    true
}

fn traced(input: &Value) -> bool {
    match FoldSpec::read(input).and_then(FoldSpec::made) {
        Ok(folds) => {
            for curve in folds.curves() {
                assert!(curve.x.len() > 1 && curve.x.len() == curve.y.len() && curve.x.len() == curve.amplitude.len());
                assert_finite("a curve", &[&curve.x[..], &curve.y, &curve.frequency, &curve.amplitude].concat());
            }
            true
        }
        Err(error) => {
            assert_speaks(&error);
            false
        }
    }
}

fn run<S: Strategy<Value = Value>>(cases: u32, inputs: S, make: impl Fn(&Value) -> bool) -> u32 {
    let config = ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() };
    let good = std::cell::Cell::new(0);
    proptest::test_runner::TestRunner::new(config)
        .run(&inputs, |input| {
            good.set(good.get() + u32::from(make(&input)));
            Ok(())
        })
        .unwrap();
    good.get()
}

#[test]
fn any_diagram_is_made_or_refused() {
    let good = run(250, diagram(), made);
    assert!((50..245).contains(&good), "{good} of 250 were good");
}

#[test]
fn any_plane_has_its_folds_or_is_refused() {
    let plane = (parameters(), range(), range()).prop_map(|(parameters, x, y)| {
        Value::Record(vec![
            named("model", Value::Text("torsional".into())),
            named("parameters", parameters),
            named("x", Value::Record(x)),
            named("y", Value::Record(y)),
            named("seeds", Value::Number(1.0)),
        ])
    });
    let good = run(40, plane, traced);
    assert!(good > 0, "{good} of 40 were good");
}

#[test]
fn what_is_neither_is_refused() {
    let config = ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() };
    proptest::test_runner::TestRunner::new(config)
        .run(&stranger(), |input| {
            prop_assert!(!made(&input) && !traced(&input));
            Ok(())
        })
        .unwrap();
}
