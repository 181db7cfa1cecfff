//! Shooting: the start and the time after which a motion is back at it.

use nalgebra::Complex;

use super::{
    flow::Flow,
    square::Square,
    vector::{complex, direction, dot, matrix, norm, real, sum, times},
};
use crate::{
    error::Result,
    few::sort_few,
    stability::{Triangle, eigenvalues},
};

/// Most steps of Newton's method; from near it takes three or four.
const NEWTON_STEPS: usize = 25;
/// A step smaller than this part of the state and of the period is the last: the next one would be its square.
const LAST: f64 = 1e-9;
/// A step that cannot be bettered is the last where it is smaller than this: what is left is the error of the integration.
const ROUNDED: f64 = 1e-6;
/// The longest step, measured by the state and the period, and the smallest part of one that is tried.
const LONGEST: f64 = 0.5;
const SHORTEST: f64 = 1e-2;
/// A motion that misses its start by more is not back.
const CLOSE: f64 = 1e-7;
/// A motion that is this near to its start, or to the mirror image, is there.
const BACK: f64 = 1e-6;
/// A guess may be of so many rounds, and of their products.
const ROUNDS: [f64; 4] = [2.0, 3.0, 5.0, 7.0];
/// What is this much smaller than its guess has gone to rest.
const REST: f64 = 1e-3;
/// Multipliers as far as this from the trivial one are told from it by the matrix itself.
const APART: f64 = 0.01;
/// A second multiplier as near to 1 as this: the orbit has others beside it, and is no limit cycle.
const BESIDE: f64 = 1e-7;

/// A periodic motion.
pub(super) struct Periodic {
    /// A state on it, in units of the typical sizes.
    pub x: Vec<f64>,
    pub period: f64,
    /// The multiplier along it, which is 1 but for errors.
    pub trivial: f64,
    /// All, by falling size, of a pair the positive imaginary part first.
    pub multipliers: Vec<Complex<f64>>,
    /// All but the trivial one are within the unit circle.
    pub stable: bool,
    /// Its second half mirrors the first.
    pub symmetric: bool,
}

/// The periodic motion near `x`, with about `periods` times the period guessed; none where Newton's method finds none.
///
/// Where a motion from x is as good at arriving at −x in half the time, and the equations are odd, it is half of a symmetric
/// cycle: half of the way is enough.
///
/// # Errors
/// A matrix so extreme that its eigenvalues leave the numbers.
pub(super) fn periodic(flow: &mut dyn Flow, x: &[f64], period: f64) -> Result<Option<Periodic>> {
    let Some((early, _)) = flow.carry(x, period, false) else { return Ok(None) };
    // The time when it passes nearest: what is left to Newton's method is the slower part.
    let (leaving, arriving) = (flow.rate(x), flow.rate(&early));
    let ahead = sum(x, -1.0, &early);
    let wait = dot(&leaving, &ahead) / dot(&leaving, &arriving);
    let period = if wait.abs() < 0.1 * period { period + wait } else { period };
    let Some((end, _)) = flow.carry(x, period, false) else { return Ok(None) };
    let Some((middle, _)) = flow.carry(x, 0.5 * period, false) else { return Ok(None) };
    let odd = [x, &middle].iter().all(|x| is_odd(flow, x));
    if odd && gap(&middle, x, -1.0) <= (10.0 * gap(&end, x, 1.0)).min(0.5) {
        let half = solution(flow, x, 0.5 * period, -1.0)?;
        if half.is_some() {
            return Ok(half);
        }
    }
    whole(flow, x, period, odd)
}

/// As [`periodic`], where the guess may be of some rounds: a motion that is back earlier has its least period.
///
/// # Errors
/// As [`periodic`].
pub(super) fn guessed(flow: &mut dyn Flow, x: &[f64], period: f64) -> Result<Option<Periodic>> {
    let Some(mut found) = periodic(flow, x, period)? else { return Ok(None) };
    let mut rounds = ROUNDS.iter();
    while let Some(times) = rounds.next() {
        let part = found.period / times;
        let Some((early, _)) = flow.carry(&found.x, part, false) else { continue };
        if gap(&early, &found.x, 1.0) < BACK {
            // As finely as one round asks for.
            flow.pace(part, 1.0);
            let Some(shorter) = periodic(flow, &found.x, part)? else { break };
            found = shorter;
            rounds = ROUNDS.iter();
        }
    }
    Ok(Some(found))
}

