//! All curves of folds in a plane of two parameters.

use std::rc::Rc;

use super::{
    Bifurcation, BifurcationSpec, PointKind,
    bordered::{Sheet, Spot},
    family::{Family, RunAt, family},
    fold::{FoldEnd, FoldWalk},
    newton::{Chart, Place},
    passes,
};
use crate::{
    error::{Code, Error, Result, shown},
    run::{Fields, Value},
    stability::{Plane, Variation},
};

/// Rows, and columns, of the plane along which folds are looked for, and most of them.
const SEEDS: usize = 4;
const MOST_SEEDS: usize = 100;
/// A fold is on a curve where it is as near as this: parts of the plane, and of the cycle's amplitude.
const KNOWN: f64 = 0.01;
/// Where a fold is this much smaller than the largest of its curve, it is that of a cycle at its birth.
const REST: f64 = 0.01;

/// Curves of folds to be followed.
#[derive(Clone, Debug, PartialEq)]
pub struct FoldSpec {
    /// The two parameters and what stays.
    pub plane: Plane,
    /// Rows, and columns, of the plane whose diagrams are made to find folds.
    pub seeds: usize,
}

/// A curve in a plane at which two limit cycles meet and vanish. It ends at the rectangle's edge, on it exactly, or where the
/// cycle has no size any more, or where no next one is found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FoldCurve {
    /// Values of the parameter across.
    pub x: Vec<f64>,
    /// Values of the parameter along.
    pub y: Vec<f64>,
    /// Of the cycle \[Hz\].
    pub frequency: Vec<f64>,
    /// Largest |·| of its first state.
    pub amplitude: Vec<f64>,
    /// It comes back to where it began: the last point is the first.
    pub closed: bool,
    /// All other multipliers are within the unit circle: one of the two cycles is stable.
    pub bounds: bool,
}

impl FoldSpec {
    /// Those of a plane, looked for along four rows and four columns.
    pub fn of(plane: Plane) -> Self {
        Self { plane, seeds: SEEDS }
    }

    /// Reads a record `{model, parameters, x: {parameter, from, to}, y, linked, seeds}`; a `count` of the axes may be there.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let fields = Fields::of("plane", input, &[Plane::KEYS.as_slice(), &["seeds"]].concat())?;
        let mut spec = Self::of(Plane::read_with(&fields, &["count"])?.0);
        let allowed = format!("a whole number from 1 to {MOST_SEEDS}");
        if let Some(seeds) = fields.number("seeds", &allowed)? {
            if seeds.fract() != 0.0 || !(1.0..=MOST_SEEDS as f64).contains(&seeds) {
                return Err(Error::new(Code::OutOfRange, "seeds", shown(seeds), allowed));
            }
            spec.seeds = seeds as usize;
        }
        Ok(spec)
    }

    /// The curves before the first, to be followed bit by bit.
    ///
    /// # Errors
    /// Parameters so extreme that the equations leave the numbers.
    pub fn begin(self) -> Result<FoldCurves> {
        let plane = self.plane.clone();
        let part = |axis: crate::stability::Axis, value: f64| (value - axis.from) / (axis.to - axis.from);
        let run_at: RunAt = Rc::new(move |x, y| plane.run_at([part(plane.x, x), part(plane.y, y)]));
        let family = family(&run_at, [self.plane.x.from, self.plane.y.from])?;
        Ok(FoldCurves { spec: self, family, done: 0, work: Work::Next, seeds: Vec::new(), curves: Vec::new() })
    }

    /// The curves.
    ///
    /// # Errors
    /// As [`FoldSpec::begin`] and [`FoldCurves::advance`].
    pub fn made(self) -> Result<FoldCurves> {
        let mut curves = self.begin()?;
        while !curves.done() {
            curves.advance()?;
        }
        Ok(curves)
    }
}

/// What is under way.
enum Work {
    Next,
    Diagram(Box<Bifurcation>),
    /// A curve from a seed, and what was found the other way.
    Curve {
        seed: Seed,
        walk: Box<FoldWalk>,
        before: Option<Box<FoldWalk>>,
    },
}

