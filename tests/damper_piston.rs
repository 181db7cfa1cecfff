//! A piston led by hand: along a sine it does what `damperResponse` says, which is held against SciPy.
#![cfg(not(target_arch = "wasm32"))]

use serde_json::json;
use shimmy::{
    element::damper::{DamperSpec, Piston, ResponseSpec},
    run::Value,
};

mod common;
use common::reference::value;

fn piston(model: &str, command: f64) -> Piston {
    let damper: Value = value(&json!({"model": model, "command": command}));
    Piston::new(DamperSpec::read(Some(&damper)).unwrap())
}

#[test]
fn led_along_a_sine_it_does_what_the_bench_does() {
    let samples = 4000;
    for (model, command) in [
        ("bouc-wen", 1.5),
        ("modified-bouc-wen", 0.0),
        ("modified-bouc-wen", 1.5),
        ("modified-bouc-wen-cubic", 1.0),
        ("current-dependent-bouc-wen", 1.0),
    ] {
        let spec = json!({"damper": {"model": model, "command": command}, "cycles": 2, "samples": samples});
        let bench = ResponseSpec::read(&value(&spec)).unwrap().response().unwrap();
        let mut led = piston(model, command);
        let interval = bench.time[1];
        let most = bench.force.iter().fold(0.0, |most: f64, force| most.max(force.abs()));
        let mut sum = 0.0;
        for i in 1..samples {
            let grip = led.lead(bench.displacement[i], interval).unwrap();
            // The velocity of a move is that of its middle; a turn falls within a move.
            let velocity_off = 0.5 * (bench.velocity[i] - bench.velocity[i - 1]);
            assert!((grip.velocity - bench.velocity[i] + velocity_off).abs() < 1e-6);
            let off = (grip.force - bench.force[i]) / most;
            assert!(off.abs() < 0.05, "{model} at {command}, sample {i}: {} for {}", grip.force, bench.force[i]);
            sum += off * off;
        }
        let rms = (sum / f64::from(samples as i32)).sqrt();
        assert!(rms < 2e-3, "{model} at {command}: {rms:e}");
    }
}

#[test]
fn held_still_a_dashpot_in_series_lets_go() {
    let mut led = piston("modified-bouc-wen", 1.0);
    let pushed = led.lead(0.005, 0.05).unwrap().force;
    let (mut force, mut before) = (pushed, f64::INFINITY);
    for _ in 0..50 {
        assert!(force <= before);
        before = force;
        force = led.lead(0.005, 0.1).unwrap().force;
    }
    // What is left is the gas spring's: k1 (x - x0), 500 N/m and 0.143 m.
    assert!((force - 500.0 * (0.005 - 0.143)).abs() < 0.01 * pushed.abs(), "{force}");
}

#[test]
fn another_command_stiffens_it_where_it_stands() {
    let mut led = piston("modified-bouc-wen", 0.0);
    let weak = led.lead(0.01, 0.1).unwrap();
    led.set_command(1.5).unwrap();
    let strong = led.lead(0.02, 0.1).unwrap();
    assert!(strong.force > 3.0 * weak.force, "{} and {}", weak.force, strong.force);
    assert!(led.set_command(f64::NAN).is_err());
    assert!(led.set_command(-1.0).is_err());
}

#[test]
fn nothing_wild_gets_in() {
    let mut led = piston("modified-bouc-wen", 1.0);
    for (displacement, interval) in
        [(f64::NAN, 0.1), (0.01, 0.0), (0.01, -1.0), (f64::INFINITY, 0.1), (1e9, 0.1), (0.01, f64::NAN)]
    {
        assert!(led.lead(displacement, interval).is_err(), "{displacement} in {interval}");
    }
    assert!(led.lead(0.01, 0.1).is_ok(), "after an error it still works");
}
