//! Sweeps: one motion carried on as a parameter goes there and back.

use std::collections::VecDeque;

use super::{
    UNKNOWN,
    field::{Axis, Field},
    follow::{Errand, Fate, Followers, Settled, Start},
};
use crate::{
    error::{Code, Error, Result},
    outlook::HORIZON,
    parameter::state_index,
    run::{Fields, Value},
};

/// Where the spec does not say where a motion starts: the first state at so many times its typical size. It is as small as
/// a disturbance may be that shall not carry it over an unstable cycle, and on the way back as large as the largest motions.
const PUSH: f64 = 0.01;
const LARGE: f64 = 3.0;

/// A sweep: over one parameter from end to end and back, or over a plane row by row, each there and back along x.
///
/// On the way there a motion that has come to rest starts anew a little beside it. The way back begins with the motion in
/// which the way there has ended; where that is rest, with a large start, and while nothing has swung anywhere yet, with a
/// large start at each value: where friction holds small swings, or rest is stable beside a large one, only that shows it.
/// So it does from what has left the range of the model.
///
/// Near a Hopf point a swing takes its time. What has not settled in its own is looked at once more, as [`crate::outlook`]
/// does, unless that time is shorter than a look; what is still on its way then, or never repeats, is told apart.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepSpec {
    /// What varies: one axis, or two.
    pub field: Field,
    /// The state whose amplitude is measured.
    pub measure: usize,
    /// The large start of the way back.
    pub start: Vec<f64>,
}

impl SweepSpec {
    /// Reads a record `{model, parameters, friction, initial, start, over, measure, linked, duration, tile}`; `over` is an axis
    /// `{parameter, from, to, count}`, or `{x, y}` with one in each.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("sweep", input, &Field::keys(&["over", "measure", "start"]))?;
        let run = Field::run(&fields)?;
        let over =
            fields.value("over").ok_or_else(|| Error::missing("over", "{parameter, from, to, count}, or {x, y}"))?;
        let is_plane =
            matches!(over, Value::Record(entries) if entries.iter().any(|(key, _)| key == "x" || key == "y"));
        let axes = if is_plane {
            let two = Fields::of("over", over, &["x", "y"])?;
            let axis = |place: &'static str| {
                let value = two.value(place).ok_or_else(|| Error::missing(place, "{parameter, from, to, count}"))?;
                Axis::read(&run, place, value, false)
            };
            let both = || Ok(vec![axis("x")?, axis("y")?]);
            both().map_err(|error: Error| error.within("over"))?
        } else {
            vec![Axis::read(&run, "over", over, false)?]
        };
        let states = run.description().state;
        let measure = fields.text("measure")?.map_or(Ok(0), |name| {
            state_index(states, name).map_err(|error| error.of_kind(Code::UnknownName).called("measure"))
        })?;
        let mut start = vec![0.0; states.len()];
        start[0] = LARGE * states[0].scale;
        if let Some(given) = fields.value("start") {
            start = Fields::state("start", given, states)?;
        }
        let field = Field::over(&fields, run, axes, PUSH)?;
        if field.tile.column > 0 || field.tile.columns < field.axes[0].count {
            let allowed = "whole rows: a motion is carried on from cell to cell";
            return Err(Error::new(Code::OutOfRange, "tile.columns", field.tile.columns.to_string(), allowed));
        }
        Ok(Self { field, measure, start })
    }

    /// The sweep before its first motion, to be made bit by bit.
    pub fn begin(self) -> Sweep {
        let Self { field, measure, start } = self;
        let (length, rows) = (field.axes[0].count, field.tile.rows);
        let cells = length * rows;
        let way = Way { kind: vec![UNKNOWN; cells], amplitude: vec![0.0; cells], settled: vec![0; cells] };
        let chains = vec![Chain { at: 0, x: field.run.initial().to_vec(), swings: false }; rows];
        let ways = [way.clone(), way];
        let waiting = (0..rows).collect();
        Sweep { followers: Followers::new(), rows: Rows { field, measure, start, chains, waiting, ways, made: 0 } }
    }

    /// The sweep.
    ///
    /// # Errors
    /// As [`Sweep::advance`].
    pub fn made(self) -> Result<Sweep> {
        let mut sweep = self.begin();
        while !sweep.done() {
            sweep.advance()?;
        }
        Ok(sweep)
    }
}

