//! Describing functions: limit cycles predicted from the first harmonic alone.

use std::{
    cell::Cell,
    f64::consts::{FRAC_2_PI, FRAC_PI_2, PI, TAU},
};

use nalgebra::Complex;

use super::Guess;
use crate::{
    energy::GAUSS,
    error::{Code, Error, Result},
    integrate::bracketed,
    run::Run,
    stability::TorsionalTheory,
};

/// Amplitudes of α among which cycles are searched for, with friction of ψ \[rad\], and how many places are looked at, equally
/// spaced in their logarithm.
const AMPLITUDES: (f64, f64) = (1e-6, FRAC_PI_2);
const PLACES: u32 = 600;
/// The same with friction, where each place is a search by itself.
const PLACES_WITH_FRICTION: u32 = 240;
/// Halvings of the way between two places: to rounding.
const HALVINGS: u32 = 60;
/// Logarithms of the ω among which the one of a swing with friction is searched for \[1/s\].
const TURNING: (f64, f64) = (-7.0, 16.0);
/// And first this near to the one of the amplitude before.
const NEAR: f64 = 0.05;
/// Terms of a Bessel function's series, whose argument is at most π: to rounding.
const TERMS: u32 = 13;
/// By how much both amplitudes are changed to see which way the gear's verdict goes.
const ASIDE: f64 = 1e-5;

/// A limit cycle as its first harmonic predicts it.
///
/// # Equations
/// A nonlinear law that a sinusoid of amplitude A goes through answers, to first harmonic, like a straight one whose slope
/// depends on A. The gear is then linear, and a sinusoid lasts where a₂a₁ = a₀, with ω² = a₁:
///
/// ```text
/// F_y   c_Fα                                   A ≤ δ      c_Fα (2/π)(asin r + r√(1 − r²)),  r = δ/A,  beyond
/// M_z   c_Mα (α_g/π)(4/(πA)) ∫₀^θ sin(πA sin t/α_g) sin t dt,   θ = π/2 for A ≤ α_g, asin(α_g/A) beyond
/// s(ψ)  1 − (2/π)(asin s + s√(1 − s²)),  s = ψ_fp/A_ψ,   A_ψ > ψ_fp;   0 within the gap
/// ψ̇     a damping constant 4M_f/(πωA_ψ) for M_f sign ψ̇
/// y = σA,   |ψ|/|y| = |iω + v/σ|/|v + iω(e − a)|
/// ```
///
/// (For A ≤ α_g the integral is (π/2) J₁(πA/α_g).) With a gap both amplitudes are solved for together, with friction also the
/// frequency. Friction holds the smallest swings: where the gear is unstable without it there is an unstable cycle, below which
/// they fade. A swing that sticks on its way is none of a sinusoid's.
///
/// # Limits
/// Higher harmonics are left out: within some per cent of the cycle where the tire saturates. It is asked for A up to π/2.
///
/// # References
/// G. Somieski, *Aerospace Science and Technology* 8 (1997) 545–555.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Predicted {
    /// Amplitudes of its sinusoids.
    pub amplitude: Amplitudes,
    /// ω/2π \[Hz\].
    pub frequency: f64,
    /// a₂a₁ − a₀ grows with the amplitude: a larger swing fades, a smaller one grows.
    pub stable: bool,
}

/// Amplitudes of a predicted cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amplitudes {
    /// ψ \[rad\].
    pub torsion_angle: f64,
    /// y \[m\].
    pub lateral_deformation: f64,
    /// α \[rad\].
    pub slip_angle: f64,
}

/// A gear as its describing functions see it.
struct Gear<'a> {
    run: &'a Run,
    theory: fn(&[f64]) -> Option<TorsionalTheory<f64>>,
    /// Places of k, c_Fα, c_Mα and c in the table.
    places: [usize; 4],
    side_force_limit: f64,
    aligning_limit: f64,
    freeplay: f64,
    friction: f64,
    velocity: f64,
    lever: f64,
    relaxation_length: f64,
    moment_of_inertia: f64,
    /// ln ω of the last swing with friction that was looked at.
    last: Cell<f64>,
}

/// What a swing of an amplitude of α would need to last.
struct Balance {
    /// Positive where the swing fades for want of it.
    excess: f64,
    /// A.
    slip: f64,
    /// A_ψ.
    torsion: f64,
    /// ω.
    turning: f64,
}