/// A fold of a diagram.
#[derive(Clone)]
struct Seed {
    spot: Spot,
    sign: f64,
    amplitude: f64,
}

/// Curves of folds, as far as they have been followed.
pub struct FoldCurves {
    spec: FoldSpec,
    family: Box<dyn Family>,
    /// Diagrams that are done: rows first, then columns.
    done: usize,
    work: Work,
    seeds: Vec<Seed>,
    curves: Vec<FoldCurve>,
}

impl FoldCurves {
    /// Goes on a bit: a point of a diagram, or of a curve.
    ///
    /// # Errors
    /// As [`Bifurcation::advance`].
    pub fn advance(&mut self) -> Result<()> {
        match std::mem::replace(&mut self.work, Work::Next) {
            Work::Diagram(mut diagram) => {
                diagram.advance()?;
                if diagram.done() {
                    self.harvest(&diagram);
                    self.done += 1;
                } else {
                    self.work = Work::Diagram(diagram);
                }
            }
            Work::Curve { seed, mut walk, before } => match walk.advance(&mut *self.family)? {
                None if walk.has_shrunk(REST) => self.ends(seed, walk, before, FoldEnd::Edge)?,
                None => self.work = Work::Curve { seed, walk, before },
                Some(end) => self.ends(seed, walk, before, end)?,
            },
            Work::Next => {
                if let Some(seed) = self.seeds.pop() {
                    self.set_out(seed, None)?;
                } else if self.done < 2 * self.spec.seeds {
                    self.work = Work::Diagram(Box::new(self.diagram()?.begin()?));
                }
            }
        }
        Ok(())
    }

    /// What its curves, or the diagram under way, have cost so far.
    #[cfg(test)]
    pub(super) fn work(&mut self) -> [u64; 2] {
        [self.family.flow().work(), if let Work::Diagram(diagram) = &mut self.work { diagram.work() } else { 0 }]
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        matches!(self.work, Work::Next) && self.seeds.is_empty() && self.done == 2 * self.spec.seeds
    }

    /// The part that is made, 0 … 1, as far as that can be said.
    pub fn fraction(&self) -> f64 {
        if self.done() {
            return 1.0;
        }
        let way = if let Work::Diagram(diagram) = &self.work { diagram.fraction() } else { 0.0 };
        ((self.done as f64 + way) / (2 * self.spec.seeds) as f64).min(0.99)
    }

    /// The curves that are complete.
    pub fn curves(&self) -> &[FoldCurve] {
        &self.curves
    }

    /// The next row's or column's diagram.
    fn diagram(&self) -> Result<BifurcationSpec> {
        let Plane { x, y, .. } = &self.spec.plane;
        let place = self.done % self.spec.seeds;
        let part = (place as f64 + 0.5) / self.spec.seeds as f64;
        let (along, at) = if self.done < self.spec.seeds { (x, [0.0, part]) } else { (y, [part, 0.0]) };
        let links = self.spec.plane.links();
        let variation = Variation {
            relaxation_length_follows: links.relaxation_length,
            tread_width_moment_constant_follows: links.tread_width_moment_constant,
            ..Variation::of(along.parameter, along.from, along.to)
        };
        Ok(BifurcationSpec::of(self.spec.plane.run_at(at)?, variation))
    }

    /// Takes the folds of a diagram as seeds.
    fn harvest(&mut self, diagram: &Bifurcation) {
        let Plane { x, y, .. } = &self.spec.plane;
        let part = (self.done % self.spec.seeds) as f64 + 0.5;
        let part = part / self.spec.seeds as f64;
        let row = self.done < self.spec.seeds;
        let branches = diagram.cycles();
        for point in diagram.points().iter().filter(|point| point.kind == PointKind::Fold) {
            let Some(branch) = point.branch else { continue };
            let cycle = &branches[branch].points[point.index];
            let (value, other) = if row { (cycle.value, y.value(part)) } else { (x.value(part), cycle.value) };
            let sign = if cycle.symmetric { -1.0 } else { 1.0 };
            let time = cycle.period * if cycle.symmetric { 0.5 } else { 1.0 };
            let place = Place { x: diagram.scaled(&cycle.state), time, value };
            self.seeds.push(Seed { spot: Spot { place, other }, sign, amplitude: cycle.amplitude[0] });
        }
    }

