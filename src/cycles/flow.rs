//! Where a motion gets to in a given time, and its neighbours with it: all that shooting asks of a gear.

use super::{
    square::{GAUSS, Square, propagator},
    vector::{norm, vector},
};
use crate::{
    error::Result,
    few::padded,
    integrate::{Failure, Integrator, Method, Outcome, Scheme, Tolerance, failed},
    live::Columns,
    model::{Gear, System},
    run::Posed,
};

/// Relative tolerance of the motions, or the run's own where that is finer.
pub(super) const RTOL: f64 = 1e-10;
/// The finest that is of use.
const FINEST_RTOL: f64 = 1e-13;
/// A period has at least so many steps: the motion's neighbours need them.
const STEPS: f64 = 48.0;
/// What takes more steps than this has no period.
const MOST_STEPS: u64 = 20_000;
/// Points of an orbit, its first one twice.
const ORBIT: usize = 128;

/// A gear's motions, every state in units of its typical size.
pub(super) trait Flow {
    /// ẋ.
    fn rate(&self, x: &[f64]) -> Vec<f64>;

    /// The state after `duration` s, and where asked how a small push at the start shows there; none where the motion does
    /// not get so far.
    fn carry(&mut self, x: &[f64], duration: f64, neighbours: bool) -> Option<(Vec<f64>, Square)>;

    /// From now on motions are followed as a period asks for, or so many times finer.
    fn pace(&mut self, period: f64, fineness: f64);

    /// How far a cycle swings in one period from `x`.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn swing(&mut self, x: &[f64], period: f64) -> Result<Swing>;

    /// One period of the cycle through the state `from`, in the states' own units.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn orbit(&mut self, from: &[f64], period: f64) -> Result<Columns>;

    /// Steps so far, those with neighbours tenfold.
    #[cfg(test)]
    fn work(&self) -> u64;
}

/// How far a cycle swings; states in their own units.
pub(super) struct Swing {
    /// Largest |·| of every state.
    pub amplitude: Vec<f64>,
    /// Half of the way from its least value to its greatest, of all states together, each in units of its typical size.
    pub size: f64,
    /// Where the first state rises through zero, if it does: else the state that was given.
    pub rise: Vec<f64>,
}

/// A system's motions, with steps that fit a period.
pub(super) struct Carrier<S, const N: usize> {
    motion: Integrator<S, N>,
    /// Relative tolerance, where nothing finer is asked for.
    relative: f64,
    scale: Vec<f64>,
    most_steps: u64,
    #[cfg(test)]
    with_neighbours: u64,
}

fn tolerance<const N: usize>(relative: f64, scale: &[f64]) -> Tolerance<N> {
    Tolerance::of(relative, &vector(scale.len(), &|i| relative / 100.0 * scale[i]))
}

impl<S: Gear<N>, const N: usize> Carrier<S, N> {
    /// The gear of a run.
    pub fn of(posed: &Posed<S, N>, period: f64) -> Result<Self> {
        let states = posed.tables.description.state;
        let scale = vector(states.len(), &|i| states[i].scale);
        let (method, most_steps) = (posed.run.method(), posed.run.max_steps().min(MOST_STEPS));
        Self::new(posed.system.clone(), method, posed.run.rtol().min(RTOL), scale, period, most_steps)
    }
}

impl<S: System<N>, const N: usize> Carrier<S, N> {
    /// A system by a method, to a relative tolerance, with its typical sizes and steps that fit a period.
    pub fn new(
        system: S,
        method: Method,
        relative: f64,
        scale: Vec<f64>,
        period: f64,
        most_steps: u64,
    ) -> Result<Self> {
        let method = match method {
            Method::Always(Scheme::RungeKutta4) => Method::Auto,
            method => method,
        };
        let motion = Integrator::new(system, method, tolerance(relative, &scale), 1.0, period / STEPS, [0.0; N])
            .map_err(|failure| failed(failure, 0.0))?;
        Ok(Self {
            motion,
            relative,
            scale,
            most_steps,
            #[cfg(test)]
            with_neighbours: 0,
        })
    }

    /// Goes over to another system; says whether its equations are in finite numbers.
    pub fn replace(&mut self, system: S) -> bool {
        self.motion.replace(system.into(), 0.0, [0.0; N]).is_ok()
    }

    /// The system that moves.
    pub fn system(&self) -> &S {
        self.motion.system()
    }

    fn start(&mut self, x: &[f64]) -> std::result::Result<(), Failure> {
        self.motion.restart(0.0, self.own(x))
    }

    /// A state in its own units.
    pub fn own(&self, x: &[f64]) -> [f64; N] {
        padded(&vector(x.len(), &|i| x[i] * self.scale[i]), 0.0)
    }

    fn scaled(&self, x: &[f64; N]) -> Vec<f64> {
        vector(self.scale.len(), &|i| x[i] / self.scale[i])
    }

    /// How the last step has carried its neighbours.
    fn carried(&mut self) -> Square {
        let (from, to) = (self.motion.step_start(), self.motion.time());
        let scale = self.scale.clone();
        let at = |place: f64| {
            let rows = self.motion.jacobian_at(from + place * (to - from));
            Square::of(scale.len(), &|i, j| rows[i][j] * (scale[j] / scale[i]))
        };
        propagator(&GAUSS.map(at), to - from)
    }
}

