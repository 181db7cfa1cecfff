//! The Bouc–Wen element: a spring that yields, and remembers where.

use crate::real::Real;

/// A branch's length is never longer than this many of its own: beyond, z is what it saturates at, to rounding.
const FARTHEST: f64 = 20.0;

/// A Bouc–Wen element: the hysteresis variable z follows the displacement x of its ends.
///
/// # Equations
/// ż = −γ|ẋ| z|z|ⁿ⁻¹ − β ẋ |z|ⁿ + A ẋ. Time enters only through x: as long as neither ẋ nor z changes its sign,
/// dz/dx = A − (β + γ sign(ẋz)) |z|ⁿ, so there are four [branches](Hysteresis::branch), two and their mirror images, on
/// each of which z is a function of x. Towards large |z| it saturates at z_max = (A/(β + γ))^(1/n).
///
/// # Limits
/// With β > γ the branch towards zero has a rest of its own at |z| = (A/(β − γ))^(1/n) > z_max, and beyond it z runs away:
/// such an element must start within ± z_max, from where it never leaves.
///
/// # References
/// R. Bouc 1967; Y. K. Wen, *J. Engineering Mechanics Division* 102 (1976) 249–263; B. F. Spencer et al., *J. Engineering
/// Mechanics* 123 (1997) 230–238, eq. 4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hysteresis {
    gamma: f64,
    beta: f64,
    exponent: f64,
    amplitude: f64,
    away: Branch,
    back: Branch,
}

/// Which way |z| goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// ẋz > 0: away from zero, towards saturation.
    Away,
    /// ẋz < 0: back to zero, and through it.
    Back,
}

impl Hysteresis {
    /// With γ ≥ 0 and β in m⁻ⁿ, γ + β > 0, n ≥ 1, A > 0.
    pub fn new(gamma: f64, beta: f64, exponent: f64, amplitude: f64) -> Self {
        let away = Branch::new(amplitude, beta + gamma, exponent);
        let back = Branch::new(amplitude, beta - gamma, exponent);
        Self { gamma, beta, exponent, amplitude, away, back }
    }

    /// A: dz/dx of the element that has not yielded.
    pub fn amplitude(&self) -> f64 {
        self.amplitude
    }

    /// n.
    pub fn exponent(&self) -> f64 {
        self.exponent
    }

    /// γ + β and β − γ: what bends the branches away and back.
    pub fn bends(&self) -> [f64; 2] {
        [self.beta + self.gamma, self.beta - self.gamma]
    }

    /// z_max, at which z saturates.
    pub fn saturation(&self) -> f64 {
        (self.amplitude / (self.beta + self.gamma)).powf(1.0 / self.exponent)
    }

    /// From every z it comes back within ± z_max: |β| ≤ γ.
    pub fn comes_back(&self) -> bool {
        self.beta.abs() <= self.gamma
    }

    /// ż at the rate ẋ of the displacement.
    #[inline(always)]
    pub fn rate<R: Real>(&self, z: R, velocity: R) -> R {
        velocity * self.slope(z, velocity.value())
    }

    /// dz/dx where the displacement goes in the direction that `heading` has the sign of.
    #[inline(always)]
    pub fn slope<R: Real>(&self, z: R, heading: f64) -> R {
        let against = z.value() * heading < 0.0;
        -self.power(z) * (if against { self.beta - self.gamma } else { self.beta + self.gamma }) + self.amplitude
    }

    /// dz/dx on a branch, and going on smoothly beyond the end of it.
    #[inline(always)]
    pub fn slope_on<R: Real>(&self, course: Course, z: R) -> R {
        let bend = match course {
            Course::Away => self.beta + self.gamma,
            Course::Back => self.beta - self.gamma,
        };
        -self.power(z) * bend + self.amplitude
    }

    /// |z|ⁿ
    #[inline(always)]
    fn power<R: Real>(&self, z: R) -> R {
        if self.exponent == 2.0 {
            z * z
        } else if self.exponent == 1.0 {
            z.abs()
        } else {
            let size = z.value().abs();
            let below = size.powf(self.exponent - 1.0);
            z.abs().chain(size * below, self.exponent * below)
        }
    }

    /// A bound of |∂ż/∂z| per unit of |ẋ| within ± z_max: n A / z_max on the branch away, and less than that on the way back
    /// where |β| ≤ γ. A method with steps of a fixed size must keep step × this × |ẋ| below 2.
    pub fn stiffness(&self) -> f64 {
        let steepest = (self.beta + self.gamma).max((self.beta - self.gamma).abs());
        self.exponent * steepest * self.saturation().powf(self.exponent - 1.0)
    }

