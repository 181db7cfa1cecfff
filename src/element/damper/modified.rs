//! The modified Bouc–Wen damper whose coefficients are straight lines of the command.

use super::{
    Coefficients, Damper, Description, Law, element, some_damping,
    tables::{
        AMPLITUDE, BETA, COMMAND_RATE, CURRENT, DAMPING, EFFECTIVE_COMMAND, EXPONENT, GAIN, GAMMA, HYSTERESIS,
        INTERNAL, OFFSET, STIFFNESS,
    },
};
use crate::{
    error::Result,
    parameter::{Parameter, StateVariable},
    real::Real,
};

/// Spencer's phenomenological model: a Bouc–Wen element, a dashpot and a spring, in series with a second dashpot, and the
/// accumulator's spring beside all of it.
///
/// # Equations
/// ẇ = (αz + c₀ẋ + k₀(x − w))/(c₀ + c₁), F = c₁ẇ + k₁(x − x₀), with α = α_a + α_b u, c₀ = c_0a + c_0b u,
/// c₁ = c_1a + c_1b u and u̇ = −η(u − command).
///
/// # Assumptions
/// On a gear whose command is a current, 1 A counts as 1 V.
///
/// # References
/// Spencer, Dyke, Sain, Carlson, *J. Engineering Mechanics* 123 (1997) 230–238, eq. 6–11 and table 2, in SI units. Their y
/// is w here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modified {
    viscous: [f64; 2],
    series: [f64; 2],
    gain: [f64; 2],
    stiffness: f64,
    accumulator: f64,
    preload: f64,
}

impl Modified {
    #[inline(always)]
    pub(super) fn coefficients<R: Real>(&self, u: R) -> Coefficients<R> {
        let line = |[base, slope]: [f64; 2]| u * slope + base;
        Coefficients {
            viscous: line(self.viscous),
            stiffness: R::from(self.stiffness),
            hysteresis_gain: line(self.gain),
            series: line(self.series),
            accumulator: R::from(self.accumulator),
            preload: R::from(self.preload),
        }
    }
}

pub(super) const TABLES: Description = Description {
    name: "modified-bouc-wen",
    title: "Spencer's modified Bouc–Wen damper, linear in the command",
    parameters: &PARAMETERS,
    state: &STATE,
    command: Parameter {
        symbol: "v_cmd",
        unit: "V",
        max: 2.25,
        doc: "Voltage at the current driver (Spencer et al. 1997); on a gear a current, 1 A for 1 V. Any value ≥ 0 is valid.",
        ..CURRENT
    },
    commanded: true,
    on_gear: &[("offset", 0.0)],
    make,
};

const PARAMETERS: [Parameter; 14] = [
    Parameter {
        name: "viscousDampingBase",
        symbol: "c_0a",
        default: 2100.0,
        min: 100.0,
        max: 20_000.0,
        doc: "Damping beside the hysteresis element without command, c₀ = c_0a + c_0b u (Spencer et al. 1997, table 2). Any value ≥ 0 is valid, c_0a + c_1a > 0.",
        ..DAMPING
    },
    Parameter {
        name: "viscousDampingSlope",
        symbol: "c_0b",
        unit: "N s/(m V)",
        default: 350.0,
        min: 10.0,
        max: 10_000.0,
        doc: "Rise of c₀ per volt (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..DAMPING
    },
    Parameter {
        default: 4690.0,
        min: 100.0,
        max: 20_000.0,
        doc: "Stiffness k₀(x − w) beside the hysteresis element (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..STIFFNESS
    },
    Parameter {
        name: "seriesDampingBase",
        symbol: "c_1a",
        default: 28_300.0,
        min: 1000.0,
        max: 200_000.0,
        doc: "Damping in series without command, c₁ = c_1a + c_1b u: it rounds the loop where the piston turns (Spencer et al. 1997, table 2). Any value ≥ 0 is valid, c_0a + c_1a > 0.",
        ..DAMPING
    },
    Parameter {
        name: "seriesDampingSlope",
        symbol: "c_1b",
        unit: "N s/(m V)",
        default: 295.0,
        min: 10.0,
        max: 100_000.0,
        doc: "Rise of c₁ per volt (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..DAMPING
    },
    Parameter {
        name: "accumulatorStiffness",
        symbol: "k_1",
        default: 500.0,
        min: 50.0,
        max: 5000.0,
        doc: "Stiffness k₁(x − x₀) of the accumulator, beside all else (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..STIFFNESS
    },
    Parameter {
        default: 0.143,
        min: -0.3,
        max: 0.3,
        doc: "Displacement x₀ at which the accumulator does not pull (Spencer et al. 1997, table 2); on a gear 0, where it would preload it. Any finite value is valid.",
        ..OFFSET
    },
    Parameter {
        name: "hysteresisGainBase",
        symbol: "α_a",
        default: 14_000.0,
        min: 1000.0,
        max: 200_000.0,
        doc: "Pull of the hysteresis element without command, α = α_a + α_b u (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..GAIN
    },
    Parameter {
        name: "hysteresisGainSlope",
        symbol: "α_b",
        unit: "N/(m V)",
        default: 69_500.0,
        min: 1000.0,
        max: 500_000.0,
        doc: "Rise of α per volt (Spencer et al. 1997, table 2). Any value ≥ 0 is valid.",
        ..GAIN
    },
    Parameter { default: 3.63e6, min: 1e5, max: 5e7, ..GAMMA },
    Parameter { default: 3.63e6, min: 1e5, max: 5e7, ..BETA },
    EXPONENT,
    Parameter { default: 301.0, min: 10.0, max: 3000.0, ..AMPLITUDE },
    Parameter { default: 190.0, min: 10.0, max: 2000.0, ..COMMAND_RATE },
];

const STATE: [StateVariable; 3] = [HYSTERESIS, INTERNAL, EFFECTIVE_COMMAND];

fn make(values: &[f64]) -> Result<Damper> {
    let [c0a, c0b, stiffness, c1a, c1b, k1, offset, alpha_a, alpha_b, gamma, beta, exponent, amplitude, rate] =
        super::taken(values);
    some_damping("viscousDampingBase", c0a + c1a)?;
    let law = Modified {
        viscous: [c0a, c0b],
        series: [c1a, c1b],
        gain: [alpha_a, alpha_b],
        stiffness,
        accumulator: k1,
        preload: -k1 * offset,
    };
    Ok(Damper {
        hysteresis: element(gamma, beta, exponent, amplitude)?,
        law: Law::Modified(law),
        in_series: true,
        command_rate: Some(rate),
        force_scale: 1.0,
    })
}
