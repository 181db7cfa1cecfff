//! A gear's motions while one of its parameters varies: where the type of its system is known for the last time.

use std::rc::Rc;

use crate::{
    cycles::flow::{Carrier, Flow, RTOL},
    error::Result,
    integrate::{Integrator, Method, Tolerance, failed},
    model::{
        Gear, Model, Tables,
        assembly::{self, STATES},
    },
    outlook::{Ahead, End, STEPS},
    parameter::StateVariable,
    run::{Posed, Run},
};

/// Most steps in a period: what takes more is given up.
const MOST_STEPS_A_PERIOD: u64 = 5_000;
/// Relative tolerance of a motion that is followed to where it settles, and most of its steps: six seconds take some ten
/// thousand.
const SETTLING: f64 = 1e-8;
const MOST_STEPS: u64 = 100_000;

/// Motions by the value of a parameter; states in units of their typical sizes.
pub(crate) trait Family {
    /// Goes over to another value of the parameter; says whether its equations are in finite numbers.
    fn vary(&mut self, value: f64) -> bool;

    /// From now on a second parameter has another value, where there is one.
    fn aside(&mut self, other: f64);

    /// The motions at the present value.
    fn flow(&mut self) -> &mut dyn Flow;

    /// Which pieces of the laws hold at a state.
    fn pieces(&self, x: &[f64]) -> u32;

    /// The motion from a state, to be followed until it settles.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn settling(&self, x: &[f64], horizon: f64) -> Result<Box<dyn Settling>>;
}

/// A motion on its way to where it settles.
pub(crate) trait Settling {
    /// Follows it for a fraction of a millisecond; says whether it has come to its end.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn advance(&mut self) -> Result<bool>;

    /// Where it has settled on a swing that repeats, and the time between two rises of its first state through zero.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn end(self: Box<Self>) -> Result<Option<(Vec<f64>, f64)>>;
}

/// A gear by the value of its parameter, and of a second one.
pub(crate) type RunAt = Rc<dyn Fn(f64, f64) -> Result<Run>>;

/// The family of a listed model, first with these values.
///
/// # Errors
/// Parameters so extreme that the equations leave the numbers.
pub(crate) fn family(run_at: &RunAt, first: [f64; 2]) -> Result<Box<dyn Family>> {
    let run = run_at(first[0], first[1])?;
    let tables = run.description();
    if !tables.parts.none() {
        let Some(tables) = assembly::tables(tables.name, tables.parts) else {
            unreachable!("a run is of listed parts")
        };
        return Ok(Box::new(posed::<_, STATES>(run_at, &run, first, tables)?));
    }
    macro_rules! pose {
        ($($n:literal, $model:ty;)*) => {
            $(if tables.name == <$model>::NAME {
                return Ok(Box::new(posed(run_at, &run, first, Tables::of::<$n, $model>())?));
            })*
        };
    }
    crate::for_each_model!(pose);
    unreachable!("a run is made for a listed model")
}

/// The family of a model's system.
fn posed<S: Gear<N>, const N: usize>(
    run_at: &RunAt,
    run: &Run,
    first: [f64; 2],
    tables: &'static Tables<S>,
) -> Result<Varied<S, N>> {
    let run_at = Rc::clone(run_at);
    let make = move |[value, other]: [f64; 2]| Ok(Posed::new(run_at(value, other)?, tables).system);
    Varied::new(Box::new(make), first, (run.method(), run.rtol()), tables.description.state)
}

/// A system by the value of its parameter, and of a second one.
type Make<S> = Box<dyn Fn([f64; 2]) -> Result<S>>;

/// A system that varies.
pub(super) struct Varied<S, const N: usize> {
    make: Make<S>,
    values: [f64; 2],
    /// The second parameter as it will be from the next variation on.
    other: f64,
    carrier: Carrier<S, N>,
    states: &'static [StateVariable],
}

impl<S: Gear<N>, const N: usize> Varied<S, N> {
    /// A system by its parameters, which have values now; by a method, to a relative tolerance.
    fn new(
        make: Make<S>,
        values: [f64; 2],
        (method, rtol): (Method, f64),
        states: &'static [StateVariable],
    ) -> Result<Self> {
        let scale = states.iter().map(|state| state.scale).collect();
        let carrier = Carrier::new(make(values)?, method, rtol.min(RTOL), scale, 1.0, MOST_STEPS_A_PERIOD)?;
        Ok(Self { make, values, other: values[1], carrier, states })
    }
}

impl<S: Gear<N>, const N: usize> Family for Varied<S, N> {
    fn vary(&mut self, value: f64) -> bool {
        let values = [value, self.other];
        if values == self.values {
            return true;
        }
        let Ok(system) = (self.make)(values) else { return false };
        let done = self.carrier.replace(system);
        if done {
            self.values = values;
        }
        done
    }

    fn aside(&mut self, other: f64) {
        self.other = other;
    }

    fn flow(&mut self) -> &mut dyn Flow {
        &mut self.carrier
    }

    fn pieces(&self, x: &[f64]) -> u32 {
        self.carrier.system().mode(0.0, &self.carrier.own(x)).0
    }

    fn settling(&self, x: &[f64], horizon: f64) -> Result<Box<dyn Settling>> {
        let absolute: Vec<f64> = self.states.iter().map(|state| SETTLING / 100.0 * state.scale).collect();
        let tolerance = Tolerance::of(SETTLING, &absolute);
        let system = self.carrier.system().clone();
        let motion = Integrator::new(system, Method::Auto, tolerance, 1.0, horizon / 20.0, self.carrier.own(x))
            .map_err(|failure| failed(failure, 0.0))?;
        Ok(Box::new(Ahead::of(motion, self.states, horizon, MOST_STEPS)))
    }
}

impl<S: Gear<N>, const N: usize> Settling for Ahead<S, N> {
    fn advance(&mut self) -> Result<bool> {
        self.follow(STEPS)
    }

    fn end(self: Box<Self>) -> Result<Option<(Vec<f64>, f64)>> {
        let states = self.scales();
        let look = self.seen()?;
        let (End::Repeats, Some(cycle)) = (look.end, look.destination) else { return Ok(None) };
        let x = look.motion.state().iter().zip(states).map(|(x, state)| x / state.scale).collect();
        Ok(Some((x, cycle.period)))
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    const STATE: StateVariable = StateVariable { name: "x", symbol: "x", unit: "1", scale: 1.0, doc: "A state." };

    /// The family of any system whose typical sizes are 1.
    pub fn family<S: Gear<N>, const N: usize>(make: fn(f64) -> S, value: f64) -> Varied<S, N> {
        let states: &'static [StateVariable] = const { &[STATE; 8] }.split_at(N).0;
        Varied::new(Box::new(move |[value, _]| Ok(make(value))), [value, 0.0], (Method::Auto, 1e-8), states).unwrap()
    }
}
