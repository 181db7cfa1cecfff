//! Magnetorheological dampers: the force of a piston in a fluid that a current stiffens.
//!
//! All four models have one shape: a [Bouc–Wen element](Hysteresis), a dashpot and a spring side by side, which in two of
//! them sit in series with another dashpot. They differ in how their [coefficients](Coefficients) follow the command. To
//! add a model: write its file, and add its line to [`list`] and to [`Law`].
//!
//! # Equations
//! Piston displacement x \[m\] and force F \[N\], both positive in extension: a positive force opposes a positive velocity.
//!
//! Side by side (`bouc-wen`, `current-dependent-bouc-wen`): F = c₀ẋ + k₀(x − x₀) + αz + f₀, with ż driven by ẋ.
//!
//! In series (`modified-bouc-wen`, `modified-bouc-wen-cubic`): ẇ = (αz + c₀ẋ + k₀(x − w))/(c₀ + c₁),
//! F = c₁ẇ + k₁(x − x₀), with ż driven by ẋ − ẇ. w is the displacement between the two parts.
//!
//! # State
//! `hysteresis` z, of models in series `internalDisplacement` w, and of those whose coil takes its time
//! `effectiveCommand` u: in this order.
//!
//! # Passivity
//! W(z) = α∫₀ᶻ s ds/(A − (β − γ)|s|ⁿ) obeys Ẇ ≤ αzẋ where A > 0, γ ≥ 0, γ + β > 0, α ≥ 0 and |z| ≤ z_max, which z never
//! leaves. With c₀, c₁, k₀, k₁ ≥ 0 and a steady command the damper never gives back more than it was given. What is not so
//! is refused.

mod cubic;
mod current_dependent;
mod excitation;
mod follow;
mod hysteresis;
mod modified;
mod piston;
mod response;
mod simple;
mod spec;
mod tables;

pub use cubic::Cubic;
pub use current_dependent::{CurrentDependent, Rise};
pub use excitation::{Excitation, Shape};
pub use hysteresis::{Branch, Course, Hysteresis};
pub use modified::Modified;
pub use piston::{Grip, Piston};
pub use response::{DamperResponse, ResponseSpec};
pub use simple::Simple;
pub use spec::DamperSpec;

use serde::{Serialize, Serializer};

use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Parameter, StateVariable, check_number},
    real::Real,
};

/// What is known of a damper without its values: its tables.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Description {
    /// Public name: `bouc-wen`.
    pub name: &'static str,
    /// One line for people.
    pub title: &'static str,
    /// Parameters in the order in which they are stored.
    pub parameters: &'static [Parameter],
    /// State variables in the order in which they are stored.
    pub state: &'static [StateVariable],
    /// The command: a current, or a voltage.
    pub command: Parameter,
    /// Whether the command enters: a model of one fixed command does without.
    pub commanded: bool,
    /// Defaults that differ where the damper sits on a gear: what would preload it, or what is far too large for it.
    #[serde(serialize_with = "by_name")]
    pub on_gear: &'static [(&'static str, f64)],
    /// The damper with checked values in table order.
    #[serde(skip)]
    make: fn(&[f64]) -> Result<Damper>,
}

fn by_name<S: Serializer>(
    values: &&'static [(&'static str, f64)],
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    serializer.collect_map(values.iter().copied())
}

/// Every damper, each a line.
static DAMPERS: [Description; 4] = [simple::TABLES, modified::TABLES, cubic::TABLES, current_dependent::TABLES];

/// The tables of all dampers.
pub fn list() -> &'static [Description] {
    &DAMPERS
}

/// The tables of the damper `name`.
///
/// # Errors
/// An unknown name, with the nearest known one.
pub fn named(name: &str) -> Result<&'static Description> {
    DAMPERS.iter().find(|damper| damper.name == name).ok_or_else(|| {
        let known: Vec<_> = DAMPERS.iter().map(|damper| damper.name).collect();
        Error::unknown(Code::UnknownName, "model", name, &known)
    })
}

impl Description {
    /// Default values of all parameters, in table order: of a damper by itself.
    pub fn defaults(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.default).collect()
    }

    /// The same on a gear.
    pub fn defaults_on_gear(&self) -> Vec<f64> {
        let own = |parameter: &Parameter| self.on_gear.iter().find(|(name, _)| *name == parameter.name);
        self.parameters.iter().map(|parameter| own(parameter).map_or(parameter.default, |(_, value)| *value)).collect()
    }

    /// The damper with these values, in table order.
    ///
    /// # Errors
    /// Values that are not valid, each by itself or together: see [the passivity](self#passivity).
    pub fn damper(&self, values: &[f64]) -> Result<Damper> {
        for (parameter, value) in self.parameters.iter().zip(values) {
            parameter.check(*value)?;
        }
        (self.make)(values)
    }

    /// A command that the model takes, or an error that says which.
    ///
    /// # Errors
    /// NaN, infinities, and commands outside of the model's range.
    pub fn check_command(&self, command: f64) -> Result<f64> {
        self.command.check(command)?;
        if self.name == cubic::TABLES.name && !cubic::COMMANDS.contains(&command) {
            let allowed = format!(
                "from {} to {} A: beyond, a damping is negative",
                shown(*cubic::COMMANDS.start()),
                shown(*cubic::COMMANDS.end())
            );
            return Err(Error::new(Code::OutOfRange, "command", shown(command), allowed));
        }
        Ok(command)
    }
}

/// How a damper's coefficients follow its command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// Not at all.
    Simple(Simple),
    /// In a straight line.
    Modified(Modified),
    /// By polynomials.
    Cubic(Cubic),
    /// In a straight line, and then towards a limit.
    CurrentDependent(CurrentDependent),
}

