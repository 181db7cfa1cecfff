//! Dry friction: it slips, it sticks, it lets go, and everything that knows of elements knows of it.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::{PI, TAU};

use common::{gear::ADAPTIVE, linear::gear, random::Random, reference};
use nalgebra::{Complex, DMatrix};
use serde_json::Value as Json;
use shimmy::{Code, Run, integrate::Trajectory, outlook::Verdict, run::Value, stability::eigenvalues};

const FRICTION: &str = "friction.moment";
const STOP: &str = "friction-stop";
const RELEASE: &str = "friction-release";

/// Times of the events of a kind.
fn times(motion: &Trajectory, kind: &str) -> Vec<f64> {
    let events = motion.events.time.iter().zip(&motion.events.kind);
    events.filter(|(_, which)| motion.events.kinds[**which as usize] == kind).map(|(time, _)| *time).collect()
}

/// A wheel on a spring alone: I ψ̈ = −kψ − M_f sign ψ̇.
fn swinging(friction: f64) -> Run {
    let parameters = [
        ("verticalForce", 0.0),
        ("treadWidthMomentConstant", 0.0),
        ("dampingConstant", 0.0),
        ("momentOfInertia", 2.0),
        ("torsionalStiffness", 5e4),
        (FRICTION, friction),
    ];
    gear(&parameters)
}

/// Half a swing is half a cosine about ± M_f/k, so that every turn is 2M_f/k nearer than the one before; within M_f/k it
/// sticks. (For instance J. P. Den Hartog, *Mechanical Vibrations*, 1956, section 8.5.)
#[test]
fn a_swing_falls_by_four_friction_angles_a_cycle_and_sticks() {
    let (friction, start) = (90.0, 0.0301);
    let (least, half) = (friction / 5e4, PI * (2.0 / 5e4_f64).sqrt());
    // From 0.0301 by 0.0036 each: the eighth turn, at 0.0013, is within 0.0018.
    let turns: Vec<f64> =
        (0..=8).map(|n| (start - 2.0 * least * f64::from(n)) * if n % 2 == 0 { 1.0 } else { -1.0 }).collect();
    assert!(turns[8].abs() < least && turns[7].abs() > least);
    for method in ADAPTIVE.into_iter().chain(["rk4"]) {
        let run = swinging(friction).starting("torsionAngle", start).unwrap().by(method).unwrap();
        // The fixed step cuts a half swing into some 200: (ωh)⁴/120 each.
        let accuracy = if method == "rk4" { 1e-7 } else { 3e-8 };
        let motion = run.lasting(0.4).unwrap().simulate().unwrap();
        let stops = times(&motion, STOP);
        assert_eq!(stops.len(), 8, "{method}");
        assert_eq!(motion.stats.events, 8, "{method}: nothing but stops");
        for (n, stop) in stops.iter().enumerate() {
            let expected = half * (n + 1) as f64;
            assert!((stop / expected - 1.0).abs() < accuracy, "{method}, stop {n}: {stop} {expected}");
            let row = motion.time.iter().position(|time| time == stop).unwrap();
            assert!((motion.states[0][row] - turns[n + 1]).abs() < accuracy * start, "{method}, turn {n}");
            assert_eq!(motion.states[1][row], 0.0);
        }
        let (last, rates) = (motion.states[0].last().unwrap(), motion.states[1].iter().rev());
        assert!((last - turns[8]).abs() < accuracy * start);
        assert!(rates.zip(motion.time.iter().rev()).all(|(rate, time)| *rate == 0.0 || time < &stops[7]), "{method}");
        let rest = motion.states[0].iter().zip(&motion.time).filter(|(_, time)| **time >= stops[7]);
        assert!(
            rest.clone().count() > 1 && rest.into_iter().all(|(psi, _)| psi == last),
            "{method}: held to the last bit"
        );
    }
}

