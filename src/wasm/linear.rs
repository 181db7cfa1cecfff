//! Linear theory of a run's gear.

use js_sys::{Array, Object};
use nalgebra::Complex;
use wasm_bindgen::prelude::*;

use super::{
    input,
    output::{self, put},
    read_run,
};
use crate::{
    Run,
    stability::{Eigenmode, Variation},
};

/// What linear theory says of the gear at rest, and where that changes.
#[wasm_bindgen(js_name = routhHurwitz, unchecked_return_type = "RouthHurwitz")]
pub fn routh_hurwitz(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    output::record(&read_run(&run)?.routh_hurwitz().map_err(output::error)?)
}

/// Routh's array of the characteristic polynomial.
#[wasm_bindgen(js_name = routhArray, unchecked_return_type = "RouthArray")]
pub fn routh_array(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    output::record(&read_run(&run)?.routh_array().map_err(output::error)?)
}

/// The parts of a parameter's range in which linear theory does not find the gear stable, the others as in the run.
#[wasm_bindgen(js_name = unstableIntervals, unchecked_return_type = "UnstableInterval[]")]
pub fn unstable_intervals(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Variation")] variation: JsValue,
) -> Result<JsValue, JsValue> {
    let (run, variation) = (read_run(&run)?, read_variation(&variation)?);
    output::record(&run.unstable_intervals(&variation).map_err(output::error)?)
}

/// Every value in a parameter's range at which eigenvalues cross the imaginary axis, the others as in the run.
#[wasm_bindgen(unchecked_return_type = "Crossing[]")]
pub fn crossings(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Variation")] variation: JsValue,
) -> Result<JsValue, JsValue> {
    let (run, variation) = (read_run(&run)?, read_variation(&variation)?);
    output::record(&run.crossings(&variation).map_err(output::error)?)
}

/// The state at which the gear rests.
#[wasm_bindgen(unchecked_return_type = "Record<string, number>")]
pub fn equilibrium(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    let object = Object::new();
    for (state, value) in run.description().state.iter().zip(run.linearised().map_err(output::error)?.equilibrium) {
        put(&object, state.name, &value.into());
    }
    Ok(object.into())
}

/// The Jacobian at the equilibrium, row by row.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn jacobian(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let jacobian = read_run(&run)?.linearised().map_err(output::error)?.jacobian;
    let n = jacobian.nrows();
    let entries: Vec<f64> = (0..n * n).map(|place| jacobian[(place / n, place % n)]).collect();
    Ok(output::series(&entries))
}

/// The eigenvalues of the Jacobian in 1/s, by falling real part, of a pair the positive imaginary part first.
#[wasm_bindgen(unchecked_return_type = "ComplexNumber[]")]
pub fn eigenvalues(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let values = read_run(&run)?.eigenvalues().map_err(output::error)?;
    Ok(values.into_iter().map(|value| JsValue::from(complex(value))).collect::<Array>().into())
}

/// The coefficients of the Jacobian's characteristic polynomial, highest power (1) first.
#[wasm_bindgen(js_name = characteristicPolynomial, unchecked_return_type = "Float64Array")]
pub fn characteristic_polynomial(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
) -> Result<JsValue, JsValue> {
    Ok(output::series(&read_run(&run)?.characteristic_polynomial().map_err(output::error)?))
}

/// What the gear does at each eigenvalue, in the same order.
#[wasm_bindgen(unchecked_return_type = "Eigenmode[]")]
pub fn eigenmodes(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    let modes = run.eigenmodes().map_err(output::error)?;
    Ok(modes.iter().map(|mode| eigenmode(&run, mode)).collect::<Result<Array, JsValue>>()?.into())
}

fn eigenmode(run: &Run, mode: &Eigenmode) -> Result<JsValue, JsValue> {
    let states = run.description().state;
    let object = Object::new();
    put(&object, "eigenvalue", &complex(mode.eigenvalue).into());
    put(&object, "dampingRatio", &output::maybe(mode.damping_ratio));
    put(&object, "naturalFrequency", &mode.natural_frequency.into());
    put(&object, "timeToHalf", &output::maybe(mode.time_to_half));
    put(&object, "timeToDouble", &output::maybe(mode.time_to_double));
    put(&object, "reference", &states[mode.reference].name.into());
    let shape = Object::new();
    for (state, part) in states.iter().zip(&mode.shape) {
        let phasor = complex(*part);
        put(&phasor, "amplitude", &part.norm().into());
        put(&phasor, "lag", &(-part.im).atan2(part.re).into());
        put(&shape, state.name, &phasor.into());
    }
    put(&object, "shape", &shape.into());
    put(&object, "energyFlow", &output::record(&mode.energy_flow)?);
    Ok(object.into())
}

pub(super) fn complex(value: Complex<f64>) -> Object {
    let object = Object::new();
    put(&object, "re", &value.re.into());
    put(&object, "im", &value.im.into());
    object
}

fn read_variation(variation: &JsValue) -> Result<Variation, JsValue> {
    let value = input::value(variation, "variation");
    value.and_then(|value| Variation::read(&value)).map_err(output::error)
}
