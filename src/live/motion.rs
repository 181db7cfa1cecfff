//! The live motion of one model.

use super::{
    INTERVAL,
    cursor::{Change, Cursor},
    journal::Journal,
    keyframes::Keyframes,
    series::{Columns, Envelope},
    simulator::Live,
    snapshot,
};
use crate::{
    error::{Code, Error, Result, shown},
    integrate::Stats,
    model::{Description, Gear},
    parameter::{Validity, check_number, parameter_index, state_index},
    run::{MOST_SAMPLES, Posed, check_fixed_step},
};

/// Steps remembered for [`Live::trace`]; when they are full, they are thinned to half.
const TRACE: usize = 16_384;

/// The present, what was, and the steps not yet fetched.
pub(crate) struct Motion<S: 'static, const N: usize> {
    posed: Posed<S, N>,
    present: Cursor<S, N>,
    /// The time that is shown: within the last step of `present`.
    time: f64,
    /// The latest time that has been shown.
    latest: f64,
    keyframes: Keyframes<S, N>,
    journal: Journal<S>,
    trace: Columns,
}

impl<S: Gear<N>, const N: usize> Motion<S, N> {
    pub fn start(posed: Posed<S, N>) -> Result<Self> {
        let present = Cursor::new(posed.tables, posed.motion(INTERVAL)?, posed.run.parameters(), 0);
        let mut trace = Columns::with_capacity(posed.system.width(), TRACE);
        trace.push(0.0, present.integrator.state());
        let keyframes = Keyframes::from(present.clone());
        Ok(Self { posed, present, time: 0.0, latest: 0.0, keyframes, journal: Journal::new(), trace })
    }

    /// Makes a change now.
    fn change(&mut self, change: Change) -> Result<()> {
        let before = self.present.applied;
        self.present.apply(self.time, change, None).map_err(|_| {
            let at = shown(self.time);
            Error::new(Code::Diverged, "the motion", at, "with this change its rate is not finite; it goes on without")
        })?;
        self.journal.write(before, self.time, change, self.present.integrator.system());
        self.keyframes.forget_after(self.time);
        self.latest = self.time;
        // The rest of the step that was under way does not happen.
        self.trace.truncate_after(self.time);
        self.trace.push_within(TRACE, self.time, self.present.integrator.state());
        Ok(())
    }

    /// Checks a window of the past.
    fn check_window(&self, from: f64, to: f64, field: &str, count: f64, least: usize) -> Result<usize> {
        let [earliest, latest] = self.range();
        for (name, value) in [("from", from), ("to", to)] {
            if !(earliest..=latest).contains(&value) {
                let allowed = within(earliest, latest);
                return Err(Error::new(Code::OutOfRange, name, shown(value), allowed));
            }
        }
        if to < from {
            return Err(Error::new(Code::NotAscending, "to", shown(to), format!("≥ {} s (from)", shown(from))));
        }
        whole(field, count, least)
    }
}

fn within(earliest: f64, latest: f64) -> String {
    format!("within the range {} … {} s", shown(earliest), shown(latest))
}

/// A number of rows as a whole number.
fn whole(field: &str, count: f64, least: usize) -> Result<usize> {
    if count >= least as f64 && count <= MOST_SAMPLES as f64 && count.fract() == 0.0 {
        return Ok(count as usize);
    }
    let code = if count > MOST_SAMPLES as f64 { Code::TooLarge } else { Code::OutOfRange };
    Err(Error::new(code, field, shown(count), format!("a whole number from {least} to 1e7")))
}

impl<S: Gear<N>, const N: usize> Live for Motion<S, N> {
    fn description(&self) -> Description {
        self.posed.tables.description
    }

    fn time(&self) -> f64 {
        self.time
    }

    fn range(&self) -> [f64; 2] {
        [self.keyframes.earliest(self.latest), self.latest]
    }

    fn state(&mut self) -> Vec<f64> {
        self.present.integrator.interpolate(self.time)[..self.posed.system.width()].to_vec()
    }

    fn parameters(&self) -> Vec<f64> {
        self.present.parameters().to_vec()
    }

    fn stats(&self) -> Stats {
        self.present.integrator.stats()
    }

    fn advance(&mut self, dt: f64) -> Result<()> {
        let dt = check_number("dt", dt, Validity::NonNegative, "s")?;
        let target = self.time + dt;
        let Self { keyframes, trace, journal, present, .. } = self;
        let outcome = journal.follow(present, target, self.posed.run.max_steps(), |cursor| {
            keyframes.keep(cursor);
            trace.push_within(TRACE, cursor.integrator.time(), cursor.integrator.state());
        });
        self.journal.forget_before(self.keyframes.applied());
        self.time = if outcome.is_ok() { target } else { self.present.integrator.time() };
        self.latest = self.latest.max(self.time);
        outcome
    }