impl Predicted {
    /// Where shooting may look for it: where the wheel turns back, in the gear of a run.
    ///
    /// # Errors
    /// A model without describing functions.
    pub(super) fn guess(&self, run: &Run) -> Result<Guess> {
        let Gear { velocity: v, relaxation_length: sigma, lever, .. } = Gear::of(run)?;
        let turning = TAU * self.frequency;
        // y/ψ = (v + iω(e − a))/(iω + v/σ).
        let ratio = Complex::new(v, turning * lever) / Complex::new(v / sigma, turning);
        let psi = self.amplitude.torsion_angle;
        Ok(Guess { period: 1.0 / self.frequency, state: vec![psi, 0.0, (ratio * psi).re] })
    }
}

impl Run {
    /// The limit cycles that describing functions predict, by rising amplitude: stable and unstable ones.
    ///
    /// # Errors
    /// A model without a closed linear theory; parameters so extreme that numbers are left; a gap in a gear without any
    /// damping, of whose swing the equations do not say which of its stiffnesses it needs.
    pub fn describing_function(&self) -> Result<Vec<Predicted>> {
        let gear = Gear::of(self)?;
        let places = if gear.friction > 0.0 { PLACES_WITH_FRICTION } else { PLACES };
        let place = |i: u32| {
            let (least, most) = AMPLITUDES;
            // Not powf, which the module has no other use for.
            least * ((most / least).ln() * f64::from(i) / f64::from(places)).exp()
        };
        let mut cycles = Vec::new();
        let mut before: [Option<(f64, f64)>; 2] = [None, None];
        for i in 0..=places {
            let now = gear.excess(place(i))?.map(|excess| (place(i), excess));
            if let (Some(start), Some(end)) = (before[1], now) {
                if start.1 * end.1 <= 0.0 && start.1 != end.1 {
                    cycles.extend(gear.cycle(start, end)?);
                } else if let Some(earlier) = before[0]
                    && start.1.abs() < earlier.1.abs().min(end.1.abs())
                    && earlier.1 * end.1 > 0.0
                {
                    // It comes near zero between them: there may be two.
                    let nearest = gear.nearest(earlier, end)?;
                    if nearest.1 * end.1 < 0.0 {
                        cycles.extend(gear.cycle(earlier, nearest)?);
                        cycles.extend(gear.cycle(nearest, end)?);
                    }
                }
            }
            before = [before[1], now];
        }
        Ok(cycles)
    }
}

impl<'a> Gear<'a> {
    fn of(run: &'a Run) -> Result<Self> {
        let value = |name: &str, without: f64| place(run, name).map_or(without, |place| run.parameters()[place]);
        let [Some(k), Some(force), Some(moment), Some(damping)] =
            ["torsionalStiffness", "sideForceDerivative", "aligningMomentDerivative", "dampingConstant"]
                .map(|name| place(run, name))
        else {
            return Err(without(run));
        };
        let gear = Self {
            run,
            theory: run.description().number_theory,
            places: [k, force, moment, damping],
            side_force_limit: value("sideForceLimitAngle", f64::INFINITY),
            aligning_limit: value("aligningMomentLimitAngle", f64::INFINITY),
            freeplay: value("freeplayAngle", 0.0),
            friction: value("friction.moment", 0.0),
            velocity: value("velocity", 0.0),
            lever: value("casterLength", 0.0) - value("halfContactLength", 0.0),
            relaxation_length: value("relaxationLength", 0.0),
            moment_of_inertia: value("momentOfInertia", 0.0),
            last: Cell::new(0.0),
        };
        let damped = value("dampingConstant", 0.0) + value("treadWidthMomentConstant", 0.0) > 0.0;
        if gear.freeplay > 0.0 && !damped && gear.friction == 0.0 {
            let allowed = "> 0 N m s/rad where there is freeplay and no tread width";
            return Err(Error::new(Code::Unsuited, "dampingConstant", "0", allowed));
        }
        Ok(gear)
    }

    /// a₂a₁ − a₀ and ω² of the quasi-linear gear, where α has the amplitude `slip`, the spring `part` of its stiffness, and
    /// friction works like a damping constant `rubbing`; in units that do not depend on them.
    fn linear(&self, slip: f64, part: f64, rubbing: f64) -> Result<(f64, f64)> {
        let mut values = self.run.parameters().to_vec();
        let gains = [part, saturation(slip, self.side_force_limit), aligning(slip, self.aligning_limit)];
        for (place, gain) in self.places.into_iter().zip(gains) {
            values[place] *= gain;
        }
        values[self.places[3]] += rubbing;
        let theory = (self.theory)(&values).ok_or_else(|| without(self.run))?;
        // What is left of the spring acts everywhere.
        let theory = TorsionalTheory { freeplay_angle: 0.0, ..theory };
        let calms = theory.calms();
        let square = theory.swings() / (self.relaxation_length * self.moment_of_inertia);
        Error::unless_finite("the describing functions", &[calms, square])?;
        Ok((calms, square))
    }

