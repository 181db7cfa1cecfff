//! Linear theory of a run's gear.

use wasm_bindgen::prelude::*;

use super::{
    input, of_run, output,
    record::{list, series},
};
use crate::{Run, error, stability::Variation};

/// What linear theory says of the gear at rest, and where that changes.
#[wasm_bindgen(js_name = routhHurwitz, unchecked_return_type = "RouthHurwitz")]
pub fn routh_hurwitz(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::routh_hurwitz(&run.routh_hurwitz()?)))
}

/// Routh's array of the characteristic polynomial.
#[wasm_bindgen(js_name = routhArray, unchecked_return_type = "RouthArray")]
pub fn routh_array(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::routh_array(&run.routh_array()?)))
}

/// The parts of a parameter's range in which linear theory does not find the gear stable, the others as in the run.
#[wasm_bindgen(js_name = unstableIntervals, unchecked_return_type = "UnstableInterval[]")]
pub fn unstable_intervals(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Variation")] variation: JsValue,
) -> Result<JsValue, JsValue> {
    varied(&run, &variation, &|run, variation| Ok(list(&run.unstable_intervals(variation)?, output::unstable_interval)))
}

/// Every value in a parameter's range at which eigenvalues cross the imaginary axis, the others as in the run.
#[wasm_bindgen(unchecked_return_type = "Crossing[]")]
pub fn crossings(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Variation")] variation: JsValue,
) -> Result<JsValue, JsValue> {
    varied(&run, &variation, &|run, variation| Ok(list(&run.crossings(variation)?, output::crossing)))
}

/// The state at which the gear rests.
#[wasm_bindgen(unchecked_return_type = "Record<string, number>")]
pub fn equilibrium(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::by_state(run.description().state, &run.linearised()?.equilibrium).done()))
}

/// The Jacobian at the equilibrium, row by row.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn jacobian(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    // Its columns are stored one after the other: those of the transposed are its rows.
    of_run(&run, &|run| Ok(series(run.linearised()?.jacobian.transpose().as_slice())))
}

/// The eigenvalues of the Jacobian in 1/s, by falling real part, of a pair the positive imaginary part first.
#[wasm_bindgen(unchecked_return_type = "ComplexNumber[]")]
pub fn eigenvalues(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(list(run.eigenvalues()?, output::complex)))
}

/// The coefficients of the Jacobian's characteristic polynomial, highest power (1) first.
#[wasm_bindgen(js_name = characteristicPolynomial, unchecked_return_type = "Float64Array")]
pub fn characteristic_polynomial(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(series(&run.characteristic_polynomial()?)))
}

/// What the gear does at each eigenvalue, in the same order.
#[wasm_bindgen(unchecked_return_type = "Eigenmode[]")]
pub fn eigenmodes(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let states = run.description().state;
        Ok(list(&run.eigenmodes()?, |mode| output::eigenmode(states, mode)))
    })
}

/// As [`of_run`], of a run and a variation.
fn varied(
    run: &JsValue,
    variation: &JsValue,
    answer: &dyn Fn(&Run, &Variation) -> error::Result<JsValue>,
) -> Result<JsValue, JsValue> {
    of_run(run, &|run| answer(run, &Variation::read(&input::value(variation, "variation")?)?))
}
