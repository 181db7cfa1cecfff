//! Where a switch falls through zero within a step.

use std::{f64::consts::PI, sync::LazyLock};

use super::linear::Factors;

/// Values of a switch that are taken along a step. Its course there is the polynomial through them: exact for a switch
/// that is linear in the state, as the dense output is of degree 7.
pub(super) const NODES: usize = 8;

/// A switch that has just been passed, and does not fall from the start on, must get below zero by this part of its largest value
/// in the step: where it starts flat, the dense output cannot tell.
const TOUCH: f64 = 1e-3;

/// What is known of a switch that has just been passed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fresh {
    /// Its slope at the start, per step.
    pub slope: f64,
    /// What its value in the step may be wrong by.
    pub error: f64,
}

/// A switch's value and slope (per step) at the start and the end of a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ends {
    pub start: f64,
    pub start_slope: f64,
    pub end: f64,
    pub end_slope: f64,
}

impl Ends {
    /// Whether the switch surely stays positive, judged by the cubic through both ends.
    ///
    /// The cubic lies within the hull of its Bernstein coefficients; the true course departs from it by far less than a
    /// tenth of their spread as long as a step is shorter than half an oscillation, and that tenth is kept as a margin.
    /// `fresh`: the switch has just been passed, its value at the start is 0 but for rounding.
    #[inline(always)]
    pub fn stays_positive(&self, fresh: bool) -> bool {
        let start = if fresh { 0.0 } else { self.start };
        let leaving = self.start_slope / 3.0;
        let arriving = self.end_slope / 3.0;
        let margin = 0.1 * (leaving.abs() + arriving.abs() + (self.end - start).abs());
        // Bernstein coefficients: start, start + leaving, end − arriving, end.
        if fresh {
            leaving > 0.0 && self.end - arriving > 0.0 && (self.end > margin || self.end > leaving)
        } else {
            start > margin && start + leaving > margin && self.end - arriving > margin && self.end > margin
        }
    }

    /// Whether the switch surely falls through zero just once, judged by the same cubic with the same margin: it starts
    /// positive, ends negative, and its slope never turns.
    #[inline(always)]
    pub fn falls_once(&self, fresh: bool) -> bool {
        let fall = self.start - self.end;
        let (leaving, arriving) = (-self.start_slope / 3.0, -self.end_slope / 3.0);
        let margin = 0.1 * fall;
        !fresh
            && self.start > 0.0
            && self.end < 0.0
            && leaving > margin
            && arriving > margin
            && leaving + arriving < fall
    }
}

impl Ends {
    /// Where the cubic of a switch that falls once is zero, to about 10⁻⁶: the cubic itself is no nearer to the truth.
    pub fn fall(&self) -> f64 {
        let rise = self.end - self.start;
        let bend = 3.0 * rise - 2.0 * self.start_slope - self.end_slope;
        let twist = self.start_slope + self.end_slope - 2.0 * rise;
        // Newton from the chord: the slope never gets near zero where a switch surely falls once.
        let mut theta = -self.start / rise;
        for _ in 0..3 {
            let value = self.start + theta * (self.start_slope + theta * (bend + theta * twist));
            let slope = self.start_slope + theta * (2.0 * bend + theta * 3.0 * twist);
            theta = (theta - value / slope).clamp(0.0, 1.0);
        }
        theta
    }
}

/// Finds the first θ ∈ \[0, 1\] at which a switch falls through zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Locator {
    nodes: [f64; NODES],
    to_bernstein: [[f64; NODES]; NODES],
}

