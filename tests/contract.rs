//! What every listed model keeps, and every table.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::collections::HashSet;

use common::random::Random;
use shimmy::{
    Run,
    integrate::methods,
    model::{self, Model, System},
    parameter::Scale,
    real::Dual,
};

/// Parameters within their ranges, every second one at an end of its range.
fn random_values<M: Model<N>, const N: usize>(random: &mut Random) -> Vec<f64> {
    M::PARAMETERS
        .iter()
        .map(|parameter| match random.between(0.0, 4.0) as u32 {
            0 => parameter.min,
            1 => parameter.max,
            _ => random.between(parameter.min, parameter.max),
        })
        .collect()
}

/// A state of some typical sizes, at times on an axis, at times far away.
fn random_state<M: Model<N>, const N: usize>(random: &mut Random) -> [f64; N] {
    std::array::from_fn(|i| {
        let size = M::STATE[i].scale;
        match random.between(0.0, 4.0) as u32 {
            0 => 0.0,
            1 => random.between(-30.0 * size, 30.0 * size),
            _ => random.between(-2.0 * size, 2.0 * size),
        }
    })
}

fn assert_rates_and_slopes<M: Model<N>, const N: usize>() {
    let mut random = Random::seeded(1);
    for _ in 0..2_000 {
        let values = random_values::<M, N>(&mut random);
        let (system, x) = (M::new(&values), random_state::<M, N>(&mut random));
        let mode = system.mode(0.0, &x);
        let at = |x: &[f64; N]| system.rate(0.0, mode, x);
        let rate = at(&x);
        assert!(rate.iter().all(|rate| rate.is_finite()), "{} {values:?} {x:?}: {rate:?}", M::NAME);

        let exact = system.jacobian(0.0, mode, &x);
        let seeded: [Dual<N>; N] = std::array::from_fn(|i| Dual::variable(x[i], i));
        assert_eq!(system.rate(Dual::from(0.0), mode, &seeded).map(|row| row.value), rate);
        for column in 0..N {
            // A step of h = 1e-4 sizes: truncation of h²/6 of the law's bend, and rounding of ε |rate|/h, against the
            // largest slope of the row that the state can bring about.
            let h = 1e-4 * M::STATE[column].scale;
            let moved = |by: f64| {
                let mut x = x;
                x[column] += by;
                at(&x)
            };
            let (ahead, behind) = (moved(h), moved(-h));
            for row in 0..N {
                let difference = (ahead[row] - behind[row]) / (2.0 * h);
                let rounding = 1e-15 * (ahead[row].abs() + exact[row][column].abs() * x[column].abs()) / h;
                let largest = exact[row][column].abs().max(difference.abs());
                let apart = (exact[row][column] - difference).abs();
                assert!(
                    apart <= 1e-4 * largest + 100.0 * rounding,
                    "{} {values:?} {x:?}: ∂{row}/∂{column} = {} by dual numbers, {difference} by differences",
                    M::NAME,
                    exact[row][column]
                );
            }
        }
    }
}

/// The equilibrium is one, and the Jacobian there is that of the system that moves.
fn assert_linearised_at_rest<M: Model<N>, const N: usize>() {
    let mut random = Random::seeded(3);
    for _ in 0..2_000 {
        let values = random_values::<M, N>(&mut random);
        let run = M::PARAMETERS.iter().zip(&values);
        let run = run.fold(Run::of(M::NAME).unwrap(), |run, (p, value)| run.with(p.name, *value).unwrap());
        let (linear, system) = (run.linearised().unwrap(), M::new(&values));
        let x: [f64; N] = std::array::from_fn(|i| linear.equilibrium[i]);
        let mode = system.mode(0.0, &x);
        let (rates, rows) = (system.rate(0.0, mode, &x), system.jacobian(0.0, mode, &x));
        for row in 0..N {
            // Rounding of the terms, and of a law that is fitted to it.
            let scale = |i: usize| rows[row][i].abs() * M::STATE[i].scale;
            let size = (0..N).map(scale).fold(0.0, f64::max);
            assert!(rates[row].abs() <= 1e-14 * size, "{} {values:?}: {rates:?}", M::NAME);
            for column in 0..N {
                let apart = (linear.jacobian[(row, column)] - rows[row][column]).abs();
                assert!(apart <= 1e-13 * rows[row][column].abs(), "{} {values:?}: {rows:?}", M::NAME);
            }
        }
    }
}

