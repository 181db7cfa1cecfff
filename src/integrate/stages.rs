//! The stages of a step and their weighted sums.

/// Most stages that a step or its dense output needs (DOP853: 12, one at the end, 3 for the dense output).
pub(super) const MOST: usize = 16;

/// Derivatives (of a Rosenbrock method: increments) of the stages of one step.
pub(super) type Stages<const N: usize> = [[f64; N]; MOST];

/// Of more states than this, sums are one loop for all stages: unrolled, they would be a tenth of the module.
const FEW: usize = 4;

/// Σ weightⱼ kⱼ. Weights are constants of a table: the loops unroll and the zeros vanish.
#[inline(always)]
pub(super) fn weighted<const N: usize>(weights: &[f64], k: &Stages<N>) -> [f64; N] {
    if N > FEW { of_many(weights, k) } else { sum_of(weights, k) }
}

#[inline(never)]
fn of_many<const N: usize>(weights: &[f64], k: &Stages<N>) -> [f64; N] {
    sum_of(weights, k)
}

#[inline(always)]
fn sum_of<const N: usize>(weights: &[f64], k: &Stages<N>) -> [f64; N] {
    let mut sum = [0.0; N];
    for (weight, derivative) in weights.iter().zip(k) {
        if *weight != 0.0 {
            for i in 0..N {
                sum[i] += weight * derivative[i];
            }
        }
    }
    sum
}

/// x + h Σ weightⱼ kⱼ, with the last derivative, which is the last to be known, on the shortest way.
#[inline(always)]
pub(super) fn moved<const N: usize>(x: &[f64; N], h: f64, weights: &[f64], k: &Stages<N>) -> [f64; N] {
    if N > FEW { moved_by_many(x, h, weights, k) } else { moved_by(x, h, weights, k) }
}

#[inline(never)]
fn moved_by_many<const N: usize>(x: &[f64; N], h: f64, weights: &[f64], k: &Stages<N>) -> [f64; N] {
    moved_by(x, h, weights, k)
}

#[inline(always)]
fn moved_by<const N: usize>(x: &[f64; N], h: f64, weights: &[f64], k: &Stages<N>) -> [f64; N] {
    let Some((last, earlier)) = weights.split_last() else { return *x };
    let (sum, last) = (sum_of(earlier, k), h * last);
    std::array::from_fn(|i| (x[i] + h * sum[i]) + last * k[earlier.len()][i])
}

/// What one try of a step gives.
pub(super) struct Attempt<const N: usize> {
    /// The state at its end.
    pub end: [f64; N],
    /// The state of the last stage at the end's time: with its derivative it tells how stiff the equations are.
    pub last_stage: [f64; N],
}
