//! The live motion as a JavaScript class.

use std::cell::RefCell;

use js_sys::Uint8Array;
use wasm_bindgen::prelude::*;

use super::{
    call_into, input, output,
    record::{Record, numbers, series},
};
use crate::{Run, error::Result, live};

/// A live motion of a run.
#[wasm_bindgen]
pub struct Simulator(RefCell<live::Simulator>);

#[wasm_bindgen]
impl Simulator {
    /// A live motion that starts as the run does.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Run")] run: JsValue) -> std::result::Result<Simulator, JsValue> {
        let motion = input::value(&run, "run").and_then(|value| Run::read(&value)?.live());
        motion.map(|motion| Self(RefCell::new(motion))).map_err(output::error)
    }

    /// The time shown, in s.
    #[wasm_bindgen(getter, unchecked_return_type = "number")]
    pub fn time(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| Ok(motion.time().into()))
    }

    /// Earliest and latest time that can be sought, in s.
    #[wasm_bindgen(getter, unchecked_return_type = "[number, number]")]
    pub fn range(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| Ok(numbers(&motion.range())))
    }

    /// Goes on by `dt` ≥ 0 s.
    pub fn advance(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] dt: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| motion.advance(input::number(&dt, "dt", "≥ 0 s")?))
    }

    /// The state at the time shown, in the order of the state table.
    #[wasm_bindgen(unchecked_return_type = "Float64Array")]
    pub fn state(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| Ok(series(&motion.state())))
    }

    /// The parameters at the time shown, by name; those of elements by their dotted names.
    #[wasm_bindgen(unchecked_return_type = "Record<string, number>")]
    pub fn parameters(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| {
            let values = motion.description().table.iter().zip(motion.parameters());
            Ok(values.fold(Record::new(), |record, (parameter, value)| record.number(parameter.name, value)).done())
        })
    }

    /// Sets a parameter now.
    pub fn set(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string")] name: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] value: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| {
            let name = input::text(&name, "name")?;
            motion.set(&name, input::number(&value, &name, "a finite number")?)
        })
    }

    /// Sets a state variable now.
    #[wasm_bindgen(js_name = setState)]
    pub fn set_state(
        &self,
        #[wasm_bindgen(unchecked_param_type = "string")] name: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] value: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| {
            let name = input::text(&name, "name")?;
            motion.set_state(&name, input::number(&value, &name, "a finite number")?)
        })
    }

    /// Gives an angular impulse in N m s about the steering axis.
    pub fn kick(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] impulse: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| motion.kick(input::number(&impulse, "impulse", "a finite number of N m s")?))
    }

    /// Back to the run as it was given.
    pub fn reset(&self) -> std::result::Result<(), JsValue> {
        self.with(|motion| motion.reset())
    }

    /// Shows another time within `range`.
    pub fn seek(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] time: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| motion.seek(input::number(&time, "time", "a time within the range, in s")?))
    }

    /// The present as bytes.
    #[wasm_bindgen(unchecked_return_type = "Uint8Array")]
    pub fn snapshot(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| Ok(Uint8Array::from(motion.snapshot().as_slice()).into()))
    }

    /// Takes up the motion of a snapshot of the same model.
    pub fn restore(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Uint8Array")] bytes: JsValue,
    ) -> std::result::Result<(), JsValue> {
        self.with(|motion| motion.restore(&input::bytes(&bytes, "bytes")?))
    }

    /// The solver's steps since the last call up to the time shown, thinned to at most `max` rows; with room for two rows
    /// a state no peak is lost. Some 10 000 steps are remembered.
    #[wasm_bindgen(unchecked_return_type = "Columns")]
    pub fn trace(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] max: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| {
            let columns = motion.trace(input::number(&max, "max", "a whole number from 2 to 1e7")?)?;
            Ok(output::columns(motion.description().state, &columns))
        })
    }

    /// Values at `samples` times, equally spaced over a window of what has been recorded.
    #[wasm_bindgen(unchecked_return_type = "Columns")]
    pub fn history(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] to: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] samples: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| {
            let (from, to) = window(&from, &to)?;
            let columns =
                motion.history(from, to, input::number(&samples, "samples", "a whole number from 2 to 1e7")?)?;
            Ok(output::columns(motion.description().state, &columns))
        })
    }

    /// Least and greatest value of the first state over a window of what has been recorded, in `buckets` parts.
    #[wasm_bindgen(unchecked_return_type = "Envelope")]
    pub fn envelope(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] from: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] to: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] buckets: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|motion| {
            let (from, to) = window(&from, &to)?;
            let envelope =
                motion.envelope(from, to, input::number(&buckets, "buckets", "a whole number from 1 to 1e7")?)?;
            Ok(output::envelope(&envelope))
        })
    }
}

fn window(from: &JsValue, to: &JsValue) -> Result<(f64, f64)> {
    let allowed = "a time within the range, in s";
    Ok((input::number(from, "from", allowed)?, input::number(to, "to", allowed)?))
}

impl Simulator {
    fn with<T>(&self, call: impl FnOnce(&mut live::Simulator) -> Result<T>) -> std::result::Result<T, JsValue> {
        call_into(&self.0, "simulator", call)
    }
}
