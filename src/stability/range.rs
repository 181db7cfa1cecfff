//! Which parameter varies, and from where to where: read and checked.

use crate::{
    error::{Code, Error, Result},
    parameter::{Parameter, parameter_index},
    run::Fields,
};

/// Reads the fields `parameter`, `from` and `to`.
///
/// # Errors
/// One that is missing, or not a name or a finite number.
pub(crate) fn read<'a>(fields: &Fields<'a>) -> Result<(&'a str, [f64; 2])> {
    let parameter = fields.text("parameter")?.ok_or_else(|| Error::missing("parameter", "the name of a parameter"))?;
    let end = |key| fields.number(key, "a finite number")?.ok_or_else(|| Error::missing(key, "a number"));
    Ok((parameter, [end("from")?, end("to")?]))
}

/// The place of `parameter` in its table, where both ends are valid for it.
///
/// # Errors
/// An unknown parameter, an end that is not valid.
pub(crate) fn check(table: &[Parameter], parameter: &str, ends: [f64; 2]) -> Result<usize> {
    let index =
        parameter_index(table, parameter).map_err(|error| error.of_kind(Code::UnknownName).called("parameter"))?;
    for (field, value) in ["from", "to"].into_iter().zip(ends) {
        table[index].check(value).map_err(|error| error.called(field))?;
    }
    Ok(index)
}
