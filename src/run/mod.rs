//! A run: which model, with which values, from where, for how long, by which method.

mod fields;
mod gear;
mod linear;
mod parse;
mod problem;
mod set;
mod value;

pub(crate) use fields::Fields;
pub use problem::Problem;
pub(crate) use problem::{Posed, check_fixed_step};
pub use value::Value;

use serde::Serialize;

use crate::{
    cycles::{Guess, LimitCycle},
    energy::Energy,
    error::{Code, Error, Result},
    integrate::{Method, Output, Scheme, Trajectory},
    live::Simulator,
    model::{self, Description, Parts, assembly::Roll},
    outlook::{HORIZON, Outlook},
    parameter::{Parameter, StateVariable},
    section::{Section, SectionSpec},
};

/// Most samples, and most times, of one trajectory.
pub const MOST_SAMPLES: usize = 10_000_000;
/// Duration of a run that does not say, in s.
const DURATION: f64 = 2.0;

/// A run, checked: whatever is in it makes sense.
///
/// Built from a model's defaults by [`Run::of`] and the methods that change one thing each, or read from untyped input
/// by [`Run::read`].
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    model: &'static str,
    parts: Parts,
    parameters: Vec<f64>,
    initial: Vec<f64>,
    /// The state u of a damper, where it does not start at the command.
    effective: bool,
    duration: Option<f64>,
    method: Method,
    rtol: f64,
    atol: Option<f64>,
    step: f64,
    max_steps: u64,
    output: Output,
}

