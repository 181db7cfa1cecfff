//! Linear theory: published critical values, and the closed form against the eigenvalues of the model's own Jacobian.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{linear::gear, random::Random};
use nalgebra::Matrix3;
use shimmy::{
    Run,
    model::{Model, System, Torsional, TorsionalLinear},
    parameter::Parameter,
    real::Dual,
    stability::{EndKind, UnstableInterval, Variation},
};

fn assert_near(got: &[f64], expected: &[f64], relative: f64) {
    assert_eq!(got.len(), expected.len(), "{got:?} {expected:?}");
    for (got, expected) in got.iter().zip(expected) {
        assert!((got / expected - 1.0).abs() < relative, "{got} {expected}");
    }
}

/// The Jacobian at rest, from the right-hand side by dual numbers: nothing of the closed form is in it.
fn jacobian<M: Model<3>>(values: &[f64]) -> Matrix3<f64> {
    let system = M::new(values);
    let at_rest = std::array::from_fn(|i| Dual::<3>::variable(0.0, i));
    let rates = system.rate(Dual::from(0.0), system.mode(0.0, &[0.0; 3]), &at_rest);
    Matrix3::from_fn(|row, column| rates[row].slope[column])
}

fn eigenvalues<M: Model<3>>(values: &[f64]) -> [nalgebra::Complex<f64>; 3] {
    jacobian::<M>(values).complex_eigenvalues().into()
}

/// The largest growth rate at rest, and the size of the eigenvalues by which its error is measured.
fn growth<M: Model<3>>(values: &[f64]) -> (f64, f64) {
    let eigenvalues = eigenvalues::<M>(values);
    let largest = eigenvalues.iter().fold(f64::NEG_INFINITY, |most, value| most.max(value.re));
    (largest, eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.norm())))
}

fn run_with(model: &str, table: &[Parameter], values: &[f64]) -> Run {
    table.iter().zip(values).fold(Run::of(model).unwrap(), |run, (p, value)| run.with(p.name, *value).unwrap())
}

/// Within the sliders' ranges, at times at an end of one; a third of the gears has freeplay.
fn random_values(random: &mut Random, table: &[Parameter]) -> Vec<f64> {
    table
        .iter()
        .map(|parameter| match parameter.name {
            "freeplayAngle" if !random.once_in(3) => 0.0,
            _ if random.once_in(12) => parameter.min,
            _ if random.once_in(12) => parameter.max,
            _ => random.between(parameter.min, parameter.max),
        })
        .collect()
}

/// theory.md, section 2: computed independently of this project, twice.
#[test]
fn published_critical_values_are_met() {
    let speeds = |c: f64| gear(&[("dampingConstant", c)]).routh_hurwitz().unwrap().critical_velocities;
    // Half a unit of the last digit given.
    assert_near(&speeds(0.0), &[15.2593], 4e-6);
    assert_near(&speeds(10.0), &[20.511, 1040.97], 3e-5);
    assert_near(&speeds(20.0), &[27.600, 501.75], 2e-5);
    assert_near(&speeds(30.0), &[37.263, 311.77], 2e-5);
    assert_near(&speeds(40.0), &[51.881, 205.13], 3e-5);
    // They meet at c = 49.7927 and v = 100.70.
    assert_near(&speeds(49.7926), &[100.70, 100.70], 3e-3);
    assert!(speeds(49.7928).is_empty());

    let damping = |v: f64| gear(&[("velocity", v)]).routh_hurwitz().unwrap().critical_damping.unwrap();
    assert_near(&[damping(30.0), damping(80.0)], &[22.808, 48.530], 3e-5);
    assert_near(&[damping(100.70)], &[49.7927], 1e-6);
}

#[test]
fn freeplay_leaves_the_spring_out() {
    // theory.md, section 4: at c = 100 the gear in its gap is unstable exactly for 3.196 < v < 73.041 m/s.
    let in_the_gap = gear(&[("velocity", 50.0), ("dampingConstant", 100.0), ("freeplayAngle", 0.01)]);
    let theory = in_the_gap.routh_hurwitz().unwrap();
    assert!(!theory.stable);
    assert_near(&theory.critical_velocities, &[3.196, 73.041], 2e-4);
    let without_spring = gear(&[("velocity", 50.0), ("dampingConstant", 100.0), ("torsionalStiffness", 0.0)]);
    assert_eq!(without_spring.routh_hurwitz().unwrap(), theory);
    assert!(gear(&[("velocity", 50.0), ("dampingConstant", 100.0)]).routh_hurwitz().unwrap().stable);
}

