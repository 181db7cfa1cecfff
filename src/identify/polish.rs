//! The best, made better: Levenberg's and Marquardt's steps.

use super::{
    IdentificationSpec,
    jacobian::{Normal, eigen},
};

/// Most steps.
const MOST: usize = 60;
/// A step that makes it better by less than this part ends it.
const ENOUGH: f64 = 1e-7;

/// Levenberg and Marquardt on the genes, one step at a time.
///
/// # Method
/// Minimises |r(g) + J d|² + λ|d|² over the genes' steps d, λ falling with success and rising with failure. The genes are
/// scaled already, so that λ treats them alike, and directions that the records do not tell stay where they are. What a
/// step would carry over a bound stays on it: genes there that would leave are held.
#[derive(Clone, Debug)]
pub(super) struct Polish {
    pub genes: Vec<f64>,
    pub error: f64,
    pub done: bool,
    lambda: f64,
    steps: usize,
}

impl Polish {
    pub fn new(genes: Vec<f64>, error: f64) -> Self {
        Self { genes, error, done: false, lambda: 1e-3, steps: 0 }
    }

    /// A step to where it is better, or the end.
    pub fn step(&mut self, spec: &IdentificationSpec) {
        self.steps += 1;
        let Some(normal) = Normal::at(spec, &self.genes) else {
            self.done = true;
            return;
        };
        let free: Vec<usize> = (0..self.genes.len())
            .filter(|&i| {
                !(self.genes[i] <= 0.0 && normal.slope[i] > 0.0 || self.genes[i] >= 1.0 && normal.slope[i] < 0.0)
            })
            .collect();
        let matrix: Vec<Vec<f64>> = free.iter().map(|i| free.iter().map(|j| normal.matrix[*i][*j]).collect()).collect();
        let pairs = eigen(&matrix);
        for _ in 0..12 {
            let mut trial = self.genes.clone();
            for (value, vector) in &pairs {
                let along: f64 = free.iter().zip(vector).map(|(i, v)| normal.slope[*i] * v).sum();
                for (i, v) in free.iter().zip(vector) {
                    trial[*i] -= v * along / (value.max(0.0) + self.lambda);
                }
            }
            trial.iter_mut().for_each(|gene| *gene = gene.clamp(0.0, 1.0));
            let error = spec.error(&spec.values(&trial));
            if error < self.error {
                self.done = error > (1.0 - ENOUGH) * self.error || self.steps >= MOST;
                (self.genes, self.error) = (trial, error);
                self.lambda *= 0.1;
                return;
            }
            self.lambda = self.lambda.max(1e-12) * 5.0;
        }
        self.done = true;
    }
}
