//! A polynomial on the unit interval, and where it changes its sign there.

use super::COEFFICIENTS;

/// A Newton step that is shorter ends the search: the next one would be its square.
const ARRIVED: f64 = 1e-8;
/// How often an interval is halved: what still seems to hold two crossings then touches zero, and does not cross it.
pub(in crate::stability) const DEEPEST: usize = 40;

/// Bernstein coefficients.
pub(in crate::stability) type Bernstein = [f64; COEFFICIENTS];

/// Σ cᵢ xⁱ from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(in crate::stability) struct Line {
    pub power: [f64; COEFFICIENTS],
    pub degree: usize,
}

/// Places at which a sign changes, ascending.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::stability) struct Crossings {
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

    /// Half-way between the first two of them, or somewhere between 0 and 1.
    fn middle(&self) -> f64 {
        self.at[0].midpoint(self.at[1])
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
        if let Some(rises) = self.crosses_once() {
            crossings.at[0] = self.crossing_in_line(0.0, 1.0, rises, guess);
            crossings.count = 1;
            return !rises;
        }
        let b = bernstein(self.power, self.degree);
        let signs = Signs::of(&b[..=self.degree]);
        match signs.changes {
            0 => crossings.count = 0,
            1 => {
                crossings.at[0] = self.crossing(0.0, 1.0, signs.last > 0.0, guess);
                crossings.count = 1;
            }
            2 if self.at(crossings.middle()).0 * signs.first < 0.0 => {
                // Between the neighbour's two it has the other sign: those are two, and there are no more.
                let middle = crossings.middle();
                crossings.at[0] = self.crossing(0.0, middle, signs.first < 0.0, crossings.at[0]);
                crossings.at[1] = self.crossing(middle, 1.0, signs.first > 0.0, crossings.at[1]);
                crossings.count = 2;
            }
            _ => {
                let mut found = Crossings::default();
                self.within(&b, [0.0, 1.0], DEEPEST, crossings, &mut found);
                *crossings = found;
            }
        }
        signs.first > 0.0
    }

    /// Whether it rises as it changes its sign, once: what is found below, for cubics that do, which most rows are.
    #[inline(always)]
    fn crosses_once(&self) -> Option<bool> {
        let c = &self.power;
        let third = c[1] * (1.0 / 3.0);
        let (first, second) = (c[0], c[0] + third);
        let (third, last) = (second + third + c[2] * (1.0 / 3.0), c[0] + c[1] + c[2] + c[3]);
        let once = first * last < 0.0 && (second * first > 0.0 || third * last > 0.0);
        (self.degree == 3 && once).then_some(last > 0.0)
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
    #[inline(never)]
    fn crossing(&self, low: f64, high: f64, rises: bool, guess: f64) -> f64 {
        self.crossing_in_line(low, high, rises, guess)
    }

    #[inline(always)]
    fn crossing_in_line(&self, mut low: f64, mut high: f64, rises: bool, guess: f64) -> f64 {
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
pub(super) fn bernstein(mut c: [f64; COEFFICIENTS], degree: usize) -> Bernstein {
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
pub(in crate::stability) fn parts(b: &Bernstein, degree: usize, part: f64) -> (Bernstein, Bernstein) {
    let (mut left, mut right) = (*b, *b);
    for step in 1..=degree {
        for i in 0..=degree - step {
            right[i] += part * (right[i + 1] - right[i]);
        }
        left[step] = right[0];
    }
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::Polynomial;

    fn with_roots(roots: &[f64]) -> Line {
        let factors = roots.iter().map(|root| Polynomial::variable() - Polynomial::from(*root));
        let power = factors.fold(Polynomial::from(1.0), |product, factor| product * factor).0;
        Line { power, degree: roots.len() }
    }

    #[test]
    fn all_changes_of_sign_are_found_wherever_they_are_expected() {
        for roots in [
            &[][..],
            &[0.3],
            &[-0.5],
            &[0.5, 2.0],
            &[0.1, 0.9, -3.0],
            &[0.25, 0.5, 0.75],
            &[1e-9, 0.5, 0.5 + 1e-6, 1.0 - 1e-9],
            &[-1.0, 0.2, 0.4, 0.6, 0.8],
        ] {
            let line = with_roots(roots);
            let within: Vec<f64> = roots.iter().copied().filter(|root| (0.0..1.0).contains(root)).collect();
            for (guess, near) in [(0.5, None), (f64::NAN, Some(0.3)), (1e300, Some(0.7))] {
                let mut crossings = Crossings::default();
                near.into_iter().for_each(|x| crossings.push(x));
                let positive = line.cross(guess, &mut crossings);
                assert_eq!(positive, line.at(0.0).0 > 0.0, "{roots:?}");
                assert_eq!(crossings.list().len(), within.len(), "{roots:?}: {crossings:?}");
                for (got, expected) in crossings.list().iter().zip(&within) {
                    // A Newton step of less than 1e-8 was the last; near a neighbour 1e-6 away rounding leaves some 1e-10.
                    assert!((got - expected).abs() < 1e-9, "{roots:?}: {got} {expected}");
                }
            }
        }
    }

    #[test]
    fn what_only_touches_zero_does_not_cross_it() {
        for roots in [&[0.5, 0.5][..], &[0.3, 0.3, 0.9], &[0.25, 0.25, 0.75, 0.75]] {
            let mut crossings = Crossings::default();
            with_roots(roots).cross(0.5, &mut crossings);
            // Rounding may lift a touch to two crossings as far apart as its root.
            let far: Vec<f64> =
                crossings.list().iter().copied().filter(|x| roots.iter().all(|root| (x - root).abs() > 1e-6)).collect();
            assert!(far.is_empty(), "{roots:?}: {crossings:?}");
            assert_eq!(crossings.list().len() % 2, roots.len() % 2, "{roots:?}: {crossings:?}");
        }
        let zero = Line { power: [0.0; COEFFICIENTS], degree: 3 };
        let mut crossings = Crossings::default();
        assert!(!zero.cross(0.5, &mut crossings) && crossings.list().is_empty());
    }

    #[test]
    fn bernstein_coefficients_bound_the_line() {
        let line = with_roots(&[0.2, 0.4, 3.0, -1.0]);
        let b = bernstein(line.power, line.degree);
        let least = b[..=4].iter().copied().fold(f64::INFINITY, f64::min);
        let most = b[..=4].iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!(b[0] == line.at(0.0).0 && (b[4] - line.at(1.0).0).abs() < 1e-14);
        let (left, right) = parts(&b, 4, 0.3);
        for i in 0..=100 {
            let x = f64::from(i) / 100.0;
            let value = line.at(x).0;
            assert!(least <= value + 1e-14 && value - 1e-14 <= most);
            for (part, from, to) in [(left, 0.0, 0.3), (right, 0.3, 1.0)] {
                if (from..=to).contains(&x) {
                    assert!(
                        part[..=4].iter().any(|c| *c <= value + 1e-14)
                            && part[..=4].iter().any(|c| *c >= value - 1e-14)
                    );
                }
            }
        }
        assert!((left[4] - line.at(0.3).0).abs() < 1e-15 && left[4] == right[0]);
    }
}
