//! The force that a damper would have shown along a record: the innermost loop of an identification.

use super::Record;
use crate::element::damper::{Coefficients, Damper, Hysteresis};

/// z this near to what it saturates at, in parts, stays there.
const SATURATED: f64 = 1e-9;
/// How far a displacement is from that of a straight line of velocity, in parts of the velocities' difference over a sample,
/// before the velocity is said to jump.
const JUMP: f64 = 0.05;
/// Most times that the mean slope of z over a sample is looked for.
const LOOKS: usize = 4;

/// Appends the force at every sample to `forces`, starting with z = 0 and w = 0.
///
/// # Method
/// Between two samples the velocity is a straight line, or jumps where the displacement says so. Side by side z follows the displacement by its closed form, cut
/// where the velocity changes its sign. In series s = x − w obeys ṡ = (c₁ẋ − αz(s) − k₀s)/(c₀ + c₁): as z(s) rises, this is
/// a decay towards a moving rest, which is followed exactly for the mean slope of z over the sample; the slope comes from
/// the closed form and is looked for until it belongs to the step. So nothing grows that should not, whatever the
/// coefficients and however long the interval; a sample in which ṡ changes its sign is cut there. The force is that of the
/// exact motion to some parts in a thousand where the element yields within a sample, and much nearer elsewhere.
///
/// For n other than 1 and 2, z moves in four exponential steps a sample.
#[inline(never)]
pub(super) fn replay(damper: &Damper, record: &Record, forces: &mut Vec<f64>) {
    let at = damper.coefficients(record.command);
    let element = Element::of(damper.hysteresis());
    let h = record.interval;
    let series = Series::of(&at);
    let (mut x0, mut v0) = (record.displacement[0], record.velocity[0]);
    let (mut z, mut s) = (0.0, x0);
    forces.push(damper.response(&at, x0, v0, z, x0 - s).force);
    for i in 1..record.len() {
        let (x, velocity) = (record.displacement[i], record.velocity[i]);
        let corner = corner(x - x0, v0, velocity, h);
        if damper.in_series() {
            (z, s) = match corner {
                Some(time) => {
                    let (z, s) = series.moved(&element, z, s, v0, v0, time);
                    series.moved(&element, z, s, velocity, velocity, h - time)
                }
                None => series.moved(&element, z, s, v0, velocity, h),
            };
        } else {
            z = match corner {
                Some(time) => element.carried(element.carried(z, v0 * time), velocity * (h - time)),
                None if v0 * velocity < 0.0 => {
                    let turn = 0.5 * v0 * h * v0 / (v0 - velocity);
                    element.carried(element.carried(z, turn), x - x0 - turn)
                }
                None => element.carried(z, x - x0),
            };
            s = x;
        }
        forces.push(damper.response(&at, x, velocity, z, x - s).force);
        (x0, v0) = (x, velocity);
    }
}

/// When the velocity jumps from v₀ to v within a sample of h seconds: where it changes its sign, and a straight line between
/// the two does not lead as far as the displacement goes.
#[inline]
fn corner(dx: f64, v0: f64, v: f64, h: f64) -> Option<f64> {
    let apart = (v0 - v).abs() * h;
    let jumps = v0 * v < 0.0 && (dx - 0.5 * (v0 + v) * h).abs() > JUMP * apart;
    jumps.then(|| ((dx - v * h) / (v0 - v)).clamp(0.0, h))
}

/// A Bouc–Wen element prepared for many short ways.
struct Element {
    exponent: f64,
    amplitude: f64,
    /// γ + β and β − γ.
    bends: [f64; 2],
    /// What z saturates at, above which it does not get.
    most: f64,
    /// On the branches away and back: rate per way and size, see [`Branch`](crate::element::damper::Branch).
    rates: [f64; 2],
    sizes: [f64; 2],
}

const AWAY: usize = 0;
const BACK: usize = 1;

