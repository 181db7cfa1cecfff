//! Ensembles: the crate's lanes beside its own step for one motion and the textbook's loop.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use serde_json::{Value, json};
use shimmy::{
    Run,
    ensemble::{Bundle, LANES, step},
    model::{Model, Prepared, Torsional},
};

/// The shortest of the runs that fit into this time is reported.
const WATCHED: Duration = Duration::from_millis(500);
/// Steps of two seconds at 50 Hz.
const STEPS: usize = 10_000;

/// Trajectories a second.
fn per_second(trajectories: usize, work: &dyn Fn() -> [f64; 3]) -> f64 {
    let (start, mut least) = (Instant::now(), Duration::MAX);
    while start.elapsed() < WATCHED {
        let one = Instant::now();
        black_box(work());
        least = least.min(one.elapsed());
    }
    trajectories as f64 / least.as_secs_f64()
}

/// The gear as a textbook has it.
fn plain() -> [f64; 3] {
    let [v, e, a, sigma, k, c, load, side, aligning, tread]: [f64; 10] =
        black_box([37.263, 0.1, 0.1, 0.3, 1e5, 30.0, 9000.0, 20.0, 2.0, 270.0]);
    let (delta, limit, h) = (5.0_f64.to_radians(), 10.0_f64.to_radians(), 2e-4);
    let rate = |[psi, turning, y]: [f64; 3]| {
        let alpha = (y / sigma).atan();
        let force = side * load * alpha.clamp(-delta, delta);
        let pi = std::f64::consts::PI;
        let moment =
            if alpha.abs() <= limit { -aligning * load * limit / pi * (pi * alpha / limit).sin() } else { 0.0 };
        let acceleration = -k * psi - (c + tread / v) * turning + moment - e * force;
        [turning, acceleration, v * psi + (e - a) * turning - v / sigma * y]
    };
    let mut x = [0.025, 0.0, 0.0];
    for _ in 0..STEPS {
        let moved = |k: [f64; 3], h: f64| std::array::from_fn(|i| x[i] + h * k[i]);
        let k1 = rate(x);
        let k2 = rate(moved(k1, 0.5 * h));
        let k3 = rate(moved(k2, 0.5 * h));
        let k4 = rate(moved(k3, h));
        x = std::array::from_fn(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    x
}

/// Every measurement; `place` begins the names of ours.
pub fn measured(place: &str) -> Vec<Value> {
    let run = Run::of("torsional").expect("it is listed");
    let run = run.with("velocity", 37.263).and_then(|run| run.with("dampingConstant", 30.0)).expect("valid values");
    let prepared = Prepared::of(&Torsional::new(run.parameters())).expect("lanes take it");
    let alone = || {
        let mut x = [0.025, 0.0, 0.0];
        for _ in 0..STEPS {
            x = step(&prepared.gear, &x, [0.5, 1.0 / 3.0, 1.0 / 6.0]);
        }
        x
    };
    let together = || {
        let mut bundle = Bundle::at_rest();
        for lane in 0..LANES {
            bundle.load(lane, &prepared.gear, [0.025, 0.0, 0.0]);
        }
        bundle.advance(STEPS);
        bundle.state(0)
    };
    let row = |what: String, per_second: f64| json!({ "what": what, "perSecond": per_second });
    vec![
        row("plain Rust, native, one by one".into(), per_second(1, &plain)),
        row(format!("{place}, the lanes' equations one by one"), per_second(1, &alone)),
        row(format!("{place}, in lanes (no registers of two)"), per_second(LANES, &together)),
    ]
}
