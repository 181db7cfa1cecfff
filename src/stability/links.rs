//! Parameters of the torsional gears that follow others.

use super::Ring;
use crate::{
    error::{Code, Error, Result},
    model::torsional,
    parameter::Parameter,
    run::Fields,
};

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
    pub(crate) fn read(fields: &Fields) -> Result<Self> {
        let Some(linked) = fields.value("linked") else { return Ok(Self::default()) };
        let linked = Fields::of("linked", linked, &["relaxationLength", "treadWidthMomentConstant"])?;
        let truth = |key: &str| Ok(linked.truth(key).map_err(|error: Error| error.within("linked"))?.unwrap_or(false));
        Ok(Self {
            relaxation_length: truth("relaxationLength")?,
            tread_width_moment_constant: truth("treadWidthMomentConstant")?,
        })
    }

    /// Refuses a link of what varies itself to something else that varies.
    ///
    /// # Errors
    /// The link, by its name.
    pub(crate) fn check(self, varying: &[&str]) -> Result<()> {
        for (linked, name, leaders) in [
            (self.relaxation_length, "relaxationLength", &["halfContactLength"][..]),
            (
                self.tread_width_moment_constant,
                "treadWidthMomentConstant",
                &["halfContactLength", "sideForceDerivative", "verticalForce"],
            ),
        ] {
            if linked && varying.contains(&name) && leaders.iter().any(|leader| varying.contains(leader)) {
                let allowed = "false where what is linked is itself an axis";
                return Err(Error::new(Code::Unsuited, format!("linked.{name}"), "true", allowed));
            }
        }
        Ok(())
    }

    /// Lets what is linked to the parameters that vary follow them; what varies itself follows nothing.
    pub(crate) fn follow<T: Ring>(self, table: &[Parameter], values: &mut [T], varying: &[&str]) {
        let Some(([a, c_f_alpha, f_z, sigma, kappa], [sigma_follows, kappa_follows])) = self.at_work(table, varying)
        else {
            return;
        };
        let linked = torsional::linked(values[a], values[c_f_alpha], values[f_z]);
        if sigma_follows {
            values[sigma] = linked.0;
        }
        if kappa_follows {
            values[kappa] = linked.1;
        }
    }

    /// Where a, c_Fα, F_z, σ and κ are in a table, and whether the last two follow.
    fn at_work(self, table: &[Parameter], varying: &[&str]) -> Option<([usize; 5], [bool; 2])> {
        let mut places = [0; 5];
        for (place, name) in places.iter_mut().zip([
            "halfContactLength",
            "sideForceDerivative",
            "verticalForce",
            "relaxationLength",
            "treadWidthMomentConstant",
        ]) {
            *place = table.iter().position(|parameter| parameter.name == name)?;
        }
        let [a, c_f_alpha, f_z, sigma, kappa] = places.map(|place| varying.contains(&table[place].name));
        let follow = [
            self.relaxation_length && a && !sigma,
            self.tread_width_moment_constant && (a || c_f_alpha || f_z) && !kappa,
        ];
        Some((places, follow))
    }
}
