//! Basins: in which motion each cell of a plane ends.

use super::{
    endings::{APART, Ending, Endings},
    field::{Axis, Field},
    follow::{Errand, Followers, Settled, Start},
    refine::Cells,
};
use crate::{
    error::{Error, Result},
    run::{Fields, Value},
};

/// Where neither the spec nor an axis says where a motion starts: the first state at so many times its typical size.
const PUSH: f64 = 0.1;

/// Basins to be found: a plane of two states, two parameters or one of each, cut into cells.
#[derive(Clone, Debug, PartialEq)]
pub struct BasinsSpec {
    /// The plane.
    pub field: Field,
    /// Coarse first, then finer where neighbours end differently; otherwise every cell is followed.
    pub refined: bool,
}

impl BasinsSpec {
    /// Reads a record `{model, parameters, initial, x: {parameter | state, from, to, count}, y, linked, duration, refine, tile}`.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("basins", input, &Field::keys(&["x", "y", "refine"]))?;
        let run = Field::run(&fields)?;
        let axis = |place| {
            let missing = || Error::missing(place, "a record {parameter or state, from, to, count}");
            Axis::read(&run, place, fields.value(place).ok_or_else(missing)?, true)
        };
        let axes = vec![axis("x")?, axis("y")?];
        let refined = fields.truth("refine")?.unwrap_or(true);
        Ok(Self { field: Field::over(&fields, run, axes, PUSH)?, refined })
    }

    /// The basins before the first motion, to be made bit by bit.
    pub fn begin(self) -> Basins {
        let Self { field, refined } = self;
        let cells = Cells::new([field.tile.columns, field.tile.rows], field.is_of_starts(), refined);
        Basins { followers: Followers::new(), plane: Plane { field, cells } }
    }

    /// The basins.
    ///
    /// # Errors
    /// As [`Basins::advance`].
    pub fn made(self) -> Result<Basins> {
        let mut basins = self.begin();
        while !basins.done() {
            basins.advance()?;
        }
        Ok(basins)
    }
}

/// Basins, as far as they have been made.
pub struct Basins {
    followers: Followers,
    plane: Plane,
}

struct Plane {
    field: Field,
    cells: Cells,
}

impl Errand for Plane {
    fn field(&self) -> &Field {
        &self.field
    }

    fn next(&mut self) -> Option<Start> {
        let place = self.cells.next()?;
        let (values, x) = self.field.at(&self.field.centre(place));
        Some(Start { place, values, x })
    }

    fn settled(&mut self, place: usize, settled: Settled) {
        self.cells.note(place, settled.fate, settled.amplitude[0]);
    }
}

impl Basins {
    /// Follows some motions a little further.
    ///
    /// # Errors
    /// Parameters with which a motion cannot be followed at all.
    pub fn advance(&mut self) -> Result<()> {
        if !self.followers.advance(&mut self.plane)? {
            self.plane.cells.refine();
        }
        Ok(())
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        self.plane.cells.done()
    }

    /// The part of the cells that is known, 0 … 1.
    pub fn fraction(&self) -> f64 {
        self.plane.cells.made as f64 / self.plane.cells.kind.len() as f64
    }

    /// Where each cell ends, as the number of a [`super::Fate`], row by row from `y.from` up; [`super::UNKNOWN`] where it is
    /// not known yet.
    pub fn kind(&self) -> &[u8] {
        &self.plane.cells.kind
    }

    /// The amplitude of the first state there: 0 at rest, 1000 where it grows without bounds. Of a cell between others
    /// that end alike it lies between theirs.
    pub fn amplitude(&self) -> &[f64] {
        &self.plane.cells.amplitude
    }

    /// How many cells were followed; the others lie between some that end alike.
    pub fn followed(&self) -> usize {
        self.plane.cells.followed
    }

    /// Amplitudes of a kind that are more than this part apart are of two endings: 1 where all are of one.
    pub fn apart(&self) -> f64 {
        if self.plane.field.is_of_starts() { APART } else { 1.0 }
    }

    /// The motions that cells end in, and by cell the place of its own; [`super::UNKNOWN`] where it is not known yet.
    pub fn endings(&self) -> (Vec<Ending>, Vec<u8>) {
        let cells = &self.plane.cells;
        let sorted = cells.endings().sorted();
        let place = |(kind, amplitude): (&u8, &f64)| {
            super::Fate::numbered(*kind).map_or(super::UNKNOWN, |fate| Endings::place(&sorted, fate, *amplitude))
        };
        let places = cells.kind.iter().zip(&cells.amplitude).map(place).collect();
        (sorted, places)
    }
}
