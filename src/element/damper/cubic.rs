//! The modified Bouc–Wen damper whose coefficients are polynomials of the current.

use std::ops::RangeInclusive;

use super::{
    Coefficients, Damper, Description, Law, element,
    tables::{AMPLITUDE, BETA, CURRENT, DAMPING, EXPONENT, GAMMA, HYSTERESIS, INTERNAL, OFFSET, STIFFNESS},
};
use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Parameter, Scale, StateVariable, Validity},
    real::Real,
};

/// Currents \[A\] at which the polynomials have a meaning: the published c₁ is positive from 0.0569 to 2.5598 A alone.
pub(super) const COMMANDS: RangeInclusive<f64> = 0.06..=2.5;

/// The model of a 200 kN damper: as [`super::Modified`], with polynomials of third degree in the current.
///
/// # Equations
/// As [`super::Modified`], with p(i) = p₀ + p₁i + p₂i² + p₃i³ for α, c₀ and c₁, and no lag of the current. Here z has no
/// unit, α is in N, and γ, β and A are in 1/m.
///
/// # Limits
/// It would hold a small nose gear rigidly: on a gear the force counts a hundredth unless one says otherwise.
///
/// # References
/// Yang, Spencer, Carlson, Sain, *Engineering Structures* 24 (2002) 309–323: numbers from memory of the paper, about 88 %
/// sure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cubic {
    viscous: [f64; 4],
    series: [f64; 4],
    gain: [f64; 4],
    stiffness: f64,
    accumulator: f64,
    preload: f64,
}

impl Cubic {
    #[inline(always)]
    pub(super) fn coefficients<R: Real>(&self, current: R) -> Coefficients<R> {
        let at = |[p0, p1, p2, p3]: [f64; 4]| ((current * p3 + p2) * current + p1) * current + p0;
        Coefficients {
            viscous: at(self.viscous),
            stiffness: R::from(self.stiffness),
            hysteresis_gain: at(self.gain),
            series: at(self.series),
            accumulator: R::from(self.accumulator),
            preload: R::from(self.preload),
        }
    }
}

pub(super) const TABLES: Description = Description {
    name: "modified-bouc-wen-cubic",
    title: "Modified Bouc–Wen damper of 200 kN, cubic in the current",
    parameters: &PARAMETERS,
    state: &STATE,
    command: Parameter {
        min: 0.06,
        max: 2.5,
        doc: "Current in the coil (Yang et al. 2002). From 0.06 to 2.5 A: beyond, the published c₁ is negative.",
        validity: Validity::Positive,
        ..CURRENT
    },
    commanded: true,
    on_gear: &[("offset", 0.0), ("forceScale", 0.01)],
    make,
};

/// A coefficient of a polynomial.
const TERM: Parameter = Parameter { validity: Validity::Finite, scale: Scale::Linear, ..DAMPING };
const C0: &str = "c₀ = c_0a + c_0b i + c_0c i² + c_0d i³ (Yang et al. 2002, from memory). Any value is valid with which c₀ > 0 from 0.06 to 2.5 A.";
const C1: &str = "c₁ = c_1a + c_1b i + c_1c i² + c_1d i³ (Yang et al. 2002, from memory). Any value is valid with which c₁ > 0 from 0.06 to 2.5 A.";
const ALPHA: &str = "α = α_a + α_b i + α_c i² + α_d i³ (Yang et al. 2002, from memory). Any value is valid with which α ≥ 0 from 0.06 to 2.5 A.";

/// The term of a power of the current, with a slider to twice its size on both sides.
const fn term(
    name: &'static str,
    symbol: &'static str,
    unit: &'static str,
    default: f64,
    doc: &'static str,
) -> Parameter {
    let size = if default < 0.0 { -default } else { default };
    Parameter { name, symbol, unit, default, min: -2.0 * size, max: 2.0 * size, doc, ..TERM }
}

