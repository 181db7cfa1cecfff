//! The live motion: any cut of time, any way back, and the same bits.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::random::Random;
use shimmy::{
    Run,
    error::Code,
    integrate::Stats,
    live::{REACH, Simulator},
};

/// A gear that shimmies, with a gap: its laws change some ten times a cycle.
fn run() -> Run {
    Run::of("torsional")
        .and_then(|run| run.with("velocity", 80.0)?.with("dampingConstant", 20.0)?.starting("torsionAngle", 0.05))
        .and_then(|run| run.with("freeplayAngle", 0.5_f64.to_radians()))
        .expect("a run")
}

fn live() -> Simulator {
    run().live().expect("a live motion")
}

/// What a motion shows now.
fn shown(live: &mut Simulator) -> (f64, Vec<f64>, Vec<f64>) {
    (live.time(), live.state(), live.parameters())
}

/// What a path has cost; looking at it costs evaluations, too, and is no part of it.
fn path(stats: Stats) -> Stats {
    Stats { evaluations: 0, ..stats }
}

/// Changes at random: a parameter, a state, a kick.
fn change(live: &mut Simulator, random: &mut Random) {
    match random.between(0.0, 5.0) as u32 {
        0 => live.set("velocity", random.between(20.0, 110.0)),
        1 => live.set("dampingConstant", random.between(0.0, 100.0)),
        2 => live.set("freeplayAngle", random.between(0.0, 0.03)),
        3 => live.set_state("torsionAngle", random.between(-0.2, 0.2)),
        _ => live.kick(random.between(-5.0, 5.0)),
    }
    .expect("a change");
}

#[test]
fn the_path_does_not_depend_on_how_time_is_cut() {
    // Sums of these are exact, so that all arrive at the very same time.
    for (pieces, dt) in [(1, 2.0), (128, 1.0 / 64.0), (2048, 1.0 / 1024.0), (32_768, 1.0 / 16_384.0)] {
        let mut motion = live();
        let mut whole = live();
        whole.advance(2.0).expect("two seconds");
        for _ in 0..pieces {
            motion.advance(dt).expect("a piece");
        }
        assert_eq!(shown(&mut motion), shown(&mut whole), "{pieces} pieces");
        assert_eq!(path(motion.stats()), path(whole.stats()));
        assert_eq!(motion.history(0.5, 2.0, 100.0), whole.history(0.5, 2.0, 100.0));
    }
}

#[test]
fn a_motion_agrees_with_a_run() {
    for method in ["auto", "dormand-prince", "dop853", "rodas", "rk4"] {
        let run = run().by(method).and_then(|run| run.within(1e-10)).expect("a method");
        let mut motion = run.live().expect("a live motion");
        motion.advance(0.5).expect("half a second");
        let history = motion.history(0.0, 0.5, 101.0).expect("a history");
        let whole = run.lasting(0.5).and_then(|run| run.sampled(101.0)?.simulate()).expect("a trajectory");
        for (i, t) in whole.time.iter().enumerate() {
            assert!((history.time[i] - t).abs() < 1e-15);
        }
        for (live, whole) in history.states.iter().zip(&whole.states) {
            let largest = whole.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            for (a, b) in live.iter().zip(whole) {
                assert!((a - b).abs() < 1e-6 * largest, "{method}: {a} {b}");
            }
        }
    }
}

#[test]
fn any_moment_is_found_again_with_all_that_was_changed() {
    let mut random = Random::seeded(7);
    let mut motion = live();
    let mut moments = vec![shown(&mut motion)];
    for frame in 0..600 {
        motion.advance(1.0 / 64.0).expect("a frame");
        if frame % 7 == 0 {
            change(&mut motion, &mut random);
        }
        moments.push(shown(&mut motion));
    }
    let last = moments.last().expect("moments").clone();
    for _ in 0..200 {
        let (time, state, parameters) = &moments[random.between(0.0, moments.len() as f64) as usize];
        motion.seek(*time).expect("a time within the range");
        assert_eq!(shown(&mut motion), (*time, state.clone(), parameters.clone()));
        assert_eq!(motion.range(), [0.0, last.0]);
    }
    // From any of them it goes on along the recorded way, changes included, and beyond it as if it had never left.
    motion.seek(last.0).expect("the last moment");
    assert_eq!(shown(&mut motion), last);
    motion.advance(0.5).expect("on");
    let ahead = shown(&mut motion);
    motion.seek(moments[100].0).expect("a moment");
    motion.advance(ahead.0 - moments[100].0).expect("the way on");
    assert_eq!(shown(&mut motion), ahead);
}

