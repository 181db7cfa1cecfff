//! Stability over a plane of two parameters, cell by cell.

mod each;
mod rows;

use std::f64::consts::TAU;

use super::{Plane, variation::missing};
use crate::{
    error::{Code, Error, Result, shown},
    run::{Fields, Value},
};
use rows::Rows;

/// Most cells of a map.
pub const MOST_CELLS: usize = 10_000_000;

/// A map to be made: a plane cut into cells, each judged at its centre.
#[derive(Clone, Debug, PartialEq)]
pub struct MapSpec {
    /// The two parameters and what stays.
    pub plane: Plane,
    /// Cells across and along.
    pub counts: [usize; 2],
    /// What is wanted beside the verdict.
    pub quantities: Quantities,
    /// The part of the map that is made.
    pub tile: Tile,
}

/// What a map tells of a cell beside the verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantities {
    /// The largest real part of an eigenvalue.
    pub growth_rate: bool,
    /// The frequency of that eigenvalue.
    pub frequency: bool,
    /// Whether it is one of a pair.
    pub kind: bool,
}

impl Default for Quantities {
    fn default() -> Self {
        Self { growth_rate: true, frequency: false, kind: false }
    }
}

impl Quantities {
    fn read(input: &Value) -> Result<Self> {
        const KNOWN: [&str; 4] = ["stable", "growthRate", "frequency", "kind"];
        let names = match input {
            Value::Texts(names) => names.as_slice(),
            Value::Numbers(none) if none.is_empty() => &[],
            other => {
                let allowed = "a list of names, such as ['stable', 'growthRate']";
                return Err(Error::new(Code::WrongType, "quantities", other.shown(), allowed));
            }
        };
        if let Some(name) = names.iter().find(|name| !KNOWN.contains(&name.as_str())) {
            return Err(Error::unknown(Code::UnknownName, "quantities", name, &KNOWN));
        }
        let wanted = |name: &str| names.iter().any(|wanted| wanted == name);
        Ok(Self { growth_rate: wanted("growthRate"), frequency: wanted("frequency"), kind: wanted("kind") })
    }

    /// Whether anything is wanted but the verdict.
    fn any(self) -> bool {
        self.growth_rate || self.frequency || self.kind
    }
}

/// A part of a map: so many columns and rows of cells from a first one on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// First column.
    pub column: usize,
    /// First row.
    pub row: usize,
    /// Columns.
    pub columns: usize,
    /// Rows.
    pub rows: usize,
}

impl Tile {
    /// The whole of a map.
    fn whole([columns, rows]: [usize; 2]) -> Self {
        Self { column: 0, row: 0, columns, rows }
    }

    fn read(input: &Value, counts: [usize; 2]) -> Result<Self> {
        let fields = Fields::of("tile", input, &["column", "row", "columns", "rows"])?;
        let part = |first: &str, many: &str, count: usize| {
            let first = whole(&fields, first, [0, count - 1])?.unwrap_or(0);
            Ok((first, whole(&fields, many, [1, count - first])?.unwrap_or(count - first)))
        };
        let read = || {
            let ((column, columns), (row, rows)) =
                (part("column", "columns", counts[0])?, part("row", "rows", counts[1])?);
            Ok(Self { column, row, columns, rows })
        };
        read().map_err(|error: Error| error.within("tile"))
    }
}

/// A field that holds a whole number between two others.
fn whole(fields: &Fields, key: &str, [least, most]: [usize; 2]) -> Result<Option<usize>> {
    let allowed = format!("a whole number from {least} to {}", shown(most as f64));
    let Some(number) = fields.number(key, &allowed)? else { return Ok(None) };
    if number.fract() == 0.0 && (least as f64..=most as f64).contains(&number) {
        return Ok(Some(number as usize));
    }
    let code = if number > most as f64 { Code::TooLarge } else { Code::OutOfRange };
    Err(Error::new(code, key, shown(number), allowed))
}

impl MapSpec {
    /// A map of `columns` × `rows` cells with the growth rate.
    ///
    /// # Errors
    /// No cells, or more than 10⁷.
    pub fn of(plane: Plane, columns: usize, rows: usize) -> Result<Self> {
        let (counts, allowed) = ([columns, rows], "a whole number from 1 to 10000000");
        for (place, count) in ["x.count", "y.count"].into_iter().zip(counts) {
            if !(1..=MOST_CELLS).contains(&count) {
                return Err(Error::new(Code::OutOfRange, place, count.to_string(), allowed));
            }
        }
        if columns.saturating_mul(rows) > MOST_CELLS {
            let allowed = format!("at most {} with {columns} cells across (x.count)", MOST_CELLS / columns);
            return Err(Error::new(Code::TooLarge, "y.count", rows.to_string(), allowed));
        }
        Ok(Self { plane, counts, quantities: Quantities::default(), tile: Tile::whole(counts) })
    }

    /// Reads a record `{model, parameters, x: {parameter, from, to, count}, y, quantities, tile, linked}`.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("map", input, &[Plane::KEYS.as_slice(), &["quantities", "tile"]].concat())?;
        let (plane, axes) = Plane::read_with(&fields, &["count"])?;
        let count = |fields: &Fields, place| {
            let count = whole(fields, "count", [1, MOST_CELLS])?;
            count.ok_or_else(|| missing("count", "a number of cells")).map_err(|error| error.within(place))
        };
        let mut map = Self::of(plane, count(&axes[0], "x")?, count(&axes[1], "y")?)?;
        if let Some(quantities) = fields.value("quantities") {
            map.quantities = Quantities::read(quantities)?;
        }
        if let Some(tile) = fields.value("tile") {
            map.tile = Tile::read(tile, map.counts)?;
        }
        Ok(map)
    }

    /// With other quantities.
    #[must_use]
    pub fn with(self, quantities: Quantities) -> Self {
        Self { quantities, ..self }
    }

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

    /// Where the centre of a cell is on its axis, 0 … 1.
    #[inline(always)]
    fn centre(&self, axis: usize, index: usize) -> f64 {
        (index as f64 + 0.5) / self.counts[axis] as f64
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
            growth_rate: Vec::with_capacity(room(wanted.growth_rate)),
            frequency: Vec::with_capacity(room(wanted.frequency)),
            kind: Vec::with_capacity(room(wanted.kind)),
            stable_count: 0,
        }
    }

    /// Notes the eigenvalue that leads a cell; refuses one that is no number.
    #[inline(always)]
    fn push_leading(&mut self, wanted: Quantities, real: f64, imaginary: f64) -> Result<()> {
        if !(real + imaginary).is_finite() {
            let allowed = "a finite number: choose less extreme values";
            return Err(Error::new(Code::NotFinite, "the growth rate", shown(real), allowed));
        }
        if wanted.growth_rate {
            self.growth_rate.push(real);
        }
        if wanted.frequency {
            self.frequency.push(imaginary / TAU);
        }
        if wanted.kind {
            self.kind.push(u8::from(imaginary > 0.0));
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
    /// As [`Plane::stable_area`].
    pub fn stable_area(&self) -> Result<Option<f64>> {
        let MapSpec { plane, counts, tile, .. } = &self.spec;
        let part = |first: usize, many: usize, axis: usize| {
            [first, first + many].map(|edge| edge as f64 / counts[axis] as f64)
        };
        let area = || plane.part(part(tile.column, tile.columns, 0), part(tile.row, tile.rows, 1)).stable_area();
        self.done().then(area).transpose()
    }
}
