//! Every scheme against motions known in closed form: its order, its dense output, its stability, its tolerance.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use common::{
    exact::{
        BetweenSprings, Exact, Forced, Linear, Modulated, Oscillator, ProtheroRobinson, StuartLandau, VanDerPol, Zigzag,
    },
    gear::{ADAPTIVE, Gear, SCHEMES},
    reference,
};
use shimmy::{
    integrate::{Integrator, Method, Outcome, Scheme, Tolerance},
    model::System,
};

/// Places within a step at which its dense output is looked at.
const WITHIN: [f64; 3] = [0.25, 0.5, 0.8];

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).fold(0.0, |most: f64, i| most.max((a[i] - b[i]).abs()))
}

/// A motion whose steps are all `h` long: the tolerance is so large that no step is too long, but for the longest.
fn marching<S: System<N>, const N: usize>(system: S, scheme: Scheme, h: f64, x: [f64; N]) -> Integrator<S, N> {
    let loose = Tolerance { relative: 0.0, absolute: [1e3; N] };
    Integrator::new(system, Method::Always(scheme), loose, h, h, x).expect("finite at the start")
}

/// Largest error at the ends of `steps` equal steps, and within them.
fn errors<S: Exact<N>, const N: usize>(problem: &S, scheme: Scheme, end: f64, steps: u64) -> [f64; 2] {
    let h = end / steps as f64;
    let mut motion = marching(problem.clone(), scheme, h, problem.exact(0.0));
    let [mut at_ends, mut within] = [0.0_f64; 2];
    for step in 1..=steps {
        motion.step(end * step as f64 / steps as f64).expect("a step");
        assert!((motion.time() - motion.step_start() - h).abs() < 1e-12, "the steps are not equal");
        at_ends = at_ends.max(distance(motion.state(), &problem.exact(motion.time())));
        for theta in WITHIN {
            let t = motion.time() - (1.0 - theta) * h;
            within = within.max(distance(&motion.interpolate(t), &problem.exact(t)));
        }
    }
    [at_ends, within]
}

/// Asserts that the error falls with the power of the step that a scheme promises, ± 0.2, at the ends of steps and
/// within them, over two halvings.
///
/// `steps` says, for each scheme, how many steps the longest are: so many that the order shows, and so few that two
/// halvings later it is not yet drowned in rounding. A scheme may be better on a `linear` system than its order.
fn assert_orders<S: Exact<N>, const N: usize>(name: &str, problem: &S, linear: bool, end: f64, steps: [u64; 4]) {
    for ((scheme, order), steps) in ORDERS.into_iter().zip(steps) {
        let found = [1, 2, 4].map(|finer| errors(problem, scheme, end, finer * steps));
        for (place, pair) in (0..2).flat_map(|place| found.windows(2).map(move |pair| (place, pair))) {
            let (coarse, fine) = (pair[0][place], pair[1][place]);
            let excess = (coarse / fine).log2() - order;
            assert!(
                excess >= -0.2 && (excess <= 0.2 || linear),
                "{name}, {scheme:?}: order {:.3} from {coarse:.1e} to {fine:.1e}",
                order + excess
            );
        }
    }
}

const ORDERS: [(Scheme, f64); 4] =
    [(Scheme::DormandPrince, 5.0), (Scheme::Dop853, 8.0), (Scheme::RungeKutta4, 4.0), (Scheme::Rodas, 5.0)];

#[test]
fn order_on_linear_systems() {
    assert_orders("linear", &Linear::coupled(), true, 4.0, [32, 16, 64, 64]);
    assert_orders("oscillator", &Oscillator, true, 6.0, [48, 12, 96, 24]);
}

#[test]
fn order_on_a_nonlinear_system() {
    assert_orders("Stuart–Landau", &StuartLandau { frequency: 3.0, start: 0.4 }, false, 4.0, [128, 16, 128, 64]);
}

#[test]
fn order_where_the_system_depends_on_time() {
    assert_orders("forced", &Forced { frequency: 1.7 }, false, 6.0, [96, 12, 192, 96]);
    assert_orders("modulated", &Modulated, false, 4.0, [96, 32, 192, 192]);
}

#[test]
fn order_across_kinks() {
    // Kinks that were straddled would leave an order near 2. Where steps are cut changes from step size to step size:
    // over two halvings the order is seen to a half. Each piece is linear: a scheme may be better than its order.
    let problem = BetweenSprings { gap: 0.3, frequency: 3.0, speed: 1.1 };
    let error = |scheme, steps: u64| {
        let mut motion = marching(problem.clone(), scheme, 5.0 / steps as f64, problem.exact(0.0));
        while motion.time() < 5.0 {
            motion.step(5.0).expect("a step");
        }
        assert!(motion.stats().events >= 6);
        distance(motion.state(), &problem.exact(5.0))
    };
    for ((scheme, order), steps) in ORDERS.into_iter().zip([80, 20, 160, 80]) {
        let observed = 0.5 * (error(scheme, steps) / error(scheme, 4 * steps)).log2();
        assert!(observed > order - 0.5, "{scheme:?}: order {observed:.2}");
    }
}

