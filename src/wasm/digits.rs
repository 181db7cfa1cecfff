//! The digits of numbers, as JavaScript writes them.

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(js_name = String)]
    pub(crate) fn plain(value: f64) -> String;
    #[wasm_bindgen(js_namespace = ["Number", "prototype", "toExponential"], js_name = call)]
    fn exponential(value: f64) -> String;
    #[wasm_bindgen(js_namespace = ["Number", "prototype", "toExponential"], js_name = call)]
    fn exponential_to(value: f64, digits: u32) -> String;
}

/// With an exponent: `1e300`.
pub(crate) fn with_exponent(value: f64) -> String {
    without_plus(exponential(value))
}

/// With an exponent and four digits: `1.234e-5`.
pub(crate) fn to_four(value: f64) -> String {
    without_plus(exponential_to(value, 3))
}

fn without_plus(mut digits: String) -> String {
    digits.retain(|digit| digit != '+');
    digits
}
