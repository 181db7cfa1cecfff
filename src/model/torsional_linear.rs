//! The torsional gear for small motions.

use super::{
    Model, Torsional,
    laws::Laws,
    torsional::{PARAMETERS as FULL, STATE},
};
use crate::{
    element::{
        friction::with_friction,
        tire_law::{LinearTireLaw, TireLaw},
    },
    parameter::{Parameter, StateVariable},
    stability::{Ring, TorsionalTheory},
};

/// The torsional gear ([`super::Torsional`]) linearised about ψ = 0, without freeplay; a dry friction may be on it, too.
///
/// # Equations
/// ```text
/// I_z ψ̈ = −k ψ − (c + κ/v) ψ̇ − (c_Mα + e c_Fα) F_z y/σ − M_f sign ψ̇
/// ẏ     = v ψ + (e − a) ψ̇ − (v/σ) y
/// ```
/// State, signs and references as there.
///
/// # Limits
/// v > 0. Unstable motions grow without bound: a long run ends with an error that says when.
/// It is the torsional gear's system with straight laws and, without friction, no kink.
#[derive(Clone, Copy, Debug)]
pub struct TorsionalLinear;

impl Model<3> for TorsionalLinear {
    type System = Torsional;
    const NAME: &'static str = "torsional-linear";
    const TITLE: &'static str = "Torsional nose landing gear, linearised";
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const TABLE: &'static [Parameter] = &with_friction::<11, 12>(PARAMETERS);
    const STATE: &'static [StateVariable] = &STATE;

    fn new(values: &[f64]) -> Torsional {
        let (Some(laws), [v, _, a, ..]) = (Self::laws(values), values) else {
            unreachable!("a checked run has as many values as the table has parameters")
        };
        Torsional::rolling(&laws, *v, *a)
    }

    fn at_rest(values: &[f64]) -> Torsional {
        Self::new(&values[..PARAMETERS.len()])
    }

    fn laws(values: &[f64]) -> Option<Laws> {
        let &[v, e, _, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, kappa, ref elements @ ..] = values else {
            return None;
        };
        Some(Laws {
            tire: TireLaw::Linear(LinearTireLaw::new(c_f_alpha * f_z, c_m_alpha * f_z)),
            relaxation_length: sigma,
            caster_length: e,
            stiffness: k,
            freeplay: 0.0,
            friction: elements.first().copied().unwrap_or(0.0),
            damping: c,
            tread_damping: kappa / v,
            moment_of_inertia: i_z,
            fitted: None,
        })
    }

    fn linear_theory<T: Ring>(values: &[T]) -> Option<TorsionalTheory<T>> {
        let &[v, e, a, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, kappa, ..] = values else { return None };
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
            freeplay_angle: T::from(0.0),
        })
    }
}

/// The full table without the two limit angles and freeplay.
const PARAMETERS: [Parameter; 11] =
    [FULL[0], FULL[1], FULL[2], FULL[3], FULL[4], FULL[5], FULL[6], FULL[7], FULL[8], FULL[9], FULL[12]];
