//! Where branches end, and what is known of them then.

use nalgebra::Complex;

use super::{Bifurcation, Birth, CycleBranch, Origin, SpecialPoint, Trip};
use crate::{
    cycles::{
        continuation::{BranchEnd, CyclePoint, PointKind, walk::Walk},
        vector::vector,
    },
    few::sort_few,
    stability::Crossing,
};

/// A branch that is as near to rest as this, in units of typical sizes, may end at a Hopf point whose frequency is as near,
/// and whose value is as near in parts of the range.
const DYING: f64 = 0.05;
const SAME_FREQUENCY: f64 = 0.03;
const SAME_VALUE: f64 = 0.02;

impl Bifurcation {
    /// The Hopf point at which the branch dies that is on its way, if it does.
    pub(super) fn arrives(&self, trip: &Trip) -> Option<usize> {
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
    pub(super) fn ends(&mut self, trip: Trip, end: BranchEnd, birth: Option<usize>) {
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
    pub(super) fn branch(
        &self,
        trip: &Trip,
        end: BranchEnd,
        birth: Option<usize>,
    ) -> (CycleBranch, Vec<(PointKind, usize)>) {
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
        let mut values = self.line.rest(value).and_then(|at| at.deciding()).unwrap_or_default();
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
