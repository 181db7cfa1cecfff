//! Maps of stability: the crate beside the plain loop over the same cells.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use serde_json::{Value, json};
use shimmy::{
    Run,
    stability::{MapSpec, Plane, Quantities},
};

/// The shortest of the runs that fit into this time is reported.
const WATCHED: Duration = Duration::from_millis(300);

/// Milliseconds.
fn shortest(mut work: impl FnMut()) -> f64 {
    let (start, mut least) = (Instant::now(), Duration::MAX);
    while start.elapsed() < WATCHED {
        let one = Instant::now();
        work();
        least = least.min(one.elapsed());
    }
    least.as_secs_f64() * 1e3
}

/// The conditions of Routh and Hurwitz as a textbook has them, cell by cell, with the default gear.
fn plain(count: usize) -> Vec<u8> {
    let [a, sigma, inertia, k, c, load, side_force, aligning, tread] =
        black_box([0.1, 0.3, 1.0, 1e5, 10.0, 9000.0, 20.0, 2.0, 270.0]);
    let mut stable = vec![0; count * count];
    for row in 0..count {
        let e = 0.5 * (row as f64 + 0.5) / count as f64;
        for column in 0..count {
            let v = 0.5 + 99.5 * (column as f64 + 0.5) / count as f64;
            let b = -(aligning + e * side_force) * load / (sigma * inertia);
            let a2 = v / sigma + (c + tread / v) / inertia;
            let a1 = k / inertia + (c + tread / v) * v / (sigma * inertia) - (e - a) * b;
            let a0 = v * k / (sigma * inertia) - v * b;
            stable[count * row + column] = u8::from(a2 > 0.0 && a0 > 0.0 && a2 * a1 > a0);
        }
    }
    stable
}

/// Every measurement; `place` begins the names of ours.
pub fn measured(place: &str) -> Vec<Value> {
    let run = Run::of("torsional").expect("it is listed");
    let plane = Plane::of(&run, ("velocity", 0.5, 100.0), ("casterLength", 0.0, 0.5)).expect("a plane");
    let map = |columns, rows| MapSpec::of(plane.clone(), columns, rows).expect("a map");
    let only = map(1000, 1000).with(Quantities { growth_rate: false, frequency: false, kind: false });
    let percent = |stable: &[u8]| 100.0 * stable.iter().map(|cell| f64::from(*cell)).sum::<f64>() / stable.len() as f64;
    let made = |spec: &MapSpec| spec.clone().made().expect("it can be made");
    let each = || {
        let mut map = map(100, 100).begin_by_eigenvalues();
        while !map.done() {
            map.advance().expect("it can be made");
        }
        map
    };
    let row = |what: String, cells: usize, milliseconds: f64, stable: &[u8]| json!({ "what": what, "cells": cells, "milliseconds": milliseconds, "percent": percent(stable) });
    vec![
        row(
            "plain Rust, native, cell by cell: e over v".into(),
            1_000_000,
            shortest(|| drop(black_box(plain(1000)))),
            &plain(1000),
        ),
        row(
            format!("{place}: e over v"),
            1_000_000,
            shortest(|| drop(black_box(made(&only)))),
            &made(&only).cells().stable,
        ),
        row(
            format!("{place}: growth rates, e over v"),
            120_000,
            shortest(|| drop(black_box(made(&map(400, 300))))),
            &made(&map(400, 300)).cells().stable,
        ),
        row(
            format!("{place}: as any model, by the eigenvalues of every cell"),
            10_000,
            shortest(|| drop(black_box(each()))),
            &each().cells().stable,
        ),
    ]
}
