//! Routh's array of any polynomial.

use super::bounded::Bounded;
use crate::error::{Code, Error, Result};

/// A row of Routh's array that could not be gone on with as it came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Special {
    /// Its first entry was zero, others were not.
    ZeroPivot,
    /// All of it was zero: the row above divides the polynomial, and has its roots in pairs ±s.
    ZeroRow,
}

impl Special {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::ZeroPivot => "zero-pivot",
            Self::ZeroRow => "zero-row",
        }
    }
}

/// Routh's array of a polynomial, and what it says of the roots.
///
/// # Equations
/// The first two rows are the coefficients, every second one each. An entry of a later row is
/// r₀ⱼ₊₁ − (r₀₀/r₁₀) r₁ⱼ₊₁, with r₁ the row above it and r₀ the row above that. Each change of sign in the first column is
/// a root in the right half plane (Routh).
///
/// *A zero row*: the row above it, read as a polynomial (the auxiliary one: every second power), divides the whole. Its
/// derivative takes the place of the zeros.
///
/// *A zero pivot*: textbooks put ε there and let it go to zero. Here the row is multiplied by a polynomial that is positive
/// on the imaginary axis, which says the same without a limit: with p leading zeros by 1 + (−1)ᵖ(s/ω₀)²ᵖ, which is
/// 1 + (ω/ω₀)²ᵖ at s = iω. The argument of the polynomial along the axis turns as often as before, and so the number of
/// roots on either side stays; the entries become r_j + (−1)ᵖ r_{j+p}/ω₀²ᵖ, the first of which is not zero. ω₀ is the power
/// of ten nearest to the size of the roots: 1 for numbers as textbooks have them.
///
/// # Limits
/// An entry is zero where it is not larger than what rounding may have left of it: a root as near to the axis is on it.
///
/// # References
/// E. J. Routh, *A Treatise on the Stability of a Given State of Motion*, Macmillan, 1877. M. Benidir and B. Picinbono,
/// *IEEE Transactions on Automatic Control* 35 (1990) 218–222, for the zero pivot.
#[derive(Clone, Debug, PartialEq)]
pub struct RouthArray {
    /// The polynomial's coefficients, highest power first.
    pub coefficients: Vec<f64>,
    /// From the row of sⁿ to that of s⁰, as the array goes on with them.
    pub rows: Vec<Vec<f64>>,
    /// What was special about each row.
    pub special: Vec<Option<Special>>,
    /// A special row as it came out; none where it was not special.
    pub replaced: Vec<Option<Vec<f64>>>,
    /// How many roots lie in the right half plane, each as often as it is one: the changes of sign in the first column.
    pub unstable_roots: usize,
    /// How many lie on the imaginary axis.
    pub neutral_roots: usize,
    /// All lie in the left half plane.
    pub stable: bool,
}

impl RouthArray {
    /// Of the polynomial with these coefficients, highest power first.
    ///
    /// # Errors
    /// No coefficients, one that is not finite, a first one that is 0; sizes so different that an entry leaves the numbers.
    pub fn of(coefficients: &[f64]) -> Result<Self> {
        Self::of_bounded(&coefficients.iter().map(|value| Bounded::rounded(*value)).collect::<Vec<_>>())
    }

