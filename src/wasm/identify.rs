//! A damper's values from records of its force.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;

use super::{
    call_into, input, output,
    record::{Record, list, series},
};
use crate::{
    error::{Code, Error, Result},
    identify::{self, Direction, Fit, IdentificationSpec, RecordSpec, Spread},
    parameter::Parameter,
    run::Value,
};

/// A record of a damper on a moving piston, with noise in its force.
#[wasm_bindgen(js_name = damperRecord, unchecked_return_type = "DamperRecord")]
pub fn damper_record(
    #[wasm_bindgen(unchecked_param_type = "DamperRecordSpec")] spec: JsValue,
) -> std::result::Result<JsValue, JsValue> {
    let record = input::value(&spec, "spec").and_then(|value| RecordSpec::read(&value)?.record());
    record.map_err(output::error).map(|record| {
        Record::new()
            .series("displacement", &record.displacement)
            .series("velocity", &record.velocity)
            .series("force", &record.force)
            .number("command", record.command)
            .number("interval", record.interval)
            .done()
    })
}

/// The errors of a population: as many values an individual as the model has parameters, in table order, one individual
/// after the other.
#[wasm_bindgen(unchecked_return_type = "Float64Array")]
pub fn fitness(
    #[wasm_bindgen(unchecked_param_type = "IdentificationSpec")] spec: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array | number[]")] population: JsValue,
) -> std::result::Result<JsValue, JsValue> {
    let errors = || {
        let spec = IdentificationSpec::read(&input::value(&spec, "identification")?)?;
        spec.fitness(&numbers(&population, "population")?)
    };
    errors().map(|errors| series(&errors)).map_err(output::error)
}

/// What the records fix of values that several seeds have found (one after the other, all parameters in table order), and
/// what they do not.
#[wasm_bindgen(unchecked_return_type = "Identifiability")]
pub fn identifiability(
    #[wasm_bindgen(unchecked_param_type = "IdentificationSpec")] spec: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Float64Array | number[]")] population: JsValue,
) -> std::result::Result<JsValue, JsValue> {
    let known = || {
        let spec = IdentificationSpec::read(&input::value(&spec, "identification")?)?;
        spec.identifiability(&numbers(&population, "population")?)
    };
    let known = known().map_err(output::error)?;
    Ok(Record::new()
        .series("errors", &known.errors)
        .number("best", known.best as f64)
        .value("parameters", list(&known.parameters, spread))
        .value("weak", list(&known.weak, direction))
        .value("fits", list(&known.fits, fit))
        .done())
}

fn numbers(js: &JsValue, field: &str) -> Result<Vec<f64>> {
    match input::value(js, field)? {
        Value::Numbers(numbers) => Ok(numbers),
        other => Err(Error::new(Code::WrongType, field, other.shown(), "a list of numbers")),
    }
}

fn spread(spread: &Spread) -> JsValue {
    Record::new()
        .text("name", spread.name)
        .number("value", spread.value)
        .numbers("range", &spread.range)
        .number("spread", spread.spread)
        .number("slack", spread.slack)
        .truth("fixed", spread.fixed)
        .done()
}

fn direction(direction: &Direction) -> JsValue {
    let parts = direction.parts.iter().fold(Record::new(), |record, (name, part)| record.number(name, *part));
    Record::new().number("change", direction.change).record("parts", parts).done()
}

fn fit(fit: &Fit) -> JsValue {
    Record::new().number("command", fit.command).number("error", fit.error).series("force", &fit.force).done()
}

fn by_name(table: &[Parameter], values: &[f64]) -> Record {
    table.iter().zip(values).fold(Record::new(), |record, (parameter, value)| record.number(parameter.name, *value))
}

/// What an identification has so far.
pub(super) fn progress(identification: &identify::Identification) -> Result<JsValue> {
    let spec = identification.spec();
    let [best, mean] = identification.history();
    let values = identification.best();
    Ok(Record::new()
        .text("model", spec.damper.name)
        .record("parameters", by_name(spec.damper.parameters, &values))
        .maybe("error", Some(identification.best_error()).filter(|error| error.is_finite()))
        .number("generation", identification.generation() as f64)
        .number("seed", spec.seed as f64)
        .record("history", Record::new().series("best", best).series("mean", mean))
        // Before the first generation the values are anybody's.
        .value("fits", list(spec.fits(&values).unwrap_or_default().iter(), fit))
        .done())
}

/// A genetic algorithm on its way to a damper's values: the same seed is the same way.
#[wasm_bindgen]
pub struct Identification(RefCell<identify::Identification>);

#[wasm_bindgen]
impl Identification {
    /// Before its first generation.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "IdentificationSpec")] spec: JsValue,
    ) -> std::result::Result<Identification, JsValue> {
        let spec = input::value(&spec, "identification").and_then(|value| IdentificationSpec::read(&value));
        spec.map(|spec| Self(RefCell::new(identify::Identification::new(spec)))).map_err(output::error)
    }

    /// A generation, or a step of the polish.
    #[wasm_bindgen(unchecked_return_type = "Generation")]
    pub fn step(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|identification| {
            identification.step();
            Ok(generation(identification))
        })
    }

    /// The generation whose errors are wanted next, as `fitness` takes it; nobody while the best is polished.
    #[wasm_bindgen(unchecked_return_type = "Float64Array")]
    pub fn ask(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|identification| Ok(series(&identification.ask())))
    }

    /// Goes on by a generation whose errors are these; none while the best is polished.
    #[wasm_bindgen(unchecked_return_type = "Generation")]
    pub fn tell(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Float64Array | number[]")] errors: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|identification| {
            identification.tell(&numbers(&errors, "errors")?)?;
            Ok(generation(identification))
        })
    }

    /// What is there so far: what a job of this kind gives.
    #[wasm_bindgen(unchecked_return_type = "Identified")]
    pub fn result(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|identification| progress(identification))
    }

    /// Nothing is left to do.
    #[wasm_bindgen(getter)]
    pub fn done(&self) -> std::result::Result<bool, JsValue> {
        self.with(|identification| Ok(identification.done()))
    }
}

impl Identification {
    fn with<R>(
        &self,
        call: impl FnOnce(&mut identify::Identification) -> Result<R>,
    ) -> std::result::Result<R, JsValue> {
        call_into(&self.0, "identification", call)
    }
}

fn generation(identification: &identify::Identification) -> JsValue {
    let last = |errors: &[f64]| errors.last().copied().filter(|error| error.is_finite());
    let [best, mean] = identification.history();
    Record::new()
        .number("generation", identification.generation() as f64)
        .maybe("bestError", last(best))
        .maybe("meanError", last(mean))
        .record("best", by_name(identification.spec().damper.parameters, &identification.best()))
        .truth("polishing", identification.polishing())
        .truth("done", identification.done())
        .done()
}