/// A wheel held aside while the tire deforms: y = σψ(1 − e^(−vt/σ)), and the moments grow to k ψ + (c_Mα + e c_Fα) F_z y/σ.
#[test]
fn a_wheel_that_is_held_is_let_go_when_the_tire_pulls_enough() {
    let (k, pull, angle, friction, v) = (1e5, 36_000.0, 9e-4, 100.0, 2.0);
    let release = -0.3 / v * (1.0_f64 - (friction - k * angle) / (pull * angle)).ln();
    for method in ADAPTIVE.into_iter().chain(["rk4"]) {
        let run = Run::of("torsional-linear").unwrap().with("velocity", v).unwrap().with(FRICTION, friction).unwrap();
        let run = run.starting("torsionAngle", angle).unwrap().by(method).unwrap().lasting(1.5 * release).unwrap();
        let motion = run.simulate().unwrap();
        let releases = times(&motion, RELEASE);
        assert_eq!(motion.events.kind.len(), 1, "{method}");
        assert!((releases[0] / release - 1.0).abs() < 1e-7, "{method}: {} {release}", releases[0]);
        let before = motion.time.iter().filter(|time| **time <= releases[0]).count();
        assert!(motion.states[0][..before].iter().all(|psi| *psi == angle), "{method}");
        assert!(motion.states[0][before..].iter().all(|psi| *psi < angle), "{method}");
        // A little less, and it is held for ever.
        let held = run.with(FRICTION, 1.0001 * (k + pull) * angle).unwrap().lasting(2.0).unwrap().simulate().unwrap();
        assert_eq!(held.stats.events, 0, "{method}");
        assert!((held.states[2].last().unwrap() / (0.3 * angle) - 1.0).abs() < 2e-6, "{method}: the tire comes to σψ");
    }
}

/// The trajectories of the file with what SciPy says of stops and releases.
fn references() -> Vec<(reference::Case, [usize; 2])> {
    let file: Json = serde_json::from_str(include_str!("friction-reference.json")).expect("a JSON file");
    let counts = |case: &Json| ["stops", "releases"].map(|key| case[key].as_u64().expect("a count") as usize);
    let counts: Vec<_> = file["trajectories"].as_array().expect("a list").iter().map(counts).collect();
    reference::trajectories(&file).into_iter().zip(counts).collect()
}

#[test]
fn trajectories_made_with_scipy_are_met() {
    assert_eq!(references().len(), 7);
    for (case, counts) in references() {
        for method in ADAPTIVE {
            let got = case.run.clone().within(1e-10).and_then(|run| run.by(method)?.simulate()).expect("a trajectory");
            let error = case.error(&got);
            println!("{}, {method}: {error:.1e}", case.id);
            assert!(error < 1e-6, "{}, {method}: {error:e}", case.id);
            assert_eq!([STOP, RELEASE].map(|kind| times(&got, kind).len()), counts, "{}, {method}", case.id);
        }
    }
}

/// Stops and releases cost no order: the error of the fixed step falls with its fourth power, ± 0.2 on average over two
/// halvings, as events fall here and there within steps.
#[test]
fn the_fixed_step_keeps_its_order() {
    for (case, _) in references() {
        let error = |step: f64| {
            let run = case.run.clone().by("rk4").and_then(|run| run.stepping(step)).unwrap();
            case.error(&run.simulate().unwrap())
        };
        let [coarse, fine] = [error(1e-4), error(2.5e-5)];
        let order = (coarse / fine).log2() / 2.0;
        println!("{}: {coarse:.1e} {fine:.1e}, order {order:.2}", case.id);
        assert!(fine < 1e-9 || (3.6..6.0).contains(&order), "{}: {coarse:e} {fine:e} {order}", case.id);
    }
}

#[test]
fn mirrored_starts_give_mirrored_motions_to_the_last_bit() {
    for (case, _) in references() {
        let start = case.run.initial().to_vec();
        let names: Vec<_> = case.run.description().state.iter().map(|state| state.name).collect();
        let mirrored =
            names.iter().zip(&start).fold(case.run.clone(), |run, (name, x)| run.starting(name, -x).unwrap());
        let (one, other) = (case.run.simulate().unwrap(), mirrored.simulate().unwrap());
        assert_eq!(one.events, other.events, "{}", case.id);
        for (a, b) in one.states.iter().zip(&other.states) {
            assert!(a.iter().zip(b).all(|(a, b)| *a == -b), "{}", case.id);
        }
    }
}

