//! From JavaScript values to [`Value`]s, whatever they are.

use js_sys::{Array, Float64Array, Reflect};
use wasm_bindgen::{JsCast, prelude::*};

use crate::{
    error::{Code, Error, Result, shown},
    run::{MOST_SAMPLES, Value},
};

/// How deep records may lie in records, and how many keys one may have: more than any input needs.
const DEEPEST: usize = 5;
const MOST_KEYS: usize = 200;

#[wasm_bindgen]
extern "C" {
    // The bindings of js-sys let an exception of a revoked proxy through, which would skip our destructors.
    #[wasm_bindgen(js_namespace = Array, js_name = isArray, catch)]
    fn is_array(value: &JsValue) -> std::result::Result<bool, JsValue>;
    #[wasm_bindgen(js_namespace = ArrayBuffer, js_name = isView)]
    fn is_view(value: &JsValue) -> bool;
}

/// Reads any value; `field` names it in errors.
///
/// # Errors
/// Getters and proxies that throw, records too deep or too large.
pub(super) fn value(js: &JsValue, field: &str) -> Result<Value> {
    read(js, field, 0)
}

/// Reads a number.
///
/// # Errors
/// Anything but a primitive number.
pub(super) fn number(js: &JsValue, field: &str, allowed: &str) -> Result<f64> {
    match value(js, field)? {
        Value::Number(number) => Ok(number),
        other => Err(Error::new(Code::WrongType, field, other.shown(), allowed)),
    }
}

/// Reads a text.
///
/// # Errors
/// Anything but a primitive string.
pub(super) fn text(js: &JsValue, field: &str) -> Result<String> {
    match value(js, field)? {
        Value::Text(text) => Ok(text),
        other => Err(Error::new(Code::WrongType, field, other.shown(), "a name in quotes")),
    }
}

fn read(js: &JsValue, field: &str, depth: usize) -> Result<Value> {
    if js.is_null() || js.is_undefined() {
        return Ok(Value::Absent);
    }
    if let Some(value) = js.as_bool() {
        return Ok(Value::Bool(value));
    }
    if let Some(value) = js.as_f64() {
        return Ok(Value::Number(value));
    }
    if let Some(text) = js.as_string() {
        return Ok(Value::Text(text));
    }
    if js.is_bigint() {
        return Ok(Value::Other("a BigInt"));
    }
    if js.is_symbol() {
        return Ok(Value::Other("a symbol"));
    }
    if js.is_function() {
        return Ok(Value::Other("a function"));
    }
    if is_view(js) {
        return match js.dyn_ref::<Float64Array>() {
            Some(array) => series(array, field),
            None => Ok(Value::Other("another kind of array than Float64Array")),
        };
    }
    if is_array(js).map_err(|_| unreadable(field))? {
        return list(js, field, depth);
    }
    if js.is_instance_of::<js_sys::Map>() {
        return Ok(Value::Other("a Map (give a plain object)"));
    }
    if depth == DEEPEST {
        return Ok(Value::Other("a record within a record within a record"));
    }
    record(js, field, depth)
}

fn unreadable(field: &str) -> Error {
    Error::new(Code::WrongType, field, "something that throws when it is read", "a plain value")
}

fn too_long(field: &str, length: f64) -> Error {
    Error::new(Code::TooLarge, field, format!("a list of {} values", shown(length)), "a list of at most 1e7 numbers")
}

fn series(array: &Float64Array, field: &str) -> Result<Value> {
    let length = array.length() as usize;
    if length > MOST_SAMPLES {
        return Err(too_long(field, length as f64));
    }
    // A detached array has no length, and throws when it is copied.
    Ok(Value::Numbers(if length == 0 { Vec::new() } else { array.to_vec() }))
}

fn list(js: &JsValue, field: &str, depth: usize) -> Result<Value> {
    let length = Reflect::get(js, &"length".into()).ok().and_then(|length| length.as_f64());
    let length = length.ok_or_else(|| unreadable(field))?;
    if !(0.0..=MOST_SAMPLES as f64).contains(&length) {
        return Err(too_long(field, length));
    }
    let (mut numbers, mut texts, mut records) = (Vec::new(), Vec::new(), Vec::new());
    for index in 0..length as u32 {
        let entry = Reflect::get_u32(js, index).map_err(|_| unreadable(field))?;
        match (entry.as_f64(), entry.as_string()) {
            (Some(number), _) if texts.is_empty() && records.is_empty() => numbers.push(number),
            // Names are few: a list of more is no list of names.
            (_, Some(text)) if numbers.is_empty() && records.is_empty() && texts.len() < MOST_KEYS => texts.push(text),
            (None, None) if numbers.is_empty() && texts.is_empty() && records.len() < MOST_KEYS && depth < DEEPEST => {
                // A list in a list is none that a field takes, and may hold itself.
                if is_array(&entry).map_err(|_| unreadable(field))? {
                    return Ok(Value::List(length as usize));
                }
                match read(&entry, &format!("{field}[{index}]"), depth + 1)? {
                    record @ Value::Record(_) => records.push(record),
                    _ => return Ok(Value::List(length as usize)),
                }
            }
            _ => return Ok(Value::List(length as usize)),
        }
    }
    Ok(if !records.is_empty() {
        Value::Records(records)
    } else if texts.is_empty() {
        Value::Numbers(numbers)
    } else {
        Value::Texts(texts)
    })
}

fn record(js: &JsValue, field: &str, depth: usize) -> Result<Value> {
    let keys: Array = Reflect::own_keys(js).map_err(|_| unreadable(field))?;
    if keys.length() as usize > MOST_KEYS {
        let count = format!("a record of {} keys", keys.length());
        return Err(Error::new(Code::TooLarge, field, count, format!("a record of at most {MOST_KEYS} keys")));
    }
    let mut entries = Vec::with_capacity(keys.length() as usize);
    for key in keys.iter() {
        let name = match key.as_string() {
            Some(name) if name.is_empty() => format!("the empty key of {field}"),
            Some(name) => name,
            None => format!("a symbol of {field}"),
        };
        let inner = Reflect::get(js, &key).map_err(|_| unreadable(&name))?;
        let value = read(&inner, &name, depth + 1)?;
        entries.push((name, value));
    }
    Ok(Value::Record(entries))
}

/// Reads bytes.
///
/// # Errors
/// Anything but a `Uint8Array` of at most a mebibyte.
pub(super) fn bytes(js: &JsValue, field: &str) -> Result<Vec<u8>> {
    let allowed = "a Uint8Array of at most 1 MiB";
    match js.dyn_ref::<js_sys::Uint8Array>().filter(|_| is_view(js)) {
        Some(array) if array.length() == 0 => Ok(Vec::new()), // detached ones too, which throw when they are copied
        Some(array) if array.length() <= 1 << 20 => Ok(array.to_vec()),
        Some(array) => Err(Error::new(Code::TooLarge, field, format!("{} bytes", array.length()), allowed)),
        None => Err(Error::new(Code::WrongType, field, value(js, field)?.shown(), allowed)),
    }
}
