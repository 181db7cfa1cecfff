//! What changes one thing of a run, in place: reading sets one after the other, and a run is large to hand around.

use super::{MOST_SAMPLES, Run};
use crate::{
    element::{control, damper},
    error::{Code, Error, Result, shown},
    integrate::{Method, Output},
    model::{Parts, damper_on, resting_command},
    parameter::{Parameter, StateVariable, Validity, check_number, parameter_index, state_index},
};

/// The state that has a largest value.
const HYSTERESIS: &str = "hysteresis";
/// The state that starts at a command.
const EFFECTIVE_COMMAND: &str = "effectiveCommand";

/// Most steps that can be asked for.
const MOST_STEPS: f64 = 1e9;
/// Tolerances that double precision can serve.
const RTOL: std::ops::RangeInclusive<f64> = 1e-14..=0.1;

impl Run {
    pub(super) fn set_parameter(&mut self, name: &str, value: f64) -> Result<()> {
        let table = self.table();
        let index = parameter_index(table, name)?;
        let before = std::mem::replace(&mut self.parameters[index], table[index].check(value)?);
        if !self.parts.none() {
            self.description().check(&self.parameters).inspect_err(|_| self.parameters[index] = before)?;
            self.settle_command();
        }
        Ok(())
    }

    /// Sets all parameters, in table order.
    pub(super) fn set_parameters(&mut self, values: &[f64]) -> Result<()> {
        let description = self.description();
        for (parameter, value) in description.table.iter().zip(values) {
            parameter.check(*value)?;
        }
        description.check(values)?;
        self.parameters = values.to_vec();
        self.settle_command();
        Ok(())
    }

    /// Puts a damper on the gear.
    pub(super) fn set_damper(&mut self, name: &str) -> Result<()> {
        let damper = damper::named(name)?;
        self.set_parts(Parts { damper: Some(damper.name), ..self.parts })
    }

    /// Puts a control law to work.
    pub(super) fn set_control(&mut self, name: &str) -> Result<()> {
        let law = control::named(name).map_err(|error| error.within("control"))?;
        self.set_parts(Parts { control: Some(law.name), ..self.parts })
    }

    /// That a state may start like this.
    pub(crate) fn check_start(&self, name: &str, value: f64) -> Result<()> {
        match damper_on(&self.description(), &self.parameters, 1.0)? {
            Some(fitted) if name == HYSTERESIS => fitted.check_hysteresis(value),
            _ => Ok(()),
        }
    }

    /// Puts parts on the gear; values that it has had before stay.
    pub(super) fn set_parts(&mut self, parts: Parts) -> Result<()> {
        let before = self.description();
        self.parts = parts;
        let after = self.description();
        let kept = |name: &str| before.table.iter().position(|parameter| parameter.name == name);
        let value = |parameter: &Parameter| kept(parameter.name).map_or(parameter.default, |at| self.parameters[at]);
        self.parameters = after.table.iter().map(value).collect();
        let kept = |name: &str| before.state.iter().position(|state| state.name == name);
        let start = |state: &StateVariable| kept(state.name).map_or(0.0, |at| self.initial[at]);
        self.initial = after.state.iter().map(start).collect();
        self.settle_command();
        after.check(&self.parameters)
    }

    /// Lets the state u start at the command, unless it is said to start elsewhere.
    pub(super) fn settle_command(&mut self) {
        self.initial = self.start_with(&self.parameters);
    }

    /// Where it starts with other values of all parameters, in table order: the state u at their command, unless it is said to
    /// start elsewhere.
    pub(crate) fn start_with(&self, parameters: &[f64]) -> Vec<f64> {
        let description = self.description();
        let mut start = self.initial.clone();
        let state = description.state.iter().position(|state| state.name == EFFECTIVE_COMMAND);
        if let (false, Some(state)) = (self.effective, state) {
            start[state] = resting_command(&description, parameters);
        }
        start
    }

