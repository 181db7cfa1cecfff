//! The list of methods.

use serde::Serialize;

use crate::error::{Code, Error, Result};

/// A method that a run can ask for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Order 5, order 8 or the L-stable scheme, by tolerance and stiffness.
    Auto,
    /// Always this scheme.
    Always(Scheme),
}

/// A scheme: a table of coefficients with its dense output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scheme {
    /// Dormand–Prince 5(4).
    DormandPrince,
    /// DOP853.
    Dop853,
    /// The classical method with a fixed step.
    RungeKutta4,
    /// Rodas5P, L-stable.
    Rodas,
}

/// What is known of a method without a run.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct MethodDescription {
    /// Public name.
    pub name: &'static str,
    /// One line for people.
    pub title: &'static str,
    /// Order of convergence; 0 where it depends on the run.
    pub order: u32,
    /// Whether the step follows a tolerance.
    pub adaptive: bool,
    /// Whether the scheme is L-stable (for stiff equations).
    pub stiff: bool,
    /// When to use it.
    pub doc: &'static str,
}

const METHODS: [(Method, MethodDescription); 5] = [
    (
        Method::Auto,
        MethodDescription {
            name: "auto",
            title: "Automatic",
            order: 0,
            adaptive: true,
            stiff: true,
            doc: "Order 5 for tolerances from 1e-5 up, order 8 below; goes over to the L-stable scheme where a run turns stiff.",
        },
    ),
    (
        Method::Always(Scheme::DormandPrince),
        MethodDescription {
            name: "dormand-prince",
            title: "Dormand–Prince 5(4)",
            order: 5,
            adaptive: true,
            stiff: false,
            doc: "Explicit, order 5 with a fourth-order estimate, dense output of order 4. Best at loose tolerances.",
        },
    ),
    (
        Method::Always(Scheme::Dop853),
        MethodDescription {
            name: "dop853",
            title: "Dormand–Prince 8(5,3)",
            order: 8,
            adaptive: true,
            stiff: false,
            doc: "Explicit, order 8, dense output of order 7. Best at tight tolerances.",
        },
    ),
    (
        Method::Always(Scheme::RungeKutta4),
        MethodDescription {
            name: "rk4",
            title: "Classical Runge–Kutta",
            order: 4,
            adaptive: false,
            stiff: false,
            doc: "Explicit, order 4, fixed step (`step`, 1e-4 s). Refused where the step is unstable for the equations.",
        },
    ),
    (
        Method::Always(Scheme::Rodas),
        MethodDescription {
            name: "rodas",
            title: "Rodas5P",
            order: 5,
            adaptive: true,
            stiff: true,
            doc: "Linearly implicit, order 5, L-stable, dense output of order 4. For stiff equations.",
        },
    ),
];

/// All methods that a run can name.
pub fn methods() -> Vec<MethodDescription> {
    METHODS.iter().map(|(_, description)| *description).collect()
}

impl Method {
    /// The method of a public name.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one.
    pub fn named(name: &str) -> Result<Self> {
        METHODS.iter().find(|(_, description)| description.name == name).map(|(method, _)| *method).ok_or_else(|| {
            let known: Vec<_> = METHODS.iter().map(|(_, description)| description.name).collect();
            Error::unknown(Code::UnknownName, "method", name, &known)
        })
    }

    /// The scheme that a run starts with.
    pub fn scheme(self, rtol: f64) -> Scheme {
        match self {
            Method::Always(scheme) => scheme,
            Method::Auto if rtol >= 1e-5 => Scheme::DormandPrince,
            Method::Auto => Scheme::Dop853,
        }
    }
}

impl Scheme {
    /// The number that snapshots know it by: its place in the list.
    pub(super) fn number(self) -> u64 {
        METHODS.iter().position(|(method, _)| *method == Method::Always(self)).unwrap_or(METHODS.len()) as u64
    }

    /// The scheme of a number.
    pub(super) fn numbered(number: u64) -> Option<Self> {
        match METHODS.get(usize::try_from(number).ok()?)?.0 {
            Method::Always(scheme) => Some(scheme),
            Method::Auto => None,
        }
    }

    /// Public name.
    pub fn name(self) -> &'static str {
        METHODS
            .iter()
            .find(|(method, _)| *method == Method::Always(self))
            .map_or("", |(_, description)| description.name)
    }
}
