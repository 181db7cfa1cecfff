//! The tables of an assembly: those of its parts, one after the other.

use std::sync::Mutex;

use super::{Assembly, Course, Fitted, Roll, Unevenness, Z, controlled::Controlled};
use crate::{
    element::{
        control::{self, Law},
        damper,
    },
    error::{Code, Error, Result, shown},
    model::{self, Description, Model, Tables, Torsional},
    parameter::{Parameter, Scale, StateVariable, Validity},
    stability::{Linearisation, at_rest},
};

/// Room for the states of all parts: three of the gear, three of the damper.
pub const STATES: usize = 6;

/// What is on a gear, and what it goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parts {
    /// The damper, by its name.
    pub damper: Option<&'static str>,
    /// It slows down, as after touchdown.
    pub rolls: bool,
    /// While it does, κ follows F_z.
    pub tread_follows: bool,
    /// The runway is uneven.
    pub runway: bool,
    /// The control law, by its name.
    pub control: Option<&'static str>,
}

impl Parts {
    /// Nothing, and nothing.
    pub const NONE: Self = Self { damper: None, rolls: false, tread_follows: false, runway: false, control: None };

    /// A gear alone.
    pub fn none(self) -> bool {
        self == Self::NONE
    }

    /// Its equations change with the time.
    pub fn changes(self) -> bool {
        self.rolls || self.runway
    }
}

/// A part's parameter.
const PART: Parameter = Parameter {
    name: "",
    symbol: "",
    unit: "",
    default: 0.0,
    min: 0.0,
    max: 1.0,
    scale: Scale::Linear,
    doc: "",
    validity: Validity::NonNegative,
};

/// What a coil that takes its time lets through.
const EFFECTIVE_COMMAND: StateVariable = StateVariable {
    name: "effectiveCommand",
    symbol: "u",
    unit: "A",
    scale: 1.0,
    doc: "Effective command of the damper, which follows what the control law commands.",
};

/// What an actuator does.
const ACTUATOR: StateVariable = StateVariable {
    unit: "N m",
    scale: 100.0,
    doc: "Moment of the actuator, positive against a positive angle, which follows what the control law commands.",
    ..EFFECTIVE_COMMAND
};

/// The damper's lever.
const LEVER_ARM: Parameter = Parameter {
    name: "damper.leverArm",
    symbol: "r",
    unit: "m",
    default: 0.1,
    min: 0.01,
    max: 0.3,
    doc: "Lever arm through which the turning wheel drives the damper's piston: x = rψ and M_d = rF (Atabay 2012, ch. 7; 0.1 m is chosen). Any value > 0 is valid.",
    validity: Validity::Positive,
    ..PART
};

/// A landing roll's.
pub const ROLL: [Parameter; 4] = [
    Parameter {
        name: "touchdownVelocity",
        symbol: "v_0",
        unit: "m/s",
        default: 80.0,
        min: 20.0,
        max: 120.0,
        doc: "Velocity at touchdown, at t = 0 (80 m/s is chosen). It takes the place of `velocity`. Any value above finalVelocity is valid.",
        validity: Validity::Positive,
        ..PART
    },
    Parameter {
        name: "deceleration",
        symbol: "b",
        unit: "m/s²",
        default: 3.0,
        min: 0.5,
        max: 6.0,
        doc: "Deceleration: v(t) = v_0 − b t (3 m/s² is chosen). It is kinematic: no load moves to the nose. Any value > 0 is valid.",
        validity: Validity::Positive,
        ..PART
    },
    Parameter {
        name: "finalVelocity",
        symbol: "v_f",
        unit: "m/s",
        default: 5.0,
        min: 1.0,
        max: 40.0,
        doc: "Velocity at which the roll ends, and which stays if it goes on (5 m/s is chosen). Any value > 0 below touchdownVelocity is valid.",
        validity: Validity::Positive,
        ..PART
    },
    Parameter {
        name: "liftFraction",
        symbol: "λ",
        unit: "1",
        max: 0.9,
        doc: "Part of the weight that lift carries at touchdown: F_z(v) = F_z [1 − λ (v/v_0)²]. From 0 to below 1.",
        ..PART
    },
];

/// An uneven runway's.
pub const RUNWAY: [Parameter; 4] = [
    Parameter {
        name: "disturbance.moment",
        symbol: "M_s",
        unit: "N m",
        default: 100.0,
        min: -1000.0,
        max: 1000.0,
        doc: "Moment about the steering axis by which an uneven runway turns the wheel: M_s sin(2πs/λ_s) over the way s. Any finite value is valid.",
        validity: Validity::Finite,
        ..PART
    },
    Parameter {
        name: "disturbance.wavelength",
        symbol: "λ_s",
        unit: "m",
        default: 2.0,
        min: 0.2,
        max: 20.0,
        scale: Scale::Log,
        doc: "Length of a wave of the uneven runway. Any value > 0 is valid.",
        validity: Validity::Positive,
    },
    Parameter {
        name: "disturbance.start",
        symbol: "t_s",
        unit: "s",
        max: 20.0,
        doc: "When the wheel comes to the uneven stretch. Any value ≥ 0 is valid.",
        ..PART
    },
    Parameter {
        name: "disturbance.duration",
        symbol: "T_s",
        unit: "s",
        default: 1e6,
        max: 30.0,
        doc: "How long the wheel is on it; 10⁶ s are for ever. Any value ≥ 0 is valid.",
        ..PART
    },
];

