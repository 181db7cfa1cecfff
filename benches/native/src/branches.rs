//! Branches of limit cycles: the crate beside what a script does with an integrator of another crate.

use std::{
    hint::black_box,
    time::{Duration, Instant},
};

use serde_json::{Value, json};
use shimmy::{Run, cycles::BifurcationSpec, stability::Variation};

/// The shortest of the runs that fit into this time is reported.
const WATCHED: Duration = Duration::from_millis(500);

/// Milliseconds.
fn shortest(mut work: impl FnMut()) -> f64 {
    let (start, mut least) = (Instant::now(), Duration::MAX);
    while start.elapsed() < WATCHED {
        let one = Instant::now();
        work();
        least = least.min(one.elapsed());
    }
    least.as_secs_f64() * 1e3
}

/// From its Hopf point to 120 m/s, c = 20, in steps that make some 200 cycles.
fn ours() -> usize {
    let run = Run::of("torsional").and_then(|run| run.with("dampingConstant", 20.0)).expect("it is listed");
    let spec = BifurcationSpec::of(run, Variation::of("velocity", 10.0, 120.0));
    let made = BifurcationSpec { step: 0.0045, probes: 0, ..spec }.made().expect("it can be made");
    made.cycles().iter().map(|branch| branch.points.len()).sum()
}

/// Every measurement; `place` begins the names of ours.
pub fn measured(place: &str) -> Vec<Value> {
    let row = |what: String, points: usize, milliseconds: f64| json!({ "what": what, "points": points, "milliseconds": milliseconds });
    vec![
        row(format!("{place}: from its Hopf point to 120 m/s, c = 20"), ours(), shortest(|| drop(black_box(ours())))),
        #[cfg(feature = "peers")]
        row(
            "script, ode_solvers dop853: shooting from 28 to 120 m/s, differences, speed by speed".into(),
            script::POINTS,
            shortest(|| drop(black_box(script::branch()))),
        ),
    ]
}

/// Shooting as a script has it: half a period with ψ = 0 at its ends, Newton's method on (ψ̇, y, T) with derivatives by
/// differences, the cycle before as the next guess. It goes through no fold, has no kinks located, and its multipliers come
/// from the same differences.
#[cfg(feature = "peers")]
mod script {
    use ode_solvers::{Dop853, OutputType, System, Vector3};

    use crate::textbook::Gear;

    pub const POINTS: usize = 200;

    struct Textbook(Gear);

    impl System<f64, Vector3<f64>> for Textbook {
        fn system(&self, _: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
            *dy = self.0.rate([y[0], y[1], y[2]]).into();
        }
    }

    fn arrival(gear: Gear, [rate, y, time]: [f64; 3]) -> Option<[f64; 3]> {
        let start = Vector3::new(0.0, rate, y);
        let mut solver = Dop853::new(Textbook(gear), 0.0, time, time, start, 1e-10, 1e-12);
        solver.set_output(OutputType::Sparse);
        solver.integrate().ok()?;
        let end = solver.y_out().last()?;
        Some([end[0], end[1] + rate, end[2] + y])
    }

    fn solved(mut rows: [[f64; 4]; 3]) -> [f64; 3] {
        for k in 0..3 {
            let pivot = (k..3).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs())).unwrap_or(k);
            rows.swap(k, pivot);
            for i in 0..3 {
                if i != k {
                    let factor = rows[i][k] / rows[k][k];
                    (k..4).for_each(|j| rows[i][j] -= factor * rows[k][j]);
                }
            }
        }
        std::array::from_fn(|i| rows[i][3] / rows[i][i])
    }

    /// The cycles, as (ψ̇, y, half the period) where ψ rises through zero.
    pub fn branch() -> Option<Vec<[f64; 3]>> {
        // The cycle at 120 m/s, roughly.
        let mut cycle = [73.0, 0.03, 0.5 / 52.5];
        let size = [100.0, 0.05, 0.01];
        (0..POINTS)
            .map(|i| {
                let gear = Gear { velocity: 120.0 - 92.0 * i as f64 / (POINTS - 1) as f64, damping: 20.0 };
                for _ in 0..20 {
                    let miss = arrival(gear, cycle)?;
                    let slopes: Vec<[f64; 3]> = (0..3)
                        .map(|j| {
                            let mut aside = cycle;
                            aside[j] += 1e-6 * size[j];
                            let other = arrival(gear, aside)?;
                            Some(std::array::from_fn(|i| (other[i] - miss[i]) / (1e-6 * size[j])))
                        })
                        .collect::<Option<_>>()?;
                    let rows = std::array::from_fn(|i| [slopes[0][i], slopes[1][i], slopes[2][i], -miss[i]]);
                    let step = solved(rows);
                    (0..3).for_each(|j| cycle[j] += step[j]);
                    if (0..3).all(|j| step[j].abs() < 1e-7 * size[j]) {
                        return Some(cycle);
                    }
                }
                None
            })
            .collect()
    }
}