    fn set(&mut self, name: &str, value: f64) -> Result<()> {
        let table = self.description().table;
        let index = parameter_index(table, name)?;
        let value = table[index].check(value)?;
        if self.present.parameters()[index] == value {
            return Ok(());
        }
        let mut parameters = self.parameters();
        parameters[index] = value;
        self.description().check(&parameters)?;
        if let Some(step) = self.posed.run.fixed_step() {
            let x = self.present.integrator.interpolate(self.time);
            check_fixed_step(&self.posed.tables.system(&parameters), &x, step)?;
        }
        self.change(Change::Parameter { index, value })
    }

    fn set_state(&mut self, name: &str, value: f64) -> Result<()> {
        let table = self.description().state;
        let index = state_index(table, name)?;
        let value = check_number(name, value, Validity::Finite, table[index].unit)?;
        self.change(Change::State { index, value })
    }

    fn kick(&mut self, impulse: f64) -> Result<()> {
        let impulse = check_number("impulse", impulse, Validity::Finite, "N m s")?;
        self.change(Change::Kick { impulse })
    }

    fn reset(&mut self) -> Result<()> {
        *self = Self::start(Posed::new(self.posed.run.clone(), self.posed.tables))?;
        Ok(())
    }

    fn seek(&mut self, time: f64) -> Result<()> {
        let [earliest, latest] = self.range();
        if !(earliest..=latest).contains(&time) {
            let allowed = within(earliest, latest);
            return Err(Error::new(Code::OutOfRange, "time", shown(time), allowed));
        }
        let mut cursor = self.keyframes.before(time);
        self.journal.follow(&mut cursor, time, u64::MAX, |_| ())?;
        self.present = cursor;
        self.time = time;
        self.trace.clear();
        Ok(())
    }

    fn snapshot(&self) -> Vec<u8> {
        snapshot::write(&self.present, self.time)
    }

    fn restore(&mut self, bytes: &[u8]) -> Result<()> {
        let (present, time) = snapshot::read(bytes, &self.present)?;
        self.keyframes = Keyframes::from(present.clone());
        self.journal = Journal::new();
        self.trace.clear();
        (self.present, self.time, self.latest) = (present, time, time);
        Ok(())
    }

    fn trace(&mut self, most: f64) -> Result<Columns> {
        let most = whole("max", most, 2)?;
        // The step under way ends later than the time shown: its turn comes.
        let mut columns = self.trace.take_until(self.time);
        columns.thin(most);
        Ok(columns)
    }

    fn history(&self, from: f64, to: f64, samples: f64) -> Result<Columns> {
        let samples = self.check_window(from, to, "samples", samples, 2)?;
        let mut columns = Columns::with_capacity(self.posed.system.width(), samples);
        let mut cursor = self.keyframes.before(from);
        for row in 0..samples {
            let t = if row + 1 == samples { to } else { from + (to - from) * row as f64 / (samples - 1) as f64 };
            self.journal.follow(&mut cursor, t, u64::MAX, |_| ())?;
            columns.push(t, &cursor.integrator.interpolate(t));
        }
        Ok(columns)
    }

    fn envelope(&self, from: f64, to: f64, stretches: f64) -> Result<Envelope> {
        let stretches = self.check_window(from, to, "buckets", stretches, 1)?;
        let mut envelope = Envelope::over(from, to, stretches);
        let width = (to - from).max(f64::MIN_POSITIVE);
        let mut cursor = self.keyframes.before(from);
        self.journal.follow(&mut cursor, from, u64::MAX, |_| ())?;
        envelope.take(0.0, cursor.integrator.interpolate(from)[0]);
        let mut look = |cursor: &mut Cursor<S, N>| {
            let motion = &mut cursor.integrator;
            envelope.take((motion.time() - from) / width, motion.state()[0]);
            if let Some((t, value)) = motion.turning_point(0) {
                envelope.take((t - from) / width, value);
            }
        };
        // The step that `from` lies in has an end and perhaps a peak after it.
        look(&mut cursor);
        self.journal.follow(&mut cursor, to, u64::MAX, look)?;
        envelope.take(1.0, cursor.integrator.interpolate(to)[0]);
        Ok(envelope.close())
    }
}
