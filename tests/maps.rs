//! Maps of stability: every cell against the eigenvalues of the model's own Jacobian there, and maps of SciPy.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    planes::{LINKED, eigenvalues, link, random_axes, random_values, run_with},
    random::Random,
    reference,
};
use nalgebra::Complex;
use shimmy::{
    Code, Run,
    model::{Model, Torsional, TorsionalLinear},
    stability::{Cells, Links, MapSpec, Plane, Quantities, Tile},
};

const ALL: Quantities = Quantities { growth_rate: true, frequency: true, kind: true };

/// What a cell should say, by eigenvalues, and how exactly these are known.
struct Truth {
    leading: Complex<f64>,
    size: f64,
    /// How far the leading one is from being another one: from the axis, from a third one's real part, from its own partner.
    margin: f64,
}

fn truth<M: Model<3>>(values: &[f64]) -> Truth {
    let all = eigenvalues::<M>(values);
    let leading = all.into_iter().max_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im))).unwrap();
    let size = all.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
    let apart =
        |a: Complex<f64>, b: Complex<f64>| if a.im == 0.0 || b.im == 0.0 { (a - b).norm() } else { f64::INFINITY };
    let own = if leading.im == 0.0 { f64::INFINITY } else { leading.im };
    let others = all.iter().filter(|other| **other != leading && **other != leading.conj());
    let margin = others.fold(own, |least, other| least.min(apart(leading, *other)).min((leading.re - other.re).abs()));
    Truth { leading, size, margin }
}

/// Cells of random maps against the eigenvalues at their centres.
fn assert_cells<M: Model<3>>(seed: u64, maps: usize) {
    let table = M::PARAMETERS;
    let mut random = Random::seeded(seed);
    let (mut looked_at, mut stable, mut swinging) = (0, 0, 0);
    for _ in 0..maps {
        let values = random_values(&mut random, table);
        let [x, y] = random_axes(&mut random, table);
        let links = if random.once_in(3) { LINKED } else { Links::default() };
        let plane = Plane::of(&run_with::<M>(&values), x, y).unwrap().linked(links);
        let counts = [1 + random.between(0.0, 60.0) as usize, 1 + random.between(0.0, 60.0) as usize];
        let map = MapSpec::of(plane.clone(), counts[0], counts[1]).unwrap().with(ALL).made().unwrap();
        let cells = map.cells();
        assert_eq!(cells.stable.len(), counts[0] * counts[1]);
        let share = cells.stable.iter().map(|cell| f64::from(*cell)).sum::<f64>() / cells.stable.len() as f64;
        assert!((map.stable_percent().unwrap() - 100.0 * share).abs() < 1e-12);
        for _ in 0..10 {
            let (column, row) =
                (random.between(0.0, counts[0] as f64) as usize, random.between(0.0, counts[1] as f64) as usize);
            let mut here = values.clone();
            for ((name, from, to), index, count) in [(x, column, counts[0]), (y, row, counts[1])] {
                let place = table.iter().position(|p| p.name == name).unwrap();
                here[place] = from + (to - from) * (index as f64 + 0.5) / count as f64;
            }
            link::<M>(&mut here, links, [x.0, y.0]);
            let Truth { leading, size, margin } = truth::<M>(&here);
            let cell = row * counts[0] + column;
            // Rounding moves an eigenvalue by ε of the largest, or by its root where two are one. Near the axis nobody can tell.
            let error = 1e-9_f64.min(1e-14 * size / margin.max(1e-300)).max(1e-11) * size;
            let what = format!("{x:?} {y:?} {here:?}: {leading}");
            assert!((cells.growth_rate[cell] - leading.re).abs() <= error, "{what}, not {}", cells.growth_rate[cell]);
            if leading.re.abs() > error {
                assert_eq!(cells.stable[cell] == 1, leading.re < 0.0, "{what}");
            }
            if margin > 1e-6 * size {
                assert_eq!(cells.kind[cell] == 1, leading.im > 0.0, "{what}");
                let frequency = leading.im / std::f64::consts::TAU;
                assert!(
                    (cells.frequency[cell] - frequency).abs() <= 1e-9 * size,
                    "{what}, not {}",
                    cells.frequency[cell]
                );
            }
            looked_at += 1;
            stable += usize::from(cells.stable[cell]);
            swinging += usize::from(cells.kind[cell]);
        }
    }
    assert!(looked_at >= 5_000, "{looked_at}");
    assert!((0.1..0.9).contains(&(stable as f64 / looked_at as f64)), "{stable}");
    assert!((0.1..0.98).contains(&(swinging as f64 / looked_at as f64)), "{swinging}");
}

