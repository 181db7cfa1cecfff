//! Landing rolls, against motions that were computed without this crate, and against what must be so.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::reference::{number, run, text};
use shimmy::{
    Code, Run,
    run::Value,
    scenario::{Landing, LandingRoll},
};

fn gear(damping: f64) -> Run {
    Run::of("torsional")
        .and_then(|run| run.with("dampingConstant", damping)?.starting("torsionAngle", 0.01)?.rolling())
        .expect("a roll")
}

fn rolled(run: Run) -> Landing {
    LandingRoll::of(run).and_then(LandingRoll::made).expect("a landing")
}

/// The largest |ψ| in each second.
fn peaks(landing: &Landing, seconds: usize) -> Vec<f64> {
    let mut peaks = vec![0.0_f64; seconds];
    for (time, psi) in landing.trajectory.time.iter().zip(&landing.trajectory.states[0]) {
        if let Some(peak) = peaks.get_mut(*time as usize) {
            *peak = peak.max(psi.abs());
        }
    }
    peaks
}

#[test]
fn rolls_made_with_scipy_are_met() {
    let file: serde_json::Value = serde_json::from_str(include_str!("landing-reference.json")).expect("a JSON file");
    for case in file["rolls"].as_array().expect("a list") {
        let id = text(&case["id"]);
        let list =
            |name: &str| -> Vec<f64> { case["expect"][name].as_array().expect("a list").iter().map(number).collect() };
        let early = run(&case["run"]).at(list("times")).expect("times");
        let motion = rolled(early);
        for (got, expect) in motion.trajectory.states[0].iter().zip(list("torsionAngle")) {
            // Of a swing of 0.3 rad; LSODA's tolerance leaves some 1e-7 after fifty cycles.
            assert!((got - expect).abs() < 1e-6, "{id}: {got} {expect}");
        }
        let whole = rolled(run(&case["run"]).sampled(500_001.0).expect("samples"));
        let expect = list("peaks");
        for (second, (got, expect)) in peaks(&whole, expect.len()).into_iter().zip(&expect).enumerate() {
            // 20,000 values a second miss a peak by 3e-5 of it; where the motion falls to nothing its size is SciPy's error.
            assert!((got - expect).abs() < 3e-4 * expect + 1e-6, "{id}, second {second}: {got} {expect}");
        }
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let drawn = rolled(run(&case["run"]).drawn(2000.0).expect("rows"));
        assert!((most(&drawn.trajectory.states[0]) / most(&expect) - 1.0).abs() < 3e-5, "{id}, drawn");
    }
}

#[test]
fn the_speed_falls_to_the_last_one_and_stays() {
    let landing = rolled(gear(60.0).lasting(30.0).and_then(|run| run.sampled(301.0)).expect("a run"));
    for (time, velocity) in landing.trajectory.time.iter().zip(&landing.velocity) {
        assert_eq!(*velocity, (80.0 - 3.0 * time).max(5.0));
    }
    let kinds = landing.trajectory.events.kinds;
    let slowed = kinds.iter().position(|kind| *kind == "final-velocity").expect("a kind") as u8;
    let events = &landing.trajectory.events;
    let at: Vec<f64> =
        events.time.iter().zip(&events.kind).filter(|(_, kind)| **kind == slowed).map(|(t, _)| *t).collect();
    assert!(at.len() == 1 && (at[0] - 25.0).abs() < 1e-9, "{at:?}");
    // Without a duration it ends there.
    let landing = rolled(gear(60.0));
    assert_eq!(landing.trajectory.time.last(), Some(&25.0));
    assert_eq!(landing.velocity.last(), Some(&5.0));
}

/// A speed that hardly falls is a constant one: b = 10⁻⁹ m/s² against a run at 80 m/s.
#[test]
fn a_roll_that_hardly_slows_is_a_run_at_constant_speed() {
    let slow = gear(20.0).with("deceleration", 1e-9).and_then(|run| run.lasting(0.5)?.sampled(50.0)).expect("a run");
    let steady = Run::of("torsional").and_then(|run| {
        run.with("dampingConstant", 20.0)?
            .with("velocity", 80.0)?
            .starting("torsionAngle", 0.01)?
            .lasting(0.5)?
            .sampled(50.0)
    });
    let (slow, steady) = (rolled(slow).trajectory, steady.and_then(|run| run.simulate()).expect("a run"));
    for (a, b) in slow.states[0].iter().zip(&steady.states[0]) {
        assert!((a - b).abs() < 1e-7, "{a} {b}");
    }
}

/// With all of the weight on and κ linked, F_z(v) is F_z: λ = 0 makes no difference whatever the link.
#[test]
fn weight_comes_on_as_lift_decays() {
    let at_end = |lift: f64| {
        let run = gear(20.0).with("liftFraction", lift).and_then(|run| run.drawn(4000.0)).expect("a run");
        peaks(&rolled(run), 25)
    };
    let (full, light) = (at_end(0.0), at_end(0.8));
    // Light at first, it is calm where the heavy one shakes, and shakes once the weight has come on.
    assert!(light[3] < 1e-5 && full[3] > 0.2, "{light:?} {full:?}");
    assert!(light[14] > 0.2, "{light:?}");
}

#[test]
fn an_uneven_runway_shakes_a_wheel_that_was_at_rest() {
    let run = gear(60.0).starting("torsionAngle", 0.0).and_then(|run| run.disturbed()).expect("a run");
    let run = run.with("disturbance.start", 2.0).and_then(|run| run.with("disturbance.duration", 0.5)).expect("a run");
    let landing = rolled(run.drawn(1e5).expect("rows"));
    let found = peaks(&landing, 25);
    assert_eq!((found[0], found[1]), (0.0, 0.0));
    assert!(found[2] > 1e-3 && found[20] < 1e-2 * found[2], "{found:?}");
    let runway = landing.trajectory.events.kinds.iter().position(|kind| *kind == "runway").expect("a kind") as u8;
    let events = &landing.trajectory.events;
    let at: Vec<f64> =
        events.time.iter().zip(&events.kind).filter(|(_, kind)| **kind == runway).map(|(t, _)| *t).collect();
    assert!(at.len() == 2 && (at[0] - 2.0).abs() < 1e-9 && (at[1] - 2.5).abs() < 1e-9, "{at:?}");
}

