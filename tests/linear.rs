//! Linearisation of every listed model: eigenvalues, characteristic polynomial, Routh's array, crossings, modes.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::{LN_2, TAU};

use common::random::Random;
use nalgebra::{Complex, DMatrix};
use shimmy::{
    Run, model,
    parameter::Parameter,
    stability::{EndKind, RouthArray, Special, Variation, eigenvalues},
};

fn gear(parameters: &[(&str, f64)]) -> Run {
    gear_of("torsional", parameters)
}

fn gear_of(model: &str, parameters: &[(&str, f64)]) -> Run {
    parameters.iter().fold(Run::of(model).unwrap(), |run, (name, value)| run.with(name, *value).unwrap())
}

/// Within the sliders' ranges, at times at an end of one; a third of the gears that can have freeplay has it.
fn random_gear(random: &mut Random, model: &str) -> Run {
    let table = Run::of(model).unwrap().description().parameters;
    table.iter().fold(Run::of(model).unwrap(), |run, parameter| {
        let value = match parameter.name {
            "freeplayAngle" if !random.once_in(3) => 0.0,
            _ if random.once_in(12) => parameter.min,
            _ if random.once_in(12) => parameter.max,
            _ => random.between(parameter.min, parameter.max),
        };
        run.with(parameter.name, value).unwrap()
    })
}

fn value_of(run: &Run, name: &str) -> f64 {
    run.parameters()[run.description().parameters.iter().position(|p| p.name == name).unwrap()]
}

fn largest(values: &[Complex<f64>]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.norm()))
}

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

/// The numbers of roots in the right half plane and on the axis, by the eigenvalues of the companion matrix; none where
/// rounding may hide one of them.
fn counted(coefficients: &[f64]) -> Option<(usize, usize)> {
    let n = coefficients.len() - 1;
    let companion = DMatrix::from_fn(n, n, |i, j| match (i, j) {
        (0, _) => -coefficients[j + 1] / coefficients[0],
        _ => f64::from(u8::from(i == j + 1)),
    });
    let roots = eigenvalues(&companion).unwrap();
    let near = |root: &&Complex<f64>| root.re.abs() < 1e-3;
    let clear = roots.iter().filter(near).all(|root| root.re.abs() < 1e-9);
    let unstable = roots.iter().filter(|root| root.re >= 1e-3).count();
    clear.then(|| (unstable, roots.iter().filter(near).count()))
}

fn counts(array: &RouthArray) -> (usize, usize) {
    (array.unstable_roots, array.neutral_roots)
}

/// K. Ogata, *Modern Control Engineering*, ch. 5; N. Nise, *Control Systems Engineering*, ch. 6; R. Dorf and R. Bishop,
/// *Modern Control Systems*, ch. 6: their examples, with the numbers of roots right of the axis and on it.
#[test]
fn textbook_arrays_are_met() {
    use Special::{ZeroPivot, ZeroRow};
    type Case = (&'static [f64], (usize, usize), &'static [(usize, Special)]);
    let cases: [Case; 14] = [
        (&[2.0, 3.0], (0, 0), &[]),
        (&[1.0, -3.0], (1, 0), &[]),
        (&[1.0, 0.0, 4.0], (0, 2), &[(1, ZeroRow)]),
        (&[1.0, 0.0, -4.0], (1, 0), &[(1, ZeroRow)]),
        (&[1.0, 10.0, 31.0, 1030.0], (2, 0), &[]),
        (&[1.0, 2.0, 1.0, 2.0], (0, 2), &[(2, ZeroRow)]),
        (&[1.0, 0.0, -3.0, 2.0], (2, 0), &[(1, ZeroPivot)]),
        (&[1.0, 2.0, 3.0, 4.0, 5.0], (2, 0), &[]),
        (&[1.0, 2.0, 3.0, 6.0, 5.0, 3.0], (2, 0), &[(2, ZeroPivot)]),
        (&[1.0, 2.0, 2.0, 4.0, 11.0, 10.0], (2, 0), &[(2, ZeroPivot)]),
        (&[1.0, 7.0, 6.0, 42.0, 8.0, 56.0], (0, 4), &[(2, ZeroRow)]),
        (&[1.0, 2.0, 24.0, 48.0, -25.0, -50.0], (1, 2), &[(2, ZeroRow)]),
        (&[1.0, 1.0, 2.0, 2.0, 1.0, 1.0], (0, 4), &[(2, ZeroRow), (4, ZeroRow)]),
        (&[1.0, 1.0, 12.0, 22.0, 39.0, 59.0, 48.0, 38.0, 20.0], (2, 4), &[(5, ZeroRow)]),
    ];
    for (coefficients, expected, special) in cases {
        let array = RouthArray::of(coefficients).unwrap();
        assert_eq!(counts(&array), expected, "{array:?}");
        assert_eq!(array.stable, expected == (0, 0));
        let found: Vec<_> = array.special.iter().enumerate().filter_map(|(i, s)| s.map(|s| (i, s))).collect();
        assert_eq!(found, special, "{array:?}");
        assert!((0..array.rows.len()).all(|i| array.replaced[i].is_some() == array.special[i].is_some()));
    }
}

