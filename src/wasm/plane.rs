//! Linear theory over a plane of two parameters.

use js_sys::{Array, Object, Uint8Array};
use wasm_bindgen::prelude::*;

use super::{
    input,
    output::{self, maybe, put, series},
};
use crate::stability::{CurveSpec, KINDS, MapSpec, StabilityMap};

/// Stability over a plane of two parameters, cell by cell.
#[wasm_bindgen(js_name = stabilityMap, unchecked_return_type = "StabilityMap")]
pub fn stability_map(#[wasm_bindgen(unchecked_param_type = "MapSpec")] map: JsValue) -> Result<JsValue, JsValue> {
    let map = input::value(&map, "map").and_then(|value| MapSpec::read(&value)?.made());
    map.and_then(|map| object_of(&map)).map_err(output::error)
}

/// The curves in a plane of two parameters at which eigenvalues cross the imaginary axis.
#[wasm_bindgen(js_name = hopfCurve, unchecked_return_type = "HopfCurve[]")]
pub fn hopf_curve(#[wasm_bindgen(unchecked_param_type = "CurveSpec")] plane: JsValue) -> Result<JsValue, JsValue> {
    let curves = input::value(&plane, "plane").and_then(|value| CurveSpec::read(&value)?.made());
    let list = Array::new();
    for curve in curves.map_err(output::error)? {
        let object = Object::new();
        put(&object, "x", &series(&curve.x));
        put(&object, "y", &series(&curve.y));
        put(&object, "frequency", &series(&curve.frequency));
        put(&object, "kind", &output::record(&curve.kind)?);
        put(&object, "closed", &curve.closed.into());
        put(&object, "bounds", &curve.bounds.into());
        list.push(&object);
    }
    Ok(list.into())
}

/// What there is of a map.
pub(super) fn object_of(map: &StabilityMap) -> crate::Result<JsValue> {
    let object = Object::new();
    let (cells, wanted) = (map.cells(), map.spec().quantities);
    put(&object, "stable", &bytes(&cells.stable[..cells.made]));
    put(&object, "stablePercent", &maybe(map.stable_percent()));
    put(&object, "stableArea", &maybe(map.stable_area()?));
    if wanted.growth_rate {
        put(&object, "growthRate", &series(&cells.growth_rate[..cells.made]));
    }
    if wanted.frequency {
        put(&object, "frequency", &series(&cells.frequency[..cells.made]));
    }
    if wanted.kind {
        put(&object, "kind", &bytes(&cells.kind[..cells.made]));
        put(&object, "kinds", &KINDS.iter().map(|kind| JsValue::from(*kind)).collect::<Array>().into());
    }
    Ok(object.into())
}

fn bytes(bytes: &[u8]) -> JsValue {
    Uint8Array::from(bytes).into()
}