#[test]
fn small_motions_scale_with_the_friction() {
    // As long as the tire is straight the equations are homogeneous: twice the start and the friction, twice the motion. A
    // power of two, so that it is so to the last bit, with tolerances that go along.
    let motion = |factor: f64| {
        let run =
            Run::of("torsional-linear").unwrap().with("velocity", 30.0).unwrap().with(FRICTION, 20.0 * factor).unwrap();
        let run =
            run.starting("torsionAngle", 0.02 * factor).unwrap().starting("lateralDeformation", 1e-3 * factor).unwrap();
        run.within_absolute(1e-10 * factor).unwrap().lasting(0.3).unwrap().simulate().unwrap()
    };
    let (one, four) = (motion(1.0), motion(4.0));
    assert!(times(&one, STOP).len() > 10);
    assert_eq!(one.events, four.events);
    for (a, b) in one.states.iter().zip(&four.states) {
        assert!(a.iter().zip(b).all(|(a, b)| 4.0 * a == *b));
    }
}

/// Whatever the gear and the method: where the wheel rests it is exactly at rest, the moments on it are within M_f, every
/// release has a stop (or a start at rest) before it, and nothing chatters.
#[test]
fn random_runs_stick_where_they_must() {
    let mut random = Random::seeded(11);
    let (mut stuck, mut released, mut refused, mut at_once) = (0, 0, 0, 0);
    for n in 0..600 {
        let table = Run::of("torsional").unwrap().description().parameters;
        let mut run = table.iter().fold(Run::of("torsional").unwrap(), |run, parameter| {
            let weak = parameter.name == "torsionalStiffness" && n % 2 == 0;
            let most = if weak { 3_000.0 } else { parameter.max };
            run.with(parameter.name, random.between(parameter.min, most)).unwrap()
        });
        if n % 3 > 0 {
            run = run.with("freeplayAngle", 0.0).unwrap();
        }
        let run = run.with(FRICTION, random.between(1.0, 1_500.0)).unwrap();
        let run = run.with("velocity", random.between(0.5, 60.0)).unwrap();
        let run = run.starting("torsionAngle", random.between(-0.2, 0.2)).unwrap();
        let run = run.starting("torsionRate", [0.0, random.between(-20.0, 20.0)][n % 2]).unwrap();
        let run = run.by(ADAPTIVE[n % 4]).unwrap().lasting(0.5).unwrap().at_most(1e5).unwrap();
        let motion = match run.simulate() {
            Ok(motion) => motion,
            Err(error) => {
                assert_eq!(error.code, Code::Diverged, "run {n}: {error} {run:?}");
                refused += 1;
                continue;
            }
        };
        let forces = run.forces_along(&motion.states).unwrap();
        let friction = run.parameters()[14];
        let stops = times(&motion, STOP);
        for row in 1..motion.time.len() {
            // From a release to the next stop may be a single step.
            let stopped = stops.contains(&motion.time[row]);
            let held = motion.states[1][row] == 0.0 && motion.states[1][row - 1] == 0.0 && !stopped;
            if held && motion.time[row] > motion.time[row - 1] {
                stuck += 1;
                assert_eq!(motion.states[0][row], motion.states[0][row - 1], "run {n}: held to the last bit");
                assert!(forces.friction_torque[row].abs() <= friction * (1.0 + 1e-9), "run {n}");
            }
        }
        let friction_events: Vec<bool> =
            motion.events.kind.iter().filter(|kind| **kind > 2).map(|kind| *kind == 4).collect();
        released += friction_events.iter().filter(|release| **release).count();
        assert!(!friction_events.windows(2).any(|pair| pair == [true, true]), "run {n}: let go twice without a stop");
        let apart = motion.events.time.windows(2).zip(motion.events.kind.windows(2));
        let again = apart.filter(|(time, kind)| time[0] == time[1] && kind.iter().all(|kind| *kind > 2)).count();
        assert!(again <= 16, "run {n} chatters: {:?}", motion.events);
        at_once += again;
    }
    println!("{stuck} steps held, {released} releases ({at_once} at once), {refused} refused");
    assert!(stuck > 1_000 && released > 300 && refused < 60, "{stuck} {released} {refused}");
    // Only a load that creeps up to what friction can hold, and stays there to within the tolerance, is let go in place.
    assert!(40 * at_once < released, "{at_once} of {released}");
}

