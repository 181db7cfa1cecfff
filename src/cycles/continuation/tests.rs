//! Branches whose every cycle is known: circles in the first two states, and what happens beside them.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::{
    family::{Family, tests::family},
    hopf::{AtRest, Criticality, Hopf, Told},
    newton::{Chart, Place, correct},
    special::PointKind,
    stop::Stop,
    walk::{BranchEnd, Limits, Walk},
};
use crate::{
    cycles::shooting::is_odd,
    model::{Gear, Mode, System},
    real::Real,
    stability::{Crossing, CurveKind, at_rest},
};

const LIMITS: Limits = Limits { points: 500, step: 0.02, tolerance: 1e-7 };

/// ṙ = r g(r²), φ̇ = ω + b r², with g = p + a r² − r⁴.
#[derive(Clone)]
struct Bend(f64);
const TURNING: f64 = 5.0;
const TWIST: f64 = -0.7;

/// ṙ = r (¼ − p² − (r² − 1)²), φ̇ = 3: the cycles are a ring over p.
#[derive(Clone)]
struct Ring(f64);

/// The unit circle in 1 s, with ż = p z − z³ beside it.
#[derive(Clone)]
struct Fork(f64);

/// The unit circle in 1 s, with two states beside it that turn by 2 rad/s and grow with p.
#[derive(Clone)]
struct Torus(f64);

/// The unit circle in 1 s, with two states beside it in axes that turn half as fast: along one they grow with p, along the
/// other they fade.
#[derive(Clone)]
struct Twisted(f64);

fn circle<R: Real>(x: R, y: R, growth: R, turning: R) -> [R; 2] {
    [x * growth - y * turning, y * growth + x * turning]
}

impl System<2> for Bend {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        let square = x[0] * x[0] + x[1] * x[1];
        circle(x[0], x[1], square - square * square + self.0, square * TWIST + TURNING)
    }
}

impl System<2> for Ring {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        let off = x[0] * x[0] + x[1] * x[1] - 1.0;
        circle(x[0], x[1], -(off * off) + (0.25 - self.0 * self.0), R::from(3.0))
    }
}

impl System<3> for Fork {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 3]) -> [R; 3] {
        let off = x[0] * x[0] + x[1] * x[1] - 1.0;
        let [u, v] = circle(x[0], x[1], -off, R::from(TAU));
        [u, v, x[2] * self.0 - x[2] * x[2] * x[2]]
    }
}

impl System<4> for Torus {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 4]) -> [R; 4] {
        let off = x[0] * x[0] + x[1] * x[1] - 1.0;
        let [u, v] = circle(x[0], x[1], -off, R::from(TAU));
        let square = x[2] * x[2] + x[3] * x[3];
        let [z, w] = circle(x[2], x[3], -square + self.0, R::from(2.0));
        [u, v, z, w]
    }
}

impl System<4> for Twisted {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 4]) -> [R; 4] {
        let [x, y, z, w] = *x;
        let [u, v] = circle(x, y, -(x * x + y * y - 1.0), R::from(TAU));
        // R(φ/2) diag(p, −1) R(−φ/2), with cos φ = x and sin φ = y on the circle.
        let (mean, half) = (0.5 * (self.0 - 1.0), 0.5 * (self.0 + 1.0));
        let turn = 0.5 * TAU;
        let cubic = z * z + w * w;
        [
            u,
            v,
            z * mean + (x * z + y * w) * half - w * turn - cubic * z,
            w * mean + (y * z - x * w) * half + z * turn - cubic * w,
        ]
    }
}

macro_rules! gears {
    ($($n:literal $system:ty;)*) => {
        $(impl Gear<$n> for $system {
            fn kicked(&self, x: &[f64; $n], _impulse: f64) -> [f64; $n] {
                *x
            }
        })*
    };
}
gears! { 2 Bend; 2 Ring; 3 Fork; 4 Torus; 4 Twisted; 2 Planar; }

/// From a cycle at a value on to where the branch ends.
fn walked(
    family: &mut dyn Family,
    x: &[f64],
    period: f64,
    value: f64,
    range: [f64; 2],
    ahead: f64,
) -> (Walk, BranchEnd) {
    // An even part that is only beside the circle does not show on it.
    let aside: Vec<f64> = x.iter().map(|x| x + 0.1).collect();
    let symmetric = is_odd(family.flow(), &aside);
    let (sign, time) = if symmetric { (-1.0, 0.5 * period) } else { (1.0, period) };
    let chart = Chart { sign, size: 1.0, low: range[0], high: range[1] };
    let along: Vec<f64> = (0..x.len() + 2).map(|j| if j == x.len() + 1 { ahead } else { 0.0 }).collect();
    family.flow().pace(period, 1.0);
    let solved = correct(family, &chart, &Place { x: x.to_vec(), time, value }, &along).expect("a cycle");
    let start = Stop::of(family, &chart, solved, &along).unwrap();
    finished(family, Walk::new(start, LIMITS))
}