    pub(super) fn set_initial(&mut self, name: &str, value: f64) -> Result<()> {
        let states = self.description().state;
        let index = state_index(states, name).map_err(|error| error.called("initial"))?;
        self.initial[index] = check_number(name, value, Validity::Finite, states[index].unit)?;
        self.check_start(name, value)?;
        self.effective |= name == EFFECTIVE_COMMAND;
        Ok(())
    }

    pub(super) fn set_duration(&mut self, duration: f64) -> Result<()> {
        self.duration = Some(check_number("duration", duration, Validity::Positive, "s")?);
        Ok(())
    }

    pub(super) fn set_method(&mut self, name: &str) -> Result<()> {
        self.method = Method::named(name)?;
        Ok(())
    }

    pub(super) fn set_step(&mut self, step: f64) -> Result<()> {
        self.step = check_number("step", step, Validity::Positive, "s")?;
        Ok(())
    }

    pub(super) fn set_rtol(&mut self, rtol: f64) -> Result<()> {
        if !RTOL.contains(&rtol) {
            return Err(Error::new(Code::OutOfRange, "rtol", shown(rtol), "between 1e-14 and 0.1"));
        }
        self.rtol = rtol;
        Ok(())
    }

    pub(super) fn set_atol(&mut self, atol: f64) -> Result<()> {
        self.atol = Some(check_number("atol", atol, Validity::Positive, "1")?);
        Ok(())
    }

    pub(super) fn set_max_steps(&mut self, steps: f64) -> Result<()> {
        if !(1.0..=MOST_STEPS).contains(&steps) || steps.fract() != 0.0 {
            return Err(Error::new(Code::OutOfRange, "maxSteps", shown(steps), "a whole number from 1 to 1e9"));
        }
        self.max_steps = steps as u64;
        Ok(())
    }

    pub(super) fn set_times(&mut self, times: Vec<f64>) -> Result<()> {
        check_times(&times)?;
        self.output = Output::Times(times);
        Ok(())
    }

    pub(super) fn set_samples(&mut self, samples: f64) -> Result<()> {
        self.output = Output::Samples(many("samples", samples)?);
        Ok(())
    }

    pub(super) fn set_rows(&mut self, rows: f64) -> Result<()> {
        self.output = Output::Rows(many("rows", rows)?);
        Ok(())
    }
}

/// A number of rows.
fn many(field: &str, count: f64) -> Result<usize> {
    if !(2.0..=MOST_SAMPLES as f64).contains(&count) || count.fract() != 0.0 {
        let code = if count > MOST_SAMPLES as f64 { Code::TooLarge } else { Code::OutOfRange };
        return Err(Error::new(code, field, shown(count), "a whole number from 2 to 1e7"));
    }
    Ok(count as usize)
}

fn check_times(times: &[f64]) -> Result<()> {
    let refused = |code, value: String, allowed: &str| Err(Error::new(code, "times", value, allowed));
    if times.is_empty() {
        return refused(Code::OutOfRange, "an empty list".into(), "at least one time");
    }
    if times.len() > MOST_SAMPLES {
        return refused(Code::TooLarge, format!("{} times", times.len()), "at most 1e7 times");
    }
    if let Some((i, t)) = times.iter().enumerate().find(|(_, t)| !t.is_finite()) {
        return refused(Code::NotFinite, format!("{} at index {i}", shown(*t)), "finite numbers of s");
    }
    if times[0] < 0.0 {
        return refused(Code::OutOfRange, shown(times[0]), "≥ 0 s");
    }
    if let Some(i) = (1..times.len()).find(|&i| times[i] < times[i - 1]) {
        return refused(Code::NotAscending, format!("{} after {}", shown(times[i]), shown(times[i - 1])), "ascending");
    }
    check_number("times", times[times.len() - 1], Validity::NonNegative, "s").map(|_| ())
}
