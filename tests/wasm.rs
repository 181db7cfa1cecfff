//! The JavaScript API from within WebAssembly: one suite for Node.js, Chromium and Firefox, so it is configured for none.
//!
//! Calls go through JavaScript values, as they do from a page. What scripts rely on in detail is tested in `tests/node/`.

#![cfg(target_arch = "wasm32")]

use js_sys::{Array, Float64Array, Function, JSON, Object, Reflect, Uint8Array};
use shimmy::wasm::{self, Simulator};
use wasm_bindgen::prelude::*;
use wasm_bindgen_test::wasm_bindgen_test;

/// A value written in JavaScript.
fn js(expression: &str) -> JsValue {
    Function::new_no_args(&format!("return {expression}")).call0(&JsValue::NULL).expect("it is JavaScript")
}

/// A property, by a dotted path.
fn get(value: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(value.clone(), |value, key| Reflect::get(&value, &key.into()).expect("it is an object"))
}

fn number(value: &JsValue, path: &str) -> f64 {
    get(value, path).as_f64().unwrap_or_else(|| panic!("{path} is a number"))
}

fn text(value: &JsValue, path: &str) -> String {
    get(value, path).as_string().unwrap_or_else(|| panic!("{path} is a string"))
}

fn series(value: &JsValue, path: &str) -> Vec<f64> {
    get(value, path).dyn_into::<Float64Array>().unwrap_or_else(|_| panic!("{path} is a Float64Array")).to_vec()
}

const SHIMMY: &str =
    "({model: 'torsional', parameters: {velocity: 80, dampingConstant: 20}, initial: {torsionAngle: 0.05}})";

/// Trajectories of SciPy, for every model that is here (none has a damper yet): within 1e-6 of each series' largest value.
#[wasm_bindgen_test]
fn meets_the_reference() {
    let reference = JSON::parse(include_str!("reference.json")).expect("it is JSON");
    let mut compared = 0;
    for case in get(&reference, "trajectories").unchecked_into::<Array>().iter() {
        if get(&case, "run.damper").is_object() {
            continue;
        }
        let trajectory = wasm::simulate(get(&case, "run")).expect("the run is good");
        let expected = get(&case, "expect");
        for state in Object::keys(expected.unchecked_ref::<Object>()).iter() {
            let state = state.as_string().expect("a key is a string");
            let expected: Vec<f64> = Array::from(&get(&expected, &state)).iter().filter_map(|x| x.as_f64()).collect();
            let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let actual = series(&trajectory, &state);
            assert_eq!(actual.len(), expected.len());
            for (actual, expected) in actual.iter().zip(&expected) {
                let error = (actual - expected).abs() / largest;
                assert!(error < 1e-6, "{}, {state}: off by {error:e}", text(&case, "id"));
            }
            compared += 1;
        }
    }
    assert!(compared >= 30, "only {compared} series were compared");
}

#[wasm_bindgen_test]
fn says_its_version() {
    assert_eq!(wasm::version(), env!("CARGO_PKG_VERSION"));
}

#[wasm_bindgen_test]
fn tables_are_plain_objects() {
    let models: Array = wasm::models().expect("models are always there").unchecked_into();
    let torsional = models.iter().find(|model| text(model, "name") == "torsional").expect("it is listed");
    assert_eq!(Object::get_prototype_of(&torsional), get(&js_sys::global(), "Object.prototype").unchecked_into());
    let velocity = Array::from(&get(&torsional, "parameters")).get(0);
    assert_eq!((text(&velocity, "name").as_str(), number(&velocity, "default")), ("velocity", 50.0));

    let methods: Array = wasm::methods().expect("methods are always there").unchecked_into();
    assert!(methods.iter().any(|method| text(&method, "name") == "dop853"));
}

#[wasm_bindgen_test]
fn foresees_the_cycle() {
    let outlook = wasm::outlook(js(SHIMMY)).expect("the run is good");
    assert_eq!(text(&outlook, "verdict"), "shimmies");
    assert!((number(&outlook, "amplitude.torsionAngle") - 0.26508).abs() < 5e-6);
    assert!((number(&outlook, "frequency") - 51.87).abs() < 5e-3);
}

#[wasm_bindgen_test]
fn answers_what_is_asked_beside_a_run() {
    let theory = wasm::routh_hurwitz(js(SHIMMY)).expect("the run is good");
    assert!((number(&theory, "criticalDamping") - 48.530).abs() < 5e-4);
    let damping = js("({parameter: 'dampingConstant', from: 0, to: 200})");
    let parts: Array = wasm::unstable_intervals(js(SHIMMY), damping).expect("the range is good").unchecked_into();
    assert_eq!(number(&parts.get(0), "to"), number(&theory, "criticalDamping"));

    let energy = wasm::energy(js(SHIMMY)).expect("the run is good");
    let out = number(&energy, "damper")
        + number(&energy, "treadWidth")
        + number(&energy, "friction")
        + number(&energy, "stored");
    assert!((number(&energy, "tire") / out - 1.0).abs() < 1e-7);

    let forces = wasm::forces(js(SHIMMY), js("[0.01, 0, 0.003]")).expect("the state is good");
    assert!((number(&forces, "springTorque") + 1000.0).abs() < 1e-9);
    let laws = wasm::force_laws(js(SHIMMY), JsValue::UNDEFINED).expect("the run is good");
    assert!(series(&laws, "slipAngle").contains(&number(&laws, "kinks.sideForceLimitAngle")));

    let wave = js("({values: Array.from({length: 64}, (_, i) => Math.sin(i * Math.PI / 4)), interval: 0.01})");
    let spectrum = wasm::spectrum(wave).expect("the series is good");
    assert!((number(&spectrum, "peak.frequency") - 12.5).abs() < 1e-9);
    assert_eq!(wasm::atlas().expect("it is JSON").unchecked_into::<Array>().length(), 283);
}

