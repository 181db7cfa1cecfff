//! Where eigenvalues cross the imaginary axis as one parameter varies: every place, for any model.

use std::f64::consts::{PI, TAU};

use super::{CurveKind, eigenvalues::eigenvalues};
use crate::error::Result;
use nalgebra::{Complex, DMatrix};

/// A value of the parameter at which eigenvalues cross the imaginary axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The parameter, in its unit.
    pub value: f64,
    /// A pair, or a real eigenvalue.
    pub kind: CurveKind,
    /// Of the swing that neither grows nor fades there \[Hz\]; 0 at a divergence.
    pub frequency: f64,
}

/// Eigenvalues, by the value of the parameter.
pub(crate) type Spectrum<'a> = &'a dyn Fn(f64) -> Result<Vec<Complex<f64>>>;

/// Places in a piece at which the test function is looked at.
const SAMPLES: usize = 16;
/// Pieces to begin with, and how often one may be halved.
const PIECES: usize = 4;
const DEEPEST: u32 = 9;
/// A piece is resolved where the last coefficients of its series are this small beside its largest value.
const RESOLVED: f64 = 1e-12;
/// What lies farther from the axis than this part of the largest eigenvalue, where the sign changes, has not crossed it: it
/// has jumped.
const NEAR: f64 = 1e-7;

/// Every crossing in the open interval (`from`, `to`), ascending.
///
/// # Method
/// A pair is on the axis only where Π (λᵢ + λⱼ), over all i < j, is zero, and a real eigenvalue only where Π λᵢ is. Both
/// products are smooth in the parameter where the Jacobian is, even where eigenvalues meet. On pieces that are halved until
/// a Chebyshev series of degree 15 holds the product to rounding, all roots of the series are found at once, as the
/// eigenvalues of its colleague matrix; between them the product's own sign is asked, and each change is bisected to the
/// last digit. So two crossings are told apart down to where rounding hides the sign between them; then they count as none
/// or as two.
///
/// A range of positive numbers is looked at in its logarithm.
///
/// # Errors
/// Those of `spectrum`.
///
/// # References
/// The products are determinants of the bialternate product of J with 1 and of J: J. Guckenheimer, M. Myers and
/// B. Sturmfels, *SIAM J. Numer. Anal.* 34 (1997) 1–21. Roots by pieces: J. P. Boyd, *SIAM J. Numer. Anal.* 40 (2002)
/// 1666–1682. Colleague matrix: I. J. Good, *Quarterly J. Math.* 12 (1961) 61–68.
pub(crate) fn crossings(spectrum: Spectrum, from: f64, to: f64) -> Result<Vec<Crossing>> {
    let geometric = from > 0.0 && to > 2.0 * from;
    let value = |part: f64| if geometric { from * ((to / from).ln() * part).exp() } else { from + (to - from) * part };
    let mut found: Vec<Crossing> = Vec::new();
    for kind in CurveKind::BOTH {
        let mut search = Search { kind, at: &|part| spectrum(value(part)), roots: Vec::new() };
        for piece in 0..PIECES {
            let end = |i: usize| i as f64 / PIECES as f64;
            search.piece(end(piece), end(piece + 1), DEEPEST)?;
        }
        for root in search.roots {
            let value = value(root);
            if let Some(frequency) = frequency(kind, &spectrum(value)?) {
                let place = found.partition_point(|crossing| crossing.value < value);
                found.insert(place, Crossing { value, kind, frequency });
            }
        }
    }
    Ok(found)
}

struct Search<'a> {
    kind: CurveKind,
    /// Eigenvalues, by the part of the range that lies behind, from 0 to 1.
    at: Spectrum<'a>,
    /// In the same measure, ascending.
    roots: Vec<f64>,
}

