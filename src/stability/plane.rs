//! Two parameters that vary while the others stay, or follow them.

use nalgebra::Complex;

use super::{Links, Polynomial, Ring, Surface, TorsionalTheory, linearised, range};
use crate::{
    Run,
    error::{Code, Error, Result, shown},
    parameter::Parameter,
    run::{Fields, Value},
};

/// How far an axis may reach for curves, over the largest value of its slider, and how narrow it may be, over its values.
const FARTHEST: f64 = 1e3;
const NARROWEST: f64 = 1e-9;

/// A model over a rectangle of two of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    run: Run,
    /// Across, from left to right.
    pub x: Axis,
    /// Along, from below upwards.
    pub y: Axis,
    links: Links,
}

/// A parameter's range on an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Its public name.
    pub parameter: &'static str,
    /// Lower end.
    pub from: f64,
    /// Upper end.
    pub to: f64,
    index: usize,
}

impl Axis {
    /// The range of a parameter of the run's model.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or do not ascend.
    fn of(run: &Run, parameter: &str, from: f64, to: f64) -> Result<Self> {
        let table = run.description().table;
        let index = range::check(table, parameter, [from, to])?;
        if to <= from {
            return Err(Error::new(Code::NotAscending, "to", shown(to), format!("> {} (from)", shown(from))));
        }
        Ok(Self { parameter: table[index].name, from, to, index })
    }

    fn read(run: &Run, fields: &Fields) -> Result<Self> {
        let (parameter, [from, to]) = range::read(fields)?;
        Self::of(run, parameter, from, to)
    }

    /// The value at a part of the way, 0 … 1; the ends are met exactly.
    pub fn value(&self, part: f64) -> f64 {
        if part == 1.0 { self.to } else { self.from + (self.to - self.from) * part }
    }
}

impl Plane {
    /// The gear of `run`, without its own values of the parameters `x` and `y`, each given with its range.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or do not ascend, the same parameter twice.
    pub fn of(run: &Run, x: (&str, f64, f64), y: (&str, f64, f64)) -> Result<Self> {
        let axis =
            |(parameter, from, to), place| Axis::of(run, parameter, from, to).map_err(|error| error.within(place));
        Self::with_axes(run.clone(), axis(x, "x")?, axis(y, "y")?)
    }

    /// With links between the parameters that vary and others.
    #[must_use]
    pub fn linked(self, links: Links) -> Self {
        Self { links, ..self }
    }

    /// The fields that a plane has.
    pub(crate) const KEYS: [&'static str; 8] =
        ["model", "parameters", "friction", "damper", "control", "x", "y", "linked"];

    /// Reads a plane whose axes have `more` fields than parameter and ends; these come back for both.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub(crate) fn read_with<'a>(fields: &Fields<'a>, more: &[&'static str]) -> Result<(Self, [Fields<'a>; 2])> {
        let given = ["model", "parameters", "friction", "damper", "control"];
        let given = given.into_iter().filter_map(|key| Some((key.to_owned(), fields.value(key)?.clone())));
        let run = Run::read(&Value::Record(given.collect()))?;
        let known = [&["parameter", "from", "to"], more].concat();
        let axis = |place: &'static str| {
            let value = fields.value(place).ok_or_else(|| Error::missing(place, "a record {parameter, from, to}"))?;
            let fields = Fields::of(place, value, &known)?;
            let axis = Axis::read(&run, &fields).map_err(|error| error.within(place))?;
            Ok((axis, fields))
        };
        let ((x, more_x), (y, more_y)) = (axis("x")?, axis("y")?);
        let links = Links::read(fields)?;
        links.check(&[x.parameter, y.parameter])?;
        Ok((Self::with_axes(run, x, y)?.linked(links), [more_x, more_y]))
    }

    fn with_axes(run: Run, x: Axis, y: Axis) -> Result<Self> {
        if x.index == y.index {
            let allowed = "another parameter than x.parameter";
            return Err(Error::new(Code::OutOfRange, "y.parameter", y.parameter, allowed));
        }
        Ok(Self { run, x, y, links: Links::default() })
    }

    /// The part of it between parts of the way on both axes.
    pub(super) fn part(&self, x: [f64; 2], y: [f64; 2]) -> Self {
        let part = |axis: Axis, [from, to]: [f64; 2]| Axis { from: axis.value(from), to: axis.value(to), ..axis };
        Self { x: part(self.x, x), y: part(self.y, y), ..self.clone() }
    }

    /// Refuses axes over which rounding would hide where a boundary is: that reach a thousand times as far as what is
    /// sensible for their parameter, or are narrower than a part in 10⁹ of their values.
    ///
    /// # Errors
    /// Such axes.
    pub(super) fn resolved(&self) -> Result<()> {
        for (place, axis) in [("x", &self.x), ("y", &self.y)] {
            let Parameter { min, max, unit, .. } = self.table()[axis.index];
            let most = FARTHEST * min.abs().max(max.abs());
            for (field, value) in [("from", axis.from), ("to", axis.to)] {
                if value.abs() > most {
                    let allowed = format!("within ±{} {unit}: beyond, rounding hides the boundary", shown(most));
                    return Err(Error::new(Code::TooLarge, field, shown(value), allowed).within(place));
                }
            }
            let least = NARROWEST * axis.from.abs().max(axis.to.abs());
            if axis.to - axis.from < least {
                let allowed = format!("more than {} beyond from: nearer, rounding hides the boundary", shown(least));
                return Err(Error::new(Code::OutOfRange, "to", shown(axis.to), allowed).within(place));
            }
        }
        Ok(())
    }

    fn table(&self) -> &'static [Parameter] {
        self.run.description().table
    }

    fn follow<T: Ring>(&self, values: &mut [T]) {
        self.links.follow(self.table(), values, &[self.x.parameter, self.y.parameter]);
    }

    /// The values of all parameters at a point of the unit square, in table order.
    pub fn values(&self, [x, y]: [f64; 2]) -> Vec<f64> {
        let mut values = self.run.parameters().to_vec();
        (values[self.x.index], values[self.y.index]) = (self.x.value(x), self.y.value(y));
        self.follow(&mut values);
        values
    }

    /// The gear at a point of the unit square.
    ///
    /// # Errors
    /// A value that makes another one invalid that is linked to it.
    pub(crate) fn run_at(&self, at: [f64; 2]) -> Result<Run> {
        self.run.clone().with_values(&self.values(at))
    }

    /// The links between its parameters and others.
    pub(crate) fn links(&self) -> Links {
        self.links
    }

    /// The eigenvalues at a point of the unit square that decide on stability, by falling real part.
    ///
    /// # Errors
    /// As [`super::Linearisation::eigenvalues`], and without an equilibrium.
    pub fn eigenvalues(&self, at: [f64; 2]) -> Result<Vec<Complex<f64>>> {
        linearised(&self.run.description(), &self.values(at))?.deciding()
    }

    /// The linear theory over the unit square, where the model has it in closed form.
    pub(super) fn theory(&self) -> Option<TorsionalTheory<Surface>> {
        let mut values: Vec<Surface> = self.run.parameters().iter().map(|value| Surface::from(*value)).collect();
        values[self.x.index] = Surface::across(Polynomial::between(self.x.from, self.x.to));
        values[self.y.index] = Surface::along(Polynomial::between(self.y.from, self.y.to));
        self.follow(&mut values);
        (self.run.description().plane_theory)(&values)
    }
}