#[test]
fn a_change_in_the_past_forgets_the_future() {
    let mut motion = live();
    motion.advance(1.0).expect("a second");
    motion.set("dampingConstant", 80.0).expect("a damping");
    motion.advance(1.0).expect("a second");
    motion.seek(0.75).expect("the past");
    assert_eq!(motion.range(), [0.0, 2.0], "looking back changes nothing");
    motion.kick(3.0).expect("a kick");
    assert_eq!(motion.range(), [0.0, 0.75]);
    assert_eq!(motion.seek(1.5).expect_err("it has not happened").code, Code::OutOfRange);
    motion.advance(1.25).expect("on");

    let mut straight = live();
    straight.advance(0.75).expect("the same");
    straight.kick(3.0).expect("a kick");
    straight.advance(1.25).expect("on");
    assert_eq!(shown(&mut motion), shown(&mut straight), "the damping of the other future is gone");
}

#[test]
fn a_value_set_to_what_it_is_changes_nothing() {
    let (mut motion, mut other) = (live(), live());
    motion.advance(0.3).expect("a while");
    motion.set("velocity", 80.0).expect("its own speed");
    motion.advance(0.7).expect("a while");
    other.advance(1.0).expect("the same");
    assert_eq!(motion.state(), other.state());
    motion.seek(0.5).expect("the past");
    motion.set("velocity", 80.0).expect("its own speed");
    assert_eq!(motion.range()[1], 1.0, "nor does it forget");
}

#[test]
fn the_past_reaches_back_sixty_seconds() {
    let mut motion = live();
    motion.advance(100.0).expect("a long while");
    let [earliest, latest] = motion.range();
    assert_eq!(latest, 100.0);
    assert!((earliest - (100.0 - REACH)).abs() < 0.1, "{earliest}");
    motion.seek(earliest).expect("the earliest time");
    motion.seek(latest).expect("the latest time");
    for outside in [earliest - 0.2, -1.0, latest + 1e-9, f64::NAN, f64::INFINITY] {
        let error = motion.seek(outside).expect_err("outside");
        assert_eq!((error.field.as_str(), error.code), ("time", Code::OutOfRange), "{outside}");
        assert_eq!(motion.time(), latest);
    }
}

#[test]
fn a_snapshot_goes_on_bit_by_bit() {
    let mut random = Random::seeded(8);
    for method in ["auto", "dormand-prince", "dop853", "rodas", "rk4"] {
        let run = run().by(method).expect("a method");
        let mut motion = run.live().expect("a live motion");
        for _ in 0..20 {
            motion.advance(random.between(0.0, 0.1)).expect("a while");
            change(&mut motion, &mut random);
            motion.advance(random.between(0.0, 0.1)).expect("a while");
            let mut other = run.live().expect("another");
            other.advance(0.01).expect("it has been somewhere else");
            other.restore(&motion.snapshot()).expect("a snapshot");
            assert_eq!(shown(&mut other), shown(&mut motion), "{method}");
            for _ in 0..3 {
                let dt = random.between(0.0, 0.1);
                motion.advance(dt).expect("on");
                other.advance(dt).expect("on");
                assert_eq!(shown(&mut other), shown(&mut motion), "{method}");
            }
            assert_eq!(path(other.stats()), path(motion.stats()));
            // Its past begins with the snapshot.
            assert!(other.range()[0] > 0.0);
        }
    }
}

#[test]
fn a_snapshot_from_the_step_that_turns_stiff_goes_on_bit_by_bit() {
    let run = Run::of("torsional").and_then(|run| run.with("velocity", 0.01)?.starting("torsionAngle", 0.1));
    let mut motion = run.clone().and_then(|run| run.live()).expect("a live motion");
    for _ in 0..500 {
        motion.advance(1e-4).expect("on");
        let mut other = run.clone().and_then(|run| run.live()).expect("another");
        other.restore(&motion.snapshot()).expect("a snapshot");
        assert_eq!(shown(&mut other), shown(&mut motion));
        other.advance(1e-4).expect("on");
        let mut ahead = run.clone().and_then(|run| run.live()).expect("a third");
        ahead.advance(other.time()).expect("straight on");
        assert_eq!(other.state(), ahead.state());
    }
    assert!(motion.stats().stiff);
}

