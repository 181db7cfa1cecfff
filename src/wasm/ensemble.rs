//! Many motions: basins and sweeps.

use wasm_bindgen::prelude::*;

use super::job;

/// In which motion each cell of a plane ends.
#[wasm_bindgen(unchecked_return_type = "Basins")]
pub fn basins(#[wasm_bindgen(unchecked_param_type = "BasinsSpec")] spec: JsValue) -> Result<JsValue, JsValue> {
    job::whole("basins", &spec)
}

/// One motion carried on as a parameter goes there and back.
#[wasm_bindgen(unchecked_return_type = "Sweep")]
pub fn sweep(#[wasm_bindgen(unchecked_param_type = "SweepSpec")] spec: JsValue) -> Result<JsValue, JsValue> {
    job::whole("sweep", &spec)
}
