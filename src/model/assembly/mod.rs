//! Gears put together from parts: a wheel that turns about its steering axis, with a damper on it.
//!
//! One system, of as many states as its parts have, padded to a fixed number: so all that moves it is compiled once, whatever
//! the parts. A gear without any has a system of its own, made for speed.

mod controlled;
mod course;
mod fitted;
mod tables;

pub use self::course::{Roll, Unevenness};
pub(crate) use self::tables::{check_control, damper_on, resting_command, roll, tables};
use self::{controlled::Controlled, course::Course};
pub use self::{
    fitted::Fitted,
    tables::{Parts, ROLL, RUNWAY, STATES},
};
use super::{
    Gear, Mode, System, Torsional,
    torsional::{PSI, PSI_RATE, Y},
};
use crate::{
    element::friction::Rubbing,
    real::{Dual, Real},
};

/// Where the damper's states begin.
const Z: usize = 3;

// Switches: the gear's kinks first, then the damper's, and last those of the friction, which is seldom there.
const KINKS: usize = 6;
const REVERSAL: usize = 6;
const RETURN: usize = 7;
const YIELD: usize = 8;
const SLOWING: usize = 9;
const COMING: usize = 10;
const LEAVING: usize = 11;
const RISING: usize = 12;
const FALLING: usize = 13;
const TURNING: usize = 14;
const FAILING: usize = 15;
const STOP: usize = 16;
const RELEASE: usize = 17;

/// A wheel that turns about its steering axis ([`Torsional`]), with a damper on it, on a way along which speed, weight and
/// runway may change.
///
/// # Equations
/// Those of the gear, with −M_d among the moments, and the damper's ([`Fitted`]); v, F_z and the runway's moment by the time
/// ([`Roll`], [`Unevenness`]).
///
/// # State
/// That of the gear, and after it the damper's: `hysteresis`, `internalDisplacement`, `effectiveCommand`, those that it has.
///
/// # Limits
/// Where the damper has no preload and its command is steady, the equations are odd in the state. At rest z may have any
/// value: there is a line of equilibria, and one eigenvalue is zero.
#[derive(Clone, Debug)]
pub struct Assembly {
    gear: Torsional,
    fitted: Option<Fitted>,
    /// Where something changes with the time.
    course: Option<Course>,
    control: Option<Controlled>,
}

/// The state of the gear alone.
#[inline(always)]
fn wheel<R: Real, const N: usize>(x: &[R; N]) -> [R; 3] {
    [x[PSI], x[PSI_RATE], x[Y]]
}

impl Assembly {
    /// The sum of all moments but the friction's on a wheel that does not turn, over I_z.
    #[inline(never)]
    fn load<R: Real, const N: usize>(&self, t: R, mode: Mode, x: &[R; N]) -> R {
        let mut still = *x;
        still[PSI_RATE] = R::from(0.0);
        self.rate(t, Torsional::rubbing(mode, Rubbing::Absent), &still)[PSI_RATE]
    }

    /// M_d \[N m\] of the damper.
    fn moment<R: Real, const N: usize>(&self, x: &[R; N]) -> R {
        self.fitted.as_ref().map_or(R::from(0.0), |fitted| fitted.moment(x))
    }

    /// Those of a control law: not worth their code wherever switches are looked at.
    #[inline(never)]
    fn control_switch<R: Real, const N: usize>(&self, which: usize, t: R, mode: Mode, x: &[R; N]) -> Option<R> {
        let control = self.control.as_ref()?;
        match which {
            RISING => control.rising(mode, x, self.moment(x)),
            FALLING => control.falling(mode, x, self.moment(x)),
            TURNING => control.turning(mode, x, self.moment(x)),
            _ => control.failing(t, mode),
        }
    }

    /// STOP or RELEASE of a wheel with friction: not worth its code wherever switches are looked at.
    #[inline(never)]
    fn friction_switch<R: Real, const N: usize>(&self, which: usize, t: R, mode: Mode, x: &[R; N]) -> Option<R> {
        match which {
            STOP if Torsional::rubs(mode, Rubbing::Forward) => Some(x[PSI_RATE]),
            STOP if Torsional::rubs(mode, Rubbing::Backward) => Some(-x[PSI_RATE]),
            RELEASE if Torsional::rubs(mode, Rubbing::Sticking) => {
                Some(self.gear.friction().margin(self.load(t, mode, x)))
            }
            _ => None,
        }
    }

