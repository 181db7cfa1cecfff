//! Bifurcation diagrams: rest and cycles of a gear over the range of a parameter, with the places where they change.
//!
//! Rest is looked at value by value, and every crossing of eigenvalues is found ([`crate::stability::Crossing`]). From each
//! Hopf point the branch of cycles that is born there is followed by pseudo-arclength: shooting in the start, the period and
//! the parameter at once, stable or not, through folds, to where the branch ends ([`BranchEnd`]). Cycles that no such branch
//! has are looked for by simulation, and followed both ways. A special point is a change of sign of a test between two cycles,
//! located there. Two parameters have curves of folds ([`FoldCurve`]).

mod family;
mod fold;
mod folds;
mod hopf;
mod line;
mod newton;
mod rest;
mod spec;
mod special;
mod walk;

#[cfg(test)]
mod tests;

use std::rc::Rc;

use self::{
    family::{Family, RunAt, family},
    hopf::{AtRest, Hopf},
    line::Line,
    newton::{Chart, Place},
    walk::{Limits, Stop, Walk},
};
pub use self::{
    folds::{FoldCurve, FoldCurves, FoldSpec},
    hopf::{Criticality, Told},
    rest::RestBranch,
    spec::BifurcationSpec,
    special::PointKind,
    walk::{BranchEnd, CyclePoint},
};
use super::{
    shooting::{self, Periodic},
    vector::{axis, dot, norm, sum, vector},
};
use crate::{
    error::{Code, Error, Result, shown},
    few::sort_few,
    parameter::StateVariable,
    stability::{Crossing, CurveKind},
};
use nalgebra::Complex;

/// Starts of simulations, in units of the first state's typical size: one for what grows from rest, and others.
const SMALL: f64 = 0.01;
const LADDER: [f64; 3] = [0.2, 1.0, 5.0];

/// How far ahead a simulation looks for a cycle \[s\].
const HORIZON: f64 = 6.0;
/// A cycle is one of a branch where amplitude and period are as near as this to what its neighbours there have between them.
const KNOWN: f64 = 0.02;
/// A branch that is as near to rest as this, in units of typical sizes, may end at a Hopf point whose frequency is as near,
/// and whose value is as near in parts of the range.
const DYING: f64 = 0.05;
const SAME_FREQUENCY: f64 = 0.03;
const SAME_VALUE: f64 = 0.02;

/// Whether a point lies on the straight way between two others, or nearly so.
fn passes(from: &[f64], to: &[f64], point: &[f64], near: f64) -> bool {
    let (step, home) = (sum(to, -1.0, from), sum(point, -1.0, from));
    let along = dot(&step, &home) / dot(&step, &step);
    let aside = sum(&home, -along, &step);
    (0.0..=1.0).contains(&along) && norm(&aside) < near
}

/// A branch of cycles.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleBranch {
    /// Its cycles, in their order.
    pub points: Vec<CyclePoint>,
    /// What is at its two ends.
    pub ends: [BranchEnd; 2],
}

/// A special point.
#[derive(Clone, Debug, PartialEq)]
pub struct SpecialPoint {
    /// What happens there.
    pub kind: PointKind,
    /// The parameter.
    pub value: f64,
    /// Largest |·| of the first state: 0 at rest.
    pub amplitude: f64,
    /// Of the cycle, or of the eigenvalues that cross \[Hz\].
    pub frequency: f64,
    /// Which of the branches of cycles it is on, or is born at it; none where there is no such branch.
    pub branch: Option<usize>,
    /// Its place on that branch, or among the values of rest.
    pub index: usize,
    /// Of a Hopf point: which way its branch goes, and what tells that.
    pub criticality: Option<(Criticality, Told)>,
    /// Of a Hopf point: by how much the growth rate of a swing changes with the square of the first state's amplitude
    /// \[1/s over the state's unit squared\], where the laws are smooth around rest.
    pub lyapunov: Option<f64>,
}

