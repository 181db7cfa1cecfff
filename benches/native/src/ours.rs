//! The crate itself in the contest.

use shimmy::{Result, Run};

use crate::case::{Case, Solution};
use crate::contest::Outcome;

/// The run of the case at a relative tolerance, by a method of this name.
fn run(case: &Case, method: &str, tolerance: f64) -> Result<Run> {
    Run::of("torsional")?
        .with("velocity", case.velocity)?
        .with("dampingConstant", case.damping)?
        .starting("torsionAngle", case.initial[0])?
        .by(method)?
        .within(tolerance)?
        .at(case.times.to_vec())
}

/// One run, as any user of the crate would ask for it.
pub fn solve(case: &Case, method: &str, tolerance: f64) -> Option<Outcome> {
    let trajectory = run(case, method, tolerance).ok()?.simulate().ok()?;
    let solution: Solution = std::array::from_fn(|time| std::array::from_fn(|state| trajectory.states[state][time]));
    Some(Outcome { solution, steps: Some(trajectory.stats.steps), evaluations: Some(trajectory.stats.evaluations) })
}
