//! A gear's motions while one of its parameters varies: where the type of its system is known for the last time.

use std::sync::Arc;

use super::line::Line;
use crate::{
    cycles::{
        MOST_STEPS,
        flow::{Carrier, Flow, RTOL},
    },
    error::Result,
    integrate::{Integrator, Method, Tolerance, failed},
    model::{Gear, Model, Tables},
    outlook::{End, look_ahead},
    parameter::StateVariable,
    run::{Posed, Run},
};

/// Most steps in a period.
const MOST_STEPS_A_PERIOD: u64 = 20_000;
/// Relative tolerance of a motion that is followed to where it settles.
const SETTLING: f64 = 1e-8;

/// Motions by the value of a parameter; states in units of their typical sizes.
pub(crate) trait Family {
    /// Goes over to another value of the parameter; says whether its equations are in finite numbers.
    fn vary(&mut self, value: f64) -> bool;

    /// The motions at the present value.
    fn flow(&mut self) -> &mut dyn Flow;

    /// Which pieces of the laws hold at a state.
    fn pieces(&self, x: &[f64]) -> u32;

    /// Where the motion from a state settles on a swing that repeats, and the time between two rises of its first state
    /// through zero.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn settled(&self, x: &[f64], horizon: f64) -> Result<Option<(Vec<f64>, f64)>>;
}

/// The family of a listed model.
///
/// # Errors
/// Parameters so extreme that the equations leave the numbers.
pub(crate) fn family(line: &Arc<Line>) -> Result<Box<dyn Family>> {
    macro_rules! pose {
        ($($n:literal, $model:ty;)*) => {
            $(if line.run().description().name == <$model>::NAME {
                return Ok(Box::new(posed(line, Tables::of::<$n, $model>())?));
            })*
        };
    }
    crate::for_each_model!(pose);
    unreachable!("a run is made for a listed model")
}

/// The family of a model's system.
fn posed<S: Gear<N>, const N: usize>(line: &Arc<Line>, tables: &'static Tables<S>) -> Result<Varied<S, N>> {
    let of = Arc::clone(line);
    let make = move |value| Ok(Posed::new(of.run_at(value)?, tables).system);
    Varied::new(Box::new(make), line.from(), line.run(), tables.description.state)
}

/// A system by the value of its parameter.
type Make<S> = Box<dyn Fn(f64) -> Result<S>>;

/// A system that varies.
pub(super) struct Varied<S, const N: usize> {
    make: Make<S>,
    value: f64,
    carrier: Carrier<S, N>,
    states: &'static [StateVariable],
}

impl<S: Gear<N>, const N: usize> Varied<S, N> {
    fn new(make: Make<S>, value: f64, run: &Run, states: &'static [StateVariable]) -> Result<Self> {
        let scale = std::array::from_fn(|i| states[i].scale);
        let carrier = Carrier::new(make(value)?, run.method(), run.rtol().min(RTOL), scale, 1.0, MOST_STEPS_A_PERIOD)?;
        Ok(Self { make, value, carrier, states })
    }

    fn own(&self, x: &[f64]) -> [f64; N] {
        std::array::from_fn(|i| x[i] * self.states[i].scale)
    }
}

impl<S: Gear<N>, const N: usize> Family for Varied<S, N> {
    fn vary(&mut self, value: f64) -> bool {
        if value == self.value {
            return true;
        }
        let Ok(system) = (self.make)(value) else { return false };
        let done = self.carrier.replace(system);
        if done {
            self.value = value;
        }
        done
    }

    fn flow(&mut self) -> &mut dyn Flow {
        &mut self.carrier
    }

    fn pieces(&self, x: &[f64]) -> u32 {
        self.carrier.system().mode(0.0, &self.own(x)).0
    }

    fn settled(&self, x: &[f64], horizon: f64) -> Result<Option<(Vec<f64>, f64)>> {
        let absolute = std::array::from_fn(|i| SETTLING / 100.0 * self.states[i].scale);
        let tolerance = Tolerance { relative: SETTLING, absolute };
        let system = self.carrier.system().clone();
        let motion = Integrator::new(system, Method::Auto, tolerance, 1.0, horizon / 20.0, self.own(x))
            .map_err(|failure| failed(failure, 0.0))?;
        let look = look_ahead(motion, self.states, horizon, MOST_STEPS)?;
        let (End::Repeats, Some(cycle)) = (look.end, look.destination) else { return Ok(None) };
        let x = look.motion.state().iter().zip(self.states).map(|(x, state)| x / state.scale).collect();
        Ok(Some((x, cycle.period)))
    }
}
