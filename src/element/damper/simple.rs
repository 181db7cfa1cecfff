//! The simple Bouc–Wen damper.

use super::{
    Coefficients, Damper, Description, Law, element,
    tables::{AMPLITUDE, BETA, CURRENT, DAMPING, EXPONENT, GAIN, GAMMA, HYSTERESIS, OFFSET, STIFFNESS},
};
use crate::{
    error::Result,
    parameter::{Parameter, StateVariable},
    real::Real,
};

/// A dashpot, a spring and a Bouc–Wen element side by side, at one fixed command.
///
/// # Equations
/// F = c₀ẋ + k₀(x − x₀) + αz.
///
/// # References
/// Spencer, Dyke, Sain, Carlson, *J. Engineering Mechanics* 123 (1997) 230–238, eq. 3 and the fit at 1.5 V: the numbers are
/// from memory of the paper, about 85 % sure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simple {
    viscous: f64,
    stiffness: f64,
    gain: f64,
    preload: f64,
}

impl Simple {
    #[inline(always)]
    pub(super) fn coefficients<R: Real>(&self) -> Coefficients<R> {
        Coefficients {
            viscous: R::from(self.viscous),
            stiffness: R::from(self.stiffness),
            hysteresis_gain: R::from(self.gain),
            series: R::from(0.0),
            accumulator: R::from(0.0),
            preload: R::from(self.preload),
        }
    }
}

pub(super) const TABLES: Description = Description {
    name: "bouc-wen",
    title: "Bouc–Wen element, dashpot and spring side by side",
    parameters: &PARAMETERS,
    state: &STATE,
    command: Parameter {
        default: 1.5,
        symbol: "u",
        unit: "V",
        max: 2.25,
        doc: "The model holds at one command, the one that its numbers were fitted at: it does not enter. Any value ≥ 0 is valid.",
        ..CURRENT
    },
    commanded: false,
    on_gear: &[("offset", 0.0)],
    make,
};

const PARAMETERS: [Parameter; 8] = [
    Parameter {
        default: 5000.0,
        min: 100.0,
        max: 20_000.0,
        doc: "Viscous damping c₀ẋ (Spencer et al. 1997, fit at 1.5 V, from memory). Any value ≥ 0 is valid.",
        ..DAMPING
    },
    Parameter {
        default: 2500.0,
        min: 100.0,
        max: 20_000.0,
        doc: "Stiffness k₀(x − x₀) of the gas spring (Spencer et al. 1997, fit at 1.5 V, from memory). Any value ≥ 0 is valid.",
        ..STIFFNESS
    },
    Parameter {
        default: 0.038,
        min: -0.2,
        max: 0.2,
        doc: "Displacement x₀ at which the spring is slack (Spencer et al. 1997, fit at 1.5 V, from memory); on a gear 0, where it would preload it. Any finite value is valid.",
        ..OFFSET
    },
    Parameter {
        default: 88_000.0,
        min: 1000.0,
        max: 500_000.0,
        doc: "Pull αz of the hysteresis element (Spencer et al. 1997, fit at 1.5 V, from memory). Any value ≥ 0 is valid.",
        ..GAIN
    },
    Parameter { default: 1e6, min: 1e4, max: 2e7, ..GAMMA },
    Parameter { default: 1e6, min: 1e4, max: 2e7, ..BETA },
    EXPONENT,
    Parameter { default: 120.0, min: 5.0, max: 2000.0, ..AMPLITUDE },
];

const STATE: [StateVariable; 1] = [HYSTERESIS];

fn make(values: &[f64]) -> Result<Damper> {
    let [viscous, stiffness, offset, gain, gamma, beta, exponent, amplitude] = super::taken(values);
    Ok(Damper {
        hysteresis: element(gamma, beta, exponent, amplitude)?,
        law: Law::Simple(Simple { viscous, stiffness, gain, preload: -stiffness * offset }),
        in_series: false,
        command_rate: None,
        force_scale: 1.0,
    })
}
