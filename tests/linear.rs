//! Linearisation of every listed model: eigenvalues and characteristic polynomial.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    linear::{gear, largest, random_gear, value_of},
    random::Random,
};
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

/// NumPy 2.4.6, numpy.linalg.eigvals of the matrix of theory.md, section 2.
#[test]
fn eigenvalues_are_those_of_numpy() {
    let (v, e, c, k, kappa) =
        ("velocity", "casterLength", "dampingConstant", "torsionalStiffness", "treadWidthMomentConstant");
    type Case<'a> = (&'a [(&'a str, f64)], [(f64, f64); 2]);
    let cases: [Case; 8] = [
        (&[], [(13.637157621763699, 328.77093322353494), (-209.3409819101942, 0.0)]),
        (&[(v, 80.0), (c, 20.0)], [(13.214435369916128, 338.26420289068307), (-316.4705374064989, 0.0)]),
        (&[(v, 30.0), (c, 22.808)], [(-0.0002276423299250041, 321.2175897892192), (-131.80754471534024, 0.0)]),
        (&[(c, 100.0), (k, 0.0)], [(6.197370475779909, 145.10025749114502), (-284.4614076182266, 0.0)]),
        (&[(v, 80.0), (c, 100.0), (k, 0.0)], [(-1.8570908087214768, 161.87220598194403), (-366.3274850492241, 0.0)]),
        (
            &[(v, 5.0), (e, -0.3), (c, 0.0), (kappa, 0.0)],
            [(-4.728068780571789, 384.5899915630876), (-7.210529105523075, 0.0)],
        ),
        (
            &[(v, 120.0), (e, 0.4), (c, 200.0), ("relaxationLength", 0.05), ("momentOfInertia", 0.1)],
            [(-1966.9215370384563, 2337.2890286594907), (-488.65692592308534, 0.0)],
        ),
        (&[(v, 60.0), (e, -0.9)], [(-114.75412067793266, 757.0838836396289), (15.008241355865529, 0.0)]),
    ];
    for (parameters, [pair, real]) in cases {
        let pair = Complex::new(pair.0, pair.1);
        let expected = [pair, pair.conj(), Complex::from(real.0)];
        let got = gear(parameters).eigenvalues().unwrap();
        assert_in_order(&got);
        // Both round: some ε of the largest entry of a matrix that NumPy balances less.
        assert!(apart(&got, &expected) < 1e-11 * largest(&got), "{parameters:?} {got:?}");
    }
}

/// theory.md, sections 4 and 8.1.
#[test]
fn published_growth_rates_are_met() {
    let growth = |parameters: &[(&str, f64)]| gear(parameters).eigenvalues().unwrap()[0].re;
    let gap = |v: f64| growth(&[("velocity", v), ("dampingConstant", 100.0), ("freeplayAngle", 0.01)]);
    assert!((gap(50.0) - 6.20).abs() < 5e-3 && (gap(80.0) + 1.86).abs() < 5e-3);
    for (k, expected) in [(1e5, [-1.28, -10.7, -13.4]), (0.0, [18.4, 65.8, 79.2])] {
        for (v, expected) in [5.0, 50.0, 120.0].into_iter().zip(expected) {
            let undamped = [("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0), ("casterLength", -0.15)];
            let got = growth(&[undamped.as_slice(), &[("velocity", v), ("torsionalStiffness", k)]].concat());
            assert!((got - expected).abs() < 5e-2, "{k} {v}: {got}");
        }
    }
}

#[test]
fn the_characteristic_polynomial_is_that_of_the_closed_form() {
    let mut random = Random::seeded(7);
    for case in 0..2_000 {
        let run = random_gear(&mut random, ["torsional", "torsional-linear"][case % 2]);
        let [v, e, a, sigma, i_z, c, f_z, c_f_alpha, c_m_alpha, kappa] = [
            "velocity",
            "casterLength",
            "halfContactLength",
            "relaxationLength",
            "momentOfInertia",
            "dampingConstant",
            "verticalForce",
            "sideForceDerivative",
            "aligningMomentDerivative",
            "treadWidthMomentConstant",
        ]
        .map(|name| value_of(&run, name));
        let free = case % 2 == 0 && value_of(&run, "freeplayAngle") > 0.0;
        let k = if free { 0.0 } else { value_of(&run, "torsionalStiffness") };
        // theory.md, section 2.
        let b = -(c_m_alpha + e * c_f_alpha) * f_z / (sigma * i_z);
        let most = (c_m_alpha + e.abs() * c_f_alpha) * f_z / (sigma * i_z);
        let damping = c + kappa / v;
        let expected = [
            (1.0, 1.0),
            (v / sigma + damping / i_z, v / sigma + damping / i_z),
            (
                k / i_z + damping * v / (sigma * i_z) - (e - a) * b,
                k / i_z + damping * v / (sigma * i_z) + (e.abs() + a) * most,
            ),
            (v * k / (sigma * i_z) - v * b, v * k / (sigma * i_z) + v * most),
        ];
        let got = run.characteristic_polynomial().unwrap();
        for (got, (expected, terms)) in got.iter().zip(expected) {
            // Some ε of each term: no digit is lost to what does not enter a coefficient.
            assert!((got - expected).abs() <= 2e-15 * terms, "{run:?}: {got} {expected}");
        }
    }
}

#[test]
fn on_the_boundary_the_largest_real_part_is_zero() {
    for c in [0.0, 10.0, 20.0, 30.0, 40.0, 49.0] {
        let speeds = gear(&[("dampingConstant", c)]).routh_hurwitz().unwrap().critical_velocities;
        assert!(!speeds.is_empty());
        for v in speeds {
            let values = gear(&[("dampingConstant", c), ("velocity", v)]).eigenvalues().unwrap();
            assert!(values[0].re.abs() < 1e-9 && values[0].im > 100.0, "c = {c}, v = {v}: {values:?}");
        }
    }
}

#[test]
fn extreme_numbers_are_refused_in_words() {
    let run = gear(&[("momentOfInertia", 1e-310)]);
    for (error, what) in [
        (run.linearised().unwrap_err(), "the Jacobian"),
        (run.eigenmodes().unwrap_err(), "the Jacobian"),
        (run.routh_array().unwrap_err(), "the characteristic polynomial"),
        (run.routh_hurwitz().unwrap_err(), "the characteristic polynomial"),
    ] {
        let expected = format!("parameters must be less extreme, got values with which {what} would leave the numbers");
        assert_eq!(error.to_string(), expected);
    }
}