/// As [`periodic`], over the whole period.
pub(super) fn whole(flow: &mut dyn Flow, x: &[f64], period: f64, odd: bool) -> Result<Option<Periodic>> {
    let Some(mut found) = solution(flow, x, period, 1.0)? else { return Ok(None) };
    if odd && let Some((middle, _)) = flow.carry(&found.x, 0.5 * found.period, false) {
        found.symmetric = gap(&middle, &found.x, -1.0) < BACK;
    }
    Ok(Some(found))
}

/// f(−x) = −f(x).
pub(super) fn is_odd(flow: &dyn Flow, x: &[f64]) -> bool {
    let mirrored = times(-1.0, x);
    let (here, there) = (flow.rate(x), flow.rate(&mirrored));
    gap(&there, &here, -1.0) < 1e-12
}

/// By how much `end` misses ± `x`, measured by x.
#[inline(never)]
pub(super) fn gap(end: &[f64], x: &[f64], sign: f64) -> f64 {
    norm(&sum(end, -sign, x)) / norm(x)
}

/// The motion that is at ± its start after about `duration`, by Newton's method on start and time.
///
/// # Equations
/// φ(x, T) = ±x and f(x₀)·(x − x₀) = 0: a step (d, τT) solves (Φ ∓ 1) d + f(φ) Tτ = ±x − φ, f(x₀)·d = 0, with Φ = ∂φ/∂x. It
/// is halved until the same matrix would ask for a smaller one at its end: cycles lie in valleys, slow along and steep
/// across, in which the residual alone is a bad guide.
///
/// # References
/// P. Deuflhard, *Newton Methods for Nonlinear Problems*, 2004, section 3.1: the natural monotonicity test.
fn solution(flow: &mut dyn Flow, from: &[f64], duration: f64, sign: f64) -> Result<Option<Periodic>> {
    let n = from.len();
    let (mut x, mut time) = (from.to_vec(), duration);
    let Some(mut arrival) = flow.carry(&x, time, true) else { return Ok(None) };
    for _ in 0..NEWTON_STEPS {
        let (leaving, arriving) = (flow.rate(&x), flow.rate(&arrival.0));
        let speed = norm(&leaving);
        let size = norm(&x);
        if size < REST * norm(from) || speed * time < REST * size {
            return Ok(None);
        }
        let rows = matrix(n + 1, &|i, j| match (i < n, j < n) {
            (true, true) => arrival.1.at(i, j) - if i == j { sign } else { 0.0 },
            (true, false) => arriving[i] * time,
            (false, true) => leaving[j] / speed,
            (false, false) => 0.0,
        });
        // The step that the matrix asks for where a motion from x arrives at `end`, and how large that is.
        let asked = |end: &[f64], x: &[f64]| {
            let miss = |i: usize| Complex::from(if i < n { sign * x[i] - end[i] } else { 0.0 });
            let step = real(&Triangle::of(&rows, 0.0.into(), &complex(n + 1, &miss)).solution(0.0));
            let long = (norm(&step[..n]) / size).max(step[n].abs());
            (step, long)
        };
        let (step, long) = asked(&arrival.0, &x);
        if !long.is_finite() {
            return Ok(None);
        }
        let mut part = (LONGEST / long).min(1.0);
        loop {
            let there = sum(&x, part, &step[..n]);
            let then = time * (1.0 + part * step[n]);
            if long < LAST {
                let close = gap(&arrival.0, &x, sign) < CLOSE;
                return if close { told(there, then, (&arrival.1, &leaving), sign) } else { Ok(None) };
            }
            if let Some(next) = flow.carry(&there, then, true).filter(|next| asked(&next.0, &there).1 < long) {
                (x, time, arrival) = (there, then, next);
                break;
            }
            part *= 0.5;
            if part < SHORTEST {
                let close = long < ROUNDED && gap(&arrival.0, &x, sign) < CLOSE;
                return if close { told(x, time, (&arrival.1, &leaving), sign) } else { Ok(None) };
            }
        }
    }
    Ok(None)
}

/// What the matrix of one round, or of half a round and its mirror, says.
fn told(x: Vec<f64>, time: f64, (around, leaving): (&Square, &[f64]), sign: f64) -> Result<Option<Periodic>> {
    let n = x.len();
    let symmetric = sign < 0.0;
    let (trivial, mut others) = multipliers(&Square::of(n, &|i, j| sign * around.at(i, j)), leaving)?;
    let trivial = if symmetric { trivial * trivial } else { trivial };
    if symmetric {
        others.iter_mut().for_each(|value| *value = squared(value));
    }
    if others.iter().any(|value| (value - 1.0).norm() < BESIDE) {
        return Ok(None);
    }
    let stable = others.iter().all(|value| value.norm() < 1.0);
    let mut multipliers = others;
    multipliers.insert(0, trivial.into());
    sort_few(&mut multipliers, |a, b| a.norm_sqr() > b.norm_sqr());
    let period = if symmetric { 2.0 * time } else { time };
    Ok(Some(Periodic { x, period, trivial, multipliers, stable, symmetric }))
}

