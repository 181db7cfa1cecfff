//! The one driver of all schemes.

mod reading;
mod saved;
mod stiffness;
mod switching;

use std::sync::Arc;

use self::{stiffness::STIFF_INTERVAL, switching::Switches};
use super::{
    controller::{Controller, power},
    dense::{COEFFICIENTS, Dense},
    dop853, dormand_prince,
    locate::Locator,
    method::{Method, Scheme},
    rodas, runge_kutta4,
    stages::{Attempt, MOST, Stages},
};
use crate::{
    few::padded,
    model::{Mode, System},
};

/// The longest fixed step in terms of what fades: the rate times it.
const FADING: f64 = 2.0;

/// What a step may be wrong by: rtol·|x| + atol in each component, as a root mean square.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance<const N: usize> {
    /// Relative.
    pub relative: f64,
    /// Absolute, in the unit of each state.
    pub absolute: [f64; N],
}

impl<const N: usize> Tolerance<N> {
    /// For as many states as there are absolute tolerances. Room that no state needs makes no mean smaller.
    pub(crate) fn of(relative: f64, absolute: &[f64]) -> Self {
        let share = (absolute.len() as f64 / N as f64).sqrt();
        Self { relative: relative * share, absolute: padded(absolute, 1.0).map(|each: f64| each * share) }
    }
}

/// What a run has cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Accepted steps.
    pub steps: u64,
    /// Steps tried again with a smaller size.
    pub rejected: u64,
    /// Right-hand sides.
    pub evaluations: u64,
    /// Switches located.
    pub events: u64,
    /// The run met a stretch where stability, not accuracy, held the explicit step down.
    pub stiff: bool,
}

/// How a step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Within its mode.
    Step,
    /// At this switch, past which it goes on in another mode.
    Switch(usize),
}

/// Why no step could be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The state left the finite numbers.
    Diverged,
    /// The step fell below what the time can resolve.
    StepTooSmall,
    /// The fixed step is too long for something that fades faster.
    StepTooLong,
}

/// A motion of a system: where it is, the step that led there, and what is needed to go on.
///
/// A clone goes on bit by bit as the original would.
#[derive(Clone, Debug)]
pub struct Integrator<S, const N: usize> {
    /// Shared by clones: keyframes are many, systems few.
    system: Arc<S>,
    tolerance: Tolerance<N>,
    method: Method,
    scheme: Scheme,
    fixed_step: f64,
    /// No step is longer, however still the motion is.
    longest_step: f64,
    locator: &'static Locator,

    mode: Mode,
    t: f64,
    x: [f64; N],
    /// Step to try next.
    h: f64,
    /// The switches at (t, x).
    switches: Switches,
    /// Switches passed whose value has not left zero since: a bit each.
    fresh: u32,
    controller: Controller,
    stiff_looking: u32,
    going_stiff: bool,
    /// Switches in a row without a step between them.
    in_place: u32,
    stats: Stats,

