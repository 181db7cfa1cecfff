//! Values of dampers found again from their own records.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::reference::value;
use serde_json::{Value as Json, json};
use shimmy::{
    element::damper,
    identify::{Identification, IdentificationSpec, Record, RecordSpec},
};

/// A record of 500 samples.
fn made(damper: &Json, excitation: &Json, cycles: f64, noise: f64, seed: u64) -> Record {
    let spec = json!({"damper": damper, "excitation": excitation, "cycles": cycles, "samples": 500, "noise": noise, "seed": seed});
    RecordSpec::read(&value(&spec)).unwrap().record().unwrap()
}

fn json_of(record: &Record) -> Json {
    json!({"displacement": record.displacement, "velocity": record.velocity, "force": record.force,
        "command": record.command, "interval": record.interval})
}

/// Four records of a damper: four motions, at commands from 0 to 1.5.
fn records(model: &str, parameters: &Json, noise: f64) -> Vec<Json> {
    let motions = [
        json!({"amplitude": 0.015, "frequency": 2.5}),
        json!({"amplitude": 0.002, "endAmplitude": 0.02, "frequency": 2}),
        json!({"amplitude": 0.005, "frequency": 1, "endFrequency": 8}),
        json!({"amplitude": 0.008, "frequency": 4}),
    ];
    let commands = [0.0, 0.5, 1.0, 1.5];
    let one = |(i, motion): (usize, &Json)| {
        let damper = json!({"model": model, "command": commands[i], "parameters": parameters});
        json_of(&made(&damper, motion, 3.0, noise, 100 + i as u64))
    };
    motions.iter().enumerate().map(one).collect()
}

fn spec(json: &Json) -> IdentificationSpec {
    IdentificationSpec::read(&value(json)).unwrap()
}

fn found(spec: IdentificationSpec) -> Identification {
    let mut identification = Identification::new(spec);
    while !identification.done() {
        identification.step();
    }
    identification
}

#[test]
fn scratch() {
    for (model, n) in
        [("bouc-wen", 2.0), ("modified-bouc-wen", 2.0), ("current-dependent-bouc-wen", 2.0), ("bouc-wen", 1.0)]
    {
        let parameters = if n == 1.0 { json!({"exponent": 1, "gamma": 3e4, "beta": 1e4}) } else { json!({}) };
        let triangle = json_of(&made(
            &json!({"model": model, "parameters": parameters}),
            &json!({"shape": "triangle"}),
            3.0,
            0.0,
            1,
        ));
        let described = damper::named(model).unwrap();
        let records = records(model, &parameters, 0.0);
        let bounds = if n == 1.0 { json!({"exponent": [1, 1]}) } else { json!({}) };
        let spec = spec(&json!({"model": model, "records": records, "bounds": bounds}));
        let mut values = described.defaults();
        if n == 1.0 {
            values[4] = 3e4;
            values[5] = 1e4;
            values[6] = 1.0;
        }
        let errors: Vec<f64> = spec.fits(&values).unwrap().iter().map(|fit| fit.error).collect();
        println!("{model}: replay errors {errors:?}");
        let of_triangle =
            IdentificationSpec::read(&value(&json!({"model": model, "records": [triangle], "bounds": bounds})))
                .unwrap();
        println!("triangle {}", of_triangle.error(&values));
        for seed in [1, 2, 3] {
            let began = std::time::Instant::now();
            let mut identification = Identification::new(spec.seeded(seed));
            while !identification.done() && !identification.polishing() {
                identification.step();
            }
            let (generations, genetic, time) =
                (identification.generation(), identification.best_error(), began.elapsed());
            while !identification.done() {
                identification.step();
            }
            println!(
                "  seed {seed}: {generations} gens {:.1}/s, error {genetic:.5}, polished {:.6} in {} steps, {:.2} s",
                generations as f64 / time.as_secs_f64(),
                identification.best_error(),
                identification.generation() - generations,
                (began.elapsed() - time).as_secs_f64()
            );
            if seed == 1 {
                let it = spec.identifiability(&identification.best()).unwrap();
                for p in &it.parameters {
                    println!("     {} {} slack {:.3} {}", p.name, p.value, p.slack, p.fixed);
                }
                for d in &it.weak {
                    println!("     weak {:.5} {:?}", d.change, d.parts);
                }
            }
        }
    }
}
