//! Control laws: what a damper's command, or an actuator's moment, does as the wheel turns.
//!
//! A semi-active law commands a current, never a force: the damper decides what that does. An active one commands a moment,
//! for comparison. What is commanded takes effect through a coil that takes its time, and is lost where the coil fails.
//!
//! To add a law: its line in [`list`] and its variant of [`Law`]; the compiler names the places that must know it.

use serde::Serialize;

use crate::{
    error::{Code, Error, Result},
    parameter::{Parameter, Scale, Validity},
};

/// What is known of a law without its values.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Description {
    /// Public name.
    pub name: &'static str,
    /// One line for people.
    pub title: &'static str,
    /// Its parameters, in the order in which they are stored.
    pub parameters: &'static [Parameter],
    /// Those that every law has, beside its own.
    pub common: &'static [Parameter],
    /// It commands a damper; otherwise it takes the place of one.
    #[serde(rename = "semiActive")]
    pub semi_active: bool,
    /// When to use it, and what it does.
    pub doc: &'static str,
}

const BASE: Parameter = Parameter {
    name: "",
    symbol: "",
    unit: "A",
    default: 0.0,
    min: 0.0,
    max: 2.0,
    scale: Scale::Linear,
    doc: "",
    validity: Validity::NonNegative,
};

const MAXIMUM: Parameter = Parameter {
    name: "maximumCommand",
    symbol: "I_max",
    default: 1.5,
    doc: "The largest command, in the damper's unit. Any value ≥ 0 is valid that the damper takes.",
    ..BASE
};

const MINIMUM: Parameter = Parameter {
    name: "minimumCommand",
    symbol: "I_min",
    doc: "The command while it is off, in the damper's unit. Any value ≥ 0 is valid that the damper takes.",
    ..BASE
};

/// How long what is commanded takes to come, and when it is lost: of all laws.
const COMMON: [Parameter; 2] = [LAG, FAILURE];

const LAG: Parameter = Parameter {
    name: "lag",
    symbol: "τ",
    unit: "s",
    default: 1.0 / 190.0,
    min: 1e-3,
    max: 0.05,
    scale: Scale::Log,
    doc: "The coil's lag: u̇ = (command − u)/τ (Spencer et al. 1997: 1/190 s). A damper with a lag of its own keeps that one. Any value > 0 is valid.",
    validity: Validity::Positive,
};

const FAILURE: Parameter = Parameter {
    name: "failureTime",
    symbol: "t_f",
    unit: "s",
    default: 1e6,
    max: 30.0,
    doc: "When the command is lost, from where on it is 0, and the coil empties; 10⁶ s are never. Any value ≥ 0 is valid.",
    ..BASE
};

/// Every law, each a line.
static LAWS: [Description; 5] = [
    Description {
        name: "passive",
        title: "A constant command",
        parameters: &[],
        common: &COMMON,
        semi_active: true,
        doc: "What `damper.command` says, until the coil fails.",
    },
    Description {
        name: "on-off",
        title: "On while the wheel turns fast",
        parameters: &[
            Parameter {
                name: "threshold",
                symbol: "ψ̇_0",
                unit: "rad/s",
                default: 1.0,
                min: 0.1,
                max: 30.0,
                scale: Scale::Log,
                doc: "Rate of the torsion angle above which it switches on; it switches off below nine tenths of that (chosen), so that it does not chatter. Any value > 0 is valid.",
                validity: Validity::Positive,
            },
            MINIMUM,
            MAXIMUM,
        ],
        common: &COMMON,
        semi_active: true,
        doc: "I_max while |ψ̇| is above ψ̇_0, else I_min (chosen).",
    },
    Description {
        name: "proportional",
        title: "In proportion to the rate",
        parameters: &[
            Parameter {
                name: "gain",
                symbol: "g",
                unit: "A s/rad",
                default: 0.1,
                min: 1e-3,
                max: 10.0,
                scale: Scale::Log,
                doc: "Command by the rate: I = min(I_max, g|ψ̇|). Any value > 0 is valid.",
                validity: Validity::Positive,
            },
            MAXIMUM,
        ],
        common: &COMMON,
        semi_active: true,
        doc: "I = min(I_max, g|ψ̇|) (chosen).",
    },
    Description {
        name: "clipped",
        title: "On while the damper does less than wanted",
        parameters: &[
            Parameter {
                name: "damping",
                symbol: "c_s",
                unit: "N m s/rad",
                default: 60.0,
                min: 1.0,
                max: 500.0,
                scale: Scale::Log,
                doc: "The damping that is wanted: the moment c_s ψ̇. It switches off where the damper's is that large, and on again below nine tenths of it (chosen), so that it does not chatter. Any value > 0 is valid.",
                validity: Validity::Positive,
            },
            MAXIMUM,
        ],
        common: &COMMON,
        semi_active: true,
        doc: "I_max where |M_d| is less than |c_s ψ̇| and against the motion, else 0 (chosen).",
    },
    Description {
        name: "active",
        title: "A moment at will, for comparison",
        parameters: &[
            Parameter {
                name: "damping",
                symbol: "c_s",
                unit: "N m s/rad",
                default: 60.0,
                min: 0.0,
                max: 500.0,
                scale: Scale::Linear,
                doc: "Moment against the rate: M_d = c_s ψ̇ + k_s ψ. Any value ≥ 0 is valid.",
                validity: Validity::NonNegative,
            },
            Parameter {
                name: "stiffness",
                symbol: "k_s",
                unit: "N m/rad",
                max: 100_000.0,
                doc: "Moment against the angle: M_d = c_s ψ̇ + k_s ψ. Any finite value is valid.",
                validity: Validity::Finite,
                ..BASE
            },
            Parameter {
                name: "maximumMoment",
                symbol: "M_max",
                unit: "N m",
                default: 1000.0,
                min: 10.0,
                max: 10_000.0,
                scale: Scale::Log,
                doc: "The largest moment of the actuator, |M_d| ≤ M_max. Any value > 0 is valid.",
                validity: Validity::Positive,
            },
        ],
        common: &COMMON,
        semi_active: false,
        doc: "M_d = c_s ψ̇ + k_s ψ within ± M_max: an actuator in the place of a damper, which may feed energy in.",
    },
];