fn finished(family: &mut dyn Family, mut walk: Walk) -> (Walk, BranchEnd) {
    loop {
        if let Some(end) = walk.advance(family) {
            return (walk, end);
        }
    }
}

/// p + r² − r⁴ = 0: born at p = 0 towards lower values, back at p = −¼ with r² = ½.
#[test]
fn a_branch_goes_through_its_fold_and_every_cycle_on_it_is_right() {
    let mut family = family(Bend, 0.0);
    let frequency = TURNING / TAU;
    let crossing = Crossing { value: 0.0, kind: CurveKind::Hopf, frequency };
    let gear = AtRest { rest: &|value| at_rest(&Bend(value)), scales: vec![1.0; 2], low: -1.0, high: 0.5 };
    let hopf = Hopf::of(&mut family, &gear, &crossing).unwrap().unwrap();
    assert!((hopf.lyapunov - 1.0).abs() < 1e-9, "{}", hopf.lyapunov);
    assert_eq!(hopf.criticality(&[]), Some((Criticality::Subcritical, Told::Lyapunov)));
    let (solved, chart, ahead) = hopf.first(&mut family, -1.0, 0.5).unwrap();
    let start = Stop::of(&mut family, &chart, solved, &ahead).unwrap();
    let (walk, end) = finished(&mut family, Walk::new(start, LIMITS));
    assert_eq!(end, BranchEnd::Range);
    let [(PointKind::Fold, fold)] = walk.special[..] else { panic!("{:?}", walk.special) };
    let fold = &walk.stops[fold].point;
    assert!((fold.value + 0.25).abs() < 1e-9 && (fold.amplitude[0] - 0.5_f64.sqrt()).abs() < 1e-6, "{fold:?}");
    for stop in &walk.stops {
        let point = &stop.point;
        let square = point.amplitude[0].powi(2);
        let period = TAU / (TURNING + TWIST * square);
        // r g(r²) has the slope 2 r² g′ where g = 0.
        let multiplier = (2.0 * square * (1.0 - 2.0 * square) * period).exp();
        assert!((point.value + square - square * square).abs() < 1e-8, "{point:?}");
        assert!((point.period / period - 1.0).abs() < 1e-8, "{point:?}");
        assert!((point.multipliers[0] - 1.0).norm() < 1e-6, "{point:?}");
        assert!((point.multipliers[1] / multiplier - 1.0).norm() < 1e-6, "{point:?} {multiplier}");
        let unstable = usize::from(square < 0.5);
        assert!(point.unstable == unstable || std::ptr::eq(point, fold), "{point:?}");
        assert!((point.state[0]).abs() < 1e-9 && point.symmetric);
    }
    assert_eq!(walk.stops.last().unwrap().point.value, 0.5);
}

#[test]
fn a_ring_closes() {
    let mut family = family(Ring, 0.0);
    let (walk, end) = walked(&mut family, &[1.2, 0.0], TAU / 3.0, 0.1, [-1.0, 1.0], 1.0);
    assert_eq!(end, BranchEnd::Closed);
    let mut folds: Vec<f64> = walk.special.iter().map(|(_, place)| walk.stops[*place].point.value).collect();
    folds.sort_by(f64::total_cmp);
    assert_eq!(folds.len(), 2);
    assert!((folds[0] + 0.5).abs() < 1e-9 && (folds[1] - 0.5).abs() < 1e-9, "{folds:?}");
    for stop in &walk.stops {
        let off = stop.point.amplitude[0].powi(2) - 1.0;
        assert!((stop.point.value.powi(2) + off * off - 0.25).abs() < 1e-7);
    }
}

