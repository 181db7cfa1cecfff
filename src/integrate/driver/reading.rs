//! Looking into the last step: values, turning points, rises.

use super::{
    super::{dop853, dormand_prince, locate::bracketed, method::Scheme, rodas, runge_kutta4},
    Integrator,
};
use crate::model::System;

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// The state at time `t` within the last step, by its dense output.
    pub fn interpolate(&mut self, t: f64) -> [f64; N] {
        if t >= self.t || self.length == 0.0 {
            return self.x;
        }
        if t <= self.from_t {
            return self.from_x;
        }
        self.prepare_dense();
        self.dense.at((t - self.from_t) / self.length)
    }

    /// ∂f/∂x at time `t` within the last step, in its mode.
    pub(crate) fn jacobian_at(&mut self, t: f64) -> [[f64; N]; N] {
        let x = self.interpolate(t);
        self.system.jacobian(t, self.from_mode, &x)
    }

    /// What the switch `which` at the end of the last step, where the rate jumps from f⁻ to f⁺, makes of a neighbour's
    /// distance d: d + (f⁺ − f⁻)(n·d)/(n·f⁻), with the switch's gradient n. Gives f⁺ − f⁻ and n/(n·f⁻); nothing where the
    /// rate goes on as it was, but for rounding.
    ///
    /// # References
    /// R. I. Leine, H. Nijmeijer, *Dynamics and Bifurcations of Non-Smooth Mechanical Systems*, 2004, section 7.3.
    pub(crate) fn jump(&self, which: usize) -> Option<([f64; N], [f64; N])> {
        const ROUNDING: f64 = 1e-9;
        let before = self.system.rate(self.t, self.from_mode, &self.landed);
        let jump: [f64; N] = std::array::from_fn(|i| self.f[i] - before[i]);
        if (0..N).all(|i| jump[i].abs() <= ROUNDING * (self.f[i].abs() + before[i].abs())) {
            return None;
        }
        let normal = self.gradient(which, self.t, self.from_mode, &self.landed)?;
        let speed: f64 = (0..N).map(|i| normal[i] * before[i]).sum();
        Some((jump, normal.map(|entry| entry / speed)))
    }

    /// Whether the motion at time `t` within the last step, and its rate there, are finite numbers, and the rate that the
    /// next step begins with is that of the equations.
    pub(crate) fn is_sound_at(&mut self, t: f64) -> bool {
        let x = self.interpolate(t);
        let rates = [self.system.rate(t, self.from_mode, &x), self.system.rate(self.t, self.mode, &self.x)];
        x.iter().chain(rates.as_flattened()).all(|value| value.is_finite()) && self.f == rates[1]
    }

    /// The turning point of `component` within the last step: its time and value, where its rate changes sign, or becomes
    /// zero and stays so.
    pub fn turning_point(&mut self, component: usize) -> Option<(f64, f64)> {
        if self.f[component] == 0.0 && self.start_rate[component] != 0.0 && self.length > 0.0 {
            return Some((self.t, self.x[component]));
        }
        if self.start_rate[component] * self.f[component] >= 0.0 || self.length == 0.0 {
            return None;
        }
        self.prepare_dense();
        let rising = self.start_rate[component] > 0.0;
        let slope = |theta: f64| self.dense.slope(theta, component) * if rising { 1.0 } else { -1.0 };
        if slope(0.0) <= 0.0 || slope(1.0) >= 0.0 {
            return None;
        }
        let theta = bracketed(0.0, 1.0, &slope);
        Some((self.from_t + theta * self.length, self.dense.at(theta)[component]))
    }

    /// The time at which `component` rises through 0 within the last step.
    pub fn rise_through_zero(&mut self, component: usize) -> Option<f64> {
        self.passes(component, 0.0, true)
    }

    /// The time at which `component` passes a level within the last step, rising or falling.
    pub fn passes(&mut self, component: usize, level: f64, rising: bool) -> Option<f64> {
        let below = |value: f64| if rising { level - value } else { value - level };
        if !(below(self.from_x[component]) > 0.0 && below(self.x[component]) <= 0.0) {
            return None;
        }
        self.prepare_dense();
        let below = |theta: f64| below(self.dense.at(theta)[component]);
        Some(self.from_t + bracketed(0.0, 1.0, &below) * self.length)
    }

    pub(super) fn prepare_dense(&mut self) {
        if self.dense_ready {
            return;
        }
        let (x0, x1, h) = (&self.from_x, &self.reached, self.length);
        self.dense = match self.scheme {
            Scheme::DormandPrince => dormand_prince::dense(x0, x1, h, &self.k),
            Scheme::Dop853 => {
                self.stats.evaluations += 3;
                dop853::dense(&*self.system, self.from_mode, self.from_t, (x0, x1), h, &mut self.k)
            }
            Scheme::RungeKutta4 => runge_kutta4::dense(x0, x1, h, &self.k),
            Scheme::Rodas => rodas::dense(x0, x1, &self.k),
        };
        self.dense_ready = true;
    }
}
