//! Whatever is handed over as a plane: it is mapped and traced in finite numbers, or refused in words that name a field.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::hostile::{assert_finite, assert_speaks};
use proptest::prelude::*;
use shimmy::{
    model::{Model, Torsional, TorsionalLinear},
    parameter::Parameter,
    run::Value,
    stability::{CurveSpec, MapSpec},
};

fn named(key: &str, value: Value) -> (String, Value) {
    (key.to_owned(), value)
}

/// Numbers at the ends of what a double can say, those just past a limit, and any other bits.
fn number() -> impl Strategy<Value = f64> {
    let edges =
        vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, -5e-324, -1.0, 2.5, 1.1e12, 1e155, f64::MAX, f64::MIN];
    prop_oneof![3 => prop::sample::select(edges), 1 => prop::num::f64::ANY, 1 => extreme()]
}

/// The ends of what a parameter can be, and its middle.
fn extreme() -> impl Strategy<Value = f64> {
    prop::sample::select(vec![0.0, 5e-324, 1e-300, 1e-150, 1e-12, 1e-3, 1.0, 1e3, 1e12])
}

/// What belongs nowhere in a plane.
fn stranger() -> impl Strategy<Value = Value> {
    prop_oneof![
        Just(Value::Absent),
        any::<bool>().prop_map(Value::Bool),
        number().prop_map(Value::Number),
        prop::sample::select(vec!["torsional", "velocity", "velocty", "growthRate", ""])
            .prop_map(|text| Value::Text(text.into())),
        prop::collection::vec(number(), 0..3).prop_map(Value::Numbers),
        prop::sample::select(vec!["stable", "kind", "growth", ""]).prop_map(|text| Value::Texts(vec![text.into()])),
        any::<usize>().prop_map(Value::List),
        number().prop_map(|value| Value::Record(vec![named("count", Value::Number(value))])),
        Just(Value::Other("a function")),
    ]
}

/// A name of a parameter, seldom another one.
fn name(table: &'static [Parameter]) -> impl Strategy<Value = String> {
    let names: Vec<_> = table.iter().map(|parameter| parameter.name.to_owned()).collect();
    prop_oneof![30 => prop::sample::select(names), 1 => Just("velocty".to_owned()), 1 => any::<String>()]
}

/// An axis of few cells: a part of a slider, or from one end of the numbers to the other.
fn axis(table: &'static [Parameter]) -> impl Strategy<Value = Value> {
    let parts = (0.0..0.5_f64, 0.5..=1.0_f64);
    let other = prop_oneof![8 => Just(None), 2 => (extreme(), extreme()).prop_map(Some), 1 => (number(), number()).prop_map(Some)];
    let count = prop_oneof![15 => (1_u8..40).prop_map(f64::from), 1 => number().prop_filter("not for ever", |n| !(40.0..=1e8).contains(n))];
    (name(table), parts, other, count).prop_map(move |(name, parts, other, count)| {
        let slider = table.iter().find(|parameter| parameter.name == name).map_or((0.0, 1.0), |p| (p.min, p.max));
        let place = |part: f64| slider.0 + (slider.1 - slider.0) * part;
        let (from, to) = other.map_or((place(parts.0), place(parts.1)), |(a, b)| if a < b { (a, b) } else { (b, a) });
        let numbers =
            [("from", from), ("to", to), ("count", count)].map(|(key, number)| named(key, Value::Number(number)));
        Value::Record([named("parameter", Value::Text(name))].into_iter().chain(numbers).collect())
    })
}

/// Values of some parameters: within their sliders, or as large or small as any may be.
fn parameters(table: &'static [Parameter]) -> impl Strategy<Value = Value> {
    let part = prop_oneof![3 => (0.0..=1.0_f64).prop_map(Ok), 1 => extreme().prop_map(Err)];
    prop::collection::vec((name(table), part), 0..8).prop_map(move |values| {
        let value = |(name, part): (String, Result<f64, f64>)| {
            let slider = table.iter().find(|parameter| parameter.name == name).map_or((0.0, 1.0), |p| (p.min, p.max));
            let number = part.map_or_else(|extreme| extreme, |part| slider.0 + (slider.1 - slider.0) * part);
            named(&name, Value::Number(number))
        };
        Value::Record(values.into_iter().map(value).collect())
    })
}

fn links() -> impl Strategy<Value = Value> {
    let names = vec!["relaxationLength", "treadWidthMomentConstant"];
    let link = (prop::sample::select(names), any::<bool>()).prop_map(|(name, truth)| named(name, Value::Bool(truth)));
    prop::collection::vec(link, 0..3).prop_map(Value::Record)
}

fn quantities() -> impl Strategy<Value = Value> {
    let names = vec!["stable", "growthRate", "frequency", "kind"];
    prop::collection::vec(prop::sample::select(names).prop_map(str::to_owned), 1..4).prop_map(Value::Texts)
}

fn tile() -> impl Strategy<Value = Value> {
    let part = prop_oneof![9 => (0_u8..20).prop_map(f64::from), 1 => number()].prop_map(Value::Number);
    let keys = prop::sample::select(vec!["column", "row", "columns", "rows"]);
    prop::collection::vec((keys, part).prop_map(|(key, part)| named(key, part)), 0..4).prop_map(Value::Record)
}

