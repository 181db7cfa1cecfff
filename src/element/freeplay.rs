//! Freeplay of the torsion spring: a gap in which the spring does nothing.

use super::Side;
use crate::real::Real;

/// A torsion spring of stiffness k \[N m/rad\] with the freeplay ψ_fp \[rad\], half of its gap.
///
/// # Equations
/// The spring's torque is −k s(ψ), with s(ψ) = ψ − ψ_fp sign ψ outside of the gap and 0 inside. Without a gap the spring
/// acts everywhere, and there is no side to tell apart.
///
/// # References
/// E. Atabay 2012, ch. 6.
#[derive(Clone, Copy, Debug)]
pub struct Spring {
    freeplay: f64,
    /// By side: stiffness and offset of k s(ψ), which is a straight line on each.
    lines: [(f64, f64); 4],
}

impl Spring {
    /// A spring of stiffness k \[N m/rad\] with a gap of ± `freeplay` \[rad\].
    pub fn new(stiffness: f64, freeplay: f64) -> Self {
        let within = if freeplay > 0.0 { (0.0, 0.0) } else { (stiffness, 0.0) };
        let mut lines = [within; 4];
        lines[Side::Above as usize] = (stiffness, -stiffness * freeplay);
        lines[Side::Below as usize] = (stiffness, stiffness * freeplay);
        Self { freeplay, lines }
    }

    /// ψ_fp, 0 where there is no gap.
    #[inline(always)]
    pub fn freeplay(&self) -> f64 {
        self.freeplay
    }

    /// By side: stiffness and offset of k s(ψ).
    pub(crate) fn lines(&self) -> [(f64, f64); 4] {
        self.lines
    }

    /// k s(ψ) \[N m\].
    #[inline(always)]
    pub fn torque<R: Real>(&self, angle: R, side: u32) -> R {
        let (stiffness, offset) = self.lines[(side & 3) as usize];
        angle * stiffness + offset
    }

    /// s(ψ) \[rad\]: the angle that winds the spring.
    pub fn angle(&self, angle: f64) -> f64 {
        match Side::of(angle, 0.0, self.freeplay) {
            Side::Within if self.freeplay > 0.0 => 0.0,
            Side::Within => angle,
            Side::Above => angle - self.freeplay,
            Side::Below => angle + self.freeplay,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn torque_is_stiffness_times_the_spring_angle() {
        for freeplay in [0.0, 0.01] {
            let spring = Spring::new(1e5, freeplay);
            for psi in [-0.3, -0.01, -0.004, 0.0, 0.007, 0.01, 0.2] {
                let side = if freeplay > 0.0 { Side::of(psi, 0.0, freeplay) } else { Side::Within };
                assert!((spring.torque(psi, side as u32) - 1e5 * spring.angle(psi)).abs() < 1e-11, "{psi}");
            }
        }
    }
}
