//! The torsional nose landing gear on a stretched-string tire.

use std::ops::Mul;

use serde::Serialize;

use super::{Gear, Mode, Model, System, laws::Laws};
use crate::{
    element::{
        Boundary, Side,
        freeplay::Spring,
        tire_law::{PiecewiseTireLaw, SteeringMoment, TireLaw},
    },
    parameter::{Parameter, Scale, StateVariable, Validity},
    real::Real,
    stability::{Polynomial, TorsionalTheory},
};

/// State ψ: torsion angle.
pub const PSI: usize = 0;
/// State ψ̇: torsion rate.
pub const PSI_RATE: usize = 1;
/// State y: lateral deformation of the tire.
pub const Y: usize = 2;

// Kinks, in the order of their bits in a mode. F_y and M_z are neighbours: their sides are read as one number.
const SIDE_FORCE: usize = 0;
const ALIGNING: usize = 1;
const FREEPLAY: usize = 2;

/// A wheel that turns about a steering axis by the angle ψ against a spring and a damper, and is steered by its own tire.
///
/// # Equations
/// ```text
/// I_z ψ̈ = −k s(ψ) − c ψ̇ − (κ/v) ψ̇ + M_z(α) − e F_y(α)
/// ẏ     = v ψ + (e − a) ψ̇ − (v/σ) y
/// α     = arctan(y/σ)
/// ```
/// s is the spring's angle with freeplay ([`Spring`]), F_y and M_z the piecewise tire law ([`PiecewiseTireLaw`]).
///
/// # State
/// | name | symbol | unit | positive |
/// | --- | --- | --- | --- |
/// | `torsionAngle` | ψ | rad | counter-clockwise from above |
/// | `torsionRate` | ψ̇ | rad/s | as ψ |
/// | `lateralDeformation` | y | m | leading contact point to the left of the wheel plane |
///
/// # Assumptions
/// Constant speed on a flat, dry runway; a rigid wheel and a rigid leg but for torsion; kinematics linear in ψ (vψ, not
/// v sin ψ); no slip in the contact line but through the limit of F_y.
///
/// # Limits
/// v > 0. Amplitudes beyond about 0.5 rad leave the range of the kinematics. With ψ_fp = 0 there is no gap and no switch
/// for it. The equations are odd in the state, and homogeneous in (state, ψ_fp) while the tire is in its linear range.
///
/// # References
/// G. Somieski, *Aerospace Science and Technology* 8 (1997) 545–555; used by E. Atabay, *Dynamics of a Landing Gear
/// Mechanism*, Istanbul Technical University, 2012, ch. 5 and 6. Here k is the stiffness and c the damping constant, both
/// positive; Somieski prints them, κ and c_Mα negative, and with the two letters swapped.
///
/// # Example
/// ```
/// use shimmy::{Run, model::torsional::PSI};
///
/// // At 80 m/s a damping of 20 N m s/rad does not hold the wheel: from 0.01 rad it grows to a limit cycle.
/// let run = Run::of("torsional")?.with("velocity", 80.0)?.with("dampingConstant", 20.0)?.starting("torsionAngle", 0.01)?;
/// let motion = run.lasting(6.0)?.simulate()?;
/// let late = motion.states[PSI].iter().skip(motion.time.len() - 100).fold(0.0_f64, |m, psi| m.max(psi.abs()));
/// assert!((late - 0.26508).abs() < 2e-3);
/// # Ok::<(), shimmy::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Torsional {
    velocity: f64,
    /// e − a
    lever: f64,
    /// v/σ
    relaxation_rate: f64,
    /// 1/σ
    slip_ratio: f64,
    stiffness: f64,
    /// 1/I_z
    mobility: f64,
    /// (c + κ/v)/I_z
    damping: f64,
    /// k s(ψ)/I_z
    spring: Spring,
    /// tan δ and tan α_g
    limits: [f64; 2],
    /// (M_z − e F_y)/I_z
    tire: SteeringMoment,
}