#[test]
fn cells_are_what_eigenvalues_say() {
    assert_cells::<Torsional>(1, 600);
}

#[test]
fn cells_of_the_linear_gear_are_what_eigenvalues_say() {
    assert_cells::<TorsionalLinear>(2, 500);
}

/// Both ways to a map, the closed form and one eigenvalue problem a cell, on the same planes.
#[test]
fn both_ways_give_the_same_map() {
    let mut random = Random::seeded(3);
    for _ in 0..60 {
        let values = random_values(&mut random, Torsional::PARAMETERS);
        let [x, y] = random_axes(&mut random, Torsional::PARAMETERS);
        let plane = Plane::of(&run_with::<Torsional>(&values), x, y).unwrap().linked(LINKED);
        let spec = MapSpec::of(plane, 17, 13).unwrap().with(ALL);
        let closed = spec.clone().made().unwrap();
        let mut each = spec.begin_by_eigenvalues();
        let mut fractions = vec![0.0];
        while !each.done() {
            each.advance().unwrap();
            assert!(each.fraction() > *fractions.last().unwrap());
            fractions.push(each.fraction());
        }
        assert_eq!(each.fraction(), 1.0);
        for (index, (a, b)) in closed.cells().growth_rate.iter().zip(&each.cells().growth_rate).enumerate() {
            let size = b.abs().max(1.0) * 1e3;
            assert!((a - b).abs() < 1e-7 * size, "{x:?} {y:?} {values:?}: {a} {b}");
            if b.abs() > 1e-7 * size {
                assert_eq!(closed.cells().stable[index], each.cells().stable[index]);
            }
        }
    }
}

/// theory.md, section 2: shares of planes, by SciPy's eigenvalues. Of 160 000 cells a few are on the boundary to rounding.
#[test]
fn shares_of_scipy_are_met() {
    let maps = reference::maps(&reference::handed_over());
    assert!(maps.len() >= 3);
    for (id, spec, percent) in maps {
        let got = spec.made().unwrap().stable_percent().unwrap();
        assert!((got - percent).abs() < 2e-3, "{id}: {got} % for {percent} %");
    }
}

fn map(x: (&str, f64, f64), y: (&str, f64, f64), counts: [usize; 2]) -> Cells {
    let plane = Plane::of(&Run::of("torsional").unwrap(), x, y).unwrap();
    MapSpec::of(plane, counts[0], counts[1]).unwrap().with(ALL).made().unwrap().cells().clone()
}

#[test]
fn exchanged_axes_give_the_transposed_map() {
    for (x, y) in [
        (("velocity", 0.5, 600.0), ("dampingConstant", 0.0, 100.0)),
        (("casterLength", -0.8, 0.5), ("torsionalStiffness", 0.0, 1e5)),
        (("halfContactLength", 0.01, 0.3), ("momentOfInertia", 0.1, 10.0)),
    ] {
        let (there, back) = (map(x, y, [70, 50]), map(y, x, [50, 70]));
        for (row, column) in (0..50).flat_map(|row| (0..70).map(move |column| (row, column))) {
            let (a, b) = (row * 70 + column, column * 50 + row);
            assert_eq!(there.stable[a], back.stable[b], "{x:?} {y:?} {row} {column}");
            let apart = (there.growth_rate[a] - back.growth_rate[b]).abs();
            assert!(apart < 1e-9 * (1.0 + there.growth_rate[a].abs()), "{x:?} {y:?}: {apart}");
        }
    }
}

