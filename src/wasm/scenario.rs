//! What a gear goes through.

use wasm_bindgen::prelude::*;

use super::job;

/// A landing roll: a run whose speed falls, until the last speed where it gives no duration.
#[wasm_bindgen(js_name = landingRoll, unchecked_return_type = "Landing")]
pub fn landing_roll(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    job::whole("landingRoll", &run)
}
