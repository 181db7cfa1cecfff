//! Dampers by themselves.

use std::cell::RefCell;

use wasm_bindgen::prelude::*;

use super::{call_into, input, output, record::Record};
use crate::{
    element::damper::{self, DamperResponse, DamperSpec, ResponseSpec},
    error::Result as Answer,
};

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

/// A damper whose piston is led by hand.
#[wasm_bindgen]
pub struct Piston(RefCell<damper::Piston>);

#[wasm_bindgen]
impl Piston {
    /// At x = 0, z = 0, w = 0 and the settled command.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Damper")] damper: JsValue) -> Result<Piston, JsValue> {
        let spec = input::value(&damper, "damper").and_then(|value| DamperSpec::read(Some(&value)));
        spec.map(|spec| Self(RefCell::new(damper::Piston::new(spec)))).map_err(output::error)
    }

    /// Leads it to `displacement` in m within `interval` in s, at a steady velocity.
    #[wasm_bindgen(unchecked_return_type = "Grip")]
    pub fn lead(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] displacement: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] interval: JsValue,
    ) -> Result<JsValue, JsValue> {
        self.with(|piston| {
            let grip = piston.lead(
                input::number(&displacement, "displacement", "a finite number")?,
                input::number(&interval, "interval", "> 0 s")?,
            )?;
            Ok(Record::new()
                .number("displacement", grip.displacement)
                .number("velocity", grip.velocity)
                .number("force", grip.force)
                .number("hysteresis", grip.hysteresis)
                .number("internalDisplacement", grip.internal_displacement)
                .done())
        })
    }

    /// Another command, at once.
    #[wasm_bindgen(js_name = setCommand)]
    pub fn set_command(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] command: JsValue,
    ) -> Result<(), JsValue> {
        self.with(|piston| piston.set_command(input::number(&command, "command", "a finite number")?))
    }

    fn with<T>(&self, work: impl FnOnce(&mut damper::Piston) -> Answer<T>) -> Result<T, JsValue> {
        call_into(&self.0, "piston", work)
    }
}
