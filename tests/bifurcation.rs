//! Bifurcation diagrams: against values from outside, their own invariants, and long simulations.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    linear::{gear, gear_of, random_gear},
    random::Random,
};
use shimmy::{
    Code, Run,
    cycles::{
        Bifurcation, BifurcationSpec, BranchEnd, Criticality, CycleBranch, CyclePoint, FoldSpec, Guess, PointKind, Told,
    },
    outlook::Verdict,
    stability::{Plane, Variation},
};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

fn diagram(parameters: &[(&str, f64)], parameter: &str, from: f64, to: f64) -> Bifurcation {
    of(&gear(parameters), parameter, from, to)
}

fn of(run: &Run, parameter: &str, from: f64, to: f64) -> Bifurcation {
    BifurcationSpec::of(run.clone(), Variation::of(parameter, from, to)).made().unwrap()
}

/// A wheel that leads its axis, on a tire whose aligning moment goes on growing up to 40°: its side force calms it until that
/// grows no more. The branch of cycles folds twice, and large cycles are there long before rest is unstable.
const LEADING: [(&str, f64); 3] =
    [("casterLength", -0.06), ("dampingConstant", 10.0), ("aligningMomentLimitAngle", 40.0 * DEGREE)];

fn only(diagram: &Bifurcation) -> CycleBranch {
    let [branch] = &diagram.cycles()[..] else { panic!("{} branches", diagram.cycles().len()) };
    branch.clone()
}

fn guess(point: &CyclePoint) -> Guess {
    Guess { period: point.period, state: point.state.clone() }
}

fn at(run: &Run, parameter: &str, point: &CyclePoint) -> Run {
    run.clone().with(parameter, point.value).unwrap()
}

/// What holds of any diagram.
fn check(run: &Run, parameter: &str, diagram: &Bifurcation, every: usize) {
    let branches = diagram.cycles();
    for branch in &branches {
        let points = &branch.points;
        assert!(points.iter().all(|point| point.period > 0.0 && point.amplitude.iter().all(|a| a.is_finite())));
        for (i, point) in points.iter().enumerate() {
            assert!((point.multipliers[0] - 1.0).norm() < 1e-6, "{run:?} {point:?}");
            assert_eq!(point.multipliers.len(), point.amplitude.len());
            let outside = point.multipliers[1..].iter().filter(|value| value.norm() > 1.0).count();
            assert_eq!(point.unstable, outside);
            if i % every != 1 || point.amplitude[0] < 1e-4 {
                continue;
            }
            // Stored stability is that of multipliers that are computed anew, and the cycle that of its neighbour.
            let found = at(run, parameter, point).limit_cycle(Some(&guess(point))).unwrap();
            let Some(found) = found.filter(|found| (found.amplitude[0] / point.amplitude[0] - 1.0).abs() < 1e-3) else {
                // Next to a fold two cycles are so near that Newton's method may take the other one, or none.
                assert!(point.multipliers[1..].iter().any(|value| (value - 1.0).norm() < 0.02), "{run:?} {point:?}");
                continue;
            };
            let leading = point.multipliers[1];
            // The trivial multiplier shows how errors grow in a round. Where a neighbour hardly comes nearer in one they add up.
            let trivial = (point.multipliers[0] - 1.0).norm();
            let allowed = ((1e-8 + 3.0 * trivial) / (leading - 1.0).norm()).max(1e-6);
            assert!((found.amplitude[0] / point.amplitude[0] - 1.0).abs() < allowed, "{found:?} {point:?}");
            // A cycle that rises from next to rest dwells there, where errors grow for long: neither its period nor what becomes of
            // its neighbours is told to many digits.
            if point.state.iter().zip(&point.amplitude).all(|(x, amplitude)| x.abs() < 0.01 * amplitude) {
                continue;
            }
            assert!((found.period / point.period - 1.0).abs() < allowed, "{found:?} {point:?}");
            let nearest = found.multipliers.iter().fold(f64::INFINITY, |near, got| near.min((got - leading).norm()));
            assert!(nearest < (1e3 * trivial).max(1e-5), "{found:?} {point:?}");
            assert!(found.stable == (point.unstable == 0) || (leading - 1.0).norm() < 1e-4, "{found:?} {point:?}");
        }
        for (end, point) in branch.ends.iter().zip([&points[0], &points[points.len() - 1]]) {
            let Variation { from, to, .. } = diagram.spec().variation;
            match end {
                BranchEnd::Range => assert!(point.value == from || point.value == to),
                BranchEnd::Hopf => assert!(
                    diagram.points().iter().any(|p| p.kind == PointKind::Hopf && p.value == point.value),
                    "{point:?}"
                ),
                _ => {}
            }
        }
    }
    for point in diagram.points() {
        match point.kind {
            PointKind::Hopf | PointKind::Divergence => {
                assert_eq!(diagram.rest().value[point.index], point.value);
                continue;
            }
            _ => {}
        }
        // A special point lies in its bracket: what it stands for is on one side of it and not on the other.
        let branch = &branches[point.branch.unwrap()].points;
        let [before, here, after] = [-1, 0, 1].map(|aside| &branch[point.index.wrapping_add_signed(aside)]);
        assert_eq!((here.value, here.amplitude[0]), (point.value, point.amplitude));
        match point.kind {
            PointKind::Fold => {
                let turns = (before.value - here.value) * (after.value - here.value);
                assert!(turns > 0.0, "{before:?} {here:?} {after:?}");
                assert_eq!(before.unstable.abs_diff(after.unstable), 1, "{before:?} {here:?} {after:?}");
                let one = here.multipliers[1..].iter().fold(f64::INFINITY, |near, m| near.min((m - 1.0).norm()));
                assert!(one < 1e-3, "{here:?}");
            }
            _ => assert_ne!(before.unstable, after.unstable, "{before:?} {here:?} {after:?}"),
        }
    }
}