#[test]
fn events_are_met_at_their_times() {
    let problem = BetweenSprings { gap: 0.02, frequency: 300.0, speed: 4.0 };
    for scheme in SCHEMES {
        let tolerance = Tolerance { relative: 1e-11, absolute: [1e-15, 1e-12] };
        let start = problem.exact(0.0);
        let mut motion =
            Integrator::new(problem.clone(), Method::Always(scheme), tolerance, 2e-5, 1.0, start).expect("a start");
        let mut met = 0;
        while motion.time() < 1.0 {
            if let Outcome::Switch(which) = motion.step(1.0).expect("a step") {
                assert_eq!(which, met / 2 % 2, "events come in pairs, above and below by turns");
                // Of fifty half periods, each a little wrong: RK4's phase error at this step is 3e-8 of the time.
                let error = (motion.time() - problem.event(met)).abs();
                assert!(error < if scheme == Scheme::RungeKutta4 { 1e-7 } else { 1e-9 }, "{scheme:?} {met}: {error:e}");
                met += 1;
            }
        }
        assert!(problem.event(met) > 1.0 && problem.event(met - 1) < 1.0, "{scheme:?}: {met} events");
        assert!(met > 80);
    }
}

#[test]
fn events_of_time_alone_are_met() {
    let problem = Zigzag { frequency: 7.0 };
    for scheme in SCHEMES {
        let tolerance = Tolerance { relative: 1e-9, absolute: [1e-9] };
        // Nothing in the state holds the step down: the longest step must see each wave.
        let mut motion =
            Integrator::new(problem.clone(), Method::Always(scheme), tolerance, 0.05, 0.2, [0.0]).expect("a start");
        while motion.time() < 10.0 {
            motion.step(10.0).expect("a step");
        }
        assert_eq!(motion.stats().events, 22, "{scheme:?}");
        assert!(distance(motion.state(), &problem.exact(10.0)) < 1e-9, "{scheme:?}");
    }
}

#[test]
fn rodas_damps_what_is_stiff() {
    // R(z) → 0 as z → −∞, like 1/z: an L-stable step forgets what is fast at once.
    for exponent in [2, 4, 6, 8, 10] {
        let fast = 10_f64.powi(exponent);
        let mut motion = marching(Linear { rows: [[-fast]], start: [1.0] }, Scheme::Rodas, 1.0, [1.0]);
        while motion.time() - motion.step_start() < 1.0 {
            motion.step(f64::INFINITY).expect("a step");
        }
        let left = (motion.state()[0] / motion.step_start_state()[0]).abs();
        assert!(left < 20.0 / fast, "h λ = {fast:e}: {left:e} is left");
    }
}

#[test]
fn rodas_keeps_its_accuracy_where_it_is_stiff() {
    for stiffness in [1e2, 1e4, 1e6] {
        let problem = ProtheroRobinson { stiffness };
        let tolerance = Tolerance { relative: 1e-8, absolute: [1e-10] };
        let method = Method::Always(Scheme::Rodas);
        let mut motion =
            Integrator::new(problem.clone(), method, tolerance, 0.0, f64::INFINITY, [0.0]).expect("a start");
        while motion.time() < 10.0 {
            motion.step(10.0).expect("a step");
            assert!(distance(motion.state(), &problem.exact(motion.time())) < 1e-7, "λ = {stiffness:e}");
        }
        assert!(motion.stats().steps < 1_500, "λ = {stiffness:e}: {} steps", motion.stats().steps);
    }
}

/// Largest error up to `end`, at the ends of steps and in their middles, and the motion that made it.
fn adaptive<S: Exact<N>, const N: usize>(
    problem: &S,
    method: &str,
    rtol: f64,
    end: f64,
) -> ([f64; 2], Integrator<S, N>) {
    let method = Method::named(method).expect("a method");
    let tolerance = Tolerance { relative: rtol, absolute: [rtol; N] };
    let mut motion =
        Integrator::new(problem.clone(), method, tolerance, 0.0, f64::INFINITY, problem.exact(0.0)).expect("a start");
    let [mut at_ends, mut within] = [0.0_f64; 2];
    while motion.time() < end {
        motion.step(end).expect("a step");
        at_ends = at_ends.max(distance(motion.state(), &problem.exact(motion.time())));
        let middle = 0.5 * (motion.step_start() + motion.time());
        within = within.max(distance(&motion.interpolate(middle), &problem.exact(middle)));
    }
    ([at_ends, within], motion)
}

