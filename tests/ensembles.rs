//! Ensembles: lanes against one motion by itself, and ends of motions against what is known of the gear.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    gear::{ADAPTIVE, Gear},
    linear,
    random::Random,
};
use shimmy::{
    Run,
    cycles::{Bifurcation, BifurcationSpec, CyclePoint},
    ensemble::{BasinsSpec, Bundle, Fate, LANES, Sweep, SweepSpec},
    integrate::Scheme,
    model::Prepared,
    run::Value,
    stability::Variation,
};

fn number(value: f64) -> Value {
    Value::Number(value)
}

fn record<const N: usize>(fields: [(&str, Value); N]) -> Value {
    Value::Record(fields.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
}

fn axis(what: &str, name: &str, from: f64, to: f64, count: usize) -> Value {
    record([
        (what, Value::Text(name.into())),
        ("from", number(from)),
        ("to", number(to)),
        ("count", number(count as f64)),
    ])
}

/// The plane of starts of a gear.
fn starts(parameters: Value, [angle, rate]: [f64; 2], [columns, rows]: [usize; 2], refine: bool) -> Value {
    record([
        ("model", Value::Text("torsional".into())),
        ("parameters", parameters),
        ("x", axis("state", "torsionAngle", -angle, angle, columns)),
        ("y", axis("state", "torsionRate", -rate, rate, rows)),
        ("refine", Value::Bool(refine)),
    ])
}

fn gear(v: f64, c: f64, degrees: f64) -> Value {
    record([("velocity", number(v)), ("dampingConstant", number(c)), ("freeplayAngle", number(degrees.to_radians()))])
}

fn run(v: f64, c: f64, degrees: f64) -> Run {
    let run = Run::of("torsional").unwrap().with("velocity", v).unwrap();
    run.with("dampingConstant", c).unwrap().with("freeplayAngle", degrees.to_radians()).unwrap()
}

#[test]
fn lanes_move_as_one_motion_by_itself_to_the_last_bit() {
    let mut random = Random::seeded(11);
    let mut taken = 0;
    while taken < 40 {
        let gears: [Gear; LANES] = std::array::from_fn(|_| Gear::random(&mut random));
        let prepared: Vec<Prepared> = gears.iter().filter_map(|gear| Prepared::of(&gear.system())).collect();
        let Ok(prepared) = <[Prepared; LANES]>::try_from(prepared) else { continue };
        taken += 1;
        let starts: [[f64; 3]; LANES] = std::array::from_fn(|_| Gear::random_start(&mut random));
        let mut bundle = Bundle::at_rest();
        for lane in 0..LANES {
            let [psi, rate, y] = starts[lane];
            bundle.load(lane, &prepared[lane].gear, [psi, rate * prepared[lane].step, y]);
        }
        bundle.advance(300);
        for lane in 0..LANES {
            let gear = &prepared[lane].gear;
            let mut x = [starts[lane][0], starts[lane][1] * prepared[lane].step, starts[lane][2]];
            for _ in 0..300 {
                x = shimmy::ensemble::step(gear, &x, [0.5, 1.0 / 3.0, 1.0 / 6.0]);
            }
            assert_eq!(bundle.state(lane).map(f64::to_bits), x.map(f64::to_bits), "{:?}", gears[lane]);
        }
    }
}

/// The crate's own RK4 knows modes and locates kinks; where neither matters the two differ by the polynomials' error alone.
#[test]
fn lanes_are_the_classical_method_where_nothing_bends() {
    let gear = Gear::default().with("velocity", 80.0).with("dampingConstant", 30.0);
    let prepared = Prepared::of(&gear.system()).unwrap();
    // Some 2·10⁻⁴ s, a hundredth of the swing.
    assert!((1.8e-4..2.1e-4).contains(&prepared.step), "{}", prepared.step);
    let start = [1e-3, 0.0, 0.0];
    let method = shimmy::integrate::Method::Always(Scheme::RungeKutta4);
    let mut one = gear.motion(method, 1e-8, prepared.step, start);
    let mut bundle = Bundle::at_rest();
    bundle.load(2, &prepared.gear, start);
    for _ in 0..200 {
        one.step(f64::INFINITY).unwrap();
    }
    bundle.advance(200);
    let [psi, change, y] = bundle.state(2);
    for (ours, theirs) in [psi, change / prepared.step, y].into_iter().zip(one.state()) {
        // Forces are within 10⁻⁶ of their largest, here some fiftieth of it is at work: over two swings 10⁻⁶ of the motion.
        assert!((ours - theirs).abs() < 3e-6 * theirs.abs().max(1e-3), "{ours} {theirs}");
    }
}

#[test]
fn amplitudes_are_those_of_the_theory() {
    // theory.md 3 and 4, computed independently there. Without a gap it is the digits printed and a step that straddles a kink, with one a step that
    // straddles it leaves 2·10⁻³ open.
    for (v, c, degrees, amplitude, fate, tolerance) in [
        (80.0, 10.0, 0.0, 0.39238, Fate::Shimmy, 5e-5),
        (80.0, 30.0, 0.0, 0.20632, Fate::Shimmy, 5e-5),
        (40.0, 20.0, 0.0, 18.057_f64.to_radians(), Fate::Shimmy, 5e-5),
        (50.0, 100.0, 0.5, 0.011171, Fate::Rattle, 2e-3),
        (50.0, 100.0, 1.0, 0.022268, Fate::Rattle, 2e-3),
        (50.0, 100.0, 1.5, 0.033219, Fate::Rattle, 2e-3),
        (50.0, 30.0, 0.0, 0.22254, Fate::Shimmy, 5e-5),
        (50.0, 30.0, 0.5, 0.22958, Fate::Shimmy, 2e-3),
        (50.0, 30.0, 1.0, 0.23577, Fate::Shimmy, 2e-3),
        (50.0, 30.0, 1.5, 0.24134, Fate::Shimmy, 2e-3),
    ] {
        let basins =
            BasinsSpec::read(&starts(gear(v, c, degrees), [0.3, 60.0], [4, 2], false)).unwrap().made().unwrap();
        for (kind, found) in basins.kind().iter().zip(basins.amplitude()) {
            assert_eq!(Fate::numbered(*kind), Some(fate), "v {v} c {c} ψ_fp {degrees}°");
            assert!((found / amplitude - 1.0).abs() < tolerance, "v {v} c {c} ψ_fp {degrees}°: {found}");
        }
    }
    // At v = 80, c = 100 the motion dies out, gap or not.
    let calm = BasinsSpec::read(&starts(gear(80.0, 100.0, 1.0), [0.3, 60.0], [4, 3], false)).unwrap().made().unwrap();
    assert!(calm.kind().iter().all(|kind| *kind == Fate::Rest as u8) && calm.amplitude().iter().all(|a| *a == 0.0));
}

/// Adaptive runs with located kinks know nothing of lanes, windows and judges.
#[test]
fn ends_are_those_of_long_simulations() {
    let mut random = Random::seeded(5);
    for _ in 0..12 {
        let (v, c) = (random.between(15.0, 110.0), random.between(0.0, 60.0));
        let degrees = if random.once_in(2) { 0.0 } else { random.between(0.2, 1.5) };
        let start = random.between(0.01, 0.3);
        let plane = record([
            ("model", Value::Text("torsional".into())),
            ("parameters", gear(v, c, degrees)),
            ("x", axis("state", "torsionAngle", start - 1e-9, start + 1e-9, 1)),
            ("y", axis("state", "torsionRate", -1e-9, 1e-9, 1)),
        ]);
        let basins = BasinsSpec::read(&plane).unwrap().made().unwrap();
        let motion = run(v, c, degrees).starting("torsionAngle", start).unwrap().by(ADAPTIVE[0]).unwrap();
        let motion = motion.lasting(20.0).unwrap().sampled(200_001.0).unwrap().simulate().unwrap();
        let late = motion.states[0][190_000..].iter().fold(0.0_f64, |most, psi| most.max(psi.abs()));
        let (fate, amplitude) = (Fate::numbered(basins.kind()[0]).unwrap(), basins.amplitude()[0]);
        let what = format!("v {v} c {c} ψ_fp {degrees}° from {start}: {fate:?} {amplitude}, not {late}");
        match fate {
            Fate::Rest => assert!(late < 1e-3, "{what}"),
            Fate::Unsettled => panic!("{what}"),
            _ => assert!((amplitude / late - 1.0).abs() < if degrees > 0.0 { 2e-3 } else { 2e-4 }, "{what}"),
        }
    }
}

/// The equations are odd: so are their basins.
#[test]
fn basins_are_odd() {
    for spec in [gear(50.0, 100.0, 1.0), gear(40.0, 45.0, 0.0)] {
        let basins = BasinsSpec::read(&starts(spec, [0.4, 100.0], [20, 14], false)).unwrap().made().unwrap();
        let kind = basins.kind();
        assert!(kind.iter().eq(kind.iter().rev()));
    }
}

/// A gear that trails the wrong way and is held by its aligning moment: rest and a large cycle are both stable.
fn bistable() -> [(&'static str, f64); 6] {
    [
        ("velocity", 102.0),
        ("dampingConstant", 29.0),
        ("casterLength", -0.2),
        ("aligningMomentDerivative", 4.8),
        ("sideForceLimitAngle", 0.047),
        ("aligningMomentLimitAngle", 0.29),
    ]
}

#[test]
fn the_unstable_cycle_separates_the_basins() {
    let run =
        bistable().iter().fold(Run::of("torsional").unwrap(), |run, (name, value)| run.with(name, *value).unwrap());
    let predicted = run.describing_function().unwrap();
    assert_eq!(predicted.iter().map(|cycle| cycle.stable).collect::<Vec<_>>(), [false, true]);
    // From the first harmonic, ψ = A cos ωt and y/ψ = (v + iω(e − a))/(iω + v/σ), shooting finds the unstable cycle itself.
    let (amplitude, frequency) = (predicted[0].amplitude.torsion_angle, predicted[0].frequency);
    let omega = std::f64::consts::TAU * frequency;
    let ratio = nalgebra::Complex::new(102.0, omega * (-0.2 - 0.1)) / nalgebra::Complex::new(102.0 / 0.3, omega);
    let guess = shimmy::cycles::Guess { period: 1.0 / frequency, state: vec![amplitude, 0.0, (ratio * amplitude).re] };
    let cycle = run.limit_cycle(Some(&guess)).unwrap().expect("a cycle");
    assert!(!cycle.stable && (cycle.amplitude[0] / amplitude - 1.0).abs() < 0.02, "{cycle:?}");

    // Rows through points of its orbit: outwards of it all goes to the large cycle, inwards all to rest. (Where ψ is near 0,
    // a row goes along the orbit and not out of it.)
    let psi = &cycle.orbit.states[0];
    let far: Vec<usize> =
        (0..psi.len()).step_by(9).filter(|point| psi[*point].abs() > 0.5 * cycle.amplitude[0]).collect();
    assert!(far.len() > 4);
    for point in far {
        let at = |state: usize| cycle.orbit.states[state][point];
        let cells = 20;
        // A thousandth of the amplitude a cell, with the orbit between the two middle ones.
        let half = cells as f64 * 0.5e-3 * cycle.amplitude[0];
        let rate = at(1);
        let parameters = record(bistable().map(|(name, value)| (name, number(value))));
        let spec = record([
            ("model", Value::Text("torsional".into())),
            ("parameters", parameters),
            ("initial", record([("lateralDeformation", number(at(2)))])),
            ("x", axis("state", "torsionAngle", at(0) - half, at(0) + half, cells)),
            ("y", axis("state", "torsionRate", rate - 1e-9, rate + 1e-9, 1)),
            ("refine", Value::Bool(false)),
            ("duration", number(30.0)),
        ]);
        let basins = BasinsSpec::read(&spec).unwrap().made().unwrap();
        let mut kind = basins.kind().to_vec();
        if at(0) < 0.0 {
            kind.reverse();
        }
        let edge = kind.iter().position(|kind| *kind == Fate::Shimmy as u8).unwrap_or(cells);
        assert!(kind[..edge].iter().all(|kind| *kind == Fate::Rest as u8), "{kind:?}");
        assert!(kind[edge..].iter().all(|kind| *kind == Fate::Shimmy as u8), "{kind:?}");
        // The lanes straddle kinks: the boundary is theirs to a few thousandths.
        assert!(edge.abs_diff(cells / 2) <= 2, "point {point}: {kind:?}");
    }
}

#[test]
fn a_sweep_shows_hysteresis_where_long_runs_do() {
    let damping = ("dampingConstant", 0.0, 60.0);
    let spec = record([
        ("model", Value::Text("torsional".into())),
        ("parameters", record(bistable().map(|(name, value)| (name, number(value))))),
        ("over", axis("parameter", damping.0, damping.1, damping.2, 21)),
    ]);
    let sweep = SweepSpec::read(&spec).unwrap().made().unwrap();
    let values = sweep.values();
    let (up, down) = (&sweep.up().amplitude, &sweep.down().amplitude);
    let run = |c: f64, push: f64| {
        let run =
            bistable().iter().fold(Run::of("torsional").unwrap(), |run, (name, value)| run.with(name, *value).unwrap());
        let run = run.with("dampingConstant", c).unwrap().starting("torsionAngle", push).unwrap();
        let motion = run.lasting(10.0).unwrap().sampled(50_001.0).unwrap().simulate().unwrap();
        motion.states[0][48_000..].iter().fold(0.0_f64, |most, psi| most.max(psi.abs()))
    };
    // Critical at c = 20.0088 by Routh and Hurwitz: below rest is lost, above it is found again only beyond the fold.
    let rest_is_stable = |c: f64| c > 20.0088;
    let mut both = 0;
    for (index, c) in values.iter().enumerate() {
        let (large, small) = (run(*c, 0.25), run(*c, 1e-3));
        let near =
            |swept: f64, simulated: f64| (swept == 0.0 && simulated < 1e-4) || (swept / simulated - 1.0).abs() < 3e-4;
        assert!(near(up[index], large), "c {c}: {} going up, simulated {large}", up[index]);
        assert!(near(down[index], small), "c {c}: {} going down, simulated {small}", down[index]);
        assert_eq!(down[index] == 0.0, rest_is_stable(*c), "c {c}");
        both += usize::from(up[index] > 0.0 && down[index] == 0.0);
    }
    assert!(both > 8, "{both} values with two motions");
}

/// A tire's laws that no short polynomial serves are followed by themselves, and end the same way.
#[test]
fn gears_that_lanes_do_not_take_are_followed_all_the_same() {
    let wide = Gear::default().with("sideForceLimitAngle", 0.8).with("velocity", 60.0).with("dampingConstant", 60.0);
    assert!(Prepared::of(&wide.system()).is_none());
    let parameters =
        record([("sideForceLimitAngle", number(0.8)), ("velocity", number(60.0)), ("dampingConstant", number(60.0))]);
    let basins = BasinsSpec::read(&starts(parameters, [0.2, 40.0], [3, 2], false)).unwrap().made().unwrap();
    assert!(basins.kind().iter().all(|kind| *kind == Fate::Rest as u8), "{:?}", basins.kind());
}

#[test]
fn refined_basins_are_those_of_every_cell() {
    let parameters = || record(bistable().map(|(name, value)| (name, number(value))));
    let [all, some] = [false, true]
        .map(|refine| BasinsSpec::read(&starts(parameters(), [0.3, 100.0], [96, 72], refine)).unwrap().made().unwrap());
    assert_eq!(all.followed(), 96 * 72);
    assert!(3 * some.followed() < 2 * all.followed(), "{}", some.followed());
    assert!(all.kind() == some.kind());
    let (endings, _) = some.endings();
    assert_eq!(endings.iter().map(|ending| ending.fate).collect::<Vec<_>>(), [Fate::Rest, Fate::Shimmy]);
}

/// Lanes have no dry friction: such a gear is followed by itself, and sticks.
#[test]
fn dry_friction_is_not_left_out() {
    let spec = |moment: f64| {
        record([
            ("model", Value::Text("torsional".into())),
            ("parameters", gear(40.0, 20.0, 0.0)),
            ("friction", record([("moment", number(moment))])),
            ("x", axis("state", "torsionAngle", -0.02, 0.02, 2)),
            ("y", axis("state", "torsionRate", -1e-3, 1e-3, 1)),
        ])
    };
    let end = |moment: f64| BasinsSpec::read(&spec(moment)).unwrap().made().unwrap().kind().to_vec();
    assert_eq!(end(0.0), [Fate::Shimmy as u8; 2]);
    // At 0.01 rad the spring asks for 1000 N m.
    assert_eq!(end(2000.0), [Fate::Rest as u8; 2]);
    let sweep = record([
        ("model", Value::Text("torsional".into())),
        ("parameters", gear(40.0, 20.0, 0.0)),
        ("over", axis("parameter", "friction.moment", 0.0, 400.0, 3)),
    ]);
    let sweep = SweepSpec::read(&sweep).unwrap().made().unwrap();
    // Carried on, the cycle lives with less amplitude; without friction it is that of theory.md 3.
    assert!((sweep.up().amplitude[0] / 18.057_f64.to_radians() - 1.0).abs() < 5e-5);
    assert!(sweep.up().amplitude.windows(2).all(|two| two[1] < two[0]), "{:?}", sweep.up().amplitude);
}

/// A sweep over a range, and the diagram of the same gear by continuation, which knows nothing of starts and settling.
fn swept(parameters: &[(&str, f64)], over: (&str, f64, f64, usize), more: Vec<(&str, Value)>) -> (Sweep, Bifurcation) {
    let (name, from, to, count) = over;
    let own = |dotted: bool| parameters.iter().filter(move |(name, _)| name.contains('.') == dotted);
    let moment = own(true).map(|(_, value)| ("moment".to_owned(), number(*value)));
    let values = own(false).map(|(name, value)| ((*name).to_owned(), number(*value)));
    let mut spec = vec![
        ("model".to_owned(), Value::Text("torsional".into())),
        ("parameters".to_owned(), Value::Record(values.collect())),
        ("friction".to_owned(), Value::Record(moment.collect())),
        ("over".to_owned(), axis("parameter", name, from, to, count)),
    ];
    spec.extend(more.into_iter().map(|(key, value)| (key.to_owned(), value)));
    let sweep = SweepSpec::read(&Value::Record(spec)).unwrap().made().unwrap();
    let diagram = BifurcationSpec::of(linear::gear(parameters), Variation::of(name, from, to)).made().unwrap();
    (sweep, diagram)
}

/// The amplitude of the stable cycle at a value: from the nearest one of a branch, by shooting.
fn stable_at(diagram: &Bifurcation, value: f64) -> Option<f64> {
    let branches = diagram.cycles();
    let stable = branches.iter().flat_map(|branch| &branch.points).filter(|point| point.unstable == 0);
    let away = |point: &&CyclePoint| (point.value - value).abs();
    let near = stable.min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let guess = shimmy::cycles::Guess { period: near.period, state: near.state.clone() };
    let run = diagram.spec().run.clone().with(diagram.parameter(), value).unwrap();
    // A gear without such a cycle is no mistake here: the guess then leads nowhere, or to another one.
    let found = run.limit_cycle(Some(&guess)).unwrap().filter(|cycle| cycle.stable)?;
    ((found.amplitude[0] / near.amplitude[0] - 1.0).abs() < 0.3).then(|| found.amplitude[0])
}

#[test]
fn near_a_hopf_point_a_sweep_waits_or_says_that_it_has_not() {
    // c = 20 is critical at 27.600 m/s (theory.md, section 2): at 27.61 a swing grows by some 0.006 a second.
    let over = ("velocity", 27.41, 28.61, 25);
    let (sweep, diagram) = swept(&[("dampingConstant", 20.0)], over, vec![]);
    for (index, v) in sweep.values().into_iter().enumerate() {
        let expected = if v < 27.6 { 0.0 } else { stable_at(&diagram, v).unwrap() };
        for way in [sweep.up(), sweep.down()] {
            assert_eq!(way.settled[index], 1, "v {v}");
            let off = way.amplitude[index] - expected;
            assert!(off.abs() <= 5e-5 * expected.max(0.01), "v {v}: {} for {expected}", way.amplitude[index]);
        }
    }
    // In half a second it does not settle: what is said to have settled is right all the same.
    let (hasty, _) = swept(&[("dampingConstant", 20.0)], over, vec![("duration", number(0.5))]);
    let mut late = 0;
    for (index, v) in hasty.values().into_iter().enumerate() {
        for way in [hasty.up(), hasty.down()] {
            assert_eq!(way.settled[index] == 0, way.kind[index] == Fate::Unsettled as u8);
            late += usize::from(way.settled[index] == 0);
            if way.settled[index] == 1 && way.amplitude[index] > 0.0 {
                let expected = stable_at(&diagram, v).unwrap();
                assert!((way.amplitude[index] / expected - 1.0).abs() < 1e-3, "v {v}: {}", way.amplitude[index]);
            }
        }
    }
    assert!(late > 20, "{late}");
}

#[test]
fn where_friction_holds_small_swings_the_way_back_starts_large() {
    for (friction, over) in [
        (100.0, ("velocity", 20.0, 80.0, 13)),
        (200.0, ("velocity", 60.0, 100.0, 5)),
        // Here the swing is at the end where the way back arrives.
        (100.0, ("dampingConstant", 0.0, 60.0, 13)),
    ] {
        let (sweep, diagram) = swept(&[("dampingConstant", 20.0), ("friction.moment", friction)], over, vec![]);
        assert!(sweep.up().amplitude.iter().all(|amplitude| *amplitude == 0.0), "{over:?}");
        let mut swings = 0;
        for (index, value) in sweep.values().into_iter().enumerate() {
            let found = sweep.down().amplitude[index];
            assert_eq!(sweep.down().settled[index], 1);
            match stable_at(&diagram, value) {
                Some(expected) => {
                    swings += 1;
                    assert!((found / expected - 1.0).abs() < 1e-4, "{over:?} at {value}: {found} for {expected}");
                }
                None => assert_eq!(found, 0.0, "{over:?} at {value}"),
            }
        }
        assert!(swings > 3, "{swings}");
    }
}

#[test]
fn the_way_back_starts_from_the_large_motion_at_the_end() {
    // tests/bifurcation.rs, and independently there: this gear's rest is lost at 53.402 m/s, its large cycle at 36.225.
    let leading = [("casterLength", -0.06), ("aligningMomentLimitAngle", 40_f64.to_radians())];
    let (sweep, diagram) = swept(&leading, ("velocity", 30.0, 50.0, 11), vec![]);
    assert!(sweep.up().amplitude.iter().all(|amplitude| *amplitude == 0.0));
    for (index, v) in sweep.values().into_iter().enumerate() {
        let found = sweep.down().amplitude[index];
        if v < 36.225 {
            assert_eq!(found, 0.0);
        } else {
            assert!((found / stable_at(&diagram, v).unwrap() - 1.0).abs() < 1e-4, "v {v}: {found}");
        }
    }
    // A start within the unstable cycle finds nothing, and a record of one is read.
    let small = vec![("start", record([("torsionAngle", number(0.02))]))];
    let (small, _) = swept(&leading, ("velocity", 30.0, 50.0, 3), small);
    assert!(small.down().amplitude.iter().all(|amplitude| *amplitude == 0.0));
    let spec = |start: Value| {
        let over = axis("parameter", "velocity", 30.0, 50.0, 3);
        SweepSpec::read(&record([("model", Value::Text("torsional".into())), ("over", over), ("start", start)]))
    };
    let error = spec(record([("torsionangle", number(0.1))])).unwrap_err();
    assert!(error.to_string().contains("torsionAngle"), "{error}");
    assert!(spec(record([("torsionAngle", number(f64::NAN))])).is_err());
}
