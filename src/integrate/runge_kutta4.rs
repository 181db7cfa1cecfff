//! The classical Runge–Kutta method of order 4, with a fixed step.

use super::{
    dense::Dense,
    stages::{Attempt, Stages, moved},
};
use crate::model::{Mode, System};

/// Stage of the derivative at the end, which is the first of the next step.
pub(super) const END: usize = 4;

/// W. Kutta, *Z. Math. Phys.* 46 (1901) 435–453.
#[inline(never)]
pub(super) fn attempt<S: System<N>, const N: usize>(
    system: &S,
    mode: Mode,
    t: f64,
    x: &[f64; N],
    h: f64,
    k: &mut Stages<N>,
) -> Attempt<N> {
    k[1] = system.rate(t + 0.5 * h, mode, &moved(x, h, &[0.5], k));
    k[2] = system.rate(t + 0.5 * h, mode, &moved(x, h, &[0.0, 0.5], k));
    let last_stage = moved(x, h, &[0.0, 0.0, 1.0], k);
    k[3] = system.rate(t + h, mode, &last_stage);
    Attempt { end: moved(x, h, &[1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0], k), last_stage }
}

/// Cubic Hermite: its error per step is of order 4, as the method's error over a run is.
pub(super) fn dense<const N: usize>(x0: &[f64; N], x1: &[f64; N], h: f64, k: &Stages<N>) -> Dense<N> {
    Dense::hermite(x0, x1, &k[0], &k[END], h)
}