    /// z can be had as a function of x in closed form: n = 1 or 2.
    pub fn is_closed(&self) -> bool {
        self.exponent == 1.0 || self.exponent == 2.0
    }

    /// |z| as a function of x on a branch; of use where [`Hysteresis::is_closed`].
    #[inline(always)]
    pub fn branch(&self, course: Course) -> &Branch {
        match course {
            Course::Away => &self.away,
            Course::Back => &self.back,
        }
    }

    /// z after the displacement has gone on by `dx` without turning; n = 1 or 2.
    pub fn moved(&self, z: f64, dx: f64) -> f64 {
        let way = dx.abs();
        let size = z.abs();
        if z * dx >= 0.0 {
            return self.away.along(size, way).copysign(dx);
        }
        // On the way back the branch is travelled towards its start.
        let to_zero = self.back.length(size);
        if way < to_zero {
            self.back.at(to_zero - way, self.back.is_beyond(size)).copysign(z)
        } else {
            self.away.at(way - to_zero, false).copysign(dx)
        }
    }
}

/// |z| as a function of the way: da/ds = A − B aⁿ, a(0) = 0, and its inverse; for n = 1 and 2.
///
/// Where B > 0, a saturates. From above it comes down to the same value on the second part of the branch, *beyond*, which
/// has lengths of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    form: Form,
    /// Per unit of way: B for n = 1, √|AB| for n = 2, A where B = 0.
    rate: f64,
    /// |A/B|^(1/n), with the sign of B for n = 1; 1 where B = 0.
    size: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// B = 0.
    Line,
    /// n = 1.
    Exponential,
    /// n = 2, B > 0.
    Tanh,
    /// n = 2, B < 0.
    Tan,
}

impl Branch {
    fn new(amplitude: f64, bend: f64, exponent: f64) -> Self {
        let (form, rate, size) = if bend == 0.0 {
            (Form::Line, amplitude, 1.0)
        } else if exponent == 1.0 {
            (Form::Exponential, bend, amplitude / bend)
        } else {
            let form = if bend > 0.0 { Form::Tanh } else { Form::Tan };
            (form, (amplitude * bend.abs()).sqrt(), (amplitude / bend.abs()).sqrt())
        };
        Self { form, rate, size }
    }

    /// `a` lies above what the branch saturates at.
    #[inline(always)]
    pub fn is_beyond(&self, a: f64) -> bool {
        match self.form {
            Form::Line | Form::Tan => false,
            Form::Exponential => self.rate > 0.0 && a > self.size,
            Form::Tanh => a > self.size,
        }
    }

    /// Along the branch from a = 0 (beyond: from infinity for n = 2, from twice the saturation for n = 1) to `a` ≥ 0.
    /// Where a is what the branch saturates at, to rounding, a length at which [`Branch::at`] gives that.
    pub fn length(&self, a: f64) -> f64 {
        let part = a / self.size;
        let lengths = match self.form {
            Form::Line => return a / self.rate,
            Form::Tan => return part.atan() / self.rate,
            Form::Exponential if self.is_beyond(a) => -(part - 1.0).ln(),
            Form::Exponential => -(-part).ln_1p(),
            Form::Tanh if part > 1.0 => 0.5 * (2.0 / (part - 1.0)).ln_1p(),
            Form::Tanh => 0.5 * (2.0 * part / (1.0 - part)).ln_1p(),
        };
        let farthest = if self.form == Form::Tanh { FARTHEST } else { 2.0 * FARTHEST };
        lengths.min(farthest) / self.rate
    }

    /// a at this length, on the part beyond saturation or on the one before.
    #[inline(always)]
    pub fn at<R: Real>(&self, length: R, beyond: bool) -> R {
        let s = length.value() * self.rate;
        let (part, slope) = match self.form {
            Form::Line => (s, 1.0),
            Form::Exponential => {
                let rest = (-s).exp_m1();
                if beyond { (2.0 + rest, -1.0 - rest) } else { (-rest, 1.0 + rest) }
            }
            Form::Tanh => {
                let tanh = s.tanh();
                let part = if beyond { 1.0 / tanh } else { tanh };
                (part, 1.0 - part * part)
            }
            Form::Tan => {
                let tan = s.tan();
                (tan, 1.0 + tan * tan)
            }
        };
        length.chain(part * self.size, slope * self.rate * self.size)
    }

