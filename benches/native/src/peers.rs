//! The crates that shimmy is measured against, used as their documentation shows: the absolute tolerance is a hundredth
//! of the relative one, and each stops at the times of the case, which gives it its own accuracy there.

use std::cell::Cell;

use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};
use ode_solvers::{Dop853, Dopri5, OutputType, System, Vector3};

use crate::case::Case;
use crate::contest::Outcome;
use crate::textbook::Gear;

struct Textbook(Gear);

impl System<f64, Vector3<f64>> for Textbook {
    fn system(&self, _: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        *dy = self.0.rate([y[0], y[1], y[2]]).into();
    }
}

/// One of the explicit methods of the crate `ode_solvers`, leg by leg to each time.
macro_rules! ode_solvers_method {
    ($name:ident, $method:ident) => {
        pub fn $name(case: &Case, tolerance: f64) -> Option<Outcome> {
            let gear = Gear { velocity: case.velocity, damping: case.damping };
            let (mut state, mut now) = (Vector3::from(case.initial), 0.0);
            let (mut steps, mut evaluations) = (0, 0);
            let mut solution = [[0.0; 3]; 2];
            for (leg, &time) in case.times.iter().enumerate() {
                let step = time - now;
                let mut solver = $method::new(Textbook(gear), now, time, step, state, tolerance, tolerance / 100.0);
                solver.set_output(OutputType::Sparse);
                let stats = solver.integrate().ok()?;
                state = *solver.y_out().last()?;
                now = time;
                steps += u64::from(stats.accepted_steps);
                evaluations += u64::from(stats.num_eval);
                solution[leg] = state.into();
            }
            Some(Outcome { solution, steps: Some(steps), evaluations: Some(evaluations) })
        }
    };
}

ode_solvers_method!(ode_solvers_dopri5, Dopri5);
ode_solvers_method!(ode_solvers_dop853, Dop853);

/// Tsitouras 5(4) of the crate `diffsol`, stopped at each time.
pub fn diffsol_tsit45(case: &Case, tolerance: f64) -> Option<Outcome> {
    let gear = Gear { velocity: case.velocity, damping: case.damping };
    let initial = case.initial;
    let evaluations = Cell::new(0);
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance / 100.0])
        .rhs(|x, _, _, rate| {
            evaluations.set(evaluations.get() + 1);
            rate.copy_from_slice(&gear.rate([x[0], x[1], x[2]]));
        })
        .init(move |_, _, state| state.copy_from_slice(&initial), 3)
        .build()
        .ok()?;
    let mut solver = problem.tsit45().ok()?;
    let mut steps = 0;
    let mut solution = [[0.0; 3]; 2];
    for (leg, &time) in case.times.iter().enumerate() {
        solver.set_stop_time(time).ok()?;
        loop {
            steps += 1;
            match solver.step().ok()? {
                OdeSolverStopReason::TstopReached => break,
                _ => continue,
            }
        }
        solution[leg].copy_from_slice(solver.state().y.batch_as_slice(0));
    }
    Some(Outcome { solution, steps: Some(steps), evaluations: Some(evaluations.get()) })
}