fn assert_sides_hold_where_they_are_said_to<M: Model<N>, const N: usize>() {
    let mut random = Random::seeded(2);
    for _ in 0..2_000 {
        let system = M::new(&random_values::<M, N>(&mut random));
        let x = random_state::<M, N>(&mut random);
        let mode = system.mode(0.0, &x);
        for which in 0..<M::System as System<N>>::SWITCHES {
            let Some(value) = system.switch(which, 0.0, mode, &x) else { continue };
            assert!(value >= 0.0, "{}: switch {which} says {value} in the mode chosen at {x:?}", M::NAME);
            let mut there = x;
            let across = system.cross(which, 0.0, mode, &mut there);
            assert_ne!(across, mode);
            assert_eq!(system.cross(which, 0.0, across, &mut there), mode, "the way back is the same switch");
            assert_eq!(there, x, "no law of these holds a state");
            let beyond = system.switch(which, 0.0, across, &x).expect("the same surface seen from its other side");
            assert_eq!(beyond, -value);
            // The laws are continuous: on the surface both sides say the same. Off it they part as the distance does.
            let kind = system.event_kind(which);
            assert!(kind < <M::System as System<N>>::EVENT_KINDS.len());
        }
    }
}

#[test]
fn rates_are_finite_and_dual_numbers_agree_with_differences() {
    macro_rules! each {
        ($($n:literal, $model:ty;)*) => { $(assert_rates_and_slopes::<$model, $n>();)* };
    }
    shimmy::for_each_model!(each);
}

#[test]
fn the_linearisation_is_that_of_the_equations() {
    macro_rules! each {
        ($($n:literal, $model:ty;)*) => { $(assert_linearised_at_rest::<$model, $n>();)* };
    }
    shimmy::for_each_model!(each);
}

#[test]
fn modes_hold_where_they_are_chosen() {
    macro_rules! each {
        ($($n:literal, $model:ty;)*) => { $(assert_sides_hold_where_they_are_said_to::<$model, $n>();)* };
    }
    shimmy::for_each_model!(each);
}

#[test]
fn tables_say_what_they_must() {
    let models = model::list();
    assert_unique("models", models.iter().map(|model| model.name));
    for model in models {
        let here = model.name;
        assert!(!model.title.is_empty());
        assert!(!model.state.is_empty());
        let parameters = model.parameters.iter().map(|parameter| parameter.name);
        assert_unique(here, parameters.chain(model.state.iter().map(|state| state.name)));
        assert_unique(here, model.parameters.iter().map(|parameter| parameter.symbol));
        assert_unique(here, model.state.iter().map(|state| state.symbol));
        assert_eq!([model.parameters, model.friction].concat().len(), model.table.len());
        for parameter in model.table {
            let name = parameter.name;
            name.split('.').for_each(assert_camel_case);
            assert!(parameter.min < parameter.max, "{here}.{name}");
            assert!((parameter.min..=parameter.max).contains(&parameter.default), "{here}.{name}");
            for value in [parameter.min, parameter.default, parameter.max] {
                assert_eq!(parameter.check(value), Ok(value), "{here}.{name}: its slider leaves what is valid");
            }
            assert!(parameter.scale == Scale::Linear || parameter.min > 0.0, "{here}.{name}: no logarithm of 0");
            assert!(!parameter.symbol.is_empty() && !parameter.unit.is_empty());
            assert!(parameter.doc.contains(parameter.symbol), "{here}.{name}: its doc does not say where it enters");
            let years = parameter.doc.split(|c: char| !c.is_ascii_digit()).filter(|digits| digits.len() == 4);
            assert_eq!(years.count(), 1, "{here}.{name}: its doc names no source");
        }
        for state in model.state {
            assert_camel_case(state.name);
            assert!(state.scale > 0.0 && state.scale.is_finite());
            assert!(!state.doc.is_empty() && !state.symbol.is_empty() && !state.unit.is_empty());
        }
        assert_eq!(model.defaults().len(), model.table.len());
    }
}

#[test]
fn methods_say_what_they_are() {
    let methods = methods();
    assert_unique("methods", methods.iter().map(|method| method.name));
    for method in methods {
        assert!(!method.title.is_empty() && method.doc.len() > 20);
        assert_eq!(method.order == 0, method.name == "auto");
        assert_eq!(method.adaptive, method.name != "rk4");
    }
}

fn assert_unique<'a>(place: &str, names: impl Iterator<Item = &'a str>) {
    let mut seen = HashSet::new();
    for name in names {
        assert!(seen.insert(name), "{place}: {name} is there twice");
    }
}

fn assert_camel_case(name: &str) {
    assert!(name.starts_with(|c: char| c.is_ascii_lowercase()), "{name}");
    assert!(name.chars().all(|c| c.is_ascii_alphanumeric()), "{name}");
}
