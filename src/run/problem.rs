//! Where the type of a model is known for the last time.

use super::Run;
use crate::{
    cycles::{self, Guess, LimitCycle},
    energy::{self, Energy},
    error::{Code, Error, Result, shown, shown_short},
    few::padded,
    integrate::{Integrator, Method, Scheme, Solving, Tolerance, Trajectory, failed, solve},
    live::{Motion, Simulator},
    model::{
        Assembly, Gear, Model, Tables,
        assembly::{self, Roll, STATES},
    },
    outlook::{Looking, Lookout},
    section::{self, Section, SectionSpec},
    stability::eigenvalues,
};

/// A run whose model has been chosen. Calls through it happen once a trajectory, never within one.
pub trait Problem {
    /// The trajectory from start to end.
    ///
    /// # Errors
    /// As [`Run::simulate`].
    fn solve(&self) -> Result<Trajectory>;
    /// What becomes of the motion, bit by bit.
    ///
    /// # Errors
    /// As [`Run::outlook`].
    fn lookout(&self) -> Result<Box<dyn Lookout>>;
    /// The live motion.
    ///
    /// # Errors
    /// As [`Run::live`].
    fn live(&self) -> Result<Simulator>;
    /// The energy of a cycle.
    ///
    /// # Errors
    /// As [`Run::energy`].
    fn energy(&self) -> Result<Option<Energy>>;
    /// Where the motion passes a section.
    ///
    /// # Errors
    /// As [`Run::section`].
    fn section(&self, section: &SectionSpec) -> Result<Section>;
    /// The limit cycle.
    ///
    /// # Errors
    /// As [`Run::limit_cycle`].
    fn limit_cycle(&self, guess: Option<&Guess>) -> Result<Option<LimitCycle>>;
}

/// A run with the system of its model.
pub(crate) struct Posed<S: 'static, const N: usize> {
    pub run: Run,
    pub tables: &'static Tables<S>,
    pub system: S,
}

impl Run {
    /// The run with its model's type erased.
    pub fn problem(&self) -> Box<dyn Problem> {
        if !self.parts.none() {
            let Some(tables) = assembly::tables(self.model, self.parts) else {
                unreachable!("a run is of listed parts")
            };
            return Box::new(Posed::<_, STATES>::new(self.clone(), tables));
        }
        macro_rules! pose {
            ($($n:literal, $model:ty;)*) => {
                $(if self.model == <$model>::NAME {
                    return Box::new(Posed::new(self.clone(), Tables::of::<$n, $model>()));
                })*
            };
        }
        crate::for_each_model!(pose);
        unreachable!("a run is made for a listed model")
    }
}

impl Run {
    /// A run whose speed falls, at its start.
    ///
    /// # Errors
    /// As [`Run::simulate`].
    pub(crate) fn landing(&self) -> Result<(Solving<Assembly, STATES>, Roll)> {
        let (Some(tables), Some(roll)) = (assembly::tables(self.model, self.parts), self.roll()) else {
            unreachable!("it rolls")
        };
        let posed = Posed::<_, STATES>::new(self.clone(), tables);
        posed.check_step_count(self.duration())?;
        let motion = posed.motion(f64::INFINITY)?;
        Ok((Solving::new(motion, self.duration(), self.output.clone(), self.max_steps)?, roll))
    }
}

/// Largest |hλ| that the classical method takes without growing, least of all directions that matter (imaginary axis
/// 2.83, real axis 2.79).
const RK4_STABLE: f64 = 2.7;

impl<S: Gear<N>, const N: usize> Posed<S, N> {
    pub fn new(run: Run, tables: &'static Tables<S>) -> Self {
        let system = tables.system(&run.parameters);
        Self { run, tables, system }
    }

    /// The state at t = 0.
    pub fn initial(&self) -> [f64; N] {
        padded(&self.run.initial, 0.0)
    }

    /// The motion at t = 0, with no step longer than `longest_step`.
    pub fn motion(&self, longest_step: f64) -> Result<Integrator<S, N>> {
        let Run { rtol, atol, step, .. } = self.run;
        let states = self.tables.description.state;
        let absolute: Vec<f64> = states.iter().map(|s| atol.unwrap_or(rtol / 100.0 * s.scale)).collect();
        if self.run.method == Method::Always(Scheme::RungeKutta4) {
            check_fixed_step(&self.system, &self.initial(), step)?;
        }
        let tolerance = Tolerance::of(rtol, &absolute);
        Integrator::new(self.system.clone(), self.run.method, tolerance, step, longest_step, self.initial())
            .map_err(|failure| failed(failure, 0.0))
    }

    /// Checks that a fixed step gets through `duration` s.
    pub fn check_step_count(&self, duration: f64) -> Result<()> {
        let Run { step, max_steps, .. } = self.run;
        if self.run.method == Method::Always(Scheme::RungeKutta4) && duration / step > max_steps as f64 {
            let allowed = format!("long enough to reach {} s in {max_steps} steps (maxSteps)", shown(duration));
            return Err(Error::new(Code::TooLarge, "step", shown(step), allowed));
        }
        Ok(())
    }
}

impl<S: Gear<N>, const N: usize> Problem for Posed<S, N> {
    fn solve(&self) -> Result<Trajectory> {
        self.check_step_count(self.run.duration())?;
        solve(self.motion(f64::INFINITY)?, self.run.duration(), &self.run.output, self.run.max_steps)
    }

    fn lookout(&self) -> Result<Box<dyn Lookout>> {
        self.run.check_steady("an outlook")?;
        Ok(Box::new(Looking::of(Posed::new(self.run.clone(), self.tables))?))
    }

    fn live(&self) -> Result<Simulator> {
        Ok(Simulator::new(Box::new(Motion::start(Posed::new(self.run.clone(), self.tables))?)))
    }

    fn energy(&self) -> Result<Option<Energy>> {
        energy::of(self)
    }

    fn section(&self, section: &SectionSpec) -> Result<Section> {
        section::of(self, section)
    }

    fn limit_cycle(&self, guess: Option<&Guess>) -> Result<Option<LimitCycle>> {
        cycles::limit_cycle(self, guess)
    }
}

/// A fixed step must be stable: beyond that, its result would be finite and worthless. Looked at where the motion is, in
/// its mode, and with the spring at work where it is in the gap now.
pub(crate) fn check_fixed_step<S: Gear<N>, const N: usize>(system: &S, x: &[f64; N], step: f64) -> Result<()> {
    let fastest = fastest_rate(system, x).max(system.without_freeplay().map_or(0.0, |gear| fastest_rate(&gear, x)));
    if step * fastest > RK4_STABLE {
        let allowed = format!("at most {} s for rk4 with these parameters", shown_short(RK4_STABLE / fastest));
        return Err(Error::new(Code::Unsuited, "step", shown(step), allowed));
    }
    Ok(())
}

/// Largest |λ| of the Jacobian at `x`; 0 where it is not finite (the motion itself says so).
fn fastest_rate<S: Gear<N>, const N: usize>(system: &S, x: &[f64; N]) -> f64 {
    // A wheel that friction holds may be released: looked at as it turns.
    let x = &if system.sticks() { system.kicked(x, 1.0) } else { *x };
    let rows = system.jacobian(0.0, system.mode(0.0, x), x);
    let matrix = nalgebra::DMatrix::from_fn(N, N, |i, j| rows[i][j]);
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return 0.0;
    }
    eigenvalues(&matrix).map_or(0.0, |values| values.iter().fold(0.0_f64, |most, value| most.max(value.norm())))
}
