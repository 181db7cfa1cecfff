//! Linear theory over a plane of two parameters.

use wasm_bindgen::prelude::*;

use super::{input, job, output, record::list};
use crate::stability::CurveSpec;

/// Stability over a plane of two parameters, cell by cell.
#[wasm_bindgen(js_name = stabilityMap, unchecked_return_type = "StabilityMap")]
pub fn stability_map(#[wasm_bindgen(unchecked_param_type = "MapSpec")] map: JsValue) -> Result<JsValue, JsValue> {
    job::whole("stabilityMap", &map)
}

/// The curves in a plane of two parameters at which eigenvalues cross the imaginary axis.
#[wasm_bindgen(js_name = hopfCurve, unchecked_return_type = "HopfCurve[]")]
pub fn hopf_curve(#[wasm_bindgen(unchecked_param_type = "CurveSpec")] plane: JsValue) -> Result<JsValue, JsValue> {
    let curves = input::value(&plane, "plane").and_then(|value| CurveSpec::read(&value)?.made());
    Ok(list(&curves.map_err(output::error)?, output::hopf_curve))
}
