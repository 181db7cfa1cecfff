//! A polynomial on the unit interval, and where it changes its sign there.

use super::polynomial::COEFFICIENTS;

/// A Newton step that is shorter ends the search: the next one would be its square.
const ARRIVED: f64 = 1e-6;
/// How often an interval is halved: what still seems to hold two crossings then touches zero, and does not cross it.
pub(super) const DEEPEST: usize = 40;

/// Bernstein coefficients.
pub(super) type Bernstein = [f64; COEFFICIENTS];

/// Σ cᵢ xⁱ from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub power: [f64; COEFFICIENTS],
    pub degree: usize,
}

/// Places at which a sign changes, ascending.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Crossings {
    at: [f64; COEFFICIENTS],
    count: usize,
}

impl Crossings {
    pub fn list(&self) -> &[f64] {
        &self.at[..self.count]
    }

    #[inline(never)]
    pub fn push(&mut self, x: f64) {
        if let Some(place) = self.at.get_mut(self.count) {
            *place = x;
            self.count += 1;
        }
    }

    /// The first of them, or any number.
    #[inline]
    pub fn first(&self) -> f64 {
        self.at[0]
    }
}

impl Line {
    /// Value and slope at `x`.
    #[inline(always)]
    pub fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for c in self.power[..=self.degree].iter().rev() {
            slope = slope * x + value;
            value = value * x + c;
        }
        (value, slope)
    }

    /// Finds where the sign changes, and tells whether the line is positive before. `crossings` are those of a neighbour,
    /// `guess` is where the first one is expected if there is but one.
    ///
    /// The signs of the Bernstein coefficients change at least as often as its own, and by an even number more (Descartes):
    /// with none or one of them all is known, with more the interval is cut in two.
    #[inline]
    pub fn cross(&self, guess: f64, crossings: &mut Crossings) -> bool {
        let b = bernstein_in_line(self.power, self.degree);
        let signs = Signs::of(&b[..=self.degree]);
        match signs.changes {
            0 => crossings.count = 0,
            1 => {
                crossings.at[0] = self.crossing(0.0, 1.0, signs.last > 0.0, guess);
                crossings.count = 1;
            }
            _ => {
                let mut found = Crossings::default();
                self.within(&b, [0.0, 1.0], DEEPEST, crossings, &mut found);
                *crossings = found;
            }
        }
        signs.first > 0.0
    }

    /// Where the sign changes in an open interval, of which `b` are the Bernstein coefficients.
    #[inline(never)]
    pub fn within(&self, b: &Bernstein, ends: [f64; 2], depth: usize, expected: &Crossings, found: &mut Crossings) {
        let signs = Signs::of(&b[..=self.degree]);
        let [low, high] = ends;
        match signs.changes {
            0 => {}
            1 => {
                let guess = expected.list().iter().find(|x| low < **x && **x < high);
                found.push(self.crossing(low, high, signs.last > 0.0, guess.copied().unwrap_or(low)));
            }
            _ if depth == 0 => {}
            _ => {
                // Where two are expected, between them.
                let between = expected.list().windows(2).map(|two| (0.5 * (two[0] + two[1]) - low) / (high - low));
                let part = between.into_iter().find(|part| (0.1..=0.9).contains(part)).unwrap_or(0.5);
                let (left, right) = parts(b, self.degree, part);
                let middle = low + part * (high - low);
                self.within(&left, [low, middle], depth - 1, expected, found);
                let (before, after) = (Signs::of(&left[..=self.degree]), Signs::of(&right[..=self.degree]));
                if right[0] == 0.0 && before.last * after.first < 0.0 {
                    found.push(middle);
                }
                self.within(&right, [middle, high], depth - 1, expected, found);
            }
        }
    }

    /// The one place between `low` and `high` where the line `rises` or falls through 0: by Newton's method, kept between.
    #[inline]
    fn crossing(&self, mut low: f64, mut high: f64, rises: bool, guess: f64) -> f64 {
        let mut x = if low < guess && guess < high { guess } else { 0.5 * (low + high) };
        for _ in 0..100 {
            let (value, slope) = self.at(x);
            if value == 0.0 {
                break;
            }
            *(if (value > 0.0) == rises { &mut high } else { &mut low }) = x;
            let next = x - value / slope;
            if low < next && next < high {
                let step = (next - x).abs();
                x = next;
                if step < ARRIVED {
                    break;
                }
            } else {
                x = 0.5 * (low + high);
            }
        }
        x
    }
}

/// From powers to the Bernstein coefficients on the unit interval, between whose least and greatest the polynomial runs.
#[inline(never)]
pub(super) fn bernstein(c: [f64; COEFFICIENTS], degree: usize) -> Bernstein {
    bernstein_in_line(c, degree)
}

#[inline(always)]
fn bernstein_in_line(mut c: [f64; COEFFICIENTS], degree: usize) -> Bernstein {
    for k in 1..degree {
        c[k] *= RECIPROCALS[degree][k];
    }
    // Up Pascal's triangle.
    for start in 1..=degree {
        for i in (start..=degree).rev() {
            c[i] += c[i - 1];
        }
    }
    c
}

/// One over the binomials of (degree, k).
const RECIPROCALS: [[f64; COEFFICIENTS]; COEFFICIENTS] = {
    let mut all = [[1.0; COEFFICIENTS]; COEFFICIENTS];
    let mut degree = 1;
    while degree < COEFFICIENTS {
        let (mut binomial, mut k) = (1.0, 1);
        while k < degree {
            binomial *= (degree + 1 - k) as f64 / k as f64;
            all[degree][k] = 1.0 / binomial;
            k += 1;
        }
        degree += 1;
    }
    all
};

/// Signs of a row of numbers, zeros aside: how often they change, and the first and last of them.
#[derive(Clone, Copy, Default)]
struct Signs {
    changes: usize,
    first: f64,
    last: f64,
}

impl Signs {
    #[inline]
    fn of(numbers: &[f64]) -> Self {
        let mut signs = Self::default();
        for b in numbers {
            if *b != 0.0 {
                let sign = b.signum();
                signs.changes += usize::from(signs.last * sign < 0.0);
                signs.last = sign;
                if signs.first == 0.0 {
                    signs.first = sign;
                }
            }
        }
        signs
    }
}

/// The Bernstein coefficients of the two parts that the interval is cut into (de Casteljau).
#[inline(never)]
pub(super) fn parts(b: &Bernstein, degree: usize, part: f64) -> (Bernstein, Bernstein) {
    let (mut left, mut right) = (*b, *b);
    for step in 1..=degree {
        for i in 0..=degree - step {
            right[i] += part * (right[i + 1] - right[i]);
        }
        left[step] = right[0];
    }
    (left, right)
}
