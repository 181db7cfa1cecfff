//! Following a boundary through the unit square.

use super::{
    Boundary, CurveKind, Point,
    geometry::{ahead, between, cross, dot, length, mixed},
};

/// The length of a first step, of the longest, and of one that gets nowhere.
const FIRST: f64 = 0.01;
const LONGEST: f64 = 0.1;
const SHORTEST: f64 = 1e-9;
/// A Newton step that is shorter ends the way back to the curve.
const ARRIVED: f64 = 1e-10;
/// What is nearer to an edge of the square is on it.
pub(super) const ON_EDGE: f64 = 1e-10;
/// Steps before a curve is given up for one that never ends.
const MOST_STEPS: usize = 20_000;
/// The cosine of the largest turn in a step, some 30°.
const LARGEST_TURN: f64 = 0.87;

/// A point of a boundary and the way it goes there, with what is positive at its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Spot {
    pub at: Point,
    pub tangent: Point,
}

impl Spot {
    fn of(at: Point, slope: Point) -> Self {
        let size = length(slope);
        Self { at, tangent: [slope[1] / size, -slope[0] / size] }
    }
}

/// Whether all of a curve is on one edge of the square.
fn along_edge(trace: &[Spot]) -> bool {
    let on = |axis: usize, edge: f64| trace.iter().all(|spot| (spot.at[axis] - edge).abs() <= ON_EDGE);
    (0..2).any(|axis| on(axis, 0.0) || on(axis, 1.0))
}

/// One kind of a boundary, to be followed.
pub(super) struct Tracer<'a> {
    pub boundary: &'a dyn Boundary,
    pub kind: CurveKind,
    /// How far a curve may be from the straight lines between its spots.
    pub tolerance: f64,
}

