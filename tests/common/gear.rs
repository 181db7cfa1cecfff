//! The torsional gear, with parameters by name or at random.

use shimmy::{
    integrate::{Integrator, Method, Scheme, Tolerance},
    model::{Model, Torsional},
    parameter::parameter_index,
};

use super::random::Random;

/// Every adaptive method that a run can ask for by name.
pub const ADAPTIVE: [&str; 4] = ["auto", "dop853", "dormand-prince", "rodas"];

/// Every scheme.
pub const SCHEMES: [Scheme; 4] = [Scheme::DormandPrince, Scheme::Dop853, Scheme::RungeKutta4, Scheme::Rodas];

/// Parameter values of a gear.
#[derive(Clone, Debug)]
pub struct Gear(pub Vec<f64>);

impl Gear {
    pub fn default() -> Self {
        Self(Torsional::PARAMETERS.iter().map(|parameter| parameter.default).collect())
    }

    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.0[parameter_index(Torsional::PARAMETERS, name).expect("a parameter")] = value;
        self
    }

    pub fn get(&self, name: &str) -> f64 {
        self.0[parameter_index(Torsional::PARAMETERS, name).expect("a parameter")]
    }

    pub fn system(&self) -> Torsional {
        Torsional::new(&self.0)
    }

    /// A motion with the tolerances that a run of this rtol has.
    pub fn motion(&self, method: Method, rtol: f64, step: f64, start: [f64; 3]) -> Integrator<Torsional, 3> {
        let absolute = std::array::from_fn(|i| rtol / 100.0 * Torsional::STATE[i].scale);
        let tolerance = Tolerance { relative: rtol, absolute };
        Integrator::new(self.system(), method, tolerance, step, f64::INFINITY, start).expect("finite at the start")
    }

    /// Anywhere within the sliders' ranges, one value in ten at an end of its range; always with a gap.
    pub fn random(random: &mut Random) -> Self {
        let anywhere = Torsional::PARAMETERS.iter().map(|parameter| match random.between(0.0, 20.0) as u32 {
            0 => parameter.min,
            1 => parameter.max,
            _ => random.between(parameter.min, parameter.max),
        });
        let gear = Self(anywhere.collect());
        if gear.get("freeplayAngle") > 0.0 { gear } else { gear.with("freeplayAngle", 1e-4) }
    }

    /// A bound of how fast anything happens, in 1/s.
    pub fn fastest(&self) -> f64 {
        let inertia = self.get("momentOfInertia");
        let damping =
            (self.get("dampingConstant") + self.get("treadWidthMomentConstant") / self.get("velocity")) / inertia;
        let swing = (self.get("torsionalStiffness") / inertia).sqrt();
        damping + swing + self.get("velocity") / self.get("relaxationLength")
    }

    /// A start within some twice the typical sizes; one state in three is zero.
    pub fn random_start(random: &mut Random) -> [f64; 3] {
        std::array::from_fn(|i| {
            let size = 2.0 * Torsional::STATE[i].scale;
            if random.once_in(3) { 0.0 } else { random.between(-size, size) }
        })
    }
}