/// The kind of special point that is at p = 0, where the circle's other multipliers are known.
fn at_zero(family: &mut dyn Family, states: usize, kind: PointKind, multipliers: &dyn Fn(f64) -> Vec<Complex<f64>>) {
    let x: Vec<f64> = (0..states).map(|i| if i == 0 { 1.0 } else { 0.0 }).collect();
    for (from, ahead) in [(-0.3, 1.0), (0.4, -1.0)] {
        let (walk, end) = walked(family, &x, 1.0, from, [-0.3, 0.4], ahead);
        assert_eq!(end, BranchEnd::Range);
        let [(found, place)] = walk.special[..] else { panic!("{:?}", walk.special) };
        assert_eq!(found, kind);
        assert!(walk.stops[place].point.value.abs() < 1e-6, "{}", walk.stops[place].point.value);
        let sides = [place - 1, place + 1].map(|beside| ahead * walk.stops[beside].point.value);
        assert!(sides[0] < 0.0 && sides[1] > 0.0);
        for stop in &walk.stops {
            let point = &stop.point;
            for expected in multipliers(point.value) {
                let nearest = point.multipliers.iter().fold(f64::INFINITY, |n, got| n.min((got - expected).norm()));
                assert!(nearest < 1e-7, "{point:?}: {expected}");
            }
            let unstable = multipliers(point.value).iter().filter(|value| value.norm() > 1.0).count();
            assert!(point.unstable == unstable || point.value.abs() < 1e-6);
        }
    }
}

#[test]
fn where_a_symmetric_cycle_loses_its_symmetry_is_a_branch_point() {
    at_zero(&mut family(Fork, 0.0), 3, PointKind::BranchPoint, &|p| vec![p.exp().into(), (-2_f64).exp().into()]);
}

#[test]
fn a_pair_that_passes_the_unit_circle_is_of_neimark_and_sacker() {
    at_zero(&mut family(Torus, 0.0), 4, PointKind::NeimarkSacker, &|p| {
        [2.0, -2.0].map(|turn| Complex::new(p, turn).exp()).to_vec()
    });
}

#[test]
fn a_multiplier_minus_one_doubles_the_period() {
    at_zero(&mut family(Twisted, 0.0), 4, PointKind::PeriodDoubling, &|p| {
        [p, -1.0].map(|rate| Complex::from(-rate.exp())).to_vec()
    });
}

/// ẋ = −ωy + f, ẏ = ωx + g with squares and cubes, and p on the diagonal.
#[derive(Clone)]
struct Planar(f64);
const OMEGA: f64 = 2.0;
/// Coefficients of x², xy, y² and of x³, x²y, xy², y³, of f and of g.
const SQUARES: [[f64; 3]; 2] = [[0.7, -1.1, 0.4], [-0.3, 0.9, 1.3]];
const CUBES: [[f64; 4]; 2] = [[0.5, -0.2, -1.4, 0.8], [1.1, -0.6, 0.3, -0.9]];

impl System<2> for Planar {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        let [x, y] = *x;
        let part = |i: usize| {
            let [xx, xy, yy] = SQUARES[i];
            let [xxx, xxy, xyy, yyy] = CUBES[i];
            x * x * xx + x * y * xy + y * y * yy + x * x * x * xxx + x * x * y * xxy + x * y * y * xyy + y * y * y * yyy
        };
        [x * self.0 - y * OMEGA + part(0), y * self.0 + x * OMEGA + part(1)]
    }
}

#[test]
fn the_lyapunov_coefficient_of_a_planar_field_is_the_textbooks() {
    // J. Guckenheimer, P. Holmes, Nonlinear Oscillations, Dynamical Systems, and Bifurcations of Vector Fields, 1983, (3.4.11):
    // ṙ = a r³.
    let [[fxx, fxy, fyy], [gxx, gxy, gyy]] = SQUARES.map(|[xx, xy, yy]| [2.0 * xx, xy, 2.0 * yy]);
    let [[fxxx, _, fxyy, _], [_, gxxy, _, gyyy]] =
        CUBES.map(|[xxx, xxy, xyy, yyy]| [6.0 * xxx, 2.0 * xxy, 2.0 * xyy, 6.0 * yyy]);
    let squares = fxy * (fxx + fyy) - gxy * (gxx + gyy) - fxx * gxx + fyy * gyy;
    let expected = (fxxx + fxyy + gxxy + gyyy) / 16.0 + squares / (16.0 * OMEGA);
    let crossing = Crossing { value: 0.0, kind: CurveKind::Hopf, frequency: OMEGA / TAU };
    let gear = AtRest { rest: &|value| at_rest(&Planar(value)), scales: vec![1.0; 2], low: -1.0, high: 1.0 };
    let hopf = Hopf::of(&mut family(Planar, 0.0), &gear, &crossing).unwrap().unwrap();
    assert!((hopf.lyapunov / expected - 1.0).abs() < 1e-8, "{} {expected}", hopf.lyapunov);
}