impl Run {
    /// A run of the model `name` with its defaults: from rest, 2 s, method `auto`, rtol 10⁻⁸.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn of(name: &str) -> Result<Self> {
        let description = model::named(name).ok_or_else(|| {
            let known: Vec<_> = model::list().iter().map(|m| m.name).collect();
            Error::unknown(Code::UnknownName, "model", name, &known)
        })?;
        Ok(Self {
            model: description.name,
            parts: Parts::NONE,
            parameters: description.defaults(),
            initial: vec![0.0; description.state.len()],
            effective: false,
            duration: None,
            method: Method::Auto,
            rtol: 1e-8,
            atol: None,
            step: 1e-4,
            max_steps: 10_000_000,
            output: Output::Steps,
        })
    }

    /// With another value of the parameter `name`; a dotted name reaches an element: `friction.moment`.
    ///
    /// # Errors
    /// An unknown name, or a value that is not valid for it.
    pub fn with(mut self, name: &str, value: f64) -> Result<Self> {
        self.set_parameter(name, value)?;
        Ok(self)
    }

    /// With other values of all parameters, in table order.
    ///
    /// # Errors
    /// A value that is not valid.
    pub(crate) fn with_values(mut self, values: &[f64]) -> Result<Self> {
        self.set_parameters(values)?;
        Ok(self)
    }

    /// Starting with another value of the state `name`.
    ///
    /// # Errors
    /// An unknown name, or a value that is not finite.
    pub fn starting(mut self, name: &str, value: f64) -> Result<Self> {
        self.set_initial(name, value)?;
        Ok(self)
    }

    /// With the damper `name` on the gear, with its defaults there.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one; a model that has no place for a damper.
    pub fn fitted(mut self, name: &str) -> Result<Self> {
        self.set_damper(name)?;
        Ok(self)
    }

    /// Until `duration` s.
    ///
    /// # Errors
    /// A duration that is not > 0.
    pub fn lasting(mut self, duration: f64) -> Result<Self> {
        self.set_duration(duration)?;
        Ok(self)
    }

    /// By the method `name`.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn by(mut self, name: &str) -> Result<Self> {
        self.set_method(name)?;
        Ok(self)
    }

    /// With the fixed step of method `rk4`, in s.
    ///
    /// # Errors
    /// A step that is not > 0.
    pub fn stepping(mut self, step: f64) -> Result<Self> {
        self.set_step(step)?;
        Ok(self)
    }

    /// To a relative tolerance, and an absolute one of rtol/100 × each state's scale.
    ///
    /// # Errors
    /// A tolerance outside of 10⁻¹⁴ … 0.1.
    pub fn within(mut self, rtol: f64) -> Result<Self> {
        self.set_rtol(rtol)?;
        Ok(self)
    }

    /// With one absolute tolerance for all states, as it is.
    ///
    /// # Errors
    /// A tolerance that is not > 0.
    pub fn within_absolute(mut self, atol: f64) -> Result<Self> {
        self.set_atol(atol)?;
        Ok(self)
    }

    /// With at most this many steps.
    ///
    /// # Errors
    /// Not a whole number from 1 to 10⁹.
    pub fn at_most(mut self, steps: f64) -> Result<Self> {
        self.set_max_steps(steps)?;
        Ok(self)
    }

    /// With values at these times, the last of which ends the run.
    ///
    /// # Errors
    /// No times, too many, times below 0 or not finite, times that do not ascend.
    pub fn at(mut self, times: Vec<f64>) -> Result<Self> {
        self.set_times(times)?;
        Ok(self)
    }

    /// With `samples` values, equally spaced from 0 to the duration.
    ///
    /// # Errors
    /// Not a whole number from 2 to 10⁷.
    pub fn sampled(mut self, samples: f64) -> Result<Self> {
        self.set_samples(samples)?;
        Ok(self)
    }

    /// With the solver's steps and the first state's turns, thinned to about `rows` for drawing: see [`Output::Rows`].
    ///
    /// # Errors
    /// Not a whole number from 2 to 10⁷.
    pub fn drawn(mut self, rows: f64) -> Result<Self> {
        self.set_rows(rows)?;
        Ok(self)
    }

    /// The model's tables.
    pub fn description(&self) -> Description {
        model::assembled(self.model, self.parts).expect("a run is made for a listed model")
    }

    /// Values of all parameters, in table order, those of its elements after them.
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The state at t = 0, in table order.
    pub fn initial(&self) -> &[f64] {
        &self.initial
    }

    /// How long it lasts, in s: to the last of its times, or its duration (2 s where none is given).
    pub fn duration(&self) -> f64 {
        let own = || self.roll().map_or(DURATION, |roll| roll.duration());
        self.given_duration().unwrap_or_else(own)
    }

    /// How its speed falls, where it does.
    pub fn roll(&self) -> Option<Roll> {
        model::roll(&self.description(), &self.parameters).ok().flatten()
    }

    /// With the control law `name`, with its defaults.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one; a law that does not go with the damper.
    pub fn controlled(mut self, name: &str) -> Result<Self> {
        self.set_control(name)?;
        Ok(self)
    }

    /// As after touchdown: the speed falls from t = 0 on, with the roll's defaults.
    ///
    /// # Errors
    /// A model that does not roll.
    pub fn rolling(mut self) -> Result<Self> {
        self.set_parts(Parts { rolls: true, ..self.parts })?;
        Ok(self)
    }

    /// On an uneven runway, with its defaults.
    ///
    /// # Errors
    /// A model that does not roll.
    pub fn disturbed(mut self) -> Result<Self> {
        self.set_parts(Parts { runway: true, ..self.parts })?;
        Ok(self)
    }

    /// How long it lasts where it says so, in s.
    pub(crate) fn given_duration(&self) -> Option<f64> {
        match &self.output {
            Output::Times(times) => times.last().copied(),
            Output::Samples(_) | Output::Steps | Output::Rows(_) => self.duration,
        }
    }

    /// The same with other values of all parameters, in table order and valid, from another state and for `duration` s.
    pub(crate) fn placed(&self, parameters: &[f64], initial: &[f64], duration: f64) -> Self {
        let (parameters, initial) = (parameters.to_vec(), initial.to_vec());
        Self { parameters, initial, duration: Some(duration), output: Output::Steps, ..self.clone() }
    }

    /// How far an outlook sees, in s.
    pub(crate) fn horizon(&self) -> f64 {
        self.duration.unwrap_or(HORIZON)
    }

    /// The fixed step that it is taken with, if it is.
    pub(crate) fn fixed_step(&self) -> Option<f64> {
        (self.method == Method::Always(Scheme::RungeKutta4)).then_some(self.step)
    }

    /// The method that it is taken with.
    pub(crate) fn method(&self) -> Method {
        self.method
    }

    /// Its relative tolerance.
    pub(crate) fn rtol(&self) -> f64 {
        self.rtol
    }

    /// Most steps it may take.
    pub(crate) fn max_steps(&self) -> u64 {
        self.max_steps
    }

    /// Carries it out.
    ///
    /// # Errors
    /// As [`crate::integrate::solve`]; and a fixed step that is unstable for the equations, or too short for `maxSteps`.
    pub fn simulate(&self) -> Result<Trajectory> {
        self.problem().solve()
    }

    /// What becomes of the motion if nothing changes: see [`Outlook`].
    ///
    /// # Errors
    /// As [`Run::simulate`].
    pub fn outlook(&self) -> Result<Outlook> {
        self.check_steady("an outlook")?;
        let mut lookout = self.problem().lookout()?;
        loop {
            if let Some(outlook) = lookout.advance()? {
                return Ok(outlook);
            }
        }
    }

    /// The run as a live motion.
    ///
    /// # Errors
    /// As [`Run::simulate`].
    pub fn live(&self) -> Result<Simulator> {
        self.problem().live()
    }

    /// The energy that goes through the motion in its duration, or in one cycle from its start where none is given; nothing
    /// where it does not swing.
    ///
    /// # Errors
    /// As [`Run::simulate`]; a model without force laws.
    pub fn energy(&self) -> Result<Option<Energy>> {
        self.check_steady("an account of energy")?;
        self.problem().energy()
    }

    /// Where the motion passes a section of the state space, within its duration.
    ///
    /// # Errors
    /// As [`Run::simulate`]; more than 10⁶ passages.
    pub fn section(&self, section: &SectionSpec) -> Result<Section> {
        self.problem().section(section)
    }

    /// The limit cycle near the guess; where there is no guess, or no cycle near it, the one that the motion settles on.
    /// A run that starts at rest is tried with a small push in the direction that grows fastest, if any does, and then from
    /// larger and larger angles. None where no start leads to a cycle.
    ///
    /// # Errors
    /// As [`Run::simulate`] and [`Run::eigenmodes`]; a guess that makes no sense.
    pub fn limit_cycle(&self, guess: Option<&Guess>) -> Result<Option<LimitCycle>> {
        self.check_steady("a limit cycle")?;
        let guess = guess.map(|guess| guess.clone().checked(self)).transpose()?;
        self.problem().limit_cycle(guess.as_ref())
    }

    fn check_steady(&self, what: &str) -> Result<()> {
        self.description().check_steady(what)
    }

    fn table(&self) -> &'static [Parameter] {
        self.description().table
    }

    /// What a run of this gear, with what is on it, has values for, and what its state is.
    pub fn tables(&self) -> RunTables {
        let Description { table, state, .. } = self.description();
        RunTables { parameters: table, state }
    }
}

/// The tables of a gear with what is on it: see [`Run::tables`].
#[derive(Clone, Copy, Debug, Serialize)]
pub struct RunTables {
    /// Parameters of the model and, by dotted names, of its elements, in the order in which a run stores them.
    pub parameters: &'static [Parameter],
    /// State variables, in the order of the state.
    pub state: &'static [StateVariable],
}
