//! Where the search for a cycle starts.

use crate::{
    error::{Error, Result},
    parameter::{Validity, check_number},
    run::{Fields, Run, Value},
};

/// The first start: so small a part of the first state's typical size.
const SMALL: f64 = 0.01;
/// Then the first state at these parts of it, the others as at rest.
const LADDER: [f64; 4] = [0.2, 1.0, 3.0, 10.0];

/// A cycle nearby: of a gear with slightly other parameters, say.
#[derive(Clone, Debug, PartialEq)]
pub struct Guess {
    /// \[s\].
    pub period: f64,
    /// A state on it, in the order of the state table.
    pub state: Vec<f64>,
}

impl Guess {
    /// Reads a record `{period, state: {[state]}}`; a state that is not named is 0. Nothing, where there is none.
    ///
    /// # Errors
    /// Anything but a record of these keys with a period > 0 and states of the run's model; the error names the field.
    pub fn read(run: &Run, input: &Value) -> Result<Option<Self>> {
        if *input == Value::Absent {
            return Ok(None);
        }
        let fields = Fields::of("guess", input, &["period", "state"])?;
        let period = fields.number("period", "> 0 s")?.ok_or_else(|| Error::missing("period", "a number > 0 s"))?;
        let given = fields.value("state").ok_or_else(|| Error::missing("state", "a record of states"))?;
        Self { period, state: Fields::state("state", given, run.description().state)? }.checked(run).map(Some)
    }

    /// Itself, where it makes sense for a run.
    ///
    /// # Errors
    /// A period that is not > 0, not as many finite numbers as the model has states.
    pub fn checked(self, run: &Run) -> Result<Self> {
        check_number("period", self.period, Validity::Positive, "s")?;
        run.check_width(self.state.len())?;
        for (variable, value) in run.description().state.iter().zip(&self.state) {
            check_number(variable.name, *value, Validity::Finite, variable.unit)?;
        }
        Ok(self)
    }
}

/// The starts of a run: its own, or where it starts at rest a small one in the direction that grows fastest, if any does,
/// and then larger ones.
pub(super) fn starts(run: &Run) -> Result<Vec<Vec<f64>>> {
    if run.initial().iter().any(|x| *x != 0.0) {
        return Ok(vec![run.initial().to_vec()]);
    }
    let rest = run.linearised()?.equilibrium;
    let scale = run.description().state[0].scale;
    let from_rest = |push: &dyn Fn(usize) -> f64| rest.iter().enumerate().map(|(i, x)| x + push(i)).collect();
    let mut starts: Vec<Vec<f64>> = Vec::with_capacity(1 + LADDER.len());
    let modes = run.eigenmodes()?;
    if let Some(mode) = modes.first().filter(|mode| mode.eigenvalue.re > 0.0) {
        let size = SMALL * run.description().state[mode.reference].scale;
        starts.push(from_rest(&|i| size * mode.shape[i].re));
    }
    starts.extend(LADDER.map(|part| from_rest(&|i| if i == 0 { part * scale } else { 0.0 })));
    Ok(starts)
}
