//! The native side of `npm run bench`: one line of JSON for each solver.

mod case;
mod contest;
mod peers;
mod textbook;

use case::Case;

fn main() {
    let case = Case::read();
    println!(
        "{}",
        contest::enter(&case, "ode_solvers dopri5", |tolerance| {
            peers::ode_solvers_dopri5(&case, tolerance)
        })
    );
    println!(
        "{}",
        contest::enter(&case, "ode_solvers dop853", |tolerance| {
            peers::ode_solvers_dop853(&case, tolerance)
        })
    );
    println!(
        "{}",
        contest::enter(&case, "diffsol tsit45", |tolerance| peers::diffsol_tsit45(
            &case, tolerance
        ))
    );
}