#[test]
fn an_array_is_written_as_people_write_it() {
    let array = RouthArray::of(&[1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
    assert_eq!(array.rows, [vec![1.0, 3.0, 5.0], vec![2.0, 4.0], vec![1.0, 5.0], vec![-6.0], vec![5.0]]);
    assert_eq!(array.column(), [1.0, 2.0, 1.0, -6.0, 5.0]);
    // s³ + 2s² + s + 2: the row of s is zero, and the derivative of 2s² + 2 takes its place.
    let array = RouthArray::of(&[1.0, 2.0, 1.0, 2.0]).unwrap();
    assert_eq!(array.rows, [vec![1.0, 1.0], vec![2.0, 2.0], vec![4.0], vec![2.0]]);
    assert_eq!(array.replaced[2], Some(vec![0.0]));
    // A pivot is zero: 0 s³ + 3.5 s becomes (1 − s²) 3.5 s.
    let array = RouthArray::of(&[1.0, 2.0, 3.0, 6.0, 5.0, 3.0]).unwrap();
    assert_eq!((&array.rows[2], &array.replaced[2]), (&vec![-3.5, 3.5], &Some(vec![0.0, 3.5])));
}

/// Products of factors whose roots are known.
#[test]
fn roots_are_counted_in_products() {
    let factors: [(&[f64], (usize, usize)); 10] = [
        (&[1.0, 1.0], (0, 0)),
        (&[1.0, 3.0], (0, 0)),
        (&[1.0, -1.0], (1, 0)),
        (&[1.0, -2.0], (1, 0)),
        (&[1.0, 0.0], (0, 1)),
        (&[1.0, 0.0, 1.0], (0, 2)),
        (&[1.0, 0.0, 4.0], (0, 2)),
        (&[1.0, 2.0, 5.0], (0, 0)),
        (&[1.0, -2.0, 5.0], (2, 0)),
        (&[1.0, 1.0, 7.0], (0, 0)),
    ];
    let mut random = Random::seeded(8);
    let mut specials = [0; 2];
    for case in 0..20_000 {
        let order = 1 + case % 8;
        let (mut product, mut expected) = (vec![1.0], (0, 0));
        while product.len() <= order {
            let (factor, (unstable, neutral)) = factors[random.between(0.0, 10.0) as usize];
            if product.len() + factor.len() > order + 2 {
                continue;
            }
            let mut next = vec![0.0; product.len() + factor.len() - 1];
            for (i, a) in product.iter().enumerate() {
                for (j, b) in factor.iter().enumerate() {
                    next[i + j] += a * b;
                }
            }
            product = next;
            expected = (expected.0 + unstable, expected.1 + neutral);
        }
        // In another unit of time, and of another sign, they are the same.
        let (unit, sign) = (10_f64.powi(random.between(-3.0, 4.0) as i32), if random.once_in(2) { 1.0 } else { -1.0 });
        let scaled: Vec<f64> = product.iter().enumerate().map(|(i, c)| sign * c * unit.powi(i as i32)).collect();
        let array = RouthArray::of(&scaled).unwrap();
        assert_eq!(counts(&array), expected, "{product:?} in units of {unit}: {array:?}");
        assert_eq!(array.stable, expected == (0, 0));
        for special in array.special.iter().flatten() {
            specials[usize::from(*special == Special::ZeroRow)] += 1;
        }
    }
    assert!(specials.iter().all(|count| *count > 1_000), "{specials:?}");
}

#[test]
fn arrays_of_small_integers_agree_with_companion_matrices() {
    let mut random = Random::seeded(9);
    let mut compared = [0; 9];
    for case in 0..20_000 {
        let order = 1 + case % 8;
        let mut coefficients: Vec<f64> = (0..=order).map(|_| random.between(-2.0, 5.0).floor()).collect();
        coefficients[0] = if coefficients[0] == 0.0 { 1.0 } else { coefficients[0] };
        let Some(expected) = counted(&coefficients) else { continue };
        let array = RouthArray::of(&coefficients).unwrap();
        assert_eq!(counts(&array), expected, "{array:?}");
        compared[order] += 1;
    }
    assert!(compared[1..].iter().all(|count| *count > 2_000), "{compared:?}");
}

#[test]
fn what_is_no_polynomial_is_refused() {
    for bad in [vec![], vec![0.0, 1.0], vec![1.0, f64::NAN], vec![1.0, f64::INFINITY], vec![1.0, 1e-300, 1.0, 1e300]] {
        assert_eq!(RouthArray::of(&bad).unwrap_err().code.name(), "not-finite", "{bad:?}");
    }
}

/// 10,000 gears of all models, away from the axis by 1e-9 of the largest eigenvalue: rounding of the eigenvalues is some
/// 1e-14 of it, and that of the array as much over the damping ratio.
#[test]
fn the_array_agrees_with_the_eigenvalues_and_with_the_closed_form() {
    let mut random = Random::seeded(10);
    let models = model::list();
    let (mut stable, mut near) = (0, 0);
    for case in 0..10_000 {
        let run = random_gear(&mut random, models[case % models.len()].name);
        let values = run.eigenvalues().unwrap();
        let margin = 1e-9 * largest(&values);
        if values.iter().any(|value| value.re.abs() < margin) {
            near += 1;
            continue;
        }
        let array = run.routh_array().unwrap();
        assert_eq!(array.unstable_roots, values.iter().filter(|value| value.re > 0.0).count(), "{run:?} {values:?}");
        assert_eq!(array.neutral_roots, 0);
        assert_eq!(array.stable, run.routh_hurwitz().unwrap().stable, "{run:?} {values:?}");
        stable += usize::from(array.stable);
    }
    // Gears without a load, spring or damper lie on the axis.
    assert!(stable > 2_000 && near < 400, "{stable} {near}");
}

#[test]
fn a_wheel_that_nothing_turns_back_is_neutral() {
    let idle = gear(&[("verticalForce", 0.0), ("torsionalStiffness", 0.0)]);
    let array = idle.routh_array().unwrap();
    assert_eq!((array.coefficients[3], counts(&array), array.stable), (0.0, (0, 1), false));
    assert_eq!((idle.eigenvalues().unwrap()[0], idle.eigenmodes().unwrap()[0].energy_flow), (0.0.into(), None));
    let undamped = idle.with("dampingConstant", 0.0).unwrap().with("treadWidthMomentConstant", 0.0).unwrap();
    assert_eq!(counts(&undamped.routh_array().unwrap()), (0, 2), "ψ̈ = 0: it turns on");
    let swinging = undamped.with("torsionalStiffness", 1e5).unwrap();
    assert_eq!(counts(&swinging.routh_array().unwrap()), (0, 2));
    assert!(swinging.routh_hurwitz_by_numbers().unwrap().critical_velocities.is_empty(), "no speed matters");
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

/// theory.md, section 2, once more, by the search that knows nothing of the gear.
#[test]
fn the_search_meets_the_published_critical_values() {
    let by_numbers = |parameters: &[(&str, f64)]| gear(parameters).routh_hurwitz_by_numbers().unwrap();
    for (c, expected) in [
        (0.0, vec![15.2593]),
        (10.0, vec![20.511, 1040.97]),
        (20.0, vec![27.600, 501.75]),
        (30.0, vec![37.263, 311.77]),
        (40.0, vec![51.881, 205.13]),
        (49.7926, vec![100.70, 100.70]),
        (49.7928, vec![]),
    ] {
        let got = by_numbers(&[("dampingConstant", c)]).critical_velocities;
        assert_eq!(got.len(), expected.len(), "{c}: {got:?}");
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < if c > 49.0 { 3e-3 } else { 3e-5 }, "{c}: {got} {expected}");
        }
    }
    for (v, expected) in [(30.0, 22.808), (80.0, 48.530)] {
        let got = by_numbers(&[("velocity", v)]).critical_damping.unwrap();
        assert!((got / expected - 1.0).abs() < 3e-5, "{got}");
    }
}

/// Neighbours in a list that are nearer to each other than this, relatively, may be hidden by rounding.
const HIDDEN: f64 = 1e-5;

#[test]
fn the_search_finds_what_the_closed_form_says() {
    let mut random = Random::seeded(11);
    let mut found = 0;
    for case in 0..600 {
        let run = random_gear(&mut random, ["torsional", "torsional-linear"][case % 2]);
        let (exact, searched) = (run.routh_hurwitz().unwrap(), run.routh_hurwitz_by_numbers().unwrap());
        let mut expected = exact.critical_velocities;
        expected.retain(|v| (0.1..=2000.0).contains(v));
        if expected.windows(2).any(|pair| pair[1] / pair[0] - 1.0 < HIDDEN) {
            continue;
        }
        let got = searched.critical_velocities;
        assert_eq!(got.len(), expected.len(), "{run:?}: {got:?} {expected:?}");
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < 1e-8, "{run:?}: {got} {expected}");
            found += 1;
        }
        match (searched.critical_damping, exact.critical_damping.filter(|c| (1e-3..=1e6).contains(c))) {
            (Some(got), Some(expected)) => assert!((got / expected - 1.0).abs() < 1e-8, "{run:?}: {got} {expected}"),
            (got, expected) => assert_eq!(got, expected, "{run:?}"),
        }
    }
    assert!(found > 200, "{found}");
}

