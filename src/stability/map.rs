//! Stability over a plane of two parameters, cell by cell.

mod each;
mod rows;
mod spec;

use std::f64::consts::TAU;

use crate::error::{Error, Result};
use rows::Rows;
pub(crate) use spec::whole;
pub use spec::{MOST_CELLS, MapSpec, Quantities, Tile};

impl MapSpec {
    /// The map before its first cell, to be made bit by bit.
    pub fn begin(self) -> StabilityMap {
        let way = match self.plane.theory() {
            Some(theory) => Way::Rows(Box::new(Rows::of(&theory, &self))),
            None => Way::Each,
        };
        StabilityMap { way, cells: Cells::room(self.tile, self.quantities), spec: self }
    }

    /// As [`MapSpec::begin`], by the eigenvalues of every single cell where there is a closed form, too.
    pub fn begin_by_eigenvalues(self) -> StabilityMap {
        StabilityMap { way: Way::Each, cells: Cells::room(self.tile, self.quantities), spec: self }
    }

    /// The map.
    ///
    /// # Errors
    /// As [`StabilityMap::advance`].
    pub fn made(self) -> Result<StabilityMap> {
        let mut map = self.begin();
        while !map.done() {
            map.advance()?;
        }
        Ok(map)
    }
}

/// How the cells are judged.
#[derive(Clone, Debug)]
enum Way {
    /// By the closed form, a row at a time.
    Rows(Box<Rows>),
    /// By eigenvalues, each for itself.
    Each,
}

/// A map, as far as it has been made.
#[derive(Clone, Debug)]
pub struct StabilityMap {
    spec: MapSpec,
    way: Way,
    cells: Cells,
}

/// What a map tells, row by row from `y.from` up, and from `x.from` on in each.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// How many have been made: what the others have beyond means nothing.
    pub made: usize,
    /// 1 where all small motions fade, 0 elsewhere.
    pub stable: Vec<u8>,
    /// The largest real part of an eigenvalue \[1/s\]; empty where it is not wanted, as are the next two.
    pub growth_rate: Vec<f64>,
    /// The frequency of that eigenvalue \[Hz\]; 0 where it is real.
    pub frequency: Vec<f64>,
    /// 1 where it is one of a pair, so that the motion swings; 0 where it is real.
    pub kind: Vec<u8>,
    /// How many are stable.
    pub stable_count: usize,
}

/// What the numbers of [`Cells::kind`] mean.
pub const KINDS: [&str; 2] = ["monotonic", "oscillatory"];

impl Cells {
    /// Without any yet, and with room for all.
    fn room(tile: Tile, wanted: Quantities) -> Self {
        let count = tile.columns * tile.rows;
        let room = |wanted: bool| if wanted { count } else { 0 };
        Self {
            made: 0,
            stable: vec![0; count],
            growth_rate: vec![0.0; room(wanted.growth_rate)],
            frequency: vec![0.0; room(wanted.frequency)],
            kind: vec![0; room(wanted.kind)],
            stable_count: 0,
        }
    }

    /// Notes the eigenvalue that leads a cell; refuses one that is no number.
    #[inline(always)]
    fn note(&mut self, index: usize, real: f64, imaginary: f64) -> Result<()> {
        if !(real + imaginary).is_finite() {
            return Err(Error::beyond_numbers("the growth rate"));
        }
        // What is not wanted has no place.
        if let Some(growth_rate) = self.growth_rate.get_mut(index) {
            *growth_rate = real;
        }
        if let Some(frequency) = self.frequency.get_mut(index) {
            *frequency = imaginary / TAU;
        }
        if let Some(kind) = self.kind.get_mut(index) {
            *kind = u8::from(imaginary > 0.0);
        }
        Ok(())
    }
}

impl StabilityMap {
    /// Makes some more of it: whole rows where there is a closed form, some cells elsewhere.
    ///
    /// # Errors
    /// A cell whose eigenvalues leave the numbers; a model that has no equilibrium there.
    pub fn advance(&mut self) -> Result<()> {
        if self.done() {
            return Ok(());
        }
        match &mut self.way {
            Way::Rows(rows) => {
                // So many cells as take some tenths of a millisecond.
                let stop = self.cells.made + if self.spec.quantities.any() { 8_192 } else { 1 << 20 };
                while self.cells.made < stop.min(self.cells.stable.len()) {
                    rows.advance(&self.spec, &mut self.cells)?;
                }
                Ok(())
            }
            Way::Each => each::advance(&self.spec, &mut self.cells),
        }
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        self.cells.made == self.cells.stable.len()
    }

    /// The part that is made, 0 … 1.
    pub fn fraction(&self) -> f64 {
        self.cells.made as f64 / self.cells.stable.len() as f64
    }

    /// What it was asked for.
    pub fn spec(&self) -> &MapSpec {
        &self.spec
    }

    /// What is there so far.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The share of stable cells among those that are made \[%\]; none before the first.
    pub fn stable_percent(&self) -> Option<f64> {
        let made = self.cells.made;
        (made > 0).then(|| 100.0 * self.cells.stable_count as f64 / made as f64)
    }

    /// The share of the map's area, or its tile's, that the boundary itself makes stable \[%\]; none before the last cell.
    ///
    /// # Errors
    /// As [`super::Plane::stable_area`].
    pub fn stable_area(&self) -> Result<Option<f64>> {
        let MapSpec { plane, counts, tile, .. } = &self.spec;
        let part = |first: usize, many: usize, axis: usize| {
            [first, first + many].map(|edge| edge as f64 / counts[axis] as f64)
        };
        let area = || plane.part(part(tile.column, tile.columns, 0), part(tile.row, tile.rows, 1)).stable_area();
        self.done().then(area).transpose()
    }
}
