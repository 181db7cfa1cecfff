//! The torsional nose landing gear on a stretched-string tire.

mod lanes;
mod tables;

use std::ops::Mul;

pub use self::lanes::{Laned, Prepared};
pub(super) use self::tables::{PARAMETERS, STATE};
use super::{Gear, Mode, Model, System, laws::Laws};
use crate::{
    element::{
        Boundary, Side,
        freeplay::Spring,
        friction::{DryFriction, Rubbing, with_friction},
        tire_law::{NO_MOMENT, PiecewiseTireLaw, SteeringMoment, TireLaw},
    },
    parameter::{Parameter, StateVariable},
    real::{Dual, Real, Sums},
    stability::{Ring, TorsionalTheory},
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
// So are the spring's side and what the friction does.
const FREEPLAY: usize = 2;
const FRICTION: usize = 3;
// All of these bits where the friction holds the wheel: every moment is then looked up as none.
const HELD: usize = 4;

// Two switches a kink, and those of the friction: it comes to rest, and it can no longer hold.
const STOP: usize = 6;
const RELEASE: usize = 7;

/// A wheel that turns about a steering axis by the angle ψ against a spring and a damper, and is steered by its own tire.
///
/// # Equations
/// ```text
/// I_z ψ̈ = −k s(ψ) − c ψ̇ − (κ/v) ψ̇ + M_z(α) − e F_y(α) − M_f sign ψ̇
/// ẏ     = v ψ + (e − a) ψ̇ − (v/σ) y
/// α     = arctan(y/σ)
/// ```
/// s is the spring's angle with freeplay ([`Spring`]), F_y and M_z the piecewise tire law ([`PiecewiseTireLaw`]), M_f a dry
/// friction ([`DryFriction`]) where there is one: at ψ̇ = 0 the wheel sticks as long as the other moments are within ± M_f.
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
/// for it, as with M_f = 0. The equations are odd in the state, and homogeneous in (state, ψ_fp, M_f) while the tire is in
/// its linear range.
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
    motion: Motion<f64>,
    /// 1/σ
    slip_ratio: f64,
    stiffness: f64,
    /// 1/I_z
    mobility: f64,
    /// k s(ψ)/I_z
    spring: Spring,
    /// M_f/I_z
    friction: DryFriction,
    /// By the spring's side and, four times that, what the friction does: both over I_z, a straight line in ψ.
    lines: [(f64, f64); 16],
    /// tan δ and tan α_g
    limits: [f64; 2],
    /// (M_z − e F_y)/I_z
    tire: SteeringMoment,
}

/// The equations of motion, whatever gives the forces: of one gear, of one in each lane, or of one whose speed changes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motion<C> {
    pub velocity: C,
    /// e − a
    pub lever: C,
    /// v/σ
    pub relaxation_rate: C,
    /// (c + κ/v)/I_z
    pub damping: C,
}

impl<C: Copy> Motion<C> {
    /// The rate of the state, with the moments over I_z of the spring and of the tire, which is added last, as it takes
    /// longest to come.
    #[inline(always)]
    fn rate<R: Sums<C>>(&self, x: &[R; 3], spring: R, tire: R) -> [R; 3] {
        let [psi, psi_rate, y] = *x;
        let psi_acceleration = tire - spring.plus(psi_rate, self.damping);
        let y_rate = (psi * self.velocity).plus(psi_rate, self.lever).minus(y, self.relaxation_rate);
        [psi_rate, psi_acceleration, y_rate]
    }
}

impl Torsional {
    /// The laws, v and a of checked parameter values.
    fn taken(values: &[f64]) -> (Laws, f64, f64) {
        let (Some(laws), [v, _, a, ..]) = (Self::laws(values), values) else {
            unreachable!("a checked run has as many values as the table has parameters")
        };
        (laws, *v, *a)
    }

