//! Where a swing goes that changes too slowly to be followed.

use super::watch::{Cycle, End, Watch};
use crate::{error::Result, integrate::failed, model::Gear};

/// Cycles after a jump until only the slow motion is left: the others fade within one or two.
const SETTLING: usize = 6;
/// Most jumps.
const JUMPS: usize = 24;
/// A growth per cycle that counts as none. What the integration itself adds is some 10⁻⁹.
const NONE: f64 = 1e-8;
/// Fallen to this fraction of where the jumps began, and still falling: it dies.
const GONE: f64 = 1e-3;

/// The end of a motion whose amplitude still creeps, and the cycle that it creeps to.
///
/// Near a Hopf point an amplitude A grows by ln(A′/A) ≈ g(A²) a cycle, with g nearly straight: its zero is the limit
/// cycle. The state is scaled to where g should be zero, followed for a few cycles, and g is known better: a secant
/// method whose every value is a true cycle of the motion.
pub(super) fn shortcut<S: Gear<N>, const N: usize>(
    watch: &mut Watch<S, N>,
    cycles: &[Cycle<N>],
    most_steps: u64,
) -> Result<(End, Cycle<N>)> {
    let Some(&last) = cycles.last() else { unreachable!("called with the cycles of a swing") };
    let growth = |pair: &[Cycle<N>]| (pair[1].amplitude[0] / pair[0].amplitude[0]).ln();
    if cycles.len() < 4 {
        return Ok((if last.amplitude[0] < cycles[0].amplitude[0] { End::Dies } else { End::Repeats }, last));
    }
    let middle = cycles.len() / 2;
    let square = |cycle: &Cycle<N>| cycle.amplitude[0].powi(2);
    let mut before = (square(&cycles[middle]), growth(&cycles[middle - 1..=middle]));
    let mut now = (square(&last), growth(&cycles[cycles.len() - 2..]));
    let mut cycle = last;
    for _ in 0..JUMPS {
        if now.1.abs() < NONE {
            return Ok((End::Repeats, cycle));
        }
        let slope = (now.1 - before.1) / (now.0 - before.0);
        let zero = now.0 - now.1 / slope;
        // What grows from rest by no more than that is on the boundary: a swing that falls there falls all the way.
        if now.1 < 0.0 && slope < 0.0 && -slope * zero < NONE {
            return Ok((End::Dies, cycle));
        }
        // Without a zero ahead (falling all the way down, or rising all the way up) take a long stride and look again.
        let target = match (slope < 0.0 && zero > 0.0, now.1 < 0.0) {
            // Not clamp, which would bring its own message with both numbers.
            (true, _) => zero.max(now.0 / 25.0).min(now.0 * 25.0),
            (false, true) => now.0 / 25.0,
            (false, false) => now.0 * 4.0,
        };
        if target.sqrt() < GONE * last.amplitude[0] {
            return Ok((End::Dies, cycle));
        }
        let Some(next) = settled(watch, (target / now.0).sqrt(), &cycle, most_steps)? else {
            return Ok((if now.1 < 0.0 { End::Dies } else { End::Grows }, cycle));
        };
        (before, now) = (now, (square(&next[1]), growth(&next)));
        cycle = next[1];
    }
    Ok((if now.1 < -NONE { End::Dies } else { End::Repeats }, cycle))
}

/// Scales the state, lets the motion settle, and gives its last two cycles; `None` where it does not swing there.
fn settled<S: Gear<N>, const N: usize>(
    watch: &mut Watch<S, N>,
    factor: f64,
    like: &Cycle<N>,
    most_steps: u64,
) -> Result<Option<[Cycle<N>; 2]>> {
    let time = watch.motion.time();
    let scaled = watch.motion.system().scaled(watch.motion.state(), factor);
    watch.jump(scaled).map_err(|failure| failed(failure, time))?;
    let end = time + 4.0 * SETTLING as f64 * like.period;
    let mut seen: Vec<Cycle<N>> = Vec::with_capacity(SETTLING);
    while seen.len() < SETTLING && watch.motion.time() < end && watch.motion.stats().steps < most_steps {
        let time = watch.motion.time();
        seen.extend(watch.step(end).map_err(|failure| failed(failure, time))?);
    }
    Ok(if let [.., before, last] = seen[..] { Some([before, last]) } else { None })
}
