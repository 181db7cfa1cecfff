//! Where the torsional gear's laws change: none of these events is missed, none is there twice.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::PI;

use common::{
    gear::{Gear, SCHEMES},
    random::Random,
};
use shimmy::{
    Run,
    integrate::{Integrator, Method, Outcome, Stats},
    model::{
        Model, System, Torsional,
        torsional::{PSI, PSI_RATE, Y},
    },
};

/// Looks within a step: so many that no swing of the dense output, a polynomial of degree 7, falls between two of them.
const LOOKS: usize = 24;

/// A dip beyond a surface that is shallower than this part of the state's size in the step counts as a touch: the dense
/// output is no truer than that at rtol 10⁻⁸ where a fast decay holds the step at the edge of stability.
const TOUCH: f64 = 1e-4;

/// The three surfaces: a state, and the distance from 0 at which a law changes. None where there is no kink.
struct Surfaces([Option<(usize, f64)>; 3]);

impl Surfaces {
    fn of(gear: &Gear) -> Self {
        let reach = |angle: &str| gear.get("relaxationLength") * gear.get(angle).tan();
        let gap = gear.get("freeplayAngle");
        Self([
            Some((Y, reach("sideForceLimitAngle"))),
            Some((Y, reach("aligningMomentLimitAngle"))),
            (gap > 0.0).then_some((PSI, gap)),
        ])
    }

    /// How far `x` lies beyond the nearer surface of `kind`, < 0 between the two.
    fn beyond(&self, kind: usize, x: &[f64; 3]) -> f64 {
        self.0[kind].map_or(f64::NEG_INFINITY, |(state, limit)| x[state].abs() - limit)
    }

    /// −1, 0 or 1: below, between, above.
    fn side(&self, kind: usize, x: &[f64; 3]) -> i8 {
        match self.0[kind] {
            Some((state, _)) if self.beyond(kind, x) > 0.0 => x[state].signum() as i8,
            _ => 0,
        }
    }

    /// The size of the state of `kind`, or its typical size where it is small.
    fn size(&self, kind: usize, x: &[f64; 3]) -> f64 {
        self.0[kind].map_or(1.0, |(state, _)| x[state].abs().max(0.1 * Torsional::STATE[state].scale))
    }
}

/// What an audit of a motion has found.
#[derive(Debug, Default)]
struct Audit {
    events: u64,
    /// Stays beyond a surface, or back within, too short to be told from a touch.
    touches: u64,
}

/// Follows a motion to `end` and holds every event against what the motion does: between two events of a kind it stays
/// on one side, at an event it is on the surface, and it changes sides there. Only the dense output is used, nothing of
/// what locates the events.
fn audit(gear: &Gear, mut motion: Integrator<Torsional, 3>, end: f64) -> Audit {
    let surfaces = Surfaces::of(gear);
    let mut found = Audit::default();
    let start = *motion.state();
    // The side of each kind, and how far the motion has been from the surface since its last event.
    let mut sides = [0, 1, 2].map(|kind| surfaces.side(kind, &start));
    let mut farthest = [f64::INFINITY; 3];
    let mut last = 0.0;
    while motion.time() < end {
        let outcome = motion.step(end).unwrap_or_else(|failure| panic!("{failure:?}: {gear:?} from {start:?}"));
        let (from, to) = (motion.step_start(), motion.time());
        assert!(from <= to && last <= to);
        last = to;
        let looks: [[f64; 3]; LOOKS + 1] =
            std::array::from_fn(|look| motion.interpolate(from + (to - from) * look as f64 / LOOKS as f64));
        for kind in 0..3 {
            let touch = TOUCH * looks.iter().fold(0.0, |most, x| surfaces.size(kind, x).max(most));
            for x in &looks {
                let beyond = surfaces.beyond(kind, x);
                let strays = match sides[kind] {
                    0 => beyond > touch,
                    side => beyond < -touch || surfaces.side(kind, x) == -side,
                };
                assert!(!strays, "kind {kind} missed near t = {to}, {beyond:e} beyond: {gear:?} from {start:?}");
                farthest[kind] = f64::max(farthest[kind], beyond.abs() / touch);
            }
        }
        if let Outcome::Switch(which) = outcome {
            let kind = motion.system().event_kind(which);
            let x = *motion.state();
            let off = surfaces.beyond(kind, &x).abs();
            let touch = TOUCH * looks.iter().fold(0.0, |most, x| surfaces.size(kind, x).max(most));
            assert!(
                off < touch,
                "an event of kind {kind} at t = {to}, {off:e} off its surface: {gear:?} from {start:?}"
            );
            // Between two events of a kind the motion must have been somewhere: else the second is the first once more.
            if farthest[kind] < 1.0 {
                found.touches += 1;
            }
            farthest[kind] = 0.0;
            let (state, _) = surfaces.0[kind].expect("an event has a surface");
            sides[kind] = if sides[kind] == 0 { x[state].signum() as i8 } else { 0 };
            found.events += 1;
        }
        assert_eq!(motion.stats().events, found.events);
    }
    found
}

