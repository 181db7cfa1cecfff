//! The stable share of a plane's area, by its boundary: the integral of its rows, and the limit of counted shares.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    planes::{Case, integral, named},
    random::Random,
    reference,
};
use shimmy::stability::{MapSpec, Quantities, Tile};

/// The area by the boundary against the integral over y of the stable part of each row in closed form: to 1e-4 of a percent.
#[test]
fn the_stable_area_is_the_integral_of_the_rows() {
    let mut random = Random::seeded(13);
    let (mut between, mut worst) = (0, 0.0_f64);
    for _ in 0..300 {
        let case = Case::random(&mut random);
        let area = case.plane.stable_area().unwrap();
        let expected = 100.0 * integral(&|part| case.stable_part(part));
        assert!((area - expected).abs() < 1e-4, "{}: {area} % for {expected} %", case.what());
        worst = worst.max((area - expected).abs());
        between += usize::from((0.1..99.9).contains(&area));
    }
    assert!(between > 100, "{between}, {worst}");
}

/// theory.md's planes: the share by count comes to the share by area as the cells become small, and SciPy's are near it.
#[test]
fn counted_shares_come_to_the_area() {
    for (id, spec, percent) in reference::maps(&reference::handed_over()) {
        let area = spec.plane.stable_area().unwrap();
        // Of 400 × 400 cells those on the boundary, some 800 at most, are right but for half of them at worst; nearly all of that cancels.
        assert!((area - percent).abs() < 0.02, "{id}: {area} % for {percent} %");
        let none = Quantities { growth_rate: false, frequency: false, kind: false };
        let fine = MapSpec::of(spec.plane, 3000, 3000).unwrap().with(none).made().unwrap();
        assert!((fine.stable_percent().unwrap() - area).abs() < 1e-3, "{id}: {area} %");
        assert_eq!(fine.stable_area().unwrap(), Some(area));
    }
}

#[test]
fn areas_of_tiles_make_up_that_of_the_map() {
    let case = named(&[], ("velocity", 0.5, 600.0), ("dampingConstant", 0.0, 100.0));
    let whole = MapSpec::of(case.plane.clone(), 70, 50).unwrap();
    let mut area = 0.0;
    for (column, columns) in [(0, 13), (13, 57)] {
        for (row, rows) in [(0, 20), (20, 30)] {
            let tile = Tile { column, row, columns, rows };
            let part = MapSpec { tile, ..whole.clone() }.made().unwrap();
            area += part.stable_area().unwrap().unwrap() * (columns * rows) as f64;
        }
    }
    let (sum, whole) = (area / 3500.0, case.plane.stable_area().unwrap());
    assert!((sum - whole).abs() < 1e-4, "{sum} {whole}");
    assert_eq!(MapSpec::of(case.plane, 3, 3).unwrap().begin().stable_area().unwrap(), None);
}
