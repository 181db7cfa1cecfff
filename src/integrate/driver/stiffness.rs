//! Telling when stability, not accuracy, holds the step down.

use super::{
    super::{
        method::{Method, Scheme},
        stages::Attempt,
    },
    Integrator,
};
use crate::model::System;

/// Explicit steps in a row that must look stiff before a run counts as such, and how often one looks.
const STIFF_IN_A_ROW: u32 = 15;
pub(super) const STIFF_INTERVAL: u64 = 25;

impl<S: System<N>, const N: usize> Integrator<S, N> {
    /// Hairer's test: the quotient of differences of the last two stages estimates the largest eigenvalue; a step that
    /// sits at the edge of the stability region again and again is held there by stiffness.
    #[inline(never)]
    pub(super) fn look_for_stiffness(&mut self, h: f64, attempt: &Attempt<N>, end_rate: &[f64; N]) {
        let (stage_rate, edge) = match self.scheme {
            Scheme::DormandPrince => (&self.k[5], 3.25),
            Scheme::Dop853 => (&self.k[11], 6.1),
            Scheme::RungeKutta4 | Scheme::Rodas => return,
        };
        let (mut rates, mut states) = (0.0, 0.0);
        for i in 0..N {
            rates += ((end_rate[i] - stage_rate[i]) / self.tolerance.absolute[i]).powi(2);
            states += ((attempt.end[i] - attempt.last_stage[i]) / self.tolerance.absolute[i]).powi(2);
        }
        if states > 0.0 && h * (rates / states).sqrt() > edge {
            self.stiff_looking += 1;
        } else {
            self.stiff_looking = 0;
        }
        if self.stiff_looking == STIFF_IN_A_ROW {
            self.stats.stiff = true;
            self.stiff_looking = 0;
            // From the next step on: the dense output of this one still reads its stages.
            self.going_stiff = self.method == Method::Auto;
        }
    }
}
