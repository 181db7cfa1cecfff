//! The force laws as curves.

use std::f64::consts::FRAC_PI_2;

use super::Laws;
use crate::{
    element::tire_law::TireLaw,
    error::{Code, Error, Result, shown},
    parameter::{Validity, check_number},
    run::{Fields, Value},
};

/// Most points of a curve before its kinks.
const MOST: f64 = 100_000.0;

/// Which part of the laws to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curves {
    slip_angle: f64,
    torsion_angle: f64,
    samples: usize,
}

/// Force laws as curves, ascending, with every kink among the points.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceLaws {
    /// α \[rad\].
    pub slip_angle: Vec<f64>,
    /// F_y \[N\].
    pub side_force: Vec<f64>,
    /// M_z \[N m\].
    pub aligning_moment: Vec<f64>,
    /// ψ \[rad\].
    pub torsion_angle: Vec<f64>,
    /// −k s(ψ) \[N m\].
    pub restoring_moment: Vec<f64>,
    /// Where they bend.
    pub kinks: Kinks,
}

/// Angles at which laws bend \[rad\]; none where they do not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kinks {
    /// δ.
    pub side_force_limit_angle: Option<f64>,
    /// α_g.
    pub aligning_moment_limit_angle: Option<f64>,
    /// ψ_fp.
    pub freeplay_angle: Option<f64>,
}

impl Curves {
    /// Over ±`slip_angle` and ±`torsion_angle` \[rad\], each with this many equally spaced points beside the kinks.
    ///
    /// # Errors
    /// Angles that are not > 0, a slip angle of 90° or more, not a whole number of points from 2 to 100 000.
    pub fn new(slip_angle: f64, torsion_angle: f64, samples: f64) -> Result<Self> {
        check_number("slipAngle", slip_angle, Validity::Positive, "rad")?;
        check_number("torsionAngle", torsion_angle, Validity::Positive, "rad")?;
        if slip_angle >= FRAC_PI_2 {
            return Err(Error::new(Code::OutOfRange, "slipAngle", shown(slip_angle), "below π/2 rad"));
        }
        if !(2.0..=MOST).contains(&samples) || samples.fract() != 0.0 {
            let code = if samples > MOST { Code::TooLarge } else { Code::OutOfRange };
            return Err(Error::new(code, "samples", shown(samples), "a whole number from 2 to 1e5"));
        }
        Ok(Self { slip_angle, torsion_angle, samples: samples as usize })
    }

    /// Reads a record `{slipAngle, torsionAngle, samples}`; what is missing is 20° and 201 points.
    ///
    /// # Errors
    /// As [`Curves::new`]; anything but such a record.
    pub fn read(input: &Value) -> Result<Self> {
        let nothing = Value::Record(Vec::new());
        let input = if *input == Value::Absent { &nothing } else { input };
        let fields = Fields::of("curves", input, &["slipAngle", "torsionAngle", "samples"])?;
        let angle = |key| Ok::<_, Error>(fields.number(key, "> 0 rad")?.unwrap_or(20_f64.to_radians()));
        let samples = fields.number("samples", "a whole number from 2 to 1e5")?.unwrap_or(201.0);
        Self::new(angle("slipAngle")?, angle("torsionAngle")?, samples)
    }

    /// The curves of these laws.
    pub(crate) fn of(&self, laws: &Laws) -> ForceLaws {
        let kinks = laws.kinks();
        let slip_angle =
            self.points(self.slip_angle, [kinks.side_force_limit_angle, kinks.aligning_moment_limit_angle]);
        let torsion_angle = self.points(self.torsion_angle, [kinks.freeplay_angle, None]);
        let (side_force, aligning_moment) = slip_angle.iter().map(|alpha| laws.at_slip_angle(*alpha)).unzip();
        // No −0 within the gap.
        let restoring_moment = torsion_angle.iter().map(|psi| 0.0 - laws.stiffness * laws.spring_angle(*psi)).collect();
        ForceLaws { slip_angle, side_force, aligning_moment, torsion_angle, restoring_moment, kinks }
    }

    /// Equally spaced over ±`reach`, and ± the kinks within.
    fn points(&self, reach: f64, kinks: [Option<f64>; 2]) -> Vec<f64> {
        let last = (self.samples - 1) as f64;
        let mut points: Vec<f64> = (0..self.samples).map(|i| reach * ((2.0 * i as f64 - last) / last)).collect();
        for kink in kinks.into_iter().flatten().filter(|kink| *kink < reach).flat_map(|kink| [-kink, kink]) {
            let place = points.partition_point(|point| *point < kink);
            if points[place] != kink {
                points.insert(place, kink);
            }
        }
        points
    }
}

impl Laws {
    /// F_y and M_z at a slip angle below 90°.
    fn at_slip_angle(&self, alpha: f64) -> (f64, f64) {
        let q = match self.tire {
            TireLaw::Piecewise(_) => alpha.tan(),
            TireLaw::Linear(_) => alpha,
        };
        let (_, side_force, aligning_moment, _) = self.at_slip_ratio(q);
        (side_force, aligning_moment)
    }

    fn kinks(&self) -> Kinks {
        let reached = |limit: f64| Some(limit).filter(|limit| *limit < FRAC_PI_2);
        let (side_force, aligning) = match self.tire {
            TireLaw::Piecewise(law) => (reached(law.side_force_limit_angle()), reached(law.aligning_limit_angle())),
            TireLaw::Linear(_) => (None, None),
        };
        Kinks {
            side_force_limit_angle: side_force,
            aligning_moment_limit_angle: aligning,
            freeplay_angle: Some(self.freeplay).filter(|gap| *gap > 0.0),
        }
    }
}
