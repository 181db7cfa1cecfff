//! Models: physics only, one file each.
//!
//! A model is a [`System`] of first-order equations, piecewise smooth, together with its tables ([`Model`]). Models may
//! share a system: code that moves one is compiled once a system. To add a model: write its file, and add its line to
//! [`list`].

pub mod assembly;
pub mod laws;
pub mod system;
pub mod torsional;
pub mod torsional_linear;

pub use assembly::{Assembly, Parts};
pub(crate) use assembly::{damper_on, resting_command, roll};
pub use system::{Gear, Mode, Model, System, Tables};
pub use torsional::{Laned, Prepared, Torsional};
pub use torsional_linear::TorsionalLinear;

use serde::Serialize;

use self::laws::Laws;
use crate::{
    error::{Code, Error, Result},
    parameter::{Parameter, StateVariable},
    stability::{Linearisation, Polynomial, Surface, TorsionalTheory, at_rest},
};

/// What is known of a model without a run: its tables.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Description {
    /// Public name: `torsional`.
    pub name: &'static str,
    /// One line for people.
    pub title: &'static str,
    /// Parameters in the order in which they are stored.
    pub parameters: &'static [Parameter],
    /// Those of the dry friction that it takes, by the dotted names that reach them; none where it takes none.
    pub friction: &'static [Parameter],
    /// State variables in the order in which they are stored.
    pub state: &'static [StateVariable],
    /// All values that a run holds: see [`Model::TABLE`].
    #[serde(skip)]
    pub table: &'static [Parameter],
    /// What is on the gear: its values and states come after the gear's own.
    #[serde(skip)]
    pub parts: Parts,
    /// See [`Model::laws`].
    #[serde(skip)]
    laws: fn(&[f64]) -> Option<Laws>,
    /// See [`Model::prepared`].
    #[serde(skip)]
    pub(crate) prepared: fn(&[f64]) -> Option<Prepared>,
    /// See [`Model::linear_theory`].
    #[serde(skip)]
    pub(crate) linear_theory: fn(&[Polynomial]) -> Option<TorsionalTheory>,
    /// The same where nothing varies.
    #[serde(skip)]
    pub(crate) number_theory: fn(&[f64]) -> Option<TorsionalTheory<f64>>,
    /// The same where two parameters vary.
    #[serde(skip)]
    pub(crate) plane_theory: fn(&[Surface]) -> Option<TorsionalTheory<Surface>>,
    /// The model at its equilibrium, for checked parameter values in table order.
    #[serde(skip)]
    linearised: fn(&Self, &[f64]) -> Result<Linearisation>,
}

impl Description {
    /// The tables of the model `M`.
    pub const fn of<const N: usize, M: Model<N>>() -> Self {
        Self {
            name: M::NAME,
            title: M::TITLE,
            parameters: M::PARAMETERS,
            friction: M::TABLE.split_at(M::PARAMETERS.len()).1,
            table: M::TABLE,
            state: M::STATE,
            parts: Parts::NONE,
            laws: M::laws,
            prepared: M::prepared,
            linear_theory: M::linear_theory,
            number_theory: M::linear_theory,
            plane_theory: M::linear_theory,
            linearised: |_, values| at_rest(&M::at_rest(values)),
        }
    }

    /// How many values are the gear's own, those of its friction among them.
    pub(crate) fn gear_width(&self) -> usize {
        self.parameters.len() + self.friction.len()
    }

    /// Its force laws one by one, for checked parameter values in table order; none where it has no such laws.
    pub(crate) fn laws(&self, values: &[f64]) -> Option<Laws> {
        let laws = (self.laws)(&values[..self.gear_width().min(values.len())])?;
        let fitted = assembly::damper_on(self, values, 1.0 / laws.moment_of_inertia).unwrap_or_default();
        Some(Laws { fitted, ..laws })
    }

    /// The model at its equilibrium, for checked parameter values in table order.
    ///
    /// # Errors
    /// As [`Linearisation`]'s.
    pub(crate) fn linearised(&self, values: &[f64]) -> Result<Linearisation> {
        (self.linearised)(self, values)
    }

    /// That the values, each of which is valid, are so together.
    ///
    /// # Errors
    /// Those of a part that says which.
    pub(crate) fn check(&self, values: &[f64]) -> Result<()> {
        assembly::damper_on(self, values, 1.0)?;
        assembly::check_control(self, values)?;
        assembly::roll(self, values).map(drop)
    }

    /// That its equations do not change with the time.
    ///
    /// # Errors
    /// A gear that slows down, or is on an uneven runway: `what` is not known of it.
    pub(crate) fn check_steady(&self, what: &str) -> Result<()> {
        if !self.parts.changes() {
            return Ok(());
        }
        let (field, got) =
            if self.parts.rolls { ("deceleration", "a landing roll") } else { ("disturbance", "an uneven runway") };
        Err(Error::new(
            Code::Unsuited,
            field,
            got,
            format!("absent: {what} is that of a constant speed on an even runway"),
        ))
    }

    /// Default values of all parameters, in table order, those of elements after them.
    pub fn defaults(&self) -> Vec<f64> {
        self.table.iter().map(|p| p.default).collect()
    }
}

/// Every model, each a line. The public name picks the line; whoever runs a model goes on with its type.
#[macro_export]
#[doc(hidden)]
macro_rules! for_each_model {
    ($do:ident) => {
        $do! {
            3, $crate::model::Torsional;
            3, $crate::model::TorsionalLinear;
        }
    };
}

/// The tables of all models.
pub fn list() -> Vec<Description> {
    macro_rules! describe {
        ($($n:literal, $model:ty;)*) => { vec![$(Description::of::<$n, $model>()),*] };
    }
    for_each_model!(describe)
}

/// The tables of the model `name` with something on it.
pub(crate) fn assembled(name: &str, parts: Parts) -> Option<Description> {
    if parts.none() { named(name) } else { assembly::tables(name, parts).map(|tables| tables.description) }
}

/// The tables of the model `name`.
pub fn named(name: &str) -> Option<Description> {
    macro_rules! find {
        ($($n:literal, $model:ty;)*) => {
            $(if name == <$model>::NAME {
                return Some(Description::of::<$n, $model>());
            })*
        };
    }
    for_each_model!(find);
    None
}
