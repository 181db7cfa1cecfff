//! Small square matrices, and how a linear motion with changing coefficients carries its neighbours.
//!
//! nalgebra's products are made for large matrices: as WebAssembly they are longer than all of this.

/// A square matrix, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Square {
    n: usize,
    entries: Vec<f64>,
}

impl Square {
    pub fn of(n: usize, entry: &dyn Fn(usize, usize) -> f64) -> Self {
        Self { n, entries: (0..n * n).map(|place| entry(place / n, place % n)).collect() }
    }

    pub fn identity(n: usize) -> Self {
        Self::of(n, &|i, j| f64::from(u8::from(i == j)))
    }

    pub fn at(&self, i: usize, j: usize) -> f64 {
        self.entries[i * self.n + j]
    }

    pub fn is_finite(&self) -> bool {
        self.entries.iter().all(|entry| entry.is_finite())
    }

    /// self · other.
    pub fn times(&self, other: &Self) -> Self {
        let n = self.n;
        let mut product = Self { n, entries: vec![0.0; n * n] };
        for i in 0..n {
            for k in 0..n {
                let factor = self.entries[i * n + k];
                for j in 0..n {
                    product.entries[i * n + j] += factor * other.entries[k * n + j];
                }
            }
        }
        product
    }

    /// The sum of a · A of each.
    fn sum(parts: &[(f64, &Self)]) -> Self {
        let n = parts[0].1.n;
        let entry = |place: usize| parts.iter().fold(0.0, |sum, (factor, part)| sum + factor * part.entries[place]);
        Self { n, entries: (0..n * n).map(entry).collect() }
    }

    /// AB − BA.
    fn commutator(&self, other: &Self) -> Self {
        Self::sum(&[(1.0, &self.times(other)), (-1.0, &other.times(self))])
    }

    /// The largest sum of a row's sizes.
    fn norm(&self) -> f64 {
        let row = |row: &[f64]| row.iter().fold(0.0, |sum, entry| sum + entry.abs());
        self.entries.chunks_exact(self.n).fold(0.0, |most: f64, entries| most.max(row(entries)))
    }

    /// The exponential: Taylor's series of a part of it that is small, squared up again.
    fn exponential(&self) -> Self {
        let mut doublings = 0;
        let mut size = self.norm();
        while size > 0.5 && doublings < 60 {
            size *= 0.5;
            doublings += 1;
        }
        let part = Self::sum(&[(0.5_f64.powi(doublings), self)]);
        let mut sum = Self::identity(self.n);
        let mut term = part.clone();
        for order in 2..20 {
            sum = Self::sum(&[(1.0, &sum), (1.0, &term)]);
            if term.norm() <= 0.1 * f64::EPSILON {
                break;
            }
            term = Self::sum(&[(1.0 / f64::from(order), &term.times(&part))]);
        }
        (0..doublings).fold(sum, |power, _| power.times(&power))
    }
}

/// Places of the three Gauss points in (0, 1).
pub(super) const GAUSS: [f64; 3] = [0.112_701_665_379_258_3, 0.5, 0.887_298_334_620_741_7];

/// How d′ = A(t) d carries d over a step of length `h`, from A at the [`GAUSS`] points: of order 6 in h, and exact for
/// constant A.
///
/// # References
/// Magnus' series as in S. Blanes, F. Casas, J. A. Oteo, J. Ros, *Physics Reports* 470 (2009) 151–238, section 5.4.
pub(super) fn propagator(a: &[Square; 3], h: f64) -> Square {
    let root = 15_f64.sqrt() / 3.0 * h;
    let third = 10.0 / 3.0 * h;
    let first = Square::sum(&[(h, &a[1])]);
    let second = Square::sum(&[(root, &a[2]), (-root, &a[0])]);
    let third = Square::sum(&[(third, &a[2]), (-2.0 * third, &a[1]), (third, &a[0])]);
    let c1 = first.commutator(&second);
    let c2 = first.commutator(&Square::sum(&[(-2.0 / 60.0, &third), (-1.0 / 60.0, &c1)]));
    let left = Square::sum(&[(-20.0 / 240.0, &first), (-1.0 / 240.0, &third), (1.0 / 240.0, &c1)]);
    let bend = left.commutator(&Square::sum(&[(1.0, &second), (1.0, &c2)]));
    Square::sum(&[(1.0, &first), (1.0 / 12.0, &third), (1.0, &bend)]).exponential()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponential_of_a_turn() {
        for angle in [0.3, 4.0, 40.0] {
            let turn = Square::of(2, &|i, j| [[0.0, -angle], [angle, 0.0]][i][j]).exponential();
            // Rounding grows with the doublings.
            assert!((turn.at(0, 0) - f64::cos(angle)).abs() < 1e-15 * (1.0 + 10.0 * angle));
            assert!((turn.at(1, 0) - f64::sin(angle)).abs() < 1e-15 * (1.0 + 10.0 * angle));
        }
    }

    /// d′ = A(t) d with A = R(t) B R(−t), R a turn by t: in the turning frame the coefficients B − J are constant.
    #[test]
    fn propagator_is_of_order_six() {
        let b = [[-0.3, 2.0], [0.5, -1.0]];
        let turn = |t: f64| Square::of(2, &|i, j| [[t.cos(), -t.sin()], [t.sin(), t.cos()]][i][j]);
        let a = |t: f64| turn(t).times(&Square::of(2, &|i, j| b[i][j])).times(&turn(-t));
        let exact =
            turn(2.0).times(&Square::of(2, &|i, j| 2.0 * (b[i][j] - [[0.0, -1.0], [1.0, 0.0]][i][j])).exponential());
        let error = |steps: u32| {
            let h = 2.0 / f64::from(steps);
            let step =
                |so_far: Square, k| propagator(&GAUSS.map(|place| a((f64::from(k) + place) * h)), h).times(&so_far);
            Square::sum(&[(1.0, &(0..steps).fold(Square::identity(2), step)), (-1.0, &exact)]).norm()
        };
        let (coarse, fine) = (error(8), error(16));
        assert!(coarse < 2e-5 && fine < 2e-7, "{coarse:e} {fine:e}");
        assert!((coarse / fine).log2() > 5.6, "{coarse:e} {fine:e}");
    }
}
