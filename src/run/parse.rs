//! Reading a run from untyped input.

use super::{Fields, Run, Value};
use crate::{
    error::{Code, Error, Result, shown},
    model::{
        self,
        assembly::{ROLL, RUNWAY},
    },
    parameter::{Parameter, parameter_index},
};

/// The keys of a run.
const KEYS: [&str; 21] = [
    "model",
    "parameters",
    "friction",
    "damper",
    "control",
    "initial",
    "duration",
    "method",
    "rtol",
    "atol",
    "step",
    "maxSteps",
    "times",
    "samples",
    "rows",
    "touchdownVelocity",
    "deceleration",
    "finalVelocity",
    "liftFraction",
    "linked",
    "disturbance",
];

/// The keys of a damper.
const DAMPER: [&str; 4] = ["model", "leverArm", "command", "parameters"];

/// The keys of a control law.
const CONTROL: [&str; 4] = ["law", "lag", "failureTime", "parameters"];

/// Parts that a run may name as absent: none of the models has room for them.
const ABSENT: [&str; 1] = ["tire"];

/// A number of a run: its key, what is allowed, what sets it.
type NumberField = (&'static str, &'static str, fn(&mut Run, f64) -> Result<()>);

const DURATION: NumberField = ("duration", "> 0 s", Run::set_duration);
const TOLERANCES_AND_STEPS: [NumberField; 4] = [
    ("rtol", "between 1e-14 and 0.1", Run::set_rtol),
    ("atol", "> 0", Run::set_atol),
    ("step", "> 0 s", Run::set_step),
    ("maxSteps", "a whole number from 1 to 1e9", Run::set_max_steps),
];
const SAMPLES: NumberField = ("samples", "a whole number from 2 to 1e7", Run::set_samples);
const ROWS: NumberField = ("rows", "a whole number from 2 to 1e7", Run::set_rows);

impl Run {
    /// Reads a run from a record. A missing key takes its default, an absent value counts as missing.
    ///
    /// # Errors
    /// Anything that is not a record of the known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let entries = record("run", input)?;
        for (key, value) in entries {
            if ABSENT.contains(&key.as_str()) {
                match value {
                    Value::Absent => continue,
                    given => {
                        return Err(Error::new(
                            Code::Unsuited,
                            key,
                            given.shown(),
                            "absent or null: no model takes it",
                        ));
                    }
                }
            }
            if !KEYS.contains(&key.as_str()) {
                return Err(Error::unknown(Code::UnknownKey, "run", key, &KEYS));
            }
        }
        // Of a key given twice the last counts, as in JavaScript.
        let given = |key: &str| {
            entries.iter().rev().find(|(name, _)| name == key).map(|(_, value)| value).filter(|v| **v != Value::Absent)
        };
        let model = given("model").ok_or_else(|| Error::missing("model", "the name of a model, such as torsional"))?;
        let mut run = Run::of(text("model", model)?)?;
        let damper = given("damper").map(|damper| Fields::of("damper", damper, &DAMPER)).transpose()?;
        if let Some(damper) = &damper {
            run.read_damper(damper).map_err(|error| error.within("damper"))?;
        }
        let control = given("control").map(|control| Fields::of("control", control, &CONTROL)).transpose()?;
        if let Some(control) = &control {
            run.read_control(control)?;
        }
        let mut parts = run.parts;
        parts.rolls = ROLL.iter().any(|parameter| given(parameter.name).is_some());
        if let Some(linked) = given("linked") {
            parts.tread_follows = read_link(linked, parts.rolls)?;
        }
        parts.runway = given("disturbance").is_some();
        run.set_parts(parts)?;
        if let Some(values) = given("parameters") {
            for (name, value) in present("parameters", values)? {
                // Dotted names too, as a live motion gives its parameters.
                let table = run.table();
                run.set_parameter(name, number_of(table, name, value)?)?;
            }
        }
        if let Some(damper) = &damper {
            run.read_values("damper", &["leverArm", "command"], damper)?;
        }
        if let Some(control) = &control {
            run.read_values("control", &["lag", "failureTime"], control)?;
        }
        if let Some(values) = given("friction") {
            run.read_element("friction", run.description().friction, values)?;
        }
        if let Some(values) = given("disturbance") {
            run.read_element("disturbance", &RUNWAY, values)?;
        }
        if parts.rolls {
            run.read_roll(&given)?;
        }
        if let Some(values) = given("initial") {
            for (name, value) in present("initial", values)? {
                // An unknown name is said before its value is looked at.
                run.set_initial(name, 0.0)?;
                run.set_initial(name, number(name, value, "a finite number")?)?;
            }
        }
        let set = |(key, allowed, set): &NumberField, run: &mut Run| match given(key) {
            Some(value) => set(run, number(key, value, allowed)?),
            None => Ok(()),
        };
        set(&DURATION, &mut run)?;
        if let Some(value) = given("method") {
            run.set_method(text("method", value)?)?;
        }
        TOLERANCES_AND_STEPS.iter().try_for_each(|field| set(field, &mut run))?;
        if let Some(times) = given("times") {
            for other in ["samples", "rows"] {
                if given(other).is_some() {
                    return Err(Error::new(Code::OutOfRange, other, "both", "given without times: one of the two"));
                }
            }
            run.set_times(numbers("times", times)?)?;
        }
        set(&SAMPLES, &mut run)?;
        if given("samples").is_some() && given("rows").is_some() {
            return Err(Error::new(Code::OutOfRange, "rows", "both", "given without samples: one of the two"));
        }
        set(&ROWS, &mut run)?;
        Ok(run)
    }
}

