//! Switches: where a step meets one, and how it stops there.

use super::{
    super::locate::{Ends, bracketed},
    Failure, Integrator, Outcome,
};
use crate::{model::System, real::Dual};

/// Most switches of a system: a bit each, and room for their values.
const MOST_SWITCHES: usize = 8;

/// Values and slopes of the switches at one moment, and a bit for each that applies in its mode.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Switches {
    pub active: u32,
    pub value: [f64; MOST_SWITCHES],
    pub slope: [f64; MOST_SWITCHES],
}

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// The first switch within the step just taken, and where.
    #[inline(always)]
    pub(super) fn first_switch(&mut self, h: f64) -> Option<(usize, f64)> {
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
    pub(super) fn look_at_switches(&mut self) {
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
    pub(super) fn stop_at(&mut self, which: usize, theta: f64) -> Result<Outcome, Failure> {
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
}
