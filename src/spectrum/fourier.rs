//! The discrete Fourier transform of any length.

use std::f64::consts::PI;

/// Real and imaginary part.
pub(super) type Complex = [f64; 2];

/// Xₖ = Σ xᵢ e^(−2πi·ik/n), in place: Cooley–Tukey for powers of two, Bluestein's chirp for other lengths.
///
/// # References
/// J. W. Cooley, J. W. Tukey, *Math. Comp.* 19 (1965) 297–301; L. I. Bluestein, *IEEE Trans. Audio Electroacoust.* 18 (1970)
/// 451–455.
pub(super) fn transform(x: &mut [Complex]) {
    if x.len().is_power_of_two() {
        by_halves(x);
    } else {
        by_chirp(x);
    }
}

fn product(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

/// e^(−2πi·m/n).
fn turned(m: usize, n: usize) -> Complex {
    let (sine, cosine) = (-2.0 * PI * m as f64 / n as f64).sin_cos();
    [cosine, sine]
}

/// A power of two: sorted by reversed bits, then put together two by two.
fn by_halves(x: &mut [Complex]) {
    let n = x.len();
    let bits = n.trailing_zeros();
    for i in 1..n {
        let reversed = i.reverse_bits() >> (usize::BITS - bits);
        if i < reversed {
            x.swap(i, reversed);
        }
    }
    let turns: Vec<Complex> = (0..n / 2).map(|m| turned(m, n)).collect();
    let mut length = 2;
    while length <= n {
        let (half, stride) = (length / 2, n / length);
        for block in x.chunks_exact_mut(length) {
            let (low, high) = block.split_at_mut(half);
            for ((low, high), m) in low.iter_mut().zip(high).zip(0..) {
                let odd = product(*high, turns[m * stride]);
                (*low, *high) = ([low[0] + odd[0], low[1] + odd[1]], [low[0] - odd[0], low[1] - odd[1]]);
            }
        }
        length *= 2;
    }
}

/// Any length: with ik = (i² + k² − (k − i)²)/2 the sum is a convolution with the chirp e^(πi·j²/n), which two longer
/// transforms carry out.
fn by_chirp(x: &mut [Complex]) {
    let n = x.len();
    // The square modulo 2n, in whole numbers: the angle stays exact.
    let chirp: Vec<Complex> = (0..n as u64).map(|j| turned((j * j % (2 * n as u64)) as usize, 2 * n)).collect();
    let long = (2 * n - 1).next_power_of_two();
    let mut signal = vec![[0.0; 2]; long];
    let mut kernel = vec![[0.0; 2]; long];
    for j in 0..n {
        signal[j] = product(x[j], chirp[j]);
        kernel[j] = [chirp[j][0], -chirp[j][1]];
        kernel[(long - j) % long] = kernel[j];
    }
    by_halves(&mut signal);
    by_halves(&mut kernel);
    // The way back is the way there with the imaginary parts turned round.
    for (s, k) in signal.iter_mut().zip(&kernel) {
        let [re, im] = product(*s, *k);
        *s = [re, -im];
    }
    by_halves(&mut signal);
    for j in 0..n {
        let [re, im] = signal[j];
        x[j] = product([re / long as f64, -im / long as f64], chirp[j]);
    }
}

#[cfg(test)]
#[cfg(not(target_arch = "wasm32"))]
mod tests {
    use super::*;
    use rustfft::{FftPlanner, num_complex};

    #[test]
    fn agrees_with_rustfft_at_every_kind_of_length() {
        let mut planner = FftPlanner::new();
        for n in [2, 3, 4, 5, 7, 8, 30, 64, 97, 1000, 1024, 4099, 16_384, 65_535, 65_536] {
            let value = |i: usize| (0.37 * i as f64 * (1.0 + 0.1 * i as f64 / n as f64)).sin() + 0.3;
            let mut ours: Vec<Complex> = (0..n).map(|i| [value(i), 0.2 * value(i + 5)]).collect();
            let mut theirs: Vec<_> = ours.iter().map(|[re, im]| num_complex::Complex::new(*re, *im)).collect();
            transform(&mut ours);
            planner.plan_fft_forward(n).process(&mut theirs);
            let size = theirs.iter().fold(0.0, |most: f64, x| most.max(x.norm()));
            for (ours, theirs) in ours.iter().zip(&theirs) {
                // Rounding of some 3 · 17 additions at most.
                assert!((ours[0] - theirs.re).hypot(ours[1] - theirs.im) < 1e-14 * size, "{n}: {ours:?} {theirs}");
            }
        }
    }
}