impl Search<'_> {
    /// The product at `part`, each factor over `size`, and how large rounding may make it.
    fn product(&self, part: f64, size: f64) -> Result<(f64, f64)> {
        let values = (self.at)(part)?;
        let rounding = 64.0 * f64::EPSILON * largest(&values) / size;
        let (mut product, mut error) = (Complex::from(1.0), 0.0);
        let mut times = |factor: Complex<f64>| {
            let factor = Complex::new(factor.re / size, factor.im / size);
            error = error * (factor.norm() + rounding) + product.norm() * rounding;
            product *= factor;
        };
        for (i, value) in values.iter().enumerate() {
            match self.kind {
                CurveKind::Hopf => values[i + 1..].iter().for_each(|other| times(value + other)),
                CurveKind::Divergence => times(*value),
            }
        }
        Ok((product.re, error))
    }

    /// Adds the roots between `low` and `high`.
    fn piece(&mut self, low: f64, high: f64, deeper: u32) -> Result<()> {
        let middle = low.midpoint(high);
        let size = largest(&(self.at)(middle)?);
        if size == 0.0 {
            return Ok(());
        }
        let place = |t: f64| middle + 0.5 * (high - low) * t;
        let angle = |j: usize| PI * (j as f64 + 0.5) / SAMPLES as f64;
        let (mut samples, mut most, mut noise) = (Vec::with_capacity(SAMPLES), 0.0_f64, 0.0_f64);
        for j in 0..SAMPLES {
            let (product, error) = self.product(place(angle(j).cos()), size)?;
            samples.push(product);
            (most, noise) = (most.max(product.abs()), noise.max(error));
        }
        if most <= noise {
            return Ok(()); // it stays on the axis
        }
        let coefficient = |k: usize| {
            let sum: f64 = samples.iter().enumerate().map(|(j, sample)| sample * (k as f64 * angle(j)).cos()).sum();
            sum * if k == 0 { 1.0 } else { 2.0 } / SAMPLES as f64
        };
        let series: Vec<f64> = (0..SAMPLES).map(coefficient).collect();
        let tail = series[SAMPLES - 3..].iter().fold(0.0, |most: f64, c| most.max(c.abs()));
        let negligible = (RESOLVED * most).max(noise);
        let places = if tail <= negligible && samples.iter().all(|sample| sample.is_finite()) {
            roots_of(&series, negligible)?
        } else if deeper > 0 {
            self.piece(low, middle, deeper - 1)?;
            return self.piece(middle, high, deeper - 1);
        } else {
            (0..SAMPLES).rev().map(|j| angle(j).cos()).collect()
        };
        // Between two neighbouring roots, the product's own sign.
        let mut start = low;
        let between = places.windows(2).map(|pair| place(pair[0].midpoint(pair[1])));
        for end in between.chain([high]) {
            self.bisect(start, end, size)?;
            start = end;
        }
        Ok(())
    }

    /// Adds the root between `low` and `high`, if the sign changes there.
    fn bisect(&mut self, mut low: f64, mut high: f64, size: f64) -> Result<()> {
        let rises = self.product(high, size)?.0 > 0.0;
        if (self.product(low, size)?.0 > 0.0) == rises {
            return Ok(());
        }
        while high - low > f64::EPSILON / 2.0 {
            let middle = low.midpoint(high);
            if (self.product(middle, size)?.0 > 0.0) == rises { high = middle } else { low = middle }
        }
        self.roots.push(low.midpoint(high));
        Ok(())
    }
}

fn largest(values: &[Complex<f64>]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.norm()))
}

/// The real parts of a Chebyshev series' roots in and near \[−1, 1\], ascending.
fn roots_of(series: &[f64], negligible: f64) -> Result<Vec<f64>> {
    let degree = series.iter().rposition(|c| c.abs() > negligible).unwrap_or(0);
    let others: f64 = series[1..=degree].iter().map(|c| c.abs()).sum();
    if degree == 0 || series[0].abs() > others + negligible {
        return Ok(Vec::new());
    }
    // T₁ = x T₀ and 2x Tₖ = Tₖ₋₁ + Tₖ₊₁, with the last one from the series itself.
    let colleague = DMatrix::from_fn(degree, degree, |row, column| {
        let recurrence = match (row, column) {
            (0, 1) => 1.0,
            _ if row.abs_diff(column) == 1 => 0.5,
            _ => 0.0,
        };
        let last = if row + 1 == degree { series[column] / series[degree] } else { 0.0 };
        recurrence - if degree == 1 { last } else { 0.5 * last }
    });
    let mut roots: Vec<f64> = eigenvalues(&colleague)?
        .into_iter()
        .filter(|root| root.re.abs() <= 1.0 + 1e-6 && root.im.abs() <= 1e-2)
        .map(|root| root.re)
        .collect();
    roots.reverse();
    Ok(roots)
}

/// The frequency \[Hz\] of what crosses, if it does.
fn frequency(kind: CurveKind, values: &[Complex<f64>]) -> Option<f64> {
    let near = NEAR * largest(values);
    match kind {
        CurveKind::Hopf => {
            let pairs = values.iter().filter(|value| value.im > 0.0);
            let pair = pairs.min_by(|a, b| a.re.abs().total_cmp(&b.re.abs()))?;
            // A real pair ±λ makes the product zero, too.
            (pair.re.abs() <= near && pair.im > near).then_some(pair.im / TAU)
        }
        CurveKind::Divergence => values.iter().any(|value| value.norm() <= near).then_some(0.0),
    }
}
