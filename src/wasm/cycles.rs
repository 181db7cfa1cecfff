//! Limit cycles: found, predicted, and followed along a parameter.

use wasm_bindgen::prelude::*;

use super::{input, job, of_run, output, record::list};
use crate::cycles::Guess;

/// The limit cycle near the guess, or the one that the run's motion settles on; from rest, one that a larger and larger
/// push leads to.
#[wasm_bindgen(js_name = limitCycle, unchecked_return_type = "LimitCycle")]
pub fn limit_cycle(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "CycleGuess | null")] guess: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let guess = Guess::read(run, &input::value(&guess, "guess")?)?;
        Ok(output::limit_cycle(run.description().state, run.limit_cycle(guess.as_ref())?.as_ref()))
    })
}

/// The limit cycles that describing functions predict, by rising amplitude.
#[wasm_bindgen(js_name = describingFunction, unchecked_return_type = "PredictedCycle[]")]
pub fn describing_function(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(list(&run.describing_function()?, output::predicted)))
}

/// Rest and limit cycles over the range of a parameter, stable or not, with the points at which they change.
#[wasm_bindgen(unchecked_return_type = "Bifurcation")]
pub fn bifurcation(
    #[wasm_bindgen(unchecked_param_type = "BifurcationSpec")] spec: JsValue,
) -> Result<JsValue, JsValue> {
    job::whole("bifurcation", &spec)
}

/// The curves in a plane of two parameters at which two limit cycles meet and vanish.
#[wasm_bindgen(js_name = foldCurve, unchecked_return_type = "FoldCurve[]")]
pub fn fold_curve(#[wasm_bindgen(unchecked_param_type = "FoldSpec")] plane: JsValue) -> Result<JsValue, JsValue> {
    job::whole("foldCurve", &plane)
}