impl Run {
    /// Puts the damper on the gear that a record names.
    fn read_damper(&mut self, fields: &Fields) -> Result<()> {
        let allowed = "the name of a damper, such as bouc-wen";
        let name = fields.text("model")?.ok_or_else(|| Error::missing("model", allowed))?;
        self.set_damper(name)
    }

    /// Puts the control law to work that a record names.
    fn read_control(&mut self, fields: &Fields) -> Result<()> {
        let allowed = "the name of a control law, such as on-off";
        let name = fields.text("law").and_then(|name| name.ok_or_else(|| Error::missing("law", allowed)));
        self.set_control(name.map_err(|error| error.within("control"))?)
    }

    /// Reads the values of a part: its own fields, and its parameters. They are checked together once all are there.
    fn read_values(&mut self, part: &str, own: &[&str], fields: &Fields) -> Result<()> {
        let table = self.table();
        let mut values = self.parameters.clone();
        let mut take = |name: &str, value: &Value| {
            values[parameter_index(table, name)?] = number_of(table, name, value)?;
            Ok(())
        };
        for name in own {
            if let Some(value) = fields.value(name) {
                take(&format!("{part}.{name}"), value)?;
            }
        }
        if let Some(given) = fields.value("parameters") {
            for (name, value) in present(&format!("{part}.parameters"), given)? {
                take(&format!("{part}.parameters.{name}"), value)?;
            }
        }
        self.set_parameters(&values)
    }

    /// Reads how the speed falls. The values are checked together once all are there.
    fn read_roll<'a>(&mut self, given: &dyn Fn(&str) -> Option<&'a Value>) -> Result<()> {
        let table = self.table();
        let mut values = self.parameters.clone();
        for Parameter { name, .. } in &ROLL {
            if let Some(value) = given(name) {
                values[parameter_index(table, name)?] = number_of(table, name, value)?;
            }
        }
        self.set_parameters(&values)
    }

    /// Reads the values of an element, whose table has them by dotted names.
    #[inline(never)]
    fn read_element(&mut self, element: &str, table: &'static [Parameter], values: &Value) -> Result<()> {
        let known: Vec<&'static str> = table.iter().filter_map(|p| p.name.get(element.len() + 1..)).collect();
        let fields = Fields::of(element, values, &known)?;
        for (key, Parameter { name, .. }) in known.iter().zip(table) {
            if let Some(value) = fields.value(key) {
                self.set_parameter(name, number_of(table, name, value)?)?;
            }
        }
        Ok(())
    }

    /// Reads a state: as many numbers as the model has states.
    ///
    /// # Errors
    /// Anything but a list of numbers; [`Run::forces`] looks at them.
    pub fn read_state(&self, input: &Value) -> Result<Vec<f64>> {
        let states = self.description().state;
        let names: Vec<_> = states.iter().map(|state| state.name).collect();
        let wrong = || wrong_type("state", input, &format!("{} numbers: {}", names.len(), names.join(", ")));
        match input {
            Value::Numbers(numbers) if numbers.len() == states.len() => Ok(numbers.clone()),
            _ => Err(wrong()),
        }
    }

    /// Reads a motion: a record with a list of numbers for every state, all of one length. What else a trajectory has
    /// may be there; a state of an element that is not there is zero.
    ///
    /// # Errors
    /// Anything but such a record; [`Run::forces_along`] looks at the numbers.
    pub fn read_states(&self, input: &Value) -> Result<Vec<Vec<f64>>> {
        let states = self.description().state;
        let known: Vec<_> = states.iter().map(|state| state.name).chain(["time", "events", "stats"]).collect();
        let fields = Fields::of("columns", input, &known)?;
        let own = model::named(self.model).map_or(0, |gear| gear.state.len());
        let mut columns: Vec<Vec<f64>> = Vec::with_capacity(states.len());
        for state in states {
            let column = match (fields.numbers(state.name)?, columns.first()) {
                (Some(column), _) => column,
                (None, Some(first)) if columns.len() >= own => vec![0.0; first.len()],
                _ => return Err(Error::missing(state.name, "a list of numbers")),
            };
            columns.push(column);
        }
        Ok(columns)
    }
}

