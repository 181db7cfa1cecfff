//! The landing roll: from touchdown until the aircraft is slow.

use crate::{
    error::Result,
    integrate::{Solving, Trajectory},
    model::{
        Assembly,
        assembly::{Roll, STATES},
    },
    run::{Run, Value},
};

/// Steps at a time: a fraction of a millisecond.
const STEPS: u64 = 400;

/// A landing roll under way: a run whose speed falls, v(t) = v₀ − bt, while weight comes on and the gear may shake.
///
/// # Equations
/// Those of the gear with v(t) and F_z(v) ([`Roll`]), its damper and its runway; all that a run may have.
///
/// # Limits
/// b is kinematic: no load moves to the nose. A wheel that starts to shake does so with a delay, as its swing must grow first;
/// one that stops does so where the branch of cycles folds.
///
/// # Example
/// ```
/// use shimmy::{Run, scenario::LandingRoll};
///
/// // Without a damper it shakes from 80 m/s on; a current of 1 A calms it before the end.
/// let gear = Run::of("torsional")?.with("dampingConstant", 20.0)?.starting("torsionAngle", 0.01)?.drawn(2000.0)?;
/// let amplitude = |run: Run| {
///     let landing = LandingRoll::of(run)?.made()?;
///     let fast = landing.velocity.iter().zip(&landing.trajectory.states[0]).filter(|(v, _)| **v > 60.0);
///     Ok::<f64, shimmy::Error>(fast.fold(0.0, |most, (_, psi)| most.max(psi.abs())))
/// };
/// assert!(amplitude(gear.clone())? > 0.2);
/// assert!(amplitude(gear.fitted("modified-bouc-wen")?.with("damper.command", 1.5)?)? < 0.02);
/// # Ok::<(), shimmy::Error>(())
/// ```
pub struct LandingRoll {
    way: Solving<Assembly, STATES>,
    roll: Roll,
    run: Run,
    done: bool,
}

/// A landing roll, as far as it has come.
#[derive(Clone, Debug, PartialEq)]
pub struct Landing {
    /// The motion.
    pub trajectory: Trajectory,
    /// The speed at its times \[m/s\].
    pub velocity: Vec<f64>,
}

impl LandingRoll {
    /// Reads a run, which need not say that it rolls.
    ///
    /// # Errors
    /// As [`Run::read`] and [`LandingRoll::of`].
    pub fn read(input: &Value) -> Result<Self> {
        Self::of(Run::read(input)?)
    }

    /// The roll of a run, with the roll's defaults where it says nothing of it.
    ///
    /// # Errors
    /// As [`Run::simulate`].
    pub fn of(run: Run) -> Result<Self> {
        let run = if run.roll().is_some() { run } else { run.rolling()? };
        let (way, roll) = run.landing()?;
        Ok(Self { way, roll, run, done: false })
    }

    /// Rolls a little further, for a fraction of a millisecond.
    ///
    /// # Errors
    /// As [`Run::simulate`].
    pub fn advance(&mut self) -> Result<()> {
        if !self.done {
            self.done = self.way.advance(STEPS)?;
        }
        Ok(())
    }

    /// It has come to its end.
    pub fn done(&self) -> bool {
        self.done
    }

    /// The part of its time that is over, 0 … 1.
    pub fn fraction(&self) -> f64 {
        if self.done { 1.0 } else { self.way.fraction() }
    }

    /// The run that rolls.
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// What there is of it.
    pub fn landing(&self) -> Landing {
        let trajectory = self.way.trajectory();
        let velocity = trajectory.time.iter().map(|t| self.roll.velocity(*t)).collect();
        Landing { trajectory, velocity }
    }

    /// The whole of it.
    ///
    /// # Errors
    /// As [`LandingRoll::advance`].
    pub fn made(mut self) -> Result<Landing> {
        while !self.done {
            self.advance()?;
        }
        Ok(self.landing())
    }
}
