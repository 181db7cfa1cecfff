//! What a map is asked for.

use crate::{
    error::{Code, Error, Result, shown},
    run::{Fields, Value},
    stability::Plane,
};

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
    pub(super) fn any(self) -> bool {
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
    pub(crate) fn whole([columns, rows]: [usize; 2]) -> Self {
        Self { column: 0, row: 0, columns, rows }
    }

    pub(crate) fn read(input: &Value, counts: [usize; 2]) -> Result<Self> {
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
pub(crate) fn whole(fields: &Fields, key: &str, [least, most]: [usize; 2]) -> Result<Option<usize>> {
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
            let count = whole(fields, "count", [1, MOST_CELLS]);
            count
                .and_then(|count| count.ok_or_else(|| Error::missing("count", "a number of cells")))
                .map_err(|error| error.within(place))
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

    /// Where the centre of a cell is on its axis, 0 … 1.
    #[inline(always)]
    pub(super) fn centre(&self, axis: usize, index: usize) -> f64 {
        (index as f64 + 0.5) / self.counts[axis] as f64
    }
}