/// Largest error of all.
fn worst<S: Exact<N>, const N: usize>(problem: &S, method: &str, rtol: f64) -> f64 {
    let ([at_ends, within], _) = adaptive(problem, method, rtol, 10.0);
    at_ends.max(within)
}

/// Decades of tolerance from 1e-4 to 1e-12.
fn tolerances() -> impl Iterator<Item = f64> {
    (4..=12).map(|decade| 10_f64.powi(-decade))
}

fn shown(errors: &[f64]) -> String {
    errors.iter().map(|error| format!("{error:.1e}")).collect::<Vec<_>>().join(" ")
}

/// Asserts that errors fall from decade to decade: each is at most 1.5 times the one before, and a third of the one two
/// decades before, until `rounding` is reached.
fn assert_falling(name: &str, method: &str, errors: &[f64], rounding: f64) {
    for (i, &error) in errors.iter().enumerate().filter(|&(_, &error)| error > rounding) {
        let before = |decades: usize| i.checked_sub(decades).map_or(f64::INFINITY, |i| errors[i]);
        assert!(error <= 1.5 * before(1) && error <= before(2) / 3.0, "{name}, {method}: {}", shown(errors));
    }
}

#[test]
fn error_falls_with_the_tolerance_on_smooth_problems() {
    for method in ADAPTIVE {
        let landau = StuartLandau { frequency: 3.0, start: 0.4 };
        let springs = BetweenSprings { gap: 0.3, frequency: 3.0, speed: 1.1 };
        let errors_of = |error: &dyn Fn(f64) -> f64| tolerances().map(error).collect::<Vec<_>>();
        for (name, errors) in [
            ("linear", errors_of(&|rtol| worst(&Linear::coupled(), method, rtol))),
            ("Stuart–Landau", errors_of(&|rtol| worst(&landau, method, rtol))),
            ("forced", errors_of(&|rtol| worst(&Forced { frequency: 1.7 }, method, rtol))),
            ("modulated", errors_of(&|rtol| worst(&Modulated, method, rtol))),
            ("springs", errors_of(&|rtol| worst(&springs, method, rtol))),
        ] {
            // Some hundred steps of rounding.
            assert_falling(name, method, &errors, 1e-13);
            // Ten units of time, over which the errors of steps add up, and the phase runs away with them.
            for (rtol, error) in tolerances().zip(&errors) {
                assert!(*error < 300.0 * rtol, "{name}, {method}, rtol {rtol:e}: {error:e}");
            }
        }
    }
}

#[test]
fn error_falls_with_the_tolerance_on_the_gear() {
    let cases = reference::trajectories(&reference::random());
    let error = |case: &reference::Case, method: &str, rtol: f64| {
        let run = case.run.clone().by(method).and_then(|run| run.within(rtol)?.within_absolute(1e-4 * rtol));
        case.error(&run.and_then(|run| run.simulate()).expect("a trajectory"))
    };
    for method in ADAPTIVE {
        let mut typical = Vec::new();
        for rtol in tolerances() {
            let errors: Vec<f64> = cases.iter().map(|case| error(case, method, rtol)).collect();
            for (case, error) in cases.iter().zip(&errors) {
                // Motions that grow take their errors along; and where a fast decay holds DOP853's step at the edge of
                // stability, its interpolation is worse than its steps.
                assert!(*error < 2_000.0 * rtol, "{}, {method}, rtol {rtol:e}: {error:e}", case.id);
            }
            typical.push((errors.iter().map(|error| error.ln()).sum::<f64>() / errors.len() as f64).exp());
        }
        for pair in typical.windows(2) {
            assert!(pair[1] < pair[0] / 3.0, "{method}: typical errors {}", shown(&typical));
        }
    }
}

#[test]
fn van_der_pol_has_its_period_and_amplitude() {
    // Periods by two independent programs; theory.md's 6.66329 and 6.28711 to more digits.
    for (mu, period, amplitude) in [(1.0, 6.663_286_86, 2.008_62), (0.1, 6.287_11, 2.000_10)] {
        for method in ADAPTIVE {
            let tolerance = Tolerance { relative: 1e-11, absolute: [1e-12; 2] };
            let method = Method::named(method).expect("a method");
            let mut motion =
                Integrator::new(VanDerPol { mu }, method, tolerance, 0.0, f64::INFINITY, [2.0, 0.0]).expect("a start");
            let (mut rises, mut peak) = (Vec::new(), 0.0_f64);
            while motion.time() < 300.0 {
                motion.step(300.0).expect("a step");
                rises.extend(motion.rise_through_zero(0));
                if motion.time() > 250.0 {
                    peak = peak.max(motion.turning_point(0).map_or(0.0, |(_, x)| x));
                }
            }
            let last = rises[rises.len() - 1] - rises[rises.len() - 2];
            let digits = if mu == 1.0 { 2e-8 } else { 1e-5 };
            assert!((last - period).abs() < digits, "μ = {mu}: period {last}");
            assert!((peak - amplitude).abs() < 1e-5, "μ = {mu}: amplitude {peak}");
        }
    }
}