/// theory.md, sections 3 and 4, at ends of ranges; to half a unit of the last digit given.
#[test]
fn known_cycles_are_on_their_branches() {
    let near = |got: f64, expected: f64, digit: f64| assert!((got - expected).abs() < 0.6 * digit, "{got} {expected}");
    for (c, v, amplitude, digit) in
        [(10.0, 80.0, 0.392_38, 1e-5), (30.0, 80.0, 0.206_32, 1e-5), (20.0, 40.0, 18.057 * DEGREE, 1e-3 * DEGREE)]
    {
        let branch = only(&diagram(&[("dampingConstant", c)], "velocity", 10.0, v));
        assert_eq!(branch.ends, [BranchEnd::Hopf, BranchEnd::Range]);
        near(branch.points.last().unwrap().amplitude[0], amplitude, digit);
    }
    for (degrees, amplitude) in [(0.5, 0.011_171), (1.0, 0.022_268), (1.5, 0.033_219)] {
        let gap = degrees * DEGREE;
        let rattle = only(&diagram(&[("velocity", 50.0), ("dampingConstant", 100.0)], "freeplayAngle", gap, 3.0 * gap));
        near(rattle.points[0].amplitude[0], amplitude, 1e-6);
        let large = only(&diagram(&[("velocity", 50.0), ("freeplayAngle", gap)], "dampingConstant", 30.0, 60.0));
        let expected = [0.229_58, 0.235_77, 0.241_34][(2.0 * degrees) as usize - 1];
        let at_30 = large.points.iter().find(|point| point.value == 30.0).unwrap();
        near(at_30.amplitude[0], expected, 1e-5);
    }
}

