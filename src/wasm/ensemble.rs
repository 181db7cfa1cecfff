//! Many motions: basins and sweeps.

use wasm_bindgen::prelude::*;

use super::{input, output};
use crate::ensemble::{BasinsSpec, SweepSpec};

/// In which motion each cell of a plane ends.
#[wasm_bindgen(unchecked_return_type = "Basins")]
pub fn basins(#[wasm_bindgen(unchecked_param_type = "BasinsSpec")] basins: JsValue) -> Result<JsValue, JsValue> {
    let made = input::value(&basins, "basins").and_then(|value| BasinsSpec::read(&value)?.made());
    made.map(|basins| output::basins(&basins)).map_err(output::error)
}

/// One motion carried on as a parameter goes there and back.
#[wasm_bindgen(unchecked_return_type = "Sweep")]
pub fn sweep(#[wasm_bindgen(unchecked_param_type = "SweepSpec")] sweep: JsValue) -> Result<JsValue, JsValue> {
    let made = input::value(&sweep, "sweep").and_then(|value| SweepSpec::read(&value)?.made());
    made.map(|sweep| output::sweep(&sweep)).map_err(output::error)
}