    /// Past STOP or RELEASE.
    #[inline(never)]
    fn cross_friction<const N: usize>(&self, which: usize, t: f64, mode: Mode, x: &mut [f64; N]) -> Mode {
        x[PSI_RATE] = 0.0;
        let seeded: [Dual<1>; N] = std::array::from_fn(|i| if i == Y { Dual::variable(x[i], 0) } else { x[i].into() });
        let Dual { value: load, slope: [slope] } = self.load(Dual::from(t), mode, &seeded);
        let friction = self.gear.friction();
        let how = if which == RELEASE {
            // To rounding the load is what the friction can hold: by less, and the wheel would be slowed down as it starts.
            if slope != 0.0 {
                x[Y] -= (load.abs() - friction.moment()) * load.signum() / slope;
            }
            friction.released(load)
        } else if (load > 0.0) == Torsional::rubs(mode, Rubbing::Forward) {
            // It was slowed down: what it can do now is stick, or turn back.
            Rubbing::Sticking
        } else {
            friction.at(0.0, load)
        };
        let mode = Torsional::rubbing(mode, how);
        match &self.fitted {
            // Where the friction stops the wheel or lets it go, a piston that it drives alone does as the wheel.
            Some(fitted) if !fitted.slips() && how != Rubbing::Sticking => {
                fitted.heading(mode, how == Rubbing::Forward, x)
            }
            _ => mode,
        }
    }
}