impl Locator {
    /// The one there is.
    pub fn get() -> &'static Self {
        static LOCATOR: LazyLock<Locator> = LazyLock::new(Locator::new);
        &LOCATOR
    }

    /// Prepares the nodes and the change of basis.
    fn new() -> Self {
        let last = (NODES - 1) as f64;
        let nodes: [f64; NODES] = std::array::from_fn(|i| 0.5 - 0.5 * (PI * i as f64 / last).cos());
        let powers = |x: f64| {
            let mut powers = [1.0; NODES];
            for i in 1..NODES {
                powers[i] = powers[i - 1] * x;
            }
            powers
        };
        let basis = nodes.map(|node| {
            let (up, down) = (powers(node), powers(1.0 - node));
            std::array::from_fn(|j| binomial(NODES - 1, j) * up[j] * down[NODES - 1 - j])
        });
        let mut to_bernstein = [[0.0; NODES]; NODES];
        // Distinct nodes have a regular basis.
        if let Some(factors) = Factors::of(basis) {
            for node in 0..NODES {
                let column = factors.solve(&std::array::from_fn(|i| if i == node { 1.0 } else { 0.0 }));
                for j in 0..NODES {
                    to_bernstein[j][node] = column[j];
                }
            }
        }
        Self { nodes, to_bernstein }
    }

    /// The first fall through zero of `switch`, a function of θ, or `None`.
    ///
    /// A dip below zero that rounding could have made does not count, nor does the start of a `fresh` switch, one that has just
    /// been passed: of that its slope there is known, as not every dense output starts with the very slope of the equations, and
    /// its error. `size` is the size of the terms whose difference the switch is.
    pub fn first(&self, fresh: Option<Fresh>, size: f64, switch: &dyn Fn(f64) -> f64) -> Option<f64> {
        let values: [f64; NODES] = std::array::from_fn(|i| switch(self.nodes[i]));
        let largest = values.iter().fold(size, |most, value| most.max(value.abs()));
        if !values.iter().all(|value| value.is_finite()) {
            return None;
        }
        if let Some(Fresh { error, .. }) = fresh
            && values.iter().all(|value| value.abs() <= error && (size == 0.0 || value.abs() <= TOUCH * size))
        {
            return None; // it is still where it was passed, for all that is known
        }
        let noise = 64.0 * f64::EPSILON * largest;
        let mut course: [f64; NODES] =
            std::array::from_fn(|i| (0..NODES).map(|j| self.to_bernstein[i][j] * values[j]).sum());
        course[0] = values[0];
        course[NODES - 1] = values[NODES - 1];
        if fresh.is_some() || course[0].abs() <= noise {
            course[0] = 0.0;
            let mut touch = [noise; 2];
            if let Some(Fresh { slope, error }) = fresh {
                course[1] = slope / (NODES - 1) as f64;
                let most = TOUCH * largest;
                let least = error.min(most).max(noise);
                touch = [least, if slope > -error { most.max(noise) } else { least }];
            }
            return first_fall_from_zero(&course, touch, noise, switch);
        }
        if course[0] < 0.0 {
            return Some(0.0);
        }
        first_fall(&course, 0.0, 1.0, switch)
            .filter(|&theta| theta == 1.0 || falls_below(&split(&course, theta).1, noise))
    }
}

/// As [`Locator::first`], for a start on the boundary. What counts is where the course leaves it: up by `touch[0]`, and it may
/// fall from there; or down by `touch[1]`, and it has fallen at once.
fn first_fall_from_zero(
    course: &[f64; NODES],
    touch: [f64; 2],
    noise: f64,
    switch: &dyn Fn(f64) -> f64,
) -> Option<f64> {
    let leaves = |sign: f64, touch: f64| {
        first_fall(&course.map(|c| touch - sign * c), 0.0, 1.0, &|theta| touch - sign * switch(theta))
    };
    let (up, down) = (leaves(1.0, touch[0]).filter(|up| *up < 1.0), leaves(-1.0, touch[1]));
    match up {
        Some(up) if down.is_none_or(|down| up < down) => {
            let rest = split(course, up).1;
            first_fall(&rest, up, 1.0, switch)
                .filter(|&theta| theta == 1.0 || falls_below(&split(course, theta).1, noise))
        }
        // It has hardly been above: back from where it is below to where it comes from. Or, but for rounding, not at all.
        _ => match down {
            Some(down) if touch[1] > noise => {
                let mut back = split(course, down).0.map(|c| -c);
                back.reverse();
                back[0] = touch[1];
                Some(down * (1.0 - first_fall(&back, 0.0, 1.0, &|theta| -switch(down * (1.0 - theta))).unwrap_or(1.0)))
            }
            _ => (down.is_some() || falls_below(course, noise)).then_some(0.0),
        },
    }
}

