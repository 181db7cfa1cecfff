//! Dormand and Prince's method of order 8 with error estimates of orders 5 and 3.

use super::{
    dense::Dense,
    stages::{Attempt, Stages, moved, weighted},
};
use crate::model::{Mode, System};

mod table;
use table::{A, B, C, D, E3, E5};

/// Stage of the derivative at the end, which is the first of the next step.
pub(super) const END: usize = 12;

#[inline(never)]
pub(super) fn attempt<S: System<N>, const N: usize>(
    system: &S,
    mode: Mode,
    t: f64,
    x: &[f64; N],
    h: f64,
    k: &mut Stages<N>,
) -> Attempt<N> {
    macro_rules! stages {
        ($($stage:literal)*) => {
            $(k[$stage] = system.rate(t + C[$stage] * h, mode, &moved(x, h, &A[$stage][..$stage], k));)*
        };
    }
    stages!(1 2 3 4 5 6 7 8 9 10);
    let last_stage = moved(x, h, &A[11][..11], k);
    k[11] = system.rate(t + h, mode, &last_stage);
    Attempt { end: moved(x, h, &B, k), last_stage }
}

/// Square of the error's norm: the estimate of order 5, damped by the one of order 3.
///
/// `scale` is 1/(tolerance of a component). E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential
/// Equations I*, II.10.
#[inline(always)]
pub(super) fn error<const N: usize>(h: f64, k: &Stages<N>, scale: &[f64; N]) -> f64 {
    let (fifth, third) = (weighted(&E5, k), weighted(&E3, k));
    let (mut five, mut three) = (0.0, 0.0);
    for i in 0..N {
        five += (fifth[i] * scale[i]).powi(2);
        three += (third[i] * scale[i]).powi(2);
    }
    let damped = five + 0.01 * three;
    if damped == 0.0 { 0.0 } else { h.abs() * five / (damped * N as f64).sqrt() }
}

/// Interpolant of order 7, for which three more stages are computed.
pub(super) fn dense<S: System<N>, const N: usize>(
    system: &S,
    mode: Mode,
    t: f64,
    (x0, x1): (&[f64; N], &[f64; N]),
    h: f64,
    k: &mut Stages<N>,
) -> Dense<N> {
    for stage in 13..16 {
        k[stage] = system.rate(t + C[stage] * h, mode, &moved(x0, h, &A[stage][..stage], k));
    }
    let mut parts = [[0.0; N]; 7];
    for i in 0..N {
        let rise = x1[i] - x0[i];
        parts[0][i] = rise;
        parts[1][i] = h * k[0][i] - rise;
        parts[2][i] = 2.0 * rise - h * (k[END][i] + k[0][i]);
    }
    for (part, weights) in parts[3..].iter_mut().zip(&D) {
        *part = weighted(weights, k).map(|sum| h * sum);
    }
    Dense::nested(x0, &parts)
}
