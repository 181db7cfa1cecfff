//! The torsional gear as a textbook writes it, with the tire law from libm: what a user of another library would type.

use std::f64::consts::PI;

/// The defaults of the torsional gear, but for speed and damping.
#[derive(Clone, Copy)]
pub struct Gear {
    pub velocity: f64,
    pub damping: f64,
}

impl Gear {
    /// The rate of (ψ, ψ̇, y).
    #[inline(always)]
    pub fn rate(&self, [psi, rate, y]: [f64; 3]) -> [f64; 3] {
        const CASTER: f64 = 0.1;
        const HALF_CONTACT: f64 = 0.1;
        const RELAXATION: f64 = 0.3;
        const INERTIA: f64 = 1.0;
        const STIFFNESS: f64 = 100_000.0;
        const LOAD: f64 = 9_000.0;
        const SIDE: f64 = 20.0;
        const ALIGNING: f64 = 2.0;
        const SIDE_LIMIT: f64 = 5.0 * PI / 180.0;
        const ALIGNING_LIMIT: f64 = 10.0 * PI / 180.0;
        const TREAD: f64 = 270.0;

        let alpha = (y / RELAXATION).atan();
        let side_force = SIDE * LOAD * alpha.clamp(-SIDE_LIMIT, SIDE_LIMIT);
        let aligning_moment = if alpha.abs() <= ALIGNING_LIMIT {
            -ALIGNING * LOAD * (ALIGNING_LIMIT / PI) * (PI * alpha / ALIGNING_LIMIT).sin()
        } else {
            0.0
        };
        let torque =
            -STIFFNESS * psi - (self.damping + TREAD / self.velocity) * rate + aligning_moment - CASTER * side_force;
        [rate, torque / INERTIA, self.velocity * psi + (CASTER - HALF_CONTACT) * rate - self.velocity / RELAXATION * y]
    }
}
