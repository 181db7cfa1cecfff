//! Linear equations of the size of a state, real and complex in one.

use nalgebra::{Complex, DMatrix};

/// A square matrix brought to triangular form by Gaussian elimination with partial pivoting, with the right-hand side that
/// went along.
pub(crate) struct Triangle {
    rows: Vec<Vec<Complex<f64>>>,
}

impl Triangle {
    /// From `matrix`, less `shift` on its diagonal, and `side`.
    pub fn of(matrix: &DMatrix<f64>, shift: Complex<f64>, side: &[Complex<f64>]) -> Self {
        let n = matrix.nrows();
        let entry = |i: usize, j: usize| Complex::from(matrix[(i, j)]) - if i == j { shift } else { 0.0.into() };
        let mut rows: Vec<Vec<_>> = (0..n).map(|i| (0..n).map(|j| entry(i, j)).chain([side[i]]).collect()).collect();
        for column in 0..n {
            let largest = |a: &usize, b: &usize| rows[*a][column].norm_sqr().total_cmp(&rows[*b][column].norm_sqr());
            let pivot = (column..n).max_by(largest).unwrap_or(column);
            rows.swap(column, pivot);
            let (done, rest) = rows.split_at_mut(column + 1);
            let head = &done[column];
            for row in rest.iter_mut().filter(|row| row[column] != 0.0.into()) {
                let factor = row[column] / head[column];
                for (entry, head) in row.iter_mut().zip(head).skip(column) {
                    *entry -= factor * head;
                }
            }
        }
        Self { rows }
    }

    /// The solution, with `least` in the place of smaller pivots: of a singular system it is large along the directions
    /// that the matrix forgets.
    pub fn solution(mut self, least: f64) -> Vec<Complex<f64>> {
        let n = self.rows.len();
        let mut x = vec![Complex::from(0.0); n];
        for i in (0..n).rev() {
            let row = &mut self.rows[i];
            if row[i].norm() < least {
                row[i] = least.into();
            }
            let known: Complex<f64> = (i + 1..n).map(|j| row[j] * x[j]).sum();
            x[i] = (row[n] - known) / row[i];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DVector;

    #[test]
    fn agrees_with_nalgebra() {
        let matrix = DMatrix::from_row_slice(
            4,
            4,
            &[0.0, 2.0, -1.0, 3.0, 4.0, 1.0, 0.5, -2.0, 1e-9, 5.0, 7.0, 1.0, 3.0, -1.0, 2.0, 8.0],
        );
        let shift = Complex::new(0.25, -3.0);
        let side = [1.0, -2.0, 0.25, 4.0].map(Complex::from);
        let shifted = matrix.map(Complex::from) - DMatrix::identity(4, 4) * shift;
        let expected = shifted.lu().solve(&DVector::from_row_slice(&side)).unwrap();
        let triangle = Triangle::of(&matrix, shift, &side);
        for (got, expected) in triangle.solution(0.0).iter().zip(&expected) {
            assert!((got - expected).norm() < 1e-14);
        }
    }
}
