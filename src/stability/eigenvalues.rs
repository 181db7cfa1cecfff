//! Eigenvalues of a Jacobian.

use nalgebra::{Complex, DMatrix, Schur, linalg::balancing::balance_parlett_reinsch};

use crate::error::{Code, Error, Result, shown};

/// Most sweeps of the QR algorithm; it takes two or three an eigenvalue.
const SWEEPS: usize = 300;

/// The eigenvalues of a square matrix of finite numbers, by falling real part; of a pair the one with the positive
/// imaginary part first, and both with the very same real part. A real eigenvalue has the imaginary part 0.
///
/// The matrix is balanced first, so that their error is of the size of ε |λ| for a system whose states are of very different
/// sizes, too.
///
/// # Errors
/// A matrix so extreme that they leave the numbers.
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<Complex<f64>>> {
    let size = matrix.amax();
    if size == 0.0 {
        return Ok(vec![0.0.into(); matrix.nrows()]);
    }
    let mut balanced = matrix / size;
    balance_parlett_reinsch(&mut balanced);
    let found = triangular(balanced.clone()).map_or_else(
        // Matrices that turn states into each other in a circle stand still under its shifts; moved aside they do not.
        || {
            let aside = balanced.amax();
            let moved = &balanced + DMatrix::identity(matrix.nrows(), matrix.nrows()) * aside;
            triangular(moved).map(|values| values.into_iter().map(|value| value - aside).collect())
        },
        Some,
    );
    let mut values: Vec<Complex<f64>> = found.unwrap_or_default().into_iter().map(|value| value * size).collect();
    let bad = values.iter().flat_map(|value| [value.re, value.im]).find(|part| !part.is_finite());
    if bad.is_some() || values.len() != matrix.nrows() {
        let (got, allowed) = (shown(bad.unwrap_or(f64::NAN)), "finite: choose less extreme values");
        return Err(Error::new(Code::NotFinite, "the eigenvalues", got, allowed));
    }
    values.sort_by(|a, b| b.re.total_cmp(&a.re).then(a.im.abs().total_cmp(&b.im.abs())).then(b.im.total_cmp(&a.im)));
    Ok(values)
}

fn triangular(matrix: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let schur = Schur::try_new(matrix, f64::EPSILON, SWEEPS)?;
    Some(schur.complex_eigenvalues().iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(rows: &[&[f64]]) -> Vec<Complex<f64>> {
        eigenvalues(&DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j])).unwrap()
    }

    #[test]
    fn they_come_in_order() {
        let got = of(&[
            &[-1.0, 0.0, 0.0, 0.0, 0.0],
            &[0.0, -1.0, 2.0, 0.0, 0.0],
            &[0.0, -2.0, -1.0, 0.0, 0.0],
            &[0.0, 0.0, 0.0, 3.0, 0.0],
            &[0.0, 0.0, 0.0, 0.0, -7.0],
        ]);
        let expected = [(3.0, 0.0), (-1.0, 0.0), (-1.0, 2.0), (-1.0, -2.0), (-7.0, 0.0)];
        assert_eq!(got, expected.map(|(re, im)| Complex::new(re, im)));
    }

    #[test]
    fn zero_is_zero() {
        assert_eq!(of(&[&[0.0, 0.0], &[0.0, 0.0]]), [Complex::from(0.0); 2]);
        assert_eq!(of(&[&[0.0, 1.0], &[0.0, 0.0]]), [Complex::from(0.0); 2]);
        assert_eq!(of(&[&[5.0]]), [Complex::from(5.0)]);
    }

    #[test]
    fn a_circle_of_states_does_not_hold_it_up() {
        let got = of(&[&[0.0, 0.0, 1.0], &[1.0, 0.0, 0.0], &[0.0, 1.0, 0.0]]);
        for (got, expected) in got.iter().zip([(1.0, 0.0), (-0.5, 0.75_f64.sqrt()), (-0.5, -0.75_f64.sqrt())]) {
            // Some roundings more than without the way round.
            assert!((got - Complex::new(expected.0, expected.1)).norm() < 1e-14, "{got}");
        }
    }

    #[test]
    fn sizes_do_not_matter() {
        for size in [1e-300, 1e-20, 1e20, 1e300] {
            let got = of(&[&[0.0, size, 0.0], &[-4.0 * size, 0.0, 0.0], &[0.0, 0.0, -size]]);
            assert!((got[0] / size - Complex::new(0.0, 2.0)).norm() < 1e-15, "{got:?}");
        }
    }
}