impl<S: System<N>, const N: usize> Flow for Carrier<S, N> {
    fn rate(&self, x: &[f64]) -> Vec<f64> {
        let x = self.own(x);
        let system = self.motion.system();
        self.scaled(&system.rate(0.0, system.mode(0.0, &x), &x))
    }

    fn carry(&mut self, x: &[f64], duration: f64, neighbours: bool) -> Option<(Vec<f64>, Square)> {
        self.start(x).ok()?;
        let end = self.motion.stats().steps + self.most_steps;
        let n = self.scale.len();
        let mut matrix = Square::identity(n);
        while self.motion.time() < duration {
            if self.motion.stats().steps >= end {
                return None;
            }
            let outcome = self.motion.step(duration).ok()?;
            #[cfg(test)]
            {
                self.with_neighbours += u64::from(neighbours);
            }
            if neighbours && self.motion.time() > self.motion.step_start() {
                matrix = self.carried().times(&matrix);
            }
            if neighbours
                && let Outcome::Switch(which) = outcome
                && let Some((jump, normal)) = self.motion.jump(which)
            {
                let leap = |i: usize, j: usize| jump[i] / self.scale[i] * (normal[j] * self.scale[j]);
                matrix = Square::of(n, &|i, j| leap(i, j) + f64::from(u8::from(i == j))).times(&matrix);
            }
        }
        let end = *self.motion.state();
        (end.iter().all(|x| x.is_finite()) && matrix.is_finite()).then(|| (self.scaled(&end), matrix))
    }

    fn pace(&mut self, period: f64, fineness: f64) {
        let relative = (self.relative / fineness.powi(3)).max(FINEST_RTOL.min(self.relative));
        self.motion.pace(period / (STEPS * fineness), tolerance(relative, &self.scale));
    }

    fn swing(&mut self, x: &[f64], period: f64) -> Result<Swing> {
        let failed = |failure: Failure| failed(failure, 0.0);
        self.start(x).map_err(failed)?;
        let (mut low, mut high) = (*self.motion.state(), *self.motion.state());
        let mut rise = low;
        let n = self.scale.len();
        while self.motion.time() < period {
            self.motion.step(period).map_err(failed)?;
            for i in 0..n {
                let end = self.motion.state()[i];
                let turn = self.motion.turning_point(i).map_or(end, |(_, value)| value);
                (low[i], high[i]) = (low[i].min(turn).min(end), high[i].max(turn).max(end));
            }
            if let Some(t) = self.motion.rise_through_zero(0) {
                rise = self.motion.interpolate(t);
            }
        }
        Ok(Swing {
            amplitude: vector(n, &|i| high[i].max(-low[i])),
            size: norm(&vector(n, &|i| 0.5 * (high[i] - low[i]) / self.scale[i])),
            rise: rise[..n].to_vec(),
        })
    }

    #[cfg(test)]
    fn work(&self) -> u64 {
        self.motion.stats().steps + 9 * self.with_neighbours
    }

    fn orbit(&mut self, from: &[f64], period: f64) -> Result<Columns> {
        let failed = |failure: Failure| failed(failure, 0.0);
        let mut orbit = Columns { time: Vec::new(), states: vec![Vec::new(); self.scale.len()] };
        self.motion.restart(0.0, padded(from, 0.0)).map_err(failed)?;
        for point in 0..=ORBIT {
            let t = period * point as f64 / ORBIT as f64;
            while self.motion.time() < t {
                self.motion.step(period).map_err(failed)?;
            }
            orbit.time.push(t);
            for (column, value) in orbit.states.iter_mut().zip(self.motion.interpolate(t)) {
                column.push(value);
            }
        }
        Ok(orbit)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::{
        Run,
        model::{Model, Tables, TorsionalLinear},
        stability::eigenvalues,
    };

    /// The motions of any system whose typical sizes are 1.
    pub fn carrier<S: System<N>, const N: usize>(system: S, period: f64) -> Carrier<S, N> {
        Carrier::new(system, Method::Auto, 1e-12, vec![1.0; N], period, MOST_STEPS).unwrap()
    }

    #[test]
    fn neighbours_of_a_linear_gear_go_by_its_eigenvalues() {
        // At the published critical speed for c = 20 (a pair on the axis) and away from it.
        for velocity in [27.600, 80.0, 15.0] {
            let run = Run::of(TorsionalLinear::NAME).unwrap().with("velocity", velocity).unwrap();
            let run = run.with("dampingConstant", 20.0).unwrap();
            let values = run.eigenvalues().unwrap();
            let period = std::f64::consts::TAU / values.iter().fold(0.0, |most: f64, value| most.max(value.im));
            let posed = Posed::new(run, Tables::of::<3, TorsionalLinear>());
            let mut carrier = Carrier::of(&posed, period).unwrap();
            let (_, matrix) = carrier.carry(&[0.3, 0.1, -0.2], period, true).unwrap();
            let carried = eigenvalues(&nalgebra::DMatrix::from_fn(3, 3, |i, j| matrix.at(i, j))).unwrap();
            for value in values {
                let expected = (value * period).exp();
                let nearest = carried.iter().fold(f64::INFINITY, |near, got| near.min((got - expected).norm()));
                // Rounding of some forty products.
                assert!(nearest < 1e-13, "{velocity}: {expected} is missed by {nearest:e}");
            }
        }
    }
}
