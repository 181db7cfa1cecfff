//! Linear theory of a run's gear. Its start does not matter.

use nalgebra::Complex;

use super::Run;
use crate::{
    error::Result,
    parameter::parameter_index,
    stability::{
        Bounded, Crossing, CurveKind, Eigenmode, Linearisation, Polynomial, RouthArray, RouthHurwitz, TorsionalTheory,
        UnstableInterval, Variation, characteristic_bounded, crossings, linearised,
    },
};

/// Speeds among which critical ones are searched for, in m/s.
const VELOCITIES: (f64, f64) = (0.1, 2000.0);
/// Damping constants among which the critical one is searched for, in N m s/rad.
const DAMPINGS: (f64, f64) = (1e-3, 1e6);

impl Run {
    /// The gear at its equilibrium: where it rests, and its Jacobian there.
    ///
    /// # Errors
    /// Parameters so extreme that the Jacobian leaves the numbers; no equilibrium that Newton's method finds from the
    /// state 0.
    pub fn linearised(&self) -> Result<Linearisation> {
        linearised(&self.description(), &self.parameters)
    }

    /// The eigenvalues of the Jacobian \[1/s\], by falling real part, of a pair the positive imaginary part first.
    ///
    /// # Errors
    /// As [`Run::linearised`]; parameters so extreme that they leave the numbers.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>> {
        self.linearised()?.eigenvalues()
    }

    /// What the gear does at each eigenvalue, in the same order.
    ///
    /// # Errors
    /// As [`Run::eigenvalues`].
    pub fn eigenmodes(&self) -> Result<Vec<Eigenmode>> {
        let description = self.description();
        let laws = description.laws(&self.parameters);
        Eigenmode::all(&self.linearised()?.jacobian, description.state, laws)
    }

    /// The coefficients of the Jacobian's characteristic polynomial, highest power (1) first.
    ///
    /// # Errors
    /// As [`Run::linearised`]; parameters so extreme that a coefficient leaves the numbers.
    pub fn characteristic_polynomial(&self) -> Result<Vec<f64>> {
        Ok(self.characteristic()?.into_iter().map(|coefficient| coefficient.value).collect())
    }

    /// The same with what rounding may have done: in closed form, where the model has one, from the parameters on.
    fn characteristic(&self) -> Result<Vec<Bounded>> {
        match self.theory_of_numbers() {
            Some(theory) => Ok(theory.characteristic()?.to_vec()),
            None => self.characteristic_by_numbers(),
        }
    }

    /// The same by numbers. What is zero whatever the values is so exactly.
    fn characteristic_by_numbers(&self) -> Result<Vec<Bounded>> {
        let linear = self.linearised()?;
        let mut coefficients = characteristic_bounded(&linear.jacobian)?;
        let deciding = coefficients.len() - linear.neutral;
        coefficients[deciding..].fill(Bounded::exact(0.0));
        Ok(coefficients)
    }

    /// The characteristic polynomial of what decides on stability: without the roots that are zero whatever the values.
    fn deciding(&self, mut coefficients: Vec<Bounded>) -> Result<Vec<Bounded>> {
        coefficients.truncate(coefficients.len() - self.linearised()?.neutral);
        Ok(coefficients)
    }

    /// Routh's array of the characteristic polynomial, without its roots that are zero whatever the values, as a hysteresis has
    /// one.
    ///
    /// # Errors
    /// As [`Run::characteristic_polynomial`]; parameters so extreme that an entry leaves the numbers.
    pub fn routh_array(&self) -> Result<RouthArray> {
        RouthArray::of_bounded(&self.deciding(self.characteristic()?)?)
    }

    /// The model's linear theory with the run's parameters.
    fn theory_of_numbers(&self) -> Option<TorsionalTheory> {
        let numbers: Vec<_> = self.parameters.iter().map(|value| Polynomial::from(*value)).collect();
        (self.description().linear_theory)(&numbers)
    }

    /// What linear theory says of the gear at rest, and where that changes: in closed form where the model has one, by
    /// numbers where not.
    ///
    /// # Errors
    /// Parameters so extreme that coefficients leave the numbers; no equilibrium.
    pub fn routh_hurwitz(&self) -> Result<RouthHurwitz> {
        self.theory_of_numbers().map_or_else(|| self.routh_hurwitz_by_numbers(), |theory| theory.routh_hurwitz())
    }

    /// As [`Run::routh_hurwitz`], for any model: the array's verdict, and critical values by a search among velocities from
    /// 0.1 to 2000 m/s and damping constants from 10⁻³ to 10⁶ N m s/rad.
    ///
    /// # Errors
    /// As [`Run::routh_array`], for the speeds and dampings searched, too.
    pub fn routh_hurwitz_by_numbers(&self) -> Result<RouthHurwitz> {
        let array = RouthArray::of_bounded(&self.deciding(self.characteristic_by_numbers()?)?)?;
        let search = |names: &[&str], (from, to)| {
            let known = names.iter().find(|name| parameter_index(self.table(), name).is_ok());
            known.map_or(Ok(Vec::new()), |name| self.crossings(&Variation::of(name, from, to)))
        };
        let dampings = search(&["dampingConstant", "torsionalDamping"], DAMPINGS)?;
        Ok(RouthHurwitz {
            stable: array.stable,
            column: array.column(),
            critical_velocities: search(&["velocity"], VELOCITIES)?.iter().map(|crossing| crossing.value).collect(),
            critical_damping: dampings.iter().rfind(|crossing| crossing.kind == CurveKind::Hopf).map(|last| last.value),
        })
    }

    /// Every value in a parameter's range at which eigenvalues cross the imaginary axis, ascending; for any model, by
    /// numbers. The other parameters stay as they are in the run, or follow as the variation says.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or do not ascend; as [`Run::eigenvalues`] anywhere in the range.
    pub fn crossings(&self, variation: &Variation) -> Result<Vec<Crossing>> {
        let varied = variation.applied(self.table(), &self.parameters)?;
        let description = self.description();
        let spectrum = |value: f64| {
            let values: Vec<f64> = varied.iter().map(|parameter| parameter.at(value)).collect();
            linearised(&description, &values)?.deciding()
        };
        crossings(&spectrum, variation.from, variation.to)
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

    /// The model's linear theory, for parameters in table order.
    fn linear_theory(&self, parameters: &[Polynomial]) -> Result<TorsionalTheory> {
        let theory = (self.description().linear_theory)(parameters);
        theory.ok_or_else(|| crate::Error::without(self.model, "a closed linear theory"))
    }
}
