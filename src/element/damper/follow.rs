//! A damper whose piston is moved: its state, as exactly as numbers allow.

use super::{Branch, Coefficients, Course, Damper, Excitation};
use crate::{
    error::{Code, Error, Result, shown},
    integrate::{
        bracketed,
        dormand_prince::{A, B, C, E},
    },
};

/// Local error allowed of a step, in parts of the displacement over which the element yields, and of z_max.
const TOLERANCE: f64 = 1e-10;
/// Most steps of a motion.
const MOST_STEPS: u64 = 1_000_000;

/// A damper on its way along a motion of its piston.
///
/// # Method
/// The displacement s of the hysteresis element's ends is x where the parts sit side by side, and x − w in series, with
/// ṡ = (c₁ẋ − αz − k₀s)/(c₀ + c₁). The motion is cut where ṡ or z changes its sign. On a piece z is a function of s alone:
/// for n = 1 and 2 the closed form of its branch. Then side by side nothing is left to integrate, and the result is exact
/// to rounding; in series one equation is left, without the stiffness of z. It is Dormand and Prince's, with a local error
/// of 10⁻¹⁰ of the displacement over which the element yields. For other n z is integrated beside s; that is stiff where
/// strokes are long, and a motion that would take more than a million steps is refused.
pub(super) struct Follower<'a> {
    damper: &'a Damper,
    at: Coefficients,
    motion: &'a Excitation,
    t: f64,
    s: f64,
    z: f64,
    step: f64,
    steps: u64,
    /// Between two corners of the motion.
    smooth: [f64; 2],
    piece: Piece,
}

/// Where neither ṡ nor z changes its sign.
#[derive(Clone, Copy)]
struct Piece {
    /// Sign of ṡ.
    heading: f64,
    course: Course,
    /// Of a closed form: s and the branch's length where the piece begins.
    start: (f64, f64),
}

impl<'a> Follower<'a> {
    /// With z = 0 and w = 0 at t = 0.
    pub fn new(damper: &'a Damper, command: f64, motion: &'a Excitation) -> Self {
        let step = 0.01 * motion.part_of_a_stroke();
        let piece = Piece { heading: 1.0, course: Course::Away, start: (0.0, 0.0) };
        let smooth = [0.0, motion.next_corner(0.0)];
        let at = damper.coefficients(command);
        let mut follower = Self { damper, at, motion, t: 0.0, s: 0.0, z: 0.0, step, steps: 0, smooth, piece };
        let slip = follower.slip(0.0, 0.0, 0.0);
        follower.enter(if slip < 0.0 { -1.0 } else { 1.0 });
        follower
    }

    /// Displacement, velocity, force, z and w at the time it has come to.
    pub fn row(&self) -> [f64; 5] {
        let (x, velocity) = self.moved(self.t);
        let w = if self.damper.in_series() { x - self.s } else { 0.0 };
        let response = self.damper.response(&self.at, x, velocity, self.z, w);
        [x, velocity, response.force, self.z, w]
    }

    /// Goes on to the time `end`.
    ///
    /// # Errors
    /// Too many steps; values so extreme that the state leaves the numbers.
    pub fn advance(&mut self, end: f64) -> Result<()> {
        while self.t < end {
            let limit = end.min(self.smooth[1]);
            let longest = (limit - self.t).min(self.motion.part_of_a_stroke());
            let wanted = if self.exact() { longest } else { self.step.min(longest) };
            let mut h = wanted;
            let (mut reached, error) = self.tried(h);
            self.steps += 1;
            if self.steps > MOST_STEPS {
                return Err(Error::new(Code::StepLimit, "steps", shown(self.t), MOST_STEPS.to_string()));
            }
            let smallest = 1e-14 * self.motion.part_of_a_stroke();
            if error.is_nan() && h <= smallest {
                return Err(Error::beyond_numbers("the damper's state"));
            }
            if (error.is_nan() || error > 1.0) && h > smallest {
                self.step = h * if error.is_nan() { 0.2 } else { (0.9 * error.powf(-0.2)).clamp(0.2, 0.9) };
                continue;
            }
            // What changes its sign within the step ends the piece there.
            let mut turned = None;
            for event in [Event::Turn, Event::Zero] {
                if self.margin(event, self.t + h, reached) < 0.0 {
                    let margin = |part: f64| self.margin(event, self.t + part, self.tried(part).0);
                    // What is there already takes the smallest step that counts.
                    h = bracketed(0.0, h, &margin).max(10.0 * smallest).min(h);
                    reached = self.tried(h).0;
                    turned = Some(event);
                }
            }
            let full = h == wanted;
            self.arrive(h, reached, limit);
            if full && !self.exact() {
                self.step = h.max(self.step.min(wanted)) * (0.9 * error.max(1e-10).powf(-0.2)).clamp(0.2, 4.0);
            }
            match turned {
                Some(Event::Turn) => self.enter(-self.piece.heading),
                Some(Event::Zero) => {
                    self.z = 0.0;
                    self.enter(self.piece.heading);
                }
                None if self.t >= self.smooth[1] => self.turn_the_corner(),
                None => {}
            }
        }
        Ok(())
    }