    /// Begins the curve through a fold, unless it is known.
    fn set_out(&mut self, seed: Seed, before: Option<Box<FoldWalk>>) -> Result<()> {
        if before.is_none() && self.curves.iter().any(|curve| self.has(curve, &seed)) {
            return Ok(());
        }
        let Plane { x, y, .. } = &self.spec.plane;
        let period = seed.spot.place.time * if seed.sign < 0.0 { 2.0 } else { 1.0 };
        self.family.flow().pace(period, 1.0);
        self.family.aside(seed.spot.other);
        if !self.family.vary(seed.spot.place.value) {
            return Ok(());
        }
        let size = self.family.flow().swing(&seed.spot.place.x, period)?.size;
        let chart = Chart { sign: seed.sign, size, low: x.from, high: x.to };
        let sheet = Sheet { chart, low: y.from, high: y.to };
        let walk = Box::new(FoldWalk::from(&sheet, &seed.spot, before.is_some()));
        self.work = Work::Curve { seed, walk, before };
        Ok(())
    }

    /// What is to be done where a curve ends.
    fn ends(&mut self, seed: Seed, walk: Box<FoldWalk>, before: Option<Box<FoldWalk>>, end: FoldEnd) -> Result<()> {
        match before {
            None if walk.stops.is_empty() => Ok(()),
            Some(before) if walk.stops.is_empty() => {
                self.note(&before, None, false);
                Ok(())
            }
            None if end != FoldEnd::Closed => self.set_out(seed, Some(walk)),
            before => {
                self.note(&walk, before.as_deref(), end == FoldEnd::Closed);
                Ok(())
            }
        }
    }

    /// Adds a curve: back along one walk, and on along the one before.
    fn note(&mut self, walk: &FoldWalk, before: Option<&FoldWalk>, closed: bool) {
        let on = before.map_or(&[][..], |before| before.stops.get(1..).unwrap_or_default());
        let mut curve = FoldCurve { closed, bounds: true, ..FoldCurve::default() };
        for (stop, other) in walk.stops.iter().rev().chain(on) {
            curve.x.push(stop.point.value);
            curve.y.push(*other);
            curve.frequency.push(1.0 / stop.point.period);
            curve.amplitude.push(stop.point.amplitude[0]);
            let others = &stop.point.multipliers[1..];
            let from_one = |i: usize| (others[i] - 1.0).norm();
            let fold = (0..others.len()).fold(0, |best, i| if from_one(i) < from_one(best) { i } else { best });
            curve.bounds &= others.iter().enumerate().all(|(i, value)| i == fold || value.norm() < 1.0);
        }
        if closed {
            for column in [&mut curve.x, &mut curve.y, &mut curve.frequency, &mut curve.amplitude] {
                let last = column.len() - 1;
                column[0] = column[last];
            }
        }
        if curve.x.len() > 1 {
            self.curves.push(curve);
        }
    }

    /// Whether a fold is on a curve.
    fn has(&self, curve: &FoldCurve, seed: &Seed) -> bool {
        let Plane { x, y, .. } = &self.spec.plane;
        let at = |value: f64, other: f64, amplitude: f64| {
            [(value - x.from) / (x.to - x.from), (other - y.from) / (y.to - y.from), amplitude.ln()]
        };
        let of = |i: usize| at(curve.x[i], curve.y[i], curve.amplitude[i]);
        let seed = at(seed.spot.place.value, seed.spot.other, seed.amplitude);
        (1..curve.x.len()).any(|i| passes(&of(i - 1), &of(i), &seed, KNOWN))
    }
}