/// The coefficients of a damper at a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<R = f64> {
    /// c₀ \[N s/m\].
    pub viscous: R,
    /// k₀ \[N/m\].
    pub stiffness: R,
    /// α \[N/m\], in N where z has no unit.
    pub hysteresis_gain: R,
    /// c₁ \[N s/m\] of a damper in series; 0 where its parts sit side by side.
    pub series: R,
    /// k₁ \[N/m\], beside all of a damper in series.
    pub accumulator: R,
    /// The force \[N\] at x = 0 with nothing else at work: f₀ − k₀x₀ side by side, −k₁x₀ in series.
    pub preload: R,
}

/// What a damper does in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response<R = f64> {
    /// F \[N\], positive against a positive velocity.
    pub force: R,
    /// The velocity \[m/s\] of the hysteresis element's ends: ẋ, in series ẋ − ẇ. [`Hysteresis::rate`] takes it.
    pub slip: R,
    /// ẇ \[m/s\], 0 where there is no w.
    pub internal: R,
}

/// A damper, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper {
    hysteresis: Hysteresis,
    law: Law,
    /// Whether c₁ sits in series.
    in_series: bool,
    /// η \[1/s\], where the coil takes its time.
    command_rate: Option<f64>,
    force_scale: f64,
}

impl Damper {
    /// Its Bouc–Wen element.
    #[inline(always)]
    pub fn hysteresis(&self) -> &Hysteresis {
        &self.hysteresis
    }

    /// It has the state w.
    #[inline(always)]
    pub fn in_series(&self) -> bool {
        self.in_series
    }

    /// η of u̇ = −η(u − command) \[1/s\]; none where the command acts at once and u is no state.
    #[inline(always)]
    pub fn command_rate(&self) -> Option<f64> {
        self.command_rate
    }

    /// Number of its states.
    pub fn states(&self) -> usize {
        1 + usize::from(self.in_series) + usize::from(self.command_rate.is_some())
    }

    /// Its coefficients at the (effective) command u.
    #[inline]
    pub fn coefficients<R: Real>(&self, u: R) -> Coefficients<R> {
        match &self.law {
            Law::Simple(law) => law.coefficients(),
            Law::Modified(law) => law.coefficients(u),
            Law::Cubic(law) => law.coefficients(u),
            Law::CurrentDependent(law) => law.coefficients(u),
        }
    }

    /// What it does at the displacement x \[m\] and velocity ẋ \[m/s\] in the state z, w (which counts in series alone).
    #[inline(always)]
    pub fn response<R: Real>(&self, at: &Coefficients<R>, x: R, velocity: R, z: R, w: R) -> Response<R> {
        if self.in_series {
            let inner = at.hysteresis_gain * z + at.viscous * velocity + at.stiffness * (x - w);
            let internal = inner / (at.viscous + at.series);
            let force = at.series * internal + at.accumulator * x + at.preload;
            Response { force: force * self.force_scale, slip: velocity - internal, internal }
        } else {
            let force = at.viscous * velocity + at.stiffness * x + at.hysteresis_gain * z + at.preload;
            Response { force: force * self.force_scale, slip: velocity, internal: R::from(0.0) }
        }
    }

    /// Rates of z, w and u; those that it does not have are 0.
    #[inline(always)]
    pub fn rates<R: Real>(&self, response: &Response<R>, z: R, u: R, command: R) -> [R; 3] {
        let lag = match self.command_rate {
            Some(rate) => (command - u) * rate,
            None => R::from(0.0),
        };
        [self.hysteresis.rate(z, response.slip), response.internal, lag]
    }

    /// The force over the one that the equations give: 1 but for a damper that is scaled to its gear.
    pub fn force_scale(&self) -> f64 {
        self.force_scale
    }

    /// A start of z, or an error that says which the element takes.
    ///
    /// # Errors
    /// NaN, infinities, and |z| > z_max where β > γ or β < −γ: from there it need not come back.
    pub fn check_hysteresis(&self, z: f64) -> Result<f64> {
        check_number("hysteresis", z, crate::parameter::Validity::Finite, "1")?;
        let most = self.hysteresis.saturation();
        if !self.hysteresis.comes_back() && z.abs() > most {
            let allowed = format!("at most {} in magnitude, where it saturates", shown(most));
            return Err(Error::new(Code::OutOfRange, "hysteresis", shown(z), allowed));
        }
        Ok(z)
    }
}

/// The Bouc–Wen element of checked values that are valid together.
///
/// # Errors
/// γ < 0, γ + β ≤ 0, n < 1.
fn element(gamma: f64, beta: f64, exponent: f64, amplitude: f64) -> Result<Hysteresis> {
    let refused = |field, value, allowed: &str| Err(Error::new(Code::OutOfRange, field, shown(value), allowed));
    if gamma + beta <= 0.0 {
        return refused("beta", beta, "> −gamma, or the element would feed energy in");
    }
    if !(1.0..=20.0).contains(&exponent) {
        return refused("exponent", exponent, "from 1 to 20");
    }
    Ok(Hysteresis::new(gamma, beta, exponent, amplitude))
}

/// As many values as a damper has parameters.
fn taken<const N: usize>(values: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| values[i])
}

/// That a sum of dampings does not vanish: ẇ is a force over it.
fn some_damping(field: &str, sum: f64) -> Result<()> {
    if sum > 0.0 {
        return Ok(());
    }
    Err(Error::new(
        Code::OutOfRange,
        field,
        "0",
        "> 0 where the other damping is 0: the two parts would have nothing between them",
    ))
}