    /// A wheel with these laws that rolls with the velocity v \[m/s\] on a tire of half contact length a \[m\].
    pub fn rolling(laws: &Laws, velocity: f64, half_contact_length: f64) -> Self {
        let Laws { relaxation_length, moment_of_inertia, .. } = *laws;
        let spring = Spring::new(laws.stiffness / moment_of_inertia, laws.freeplay);
        let friction = DryFriction::new(laws.friction / moment_of_inertia);
        Self {
            motion: Motion {
                velocity,
                lever: laws.caster_length - half_contact_length,
                relaxation_rate: velocity / relaxation_length,
                damping: (laws.damping + laws.tread_damping) / moment_of_inertia,
            },
            slip_ratio: 1.0 / relaxation_length,
            mobility: 1.0 / moment_of_inertia,
            stiffness: laws.stiffness,
            spring,
            friction,
            lines: lines(&spring, &friction),
            limits: [laws.tire.side_force_limit(), laws.tire.aligning_limit()],
            tire: SteeringMoment::new(laws.tire, laws.caster_length, relaxation_length, moment_of_inertia),
        }
    }

    /// The sum of all moments but the friction's on a wheel that does not turn, over I_z; and its slope in y.
    ///
    /// Asked for seldom, and never in a gear without friction: one copy of it serves all kinds of numbers.
    #[inline(never)]
    fn load(&self, mode: Mode, psi: f64, y: f64) -> (f64, f64) {
        let limited = self.tire.constant(mode.sides(SIDE_FORCE));
        let tire = self.tire.curve(Dual::<1>::variable(y, 0), mode.sides(SIDE_FORCE));
        (-(self.spring.torque(psi, mode.sides(FREEPLAY)) - limited) + tire.value, tire.slope[0])
    }

    /// STOP or RELEASE of a wheel with friction: not worth its code wherever switches are looked at.
    #[inline(never)]
    fn friction_switch<R: Real>(&self, which: usize, mode: Mode, x: &[R; 3]) -> Option<R> {
        match which {
            STOP if Self::rubs(mode, Rubbing::Forward) => Some(x[PSI_RATE]),
            STOP if Self::rubs(mode, Rubbing::Backward) => Some(-x[PSI_RATE]),
            RELEASE if Self::rubs(mode, Rubbing::Sticking) => {
                let (psi, y) = (x[PSI].value(), x[Y].value());
                let (load, slope) = self.load(mode, psi, y);
                let (stiffness, _) = self.spring.lines()[(mode.sides(FREEPLAY) & 3) as usize];
                let load = (x[Y] - y) * slope - (x[PSI] - psi) * stiffness + load;
                Some(self.friction.margin(load))
            }
            _ => None,
        }
    }

    /// Past STOP or RELEASE.
    #[inline(never)]
    fn cross_friction(&self, which: usize, mode: Mode, x: &mut [f64; 3]) -> Mode {
        x[PSI_RATE] = 0.0;
        let (load, slope) = self.load(mode, x[PSI], x[Y]);
        if which == RELEASE {
            // To rounding the load is what the friction can hold: by less, and the wheel would be slowed down as it starts.
            if slope != 0.0 {
                x[Y] -= (load.abs() - self.friction.moment()) * load.signum() / slope;
            }
            return Self::rubbing(mode, self.friction.released(load));
        }
        // It was slowed down: what it can do now is stick, or turn back.
        let onward = (load > 0.0) == Self::rubs(mode, Rubbing::Forward);
        Self::rubbing(mode, if onward { Rubbing::Sticking } else { self.friction.at(0.0, load) })
    }

    /// What the friction does in a mode.
    #[inline(always)]
    pub(super) fn rubs(mode: Mode, how: Rubbing) -> bool {
        mode.sides(FRICTION) & 3 == how as u32
    }

    /// The mode with the friction at work like this.
    pub(super) fn rubbing(mode: Mode, how: Rubbing) -> Mode {
        let held = if how == Rubbing::Sticking { NO_MOMENT } else { 0 };
        mode.with(FRICTION, how as u32).with(HELD, held & 3).with(HELD + 1, held >> 2)
    }

    /// The friction, with M_f/I_z.
    pub(super) fn friction(&self) -> &DryFriction {
        &self.friction
    }

    /// 1/I_z
    pub(super) fn mobility(&self) -> f64 {
        self.mobility
    }