impl<const N: usize> System<N> for Assembly {
    const SWITCHES: usize = 18;
    const SELDOM: usize = 2;
    const EVENT_KINDS: &'static [&'static str] = &[
        "side-force-limit",
        "aligning-moment-limit",
        "freeplay",
        "friction-stop",
        "friction-release",
        "damper-reversal",
        "damper-return",
        "damper-yield",
        "final-velocity",
        "runway",
        "control-step",
        "control-turn",
        "control-failure",
    ];

    #[inline(always)]
    fn width(&self) -> usize {
        match (&self.fitted, &self.control) {
            (Some(fitted), _) => Z + fitted.states(),
            (None, control) => Z + usize::from(control.is_some()),
        }
    }

    fn rest(&self) -> ([f64; N], u32) {
        let mut x = [0.0; N];
        let free = self.fitted.as_ref().map_or(0, |fitted| fitted.rest(&mut x));
        if let Some(control) = &self.control {
            x[control.place] = control.law.at_rest();
        }
        (x, free)
    }

    #[inline(always)]
    fn fading(&self, mode: Mode, x: &[f64; N]) -> f64 {
        self.fitted.as_ref().map_or(0.0, |fitted| fitted.fading(mode, x))
    }

    // Not worth its code in each of the thirty places that ask for it.
    #[inline(never)]
    fn rate<R: Real>(&self, t: R, mode: Mode, x: &[R; N]) -> [R; N] {
        let mut rate = [R::from(0.0); N];
        let mut moment = R::from(0.0);
        if let Some(fitted) = &self.fitted {
            let taken = fitted.rate(mode, x, &mut rate);
            if !Torsional::rubs(mode, Rubbing::Sticking) {
                moment = taken;
            }
        }
        if let Some(control) = &self.control {
            if self.fitted.is_none() && !Torsional::rubs(mode, Rubbing::Sticking) {
                moment = x[control.place] * self.gear.mobility();
            }
            rate[control.place] = control.rate(mode, x);
        }
        let wheel = match &self.course {
            None => self.gear.driven(mode, &wheel(x), moment),
            Some(course) => {
                if !Torsional::rubs(mode, Rubbing::Sticking) {
                    moment = moment - course.push(t, mode);
                }
                let (motion, weight) = course.motion(t, mode);
                self.gear.rolled(mode, &wheel(x), moment, &motion, weight)
            }
        };
        rate[..Z].copy_from_slice(&wheel);
        rate
    }

    fn mode(&self, t: f64, x: &[f64; N]) -> Mode {
        let mut mode = self.gear.sides(&wheel(x));
        if let Some(course) = &self.course {
            mode = course.mode(t, mode);
        }
        if let Some(control) = &self.control {
            mode = control.mode(t, mode, x, self.moment(x));
        }
        if self.gear.friction().moment() > 0.0 {
            mode = Torsional::rubbing(mode, self.gear.friction().at(x[PSI_RATE], self.load(t, mode, x)));
        }
        let Some(fitted) = &self.fitted else { return mode };
        let slip = fitted.slip(x);
        // Where it stands it goes as it is pulled.
        let heading = if slip == 0.0 { fitted.pull(x, &self.rate(t, mode, x)) } else { slip };
        fitted.heading(mode, heading >= 0.0, x)
    }

    #[inline(never)]
    fn switch<R: Real>(&self, which: usize, t: R, mode: Mode, x: &[R; N]) -> Option<R> {
        match which {
            ..KINKS => self.gear.switch(which, t, mode, &wheel(x)),
            REVERSAL | RETURN | YIELD => {
                let fitted = self.fitted.as_ref()?;
                match which {
                    RETURN => fitted.returning(mode, x),
                    YIELD => fitted.yielding(mode, x),
                    // What turns with the wheel does so by the friction's switch.
                    _ if !fitted.slips() && !Torsional::rubs(mode, Rubbing::Absent) => None,
                    _ => Some(fitted.going(mode, x)),
                }
            }
            SLOWING => self.course.as_ref()?.slowing(t, mode),
            COMING => self.course.as_ref()?.coming(t, mode),
            LEAVING => self.course.as_ref()?.leaving(t, mode),
            RISING | FALLING | TURNING | FAILING => self.control_switch(which, t, mode, x),
            _ => self.friction_switch(which, t, mode, x),
        }
    }

    #[inline(always)]
    fn minds(&self, mode: Mode) -> bool {
        !Torsional::rubs(mode, Rubbing::Absent)
    }

    fn cross(&self, which: usize, t: f64, mode: Mode, x: &mut [f64; N]) -> Mode {
        match which {
            ..KINKS => self.gear.cross(which, t, mode, &mut wheel(x)),
            SLOWING => Course::slowed(mode),
            COMING | LEAVING => Course::passed(mode),
            FAILING => Controlled::failed(mode),
            RISING | FALLING | TURNING => self.control.as_ref().map_or(mode, |control| match which {
                TURNING => control.turned(mode),
                _ => control.stepped(mode, which == RISING),
            }),
            STOP | RELEASE => self.cross_friction(which, t, mode, x),
            _ => self.fitted.as_ref().map_or(mode, |fitted| match which {
                REVERSAL => fitted.turned(mode, x),
                RETURN => fitted.returned(mode, x),
                _ => fitted.yielded(mode, x),
            }),
        }
    }

    fn event_kind(&self, which: usize) -> usize {
        match which {
            ..KINKS => self.gear.event_kind(which),
            STOP => 3,
            RELEASE => 4,
            LEAVING => 9,
            RISING | FALLING => 10,
            TURNING => 11,
            FAILING => 12,
            which => which - REVERSAL + 5,
        }
    }
}

impl<const N: usize> Gear<N> for Assembly {
    fn kicked(&self, x: &[f64; N], impulse: f64) -> [f64; N] {
        let mut kicked = *x;
        kicked[PSI_RATE] += impulse * self.gear.mobility();
        kicked
    }

    fn without_freeplay(&self) -> Option<Self> {
        Some(Self { gear: self.gear.without_freeplay()?, ..self.clone() })
    }

    fn scaled(&self, x: &[f64; N], factor: f64) -> [f64; N] {
        let mut scaled = x.map(|x| x * factor);
        if let Some(control) = &self.control {
            scaled[control.place] = x[control.place];
        }
        if let Some(fitted) = &self.fitted {
            scaled[Z] = fitted.within(scaled[Z]);
            if let Some(place) = fitted.place() {
                scaled[place] = x[place];
            }
        }
        scaled
    }

    fn sticks(&self) -> bool {
        self.gear.sticks()
    }
}
