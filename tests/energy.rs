//! Where a swing's energy comes from and where it goes, against integrals taken another way.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{linear, random::Random};
use shimmy::{
    Run,
    energy::Energy,
    model::{Model, System, Torsional, TorsionalLinear},
};

fn gear(parameters: &[(&str, f64)], psi: f64) -> Run {
    linear::gear(parameters).starting("torsionAngle", psi).unwrap()
}

/// The run from the first point of the orbit that it goes to, to a tight tolerance, and the period.
fn on_the_cycle(run: &Run) -> (Run, f64) {
    let outlook = run.clone().within(1e-11).unwrap().outlook().unwrap();
    let names = ["torsionAngle", "torsionRate", "lateralDeformation"];
    let start = names
        .iter()
        .zip(&outlook.orbit.states)
        .fold(run.clone(), |run, (name, column)| run.starting(name, column[0]).unwrap());
    (start, 1.0 / outlook.frequency.unwrap())
}

fn assert_balanced(energy: &Energy, relative: f64) {
    let out = energy.damper + energy.tread_width + energy.stored;
    let size = energy.tire.abs() + energy.damper + energy.tread_width;
    assert!((energy.tire - out).abs() <= relative * size, "{energy:?}: {} comes out", out);
}

#[test]
fn on_the_limit_cycle_what_comes_in_goes_out() {
    for (v, c, gap) in [(80.0, 20.0, 0.0), (80.0, 10.0, 0.0), (40.0, 20.0, 0.0), (50.0, 100.0, 0.01)] {
        let run = gear(&[("velocity", v), ("dampingConstant", c), ("freeplayAngle", gap)], 0.05);
        let (cycle, period) = on_the_cycle(&run);
        let energy = cycle.energy().unwrap().unwrap();
        assert!((energy.duration / period - 1.0).abs() < 1e-7, "{} for {period} s", energy.duration);
        let out = energy.damper + energy.tread_width;
        assert!((energy.tire / out - 1.0).abs() < 1e-6, "v = {v}, c = {c}: {energy:?}");
        assert!(energy.stored.abs() < 1e-6 * out);
        assert_balanced(&energy, 1e-8);
    }
}

/// By Parseval: over a period of a cycle the mean of ψ̇² is half the sum of its squared Fourier amplitudes. As the motion is
/// sampled evenly over a whole period, the mean of the samples is that, to the accuracy of the samples: a sum over a period
/// converges faster than any power of their number, up to the kinks (h⁴ for ψ̇, whose second derivative jumps).
#[test]
fn dissipation_is_the_mean_square_rate_of_evenly_sampled_motion() {
    let (v, c) = (80.0, 20.0);
    let (cycle, period) = on_the_cycle(&gear(&[("velocity", v), ("dampingConstant", c)], 0.05));
    let energy = cycle.energy().unwrap().unwrap();
    let samples = 4001;
    let motion =
        cycle.lasting(period).unwrap().sampled(samples as f64).unwrap().within(1e-12).unwrap().simulate().unwrap();
    let mean_square = motion.states[1][1..].iter().map(|rate| rate * rate).sum::<f64>() / (samples - 1) as f64;
    assert!((energy.damper / (c * mean_square * period) - 1.0).abs() < 1e-8, "{energy:?}");
    assert!((energy.tread_width / (270.0 / v * mean_square * period) - 1.0).abs() < 1e-8, "{energy:?}");
}

/// Simpson's rule over the equations as they are printed, on samples of a growing, a falling and a rattling motion.
#[test]
fn every_part_is_the_integral_of_its_power() {
    for (parameters, psi) in [
        ([("velocity", 80.0), ("dampingConstant", 20.0), ("freeplayAngle", 0.0)], 0.02),
        ([("velocity", 80.0), ("dampingConstant", 20.0), ("freeplayAngle", 0.0)], 0.4),
        ([("velocity", 80.0), ("dampingConstant", 60.0), ("freeplayAngle", 0.0)], 0.3),
        ([("velocity", 50.0), ("dampingConstant", 100.0), ("freeplayAngle", 0.0174)], 0.1),
    ] {
        let run = gear(&parameters, psi);
        let energy = run.energy().unwrap().unwrap();
        let (v, c) = (parameters[0].1, parameters[1].1);
        let intervals = 200_000;
        let motion = run.clone().lasting(energy.duration).unwrap().within(1e-12).unwrap();
        let motion = motion.sampled(f64::from(intervals + 1)).unwrap().simulate().unwrap();
        let simpson = |power: &dyn Fn(f64, f64) -> f64| {
            let last = intervals as usize;
            let sum: f64 = (0..=last)
                .map(|i| {
                    let weight = if i == 0 || i == last { 1.0 } else { f64::from(2 + 2 * (i as u32 % 2)) };
                    weight * power(motion.states[1][i], motion.states[2][i])
                })
                .sum();
            sum * energy.duration / f64::from(3 * intervals)
        };
        // theory.md, section 1, with the default constants.
        let tire = simpson(&|rate, y| {
            let alpha = (y / 0.3).atan();
            let force = 180_000.0 * alpha.clamp(-5_f64.to_radians(), 5_f64.to_radians());
            let limit = 10_f64.to_radians();
            let moment = if alpha.abs() > limit {
                0.0
            } else {
                -18_000.0 * limit / std::f64::consts::PI * (std::f64::consts::PI * alpha / limit).sin()
            };
            (moment - 0.1 * force) * rate
        });
        let damper = simpson(&|rate, _| c * rate * rate);
        let tread = simpson(&|rate, _| 270.0 / v * rate * rate);
        let size = damper + tread;
        // The motion itself, over a cycle at rtol 1e-8, and Simpson's rule at kinks of the second derivative.
        for (got, expected) in [(energy.tire, tire), (energy.damper, damper), (energy.tread_width, tread)] {
            assert!((got - expected).abs() < 2e-8 * size, "{parameters:?}: {energy:?}, {expected} by Simpson's rule");
        }
        assert_balanced(&energy, 1e-8);
    }
}

