//! Planes of gears without damping, spring or trail, cut so that boundaries fall where planes are halved.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    planes::{Case, gear, integral, nearest, place},
    random::Random,
};
use shimmy::{
    model::{Model, Torsional},
    stability::{CurveKind, Links},
};

/// theory.md 8.1: stable above e = σ + a = 0.4, and from −0.6556, where it falls, to −t = −0.1.
#[test]
fn a_boundary_at_three_quarters_of_the_plane_is_found() {
    let undamped = [("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
    let axes = [("velocity", 1.0, 120.0), ("casterLength", -0.8, 0.8)];
    let case = Case::of(gear(&undamped), axes, Links::default());
    let mut heights: Vec<f64> = case.plane.hopf_curves().unwrap().iter().map(|curve| curve.y[0]).collect();
    heights.sort_by(f64::total_cmp);
    let expected = [-0.1 - 1e5 / 180e3, -0.1, 0.4];
    assert_eq!(heights.len(), 3, "{heights:?}");
    assert!(heights.iter().zip(expected).all(|(got, expected)| (got - expected).abs() < 1e-12), "{heights:?}");
    let share = 100.0 * (0.4 + (1e5 / 180e3)) / 1.6;
    assert!((case.plane.stable_area().unwrap() - share).abs() < 1e-9, "{}", case.plane.stable_area().unwrap());
}

/// Without damping, seldom with a spring or a trail; a boundary in e at a half, a quarter or an eighth of its axis.
fn degenerate(random: &mut Random) -> Case {
    let zero = [("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
    let mut values = gear(&zero);
    for name in ["torsionalStiffness", "aligningMomentDerivative"] {
        values[place(name)] *= f64::from(u8::from(!random.once_in(2)));
    }
    let of = |name: &str| values[place(name)];
    let side = of("sideForceDerivative") * of("verticalForce");
    let trail = of("aligningMomentDerivative") / of("sideForceDerivative");
    let boundaries =
        [of("relaxationLength") + of("halfContactLength"), -trail, -trail - of("torsionalStiffness") / side];
    let boundary = boundaries[random.between(0.0, 3.0) as usize];
    let part = random.between(0.0, 9.0).floor() / 8.0;
    let width = if random.once_in(2) { 1.6 } else { random.between(0.1, 2.0) };
    let caster = if random.once_in(3) {
        ("casterLength", -0.8, 0.8)
    } else {
        ("casterLength", boundary - part * width, boundary + (1.0 - part) * width)
    };
    loop {
        let parameter = &Torsional::PARAMETERS[random.between(0.0, Torsional::PARAMETERS.len() as f64) as usize];
        let idle = ["casterLength", "dampingConstant", "treadWidthMomentConstant", "freeplayAngle"];
        if !idle.contains(&parameter.name) {
            let (a, b) = (random.between(parameter.min, parameter.max), random.between(parameter.min, parameter.max));
            let ends = if random.once_in(3) { (parameter.min, parameter.max) } else { (a.min(b), a.max(b)) };
            let axes = [(parameter.name, ends.0, ends.1), caster];
            return Case::of(values, axes, Links::default());
        }
    }
}

/// Areas against the integral of rows in closed form; where a row or a column meets the boundary there is a curve.
#[test]
fn degenerate_planes_have_all_their_curves_and_their_area() {
    let mut random = Random::seeded(17);
    let (mut between, mut crossings) = (0, 0);
    for _ in 0..400 {
        let case = degenerate(&mut random);
        let turned = Case::of(case.values.clone(), [case.axes[1], case.axes[0]], case.links);
        let expected = 100.0 * integral(&|part| case.stable_part(part));
        between += usize::from((0.1..99.9).contains(&expected));
        for case in [case, turned] {
            let area = case.plane.stable_area().unwrap();
            assert!((area - expected).abs() < 1e-4, "{}: {area} % for {expected} %", case.what());
            let curves = case.plane.hopf_curves().unwrap();
            for (at, kind) in case.meetings(&mut random, 10) {
                // A boundary on the plane's own edge bounds nothing in it.
                if at[0].min(1.0 - at[0]) >= 1e-9 {
                    // Any kind: without spring and damping both conditions are zero in the same place.
                    let off = nearest(&case, &curves, at);
                    assert!(off < 2e-6, "{} at {at:?}: no curve, by {kind:?}, nearer than {off}", case.what());
                    crossings += 1;
                }
            }
            for curve in &curves {
                assert!(
                    curve.frequency.iter().all(|f| (*f > 0.0) == (curve.kind == CurveKind::Hopf)),
                    "{}",
                    case.what()
                );
            }
        }
    }
    assert!(between > 200 && crossings > 3_000, "{between} {crossings}");
}
