//! A moment of a live motion, from which it can be taken up.

use std::sync::Arc;

use super::codec::Codec;
use crate::{
    integrate::{Failure, Integrator},
    model::{Gear, Tables},
};

/// Most parameters of a model: a cursor is copied often and must not allocate.
const MOST_PARAMETERS: usize = 64;

/// A change from outside.
#[derive(Clone, Copy, Debug)]
pub(super) enum Change {
    Parameter { index: usize, value: f64 },
    State { index: usize, value: f64 },
    Kick { impulse: f64 },
}

/// A motion with the parameter values that hold and the number of changes that have been made.
#[derive(Clone)]
pub(super) struct Cursor<S: 'static, const N: usize> {
    pub tables: &'static Tables<S>,
    pub integrator: Integrator<S, N>,
    parameters: [f64; MOST_PARAMETERS],
    /// Changes that have taken effect, counted from the very first.
    pub applied: usize,
}

impl<S: Gear<N>, const N: usize> Cursor<S, N> {
    pub fn new(tables: &'static Tables<S>, integrator: Integrator<S, N>, parameters: &[f64], applied: usize) -> Self {
        let mut values = [0.0; MOST_PARAMETERS];
        values[..parameters.len()].copy_from_slice(parameters);
        Self { tables, integrator, parameters: values, applied }
    }

    pub fn parameters(&self) -> &[f64] {
        &self.parameters[..self.tables.description.table.len()]
    }

    /// Makes a change at time `t` within the last step. Where it cannot be made, nothing changes. `known` is the system that
    /// a parameter's change leads to, where it has been made before: to make one takes as long as hundreds of steps.
    pub fn apply(&mut self, t: f64, change: Change, known: Option<&Arc<S>>) -> Result<(), Failure> {
        let mut x = self.integrator.interpolate(t);
        match change {
            Change::Parameter { index, value } => {
                let mut parameters = self.parameters;
                parameters[index] = value;
                let count = self.parameters().len();
                let system = known.cloned().unwrap_or_else(|| Arc::new(self.tables.system(&parameters[..count])));
                // What a new damper cannot hold it has let go.
                x = system.scaled(&x, 1.0);
                self.integrator.replace(system, t, x)?;
                self.parameters = parameters;
            }
            Change::State { index, value } => {
                x[index] = value;
                self.integrator.restart(t, x)?;
            }
            Change::Kick { impulse } => {
                let kicked = self.integrator.system().kicked(&x, impulse);
                self.integrator.restart(t, kicked)?;
            }
        }
        self.applied += 1;
        Ok(())
    }

    /// Writes or reads every number of the cursor. False where what was read makes no sense.
    pub fn code(&mut self, codec: &mut dyn Codec) -> bool {
        let table = self.tables.description.table;
        for value in &mut self.parameters[..table.len()] {
            codec.number(value);
        }
        if !table.iter().zip(&self.parameters).all(|(parameter, value)| parameter.check(*value).is_ok()) {
            return false;
        }
        if self.tables.description.check(self.parameters()).is_err() {
            return false;
        }
        let system = self.tables.system(self.parameters());
        self.integrator.code(codec, system)
    }
}