#[test]
fn what_is_no_snapshot_is_refused_and_changes_nothing() {
    let mut motion = live();
    motion.advance(0.4).expect("a while");
    let whole = motion.snapshot();
    let before = shown(&mut motion);
    let linear = Run::of("torsional-linear").and_then(|run| run.live()).expect("another model").snapshot();
    let mut refused = vec![Vec::new(), vec![0; whole.len()], linear, whole[..whole.len() - 1].to_vec()];
    for place in (0..whole.len()).step_by(5) {
        let mut damaged = whole.clone();
        damaged[place] ^= 0x10;
        refused.push(damaged);
    }
    for bytes in refused {
        assert_eq!(motion.restore(&bytes).expect_err("no snapshot").code, Code::BadSnapshot);
        assert_eq!(shown(&mut motion), before);
        assert_eq!(motion.range(), [0.0, 0.4]);
    }
    motion.advance(0.1).expect("it lives on");
    let mut other = live();
    other.advance(0.4).expect("the same");
    other.advance(0.1).expect("the same");
    assert_eq!(shown(&mut motion), shown(&mut other));
}

#[test]
fn a_reset_is_a_new_start() {
    let mut motion = live();
    let start = shown(&mut motion);
    motion.advance(0.5).expect("a while");
    motion.set("velocity", 30.0).expect("a speed");
    motion.advance(0.5).expect("a while");
    motion.reset().expect("a start");
    assert_eq!(shown(&mut motion), start);
    assert_eq!(motion.range(), [0.0, 0.0]);
    motion.advance(0.5).expect("on");
    let mut other = live();
    other.advance(0.5).expect("the same");
    assert_eq!(shown(&mut motion), shown(&mut other));
}

/// Peaks of the torsion angle by a run of its own: times and heights.
fn peaks(duration: f64) -> Vec<(f64, f64)> {
    let samples = duration * 1e5 + 1.0;
    let whole = run().within(1e-10).and_then(|run| run.lasting(duration)?.sampled(samples.round())?.simulate());
    let whole = whole.expect("a trajectory");
    let psi = &whole.states[0];
    let turns = |i: &usize| (psi[*i] - psi[i - 1]) * (psi[i + 1] - psi[*i]) < 0.0;
    (1..psi.len() - 1).filter(turns).map(|i| (whole.time[i], psi[i])).collect()
}

#[test]
fn envelopes_hold_every_peak() {
    let mut motion = live();
    motion.advance(2.0).expect("a while");
    let peaks = peaks(2.0);
    assert!(peaks.len() > 150);
    for (from, to, stretches) in [(0.0, 2.0, 10), (0.0, 2.0, 400), (0.7, 1.3, 64), (1.99, 2.0, 3)] {
        let envelope = motion.envelope(from, to, f64::from(stretches)).expect("an envelope");
        assert_eq!(envelope.time.len(), stretches as usize);
        let width = (to - from) / f64::from(stretches);
        for &(t, psi) in peaks.iter().filter(|(t, _)| (from + 1e-4..to - 1e-4).contains(t)) {
            // A peak at the border of two stretches may be in either.
            let near: Vec<usize> =
                (0..stretches as usize).filter(|&i| (envelope.time[i] - t).abs() <= 0.5 * width + 1e-4).collect();
            let reached = near.iter().any(|&i| {
                let bound = if psi > 0.0 { envelope.high[i] } else { -envelope.low[i] };
                bound >= psi.abs() - 1e-6
            });
            assert!(reached, "the peak {psi} at {t} is not in {stretches} stretches from {from} to {to}");
        }
        let highest = envelope.high.iter().fold(f64::NEG_INFINITY, |most, x| most.max(*x));
        let top =
            motion.history(from, to, 20_001.0).expect("a history").states[0].iter().fold(0.0, |a: f64, x| a.max(*x));
        assert!((highest - top).abs() < 1e-5, "{highest} {top}");
    }
}

#[test]
fn traces_are_the_steps_since_the_last_call_and_keep_peaks() {
    let mut motion = live();
    motion.trace(16.0).expect("the start");
    motion.advance(2.0).expect("a while");
    let whole = live().history(0.0, 0.0, 2.0).expect("a moment");
    assert_eq!(whole.time, [0.0, 0.0]);
    let mut other = live();
    other.trace(16.0).expect("the start");
    other.advance(2.0).expect("the same");
    let all = motion.trace(1e6).expect("all of it");
    let few = other.trace(600.0).expect("some of it");
    assert!(all.time.len() > 1_500 && few.time.len() <= 600 && few.time.len() > 300);
    assert!(all.time.is_sorted() && few.time.is_sorted());
    for state in 0..3 {
        let extremes = |values: &[f64]| {
            values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)))
        };
        assert_eq!(extremes(&all.states[state]), extremes(&few.states[state]), "the extremes stay");
    }
    // Every row is a moment of the motion.
    for row in (0..few.time.len()).step_by(37).filter(|row| few.time[*row] <= 2.0) {
        other.seek(few.time[row]).expect("a moment");
        for (a, b) in other.state().iter().zip(&few.states) {
            assert!((a - b[row]).abs() <= 1e-12 * a.abs(), "{a} {}", b[row]);
        }
    }
    assert!(motion.trace(16.0).expect("nothing new").time.is_empty());
}