/// Whether κ is to follow F_z: of a gear that slows down.
fn read_link(linked: &Value, rolls: bool) -> Result<bool> {
    if !rolls {
        let allowed = "absent where nothing changes on the way: it is for a landing roll";
        return Err(Error::new(Code::Unsuited, "linked", linked.shown(), allowed));
    }
    let fields = Fields::of("linked", linked, &["treadWidthMomentConstant"])?;
    let follows = fields.truth("treadWidthMomentConstant").map_err(|error| error.within("linked"))?;
    Ok(follows.unwrap_or(false))
}

#[inline(never)]
fn number_of(table: &[Parameter], name: &str, value: &Value) -> Result<f64> {
    let index = parameter_index(table, name)?;
    match value {
        Value::Number(number) => Ok(*number),
        // The table's own words for what is allowed.
        other => match table[index].check(f64::NAN) {
            Err(error) => {
                let allowed = error.allowed.strip_prefix("a finite number ").unwrap_or(&error.allowed);
                Err(wrong_type(name, other, &format!("a number {allowed}")))
            }
            Ok(_) => Ok(f64::NAN),
        },
    }
}

/// The entries of a record that are there.
fn present<'a>(field: &str, value: &'a Value) -> Result<impl Iterator<Item = (&'a str, &'a Value)>> {
    Ok(record(field, value)?
        .iter()
        .filter(|(_, value)| *value != Value::Absent)
        .map(|(key, value)| (key.as_str(), value)))
}

#[inline(never)]
pub(super) fn wrong_type(field: &str, value: &Value, allowed: &str) -> Error {
    Error::new(Code::WrongType, field, value.shown(), allowed)
}

/// The entries of a record.
#[inline(never)]
pub(super) fn record<'a>(field: &str, value: &'a Value) -> Result<&'a [(String, Value)]> {
    match value {
        Value::Record(entries) => Ok(entries),
        other => Err(wrong_type(field, other, "a record of named values")),
    }
}

#[inline(never)]
pub(super) fn text<'a>(field: &str, value: &'a Value) -> Result<&'a str> {
    match value {
        Value::Text(text) => Ok(text),
        other => Err(wrong_type(field, other, "a name in quotes")),
    }
}

#[inline(never)]
pub(super) fn number(field: &str, value: &Value, allowed: &str) -> Result<f64> {
    match value {
        Value::Number(number) if !number.is_finite() => {
            Err(Error::new(Code::NotFinite, field, shown(*number), allowed))
        }
        Value::Number(number) => Ok(*number),
        other => Err(wrong_type(field, other, allowed)),
    }
}

#[inline(never)]
pub(super) fn numbers(field: &str, value: &Value) -> Result<Vec<f64>> {
    match value {
        Value::Numbers(numbers) => Ok(numbers.clone()),
        Value::List(0) => Ok(Vec::new()),
        other => Err(wrong_type(field, other, "a list of numbers")),
    }
}
