//! Eigenvalues of a Jacobian.
//!
//! nalgebra's Schur decomposition has no way out where its shifts turn a matrix into itself, and as WebAssembly it is five
//! times as long: a state has a few entries, and its own QR algorithm is a page.

use nalgebra::{Complex, DMatrix};

use super::characteristic_bounded;
use crate::{
    error::{Error, Result},
    few::sort_few,
};

/// Most sweeps for one eigenvalue; it takes two or three.
const SWEEPS: usize = 100;
/// Every so many sweeps the shifts are others, for matrices that the usual ones turn into themselves.
const STANDSTILL: usize = 10;
/// What of the largest |λ| rounding may come to in another eigenvalue, and the steps in which it is found out.
const IN_DOUBT: f64 = 1e-13;
const STEPS: usize = 4;
/// What is smaller beside the largest |λ| has lost digits in which the characteristic polynomial without its first terms is
/// better.
const LOST: f64 = 1e-9;

/// The eigenvalues of a square matrix of finite numbers, by falling real part; of a pair the one with the positive
/// imaginary part first, and both with the very same real part. A real eigenvalue has the imaginary part 0.
///
/// The matrix is balanced first, so that states of very different sizes do not cost digits: the error is some ε of the
/// largest |λ|, times the condition of the eigenvalue.
///
/// # Errors
/// A matrix so extreme that they leave the numbers.
///
/// # References
/// J. G. F. Francis, *The Computer Journal* 4 (1961) 265–271 and 332–345; the exceptional shifts of R. S. Martin,
/// G. Peters and J. H. Wilkinson, *Numerische Mathematik* 14 (1970) 219–231. Balancing: B. N. Parlett and C. Reinsch,
/// *Numerische Mathematik* 13 (1969) 293–304.
pub fn eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<Complex<f64>>> {
    let mut work = matrix.clone();
    let size = matrix.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    if size > 0.0 {
        work.iter_mut().for_each(|entry| *entry /= size);
        balance(&mut work);
        to_hessenberg(&mut work);
    }
    let mut values = of_hessenberg(&mut work).unwrap_or_default();
    for value in &mut values {
        *value = Complex::new(value.re * size, value.im * size);
    }
    if values.len() != matrix.nrows() || !values.iter().all(|value| value.re.is_finite() && value.im.is_finite()) {
        return Err(Error::beyond_numbers("the eigenvalues"));
    }
    settle(matrix, &mut values);
    sort(&mut values);
    Ok(values)
}

/// Looks again at eigenvalues so near to the axis that rounding of the largest one may have put them on their side of it:
/// by Newton's method on the characteristic polynomial, whose small coefficients keep their digits.
fn settle(matrix: &DMatrix<f64>, values: &mut [Complex<f64>]) {
    let size = values.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
    let in_doubt = |value: &Complex<f64>| value.re.abs() <= IN_DOUBT * size;
    let lost = |value: &Complex<f64>| value.norm() <= LOST * size;
    if !values.iter().any(|value| in_doubt(value) || lost(value)) {
        return;
    }
    let Ok(polynomial) = characteristic_bounded(matrix) else { return };
    // One or two that are lost beside the others are the roots of the polynomial's end.
    let end = |i: usize| polynomial[polynomial.len() - 1 - i].value;
    let roots = match values.iter().filter(|value| lost(value)).count() {
        1 => [Complex::from(-end(0) / end(1)); 2],
        2 => of_two(-end(1) / end(2), -end(0) / end(2), 1.0, 0.0),
        _ => [Complex::from(f64::NAN); 2],
    };
    if roots.iter().all(lost) {
        values.iter_mut().filter(|value| lost(value)).zip(roots).for_each(|(value, root)| *value = root);
    }
    for value in values.iter_mut().filter(|value| in_doubt(value)) {
        let mut root = *value;
        for _ in 0..STEPS {
            let (mut p, mut slope) = (Complex::from(0.0), Complex::from(0.0));
            for coefficient in &polynomial {
                slope = slope * root + p;
                p = p * root + coefficient.value;
            }
            let step = p / slope;
            root -= step;
            if step.re.abs() <= 4.0 * f64::EPSILON * root.re.abs()
                && step.im.abs() <= 4.0 * f64::EPSILON * root.im.abs()
            {
                break;
            }
        }
        // Where several are one it goes astray.
        if (root - *value).norm() <= IN_DOUBT * size {
            *value = root;
        }
    }
}

/// By falling real part, then by how fast they turn, of a pair the positive first.
fn sort(values: &mut [Complex<f64>]) {
    let before = |a: &Complex<f64>, b: &Complex<f64>| {
        a.re > b.re || (a.re == b.re && (a.im.abs() < b.im.abs() || (a.im == -b.im && a.im > b.im)))
    };
    sort_few(values, before);
}

