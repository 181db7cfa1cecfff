//! From results to plain JavaScript objects.

use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::{
    Error, Run,
    integrate::{Stats, Trajectory},
    live::{Columns, Envelope},
    model::laws::{ForceColumns, ForceLaws},
    outlook::Outlook,
    parameter::StateVariable,
    spectrum::Spectrum,
};

/// Small records: plain objects, never Maps; what is absent is `null`.
pub(super) fn record(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer =
        serde_wasm_bindgen::Serializer::new().serialize_maps_as_objects(true).serialize_missing_as_null(true);
    value.serialize(&serializer).map_err(JsValue::from)
}

/// An `Error` with its data as properties.
#[inline(never)]
pub(super) fn error(error: Error) -> JsValue {
    let js = js_sys::Error::new(&error.to_string());
    let target: &Object = js.as_ref();
    put(target, "code", &error.code.name().into());
    put(target, "field", &error.field.as_str().into());
    put(target, "value", &error.value.as_str().into());
    put(target, "allowed", &error.allowed.as_str().into());
    put(target, "suggestion", &error.suggestion.map_or(JsValue::NULL, JsValue::from));
    js.into()
}

/// Sets a property of an object that this module has made; that cannot fail.
#[inline(never)]
pub(super) fn put(object: &Object, key: &str, value: &JsValue) {
    let _ = Reflect::set(object, &key.into(), value);
}

#[inline(never)]
pub(super) fn series(values: &[f64]) -> JsValue {
    Float64Array::from(values).into()
}

/// `time` and one array per state.
pub(super) fn columns(states: &[StateVariable], columns: Columns) -> Object {
    let object = Object::new();
    put(&object, "time", &series(&columns.time));
    for (state, column) in states.iter().zip(columns.states) {
        put(&object, state.name, &series(&column));
    }
    object
}

pub(super) fn envelope(envelope: &Envelope) -> Object {
    let object = Object::new();
    put(&object, "time", &series(&envelope.time));
    put(&object, "low", &series(&envelope.low));
    put(&object, "high", &series(&envelope.high));
    object
}

pub(super) fn trajectory(run: &Run, trajectory: Trajectory) -> Result<JsValue, JsValue> {
    let Trajectory { time, states, events, stats, scheme } = trajectory;
    let object = columns(run.description().state, Columns { time, states });
    let record = Object::new();
    put(&record, "time", &series(&events.time));
    put(&record, "kind", &Uint8Array::from(events.kind.as_slice()).into());
    put(&record, "kinds", &events.kinds.iter().map(|kind| JsValue::from(*kind)).collect::<Array>().into());
    put(&object, "events", &record.into());
    put(&object, "stats", &statistics(stats, scheme.name()).into());
    Ok(object.into())
}

fn statistics(stats: Stats, method: &str) -> Object {
    let object = Object::new();
    put(&object, "method", &method.into());
    put(&object, "steps", &(stats.steps as f64).into());
    put(&object, "rejected", &(stats.rejected as f64).into());
    put(&object, "evaluations", &(stats.evaluations as f64).into());
    put(&object, "events", &(stats.events as f64).into());
    put(&object, "stiff", &stats.stiff.into());
    object
}

pub(super) fn outlook(run: &Run, outlook: Outlook) -> Result<JsValue, JsValue> {
    let states = run.description().state;
    let object = Object::new();
    put(&object, "verdict", &record(&outlook.verdict)?);
    put(&object, "settled", &outlook.settled.into());
    let amplitude = Object::new();
    for (state, value) in states.iter().zip(&outlook.amplitude) {
        put(&amplitude, state.name, &(*value).into());
    }
    put(&object, "amplitude", &amplitude.into());
    put(&object, "frequency", &maybe(outlook.frequency));
    let present = Object::new();
    put(&present, "amplitude", &outlook.present_amplitude.into());
    put(&present, "frequency", &maybe(outlook.present_frequency));
    put(&present, "trend", &record(&outlook.trend)?);
    put(&object, "present", &present.into());
    put(&object, "envelope", &envelope(&outlook.envelope).into());
    put(&object, "orbit", &columns(states, outlook.orbit).into());
    Ok(object.into())
}

pub(super) fn forces_along(columns: &ForceColumns) -> Object {
    let object = Object::new();
    put(&object, "slipAngle", &series(&columns.slip_angle));
    put(&object, "sideForce", &series(&columns.side_force));
    put(&object, "aligningMoment", &series(&columns.aligning_moment));
    put(&object, "springTorque", &series(&columns.spring_torque));
    object
}

pub(super) fn force_laws(laws: &ForceLaws) -> Result<JsValue, JsValue> {
    let object = Object::new();
    put(&object, "slipAngle", &series(&laws.slip_angle));
    put(&object, "sideForce", &series(&laws.side_force));
    put(&object, "aligningMoment", &series(&laws.aligning_moment));
    put(&object, "torsionAngle", &series(&laws.torsion_angle));
    put(&object, "restoringMoment", &series(&laws.restoring_moment));
    put(&object, "kinks", &record(&laws.kinks)?);
    Ok(object.into())
}

pub(super) fn spectrum(spectrum: &Spectrum) -> Result<JsValue, JsValue> {
    let object = Object::new();
    put(&object, "frequency", &series(&spectrum.frequency));
    put(&object, "amplitude", &series(&spectrum.amplitude));
    put(&object, "peak", &record(&spectrum.peak)?);
    Ok(object.into())
}

#[inline(never)]
pub(super) fn maybe(value: Option<f64>) -> JsValue {
    value.map_or(JsValue::NULL, JsValue::from)
}
