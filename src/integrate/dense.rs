//! Dense output: the solution within a step as a polynomial.

/// Coefficients a component can have: DOP853's interpolant is of degree 7.
pub(super) const COEFFICIENTS: usize = 8;

/// x(θ) = c₀ + c₁θ + … for θ from 0 (start of the step) to 1 (its end).
#[derive(Clone, Copy, Debug)]
pub(super) struct Dense<const N: usize> {
    pub c: [[f64; N]; COEFFICIENTS],
}

impl<const N: usize> Dense<N> {
    /// The cubic through both ends with their derivatives `f0`, `f1`: error h⁴ max|x⁗|/384.
    pub fn hermite(x0: &[f64; N], x1: &[f64; N], f0: &[f64; N], f1: &[f64; N], h: f64) -> Self {
        let mut c = [[0.0; N]; COEFFICIENTS];
        for i in 0..N {
            let rise = x1[i] - x0[i];
            c[0][i] = x0[i];
            c[1][i] = h * f0[i];
            c[2][i] = 3.0 * rise - h * (2.0 * f0[i] + f1[i]);
            c[3][i] = h * (f0[i] + f1[i]) - 2.0 * rise;
        }
        Self { c }
    }

    /// From the nested form x₀ + θ(F₀ + (1 − θ)(F₁ + θ(F₂ + (1 − θ)(F₃ + …)))) that interpolants are published in.
    pub fn nested<const F: usize>(x0: &[f64; N], parts: &[[f64; N]; F]) -> Self {
        let mut c = [[0.0; N]; COEFFICIENTS];
        for i in 0..N {
            let mut polynomial = [0.0; COEFFICIENTS];
            for (level, part) in parts.iter().enumerate().rev() {
                polynomial[0] += part[i];
                let mut product = [0.0; COEFFICIENTS];
                if level % 2 == 0 {
                    product[1..].copy_from_slice(&polynomial[..COEFFICIENTS - 1]);
                } else {
                    for power in 0..COEFFICIENTS {
                        product[power] = polynomial[power] - if power > 0 { polynomial[power - 1] } else { 0.0 };
                    }
                }
                polynomial = product;
            }
            polynomial[0] += x0[i];
            for power in 0..COEFFICIENTS {
                c[power][i] = polynomial[power];
            }
        }
        Self { c }
    }

    /// Slope of `component` per θ.
    pub fn slope(&self, theta: f64, component: usize) -> f64 {
        (1..COEFFICIENTS).rev().fold(0.0, |sum, power| sum * theta + power as f64 * self.c[power][component])
    }

    /// The state at θ.
    #[inline(always)]
    pub fn at(&self, theta: f64) -> [f64; N] {
        let mut x = self.c[COEFFICIENTS - 1];
        for coefficients in self.c.iter().rev().skip(1) {
            for i in 0..N {
                x[i] = x[i] * theta + coefficients[i];
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nested_form_is_converted_exactly() {
        let parts = [[1.5], [-0.3], [0.7], [2.0], [-1.1], [0.4], [0.9]];
        let dense = Dense::nested(&[0.25], &parts);
        for theta in [0.0, 0.1, 0.5, 0.77, 1.0] {
            let mut nested = 0.0;
            for (level, part) in parts.iter().enumerate().rev() {
                nested = (nested + part[0]) * if level % 2 == 0 { theta } else { 1.0 - theta };
            }
            assert!((dense.at(theta)[0] - 0.25 - nested).abs() < 1e-14);
        }
    }

    #[test]
    fn hermite_reproduces_a_cubic() {
        let cubic = |t: f64| 1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t;
        let slope = |t: f64| -2.0 + 6.0 * t - 1.5 * t * t;
        let (t0, h) = (0.3, 0.8);
        let dense = Dense::hermite(&[cubic(t0)], &[cubic(t0 + h)], &[slope(t0)], &[slope(t0 + h)], h);
        for theta in [0.0, 0.2, 0.6, 1.0] {
            assert!((dense.at(theta)[0] - cubic(t0 + theta * h)).abs() < 1e-14);
        }
    }
}