/// What a way through the cells has shown, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// How the motion ends at each, as the number of a [`Fate`]; [`UNKNOWN`] where it is not known yet.
    pub kind: Vec<u8>,
    /// The amplitude of the measured state there: 0 at rest, 1000 where it grows without bounds.
    pub amplitude: Vec<f64>,
    /// 1 where the motion has come to its end, and this is its amplitude; 0 where it was still on its way when its time was
    /// over, or never repeats.
    pub settled: Vec<u8>,
}

/// A row there and back.
#[derive(Clone, Debug)]
struct Chain {
    /// Which of its points is next: there, and then back.
    at: usize,
    /// The state to go on from.
    x: Vec<f64>,
    /// It has swung somewhere.
    swings: bool,
}

struct Rows {
    field: Field,
    measure: usize,
    start: Vec<f64>,
    chains: Vec<Chain>,
    /// Rows whose motion is ready to go on.
    waiting: VecDeque<usize>,
    ways: [Way; 2],
    made: usize,
}

/// A sweep, as far as it has been made.
pub struct Sweep {
    followers: Followers,
    rows: Rows,
}

impl Rows {
    /// Which way a chain goes at a point, and which cell of a row that is.
    fn place(&self, at: usize) -> (usize, usize) {
        let length = self.field.axes[0].count;
        if at < length { (0, at) } else { (1, 2 * length - 1 - at) }
    }

    /// The values of the axes there.
    fn values(&self, row: usize, cell: usize) -> Vec<f64> {
        match self.field.axes.as_slice() {
            [x, y] => vec![x.centre(cell), y.centre(self.field.tile.row + row)],
            axes => axes.iter().map(|axis| axis.point(cell)).collect(),
        }
    }
}

impl Errand for Rows {
    fn field(&self) -> &Field {
        &self.field
    }

    fn next(&mut self) -> Option<Start> {
        let row = self.waiting.pop_front()?;
        let (_, cell) = self.place(self.chains[row].at);
        let (values, _) = self.field.at(&self.values(row, cell));
        Some(Start { place: row, values, x: self.chains[row].x.clone() })
    }

    fn is_patient(&self) -> bool {
        self.field.duration >= HORIZON
    }

    fn settled(&mut self, row: usize, settled: Settled) {
        let length = self.field.axes[0].count;
        let (way, cell) = self.place(self.chains[row].at);
        let place = row * length + cell;
        self.ways[way].kind[place] = settled.fate as u8;
        self.ways[way].amplitude[place] = settled.amplitude[self.measure];
        self.ways[way].settled[place] = u8::from(settled.fate != Fate::Unsettled);
        self.made += 1;
        let chain = &mut self.chains[row];
        chain.at += 1;
        // From rest, and from beyond, it starts anew.
        let carried = !matches!(settled.fate, Fate::Rest | Fate::Divergence) && settled.x.iter().all(|x| x.is_finite());
        let rests = settled.fate == Fate::Rest;
        chain.swings |= !rests;
        let largely = chain.at == length || (chain.at > length && !(rests && chain.swings));
        chain.x = match (carried, largely) {
            (true, _) => settled.x,
            (_, true) => self.start.clone(),
            _ => self.field.run.initial().to_vec(),
        };
        if chain.at < 2 * length {
            self.waiting.push_back(row);
        }
    }
}

impl Sweep {
    /// Follows some motions a little further.
    ///
    /// # Errors
    /// Parameters with which a motion cannot be followed at all.
    pub fn advance(&mut self) -> Result<()> {
        self.followers.advance(&mut self.rows).map(|_| ())
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        self.rows.made == 2 * self.rows.ways[0].kind.len()
    }

    /// The part that is made, 0 … 1.
    pub fn fraction(&self) -> f64 {
        self.rows.made as f64 / (2 * self.rows.ways[0].kind.len()) as f64
    }

    /// The parameter's values along x: from end to end of one, at the cells' centres of a plane.
    pub fn values(&self) -> Vec<f64> {
        (0..self.rows.field.axes[0].count).map(|cell| self.rows.values(0, cell)[0]).collect()
    }

    /// There, from `from` to `to`.
    pub fn up(&self) -> &Way {
        &self.rows.ways[0]
    }

    /// And back.
    pub fn down(&self) -> &Way {
        &self.rows.ways[1]
    }

    /// What it was asked for.
    pub fn field(&self) -> &Field {
        &self.rows.field
    }

    /// The state whose amplitude is measured, by its place in the table.
    pub fn measure(&self) -> usize {
        self.rows.measure
    }
}