/// Hopf points are the crossings of linear theory; the coefficient is that of a script in NumPy, from the third derivatives
/// of the laws by hand and the eigenvectors, at the critical value found by bisection of the eigenvalues.
#[test]
fn hopf_points_are_crossings_and_their_coefficient_is_known() {
    for (parameters, parameter, [from, to], value, coefficient) in [
        (&[("dampingConstant", 20.0)][..], "velocity", [10.0, 60.0], 27.599_606_344_488_74, -21.976_211_567_9),
        (&[("dampingConstant", 10.0)], "velocity", [10.0, 60.0], 20.511_049_178_860_15, -10.093_009_369_2),
        (&[("velocity", 80.0)], "dampingConstant", [30.0, 60.0], 48.530_218_171_307_38, -175.698_860_643_6),
        (&LEADING, "velocity", [40.0, 60.0], 53.402_364_737_606_64, -22.396_572_970_7),
    ] {
        let diagram = diagram(parameters, parameter, from, to);
        let hopf = &diagram.points()[0];
        assert!((hopf.value / value - 1.0).abs() < 1e-12, "{hopf:?}");
        assert!((hopf.lyapunov.unwrap() / coefficient - 1.0).abs() < 1e-8, "{hopf:?}");
        assert_eq!(hopf.criticality, Some((Criticality::Supercritical, Told::Lyapunov)));
        let crossings = gear(parameters).crossings(&Variation::of(parameter, from, to)).unwrap();
        assert_eq!((crossings[0].value, crossings[0].frequency), (hopf.value, hopf.frequency));
        // The branch begins there, and does what the coefficient says: growth and amplitude² balance.
        let branch = &diagram.cycles()[hopf.branch.unwrap()];
        assert_eq!((branch.points[0].value, branch.points[0].amplitude[0]), (hopf.value, 0.0));
        let first = &branch.points[1];
        let run = at(&gear(parameters), parameter, first);
        let growth = run.eigenvalues().unwrap()[0].re;
        let balance = growth + coefficient * first.amplitude[0].powi(2);
        assert!(balance.abs() < 0.02 * growth, "{growth} {first:?}");
    }
}

#[test]
fn a_subcritical_point_is_called_so_by_both() {
    // The tire's force has its limit next to rest: what the coefficient says holds only below it.
    let parameters = [LEADING[0], LEADING[1], LEADING[2], ("sideForceLimitAngle", 0.1 * DEGREE)];
    let tight = diagram(&parameters, "velocity", 10.0, 120.0);
    let hopf = tight.points().iter().find(|point| point.kind == PointKind::Hopf).unwrap();
    assert_eq!(hopf.criticality, Some((Criticality::Subcritical, Told::Branch)));
    assert!(hopf.lyapunov.unwrap() < 0.0, "within the limit it would be supercritical: {hopf:?}");
    let beyond = tight.cycles()[hopf.branch.unwrap()].points.iter().find(|point| point.amplitude[0] > 0.01).cloned();
    assert!(beyond.is_some_and(|point| point.value < hopf.value && point.unstable == 1));
    check(&gear(&parameters), "velocity", &tight, 5);
}

#[test]
fn the_branch_of_a_leading_wheel_folds_where_another_program_says() {
    let diagram = diagram(&LEADING, "velocity", 10.0, 120.0);
    check(&gear(&LEADING), "velocity", &diagram, 3);
    let folds: Vec<f64> =
        diagram.points().iter().filter(|point| point.kind == PointKind::Fold).map(|point| point.value).collect();
    // SciPy: half-period maps by DOP853 with rtol 1e-12, in pieces between the kinks, closed by fsolve at fixed ψ̇; the extreme
    // of v over ψ̇ by polynomials of degree 4 through five cycles, four times nearer each time. The lower fold comes out as
    // …8164 to …8164558; at the other the side force comes to its limit, and the last two are 56.9989232 and 56.9988983.
    assert_eq!(folds.len(), 2);
    assert!((folds[1] - 36.225_258_164_4).abs() < 1e-8, "{folds:?}");
    assert!((folds[0] - 56.998_898_28).abs() < 1e-6, "{folds:?}");
    let branch = only(&diagram);
    let counts: Vec<usize> = branch.points.iter().map(|point| point.unstable).collect();
    let changes = counts.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(counts[1] == 0 && counts[counts.len() - 1] == 0 && counts.contains(&1) && (2..=4).contains(&changes));
}