/// Along any parameter, in any range: crossings are the ends of the closed form's intervals.
#[test]
fn crossings_are_the_ends_of_intervals() {
    let table = Run::of("torsional").unwrap().description().parameters;
    let mut random = Random::seeded(12);
    let mut found = [0; 2];
    for case in 0..1_500 {
        let run = random_gear(&mut random, "torsional");
        let Parameter { name, min, max, .. } = table[case % table.len()];
        let (a, b) = (random.between(min, max), random.between(min, max));
        let (from, to) = if random.once_in(2) { (min, max) } else { (a.min(b), a.max(b)) };
        let variation = Variation::of(name, from, to);
        let intervals = run.unstable_intervals(&variation).unwrap();
        let mut expected: Vec<(f64, EndKind)> =
            intervals.iter().flat_map(|part| [(part.from, part.from_kind), (part.to, part.to_kind)]).collect();
        expected.retain(|end| end.1 != EndKind::Range);
        let crossings = run.crossings(&variation).unwrap();
        let width = to - from;
        if expected.windows(2).any(|pair| pair[1].0 - pair[0].0 < HIDDEN * width) {
            continue;
        }
        for (value, kind) in &expected {
            let near = crossings.iter().find(|c| (c.value - value).abs() < 1e-8 * width && c.kind == *kind);
            assert!(near.is_some(), "{name} {from} … {to} of {run:?}: {expected:?} {crossings:?}");
            found[usize::from(*kind == EndKind::Hopf)] += 1;
        }
        // What else crosses does so where another eigenvalue is unstable already; all are on the axis there.
        for crossing in &crossings {
            let values = run.clone().with(name, crossing.value).unwrap().eigenvalues().unwrap();
            let on_axis = values.iter().find(|value| match crossing.kind {
                EndKind::Hopf => (value.im - TAU * crossing.frequency).abs() < 1e-9 * largest(&values),
                _ => value.norm() < 1e-9 * largest(&values),
            });
            assert!(on_axis.unwrap().re.abs() < 1e-9 * largest(&values), "{name}: {crossing:?} {values:?}");
        }
    }
    assert!(found.iter().all(|count| *count > 30), "{found:?}");
}

