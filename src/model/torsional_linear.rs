//! The torsional gear for small motions.

use super::{
    Mode, Model, System,
    laws::{Laws, TireLaw},
    torsional::{PARAMETERS as FULL, PSI, PSI_RATE, STATE, Y},
};
use crate::{
    element::tire_law::LinearTireLaw,
    parameter::{Parameter, StateVariable},
    real::Real,
    stability::{Polynomial, TorsionalTheory},
};

/// The torsional gear ([`super::Torsional`]) linearised about ψ = 0, without freeplay.
///
/// # Equations
/// ```text
/// I_z ψ̈ = −k ψ − (c + κ/v) ψ̇ − (c_Mα + e c_Fα) F_z y/σ
/// ẏ     = v ψ + (e − a) ψ̇ − (v/σ) y
/// ```
/// State, signs and references as there.
///
/// # Limits
/// v > 0. Unstable motions grow without bound: a long run ends with an error that says when.
#[derive(Clone, Debug)]
pub struct TorsionalLinear {
    velocity: f64,
    /// e − a
    lever: f64,
    /// v/σ
    relaxation_rate: f64,
    /// 1/I_z
    mobility: f64,
    stiffness: f64,
    /// c + κ/v
    damping: f64,
    /// (c_Mα + e c_Fα) F_z/σ
    tire_stiffness: f64,
}

impl System<3> for TorsionalLinear {
    #[inline(always)]
    fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 3]) -> [R; 3] {
        let [psi, psi_rate, y] = *x;
        let torque = -(psi * self.stiffness) - psi_rate * self.damping - y * self.tire_stiffness;
        [psi_rate, torque * self.mobility, psi * self.velocity + psi_rate * self.lever - y * self.relaxation_rate]
    }
}

impl Model<3> for TorsionalLinear {
    const NAME: &'static str = "torsional-linear";
    const TITLE: &'static str = "Torsional nose landing gear, linearised";
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const STATE: &'static [StateVariable] = &STATE;

    fn new(values: &[f64]) -> Self {
        let &[v, e, a, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, kappa] = values else {
            unreachable!("a checked run has as many values as the table has parameters")
        };
        Self {
            velocity: v,
            lever: e - a,
            relaxation_rate: v / sigma,
            mobility: 1.0 / i_z,
            stiffness: k,
            damping: c + kappa / v,
            tire_stiffness: (c_m_alpha + e * c_f_alpha) * f_z / sigma,
        }
    }

    fn kicked(&self, x: &[f64; 3], impulse: f64) -> [f64; 3] {
        [x[PSI], x[PSI_RATE] + impulse * self.mobility, x[Y]]
    }

    fn laws(values: &[f64]) -> Option<Laws> {
        let &[v, e, _, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, kappa] = values else { return None };
        Some(Laws {
            tire: TireLaw::Linear(LinearTireLaw::new(c_f_alpha * f_z, c_m_alpha * f_z)),
            relaxation_length: sigma,
            caster_length: e,
            stiffness: k,
            freeplay: 0.0,
            damping: c,
            tread_damping: kappa / v,
            moment_of_inertia: i_z,
        })
    }

    fn linear_theory(values: &[Polynomial]) -> Option<TorsionalTheory> {
        let &[v, e, a, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, kappa] = values else { return None };
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
            freeplay_angle: Polynomial::from(0.0),
        })
    }
}

/// The full table without the two limit angles and freeplay.
const PARAMETERS: [Parameter; 11] =
    [FULL[0], FULL[1], FULL[2], FULL[3], FULL[4], FULL[5], FULL[6], FULL[7], FULL[8], FULL[9], FULL[12]];
