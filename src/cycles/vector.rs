//! Vectors and matrices of a few numbers.
//!
//! An iterator's code, written out for each of a hundred places, would be a fourth of the module: here it is once.

use nalgebra::{Complex, DMatrix};

/// The vector of these entries.
#[inline(never)]
pub(super) fn vector(n: usize, entry: &dyn Fn(usize) -> f64) -> Vec<f64> {
    (0..n).map(entry).collect()
}

/// The same with complex entries.
#[inline(never)]
pub(super) fn complex(n: usize, entry: &dyn Fn(usize) -> Complex<f64>) -> Vec<Complex<f64>> {
    (0..n).map(entry).collect()
}

/// The square matrix of these entries, by row and column.
#[inline(never)]
pub(super) fn matrix(n: usize, entry: &dyn Fn(usize, usize) -> f64) -> DMatrix<f64> {
    DMatrix::from_fn(n, n, entry)
}

/// a + factor · b.
#[inline(never)]
pub(super) fn sum(a: &[f64], factor: f64, b: &[f64]) -> Vec<f64> {
    vector(a.len(), &|i| a[i] + factor * b[i])
}

/// factor · a.
#[inline(never)]
pub(super) fn times(factor: f64, a: &[f64]) -> Vec<f64> {
    vector(a.len(), &|i| factor * a[i])
}

/// a / its length.
#[inline(never)]
pub(super) fn direction(a: &[f64]) -> Vec<f64> {
    let length = norm(a);
    vector(a.len(), &|i| a[i] / length)
}

/// 1 along one axis.
#[inline(never)]
pub(super) fn axis(n: usize, which: usize) -> Vec<f64> {
    vector(n, &|i| if i == which { 1.0 } else { 0.0 })
}

/// Re a.
#[inline(never)]
pub(super) fn real(a: &[Complex<f64>]) -> Vec<f64> {
    vector(a.len(), &|i| a[i].re)
}

/// Im a.
#[inline(never)]
pub(super) fn imaginary(a: &[Complex<f64>]) -> Vec<f64> {
    vector(a.len(), &|i| a[i].im)
}

/// a · b.
#[inline(never)]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

/// The length of a.
#[inline(never)]
pub(super) fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}
