//! Where a motion gets to in a given time, and its neighbours with it: all that shooting asks of a gear.

use super::square::{GAUSS, Square, propagator};
use crate::{
    error::Result,
    integrate::{Failure, Integrator, Method, Scheme, Tolerance, failed},
    live::Columns,
    model::{Gear, System},
    run::Posed,
};

/// Relative tolerance of the motions, or the run's own where that is finer.
const RTOL: f64 = 1e-10;
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

    /// One period from `x`, in the states' own units.
    ///
    /// # Errors
    /// A motion that leaves the numbers.
    fn round(&mut self, x: &[f64], period: f64) -> Result<Round>;
}

/// A period of a cycle.
pub(super) struct Round {
    /// Largest |·| of every state.
    pub amplitude: Vec<f64>,
    /// From where the first state rises through zero, if it does.
    pub orbit: Columns,
}

/// A system's motions, with steps that fit a period.
pub(super) struct Carrier<S, const N: usize> {
    motion: Integrator<S, N>,
    scale: [f64; N],
    most_steps: u64,
}

impl<S: Gear<N>, const N: usize> Carrier<S, N> {
    /// The gear of a run.
    pub fn of(posed: &Posed<S, N>, period: f64) -> Result<Self> {
        let scale = std::array::from_fn(|i| posed.tables.description.state[i].scale);
        let (method, most_steps) = (posed.run.method(), posed.run.max_steps().min(MOST_STEPS));
        Self::new(posed.system.clone(), method, posed.run.rtol().min(RTOL), scale, period, most_steps)
    }
}

impl<S: System<N>, const N: usize> Carrier<S, N> {
    fn new(system: S, method: Method, relative: f64, scale: [f64; N], period: f64, most_steps: u64) -> Result<Self> {
        let tolerance = Tolerance { relative, absolute: scale.map(|scale: f64| relative / 100.0 * scale) };
        let method = match method {
            Method::Always(Scheme::RungeKutta4) => Method::Auto,
            method => method,
        };
        let motion = Integrator::new(system, method, tolerance, 1.0, period / STEPS, [0.0; N])
            .map_err(|failure| failed(failure, 0.0))?;
        Ok(Self { motion, scale, most_steps })
    }

    fn start(&mut self, x: &[f64]) -> std::result::Result<(), Failure> {
        self.motion.restart(0.0, std::array::from_fn(|i| x[i] * self.scale[i]))
    }

    fn scaled(&self, x: &[f64; N]) -> Vec<f64> {
        x.iter().zip(&self.scale).map(|(x, scale)| x / scale).collect()
    }

    /// How the last step has carried its neighbours.
    fn carried(&mut self) -> Square {
        let (from, to) = (self.motion.step_start(), self.motion.time());
        let scale = self.scale;
        let at = |place: f64| {
            let rows = self.motion.jacobian_at(from + place * (to - from));
            Square::of(N, &|i, j| rows[i][j] * (scale[j] / scale[i]))
        };
        propagator(&GAUSS.map(at), to - from)
    }
}

impl<S: System<N>, const N: usize> Flow for Carrier<S, N> {
    fn rate(&self, x: &[f64]) -> Vec<f64> {
        let x = std::array::from_fn(|i| x[i] * self.scale[i]);
        let system = self.motion.system();
        self.scaled(&system.rate(0.0, system.mode(0.0, &x), &x))
    }

    fn carry(&mut self, x: &[f64], duration: f64, neighbours: bool) -> Option<(Vec<f64>, Square)> {
        self.start(x).ok()?;
        let end = self.motion.stats().steps + self.most_steps;
        let mut matrix = Square::identity(N);
        while self.motion.time() < duration {
            if self.motion.stats().steps >= end {
                return None;
            }
            self.motion.step(duration).ok()?;
            if neighbours && self.motion.time() > self.motion.step_start() {
                matrix = self.carried().times(&matrix);
            }
        }
        let end = *self.motion.state();
        (end.iter().all(|x| x.is_finite()) && matrix.is_finite()).then(|| (self.scaled(&end), matrix))
    }

    fn round(&mut self, x: &[f64], period: f64) -> Result<Round> {
        let failed = |failure: Failure| failed(failure, 0.0);
        self.start(x).map_err(failed)?;
        let mut amplitude = *self.motion.state();
        let mut rise = amplitude;
        while self.motion.time() < period {
            self.motion.step(period).map_err(failed)?;
            for i in 0..N {
                let turn = self.motion.turning_point(i).map_or(0.0, |(_, value)| value);
                amplitude[i] = amplitude[i].abs().max(turn.abs()).max(self.motion.state()[i].abs());
            }
            if let Some(t) = self.motion.rise_through_zero(0) {
                rise = self.motion.interpolate(t);
            }
        }
        let mut orbit = Columns { time: Vec::new(), states: vec![Vec::new(); N] };
        self.motion.restart(0.0, rise).map_err(failed)?;
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
        Ok(Round { amplitude: amplitude.to_vec(), orbit })
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
        Carrier::new(system, Method::Auto, 1e-12, [1.0; N], period, MOST_STEPS).unwrap()
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