    /// A_ψ where α has the amplitude `slip` and swings with ω.
    fn torsion(&self, slip: f64, turning: f64) -> f64 {
        let (v, sigma) = (self.velocity, self.relaxation_length);
        sigma * slip * turning.hypot(v / sigma) / v.hypot(turning * self.lever)
    }

    /// The damping constant that friction is worth where ψ has the amplitude `torsion` and swings with ω.
    fn rubbing(&self, torsion: f64, turning: f64) -> f64 {
        4.0 * self.friction / (PI * turning * torsion)
    }

    /// Of a swing with the amplitude `torsion` of ψ where there is friction: that says what the spring is worth, and its
    /// frequency, which grows with what friction is worth, which falls with it, can be found.
    fn balance_with_friction(&self, torsion: f64) -> Result<Option<Balance>> {
        let part = gap(torsion, self.freeplay);
        let at = |turning: f64| {
            let slip = torsion / self.torsion(1.0, turning);
            Ok::<_, Error>((slip, self.linear(slip, part, self.rubbing(torsion, turning))?))
        };
        let faster = |log: f64| at(log.exp()).map_or(f64::NAN, |(_, (_, square))| square - (2.0 * log).exp());
        let (low, high) = (self.last.get() - NEAR, self.last.get() + NEAR);
        let (low, high) = if faster(low) > 0.0 && faster(high) < 0.0 { (low, high) } else { TURNING };
        let log = bracketed(low, high, &faster);
        self.last.set(log);
        let turning = log.exp();
        let (slip, (excess, _)) = at(turning)?;
        Ok((slip < FRAC_PI_2 && excess.is_finite()).then_some(Balance { excess, slip, torsion, turning }))
    }

    /// Of a swing with this amplitude, of α or, with friction, of ψ; none where it could not turn back.
    fn balance(&self, amplitude: f64) -> Result<Option<Balance>> {
        if self.friction > 0.0 {
            return self.balance_with_friction(amplitude);
        }
        let slip = amplitude;
        let (with, fast) = self.linear(slip, 1.0, 0.0)?;
        let (excess, square) = if self.freeplay > 0.0 {
            // Both are straight in the spring's part: it is known which one the swing needs.
            let (without, slow) = self.linear(slip, 0.0, 0.0)?;
            let part = -without / (with - without);
            let square = slow + part * (fast - slow);
            let there = gap(self.torsion(slip, square.max(0.0).sqrt()), self.freeplay);
            (there - part, square)
        } else {
            (with, fast)
        };
        let turning = square.sqrt();
        let torsion = self.torsion(slip, turning);
        Ok((square > 0.0 && excess.is_finite() && torsion.is_finite()).then_some(Balance {
            excess,
            slip,
            torsion,
            turning,
        }))
    }

    fn excess(&self, amplitude: f64) -> Result<Option<f64>> {
        Ok(self.balance(amplitude)?.map(|balance| balance.excess))
    }

    /// The place between two where the excess is nearest to zero, by thirds.
    fn nearest(&self, mut low: (f64, f64), mut high: (f64, f64)) -> Result<(f64, f64)> {
        let sign = low.1.signum();
        for _ in 0..HALVINGS {
            let third = (high.0 - low.0) / 3.0;
            let inner = [low.0 + third, high.0 - third];
            let [Some(a), Some(b)] = [self.excess(inner[0])?, self.excess(inner[1])?] else { break };
            for (place, excess) in inner.into_iter().zip([a, b]) {
                if sign * excess < 0.0 {
                    return Ok((place, excess));
                }
            }
            if sign * a < sign * b { high = (inner[1], b) } else { low = (inner[0], a) }
        }
        Ok(low)
    }

    /// The cycle between two amplitudes at which the excess has different signs.
    fn cycle(&self, start: (f64, f64), end: (f64, f64)) -> Result<Option<Predicted>> {
        let (mut low, mut high) = (start.0, end.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let Some(excess) = self.excess(middle)? else { return Ok(None) };
            *(if excess * start.1 > 0.0 { &mut low } else { &mut high }) = middle;
        }
        let Some(balance) = self.balance(0.5 * (low + high))? else { return Ok(None) };
        let Balance { slip, torsion, turning, .. } = balance;
        // Both amplitudes change together, as the swing's shape has them.
        let calms = |factor: f64| {
            let torsion = factor * torsion;
            self.linear(factor * slip, gap(torsion, self.freeplay), self.rubbing(torsion, turning))
        };
        let amplitude =
            Amplitudes { torsion_angle: torsion, lateral_deformation: self.relaxation_length * slip, slip_angle: slip };
        Ok(Some(Predicted {
            amplitude,
            frequency: turning / TAU,
            stable: calms(1.0 + ASIDE)?.0 > calms(1.0 - ASIDE)?.0,
        }))
    }
}

