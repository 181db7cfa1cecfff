//! What varies over a plane, or along a line: parameters and states.

use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Validity, check_number},
    run::{Fields, Run, Value},
    stability::{Links, Tile, range, whole},
};

/// Most motions of a plane: at ten thousand a second they take some minutes.
const MOST: usize = 1_000_000;
/// The longest that a motion may take to settle, in s.
const LONGEST: f64 = 1000.0;
/// A motion has so long to settle where nothing is said, in s.
const DURATION: f64 = 10.0;

/// What varies on an axis: a place in the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum What {
    Parameter(usize),
    State(usize),
}

/// A range cut into cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Public name of the parameter or the state.
    pub name: &'static str,
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    /// How many cells.
    pub count: usize,
    what: What,
}

impl Axis {
    pub(super) fn read(run: &Run, place: &'static str, input: &Value, states: bool) -> Result<Self> {
        let known: &[&'static str] =
            if states { &["parameter", "state", "from", "to", "count"] } else { &["parameter", "from", "to", "count"] };
        let fields = Fields::of(place, input, known)?;
        Self::taken(run, &fields).map_err(|error| error.within(place))
    }

    fn taken(run: &Run, fields: &Fields) -> Result<Self> {
        let description = run.description();
        let (name, what, from, to) = match (fields.text("state")?, fields.value("parameter")) {
            (Some(name), None) => {
                let index = crate::parameter::state_index(description.state, name)
                    .map_err(|error| error.of_kind(Code::UnknownName).called("state"))?;
                let variable = &description.state[index];
                let end = |key| {
                    let value =
                        fields.number(key, "a finite number")?.ok_or_else(|| Error::missing(key, "a number"))?;
                    check_number(key, value, Validity::Finite, variable.unit)
                };
                (variable.name, What::State(index), end("from")?, end("to")?)
            }
            (Some(_), Some(_)) => {
                return Err(Error::new(Code::OutOfRange, "state", "both", "given without a parameter: one of the two"));
            }
            (None, _) => {
                let (name, [from, to]) = range::read(fields)?;
                let index = range::check(description.table, name, [from, to])?;
                (description.table[index].name, What::Parameter(index), from, to)
            }
        };
        if to <= from {
            return Err(Error::new(Code::NotAscending, "to", shown(to), format!("> {} (from)", shown(from))));
        }
        let count = whole(fields, "count", [1, MOST])?.ok_or_else(|| Error::missing("count", "a number of cells"))?;
        Ok(Self { name, from, to, count, what })
    }

    /// The value at a part of the way, 0 … 1.
    fn value(&self, part: f64) -> f64 {
        if part == 1.0 { self.to } else { self.from + (self.to - self.from) * part }
    }

    /// The value at a cell's centre.
    pub fn centre(&self, index: usize) -> f64 {
        self.value((index as f64 + 0.5) / self.count as f64)
    }

    /// The value at one of as many points as there are cells, from end to end.
    pub fn point(&self, index: usize) -> f64 {
        self.value(if self.count > 1 { index as f64 / (self.count - 1) as f64 } else { 0.0 })
    }
}

/// A gear, a start, and what of them varies.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    pub(super) run: Run,
    /// Across and, of a plane, along.
    pub axes: Vec<Axis>,
    /// The part of a plane that is made.
    pub tile: Tile,
    /// How long a motion has to settle \[s\].
    pub duration: f64,
    links: Links,
}

impl Field {
    /// The keys that a field has, beside those of its axes.
    const KEYS: [&'static str; 9] =
        ["model", "parameters", "friction", "damper", "control", "initial", "linked", "duration", "tile"];

    /// All keys of a record that has `more` beside a field's.
    pub(super) fn keys(more: &[&'static str]) -> Vec<&'static str> {
        [&Self::KEYS, more].concat()
    }

    /// The run of a field: where neither the record nor an axis says where it starts, the first state is this part of its
    /// typical size.
    pub(super) fn run(fields: &Fields) -> Result<Run> {
        let given = ["model", "parameters", "friction", "damper", "control", "initial"]
            .into_iter()
            .filter_map(|key| Some((key.to_owned(), fields.value(key)?.clone())));
        Run::read(&Value::Record(given.collect()))
    }

    /// A field over these axes, of a run that starts with the first state at `push` × its typical size where nothing else is
    /// said.
    pub(super) fn over(fields: &Fields, run: Run, axes: Vec<Axis>, push: f64) -> Result<Self> {
        if let [x, y] = axes.as_slice() {
            if x.what == y.what {
                return Err(Error::new(Code::OutOfRange, "y", y.name, format!("another one than x, {}", x.name)));
            }
            if x.count.saturating_mul(y.count) > MOST {
                let allowed = format!("at most {} with {} cells across (x.count)", MOST / x.count, x.count);
                return Err(Error::new(Code::TooLarge, "y.count", y.count.to_string(), allowed));
            }
        }
        let names: Vec<&str> = axes.iter().map(|axis| axis.name).collect();
        let links = Links::read(fields)?;
        links.check(&names)?;
        let counts = [axes[0].count, axes.get(1).map_or(1, |axis| axis.count)];
        let tile = fields.value("tile").map_or(Ok(Tile::whole(counts)), |tile| Tile::read(tile, counts))?;
        let duration = fields.number("duration", "> 0 s")?.unwrap_or(DURATION);
        let duration = check_number("duration", duration, Validity::Positive, "s")?;
        if duration > LONGEST {
            return Err(Error::new(Code::TooLarge, "duration", shown(duration), "at most 1000 s"));
        }
        let starts = axes.iter().any(|axis| matches!(axis.what, What::State(_)));
        let mut initial = run.initial().to_vec();
        if !starts && initial.iter().all(|x| *x == 0.0) {
            initial[0] = push * run.description().state[0].scale;
        }
        let run = run.placed(run.parameters(), &initial, duration);
        Ok(Self { run, axes, tile, duration, links })
    }

    /// Whether one gear starts everywhere.
    pub(super) fn is_of_starts(&self) -> bool {
        self.axes.iter().all(|axis| matches!(axis.what, What::State(_)))
    }

    /// Parameters and start where the axes have these values.
    pub(super) fn at(&self, values: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut parameters = self.run.parameters().to_vec();
        for (axis, value) in self.axes.iter().zip(values) {
            if let What::Parameter(index) = axis.what {
                parameters[index] = *value;
            }
        }
        let names: Vec<&str> = self.axes.iter().map(|axis| axis.name).collect();
        self.links.follow(self.run.description().table, &mut parameters, &names);
        let mut x = self.run.start_with(&parameters);
        for (axis, value) in self.axes.iter().zip(values) {
            if let What::State(index) = axis.what {
                x[index] = *value;
            }
        }
        (parameters, x)
    }

    /// The values of the axes at the centre of a cell of the tile.
    pub(super) fn centre(&self, cell: usize) -> Vec<f64> {
        let Tile { column, row, columns, .. } = self.tile;
        let places = [column + cell % columns, row + cell / columns];
        self.axes.iter().zip(places).map(|(axis, place)| axis.centre(place)).collect()
    }
}