#[test]
fn windows_of_the_past_are_exact() {
    let mut motion = live();
    let mut states = Vec::new();
    for _ in 0..128 {
        motion.advance(1.0 / 64.0).expect("a frame");
        states.push(motion.state());
    }
    let history = motion.history(1.0 / 64.0, 2.0, 128.0).expect("a history");
    for (row, state) in states.iter().enumerate() {
        assert_eq!(history.time[row], (row + 1) as f64 / 64.0);
        let of_row: Vec<f64> = history.states.iter().map(|column| column[row]).collect();
        assert_eq!(&of_row, state);
    }
    for (from, to, samples, field) in [
        (-1.0, 1.0, 10.0, "from"),
        (0.0, 2.5, 10.0, "to"),
        (1.0, 0.5, 10.0, "to"),
        (f64::NAN, 1.0, 10.0, "from"),
        (0.0, 1.0, 1.0, "samples"),
        (0.0, 1.0, 1e12, "samples"),
        (0.0, 1.0, 2.5, "samples"),
        (0.0, 1.0, f64::NAN, "samples"),
    ] {
        assert_eq!(motion.history(from, to, samples).expect_err("refused").field, field, "{from} {to} {samples}");
    }
    assert_eq!(motion.envelope(0.0, 1.0, 0.0).expect_err("refused").field, "buckets");
}

#[test]
fn refused_changes_leave_the_motion_as_it_was() {
    let mut motion = live();
    motion.advance(0.25).expect("a while");
    let before = (shown(&mut motion), motion.range(), motion.snapshot());
    let refused = [
        motion.set("velocity", -3.0),
        motion.set("velocity", 0.0),
        motion.set("velocity", f64::NAN),
        motion.set("velocty", 3.0),
        motion.set_state("torsionAngle", f64::INFINITY),
        motion.set_state("velocity", 1.0),
        motion.kick(f64::NAN),
        motion.kick(f64::NEG_INFINITY),
        motion.advance(-0.1),
        motion.advance(f64::NAN),
        motion.seek(7.0),
        motion.trace(1.0).map(drop),
        motion.trace(f64::NAN).map(drop),
    ];
    for outcome in refused {
        assert!(!outcome.expect_err("refused").field.is_empty());
    }
    assert_eq!((shown(&mut motion), motion.range(), motion.snapshot()), before);
    motion.advance(0.25).expect("it goes on");
    let mut other = live();
    other.advance(0.5).expect("the same");
    assert_eq!(motion.state(), other.state());
}

#[test]
fn a_motion_that_diverges_says_when_and_can_be_taken_back() {
    let run = Run::of("torsional-linear")
        .and_then(|run| run.with("velocity", 100.0)?.with("dampingConstant", 0.0)?.starting("torsionAngle", 0.1))
        .and_then(|run| run.live());
    let mut motion = run.expect("a live motion");
    let mut error = None;
    for _ in 0..1_000 {
        if let Err(refused) = motion.advance(1.0) {
            error = Some(refused);
            break;
        }
    }
    let error = error.expect("it grows without bound");
    assert_eq!(error.code, Code::Diverged);
    assert!(motion.state().iter().all(|x| x.is_finite()));
    let [earliest, latest] = motion.range();
    assert!(latest > 1.0 && motion.time() == latest);
    motion.seek(earliest).expect("the past is still there");
    motion.set("dampingConstant", 200.0).expect("a damping");
    motion.set_state("torsionAngle", 0.1).expect("an angle");
    motion.set_state("torsionRate", 0.0).expect("a rate");
    motion.set_state("lateralDeformation", 0.0).expect("a deformation");
    motion.advance(1.0).expect("it dies out");
    assert!(motion.state()[0].abs() < 0.1);
}

#[test]
fn the_last_frames_of_a_long_motion_are_those_of_a_fresh_one() {
    // After its reach is full, what is forgotten must not touch what is kept.
    let mut random = Random::seeded(9);
    let mut motion = live();
    let mut moments = Vec::new();
    for frame in 0..90 * 16 {
        motion.advance(1.0 / 16.0).expect("a frame");
        if frame % 5 == 0 {
            change(&mut motion, &mut random);
        }
        moments.push(shown(&mut motion));
    }
    let [earliest, _] = motion.range();
    for moment in moments.iter().filter(|(time, ..)| *time >= earliest).step_by(29) {
        motion.seek(moment.0).expect("a moment");
        assert_eq!(&shown(&mut motion), moment);
    }
}
