//! The JavaScript API: the only place that knows of JavaScript.
//!
//! Every exported function reads its input into a [`Value`], hands it to the crate, and writes the result as plain
//! objects and `Float64Array`s. Nothing here can panic on input, and methods take `&self`: a panic would leave a
//! `&mut self` borrowed for ever.

mod cycles;
mod damper;
pub(crate) mod digits;
mod ensemble;
mod identify;
mod input;
mod job;
mod linear;
mod output;
mod plane;
mod record;
mod scenario;
mod simulator;

pub use cycles::{bifurcation, describing_function, fold_curve, limit_cycle};
pub use damper::{Piston, damper_response, dampers};
pub use ensemble::{basins, poincare, sweep};
pub use identify::{Identification, damper_record, fitness, identifiability};
pub use job::Job;
pub use linear::{
    characteristic_polynomial, crossings, eigenmodes, eigenvalues, equilibrium, jacobian, routh_array, routh_hurwitz,
    unstable_intervals,
};
pub use plane::{hopf_curve, stability_map};
pub use scenario::landing_roll;
pub use simulator::Simulator;

use std::cell::RefCell;

use wasm_bindgen::prelude::*;

use crate::{
    Run, atlas,
    element::control,
    error,
    integrate::methods as list_of_methods,
    model::{self, laws::Curves},
    spectrum::Series,
};

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

/// A panic is a defect: its message goes to the console before the instance stops.
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|info| web_sys::console::error_1(&info.to_string().into())));
}

/// Version of the module.
#[wasm_bindgen]
pub fn version() -> String {
    env!("CARGO_PKG_VERSION").into()
}

/// Tables of all models.
#[wasm_bindgen(unchecked_return_type = "Model[]")]
pub fn models() -> Result<JsValue, JsValue> {
    output::table(&model::list())
}

/// What a run of this gear, with what is on it, has values for, and what its state is.
#[wasm_bindgen(js_name = runTables, unchecked_return_type = "RunTables")]
pub fn run_tables(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let run = input::value(&run, "run").and_then(|value| Run::read(&value)).map_err(output::error)?;
    output::table(&run.tables())
}

/// Table of all methods.
#[wasm_bindgen(unchecked_return_type = "Method[]")]
pub fn methods() -> Result<JsValue, JsValue> {
    output::table(&list_of_methods())
}

/// Tables of all control laws.
#[wasm_bindgen(unchecked_return_type = "ControlLaw[]")]
pub fn controls() -> Result<JsValue, JsValue> {
    output::table(&control::list())
}

/// Carries out a run.
#[wasm_bindgen(unchecked_return_type = "Trajectory")]
pub fn simulate(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::trajectory(run, &run.simulate()?)))
}

/// What becomes of a motion if nothing changes; `duration` is how far ahead it looks (6 s).
#[wasm_bindgen(unchecked_return_type = "Outlook")]
pub fn outlook(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::outlook(run, &run.outlook()?)))
}

/// The energy of one cycle from the run's start, or of its `duration` where it has one.
#[wasm_bindgen(unchecked_return_type = "Energy | null")]
pub fn energy(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(run.energy()?.as_ref().map_or(JsValue::NULL, output::energy)))
}

/// The force laws as curves: against the slip angle and against the torsion angle, with their kinks among the points.
#[wasm_bindgen(js_name = forceLaws, unchecked_return_type = "ForceLaws")]
pub fn force_laws(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_optional_param_type = "Curves | null")] curves: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let curves = Curves::read(&input::value(&curves, "curves")?)?;
        Ok(output::force_laws(&run.force_laws(&curves)?))
    })
}

/// The amplitude spectrum of equally spaced values: a sinusoid of amplitude A shows as A.
#[wasm_bindgen(unchecked_return_type = "Spectrum")]
pub fn spectrum(#[wasm_bindgen(unchecked_param_type = "Series")] series: JsValue) -> Result<JsValue, JsValue> {
    let series = input::value(&series, "series").and_then(|value| Series::read(&value)).map_err(output::error)?;
    Ok(output::spectrum(&series.spectrum()))
}

/// The figures and tables of the work that this implements.
#[wasm_bindgen(unchecked_return_type = "AtlasEntry[]")]
pub fn atlas() -> Result<JsValue, JsValue> {
    js_sys::JSON::parse(atlas::JSON)
}

/// Values that the links σ = 3a and κ = 0.15 a² c_Fα F_z give for the parameters of a run.
#[wasm_bindgen(js_name = linkedParameters, unchecked_return_type = "LinkedParameters")]
pub fn linked_parameters(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| Ok(output::linked_parameters(&run.linked_parameters()?)))
}

/// Forces at a state, in the order of the state table.
#[wasm_bindgen(unchecked_return_type = "Forces")]
pub fn forces(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array | number[]")] state: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let state = run.read_state(&input::value(&state, "state")?)?;
        Ok(output::forces(&run.forces(&state)?))
    })
}

/// Forces along a motion: what `forces` says, row by row.
#[wasm_bindgen(js_name = forcesAlong, unchecked_return_type = "ForceColumns")]
pub fn forces_along(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Columns")] columns: JsValue,
) -> Result<JsValue, JsValue> {
    of_run(&run, &|run| {
        let states = run.read_states(&input::value(&columns, "columns")?)?;
        Ok(output::forces_along(&run.forces_along(&states)?))
    })
}

/// What is answered of a run.
#[inline(never)]
fn of_run(run: &JsValue, answer: &dyn Fn(&Run) -> error::Result<JsValue>) -> Result<JsValue, JsValue> {
    input::value(run, "run").and_then(|value| answer(&Run::read(&value)?)).map_err(output::error)
}

/// Calls into what a class holds; a call from within a call (a getter that calls back) is refused.
fn call_into<T, R>(
    held: &RefCell<T>,
    class: &str,
    call: impl FnOnce(&mut T) -> error::Result<R>,
) -> Result<R, JsValue> {
    let mut held = held.try_borrow_mut().map_err(|_| {
        output::error(error::Error::new(error::Code::Unusable, class, "a call within a call", "called once at a time"))
    })?;
    call(&mut held).map_err(output::error)
}