impl Element {
    fn of(hysteresis: &Hysteresis) -> Self {
        let (exponent, amplitude) = (hysteresis.exponent(), hysteresis.amplitude());
        let bends = hysteresis.bends();
        let of_two = |form: fn(f64, f64) -> f64, bend: f64| form(amplitude, bend.abs());
        let (rates, sizes) = if exponent == 2.0 {
            (
                bends.map(|bend| of_two(|a, b| (a * b).sqrt(), bend)),
                bends.map(|bend| of_two(|a, b| (a / b).sqrt(), bend)),
            )
        } else {
            (bends, bends.map(|bend| amplitude / bend))
        };
        Self { exponent, amplitude, bends, most: hysteresis.saturation(), rates, sizes }
    }

    /// dz/ds at ζ, the way going upwards.
    #[inline(always)]
    fn slope(&self, zeta: f64) -> f64 {
        let bend = if zeta < 0.0 { self.bends[BACK] } else { self.bends[AWAY] };
        let power = if self.exponent == 2.0 {
            zeta * zeta
        } else if self.exponent == 1.0 {
            zeta.abs()
        } else {
            zeta.abs().powf(self.exponent)
        };
        self.amplitude - bend * power
    }

    /// ζ after the way `ds` ≥ 0 upwards.
    #[inline]
    fn along(&self, zeta: f64, ds: f64) -> f64 {
        if zeta >= self.most * (1.0 - SATURATED) {
            return zeta;
        }
        if self.exponent == 2.0 {
            self.along_squared(zeta, ds)
        } else if self.exponent == 1.0 {
            self.along_straight(zeta, ds)
        } else {
            self.along_powers(zeta, ds)
        }
    }

    fn along_squared(&self, zeta: f64, ds: f64) -> f64 {
        let away = |zeta: f64, ds: f64| {
            let (size, tanh) = (self.sizes[AWAY], tanh(self.rates[AWAY] * ds));
            (zeta + size * tanh) / (1.0 + zeta * tanh / size)
        };
        if zeta >= 0.0 {
            return away(zeta, ds);
        }
        let (a, size, rate, bend) = (-zeta, self.sizes[BACK], self.rates[BACK], self.bends[BACK]);
        // By the sums' rules of tanh and tan: the way to zero is needed only where zero is passed.
        let there = if bend == 0.0 {
            a - self.amplitude * ds
        } else if bend > 0.0 {
            let tanh = tanh(rate * ds);
            (a - size * tanh) / (1.0 - a * tanh / size)
        } else if rate * ds < 1.5 {
            let tan = (rate * ds).tan();
            (a - size * tan) / (1.0 + a * tan / size)
        } else {
            -1.0
        };
        if there >= 0.0 {
            return -there;
        }
        let part = a / size;
        let to_zero = if bend == 0.0 {
            a / self.amplitude
        } else if bend > 0.0 {
            0.5 * (2.0 * part / (1.0 - part)).ln_1p() / rate
        } else {
            part.atan() / rate
        };
        away(0.0, (ds - to_zero).max(0.0))
    }

    fn along_straight(&self, zeta: f64, ds: f64) -> f64 {
        let away = |zeta: f64, ds: f64| self.most + (zeta - self.most) * (-self.rates[AWAY] * ds).exp();
        if zeta >= 0.0 {
            return away(zeta, ds);
        }
        let (a, rate, size) = (-zeta, self.rates[BACK], self.sizes[BACK]);
        let there = if rate == 0.0 { a - self.amplitude * ds } else { size + (a - size) * (rate * ds).exp() };
        if there >= 0.0 {
            return -there;
        }
        let to_zero = if rate == 0.0 { a / self.amplitude } else { -(-a / size).ln_1p() / rate };
        away(0.0, (ds - to_zero).max(0.0))
    }

    fn along_powers(&self, mut zeta: f64, ds: f64) -> f64 {
        const STEPS: i32 = 4;
        let part = ds / f64::from(STEPS);
        for _ in 0..STEPS {
            let slope = self.slope(zeta);
            let bend = if zeta < 0.0 { self.bends[BACK] } else { self.bends[AWAY] };
            let decay = self.exponent * bend * zeta.abs().powf(self.exponent - 1.0) * zeta.signum() * part;
            let (phi, _, _) = decays(decay);
            zeta = (zeta + slope * part * phi).min(self.most).max(-self.most);
        }
        zeta
    }