#[test]
fn energy_of_an_oscillator_stays() {
    for method in ADAPTIVE {
        let (_, motion) = adaptive(&Oscillator, method, 1e-12, 200.0);
        let [x, v] = *motion.state();
        assert!((x * x + v * v - 1.0).abs() < 1e-9, "{method}: {:e}", x * x + v * v - 1.0);
    }
}

#[test]
fn auto_chooses_by_tolerance() {
    let scheme = |rtol| adaptive(&Linear::coupled(), "auto", rtol, 1.0).1.scheme();
    assert_eq!(scheme(1e-3), Scheme::DormandPrince);
    assert_eq!(scheme(1e-5), Scheme::DormandPrince);
    assert_eq!(scheme(1e-6), Scheme::Dop853);
    assert_eq!(scheme(1e-12), Scheme::Dop853);
}

#[test]
fn auto_goes_over_where_a_run_turns_stiff() {
    // Errors at the ends of steps: what is fast holds an explicit step at the edge of stability, where its interpolation
    // swings; and an L-stable step may be as long as a wave of what drives it, and see nothing of it.
    for rtol in [1e-4, 1e-8] {
        let ([error, _], motion) = adaptive(&Linear::two_scales(1e6), "auto", rtol, 10.0);
        assert!(error < 10.0 * rtol, "{error:e}");
        assert!(motion.stats().stiff && motion.scheme() == Scheme::Rodas);
        // Explicit steps at the edge of stability would be some 2.5 million.
        assert!(motion.stats().steps < 2_000, "{} steps", motion.stats().steps);
        let ([error, _], motion) = adaptive(&ProtheroRobinson { stiffness: 1e6 }, "auto", rtol, 10.0);
        assert!(error < 10.0 * rtol, "{error:e}");
        assert!(motion.stats().stiff && motion.scheme() == Scheme::Rodas);
        assert!(motion.stats().steps < 2_000, "{} steps", motion.stats().steps);
    }
}

#[test]
fn the_step_in_which_auto_goes_over_can_be_looked_into() {
    // At 0.01 m/s the tire's damping κ/v dies away 27 000 times a second.
    let gear = Gear::default().with("velocity", 0.01);
    for rtol in [1e-3, 1e-5, 1e-6, 1e-8] {
        let mut motion = gear.motion(Method::Auto, rtol, 0.0, [0.1, 0.0, 0.0]);
        let mut changes = 0;
        while motion.time() < 0.02 {
            let before = motion.scheme();
            motion.step(0.02).expect("a step");
            changes += u32::from(motion.scheme() != before);
            for theta in WITHIN {
                let x = motion.interpolate(motion.step_start() + theta * (motion.time() - motion.step_start()));
                // It creeps back, and nothing else: ψ̇ = −k ψ/(c + κ/v) once the start is over.
                assert!(x[0] > 0.0 && x[0] <= 0.1 * (1.0 + rtol) && x[1] > -1.0, "rtol {rtol:e}: {x:?}");
            }
        }
        assert!(changes == 1 && motion.stats().stiff);
    }
}

#[test]
fn explicit_methods_say_that_a_run_is_stiff_and_stay() {
    for method in ["dormand-prince", "dop853"] {
        let ([error, _], motion) = adaptive(&Linear::two_scales(1e4), method, 1e-6, 10.0);
        assert!(error < 1e-5, "{method}: {error:e}");
        assert!(motion.stats().stiff && motion.scheme().name() == method);
    }
}

#[test]
fn the_ordinary_gear_is_not_stiff() {
    let free = 1_f64.to_radians();
    for (velocity, damping, freeplay) in
        [(20.0, 0.0, 0.0), (80.0, 20.0, 0.0), (50.0, 30.0, free), (50.0, 100.0, free), (120.0, 200.0, 0.0)]
    {
        for rtol in [1e-4, 1e-8, 1e-10] {
            let gear = Gear::default().with("velocity", velocity).with("dampingConstant", damping);
            let gear = gear.with("freeplayAngle", freeplay);
            let mut motion = gear.motion(Method::Auto, rtol, 0.0, [0.1, 0.0, 0.0]);
            // Long after the motion has settled or died, where nothing but stability holds the step.
            while motion.time() < 0.5 {
                motion.step(0.5).expect("a step");
            }
            assert!(!motion.stats().stiff, "v = {velocity}, c = {damping}, rtol {rtol:e}");
        }
    }
}
