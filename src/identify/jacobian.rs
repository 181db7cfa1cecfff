//! How the forces change with the genes: for polishing, and for what the records do not fix.

use super::IdentificationSpec;
use crate::few::sort_few;

/// Step of the differences, in parts of a gene's range: small beside what matters, and far above rounding.
const STEP: f64 = 1e-6;

/// JᵀJ and Jᵀr of the relative residual r = (F̂ − F)/(√N rms F), whose length is the error.
pub(super) struct Normal {
    pub matrix: Vec<Vec<f64>>,
    pub slope: Vec<f64>,
}

impl Normal {
    /// At these genes; `None` where the model refuses them.
    pub fn at(spec: &IdentificationSpec, genes: &[f64]) -> Option<Self> {
        let forces = spec.forces(&spec.values(genes))?;
        let weight = 1.0 / (spec.size * (forces.len() as f64).sqrt());
        let measured = spec.records.iter().flat_map(|record| &record.force);
        let residual: Vec<f64> = forces.iter().zip(measured).map(|(a, b)| (a - b) * weight).collect();
        let column = |gene: usize| {
            let mut moved = genes.to_vec();
            let step = if genes[gene] + STEP > 1.0 { -STEP } else { STEP };
            moved[gene] += step;
            let there = spec.forces(&spec.values(&moved))?;
            Some(there.iter().zip(&forces).map(|(a, b)| (a - b) * weight / step).collect::<Vec<f64>>())
        };
        let columns: Vec<Vec<f64>> = (0..genes.len()).map(column).collect::<Option<_>>()?;
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        Some(Self {
            matrix: columns.iter().map(|a| columns.iter().map(|b| product(a, b)).collect()).collect(),
            slope: columns.iter().map(|column| product(column, &residual)).collect(),
        })
    }
}

/// Eigenvalues of a symmetric matrix by rising size, and their vectors: Jacobi's rotations.
///
/// # References
/// G. Golub, C. Van Loan, *Matrix Computations*, 8.5.
pub(super) fn eigen(matrix: &[Vec<f64>]) -> Vec<(f64, Vec<f64>)> {
    let n = matrix.len();
    let mut a = matrix.to_vec();
    let mut vectors: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..60 {
        let mut rotated = false;
        for p in 0..n {
            for q in p + 1..n {
                // Small beside both of its diagonals, and not only beside the largest: weak directions count here.
                if a[p][q].abs() <= 1e-15 * (a[p][p] * a[q][q]).abs().sqrt() || a[p][q] == 0.0 {
                    continue;
                }
                rotated = true;
                let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
                let c = 1.0 / t.hypot(1.0);
                let s = t * c;
                for k in 0..n {
                    (a[k][p], a[k][q]) = (c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]);
                }
                for k in 0..n {
                    (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
                }
                let [vp, vq] = vectors.get_disjoint_mut([p, q]).expect("two places");
                for (vp, vq) in vp.iter_mut().zip(vq) {
                    (*vp, *vq) = (c * *vp - s * *vq, s * *vp + c * *vq);
                }
            }
        }
        if !rotated {
            break;
        }
    }
    let mut pairs: Vec<(f64, Vec<f64>)> =
        vectors.into_iter().enumerate().map(|(i, vector)| (a[i][i], vector)).collect();
    sort_few(&mut pairs, |a, b| a.0 < b.0);
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    #[test]
    fn eigenvectors_are_what_the_matrix_stretches() {
        let mut random = Random::seeded(4);
        let n = 7;
        let b: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|_| random.normal() * 10_f64.powi(-(i as i32))).collect()).collect();
        let matrix: Vec<Vec<f64>> =
            (0..n).map(|i| (0..n).map(|j| b.iter().map(|row| row[i] * row[j]).sum()).collect()).collect();
        let pairs = eigen(&matrix);
        assert!(pairs.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        for (value, vector) in &pairs {
            assert!((vector.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-13);
            for i in 0..n {
                let image: f64 = (0..n).map(|j| matrix[i][j] * vector[j]).sum();
                assert!((image - value * vector[i]).abs() < 1e-13 * matrix[0][0].abs().max(1.0) * 10.0);
            }
        }
    }
}