    /// The rate of the state with one more moment against the motion, over I_z.
    #[inline(always)]
    pub(super) fn driven<R: Real>(&self, mode: Mode, x: &[R; 3], moment: R) -> [R; 3] {
        // All moments over I_z. A side force at its limit is constant: it is there as early as the spring's.
        let sides = mode.sides(SIDE_FORCE) | mode.sides(HELD);
        let (stiffness, offset) = self.lines[(mode.sides(FREEPLAY) & 15) as usize];
        let spring_and_friction = x[PSI] * stiffness + offset;
        let known = spring_and_friction + moment - self.tire.constant(sides);
        self.motion.rate(x, known, self.tire.curve(x[Y], sides))
    }

    /// The same while speed and weight change: `motion` is what holds now, `weight` the part of F_z that is on the wheel.
    pub(super) fn rolled<R: Real>(&self, mode: Mode, x: &[R; 3], moment: R, motion: &Motion<R>, weight: R) -> [R; 3] {
        let sides = mode.sides(SIDE_FORCE) | mode.sides(HELD);
        let (stiffness, offset) = self.lines[(mode.sides(FREEPLAY) & 15) as usize];
        let spring_and_friction = x[PSI] * stiffness + offset;
        let known = spring_and_friction + moment - weight * self.tire.constant(sides);
        motion.rate(x, known, self.tire.curve(x[Y], sides) * weight)
    }

    /// e − a \[m\] and 1/σ \[1/m\].
    pub(super) fn lever_and_slip(&self) -> (f64, f64) {
        (self.motion.lever, self.slip_ratio)
    }

    /// The sides of the kinks, without friction.
    pub(super) fn sides(&self, x: &[f64; 3]) -> Mode {
        let q = x[Y] * self.slip_ratio;
        let y_rate = self.motion.rate(x, 0.0, 0.0)[Y];
        let mut mode = Mode::default()
            .with_side(SIDE_FORCE, Side::of(q, y_rate, self.limits[SIDE_FORCE]))
            .with_side(ALIGNING, Side::of(q, y_rate, self.limits[ALIGNING]));
        if self.spring.freeplay() > 0.0 {
            mode = mode.with_side(FREEPLAY, Side::of(x[PSI], x[PSI_RATE], self.spring.freeplay()));
        }
        mode
    }
}

/// See [`Torsional::lines`].
fn lines(spring: &Spring, friction: &DryFriction) -> [(f64, f64); 16] {
    std::array::from_fn(|bits| {
        let (stiffness, offset) = spring.lines()[bits & 3];
        let rubbing = bits >> 2;
        if rubbing == Rubbing::Sticking as usize {
            return (0.0, 0.0);
        }
        let torque = if rubbing == Rubbing::Forward as usize {
            friction.moment()
        } else if rubbing == Rubbing::Backward as usize {
            -friction.moment()
        } else {
            0.0
        };
        (stiffness, offset + torque)
    })
}

