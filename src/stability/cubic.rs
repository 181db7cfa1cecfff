//! The root of a cubic that is farthest to the right, by real numbers alone.

/// Relative length of the Newton step that is the last: the next one would be its square.
const ARRIVED: f64 = 1e-8;

/// The root of s³ + a₂s² + a₁s + a₀ with the largest real part: that, and its imaginary part, ≥ 0.
///
/// `start` takes the real root, shifted, of a neighbour, and gives this one's back; any number will do.
///
/// With s = t − a₂/3 it is t³ + pt + q. On the side of 0 that q's sign does not name lies exactly one real root, and the
/// curve bends one way there: Newton's method comes to it from any point beyond. The other two are those of
/// t² + t₁t + t₁² + p.
///
/// # References
/// W. Kahan, *To Solve a Real Cubic Equation*, Berkeley, 1986.
#[inline(always)]
pub(super) fn rightmost(a2: f64, a1: f64, a0: f64, start: &mut f64) -> (f64, f64) {
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