/// On both sides of an unstable cycle long simulations go where the diagram says: to rest, and to the stable cycle above.
#[test]
fn simulations_agree_on_both_sides_of_the_fold() {
    let run = gear(&LEADING);
    let branch = only(&diagram(&LEADING, "velocity", 10.0, 120.0));
    let lower = branch.points.iter().filter(|p| p.unstable == 1 && p.value > 37.0 && p.value < 50.0);
    for edge in lower.step_by(2) {
        let run = at(&run, "velocity", edge);
        let large = branch
            .points
            .windows(2)
            .find(|pair| {
                pair[0].unstable == 0
                    && pair[0].value < edge.value
                    && pair[1].value >= edge.value
                    && pair[0].amplitude[0] > edge.amplitude[0]
            })
            .unwrap();
        let start = |part: f64| {
            run.description()
                .state
                .iter()
                .zip(&edge.state)
                .fold(run.clone(), |run, (state, x)| run.starting(state.name, part * x).unwrap())
        };
        assert_eq!(start(0.998).outlook().unwrap().verdict, Verdict::DiesOut, "{edge:?}");
        let end = start(1.002).lasting(4.0).unwrap().sampled(40_001.0).unwrap().simulate().unwrap();
        let late = end.states[0][38_000..].iter().fold(0.0_f64, |most, psi| most.max(psi.abs()));
        let bounds = [large[0].amplitude[0], large[1].amplitude[0]];
        let (low, high) = (bounds[0].min(bounds[1]), bounds[0].max(bounds[1]));
        assert!(late > 0.995 * low && late < 1.005 * high, "{late} {bounds:?}");
    }
    // Below the fold there is nothing but rest.
    let below = run.with("velocity", 36.1).unwrap().starting("torsionAngle", 0.8).unwrap();
    assert_eq!(below.outlook().unwrap().verdict, Verdict::DiesOut);
}

#[test]
fn direction_does_not_matter() {
    for (parameters, parameter, from, to) in [
        (&LEADING[..], "velocity", 10.0, 120.0),
        (&[("dampingConstant", 100.0), ("freeplayAngle", DEGREE)], "velocity", 40.0, 60.0),
        (&[("velocity", 80.0)], "casterLength", -0.5, 0.5),
    ] {
        let (there, back) = (diagram(parameters, parameter, from, to), diagram(parameters, parameter, to, from));
        assert_eq!(there.cycles(), back.cycles());
        assert_eq!((there.points(), there.rest()), (back.points(), back.rest()));
    }
    // Nor does where a branch without a beginning was entered: its ends are the same cycles.
    let parameters = [("dampingConstant", 100.0), ("freeplayAngle", DEGREE)];
    let found = only(&diagram(&parameters, "velocity", 40.0, 60.0));
    for entry in [3, found.points.len() - 4] {
        let point = &found.points[entry];
        let spec = BifurcationSpec::of(gear(&parameters), Variation::of("velocity", 40.0, 60.0));
        let spec = BifurcationSpec { cycle: Some((guess(point), point.value)), probes: 0, ..spec };
        let again = only(&spec.made().unwrap());
        for (a, b) in
            [(&again.points[0], &found.points[0]), (again.points.last().unwrap(), found.points.last().unwrap())]
        {
            assert_eq!(a.value, b.value);
            assert!((a.amplitude[0] / b.amplitude[0] - 1.0).abs() < 1e-8, "{a:?} {b:?}");
        }
    }
}

