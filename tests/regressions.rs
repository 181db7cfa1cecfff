//! Runs that once had a wrong answer, or none.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::linear::gear;
use shimmy::{Code, Run, model::laws::Curves, run::Value};

#[test]
fn a_fixed_step_is_judged_with_the_spring_at_work() {
    // Inside the gap there is no spring; outside, 4 ms are past stability: this went to 1e21 rad without a word.
    let stiff = gear(&[
        ("torsionalStiffness", 3e5),
        ("momentOfInertia", 0.1),
        ("freeplayAngle", 0.02),
        ("dampingConstant", 20.0),
    ]);
    let run = stiff.starting("torsionAngle", 0.01).unwrap().by("rk4").unwrap();
    assert_eq!(run.clone().stepping(4e-3).unwrap().simulate().unwrap_err().code, Code::Unsuited);
    assert!(run.stepping(1e-4).unwrap().simulate().is_ok());
}

#[test]
fn a_parameter_that_a_fixed_step_cannot_follow_is_refused_live() {
    let run = gear(&[("velocity", 80.0)]).starting("torsionAngle", 0.01).unwrap().by("rk4").unwrap();
    let mut live = run.live().unwrap();
    live.advance(0.1).unwrap();
    let before = live.state();
    assert_eq!(live.set("momentOfInertia", 1e-4).unwrap_err().code, Code::Unsuited);
    assert_eq!(live.state(), before);
    live.set("dampingConstant", 20.0).unwrap();
    live.advance(0.1).unwrap();
}

#[test]
fn a_snapshot_fits_only_a_run_with_its_settings() {
    let run = gear(&[]).starting("torsionAngle", 0.01).unwrap();
    let mut live = run.live().unwrap();
    live.advance(0.1).unwrap();
    let bytes = live.snapshot();
    for other in [run.clone().by("rodas").unwrap(), run.clone().within(1e-6).unwrap()] {
        assert_eq!(other.live().unwrap().restore(&bytes).unwrap_err().code, Code::BadSnapshot);
    }
    assert!(run.live().unwrap().restore(&bytes).is_ok());
}

#[test]
fn the_trace_ends_at_the_time_shown_and_keeps_to_its_room() {
    let mut live = gear(&[("velocity", 80.0)]).starting("torsionAngle", 0.05).unwrap().live().unwrap();
    live.advance(0.1).unwrap();
    let shown = live.trace(1e6).unwrap();
    assert!(*shown.time.last().unwrap() <= live.time());
    live.set_state("torsionAngle", 0.02).unwrap();
    live.advance(0.01).unwrap();
    let next = live.trace(1e6).unwrap();
    assert!(next.time[0] >= *shown.time.last().unwrap() && next.time.is_sorted());
    for _ in 0..40_000 {
        live.kick(0.0).unwrap();
    }
    assert!(live.trace(1e6).unwrap().time.len() <= 16_384);
}

#[test]
fn an_envelope_sees_the_peak_in_the_step_it_starts_in() {
    let mut live =
        gear(&[("velocity", 80.0), ("dampingConstant", 20.0)]).starting("torsionAngle", 0.2).unwrap().live().unwrap();
    live.advance(1.0).unwrap();
    for start in 0..200 {
        // One cycle, from every phase.
        let from = 0.9 + 1e-4 * f64::from(start);
        let to = from + 0.0193;
        let envelope = live.envelope(from, to, 1.0).unwrap();
        let psi = &live.history(from, to, 2001.0).unwrap().states[0];
        let (low, high) = psi.iter().fold((0.0_f64, 0.0_f64), |(low, high), value| (low.min(*value), high.max(*value)));
        // Samples 10 µs apart miss a peak by (ω Δt/2)²/2 = 1e-6 of it.
        assert!((envelope.high[0] - high).abs() < 1e-5 && (envelope.low[0] - low).abs() < 1e-5, "from {from}");
    }
}

#[test]
fn parts_that_no_model_takes_may_be_absent_and_nothing_else() {
    let read = |part: &str, value: Value| {
        Run::read(&Value::Record(vec![("model".into(), Value::Text("torsional".into())), (part.into(), value)]))
    };
    for part in ["damper", "control", "disturbance", "tire"] {
        assert!(read(part, Value::Absent).is_ok(), "{part}");
    }
    let error = read("tire", Value::Record(Vec::new())).unwrap_err();
    assert_eq!((error.code, error.field.as_str()), (Code::Unsuited, "tire"));
}

/// π/α_g was infinite, and the aligning moment of no slip not a number: in curves to draw, and at rest.
#[test]
fn an_aligning_moment_that_ends_next_to_zero_is_a_number() {
    let curves = Curves::new(0.3, 0.3, 3.0).unwrap();
    for limit in [5e-324, 1e-310, 1.7e-308] {
        let run = gear(&[("aligningMomentLimitAngle", limit)]);
        let laws = run.force_laws(&curves).unwrap();
        assert!(laws.slip_angle.contains(&limit) && laws.slip_angle.contains(&0.0));
        // It is below C_Mα α_g/π where it is at all.
        assert!(
            laws.aligning_moment.iter().all(|moment| moment.abs() <= 18_000.0 * limit),
            "{:?}",
            laws.aligning_moment
        );
        for y in [0.0, 5e-324, 0.01] {
            assert!(run.forces(&[0.0, 0.0, y]).unwrap().aligning_moment.abs() <= 18_000.0 * limit);
        }
        // As good as a tire without one.
        let moved = |run: Run| {
            run.starting("torsionAngle", 0.05).unwrap().lasting(0.1).unwrap().sampled(11.0).unwrap().simulate()
        };
        let without = gear(&[("aligningMomentLimitAngle", limit), ("aligningMomentDerivative", 0.0)]);
        for (with, without) in moved(run).unwrap().states.iter().zip(&moved(without).unwrap().states) {
            assert!(
                with.iter().zip(without).all(|(with, without)| (with - without).abs() < 1e-6),
                "{with:?} {without:?}"
            );
        }
    }
}
