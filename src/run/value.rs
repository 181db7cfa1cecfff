//! Untyped input: what a caller from outside hands over, before anything is believed of it.

/// A value of unknown make.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// `null`, `undefined`: the same as not being there.
    Absent,
    /// A truth value.
    Bool(bool),
    /// A number, possibly not finite.
    Number(f64),
    /// A text.
    Text(String),
    /// A list of numbers only.
    Numbers(Vec<f64>),
    /// A list of texts only, and of some.
    Texts(Vec<String>),
    /// A list of records only, and of some.
    Records(Vec<Value>),
    /// A list of this many values of other or several kinds: no field takes one, so that is all there is to know.
    List(usize),
    /// Named values, in the order given.
    Record(Vec<(String, Value)>),
    /// Something that no field takes: a function, a date …
    Other(&'static str),
}

impl Value {
    /// The value as an error message shows it: short, and with its kind where the value itself would not help.
    pub fn shown(&self) -> String {
        match self {
            Value::Absent => "nothing".into(),
            Value::Bool(value) => value.to_string(),
            Value::Number(value) => crate::error::shown(*value),
            Value::Text(text) => format!("\"{}\"", text.chars().take(60).collect::<String>()),
            Value::Numbers(numbers) => format!("a list of {} numbers", numbers.len()),
            Value::Texts(texts) => format!("a list of {} texts", texts.len()),
            Value::Records(records) => format!("a list of {} values", records.len()),
            Value::List(length) => format!("a list of {length} values"),
            Value::Record(_) => "a record".into(),
            Value::Other(kind) => (*kind).into(),
        }
    }
}