#[test]
fn tiles_make_up_the_map() {
    let plane = Plane::of(&Run::of("torsional").unwrap(), ("velocity", 0.5, 600.0), ("dampingConstant", 0.0, 100.0));
    let whole = MapSpec::of(plane.unwrap(), 90, 40).unwrap().with(ALL);
    let map = whole.clone().made().unwrap();
    let mut count = 0;
    for (column, columns) in [(0, 31), (31, 59)] {
        for (row, rows) in [(0, 1), (1, 20), (21, 19)] {
            let tile = Tile { column, row, columns, rows };
            let part = MapSpec { tile, ..whole.clone() }.made().unwrap();
            for index in 0..rows * columns {
                let place = (row + index / columns) * 90 + column + index % columns;
                assert_eq!(part.cells().stable[index], map.cells().stable[place]);
                assert_eq!(part.cells().kind[index], map.cells().kind[place]);
                // They may have come to it from another neighbour.
                let apart = (part.cells().growth_rate[index] - map.cells().growth_rate[place]).abs();
                assert!(apart < 1e-11, "{apart}");
            }
            count += part.cells().stable_count;
        }
    }
    assert_eq!(count, map.cells().stable_count);
}

/// theory.md, section 4: with freeplay the gear rests in its gap, where no spring acts, however narrow the gap is.
#[test]
fn freeplay_as_an_axis_leaves_the_spring_out() {
    let speeds = ("velocity", 0.5, 100.0);
    let with = map(speeds, ("freeplayAngle", 0.0, 0.05), [400, 3]);
    let run = Run::of("torsional").unwrap().with("torsionalStiffness", 0.0).unwrap();
    let plane = Plane::of(&run, speeds, ("sideForceLimitAngle", 0.05, 0.1)).unwrap();
    let without_spring = MapSpec::of(plane, 400, 3).unwrap().with(ALL).made().unwrap();
    assert_eq!(with, *without_spring.cells());
    assert_ne!(with, map(speeds, ("sideForceLimitAngle", 0.05, 0.1), [400, 3]));
    // A gear whose freeplay does not vary, and is 0, keeps its spring: the last map is of one.
}

#[test]
fn a_bad_plane_is_refused() {
    let run = Run::of("torsional").unwrap();
    let (good, also) = (("velocity", 1.0, 100.0), ("dampingConstant", 0.0, 100.0));
    let refused = |x, y| Plane::of(&run, x, y).unwrap_err();
    let error = refused(("velocty", 1.0, 2.0), also);
    assert_eq!(
        (error.code, error.field.as_str(), error.suggestion),
        (Code::UnknownName, "x.parameter", Some("velocity"))
    );
    let error = refused(good, good);
    assert_eq!(error.to_string(), "y.parameter must be another parameter than x.parameter, got velocity");
    assert_eq!(refused(good, ("dampingConstant", 3.0, 3.0)).to_string(), "y.to must be > 3 (from), got 3");
    assert_eq!(refused(good, ("dampingConstant", 3.0, 2.0)).code, Code::NotAscending);
    assert_eq!(refused(("velocity", 0.0, 2.0), also).to_string(), "x.from must be > 0 m/s, got 0");
    assert_eq!(refused(good, ("dampingConstant", 0.0, f64::INFINITY)).field, "y.to");
    assert_eq!(refused(good, ("momentOfInertia", f64::NAN, 1.0)).code, Code::NotFinite);

    let refused = |columns, rows| MapSpec::of(Plane::of(&run, good, also).unwrap(), columns, rows).unwrap_err();
    assert_eq!(refused(0, 5).field, "x.count");
    assert_eq!(refused(5, 0).field, "y.count");
    let error = refused(4000, 2501);
    assert_eq!((error.code, error.field.as_str()), (Code::TooLarge, "y.count"));
    assert_eq!(error.allowed, "at most 2500 with 4000 cells across (x.count)");
    assert_eq!(refused(usize::MAX, 2).field, "x.count");
}

/// Growth rates leave the numbers only where speed and lengths are absurd; that is said.
#[test]
fn growth_beyond_the_numbers_is_refused() {
    let run = Run::of("torsional").unwrap().with("relaxationLength", 1e-300).unwrap();
    let plane = Plane::of(&run, ("momentOfInertia", 1e-300, 2e-300), ("dampingConstant", 0.0, 100.0)).unwrap();
    let error = MapSpec::of(plane, 3, 3).unwrap().made().unwrap_err();
    assert_eq!((error.code, error.field.as_str()), (Code::NotFinite, "parameters"));
}