#[test]
fn what_comes_in_goes_out() {
    for (case, _) in references() {
        let energy = case.run.energy().unwrap().expect("a duration is given");
        let out = energy.damper + energy.tread_width + energy.friction + energy.stored;
        let size = energy.friction + energy.damper + energy.tread_width + energy.stored.abs();
        println!("{}: {energy:?}", case.id);
        assert!((energy.tire - out).abs() < 1e-6 * size, "{}: {energy:?}", case.id);
        assert!(energy.friction > 0.0);
    }
    // Friction takes M_f for every radian on the way: 8 half swings of 2·(A_n − M_f/k).
    let way: f64 = (0..8).map(|n| 2.0 * (0.0301 - 0.0018 * f64::from(2 * n + 1))).sum();
    let energy =
        swinging(90.0).starting("torsionAngle", 0.0301).unwrap().lasting(0.4).unwrap().energy().unwrap().unwrap();
    assert!((energy.friction / (90.0 * way) - 1.0).abs() < 1e-7, "{energy:?} {way}");
    assert!((energy.stored + energy.friction).abs() < 1e-7 * energy.friction);
}

#[test]
fn friction_is_among_the_forces() {
    let run = gear(&[(FRICTION, 70.0)]);
    assert_eq!(run.forces(&[0.01, 2.0, 0.0]).unwrap().friction_torque, -70.0);
    assert_eq!(run.forces(&[0.01, -2.0, 0.0]).unwrap().friction_torque, 70.0);
    assert_eq!(run.forces(&[5e-4, 0.0, 0.0]).unwrap().friction_torque, 50.0, "it holds the spring");
    assert_eq!(run.forces(&[-0.01, 0.0, 0.0]).unwrap().friction_torque, -70.0, "it cannot hold the spring");
    assert_eq!(gear(&[]).forces(&[0.01, 2.0, 0.0]).unwrap().friction_torque, 0.0);
}

#[test]
fn a_motion_that_friction_holds_rests() {
    let at = |angle: f64, parameters: &[(&str, f64)]| {
        gear(parameters).starting("torsionAngle", angle).unwrap().outlook().unwrap()
    };
    let stable = [("velocity", 30.0), ("dampingConstant", 60.0), (FRICTION, 80.0)];
    for start in [0.5, 0.05, 5e-3, 8e-4] {
        let outlook = at(start, &stable);
        assert_eq!(outlook.verdict, Verdict::Rests, "{start}: {outlook:?}");
        assert!(outlook.held, "{start}");
        // Where the tire has come to σψ, it pulls with 36 000 N m/rad beside the spring.
        assert!(outlook.amplitude[0] > 0.0 && outlook.amplitude[0] <= 80.0 / 1e5 && outlook.frequency.is_none());
        assert!((outlook.amplitude[2] / (0.3 * outlook.amplitude[0]) - 1.0).abs() < 1e-2, "{outlook:?}");
    }
    // Linear theory calls this gear unstable; with friction a small push is held, and a larger one shakes it.
    let unstable = [("velocity", 80.0), ("dampingConstant", 20.0), (FRICTION, 80.0)];
    assert!(!gear(&unstable).routh_hurwitz().unwrap().stable);
    assert_eq!(at(2e-3, &unstable).verdict, Verdict::Rests);
    let shakes = at(0.05, &unstable);
    assert_eq!(shakes.verdict, Verdict::Shimmies);
    let without = at(0.05, &unstable[..2]);
    assert!(shakes.amplitude[0] < without.amplitude[0] && shakes.amplitude[0] > 0.9 * without.amplitude[0]);
    // Near the boundary between the two it takes its time, and is held all the same.
    let slow = |angle| at(angle, &unstable).verdict;
    let (mut low, mut high) = (2e-3, 0.05);
    for _ in 0..30 {
        let middle = 0.5 * (low + high);
        match slow(middle) {
            Verdict::Rests => low = middle,
            Verdict::Shimmies => high = middle,
            other => panic!("{other:?} from {middle}"),
        }
    }
    println!("the boundary is at {low}");
    // A gap that linear theory calls unstable rattles, and friction holds a small rattle.
    let gap = [("velocity", 50.0), ("dampingConstant", 100.0), ("freeplayAngle", 1_f64.to_radians())];
    assert_eq!(at(0.03, &[&gap[..], &[(FRICTION, 5.0)]].concat()).verdict, Verdict::Rattles);
    assert_eq!(at(0.03, &[&gap[..], &[(FRICTION, 100.0)]].concat()).verdict, Verdict::Rests);
}