#[test]
fn freeplay_rattles_from_hopf_to_hopf_and_in_proportion() {
    // The gear in its gap, without a spring: theory.md has its two critical speeds, 3.196 and 73.041 m/s.
    let parameters = [("dampingConstant", 100.0), ("freeplayAngle", DEGREE)];
    let diagram_v = diagram(&parameters, "velocity", 1.0, 120.0);
    check(&gear(&parameters), "velocity", &diagram_v, 5);
    let branch = only(&diagram_v);
    assert_eq!(branch.ends, [BranchEnd::Hopf; 2]);
    let [first, second] = [0, 1].map(|i| &diagram_v.points()[i]);
    assert!((first.value - 3.196).abs() < 6e-4 && (second.value - 73.041).abs() < 6e-4);
    // The cycles grow through the gap at nearly the same speed, and turn aside where they touch its ends.
    for point in [first, second] {
        assert_eq!(point.criticality, Some((Criticality::Supercritical, Told::Branch)));
    }
    let largest = branch.points.iter().fold(0.0_f64, |most, point| most.max(point.amplitude[0]));
    assert!(largest > DEGREE && largest < 1.4 * DEGREE, "{largest}");
    // Over the gap: a cycle of the same shape, as long as the tire's law is straight.
    let small = only(&diagram(&[("velocity", 50.0), ("dampingConstant", 100.0)], "freeplayAngle", 0.0, 0.05 * DEGREE));
    assert_eq!(small.ends, [BranchEnd::Rest, BranchEnd::Range]);
    let ratio = |point: &CyclePoint| point.amplitude[0] / point.value;
    let last = ratio(small.points.last().unwrap());
    for point in small.points.iter().filter(|point| point.value > 1e-6) {
        assert!((ratio(point) / last - 1.0).abs() < 1e-4, "{point:?}");
    }
}

#[test]
fn a_linear_gear_has_no_cycles_and_says_why() {
    let run = gear_of("torsional-linear", &[("dampingConstant", 20.0)]);
    let diagram = of(&run, "velocity", 10.0, 80.0);
    assert!(diagram.cycles().is_empty());
    let [hopf] = diagram.points() else { panic!("{:?}", diagram.points()) };
    assert_eq!(hopf.criticality, Some((Criticality::Degenerate, Told::Lyapunov)));
    assert_eq!((hopf.branch, hopf.lyapunov.map(f64::abs)), (None, Some(0.0)));
}

#[test]
fn what_follows_a_parameter_follows_it() {
    let run = gear(&[("velocity", 60.0), ("dampingConstant", 20.0)]);
    let variation = Variation { relaxation_length_follows: true, ..Variation::of("halfContactLength", 0.06, 0.16) };
    let diagram = BifurcationSpec::of(run.clone(), variation).made().unwrap();
    let branch = &diagram.cycles()[0];
    for point in branch.points.iter().skip(1).step_by(7) {
        let linked = at(&run, "halfContactLength", point).with("relaxationLength", 3.0 * point.value).unwrap();
        let found = linked.limit_cycle(Some(&guess(point))).unwrap().unwrap();
        assert!((found.amplitude[0] / point.amplitude[0] - 1.0).abs() < 1e-6);
    }
}

/// With dry friction the wheel sticks at rest, whatever the speed, and a push that it must exceed to shimmy is an unstable
/// cycle, from the fold on: to first harmonic that of describing functions.
#[test]
fn dry_friction_hides_the_large_cycle_behind_a_small_one() {
    let run = gear(&[("dampingConstant", 20.0), ("friction.moment", 10.0)]);
    let diagram = of(&run, "velocity", 10.0, 120.0);
    check(&run, "velocity", &diagram, 4);
    let hopf = &diagram.points()[0];
    assert_eq!((hopf.kind, hopf.branch, hopf.criticality), (PointKind::Hopf, None, None), "no cycle is born from it");
    let branch = only(&diagram);
    assert_eq!(branch.ends, [BranchEnd::Range; 2]);
    let fold = diagram.points().iter().find(|point| point.kind == PointKind::Fold).unwrap();
    assert!(fold.value > hopf.value);
    for point in branch.points.iter().filter(|point| point.value > 35.0).step_by(5) {
        let predicted = at(&run, "velocity", point).describing_function().unwrap();
        let same = predicted.iter().filter(|cycle| cycle.stable == (point.unstable == 0));
        let nearest = same.map(|cycle| (cycle.amplitude.torsion_angle / point.amplitude[0] - 1.0).abs());
        // Higher harmonics: where both directions of the wheel stick for a while they matter most.
        assert!(nearest.fold(f64::INFINITY, f64::min) < 0.03, "{point:?} {predicted:?}");
    }
}

