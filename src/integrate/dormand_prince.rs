//! Dormand and Prince's pair of orders 5 and 4.

use super::{
    dense::Dense,
    stages::{Attempt, Stages, moved, weighted},
};
use crate::model::{Mode, System};

// J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980) 19–26.
pub(crate) const C: [f64; 6] = [0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0];
pub(crate) const A: [[f64; 5]; 6] = [
    [0.0; 5],
    [1.0 / 5.0, 0.0, 0.0, 0.0, 0.0],
    [3.0 / 40.0, 9.0 / 40.0, 0.0, 0.0, 0.0],
    [44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0, 0.0, 0.0],
    [19_372.0 / 6561.0, -25_360.0 / 2187.0, 64_448.0 / 6561.0, -212.0 / 729.0, 0.0],
    [9017.0 / 3168.0, -355.0 / 33.0, 46_732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18_656.0],
];
pub(crate) const B: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
/// Order 5 minus order 4.
pub(crate) const E: [f64; 7] =
    [71.0 / 57_600.0, 0.0, -71.0 / 16_695.0, 71.0 / 1920.0, -17_253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
/// Dense output of order 4: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.6.
const D: [f64; 7] = [
    -12_715_105_075.0 / 11_282_082_432.0,
    0.0,
    87_487_479_700.0 / 32_700_410_799.0,
    -10_690_763_975.0 / 1_880_347_072.0,
    701_980_252_875.0 / 199_316_789_632.0,
    -1_453_857_185.0 / 822_651_844.0,
    69_997_945.0 / 29_380_423.0,
];

/// Stage of the derivative at the end, which is the first of the next step.
pub(super) const END: usize = 6;

#[inline(never)]
pub(super) fn attempt<S: System<N>, const N: usize>(
    system: &S,
    mode: Mode,
    t: f64,
    x: &[f64; N],
    h: f64,
    k: &mut Stages<N>,
) -> Attempt<N> {
    k[1] = system.rate(t + C[1] * h, mode, &moved(x, h, &A[1][..1], k));
    k[2] = system.rate(t + C[2] * h, mode, &moved(x, h, &A[2][..2], k));
    k[3] = system.rate(t + C[3] * h, mode, &moved(x, h, &A[3][..3], k));
    k[4] = system.rate(t + C[4] * h, mode, &moved(x, h, &A[4][..4], k));
    let last_stage = moved(x, h, &A[5][..5], k);
    k[5] = system.rate(t + h, mode, &last_stage);
    let end = moved(x, h, &B, k);
    k[END] = system.rate(t + h, mode, &end);
    Attempt { end, last_stage }
}

/// Estimate of the local error, component by component.
#[inline(always)]
pub(super) fn error<const N: usize>(h: f64, k: &Stages<N>) -> [f64; N] {
    weighted(&E, k).map(|e| h * e)
}

pub(super) fn dense<const N: usize>(x0: &[f64; N], x1: &[f64; N], h: f64, k: &Stages<N>) -> Dense<N> {
    let bend = weighted(&D, k);
    let rise: [f64; N] = std::array::from_fn(|i| x1[i] - x0[i]);
    let start: [f64; N] = std::array::from_fn(|i| h * k[0][i] - rise[i]);
    let end: [f64; N] = std::array::from_fn(|i| rise[i] - h * k[END][i] - start[i]);
    Dense::nested(x0, &[rise, start, end, bend.map(|b| h * b)])
}
