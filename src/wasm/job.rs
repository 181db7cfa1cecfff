//! Long work in slices, as a JavaScript class.

use std::cell::RefCell;

use js_sys::Date;
use wasm_bindgen::prelude::*;

use super::{call_into, input, output, record::Record};
use crate::{
    error::{Code, Error, Result, shown},
    stability::{MapSpec, StabilityMap},
};

/// Kinds of jobs.
const KINDS: [&str; 1] = ["stabilityMap"];

/// Work that is done bit by bit.
#[wasm_bindgen]
pub struct Job(RefCell<StabilityMap>);

#[wasm_bindgen]
impl Job {
    /// The work of the function of this name, with what that is given.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "'stabilityMap'")] kind: JsValue,
        #[wasm_bindgen(unchecked_param_type = "MapSpec")] spec: JsValue,
    ) -> std::result::Result<Job, JsValue> {
        let begin = || {
            let kind = input::text(&kind, "kind")?;
            if !KINDS.contains(&kind.as_str()) {
                return Err(Error::unknown(Code::UnknownName, "kind", &kind, &KINDS));
            }
            Ok(Self(RefCell::new(MapSpec::read(&input::value(&spec, "map")?)?.begin())))
        };
        begin().map_err(output::error)
    }

    /// Works on for about so many milliseconds, and tells how much is done.
    #[wasm_bindgen(unchecked_return_type = "Progress")]
    pub fn advance(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] milliseconds: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|map| {
            let allowed = "≥ 0 ms";
            let time = input::number(&milliseconds, "milliseconds", allowed)?;
            if time.is_nan() || time < 0.0 {
                return Err(Error::new(Code::OutOfRange, "milliseconds", shown(time), allowed));
            }
            let end = Date::now() + time;
            loop {
                map.advance()?;
                if map.done() || Date::now() >= end {
                    break;
                }
            }
            Ok(Record::new().truth("done", map.done()).number("fraction", map.fraction()).done())
        })
    }

    /// What is there so far: what the function of the job's name gives, its arrays no longer than that.
    #[wasm_bindgen(unchecked_return_type = "UnfinishedMap")]
    pub fn result(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|map| output::stability_map(map))
    }
}

impl Job {
    fn with(&self, call: impl FnOnce(&mut StabilityMap) -> Result<JsValue>) -> std::result::Result<JsValue, JsValue> {
        call_into(&self.0, "job", call)
    }
}
