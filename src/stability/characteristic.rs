//! The characteristic polynomial of a Jacobian.

use nalgebra::DMatrix;

use super::bounded::Bounded;
use crate::error::{Error, Result};

/// The coefficients of det(s − J), highest power (1) first.
///
/// The coefficient of sⁿ⁻ᵏ is (−1)ᵏ times the sum of the principal minors of order k. Each is expanded along its rows, past
/// the zeros that a Jacobian is full of: so a coefficient that is zero by the structure of the equations is zero, and a
/// small one keeps the digits that the entries hold.
///
/// # Errors
/// A matrix so extreme that they leave the numbers.
pub fn characteristic_polynomial(jacobian: &DMatrix<f64>) -> Result<Vec<f64>> {
    Ok(characteristic_bounded(jacobian)?.into_iter().map(|coefficient| coefficient.value).collect())
}

/// As [`characteristic_polynomial`], with how far rounding of the entries and of their sums may have led them.
///
/// # Errors
/// As there.
pub(crate) fn characteristic_bounded(jacobian: &DMatrix<f64>) -> Result<Vec<Bounded>> {
    let n = jacobian.nrows();
    let mut coefficients = vec![Bounded::exact(0.0); n + 1];
    coefficients[0] = Bounded::exact(1.0);
    for chosen in 1_usize..1 << n {
        let rows: Vec<usize> = (0..n).filter(|place| chosen >> place & 1 == 1).collect();
        let minor = determinant(jacobian, &rows, &rows);
        let signed = if rows.len() % 2 == 1 { minor.negative() } else { minor };
        coefficients[rows.len()] = coefficients[rows.len()] + signed;
    }
    if coefficients.iter().any(|coefficient| !coefficient.value.is_finite()) {
        return Err(Error::beyond_numbers("the characteristic polynomial"));
    }
    Ok(coefficients)
}

/// Of the entries in these rows and columns, along the first row.
fn determinant(matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> Bounded {
    let Some((first, rest)) = rows.split_first() else { return Bounded::exact(1.0) };
    let mut sum = Bounded::exact(0.0);
    for (place, column) in columns.iter().enumerate() {
        let entry = matrix[(*first, *column)];
        if entry != 0.0 {
            let others: Vec<usize> = columns.iter().copied().filter(|other| other != column).collect();
            let term = Bounded::rounded(entry) * determinant(matrix, rest, &others);
            sum = if place % 2 == 1 { sum - term } else { sum + term };
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::error::Code;

    #[test]
    fn of_a_companion_matrix_they_are_its_row() {
        // s⁵ + 2s⁴ + 3s³ + 6s² + 5s + 3
        let row = [2.0, 3.0, 6.0, 5.0, 3.0];
        let companion = DMatrix::from_fn(5, 5, |i, j| if i == 0 { -row[j] } else { f64::from(u8::from(i == j + 1)) });
        assert_eq!(characteristic_polynomial(&companion).unwrap(), [1.0, 2.0, 3.0, 6.0, 5.0, 3.0]);
    }

    #[test]
    fn a_triangle_shows_its_roots() {
        // (s − 1)(s − 2)(s + 3) = s³ − 7s + 6, whatever stands above the diagonal.
        let matrix = DMatrix::from_row_slice(3, 3, &[1.0, 1e8, -7.0, 0.0, 2.0, 1e-8, 0.0, 0.0, -3.0]);
        assert_eq!(characteristic_polynomial(&matrix).unwrap(), [1.0, 0.0, -7.0, 6.0]);
    }

    #[test]
    fn extreme_entries_are_refused() {
        let matrix = DMatrix::from_diagonal_element(3, 3, 1e200);
        assert_eq!(characteristic_polynomial(&matrix).unwrap_err().code, Code::NotFinite);
    }
}