/// Whether the course really gets below zero: at its end at all, on its way by more than noise.
fn falls_below(course: &[f64; NODES], noise: f64) -> bool {
    course[NODES - 1] < 0.0 || dips_below(course, -noise, 20)
}

/// Whether a polynomial in Bernstein form gets below `level`: its coefficients bound it, its ends are on it.
fn dips_below(course: &[f64; NODES], level: f64, halvings: u32) -> bool {
    if course.iter().all(|&c| c >= level) {
        return false;
    }
    if course[0] < level || course[NODES - 1] < level {
        return true;
    }
    let (first, second) = split(course, 0.5);
    halvings > 0 && (dips_below(&first, level, halvings - 1) || dips_below(&second, level, halvings - 1))
}

/// First root of a polynomial in Bernstein form over \[`low`, `high`\] that starts positive.
///
/// Coefficients that are all positive prove that there is none; one change of sign proves that there is one, which is
/// then bracketed; otherwise the interval is halved.
fn first_fall(course: &[f64; NODES], low: f64, high: f64, switch: &dyn Fn(f64) -> f64) -> Option<f64> {
    if course.iter().all(|&c| c > 0.0) {
        return None;
    }
    if course[0] <= 0.0 {
        return Some(low);
    }
    let changes = course.windows(2).filter(|pair| (pair[0] > 0.0) != (pair[1] > 0.0)).count();
    if changes == 1 {
        return Some(bracketed(low, high, switch));
    }
    let middle = 0.5 * (low + high);
    if high - low < 1e-9 {
        return None; // a touch, far below what a step resolves
    }
    let (first, second) = split(course, 0.5);
    first_fall(&first, low, middle, switch).or_else(|| first_fall(&second, middle, high, switch))
}

/// Root of `switch` between `low` (positive) and `high` (not): regula falsi of the Illinois kind, to rounding.
pub(crate) fn bracketed(mut low: f64, mut high: f64, switch: &dyn Fn(f64) -> f64) -> f64 {
    let (mut at_low, mut at_high) = (switch(low), switch(high));
    if at_low <= 0.0 {
        return low;
    }
    let rounding = 2.0 * f64::EPSILON * at_low.max(at_high.abs());
    let mut side = 0;
    for _ in 0..60 {
        if at_high >= 0.0 || high - low <= 2.0 * f64::EPSILON * high {
            break;
        }
        let theta = low + (high - low) * at_low / (at_low - at_high);
        let theta = if theta > low && theta < high { theta } else { 0.5 * (low + high) };
        let value = switch(theta);
        if value.abs() <= rounding {
            return theta;
        }
        // The end that stays twice in a row is trusted half as much, or one end would never move.
        if value > 0.0 {
            (low, at_low) = (theta, value);
            at_high *= if side == 1 { 0.5 } else { 1.0 };
            side = 1;
        } else {
            (high, at_high) = (theta, value);
            at_low *= if side == -1 { 0.5 } else { 1.0 };
            side = -1;
        }
    }
    high
}

