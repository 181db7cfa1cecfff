//! Where branches begin: at Hopf points, at a guess, and where simulations settle.

use super::{Bifurcation, Birth, Origin, Probe, Task, Trip};
use crate::{
    cycles::{
        Arrival, Guess,
        continuation::{
            CyclePoint, PointKind, SpecialPoint,
            hopf::{AtRest, Hopf},
            newton::{Chart, Place},
            stop::Stop,
            walk::{Limits, Walk},
        },
        shooting::{self, Periodic},
        vector::{axis, vector},
    },
    error::Result,
    few::sort_few,
    stability::{Crossing, CurveKind},
};

/// Starts of simulations, in units of the first state's typical size: one for what grows from rest, and others.
const SMALL: f64 = 0.01;
const LADDER: [f64; 3] = [0.2, 1.0, 5.0];

/// How far ahead a simulation looks for a cycle \[s\].
const HORIZON: f64 = 6.0;
/// A cycle is one of a branch where amplitude and period are as near as this to what its neighbours there have between them.
const KNOWN: f64 = 0.02;

impl Bifurcation {
    /// Finds what crosses the axis, and plans what follows from it.
    pub(super) fn look_at_crossings(&mut self) -> Result<()> {
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
                // At rest among others that are as much at rest no cycle is born: near it all swing about another place.
                let alone = self.line.rest(crossing.value)?.neutral == 0;
                let hopf = if alone { Hopf::of(&mut *self.family, &gear, &crossing)? } else { None };
                self.tasks.push(Task::Hopf(self.births.len()));
                self.births.push(Birth { hopf, crossing, branch: None });
            } else {
                self.divergences.push(crossing);
            }
        }
        if self.spec.cycle.is_some() {
            self.tasks.push(Task::Guess);
        }
        self.tasks.extend((0..self.spec.probes).map(Task::Predictions));
        let probes = (0..self.spec.probes).flat_map(|place| (0..=LADDER.len()).map(move |start| (place, start)));
        self.tasks.extend(probes.map(|(place, start)| Task::Probe(place, start)));
        Ok(())
    }

    /// The special points of rest, by rising value.
    pub(super) fn note_rest(&mut self) {
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
    pub(super) fn set_out_from_hopf(&mut self, birth: usize) {
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

    pub(super) fn limits(&self) -> Limits {
        Limits { points: self.spec.points, step: self.spec.step, tolerance: self.spec.tolerance }
    }

    /// One of the values at which cycles are looked for.
    fn place(&self, place: usize) -> f64 {
        self.line.from() + self.line.width() * ((place as f64 + 0.5) / self.spec.probes as f64)
    }

    /// Predicts the unstable cycles at a value, to which no simulation leads.
    pub(super) fn predict(&mut self, place: usize) -> Result<()> {
        let value = self.place(place);
        let run = self.line.run_at(value)?;
        // A model without describing functions has none to tell of.
        for cycle in run.describing_function().unwrap_or_default().iter().filter(|cycle| !cycle.stable) {
            self.predicted.push((cycle.guess(&run)?, value));
        }
        Ok(())
    }

    /// Begins the branch through the cycle that a guess leads to, if it does.
    pub(super) fn seek(&mut self, guess: &Guess, value: f64) {
        let x = self.scaled(&guess.state);
        if self.vary(value, guess.period)
            && let Ok(Some(found)) = shooting::guessed(self.family.flow(), &x, guess.period)
        {
            self.set_out(found, value);
        }
    }

    /// The motion from a start at a value, which may lead to a cycle that no branch has.
    pub(super) fn begin_probe(&mut self, place: usize, start: usize) -> Result<Option<Probe>> {
        let value = self.place(place);
        let rest = self.line.rest(value)?;
        // The smallest start is for what grows.
        let size = match start.checked_sub(1) {
            Some(start) => LADDER[start],
            None if rest.deciding()?[0].re > 0.0 => SMALL,
            None => return Ok(None),
        };
        let mut x = self.scaled(&rest.equilibrium);
        x[0] += size;
        if !self.vary(value, 1.0) {
            return Ok(None);
        }
        // A motion that leaves the numbers settles nowhere.
        Ok(self.family.settling(&x, HORIZON).ok().map(|motion| Probe::Settling(value, motion)))
    }

    /// Follows a motion a little further, and begins the branch through the cycle that it leads to, if it does.
    pub(super) fn follow(&mut self, probe: Probe) -> Option<Probe> {
        match probe {
            Probe::Settling(value, mut motion) => {
                if !motion.advance().ok()? {
                    return Some(Probe::Settling(value, motion));
                }
                let (x, between) = motion.end().ok()??;
                Some(Probe::Arrived(value, Arrival::at(x, between)))
            }
            Probe::Arrived(value, mut arrival) => {
                self.vary(value, arrival.between);
                if !arrival.advance(self.family.flow()).ok()? {
                    return Some(Probe::Arrived(value, arrival));
                }
                if let Some(found) = arrival.best {
                    self.set_out(found, value);
                }
                None
            }
        }
    }

    /// Begins the branch through a cycle, unless it is known.
    pub(super) fn set_out(&mut self, found: Periodic, value: f64) {
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
    pub(super) fn knows(&self, value: f64, amplitude: f64, period: f64) -> bool {
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
}