#[test]
fn an_undamped_trailing_wheel_is_stable_by_its_geometry_alone() {
    // Pacejka's condition (theory.md 8.1): e > σ + a = 0.4, or e < −t = −0.1 and above −t − k/(c_Fα F_z) = −0.6556.
    let stable = |e: f64, v: f64| {
        let undamped = [("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)];
        let theory = gear(&undamped).with("casterLength", e).unwrap().with("velocity", v).unwrap().routh_hurwitz();
        let theory = theory.unwrap();
        assert!(theory.critical_velocities.is_empty(), "no speed matters");
        theory.stable
    };
    for v in [1.0, 30.0, 300.0] {
        for (e, expected) in
            [(0.41, true), (0.39, false), (0.0, false), (-0.09, false), (-0.11, true), (-0.65, true), (-0.66, false)]
        {
            assert_eq!(stable(e, v), expected, "e = {e}, v = {v}");
        }
    }
}

#[test]
fn degenerate_gears_have_their_verdict() {
    // A wheel on a frictionless ground swings on its spring, damped or not, or turns freely.
    let unloaded = gear(&[("verticalForce", 0.0)]).routh_hurwitz().unwrap();
    assert!(unloaded.stable && unloaded.critical_velocities.is_empty() && unloaded.critical_damping.is_none());
    let undamped = gear(&[("verticalForce", 0.0), ("dampingConstant", 0.0), ("treadWidthMomentConstant", 0.0)]);
    assert!(!undamped.routh_hurwitz().unwrap().stable, "on the axis is not left of it");
    assert!(!gear(&[("verticalForce", 0.0), ("torsionalStiffness", 0.0)]).routh_hurwitz().unwrap().stable);
    // Without an aligning moment and with the contact centre on the axis the tire does not steer.
    let idle = gear(&[("aligningMomentDerivative", 0.0), ("casterLength", 0.0)]).routh_hurwitz().unwrap();
    assert!(idle.stable && idle.critical_velocities.is_empty() && idle.critical_damping.is_none());
    // A wheel far ahead of its axis turns round: a real eigenvalue, no pair, at whatever speed and damping.
    let leading = gear(&[("casterLength", -0.9)]).routh_hurwitz().unwrap();
    assert!(!leading.stable && leading.column[3] < 0.0);
    assert!(leading.critical_velocities.is_empty() && leading.critical_damping.is_none());
}

#[test]
fn extreme_numbers_are_refused_in_words() {
    let error = gear(&[("velocity", 1e-310), ("treadWidthMomentConstant", 1e12)]).routh_hurwitz().unwrap_err();
    assert_eq!(error.code.name(), "not-finite");
}

fn assert_agrees_with_eigenvalues<M: Model<3>>() {
    let mut random = Random::seeded(3);
    let (mut stable, mut crossings) = (0, 0);
    for _ in 0..3_000 {
        let values = random_values(&mut random, M::PARAMETERS);
        let run = run_with(M::NAME, M::PARAMETERS, &values);
        let theory = run.routh_hurwitz().unwrap();
        let (rate, size) = growth::<M>(&values);
        // Rounding of the eigenvalues; nearer than that to the axis nobody can tell.
        if rate.abs() > 1e-11 * size {
            assert_eq!(theory.stable, rate < 0.0, "{values:?}: growth {rate}");
            stable += usize::from(theory.stable);
        }
        // The coefficients of the characteristic polynomial are the trace, the principal minors and the determinant.
        let matrix = jacobian::<M>(&values);
        let minors: f64 = (0..3).map(|i| matrix.remove_row(i).remove_column(i).determinant()).sum();
        let (a2, a1, a0) = (-matrix.trace(), minors, -matrix.determinant());
        let expected = [1.0, a2, a1 - a0 / a2, a0];
        let scales = [1.0, size, size.powi(2) + (a0 / a2).abs(), size.powi(3)];
        for i in 0..4 {
            let apart = (theory.column[i] - expected[i]).abs();
            assert!(apart <= 1e-12 * scales[i], "{values:?}: {:?} {expected:?}", theory.column);
        }
        let at = |name: &str, value: f64| {
            let mut values = values.clone();
            values[M::PARAMETERS.iter().position(|p| p.name == name).unwrap()] = value;
            eigenvalues::<M>(&values)
        };
        let velocities = theory.critical_velocities.iter().map(|v| ("velocity", *v));
        let dampings = theory.critical_damping.iter().map(|c| ("dampingConstant", *c));
        for (name, value) in velocities.chain(dampings) {
            let (lambda, size) = pair(&at(name, value));
            assert!(lambda.re.abs() < 1e-9 * size, "{values:?}: at {name} {value} a pair at {lambda}");
            crossings += 1;
        }
    }
    assert!(stable > 500 && crossings > 1_000, "{stable} stable gears, {crossings} crossings seen");
}

/// The eigenvalue with the largest imaginary part, and the size of the largest.
fn pair(eigenvalues: &[nalgebra::Complex<f64>; 3]) -> (nalgebra::Complex<f64>, f64) {
    let pair = eigenvalues.iter().copied().max_by(|a, b| a.im.total_cmp(&b.im)).unwrap();
    assert!(pair.im > 0.0, "{eigenvalues:?} has no pair");
    (pair, eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.norm())))
}