/// De Casteljau's subdivision at `theta`.
#[inline(never)]
fn split(course: &[f64; NODES], theta: f64) -> ([f64; NODES], [f64; NODES]) {
    let mut work = *course;
    let (mut first, mut second) = ([0.0; NODES], [0.0; NODES]);
    for level in 0..NODES {
        first[level] = work[0];
        second[NODES - 1 - level] = work[NODES - 1 - level];
        for i in 0..NODES - 1 - level {
            work[i] = (1.0 - theta) * work[i] + theta * work[i + 1];
        }
    }
    (first, second)
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(fresh: bool, switch: impl Fn(f64) -> f64) -> Option<f64> {
        let slope = (switch(1e-7) - switch(0.0)) / 1e-7;
        Locator::get().first(fresh.then_some(Fresh { slope, error: 1e-10 }), 0.0, &switch)
    }

    #[test]
    fn first_of_several_roots_is_found_to_rounding() {
        let roots = [0.31, 0.62, 0.9];
        let found = first(false, |t| -(t - roots[0]) * (t - roots[1]) * (t - roots[2])).unwrap();
        assert!((found - roots[0]).abs() < 1e-14);
    }

    #[test]
    fn a_short_dip_between_the_nodes_is_found() {
        // Below zero only on 0.500 … 0.502.
        let found = first(false, |t| (t - 0.5) * (t - 0.502)).unwrap();
        assert!((found - 0.5).abs() < 1e-12, "{found}");
    }

    #[test]
    fn a_touch_is_no_fall() {
        assert_eq!(first(false, |t| (t - 0.4).powi(2)), None);
        assert_eq!(first(false, |t| (t - 0.4).powi(2) + 1e-13), None);
        assert_eq!(first(false, |t| 1.0 + t), None);
    }

    #[test]
    fn the_boundary_just_passed_does_not_count_again() {
        assert_eq!(first(true, |t| t), None);
        assert_eq!(first(true, |t| t - 1e-12), None, "rounding at the start");
        let back = first(true, |t| t * (0.25 - t)).unwrap();
        assert!((back - 0.25).abs() < 1e-14);
    }

    #[test]
    fn a_flat_start_may_fall_later() {
        // As a wheel that is let go: rounding has its slope at the start fall or rise a little.
        for rounding in [0.0, -1e-14, 1e-14] {
            let found = first(true, |t| t * (rounding + t * (0.7 - t))).unwrap();
            assert!((found - 0.7).abs() < 1e-12, "{found}");
            assert_eq!(first(true, |t| t * (rounding + t * (1.1 - t))), None);
        }
        assert_eq!(first(true, |t| t * (-1e-3 + t)), Some(0.0), "this one falls");
        assert_eq!(first(true, |t| -t * t), Some(0.0));
    }

    #[test]
    fn a_start_beyond_the_boundary_falls_at_once() {
        assert_eq!(first(false, |t| -0.1 + t), Some(0.0));
    }

    #[test]
    fn a_fall_promised_to_be_the_only_one_is() {
        let mut promises = 0;
        for level in 0..100 {
            for phase in 0..120 {
                for step in [0.1, 0.4, 0.8, 1.5] {
                    let offset = -1.0 + 2.0 * level as f64 / 99.0;
                    let start = phase as f64 * 0.0525;
                    let value = |theta: f64| offset + (start + theta * step).sin();
                    let slope = |theta: f64| step * (start + theta * step).cos();
                    let ends =
                        Ends { start: value(0.0), start_slope: slope(0.0), end: value(1.0), end_slope: slope(1.0) };
                    if ends.falls_once(false) {
                        promises += 1;
                        // The cubic departs from a sine by up to step⁴/384, over its least slope.
                        assert!(value(ends.fall()).abs() < 0.015 * step.powi(3), "{ends:?}");
                        assert!((0..=100).all(|i| slope(0.01 * i as f64) < 0.0), "{ends:?}");
                    }
                }
            }
        }
        assert!(promises > 1000, "the shortcut is used: {promises}");
    }

    #[test]
    fn ends_never_promise_what_a_sine_breaks() {
        // Courses margin + sin, steps up to 1.5 rad long: whenever the true course falls below 0, no promise.
        let mut promises = 0;
        for level in 0..200 {
            for phase in 0..120 {
                for step in [0.1, 0.4, 0.8, 1.5] {
                    let offset = -1.1 + 2.2 * level as f64 / 199.0;
                    let start = phase as f64 * 0.0525;
                    let value = |theta: f64| offset + (start + theta * step).sin();
                    let slope = |theta: f64| step * (start + theta * step).cos();
                    let ends =
                        Ends { start: value(0.0), start_slope: slope(0.0), end: value(1.0), end_slope: slope(1.0) };
                    if ends.stays_positive(false) {
                        promises += 1;
                        assert!((0..=100).all(|i| value(0.01 * i as f64) > 0.0), "{ends:?}");
                    }
                }
            }
        }
        assert!(promises > 20_000, "the shortcut is used: {promises}");
    }
}