#[test]
fn ten_thousand_random_runs_miss_none_and_double_none() {
    // Two threads: two cores.
    let found: Vec<Audit> = std::thread::scope(|scope| {
        let halves = [1, 2].map(|seed| {
            scope.spawn(move || {
                let mut random = Random::seeded(seed);
                let mut next = || {
                    let gear = Gear::random(&mut random);
                    let motion = gear.motion(Method::Auto, 1e-8, 0.0, Gear::random_start(&mut random));
                    audit(&gear, motion, random.between(0.05, 0.3))
                };
                (0..5_000).map(|_| next()).collect::<Vec<_>>()
            })
        });
        halves.into_iter().flat_map(|half| half.join().expect("no assertion failed")).collect()
    });
    let events: u64 = found.iter().map(|audit| audit.events).sum();
    let touched = found.iter().filter(|audit| audit.touches > 0).count();
    assert!(events > 100_000, "the runs are too tame: {events} events");
    assert!(touched < 100, "{touched} runs of 10,000 touch a surface");
}

/// The equations of the torsional gear as they are printed, without pieces, modes or polynomials.
fn written_rate(gear: &Gear, x: &[f64; 3]) -> [f64; 3] {
    let [psi, psi_rate, y] = *x;
    let get = |name| gear.get(name);
    let (v, e, sigma, gap) = (get("velocity"), get("casterLength"), get("relaxationLength"), get("freeplayAngle"));
    let (delta, alpha_g) = (get("sideForceLimitAngle"), get("aligningMomentLimitAngle"));
    let alpha = (y / sigma).atan();
    let side_force = get("sideForceDerivative") * get("verticalForce") * alpha.clamp(-delta, delta);
    let aligning_moment = if alpha.abs() > alpha_g {
        0.0
    } else {
        -get("aligningMomentDerivative") * get("verticalForce") * alpha_g / PI * (PI * alpha / alpha_g).sin()
    };
    let wound = psi - psi.clamp(-gap, gap);
    let damping = get("dampingConstant") + get("treadWidthMomentConstant") / v;
    let torque = -get("torsionalStiffness") * wound - damping * psi_rate + aligning_moment - e * side_force;
    let y_rate = v * psi + (e - get("halfContactLength")) * psi_rate - v / sigma * y;
    [psi_rate, torque / get("momentOfInertia"), y_rate]
}

/// What a plain count of sides finds.
struct Counted {
    /// Times at which a side changes, for each kind.
    times: [Vec<f64>; 3],
    /// A turn so near a surface, or an event so near the end, that a count can not be sure of it.
    doubtful: bool,
}

/// Steps of the plain integration for the time in which anything happens: kinks are straddled, which leaves an error of
/// the square of this part.
const FINENESS: f64 = 300.0;

