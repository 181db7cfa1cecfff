//! The journal of changes, and the motion carried along it.

use std::collections::VecDeque;

use super::{
    REACH,
    cursor::{Change, Cursor},
};
use crate::{
    error::{Code, Error, Result},
    integrate::failed,
    model::Gear,
};

/// Room made at the start: a change in every frame of the whole reach.
const CHANGES: usize = 60 * REACH as usize;

/// Changes with their times, in order.
pub(super) struct Journal {
    changes: VecDeque<(f64, Change)>,
    /// How many of the first are not here any more.
    forgotten: usize,
}

impl Journal {
    /// An empty journal.
    pub fn new() -> Self {
        Self { changes: VecDeque::with_capacity(CHANGES), forgotten: 0 }
    }

    /// Writes down the change with which `cursor` goes on at time `t`; what had been written after it is struck out.
    pub fn write<S: Gear<N>, const N: usize>(&mut self, cursor: &Cursor<S, N>, t: f64, change: Change) {
        self.changes.truncate(cursor.applied - self.forgotten);
        self.changes.push_back((t, change));
    }

    /// Forgets the changes before number `first`.
    pub fn forget_before(&mut self, first: usize) {
        while self.forgotten < first && self.changes.pop_front().is_some() {
            self.forgotten += 1;
        }
    }

    /// Brings `cursor` to time `t` (its last step ends there or later), with the changes on the way; `seen` looks at it
    /// after every step.
    ///
    /// # Errors
    /// A motion that cannot go on, or that takes more than `most_steps` steps; the cursor stays where it got to.
    pub fn follow<S: Gear<N>, const N: usize>(
        &self,
        cursor: &mut Cursor<S, N>,
        t: f64,
        most_steps: u64,
        mut seen: impl FnMut(&mut Cursor<S, N>),
    ) -> Result<()> {
        let mut left = most_steps;
        loop {
            let next = self.changes.get(cursor.applied - self.forgotten).filter(|(time, _)| *time <= t);
            let target = next.map_or(t, |(time, _)| *time);
            while cursor.integrator.time() < target {
                let time = cursor.integrator.time();
                if left == 0 {
                    return Err(Error::new(Code::StepLimit, "maxSteps", time.to_string(), most_steps.to_string()));
                }
                left -= 1;
                cursor.integrator.step(f64::INFINITY).map_err(|failure| failed(failure, time))?;
                seen(cursor);
            }
            let Some(&(time, change)) = next else { return Ok(()) };
            cursor.apply(time, change).map_err(|failure| failed(failure, time))?;
        }
    }
}
