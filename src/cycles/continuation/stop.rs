//! A cycle on a branch, with what is needed to go on from it.

use nalgebra::Complex;

use super::{
    family::Family,
    newton::{Chart, Place, Solved},
};
use crate::{
    cycles::{
        TRIVIAL,
        flow::Swing,
        shooting::squared,
        vector::{direction, times, vector},
    },
    error::Result,
};

/// A cycle on a branch.
#[derive(Clone, Debug, PartialEq)]
pub struct CyclePoint {
    /// The parameter.
    pub value: f64,
    /// \[s\].
    pub period: f64,
    /// Largest |·| of every state.
    pub amplitude: Vec<f64>,
    /// Where the first state rises through zero, if it does, else another state on the cycle.
    pub state: Vec<f64>,
    /// Floquet multipliers: the trivial one (1, as it was computed) first, the others by falling size, of a pair the positive
    /// imaginary part first.
    pub multipliers: Vec<Complex<f64>>,
    /// How many of the others are outside of the unit circle.
    pub unstable: usize,
    /// The second half mirrors the first.
    pub symmetric: bool,
}

/// A cycle with what is needed to go on from it.
#[derive(Clone, Debug)]
pub(super) struct Stop {
    pub place: Place,
    /// Which way the branch goes on.
    pub tangent: Vec<f64>,
    pub chart: Chart,
    /// Multipliers of one round, or of half of one and its mirror, without the trivial one.
    pub halves: Vec<Complex<f64>>,
    pub point: CyclePoint,
}

impl Stop {
    /// What there is to know of a cycle that was found; the branch goes on along `ahead`.
    ///
    /// # Errors
    /// A motion or a matrix that leaves the numbers.
    pub fn of(family: &mut dyn Family, chart: &Chart, solved: Solved, ahead: &[f64]) -> Result<Self> {
        let (trivial, halves) = solved.multipliers()?;
        let place = solved.place.clone();
        let symmetric = chart.sign < 0.0;
        let period = place.time * if symmetric { 2.0 } else { 1.0 };
        family.vary(place.value);
        let flow = family.flow();
        let Swing { amplitude, size, rise } = flow.swing(&place.x, period)?;
        let whole = |half: &Complex<f64>| if symmetric { squared(half) } else { *half };
        let multipliers: Vec<_> = [Complex::from(trivial)].iter().chain(&halves).map(whole).collect();
        let unstable = multipliers[1..].iter().filter(|value| value.norm_sqr() > 1.0).count();
        let tangent = rescaled(&solved.tangent(ahead), place.x.len(), chart.size / size);
        let point = CyclePoint { value: place.value, period, amplitude, state: rise, multipliers, unstable, symmetric };
        Ok(Self { place, tangent, chart: Chart { size, ..*chart }, halves, point })
    }

    /// Whether it is carried into itself as exactly as it should be.
    pub fn is_sound(&self) -> bool {
        (self.point.multipliers[0] - 1.0).norm() < TRIVIAL
    }

    /// The same cycle, from which the branch goes on the other way.
    pub fn turned(&self) -> Self {
        Self { tangent: times(-1.0, &self.tangent), ..self.clone() }
    }
}

/// A way, brought to length 1, whose first so many parts were measured by a size that is `factor` times the new one.
pub(super) fn rescaled(way: &[f64], states: usize, factor: f64) -> Vec<f64> {
    direction(&vector(way.len(), &|i| if i < states { factor * way[i] } else { way[i] }))
}