const PARAMETERS: [Parameter; 20] = [
    term("viscousDampingBase", "c_0a", "N s/m", 457_741.0, C0),
    term("viscousDampingSlope", "c_0b", "N s/(m A)", 1_641_376.0, C0),
    term("viscousDampingSquare", "c_0c", "N s/(m A²)", -1_545_407.0, C0),
    term("viscousDampingCube", "c_0d", "N s/(m A³)", 437_097.0, C0),
    Parameter {
        default: 137_810.0,
        min: 1e4,
        max: 1e6,
        doc: "Stiffness k₀(x − w) beside the hysteresis element (Yang et al. 2002, from memory). Any value ≥ 0 is valid.",
        ..STIFFNESS
    },
    term("seriesDampingBase", "c_1a", "N s/m", -2_791_630.0, C1),
    term("seriesDampingSlope", "c_1b", "N s/(m A)", 48_788_640.0, C1),
    term("seriesDampingSquare", "c_1c", "N s/(m A²)", 5_334_183.0, C1),
    term("seriesDampingCube", "c_1d", "N s/(m A³)", -9_363_108.0, C1),
    Parameter {
        name: "accumulatorStiffness",
        symbol: "k_1",
        default: 617.31,
        min: 50.0,
        max: 5000.0,
        doc: "Stiffness k₁(x − x₀) of the accumulator, beside all else (Yang et al. 2002, from memory). Any value ≥ 0 is valid.",
        ..STIFFNESS
    },
    Parameter {
        default: 0.18,
        min: -0.3,
        max: 0.3,
        doc: "Displacement x₀ at which the accumulator does not pull (Yang et al. 2002, from memory); on a gear 0, where it would preload it. Any finite value is valid.",
        ..OFFSET
    },
    term("hysteresisGainBase", "α_a", "N", 15_114.0, ALPHA),
    term("hysteresisGainSlope", "α_b", "N/A", 168_326.0, ALPHA),
    term("hysteresisGainSquare", "α_c", "N/A²", -87_071.0, ALPHA),
    term("hysteresisGainCube", "α_d", "N/A³", 16_566.0, ALPHA),
    Parameter {
        unit: "1/m",
        default: 647.46,
        min: 50.0,
        max: 5000.0,
        doc: "How much of the hysteresis element's yielding turns its sense with the velocity: −γ|ẋ|z|z|ⁿ⁻¹ in ż, z without unit (Yang et al. 2002, from memory). Any value ≥ 0 is valid, together with γ + β > 0.",
        ..GAMMA
    },
    Parameter {
        unit: "1/m",
        default: 647.46,
        min: 50.0,
        max: 5000.0,
        doc: "How much of the yielding keeps its sense: −βẋ|z|ⁿ in ż, z without unit (Yang et al. 2002, from memory). Any value with γ + β > 0 is valid; with |β| > γ z must start within ± z_max.",
        ..BETA
    },
    Parameter { default: 10.0, max: 12.0, ..EXPONENT },
    Parameter { unit: "1/m", default: 2679.0, min: 100.0, max: 20_000.0, ..AMPLITUDE },
    Parameter {
        name: "forceScale",
        symbol: "s_F",
        unit: "1",
        default: 1.0,
        min: 0.001,
        max: 1.0,
        doc: "What the damper's force is multiplied with (chosen): on a gear 0.01, which the whole force of 200 kN would hold rigidly. Any value ≥ 0 is valid.",
        ..DAMPING
    },
];

const STATE: [StateVariable; 2] = [StateVariable { unit: "1", scale: 1.0, ..HYSTERESIS }, INTERNAL];

fn make(values: &[f64]) -> Result<Damper> {
    let [
        c0a,
        c0b,
        c0c,
        c0d,
        stiffness,
        c1a,
        c1b,
        c1c,
        c1d,
        k1,
        offset,
        alpha_a,
        alpha_b,
        alpha_c,
        alpha_d,
        gamma,
        beta,
        exponent,
        amplitude,
        force_scale,
    ] = super::taken(values);
    let law = Cubic {
        viscous: [c0a, c0b, c0c, c0d],
        series: [c1a, c1b, c1c, c1d],
        gain: [alpha_a, alpha_b, alpha_c, alpha_d],
        stiffness,
        accumulator: k1,
        preload: -k1 * offset,
    };
    for (field, polynomial) in
        [("viscousDampingBase", law.viscous), ("seriesDampingBase", law.series), ("hysteresisGainBase", law.gain)]
    {
        let least = least(polynomial);
        if least < 0.0 || (least == 0.0 && field != "hysteresisGainBase") {
            let allowed = "such that its polynomial is positive from 0.06 to 2.5 A";
            return Err(Error::new(Code::OutOfRange, field, shown(polynomial[0]), allowed));
        }
    }
    Ok(Damper {
        hysteresis: element(gamma, beta, exponent, amplitude)?,
        law: Law::Cubic(law),
        in_series: true,
        command_rate: None,
        force_scale,
    })
}

/// The least value of a polynomial over the currents: at an end, or where its slope is 0.
fn least([p0, p1, p2, p3]: [f64; 4]) -> f64 {
    let value = |i: f64| ((p3 * i + p2) * i + p1) * i + p0;
    // 3p₃i² + 2p₂i + p₁ = 0, by the formula that neither cancels nor needs p₃ ≠ 0; what is no root is no harm.
    let root = (p2 * p2 - 3.0 * p3 * p1).max(0.0).sqrt();
    let q = -(p2 + root.copysign(p2));
    let turns = [q / (3.0 * p3), p1 / q].into_iter().filter(|i| COMMANDS.contains(i));
    [*COMMANDS.start(), *COMMANDS.end()].into_iter().chain(turns).map(value).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_value_is_found_wherever_it_is() {
        for polynomial in [
            [1.0, -2.0, 1.0, 0.0],
            [1.0, -2.0, 0.5, 0.2],
            [0.0, 0.0, 0.0, 1.0],
            [3.0, 1.0, 0.0, -0.4],
            [0.0, 1.0, 0.0, 0.0],
        ] {
            let sampled = (0..=100_000).map(|i| {
                let i = COMMANDS.start() + (COMMANDS.end() - COMMANDS.start()) * f64::from(i) / 1e5;
                polynomial[0] + i * (polynomial[1] + i * (polynomial[2] + i * polynomial[3]))
            });
            let sampled = sampled.fold(f64::INFINITY, f64::min);
            assert!((least(polynomial) - sampled).abs() < 1e-8, "{polynomial:?}");
        }
    }
}