/// Tables that have been put together: each once.
static KNOWN: Mutex<Vec<&'static Tables<Assembly>>> = Mutex::new(Vec::new());

/// The tables of a gear with something on it; none of a gear that there is not.
pub(crate) fn tables(gear: &str, parts: Parts) -> Option<&'static Tables<Assembly>> {
    let mut known = KNOWN.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    let same =
        |tables: &&&'static Tables<Assembly>| tables.description.name == gear && tables.description.parts == parts;
    if let Some(tables) = known.iter().find(same) {
        return Some(tables);
    }
    let tables = Box::leak(Box::new(Tables { description: described(&model::named(gear)?, parts)?, new }));
    known.push(tables);
    Some(tables)
}

/// The gear's tables, and those of its parts after them.
fn described(gear: &Description, parts: Parts) -> Option<Description> {
    let mut table = gear.table.to_vec();
    let mut state = gear.state.to_vec();
    if let Some(damper) = parts.damper {
        let damper = damper::named(damper).ok()?;
        table.push(LEVER_ARM);
        table.push(Parameter { name: "damper.command", ..damper.command });
        for (parameter, default) in damper.parameters.iter().zip(damper.defaults_on_gear()) {
            let name = Box::leak(format!("damper.parameters.{}", parameter.name).into_boxed_str());
            table.push(Parameter { name, default, ..*parameter });
        }
        state.extend_from_slice(damper.state);
    }
    if let Some(law) = parts.control {
        let law = control::named(law).ok()?;
        for (parameter, part) in
            law.common.iter().map(|common| (common, "")).chain(law.parameters.iter().map(|own| (own, "parameters.")))
        {
            let name = Box::leak(format!("control.{part}{}", parameter.name).into_boxed_str());
            table.push(Parameter { name, ..*parameter });
        }
        if !law.semi_active {
            state.push(ACTUATOR);
        } else if state.last().is_none_or(|last| last.name != EFFECTIVE_COMMAND.name) {
            state.push(EFFECTIVE_COMMAND);
        }
    }
    if parts.runway {
        table.extend_from_slice(&RUNWAY);
    }
    if parts.rolls {
        table.extend_from_slice(&ROLL);
    }
    Some(Description {
        parts,
        table: Box::leak(table.into_boxed_slice()),
        state: Box::leak(state.into_boxed_slice()),
        prepared: |_| None,
        linear_theory: |_| None,
        number_theory: |_| None,
        plane_theory: |_| None,
        linearised: |tables, values| {
            tables.check(values)?;
            tables.check_steady("linear theory")?;
            rest(tables, values)
        },
        ..*gear
    })
}

/// The gear at rest. Where nothing preloads it it rests in the middle, and its straight laws will do; to prepare the others
/// takes its time.
fn rest(tables: &Description, values: &[f64]) -> Result<Linearisation> {
    let rest = at_rest::<_, STATES>(&made(tables, values, true))?;
    if rest.equilibrium.iter().take(Z).all(|x| *x == 0.0) {
        return Ok(rest);
    }
    let mut free = values.to_vec();
    free[tables.parameters.len()..tables.gear_width()].fill(0.0);
    at_rest::<_, STATES>(&made(tables, &free, false))
}

/// The damper of checked values, in table order.
///
/// # Errors
/// Values that are not valid together.
pub(crate) fn damper_on(tables: &Description, values: &[f64], mobility: f64) -> Result<Option<Fitted>> {
    let Some(name) = tables.parts.damper else { return Ok(None) };
    let own = |error: Error| error.within("damper");
    let damper = damper::named(name).map_err(own)?;
    let all = values;
    let [lever, command, values @ ..] = &values[tables.gear_width()..] else { return Ok(None) };
    damper.check_command(*command).map_err(own)?;
    let made = damper.damper(values).map_err(|error| own(error.within("parameters")))?;
    let fading = controlled(tables, all)?.map(|control| control.fading);
    Ok(Some(Fitted::new(made, *lever, mobility, *command, fading)))
}

/// As many values as there are in a part's table, in its order.
fn of_part<const N: usize>(tables: &Description, values: &[f64], part: &[Parameter; N]) -> Option<[f64; N]> {
    let first = tables.table.iter().position(|parameter| parameter.name == part[0].name)?;
    values.get(first..first + N)?.try_into().ok()
}

