//! Poincaré sections: where a motion passes a level of one of its states.

use crate::{
    error::{Code, Error, Result, shown},
    integrate::failed,
    model::Gear,
    parameter::{Validity, check_number, state_index},
    run::{Fields, Posed, Run, Value},
};

/// Most passages that are kept: of a wheel that shakes fifty times a second those of five hours.
const MOST: usize = 1_000_000;
/// A step is at most this part of the run.
const STEPS: f64 = 20.0;

/// A section: the states in which one of them has a certain value, and passes it in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectionSpec {
    /// The state, by its place in the table.
    pub state: usize,
    /// Its value, in its unit.
    pub level: f64,
    /// It rises through it; otherwise it falls.
    pub rising: bool,
    /// Passages before this time do not count \[s\].
    pub after: f64,
}

impl Default for SectionSpec {
    /// Where the first state rises through 0, from the start on.
    fn default() -> Self {
        Self { state: 0, level: 0.0, rising: true, after: 0.0 }
    }
}

impl SectionSpec {
    /// Reads a record `{state, level, rising, after}`; the default, where there is none.
    ///
    /// # Errors
    /// Anything but a record of these keys with a state of the run's model; the error names the field.
    pub fn read(run: &Run, input: &Value) -> Result<Self> {
        let mut section = Self::default();
        if *input == Value::Absent {
            return Ok(section);
        }
        let fields = Fields::of("section", input, &["state", "level", "rising", "after"])?;
        let states = run.description().state;
        if let Some(name) = fields.text("state")? {
            let unknown = |error: Error| error.of_kind(Code::UnknownName).called("state");
            section.state = state_index(states, name).map_err(unknown)?;
        }
        if let Some(level) = fields.number("level", "a finite number")? {
            section.level = check_number("level", level, Validity::Finite, states[section.state].unit)?;
        }
        section.rising = fields.truth("rising")?.unwrap_or(true);
        if let Some(after) = fields.number("after", "≥ 0 s")? {
            section.after = check_number("after", after, Validity::NonNegative, "s")?;
        }
        Ok(section)
    }
}

/// The passages of a motion through a section, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// When \[s\].
    pub time: Vec<f64>,
    /// The states there: one column a state. Poincaré's map takes each to the next.
    pub states: Vec<Vec<f64>>,
    /// From each passage to the next, how far the section's state goes from its level: one less than passages. The return
    /// map of amplitudes takes each to the next.
    pub amplitude: Vec<f64>,
}

/// The passages of a run.
pub(crate) fn of<S: Gear<N>, const N: usize>(posed: &Posed<S, N>, spec: &SectionSpec) -> Result<Section> {
    let SectionSpec { state, level, rising, after } = *spec;
    let duration = posed.run.duration();
    posed.check_step_count(duration)?;
    let mut motion = posed.motion(duration / STEPS)?;
    let mut section =
        Section { time: Vec::new(), states: vec![Vec::new(); posed.system.width()], amplitude: Vec::new() };
    let mut reach = 0.0_f64;
    while motion.time() < duration {
        if motion.stats().steps >= posed.run.max_steps() {
            return Err(Error::step_limit(motion.time(), posed.run.max_steps()));
        }
        let time = motion.time();
        motion.step(duration).map_err(|failure| failed(failure, time))?;
        let turn = motion.turning_point(state);
        let passage = motion.passes(state, level, rising).filter(|time| *time >= after);
        // A step may have a turn as well as a passage, the one before or after the other.
        let far = |turn: Option<(f64, f64)>| turn.map_or(0.0, |(_, value)| (value - level).abs());
        reach = reach.max(far(turn.filter(|(turned, _)| passage.is_none_or(|time| *turned < time))));
        let Some(time) = passage else { continue };
        if section.time.len() == MOST {
            return Err(Error::new(
                Code::TooLarge,
                "duration",
                shown(duration),
                "so short that there are at most 1e6 passages",
            ));
        }
        if !section.time.is_empty() {
            section.amplitude.push(reach);
        }
        section.time.push(time);
        for (column, value) in section.states.iter_mut().zip(motion.interpolate(time)) {
            column.push(value);
        }
        reach = far(turn.filter(|(turned, _)| *turned >= time));
    }
    Ok(section)
}
