//! What is allocated when: nothing in a step, and no more after an hour than after a minute.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use allocation_counter::measure;
use common::gear::{Gear, SCHEMES};
use shimmy::{
    Run,
    integrate::{Method, Outcome},
    live::Simulator,
};

#[test]
fn steps_allocate_nothing() {
    let gear = Gear::default().with("velocity", 80.0).with("dampingConstant", 20.0);
    let gear = gear.with("freeplayAngle", 1_f64.to_radians());
    for method in SCHEMES.map(Method::Always).into_iter().chain([Method::Auto]) {
        let mut motion = gear.motion(method, 1e-8, 1e-4, [0.1, 0.0, 0.0]);
        let mut switches = 0;
        let info = measure(|| {
            for _ in 0..3_000 {
                if let Ok(Outcome::Switch(_)) = motion.step(f64::INFINITY) {
                    switches += 1;
                }
                motion.interpolate(0.5 * (motion.step_start() + motion.time()));
                motion.turning_point(0);
                motion.rise_through_zero(0);
            }
        });
        assert_eq!(info.count_total, 0, "{method:?}");
        assert!(switches > 50, "{method:?}: {switches} switches");
    }
}

#[test]
fn a_step_that_turns_stiff_allocates_nothing() {
    // At 0.01 m/s the damping κ/v holds explicit steps at the edge of stability.
    let gear = Gear::default().with("velocity", 0.01);
    let mut motion = gear.motion(Method::Auto, 1e-6, 0.0, [0.1, 0.0, 0.0]);
    let info = measure(|| {
        for _ in 0..500 {
            motion.step(f64::INFINITY).expect("a step");
        }
    });
    assert_eq!(info.count_total, 0);
    assert!(motion.stats().stiff && motion.scheme().name() == "rodas");
}

/// A page's use of a live motion for so many seconds of its time: a slider that moves in every frame, a kick now and
/// then, and a look at what there is.
fn play(live: &mut Simulator, seconds: u32) {
    for frame in 0..60 * seconds {
        live.advance(1.0 / 60.0).expect("a frame");
        live.set("velocity", 80.0 + f64::from(frame % 7)).expect("a speed");
        if frame % 100 == 0 {
            live.kick(1.0).expect("a kick");
        }
        live.trace(500.0).expect("a trace");
    }
}

#[test]
fn a_live_motion_keeps_its_size() {
    let run = Run::of("torsional").and_then(|run| run.with("dampingConstant", 20.0)?.starting("torsionAngle", 0.01));
    let mut live = None;
    let whole = measure(|| {
        let mut started = run.and_then(|run| run.live()).expect("a live motion");
        // The past is full after its 60 s; from then on what comes in must go out.
        play(&mut started, 62);
        live = Some(started);
    });
    assert!(whole.bytes_current < 8_000_000, "{} bytes", whole.bytes_current);
    let mut live = live.expect("it has been started");
    for minute in 2..4 {
        let info = measure(|| play(&mut live, 60));
        // A few keyframes more or less.
        assert!(info.bytes_current.abs() < 10_000, "minute {minute}: {} bytes more", info.bytes_current);
    }
}