    /// As [`RouthArray::of`], where it is known how far each coefficient may be off.
    ///
    /// # Errors
    /// As there.
    pub(crate) fn of_bounded(bounded: &[Bounded]) -> Result<Self> {
        let coefficients = &values(bounded)[..];
        let degree = coefficients.len().saturating_sub(1);
        if coefficients.first().is_none_or(|leading| *leading == 0.0) {
            let allowed = "of a polynomial whose first coefficient is not 0";
            return Err(Error::new(Code::NotFinite, "Routh's array", "none", allowed));
        }
        let mut array = Self {
            coefficients: coefficients.to_vec(),
            rows: Vec::new(),
            special: Vec::new(),
            replaced: Vec::new(),
            unstable_roots: 0,
            neutral_roots: 0,
            stable: true,
        };
        let (mut above, mut row): (Vec<Bounded>, Vec<Bounded>) = (Vec::new(), Vec::new());
        // The degree of the first auxiliary polynomial, and the changes of sign above it.
        let mut auxiliary = None;
        for index in 0..=degree {
            let next = if index < 2 {
                bounded.iter().skip(index).step_by(2).copied().collect()
            } else {
                below(&above, &row, (degree - index) / 2 + 1)
            };
            (above, row) = (row, next);
            check_finite(&row)?;
            row.iter_mut().for_each(|entry| *entry = entry.cleared());
            let came_out = values(&row);
            let zeros = came_out.iter().take_while(|entry| **entry == 0.0).count();
            let special = match zeros {
                0 => None,
                _ if zeros < row.len() => Some(Special::ZeroPivot),
                _ => Some(Special::ZeroRow),
            };
            match special {
                None => {}
                Some(Special::ZeroPivot) => multiply(&mut row, zeros, size_of_roots(coefficients)),
                Some(Special::ZeroRow) => {
                    let power = degree + 1 - index;
                    auxiliary = auxiliary.or(Some((power, array.unstable_roots)));
                    differentiate(&mut row, &above, power);
                }
            }
            check_finite(&row)?;
            let before = array.rows.last().map_or(coefficients[0], |row| row[0]);
            array.unstable_roots += usize::from((before < 0.0) != (row[0].value < 0.0));
            array.replaced.push(special.map(|_| came_out));
            array.special.push(special);
            array.rows.push(values(&row));
        }
        if let Some((roots, before)) = auxiliary {
            // It has as many roots on the left as on the right.
            array.neutral_roots = roots - 2 * (array.unstable_roots - before);
        }
        array.stable = array.unstable_roots == 0 && array.special.iter().all(Option::is_none);
        Ok(array)
    }

    /// The first column.
    pub fn column(&self) -> Vec<f64> {
        self.rows.iter().map(|row| row[0]).collect()
    }
}

/// The row under `above` and `row`, of `length` entries.
fn below(above: &[Bounded], row: &[Bounded], length: usize) -> Vec<Bounded> {
    let ratio = above[0].over(row[0].negative());
    (0..length)
        .map(|place| row.get(place + 1).map_or(above[place + 1], |entry| above[place + 1] + ratio * *entry))
        .collect()
}

/// Turns a row with so many leading zeros into its product with 1 + (−1)ᵖ(s/ω₀)²ᵖ, p = `zeros`, ω₀ = `size`.
fn multiply(row: &mut [Bounded], zeros: usize, size: f64) {
    let factor = Bounded::exact((-1.0 / (size * size)).powi(zeros as i32));
    for place in zeros..row.len() {
        row[place - zeros] = row[place - zeros] + factor * row[place];
    }
}

/// Puts the derivative of the polynomial `above`, whose first power is `power`, in the place of a zero row.
fn differentiate(row: &mut [Bounded], above: &[Bounded], power: usize) {
    for (place, entry) in row.iter_mut().enumerate() {
        *entry = *entry + Bounded::exact((power - 2 * place) as f64) * above[place];
    }
}

fn values(row: &[Bounded]) -> Vec<f64> {
    row.iter().map(|entry| entry.value).collect()
}

fn check_finite(row: &[Bounded]) -> Result<()> {
    if row.iter().all(|entry| entry.value.is_finite() && entry.error.is_finite()) {
        return Ok(());
    }
    Err(Error::beyond_numbers("Routh's array"))
}

/// The power of ten nearest to the roots' geometric mean; 1 where one of them is 0.
fn size_of_roots(coefficients: &[f64]) -> f64 {
    let degree = coefficients.len() as i32 - 1;
    let (leading, last) = (coefficients[0].abs(), coefficients[coefficients.len() - 1].abs());
    let mut size = 1.0;
    if last > 0.0 {
        while leading * (size * 10_f64.sqrt()).powi(degree) < last {
            size *= 10.0;
        }
        while leading * (size / 10_f64.sqrt()).powi(degree) > last {
            size /= 10.0;
        }
    }
    size
}
