//! What the dampers' tables have in common.

use crate::parameter::{Parameter, Scale, StateVariable, Validity};

/// A damping constant.
pub(super) const DAMPING: Parameter = Parameter {
    name: "viscousDamping",
    symbol: "c_0",
    unit: "N s/m",
    default: 0.0,
    min: 0.0,
    max: 0.0,
    scale: Scale::Log,
    doc: "",
    validity: Validity::NonNegative,
};

/// A stiffness.
pub(super) const STIFFNESS: Parameter = Parameter { name: "stiffness", symbol: "k_0", unit: "N/m", ..DAMPING };

/// α
pub(super) const GAIN: Parameter = Parameter { name: "hysteresisGain", symbol: "α", unit: "N/m", ..DAMPING };

/// x₀
pub(super) const OFFSET: Parameter =
    Parameter { name: "offset", symbol: "x_0", unit: "m", scale: Scale::Linear, validity: Validity::Finite, ..DAMPING };

/// γ
pub(super) const GAMMA: Parameter = Parameter {
    name: "gamma",
    symbol: "γ",
    unit: "1/m²",
    doc: "How much of the hysteresis element's yielding turns its sense with the velocity: −γ|ẋ|z|z|ⁿ⁻¹ in ż. The unit is m⁻ⁿ. Any value ≥ 0 is valid, together with γ + β > 0.",
    ..DAMPING
};

/// β
pub(super) const BETA: Parameter = Parameter {
    name: "beta",
    symbol: "β",
    unit: "1/m²",
    doc: "How much of the yielding keeps its sense: −βẋ|z|ⁿ in ż. The unit is m⁻ⁿ. Any value with γ + β > 0 is valid; with |β| > γ z must start within ± z_max.",
    validity: Validity::Finite,
    ..DAMPING
};

/// n
pub(super) const EXPONENT: Parameter = Parameter {
    name: "exponent",
    symbol: "n",
    unit: "1",
    default: 2.0,
    min: 1.0,
    max: 4.0,
    scale: Scale::Linear,
    doc: "How sharply the hysteresis element yields: |z|ⁿ in ż. From 1 to 20; for 1 and 2 z is known in closed form.",
    validity: Validity::Positive,
};

/// A
pub(super) const AMPLITUDE: Parameter = Parameter {
    name: "amplitude",
    symbol: "A",
    unit: "1",
    doc: "Rate of z per unit of displacement before the element yields: Aẋ in ż. It yields at z_max = (A/(β + γ))^(1/n). Any value > 0 is valid.",
    validity: Validity::Positive,
    ..DAMPING
};

/// η
pub(super) const COMMAND_RATE: Parameter = Parameter {
    name: "commandRate",
    symbol: "η",
    unit: "1/s",
    doc: "How fast the fluid and the coil follow the command: u̇ = −η(u − command) (Spencer et al. 1997, eq. 11). Any value > 0 is valid.",
    validity: Validity::Positive,
    ..DAMPING
};

/// A current.
pub(super) const CURRENT: Parameter = Parameter {
    name: "command",
    symbol: "I",
    unit: "A",
    default: 0.5,
    min: 0.0,
    max: 1.5,
    scale: Scale::Linear,
    doc: "",
    validity: Validity::NonNegative,
};

/// z
pub(super) const HYSTERESIS: StateVariable = StateVariable {
    name: "hysteresis",
    symbol: "z",
    unit: "m",
    scale: 0.005,
    doc: "Hysteresis variable: how far the Bouc–Wen element is wound, positive after a positive displacement; it pulls with αz.",
};

/// w
pub(super) const INTERNAL: StateVariable = StateVariable {
    name: "internalDisplacement",
    symbol: "w",
    unit: "m",
    scale: 0.01,
    doc: "Displacement between the two parts in series, in the sense of the piston's.",
};

/// u
pub(super) const EFFECTIVE_COMMAND: StateVariable = StateVariable {
    name: "effectiveCommand",
    symbol: "u",
    unit: "V",
    scale: 1.0,
    doc: "What has arrived of the command in the fluid; it starts at the command.",
};
