//! The Bouc–Wen damper whose coefficients rise with the current and saturate.

use super::{
    Coefficients, Damper, Description, Law, element,
    tables::{AMPLITUDE, BETA, CURRENT, DAMPING, EXPONENT, GAIN, GAMMA, HYSTERESIS, STIFFNESS},
};
use crate::{
    error::{Code, Error, Result, shown},
    parameter::{Parameter, Scale, StateVariable, Validity},
    real::Real,
};

/// A dashpot, a spring, a Bouc–Wen element and a force side by side, each growing with the current in its own way.
///
/// # Equations
/// F = c₀(I)ẋ + k₀(I)x + α(I)z + f₀(I), the coefficients by [`Rise`] with one common I_c.
///
/// # References
/// Dominguez, Sedaghati, Stiharu, *Smart Materials and Structures* 13 (2004) 1351–1361 describe the form; E. Atabay 2012,
/// ch. 7, puts it on the gear. The function is chosen after the description; the numbers are this project's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurrentDependent {
    critical_current: f64,
    viscous: Rise,
    stiffness: Rise,
    gain: Rise,
    preload: Rise,
}

/// A coefficient that rises in a straight line up to a critical current, and above it towards a limit.
///
/// # Equations
/// p(I) = p₀ + p₁I for I ≤ I_c, and p₀ + p₁I_c + (p₁/p₂)(1 − e^(−p₂(I − I_c))) above: continuous with its slope. With
/// p₂ = 0 the straight line goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rise {
    /// p₀
    pub base: f64,
    /// p₁, per A.
    pub slope: f64,
    /// p₂ ≥ 0, per A.
    pub saturation: f64,
}

impl Rise {
    /// p(I), I_c being `critical`.
    #[inline]
    pub fn at<R: Real>(&self, current: R, critical: f64) -> R {
        let above = current.value() - critical;
        if above <= 0.0 || self.saturation == 0.0 {
            return current * self.slope + self.base;
        }
        let rest = (-self.saturation * above).exp_m1();
        let value = self.base + self.slope * (critical - rest / self.saturation);
        current.chain(value, self.slope * (1.0 + rest))
    }

    /// Its least value over all currents ≥ 0: it goes one way.
    fn least(&self, critical: f64) -> f64 {
        if self.slope >= 0.0 {
            self.base
        } else if self.saturation == 0.0 {
            f64::NEG_INFINITY
        } else {
            self.base + self.slope * (critical + 1.0 / self.saturation)
        }
    }
}

impl CurrentDependent {
    #[inline]
    pub(super) fn coefficients<R: Real>(&self, current: R) -> Coefficients<R> {
        let at = |rise: &Rise| rise.at(current, self.critical_current);
        Coefficients {
            viscous: at(&self.viscous),
            stiffness: at(&self.stiffness),
            hysteresis_gain: at(&self.gain),
            series: R::from(0.0),
            accumulator: R::from(0.0),
            preload: at(&self.preload),
        }
    }
}

pub(super) const TABLES: Description = Description {
    name: "current-dependent-bouc-wen",
    title: "Bouc–Wen damper whose coefficients rise with the current and saturate",
    parameters: &PARAMETERS,
    state: &STATE,
    command: Parameter {
        doc: "Current in the coil. The numbers that the model comes with were fitted from 0 to 1.5 A. Any value ≥ 0 is valid.",
        ..CURRENT
    },
    commanded: true,
    on_gear: &[("preloadBase", 0.0), ("preloadSlope", 0.0)],
    make,
};

/// p₁, which may fall.
const SLOPE: Parameter = Parameter { scale: Scale::Linear, validity: Validity::Finite, ..DAMPING };
/// p₂
const SATURATION: Parameter =
    Parameter { unit: "1/A", min: 0.0, max: 10.0, scale: Scale::Linear, validity: Validity::NonNegative, ..DAMPING };

