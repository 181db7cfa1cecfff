//! What is asked of a run's gear without moving it.

use super::Run;
use crate::{
    error::{Code, Error, Result},
    model::{
        laws::{Curves, ForceColumns, ForceLaws, Forces, Laws},
        torsional::{self, LinkedParameters},
    },
    parameter::{Validity, check_number, parameter_index},
    stability::{Linearisation, Polynomial, RouthHurwitz, TorsionalTheory, UnstableInterval, Variation, linearised},
};

impl Run {
    /// The gear at its equilibrium: where it rests, and its Jacobian there. Its start does not matter.
    ///
    /// # Errors
    /// Parameters so extreme that the Jacobian leaves the numbers; no equilibrium that Newton's method finds from the
    /// state 0.
    pub fn linearised(&self) -> Result<Linearisation> {
        linearised(&self.description(), &self.parameters)
    }

    /// What linear theory says of the gear at rest, and where that changes. Its start does not matter.
    ///
    /// # Errors
    /// A model without a closed linear theory; parameters so extreme that its coefficients leave the numbers.
    pub fn routh_hurwitz(&self) -> Result<RouthHurwitz> {
        let numbers: Vec<_> = self.parameters.iter().map(|value| Polynomial::from(*value)).collect();
        self.linear_theory(&numbers)?.routh_hurwitz()
    }

    /// The parts of a parameter's range in which linear theory does not find the gear stable, ascending; the other
    /// parameters stay as they are in the run. An end is exact where it is a boundary.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or do not ascend, a model without a closed linear theory.
    pub fn unstable_intervals(&self, variation: &Variation) -> Result<Vec<UnstableInterval>> {
        let varied = variation.applied(self.table(), &self.parameters)?;
        Ok(self.linear_theory(&varied)?.unstable_intervals(variation.from, variation.to))
    }

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

    fn check_width(&self, width: usize) -> Result<()> {
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
        (self.description().laws)(&self.parameters).ok_or_else(|| Error::without(self.model, "force laws"))
    }

    /// The model's linear theory, for parameters in table order.
    fn linear_theory(&self, parameters: &[Polynomial]) -> Result<TorsionalTheory> {
        let theory = (self.description().linear_theory)(parameters);
        theory.ok_or_else(|| Error::without(self.model, "a closed linear theory"))
    }
}
