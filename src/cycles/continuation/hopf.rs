//! A cycle's birth at a Hopf point.

use nalgebra::{Complex, DMatrix};

use super::{
    family::Family,
    field::{self, Field},
    newton::{Chart, Place, Solved, correct},
};
use crate::{
    cycles::{
        shooting::is_odd,
        vector::{complex, imaginary, matrix, norm, real, sum, vector},
    },
    error::Result,
    stability::{Crossing, Linearisation, Triangle},
};

/// The first cycle's size, in units of the typical one, and how often it is halved where it is not found.
const FIRST: f64 = 0.02;
const HALVINGS: usize = 6;
/// How far small cycles must be within the same pieces of the laws for the Lyapunov coefficient to say which way the branch
/// goes, in units of the first state's typical size.
const SMOOTH: f64 = 0.2;
/// Beyond this no piece matters.
const FARTHEST: f64 = 10.0;
/// A growth by less than this part of ω at the typical size is rounding: the gear is linear.
const LINEAR: f64 = 1e-9;
/// By which part of the range the parameter is changed to see how eigenvalues move.
const ALONG: f64 = 1e-6;

/// Which way the branch goes at a Hopf point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Criticality {
    /// Cycles are where rest has become unstable: they grow from nothing.
    Supercritical,
    /// Cycles are where rest is stable still: small swings fade, larger ones do not.
    Subcritical,
    /// All at the same value: a linear gear.
    Degenerate,
}

impl Criticality {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Supercritical => "supercritical",
            Self::Subcritical => "subcritical",
            Self::Degenerate => "degenerate",
        }
    }
}

/// What tells the [`Criticality`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Told {
    /// The first Lyapunov coefficient: the laws are smooth around rest.
    Lyapunov,
    /// The branch's direction where its cycles have come through the nearest kink.
    Branch,
}

impl Told {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lyapunov => "lyapunov",
            Self::Branch => "branch",
        }
    }
}

/// A gear at rest along a range.
pub(super) struct AtRest<'a> {
    /// At a value of the parameter.
    pub rest: &'a dyn Fn(f64) -> Result<Linearisation>,
    /// The states' typical sizes.
    pub scales: Vec<f64>,
    pub low: f64,
    pub high: f64,
}

/// A Hopf point.
#[derive(Clone, Debug)]
pub(super) struct Hopf {
    pub value: f64,
    /// \[Hz\].
    pub frequency: f64,
    /// By how much the growth rate changes with the square of the amplitude, in units of the typical size \[1/s\].
    pub lyapunov: f64,
    /// The growth rate's slope along the parameter.
    growth: f64,
    /// How far small cycles stay within the same pieces of the laws.
    pub reach: f64,
    rest: Vec<f64>,
    /// The swing Re(q e^{iωt}): where it starts and where it is a quarter of a period before.
    shape: [Vec<f64>; 2],
}

impl Hopf {
    /// The Hopf point of a crossing; none where there is none in finite numbers.
    ///
    /// # Errors
    /// A gear that has no equilibrium there.
    pub fn of(family: &mut dyn Family, gear: &AtRest, crossing: &Crossing) -> Result<Option<Self>> {
        let AtRest { rest, scales, low, high } = gear;
        let at = rest(crossing.value)?;
        let n = scales.len();
        let scaled = |jacobian: &DMatrix<f64>| matrix(n, &|i, j| jacobian[(i, j)] * scales[j] / scales[i]);
        let jacobian = scaled(&at.jacobian);
        let equilibrium = vector(n, &|i| at.equilibrium[i] / scales[i]);
        let turning = std::f64::consts::TAU * crossing.frequency;
        let mut right = null_vector(&jacobian, Complex::new(0.0, turning));
        // The first state where it takes part.
        let largest = right.iter().fold(0.0, |most: f64, part| most.max(part.norm()));
        let by = right.iter().find(|part| part.norm() > 1e-9 * largest).copied().unwrap_or(1.0.into());
        right.iter_mut().for_each(|part| *part /= by);
        let mut left = null_vector(&jacobian.transpose(), Complex::new(0.0, -turning));
        let product = inner(&left, &right).conj();
        left.iter_mut().for_each(|part| *part /= product);
        if !family.vary(crossing.value) || !right.iter().chain(&left).all(|part| part.norm().is_finite()) {
            return Ok(None);
        }
        // dλ/dp = ⟨left, J′ right⟩.
        let aside = ALONG * (high - low);
        let (before, after) = ((crossing.value - aside).max(*low), (crossing.value + aside).min(*high));
        let (before_it, after_it) = (rest(before)?.jacobian, rest(after)?.jacobian);
        let change = scaled(&matrix(n, &|i, j| after_it[(i, j)] - before_it[(i, j)]));
        let growth = inner(&left, &applied(&change, &right)).re / (after - before);
        let shape = [real(&right), imaginary(&right)];
        let mut hopf = Self {
            value: crossing.value,
            frequency: crossing.frequency,
            lyapunov: 0.0,
            growth,
            reach: 0.0,
            rest: equilibrium,
            shape,
        };
        hopf.reach = hopf.reach(family);
        hopf.lyapunov = 0.25 * hopf.normal_form(family, &jacobian, &right, &left).re;
        Ok(hopf.lyapunov.is_finite().then_some(hopf))
    }

