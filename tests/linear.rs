//! Linearisation of every listed model: eigenvalues, characteristic polynomial, Routh's array, crossings, modes.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::random::Random;
use nalgebra::{Complex, DMatrix};
use shimmy::stability::eigenvalues;

/// The value nearest to each expected one, each used once: the largest distance.
fn apart(got: &[Complex<f64>], expected: &[Complex<f64>]) -> f64 {
    assert_eq!(got.len(), expected.len());
    let mut left = got.to_vec();
    expected.iter().fold(0.0, |worst: f64, value| {
        let nearest = (0..left.len()).min_by(|a, b| (left[*a] - value).norm().total_cmp(&(left[*b] - value).norm()));
        worst.max((left.swap_remove(nearest.unwrap()) - value).norm())
    })
}

fn assert_in_order(values: &[Complex<f64>]) {
    for (i, value) in values.iter().enumerate() {
        assert!(i == 0 || values[i - 1].re >= value.re, "{values:?}");
        if value.im > 0.0 {
            assert_eq!(values[i + 1], value.conj(), "{values:?}");
        } else if value.im < 0.0 {
            assert_eq!(values[i - 1], value.conj(), "{values:?}");
        }
    }
}

#[test]
fn eigenvalues_agree_with_nalgebra() {
    let mut random = Random::seeded(6);
    for case in 0..4_000 {
        let n = 1 + case % 10;
        // Full and sparse ones, and of states of different sizes.
        let sparse = random.once_in(2);
        let sizes: Vec<f64> = (0..n).map(|_| 10_f64.powf(random.between(-3.0, 3.0))).collect();
        let plain =
            DMatrix::from_fn(n, n, |_, _| if sparse && random.once_in(2) { 0.0 } else { random.between(-1.0, 1.0) });
        let Some(schur) = nalgebra::Schur::try_new(plain.clone(), f64::EPSILON, 1_000) else { continue };
        let expected: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
        if expected.iter().any(|value| !value.re.is_finite() || !value.im.is_finite()) {
            continue; // nalgebra's own answer to a double eigenvalue
        }
        let got = eigenvalues(&DMatrix::from_fn(n, n, |i, j| plain[(i, j)] * sizes[i] / sizes[j])).unwrap();
        assert_in_order(&got);
        // An eigenvalue of multiplicity m moves by ε^(1/m); in sparse matrices zero is often double, at times triple.
        let tolerance = if sparse { 1e-4 } else { 1e-9 };
        assert!(apart(&got, &expected) < tolerance, "{plain} {got:?} {expected:?}");
    }
}
