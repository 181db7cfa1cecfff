//! The one driver of all schemes.

use std::sync::Arc;

use super::{
    controller::{Controller, power},
    dense::{COEFFICIENTS, Dense},
    dop853, dormand_prince,
    locate::{Ends, Locator, bracketed},
    method::{Method, Scheme},
    rodas, runge_kutta4,
    stages::{Attempt, MOST, Stages},
};
use crate::{
    model::{Mode, System},
    real::Dual,
};

/// What a step may be wrong by: rtol·|x| + atol in each component, as a root mean square.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance<const N: usize> {
    /// Relative.
    pub relative: f64,
    /// Absolute, in the unit of each state.
    pub absolute: [f64; N],
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

/// Why no step could be taken. The motion stays where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The state left the finite numbers.
    Diverged,
    /// The step fell below what the time can resolve.
    StepTooSmall,
}

/// Most switches of a system: a bit each, and room for their values.
const MOST_SWITCHES: usize = 8;

/// Explicit steps in a row that must look stiff before a run counts as such, and how often one looks.
const STIFF_IN_A_ROW: u32 = 15;
const STIFF_INTERVAL: u64 = 25;

/// Values and slopes of the switches at one moment, and a bit for each that applies in its mode.
#[derive(Clone, Copy, Debug, Default)]
struct Switches {
    active: u32,
    value: [f64; MOST_SWITCHES],
    slope: [f64; MOST_SWITCHES],
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
    length: f64,
    from_mode: Mode,
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
            length: 0.0,
            from_mode: Mode::default(),
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
    pub fn replace(&mut self, system: S, t: f64, x: [f64; N]) -> Result<(), Failure> {
        let before = std::mem::replace(&mut self.system, Arc::new(system));
        self.restart(t, x).inspect_err(|_| self.system = before)
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

    /// The system that moves.
    pub fn system(&self) -> &S {
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

    /// The state at time `t` within the last step, by its dense output.
    pub fn interpolate(&mut self, t: f64) -> [f64; N] {
        if t >= self.t || self.length == 0.0 {
            return self.x;
        }
        if t <= self.from_t {
            return self.from_x;
        }
        self.prepare_dense();
        self.dense.at((t - self.from_t) / self.length)
    }

    /// Whether the motion at time `t` within the last step, and its rate there, are finite numbers.
    pub(crate) fn is_finite_at(&mut self, t: f64) -> bool {
        let x = self.interpolate(t);
        let rates = [self.system.rate(t, self.mode, &x), self.system.rate(self.t, self.mode, &self.x)];
        x.iter().chain(rates.as_flattened()).all(|value| value.is_finite())
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
        self.x = attempt.end;
        self.dense_ready = false;
        self.stats.steps += 1;
        if self.stats.steps.is_multiple_of(STIFF_INTERVAL) || self.stiff_looking > 0 {
            self.look_for_stiffness(h, &attempt, &end_rate);
        }
        self.start_rate = std::mem::replace(&mut self.f, end_rate);
        if S::SWITCHES > 0
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
            // A remainder shorter than a tenth of a step would be a step of its own: stretch or land exactly.
            let mut h = self.h;
            if self.scheme == Scheme::RungeKutta4 {
                h = self.to_grid();
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
        let scale: [f64; N] = std::array::from_fn(|i| {
            let (start, end) = (self.x[i].abs(), attempt.end[i].abs());
            let size = if start > end { start } else { end };
            1.0 / (self.tolerance.absolute[i] + self.tolerance.relative * size)
        });
        let error = match self.scheme {
            Scheme::DormandPrince => root_mean_square(&dormand_prince::error(h, k), &scale),
            Scheme::Dop853 => dop853::error(h, k, &scale),
            Scheme::RungeKutta4 => 0.0,
            Scheme::Rodas => root_mean_square(&rodas::error(k), &scale),
        };
        let finite = attempt.end.iter().all(|x| x.is_finite());
        (attempt, if finite { error } else { f64::INFINITY })
    }

    /// Derivative at the end of an accepted step, where the next step starts.
    #[inline(always)]
    fn end_rate(&mut self, t: f64, x: &[f64; N]) -> [f64; N] {
        if self.scheme == Scheme::DormandPrince {
            return self.k[dormand_prince::END];
        }
        self.stats.evaluations += 1;
        let rate = self.system.rate(t, self.mode, x);
        if self.scheme == Scheme::Dop853 {
            self.k[dop853::END] = rate;
        }
        rate
    }

    /// The turning point of `component` within the last step: its time and value, where its rate changes sign.
    pub fn turning_point(&mut self, component: usize) -> Option<(f64, f64)> {
        if self.start_rate[component] * self.f[component] >= 0.0 || self.length == 0.0 {
            return None;
        }
        self.prepare_dense();
        let rising = self.start_rate[component] > 0.0;
        let slope = |theta: f64| self.dense.slope(theta, component) * if rising { 1.0 } else { -1.0 };
        if slope(0.0) <= 0.0 || slope(1.0) >= 0.0 {
            return None;
        }
        let theta = bracketed(0.0, 1.0, &slope);
        Some((self.from_t + theta * self.length, self.dense.at(theta)[component]))
    }

    /// The time at which `component` rises through 0 within the last step.
    pub fn rise_through_zero(&mut self, component: usize) -> Option<f64> {
        if !(self.from_x[component] < 0.0 && self.x[component] >= 0.0) {
            return None;
        }
        self.prepare_dense();
        let below = |theta: f64| -self.dense.at(theta)[component];
        Some(self.from_t + bracketed(0.0, 1.0, &below) * self.length)
    }

    fn prepare_dense(&mut self) {
        if self.dense_ready {
            return;
        }
        let (x0, x1, h) = (&self.from_x, &self.x, self.length);
        self.dense = match self.scheme {
            Scheme::DormandPrince => dormand_prince::dense(x0, x1, h, &self.k),
            Scheme::Dop853 => {
                self.stats.evaluations += 3;
                dop853::dense(&*self.system, self.from_mode, self.from_t, (x0, x1), h, &mut self.k)
            }
            Scheme::RungeKutta4 => runge_kutta4::dense(x0, x1, &self.f, h, &self.k),
            Scheme::Rodas => rodas::dense(x0, x1, &self.k),
        };
        self.dense_ready = true;
    }

    /// The first switch within the step just taken, and where.
    #[inline(always)]
    fn first_switch(&mut self, h: f64) -> Option<(usize, f64)> {
        let (fresh, start) = (self.fresh, self.switches);
        self.look_at_switches();
        let (mut suspects, mut certain) = (0_u32, 0_u32);
        for which in 0..S::SWITCHES {
            if start.active >> which & 1 == 0 {
                continue;
            }
            let ends = Ends {
                start: start.value[which],
                start_slope: h * start.slope[which],
                end: self.switches.value[which],
                end_slope: h * self.switches.slope[which],
            };
            if ends.end > 0.0 {
                self.fresh &= !(1 << which);
            }
            let fresh = fresh >> which & 1 == 1;
            if !ends.stays_positive(fresh) {
                suspects |= 1 << which;
                certain |= u32::from(ends.falls_once(fresh)) << which;
            }
        }
        if suspects == 0 { None } else { self.locate(suspects, certain, fresh) }
    }

    /// Values and slopes of the switches at the end of the last step, where the next one starts.
    #[inline(always)]
    fn look_at_switches(&mut self) {
        const { assert!(S::SWITCHES <= MOST_SWITCHES) };
        let along: [Dual<1>; N] = std::array::from_fn(|i| Dual { value: self.x[i], slope: [self.f[i]] });
        self.switches.active = 0;
        for which in 0..S::SWITCHES {
            if let Some(value) = self.system.switch(which, Dual::variable(self.t, 0), self.mode, &along) {
                self.switches.active |= 1 << which;
                self.switches.value[which] = value.value;
                self.switches.slope[which] = value.slope[0];
            }
        }
    }

    /// The first of the suspected switches on the dense output, and the θ where it falls; of the certain ones it is
    /// known that they fall once.
    #[inline(never)]
    fn locate(&mut self, suspects: u32, certain: u32, fresh: u32) -> Option<(usize, f64)> {
        self.prepare_dense();
        let mut first: Option<(usize, f64)> = None;
        for which in (0..S::SWITCHES).filter(|which| suspects >> which & 1 == 1) {
            let value = |theta: f64| {
                let t = self.from_t + theta * self.length;
                self.system.switch(which, t, self.mode, &self.dense.at(theta)).unwrap_or(1.0)
            };
            let fall = if certain >> which & 1 == 1 {
                Some(bracketed(0.0, 1.0, &value))
            } else {
                self.locator.first(fresh >> which & 1 == 1, value)
            };
            if let Some(theta) = fall
                && first.is_none_or(|(_, earliest)| theta < earliest)
            {
                first = Some((which, theta));
            }
        }
        if first.is_some() {
            // The step is cut at the switch: what was fresh at its start may still be.
            self.fresh = fresh;
        }
        first
    }

    /// Takes the step again up to the switch, with the full order of the scheme, and changes the mode there.
    #[inline(never)]
    fn stop_at(&mut self, which: usize, theta: f64) -> Result<Outcome, Failure> {
        let h = theta * self.length;
        self.k[0] = self.start_rate;
        (self.t, self.x) = (self.from_t, self.from_x);
        if self.t + h > self.t {
            let (attempt, _) = self.attempt(h);
            (self.t, self.x, self.length) = (self.t + h, attempt.end, h);
            self.in_place = 0;
        } else {
            self.length = 0.0;
            self.in_place += 1;
        }
        if !self.x.iter().all(|x| x.is_finite()) || self.in_place > 4 * S::SWITCHES as u32 {
            return Err(Failure::StepTooSmall);
        }
        self.end_rate(self.t, &self.x.clone());
        self.dense_ready = false;
        self.stats.events += 1;
        self.mode = self.system.cross(which, self.mode);
        self.f = self.system.rate(self.t, self.mode, &self.x);
        self.stats.evaluations += 1;
        self.look_at_switches();
        for other in 0..S::SWITCHES {
            if self.switches.active >> other & 1 == 0 || self.switches.value[other] > 0.0 {
                self.fresh &= !(1 << other);
            }
        }
        self.fresh |= 1 << which;
        Ok(Outcome::Switch(which))
    }

    /// Hairer's test: the quotient of differences of the last two stages estimates the largest eigenvalue; a step that
    /// sits at the edge of the stability region again and again is held there by stiffness.
    #[inline(never)]
    fn look_for_stiffness(&mut self, h: f64, attempt: &Attempt<N>, end_rate: &[f64; N]) {
        let (stage_rate, edge) = match self.scheme {
            Scheme::DormandPrince => (&self.k[5], 3.25),
            Scheme::Dop853 => (&self.k[11], 6.1),
            Scheme::RungeKutta4 | Scheme::Rodas => return,
        };
        let (mut rates, mut states) = (0.0, 0.0);
        for i in 0..N {
            rates += ((end_rate[i] - stage_rate[i]) / self.tolerance.absolute[i]).powi(2);
            states += ((attempt.end[i] - attempt.last_stage[i]) / self.tolerance.absolute[i]).powi(2);
        }
        if states > 0.0 && h * (rates / states).sqrt() > edge {
            self.stiff_looking += 1;
        } else {
            self.stiff_looking = 0;
        }
        if self.stiff_looking == STIFF_IN_A_ROW {
            self.stats.stiff = true;
            self.stiff_looking = 0;
            // From the next step on: the dense output of this one still reads its stages.
            self.going_stiff = self.method == Method::Auto;
        }
    }

    /// Writes or reads every number of the motion but its system and settings, which are given. False where what was
    /// read makes no sense.
    pub(crate) fn code(&mut self, codec: &mut dyn crate::live::Codec, system: S) -> bool {
        self.system = Arc::new(system);
        let (mut mode, mut from_mode, mut fresh) = (self.mode.0.into(), self.from_mode.0.into(), self.fresh.into());
        let (mut looking, mut in_place) = (self.stiff_looking.into(), self.in_place.into());
        let mut scheme = SCHEMES.iter().position(|scheme| *scheme == self.scheme).unwrap_or(0) as u64;
        let (mut stiff, mut going) = (u64::from(self.stats.stiff), u64::from(self.going_stiff));
        let Stats { steps, rejected, evaluations, events, .. } = &mut self.stats;
        let flags =
            [&mut mode, &mut from_mode, &mut fresh, &mut looking, &mut in_place, &mut scheme, &mut stiff, &mut going];
        let mut sound = true;
        for bits in flags {
            codec.bits(bits);
            sound &= *bits <= u64::from(u32::MAX >> 1);
        }
        for count in [steps, rejected, evaluations, events] {
            codec.bits(count);
            sound &= *count < 1 << 53;
        }
        for number in [&mut self.t, &mut self.h, &mut self.from_t, &mut self.length] {
            codec.number(number);
        }
        let vectors = [&mut self.x, &mut self.from_x, &mut self.f, &mut self.start_rate];
        for number in vectors.into_iter().chain(&mut self.k).flatten() {
            codec.number(number);
        }
        let Some(scheme) = SCHEMES.get(scheme as usize) else { return false };
        self.scheme = *scheme;
        self.controller = controller(*scheme);
        sound &= self.controller.code(codec);
        (self.mode, self.from_mode, self.fresh) = (Mode(mode as u32), Mode(from_mode as u32), fresh as u32);
        (self.stiff_looking, self.in_place, self.stats.stiff) = (looking as u32, in_place as u32, stiff != 0);
        self.going_stiff = going != 0;
        self.dense_ready = false;
        self.look_at_switches();
        sound && self.h > 0.0 && self.length >= 0.0
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

/// The schemes by the numbers that snapshots know them by.
const SCHEMES: [Scheme; 4] = [Scheme::DormandPrince, Scheme::Dop853, Scheme::RungeKutta4, Scheme::Rodas];

fn controller(scheme: Scheme) -> Controller {
    match scheme {
        Scheme::Dop853 => Controller::new(order(scheme), 0.06, 0.9),
        Scheme::Rodas => Controller::new(order(scheme), 0.0, 0.9),
        Scheme::DormandPrince | Scheme::RungeKutta4 => Controller::new(order(scheme), 0.04, 0.9),
    }
}
