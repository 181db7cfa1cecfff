//! Dampers by themselves.

use wasm_bindgen::prelude::*;

use super::{input, output, record::Record};
use crate::element::damper::{self, DamperResponse, ResponseSpec};

/// Tables of all dampers.
#[wasm_bindgen(unchecked_return_type = "DamperModel[]")]
pub fn dampers() -> Result<JsValue, JsValue> {
    output::table(&damper::list())
}

/// What a damper does as its piston is moved: x(t) = amplitude · sin(2π · frequency · t), from rest.
#[wasm_bindgen(js_name = damperResponse, unchecked_return_type = "DamperResponse")]
pub fn damper_response(
    #[wasm_bindgen(unchecked_param_type = "DamperResponseSpec")] spec: JsValue,
) -> Result<JsValue, JsValue> {
    let rows = input::value(&spec, "spec").and_then(|value| ResponseSpec::read(&value)?.response());
    Ok(response(&rows.map_err(output::error)?).done())
}

pub(super) fn response(rows: &DamperResponse) -> Record {
    Record::new()
        .series("time", &rows.time)
        .series("displacement", &rows.displacement)
        .series("velocity", &rows.velocity)
        .series("force", &rows.force)
        .series("hysteresis", &rows.hysteresis)
        .series("internalDisplacement", &rows.internal_displacement)
}
