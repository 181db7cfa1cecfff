//! Parameters of the torsional gears that follow others.

use super::Ring;
use crate::{error::Result, model::torsional, parameter::Parameter, run::Fields};

/// Which links between parameters hold as others vary: none, unless asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Links {
    /// σ = 3a holds as a varies.
    pub relaxation_length: bool,
    /// κ = 0.15 a² c_Fα F_z holds as a, c_Fα or F_z varies.
    pub tread_width_moment_constant: bool,
}

impl Links {
    /// Reads the field `linked: {relaxationLength, treadWidthMomentConstant}`.
    pub(super) fn read(fields: &Fields) -> Result<Self> {
        let Some(linked) = fields.value("linked") else { return Ok(Self::default()) };
        let linked = Fields::of("linked", linked, &["relaxationLength", "treadWidthMomentConstant"])?;
        Ok(Self {
            relaxation_length: linked.truth("relaxationLength")?.unwrap_or(false),
            tread_width_moment_constant: linked.truth("treadWidthMomentConstant")?.unwrap_or(false),
        })
    }

    /// Lets what is linked to the parameters that vary follow them; what varies itself follows nothing.
    pub(super) fn follow<T: Ring>(self, table: &[Parameter], values: &mut [T], varying: &[&str]) {
        let place = |name: &str| table.iter().position(|parameter| parameter.name == name);
        let [Some(a), Some(c_f_alpha), Some(f_z), Some(sigma), Some(kappa)] = [
            "halfContactLength",
            "sideForceDerivative",
            "verticalForce",
            "relaxationLength",
            "treadWidthMomentConstant",
        ]
        .map(place) else {
            return;
        };
        let varies = |index: usize| varying.contains(&table[index].name);
        let linked = torsional::linked(values[a], values[c_f_alpha], values[f_z]);
        if self.relaxation_length && varies(a) && !varies(sigma) {
            values[sigma] = linked.0;
        }
        if self.tread_width_moment_constant && (varies(a) || varies(c_f_alpha) || varies(f_z)) && !varies(kappa) {
            values[kappa] = linked.1;
        }
    }
}
