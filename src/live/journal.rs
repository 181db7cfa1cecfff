//! The journal of changes, and the motion carried along it.

use std::{collections::VecDeque, sync::Arc};

use super::{
    REACH,
    cursor::{Change, Cursor},
};
use crate::{
    error::{Error, Result},
    integrate::failed,
    model::Gear,
};

/// Room made at the start: a change in every frame of the whole reach.
const CHANGES: usize = 60 * REACH as usize;

/// The latest changes keep the systems that they led to, so that the last moments of a drag are lived again at the cost of
/// their steps; more would fill the memory.
const SYSTEMS: usize = 512;

/// A change, when it was made, and the system that holds since, for a while.
struct Entry<S> {
    time: f64,
    change: Change,
    system: Option<Arc<S>>,
}

/// Changes with their times, in order.
pub(super) struct Journal<S> {
    changes: VecDeque<Entry<S>>,
    /// How many of the first are not here any more.
    forgotten: usize,
}

impl<S> Journal<S> {
    /// An empty journal.
    pub fn new() -> Self {
        Self { changes: VecDeque::with_capacity(CHANGES), forgotten: 0 }
    }

    /// Writes down a change at `time` that follows `applied` others, with the system that it led to; what had been written
    /// after them is struck out.
    pub fn write(&mut self, applied: usize, time: f64, change: Change, system: &Arc<S>) {
        self.changes.truncate(applied - self.forgotten);
        if let Some(old) = self.changes.len().checked_sub(SYSTEMS) {
            self.changes[old].system = None;
        }
        let system = matches!(change, Change::Parameter { .. }).then(|| system.clone());
        self.changes.push_back(Entry { time, change, system });
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
    pub fn follow<const N: usize>(
        &self,
        cursor: &mut Cursor<S, N>,
        t: f64,
        most_steps: u64,
        mut seen: impl FnMut(&mut Cursor<S, N>),
    ) -> Result<()>
    where
        S: Gear<N>,
    {
        let mut left = most_steps;
        loop {
            let next = self.changes.get(cursor.applied - self.forgotten).filter(|entry| entry.time <= t);
            let target = next.map_or(t, |entry| entry.time);
            while cursor.integrator.time() < target {
                let time = cursor.integrator.time();
                if left == 0 {
                    return Err(Error::step_limit(time, most_steps));
                }
                left -= 1;
                cursor.integrator.step(f64::INFINITY).map_err(|failure| failed(failure, time))?;
                seen(cursor);
            }
            let Some(Entry { time, change, system }) = next else { return Ok(()) };
            cursor.apply(*time, *change, system.as_ref()).map_err(|failure| failed(failure, *time))?;
        }
    }
}
