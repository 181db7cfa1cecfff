//! Control laws on a gear with a damper: what they command, when, and what becomes of the motion.
#![cfg(not(target_arch = "wasm32"))]

use shimmy::{Code, Run, integrate::Trajectory, outlook::Verdict};

const DAMPER: &str = "modified-bouc-wen";
const COIL: f64 = 190.0;

/// At 80 m/s without damping of its own, from 0.05 rad.
fn bare() -> Run {
    Run::of("torsional")
        .and_then(|run| run.with("velocity", 80.0)?.with("dampingConstant", 0.0)?.starting("torsionAngle", 0.05))
        .expect("a run")
}

fn controlled(law: &str, values: &[(&str, f64)]) -> Run {
    let run = bare().fitted(DAMPER).and_then(|run| run.controlled(law)).expect("a law");
    values.iter().fold(run, |run, (name, value)| run.with(&format!("control.{name}"), *value).expect("a valid value"))
}

fn sampled(run: Run, duration: f64, samples: f64) -> Trajectory {
    run.lasting(duration).and_then(|run| run.sampled(samples)?.simulate()).expect("a trajectory")
}

/// u̇ = (I − u)/τ of the samples' u, solved for I: between two samples u is as an exponential towards I, where I is constant.
fn commands(motion: &Trajectory, rate: f64) -> Vec<f64> {
    let u = motion.states.last().expect("a state");
    let h = motion.time[1] - motion.time[0];
    let kept = (-rate * h).exp();
    u.windows(2).map(|pair| (pair[1] - kept * pair[0]) / (1.0 - kept)).collect()
}

#[test]
fn a_passive_law_is_a_constant_command() {
    let with = sampled(controlled("passive", &[]).with("damper.command", 1.0).expect("a command"), 0.3, 301.0);
    let without = bare().fitted(DAMPER).and_then(|run| run.with("damper.command", 1.0)).expect("a run");
    assert_eq!(with.states, sampled(without, 0.3, 301.0).states);
}

