//! What dampers do on a moved piston: against SciPy, and never giving back more than they were given.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{random::Random, reference::value};
use serde_json::{Value as Json, json};
use shimmy::element::damper::{self, DamperResponse, DamperSpec, Excitation, ResponseSpec, Shape};

fn spec(json: &Json) -> ResponseSpec {
    ResponseSpec::read(&value(json)).unwrap()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

/// The file is made by benches/dampers.py: DOP853 of SciPy at 1e-13 between the turns.
#[test]
fn loops_agree_with_scipy() {
    let file: Json = serde_json::from_str(include_str!("damper-reference.json")).unwrap();
    let cases = file.as_array().unwrap();
    assert_eq!(cases.len(), 16);
    for case in cases {
        let got = spec(&case["spec"]).response().unwrap();
        let rows = case["rows"].as_array().unwrap();
        assert!(rows.len() >= 20);
        for row in rows {
            let [time, force, z, w] = [0, 1, 2, 3].map(|i| row[i].as_f64().unwrap());
            let at = got.time.iter().position(|t| (t - time).abs() < 1e-9 * got.time[1]).unwrap();
            let off = (got.force[at] - force).abs() / largest(&got.force);
            assert!(off < 1e-8, "{} at {time}: {} for {force}, off by {off:e}", case["spec"], got.force[at]);
            assert!((got.hysteresis[at] - z).abs() < 1e-8 * largest(&got.hysteresis), "{}", case["spec"]);
            assert!((got.internal_displacement[at] - w).abs() <= 1e-8 * largest(&got.internal_displacement));
        }
    }
}

#[test]
fn without_a_word_it_is_four_cycles_of_a_centimetre() {
    for damper in damper::list() {
        let got = spec(&json!({"damper": {"model": damper.name}})).response().unwrap();
        assert_eq!(got.time.len(), 1000);
        assert_eq!(got.time[1], 2.0 / 1000.0);
        assert_eq!((got.displacement[0], got.hysteresis[0], got.internal_displacement[0]), (0.0, 0.0, 0.0));
        assert!((got.displacement[62] - 0.01 * (4.0 * std::f64::consts::PI * 0.124_f64).sin()).abs() < 1e-15);
        assert!((got.velocity[0] - 0.01 * 4.0 * std::f64::consts::PI).abs() < 1e-15);
    }
}

#[test]
fn a_force_scale_scales_the_force_and_nothing_else() {
    let of = |scale: f64| {
        spec(&json!({"damper": {"model": "modified-bouc-wen-cubic", "parameters": {"forceScale": scale}}}))
            .response()
            .unwrap()
    };
    let (whole, part) = (of(1.0), of(0.01));
    assert!(
        whole.force.iter().zip(&part.force).all(|(whole, part)| (whole * 0.01 - part).abs() <= 1e-12 * whole.abs())
    );
    assert_eq!(whole.hysteresis, part.hysteresis);
}

/// A damper with random values around its defaults, some of them with |β| > γ.
fn any_damper(random: &mut Random) -> DamperSpec {
    let list = damper::list();
    loop {
        let description = &list[(random.unit() * 4.0) as usize];
        let mut spec = DamperSpec::of(description.name).unwrap();
        let mut fits = true;
        let exponent = [1.0, 2.0, 2.0, 1.7, 3.0][(random.unit() * 5.0) as usize];
        // γ and β are in m⁻ⁿ: it yields where it did.
        let usual = spec.damper().hysteresis();
        let per_unit = usual.saturation().powf(usual.exponent() - exponent);
        for parameter in description.parameters {
            let default = parameter.default;
            let value = match parameter.name {
                "exponent" => exponent,
                "gamma" => default * per_unit * random.between(0.3, 3.0),
                "beta" => default * per_unit * random.between(-0.9, 3.0),
                name if name.ends_with("Saturation") => random.between(0.0, 6.0),
                // Other polynomials are likely to be negative somewhere.
                _ if description.name == "modified-bouc-wen-cubic" => default,
                _ => default * random.between(0.3, 3.0),
            };
            match spec.clone().with(parameter.name, value) {
                Ok(changed) => spec = changed,
                Err(_) => fits = false,
            }
        }
        let command = random.between(description.command.min, description.command.max);
        if let (true, Ok(spec)) = (fits, spec.with("command", command)) {
            return spec;
        }
    }
}

/// ∫ F dx, the force taken in the middle.
fn work(got: &DamperResponse, from: usize) -> f64 {
    (from + 1..got.force.len())
        .map(|i| 0.5 * (got.force[i] + got.force[i - 1]) * (got.displacement[i] - got.displacement[i - 1]))
        .sum()
}

#[test]
fn over_closed_cycles_no_damper_gives_energy() {
    let mut random = Random::seeded(7);
    for round in 0..80 {
        let damper = any_damper(&mut random);
        let amplitude = random.between(1e-4, 0.03);
        let shape = if round % 3 == 0 { Shape::Triangle } else { Shape::Sine };
        let excitation = Excitation::new(shape, [amplitude, amplitude], [random.between(0.2, 20.0); 2], 6.0).unwrap();
        let samples = 6000;
        let name = format!("{} {:?} {excitation:?}", damper.description.name, damper.values);
        let got = ResponseSpec { damper, excitation, samples }.response().unwrap();
        let scale = largest(&got.force) * amplitude;
        // The last cycle, from zero to zero: what the springs hold at its ends is the same, and w has settled.
        let taken = work(&got, samples * 5 / 6);
        assert!(taken > -1e-6 * scale, "{name}: {taken} of {scale}");
    }
}

/// From rest, with all springs slack, the work done on a passive damper is never negative, whatever the motion.
#[test]
fn from_rest_no_damper_ever_gives_more_than_it_was_given() {
    let mut random = Random::seeded(11);
    for _ in 0..50 {
        let mut damper = any_damper(&mut random);
        for (name, value) in damper.description.on_gear {
            damper = damper.with(name, *value).unwrap();
        }
        let amplitude = [random.between(1e-4, 0.03), random.between(1e-4, 0.03)];
        let frequency = [random.between(0.2, 20.0), random.between(0.2, 20.0)];
        let shape = if random.once_in(2) { Shape::Triangle } else { Shape::Sine };
        let excitation = Excitation::new(shape, amplitude, frequency, 5.0).unwrap();
        let got = ResponseSpec { damper, excitation, samples: 6000 }.response().unwrap();
        let scale = largest(&got.force) * amplitude[0].max(amplitude[1]);
        let mut taken = 0.0;
        for i in 1..got.force.len() {
            taken += 0.5 * (got.force[i] + got.force[i - 1]) * (got.displacement[i] - got.displacement[i - 1]);
            assert!(taken > -1e-5 * scale, "after {i}: {taken} of {scale}");
        }
    }
}

#[test]
fn energy_and_storage_balance_under_two_frequencies() {
    // Ẇ ≤ αzẋ for every motion, here of two frequencies that never close: W by its own integral, z by the closed form.
    let mut random = Random::seeded(3);
    for _ in 0..200 {
        let (n, gamma) = ([1.0, 2.0][(random.unit() * 2.0) as usize], random.between(0.1, 1.0));
        let beta = gamma * random.between(-0.95, 3.0);
        let element = damper::Hysteresis::new(gamma, beta, n, random.between(0.5, 2.0));
        let stored = |z: f64| {
            let (steps, h) = (200, z.abs() / 200.0);
            let part = |s: f64| s / (element.amplitude() - (beta - gamma) * s.powf(n));
            (0..steps).map(|i| h * part((f64::from(i) + 0.5) * h)).sum::<f64>()
        };
        let [a, b] = [random.between(0.1, 5.0), random.between(0.1, 5.0)];
        let x = |t: f64| a * t.sin() + b * (std::f64::consts::SQRT_2 * t).sin();
        let (mut z, mut given) = (0.0, 0.0);
        for i in 1..4000 {
            let dx = x(f64::from(i) * 0.01) - x(f64::from(i - 1) * 0.01);
            let next = element.moved(z, dx);
            // αz over the way by Simpson's rule.
            given += dx * (z + 4.0 * element.moved(z, 0.5 * dx) + next) / 6.0;
            z = next;
            if i % 50 == 0 {
                assert!(stored(z) <= given + 1e-3, "{n} {gamma} {beta}: {} of {given}", stored(z));
            }
        }
    }
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let field = |json: Json| ResponseSpec::read(&value(&json)).unwrap_err().field.clone();
    assert_eq!(field(json!({})), "damper");
    assert_eq!(field(json!({"damper": {}})), "damper.model");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen"}, "cycles": 0})), "cycles");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen"}, "cycles": 1e9})), "cycles");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen"}, "samples": 1e9})), "samples");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen", "command": -1}})), "damper.command");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen", "leverArm": 0}})), "damper.leverArm");
    assert_eq!(field(json!({"damper": {"model": "modified-bouc-wen-cubic", "command": 0}})), "damper.command");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen", "parameters": {"gamma": -1}}})), "damper.parameters.gamma");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen"}, "excitation": {"amplitude": 0}})), "excitation.amplitude");
    assert_eq!(field(json!({"damper": {"model": "bouc-wen"}, "excitation": {"shape": "saw"}})), "excitation.shape");
    // Extreme, and yet it ends: with an answer or with a word.
    for model in damper::list() {
        for (amplitude, frequency) in [(1e-9, 1e-6), (1e6, 1e6), (1e12, 1e-9), (1e-12, 1e12)] {
            let spec = spec(&json!({"damper": {"model": model.name}, "samples": 20, "cycles": 1,
                "excitation": {"amplitude": amplitude, "frequency": frequency}}));
            if let Ok(got) = spec.response() {
                assert!(got.force.iter().all(|force| force.is_finite()));
            }
        }
    }
}
