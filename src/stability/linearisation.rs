//! A model at its equilibrium: where it rests, and how it answers a small push there.

use nalgebra::{Complex, DMatrix};

use super::{eigenvalues::eigenvalues, elimination::Triangle};
use crate::{
    error::{Code, Error, Result},
    few::{padded, sort_few},
    model::{Description, System},
};

/// Most steps of Newton's method on the way to an equilibrium: it takes a few, or it will not come.
const NEWTON_STEPS: usize = 50;

/// The equations ẋ = f(x) near their equilibrium x₀: a small push d from it moves by ḋ = J d.
///
/// # Equations
/// f(x₀) = 0 and J = ∂f/∂x at x₀, exact by dual numbers, in the mode that holds at x₀: with freeplay the gear rests in its
/// gap, where no spring acts.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearisation {
    /// x₀, in the order of the state table.
    pub equilibrium: Vec<f64>,
    /// J, in the same order.
    pub jacobian: DMatrix<f64>,
    /// How many states may have any value at rest: as many eigenvalues are zero, and say nothing of stability. A hysteresis
    /// has one.
    pub neutral: usize,
}

impl Linearisation {
    /// The eigenvalues of J \[1/s\]: see [`eigenvalues`].
    ///
    /// # Errors
    /// A matrix so extreme that they leave the numbers.
    pub fn eigenvalues(&self) -> Result<Vec<Complex<f64>>> {
        let mut values = self.deciding()?;
        if self.neutral == 0 {
            return Ok(values);
        }
        values.extend(vec![Complex::from(0.0); self.neutral]);
        sort_few(&mut values, |a, b| a.re > b.re);
        Ok(values)
    }

    /// Those that decide on stability: all but what is zero whatever the values.
    ///
    /// # Errors
    /// As [`Linearisation::eigenvalues`].
    pub fn deciding(&self) -> Result<Vec<Complex<f64>>> {
        let mut values = eigenvalues(&self.jacobian)?;
        for _ in 0..self.neutral {
            let least = (0..values.len()).min_by(|a, b| values[*a].norm_sqr().total_cmp(&values[*b].norm_sqr()));
            least.map(|least| values.remove(least));
        }
        Ok(values)
    }
}

/// The model with the parameter values `values`, in table order, at its equilibrium.
///
/// # Errors
/// Values so extreme that the Jacobian leaves the numbers; no equilibrium that Newton's method finds from the state 0.
pub(crate) fn linearised(model: &Description, values: &[f64]) -> Result<Linearisation> {
    model.linearised(values)
}

/// A system at its equilibrium.
///
/// # Errors
/// As [`linearised`].
pub(crate) fn at_rest<S: System<N>, const N: usize>(system: &S) -> Result<Linearisation> {
    let width = system.width();
    let (start, free) = system.rest();
    newton(&start[..width], free, &|x| {
        let x: [f64; N] = padded(x, 0.0);
        let mode = system.mode(0.0, &x);
        let rows = system.jacobian(0.0, mode, &x);
        (system.rate(0.0, mode, &x)[..width].to_vec(), DMatrix::from_fn(width, width, |row, column| rows[row][column]))
    })
}

/// f and ∂f/∂x at a state.
type Answer = (Vec<f64>, DMatrix<f64>);

/// Newton's method for f(x) = 0 from a start; `at` gives f and its Jacobian, and `free` has a bit for each state that stays.
fn newton(start: &[f64], free: u32, at: &dyn Fn(&[f64]) -> Answer) -> Result<Linearisation> {
    let mut equilibrium = start.to_vec();
    let neutral = free.count_ones() as usize;
    let mut arrived = false;
    for _ in 0..NEWTON_STEPS {
        let (rate, jacobian) = at(&equilibrium);
        if jacobian.iter().chain(&rate).any(|entry| !entry.is_finite()) {
            return Err(Error::beyond_numbers("the Jacobian"));
        }
        if arrived || rate.iter().all(|rate| *rate == 0.0) {
            return Ok(Linearisation { equilibrium, jacobian, neutral });
        }
        let mut side: Vec<Complex<f64>> = rate.iter().map(|rate| Complex::from(-rate)).collect();
        let mut jacobian = jacobian;
        for i in (0..start.len()).filter(|i| free >> i & 1 == 1) {
            side[i] = 0.0.into();
            (0..start.len()).for_each(|j| jacobian[(i, j)] = f64::from(u8::from(i == j)));
        }
        let step = Triangle::of(&jacobian, 0.0.into(), &side).solution(0.0);
        // A step that is lost in rounding is the last.
        arrived = step.iter().zip(&equilibrium).all(|(step, x)| step.re.abs() <= 4.0 * f64::EPSILON * x.abs());
        for (x, step) in equilibrium.iter_mut().zip(&step) {
            *x += step.re;
        }
    }
    let allowed = "such that the model has an equilibrium that Newton's method finds from the state 0";
    Err(Error::new(Code::Unsuited, "parameters", "values with which it finds none", allowed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{model::Mode, real::Real};

    /// A pendulum of unit length that a constant torque holds aside: θ̈ = −9 sin θ − θ̇/2 + torque.
    #[derive(Clone)]
    struct Held(f64);

    impl System<2> for Held {
        fn rate<R: Real>(&self, _t: R, _mode: Mode, x: &[R; 2]) -> [R; 2] {
            [x[1], x[0].sin() * -9.0 - x[1] * 0.5 + self.0]
        }
    }

    #[test]
    fn an_equilibrium_away_from_zero_is_found() {
        let linear = at_rest(&Held(4.5)).unwrap();
        let rest = std::f64::consts::FRAC_PI_6; // 9 sin θ = 4.5
        assert!((linear.equilibrium[0] - rest).abs() < 1e-15 && linear.equilibrium[1] == 0.0, "{linear:?}");
        assert!((linear.jacobian[(1, 0)] + 9.0 * rest.cos()).abs() < 1e-14);
        assert_eq!(linear.jacobian[(1, 1)], -0.5);
    }

    #[test]
    fn what_never_rests_is_refused() {
        assert_eq!(at_rest(&Held(10.0)).unwrap_err().code, Code::Unsuited);
    }
}
