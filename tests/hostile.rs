//! Whatever is handed over as a run: it is carried out in finite numbers, or refused in words that name a field.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::hostile::{assert_finite, assert_speaks};
use proptest::prelude::*;
use shimmy::{
    Run,
    cycles::Guess,
    live::Simulator,
    model::laws::Curves,
    run::{MOST_SAMPLES, Value},
    spectrum::Series,
    stability::Variation,
};

/// A run that is damaged still ends after so many steps.
const STEPS: f64 = 2_000.0;

const RUN_KEYS: [&str; 15] = [
    "model",
    "parameters",
    "initial",
    "duration",
    "method",
    "rtol",
    "atol",
    "step",
    "times",
    "samples",
    "damper",
    "friction",
    "modle",
    "",
    "__proto__",
];

const PARAMETERS: [&str; 11] = [
    "velocity",
    "casterLength",
    "halfContactLength",
    "relaxationLength",
    "momentOfInertia",
    "torsionalStiffness",
    "dampingConstant",
    "verticalForce",
    "sideForceDerivative",
    "aligningMomentDerivative",
    "treadWidthMomentConstant",
];

/// Those of the nonlinear model only.
const LIMITS: [&str; 3] = ["sideForceLimitAngle", "aligningMomentLimitAngle", "freeplayAngle"];

const STATES: [&str; 3] = ["torsionAngle", "torsionRate", "lateralDeformation"];

const STRANGERS: [&str; 8] =
    ["velocity", "torsionAngle", "velocty", "", "🛬", "__proto__", "damper.command", "friction.moment"];

/// Numbers at the ends of what a double can say, those just past a limit, and any other bits.
fn number() -> impl Strategy<Value = f64> {
    let edges = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        f64::MIN_POSITIVE,
        1e-300,
        1e-30,
        f64::EPSILON,
        0.5,
        -1.0,
        1e12,
        1.000_000_1e12,
        9_007_199_254_740_993.0,
        1e155,
        1e308,
        f64::MAX,
        f64::MIN,
    ];
    prop_oneof![4 => prop::sample::select(edges.to_vec()), 1 => prop::num::f64::ANY, 2 => 1e-3..100.0]
}

fn text() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(vec![
            "torsional",
            "torsional-linear",
            "torsionl",
            "rk4",
            "rodas",
            "dop853",
            "12",
            "NaN",
            "\0",
            ""
        ])
        .prop_map(str::to_owned),
        any::<String>(),
        Just("x".repeat(100_000)),
    ]
}

fn value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Absent),
        any::<bool>().prop_map(Value::Bool),
        number().prop_map(Value::Number),
        text().prop_map(Value::Text),
        prop::collection::vec(number(), 0..5).prop_map(Value::Numbers),
        prop::collection::vec(text(), 1..3).prop_map(Value::Texts),
        Just(Value::Other("a function")),
    ];
    leaf.prop_recursive(4, 24, 4, |inner| {
        prop_oneof![
            any::<usize>().prop_map(Value::List),
            prop::collection::vec((key(&STRANGERS), inner), 0..4).prop_map(Value::Record),
        ]
    })
}

