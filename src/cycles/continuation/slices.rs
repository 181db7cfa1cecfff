//! Long work comes in small pieces: counted in steps, since time depends on who else is at work.

use super::{BifurcationSpec, FoldSpec};
use crate::{
    run::{Run, Value},
    stability::Variation,
};

/// Steps of a piece, those with neighbours tenfold: some two milliseconds natively. A cycle that is corrected once takes two
/// or three rounds of some sixty steps with neighbours; a curve of folds takes its derivatives from six such rounds at once.
const MOST: u64 = 2_500;

fn gear(parameters: &[(&str, f64)]) -> Run {
    parameters.iter().fold(Run::of("torsional").unwrap(), |run, (name, value)| run.with(name, *value).unwrap())
}

fn record<const N: usize>(fields: [(&str, Value); N]) -> Value {
    Value::Record(fields.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
}

#[test]
fn diagrams_come_in_small_pieces() {
    let wide = 40_f64.to_radians();
    for (run, parameter, from, to) in [
        (gear(&[("dampingConstant", 20.0)]), "velocity", 10.0, 100.0),
        (gear(&[("dampingConstant", 20.0), ("friction.moment", 200.0)]), "velocity", 10.0, 100.0),
        (gear(&[("casterLength", -0.06), ("aligningMomentLimitAngle", wide)]), "velocity", 10.0, 120.0),
        (gear(&[("dampingConstant", 100.0), ("freeplayAngle", 0.0174)]), "velocity", 1.0, 100.0),
        (gear(&[("velocity", 80.0), ("dampingConstant", 20.0)]), "casterLength", -0.3, 0.3),
    ] {
        let mut diagram = BifurcationSpec::of(run, Variation::of(parameter, from, to)).begin().unwrap();
        let (mut before, mut most, mut pieces) = (0, 0, 0);
        while !diagram.done() {
            diagram.advance().unwrap();
            let work = diagram.work();
            most = most.max(work - before);
            (before, pieces) = (work, pieces + 1);
        }
        assert!(most < MOST, "{parameter}: {most} steps at a time, of {before} in {pieces}");
    }
}

#[test]
fn curves_of_folds_come_in_small_pieces() {
    let axis = |name: &str, from: f64, to: f64| {
        record([("parameter", Value::Text(name.into())), ("from", Value::Number(from)), ("to", Value::Number(to))])
    };
    let gear = [("casterLength", -0.06), ("aligningMomentLimitAngle", 40_f64.to_radians())];
    let spec = record([
        ("model", Value::Text("torsional".into())),
        ("parameters", record(gear.map(|(name, value)| (name, Value::Number(value))))),
        ("x", axis("velocity", 10.0, 120.0)),
        ("y", axis("dampingConstant", 0.0, 40.0)),
    ]);
    let mut curves = FoldSpec::read(&spec).unwrap().begin().unwrap();
    let (mut before, mut most, mut pieces) = ([0; 2], 0, 0);
    while !curves.done() {
        curves.advance().unwrap();
        let work = curves.work();
        // Of a diagram that has just begun nothing has been counted yet.
        let added = (0..2).map(|i| work[i].saturating_sub(before[i])).sum::<u64>();
        most = most.max(added);
        (before, pieces) = (work, pieces + 1);
    }
    assert!(!curves.curves().is_empty());
    assert!(most < 2 * MOST, "{most} steps at a time, of {before:?} in {pieces}");
}
