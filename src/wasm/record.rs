//! Plain JavaScript objects, field by field.

use js_sys::{Array, Float64Array, Uint8Array};
use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// A plain object.
    #[wasm_bindgen(js_name = Object)]
    type Plain;
    #[wasm_bindgen(constructor, js_class = Object)]
    fn new() -> Plain;
    // Assignments to an object that this module has made cannot fail.
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn assign(this: &Plain, key: &str, value: &JsValue);
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn assign_number(this: &Plain, key: &str, value: f64);
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn assign_text(this: &Plain, key: &str, value: &str);
    #[wasm_bindgen(method, structural, indexing_setter)]
    fn assign_truth(this: &Plain, key: &str, value: bool);
}

/// An object in the making. Its methods are small and never inlined: there are a hundred calls of them.
pub(super) struct Record(Plain);

impl Record {
    #[inline(never)]
    pub fn new() -> Self {
        Self(Plain::new())
    }

    /// Puts the fields into an object that is there.
    pub fn onto(object: JsValue) -> Self {
        Self(object.unchecked_into())
    }

    #[inline(never)]
    pub fn value(self, key: &str, value: JsValue) -> Self {
        self.0.assign(key, &value);
        self
    }

    #[inline(never)]
    pub fn number(self, key: &str, value: f64) -> Self {
        self.0.assign_number(key, value);
        self
    }

    /// `null` where there is no number.
    #[inline(never)]
    pub fn maybe(self, key: &str, value: Option<f64>) -> Self {
        match value {
            Some(value) => self.number(key, value),
            None => self.value(key, JsValue::NULL),
        }
    }

    #[inline(never)]
    pub fn text(self, key: &str, value: &str) -> Self {
        self.0.assign_text(key, value);
        self
    }

    #[inline(never)]
    pub fn truth(self, key: &str, value: bool) -> Self {
        self.0.assign_truth(key, value);
        self
    }

    /// Numbers as a `Float64Array`.
    #[inline(never)]
    pub fn series(self, key: &str, values: &[f64]) -> Self {
        self.value(key, series(values))
    }

    /// Bytes as a `Uint8Array`.
    #[inline(never)]
    pub fn bytes(self, key: &str, bytes: &[u8]) -> Self {
        self.value(key, Uint8Array::from(bytes).into())
    }

    /// Numbers as an `Array`.
    #[inline(never)]
    pub fn numbers(self, key: &str, values: &[f64]) -> Self {
        self.value(key, numbers(values))
    }

    /// Names as an `Array`.
    #[inline(never)]
    pub fn names(self, key: &str, names: &[&str]) -> Self {
        let list = Array::new();
        for name in names {
            list.push(&JsValue::from_str(name));
        }
        self.value(key, list.into())
    }

    pub fn record(self, key: &str, record: Record) -> Self {
        self.value(key, record.done())
    }

    /// The object.
    #[inline(never)]
    pub fn done(self) -> JsValue {
        self.0.into()
    }
}

#[inline(never)]
pub(super) fn series(values: &[f64]) -> JsValue {
    Float64Array::from(values).into()
}

#[inline(never)]
pub(super) fn numbers(values: &[f64]) -> JsValue {
    let list = Array::new();
    for value in values {
        list.push(&JsValue::from_f64(*value));
    }
    list.into()
}

/// An `Array`, entry by entry.
pub(super) fn list<T>(entries: impl IntoIterator<Item = T>, entry: impl Fn(T) -> JsValue) -> JsValue {
    let list = Array::new();
    for value in entries {
        list.push(&entry(value));
    }
    list.into()
}
