//! Every entry of the atlas that is a run of a gear that is here can be read and carried out.
#![cfg(not(target_arch = "wasm32"))]

use std::collections::HashSet;

use serde_json::Value as Json;
use shimmy::{Run, atlas, model, run::Value};

fn entries() -> Vec<Json> {
    serde_json::from_str(atlas::JSON).unwrap()
}

fn untyped(json: &Json) -> Value {
    match json {
        Json::Null => Value::Absent,
        Json::Bool(truth) => Value::Bool(*truth),
        Json::Number(number) => Value::Number(number.as_f64().unwrap()),
        Json::String(text) => Value::Text(text.clone()),
        Json::Array(list) => match list.iter().map(Json::as_f64).collect() {
            Some(numbers) => Value::Numbers(numbers),
            None => Value::List(list.len()),
        },
        Json::Object(entries) => {
            Value::Record(entries.iter().map(|(key, value)| (key.clone(), untyped(value))).collect())
        }
    }
}

#[test]
fn every_entry_says_what_it_is() {
    let entries = entries();
    assert_eq!(entries.len(), 283);
    let mut seen = HashSet::new();
    for entry in &entries {
        let text = |key: &str| entry[key].as_str().unwrap_or_else(|| panic!("{entry} has no {key}"));
        assert!(seen.insert(text("id")), "{} is there twice", text("id"));
        assert!(!text("title").is_empty() && !text("view").is_empty());
    }
    for figure in ["Figure 5.59", "Figure 6.24b"] {
        assert!(seen.contains(figure));
    }
}

#[test]
fn every_run_of_a_gear_that_is_here_is_carried_out() {
    let known: HashSet<_> = model::list().iter().map(|model| model.name).collect();
    let mut carried_out = 0;
    for entry in entries() {
        let run = &entry["run"];
        if !run["model"].as_str().is_some_and(|model| known.contains(model)) {
            continue;
        }
        let run = Run::read(&untyped(run)).unwrap_or_else(|error| panic!("{entry}: {error}"));
        let motion = run.simulate().unwrap_or_else(|error| panic!("{entry}: {error}"));
        assert!(motion.states.iter().flatten().all(|value| value.is_finite()));
        for shown in entry["show"].as_array().into_iter().flatten() {
            assert!(run.description().state.iter().any(|state| shown == state.name), "{entry}");
        }
        carried_out += 1;
    }
    assert!(carried_out > 120, "only {carried_out} runs");
}

#[test]
fn every_map_of_a_gear_that_is_here_names_its_parameters() {
    let mut maps = 0;
    for entry in entries().iter().filter(|entry| !entry["map"].is_null()) {
        let map = &entry["map"];
        let gear = Run::of(map["model"].as_str().unwrap()).unwrap();
        for (name, value) in map["parameters"].as_object().unwrap() {
            gear.clone().with(name, value.as_f64().unwrap()).unwrap();
        }
        for axis in ["x", "y"] {
            for end in ["from", "to"] {
                let name = map[axis]["parameter"].as_str().unwrap();
                gear.clone().with(name, map[axis][end].as_f64().unwrap()).unwrap();
            }
        }
        maps += 1;
    }
    assert_eq!(maps, 53);
}
