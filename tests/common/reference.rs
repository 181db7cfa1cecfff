//! Reference trajectories from outside of this crate, and the runs that must meet them.

use serde_json::Value as Json;
use shimmy::{Run, integrate::Trajectory, run::Value, stability::MapSpec};

/// A run and what it must give.
pub struct Case {
    pub id: String,
    pub run: Run,
    /// One column per state variable, in the order of the state table.
    pub expect: Vec<Vec<f64>>,
    /// Kinks crossed on the way, where the source counts them.
    pub kinks: Option<u64>,
}

impl Case {
    /// Largest difference of any state, relative to its series' largest value.
    pub fn error(&self, got: &Trajectory) -> f64 {
        self.expect.iter().zip(&got.states).fold(0.0, |worst, (expect, got)| {
            assert_eq!(expect.len(), got.len());
            let largest = expect.iter().fold(f64::MIN_POSITIVE, |most, value| value.abs().max(most));
            expect.iter().zip(got).fold(worst, |worst: f64, (a, b)| worst.max((a - b).abs() / largest))
        })
    }
}

/// Made with SciPy, handed to the project with its brief.
pub fn handed_over() -> Json {
    serde_json::from_str(include_str!("../reference.json")).expect("a JSON file")
}

/// Taylor series in 128-bit floats; the file says more.
pub fn random() -> Json {
    serde_json::from_str(include_str!("../random-reference.json")).expect("a JSON file")
}

/// With dampers; the file says more.
pub fn with_dampers() -> Json {
    serde_json::from_str(include_str!("../damped-gear-reference.json")).expect("a JSON file")
}

/// The trajectories of a file, but for those with a damper, of which not all that others are asked for is asked.
pub fn trajectories(file: &Json) -> Vec<Case> {
    cases(file, false)
}

/// Those with a damper.
pub fn damped(file: &Json) -> Vec<Case> {
    cases(file, true)
}

fn cases(file: &Json, damped: bool) -> Vec<Case> {
    let cases = file["trajectories"].as_array().expect("a list");
    cases
        .iter()
        .filter(|case| case["run"]["damper"].is_null() != damped)
        .map(|case| {
            let run = run(&case["run"]);
            let expect = |name: &str| case["expect"][name].as_array().expect("a series").iter().map(number).collect();
            Case {
                id: case["id"].as_str().expect("a name").to_owned(),
                expect: run.description().state.iter().map(|state| expect(state.name)).collect(),
                kinks: case["kinks"].as_u64(),
                run,
            }
        })
        .collect()
}

/// The maps of a file: name, map, and the share of stable cells in percent.
pub fn maps(file: &Json) -> Vec<(String, MapSpec, f64)> {
    let of = |case: &Json| {
        let spec = MapSpec::read(&value(&case["map"])).expect("a map");
        (case["id"].as_str().expect("a name").to_owned(), spec, number(&case["stablePercent"]))
    };
    file["maps"].as_array().expect("a list").iter().map(of).collect()
}

/// What the source itself may be wrong by, where it says so.
pub fn reference_error(file: &Json, id: &str) -> f64 {
    let cases = file["trajectories"].as_array().expect("a list");
    cases.iter().find(|case| case["id"] == id).and_then(|case| case["referenceError"].as_f64()).unwrap_or(0.0)
}

/// A run as a JavaScript caller would write it.
pub fn run(json: &Json) -> Run {
    Run::read(&value(json)).expect("a run")
}

pub fn text(json: &Json) -> &str {
    json.as_str().expect("a name")
}

pub fn number(json: &Json) -> f64 {
    json.as_f64().expect("a number")
}

pub fn value(json: &Json) -> Value {
    match json {
        Json::Null => Value::Absent,
        Json::Bool(truth) => Value::Bool(*truth),
        Json::Number(_) => Value::Number(number(json)),
        Json::String(text) => Value::Text(text.clone()),
        Json::Array(list) if list.first().is_some_and(Json::is_object) => {
            Value::Records(list.iter().map(value).collect())
        }
        Json::Array(list) => Value::Numbers(list.iter().map(number).collect()),
        Json::Object(entries) => Value::Record(entries.iter().map(|(key, json)| (key.clone(), value(json))).collect()),
    }
}
