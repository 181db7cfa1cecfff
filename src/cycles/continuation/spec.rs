//! What a bifurcation diagram is asked for.

use crate::{
    cycles::Guess,
    error::{Code, Error, Result, shown},
    run::{Fields, Run, Value},
    stability::Variation,
};

/// Most points of a branch, unless asked for otherwise, and most that can be asked for.
const POINTS: usize = 400;
const MOST_POINTS: usize = 10_000;
/// The longest step, in parts of the range.
const STEP: f64 = 0.025;
/// How near special points are located, in parts of the range and of the cycle's size.
const TOLERANCE: f64 = 1e-6;
/// Values at which simulation looks for cycles that no branch has, and most of them.
const PROBES: usize = 4;
const MOST_PROBES: usize = 100;

/// A bifurcation diagram to be made: rest and cycles of a gear over the range of one of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct BifurcationSpec {
    /// The gear.
    pub run: Run,
    /// The parameter and its range; the ends may come in either order.
    pub variation: Variation,
    /// A cycle nearby, and the parameter's value there.
    pub cycle: Option<(Guess, f64)>,
    /// Most points of a branch.
    pub points: usize,
    /// The longest step along the parameter, in parts of its range.
    pub step: f64,
    /// How near special points are located, in parts of the range and of the cycle's size.
    pub tolerance: f64,
    /// At how many values motions are simulated, from small and large starts, to find cycles that no branch has.
    pub probes: usize,
}

impl BifurcationSpec {
    /// The gear of a run along a parameter, in the usual manner.
    pub fn of(run: Run, variation: Variation) -> Self {
        Self { run, variation, cycle: None, points: POINTS, step: STEP, tolerance: TOLERANCE, probes: PROBES }
    }

    /// Reads a record `{model, parameters, friction, damper, parameter, from, to, linked, cycle: {period, state, value}, points, step, tolerance,
    /// probes}`.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field. Names and ranges are checked against the model
    /// when it begins.
    pub fn read(input: &Value) -> Result<Self> {
        const RUN: [&str; 5] = ["model", "parameters", "friction", "damper", "control"];
        const RANGE: [&str; 4] = ["parameter", "from", "to", "linked"];
        const OWN: [&str; 5] = ["cycle", "points", "step", "tolerance", "probes"];
        let fields = Fields::of("bifurcation", input, &[RUN.as_slice(), &RANGE, &OWN].concat())?;
        let part = |keys: &[&str]| {
            let given = keys.iter().filter_map(|key| Some(((*key).to_owned(), fields.value(key)?.clone())));
            Value::Record(given.collect())
        };
        let run = Run::read(&part(&RUN))?;
        let mut spec = Self::of(run, Variation::read(&part(&RANGE))?);
        if let Some(cycle) = fields.value("cycle") {
            spec.cycle = Some(spec.read_cycle(cycle)?);
        }
        let whole = |key, least: usize, most: usize| {
            let allowed = format!("a whole number from {least} to {most}");
            let Some(number) = fields.number(key, &allowed)? else { return Ok(None) };
            if number.fract() == 0.0 && (least as f64..=most as f64).contains(&number) {
                return Ok(Some(number as usize));
            }
            let code = if number > most as f64 { Code::TooLarge } else { Code::OutOfRange };
            Err(Error::new(code, key, shown(number), allowed))
        };
        let between = |key, least: f64, most: f64| {
            let allowed = format!("from {} to {}", shown(least), shown(most));
            match fields.number(key, &allowed)? {
                Some(number) if !(least..=most).contains(&number) => {
                    Err(Error::new(Code::OutOfRange, key, shown(number), allowed))
                }
                number => Ok(number),
            }
        };
        spec.points = whole("points", 2, MOST_POINTS)?.unwrap_or(POINTS);
        spec.probes = whole("probes", 0, MOST_PROBES)?.unwrap_or(PROBES);
        spec.step = between("step", 1e-4, 0.1)?.unwrap_or(STEP);
        spec.tolerance = between("tolerance", 1e-9, 1e-3)?.unwrap_or(TOLERANCE);
        Ok(spec)
    }

    /// A guess with the parameter's value, which is the run's own where none is given.
    fn read_cycle(&self, input: &Value) -> Result<(Guess, f64)> {
        let fields = Fields::of("cycle", input, &["period", "state", "value"])?;
        let given =
            ["period", "state"].into_iter().filter_map(|key| Some((key.to_owned(), fields.value(key)?.clone())));
        let guess = Guess::read(&self.run, &Value::Record(given.collect())).map_err(|error| error.within("cycle"))?;
        let guess = guess.ok_or_else(|| Error::missing("cycle", "a record {period, state, value}"))?;
        let own = || {
            let table = self.run.description().table;
            let place = table.iter().position(|parameter| parameter.name == self.variation.parameter);
            place.map_or(f64::NAN, |place| self.run.parameters()[place])
        };
        let value = fields.number("value", "a finite number").map_err(|error| error.within("cycle"))?;
        Ok((guess, value.unwrap_or_else(own)))
    }
}