/// A complex number's square, without a zero below zero.
pub(super) fn squared(value: &Complex<f64>) -> Complex<f64> {
    Complex::new(value.re * value.re - value.im * value.im, 2.0 * value.re * value.im + 0.0)
}

/// The multipliers of a matrix by which neighbours of a cycle are carried around, or halfway and mirrored back: that along the
/// cycle, which leaves its start as `leaving` says and is 1 but for errors, and the others by falling size, of a pair the
/// positive imaginary part first.
///
/// A reflection turns the first direction into that of the motion, which is carried into itself: what is left of the matrix
/// beside it has the other multipliers alone, and keeps them apart from the first where they come near to it.
///
/// # Errors
/// A matrix so extreme that its eigenvalues leave the numbers.
pub(super) fn multipliers(around: &Square, leaving: &[f64]) -> Result<(f64, Vec<Complex<f64>>)> {
    let n = leaving.len();
    let mut normal = direction(leaving);
    normal[0] += 1.0_f64.copysign(normal[0]);
    let scale = 2.0 / dot(&normal, &normal);
    let mirror = Square::of(n, &|i, j| f64::from(u8::from(i == j)) - scale * normal[i] * normal[j]);
    let turned = mirror.times(around).times(&mirror);
    let trivial = turned.at(0, 0);
    let mut others = eigenvalues(&matrix(n - 1, &|i, j| turned.at(i + 1, j + 1)))?;
    let away = |value: &Complex<f64>| (value - trivial).norm();
    // The cycle misses itself by an error, and with it what is left of the matrix: where no other is beside the first, the
    // whole of it has them without that.
    if others.iter().all(|value| away(value) > APART) {
        others = eigenvalues(&matrix(n, &|i, j| around.at(i, j)))?;
        let first = (0..n).fold(0, |best, i| if away(&others[i]) < away(&others[best]) { i } else { best });
        others.remove(first);
    }
    // They come by falling real part, and of a pair the positive one first; the sizes of a pair are the same.
    sort_few(&mut others, |a, b| a.norm_sqr() > b.norm_sqr());
    Ok((trivial, others))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::{
        cycles::flow::tests::carrier,
        model::{Mode, System},
        real::Real,
    };

    /// Stuart–Landau: ṙ = r − r³, φ̇ = ω − r². The unit circle, in 2π/(ω − 1); by ∂ṙ/∂r = −2 the multiplier e^(−2T).
    #[derive(Clone)]
    struct StuartLandau(f64);

    impl System<2> for StuartLandau {
        fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
            let size = x[0] * x[0] + x[1] * x[1];
            let (growth, turn) = (-size + 1.0, -size + self.0);
            [x[0] * growth - x[1] * turn, x[1] * growth + x[0] * turn]
        }
    }

    #[test]
    fn the_circle_of_stuart_and_landau() {
        let mut flow = carrier(StuartLandau(6.0), 1.2);
        let found = periodic(&mut flow, &[0.8, 0.3], 1.2).unwrap().unwrap();
        let period = TAU / 5.0;
        assert!((found.period - period).abs() < 1e-10 && (norm(&found.x) - 1.0).abs() < 1e-10);
        assert!(found.stable && found.symmetric);
        assert!((found.multipliers[0] - 1.0).norm() < 1e-7, "{:?}", found.multipliers);
        assert!((found.multipliers[1] - (-2.0 * period).exp()).norm() < 1e-7, "{:?}", found.multipliers);
    }

    /// Two wells: v̇ = x − x³ + μv(E − H) with the energy H = v²/2 − x²/2 + x⁴/4, so that Ḣ = μv²(E − H): the orbits H = E
    /// are its cycles, one in each well for E < 0, each the other's mirror image, and one around both for E > 0.
    #[derive(Clone)]
    struct TwoWells {
        energy: f64,
        pull: f64,
    }

    impl System<2> for TwoWells {
        fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
            let [x, v] = *x;
            let square = x * x;
            let excess = v * v * 0.5 - square * 0.5 + square * square * 0.25 - self.energy;
            [v, x - square * x - excess * v * self.pull]
        }
    }

    impl TwoWells {
        /// Period and ∮v² dt of the orbit in the right well, or around both.
        fn exact(&self) -> (f64, f64) {
            // v² = (h² − x²)(x² − l²)/2 with h², l² = 1 ± √(1 + 4E).
            let root = (1.0 + 4.0 * self.energy).sqrt();
            let (high, low) = ((1.0 + root).sqrt(), (1.0 - root).max(0.0).sqrt());
            let middle = if self.energy < 0.0 { 0.5 * (high + low) } else { 0.0 };
            let half = high - middle;
            // x = middle + half sin θ: smooth and periodic in θ, where the midpoint rule converges faster than any power.
            let n = 4000;
            (0..n).fold((0.0, 0.0), |(period, action), k| {
                let theta = (f64::from(k) + 0.5) / f64::from(n) * TAU;
                let x = middle + half * theta.sin();
                let v = (2.0 * (self.energy + 0.5 * x * x - 0.25 * x.powi(4))).sqrt();
                let dt = half * theta.cos().abs() / v * TAU / f64::from(n);
                (period + dt, action + v * v * dt)
            })
        }
    }

    #[test]
    fn a_cycle_and_its_mirror_image_are_told_from_a_symmetric_one() {
        for energy in [-0.15, 0.3] {
            let system = TwoWells { energy, pull: 0.4 };
            let (period, action) = system.exact();
            let amplitude = (1.0 + (1.0 + 4.0 * energy).sqrt()).sqrt();
            let mut flow = carrier(system, period);
            for side in [1.0, -1.0] {
                let found = periodic(&mut flow, &[1.02 * side * amplitude, 0.05], 0.97 * period).unwrap().unwrap();
                assert_eq!(found.symmetric, energy > 0.0);
                assert!(found.stable);
                assert!((found.period / period - 1.0).abs() < 1e-8, "{} {period}", found.period);
                let swing = flow.swing(&found.x, found.period).unwrap();
                assert!((swing.amplitude[0] / amplitude - 1.0).abs() < 1e-9);
                // The divergence along the orbit is −μv².
                let expected = (-0.4 * action).exp();
                assert!((found.multipliers[1] - expected).norm() < 1e-7, "{:?} {expected}", found.multipliers);
                assert!((found.multipliers[0] - 1.0).norm() < 1e-7);
            }
        }
    }

    #[test]
    fn an_unstable_cycle_is_found_and_called_so() {
        let system = TwoWells { energy: 0.3, pull: -0.4 };
        let (period, action) = system.exact();
        let mut flow = carrier(system, period);
        let found = periodic(&mut flow, &[1.585, 0.02], 1.02 * period).unwrap().unwrap();
        assert!(!found.stable && found.symmetric);
        let expected = (0.4 * action).exp();
        assert!((found.multipliers[0] / expected - 1.0).norm() < 1e-7, "{:?} {expected}", found.multipliers);
        assert!((found.multipliers[1] - 1.0).norm() < 1e-7);
    }

    #[test]
    fn a_guess_of_some_rounds_finds_one() {
        // Around both wells, which is symmetric, and around one.
        for energy in [0.3, -0.15] {
            let system = TwoWells { energy, pull: 0.4 };
            let (period, action) = system.exact();
            let amplitude = (1.0 + (1.0 + 4.0 * energy).sqrt()).sqrt();
            for rounds in [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 15.0] {
                let mut flow = carrier(system.clone(), rounds * period);
                let found = guessed(&mut flow, &[1.001 * amplitude, 0.002], 1.0005 * rounds * period).unwrap().unwrap();
                assert!((found.period / period - 1.0).abs() < 1e-8, "{rounds}: {} {period}", found.period);
                assert_eq!(found.symmetric, energy > 0.0, "{rounds}");
                let expected = (-0.4 * action).exp();
                assert!((found.multipliers[1] - expected).norm() < 1e-7, "{rounds}: {:?}", found.multipliers);
            }
        }
    }

    #[test]
    fn an_orbit_among_others_is_no_limit_cycle() {
        // A centre: without pull every energy has its orbit.
        let mut flow = carrier(TwoWells { energy: 0.3, pull: 0.0 }, 4.0);
        for x in [[1.6, 0.0], [1.2, 0.1]] {
            assert!(periodic(&mut flow, &x, PI).unwrap().is_none());
        }
        // Nor is rest.
        assert!(periodic(&mut flow, &[1.0 + 1e-9, 0.0], TAU / 2_f64.sqrt()).unwrap().is_none());
        assert!(periodic(&mut flow, &[0.0, 0.0], 1.0).unwrap().is_none());
    }
}
