//! Runs of gears, by name or at random, for linear theory.

use nalgebra::Complex;
use shimmy::Run;

use super::random::Random;

pub fn gear(parameters: &[(&str, f64)]) -> Run {
    gear_of("torsional", parameters)
}

pub fn gear_of(model: &str, parameters: &[(&str, f64)]) -> Run {
    parameters.iter().fold(Run::of(model).unwrap(), |run, (name, value)| run.with(name, *value).unwrap())
}

/// Within the sliders' ranges, at times at an end of one; a third of the gears that can have freeplay has it.
pub fn random_gear(random: &mut Random, model: &str) -> Run {
    let table = Run::of(model).unwrap().description().parameters;
    table.iter().fold(Run::of(model).unwrap(), |run, parameter| {
        let value = match parameter.name {
            "freeplayAngle" if !random.once_in(3) => 0.0,
            _ if random.once_in(12) => parameter.min,
            _ if random.once_in(12) => parameter.max,
            _ => random.between(parameter.min, parameter.max),
        };
        run.with(parameter.name, value).unwrap()
    })
}

pub fn value_of(run: &Run, name: &str) -> f64 {
    run.parameters()[run.description().parameters.iter().position(|p| p.name == name).unwrap()]
}

pub fn largest(values: &[Complex<f64>]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.norm()))
}
