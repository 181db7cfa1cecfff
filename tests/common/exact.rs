//! Problems whose motion is known.

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{DMatrix, DVector};
use shimmy::{
    element::{Boundary, Side},
    model::{Mode, System},
    real::Real,
};

/// A system with a motion in closed form.
pub trait Exact<const N: usize>: System<N> {
    /// The state at time `t`.
    fn exact(&self, t: f64) -> [f64; N];
}

/// ẋ = A x, solved by the matrix exponential.
#[derive(Clone)]
pub struct Linear<const N: usize> {
    pub rows: [[f64; N]; N],
    pub start: [f64; N],
}

impl Linear<4> {
    /// Two damped oscillators that drive each other: eigenvalues near −0.1 ± 2i and −0.1 ± i.
    pub fn coupled() -> Self {
        Self {
            rows: [[0.0, 1.0, 0.0, 0.0], [-3.0, -0.2, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0], [1.0, 0.0, -2.0, -0.2]],
            start: [1.0, 0.0, -0.5, 0.3],
        }
    }
}

impl Linear<2> {
    /// Eigenvalues −1 and −`fast`, with eigenvectors that both states share.
    pub fn two_scales(fast: f64) -> Self {
        // V diag(−1, −fast) V⁻¹ with V = [[1, 1], [1, −1]].
        let (sum, difference) = (-0.5 * (1.0 + fast), -0.5 * (1.0 - fast));
        Self { rows: [[sum, difference], [difference, sum]], start: [1.0, 0.0] }
    }
}

impl<const N: usize> System<N> for Linear<N> {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; N]) -> [R; N] {
        self.rows.map(|row| (0..N).fold(R::from(0.0), |sum, i| sum + x[i] * row[i]))
    }
}

impl<const N: usize> Exact<N> for Linear<N> {
    fn exact(&self, t: f64) -> [f64; N] {
        let flow = (DMatrix::from_fn(N, N, |i, j| self.rows[i][j]) * t).exp();
        let x = flow * DVector::from_column_slice(&self.start);
        std::array::from_fn(|i| x[i])
    }
}

/// ẍ + x = 0 from x = 1: its energy stays.
#[derive(Clone)]
pub struct Oscillator;

impl System<2> for Oscillator {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        [x[1], -x[0]]
    }
}

impl Exact<2> for Oscillator {
    fn exact(&self, t: f64) -> [f64; 2] {
        [t.cos(), -t.sin()]
    }
}

/// Stuart–Landau: ṙ = r − r³, φ̇ = ω − r² in polar coordinates. Its cycle is the unit circle, of period 2π/(ω − 1).
///
/// r² = 1/(1 + (1/r₀² − 1) e^(−2t)), and ∫ r² dt = ½ ln(1 + r₀² (e^(2t) − 1)).
#[derive(Clone)]
pub struct StuartLandau {
    pub frequency: f64,
    pub start: f64,
}

impl System<2> for StuartLandau {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        let [x, y] = *x;
        let size = x * x + y * y;
        let growth = -size + 1.0;
        let turn = -size + self.frequency;
        [x * growth - y * turn, y * growth + x * turn]
    }
}

impl Exact<2> for StuartLandau {
    fn exact(&self, t: f64) -> [f64; 2] {
        let r0 = self.start * self.start;
        let r = (1.0 + (1.0 / r0 - 1.0) * (-2.0 * t).exp()).sqrt().recip();
        let phase = self.frequency * t - 0.5 * (r0 * (2.0 * t).exp_m1()).ln_1p();
        [r * phase.cos(), r * phase.sin()]
    }
}

/// ẋ = 3 x cos 3t, a system that depends on the time: x = exp(sin 3t).
#[derive(Clone)]
pub struct Modulated;

impl System<1> for Modulated {
    fn rate<R: Real>(&self, t: R, _mode: Mode, x: &[R; 1]) -> [R; 1] {
        [x[0] * (t * 3.0 + FRAC_PI_2).sin() * 3.0]
    }
}

impl Exact<1> for Modulated {
    fn exact(&self, t: f64) -> [f64; 1] {
        [(3.0 * t).sin().exp()]
    }
}

/// ẍ + x = sin Ωt from x = 1: x = cos t + (sin Ωt − Ω sin t)/(1 − Ω²).
#[derive(Clone)]
pub struct Forced {
    pub frequency: f64,
}

impl System<2> for Forced {
    fn rate<R: Real>(&self, t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        [x[1], (t * self.frequency).sin() - x[0]]
    }
}

impl Exact<2> for Forced {
    fn exact(&self, t: f64) -> [f64; 2] {
        let w = self.frequency;
        let room = 1.0 - w * w;
        [t.cos() + ((w * t).sin() - w * t.sin()) / room, -t.sin() + w * ((w * t).cos() - t.cos()) / room]
    }
}

/// A. Prothero, A. Robinson, *Math. Comp.* 28 (1974) 145–162: ẋ = −λ (x − sin t) + cos t, stiff for large λ; x = sin t.
#[derive(Clone)]
pub struct ProtheroRobinson {
    pub stiffness: f64,
}