#[wasm_bindgen_test]
fn maps_a_plane_and_its_boundary() {
    let plane = |more: &str| {
        js(&format!(
            "({{model: 'torsional', x: {{parameter: 'velocity', from: 0.5, to: 100{more}}}, \
             y: {{parameter: 'casterLength', from: 0, to: 0.5{more}}}}})"
        ))
    };
    let map = wasm::stability_map(plane(", count: 400")).expect("the map is good");
    // SciPy counts 48.37 % (tests/reference.json).
    assert!((number(&map, "stablePercent") - 48.37).abs() < 2e-3);
    assert!((number(&map, "stableArea") - 48.37).abs() < 0.02);
    assert_eq!(series(&map, "growthRate").len(), 160_000);

    let curves: Array = wasm::hopf_curve(plane("")).expect("the plane is good").unchecked_into();
    let curve = curves.get(0);
    assert_eq!((curves.length(), text(&curve, "kind").as_str()), (1, "hopf"));
    assert!(series(&curve, "x").contains(&100.0) && series(&curve, "y").contains(&0.0));

    let job = wasm::Job::new(js("'stabilityMap'"), plane(", count: 400")).expect("the map is good");
    let mut slices = 0;
    while get(&job.advance(js("1")).expect("it goes on"), "done") != JsValue::TRUE {
        slices += 1;
    }
    let made = job.result().expect("it is done");
    assert!(slices > 0 && series(&made, "growthRate") == series(&map, "growthRate"));
}

#[wasm_bindgen_test]
fn a_refusal_is_an_error_with_data() {
    let error = wasm::simulate(js("({model: 'torsional', parameters: {velocity: -3}})")).expect_err("no gear rolls so");
    assert!(error.is_instance_of::<js_sys::Error>());
    assert_eq!(text(&error, "message"), "velocity must be > 0 m/s, got -3");
    assert_eq!(text(&error, "field"), "velocity");
    assert_eq!(text(&error, "code"), "out-of-range");

    let error = wasm::simulate(js("({model: 'torsional', parameters: {velocty: 3}})")).expect_err("a slip of the pen");
    assert_eq!(text(&error, "suggestion"), "velocity");
}

#[wasm_bindgen_test]
fn whatever_is_no_run_is_refused() {
    for expression in [
        "undefined",
        "null",
        "1",
        "'torsional'",
        "[]",
        "() => 1",
        "Symbol('run')",
        "10n",
        "new Map([['model', 'torsional']])",
        "({get model() { throw new Error('boo') }})",
        "({model: 'torsional', samples: 1e12})",
        "({model: 'torsional', times: new Float64Array([NaN])})",
    ] {
        let error = wasm::simulate(js(expression)).expect_err(expression);
        assert!(error.is_instance_of::<js_sys::Error>(), "{expression}");
    }
}

#[wasm_bindgen_test]
fn the_live_gear_lives_on_after_a_refusal() {
    let live = Simulator::new(js(SHIMMY)).expect("the run is good");
    live.advance(js("0.1")).expect("time goes on");
    let before = live.state().expect("it has a state").unchecked_into::<Float64Array>().to_vec();

    assert!(live.advance(js("NaN")).is_err());
    assert!(live.set(js("'velocity'"), js("-3")).is_err());
    assert!(live.seek(js("1e9")).is_err());
    assert!(live.restore(Uint8Array::new_with_length(7).into()).is_err());
    assert_eq!(live.state().expect("it has a state").unchecked_into::<Float64Array>().to_vec(), before);

    live.set(js("'dampingConstant'"), js("60")).expect("it can be set");
    live.advance(js("0.1")).expect("time goes on");
    assert!((live.time().expect("it has a time").as_f64().expect("a number") - 0.2).abs() < 1e-12);
}

/// An argument that would call back into the very gear that reads it is refused unread.
#[wasm_bindgen_test]
fn a_call_within_a_call_breaks_nothing() {
    let live = JsValue::from(Simulator::new(js(SHIMMY)).expect("the run is good"));
    let knot = js("(live) => live.advance({valueOf() { live.advance(0.1); return 0.1 }})").unchecked_into::<Function>();
    assert!(knot.call1(&JsValue::NULL, &live).is_err(), "an object is no number");
    let advance = js("(live) => { live.advance(0.1); return live.time }").unchecked_into::<Function>();
    let time = advance.call1(&JsValue::NULL, &live).expect("time goes on").as_f64().expect("a number");
    assert!((time - 0.1).abs() < 1e-12);
}
