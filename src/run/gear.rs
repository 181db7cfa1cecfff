//! What is asked of a run's gear without moving it.

use super::Run;
use crate::{
    error::{Code, Error, Result},
    model::{
        laws::{Curves, ForceColumns, ForceLaws, Forces, Laws},
        torsional::{self, LinkedParameters},
    },
    parameter::{Validity, check_number, parameter_index},
};

impl Run {
    /// Forces at a state, in the order of the state table.
    ///
    /// # Errors
    /// Not as many finite numbers as the model has states; a model without force laws.
    pub fn forces(&self, state: &[f64]) -> Result<Forces> {
        self.check_width(state.len())?;
        for (variable, value) in self.description().state.iter().zip(state) {
            check_number(variable.name, *value, Validity::Finite, variable.unit)?;
        }
        self.laws()?.forces(state)
    }

    /// Forces along a motion: one column a state, in the order of the state table.
    ///
    /// # Errors
    /// Not as many columns of finite numbers, all of one length, as the model has states; a model without force laws.
    pub fn forces_along(&self, states: &[Vec<f64>]) -> Result<ForceColumns> {
        self.check_width(states.len())?;
        let rows = states.first().map_or(0, Vec::len);
        for (variable, column) in self.description().state.iter().zip(states) {
            if column.len() != rows {
                let (got, allowed) = (format!("{} numbers", column.len()), format!("{rows} numbers, as the others"));
                return Err(Error::new(Code::OutOfRange, variable.name, got, allowed));
            }
            for value in column {
                check_number(variable.name, *value, Validity::Finite, variable.unit)?;
            }
        }
        self.laws()?.along(states)
    }

    pub(crate) fn check_width(&self, width: usize) -> Result<()> {
        let names: Vec<_> = self.description().state.iter().map(|variable| variable.name).collect();
        if width == names.len() {
            return Ok(());
        }
        let allowed = format!("{} numbers: {}", names.len(), names.join(", "));
        Err(Error::new(Code::WrongType, "state", format!("a list of {width} numbers"), allowed))
    }

    /// Values that the links between the parameters of the torsional gears would give.
    ///
    /// # Errors
    /// A model without these parameters.
    pub fn linked_parameters(&self) -> Result<LinkedParameters> {
        let value = |name: &str| {
            let index = parameter_index(self.table(), name);
            index.map(|index| self.parameters[index]).map_err(|_| Error::without(self.model, name))
        };
        let (a, c_f_alpha, f_z) = (value("halfContactLength")?, value("sideForceDerivative")?, value("verticalForce")?);
        let (relaxation_length, tread_width_moment_constant) = torsional::linked(a, c_f_alpha, f_z);
        Ok(LinkedParameters { relaxation_length, tread_width_moment_constant })
    }

    /// The force laws as curves to draw.
    ///
    /// # Errors
    /// A model without force laws.
    pub fn force_laws(&self, curves: &Curves) -> Result<ForceLaws> {
        Ok(curves.of(&self.laws()?))
    }

    /// The model's force laws.
    pub(crate) fn laws(&self) -> Result<Laws> {
        self.description().check_steady("an account of forces")?;
        self.description().laws(&self.parameters).ok_or_else(|| Error::without(self.model, "force laws"))
    }
}