#[test]
fn the_live_motion_sticks_and_is_found_again_bit_by_bit() {
    let run = gear(&[("velocity", 30.0), ("dampingConstant", 60.0), (FRICTION, 80.0)]);
    for method in ADAPTIVE {
        let mut live = run.clone().starting("torsionAngle", 0.05).unwrap().by(method).unwrap().live().unwrap();
        let mut seen = Vec::new();
        for frame in 0..120 {
            match frame {
                40 => live.kick(3.0).unwrap(),
                60 => live.set(FRICTION, 0.0).unwrap(),
                70 => live.set(FRICTION, 200.0).unwrap(),
                90 => live.set_state("torsionAngle", 0.01).unwrap(),
                _ => {}
            }
            live.advance(1.0 / 60.0).unwrap();
            seen.push((live.time(), live.state(), live.parameters()));
        }
        assert!(seen[38].1[1] == 0.0 && seen[38].1[0] != 0.0, "{method}: it sticks before the kick");
        assert!(seen[119].1[1] == 0.0 && seen[119].1[0] != 0.0, "{method}: and at the end");
        assert_eq!(seen[100].2[14], 200.0);
        let snapshot = live.snapshot();
        // At the moment of a change the motion shown is that after it.
        for frame in (0..120).rev().filter(|frame| ![39, 59, 69, 89].contains(frame)) {
            live.seek(seen[frame].0).unwrap();
            assert_eq!((live.time(), live.state(), live.parameters()), seen[frame], "{method}, frame {frame}");
        }
        let mut other = run.clone().by(method).unwrap().live().unwrap();
        other.restore(&snapshot).unwrap();
        live.seek(seen[119].0).unwrap();
        for motion in [&mut live, &mut other] {
            motion.kick(-4.0).unwrap();
            motion.advance(0.07).unwrap();
        }
        assert_eq!(live.state(), other.state(), "{method}");
    }
}

#[test]
fn a_run_names_its_friction() {
    let record = |entries: &[(&str, Value)]| {
        Value::Record(entries.iter().map(|(key, value)| ((*key).into(), value.clone())).collect())
    };
    let read =
        |friction: Value| Run::read(&record(&[("model", Value::Text("torsional".into())), ("friction", friction)]));
    let moment = |value: f64| read(record(&[("moment", Value::Number(value))]));
    assert_eq!(moment(25.0).unwrap(), gear(&[(FRICTION, 25.0)]));
    for none in
        [Value::Absent, record(&[]), record(&[("moment", Value::Absent)]), record(&[("moment", Value::Number(0.0))])]
    {
        assert_eq!(read(none).unwrap(), Run::of("torsional").unwrap());
    }
    let message = |result: shimmy::Result<Run>| result.unwrap_err().to_string();
    assert_eq!(message(moment(-1.0)), "friction.moment must be ≥ 0 N m, got -1");
    assert_eq!(moment(f64::NAN).unwrap_err().code, Code::NotFinite);
    assert_eq!(read(Value::Number(3.0)).unwrap_err().code, Code::WrongType);
    assert_eq!(read(record(&[("moment", Value::Text("3".into()))])).unwrap_err().code, Code::WrongType);
    let unknown = read(record(&[("momemt", Value::Number(3.0))])).unwrap_err();
    assert_eq!((unknown.code, unknown.suggestion), (Code::UnknownKey, Some("moment")));
    // Its dotted name reaches it among the parameters, too, which is where a live motion tells it.
    let parameters = record(&[("friction.moment", Value::Number(25.0))]);
    let run = record(&[("model", Value::Text("torsional".into())), ("parameters", parameters)]);
    assert_eq!(Run::read(&run).unwrap(), gear(&[(FRICTION, 25.0)]));
    let mut live = gear(&[]).live().unwrap();
    assert!(live.set("friction.momemt", 1.0).unwrap_err().to_string().contains("friction.moment"));
}

/// Linear theory is that of the gear without friction, which would hold every small motion.
#[test]
fn linear_theory_leaves_friction_out() {
    for model in ["torsional", "torsional-linear"] {
        let without = Run::of(model).unwrap();
        let with = without.clone().with(FRICTION, 100.0).unwrap();
        assert_eq!(with.eigenvalues().unwrap(), without.eigenvalues().unwrap());
        assert_eq!(with.linearised().unwrap(), without.linearised().unwrap());
        assert_eq!(with.routh_hurwitz().unwrap(), without.routh_hurwitz().unwrap());
    }
}