impl Torsional {
    /// A wheel with these laws that rolls with the velocity v \[m/s\] on a tire of half contact length a \[m\].
    pub fn rolling(laws: &Laws, velocity: f64, half_contact_length: f64) -> Self {
        let Laws { relaxation_length, moment_of_inertia, .. } = *laws;
        Self {
            velocity,
            lever: laws.caster_length - half_contact_length,
            relaxation_rate: velocity / relaxation_length,
            slip_ratio: 1.0 / relaxation_length,
            mobility: 1.0 / moment_of_inertia,
            damping: (laws.damping + laws.tread_damping) / moment_of_inertia,
            stiffness: laws.stiffness,
            spring: Spring::new(laws.stiffness / moment_of_inertia, laws.freeplay),
            limits: [laws.tire.side_force_limit(), laws.tire.aligning_limit()],
            tire: SteeringMoment::new(laws.tire, laws.caster_length, relaxation_length, moment_of_inertia),
        }
    }
}

impl System<3> for Torsional {
    const SWITCHES: usize = 6;
    const EVENT_KINDS: &'static [&'static str] = &["side-force-limit", "aligning-moment-limit", "freeplay"];

    #[inline(always)]
    fn rate<R: Real>(&self, _t: R, mode: Mode, x: &[R; 3]) -> [R; 3] {
        let [psi, psi_rate, y] = *x;
        // All moments over I_z. The tire's is added last, as it takes longest to come.
        let spring = self.spring.torque(psi, mode.sides(FREEPLAY));
        let limited = self.tire.constant(mode.sides(SIDE_FORCE));
        let psi_acceleration =
            -(spring + psi_rate * self.damping - limited) + self.tire.curve(y, mode.sides(SIDE_FORCE));
        let y_rate = psi * self.velocity + psi_rate * self.lever - y * self.relaxation_rate;
        [psi_rate, psi_acceleration, y_rate]
    }

    fn mode(&self, t: f64, x: &[f64; 3]) -> Mode {
        let q = x[Y] * self.slip_ratio;
        let y_rate = self.rate(t, Mode::default(), x)[Y];
        let mut mode = Mode::default()
            .with_side(SIDE_FORCE, Side::of(q, y_rate, self.limits[SIDE_FORCE]))
            .with_side(ALIGNING, Side::of(q, y_rate, self.limits[ALIGNING]));
        if self.spring.freeplay() > 0.0 {
            mode = mode.with_side(FREEPLAY, Side::of(x[PSI], x[PSI_RATE], self.spring.freeplay()));
        }
        mode
    }

    #[inline(always)]
    fn switch<R: Real>(&self, which: usize, _t: R, mode: Mode, x: &[R; 3]) -> Option<R> {
        let (kink, boundary) = kink_and_boundary(which);
        let (quantity, limit) = match kink {
            SIDE_FORCE | ALIGNING if self.limits[kink].is_finite() => (x[Y] * self.slip_ratio, self.limits[kink]),
            SIDE_FORCE | ALIGNING => return None, // a limit of 90° or more is never reached
            _ if self.spring.freeplay() > 0.0 => (x[PSI], self.spring.freeplay()),
            _ => return None,
        };
        mode.side(kink).margin(boundary, quantity, limit)
    }

    fn cross(&self, which: usize, mode: Mode) -> Mode {
        let (kink, boundary) = kink_and_boundary(which);
        mode.with_side(kink, mode.side(kink).across(boundary))
    }

    fn event_kind(&self, which: usize) -> usize {
        kink_and_boundary(which).0
    }
}

/// Two switches a kink: where its quantity passes +limit, and where it passes −limit.
#[inline(always)]
fn kink_and_boundary(which: usize) -> (usize, Boundary) {
    (which / 2, if which.is_multiple_of(2) { Boundary::Upper } else { Boundary::Lower })
}

impl Gear<3> for Torsional {
    fn kicked(&self, x: &[f64; 3], impulse: f64) -> [f64; 3] {
        [x[PSI], x[PSI_RATE] + impulse * self.mobility, x[Y]]
    }

    fn without_freeplay(&self) -> Option<Self> {
        (self.spring.freeplay() > 0.0)
            .then(|| Self { spring: Spring::new(self.stiffness * self.mobility, 0.0), ..self.clone() })
    }
}

impl Model<3> for Torsional {
    type System = Self;
    const NAME: &'static str = "torsional";
    const TITLE: &'static str = "Torsional nose landing gear on a stretched-string tire";
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const STATE: &'static [StateVariable] = &STATE;