    /// a after so much more way from `a` on.
    fn along(&self, a: f64, way: f64) -> f64 {
        self.at(self.length(a) + way, self.is_beyond(a))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::real::Dual;

    /// n, γ, β: saturating on both branches, on one, straight back, and turned round.
    const KINDS: [(f64, f64, f64); 8] = [
        (2.0, 3.63e6, 3.63e6),
        (2.0, 136_320.0, 2_059_020.0),
        (2.0, 3e6, 1e6),
        (2.0, 3e6, -1e6),
        (1.0, 400.0, 400.0),
        (1.0, 300.0, 500.0),
        (1.0, 500.0, 300.0),
        (1.0, 500.0, -300.0),
    ];

    #[test]
    fn the_closed_form_has_the_slope_of_the_equation() {
        for (n, gamma, beta) in KINDS {
            let element = Hysteresis::new(gamma, beta, n, 100.0);
            let most = element.saturation();
            for part in [-1.0, -0.9, -0.3, 0.0, 0.4, 0.99, 1.0, 1.2] {
                let z = part * most;
                for heading in [1.0, -1.0] {
                    // Differences of second order, on one side of a turn.
                    let h = heading * 1e-6 * most / 100.0;
                    let [z1, z2] = [h, 2.0 * h].map(|dx| element.moved(z, dx));
                    let slope = (4.0 * z1 - 3.0 * z - z2) / (2.0 * h);
                    let expected: f64 = element.slope(z + 1e-12 * heading * most, heading);
                    assert!((slope - expected).abs() < 1e-5 * 100.0, "{n} {gamma} {beta} {part}: {slope} {expected}");
                    assert!((element.rate(z, 3.0 * heading) - 3.0 * heading * element.slope(z, heading)).abs() < 1e-9);
                }
            }
        }
    }

    #[test]
    fn two_ways_in_one_direction_are_one() {
        for (n, gamma, beta) in KINDS {
            let element = Hysteresis::new(gamma, beta, n, 100.0);
            let most = element.saturation();
            for part in [-1.0, -0.7, 0.0, 0.5] {
                for (first, second) in [(1e-5, 3e-5), (0.4e-4, 1e-4), (-2e-5, -3e-4), (1e-3, 1e-2)] {
                    let z = part * most;
                    let twice = element.moved(element.moved(z, first), second);
                    let once = element.moved(z, first + second);
                    assert!((twice - once).abs() < 1e-13 * most, "{n} {part}: {twice} {once}");
                }
            }
        }
    }

    #[test]
    fn saturated_is_z_max_to_rounding_and_comes_back_from_there() {
        for (n, gamma, beta) in KINDS {
            let element = Hysteresis::new(gamma, beta, n, 100.0);
            let most = element.saturation();
            let far = element.moved(0.0, 1.0);
            assert!((far - most).abs() < 4.0 * f64::EPSILON * most, "{n}: {far} {most}");
            assert!(element.branch(Course::Away).length(far).is_finite());
            assert!((element.moved(far, 1.0) - most).abs() < 4.0 * f64::EPSILON * most);
            assert!((element.moved(far, -1.0) + most).abs() < 4.0 * f64::EPSILON * most);
        }
    }

    #[test]
    fn lengths_and_their_inverse_belong_together() {
        for (n, gamma, beta) in KINDS {
            let element = Hysteresis::new(gamma, beta, n, 100.0);
            for course in [Course::Away, Course::Back] {
                let branch = element.branch(course);
                for part in [0.0, 1e-9, 0.2, 0.8, 0.999, 1.5] {
                    let a = part * element.saturation();
                    let there = branch.at(branch.length(a), branch.is_beyond(a));
                    assert!((there - a).abs() < 1e-12 * element.saturation(), "{n} {course:?} {part}");
                    let dual = branch.at(Dual::<1>::variable(branch.length(a), 0), branch.is_beyond(a));
                    let heading = if course == Course::Away { 1.0 } else { -1.0 };
                    let slope: f64 = element.slope(a, heading);
                    assert!((dual.slope[0] - slope).abs() < 1e-8, "{n} {course:?} {part}: {} {slope}", dual.slope[0]);
                }
            }
        }
    }

    #[test]
    fn any_exponent_has_its_rate() {
        let element = Hysteresis::new(647.46, 647.46, 10.0, 2679.0);
        assert!((element.saturation() - 1.0754).abs() < 5e-5);
        let z = Dual::<1>::variable(0.9, 0);
        let difference = (element.slope(0.9 + 1e-6, 1.0) - element.slope(0.9 - 1e-6, 1.0)) / 2e-6;
        assert!((element.slope(z, 1.0).slope[0] - difference).abs() < 1e-5 * difference.abs());
        assert!(element.stiffness() >= difference.abs());
        assert_eq!(element.slope(0.0, 1.0), 2679.0);
    }
}