#[test]
fn every_method_and_tolerance_serves() {
    let run = gear(&[("velocity", 80.0), ("dampingConstant", 20.0)], 0.1);
    let exact = run.clone().within(1e-12).unwrap().energy().unwrap().unwrap();
    for (method, rtol, error) in [
        ("auto", 1e-8, 1e-8),
        ("dop853", 1e-10, 1e-9),
        ("dormand-prince", 1e-8, 1e-6),
        ("rodas", 1e-8, 1e-6),
        ("rk4", 1e-8, 1e-4),
        ("auto", 1e-4, 1e-3),
    ] {
        let energy = run.clone().by(method).unwrap().within(rtol).unwrap().energy().unwrap().unwrap();
        assert!((energy.tire / exact.tire - 1.0).abs() < error, "{method} at {rtol}: {energy:?} {exact:?}");
    }
}

#[test]
fn the_linear_gear_has_its_account_too() {
    let run =
        Run::of("torsional-linear").unwrap().with("velocity", 80.0).unwrap().with("dampingConstant", 48.530).unwrap();
    let energy = run.starting("torsionAngle", 0.05).unwrap().energy().unwrap().unwrap();
    assert_balanced(&energy, 1e-8);
    // At the critical damping the swing is kept up, but for its first cycle's other eigenvector.
    assert!(energy.tire > 0.0 && energy.duration > 0.0);
}

#[test]
fn a_duration_that_is_given_counts() {
    let run = gear(&[("velocity", 80.0), ("dampingConstant", 20.0)], 0.1);
    let whole = run.clone().lasting(0.05).unwrap().energy().unwrap().unwrap();
    assert_eq!(whole.duration, 0.05);
    assert_eq!(run.clone().at(vec![0.0, 0.01, 0.05]).unwrap().energy().unwrap().unwrap(), whole);
    // Parts of the way add up to the whole.
    let middle = run.clone().at(vec![0.02]).unwrap().simulate().unwrap();
    let names = ["torsionAngle", "torsionRate", "lateralDeformation"];
    let rest = names.iter().zip(&middle.states).fold(run.clone(), |run, (name, x)| run.starting(name, x[0]).unwrap());
    let (first, second) = (run.lasting(0.02).unwrap(), rest.lasting(0.03).unwrap());
    let (first, second) = (first.energy().unwrap().unwrap(), second.energy().unwrap().unwrap());
    assert!((first.tire + second.tire - whole.tire).abs() < 1e-7 * whole.tire.abs());
    assert!((first.stored + second.stored - whole.stored).abs() < 1e-7 * whole.damper);
}

#[test]
fn what_does_not_swing_has_no_cycle() {
    assert_eq!(gear(&[], 0.0).energy().unwrap(), None);
    // A linear gear that turns round without a swing.
    let leading = Run::of("torsional-linear").unwrap().with("casterLength", -0.9).unwrap();
    assert_eq!(leading.starting("torsionAngle", 0.1).unwrap().energy().unwrap(), None);
    let nothing = gear(&[], 0.0).lasting(1.0).unwrap().energy().unwrap().unwrap();
    assert_eq!(nothing, Energy { duration: 1.0, ..Energy::default() });
}

/// The laws one by one add up to the model's own right-hand side.
fn assert_laws_are_the_model<M: Model<3>>() {
    let mut random = Random::seeded(6);
    for _ in 0..2_000 {
        let values: Vec<f64> = M::PARAMETERS.iter().map(|p| random.between(p.min, p.max)).collect();
        let x: [f64; 3] = std::array::from_fn(|i| 3.0 * M::STATE[i].scale * random.between(-1.0, 1.0));
        let (system, laws) = (M::new(&values), M::laws(&values).unwrap());
        let rate = system.rate(0.0, system.mode(0.0, &x), &x);
        let (power, forces) = (laws.power(&x), laws.forces(&x).unwrap());
        let moment = (power.tire - power.damper - power.tread_width) / x[1] + forces.spring_torque;
        let size = (power.tire.abs() + power.damper + power.tread_width) / x[1].abs() + forces.spring_torque.abs();
        assert!((laws.moment_of_inertia * rate[1] - moment).abs() < 1e-13 * size, "{values:?} {x:?}");
        assert!(
            (power.tire - (forces.aligning_moment - laws.caster_length * forces.side_force) * x[1]).abs()
                < 1e-13 * size * x[1].abs()
        );
    }
}

#[test]
fn the_laws_one_by_one_add_up_to_the_model() {
    assert_laws_are_the_model::<Torsional>();
    assert_laws_are_the_model::<TorsionalLinear>();
}
