//! What any answer to any input is: finite numbers, or a refusal in words.

use shimmy::Error;

pub fn assert_speaks(error: &Error) {
    let sentence = error.to_string();
    assert!(!error.field.is_empty(), "names no field: {sentence}");
    assert!(!error.code.name().is_empty());
    assert!(!error.allowed.is_empty(), "does not say what is allowed: {sentence}");
    assert!(sentence.len() < 2_000, "{} characters of message", sentence.len());
}

pub fn assert_finite(what: &str, values: &[f64]) {
    assert!(values.iter().all(|value| value.is_finite()), "{what} is not finite: {values:?}");
}