#[test]
fn a_mode_solves_the_equations_and_its_energy_adds_up() {
    let mut random = Random::seeded(13);
    let models = model::list();
    let mut flows = 0;
    for case in 0..4_000 {
        let run = random_gear(&mut random, models[case % models.len()].name);
        let jacobian = run.linearised().unwrap().jacobian;
        let (modes, values) = (run.eigenmodes().unwrap(), run.eigenvalues().unwrap());
        assert_eq!(modes.iter().map(|mode| mode.eigenvalue).collect::<Vec<_>>(), values);
        for mode in modes {
            let (lambda, shape) = (mode.eigenvalue, &mode.shape);
            assert_eq!(shape[mode.reference], Complex::from(1.0));
            for row in 0..shape.len() {
                let terms: Vec<Complex<f64>> = (0..shape.len()).map(|i| shape[i] * jacobian[(row, i)]).collect();
                let sum: Complex<f64> = terms.iter().sum();
                let size = terms.iter().fold((lambda * shape[row]).norm(), |most, term| most.max(term.norm()));
                assert!((sum - lambda * shape[row]).norm() <= 1e-9 * size.max(1.0), "{run:?}: {mode:?} row {row}");
            }
            assert!((mode.natural_frequency * TAU - lambda.norm()).abs() <= 1e-12 * lambda.norm());
            if let Some(time) = mode.time_to_half {
                assert!(mode.time_to_double.is_none() && (time * lambda.re + LN_2).abs() < 1e-12);
            }
            if let Some(time) = mode.time_to_double {
                assert!((time * lambda.re - LN_2).abs() < 1e-12);
            }
            let Some(flow) = mode.energy_flow else { continue };
            let parts = [flow.tire, -flow.damper, -flow.tread_width];
            let scale = parts.iter().fold(1.0, |most: f64, part| most.max(part.abs()));
            assert!((parts.iter().sum::<f64>() - lambda.re).abs() < 1e-9 * scale, "{run:?}: {mode:?}");
            assert!((flow.stored - lambda.re).abs() < 1e-12 * scale && flow.stored == flow.kinetic + flow.spring);
            // What a damper takes of a swing's energy: c|ψ̇|² over I_z|ψ̇|² + k|ψ|², with |ψ̇| = |λ||ψ|.
            let free = run.description().name == "torsional" && value_of(&run, "freeplayAngle") > 0.0;
            let k = if free { 0.0 } else { value_of(&run, "torsionalStiffness") };
            let (rate, i_z) = (lambda.norm_sqr(), value_of(&run, "momentOfInertia"));
            let damper = value_of(&run, "dampingConstant") * rate / (i_z * rate + k);
            assert!((flow.damper - damper).abs() < 1e-9 * scale, "{run:?}: {mode:?} {damper}");
            flows += 1;
        }
    }
    assert!(flows > 8_000, "{flows}");
}

