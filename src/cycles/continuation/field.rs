//! The equations' right-hand side near rest, and its second and third derivatives.

use nalgebra::Complex;

use super::family::Family;
use crate::cycles::vector::{complex, imaginary, norm, real, sum, times, vector};

/// The longest step from rest over which derivatives are taken, and how often it is halved.
pub(super) const ASIDE: f64 = 0.1;
const LEVELS: usize = 3;

/// The equations' right-hand side near rest.
pub(super) struct Field<'a> {
    pub family: &'a mut dyn Family,
    pub rest: &'a [f64],
    /// How far from rest it may be asked.
    pub room: f64,
}

impl Field<'_> {
    fn at(&mut self, way: &[f64], part: f64) -> Vec<f64> {
        self.family.flow().rate(&sum(self.rest, part, way))
    }

    /// An even or odd difference over halved steps, extrapolated to none.
    fn extrapolated(&mut self, way: &[f64], steps: f64, difference: &dyn Fn(&mut Self, f64) -> Vec<f64>) -> Vec<f64> {
        let length = norm(way);
        if length == 0.0 {
            return vec![0.0; way.len()];
        }
        let mut table: Vec<Vec<f64>> = Vec::with_capacity(LEVELS);
        for level in 0..LEVELS {
            let h = self.room / (steps * length) * 0.5_f64.powi(level as i32);
            let mut row = difference(self, h);
            for (k, before) in table.iter_mut().enumerate() {
                let weight = 4.0_f64.powi(k as i32 + 1);
                let better = vector(row.len(), &|i| (weight * row[i] - before[i]) / (weight - 1.0));
                *before = std::mem::replace(&mut row, better);
            }
            table.push(row);
        }
        table.pop().unwrap_or_default()
    }

    /// d²f/ds² along `way`.
    pub fn second(&mut self, way: &[f64]) -> Vec<f64> {
        self.extrapolated(way, 1.0, &|field, h| {
            let [before, here, after] = [-h, 0.0, h].map(|part| field.at(way, part));
            vector(way.len(), &|i| (after[i] + before[i] - 2.0 * here[i]) / (h * h))
        })
    }

    /// d³f/ds³ along `way`.
    pub fn third(&mut self, way: &[f64]) -> Vec<f64> {
        self.extrapolated(way, 2.0, &|field, h| {
            let [far, before, after, ahead] = [-2.0 * h, -h, h, 2.0 * h].map(|part| field.at(way, part));
            let entry = |i: usize| ((ahead[i] - far[i]) - 2.0 * (after[i] - before[i])) / (2.0 * h * h * h);
            vector(way.len(), &entry)
        })
    }

    /// B(a, b).
    pub fn bilinear(&mut self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let [plus, minus] = [1.0, -1.0].map(|sign| self.second(&sum(a, sign, b)));
        times(0.25, &sum(&plus, -1.0, &minus))
    }

    /// B(a, b) of complex directions.
    pub fn complex_bilinear(&mut self, a: &[Complex<f64>], b: &[Complex<f64>]) -> Vec<Complex<f64>> {
        let ([a, ai], [b, bi]) = ([real(a), imaginary(a)], [real(b), imaginary(b)]);
        let [rr, ii, ri, ir] = [(&a, &b), (&ai, &bi), (&a, &bi), (&ai, &b)].map(|(a, b)| self.bilinear(a, b));
        complex(a.len(), &|i| Complex::new(rr[i] - ii[i], ri[i] + ir[i]))
    }
}