/// Integrates the written equations by the classical method in tiny steps and counts changes of sides.
fn counted(gear: &Gear, start: [f64; 3], end: f64) -> Counted {
    let surfaces = Surfaces::of(gear);
    let steps = (end * gear.fastest() * FINENESS).ceil();
    let h = end / steps;
    let moved = |x: &[f64; 3], h: f64, k: &[f64; 3]| std::array::from_fn(|i| x[i] + h * k[i]);
    let (mut x, mut rate) = (start, written_rate(gear, &start));
    let mut found = Counted { times: Default::default(), doubtful: false };
    for step in 0..steps as u64 {
        let k2 = written_rate(gear, &moved(&x, 0.5 * h, &rate));
        let k3 = written_rate(gear, &moved(&x, 0.5 * h, &k2));
        let k4 = written_rate(gear, &moved(&x, h, &k3));
        let next = std::array::from_fn(|i| x[i] + h / 6.0 * (rate[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        let next_rate = written_rate(gear, &next);
        for kind in 0..3 {
            let Some((state, limit)) = surfaces.0[kind] else { continue };
            let (before, after) = (surfaces.side(kind, &x), surfaces.side(kind, &next));
            // Out of one side and into the other: a step that flies through a narrow gap does both.
            for side in [before, after].into_iter().filter(|side| before != after && *side != 0) {
                let part = (limit * f64::from(side) - x[state]) / (next[state] - x[state]);
                found.times[kind].push((step as f64 + part) * h);
            }
            let turns = rate[state] * next_rate[state] <= 0.0;
            let ends = step as f64 > steps - 10.0 && (next[state].abs() - limit).abs() < 20.0 * h * rate[state].abs();
            let near = surfaces.beyond(kind, &next).abs() < 1e-3 * surfaces.size(kind, &next);
            found.doubtful |= turns && near || ends;
        }
        (x, rate) = (next, next_rate);
    }
    found
}

/// The events of a motion, for each kind.
fn located(mut motion: Integrator<Torsional, 3>, end: f64) -> [Vec<f64>; 3] {
    let mut times: [Vec<f64>; 3] = Default::default();
    while motion.time() < end {
        if let Outcome::Switch(which) = motion.step(end).expect("a step") {
            times[motion.system().event_kind(which)].push(motion.time());
        }
    }
    times
}

#[test]
fn events_are_those_of_a_plain_count_by_every_method() {
    let mut random = Random::seeded(3);
    let (mut events, mut doubtful) = (0, 0);
    const CASES: usize = 300;
    for _ in 0..CASES {
        let (gear, start) = (Gear::random(&mut random), Gear::random_start(&mut random));
        let end = 80.0 / gear.fastest();
        let expect = counted(&gear, start, end);
        if expect.doubtful {
            doubtful += 1;
            continue;
        }
        for scheme in SCHEMES {
            let got = located(gear.motion(Method::Always(scheme), 1e-9, 0.01 / gear.fastest(), start), end);
            for kind in 0..3 {
                let (got, expect) = (&got[kind], &expect.times[kind]);
                assert_eq!(got.len(), expect.len(), "{scheme:?}, kind {kind}: {gear:?} from {start:?}");
                for (a, b) in got.iter().zip(expect) {
                    assert!((a - b).abs() < 0.01 / gear.fastest(), "{scheme:?}, kind {kind}: {a} or {b}? {gear:?}");
                }
                events += got.len();
            }
        }
    }
    assert!(events > 4_000, "{events}");
    assert!(doubtful <= CASES / 20, "{doubtful} of {CASES} runs could not be counted");
}

/// Creeping onto the end of the gap: an overdamped spring without a tire to push takes for ever, and is at last off the
/// surface by rounding alone. The motion must go on all the same.
#[test]
fn a_motion_that_creeps_onto_a_surface_goes_on() {
    let gear = Gear::default().with("verticalForce", 0.0).with("momentOfInertia", 0.1).with("velocity", 2.0);
    let gear = gear.with("torsionalStiffness", 3e4).with("dampingConstant", 100.0);
    for gap in [1e-4, 0.005, 0.014_434_193_796_511_946, 0.05] {
        let gear = gear.clone().with("freeplayAngle", gap);
        for scheme in SCHEMES {
            for (psi, rtol) in [(0.1, 1e-6), (-0.09, 1e-8), (0.02, 1e-10)] {
                let mut motion = gear.motion(Method::Always(scheme), rtol, 1e-5, [psi, 1.0, -0.02]);
                while motion.time() < 0.3 {
                    motion.step(0.3).unwrap_or_else(|failure| panic!("{scheme:?}, gap {gap}, from {psi}: {failure:?}"));
                }
                let rest = motion.state()[PSI].abs();
                assert!(rest <= gap * (1.0 + 1e-5) && motion.state()[PSI_RATE].abs() < 1e-4, "{:?}", motion.state());
            }
        }
    }
}

#[test]
fn mirrored_starts_give_mirrored_motions_to_the_last_bit() {
    let mut random = Random::seeded(4);
    for _ in 0..200 {
        let (gear, start) = (Gear::random(&mut random), Gear::random_start(&mut random));
        for scheme in SCHEMES {
            let motion = |start| gear.motion(Method::Always(scheme), 1e-7, 0.02 / gear.fastest(), start);
            let (mut one, mut other) = (motion(start), motion(start.map(|x| -x)));
            for _ in 0..300 {
                let outcomes = [one.step(1.0).map_err(|_| ()), other.step(1.0).map_err(|_| ())];
                // The upper surface for the one is the lower for the other: they are numbered in pairs.
                match outcomes {
                    [Ok(Outcome::Switch(a)), Ok(Outcome::Switch(b))] => assert_eq!(a, b ^ 1),
                    [a, b] => assert_eq!(a, b),
                }
                assert_eq!(one.time(), other.time());
                assert_eq!(*one.state(), other.state().map(|x| -x), "{scheme:?}: {gear:?} from {start:?}");
                if one.time() >= 1.0 {
                    break;
                }
            }
        }
    }
}

/// theory.md 4: while the tire is in its linear range, λ times the gap and the start is λ times the motion.
#[test]
fn small_motions_scale_with_the_gap() {
    let motion = |size: f64| {
        Run::of("torsional")
            .and_then(|run| run.with("velocity", 50.0)?.with("dampingConstant", 100.0)?.with("freeplayAngle", size))
            .and_then(|run| run.starting("torsionAngle", 3.0 * size)?.within(1e-11)?.within_absolute(1e-11 * size))
            .and_then(|run| run.lasting(0.3)?.sampled(200.0)?.simulate())
            .expect("a trajectory")
    };
    // The tire's laws bend with α², some (4 · 10⁻⁵)² here.
    let (one, other) = (motion(1e-5), motion(2.5e-5));
    assert!(one.events.time.len() > 10);
    assert_eq!(one.events.kind, other.events.kind);
    for (a, b) in one.events.time.iter().zip(&other.events.time) {
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
    for (one, other) in one.states.iter().zip(&other.states) {
        let largest = one.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for (a, b) in one.iter().zip(other) {
            assert!((a - b / 2.5).abs() < 1e-6 * largest, "{a} {b}");
        }
    }
}

#[test]
fn kinks_at_the_same_place_are_each_an_event() {
    for scheme in SCHEMES {
        let gear = Gear::default().with("velocity", 80.0).with("aligningMomentLimitAngle", 5_f64.to_radians());
        let found = audit(&gear, gear.motion(Method::Always(scheme), 1e-8, 1e-5, [0.3, 0.0, 0.0]), 0.2);
        let times = located(gear.motion(Method::Always(scheme), 1e-8, 1e-5, [0.3, 0.0, 0.0]), 0.2);
        assert!(found.events > 20);
        assert_eq!(times[0].len(), times[1].len(), "{scheme:?}");
        for (a, b) in times[0].iter().zip(&times[1]) {
            assert!((a - b).abs() < 1e-9, "{scheme:?}: {a} {b}");
        }
    }
}

#[test]
fn a_start_on_a_surface_is_no_event() {
    let gap = 1_f64.to_radians();
    let gear = Gear::default().with("freeplayAngle", gap).with("velocity", 60.0);
    let reach = gear.get("relaxationLength") * gear.get("sideForceLimitAngle").tan();
    for scheme in SCHEMES {
        for sign in [-1.0, 1.0] {
            for rate in [-5.0, 5.0] {
                for y in [0.0, reach, -reach] {
                    let (start, end) = ([sign * gap, rate, y], 0.05);
                    // A hair further the way it goes, a plain count is sure of the side.
                    let ahead = counted(&gear, [start[0] + 1e-12 * rate, rate, y], end);
                    let found = located(gear.motion(Method::Always(scheme), 1e-8, 1e-5, start), end);
                    assert!(found[2][0] > 1e-4, "{scheme:?} from {start:?}: {:?}", found[2]);
                    assert_eq!(found[2].len(), ahead.times[2].len(), "{scheme:?} from {start:?}");
                }
            }
        }
    }
}

#[test]
fn walking_pace_is_not_too_slow() {
    // κ/v damps 27 000 and 2.7 million times a second: the motion only creeps, out of the spring and into the gap.
    let gap = 1_f64.to_radians();
    for (velocity, most_steps) in [(0.01, 2_000), (1e-4, 2_000)] {
        let gear = Gear::default().with("velocity", velocity).with("freeplayAngle", gap);
        let mut motion = gear.motion(Method::Auto, 1e-8, 0.0, [0.1, 0.0, 0.0]);
        while motion.time() < 1.0 {
            motion.step(1.0).expect("a step");
        }
        let Stats { steps, events, stiff, .. } = motion.stats();
        assert!(stiff && steps < most_steps, "v = {velocity}: {steps} steps");
        assert!(motion.state()[PSI] > 0.0 && motion.state()[PSI] < 0.1);
        assert!(events <= 2, "v = {velocity}: {events} events");
    }
}