impl Tracer<'_> {
    /// All curves in the unit square but those along its edges; where one is closed its last spot is its first.
    pub fn traces(&self) -> Vec<Vec<Spot>> {
        let mut traces: Vec<Vec<Spot>> = Vec::new();
        for seed in self.boundary.seeds(self.kind) {
            if traces.iter().any(|trace| trace.windows(2).any(|two| crosses(two[0].at, two[1].at, seed))) {
                continue;
            }
            let Some(start) = self.on(seed) else { continue };
            if !traces.iter().any(|trace| self.passes(trace, &start)) {
                traces.push(self.trace(start));
            }
        }
        traces.retain(|trace| !along_edge(trace));
        traces
    }

    /// The point of the curve next to a point, no farther than `reach`.
    pub fn spot(&self, from: Point, reach: f64) -> Option<Spot> {
        let mut at = from;
        let mut step = f64::INFINITY;
        for _ in 0..8 {
            let (value, slope) = self.boundary.test(self.kind, at);
            let size = length(slope);
            step = (value / size).abs();
            at = ahead(at, slope, -value / (size * size));
            let moved = length(between(from, at));
            if moved.is_nan() || moved > reach {
                return None;
            }
            if step < ARRIVED {
                return Some(Spot::of(at, slope));
            }
        }
        (step < 1e3 * ARRIVED).then(|| Spot::of(at, self.boundary.test(self.kind, at).1))
    }

    /// A point of the curve on a line over which the sign changes, or near a point.
    fn on(&self, [mut low, mut high]: [Point; 2]) -> Option<Spot> {
        let rises = |at| self.boundary.test(self.kind, at).0 > 0.0;
        if low != high {
            let low_rises = rises(low);
            for _ in 0..30 {
                let middle = mixed(low, high, 0.5);
                *(if rises(middle) == low_rises { &mut low } else { &mut high }) = middle;
            }
        }
        self.spot(mixed(low, high, 0.5), 1e-3)
    }

    /// Whether a curve runs through a spot already, in the same sense: neighbours run in opposite ones.
    fn passes(&self, trace: &[Spot], spot: &Spot) -> bool {
        trace.windows(2).any(|two| {
            let (chord, to) = (between(two[0].at, two[1].at), between(two[0].at, spot.at));
            let part = (dot(to, chord) / dot(chord, chord)).clamp(0.0, 1.0);
            length(between(mixed(two[0].at, two[1].at, part), spot.at)) < 4.0 * self.tolerance
                && dot(two[0].tangent, spot.tangent) > 0.5
        })
    }

    /// The whole curve through a spot; where it is closed the last spot is the first.
    fn trace(&self, start: Spot) -> Vec<Spot> {
        let mut spots = self.walk(start, 1.0);
        if spots.len() < 2 || spots.last() != Some(&start) {
            let mut back = self.walk(start, -1.0);
            back.reverse();
            back.pop();
            back.append(&mut spots);
            spots = back;
        }
        spots
    }

    /// From a spot on, with the tangents or against them.
    fn walk(&self, start: Spot, sense: f64) -> Vec<Spot> {
        let mut spots = vec![start];
        let (mut here, mut step) = (start, FIRST);
        while step > SHORTEST && spots.len() < MOST_STEPS {
            let way = here.tangent.map(|part| sense * part);
            let room = room(here.at, way);
            if room < ON_EDGE {
                break;
            }
            if room <= step {
                if let Some(end) = self.edge(&here, way) {
                    spots.push(end);
                    break;
                }
                step = 0.5 * room;
            }
            let guess = ahead(here.at, way, step);
            let Some((next, error)) = self.spot(guess, 0.5 * step).and_then(|next| self.fit(&here, next, guess)) else {
                step *= 0.5;
                continue;
            };
            if !next.at.iter().all(|part| (0.0..=1.0).contains(part)) {
                let way = between(here.at, next.at);
                if let Some(end) = self.edge(&here, way) {
                    spots.push(end);
                    break;
                }
                step *= 0.5;
                continue;
            }
            if error > self.tolerance {
                step *= (0.9 * (self.tolerance / error).sqrt()).max(0.2);
                continue;
            }
            let home = between(here.at, start.at);
            let (along, aside) = (dot(home, way), cross(way, home).abs());
            if along > 0.0
                && along <= length(between(here.at, next.at))
                && aside <= (4.0 * self.tolerance).max(0.5 * along)
                && dot(here.tangent, start.tangent) > 0.5
            {
                spots.push(start);
                break;
            }
            spots.push(next);
            here = next;
            step = (step * (0.9 * (self.tolerance / error).sqrt()).min(2.0)).min(LONGEST);
        }
        spots
    }

    /// How far the curve is from the straight line between two spots; nothing where the second seems to be on another curve.
    fn fit(&self, here: &Spot, next: Spot, guess: Point) -> Option<(Spot, f64)> {
        let turn = dot(here.tangent, next.tangent);
        // An arc's height over its chord; and half of what it left the tangent by, over half of the way.
        let height = length(between(here.at, next.at)) * cross(here.tangent, next.tangent).abs() / 8.0;
        let missed = length(between(guess, next.at)) / 4.0;
        (turn > LARGEST_TURN).then_some((next, height.max(missed).max(1e-3 * self.tolerance)))
    }

    /// Where the curve leaves the square next, going on along `way`.
    fn edge(&self, here: &Spot, way: Point) -> Option<Spot> {
        (0..2).filter(|axis| way[*axis] != 0.0).find_map(|axis| {
            let other = 1 - axis;
            let border = if way[axis] > 0.0 { 1.0 } else { 0.0 };
            let part = (border - here.at[axis]) / way[axis];
            let mut guess = ahead(here.at, way, part);
            guess[axis] = border;
            guess[other] = guess[other].clamp(0.0, 1.0);
            let mut at = guess;
            for _ in 0..8 {
                let (value, slope) = self.boundary.test(self.kind, at);
                let step = value / slope[other];
                at[other] -= step;
                if !(0.0..=1.0).contains(&at[other]) {
                    return None;
                }
                if step.abs() < ARRIVED {
                    let (end, error) = self.fit(here, Spot::of(at, slope), guess)?;
                    return (error <= self.tolerance).then_some(end);
                }
            }
            None
        })
    }
}

/// How far it is to the edge along a way.
fn room(at: Point, way: Point) -> f64 {
    (0..2).fold(f64::INFINITY, |least, axis| match way[axis] {
        0.0 => least,
        part => least.min((if part > 0.0 { 1.0 - at[axis] } else { -at[axis] }) / part),
    })
}

/// Whether the straight line between two points crosses another one, which is none where it is a point.
fn crosses(a: Point, b: Point, [c, d]: [Point; 2]) -> bool {
    let side = |a: Point, b: Point, c: Point| cross(between(a, b), between(a, c));
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}
