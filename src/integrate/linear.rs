//! Linear systems of the size of a state.
//!
//! nalgebra's factorisation asks for bounds on the dimension that every generic caller would have to repeat; a state has
//! at most a few entries, and its elimination is a few lines.

/// A matrix factorised by Gaussian elimination with partial pivoting.
pub(super) struct Factors<const N: usize> {
    rows: [[f64; N]; N],
    order: [usize; N],
}

impl<const N: usize> Factors<N> {
    /// Factorises; `None` where the matrix is singular or not finite.
    #[inline(always)]
    pub fn of(mut rows: [[f64; N]; N]) -> Option<Self> {
        let mut order: [usize; N] = std::array::from_fn(|i| i);
        for column in 0..N {
            let mut pivot = column;
            for row in column + 1..N {
                if rows[row][column].abs() > rows[pivot][column].abs() {
                    pivot = row;
                }
            }
            if !(rows[pivot][column].abs() > 0.0 && rows[pivot][column].is_finite()) {
                return None;
            }
            rows.swap(column, pivot);
            order.swap(column, pivot);
            for row in column + 1..N {
                let factor = rows[row][column] / rows[column][column];
                rows[row][column] = factor;
                for i in column + 1..N {
                    rows[row][i] -= factor * rows[column][i];
                }
            }
        }
        Some(Self { rows, order })
    }

    /// The solution for the right-hand side `side`.
    #[inline(always)]
    pub fn solve(&self, side: &[f64; N]) -> [f64; N] {
        let mut x: [f64; N] = std::array::from_fn(|i| side[self.order[i]]);
        for row in 0..N {
            for i in 0..row {
                x[row] -= self.rows[row][i] * x[i];
            }
        }
        for row in (0..N).rev() {
            for i in row + 1..N {
                x[row] -= self.rows[row][i] * x[i];
            }
            x[row] /= self.rows[row][row];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix4, Vector4};

    #[test]
    fn agrees_with_nalgebra() {
        let rows = [[0.0, 2.0, -1.0, 3.0], [4.0, 1.0, 0.5, -2.0], [1e-9, 5.0, 7.0, 1.0], [3.0, -1.0, 2.0, 8.0]];
        let side = [1.0, -2.0, 0.25, 4.0];
        let expected = Matrix4::from_fn(|i, j| rows[i][j]).lu().solve(&Vector4::from(side)).unwrap();
        let got = Factors::of(rows).unwrap().solve(&side);
        for i in 0..4 {
            assert!((got[i] - expected[i]).abs() < 1e-14);
        }
    }

    #[test]
    fn singular_matrices_have_no_factors() {
        assert!(Factors::of([[1.0, 2.0], [2.0, 4.0]]).is_none());
        assert!(Factors::of([[f64::NAN, 0.0], [0.0, 1.0]]).is_none());
    }
}