#[test]
fn on_off_commands_one_of_two_by_the_rate() {
    let (low, high, threshold) = (0.2, 1.4, 20.0);
    let run = controlled(
        "on-off",
        &[("parameters.minimumCommand", low), ("parameters.maximumCommand", high), ("parameters.threshold", threshold)],
    );
    let motion = sampled(run, 0.2, 20_001.0);
    let mut seen = [0; 2];
    for (command, rates) in commands(&motion, COIL).iter().zip(motion.states[1].windows(2)) {
        // Between samples on both sides of a switch the command is between the two.
        let (a, b) = (rates[0].abs(), rates[1].abs());
        if a.min(b) > threshold * 1.01 {
            assert!((command - high).abs() < 1e-6, "{command} at {a}");
            seen[1] += 1;
        } else if a.max(b) < 0.89 * threshold {
            assert!((command - low).abs() < 1e-6, "{command} at {a}");
            seen[0] += 1;
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
    // It does not chatter: four switches a cycle.
    let steps = motion.events.kinds.iter().position(|kind| *kind == "control-step").expect("a kind") as u8;
    let count = motion.events.kind.iter().filter(|kind| **kind == steps).count();
    assert!((20..60).contains(&count), "{count}");
}

#[test]
fn proportional_commands_follow_the_rate_up_to_a_bound() {
    let (gain, high) = (0.05, 1.2);
    let run = controlled("proportional", &[("parameters.gain", gain), ("parameters.maximumCommand", high)]);
    let motion = sampled(run, 0.1, 20_001.0);
    for (command, rates) in commands(&motion, COIL).iter().zip(motion.states[1].windows(2)) {
        let wanted = |rate: f64| (gain * rate.abs()).min(high);
        let (a, b) = (wanted(rates[0]), wanted(rates[1]));
        // Between two samples it may have been zero.
        let least = if rates[0] * rates[1] > 0.0 { a.min(b) } else { 0.0 };
        assert!(*command > least - 1e-4 && *command < a.max(b) + 1e-4, "{command}: {a} … {b}");
    }
    let u = motion.states.last().expect("a state");
    assert!(u.iter().all(|u| (0.0..=high).contains(u)) && u.iter().any(|u| *u > 0.5));
}

#[test]
fn clipped_commands_all_while_the_damper_does_less_than_wanted() {
    let (damping, high) = (40.0, 1.5);
    let run = controlled("clipped", &[("parameters.damping", damping), ("parameters.maximumCommand", high)]);
    let moments = run.clone();
    let motion = sampled(run, 0.2, 20_001.0);
    let torque = moments.forces_along(&motion.states).expect("forces").damper_torque;
    let mut seen = [0; 2];
    for (i, command) in commands(&motion, COIL).iter().enumerate() {
        let at = |i: usize| {
            let (moment, wanted) = (-torque[i], damping * motion.states[1][i]);
            (moment * wanted > 0.0, moment.abs() / wanted.abs())
        };
        let (before, after) = (at(i), at(i + 1));
        if before.0 && after.0 && before.1.max(after.1) < 0.89 {
            assert!((command - high).abs() < 1e-6, "{command} at {before:?}");
            seen[1] += 1;
        } else if !(before.0 || after.0) || before.1.min(after.1) > 1.01 {
            assert!(command.abs() < 1e-6, "{command} at {before:?}");
            seen[0] += 1;
        }
    }
    assert!(seen[0] > 1000 && seen[1] > 1000, "{seen:?}");
    // A damping that the damper has by itself already is never asked of it.
    let idle = sampled(controlled("clipped", &[("parameters.damping", 1.0)]), 0.2, 201.0);
    assert!(idle.states.last().expect("a state").iter().all(|u| u.abs() < 0.05));
}

/// An actuator of c_s ψ̇ without lag is a damping constant of that size: the shorter the lag, the nearer.
#[test]
fn an_active_law_is_the_damping_that_it_commands() {
    let damped = sampled(bare().with("dampingConstant", 60.0).expect("a value"), 0.2, 201.0);
    let active = |lag: f64| {
        let run = bare().controlled("active").and_then(|run| {
            run.with("control.parameters.damping", 60.0)?
                .with("control.parameters.maximumMoment", 1e6)?
                .with("control.lag", lag)
        });
        let motion = sampled(run.expect("a run"), 0.2, 201.0);
        motion.states[0].iter().zip(&damped.states[0]).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    };
    let (long, short) = (active(1e-4), active(1e-5));
    assert!(short < 5e-4 && (short / long - 0.1).abs() < 0.02, "{short} {long}");
    let bounded = bare().controlled("active").and_then(|run| run.with("control.parameters.maximumMoment", 50.0));
    let motion = sampled(bounded.expect("a run"), 0.5, 5001.0);
    assert!(motion.states[3].iter().all(|moment| moment.abs() <= 50.0 + 1e-9));
}

#[test]
fn a_coil_that_fails_empties_and_the_gear_shakes() {
    let run = controlled("passive", &[("failureTime", 1.0)]).with("damper.command", 1.5).expect("a command");
    let run = run.starting("torsionAngle", 0.01).expect("a start");
    let motion = sampled(run.clone(), 4.0, 4001.0);
    let u = motion.states.last().expect("a state");
    for (time, u) in motion.time.iter().zip(u) {
        let expected = if *time <= 1.0 { 1.5 } else { 1.5 * (-COIL * (time - 1.0)).exp() };
        assert!((u - expected).abs() < 1e-7, "{time}: {u} {expected}");
    }
    let most =
        |from: usize, to: usize| motion.states[0][from..to].iter().fold(0.0_f64, |most, psi| most.max(psi.abs()));
    assert!(most(800, 1000) < 1e-3, "calm before");
    // A push after the failure is not calmed any more.
    let mut live = run.live().expect("a motion");
    live.advance(2.0).expect("some time");
    live.kick(20.0).expect("a kick");
    live.advance(4.0).expect("some time");
    let envelope = live.envelope(5.5, 6.0, 1.0).expect("the past");
    assert!(envelope.high[0] > 0.2, "{envelope:?}");
}

/// Semi-active laws calm what they were made to calm; the damper still never gives energy but what a rising current frees.
#[test]
fn semi_active_laws_calm_the_gear() {
    for (law, values) in [
        ("on-off", &[("parameters.maximumCommand", 1.5)][..]),
        ("proportional", &[("parameters.gain", 1.0), ("parameters.maximumCommand", 1.5)]),
    ] {
        let run = controlled(law, values).starting("torsionAngle", 0.005).expect("a start");
        let passive = bare().fitted(DAMPER).and_then(|run| run.starting("torsionAngle", 0.005)).expect("a run");
        assert_eq!(passive.outlook().expect("an outlook").verdict, Verdict::Shimmies, "at 0 A");
        let look = run.outlook().expect("an outlook");
        // It may end in a small swing below the threshold, but not in shimmy.
        assert!(look.amplitude[0] < 0.02, "{law}: {look:?}");
    }
}

#[test]
fn a_law_is_taken_with_what_it_can_command_or_refused() {
    let refused = |run: shimmy::Result<Run>| run.and_then(|run| run.simulate()).unwrap_err();
    let cases = [
        (bare().controlled("on-off"), Code::Unsuited, "control.law"),
        (bare().fitted(DAMPER).and_then(|run| run.controlled("active")), Code::Unsuited, "control.law"),
        (bare().fitted("bouc-wen").and_then(|run| run.controlled("proportional")), Code::Unsuited, "control.law"),
        (
            bare().fitted("modified-bouc-wen-cubic").and_then(|run| run.controlled("clipped")),
            Code::OutOfRange,
            "control.law",
        ),
        (bare().fitted(DAMPER).and_then(|run| run.controlled("onoff")), Code::UnknownName, "control.law"),
        (controlled("on-off", &[]).with("control.lag", 0.0), Code::OutOfRange, "control.lag"),
        (controlled("on-off", &[]).with("control.parameters.gain", 1.0), Code::UnknownKey, "parameters"),
    ];
    for (run, code, field) in cases {
        let error = refused(run);
        assert_eq!((error.code, error.field.as_str()), (code, field), "{error}");
    }
}

#[test]
fn a_controlled_gear_is_live_and_lands() {
    let run = controlled("on-off", &[]);
    let mut live = run.clone().live().expect("a motion");
    live.advance(0.5).expect("some time");
    let snapshot = live.snapshot();
    live.set("control.parameters.maximumCommand", 0.5).expect("a value");
    live.advance(0.5).expect("some time");
    let there = live.state();
    live.seek(0.7).expect("the past");
    live.seek(1.0).expect("the present");
    assert_eq!(live.state(), there);
    assert!(controlled("passive", &[]).live().expect("a motion").restore(&snapshot).is_err());
    let landing =
        run.rolling().and_then(shimmy::scenario::LandingRoll::of).and_then(|roll| roll.made()).expect("a landing");
    assert!(landing.velocity.last() == Some(&5.0) && landing.trajectory.states.iter().flatten().all(|x| x.is_finite()));
    assert_eq!(run_of_lag(), 4);
}

/// A damper without a lag of its own gets the coil's.
fn run_of_lag() -> usize {
    let run =
        bare().fitted("current-dependent-bouc-wen").and_then(|run| run.controlled("proportional")).expect("a run");
    let names: Vec<_> = run.description().state.iter().map(|state| state.name).collect();
    names.iter().position(|name| *name == "effectiveCommand").expect("a state")
}