#[test]
fn the_closed_form_agrees_with_the_eigenvalues_of_the_torsional_gear() {
    assert_agrees_with_eigenvalues::<Torsional>();
}

#[test]
fn the_closed_form_agrees_with_the_eigenvalues_of_the_linear_gear() {
    assert_agrees_with_eigenvalues::<TorsionalLinear>();
}

/// Every crossing that a fine scan of the growth rate sees is an end of an interval, and the other way round.
#[test]
fn intervals_are_those_of_a_scan() {
    let table = Torsional::PARAMETERS;
    let mut random = Random::seeded(4);
    let mut boundaries = 0;
    for case in 0..1_500 {
        let values = random_values(&mut random, table);
        let index = case % table.len();
        let Parameter { name, min, max, .. } = table[index];
        let (from, to) = if random.once_in(2) { (min, max) } else { range_within(&mut random, min, max) };
        let run = run_with("torsional", table, &values);
        let intervals = run.unstable_intervals(&Variation::of(name, from, to)).unwrap();
        let growth_at = |x: f64| {
            let mut values = values.clone();
            values[index] = x;
            growth::<Torsional>(&values)
        };
        assert_in_order(&intervals, from, to);
        for i in 0..=60 {
            // Not the ends themselves: with freeplay of 0 the gear is another one than with a little.
            let x = from + (to - from) * (i as f64 + 0.5) / 61.0;
            let (rate, size) = growth_at(x);
            if rate.abs() > 1e-10 * size {
                let said = intervals.iter().any(|interval| (interval.from..=interval.to).contains(&x));
                assert_eq!(said, rate > 0.0, "{name} = {x} of {values:?}: growth {rate}, {intervals:?}");
            }
        }
        for (at, kind) in intervals.iter().flat_map(|i| [(i.from, i.from_kind), (i.to, i.to_kind)]) {
            let mut values = values.clone();
            values[index] = at;
            let eigenvalues = eigenvalues::<Torsional>(&values);
            let size = eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
            match kind {
                EndKind::Range => assert!(at == from || at == to),
                EndKind::Hopf => assert!(pair(&eigenvalues).0.re.abs() < 1e-9 * size, "{name} = {at}: {eigenvalues:?}"),
                EndKind::Divergence => {
                    let least = eigenvalues.iter().fold(f64::INFINITY, |least, value| least.min(value.norm()));
                    assert!(least < 1e-9 * size, "{name} = {at}: {eigenvalues:?}");
                }
            }
            boundaries += usize::from(kind != EndKind::Range);
        }
    }
    assert!(boundaries > 300, "only {boundaries} boundaries seen");
}

fn range_within(random: &mut Random, min: f64, max: f64) -> (f64, f64) {
    let (a, b) = (random.between(min, max), random.between(min, max));
    (a.min(b), a.max(b))
}

fn assert_in_order(intervals: &[UnstableInterval], from: f64, to: f64) {
    let mut last = from;
    for (i, interval) in intervals.iter().enumerate() {
        assert!(interval.from <= interval.to && interval.to <= to);
        assert!(if i == 0 { interval.from >= last } else { interval.from > last }, "{intervals:?}");
        last = interval.to;
    }
}