impl System<1> for ProtheroRobinson {
    fn rate<R: Real>(&self, t: R, _mode: Mode, x: &[R; 1]) -> [R; 1] {
        [(t.sin() - x[0]) * self.stiffness + (t + FRAC_PI_2).sin()]
    }
}

impl Exact<1> for ProtheroRobinson {
    fn exact(&self, t: f64) -> [f64; 1] {
        [t.sin()]
    }
}

/// ẍ − μ(1 − x²)ẋ + x = 0.
#[derive(Clone)]
pub struct VanDerPol {
    pub mu: f64,
}

impl System<2> for VanDerPol {
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
        let [x, v] = *x;
        [v, (-(x * x) + 1.0) * v * self.mu - x]
    }
}

/// A mass between two springs with a gap: ẍ = −ω² s(x), s as in the torsional gear. From x = 0 with the speed v it
/// flies to the gap's end, swings on the spring for half a period, and flies back with the same speed.
#[derive(Clone)]
pub struct BetweenSprings {
    pub gap: f64,
    pub frequency: f64,
    pub speed: f64,
}

impl BetweenSprings {
    /// Time from x = 0 to the end of the gap.
    fn flight(&self) -> f64 {
        self.gap / self.speed
    }

    /// Time on a spring.
    fn swing(&self) -> f64 {
        PI / self.frequency
    }

    /// Time of event `index`.
    pub fn event(&self, index: usize) -> f64 {
        let (swings, flights) = (index.div_ceil(2), index / 2);
        self.flight() * (1.0 + 2.0 * flights as f64) + self.swing() * swings as f64
    }
}

impl System<2> for BetweenSprings {
    const SWITCHES: usize = 2;
    const EVENT_KINDS: &'static [&'static str] = &["upper", "lower"];

    fn rate<R: Real>(&self, _t: R, mode: Mode, x: &[R; 2]) -> [R; 2] {
        let wound = match mode.side(0) {
            Side::Within => R::from(0.0),
            Side::Above => x[0] - self.gap,
            Side::Below => x[0] + self.gap,
        };
        [x[1], wound * -(self.frequency * self.frequency)]
    }

    fn mode(&self, _t: f64, x: &[f64; 2]) -> Mode {
        Mode::default().with_side(0, Side::of(x[0], x[1], self.gap))
    }

    fn switch<R: Real>(&self, which: usize, _t: R, mode: Mode, x: &[R; 2]) -> Option<R> {
        mode.side(0).margin(boundary(which), x[0], self.gap)
    }

    fn cross(&self, which: usize, _t: f64, mode: Mode, _x: &mut [f64; 2]) -> Mode {
        mode.with_side(0, mode.side(0).across(boundary(which)))
    }
}

fn boundary(which: usize) -> Boundary {
    if which == 0 { Boundary::Upper } else { Boundary::Lower }
}

impl Exact<2> for BetweenSprings {
    fn exact(&self, t: f64) -> [f64; 2] {
        let half = 2.0 * self.flight() + self.swing();
        // Counted from the last entry into the gap; the second half of a period mirrors the first.
        let since = t + self.flight();
        let (halves, rest) = ((since / half).floor(), since.rem_euclid(half));
        let sign = if halves as i64 % 2 == 0 { 1.0 } else { -1.0 };
        let [x, v] = if rest < 2.0 * self.flight() {
            [self.speed * rest - self.gap, self.speed]
        } else {
            let phase = self.frequency * (rest - 2.0 * self.flight());
            [self.gap + self.speed / self.frequency * phase.sin(), self.speed * phase.cos()]
        };
        [sign * x, sign * v]
    }
}

/// A driven switch: ẋ = 1 where sin ωt > 0, −1 where not. Its events depend on the time alone: t = nπ/ω.
#[derive(Clone)]
pub struct Zigzag {
    pub frequency: f64,
}

impl System<1> for Zigzag {
    const SWITCHES: usize = 1;
    const EVENT_KINDS: &'static [&'static str] = &["turn"];

    fn rate<R: Real>(&self, _t: R, mode: Mode, _x: &[R; 1]) -> [R; 1] {
        [R::from(if mode.side(0) == Side::Above { 1.0 } else { -1.0 })]
    }

    fn mode(&self, t: f64, _x: &[f64; 1]) -> Mode {
        let [wave, slope] = [0.0, FRAC_PI_2].map(|lead| (self.frequency * t + lead).sin());
        let up = wave > 0.0 || (wave == 0.0 && slope > 0.0);
        Mode::default().with_side(0, if up { Side::Above } else { Side::Below })
    }

    fn switch<R: Real>(&self, _which: usize, t: R, mode: Mode, _x: &[R; 1]) -> Option<R> {
        let wave = (t * self.frequency).sin();
        Some(if mode.side(0) == Side::Above { wave } else { -wave })
    }

    fn cross(&self, _which: usize, _t: f64, mode: Mode, _x: &mut [f64; 1]) -> Mode {
        mode.with_side(0, if mode.side(0) == Side::Above { Side::Below } else { Side::Above })
    }
}

impl Exact<1> for Zigzag {
    fn exact(&self, t: f64) -> [f64; 1] {
        let half = PI / self.frequency;
        let rest = t.rem_euclid(2.0 * half);
        [if rest < half { rest } else { 2.0 * half - rest }]
    }
}