    /// The step that ended at (t, x): its start, length, mode, and stages (the derivative at its end goes first in the
    /// next step).
    from_t: f64,
    from_x: [f64; N],
    /// The state that its stages lead to: x itself, or a little before a switch.
    reached: [f64; N],
    length: f64,
    from_mode: Mode,
    /// The state before the switch that ended the step.
    landed: [f64; N],
    k: Stages<N>,
    start_rate: [f64; N],
    f: [f64; N],
    dense: Dense<N>,
    dense_ready: bool,
}

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// A motion that starts at `x` at t = 0.
    ///
    /// # Errors
    /// [`Failure::Diverged`] where the right-hand side is not finite there.
    pub fn new(
        system: S,
        method: Method,
        tolerance: Tolerance<N>,
        fixed_step: f64,
        longest_step: f64,
        x: [f64; N],
    ) -> Result<Self, Failure> {
        let t = 0.0;
        let scheme = method.scheme(tolerance.relative);
        let mut motion = Self {
            system: Arc::new(system),
            tolerance,
            method,
            scheme,
            fixed_step,
            longest_step,
            locator: Locator::get(),
            mode: Mode::default(),
            t,
            x,
            h: fixed_step,
            switches: Switches::default(),
            fresh: 0,
            controller: controller(scheme),
            stiff_looking: 0,
            going_stiff: false,
            in_place: 0,
            stats: Stats::default(),
            from_t: t,
            from_x: x,
            reached: x,
            length: 0.0,
            from_mode: Mode::default(),
            landed: x,
            k: [[0.0; N]; MOST],
            start_rate: [0.0; N],
            f: [0.0; N],
            dense: Dense { c: [[0.0; N]; COEFFICIENTS] },
            dense_ready: false,
        };
        motion.restart(t, x)?;
        Ok(motion)
    }

    /// Goes on from (`t`, `x`) instead, with nothing remembered but what the run has cost.
    ///
    /// # Errors
    /// [`Failure::Diverged`] where the right-hand side is not finite there; the motion stays where it was.
    pub fn restart(&mut self, t: f64, x: [f64; N]) -> Result<(), Failure> {
        let mode = self.system.mode(t, &x);
        let f = self.system.rate(t, mode, &x);
        if !f.iter().chain(&x).all(|value| value.is_finite()) {
            return Err(Failure::Diverged);
        }
        self.stats.evaluations += 1;
        (self.t, self.x, self.f, self.mode) = (t, x, f, mode);
        (self.from_t, self.from_x, self.length, self.from_mode) = (t, x, 0.0, mode);
        self.reached = x;
        self.fresh = 0;
        self.dense_ready = false;
        self.stiff_looking = 0;
        self.going_stiff = false;
        self.scheme = self.method.scheme(self.tolerance.relative);
        self.controller = controller(self.scheme);
        self.h = if self.scheme == Scheme::RungeKutta4 { self.fixed_step } else { self.first_step() };
        self.look_at_switches();
        Ok(())
    }

    /// Goes on with another system (other parameter values) from the same state at time `t`.
    ///
    /// # Errors
    /// As [`Integrator::restart`]; then the old system stays.
    pub fn replace(&mut self, system: Arc<S>, t: f64, x: [f64; N]) -> Result<(), Failure> {
        let before = std::mem::replace(&mut self.system, system);
        self.restart(t, x).inspect_err(|_| self.system = before)
    }

    /// From now on no step is longer, and none is wrong by more.
    pub(crate) fn pace(&mut self, longest_step: f64, tolerance: Tolerance<N>) {
        (self.longest_step, self.tolerance) = (longest_step, tolerance);
    }

    /// Time at the end of the last step.
    #[inline(always)]
    pub fn time(&self) -> f64 {
        self.t
    }

    /// State at the end of the last step.
    #[inline(always)]
    pub fn state(&self) -> &[f64; N] {
        &self.x
    }

    /// Derivative at the end of the last step.
    pub fn derivative(&self) -> &[f64; N] {
        &self.f
    }

    /// Time at the start of the last step: within the step, [`Integrator::interpolate`] serves.
    pub fn step_start(&self) -> f64 {
        self.from_t
    }

    /// State at the start of the last step.
    pub fn step_start_state(&self) -> &[f64; N] {
        &self.from_x
    }

    /// The system that moves, shared with whoever else runs it.
    pub fn system(&self) -> &Arc<S> {
        &self.system
    }

    /// What the motion has cost so far.
    pub fn stats(&self) -> Stats {
        self.stats
    }

    /// The scheme in use.
    pub fn scheme(&self) -> Scheme {
        self.scheme
    }

    /// Takes one step, to `end` at most, and stops at a switch on its way.
    ///
    /// # Errors
    /// A [`Failure`]; the motion stays where it was.
    pub fn step(&mut self, end: f64) -> Result<Outcome, Failure> {
        if self.going_stiff {
            self.going_stiff = false;
            self.scheme = Scheme::Rodas;
            self.controller = controller(self.scheme);
        }
        let (h, attempt) = self.accepted_attempt(end)?;
        let landed = if h == end - self.t { end } else { self.t + h };
        (self.from_t, self.from_x, self.from_mode, self.length) = (self.t, self.x, self.mode, h);
        let end_rate = self.end_rate(landed, &attempt.end);
        self.t = landed;
        (self.x, self.reached) = (attempt.end, attempt.end);
        self.dense_ready = false;
        self.stats.steps += 1;
        if self.stats.steps.is_multiple_of(STIFF_INTERVAL) || self.stiff_looking > 0 {
            self.look_for_stiffness(h, &attempt, &end_rate);
        }
        self.start_rate = std::mem::replace(&mut self.f, end_rate);
        if self.in_place > 2 * S::SWITCHES as u32 {
            self.pass_blindly();
        } else if S::SWITCHES > 0
            && let Some((which, theta)) = self.first_switch(h)
        {
            return self.stop_at(which, theta);
        }
        Ok(Outcome::Step)
    }

    /// A step whose error is within the tolerance.
    #[inline(always)]
    fn accepted_attempt(&mut self, end: f64) -> Result<(f64, Attempt<N>), Failure> {
        let room = end - self.t;
        loop {
            // A remainder of less than a hundredth of a step is taken along, not left for a step of its own.
            let mut h = self.h;
            if self.scheme == Scheme::RungeKutta4 {
                h = self.to_grid();
                if h * self.system.fading(self.mode, &self.x) > FADING {
                    return Err(Failure::StepTooLong);
                }
            }
            if h * 1.01 >= room {
                h = room;
            }
            if h <= 4.0 * f64::EPSILON * self.t.abs() || h < 1e-290 {
                return Err(if self.x.iter().any(|x| x.abs() > 1e100) {
                    Failure::Diverged
                } else {
                    Failure::StepTooSmall
                });
            }
            self.k[0] = self.f;
            let (attempt, error) = self.attempt(h);
            if error <= 1.0 {
                if self.scheme != Scheme::RungeKutta4 {
                    let next = h * self.controller.accepted(error);
                    // A step cut short by the end says nothing against the longer one that was planned.
                    self.h = if h < self.h { next.max(self.h) } else { next }.min(self.longest_step);
                }
                return Ok((h, attempt));
            }
            self.stats.rejected += 1;
            if self.scheme == Scheme::RungeKutta4 {
                return Err(Failure::Diverged);
            }
            self.h = h * self.controller.rejected(error);
        }
    }

    /// Tries a step of length `h`: its end and its error in units of the tolerance.
    #[inline(always)]
    fn attempt(&mut self, h: f64) -> (Attempt<N>, f64) {
        let (system, k) = (&*self.system, &mut self.k);
        let attempt = match self.scheme {
            Scheme::DormandPrince => {
                self.stats.evaluations += 6;
                dormand_prince::attempt(system, self.mode, self.t, &self.x, h, k)
            }
            Scheme::Dop853 => {
                self.stats.evaluations += 11;
                dop853::attempt(system, self.mode, self.t, &self.x, h, k)
            }
            Scheme::RungeKutta4 => {
                self.stats.evaluations += 3;
                runge_kutta4::attempt(system, self.mode, self.t, &self.x, h, k)
            }
            Scheme::Rodas => {
                self.stats.evaluations += rodas::STAGES as u64 - 1;
                match rodas::attempt(system, self.mode, self.t, &self.x, h, k) {
                    Some(attempt) => attempt,
                    None => return (Attempt { end: self.x, last_stage: self.x }, f64::INFINITY),
                }
            }
        };
        let scale = self.scale(&attempt.end);
        let error = match self.scheme {
            Scheme::DormandPrince => root_mean_square(&dormand_prince::error(h, &self.k), &scale),
            Scheme::Dop853 => dop853::error(h, &self.k, &scale),
            Scheme::RungeKutta4 => 0.0,
            Scheme::Rodas => root_mean_square(&rodas::error(&self.k), &scale),
        };
        let finite = attempt.end.iter().all(|x| x.is_finite());
        (attempt, if finite { error } else { f64::INFINITY })
    }

    /// One over the tolerance of each component, over a step that ends at `end`.
    #[inline(always)]
    fn scale(&self, end: &[f64; N]) -> [f64; N] {
        std::array::from_fn(|i| {
            let (start, end) = (self.x[i].abs(), end[i].abs());
            let size = if start > end { start } else { end };
            1.0 / (self.tolerance.absolute[i] + self.tolerance.relative * size)
        })
    }

    /// Derivative at the end of an accepted step, where the next step starts.
    #[inline(always)]
    fn end_rate(&mut self, t: f64, x: &[f64; N]) -> [f64; N] {
        if self.scheme == Scheme::DormandPrince {
            return self.k[dormand_prince::END];
        }
        self.stats.evaluations += 1;
        let rate = self.system.rate(t, self.mode, x);
        match self.scheme {
            Scheme::Dop853 => self.k[dop853::END] = rate,
            Scheme::RungeKutta4 => self.k[runge_kutta4::END] = rate,
            Scheme::DormandPrince | Scheme::Rodas => {}
        }
        rate
    }

    /// Length of the fixed step that leads to the next point of its grid, kept through switches.
    fn to_grid(&self) -> f64 {
        let done = (self.t / self.fixed_step + 1e-6).floor();
        (done + 1.0) * self.fixed_step - self.t
    }

    /// A first step from the sizes of the state and its first two derivatives.
    ///
    /// E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, II.4.
    fn first_step(&mut self) -> f64 {
        let scale: [f64; N] =
            std::array::from_fn(|i| 1.0 / (self.tolerance.absolute[i] + self.tolerance.relative * self.x[i].abs()));
        let (size, speed) = (root_mean_square(&self.x, &scale), root_mean_square(&self.f, &scale));
        let guess = if size < 1e-5 || speed < 1e-5 { 1e-6 } else { 0.01 * size / speed };
        let ahead: [f64; N] = std::array::from_fn(|i| self.x[i] + guess * self.f[i]);
        let rate = self.system.rate(self.t + guess, self.mode, &ahead);
        self.stats.evaluations += 1;
        let bend: [f64; N] = std::array::from_fn(|i| rate[i] - self.f[i]);
        let largest = speed.max(root_mean_square(&bend, &scale) / guess);
        let by_error =
            if largest <= 1e-15 { (guess * 1e-3).max(1e-6) } else { power(0.01 / largest, 1.0 / order(self.scheme)) };
        (100.0 * guess).min(by_error).min(self.longest_step)
    }
}

fn root_mean_square<const N: usize>(values: &[f64; N], scale: &[f64; N]) -> f64 {
    let sum: f64 = (0..N).map(|i| (values[i] * scale[i]).powi(2)).sum();
    (sum / N as f64).sqrt()
}

/// Power with which a scheme's error estimate falls.
fn order(scheme: Scheme) -> f64 {
    if scheme == Scheme::Dop853 { 8.0 } else { 5.0 }
}

fn controller(scheme: Scheme) -> Controller {
    match scheme {
        Scheme::Dop853 => Controller::new(order(scheme), 0.06, 0.9),
        Scheme::Rodas => Controller::new(order(scheme), 0.0, 0.9),
        Scheme::DormandPrince | Scheme::RungeKutta4 => Controller::new(order(scheme), 0.04, 0.9),
    }
}