    /// ω.
    fn turning(&self) -> f64 {
        std::f64::consts::TAU * self.frequency
    }

    /// The growth does not change with the amplitude.
    pub fn is_linear(&self) -> bool {
        self.reach >= FARTHEST && self.lyapunov.abs() <= LINEAR * self.turning()
    }

    /// A state of the small swing of an amplitude, by its phase.
    fn swing(&self, amplitude: f64, phase: f64) -> Vec<f64> {
        let (sine, cosine) = phase.sin_cos();
        let part = |i: usize| self.shape[0][i] * cosine - self.shape[1][i] * sine;
        vector(self.rest.len(), &|i| self.rest[i] + amplitude * part(i))
    }

    /// The largest amplitude of a swing within the pieces of the laws that hold at rest.
    fn reach(&self, family: &dyn Family) -> f64 {
        let pieces = family.pieces(&self.rest);
        let phases = 64;
        let within = |amplitude: f64| {
            (0..phases).all(|k| {
                let phase = f64::from(k) * std::f64::consts::TAU / f64::from(phases);
                family.pieces(&self.swing(amplitude, phase)) == pieces
            })
        };
        if within(FARTHEST) {
            return FARTHEST;
        }
        let (mut low, mut high) = (0.0, FARTHEST);
        while high - low > 1e-3 * high && high > 1e-12 {
            let middle = 0.5 * (low + high);
            *(if within(middle) { &mut low } else { &mut high }) = middle;
        }
        low
    }

    /// The coefficient c₁ of ż = λz + c₁z|z|² on the centre manifold, x − x₀ = zq + z̄q̄ + ….
    ///
    /// # Equations
    /// With the second and third derivatives B and C of f at rest
    /// ```text
    /// c₁ = ½ ⟨p, C(q, q, q̄) − 2B(q, J⁻¹B(q, q̄)) + B(q̄, (2iω − J)⁻¹B(q, q))⟩
    /// ```
    /// They are taken along straight lines through rest, by central differences of halved steps, extrapolated.
    ///
    /// # References
    /// Yu. A. Kuznetsov, *Elements of Applied Bifurcation Theory*, 3rd ed., 2004, section 5.4.
    fn normal_form(
        &self,
        family: &mut dyn Family,
        jacobian: &DMatrix<f64>,
        right: &[Complex<f64>],
        left: &[Complex<f64>],
    ) -> Complex<f64> {
        let [a, b] = &self.shape;
        let room = field::ASIDE.min(0.5 * self.reach);
        let mut field = Field { family, rest: &self.rest, room };
        let (square_a, square_b) = (field.second(a), field.second(b));
        let mixed = field.bilinear(a, b);
        let n = a.len();
        let minus = complex(n, &|i| Complex::from(-square_a[i] - square_b[i]));
        let mean = Triangle::of(jacobian, 0.0.into(), &minus).solution(0.0);
        let twice = complex(n, &|i| -Complex::new(square_a[i] - square_b[i], 2.0 * mixed[i]));
        let double = Triangle::of(jacobian, Complex::new(0.0, 2.0 * self.turning()), &twice).solution(0.0);
        let conjugate = complex(n, &|i| right[i].conj());
        let by_mean = field.complex_bilinear(right, &mean);
        let by_double = field.complex_bilinear(&conjugate, &double);
        // C(q, q, q̄) by third derivatives along a, b, a + b and a − b.
        let (plus, minus) = (sum(a, 1.0, b), sum(a, -1.0, b));
        let [third_a, third_b, plus, minus] = [a, b, &plus, &minus].map(|way| field.third(way));
        let cubic = |i: usize| {
            let real = third_a[i] + (plus[i] + minus[i] - 2.0 * third_a[i]) / 6.0;
            let imaginary = third_b[i] + (plus[i] - minus[i] - 2.0 * third_b[i]) / 6.0;
            Complex::new(real, imaginary)
        };
        let all = complex(n, &|i| cubic(i) + 2.0 * by_mean[i] + by_double[i]);
        0.5 * inner(left, &all)
    }