/// Where a branch began.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    Hopf(usize),
    Cycle,
}

/// What is to be done.
#[derive(Clone, Copy, Debug)]
enum Task {
    Rest,
    Hopf(usize),
    Guess,
    /// Which value, and which start there.
    Probe(usize, usize),
}

/// A branch on its way.
struct Trip {
    walk: Walk,
    from: Origin,
    /// The other way from the same cycle, where that is done: with its end, and the Hopf point where that is one.
    before: Option<(Walk, BranchEnd, Option<usize>)>,
}

/// A Hopf point with the branch that is born there.
struct Birth {
    hopf: Option<Hopf>,
    crossing: Crossing,
    /// Which branch, and whether it ends there.
    branch: Option<(usize, bool)>,
}

/// A bifurcation diagram, as far as it has been made.
///
/// # Limits
/// Rest is the state that Newton's method finds from 0, whatever else the gear may rest at; other branches that begin at a
/// branch point or a period doubling are not followed. A branch that no Hopf point of the range begins, and no start of a
/// simulation at one of the values looked at leads to, is missed.
///
/// # Example
/// ```
/// use shimmy::{Run, cycles::{BifurcationSpec, PointKind}, stability::Variation};
///
/// // A wheel that leads its axis, on a tire whose aligning moment goes on growing: it shakes before rest is unstable.
/// let gear = Run::of("torsional")?.with("casterLength", -0.06)?.with("aligningMomentLimitAngle", 40_f64.to_radians())?;
/// let diagram = BifurcationSpec::of(gear, Variation::of("velocity", 10.0, 120.0)).made()?;
/// let at = |kind| diagram.points().iter().filter(|point| point.kind == kind).map(|point| point.value).fold(120.0, f64::min);
/// assert!((at(PointKind::Hopf) - 53.402).abs() < 1e-3); // m/s
/// assert!((at(PointKind::Fold) - 36.225).abs() < 1e-3);
/// # Ok::<(), shimmy::Error>(())
/// ```
pub struct Bifurcation {
    spec: BifurcationSpec,
    line: Rc<Line>,
    family: Box<dyn Family>,
    rest: RestBranch,
    crossings: Vec<f64>,
    divergences: Vec<Crossing>,
    births: Vec<Birth>,
    cycles: Vec<CycleBranch>,
    points: Vec<SpecialPoint>,
    tasks: Vec<Task>,
    done: usize,
    trip: Option<Trip>,
}

impl BifurcationSpec {
    /// The diagram before its first point, to be made bit by bit.
    ///
    /// # Errors
    /// An unknown parameter, ends that are not valid for it or the same, a guess outside of the range; parameters so extreme
    /// that the equations leave the numbers.
    pub fn begin(self) -> Result<Bifurcation> {
        let line = Rc::new(Line::of(self.run.clone(), self.variation.clone())?);
        let of = Rc::clone(&line);
        let run_at: RunAt = Rc::new(move |value, _| of.run_at(value));
        let family = family(&run_at, [line.from(), 0.0])?;
        if let Some((guess, value)) = &self.cycle {
            guess.clone().checked(&self.run).map_err(|error| error.within("cycle"))?;
            if !(line.from()..=line.to()).contains(value) {
                let allowed = format!("from {} to {}", shown(line.from()), shown(line.to()));
                return Err(Error::new(Code::OutOfRange, "cycle.value", shown(*value), allowed));
            }
        }
        let rest = RestBranch::of(self.run.description().state.len());
        Ok(Bifurcation {
            spec: self,
            line,
            family,
            rest,
            crossings: Vec::new(),
            divergences: Vec::new(),
            births: Vec::new(),
            cycles: Vec::new(),
            points: Vec::new(),
            tasks: vec![Task::Rest],
            done: 0,
            trip: None,
        })
    }

    /// The diagram.
    ///
    /// # Errors
    /// As [`BifurcationSpec::begin`] and [`Bifurcation::advance`].
    pub fn made(self) -> Result<Bifurcation> {
        let mut diagram = self.begin()?;
        while !diagram.done() {
            diagram.advance()?;
        }
        Ok(diagram)
    }
}