fn key(known: &[&'static str]) -> impl Strategy<Value = String> + use<> {
    prop::sample::select(known.to_vec()).prop_map(str::to_owned)
}

/// A number as a live motion may be given it, or any other.
fn amount() -> impl Strategy<Value = f64> {
    prop_oneof![2 => 0.0..0.02_f64, 1 => number()]
}

/// A name of a parameter or a state, or any other.
fn name() -> impl Strategy<Value = String> {
    key(&[PARAMETERS.as_slice(), &LIMITS, &STATES, &STRANGERS].concat())
}

/// Mostly a number as a gear may have it.
fn plausible() -> impl Strategy<Value = Value> {
    prop_oneof![12 => 1e-3..100.0_f64, 2 => -1.0..1.0_f64, 1 => number()].prop_map(Value::Number)
}

fn record(known: &[&'static str]) -> impl Strategy<Value = Value> + use<> {
    prop::collection::vec((key(known), plausible()), 0..5).prop_map(Value::Record)
}

/// A record that looks like a run, half of the time with something in it that does not belong there; the last key keeps
/// it short.
fn run_like() -> impl Strategy<Value = Value> {
    let nonlinear = [PARAMETERS.as_slice(), &LIMITS].concat();
    let model = prop_oneof![(Just("torsional"), record(&nonlinear)), (Just("torsional-linear"), record(&PARAMETERS)),];
    let method = prop::sample::select(vec!["auto", "dormand-prince", "dop853", "rk4", "rodas"]);
    let damage = prop_oneof![Just(vec![]), prop::collection::vec((key(&RUN_KEYS), value()), 1..3)];
    let friction = prop_oneof![Just(Value::Absent), record(&["moment"])];
    (model, method, friction, record(&STATES), damage).prop_map(
        |((model, parameters), method, friction, initial, damage)| {
            let named = |key: &str, value| (key.to_owned(), value);
            let mut entries = vec![
                named("model", Value::Text(model.into())),
                named("method", Value::Text(method.into())),
                named("parameters", parameters),
                named("friction", friction),
                named("initial", initial),
                named("duration", Value::Number(0.01)),
            ];
            entries.extend(damage.into_iter().filter(|(key, value)| !is_large(key, value)));
            entries.push(named("maxSteps", Value::Number(STEPS)));
            Value::Record(entries)
        },
    )
}

/// A number of samples that is allowed, and takes a while.
fn is_large(key: &str, value: &Value) -> bool {
    key == "samples" && matches!(value, Value::Number(n) if (1e4..=MOST_SAMPLES as f64).contains(n))
}

/// Carries a value out as a run, as far as it gets.
fn attempt(input: &Value) {
    let run = match Run::read(input) {
        Ok(run) => run,
        Err(error) => return assert_speaks(&error),
    };
    match run.simulate() {
        Ok(trajectory) => {
            assert_finite("time", &trajectory.time);
            assert!(trajectory.time.is_sorted(), "time falls");
            for column in &trajectory.states {
                assert_eq!(column.len(), trajectory.time.len());
                assert_finite("a state", column);
            }
            assert_finite("an event's time", &trajectory.events.time);
        }
        Err(error) => assert_speaks(&error),
    }
    match run.routh_hurwitz() {
        Ok(theory) => {
            assert_finite("the Routh column", &theory.column);
            assert_finite("a critical velocity", &theory.critical_velocities);
            assert_finite("the critical damping", &theory.critical_damping.into_iter().collect::<Vec<_>>());
        }
        Err(error) => assert_speaks(&error),
    }
    linearise(&run);
    match run.energy() {
        Ok(energy) => {
            let parts = energy
                .map(|e| vec![e.duration, e.tire, e.damper, e.tread_width, e.friction, e.kinetic, e.spring, e.stored]);
            assert_finite("an energy", &parts.unwrap_or_default());
        }
        Err(error) => assert_speaks(&error),
    }
    cycle(&run, None);
    match run.describing_function() {
        Ok(cycles) => cycles.iter().for_each(|cycle| {
            assert_finite(
                "a prediction",
                &[cycle.frequency, cycle.amplitude.torsion_angle, cycle.amplitude.slip_angle],
            );
        }),
        Err(error) => assert_speaks(&error),
    }
    match run.live() {
        Ok(mut simulator) => {
            for _ in 0..3 {
                if let Err(error) = simulator.advance(1e-3) {
                    assert_speaks(&error);
                }
                assert_finite("the live state", &simulator.state());
            }
        }
        Err(error) => assert_speaks(&error),
    }
}

/// Its limit cycle: one in finite numbers, none, or a refusal.
fn cycle(run: &Run, guess: Option<&Guess>) {
    match run.limit_cycle(guess) {
        Ok(None) => {}
        Ok(Some(cycle)) => {
            assert_finite("a cycle", &[cycle.period, cycle.frequency]);
            assert_finite("an amplitude", &cycle.amplitude);
            cycle.multipliers.iter().for_each(|value| assert_finite("a multiplier", &[value.re, value.im]));
            cycle.orbit.states.iter().for_each(|column| assert_finite("an orbit", column));
            assert!(cycle.period > 0.0 && cycle.multipliers.len() == cycle.amplitude.len());
        }
        Err(error) => assert_speaks(&error),
    }
}

/// What linear theory says by numbers.
fn linearise(run: &Run) {
    match run.linearised() {
        Ok(linear) => {
            assert_finite("the equilibrium", &linear.equilibrium);
            assert_finite("the Jacobian", linear.jacobian.as_slice());
        }
        Err(error) => return assert_speaks(&error),
    }
    match run.eigenvalues() {
        Ok(values) => values.iter().for_each(|value| assert_finite("an eigenvalue", &[value.re, value.im])),
        Err(error) => assert_speaks(&error),
    }
    match run.routh_array() {
        Ok(array) => {
            let degree = array.coefficients.len() - 1;
            assert!(array.unstable_roots + array.neutral_roots <= degree, "{array:?}");
            assert_finite("the polynomial", &array.coefficients);
            array.rows.iter().for_each(|row| assert_finite("Routh's array", row));
        }
        Err(error) => assert_speaks(&error),
    }
    match run.eigenmodes() {
        Ok(modes) => {
            for mode in modes {
                mode.shape.iter().for_each(|part| assert_finite("a shape", &[part.re, part.im]));
                let flow =
                    mode.energy_flow.map(|flow| [flow.tire, flow.damper, flow.tread_width, flow.kinetic, flow.spring]);
                assert_finite("an energy flow", &flow.unwrap_or_default());
                let numbers =
                    [Some(mode.natural_frequency), mode.damping_ratio, mode.time_to_half, mode.time_to_double];
                assert_finite("a mode", &numbers.map(Option::unwrap_or_default));
            }
        }
        Err(error) => assert_speaks(&error),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn anything_is_carried_out_or_refused(input in value()) {
        attempt(&input);
    }

    #[test]
    fn what_looks_like_a_run_is_carried_out_or_refused(input in run_like()) {
        attempt(&input);
    }

    #[test]
    fn a_live_motion_survives_every_argument(
        input in run_like(),
        moves in prop::collection::vec((0_usize..9, amount(), amount(), amount(), name()), 1..10),
    ) {
        let Ok(mut live) = Run::read(&input).and_then(|run| run.live()) else { return Ok(()) };
        for (which, a, b, c, name) in moves {
            let outcome = match which {
                0 => live.advance(a.min(0.01)),
                1 => live.set(&name, a),
                2 => live.set_state(&name, a),
                3 => live.kick(a),
                4 => live.seek(a),
                5 => live.reset(),
                6 => live.trace(a).map(|columns| columns.states.iter().for_each(|column| assert_finite("the trace", column))),
                7 => live.history(a, b, c.min(100.0)).map(|columns| columns.states.iter().for_each(|column| assert_finite("the past", column))),
                _ => live.envelope(a, b, c.min(100.0)).map(|envelope| assert_finite("the envelope", &envelope.low)),
            };
            if let Err(error) = outcome {
                assert_speaks(&error);
            }
            assert_finite("the live state", &live.state());
            prop_assert!(live.time().is_finite());
        }
    }

    #[test]
    fn what_is_asked_of_a_gear_is_answered_or_refused(
        run in run_like(),
        (parameter, from, to, linked) in (name(), amount(), amount(), value()),
        (state, curves, anything) in (prop::collection::vec(amount(), 0..5), record(&["slipAngle", "torsionAngle", "samples"]), value()),
    ) {
        let Ok(run) = Run::read(&run) else { return Ok(()) };
        let named = |key: &str, value| (key.to_owned(), value);
        let (parameter, from, to) = (Value::Text(parameter), Value::Number(from), Value::Number(to));
        let variation = vec![named("parameter", parameter), named("from", from.clone()), named("to", to), named("linked", linked)];
        for input in [Value::Record(variation.clone()), Value::Record(variation[..3].to_vec()), anything.clone()] {
            match Variation::read(&input).and_then(|variation| run.unstable_intervals(&variation)) {
                Ok(intervals) => intervals.iter().for_each(|part| assert_finite("an end", &[part.from, part.to])),
                Err(error) => assert_speaks(&error),
            }
            match Variation::read(&input).and_then(|variation| run.crossings(&variation)) {
                Ok(crossings) => crossings.iter().for_each(|c| assert_finite("a crossing", &[c.value, c.frequency])),
                Err(error) => assert_speaks(&error),
            }
        }
        let states = run.description().state.iter().zip(&state).map(|(state, x)| named(state.name, Value::Number(*x)));
        let guess = vec![named("period", from.clone()), named("state", Value::Record(states.collect()))];
        for input in [Value::Record(guess), anything.clone()] {
            match Guess::read(&run, &input) {
                Ok(guess) => cycle(&run, guess.as_ref()),
                Err(error) => assert_speaks(&error),
            }
        }
        for input in [Value::Numbers(state.clone()), anything.clone()] {
            match run.read_state(&input).and_then(|state| run.forces(&state)) {
                Ok(forces) => assert_finite("a force", &[forces.slip_angle, forces.side_force, forces.aligning_moment, forces.spring_torque]),
                Err(error) => assert_speaks(&error),
            }
        }
        let columns = STATES.iter().map(|name| named(name, Value::Numbers(state.clone()))).collect();
        for input in [Value::Record(columns), anything.clone()] {
            match run.read_states(&input).and_then(|states| run.forces_along(&states)) {
                Ok(columns) => assert_finite("a force", &[columns.side_force, columns.aligning_moment, columns.spring_torque].concat()),
                Err(error) => assert_speaks(&error),
            }
        }
        for input in [curves, anything] {
            match Curves::read(&input).and_then(|curves| run.force_laws(&curves)) {
                Ok(laws) => assert_finite("a law", &[laws.slip_angle, laws.side_force, laws.aligning_moment, laws.restoring_moment].concat()),
                Err(error) => assert_speaks(&error),
            }
        }
        match run.linked_parameters() {
            Ok(linked) => assert_finite("a link", &[linked.relaxation_length, linked.tread_width_moment_constant]),
            Err(error) => assert_speaks(&error),
        }
    }

    #[test]
    fn any_series_has_its_spectrum_or_is_refused(
        values in prop::collection::vec(number(), 0..40), tame in prop::collection::vec(-1e3..1e3_f64, 2..40),
        interval in number(), anything in value(),
    ) {
        let series = |values: &[f64], interval| {
            let (values, interval) = (Value::Numbers(values.to_vec()), Value::Number(interval));
            Value::Record(vec![("values".into(), values), ("interval".into(), interval)])
        };
        for input in [series(&values, interval), series(&tame, interval), series(&values, 0.1), anything] {
            match Series::read(&input) {
                Ok(series) => {
                    let spectrum = series.spectrum();
                    assert_finite("a frequency", &spectrum.frequency);
                    assert_finite("an amplitude", &spectrum.amplitude);
                    if let Some(peak) = spectrum.peak {
                        assert_finite("the peak", &[peak.frequency, peak.amplitude]);
                    }
                }
                Err(error) => assert_speaks(&error),
            }
        }
    }

    #[test]
    fn damaged_snapshots_are_refused_and_change_nothing(
        byte in any::<prop::sample::Index>(), bit in 0_u8..8, kept in any::<prop::sample::Index>(),
    ) {
        let mut live = moving();
        let whole = live.snapshot();
        let state = live.state();
        let mut flipped = whole.clone();
        flipped[byte.index(whole.len())] ^= 1 << bit;
        for damaged in [flipped.as_slice(), &whole[..kept.index(whole.len())], &[whole.as_slice(), &[0]].concat()] {
            assert_speaks(&live.restore(damaged).unwrap_err());
            prop_assert_eq!(live.state(), state.clone());
        }
        live.restore(&whole).unwrap();
        prop_assert_eq!(live.state(), state);
    }

    #[test]
    fn forged_snapshots_do_no_harm(
        word in any::<prop::sample::Index>(),
        bits in prop_oneof![number().prop_map(f64::to_bits), any::<u64>(), 0_u64..8],
    ) {
        let mut live = moving();
        let bytes = live.snapshot();
        assert_harmless(&mut live, &forged(&bytes, word.index(bytes.len() / 8 - 1), bits));
    }
}

/// Numbers so large that what follows from them overflows later: a forged rate once did, in the first step after.
#[test]
fn whatever_word_is_forged_does_no_harm() {
    let bytes = moving().snapshot();
    for word in 0..bytes.len() / 8 - 1 {
        for bits in [0xfee8_45e3_ea18_5562, 0x7fe0_0000_0000_0000] {
            assert_harmless(&mut moving(), &forged(&bytes, word, bits));
        }
    }
}

fn moving() -> Simulator {
    let mut live = Run::of("torsional").unwrap().starting("torsionAngle", 0.1).unwrap().live().unwrap();
    live.advance(0.1).unwrap();
    live
}

/// A snapshot with one of its eight-byte words replaced and its checksum (FNV-1a) made right again: a checksum finds
/// accidents, it is no proof of good will.
fn forged(snapshot: &[u8], word: usize, bits: u64) -> Vec<u8> {
    let mut bytes = snapshot.to_vec();
    let body = bytes.len() - 8;
    bytes[8 * word..8 * word + 8].copy_from_slice(&bits.to_le_bytes());
    let sum = bytes[..body]
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3));
    bytes[body..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

/// Taken up or refused, the motion stays finite, ends every call, and is whole again after a reset.
fn assert_harmless(live: &mut Simulator, bytes: &[u8]) {
    if let Err(error) = live.restore(bytes) {
        assert_speaks(&error);
    }
    assert_finite("the live state", &live.state());
    if let Err(error) = live.advance(1e-3) {
        assert_speaks(&error);
    }
    assert_finite("the live state", &live.state());
    let [from, to] = live.range();
    for outcome in [live.history(from, to, 10.0).map(drop), live.seek(from), live.set("velocity", 60.0)] {
        if let Err(error) = outcome {
            assert_speaks(&error);
        }
    }
    live.reset().unwrap();
    live.advance(1e-3).unwrap();
    assert_finite("the live state", &live.state());
}

/// A step length of `f64::MAX` was once stretched to infinity and rejected for ever.
#[test]
fn every_number_of_a_snapshot_may_be_the_largest() {
    let mut live = moving();
    let bytes = live.snapshot();
    for word in 0..bytes.len() / 8 - 1 {
        for number in [f64::MAX, f64::MIN, 5e-324] {
            assert_harmless(&mut live, &forged(&bytes, word, number.to_bits()));
        }
        live.restore(&bytes).unwrap();
    }
}

#[test]
fn deep_nesting_is_refused_without_deep_recursion() {
    let mut input = Value::Number(1.0);
    for _ in 0..10_000 {
        input = Value::Record(vec![("parameters".into(), input)]);
    }
    attempt(&input);
}

#[test]
fn sizes_that_would_never_end_are_refused() {
    let run = |key: &str, value| {
        Run::read(&Value::Record(vec![
            ("model".into(), Value::Text("torsional".into())),
            (key.into(), Value::Number(value)),
        ]))
        .unwrap_err()
    };
    assert_eq!(run("samples", 1e12).code.name(), "too-large");
    assert_eq!(run("samples", 1e12).field, "samples");
    assert_speaks(&run("samples", 2.5));
    assert_speaks(&run("maxSteps", 1e300));
    assert_speaks(&run("duration", f64::INFINITY));
    assert_speaks(&run("rtol", 0.0));
}