    /// z after the displacement has gone on by `dx`.
    #[inline]
    fn carried(&self, z: f64, dx: f64) -> f64 {
        let heading = if dx < 0.0 { -1.0 } else { 1.0 };
        heading * self.along(z * heading, dx * heading)
    }
}

/// What moves s in a damper whose parts are in series.
struct Series {
    /// α, k₀ and c₁ over c₀ + c₁.
    gain: f64,
    stiffness: f64,
    drive: f64,
}

impl Series {
    fn of(at: &Coefficients) -> Self {
        let sum = at.viscous + at.series;
        Self { gain: at.hysteresis_gain / sum, stiffness: at.stiffness / sum, drive: at.series / sum }
    }

    /// z and s after h seconds in which the velocity goes from v₀ to v in a straight line.
    #[inline]
    fn moved(&self, element: &Element, z: f64, s: f64, v0: f64, v: f64, h: f64) -> (f64, f64) {
        let slip = self.drive * v0 - self.gain * z - self.stiffness * s;
        let rise = if v == v0 { 0.0 } else { self.drive * (v - v0) / h };
        let heading = if slip == 0.0 { rise.signum() } else { slip.signum() };
        let (zeta, ds, turn) = self.stretch(element, z * heading, slip * heading, rise * heading, h);
        let (z, s) = (zeta * heading, s + ds * heading);
        match turn {
            // From the turn on the other way. It may turn once more only where the velocity bends back, which it does not.
            Some(time) => {
                let (zeta, ds, _) = self.stretch(element, -zeta, 0.0, -rise * heading, h - time);
                (-zeta * heading, s - ds.max(0.0) * heading)
            }
            None => (z, s),
        }
    }

    /// ζ and the way after h seconds, or at the turn before that, and when that is.
    #[inline]
    fn stretch(&self, element: &Element, zeta: f64, slip: f64, rise: f64, h: f64) -> (f64, f64, Option<f64>) {
        let saturated = zeta >= element.most * (1.0 - SATURATED);
        let mut slope = if saturated { 0.0 } else { element.slope(zeta) };
        let mut h = h;
        let mut turn = None;
        let (mut end, mut ds) = (zeta, 0.0);
        for _ in 0..LOOKS {
            let decay = self.gain * slope + self.stiffness;
            let (phi1, phi2, rest) = decays(decay * h);
            if slip * rest + rise * h * phi1 < 0.0 {
                // It turns: ṡ = (slip − rise/decay) e^(−decay t) + rise/decay = 0.
                let ratio = slip / -rise;
                let time = if decay * ratio < 1e-6 { ratio } else { (decay * ratio).ln_1p() / decay };
                h = time.min(h);
                turn = Some(h);
                let (phi1, phi2, _) = decays(decay * h);
                ds = h * (slip * phi1 + rise * h * phi2);
            } else {
                ds = h * (slip * phi1 + rise * h * phi2);
            }
            if saturated || ds <= 0.0 {
                break;
            }
            end = element.along(zeta, ds);
            let mean = (end - zeta) / ds;
            let off = (mean - slope).abs() * self.gain * h;
            slope = mean;
            if off < 1e-3 {
                break;
            }
        }
        (end, ds.max(0.0), turn)
    }
}

/// (1 − e⁻ʸ)/y, (y − 1 + e⁻ʸ)/y² and e⁻ʸ.
#[inline(always)]
fn decays(y: f64) -> (f64, f64, f64) {
    if y.abs() < 0.02 {
        // The next terms of the series are below 1e-11.
        let phi2 = 0.5 - y * (1.0 / 6.0 - y * (1.0 / 24.0 - y * (1.0 / 120.0 - y / 720.0)));
        let phi1 = 1.0 - y * phi2;
        return (phi1, phi2, 1.0 - y * phi1);
    }
    let rest = (-y).exp();
    let phi1 = (1.0 - rest) / y;
    (phi1, (1.0 - phi1) / y, rest)
}

/// Of y ≥ 0, to rounding of 1.
#[inline(always)]
fn tanh(y: f64) -> f64 {
    1.0 - 2.0 / ((2.0 * y).exp() + 1.0)
}
