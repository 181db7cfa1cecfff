//! Odd functions of a slip ratio as polynomials: fitted once per parameter set, evaluated millions of times.

use std::f64::consts::PI;

use crate::real::Real;

/// Chebyshev nodes of the fit. More than any kept series needs, so that the last coefficients measure what is cut off.
const NODES: usize = 24;

/// `f(x) ≈ s · P(s²)`, s = x/range, with `TERMS` coefficients on |x| ≤ `range`; beyond, and where the series does not
/// reach rounding, the function itself is called.
///
/// The fit is a Chebyshev interpolation of f(√u)/√u in u = s², cut after `TERMS` terms. Its error is the sum of the
/// coefficients cut off, which must lie at rounding (4 · 2⁻⁵² of the terms' size): otherwise `range` is 0 and every call
/// goes to the function. An odd analytic f whose nearest singularity is at x = ±i (arc tangents) converges like
/// (4/range²)⁻ⁿ.
#[derive(Clone, Copy, Debug)]
pub struct OddPolynomial<const TERMS: usize> {
    coefficients: [f64; TERMS],
    /// 1/range
    to_unit: f64,
    range: f64,
}

impl<const TERMS: usize> OddPolynomial<TERMS> {
    /// The function that is 0 everywhere.
    pub fn zero() -> Self {
        Self { coefficients: [0.0; TERMS], to_unit: 0.0, range: f64::INFINITY }
    }

    /// No polynomial: every call goes to the function.
    pub fn none() -> Self {
        // Not 0: at x = 0 the derivative must come from the function, too.
        Self { coefficients: [0.0; TERMS], to_unit: 0.0, range: f64::NEG_INFINITY }
    }

    /// The straight line of this slope.
    pub fn line(slope: f64) -> Self {
        let mut coefficients = [0.0; TERMS];
        coefficients[0] = slope;
        // Beyond, the sixteenth power of x would be infinite; the function itself has none.
        Self { coefficients, to_unit: 1.0, range: 1e18 }
    }

    /// Fits `function` on |x| ≤ `range`.
    ///
    /// `function` must be odd, and analytic on the range; `size` is the size of its terms per unit of x, over all of the
    /// range: the error is measured by it.
    pub fn fit(range: f64, size: f64, function: impl Fn(f64) -> f64) -> Self {
        Self::fit_within(range, 4.0 * f64::EPSILON * size * range, &function)
    }

    /// As [`OddPolynomial::fit`], with an error of at most `tolerance`.
    pub fn fit_within(range: f64, tolerance: f64, function: &dyn Fn(f64) -> f64) -> Self {
        let mut coefficients = [0.0; TERMS];
        if fitted(range, tolerance, function, &mut coefficients) {
            Self { coefficients, to_unit: 1.0 / range, range }
        } else {
            Self::none()
        }
    }

    /// The fitted function at `x`; `function` is called where the polynomial does not reach.
    #[inline(always)]
    pub fn eval<R: Real>(&self, x: R, function: impl Fn(R) -> R) -> R {
        if x.value().abs() > self.range {
            return function(x);
        }
        let s = x * self.to_unit;
        s * estrin(&self.coefficients, s * s)
    }

    /// The coefficients of x, x³, x⁵ …; none where the polynomial does not serve.
    pub fn powers(&self) -> Option<[f64; TERMS]> {
        let mut scale = self.to_unit;
        let powers = self.coefficients.map(|coefficient| {
            let power = coefficient * scale;
            scale *= self.to_unit * self.to_unit;
            power
        });
        (self.range > 0.0 && powers.iter().all(|power| power.is_finite())).then_some(powers)
    }

    /// Largest |x| for which the polynomial serves; 0 where it never does.
    pub fn range(&self) -> f64 {
        self.range.max(0.0)
    }
}