impl System<3> for Torsional {
    const SWITCHES: usize = 8;
    const SELDOM: usize = 2;
    const EVENT_KINDS: &'static [&'static str] =
        &["side-force-limit", "aligning-moment-limit", "freeplay", "friction-stop", "friction-release"];

    #[inline(always)]
    fn rate<R: Real>(&self, _t: R, mode: Mode, x: &[R; 3]) -> [R; 3] {
        // All moments over I_z. A side force at its limit is constant: it is there as early as the spring's.
        let sides = mode.sides(SIDE_FORCE) | mode.sides(HELD);
        let (stiffness, offset) = self.lines[(mode.sides(FREEPLAY) & 15) as usize];
        let spring_and_friction = x[PSI] * stiffness + offset;
        self.motion.rate(x, spring_and_friction - self.tire.constant(sides), self.tire.curve(x[Y], sides))
    }

    fn mode(&self, _t: f64, x: &[f64; 3]) -> Mode {
        let mut mode = self.sides(x);
        if self.friction.moment() > 0.0 {
            let (load, _) = self.load(mode, x[PSI], x[Y]);
            mode = Self::rubbing(mode, self.friction.at(x[PSI_RATE], load));
        }
        mode
    }

    #[inline(always)]
    fn switch<R: Real>(&self, which: usize, _t: R, mode: Mode, x: &[R; 3]) -> Option<R> {
        if which >= STOP {
            return if mode.sides(FRICTION) & 3 == 0 { None } else { self.friction_switch(which, mode, x) };
        }
        let (kink, boundary) = kink_and_boundary(which);
        let (quantity, limit) = match kink {
            SIDE_FORCE | ALIGNING if self.limits[kink].is_finite() => (x[Y] * self.slip_ratio, self.limits[kink]),
            SIDE_FORCE | ALIGNING => return None, // a limit of 90° or more is never reached
            _ if self.spring.freeplay() > 0.0 => (x[PSI], self.spring.freeplay()),
            _ => return None,
        };
        mode.side(kink).margin(boundary, quantity, limit)
    }

    #[inline(always)]
    fn minds(&self, mode: Mode) -> bool {
        !Self::rubs(mode, Rubbing::Absent)
    }

    fn cross(&self, which: usize, _t: f64, mode: Mode, x: &mut [f64; 3]) -> Mode {
        if which >= STOP {
            return self.cross_friction(which, mode, x);
        }
        let (kink, boundary) = kink_and_boundary(which);
        mode.with_side(kink, mode.side(kink).across(boundary))
    }

    fn event_kind(&self, which: usize) -> usize {
        match which {
            STOP => 3,
            RELEASE => 4,
            _ => kink_and_boundary(which).0,
        }
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
        (self.spring.freeplay() > 0.0).then(|| {
            let spring = Spring::new(self.stiffness * self.mobility, 0.0);
            Self { spring, lines: lines(&spring, &self.friction), ..self.clone() }
        })
    }

    fn sticks(&self) -> bool {
        self.friction.moment() > 0.0
    }
}

impl Model<3> for Torsional {
    type System = Self;
    const NAME: &'static str = "torsional";
    const TITLE: &'static str = "Torsional nose landing gear on a stretched-string tire";
    const PARAMETERS: &'static [Parameter] = &PARAMETERS;
    const TABLE: &'static [Parameter] = &with_friction::<14, 15>(PARAMETERS);
    const STATE: &'static [StateVariable] = &STATE;

    fn new(values: &[f64]) -> Self {
        let (laws, v, a) = Self::taken(values);
        Self::rolling(&laws, v, a)
    }

    fn at_rest(values: &[f64]) -> Self {
        let (laws, v, a) = Self::taken(values);
        Self::rolling(&laws.linearised(), v, a)
    }

    fn laws(values: &[f64]) -> Option<Laws> {
        let &[v, e, _, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, delta, alpha_g, kappa, freeplay, ref elements @ ..] =
            values
        else {
            return None;
        };
        Some(Laws {
            tire: TireLaw::Piecewise(PiecewiseTireLaw::new(c_f_alpha * f_z, c_m_alpha * f_z, delta, alpha_g)),
            relaxation_length: sigma,
            caster_length: e,
            stiffness: k,
            freeplay,
            friction: elements.first().copied().unwrap_or(0.0),
            damping: c,
            tread_damping: kappa / v,
            moment_of_inertia: i_z,
            fitted: None,
        })
    }

    fn prepared(values: &[f64]) -> Option<Prepared> {
        // Elements beside the table's parameters are not in the lanes' equations.
        let alone =
            values.get(PARAMETERS.len()..).is_none_or(|elements| elements.iter().all(|element| *element == 0.0));
        alone.then(|| Prepared::of(&Self::new(values)))?
    }

    fn linear_theory<T: Ring>(values: &[T]) -> Option<TorsionalTheory<T>> {
        let &[v, e, a, sigma, i_z, k, c, f_z, c_f_alpha, c_m_alpha, _, _, kappa, freeplay, ..] = values else {
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkedParameters {
    /// σ = 3a \[m\].
    pub relaxation_length: f64,
    /// κ = 0.15 a² c_Fα F_z \[N m²/rad\].
    pub tread_width_moment_constant: f64,
}