#[test]
fn no_peak_is_lost_where_rows_are_few() {
    let run = gear(20.0).fitted("modified-bouc-wen").expect("a damper");
    let fine = rolled(run.clone().drawn(1e7).expect("rows"));
    let few = rolled(run.drawn(600.0).expect("rows"));
    assert!(few.trajectory.time.len() <= 640 && few.trajectory.time.is_sorted());
    assert_eq!(few.velocity.len(), few.trajectory.time.len());
    for (fine, few) in fine.trajectory.states.iter().zip(&few.trajectory.states) {
        let extremes =
            |column: &[f64]| column.iter().fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
        assert_eq!(extremes(fine), extremes(few));
    }
}

#[test]
fn made_in_slices_it_is_the_same() {
    let run = gear(40.0).sampled(500.0).expect("samples");
    let whole = rolled(run.clone());
    let mut sliced = LandingRoll::of(run).expect("a roll");
    let (mut slices, mut last) = (0, 0.0);
    while !sliced.done() {
        sliced.advance().expect("a step");
        assert!(sliced.fraction() >= last && sliced.landing().trajectory.time.len() <= 500);
        (slices, last) = (slices + 1, sliced.fraction());
    }
    assert!(slices > 3 && last == 1.0);
    assert_eq!(sliced.landing(), whole);
}

#[test]
fn a_live_landing_slows_down_and_finds_back() {
    let run = gear(20.0).fitted("modified-bouc-wen").and_then(|run| run.with("damper.command", 0.2)).expect("a run");
    let mut live = run.clone().live().expect("a motion");
    live.advance(3.0).expect("some time");
    let there = live.state();
    let motion = run.at(vec![3.0]).and_then(|run| run.simulate()).expect("a trajectory");
    for (live, motion) in there.iter().zip(&motion.states) {
        assert!((live - motion[0]).abs() < 1e-5 * motion[0].abs().max(1e-3), "{live} {}", motion[0]);
    }
    live.set("damper.command", 1.5).expect("a current");
    live.advance(2.0).expect("some time");
    let later = live.state();
    live.seek(3.5).expect("the past");
    live.seek(5.0).expect("the present");
    assert_eq!(live.state(), later);
    assert_eq!(live.set("finalVelocity", 90.0).unwrap_err().field, "finalVelocity");
}

#[test]
fn what_is_known_of_a_constant_speed_alone_is_refused() {
    let run = gear(20.0);
    let codes = [
        run.outlook().unwrap_err().code,
        run.eigenvalues().unwrap_err().code,
        run.routh_hurwitz().unwrap_err().code,
        run.limit_cycle(None).unwrap_err().code,
        run.energy().unwrap_err().code,
        run.forces(&[0.0; 3]).unwrap_err().code,
        run.describing_function().unwrap_err().code,
    ];
    assert_eq!(codes, [Code::Unsuited; 7]);
    assert!(run.clone().live().is_ok() && run.simulate().is_ok());
}

#[test]
fn a_roll_is_read_or_refused_with_its_field() {
    let read = |entries: &[(&str, Value)]| {
        let all = entries.iter().map(|(key, value)| ((*key).to_owned(), value.clone()));
        LandingRoll::read(&Value::Record(
            [("model".to_owned(), Value::Text("torsional".into()))].into_iter().chain(all).collect(),
        ))
    };
    let number = Value::Number;
    let roll = read(&[("touchdownVelocity", number(60.0)), ("finalVelocity", number(10.0))])
        .map(|roll| *roll.run().roll().as_ref().expect("a roll"));
    let roll = roll.expect("a roll");
    assert_eq!(
        (roll.touchdown_velocity, roll.deceleration, roll.final_velocity, roll.lift_fraction),
        (60.0, 3.0, 10.0, 0.0)
    );
    assert_eq!(read(&[]).expect("a roll").run().roll().expect("a roll").touchdown_velocity, 80.0);
    let record = |key: &str, value: Value| Value::Record(vec![(key.to_owned(), value)]);
    for (key, value, code, field) in [
        ("touchdownVelocity", number(4.0), Code::OutOfRange, "finalVelocity"),
        ("touchdownVelocity", number(f64::NAN), Code::NotFinite, "touchdownVelocity"),
        ("deceleration", number(0.0), Code::OutOfRange, "deceleration"),
        ("liftFraction", number(1.0), Code::OutOfRange, "liftFraction"),
        ("liftFraction", number(-0.1), Code::OutOfRange, "liftFraction"),
        ("deceleration", Value::Text("3".into()), Code::WrongType, "deceleration"),
        ("linked", record("treadWidthMomentConstant", Value::Bool(true)), Code::Unsuited, "linked"),
        ("disturbance", record("wavelength", number(0.0)), Code::OutOfRange, "disturbance.wavelength"),
        ("disturbance", record("wavelenght", number(1.0)), Code::UnknownKey, "disturbance"),
        ("rows", number(1.0), Code::OutOfRange, "rows"),
        ("tire", Value::Record(Vec::new()), Code::Unsuited, "tire"),
    ] {
        let error = read(&[(key, value)]).err().expect("a refusal");
        assert_eq!((error.code, error.field.as_str()), (code, field), "{error}");
    }
}