/// Fits as many coefficients as there is room for; false where the error is larger than allowed.
#[inline(never)]
fn fitted(range: f64, tolerance: f64, function: &dyn Fn(f64) -> f64, coefficients: &mut [f64]) -> bool {
    if !(range > 0.0 && range.is_finite() && (1.0 / range).is_finite()) {
        return false;
    }
    // cos(π m/2·NODES): taken from one turn, as large arguments would lose digits.
    let cosines: [f64; 4 * NODES] = std::array::from_fn(|m| (PI * m as f64 / (2 * NODES) as f64).cos());
    let cosine = |m: usize| cosines[m % (4 * NODES)];
    let values: [f64; NODES] = std::array::from_fn(|node| {
        let s = (0.5 * (cosine(2 * node + 1) + 1.0)).sqrt();
        function(s * range) / s
    });
    let chebyshev: [f64; NODES] = std::array::from_fn(|order| {
        let sum: f64 = (0..NODES).map(|node| values[node] * cosine(order * (2 * node + 1))).sum();
        sum * if order == 0 { 1.0 } else { 2.0 } / NODES as f64
    });
    // A series that converges falls from term to term: the first few cut off stand for all. (Rounding leaves about ε/2 in
    // each.)
    let terms = coefficients.len();
    let cut_off: f64 = chebyshev[terms..terms + 4].iter().map(|c| c.abs()).sum();
    to_powers(&chebyshev, coefficients);
    cut_off <= tolerance
}

/// Coefficients of the Chebyshev polynomials T(2u − 1) (as many as there is room for) to powers of u.
fn to_powers(chebyshev: &[f64; NODES], powers: &mut [f64]) {
    let terms = powers.len();
    let [mut before, mut current] = [[0.0; NODES]; 2];
    before[0] = 1.0;
    (current[0], current[1]) = (-1.0, 2.0);
    for order in 0..terms {
        for i in 0..terms {
            powers[i] += chebyshev[order] * before[i];
        }
        let next = std::array::from_fn(|i| {
            let raised = if i > 0 { 2.0 * current[i - 1] } else { 0.0 };
            2.0 * (raised - current[i]) - before[i]
        });
        before = current;
        current = next;
    }
}

/// Estrin's scheme for up to 12 terms: pairs, then pairs of pairs, so that the multiplications do not wait for each
/// other. What a stage of a step costs is the longest chain of operations, not their number.
#[inline(always)]
fn estrin<R: Real, const TERMS: usize>(c: &[f64; TERMS], u: R) -> R {
    const { assert!(TERMS <= 12) };
    let u2 = u * u;
    let pair = |i: usize| if i + 1 < TERMS { u * c[i + 1] + c[i] } else { R::from(c[i]) };
    let quad = |i: usize| if i + 2 < TERMS { u2 * pair(i + 2) + pair(i) } else { pair(i) };
    if TERMS <= 4 {
        return quad(0);
    }
    let u4 = u2 * u2;
    let low = u4 * quad(4) + quad(0);
    if TERMS <= 8 { low } else { low + (u4 * u4) * quad(8) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arc_tangent_is_exact_to_rounding() {
        let fit = OddPolynomial::<8>::fit(0.13, 1.0, f64::atan);
        assert_eq!(fit.range(), 0.13);
        for i in 0..=10_000 {
            let x = 0.13 * i as f64 / 10_000.0;
            let error = (fit.eval(x, |_| f64::NAN) - x.atan()).abs();
            assert!(error <= 3.0 * f64::EPSILON * x, "{x}: {error:e}");
            assert_eq!(fit.eval(-x, |_| f64::NAN), -fit.eval(x, |_| f64::NAN), "odd");
        }
    }

    #[test]
    fn beyond_its_range_the_function_itself_is_called() {
        let fit = OddPolynomial::<8>::fit(0.1, 1.0, f64::atan);
        assert_eq!(fit.eval(0.7, f64::atan), 0.7_f64.atan());
        // Too wide for eight terms: refused at the fit, exact at every call.
        let wide = OddPolynomial::<8>::fit(1.5, 1.0, f64::atan);
        assert_eq!(wide.range(), 0.0);
        assert_eq!(wide.eval(0.3, f64::atan), 0.3_f64.atan());
        for hopeless in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(OddPolynomial::<8>::fit(hopeless, 1.0, f64::atan).range(), 0.0, "{hopeless}");
        }
    }
}
