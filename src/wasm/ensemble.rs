//! Many motions, and many passages of one: basins, sweeps, Poincaré's section.

use wasm_bindgen::prelude::*;

use super::{input, job, of_run, output};
use crate::section::SectionSpec;

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

/// Where a motion passes a section of its states, within the run's duration.
#[wasm_bindgen(unchecked_return_type = "Section")]
pub fn poincare(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "SectionSpec | null")] section: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let section = SectionSpec::read(run, &input::value(&section, "section")?)?;
        Ok(output::section(run.description().state, &run.section(&section)?))
    })
}