impl Bifurcation {
    /// Makes some more of it: a cycle, a simulation, some values of rest. A cycle that leaves the numbers ends its branch.
    ///
    /// # Errors
    /// Values at which the eigenvalues leave the numbers; a gear that has no equilibrium there.
    pub fn advance(&mut self) -> Result<()> {
        if let Some(mut trip) = self.trip.take() {
            let before = trip.walk.stops.len();
            let end = trip.walk.advance(&mut *self.family).map(|end| (end, None));
            let arrives = if trip.walk.stops.len() > before { self.arrives(&trip) } else { None };
            match end.or(arrives.map(|birth| (BranchEnd::Hopf, Some(birth)))) {
                Some((end, birth)) => self.ends(trip, end, birth),
                None => self.trip = Some(trip),
            }
            return Ok(());
        }
        let Some(task) = self.tasks.get(self.done).copied() else { return Ok(()) };
        match task {
            Task::Rest => {
                if self.rest.value.is_empty() {
                    self.look_at_crossings()?;
                }
                if self.rest.advance(&self.line, &self.crossings)? {
                    return Ok(());
                }
                self.note_rest();
            }
            Task::Hopf(birth) => self.set_out_from_hopf(birth),
            Task::Guess => {
                if let Some((guess, value)) = self.spec.cycle.clone() {
                    let x = self.scaled(&guess.state);
                    self.vary(value, guess.period);
                    if let Ok(Some(found)) = shooting::periodic(self.family.flow(), &x, guess.period) {
                        self.set_out(found, value);
                    }
                }
            }
            Task::Probe(place, start) => self.probe(place, start)?,
        }
        self.done += 1;
        Ok(())
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        self.done == self.tasks.len() && self.trip.is_none()
    }

    /// The part that is made, 0 … 1, as far as that can be said.
    pub fn fraction(&self) -> f64 {
        if self.done() {
            return 1.0;
        }
        // Of the first task the others are not known yet, and a branch is as long as it is.
        let known = self.tasks.len().max(4) as f64;
        let way = self.trip.as_ref().map_or(0.0, |trip| {
            let before = trip.before.as_ref().map_or(0, |_| self.spec.points);
            let ways = if trip.from == Origin::Cycle { 2.0 } else { 1.0 };
            (before + trip.walk.stops.len()) as f64 / (ways * self.spec.points as f64)
        });
        let begun = if self.trip.is_some() { self.done.saturating_sub(1) } else { self.done };
        ((begun as f64 + 0.9 * way.min(1.0)) / known).min(0.99)
    }

    /// The gear, and its parameter's range.
    pub fn spec(&self) -> &BifurcationSpec {
        &self.spec
    }

