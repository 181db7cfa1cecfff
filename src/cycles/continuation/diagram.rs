//! A bifurcation diagram in the making.

mod ends;
mod search;

use std::rc::Rc;

use super::{
    BifurcationSpec, BranchEnd, Criticality, CyclePoint, PointKind, RestBranch, Told,
    family::{Family, RunAt, Settling, family},
    hopf::Hopf,
    line::Line,
    walk::Walk,
};
use crate::{
    cycles::{Arrival, Guess, vector::vector},
    error::{Code, Error, Result, shown},
    parameter::StateVariable,
    stability::Crossing,
};

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
    /// At which value.
    Predictions(usize),
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
/// branch point or a period doubling are not followed. A branch that no Hopf point of the range begins, no describing function
/// predicts and no simulation leads to at one of the values looked at, is missed. With dry friction rest and its Hopf points are those of a
/// wheel that turns freely: one that friction holds sticks, and no branch begins there.
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
    /// The part that is made.
    made: f64,
    /// Unstable cycles that are predicted at a value, and not looked for yet.
    predicted: Vec<(Guess, f64)>,
    probe: Option<Probe>,
    trip: Option<Trip>,
}

/// A motion that may lead to a cycle, at a value.
enum Probe {
    Settling(f64, Box<dyn Settling>),
    Arrived(f64, Arrival),
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
            made: 0.0,
            predicted: Vec::new(),
            probe: None,
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
        self.go_on()?;
        // A task may lead to several branches, none of which is known before: what was said to be made stays so.
        self.made = self.made.max(self.part());
        Ok(())
    }

    fn go_on(&mut self) -> Result<()> {
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
        if let Some(probe) = self.probe.take() {
            self.probe = self.follow(probe);
            return Ok(());
        }
        if let Some((guess, value)) = self.predicted.pop() {
            self.seek(&guess, value);
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
                    self.seek(&guess, value);
                }
            }
            Task::Predictions(place) => self.predict(place)?,
            Task::Probe(place, start) => self.probe = self.begin_probe(place, start)?,
        }
        self.done += 1;
        Ok(())
    }

    /// What its cycles have cost so far: see [`Flow`](crate::cycles::flow::Flow).
    #[cfg(test)]
    pub(super) fn work(&mut self) -> u64 {
        self.family.flow().work()
    }

    /// Nothing is left to do.
    pub fn done(&self) -> bool {
        self.done == self.tasks.len() && self.trip.is_none() && self.probe.is_none() && self.predicted.is_empty()
    }

    /// The part that is made, 0 … 1, as far as that can be said.
    pub fn fraction(&self) -> f64 {
        self.made
    }

    fn part(&self) -> f64 {
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
        let under_way = self.trip.is_some() || self.probe.is_some() || !self.predicted.is_empty();
        let begun = if under_way { self.done.saturating_sub(1) } else { self.done };
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

    pub(super) fn scaled(&self, x: &[f64]) -> Vec<f64> {
        let states = self.states();
        vector(x.len(), &|i| x[i] / states[i].scale)
    }

    fn vary(&mut self, value: f64, period: f64) -> bool {
        self.family.flow().pace(period, 1.0);
        self.family.vary(value)
    }
}