/// A record that looks like a map, at times with something in it that does not belong there.
fn map() -> impl Strategy<Value = Value> {
    let model = |name: &'static str, table: &'static [Parameter]| {
        (Just(named("model", Value::Text(name.into()))), parameters(table), axis(table), axis(table))
    };
    let gear = prop_oneof![
        4 => model("torsional", Torsional::PARAMETERS),
        1 => model("torsional-linear", TorsionalLinear::PARAMETERS),
    ];
    let tile = prop_oneof![4 => Just(None), 1 => tile().prop_map(Some)];
    let damage = prop_oneof![8 => Just(None), 1 => (0_usize..7, stranger()).prop_map(Some)];
    (gear, links(), quantities(), tile, damage).prop_map(
        |((model, parameters, x, y), linked, quantities, tile, damage)| {
            let mut entries = vec![
                model,
                named("parameters", parameters),
                named("x", x),
                named("y", y),
                named("linked", linked),
                named("quantities", quantities),
            ];
            entries.extend(tile.map(|tile| named("tile", tile)));
            if let Some((index, value)) = damage {
                let place = index % entries.len();
                entries[place].1 = value;
            }
            Value::Record(entries)
        },
    )
}

/// Makes a map of a value; whether it could be made.
fn mapped(input: &Value) -> bool {
    match MapSpec::read(input).and_then(MapSpec::made) {
        Ok(map) => {
            let cells = map.cells();
            assert_eq!(cells.made, cells.stable.len());
            assert_finite("a growth rate", &cells.growth_rate);
            assert_finite("a frequency", &cells.frequency);
            let count = cells.stable.iter().map(|cell| usize::from(*cell)).sum::<usize>();
            assert_eq!(count, cells.stable_count);
            assert_finite("the share", &[map.stable_percent().unwrap()]);
            match map.stable_area() {
                Ok(area) => assert!((0.0..=100.0).contains(&area.unwrap()), "{area:?} % of {:?}", map.spec()),
                Err(error) => assert_speaks(&error),
            }
            true
        }
        Err(error) => {
            assert_speaks(&error);
            false
        }
    }
}

/// Traces the boundary in a value without what only a map has.
fn traced(input: &Value) {
    let Value::Record(entries) = input else { return assert_speaks(&CurveSpec::read(input).unwrap_err()) };
    let plane = entries.iter().filter(|(key, _)| !["quantities", "tile"].contains(&key.as_str())).cloned().collect();
    match CurveSpec::read(&Value::Record(plane)).and_then(|curves| curves.made()) {
        Ok(curves) => {
            for curve in curves {
                assert!(curve.x.len() > 1 && curve.x.len() == curve.y.len() && curve.x.len() == curve.frequency.len());
                assert_finite("a curve", &[curve.x, curve.y, curve.frequency].concat());
            }
        }
        Err(error) => assert_speaks(&error),
    }
}

#[test]
fn any_plane_is_mapped_and_traced_or_refused() {
    let config = ProptestConfig { cases: 4_000, failure_persistence: None, ..ProptestConfig::default() };
    let made = std::cell::Cell::new(0);
    let mut runner = proptest::test_runner::TestRunner::new(config);
    runner
        .run(&map(), |input| {
            made.set(made.get() + usize::from(mapped(&input)));
            traced(&input);
            Ok(())
        })
        .unwrap();
    assert!((1_000..3_900).contains(&made.get()), "{} of 4000 were good", made.get());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_no_plane_is_refused(input in stranger()) {
        prop_assert!(!mapped(&input));
        traced(&input);
    }
}

/// What is an axis itself cannot follow the other one; the link is named, as is a wrong type of one.
#[test]
fn links_between_the_axes_are_refused() {
    let read = |x: &str, y: &str, link: &str, value: Value| {
        let axis = |name: &str| {
            let ends = [("from", 0.1), ("to", 0.2)].map(|(key, end)| named(key, Value::Number(end)));
            Value::Record([named("parameter", Value::Text(name.into()))].into_iter().chain(ends).collect())
        };
        let linked = Value::Record(vec![named(link, value)]);
        let model = named("model", Value::Text("torsional".into()));
        CurveSpec::read(&Value::Record(vec![model, named("x", axis(x)), named("y", axis(y)), named("linked", linked)]))
    };
    let yes = Value::Bool(true);
    let error = read("halfContactLength", "relaxationLength", "relaxationLength", yes.clone()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "linked.relaxationLength must be false where what is linked is itself an axis, got true"
    );
    let error = read("treadWidthMomentConstant", "verticalForce", "treadWidthMomentConstant", yes.clone()).unwrap_err();
    assert_eq!(error.field, "linked.treadWidthMomentConstant");
    assert!(read("relaxationLength", "velocity", "relaxationLength", yes.clone()).is_ok(), "nothing leads it");
    assert!(read("halfContactLength", "velocity", "relaxationLength", yes).is_ok());
    let error = read("halfContactLength", "velocity", "relaxationLength", Value::Number(1.0)).unwrap_err();
    assert_eq!(error.field, "linked.relaxationLength");
}