/// The landing roll of checked values, in table order.
///
/// # Errors
/// Values that are not valid together.
pub(crate) fn roll(tables: &Description, values: &[f64]) -> Result<Option<Roll>> {
    let Some([touchdown_velocity, deceleration, final_velocity, lift_fraction]) = of_part(tables, values, &ROLL) else {
        return Ok(None);
    };
    if final_velocity >= touchdown_velocity {
        let allowed = format!("below {} m/s (touchdownVelocity)", shown(touchdown_velocity));
        return Err(Error::new(Code::OutOfRange, "finalVelocity", shown(final_velocity), allowed));
    }
    if lift_fraction >= 1.0 {
        let allowed = "from 0 to below 1: what is lifted does not roll";
        return Err(Error::new(Code::OutOfRange, "liftFraction", shown(lift_fraction), allowed));
    }
    let tread_follows = tables.parts.tread_follows;
    Ok(Some(Roll { touchdown_velocity, deceleration, final_velocity, lift_fraction, tread_follows }))
}

/// The control law of checked values, in table order; where its state is is not known yet.
///
/// # Errors
/// A law without a damper to command, or with one that follows no command or not all of the law's; an active one beside a
/// damper.
fn controlled(tables: &Description, values: &[f64]) -> Result<Option<Controlled>> {
    let Some(name) = tables.parts.control else { return Ok(None) };
    let law = control::named(name).map_err(|error| error.within("control"))?;
    let place = |name: &str| tables.table.iter().position(|parameter| parameter.name == name);
    let Some(first) = place("control.lag") else { return Ok(None) };
    let refused = |got: &str, allowed: &str| Err(Error::new(Code::Unsuited, "control.law", got, allowed));
    let command = place("damper.command").map(|place| values[place]);
    let [lag, failure, own @ ..] = &values[first..first + 2 + law.parameters.len()] else { return Ok(None) };
    let Some(law_at_work) = Law::of(name, own, command.unwrap_or(0.0)) else { return Ok(None) };
    match tables.parts.damper {
        None if law.semi_active => return refused(name, "active without a damper: the others command one"),
        Some(_) if !law.semi_active => return refused(name, "without a damper, whose place it takes"),
        Some("bouc-wen") => return refused(name, "absent beside bouc-wen, which holds at one command"),
        Some(damper) => {
            let damper = damper::named(damper)?;
            for (command, place) in
                law_at_work.commands().into_iter().chain([0.0]).zip(["minimumCommand", "maximumCommand", "failureTime"])
            {
                damper.check_command(command).map_err(|error| {
                    let place = if law.parameters.iter().any(|parameter| parameter.name == place) {
                        format!("control.parameters.{place}")
                    } else {
                        "control.law".to_owned()
                    };
                    error.called(&place)
                })?;
            }
        }
        None => {}
    }
    Ok(Some(Controlled { law: law_at_work, fading: 1.0 / lag, failure: *failure, place: Z }))
}

/// As [`controlled`], for its errors.
///
/// # Errors
/// Those.
pub(crate) fn check_control(tables: &Description, values: &[f64]) -> Result<()> {
    controlled(tables, values).map(drop)
}

/// What the state u of a gear at rest comes to, for checked values in table order.
pub(crate) fn resting_command(tables: &Description, values: &[f64]) -> f64 {
    let command = || tables.table.iter().position(|parameter| parameter.name == "damper.command");
    match controlled(tables, values) {
        Ok(Some(control)) => control.law.at_rest(),
        _ => command().map_or(0.0, |place| values[place]),
    }
}

fn unevenness(tables: &Description, values: &[f64]) -> Option<Unevenness> {
    let [moment, wavelength, start, duration] = of_part(tables, values, &RUNWAY)?;
    Some(Unevenness { moment, wavelength, start, duration })
}

/// The system for checked values, in table order.
fn new(tables: &Description, values: &[f64]) -> Assembly {
    made(tables, values, false)
}

/// The same; `resting`: with the gear's straight laws, as at rest.
fn made(tables: &Description, values: &[f64], resting: bool) -> Assembly {
    let own = &values[..tables.gear_width()];
    let mut gear = None;
    macro_rules! chosen {
        ($($n:literal, $model:ty;)*) => {
            $(if tables.name == <$model>::NAME {
                let make = if resting { <$model as Model<$n>>::at_rest } else { <$model as Model<$n>>::new };
                gear = Some(Torsional::from(make(own)));
            })*
        };
    }
    crate::for_each_model!(chosen);
    let (Some(gear), Some(laws)) = (gear, tables.laws(values)) else { unreachable!("tables are of a listed gear") };
    let mobility = gear.mobility();
    let (Ok(fitted), Ok(roll), Ok(control)) =
        (damper_on(tables, values, mobility), roll(tables, values), controlled(tables, values))
    else {
        unreachable!("values are checked")
    };
    let at_work = |control: Controlled| {
        let place = fitted.and_then(|fitted| Some((fitted.place()?, fitted.fading_of_command()?)));
        place.map_or(control, |(place, fading)| Controlled { place, fading, ..control })
    };
    let control = control.map(at_work);
    let unevenness = unevenness(tables, values);
    let course = tables.parts.changes().then(|| {
        let (lever, slip) = gear.lever_and_slip();
        let velocity = values[0];
        let (damping, tread) = (laws.damping * mobility, laws.tread_damping * velocity * mobility);
        Course { roll, unevenness, velocity, damping, tread, mobility, lever, slip }
    });
    Assembly { gear, fitted, course, control }
}
