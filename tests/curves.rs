//! Boundaries of stability as curves: on them eigenvalues are on the axis, none is missed, and their area is right.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    planes::{Case, distance, eigenvalues, gear, named, nearest, place, run_with},
    random::Random,
};
use nalgebra::Complex;
use shimmy::{
    Run,
    model::Torsional,
    stability::{CurveKind, CurveSpec, HopfCurve, Plane},
};

/// Every point of every curve, by the eigenvalues of the model's own Jacobian: what the curve says is on the axis is there
/// to 1e-9 of the largest eigenvalue, with the frequency it says, and the others are where it says.
fn assert_on_the_axis(case: &Case, curves: &[HopfCurve]) -> usize {
    let mut points = 0;
    for curve in curves {
        assert!(curve.x.len() == curve.y.len() && curve.x.len() == curve.frequency.len() && curve.x.len() > 1);
        for ((x, y), frequency) in curve.x.iter().zip(&curve.y).zip(&curve.frequency) {
            let all = eigenvalues::<Torsional>(&case.at(*x, *y));
            let size = all.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
            let what = || format!("{} at {x}, {y}: {all:?}", case.what());
            let on_axis = |value: &&Complex<f64>| match curve.kind {
                CurveKind::Hopf => value.im > 0.0,
                CurveKind::Divergence => value.im.abs() < 1e-5 * size,
            };
            let crosses = all.iter().filter(on_axis).min_by(|a, b| a.re.abs().total_cmp(&b.re.abs()));
            let crosses = crosses.unwrap_or_else(|| panic!("nothing of the kind: {}", what()));
            // A double zero takes its root.
            let near_double = crosses.im.abs() < 1e-4 * size;
            assert!(crosses.re.abs() < if near_double { 1e-7 } else { 1e-9 } * size, "{}", what());
            assert!((crosses.im / std::f64::consts::TAU - frequency).abs() < 1e-7 * size, "{frequency}: {}", what());
            let mut others = all.iter().filter(|other| **other != *crosses && **other != crosses.conj());
            let stable = others.all(|other| other.re < 1e-9 * size);
            assert!(!curve.bounds || stable, "{}", what());
            points += 1;
        }
        let last = curve.x.len() - 1;
        assert_eq!(curve.closed, curve.x[0] == curve.x[last] && curve.y[0] == curve.y[last]);
    }
    points
}

#[test]
fn curves_are_where_eigenvalues_cross_and_none_is_missed() {
    let mut random = Random::seeded(11);
    let (mut points, mut crossings, mut several) = (0, 0, 0);
    for _ in 0..500 {
        let case = Case::random(&mut random);
        let curves = case.plane.hopf_curves().unwrap();
        points += assert_on_the_axis(&case, &curves);
        several += usize::from(curves.len() > 1);
        // Straight lines between its points are within 1e-6 of the true boundary.
        for (at, kind) in case.meetings(&mut random, 40) {
            let off = nearest(&case, curves.iter().filter(|curve| curve.kind == kind && curve.bounds), at);
            assert!(off < 2e-6, "{} at {at:?}: the nearest {kind:?} curve is {off} away", case.what());
            crossings += 1;
        }
    }
    assert!(points > 5_000 && crossings > 5_000 && several > 50, "{points} {crossings} {several}");
}

/// A curve ends at the edge, exactly, where it does not close or meet itself.
#[test]
fn curves_end_at_the_edge() {
    let mut random = Random::seeded(12);
    let (mut ends, mut meetings) = (0, 0);
    for _ in 0..300 {
        let case = Case::random(&mut random);
        let [(_, left, right), (_, low, high)] = case.axes;
        for curve in case.plane.hopf_curves().unwrap().iter().filter(|curve| !curve.closed) {
            for i in [0, curve.x.len() - 1] {
                let (x, y) = (curve.x[i], curve.y[i]);
                if x == left || x == right || y == low || y == high {
                    ends += 1;
                } else {
                    // k = 0 and no load: k + T is a product that is zero on an edge, too, and a curve ends where they meet.
                    let [x, y] = case.unit(x, y);
                    let to_edge = x.min(1.0 - x).min(y).min(1.0 - y);
                    assert!(to_edge < 1e-6 && curve.kind == CurveKind::Divergence, "{}: {x} {y}", case.what());
                    meetings += 1;
                }
            }
        }
    }
    assert!(ends > 200 && meetings < 20, "{ends} {meetings}");
}