#[test]
fn a_mode_is_what_the_gear_does() {
    // theory.md, section 3: |ψ|/|y| = |λ + v/σ|/|v + λ(e − a)|. At the boundary a cycle of the linear gear is the mode.
    let gear_at = |e: f64| gear_of("torsional-linear", &[("dampingConstant", 20.0), ("casterLength", e)]);
    for e in [0.05, 0.1, 0.2] {
        let v = gear_at(e).routh_hurwitz().unwrap().critical_velocities[0];
        let run = gear_at(e).with("velocity", v).unwrap();
        let [mode, other, _] = &run.eigenmodes().unwrap()[..] else { panic!() };
        let (lambda, y) = (mode.eigenvalue, mode.shape[2]);
        assert_eq!((mode.reference, other.shape[2]), (0, y.conj()));
        let expected = (lambda * (e - 0.1) + v) / (lambda + v / 0.3);
        assert!((y - expected).norm() < 1e-12 * y.norm(), "{y} {expected}");

        let period = TAU / lambda.im;
        let run = run.starting("torsionAngle", 0.01).unwrap();
        let run =
            run.starting("lateralDeformation", 0.01 * y.re).unwrap().lasting(period).unwrap().within(1e-12).unwrap();
        let start = mode.shape[1].re * 0.01;
        let energy = run.starting("torsionRate", start).unwrap().energy().unwrap().unwrap();
        let flow = mode.energy_flow.unwrap();
        // Half of ½k|ψ|² + ½I_z|ψ̇|² is the mean; the mean power over twice of it is the rate.
        let mean = 0.25e-4 * (1e5 + lambda.norm_sqr());
        for (rate, total) in
            [(flow.tire, energy.tire), (flow.damper, energy.damper), (flow.tread_width, energy.tread_width)]
        {
            assert!((rate - total / period / (2.0 * mean)).abs() < 1e-7 * rate.abs(), "{flow:?} {energy:?}");
        }
        assert!(mode.damping_ratio.unwrap().abs() < 1e-12);
    }
}

#[test]
fn a_state_that_the_wheel_does_not_move_is_its_own_reference() {
    // Without a load the tire does not turn the wheel: its deformation fades by itself, and takes no energy with it.
    let modes = gear(&[("verticalForce", 0.0)]).eigenmodes().unwrap();
    let tire = modes.iter().find(|mode| mode.eigenvalue.im == 0.0).unwrap();
    assert_eq!((tire.reference, tire.energy_flow), (2, None));
    assert!((tire.eigenvalue.re + 50.0 / 0.3).abs() < 1e-11 && tire.damping_ratio == Some(1.0));
    assert!(
        modes.iter().filter(|mode| mode.eigenvalue.im != 0.0).all(|mode| mode.energy_flow.unwrap().tire.abs() < 1e-12)
    );
}

#[test]
fn extreme_numbers_are_refused_in_words() {
    let run = gear(&[("momentOfInertia", 1e-310)]);
    for error in [run.linearised().unwrap_err(), run.eigenmodes().unwrap_err(), run.routh_array().unwrap_err()] {
        assert_eq!(error.to_string(), "the Jacobian must be of finite numbers: choose less extreme values, got NaN");
    }
}
