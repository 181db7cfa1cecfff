//! Moments kept, from which any later one is computed again.

use std::collections::VecDeque;

use super::{INTERVAL, REACH, cursor::Cursor};
use crate::model::Gear;

/// Room made at the start: keyframes of the whole reach.
const KEYFRAMES: usize = (REACH / INTERVAL) as usize + 4;

/// Cursors in the order of time, about one every [`INTERVAL`].
pub(super) struct Keyframes<S: 'static, const N: usize>(VecDeque<Cursor<S, N>>);

impl<S: Gear<N>, const N: usize> Keyframes<S, N> {
    /// With its first keyframe.
    pub fn from(first: Cursor<S, N>) -> Self {
        let mut keyframes = VecDeque::with_capacity(KEYFRAMES);
        keyframes.push_back(first);
        Self(keyframes)
    }

    /// Keeps `cursor` where a keyframe is due, and forgets what is out of reach.
    pub fn keep(&mut self, cursor: &Cursor<S, N>) {
        let place = |cursor: &Cursor<S, N>| (cursor.integrator.time() / INTERVAL).floor();
        if self.0.back().is_some_and(|last| place(last) >= place(cursor)) {
            return;
        }
        let oldest = cursor.integrator.step_start() - REACH;
        while self.0.len() > 1 && self.0[1].integrator.step_start() <= oldest {
            self.0.pop_front();
        }
        self.0.push_back(cursor.clone());
    }

    /// The earliest time that can be seen when `latest` is the last.
    pub fn earliest(&self, latest: f64) -> f64 {
        self.0.front().map_or(latest, |first| first.integrator.step_start().max(latest - REACH))
    }

    /// Changes made before the first keyframe.
    pub fn applied(&self) -> usize {
        self.0.front().map_or(0, |first| first.applied)
    }

    /// The keyframe at or before time `t`.
    pub fn before(&self, t: f64) -> Cursor<S, N> {
        let after = self.0.partition_point(|keyframe| keyframe.integrator.step_start() <= t);
        self.0[after.max(1) - 1].clone()
    }

    /// Forgets the keyframes after time `t`, but not the first.
    pub fn forget_after(&mut self, t: f64) {
        let kept = self.0.partition_point(|keyframe| keyframe.integrator.step_start() <= t);
        self.0.truncate(kept.max(1));
    }
}
