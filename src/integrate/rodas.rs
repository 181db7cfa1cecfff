//! Rodas5P: an L-stable Rosenbrock method of order 5.

use super::{
    dense::Dense,
    linear::Factors,
    stages::{Attempt, Stages, weighted},
};
use crate::{
    model::{Mode, System},
    real::Dual,
};

// G. Steinebach, Construction of Rosenbrock–Wanner method Rodas5P and numerical benchmarks within the Julia
// Differential Equations package, BIT Numer. Math. 63 (2023) 27. Here in the form without matrix products.
const GAMMA: f64 = 0.211_937_563_194_290_14;
const NODES: [f64; 8] = [
    0.0,
    0.635_812_689_582_870_4,
    0.409_579_839_339_753_5,
    0.976_930_672_506_071_6,
    0.428_840_360_955_866_4,
    1.0,
    1.0,
    1.0,
];
/// Weights of the earlier increments in a stage's state; stages 7 and 8 add the increment before to the stage before.
const A: [[f64; 5]; 6] = [
    [0.0; 5],
    [3.0, 0.0, 0.0, 0.0, 0.0],
    [2.849_394_379_747_939, 0.458_422_422_044_639_23, 0.0, 0.0, 0.0],
    [-6.954_028_509_809_101, 2.489_845_061_869_568, -10.358_996_098_473_584, 0.0, 0.0],
    [2.802_998_627_562_896_4, 0.507_246_473_622_820_6, -0.398_831_254_177_052_4, -0.047_211_872_304_046_41, 0.0],
    [
        -7.502_846_399_306_121,
        2.561_846_144_803_919,
        -11.627_539_656_261_098,
        -0.182_687_676_599_422_56,
        0.030_198_172_008_377_946,
    ],
];
/// Weights (over h) of the earlier increments in a stage's right-hand side.
const CARRY: [[f64; 7]; 8] = [
    [0.0; 7],
    [-14.155_112_264_123_755, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [-17.972_960_358_859_52, -2.859_693_295_451_294, 0.0, 0.0, 0.0, 0.0, 0.0],
    [147.121_502_757_117_16, -1.412_214_027_182_13, 71.689_402_513_023_58, 0.0, 0.0, 0.0, 0.0],
    [165.435_170_248_716_76, -0.459_282_345_649_112_6, 42.909_383_369_586_03, -5.961_986_721_573_306, 0.0, 0.0, 0.0],
    [
        24.854_864_614_690_072,
        -3.000_922_700_283_218_6,
        47.493_111_002_076_8,
        5.581_419_782_155_812_5,
        -0.661_069_182_524_947_1,
        0.0,
        0.0,
    ],
    [
        30.912_732_140_285_99,
        -3.120_824_334_993_797_4,
        77.799_546_460_708_92,
        34.286_460_282_947_83,
        -19.097_331_116_725_623,
        -28.087_943_162_872_662,
        0.0,
    ],
    [
        37.802_771_233_905_63,
        -3.257_196_902_907_227_6,
        112.269_188_494_963_27,
        66.934_723_124_404_7,
        -40.066_189_370_910_02,
        -54.667_802_628_779_68,
        -9.488_616_523_096_27,
    ],
];
/// Weights (times h) of ∂f/∂t in a stage's right-hand side.
const DRIFT: [f64; 8] = [
    GAMMA,
    -0.423_875_126_388_580_27,
    -0.338_462_712_623_592_4,
    1.804_645_287_288_273_4,
    2.325_825_639_765_069,
    0.0,
    0.0,
    0.0,
];
/// Dense output of order 4.
const H: [[f64; 8]; 3] = [
    [
        25.948_786_856_663_858,
        -2.557_972_484_584_623_5,
        10.433_815_404_888_879,
        -2.367_925_102_268_520_4,
        0.524_948_541_321_073,
        1.124_108_831_045_040_4,
        0.427_287_619_443_187_4,
        -0.172_022_210_701_554_93,
    ],
    [
        -9.915_688_506_951_71,
        -0.968_994_459_411_515_4,
        3.043_803_724_297_845_3,
        -24.495_224_566_215_796,
        20.176_138_334_709_044,
        15.980_663_614_246_51,
        -6.789_040_303_419_874,
        -6.710_236_069_923_372,
    ],
    [
        11.419_903_575_922_262,
        2.887_964_514_613_699_4,
        72.921_379_959_960_29,
        80.125_118_346_226_43,
        -52.072_871_366_152_654,
        -59.789_936_252_667_29,
        -0.155_826_842_827_519_13,
        4.883_087_185_713_722,
    ],
];

/// Stages of a step.
pub(super) const STAGES: usize = 8;

/// One step: `k` holds f(t, x) in its first place at the start, and the increments of the stages afterwards. `None`
/// where the matrix is singular.
///
/// Stage i solves (1/(γh) − J) kᵢ = f(t + cᵢh, uᵢ) + Σ Cᵢⱼkⱼ/h + h dᵢ ∂f/∂t.
#[inline(never)]
pub(super) fn attempt<S: System<N>, const N: usize>(
    system: &S,
    mode: Mode,
    t: f64,
    x: &[f64; N],
    h: f64,
    k: &mut Stages<N>,
) -> Option<Attempt<N>> {
    let mut matrix = system.jacobian(t, mode, x).map(|row| row.map(|entry| -entry));
    for (i, row) in matrix.iter_mut().enumerate() {
        row[i] += 1.0 / (GAMMA * h);
    }
    let factors = Factors::of(matrix)?;
    let drift: [f64; N] = {
        let still: [Dual<1>; N] = std::array::from_fn(|i| Dual::from(x[i]));
        system.rate(Dual::variable(t, 0), mode, &still).map(|d| d.slope[0])
    };
    let mut state = *x;
    let mut rate = k[0];
    for stage in 0..STAGES {
        if stage > 0 {
            if stage < A.len() {
                let sum = weighted(&A[stage], k);
                state = std::array::from_fn(|i| x[i] + sum[i]);
            } else {
                state = std::array::from_fn(|i| state[i] + k[stage - 1][i]);
            }
            rate = system.rate(t + NODES[stage] * h, mode, &state);
        }
        let carried = weighted(&CARRY[stage][..stage.min(7)], k);
        k[stage] = factors.solve(&std::array::from_fn(|i| rate[i] + carried[i] / h + h * DRIFT[stage] * drift[i]));
    }
    let end = std::array::from_fn(|i| state[i] + k[STAGES - 1][i]);
    Some(Attempt { end, last_stage: state })
}

/// Estimate of the local error: the last increment.
#[inline(always)]
pub(super) fn error<const N: usize>(k: &Stages<N>) -> [f64; N] {
    k[STAGES - 1]
}

pub(super) fn dense<const N: usize>(x0: &[f64; N], x1: &[f64; N], k: &Stages<N>) -> Dense<N> {
    let [first, second, third] = [weighted(&H[0], k), weighted(&H[1], k), weighted(&H[2], k)];
    // x₀ + θ(Δ + (1 − θ)(first + θ(second + θ third))), and θ third = third − (1 − θ) third.
    let rise = std::array::from_fn(|i| x1[i] - x0[i]);
    let inner = std::array::from_fn(|i| second[i] + third[i]);
    Dense::nested(x0, &[rise, first, inner, third.map(|part| -part)])
}
