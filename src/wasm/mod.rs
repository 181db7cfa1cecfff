//! The JavaScript API: the only place that knows of JavaScript.
//!
//! Every exported function reads its input into a [`Value`], hands it to the crate, and writes the result as plain
//! objects and `Float64Array`s. Nothing here can panic on input, and methods take `&self`: a panic would leave a
//! `&mut self` borrowed for ever.

mod input;
mod output;
mod simulator;

pub use simulator::Simulator;

use wasm_bindgen::prelude::*;

use crate::{
    Error, Run, atlas,
    integrate::methods as list_of_methods,
    model::{self, Model, Torsional, laws::Curves, torsional},
    parameter::{Validity, check_number},
    run::Value,
    spectrum::Series,
    stability::Variation,
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
    output::record(&model::list())
}

/// Table of all methods.
#[wasm_bindgen(unchecked_return_type = "Method[]")]
pub fn methods() -> Result<JsValue, JsValue> {
    output::record(&list_of_methods())
}

/// Carries out a run.
#[wasm_bindgen(unchecked_return_type = "Trajectory")]
pub fn simulate(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    output::trajectory(&run, run.simulate().map_err(output::error)?)
}

/// What becomes of a motion if nothing changes; `duration` is how far ahead it looks (6 s).
#[wasm_bindgen(unchecked_return_type = "Outlook")]
pub fn outlook(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    output::outlook(&run, run.outlook().map_err(output::error)?)
}

/// What linear theory says of the gear at rest, and where that changes.
#[wasm_bindgen(js_name = routhHurwitz, unchecked_return_type = "RouthHurwitz")]
pub fn routh_hurwitz(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    output::record(&read_run(&run)?.routh_hurwitz().map_err(output::error)?)
}

/// The parts of a parameter's range in which linear theory does not find the gear stable, the others as in the run.
#[wasm_bindgen(js_name = unstableIntervals, unchecked_return_type = "UnstableInterval[]")]
pub fn unstable_intervals(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Variation")] variation: JsValue,
) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    let variation = input::value(&variation, "variation").and_then(|value| Variation::read(&value));
    output::record(&variation.and_then(|variation| run.unstable_intervals(&variation)).map_err(output::error)?)
}

/// The energy of one cycle from the run's start, or of its `duration` where it has one.
#[wasm_bindgen(unchecked_return_type = "Energy | null")]
pub fn energy(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> Result<JsValue, JsValue> {
    output::record(&read_run(&run)?.energy().map_err(output::error)?)
}

/// The force laws as curves: against the slip angle and against the torsion angle, with their kinks among the points.
#[wasm_bindgen(js_name = forceLaws, unchecked_return_type = "ForceLaws")]
pub fn force_laws(
    #[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Curves | null | undefined")] curves: JsValue,
) -> Result<JsValue, JsValue> {
    let run = read_run(&run)?;
    let curves = input::value(&curves, "curves").and_then(|value| Curves::read(&value));
    output::force_laws(&curves.and_then(|curves| run.force_laws(&curves)).map_err(output::error)?)
}

/// The amplitude spectrum of equally spaced values: a sinusoid of amplitude A shows as A.
#[wasm_bindgen(unchecked_return_type = "Spectrum")]
pub fn spectrum(#[wasm_bindgen(unchecked_param_type = "Series")] series: JsValue) -> Result<JsValue, JsValue> {
    let series = input::value(&series, "series").and_then(|value| Series::read(&value)).map_err(output::error)?;
    output::spectrum(&series.spectrum())
}

/// The figures and tables of the work that this implements.
#[wasm_bindgen(unchecked_return_type = "AtlasEntry[]")]
pub fn atlas() -> Result<JsValue, JsValue> {
    js_sys::JSON::parse(atlas::JSON)
}

/// Values that the links σ = 3a and κ = 0.15 a² c_Fα F_z give for these parameters of the torsional gear.
#[wasm_bindgen(js_name = linkedParameters, unchecked_return_type = "LinkedParameters")]
pub fn linked_parameters(
    #[wasm_bindgen(unchecked_param_type = "Parameters | null | undefined")] parameters: JsValue,
) -> Result<JsValue, JsValue> {
    let run = torsional_run(&parameters)?;
    let of = |name: &str| {
        let index = Torsional::PARAMETERS.iter().position(|p| p.name == name);
        index.map_or(f64::NAN, |index| run.parameters()[index])
    };
    let (sigma, kappa) = torsional::linked(of("halfContactLength"), of("sideForceDerivative"), of("verticalForce"));
    let record = js_sys::Object::new();
    output::put(&record, "relaxationLength", &sigma.into());
    output::put(&record, "treadWidthMomentConstant", &kappa.into());
    Ok(record.into())
}

/// Forces of the torsional gear at a state: three numbers in the order of the state table.
#[wasm_bindgen(unchecked_return_type = "Forces")]
pub fn forces(
    #[wasm_bindgen(unchecked_param_type = "Parameters | null | undefined")] parameters: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array | number[]")] state: JsValue,
) -> Result<JsValue, JsValue> {
    let run = torsional_run(&parameters)?;
    let refused = |got: String| {
        let allowed = "three numbers: torsionAngle, torsionRate, lateralDeformation";
        output::error(Error::new(crate::Code::WrongType, "state", got, allowed))
    };
    match input::value(&state, "state").map_err(output::error)? {
        Value::Numbers(x) if x.len() == 3 => {
            for (state, value) in Torsional::STATE.iter().zip(&x) {
                check_number(state.name, *value, Validity::Finite, state.unit).map_err(output::error)?;
            }
            output::record(&Torsional::laws(run.parameters()).map(|laws| laws.forces(&x)))
        }
        other => Err(refused(other.shown())),
    }
}

fn read_run(run: &JsValue) -> Result<Run, JsValue> {
    input::value(run, "run").and_then(|value| Run::read(&value)).map_err(output::error)
}

fn torsional_run(parameters: &JsValue) -> Result<Run, JsValue> {
    let parameters = input::value(parameters, "parameters").map_err(output::error)?;
    let model = Value::Text(Torsional::NAME.into());
    Run::read(&Value::Record(vec![("model".into(), model), ("parameters".into(), parameters)])).map_err(output::error)
}