/// theory.md, section 2: critical speeds and dampings, on the curves between their points, to 5 digits.
#[test]
fn published_critical_values_lie_on_the_curve() {
    let case = named(&[], ("velocity", 0.5, 1100.0), ("dampingConstant", 0.0, 60.0));
    let curves = case.plane.hopf_curves().unwrap();
    let [curve] = &curves[..] else { panic!("{curves:?}") };
    assert!(curve.kind == CurveKind::Hopf && curve.bounds && !curve.closed);
    // Where the curve itself is, not its chords: a plane so small that they cannot be told apart.
    for (v, c) in [
        (15.2593, 0.0),
        (20.511, 10.0),
        (1040.97, 10.0),
        (27.600, 20.0),
        (501.75, 20.0),
        (37.263, 30.0),
        (311.77, 30.0),
        (51.881, 40.0),
        (205.13, 40.0),
        (30.0, 22.808),
        (80.0, 48.530),
        (100.70, 49.7927),
    ] {
        let near = named(&[], ("velocity", 0.99 * v, 1.01 * v), ("dampingConstant", (c - 1.0_f64).max(0.0), c + 1.0));
        let curves = near.plane.hopf_curves().unwrap();
        let off = nearest(&near, &curves, near.unit(v, c));
        // Half a unit of the fifth digit of v is 2.5e-5 · v/2, at most, of a plane that is 0.02 v wide.
        assert!(off < 2.5e-3, "{v} {c}: {off}");
        assert!(distance(&case, curve, case.unit(v, c)) < 1e-4, "{v} {c}");
    }
    // Its top is where the two speeds meet.
    let top = (0..curve.y.len()).max_by(|a, b| curve.y[*a].total_cmp(&curve.y[*b])).unwrap();
    assert!((curve.y[top] - 49.7927).abs() < 5e-3, "{}", curve.y[top]);
}

#[test]
fn an_island_of_shimmy_is_a_closed_curve() {
    let case = named(&[("dampingConstant", 45.0)], ("velocity", 0.5, 300.0), ("casterLength", -0.3, 0.5));
    let curves = case.plane.hopf_curves().unwrap();
    let [island] = &curves[..] else { panic!("{} curves", curves.len()) };
    assert!(island.closed && island.bounds && island.kind == CurveKind::Hopf);
    // What is stable lies at its left: it goes round the island clockwise.
    let doubled: f64 = (1..island.x.len())
        .map(|i| (case.unit(island.x[i - 1], island.y[i - 1]), case.unit(island.x[i], island.y[i])))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    assert!((-1.0..-0.02).contains(&doubled), "{doubled}");
    assert!((case.plane.stable_area().unwrap() - 100.0 * (1.0 + 0.5 * doubled)).abs() < 0.02);
}