/// Where the table has a parameter, if it does: a law without a limit never comes to it.
#[inline(never)]
fn place(run: &Run, name: &str) -> Option<usize> {
    run.description().table.iter().position(|parameter| parameter.name == name)
}

fn without(run: &Run) -> Error {
    Error::without(run.description().name, "describing functions")
}

/// The part of its slope that a law keeps which does not grow beyond ± `limit`.
fn saturation(amplitude: f64, limit: f64) -> f64 {
    let r = (limit / amplitude).min(1.0);
    FRAC_2_PI * (r.asin() + r * (1.0 - r * r).sqrt())
}

/// The part of its stiffness that a spring keeps in a gap of ± `freeplay`.
fn gap(amplitude: f64, freeplay: f64) -> f64 {
    if freeplay > 0.0 { 1.0 - saturation(amplitude, freeplay) } else { 1.0 }
}

/// The part of its slope that the aligning moment (limit/π) sin(π α/limit) keeps, which is 0 beyond ± `limit`.
fn aligning(amplitude: f64, limit: f64) -> f64 {
    let wave = PI * amplitude / limit;
    if wave == 0.0 {
        return 1.0;
    }
    if amplitude <= limit {
        // 2 J₁(w)/w by its series: w ≤ π.
        let mut term = 1.0;
        return (1..=TERMS).fold(0.0, |sum, k| {
            let added = sum + term;
            term *= -0.25 * wave * wave / f64::from(k * (k + 1));
            added
        });
    }
    let panels = 8;
    let width = (limit / amplitude).asin() / f64::from(panels);
    let integral = (0..panels).fold(0.0, |sum, panel| {
        GAUSS.iter().fold(sum, |sum, (place, weight)| {
            let sine = ((f64::from(panel) + place) * width).sin();
            sum + weight * width * (wave * sine).sin() * sine
        })
    });
    4.0 / (PI * wave) * integral
}

#[cfg(test)]
mod tests {
    use super::*;

    /// J₁ by Bessel's integral (1/π)∫₀^π cos(θ − x sin θ) dθ: the midpoint rule, which of a whole period leaves nothing open.
    fn bessel(x: f64) -> f64 {
        let n = 200;
        let theta = |i: u32| (f64::from(i) + 0.5) / f64::from(n) * TAU;
        (0..n).fold(0.0, |sum, i| sum + (theta(i) - x * theta(i).sin()).cos()) / f64::from(n)
    }

    #[test]
    fn aligning_moment_is_a_bessel_function_up_to_its_limit() {
        assert!((bessel(2.0) - 0.576_724_807_756_873_4).abs() < 1e-15, "Abramowitz and Stegun, table 9.1");
        for part in [0.01, 0.3, 0.7, 1.0] {
            let expected = 2.0 / (PI * part) * bessel(PI * part);
            assert!((aligning(0.2 * part, 0.2) - expected).abs() < 1e-13, "{part}");
        }
        assert_eq!([aligning(0.3, f64::INFINITY), aligning(2e-10, 0.2)], [1.0; 2]);
    }

    /// The first harmonic of each law, by the midpoint rule over a period.
    #[test]
    fn gains_are_first_harmonics() {
        let n = 2_000_000;
        let harmonic = |amplitude: f64, law: &dyn Fn(f64) -> f64| {
            let sum = (0..n).fold(0.0, |sum, i| {
                let sine = ((f64::from(i) + 0.5) / f64::from(n) * FRAC_PI_2).sin();
                sum + law(amplitude * sine) * sine
            });
            2.0 / (f64::from(n) * amplitude) * sum
        };
        let limit = 0.17_f64;
        for amplitude in [0.1, 0.16, 0.171, 0.3, 1.5] {
            let moment = |x: f64| if x <= limit { limit / PI * (PI * x / limit).sin() } else { 0.0 };
            assert!((aligning(amplitude, limit) - harmonic(amplitude, &moment)).abs() < 1e-6, "{amplitude}");
            assert!(
                (saturation(amplitude, limit) - harmonic(amplitude, &|x| x.min(limit))).abs() < 1e-6,
                "{amplitude}"
            );
            let spring = |x: f64| (x - limit).max(0.0);
            assert!((gap(amplitude, limit) - harmonic(amplitude, &spring)).abs() < 1e-6, "{amplitude}");
        }
    }
}
