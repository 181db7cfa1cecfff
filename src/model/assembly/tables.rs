//! The tables of an assembly: those of its parts, one after the other.

use std::sync::Mutex;

use super::{Assembly, Fitted};
use crate::{
    element::damper,
    error::Result,
    model::{self, Description, Model, Tables, Torsional},
    parameter::{Parameter, Scale, Validity},
    stability::at_rest,
};

/// Room for the states of all parts: three of the gear, three of the damper.
pub const STATES: usize = 6;

/// What is on a gear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parts {
    /// The damper, by its name.
    pub damper: Option<&'static str>,
}

impl Parts {
    /// Nothing is on it.
    pub fn none(self) -> bool {
        self == Self::default()
    }
}

/// The damper's lever.
const LEVER_ARM: Parameter = Parameter {
    name: "damper.leverArm",
    symbol: "r",
    unit: "m",
    default: 0.1,
    min: 0.01,
    max: 0.3,
    scale: Scale::Linear,
    doc: "Lever arm through which the turning wheel drives the damper's piston: x = rψ and M_d = rF (Atabay 2012, ch. 7; 0.1 m is chosen). Any value > 0 is valid.",
    validity: Validity::Positive,
};

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
            at_rest::<_, STATES>(&new(tables, values))
        },
        ..*gear
    })
}

/// The damper of checked values, in table order.
pub(crate) fn damper_on(tables: &Description, values: &[f64], mobility: f64) -> Result<Option<Fitted>> {
    let Some(name) = tables.parts.damper else { return Ok(None) };
    let own = |error: crate::Error| error.within("damper");
    let damper = damper::named(name).map_err(own)?;
    let [lever, command, values @ ..] = &values[tables.gear_width()..] else { return Ok(None) };
    damper.check_command(*command).map_err(own)?;
    let made = damper.damper(values).map_err(|error| own(error.within("parameters")))?;
    Ok(Some(Fitted::new(made, *lever, mobility, *command)))
}

/// The system for checked values, in table order.
fn new(tables: &Description, values: &[f64]) -> Assembly {
    let mut gear = None;
    macro_rules! chosen {
        ($($n:literal, $model:ty;)*) => {
            $(if tables.name == <$model>::NAME {
                gear = Some(Torsional::from(<$model as Model<$n>>::new(&values[..tables.gear_width()])));
            })*
        };
    }
    crate::for_each_model!(chosen);
    let Some(gear) = gear else { unreachable!("tables are of a listed gear") };
    let Ok(fitted) = damper_on(tables, values, gear.mobility()) else { unreachable!("values are checked") };
    Assembly { gear, fitted }
}
