//! When a motion has settled, told from its amplitude, stretch by stretch.

/// Deviations that fall like a geometric series are settled once what is left of it is so small a part of the amplitude.
const LEFT: f64 = 1e-5;
/// They must fall at least by this factor from stretch to stretch: near a fold they hardly do.
const FALLING: f64 = 0.9;
/// And so often in turn.
const SURE: usize = 3;
/// Amplitudes that go up and down within this part of them are measured as well as they can be: where a step straddles a
/// kink decides of the last digits, and of a gap, which a fast swing crosses in two or three steps, of more.
pub(super) const NOISE: f64 = 2e-4;
pub(super) const NOISE_OF_GAP: f64 = 2e-3;
/// How many of them in turn, and how often they must turn.
const HEARD: usize = 6;
const TURNS: usize = 2;
/// So many in turn need not turn: steps and swings may beat slowly.
const LONG: usize = 16;
/// Farther than this nothing comes back, in rad: it stands for the amplitude of what grows without bounds.
pub(super) const LOST: f64 = 1e3;

/// What becomes of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// It falls, and is so small that it falls to rest.
    Rests,
    /// It repeats with this amplitude.
    Repeats(f64),
    /// It leaves all bounds.
    Diverges,
}

/// Hears the amplitudes of stretches of equal length.
///
/// A motion that lingers at an unstable cycle changes as little as one that has settled; but its deviations grow. So they
/// must have fallen twice in turn, and the next stretches say the same; or amplitudes stay the same up to noise, which goes
/// back and forth, or is slow where steps and swings beat.
#[derive(Clone, Copy, Debug)]
pub(super) struct Judge {
    small: f64,
    noise: f64,
    heard: usize,
    /// The last amplitudes, the latest first.
    amplitudes: [f64; HEARD],
    /// How often in turn it seemed to have settled.
    seems: usize,
    /// What the last ones do not differ from, and how many they are.
    level: f64,
    steady: usize,
}

impl Judge {
    /// Below the amplitude `small`, what falls falls to rest; `noise` is the part of an amplitude that measuring leaves open.
    pub fn new(small: f64, noise: f64) -> Self {
        Self { small, noise, heard: 0, amplitudes: [0.0; HEARD], seems: 0, level: 0.0, steady: 0 }
    }

    /// The amplitude heard last.
    pub fn last(&self) -> f64 {
        self.amplitudes[0]
    }

    /// Hears the amplitude of the next stretch.
    pub fn hear(&mut self, amplitude: f64) -> Option<Verdict> {
        if amplitude.is_nan() || amplitude > LOST {
            return Some(Verdict::Diverges);
        }
        self.heard += 1;
        self.amplitudes.rotate_right(1);
        self.amplitudes[0] = amplitude;
        if amplitude == 0.0 || (self.heard > 1 && amplitude < self.small && amplitude < self.amplitudes[1]) {
            return Some(Verdict::Rests);
        }
        let changes: [f64; HEARD - 1] = std::array::from_fn(|i| self.amplitudes[i] - self.amplitudes[i + 1]);
        let ratio = |i: usize| changes[i] / changes[i + 1];
        let left = changes[0] * ratio(0) / (1.0 - ratio(0));
        let falls = self.heard > 3 && ratio(0).abs().max(ratio(1).abs()) < FALLING;
        self.seems = if falls && left.abs() <= LEFT * amplitude { self.seems + 1 } else { 0 };
        if self.seems >= SURE {
            return Some(Verdict::Repeats(amplitude + left));
        }
        let turns = changes.windows(2).filter(|two| two[0] * two[1] <= 0.0).count();
        let (low, high) =
            self.amplitudes.iter().fold((amplitude, amplitude), |(low, high), a| (low.min(*a), high.max(*a)));
        self.steady += 1;
        if (amplitude - self.level).abs() > self.noise * amplitude {
            (self.level, self.steady) = (amplitude, 0);
        }
        let turns_in_noise = self.heard >= HEARD && turns >= TURNS && high - low <= self.noise * amplitude;
        let is_noise = turns_in_noise || self.steady >= LONG;
        is_noise.then(|| Verdict::Repeats(self.amplitudes.iter().sum::<f64>() / HEARD as f64))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The stretch at which a sequence is judged, and how.
    fn judged(amplitudes: impl Iterator<Item = f64>) -> Option<(usize, Verdict)> {
        let mut judge = Judge::new(1e-3, NOISE);
        amplitudes.take(1000).enumerate().find_map(|(n, amplitude)| Some((n, judge.hear(amplitude)?)))
    }

    #[test]
    fn a_geometric_approach_is_cut_short_at_its_limit() {
        for ratio in [0.1, 0.5, -0.4, 0.8] {
            let Some((_, Verdict::Repeats(limit))) = judged((0..).map(|n| 0.2 + 0.1 * f64::powi(ratio, n))) else {
                panic!("{ratio}")
            };
            assert!((limit - 0.2).abs() < 1e-9, "{ratio}: {limit}");
        }
    }

    #[test]
    fn lingering_at_an_unstable_cycle_is_not_settled() {
        // A transient that fades, and a deviation that grows from a hundred-thousandth to a fall to rest.
        let slow = |n: i32| (0.1 + 0.05 * f64::powi(0.05, n) - 1e-6 * f64::powi(1.5, n)).max(0.0);
        assert_eq!(judged((0..).map(slow)).map(|(_, verdict)| verdict), Some(Verdict::Rests));
        let up = |n: i32| (0.1 + 0.05 * f64::powi(0.05, n) + 1e-6 * f64::powi(1.5, n)).min(0.3);
        let Some((_, Verdict::Repeats(limit))) = judged((0..).map(up)) else { panic!() };
        assert!((limit - 0.3).abs() < 3e-5, "{limit}");
    }

    #[test]
    fn what_only_measuring_moves_is_settled() {
        let noisy = |n: i32| 0.2 + 1e-5 * f64::from(n * n % 7 - 3) + 0.1 * f64::powi(0.3, n);
        let Some((n, Verdict::Repeats(limit))) = judged((0..).map(noisy)) else { panic!() };
        assert!((limit - 0.2).abs() < 4e-5 && n < 15, "{limit} after {n}");
    }

    #[test]
    fn small_and_falling_is_rest_and_small_and_rising_is_not() {
        assert_eq!(judged((0..).map(|n| 1e-3 * f64::powi(0.99, n))), Some((1, Verdict::Rests)));
        assert!(matches!(judged((0..).map(|n| (1e-6 * f64::powi(2.0, n)).min(0.1))), Some((_, Verdict::Repeats(_)))));
        assert_eq!(judged(std::iter::repeat(0.0)), Some((0, Verdict::Rests)));
    }

    #[test]
    fn without_bounds_is_divergence() {
        assert_eq!(judged((0..).map(|n| f64::powi(10.0, n))).map(|(_, verdict)| verdict), Some(Verdict::Diverges));
        assert_eq!(judged([0.1, f64::NAN].into_iter()), Some((1, Verdict::Diverges)));
    }

    #[test]
    fn what_never_repeats_is_never_settled() {
        assert_eq!(judged((0..).map(|n| 0.2 + 0.01 * f64::from(n).sin())), None);
    }
}
