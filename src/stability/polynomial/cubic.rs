//! The root of a cubic that is farthest to the right, by real numbers alone.

/// Relative length of the Newton step that is the last: the next one would be its square.
const ARRIVED: f64 = 1e-8;

/// The root of s³ + a₂s² + a₁s + a₀ with the largest real part: that, and its imaginary part, ≥ 0.
///
/// `start` takes the real root, shifted, of a neighbour, and gives this one's back; any finite number will do.
///
/// With s = t − a₂/3 it is t³ + pt + q. On the side of 0 that q's sign does not name lies exactly one real root, and the
/// curve bends one way there: Newton's method comes to it from any point beyond. The other two are those of
/// t² + t₁t + t₁² + p.
///
/// # References
/// W. Kahan, *To Solve a Real Cubic Equation*, Berkeley, 1986.
#[inline(always)]
pub(in crate::stability) fn rightmost(a2: f64, a1: f64, a0: f64, start: &mut f64) -> (f64, f64) {
    let shift = a2 * (1.0 / 3.0);
    let p = a1 - a2 * shift;
    let q = a0 - shift * (a1 - 2.0 * shift * shift);
    let mut t = *start;
    if !(t * q < 0.0 && 3.0 * t * t + p > 0.0) {
        t = beyond(p, q);
    }
    for _ in 0..100 {
        let square = t * t;
        let next = (2.0 * t * square - q) / (3.0 * square + p);
        let step = (next - t).abs();
        t = next;
        if step <= ARRIVED * next.abs() {
            break;
        }
    }
    if q == 0.0 {
        t = 0.0;
    }
    *start = t;
    // ¾t² + p > 0: a pair at −t/2 ± √.
    let square = 0.75 * t * t + p;
    let (real, imaginary) = if q < 0.0 {
        (t, 0.0)
    } else if square > 0.0 {
        (-0.5 * t, square.sqrt())
    } else {
        (-0.5 * t + (-square).sqrt(), 0.0)
    };
    (real - shift, imaginary)
}

/// A point beyond the outermost root on the side that −q names.
#[cold]
fn beyond(p: f64, q: f64) -> f64 {
    // |t|³ ≤ |p||t| + |q|: t is at most 1.3247 (the root of x³ = x + 1) times the larger of √|p| and ∛|q|, whose exponent is
    // a third of q's.
    let cube_root = f64::from_bits(q.abs().to_bits() / 3 + (0x2a9f_7893 << 32)) * 1.1;
    -1.33 * p.abs().sqrt().max(cube_root).copysign(q)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// (s − r)(s² − 2us + u² + w): a real root and a pair u ± i√w, or two real ones where w is negative.
    fn of(r: f64, u: f64, w: f64, start: f64) -> (f64, f64) {
        let product = u * u + w;
        rightmost(-r - 2.0 * u, product + 2.0 * u * r, -r * product, &mut start.clone())
    }

    #[test]
    fn the_rightmost_root_is_found_from_anywhere() {
        for start in [0.0, 1.0, -1e3, 1e9, f64::NAN, 5e-324] {
            for (r, u, w, expected) in [
                (-5.0, -1.0, 9.0, (-1.0, 3.0)),
                (2.0, -1.0, 9.0, (2.0, 0.0)),
                (-300.0, 4.0, 1e5, (4.0, 1e5_f64.sqrt())),
                (-1.0, -3.0, -1.0, (-1.0, 0.0)),
                (-9.0, -3.0, -1.0, (-2.0, 0.0)),
                (-3.0, -3.0, -4.0, (-1.0, 0.0)),
                (0.0, 0.0, 4.0, (0.0, 2.0)),
                (0.0, 0.0, 0.0, (0.0, 0.0)),
                (1e-3, -1e6, 1e12, (1e-3, 0.0)),
            ] {
                let (real, imaginary) = of(r, u, w, start);
                // The coefficients hold a root to rounding of the largest one.
                let size = r.abs().max(u.abs()).max(w.abs().sqrt());
                assert!((real - expected.0).abs() <= 4e-15 * size, "{r} {u} {w} from {start}: {real}");
                assert!((imaginary - expected.1).abs() <= 1e-14 * size, "{r} {u} {w} from {start}: {imaginary}");
            }
        }
    }

    #[test]
    fn a_multiple_root_costs_its_digits_only() {
        let (real, imaginary) = of(-2.0, -2.0, 0.0, 0.0);
        // Where three roots are one, rounding parts them by its cube root.
        assert!((real + 2.0).abs() < 3e-5 && imaginary < 3e-5, "{real} {imaginary}");
    }
}