/// Where a period ends, from ± small pushes at the start: what shooting knows from variational equations and jumps.
fn by_differences(run: &Run, start: &[f64], period: f64) -> Vec<Complex<f64>> {
    let names: Vec<_> = run.description().state.iter().map(|state| state.name).collect();
    let scales: Vec<_> = run.description().state.iter().map(|state| state.scale).collect();
    let end = |start: &[f64]| -> Vec<f64> {
        let run = names.iter().zip(start).fold(run.clone(), |run, (name, x)| run.starting(name, *x).unwrap());
        let motion = run.within(1e-12).unwrap().at(vec![period]).unwrap().simulate().unwrap();
        motion.states.iter().map(|column| column[0]).collect()
    };
    let column = |j: usize| {
        let moved = |by: f64| {
            end(&start
                .iter()
                .enumerate()
                .map(|(i, x)| if i == j { x + by * scales[j] } else { *x })
                .collect::<Vec<_>>())
        };
        let (ahead, behind) = (moved(1e-5), moved(-1e-5));
        (0..3).map(|i| (ahead[i] - behind[i]) / (2e-5 * scales[i])).collect::<Vec<_>>()
    };
    let columns: Vec<_> = (0..3).map(column).collect();
    let mut values = eigenvalues(&DMatrix::from_fn(3, 3, |i, j| columns[j][i])).unwrap();
    values.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    values
}

#[test]
fn cycles_know_of_the_jump_where_friction_turns() {
    for (name, parameters) in [
        (
            "slips",
            [
                ("velocity", 80.0),
                ("dampingConstant", 20.0),
                ("torsionalStiffness", 1e5),
                ("casterLength", 0.1),
                (FRICTION, 150.0),
            ],
        ),
        (
            "slips more",
            [
                ("velocity", 80.0),
                ("dampingConstant", 20.0),
                ("torsionalStiffness", 1e5),
                ("casterLength", 0.1),
                (FRICTION, 400.0),
            ],
        ),
        (
            "sticks",
            [
                ("velocity", 5.0),
                ("dampingConstant", 0.0),
                ("torsionalStiffness", 2e3),
                ("casterLength", 0.05),
                (FRICTION, 1_000.0),
            ],
        ),
        (
            "sticks softly",
            [
                ("velocity", 2.0),
                ("dampingConstant", 0.0),
                ("torsionalStiffness", 2e3),
                ("casterLength", 0.05),
                (FRICTION, 300.0),
            ],
        ),
    ] {
        let run = gear(&parameters);
        let cycle = run.limit_cycle(None).unwrap().unwrap_or_else(|| panic!("{name}: no cycle"));
        println!("{name}: {} Hz, {:?}, multipliers {:?}", cycle.frequency, cycle.amplitude, cycle.multipliers);
        assert!(cycle.stable && cycle.symmetric, "{name}");
        let trivial = cycle.multipliers.iter().map(|value| (value - 1.0).norm()).fold(f64::INFINITY, f64::min);
        assert!(trivial < 1e-6, "{name}: {trivial:e}");
        if name.starts_with("sticks") {
            assert!(cycle.multipliers[2].norm() < 1e-12, "{name}: what the stop takes away");
        }
        let start: Vec<f64> = cycle.orbit.states.iter().map(|column| column[0]).collect();
        for (got, expected) in cycle.multipliers.iter().zip(by_differences(&run, &start, cycle.period)) {
            assert!((got - expected).norm() < 2e-6, "{name}: {got} {expected}");
        }
        // A long motion comes to it.
        let outlook = run.starting("torsionAngle", 0.9 * cycle.amplitude[0]).unwrap().outlook().unwrap();
        assert_eq!(outlook.verdict, Verdict::Shimmies);
        assert!((outlook.amplitude[0] / cycle.amplitude[0] - 1.0).abs() < 1e-6, "{name}: {}", outlook.amplitude[0]);
    }
}

