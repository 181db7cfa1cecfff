//! Every number of a motion, in order: for snapshots.

use std::sync::Arc;

use super::{
    super::method::{Method, Scheme},
    Integrator, Stats, Tolerance, controller,
};
use crate::model::{Mode, System};

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// Method, tolerances and steps, as numbers that tell them apart.
    pub(crate) fn settings(&self) -> impl Iterator<Item = u64> {
        let method = match self.method {
            Method::Auto => 0,
            Method::Always(scheme) => 1 + scheme.number(),
        };
        let Tolerance { relative, absolute } = self.tolerance;
        let numbers = [relative, self.fixed_step, self.longest_step].into_iter().chain(absolute);
        std::iter::once(method).chain(numbers.map(f64::to_bits))
    }

    /// Writes or reads every number of the motion but its system and settings, which are given. False where what was
    /// read makes no sense.
    pub(crate) fn code(&mut self, codec: &mut dyn crate::live::Codec, system: S) -> bool {
        self.system = Arc::new(system);
        let (mut mode, mut from_mode, mut fresh) = (self.mode.0.into(), self.from_mode.0.into(), self.fresh.into());
        let (mut looking, mut in_place) = (self.stiff_looking.into(), self.in_place.into());
        let mut scheme = self.scheme.number();
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
        let vectors = [&mut self.x, &mut self.from_x, &mut self.reached, &mut self.f, &mut self.start_rate];
        for number in vectors.into_iter().chain(&mut self.k).flatten() {
            codec.number(number);
        }
        let Some(scheme) = Scheme::numbered(scheme) else { return false };
        self.scheme = scheme;
        self.controller = self.controller.like(controller(scheme));
        sound &= self.controller.code(codec);
        (self.mode, self.from_mode, self.fresh) = (Mode(mode as u32), Mode(from_mode as u32), fresh as u32);
        (self.stiff_looking, self.in_place, self.stats.stiff) = (looking as u32, in_place as u32, stiff != 0);
        self.going_stiff = going != 0;
        self.dense_ready = false;
        self.look_at_switches();
        // A longer step than any run can ask for would be infinite once stretched, and be rejected for ever.
        sound && self.h > 0.0 && self.h <= 1e12 && self.length >= 0.0
    }
}
