//! Switches: where a step meets one, and how it stops there.

use super::{
    super::{
        locate::{Ends, Fresh},
        stages::Attempt,
    },
    Failure, Integrator, Outcome, root_mean_square,
};
use crate::{
    model::{Mode, System},
    real::Dual,
};

/// Most switches of a system: a bit each, and room for their values.
const MOST_SWITCHES: usize = 18;

/// Values and slopes of the switches at one moment, and a bit for each that applies in its mode.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Switches {
    pub active: u32,
    pub value: [f64; MOST_SWITCHES],
    pub slope: [f64; MOST_SWITCHES],
    /// Of the suspected ones: their slopes at the start of the last step, per step.
    pub start_slope: [f64; MOST_SWITCHES],
}

/// What a look at the switches has shown: a bit for each that may fall in the step, the first that surely does, and whether
/// there is one that must be looked at more closely.
#[derive(Default)]
struct Seen {
    suspects: u32,
    first: Option<(usize, f64)>,
    unclear: bool,
}

impl Switches {
    /// Puts in the value and slope of one switch, and gives back what was there. One by one: a copy of the whole is a
    /// call in WebAssembly.
    #[inline(always)]
    fn replace(&mut self, which: usize, (value, slope): (f64, f64)) -> (f64, f64) {
        (std::mem::replace(&mut self.value[which], value), std::mem::replace(&mut self.slope[which], slope))
    }
}

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// The first switch within the step just taken, and where. Looks at all of them at its end.
    #[inline(always)]
    pub(super) fn first_switch(&mut self, h: f64) -> Option<(usize, f64)> {
        let fresh_at_start = self.fresh;
        let mut seen = Seen::default();
        for which in 0..S::SWITCHES - S::SELDOM {
            self.look_at(which, h, fresh_at_start, &mut seen);
        }
        if S::SELDOM > 0 && self.system.minds(self.mode) {
            for which in S::SWITCHES - S::SELDOM..S::SWITCHES {
                self.look_at(which, h, fresh_at_start, &mut seen);
            }
        }
        if seen.suspects == 0 {
            return None;
        }
        let first = if seen.unclear { self.locate(seen.suspects, fresh_at_start) } else { seen.first };
        if first.is_some() {
            // The step is cut at the switch: what was fresh at its start may still be.
            self.fresh = fresh_at_start;
        }
        first
    }

    /// Looks at one switch at the end of the step just taken.
    #[inline(always)]
    fn look_at(&mut self, which: usize, h: f64, fresh_at_start: u32, seen: &mut Seen) {
        // Within a step a switch applies throughout, or not at all.
        let now = self.system.switch(which, Dual::variable(self.t, 0), self.mode, &self.along());
        let Some(now) = now else { return };
        let before = self.switches.replace(which, (now.value, now.slope[0]));
        let ends = Ends { start: before.0, start_slope: h * before.1, end: now.value, end_slope: h * now.slope[0] };
        if ends.end > 0.0 {
            self.fresh &= !(1 << which);
        }
        let fresh = fresh_at_start >> which & 1 == 1;
        if !ends.stays_positive(fresh) {
            seen.suspects |= 1 << which;
            self.switches.start_slope[which] = ends.start_slope;
            if ends.falls_once(fresh) {
                // Near enough for `stop_at`, which goes on from there.
                let theta = ends.fall();
                if seen.first.is_none_or(|(_, earliest)| theta < earliest) {
                    seen.first = Some((which, theta));
                }
            } else {
                seen.unclear = true;
            }
        }
    }

    /// The state at the end of the last step, with its slope in time.
    #[inline(always)]
    fn along(&self) -> [Dual<1>; N] {
        std::array::from_fn(|i| Dual { value: self.x[i], slope: [self.f[i]] })
    }

    /// Values and slopes of the switches at the end of the last step, where the next one starts.
    #[inline(always)]
    pub(super) fn look_at_switches(&mut self) {
        const { assert!(S::SWITCHES <= MOST_SWITCHES) };
        let along = self.along();
        self.switches.active = 0;
        for which in 0..S::SWITCHES {
            if let Some(value) = self.system.switch(which, Dual::variable(self.t, 0), self.mode, &along) {
                self.switches.active |= 1 << which;
                self.switches.replace(which, (value.value, value.slope[0]));
            }
        }
    }

    /// The first of the suspected switches on the dense output, and the θ where it falls.
    #[inline(never)]
    fn locate(&mut self, suspects: u32, fresh: u32) -> Option<(usize, f64)> {
        self.prepare_dense();
        let mut first: Option<(usize, f64)> = None;
        for which in (0..S::SWITCHES).filter(|which| suspects >> which & 1 == 1) {
            let value = |theta: f64| {
                let t = self.from_t + theta * self.length;
                self.system.switch(which, t, self.mode, &self.dense.at(theta)).unwrap_or(1.0)
            };
            // At rest a switch is what its quantity is compared with.
            let size = self.system.switch(which, self.from_t, self.mode, &[0.0; N]).map_or(0.0, f64::abs);
            let fresh = (fresh >> which & 1 == 1).then(|| self.passed(which));
            if let Some(theta) = self.locator.first(fresh, size, &value)
                && first.is_none_or(|(_, earliest)| theta < earliest)
            {
                first = Some((which, theta));
            }
        }
        first
    }

    /// What is known of a suspected switch that was passed at the start of the last step.
    fn passed(&self, which: usize) -> Fresh {
        let gradient = self.gradient(which, self.from_t, self.mode, &self.from_x);
        // Within a step the dense output is somewhat less true than at its end.
        let scale = self.scale(&self.from_x).map(|scale| 0.1 * scale);
        let error = gradient.map_or(0.0, |gradient| (0..N).map(|i| gradient[i].abs() / scale[i]).sum());
        Fresh { slope: self.switches.start_slope[which], error }
    }

    /// How a switch changes with the state, where it applies.
    #[inline(never)]
    pub(super) fn gradient(&self, which: usize, t: f64, mode: Mode, x: &[f64; N]) -> Option<[f64; N]> {
        let seeded: [Dual<N>; N] = std::array::from_fn(|i| Dual::variable(x[i], i));
        self.system.switch(which, Dual::from(t), mode, &seeded).map(|switch| switch.slope)
    }

    /// Takes the step again up to the switch, with the full order of the scheme, and changes the mode there.
    #[inline(never)]
    pub(super) fn stop_at(&mut self, which: usize, theta: f64) -> Result<Outcome, Failure> {
        (self.t, self.x) = (self.from_t, self.from_x);
        self.dense_ready = false;
        let h = theta * self.length;
        if self.t + h > self.t {
            self.land_on(which, h);
            self.in_place = 0;
        } else {
            (self.length, self.reached) = (0.0, self.x);
            self.in_place += 1;
        }
        if !self.x.iter().all(|x| x.is_finite()) {
            return Err(Failure::Diverged);
        }
        self.stats.events += 1;
        self.landed = self.x;
        self.mode = self.system.cross(which, self.t, self.mode, &mut self.x);
        self.f = self.system.rate(self.t, self.mode, &self.x);
        self.stats.evaluations += 1;
        self.look_at_switches();
        for other in 0..S::SWITCHES {
            if self.switches.active >> other & 1 == 0 || self.switches.value[other] > 0.0 {
                self.fresh &= !(1 << other);
            } else if self.switches.value[other] == 0.0 {
                // As of a wheel that is let go: it is where it would stop.
                self.fresh |= 1 << other;
            }
        }
        self.fresh |= 1 << which;
        Ok(Outcome::Switch(which))
    }

    /// Ends a step for which the switches were not looked at, in the mode that its end says.
    ///
    /// Where a motion creeps along a boundary to within rounding, it can be called over and back again in one place. The
    /// laws are continuous there: either mode will do for a step.
    #[inline(never)]
    pub(super) fn pass_blindly(&mut self) {
        self.in_place = 0;
        self.mode = self.system.mode(self.t, &self.x);
        self.f = self.system.rate(self.t, self.mode, &self.x);
        self.stats.evaluations += 1;
        self.fresh = 0;
        self.look_at_switches();
        for which in 0..S::SWITCHES {
            self.fresh |=
                u32::from(self.switches.active >> which & 1 == 1 && self.switches.value[which] <= 0.0) << which;
        }
    }

    /// Steps by about `h` to where switch `which` is zero.
    ///
    /// The step ends near the switch; the rest δ of the way is a parabola with the curvature of the step's cubic, as long
    /// as what that adds is small. Where it is not, the step is taken once more, to the better place.
    fn land_on(&mut self, which: usize, mut h: f64) {
        let longest = self.length;
        for tries_left in (0..3).rev() {
            self.k[0] = self.start_rate;
            let (Attempt { end, .. }, _) = self.attempt(h);
            let rate = self.end_rate(self.from_t + h, &end);
            let along: [Dual<1>; N] = std::array::from_fn(|i| Dual { value: end[i], slope: [rate[i]] });
            let delta = match self.system.switch(which, Dual::variable(self.from_t + h, 0), self.mode, &along) {
                Some(Dual { value, slope: [slope] }) if slope < 0.0 => -value / slope,
                _ => 0.0,
            };
            // A switch that hardly changes any more is not sought beyond the step.
            let delta = if delta > longest - h { longest - h } else { delta };
            let bend: [f64; N] = std::array::from_fn(|i| {
                let mean = (end[i] - self.from_x[i]) / h;
                0.5 * delta * (delta / h) * (2.0 * self.start_rate[i] + 4.0 * rate[i] - 6.0 * mean)
            });
            let better = h + delta;
            let small = better > 0.0 && root_mean_square(&bend, &self.scale(&end)) < 0.1;
            if small || tries_left == 0 || better <= 0.0 || better > longest {
                (self.reached, self.length) = (end, h);
                self.t = self.from_t + h;
                self.x = end;
                if small {
                    self.t += delta;
                    self.x = std::array::from_fn(|i| end[i] + delta * rate[i] + bend[i]);
                }
                return;
            }
            h = better;
        }
    }
}