/// The tables of all laws.
pub fn list() -> &'static [Description] {
    &LAWS
}

/// The tables of the law `name`.
///
/// # Errors
/// An unknown name, with the nearest known one.
pub fn named(name: &str) -> Result<&'static Description> {
    LAWS.iter().find(|law| law.name == name).ok_or_else(|| {
        let known: Vec<_> = LAWS.iter().map(|law| law.name).collect();
        Error::unknown(Code::UnknownName, "law", name, &known)
    })
}

/// A law with its values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Law {
    /// This command.
    Passive(f64),
    /// One of two commands, by |ψ̇|.
    OnOff {
        /// ψ̇₀ \[rad/s\]
        threshold: f64,
        /// I_min
        low: f64,
        /// I_max
        high: f64,
    },
    /// I = min(I_max, g|ψ̇|).
    Proportional {
        /// g \[A s/rad\]
        gain: f64,
        /// I_max
        high: f64,
    },
    /// I_max or nothing, by what the damper does.
    Clipped {
        /// c_s \[N m s/rad\]
        damping: f64,
        /// I_max
        high: f64,
    },
    /// M_d = c_s ψ̇ + k_s ψ within ± M_max.
    Active {
        /// c_s \[N m s/rad\]
        damping: f64,
        /// k_s \[N m/rad\]
        stiffness: f64,
        /// M_max \[N m\]
        most: f64,
    },
}

impl Law {
    /// The law `name` with its values in table order, of a damper at `command`.
    pub fn of(name: &str, values: &[f64], command: f64) -> Option<Self> {
        Some(match (name, values) {
            ("passive", []) => Self::Passive(command),
            ("on-off", &[threshold, low, high]) => Self::OnOff { threshold, low, high },
            ("proportional", &[gain, high]) => Self::Proportional { gain, high },
            ("clipped", &[damping, high]) => Self::Clipped { damping, high },
            ("active", &[damping, stiffness, most]) => Self::Active { damping, stiffness, most },
            _ => return None,
        })
    }

    /// What it commands of a wheel at rest.
    pub fn at_rest(&self) -> f64 {
        match self {
            Self::Passive(command) => *command,
            Self::OnOff { low, .. } => *low,
            Self::Proportional { .. } | Self::Clipped { .. } | Self::Active { .. } => 0.0,
        }
    }

    /// The commands that it may give to a damper.
    pub fn commands(&self) -> [f64; 2] {
        match self {
            Self::Passive(command) => [0.0, *command],
            Self::OnOff { low, high, .. } => [*low, *high],
            Self::Proportional { high, .. } | Self::Clipped { high, .. } => [0.0, *high],
            Self::Active { .. } => [0.0, 0.0],
        }
    }
}