/// Scales the states by powers of two, which costs no digit, until each row is about as large as its column; gives back
/// what a state of the scaled matrix is worth.
pub(super) fn balance(matrix: &mut DMatrix<f64>) -> Vec<f64> {
    let n = matrix.nrows();
    let mut sizes = vec![1.0; n];
    let mut done = false;
    while !done {
        done = true;
        for i in 0..n {
            let sum = |entry: &dyn Fn(usize) -> f64| (0..n).filter(|j| *j != i).map(|j| entry(j).abs()).sum::<f64>();
            let (column, row) = (sum(&|j| matrix[(j, i)]), sum(&|j| matrix[(i, j)]));
            if column == 0.0 || row == 0.0 {
                continue;
            }
            let mut factor = 1.0;
            while column * factor < 0.5 * row / factor {
                factor *= 2.0;
            }
            while column * factor > 2.0 * row / factor {
                factor *= 0.5;
            }
            if column * factor + row / factor < 0.95 * (column + row) {
                done = false;
                sizes[i] *= factor;
                for j in 0..n {
                    matrix[(j, i)] *= factor;
                    matrix[(i, j)] /= factor;
                }
            }
        }
    }
    sizes
}

/// Brings a matrix to the form without entries below the first subdiagonal.
fn to_hessenberg(matrix: &mut DMatrix<f64>) {
    let n = matrix.nrows();
    for k in 1..n.saturating_sub(1) {
        let column: Vec<f64> = (k..n).map(|row| matrix[(row, k - 1)]).collect();
        reflect(matrix, k, &column, (k - 1, n), (0, n));
        for row in k + 1..n {
            matrix[(row, k - 1)] = 0.0;
        }
    }
}

/// The similarity by the reflection that turns `vector`, in the places from `first` on, into its first direction; applied
/// to these columns, and to these rows.
fn reflect(matrix: &mut DMatrix<f64>, first: usize, vector: &[f64], columns: (usize, usize), rows: (usize, usize)) {
    let size = vector.iter().fold(0.0, |sum, entry| sum + entry.abs());
    if size == 0.0 {
        return;
    }
    let mut normal: Vec<f64> = vector.iter().map(|entry| entry / size).collect();
    let length = normal.iter().fold(0.0, |sum, entry| sum + entry * entry).sqrt();
    normal[0] += length.copysign(normal[0]);
    let scale = 1.0 / (length * normal[0].abs());
    for column in columns.0..columns.1 {
        let along = normal.iter().enumerate().fold(0.0, |sum, (i, part)| sum + part * matrix[(first + i, column)]);
        for (i, part) in normal.iter().enumerate() {
            matrix[(first + i, column)] -= scale * along * part;
        }
    }
    for row in rows.0..rows.1 {
        let along = normal.iter().enumerate().fold(0.0, |sum, (i, part)| sum + part * matrix[(row, first + i)]);
        for (i, part) in normal.iter().enumerate() {
            matrix[(row, first + i)] -= scale * along * part;
        }
    }
}

/// The eigenvalues of a matrix in Hessenberg form, by the QR algorithm with two shifts at once.
fn of_hessenberg(h: &mut DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    let mut values = Vec::with_capacity(h.nrows());
    let size = h.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    let mut end = h.nrows(); // what follows is done
    let mut sweeps = 0;
    while end > 0 {
        let last = end - 1;
        let coupled = |i: usize| {
            let beside = h[(i, i)].abs() + h[(i - 1, i - 1)].abs();
            h[(i, i - 1)].abs() > f64::EPSILON * if beside == 0.0 { size } else { beside }
        };
        let start = (1..end).rev().find(|i| !coupled(*i)).unwrap_or(0);
        if last - start < 2 {
            if start == last {
                values.push(h[(last, last)].into());
            } else {
                values.extend(of_two(h[(start, start)], h[(start, last)], h[(last, start)], h[(last, last)]));
            }
            (end, sweeps) = (start, 0);
            continue;
        }
        sweeps += 1;
        if sweeps > SWEEPS {
            return None;
        }
        let (a, b, c, d) = (h[(last - 1, last - 1)], h[(last - 1, last)], h[(last, last - 1)], h[(last, last)]);
        let (sum, product) = if sweeps % STANDSTILL == 0 {
            let aside = c.abs() + h[(last - 1, last - 2)].abs();
            (1.5 * aside, aside * aside)
        } else {
            (a + d, a * d - b * c)
        };
        let (top, below) = (h[(start, start)], h[(start + 1, start)]);
        let mut bulge = vec![
            top * (top - sum) + h[(start, start + 1)] * below + product,
            below * (top + h[(start + 1, start + 1)] - sum),
            below * h[(start + 2, start + 1)],
        ];
        for k in start..last {
            reflect(h, k, &bulge, (k.saturating_sub(1).max(start), end), (start, end.min(k + 4)));
            for row in k + 1..end.min(k + 3) {
                if k > start {
                    h[(row, k - 1)] = 0.0;
                }
            }
            bulge = (k + 1..end.min(k + 4)).map(|row| h[(row, k)]).collect();
        }
    }
    Some(values)
}

/// The eigenvalues of \[\[a, b\], \[c, d\]\].
fn of_two(a: f64, b: f64, c: f64, d: f64) -> [Complex<f64>; 2] {
    let half = 0.5 * (a - d);
    let discriminant = half * half + b * c;
    if discriminant < 0.0 {
        let (re, im) = (d + half, (-discriminant).sqrt());
        return [Complex::new(re, im), Complex::new(re, -im)];
    }
    let far = half + discriminant.sqrt().copysign(half);
    let near = if far == 0.0 { 0.0 } else { -b * c / far };
    [(d + far).into(), (d + near).into()]
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