/// The last sliver of an island, 1e-7 below the damping above which no speed is unstable: smaller than any grid would see.
#[test]
fn a_tiny_island_is_found() {
    let case = named(&[("casterLength", 0.1)], ("velocity", 1.0, 1000.0), ("dampingConstant", 0.0, 200.0));
    assert_eq!(case.plane.hopf_curves().unwrap().len(), 1);
    // Over e the critical damping has a largest value too: near it the island in the e–v plane shrinks to a point.
    let peak = |e: f64| {
        let run = run_with::<Torsional>(&gear(&[("casterLength", e), ("dampingConstant", 0.0)]));
        let at =
            |v: f64| run.clone().with("velocity", v).unwrap().routh_hurwitz().unwrap().critical_damping.unwrap_or(0.0);
        golden(at, 20.0, 400.0).1
    };
    let (e, most) = golden(peak, 0.0, 0.3);
    let island = |c: f64| {
        let axes = (("velocity", 0.5, 700.0), ("casterLength", -0.5, 0.5));
        named(&[("dampingConstant", c)], axes.0, axes.1).plane.hopf_curves().unwrap()
    };
    let [tiny] = &island(most - 1e-5)[..] else { panic!("{:?} below {most} at {e}", island(most - 1e-5)) };
    assert!(tiny.closed && tiny.y.iter().all(|y| (y - e).abs() < 1e-3), "{tiny:?}");
    let width = |values: &[f64]| {
        values.iter().fold(f64::MIN, |a, b| a.max(*b)) - values.iter().fold(f64::MAX, |a, b| a.min(*b))
    };
    assert!(width(&tiny.x) < 1.0 && width(&tiny.y) < 1e-3, "{} {}", width(&tiny.x), width(&tiny.y));
    assert!(island(most + 1e-5).is_empty());
}