    /// The first cycle of the branch, and the way it goes on.
    pub fn first(&self, family: &mut dyn Family, low: f64, high: f64) -> Option<(Solved, Chart, Vec<f64>)> {
        let x = self.swing(FIRST, 0.0);
        family.vary(self.value).then_some(())?;
        let symmetric = norm(&self.rest) < 1e-12 && is_odd(family.flow(), &x);
        let mut amplitude = FIRST.min(0.5 * self.reach);
        for _ in 0..HALVINGS {
            let way = sum(&self.swing(amplitude, 0.0), -1.0, &self.rest);
            let size = norm(&way);
            let sign = if symmetric { -1.0 } else { 1.0 };
            let chart = Chart { sign, size, low, high };
            let period = 1.0 / self.frequency;
            let time = if symmetric { 0.5 * period } else { period };
            // Where growth and what the amplitude makes of it cancel.
            let shift = -self.lyapunov * amplitude * amplitude / self.growth;
            let value = if shift.abs() < 0.1 * (high - low) { self.value + shift } else { self.value };
            let x = self.swing(amplitude, 0.0);
            let border = vector(way.len() + 2, &|i| way.get(i).map_or(0.0, |part| part / size));
            family.flow().pace(period, 1.0);
            let place = Place { x, time, value: value.max(low).min(high) };
            if let Some(solved) = correct(family, &chart, &place, &border)
                && (low..=high).contains(&solved.place.value)
            {
                return Some((solved, chart, border));
            }
            amplitude *= 0.5;
        }
        None
    }

    /// Which way the branch goes, and what tells it; `branch` has the first state's amplitudes on it in units of the typical
    /// size, and its values.
    pub fn criticality(&self, branch: &[(f64, f64)]) -> Option<(Criticality, Told)> {
        let of = |super_critical: bool| {
            if super_critical { Criticality::Supercritical } else { Criticality::Subcritical }
        };
        if self.reach < SMOOTH {
            let (_, value) = branch.iter().find(|(amplitude, _)| *amplitude > 1.02 * self.reach)?;
            return Some((of((value - self.value) * self.growth > 0.0), Told::Branch));
        }
        let told = if self.is_linear() { Criticality::Degenerate } else { of(self.lyapunov < 0.0) };
        Some((told, Told::Lyapunov))
    }
}

/// A vector that a matrix, less `shift` on its diagonal, makes nothing of.
pub(super) fn null_vector(matrix: &DMatrix<f64>, shift: Complex<f64>) -> Vec<Complex<f64>> {
    let n = matrix.nrows();
    let size = matrix.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let mut vector = complex(n, &|i| Complex::new(1.0, 0.1 * i as f64));
    for _ in 0..3 {
        vector = Triangle::of(matrix, shift, &vector).solution(f64::EPSILON * size);
        let length = vector.iter().fold(0.0, |sum: f64, part| sum + part.norm_sqr()).sqrt();
        vector.iter_mut().for_each(|part| *part /= length);
    }
    vector
}

/// ⟨a, b⟩ = Σ āb.
fn inner(a: &[Complex<f64>], b: &[Complex<f64>]) -> Complex<f64> {
    a.iter().zip(b).fold(Complex::from(0.0), |sum, (a, b)| sum + a.conj() * b)
}

fn applied(matrix: &DMatrix<f64>, vector: &[Complex<f64>]) -> Vec<Complex<f64>> {
    let row = |i: usize| (0..vector.len()).fold(Complex::from(0.0), |sum, j| sum + vector[j] * matrix[(i, j)]);
    complex(vector.len(), &row)
}