const PARAMETERS: [Parameter; 17] = [
    Parameter {
        name: "criticalCurrent",
        symbol: "I_c",
        unit: "A",
        default: 1.0,
        min: 0.0,
        max: 1.5,
        scale: Scale::Linear,
        doc: "Current up to which all coefficients rise in straight lines. Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "viscousDampingBase",
        symbol: "c_00",
        default: 2000.0,
        min: 100.0,
        max: 20_000.0,
        doc: "c₀ without current. Any value is valid with which c₀ ≥ 0 at every current.",
        ..DAMPING
    },
    Parameter {
        name: "viscousDampingSlope",
        symbol: "c_01",
        unit: "N s/(m A)",
        default: 350.0,
        min: -2000.0,
        max: 10_000.0,
        doc: "Rise of c₀ per ampere up to I_c. Any value is valid with which c₀ ≥ 0 at every current.",
        ..SLOPE
    },
    Parameter {
        name: "viscousDampingSaturation",
        symbol: "c_02",
        default: 0.0,
        doc: "How fast c₀ comes to its limit above I_c; with 0 it rises on. Any value ≥ 0 is valid.",
        ..SATURATION
    },
    Parameter {
        name: "stiffnessBase",
        symbol: "k_00",
        default: 500.0,
        min: 10.0,
        max: 10_000.0,
        doc: "k₀ without current. Any value is valid with which k₀ ≥ 0 at every current.",
        ..STIFFNESS
    },
    Parameter {
        name: "stiffnessSlope",
        symbol: "k_01",
        unit: "N/(m A)",
        default: 0.0,
        min: -2000.0,
        max: 10_000.0,
        doc: "Rise of k₀ per ampere up to I_c. Any value is valid with which k₀ ≥ 0 at every current.",
        ..SLOPE
    },
    Parameter {
        name: "stiffnessSaturation",
        symbol: "k_02",
        default: 0.0,
        doc: "How fast k₀ comes to its limit above I_c; with 0 it rises on. Any value ≥ 0 is valid.",
        ..SATURATION
    },
    Parameter {
        name: "hysteresisGainBase",
        symbol: "α_0",
        default: 14_000.0,
        min: 1000.0,
        max: 200_000.0,
        doc: "α without current. Any value is valid with which α ≥ 0 at every current.",
        ..GAIN
    },
    Parameter {
        name: "hysteresisGainSlope",
        symbol: "α_1",
        unit: "N/(m A)",
        default: 69_500.0,
        min: 0.0,
        max: 500_000.0,
        scale: Scale::Linear,
        doc: "Rise of α per ampere up to I_c. Any value is valid with which α ≥ 0 at every current.",
        validity: Validity::Finite,
    },
    Parameter {
        name: "hysteresisGainSaturation",
        symbol: "α_2",
        default: 0.0,
        doc: "How fast α comes to its limit above I_c; with 0 it rises on. Any value ≥ 0 is valid.",
        ..SATURATION
    },
    Parameter {
        name: "preloadBase",
        symbol: "f_00",
        unit: "N",
        default: -71.5,
        min: -500.0,
        max: 500.0,
        doc: "Force f₀ at rest without current; on a gear 0, where it would preload it. Any finite value is valid.",
        ..SLOPE
    },
    Parameter {
        name: "preloadSlope",
        symbol: "f_01",
        unit: "N/A",
        default: 0.0,
        min: -500.0,
        max: 500.0,
        doc: "Rise of f₀ per ampere up to I_c; on a gear 0. Any finite value is valid.",
        ..SLOPE
    },
    Parameter {
        name: "preloadSaturation",
        symbol: "f_02",
        default: 0.0,
        doc: "How fast f₀ comes to its limit above I_c; with 0 it rises on. Any value ≥ 0 is valid.",
        ..SATURATION
    },
    Parameter { default: 3.63e6, min: 1e5, max: 5e7, ..GAMMA },
    Parameter { default: 3.63e6, min: 1e5, max: 5e7, ..BETA },
    EXPONENT,
    Parameter { default: 301.0, min: 10.0, max: 3000.0, ..AMPLITUDE },
];

const STATE: [StateVariable; 1] = [HYSTERESIS];

fn make(values: &[f64]) -> Result<Damper> {
    let [
        critical_current,
        c00,
        c01,
        c02,
        k00,
        k01,
        k02,
        alpha0,
        alpha1,
        alpha2,
        f00,
        f01,
        f02,
        gamma,
        beta,
        exponent,
        amplitude,
    ] = super::taken(values);
    let rise = |base, slope, saturation| Rise { base, slope, saturation };
    let law = CurrentDependent {
        critical_current,
        viscous: rise(c00, c01, c02),
        stiffness: rise(k00, k01, k02),
        gain: rise(alpha0, alpha1, alpha2),
        preload: rise(f00, f01, f02),
    };
    let passive =
        [("viscousDampingSlope", law.viscous), ("stiffnessSlope", law.stiffness), ("hysteresisGainSlope", law.gain)];
    for (field, rise) in passive {
        if rise.least(critical_current) < 0.0 {
            let allowed = "such that its coefficient is ≥ 0 at every current";
            return Err(Error::new(Code::OutOfRange, field, shown(rise.slope), allowed));
        }
    }
    Ok(Damper {
        hysteresis: element(gamma, beta, exponent, amplitude)?,
        law: Law::CurrentDependent(law),
        in_series: false,
        command_rate: None,
        force_scale: 1.0,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Dual;

    #[test]
    fn the_rise_is_smooth_and_ends_at_its_limit() {
        let rise = Rise { base: 2.0, slope: 3.0, saturation: 4.0 };
        assert_eq!(rise.at(0.5, 1.0), 3.5);
        assert!((rise.at(50.0, 1.0) - (2.0 + 3.0 * (1.0 + 0.25))).abs() < 1e-14);
        for current in [0.3, 1.0 - 1e-9, 1.0 + 1e-9, 1.7] {
            let dual = rise.at(Dual::<1>::variable(current, 0), 1.0);
            let difference = (rise.at(current + 1e-6, 1.0) - rise.at(current - 1e-6, 1.0)) / 2e-6;
            // At the joint the difference sees half of the bend p₁p₂ over 1e-6.
            assert!((dual.slope[0] - difference).abs() < 1e-5, "{current}");
        }
        assert_eq!(Rise { saturation: 0.0, ..rise }.at(2.0, 1.0), 8.0);
    }
}