    fn new(values: &[f64]) -> Self {
        let (Some(laws), [v, _, a, ..]) = (Self::laws(values), values) else {
            unreachable!("a checked run has as many values as the table has parameters")
        };
        Self::rolling(&laws, *v, *a)
    }

    fn laws(values: &[f64]) -> Option<Laws> {
        let &[v, e, _, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, delta, alpha_g, kappa, freeplay] = values else {
            return None;
        };
        Some(Laws {
            tire: TireLaw::Piecewise(PiecewiseTireLaw::new(c_f_alpha * f_z, c_m_alpha * f_z, delta, alpha_g)),
            relaxation_length: sigma,
            caster_length: e,
            stiffness: k,
            freeplay,
            damping: c,
            tread_damping: kappa / v,
            moment_of_inertia: i_z,
        })
    }

    fn linear_theory(values: &[Polynomial]) -> Option<TorsionalTheory> {
        let &[v, e, a, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, _, _, kappa, freeplay] = values else {
            return None;
        };
        Some(TorsionalTheory {
            velocity: v,
            caster_length: e,
            half_contact_length: a,
            relaxation_length: sigma,
            moment_of_inertia: i_z,
            torsional_stiffness: k,
            damping_constant: c,
            vertical_force: f_z,
            side_force_derivative: c_f_alpha,
            aligning_moment_derivative: c_m_alpha,
            tread_width_moment_constant: kappa,
            freeplay_angle: freeplay,
        })
    }
}

/// Values that the links σ = 3a and κ = 0.15 a² c_Fα F_z would give: an offer, never applied by the crate itself.
///
/// `half_contact_length` a \[m\], `side_force_derivative` c_Fα \[1/rad\], `vertical_force` F_z \[N\] → (σ \[m\],
/// κ \[N m²/rad\]). Source: the relations that hold among Somieski's data.
pub fn linked<T: Copy + Mul<Output = T> + From<f64>>(
    half_contact_length: T,
    side_force_derivative: T,
    vertical_force: T,
) -> (T, T) {
    let a = half_contact_length;
    (T::from(3.0) * a, T::from(0.15) * a * a * side_force_derivative * vertical_force)
}