    fn arrive(&mut self, h: f64, reached: [f64; 2], limit: f64) {
        self.t = if self.t + h >= limit * (1.0 - 1e-15) { limit } else { self.t + h };
        self.s = reached[0];
        self.z = self.hysteresis(reached);
        if !self.damper.in_series() {
            self.s = self.moved(self.t).0;
        }
    }

    fn turn_the_corner(&mut self) {
        self.smooth = [self.smooth[1], self.motion.next_corner(self.smooth[1])];
        let slip = self.slip(self.t, self.s, self.z);
        self.enter(if slip < 0.0 { -1.0 } else { 1.0 });
    }

    /// Begins the piece in this direction.
    fn enter(&mut self, heading: f64) {
        let course = if self.z * heading >= 0.0 { Course::Away } else { Course::Back };
        let length = if self.is_closed() { self.branch(course).length(self.z.abs()) } else { 0.0 };
        self.piece = Piece { heading, course, start: (self.s, length) };
    }

    fn branch(&self, course: Course) -> &Branch {
        self.damper.hysteresis().branch(course)
    }

    fn is_closed(&self) -> bool {
        self.damper.hysteresis().is_closed()
    }

    /// Nothing is left to integrate.
    fn exact(&self) -> bool {
        self.is_closed() && !self.damper.in_series()
    }

    /// The piston's displacement and velocity, at a corner of its motion those on this side of it.
    fn moved(&self, t: f64) -> (f64, f64) {
        let [from, to] = self.smooth;
        let margin = 1e-12 * self.motion.part_of_a_stroke();
        let inside = if from > 0.0 { t.max(from + margin) } else { t };
        self.motion.at(inside.min(to - margin))
    }

    /// ṡ
    fn slip(&self, t: f64, s: f64, z: f64) -> f64 {
        let (x, velocity) = self.moved(t);
        self.damper.response(&self.at, x, velocity, z, x - s).slip
    }

    /// z on this piece.
    fn hysteresis(&self, [s, z]: [f64; 2]) -> f64 {
        if !self.is_closed() {
            return z;
        }
        let Piece { heading, course, start: (s0, length) } = self.piece;
        let gone = heading * (s - s0);
        match course {
            Course::Away => heading * self.branch(course).at(length + gone, false),
            Course::Back => -heading * self.branch(course).at(length - gone, false),
        }
    }

    fn rate(&self, t: f64, at: [f64; 2]) -> [f64; 2] {
        let z = self.hysteresis(at);
        let slip = self.slip(t, at[0], z);
        [slip, if self.is_closed() { 0.0 } else { self.damper.hysteresis().rate(z, slip) }]
    }

    /// s and z after a step of length h, and its error in parts of what is allowed.
    fn tried(&self, h: f64) -> ([f64; 2], f64) {
        if self.exact() {
            return ([self.moved(self.t + h).0, self.z], 0.0);
        }
        let start = [self.s, self.z];
        let mut k = [[0.0; 2]; 7];
        k[0] = self.rate(self.t, start);
        let sum = |weights: &[f64], k: &[[f64; 2]; 7]| -> [f64; 2] {
            std::array::from_fn(|i| weights.iter().zip(k).map(|(weight, k)| weight * k[i]).sum())
        };
        for stage in 1..6 {
            let rise = sum(&A[stage], &k);
            k[stage] = self.rate(self.t + C[stage] * h, [0, 1].map(|i| start[i] + h * rise[i]));
        }
        let rise = sum(&B, &k);
        let end = [0, 1].map(|i| start[i] + h * rise[i]);
        k[6] = self.rate(self.t + h, end);
        let most = self.damper.hysteresis().saturation();
        let yielding = (most / self.damper.hysteresis().amplitude()).min(self.motion.reach());
        let off = sum(&E, &k);
        let error = (h * off[0] / yielding).abs().max((h * off[1] / most).abs()) / TOLERANCE;
        (end, error)
    }

    /// Positive as long as an event has not come.
    fn margin(&self, event: Event, t: f64, at: [f64; 2]) -> f64 {
        let Piece { heading, course, start: (s0, length) } = self.piece;
        match event {
            Event::Turn => heading * self.slip(t, at[0], self.hysteresis(at)),
            Event::Zero if course == Course::Away => 1.0,
            // Not z itself, which has poles where its branch is continued far beyond.
            Event::Zero if self.is_closed() => length - heading * (at[0] - s0),
            Event::Zero => -heading * at[1],
        }
    }
}

/// What ends a piece.
#[derive(Clone, Copy)]
enum Event {
    /// ṡ changes its sign.
    Turn,
    /// z does.
    Zero,
}