    /// The parameter's public name.
    pub fn parameter(&self) -> &'static str {
        self.line.parameter()
    }

    /// The gear at rest, so far.
    pub fn rest(&self) -> &RestBranch {
        &self.rest
    }

    /// The branches of cycles, so far: the one that is on its way last.
    pub fn cycles(&self) -> Vec<CycleBranch> {
        let under_way = self.trip.as_ref().map(|trip| self.branch(trip, BranchEnd::Points, None));
        self.cycles.iter().cloned().chain(under_way.map(|(branch, _)| branch)).collect()
    }

    /// The special points, so far: those of rest by rising value, then those of each branch in their order.
    pub fn points(&self) -> &[SpecialPoint] {
        &self.points
    }

    fn states(&self) -> &'static [StateVariable] {
        self.spec.run.description().state
    }

    fn scaled(&self, x: &[f64]) -> Vec<f64> {
        let states = self.states();
        vector(x.len(), &|i| x[i] / states[i].scale)
    }

    fn vary(&mut self, value: f64, period: f64) -> bool {
        self.family.flow().pace(period, 1.0);
        self.family.vary(value)
    }

    /// Finds what crosses the axis, and plans what follows from it.
    fn look_at_crossings(&mut self) -> Result<()> {
        let crossings = self.line.run().crossings(self.line.variation())?;
        self.crossings = crossings.iter().map(|crossing| crossing.value).collect();
        self.crossings.dedup();
        for crossing in crossings {
            if crossing.kind == CurveKind::Hopf {
                let line = &self.line;
                let gear = AtRest {
                    rest: &|value| line.rest(value),
                    scales: vector(self.states().len(), &|i| self.states()[i].scale),
                    low: line.from(),
                    high: line.to(),
                };
                let hopf = Hopf::of(&mut *self.family, &gear, &crossing)?;
                self.tasks.push(Task::Hopf(self.births.len()));
                self.births.push(Birth { hopf, crossing, branch: None });
            } else {
                self.divergences.push(crossing);
            }
        }
        if self.spec.cycle.is_some() {
            self.tasks.push(Task::Guess);
        }
        let probes = (0..self.spec.probes).flat_map(|place| (0..=LADDER.len()).map(move |start| (place, start)));
        self.tasks.extend(probes.map(|(place, start)| Task::Probe(place, start)));
        Ok(())
    }

    /// The special points of rest, by rising value.
    fn note_rest(&mut self) {
        let place = |value: f64| self.rest.value.iter().position(|other| *other == value).unwrap_or(0);
        let point = |crossing: &Crossing, kind| SpecialPoint {
            kind,
            value: crossing.value,
            amplitude: self.rest.states[0].get(place(crossing.value)).map_or(0.0, |x| x.abs()),
            frequency: crossing.frequency,
            branch: None,
            index: place(crossing.value),
            criticality: None,
            lyapunov: None,
        };
        let unit = self.states()[0].scale;
        let hopfs = self.births.iter().map(|birth| SpecialPoint {
            criticality: birth.hopf.as_ref().and_then(|hopf| hopf.criticality(&[])),
            lyapunov: birth.hopf.as_ref().map(|hopf| hopf.lyapunov / (unit * unit)),
            ..point(&birth.crossing, PointKind::Hopf)
        });
        let divergences = self.divergences.iter().map(|crossing| point(crossing, PointKind::Divergence));
        let mut points: Vec<SpecialPoint> = hopfs.chain(divergences).collect();
        sort_few(&mut points, |a, b| a.value < b.value);
        self.points = points;
    }

    /// Begins the branch that is born at a Hopf point, unless another one has come there.
    fn set_out_from_hopf(&mut self, birth: usize) {
        let Birth { hopf: Some(hopf), branch: None, .. } = &self.births[birth] else { return };
        if hopf.is_linear() {
            return;
        }
        if let Some((solved, chart, ahead)) = hopf.first(&mut *self.family, self.line.from(), self.line.to())
            && let Ok(start) = Stop::of(&mut *self.family, &chart, solved, &ahead)
        {
            self.trip = Some(Trip { walk: Walk::new(start, self.limits()), from: Origin::Hopf(birth), before: None });
        }
    }

    fn limits(&self) -> Limits {
        Limits { points: self.spec.points, step: self.spec.step, tolerance: self.spec.tolerance }
    }

    /// Looks from a start at a value for a cycle that no branch has.
    fn probe(&mut self, place: usize, start: usize) -> Result<()> {
        let part = (place as f64 + 0.5) / self.spec.probes as f64;
        let value = self.line.from() + self.line.width() * part;
        let rest = self.line.rest(value)?;
        // The smallest start is for what grows.
        let size = match start.checked_sub(1) {
            Some(start) => LADDER[start],
            None if rest.eigenvalues()?[0].re > 0.0 => SMALL,
            None => return Ok(()),
        };
        let mut x = self.scaled(&rest.equilibrium);
        x[0] += size;
        if !self.vary(value, 1.0) {
            return Ok(());
        }
        // A motion that leaves the numbers settles nowhere.
        let Ok(Some((x, between))) = self.family.settled(&x, HORIZON) else { return Ok(()) };
        self.family.flow().pace(between, 1.0);
        if let Ok(Some(found)) = super::settled(self.family.flow(), &x, between) {
            self.set_out(found, value);
        }
        Ok(())
    }

    /// Begins the branch through a cycle, unless it is known.
    fn set_out(&mut self, found: Periodic, value: f64) {
        let Ok(swing) = self.family.flow().swing(&found.x, found.period) else { return };
        if self.knows(value, swing.amplitude[0], found.period) {
            return;
        }
        let sign = if found.symmetric { -1.0 } else { 1.0 };
        let chart = Chart { sign, size: swing.size, low: self.line.from(), high: self.line.to() };
        let time = if found.symmetric { 0.5 * found.period } else { found.period };
        let along = axis(found.x.len() + 2, found.x.len() + 1);
        let place = Place { x: found.x, time, value };
        let limits = self.limits();
        let walk = Walk::at(&mut *self.family, &chart, &place, &along, limits).unwrap_or_default();
        self.trip = walk.map(|walk| Trip { walk, from: Origin::Cycle, before: None });
    }

    /// Whether a branch has this cycle.
    fn knows(&self, value: f64, amplitude: f64, period: f64) -> bool {
        let between = |a: &CyclePoint, b: &CyclePoint| {
            let part = if a.value == b.value { 0.0 } else { (value - a.value) / (b.value - a.value) };
            let mixed = |a: f64, b: f64| a + (b - a) * part;
            let near = |got: f64, expected: f64| (got / expected - 1.0).abs() < KNOWN;
            (0.0..=1.0).contains(&part)
                && near(mixed(a.amplitude[0], b.amplitude[0]), amplitude)
                && near(mixed(a.period, b.period), period)
        };
        self.cycles.iter().any(|branch| branch.points.windows(2).any(|pair| between(&pair[0], &pair[1])))
    }

    /// The Hopf point at which the branch dies that is on its way, if it does.
    fn arrives(&self, trip: &Trip) -> Option<usize> {
        let [.., before, last] = trip.walk.stops.as_slice() else { return None };
        if !(last.chart.size < DYING && last.chart.size < before.chart.size) {
            return None;
        }
        let away = |birth: &Birth| {
            let frequency = last.point.period * birth.crossing.frequency - 1.0;
            let value = (last.point.value - birth.crossing.value).abs() / self.line.width();
            (frequency.abs() < SAME_FREQUENCY && value < SAME_VALUE).then_some(value)
        };
        let near = self.births.iter().enumerate().filter_map(|(i, birth)| Some((i, away(birth)?)));
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    }

    /// What is to be done where a branch ends.
    fn ends(&mut self, trip: Trip, end: BranchEnd, birth: Option<usize>) {
        if trip.from == Origin::Cycle && trip.before.is_none() && end != BranchEnd::Closed {
            // The other way from the same cycle; where it died there is none to come.
            let back = trip.walk.turned();
            let index = self.cycles.len();
            if let Some(birth) = birth {
                self.births[birth].branch = Some((index, true));
            }
            self.trip = Some(Trip { walk: back, from: Origin::Cycle, before: Some((trip.walk, end, birth)) });
            return;
        }
        let index = self.cycles.len();
        let (branch, special) = self.branch(&trip, end, birth);
        if let Origin::Hopf(birth) = trip.from {
            self.births[birth].branch = Some((index, false));
        }
        if let Some(birth) = birth {
            self.births[birth].branch = Some((index, trip.from != Origin::Cycle));
        }
        for (kind, place) in special {
            let point = &branch.points[place];
            self.points.push(SpecialPoint {
                kind,
                value: point.value,
                amplitude: point.amplitude[0],
                frequency: 1.0 / point.period,
                branch: Some(index),
                index: place,
                criticality: None,
                lyapunov: None,
            });
        }
        self.cycles.push(branch);
        self.tell_births(index);
    }

    /// Says of the Hopf points of a branch which way it goes from them.
    fn tell_births(&mut self, index: usize) {
        let unit = self.states()[0].scale;
        for birth in &self.births {
            let (Some((branch, last)), Some(hopf)) = (birth.branch, &birth.hopf) else { continue };
            if branch != index {
                continue;
            }
            let mut way: Vec<(f64, f64)> =
                self.cycles[index].points.iter().map(|point| (point.amplitude[0] / unit, point.value)).collect();
            if last {
                way.reverse();
            }
            let value = birth.crossing.value;
            for point in self.points.iter_mut().filter(|p| p.kind == PointKind::Hopf && p.value == value) {
                point.branch = Some(index);
                point.criticality = hopf.criticality(&way[1..]);
            }
        }
    }

    /// A branch as it is known when it ends, with its special points.
    fn branch(&self, trip: &Trip, end: BranchEnd, birth: Option<usize>) -> (CycleBranch, Vec<(PointKind, usize)>) {
        let points = |walk: &Walk| walk.stops.iter().map(|stop| stop.point.clone()).collect::<Vec<_>>();
        let (mut all, mut special) = (points(&trip.walk), trip.walk.special.clone());
        let ends = match (trip.from, &trip.before) {
            (Origin::Hopf(from), _) => {
                all.insert(0, self.born(from));
                special.iter_mut().for_each(|(_, place)| *place += 1);
                [BranchEnd::Hopf, end]
            }
            (Origin::Cycle, None) => [if end == BranchEnd::Closed { end } else { BranchEnd::Points }, end],
            (Origin::Cycle, Some((first, first_end, first_birth))) => {
                // Back from where this way ends to the first cycle, and on along the way before.
                let last = all.len() - 1;
                all.reverse();
                special.iter_mut().for_each(|(_, place)| *place = last - *place);
                special.reverse();
                all.extend(points(first).into_iter().skip(1));
                special.extend(first.special.iter().map(|(kind, place)| (*kind, last + place)));
                all.extend(first_birth.map(|birth| self.born(birth)));
                [end, *first_end]
            }
        };
        if let Some(birth) = birth {
            if trip.from == Origin::Cycle && trip.before.is_some() {
                all.insert(0, self.born(birth));
                special.iter_mut().for_each(|(_, place)| *place += 1);
            } else {
                all.push(self.born(birth));
            }
        }
        (CycleBranch { points: all, ends }, special)
    }

    /// The cycle of no size at a Hopf point.
    fn born(&self, birth: usize) -> CyclePoint {
        let Crossing { value, frequency, .. } = self.births[birth].crossing;
        let place = self.rest.value.iter().position(|other| *other == value).unwrap_or(0);
        let state = vector(self.rest.states.len(), &|i| self.rest.states[i][place]);
        let turning = std::f64::consts::TAU * frequency;
        let mut values = self.line.rest(value).and_then(|at| at.eigenvalues()).unwrap_or_default();
        let off = |value: &Complex<f64>| value.re.abs() + (value.im.abs() - turning).abs();
        sort_few(&mut values, |a, b| off(a) < off(b));
        let unstable = values.iter().skip(2).filter(|value| value.re > 0.0).count();
        let around = |value: &Complex<f64>| {
            let (sine, cosine) = (value.im / frequency).sin_cos();
            Complex::new(cosine, sine) * (value.re / frequency).exp()
        };
        let pair = [Complex::from(1.0); 2];
        let mut multipliers: Vec<Complex<f64>> =
            pair.into_iter().chain(values.iter().skip(2).map(around)).take(state.len()).collect();
        sort_few(&mut multipliers[1..], |a, b| a.norm_sqr() > b.norm_sqr());
        let symmetric = state.iter().all(|x| *x == 0.0);
        let amplitude = vector(state.len(), &|i| state[i].abs());
        CyclePoint { value, period: 1.0 / frequency, amplitude, state, multipliers, unstable, symmetric }
    }
}
