//! The step-size controller.

/// Smallest and largest factor from one step to the next.
const SHRINK: f64 = 0.2;
const GROW: f64 = 6.0;

/// An error smaller than 10⁻⁴ of the tolerance is remembered as that: log₂ 10⁻⁴.
const LEAST_REMEMBERED: f64 = -13.287_712;

/// A PI controller: h ← h · safety · err^(−exponent) · err_before^β.
///
/// K. Gustafsson, *ACM TOMS* 17 (1991) 533–554; E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential
/// Equations I*, II.4 and IV.2. The powers are approximate (see [`power`]): a controller needs no more, and the same bits
/// come out on every machine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Controller {
    exponent: f64,
    beta: f64,
    safety: f64,
    /// log₂ of the error of the step before.
    log_before: f64,
    rejected: bool,
}

impl Controller {
    /// For a method whose error estimate falls with the `order`-th power of the step.
    pub fn new(order: f64, beta: f64, safety: f64) -> Self {
        Self { exponent: 1.0 / order - 0.75 * beta, beta, safety, log_before: LEAST_REMEMBERED, rejected: false }
    }

    /// Factor for the next step after one that was accepted with `error` ≤ 1.
    #[inline(always)]
    pub fn accepted(&mut self, error: f64) -> f64 {
        let log_error = log2(if error > 1e-10 { error } else { 1e-10 });
        let factor = self.safety * exp2(self.beta * self.log_before - self.exponent * log_error);
        self.log_before = if log_error > LEAST_REMEMBERED { log_error } else { LEAST_REMEMBERED };
        let most = if self.rejected { 1.0 } else { GROW };
        self.rejected = false;
        // Comparisons, as `clamp` and `max` must also mind NaN and cost more than the powers.
        if factor < SHRINK {
            SHRINK
        } else if factor > most {
            most
        } else {
            factor
        }
    }

    /// The memory of this controller with the settings of another.
    pub fn like(self, settings: Self) -> Self {
        Self { log_before: self.log_before, rejected: self.rejected, ..settings }
    }

    /// Writes or reads what is remembered. False where what was read makes no sense.
    pub fn code(&mut self, codec: &mut dyn crate::live::Codec) -> bool {
        let mut rejected = u64::from(self.rejected);
        codec.number(&mut self.log_before);
        codec.bits(&mut rejected);
        self.rejected = rejected != 0;
        (LEAST_REMEMBERED..=0.1).contains(&self.log_before)
    }

    /// Factor for another try after one with `error` > 1 (or not a number).
    pub fn rejected(&mut self, error: f64) -> f64 {
        self.rejected = true;
        if error.is_finite() { (self.safety * power(error, -self.exponent)).clamp(SHRINK, 0.9) } else { SHRINK }
    }
}

/// x^p for x > 0 to about 1 %: the exponent of the number's bits is its logarithm but for the mantissa.
///
/// `powf` costs as much as three right-hand sides, twice a step.
#[inline(always)]
pub(super) fn power(x: f64, p: f64) -> f64 {
    exp2(p * log2(x))
}

#[inline(always)]
fn log2(x: f64) -> f64 {
    let bits = x.to_bits();
    let exponent = (bits >> 52) as f64 - 1023.0;
    let mantissa = f64::from_bits(bits & 0x000f_ffff_ffff_ffff | 0x3ff0_0000_0000_0000);
    // log₂ m ≈ (m − 1)(1 + (2 − m)·0.3441): exact at 1 and 2, error below 0.008 between.
    exponent + (mantissa - 1.0) * (1.0 + (2.0 - mantissa) * 0.344_1)
}

#[inline(always)]
fn exp2(x: f64) -> f64 {
    // Adding 1023 makes it positive, and truncation of a positive number is its floor.
    let biased = (if x.abs() < 1000.0 { x + 1023.0 } else { 1023.0 + 1000.0_f64.copysign(x) }) as u64;
    let part = x - (biased as f64 - 1023.0);
    // 2^p ≈ 1 + p − 0.3431 p (1 − p): exact at 0 and 1, error below 0.003 between.
    let mantissa = 1.0 + part - 0.343_1 * part * (1.0 - part);
    f64::from_bits(biased << 52) * mantissa
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_is_within_one_percent_over_the_controllers_range() {
        for i in -400..=400 {
            let x = 10_f64.powf(i as f64 / 20.0);
            for p in [-0.2, -0.17, -0.125, -0.1, 0.02, 0.04, 0.08] {
                let ratio = power(x, p) / x.powf(p);
                assert!((ratio - 1.0).abs() < 0.01, "{x:e}^{p}: {ratio}");
            }
        }
    }

    #[test]
    fn factors_are_bounded_and_do_not_grow_after_a_rejection() {
        let mut controller = Controller::new(5.0, 0.04, 0.9);
        assert_eq!(controller.accepted(0.0), GROW);
        assert_eq!(controller.rejected(1e300), SHRINK);
        assert_eq!(controller.rejected(f64::NAN), SHRINK);
        assert!(controller.accepted(1e-9) <= 1.0);
        assert!(controller.accepted(1e-9) > 1.0);
    }
}