/// A gear so stiff, and a range so wide, that the arrival of a motion depends on the parameter in jumps of a millionth.
#[test]
fn a_stiff_gear_is_followed_from_end_to_end() {
    let parameters = [
        ("velocity", 21.766),
        ("casterLength", 0.35664),
        ("halfContactLength", 0.25841),
        ("relaxationLength", 0.27985),
        ("momentOfInertia", 9.0609),
        ("torsionalStiffness", 0.0),
        ("dampingConstant", 55.358),
        ("verticalForce", 32_424.0),
        ("aligningMomentDerivative", 2.468),
        ("sideForceLimitAngle", 0.098_675),
        ("aligningMomentLimitAngle", 0.395_64),
        ("treadWidthMomentConstant", 1770.7),
    ];
    let diagram = diagram(&parameters, "sideForceDerivative", 1.0, 50.0);
    check(&gear(&parameters), "sideForceDerivative", &diagram, 5);
    let branch = only(&diagram);
    assert_eq!(branch.ends, [BranchEnd::Range; 2]);
    assert!(branch.points.len() < 120, "{}", branch.points.len());
}

/// Any gear over any of its parameters: whatever comes out obeys what holds of any diagram.
#[test]
fn diagrams_of_random_gears_hold_together() {
    let mut random = Random::seeded(31);
    let table = Run::of("torsional").unwrap().description().parameters;
    let (mut cycles, mut special, mut lost) = (0, 0, 0);
    for case in 0..60 {
        let run = random_gear(&mut random, "torsional");
        let parameter = &table[case % table.len()];
        let Ok(diagram) =
            BifurcationSpec::of(run.clone(), Variation::of(parameter.name, parameter.min, parameter.max)).made()
        else {
            continue;
        };
        check(&run, parameter.name, &diagram, 9);
        let branches = diagram.cycles();
        cycles += branches.iter().map(|branch| branch.points.len()).sum::<usize>();
        special += diagram.points().iter().filter(|point| point.kind != PointKind::Hopf).count();
        lost += branches.iter().filter(|branch| branch.ends.contains(&BranchEnd::Lost)).count();
    }
    println!("{cycles} cycles, {special} special points, {lost} branches lost");
    assert!(cycles > 500, "{cycles}");
}

