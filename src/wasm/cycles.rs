//! Limit cycles: found, and predicted.

use js_sys::{Array, Object};
use wasm_bindgen::prelude::*;

use super::{
    input,
    linear::complex,
    output::{self, put},
    read_run,
};
use crate::{cycles::Guess, live::Columns};

/// The limit cycle near the guess, or the one that the run's motion settles on; from rest, one that a larger and larger
/// push leads to.
#[wasm_bindgen(js_name = limitCycle, unchecked_return_type = "LimitCycle")]
pub fn limit_cycle(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CycleGuess | null")] guess: JsValue,
) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    let guess = input::value(&guess, "guess").and_then(|value| Guess::read(&run, &value)).map_err(output::error)?;
    let found = run.limit_cycle(guess.as_ref()).map_err(output::error)?;
    let states = run.description().state;
    let object = Object::new();
    put(&object, "found", &found.is_some().into());
    put(&object, "period", &output::maybe(found.as_ref().map(|cycle| cycle.period)));
    put(&object, "frequency", &output::maybe(found.as_ref().map(|cycle| cycle.frequency)));
    let truth = |truth: Option<bool>| truth.map_or(JsValue::NULL, JsValue::from);
    put(&object, "stable", &truth(found.as_ref().map(|cycle| cycle.stable)));
    put(&object, "symmetric", &truth(found.as_ref().map(|cycle| cycle.symmetric)));
    let (amplitude, mut multipliers) = (Object::new(), Array::new());
    let mut orbit = Columns { time: Vec::new(), states: vec![Vec::new(); states.len()] };
    if let Some(cycle) = found {
        for (state, value) in states.iter().zip(cycle.amplitude) {
            put(&amplitude, state.name, &value.into());
        }
        multipliers = cycle.multipliers.into_iter().map(|value| JsValue::from(complex(value))).collect();
        orbit = cycle.orbit;
    }
    put(&object, "amplitude", &amplitude.into());
    put(&object, "multipliers", &multipliers.into());
    put(&object, "orbit", &output::columns(states, orbit).into());
    Ok(object.into())
}

/// The limit cycles that describing functions predict, by rising amplitude.
#[wasm_bindgen(js_name = describingFunction, unchecked_return_type = "PredictedCycle[]")]
pub fn describing_function(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    output::record(&read_run(&run)?.describing_function().map_err(output::error)?)
}
