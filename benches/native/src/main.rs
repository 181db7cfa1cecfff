//! The native side of `npm run bench`: one line of JSON for each measurement.

mod branches;
mod case;
mod contest;
mod ensembles;
mod maps;
mod ours;
#[cfg(feature = "peers")]
mod peers;
#[cfg(feature = "peers")]
mod textbook;

use case::Case;
use serde_json::json;

fn main() {
    let case = Case::read();
    let flags = env!("BUILD_FLAGS");
    let place = if flags.contains("target-cpu") { "shimmy, native (this CPU)" } else { "shimmy, native (plain flags)" };
    println!("{}", json!({ "flags": flags }));
    println!("{}", contest::enter(&case, place, |tolerance| ours::solve(&case, "auto", tolerance)));
    for map in maps::measured(place) {
        println!("{}", json!({ "map": map }));
    }
    for branch in branches::measured(place) {
        println!("{}", json!({ "branch": branch }));
    }
    for ensemble in ensembles::measured(place) {
        println!("{}", json!({ "ensemble": ensemble }));
    }
    #[cfg(feature = "peers")]
    {
        if let Some(tight) = ours::solve(&case, "dop853", 1e-13) {
            println!("{}", json!({ "tight": case.errors(&tight.solution) }));
        }
        println!(
            "{}",
            contest::enter(&case, "ode_solvers dopri5", |tolerance| peers::ode_solvers_dopri5(&case, tolerance))
        );
        println!(
            "{}",
            contest::enter(&case, "ode_solvers dop853", |tolerance| peers::ode_solvers_dop853(&case, tolerance))
        );
        println!("{}", contest::enter(&case, "diffsol tsit45", |tolerance| peers::diffsol_tsit45(&case, tolerance)));
    }
}