#[test]
fn a_sliver_is_not_missed() {
    // The speeds between which the gear shimmies meet at c = 49.7927 and v = 100.70: a little below, less than 1 cm/s of
    // the 119 m/s is left.
    let critical = gear(&[("velocity", 100.7)]).routh_hurwitz().unwrap().critical_damping.unwrap();
    let run = gear(&[("dampingConstant", critical - 1e-12)]);
    let [sliver] = run.unstable_intervals(&Variation::of("velocity", 1.0, 120.0)).unwrap()[..] else { panic!() };
    assert!(sliver.from < 100.7 && 100.7 < sliver.to && sliver.to - sliver.from < 1e-2, "{sliver:?}");
    assert_eq!((sliver.from_kind, sliver.to_kind), (EndKind::Hopf, EndKind::Hopf));
    assert_near(&[sliver.from, sliver.to], &run.routh_hurwitz().unwrap().critical_velocities, 1e-8);
}

#[test]
fn what_does_not_enter_gives_all_or_nothing() {
    let of = |c: f64, name: &str, from: f64, to: f64| {
        let run = gear(&[("velocity", 80.0), ("dampingConstant", c)]);
        run.unstable_intervals(&Variation::of(name, from, to)).unwrap()
    };
    for name in ["sideForceLimitAngle", "aligningMomentLimitAngle"] {
        assert_eq!(of(60.0, name, 0.1, 0.2), []);
        let (from, to, range) = (0.1, 0.2, EndKind::Range);
        assert_eq!(of(20.0, name, 0.1, 0.2), [UnstableInterval { from, to, from_kind: range, to_kind: range }]);
    }
    // Freeplay enters by being there: at 80 m/s the gear with c = 60 is stable with its spring and not without.
    assert_eq!(of(60.0, "freeplayAngle", 0.0, 0.0), []);
    assert_eq!(of(60.0, "freeplayAngle", 0.0, 0.05).len(), 1);
    assert_eq!(of(60.0, "freeplayAngle", 0.01, 0.01).len(), 1);
}

#[test]
fn what_is_linked_follows() {
    let table = Torsional::PARAMETERS;
    let index = |name: &str| table.iter().position(|p| p.name == name).unwrap();
    let mut random = Random::seeded(5);
    let mut different = 0;
    for case in 0..300 {
        let values = random_values(&mut random, table);
        let name = ["halfContactLength", "verticalForce", "sideForceDerivative"][case % 3];
        let Parameter { min, max, .. } = table[index(name)];
        let run = run_with("torsional", table, &values);
        let alone = Variation::of(name, min, max);
        let linked =
            Variation { relaxation_length_follows: true, tread_width_moment_constant_follows: true, ..alone.clone() };
        let intervals = run.unstable_intervals(&linked).unwrap();
        different += usize::from(intervals != run.unstable_intervals(&alone).unwrap());
        for i in 0..40 {
            let x = min + (max - min) * (i as f64 + 0.5) / 40.0;
            let mut values = values.clone();
            values[index(name)] = x;
            let of = |name: &str| values[index(name)];
            let (a, stiffness) = (of("halfContactLength"), of("sideForceDerivative") * of("verticalForce"));
            if name == "halfContactLength" {
                values[index("relaxationLength")] = 3.0 * a;
            }
            values[index("treadWidthMomentConstant")] = 0.15 * a * a * stiffness;
            let (rate, size) = growth::<Torsional>(&values);
            if rate.abs() > 1e-10 * size {
                let said = intervals.iter().any(|interval| (interval.from..=interval.to).contains(&x));
                assert_eq!(said, rate > 0.0, "{name} = {x} of {values:?}: growth {rate}, {intervals:?}");
            }
        }
    }
    assert!(different > 100, "{different}");
}

#[test]
fn a_bad_range_is_refused() {
    let run = gear(&[]);
    let refused = |name: &str, from: f64, to: f64| run.unstable_intervals(&Variation::of(name, from, to)).unwrap_err();
    let error = refused("velocty", 1.0, 2.0);
    assert_eq!((error.field.as_str(), error.suggestion), ("parameter", Some("velocity")));
    assert_eq!(refused("velocity", 0.0, 2.0).to_string(), "from must be > 0 m/s, got 0");
    assert_eq!(refused("velocity", 1.0, f64::NAN).field, "to");
    assert_eq!(refused("velocity", 3.0, 2.0).to_string(), "to must be ≥ 3 (from), got 2");
}