#[test]
fn curves_of_folds_go_through_the_folds_of_diagrams() {
    let run = gear(&LEADING);
    let plane = Plane::of(&run, ("velocity", 10.0, 120.0), ("dampingConstant", 0.0, 40.0)).unwrap();
    let curves = FoldSpec::of(plane).made().unwrap();
    let curves = curves.curves();
    assert_eq!(curves.len(), 2, "{curves:?}");
    for curve in curves {
        assert!(curve.bounds && !curve.closed);
        // From the edge without damping to that of the highest speed.
        let last = curve.x.len() - 1;
        let ends = [(curve.x[0], curve.y[0]), (curve.x[last], curve.y[last])];
        assert!(ends.iter().any(|end| end.1 == 0.0) && ends.iter().any(|end| end.0 == 120.0), "{ends:?}");
        for i in (1..last).step_by(7) {
            // Along another row than the curve was found in. Near its top two folds are near the end of the range.
            let run = run.clone().with("dampingConstant", curve.y[i]).unwrap();
            let spec = BifurcationSpec::of(run, Variation::of("velocity", 10.0, 120.0));
            let diagram = BifurcationSpec { probes: 24, ..spec }.made().unwrap();
            let folds = diagram.points().iter().filter(|point| point.kind == PointKind::Fold);
            let nearest = folds.min_by(|a, b| (a.value - curve.x[i]).abs().total_cmp(&(b.value - curve.x[i]).abs()));
            let nearest = nearest.expect("a fold");
            assert!((nearest.value / curve.x[i] - 1.0).abs() < 1e-6, "{nearest:?} {}", curve.x[i]);
            assert!((nearest.amplitude / curve.amplitude[i] - 1.0).abs() < 1e-4, "{nearest:?} {}", curve.amplitude[i]);
        }
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    let spec = |parameter: &str, from, to| BifurcationSpec::of(gear(&[]), Variation::of(parameter, from, to));
    let refused = |spec: BifurcationSpec| spec.made().err().expect("a refusal");
    assert_eq!(refused(spec("velocty", 1.0, 2.0)).suggestion, Some("velocity"));
    assert_eq!(refused(spec("velocity", -1.0, 2.0)).field, "from");
    assert_eq!(refused(spec("velocity", 2.0, 2.0)).field, "to");
    let outside = (Guess { period: 0.02, state: vec![0.1, 0.0, 0.0] }, 80.0);
    assert_eq!(refused(BifurcationSpec { cycle: Some(outside), ..spec("velocity", 1.0, 2.0) }).field, "cycle.value");
    let narrow = (Guess { period: 0.02, state: vec![0.1] }, 1.5);
    assert_eq!(refused(BifurcationSpec { cycle: Some(narrow), ..spec("velocity", 1.0, 2.0) }).field, "cycle.state");
    let extreme = BifurcationSpec::of(gear(&[("momentOfInertia", 1e-310)]), Variation::of("velocity", 1.0, 2.0));
    assert_eq!(refused(extreme).code, Code::Diverged);
}

/// Both parts of a branch whose fold is outside of the range are there, once each, and the unstable one is a cycle by another
/// method than the one that found it, with different ends on either side.
#[test]
fn an_unstable_part_is_found_without_its_fold() {
    let friction = |moment: f64| gear(&[("dampingConstant", 20.0), ("friction.moment", moment)]);
    let trailing = [
        ("velocity", 102.0),
        ("casterLength", -0.2),
        ("aligningMomentDerivative", 4.8),
        ("sideForceLimitAngle", 0.047),
        ("aligningMomentLimitAngle", 0.29),
    ];
    for (run, parameter, from, to) in [
        (friction(200.0), "velocity", 60.0, 100.0),
        (friction(100.0), "dampingConstant", 30.0, 10.0),
        (gear(&LEADING), "velocity", 40.0, 50.0),
        (gear(&trailing), "dampingConstant", 21.0, 30.0),
    ] {
        let diagram = of(&run, parameter, from, to);
        check(&run, parameter, &diagram, 5);
        let branches = diagram.cycles();
        let [small, large] = &branches[..] else { panic!("{parameter}: {} branches", branches.len()) };
        for branch in [small, large] {
            assert_eq!(branch.ends, [BranchEnd::Range; 2], "{parameter}");
        }
        assert!(small.points.iter().all(|point| point.unstable == 1));
        assert!(large.points.iter().all(|point| point.unstable == 0));
        for point in small.points.iter().step_by(11) {
            let run = at(&run, parameter, point);
            let from = |factor: f64| {
                let states = run.description().state.iter().zip(&point.state);
                states.fold(run.clone(), |run, (state, x)| run.starting(state.name, factor * x).unwrap())
            };
            let round = from(1.0).by("dop853").unwrap().within(1e-12).unwrap().lasting(point.period).unwrap();
            let end = round.simulate().unwrap();
            for ((column, x), amplitude) in end.states.iter().zip(&point.state).zip(&point.amplitude) {
                let missed = (column.last().unwrap() - x).abs() / amplitude;
                assert!(missed < 1e-7, "{parameter} {}: misses itself by {missed:e}", point.value);
            }
            let (inside, outside) = (from(0.99).outlook().unwrap(), from(1.01).outlook().unwrap());
            assert!(matches!(inside.verdict, Verdict::DiesOut | Verdict::Rests), "{inside:?}");
            let beyond = |other: &&CyclePoint| (other.value - point.value).abs();
            let near = large.points.iter().min_by(|a, b| beyond(a).total_cmp(&beyond(b))).unwrap();
            let stable = run.limit_cycle(Some(&guess(near))).unwrap().unwrap().amplitude[0];
            assert!((outside.amplitude[0] / stable - 1.0).abs() < 1e-4, "{} {stable}", outside.amplitude[0]);
        }
    }
}