/// What the links give: see [`linked`].
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct LinkedParameters {
    /// σ = 3a \[m\].
    pub relaxation_length: f64,
    /// κ = 0.15 a² c_Fα F_z \[N m²/rad\].
    pub tread_width_moment_constant: f64,
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// The parameter table. The linear gear takes the entries that it has from here.
pub(super) const PARAMETERS: [Parameter; 14] = [
    Parameter {
        name: "velocity",
        symbol: "v",
        unit: "m/s",
        default: 50.0,
        min: 1.0,
        max: 120.0,
        scale: Scale::Linear,
        doc: "Taxiing velocity, constant during a run. It enters ẏ = vψ + (e − a)ψ̇ − (v/σ)y, and the tread's damping as κ/v (Somieski 1997). Any value > 0 is valid.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "casterLength",
        symbol: "e",
        unit: "m",
        default: 0.1,
        min: -0.5,
        max: 0.5,
        scale: Scale::Linear,
        doc: "Caster length (mechanical trail), positive when the contact centre trails the steering axis. It is the lever of the side force, −e F_y, and enters ẏ as (e − a)ψ̇ (Somieski 1997). Any finite value is valid.",
        validity: Validity::Finite,
    },
    Parameter {
        name: "halfContactLength",
        symbol: "a",
        unit: "m",
        default: 0.1,
        min: 0.01,
        max: 0.3,
        scale: Scale::Linear,
        doc: "Half of the length over which the tire touches the ground. It enters ẏ as (e − a)ψ̇ (Somieski 1997). Any value > 0 is valid.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "relaxationLength",
        symbol: "σ",
        unit: "m",
        default: 0.3,
        min: 0.02,
        max: 1.0,
        scale: Scale::Linear,
        doc: "Relaxation length of the tire, over which its deformation fades: −(v/σ)y in ẏ, and the slip angle α = arctan(y/σ), in the linear gear y/σ (Somieski 1997; 3a in his data). Any value > 0 is valid.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "momentOfInertia",
        symbol: "I_z",
        unit: "kg m²",
        default: 1.0,
        min: 0.1,
        max: 10.0,
        scale: Scale::Log,
        doc: "Moment of inertia about the steering axis: I_z ψ̈ is the sum of all moments (Somieski 1997). Any value > 0 is valid.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "torsionalStiffness",
        symbol: "k",
        unit: "N m/rad",
        default: 100_000.0,
        min: 0.0,
        max: 300_000.0,
        scale: Scale::Linear,
        doc: "Torsional stiffness, positive when it turns the wheel back: the moment −k s(ψ), with s = ψ where there is no gap (Somieski 1997, who writes c). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "dampingConstant",
        symbol: "c",
        unit: "N m s/rad",
        default: 10.0,
        min: 0.0,
        max: 200.0,
        scale: Scale::Linear,
        doc: "Torsional damping constant, positive when it takes energy out: the moment −cψ̇ (Somieski 1997, who writes k). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "verticalForce",
        symbol: "F_z",
        unit: "N",
        default: 9000.0,
        min: 0.0,
        max: 50_000.0,
        scale: Scale::Linear,
        doc: "Vertical force F_z on the wheel: side force and aligning moment are proportional to it (Somieski 1997). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "sideForceDerivative",
        symbol: "c_Fα",
        unit: "1/rad",
        default: 20.0,
        min: 1.0,
        max: 50.0,
        scale: Scale::Linear,
        doc: "Slope of the side force at small slip angle, per unit of vertical force: F_y = c_Fα F_z α, up to the limit angle δ where there is one (Somieski 1997). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "aligningMomentDerivative",
        symbol: "c_Mα",
        unit: "m/rad",
        default: 2.0,
        min: 0.0,
        max: 5.0,
        scale: Scale::Linear,
        doc: "Slope of the aligning moment at small slip angle, per unit of vertical force: M_z = −c_Mα F_z α there (Somieski 1997). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "sideForceLimitAngle",
        symbol: "δ",
        unit: "rad",
        default: 5.0 * DEGREE,
        min: DEGREE,
        max: 15.0 * DEGREE,
        scale: Scale::Linear,
        doc: "Slip angle at which the side force stops growing: F_y = ±c_Fα F_z δ beyond (Somieski 1997). Any value > 0 is valid; from 90° on it is never reached.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "aligningMomentLimitAngle",
        symbol: "α_g",
        unit: "rad",
        default: 10.0 * DEGREE,
        min: 2.0 * DEGREE,
        max: 30.0 * DEGREE,
        scale: Scale::Linear,
        doc: "Slip angle beyond which there is no aligning moment: M_z = −c_Mα F_z (α_g/π) sin(πα/α_g) within (Somieski 1997). Any value > 0 is valid; from 90° on it is never reached.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "treadWidthMomentConstant",
        symbol: "κ",
        unit: "N m²/rad",
        default: 270.0,
        min: 0.0,
        max: 2000.0,
        scale: Scale::Linear,
        doc: "Damping by the width of the tread: the moment −(κ/v)ψ̇ (Somieski 1997; κ = 0.15 a² c_Fα F_z in his data). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
    Parameter {
        name: "freeplayAngle",
        symbol: "ψ_fp",
        unit: "rad",
        default: 0.0,
        min: 0.0,
        max: 3.0 * DEGREE,
        scale: Scale::Linear,
        doc: "Freeplay, half of the gap in which the spring does not act: s(ψ) = ψ − ψ_fp sign ψ beyond ±ψ_fp, 0 within (Atabay 2012, ch. 6). Any value ≥ 0 is valid.",
        validity: Validity::NonNegative,
    },
];

/// The state table, which the linear gear shares.
pub(super) const STATE: [StateVariable; 3] = [
    StateVariable {
        name: "torsionAngle",
        symbol: "ψ",
        unit: "rad",
        scale: 0.1,
        doc: "Torsion angle of the wheel about the steering axis, positive counter-clockwise from above.",
    },
    StateVariable {
        name: "torsionRate", symbol: "ψ̇", unit: "rad/s", scale: 30.0, doc: "Rate of the torsion angle."
    },
    StateVariable {
        name: "lateralDeformation",
        symbol: "y",
        unit: "m",
        scale: 0.02,
        doc: "Lateral deformation of the leading contact point of the tire, positive to the left of the wheel plane.",
    },
];