/// The first harmonic of friction's square wave is 4M_f/π: a swing lasts where it takes as much as the gear has too little
/// damping for. In the tire's straight range that is known: at c_critical (theory.md, section 2) the gear without friction
/// holds any swing.
#[test]
fn the_smallest_cycle_is_where_friction_makes_up_for_the_damping_that_lacks() {
    let critical = 48.530;
    for (c, friction) in [(20.0, 1.0), (20.0, 5.0), (40.0, 2.0), (10.0, 10.0)] {
        let run = gear(&[("velocity", 80.0), ("dampingConstant", c), (FRICTION, friction)]);
        let cycles = run.describing_function().unwrap();
        let [small, large] = cycles[..] else { panic!("{cycles:?}") };
        assert!(!small.stable && large.stable && small.amplitude.torsion_angle < large.amplitude.torsion_angle);
        let turning = TAU * small.frequency;
        let expected = 4.0 * friction / (PI * turning * (critical - c));
        // c_critical is printed to five digits; the aligning moment bends by (πα/α_g)²/8.
        let bend = (PI * small.amplitude.slip_angle / 10_f64.to_radians()).powi(2) / 8.0;
        let off = small.amplitude.torsion_angle / expected - 1.0;
        assert!(off.abs() < 1e-4 + 3.0 * bend, "c {c} M_f {friction}: {off:e}, bend {bend:e}");
    }
    // Without friction there is no such cycle, and none where friction takes more than there is.
    assert_eq!(gear(&[("velocity", 80.0), ("dampingConstant", 20.0)]).describing_function().unwrap().len(), 1);
    assert_eq!(
        gear(&[("velocity", 80.0), ("dampingConstant", 20.0), (FRICTION, 1_500.0)]).describing_function().unwrap(),
        []
    );
}

#[test]
fn predictions_are_near_the_true_cycles() {
    for v in [40.0, 60.0, 80.0, 100.0] {
        for (c, friction, degrees) in
            [(20.0, 20.0, 0.0), (20.0, 80.0, 0.0), (30.0, 40.0, 0.0), (30.0, 40.0, 1.0), (100.0, 3.0, 0.5)]
        {
            let parameters = [
                ("velocity", v),
                ("dampingConstant", c),
                (FRICTION, friction),
                ("freeplayAngle", f64::to_radians(degrees)),
            ];
            let run = gear(&parameters);
            let cycles = run.describing_function().unwrap();
            let found = run.limit_cycle(None).unwrap();
            let stable = cycles.iter().find(|cycle| cycle.stable);
            assert_eq!(stable.is_some(), found.is_some(), "v {v} c {c} M_f {friction} gap {degrees}: {cycles:?}");
            let (Some(predicted), Some(found)) = (stable, found) else {
                println!("v {v} c {c} M_f {friction} gap {degrees}°: none by either");
                continue;
            };
            let aside = predicted.amplitude.torsion_angle / found.amplitude[0] - 1.0;
            let faster = predicted.frequency / found.frequency - 1.0;
            println!(
                "v {v} c {c} M_f {friction} gap {degrees}°: amplitude {:+.3} %, frequency {:+.3} %",
                100.0 * aside,
                100.0 * faster
            );
            assert!(
                aside.abs() < 0.02 && faster.abs() < 0.02,
                "v {v} c {c} M_f {friction} gap {degrees}: {aside} {faster}"
            );
            // On either side of the unstable one below it, a motion is held, or comes to the stable one.
            let Some(below) = cycles.iter().find(|cycle| !cycle.stable) else { panic!("{cycles:?}") };
            let start = |factor: f64| {
                // Where a sinusoid passes its turning point: ψ = A, ψ̇ = 0, and y in its phase.
                let turning = TAU * below.frequency;
                let lag = Complex::new(v, 0.0) / Complex::new(v / 0.3, turning);
                let psi = factor * below.amplitude.torsion_angle;
                let run = run.clone().starting("torsionAngle", psi).unwrap();
                run.starting("lateralDeformation", psi * lag.re).unwrap().outlook().unwrap().verdict
            };
            assert_eq!(start(0.85), Verdict::Rests, "v {v} c {c} M_f {friction} gap {degrees}: {cycles:?}");
            assert_ne!(start(1.15), Verdict::Rests, "v {v} c {c} M_f {friction} gap {degrees}: {cycles:?}");
        }
    }
}