/// The place and the size of the largest value of a function that has one peak, by golden sections.
fn golden(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> (f64, f64) {
    let part = 0.5 * (5.0_f64.sqrt() - 1.0);
    while high - low > 1e-9 * high.abs().max(1.0) {
        let (a, b) = (high - part * (high - low), low + part * (high - low));
        if f(a) > f(b) { high = b } else { low = a }
    }
    (low.midpoint(high), f(low.midpoint(high)))
}

/// By eigenvalues alone, without the closed form: the same curves and the same area.
#[test]
fn any_models_way_finds_the_same_curves() {
    for (changes, x, y) in [
        (vec![], ("velocity", 0.5, 600.0), ("dampingConstant", 0.0, 100.0)),
        (vec![], ("velocity", 0.5, 100.0), ("casterLength", -0.9, 0.5)),
        (vec![("dampingConstant", 45.0)], ("velocity", 0.5, 300.0), ("casterLength", -0.3, 0.5)),
        (vec![], ("casterLength", -0.5, 0.5), ("halfContactLength", 0.01, 0.3)),
        (vec![("dampingConstant", 100.0)], ("velocity", 0.5, 100.0), ("freeplayAngle", 0.0, 0.05)),
    ] {
        let case = named(&changes, x, y);
        let (closed, open) = (case.plane.hopf_curves().unwrap(), case.plane.hopf_curves_by_eigenvalues().unwrap());
        assert_eq!(closed.len(), open.len(), "{}", case.what());
        assert_on_the_axis(&case, &open);
        for (a, b) in [(&closed, &open), (&open, &closed)] {
            for curve in a {
                let same = |other: &&HopfCurve| {
                    (other.kind, other.closed, other.bounds) == (curve.kind, curve.closed, curve.bounds)
                };
                for i in 0..curve.x.len() {
                    let at = case.unit(curve.x[i], curve.y[i]);
                    let off = nearest(&case, b.iter().filter(same), at);
                    // At the edge of freeplay, where the spring goes, slopes over 1e-5 of the plane see both sides.
                    assert!(off < 2e-5, "{} at {at:?}: {off}", case.what());
                }
            }
        }
    }
}

/// Pacejka (theory.md 8.1): without damping the boundaries are lines, e = σ + a and e = −t, whatever the speed; and in the
/// plane of e and a they cross nowhere.
#[test]
fn an_undamped_trailing_wheel_has_straight_boundaries() {
    let undamped = [("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
    let case = named(&undamped, ("velocity", 0.5, 100.0), ("casterLength", -0.9, 0.9));
    let curves = case.plane.hopf_curves().unwrap();
    let mut heights: Vec<(f64, CurveKind)> = curves.iter().map(|curve| (curve.y[0], curve.kind)).collect();
    heights.sort_by(|a, b| a.0.total_cmp(&b.0));
    let expected = [(-0.1 - 1e5 / 180e3, CurveKind::Divergence), (-0.1, CurveKind::Hopf), (0.4, CurveKind::Hopf)];
    assert_eq!(heights.len(), expected.len(), "{heights:?}");
    for ((height, kind), (at, of)) in heights.iter().zip(expected) {
        assert!((height - at).abs() < 1e-12 && *kind == of, "{heights:?}");
    }
    for curve in &curves {
        assert!(curve.y.iter().all(|y| (y - curve.y[0]).abs() < 1e-12) && curve.bounds);
    }
    let area = case.plane.stable_area().unwrap();
    let expected = 100.0 * (0.5 + (1e5 / 180e3)) / 1.8;
    assert!((area - expected).abs() < 1e-9, "{area} {expected}");
}

#[test]
fn where_nothing_crosses_there_is_no_curve() {
    let nothing = named(&[("verticalForce", 0.0)], ("velocity", 0.5, 100.0), ("dampingConstant", 1.0, 100.0));
    assert!(nothing.plane.hopf_curves().unwrap().is_empty());
    assert_eq!(nothing.plane.stable_area().unwrap(), 100.0);
    // On the axis all over: a spring without any damping.
    let undamped = [("verticalForce", 0.0), ("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
    let axis = named(&undamped, ("velocity", 0.5, 100.0), ("casterLength", 0.0, 0.5));
    assert!(axis.plane.hopf_curves().unwrap().is_empty());
    assert_eq!(axis.plane.stable_area().unwrap(), 0.0);
    let run = Run::of("torsional").unwrap();
    let limits = Plane::of(&run, ("sideForceLimitAngle", 0.01, 0.2), ("aligningMomentLimitAngle", 0.01, 0.2)).unwrap();
    assert!(limits.hopf_curves().unwrap().is_empty());
    assert_eq!(limits.stable_area().unwrap(), 0.0);
}

/// The terms of the condition of theory.md 2 that is zero where what leads is on the axis.
fn terms(values: &[f64], kind: CurveKind) -> Vec<f64> {
    let of = |name: &str| values[place(name)];
    let (v, sigma, i_z) = (of("velocity"), of("relaxationLength"), of("momentOfInertia"));
    let k = if of("freeplayAngle") == 0.0 { of("torsionalStiffness") } else { 0.0 };
    let d = of("dampingConstant") * v + of("treadWidthMomentConstant");
    let (e, a) = (of("casterLength"), of("halfContactLength"));
    let tire = [of("aligningMomentDerivative"), e * of("sideForceDerivative")].map(|part| part * of("verticalForce"));
    match kind {
        CurveKind::Divergence => [&[k][..], &tire].concat(),
        CurveKind::Hopf => {
            let mut terms = vec![i_z * v * v * d, sigma * d * k * sigma, sigma * d * d];
            for part in tire {
                for lever in [e, -a, -sigma] {
                    terms.push(i_z * v * v * part * lever);
                }
                terms.extend([sigma * d * part * e, -sigma * d * part * a]);
            }
            terms
        }
    }
}

/// Their sum over their sizes at a point of a case. What is zero itself there is so to a part of its axis.
fn residual(case: &Case, [x, y]: [f64; 2], kind: CurveKind) -> f64 {
    let sum: f64 = terms(&case.at(x, y), kind).iter().sum();
    let [x, y] = [(x, case.axes[0]), (y, case.axes[1])].map(|(value, (_, from, to))| value.abs() + 1e-9 * (to - from));
    sum.abs() / terms(&case.at(x, y), kind).iter().fold(f64::MIN_POSITIVE, |sum, term| sum + term.abs())
}

/// The condition itself: by the eigenvalues of the gear, positive where it holds.
fn signed(values: &[f64], kind: CurveKind) -> f64 {
    let all = eigenvalues::<Torsional>(values);
    match kind {
        CurveKind::Divergence => -all.iter().product::<Complex<f64>>().re,
        CurveKind::Hopf => -((all[0] + all[1]) * (all[0] + all[2]) * (all[1] + all[2])).re,
    }
}

/// Between two points the true boundary is within the accuracy asked for from the straight line, of the plane's size: across
/// the middle of each chord the condition changes its sign there.
#[test]
fn chords_keep_to_the_accuracy_asked_for() {
    let mut random = Random::seeded(14);
    let (mut chords, mut most) = (0, 0);
    for number in 0..200 {
        let case = Case::random(&mut random);
        let accuracy = [1e-4, 1e-5, 1e-6][number % 3];
        let mut spec = CurveSpec::of(case.plane.clone());
        assert_eq!(spec.accuracy, 1e-6);
        spec.accuracy = accuracy;
        for curve in spec.made().unwrap() {
            most = most.max(curve.x.len());
            for i in 1..curve.x.len() {
                let [a, b] = [i - 1, i].map(|i| case.unit(curve.x[i], curve.y[i]));
                let way = [b[0] - a[0], b[1] - a[1]];
                let length = way[0].hypot(way[1]);
                let beside = |side: f64| {
                    let aside = side * accuracy / length;
                    let at = [a[0].midpoint(b[0]) - aside * way[1], a[1].midpoint(b[1]) + aside * way[0]];
                    let at = at.map(|part| part.clamp(0.0, 1.0));
                    signed(&case.at(case.plane.x.value(at[0]), case.plane.y.value(at[1])), curve.kind)
                };
                if length > 1e-5 {
                    assert!(beside(1.0) * beside(-1.0) <= 0.0, "{} at {a:?} {b:?}", case.what());
                    chords += 1;
                }
            }
        }
    }
    assert!(chords > 3_000 && most < 3_000, "{chords} {most}");
}

/// Axes a thousand times as far as their sliders: every point is on a boundary of the gear there, and none is missed that is
/// not lost beside the axis; beyond, they are refused.
#[test]
fn points_of_wide_planes_are_on_the_boundary_or_refused() {
    let mut random = Random::seeded(15);
    let mut points = 0;
    for _ in 0..500 {
        let mut case = Case::random(&mut random);
        let axes = case.axes.map(|(name, from, to)| {
            let wide = 10_f64.powf(random.between(0.0, 3.0));
            (name, if from < 0.0 { from * wide } else { from / wide }, to * wide)
        });
        if axes.iter().any(|(_, from, to)| to <= from) {
            continue;
        }
        case = Case::of(case.values, axes, case.links);
        let curves = case.plane.hopf_curves().unwrap();
        for (at, kind) in case.meetings(&mut random, 10) {
            if (1e-6..1.0 - 1e-6).contains(&at[0]) {
                let off = nearest(&case, curves.iter().filter(|curve| curve.kind == kind && curve.bounds), at);
                assert!(off < 1e-5, "{} at {at:?}: the nearest {kind:?} curve is {off} away", case.what());
            }
        }
        for curve in curves {
            for (x, y) in curve.x.iter().zip(&curve.y) {
                let off = residual(&case, [*x, *y], curve.kind);
                assert!(off < 1e-6, "{} at {x} {y}: {off}", case.what());
                points += 1;
            }
        }
    }
    assert!(points > 20_000, "{points}");

    let refused = |x, y| named(&[], x, y).plane.hopf_curves().unwrap_err();
    let error = refused(("velocity", 1e-12, 1e12), ("dampingConstant", 0.0, 100.0));
    assert_eq!(
        error.to_string(),
        "x.to must be within ±120000 m/s: beyond, rounding hides the boundary, got 1000000000000"
    );
    assert_eq!(refused(("velocity", 1.0, 100.0), ("casterLength", -1e12, 1e12)).field, "y.from");
    assert_eq!(refused(("velocity", 50.0, 50.0 + 1e-9), ("casterLength", 0.0, 1.0)).field, "x.to");
}
