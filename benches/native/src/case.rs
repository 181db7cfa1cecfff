//! The case that every solver is given, and how far a solution is from the truth.

use serde_json::Value;

/// The states at the two times of the case.
pub type Solution = [[f64; 3]; 2];

/// `benches/case.json`: one run, its reference, and the error that is allowed at each time.
pub struct Case {
    pub velocity: f64,
    pub damping: f64,
    pub initial: [f64; 3],
    pub times: [f64; 2],
    pub allowed: [f64; 2],
    pub tolerances: Vec<f64>,
    amplitude: [f64; 3],
    reference: Solution,
}

impl Case {
    pub fn read() -> Self {
        let json: Value = serde_json::from_str(include_str!("../../case.json")).expect("case.json is JSON");
        let numbers = |value: &Value| -> Vec<f64> {
            value.as_array().expect("a list").iter().map(|item| item.as_f64().expect("a number")).collect()
        };
        let three = |value: &Value| -> [f64; 3] { numbers(value).try_into().expect("three numbers") };
        let two = |value: &Value| -> [f64; 2] { numbers(value).try_into().expect("two numbers") };
        let parameter = |name: &str| json["parameters"][name].as_f64().expect("a number");
        Self {
            velocity: parameter("velocity"),
            damping: parameter("dampingConstant"),
            initial: [json["initial"]["torsionAngle"].as_f64().expect("a number"), 0.0, 0.0],
            times: two(&json["times"]),
            allowed: two(&json["allowed"]),
            tolerances: numbers(&json["tolerances"]),
            amplitude: three(&json["amplitude"]),
            reference: [three(&json["reference"][0]), three(&json["reference"][1])],
        }
    }

    /// At each time the largest difference of the three states, relative to their amplitudes on the cycle.
    pub fn errors(&self, solution: &Solution) -> [f64; 2] {
        std::array::from_fn(|time| {
            (0..3)
                .map(|state| (solution[time][state] - self.reference[time][state]).abs() / self.amplitude[state])
                .fold(0.0, f64::max)
        })
    }
}
