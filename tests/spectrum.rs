//! What a series is made of, for series that are known.
#![cfg(not(target_arch = "wasm32"))]

mod common;

use std::f64::consts::PI;

use common::random::Random;
use shimmy::{
    Run,
    run::Value,
    spectrum::{Series, Spectrum},
};

fn spectrum_of(values: Vec<f64>, interval: f64) -> Spectrum {
    Series::new(values, interval).unwrap().spectrum()
}

/// A sinusoid of `cycles` cycles over `n` values.
fn tone(n: usize, cycles: f64, amplitude: f64, phase: f64) -> Vec<f64> {
    (0..n).map(|i| amplitude * (2.0 * PI * cycles * i as f64 / n as f64 + phase).sin()).collect()
}

#[test]
fn a_sinusoid_shows_its_amplitude_at_its_frequency() {
    for n in [64, 100, 257, 4096, 6000] {
        // 1 ms apart, on a frequency: n/8 cycles, or what is near.
        let k = n / 8;
        let spectrum = spectrum_of(tone(n, k as f64, 0.3, 0.7), 1e-3);
        assert_eq!((spectrum.frequency.len(), spectrum.amplitude.len()), (n / 2 + 1, n / 2 + 1));
        assert!((spectrum.frequency[k] - k as f64 / (n as f64 * 1e-3)).abs() < 1e-9);
        assert!((spectrum.amplitude[k] - 0.3).abs() < 1e-13, "{n}: {}", spectrum.amplitude[k]);
        // Hann's window spreads to the neighbours, half as high, and no further.
        assert!((spectrum.amplitude[k + 1] - 0.15).abs() < 1e-13);
        assert!(spectrum.amplitude.iter().enumerate().all(|(i, a)| i.abs_diff(k) <= 1 || *a < 1e-13));
        let peak = spectrum.peak.unwrap();
        assert!((peak.frequency - spectrum.frequency[k]).abs() < 1e-9 && (peak.amplitude - 0.3).abs() < 1e-12);
    }
}

#[test]
fn a_peak_between_two_frequencies_is_found() {
    let mut random = Random::seeded(7);
    for _ in 0..500 {
        let n = random.between(128.0, 2000.0) as usize;
        let cycles = random.between(10.0, 0.45 * n as f64);
        let (amplitude, offset) = (random.between(0.01, 50.0), random.between(-100.0, 100.0));
        let interval = 10_f64.powf(random.between(-5.0, 1.0));
        let values = tone(n, cycles, amplitude, random.between(0.0, 2.0 * PI)).iter().map(|x| x + offset).collect();
        let peak = spectrum_of(values, interval).peak.unwrap();
        let place = peak.frequency * n as f64 * interval;
        // What is left is the mirror at −f, 20 and more spacings away, where the window has fallen as the cube.
        assert!((place - cycles).abs() < 1e-3, "{place} for {cycles} cycles in {n}");
        assert!((peak.amplitude / amplitude - 1.0).abs() < 1e-3, "{} for {amplitude}", peak.amplitude);
    }
    // With a few cycles only the mirror is near: still within two hundredths of a spacing.
    for cycles in [3.0, 3.3, 4.5, 5.7, 8.2] {
        for phase in [0.0, 0.8, 1.6] {
            let peak = spectrum_of(tone(400, cycles, 1.0, phase), 0.01).peak.unwrap();
            assert!((peak.frequency * 4.0 - cycles).abs() < 0.02, "{} for {cycles}", peak.frequency * 4.0);
        }
    }
}

/// Parseval: over whole cycles half the sum of the squared amplitudes is the mean square, 3/2 of it under Hann's window.
#[test]
fn energy_is_kept() {
    let n = 1000;
    let values: Vec<f64> = (0..n)
        .map(|i| tone(n, 50.0, 1.0, 0.3)[i] + tone(n, 150.0, 0.2, 1.0)[i] + tone(n, 333.0, 0.05, 2.0)[i])
        .collect();
    let mean_square = values.iter().map(|x| x * x).sum::<f64>() / n as f64;
    let sum: f64 = spectrum_of(values, 1.0).amplitude.iter().map(|a| 0.5 * a * a).sum();
    assert!((sum / (1.5 * mean_square) - 1.0).abs() < 1e-12);
}

#[test]
fn the_limit_cycle_has_its_known_frequency_and_only_odd_multiples() {
    // theory.md, section 3: v = 80, c = 10: 51.215 Hz, and the largest ψ is 0.39238 rad.
    let run = Run::of("torsional").unwrap().with("velocity", 80.0).unwrap().with("dampingConstant", 10.0).unwrap();
    let run = run.starting("torsionAngle", 0.3).unwrap().lasting(4.0).unwrap().sampled(8001.0).unwrap();
    let motion = run.simulate().unwrap();
    let late = motion.states[0][4001..].to_vec();
    let spectrum = spectrum_of(late, 5e-4);
    let peak = spectrum.peak.unwrap();
    assert!((peak.frequency - 51.215).abs() < 1e-3, "{}", peak.frequency);
    // The fundamental of a swing that is nearly a sinusoid.
    assert!((peak.amplitude / 0.392_38 - 1.0).abs() < 0.02, "{}", peak.amplitude);
    let near = |f: f64| {
        let close = spectrum.frequency.iter().zip(&spectrum.amplitude).filter(|(at, _)| (*at - f).abs() < 1.5);
        close.fold(0.0, |most: f64, (_, a)| most.max(*a))
    };
    let (second, third) = (near(2.0 * 51.215), near(3.0 * 51.215));
    assert!(third > 1e-4 && second < 1e-3 * third, "the model is odd: {second} {third}");
}

#[test]
fn what_does_not_swing_has_no_peak() {
    for values in [vec![0.0; 100], vec![3.7; 100], vec![1.0, 2.0], vec![1.0, 2.0, 1.0]] {
        let spectrum = spectrum_of(values, 0.1);
        assert_eq!(spectrum.peak, None);
        assert!(spectrum.amplitude.iter().all(|a| a.is_finite()));
    }
}

#[test]
fn sizes_do_not_matter() {
    for unit in [1e-300, 1e299] {
        let spectrum = spectrum_of(tone(200, 20.0, unit, 0.0), 1e-3);
        assert!((spectrum.amplitude[20] / unit - 1.0).abs() < 1e-12);
    }
}

#[test]
fn bad_series_are_refused() {
    let refused = |values: Vec<f64>, interval| Series::new(values, interval).unwrap_err();
    assert_eq!(refused(vec![1.0], 1.0).field, "values");
    assert_eq!(refused(vec![1.0; 65_537], 1.0).code.name(), "too-large");
    assert_eq!(refused(vec![1.0, f64::NAN], 1.0).to_string(), "values must be finite numbers, got NaN at index 1");
    assert_eq!(refused(vec![1.0, f64::MAX], 1.0).field, "values");
    for interval in [0.0, -1.0, f64::NAN, 1e-310] {
        assert_eq!(refused(vec![1.0, 2.0], interval).field, "interval");
    }
    let record = |entries: &[(&str, Value)]| {
        Value::Record(entries.iter().map(|(key, value)| ((*key).into(), value.clone())).collect())
    };
    let values = ("values", Value::Numbers(vec![1.0, 2.0]));
    assert!(Series::read(&record(&[values.clone(), ("interval", Value::Number(0.1))])).is_ok());
    assert_eq!(Series::read(&record(&[values])).unwrap_err().code.name(), "missing");
    assert_eq!(Series::read(&Value::Absent).unwrap_err().code.name(), "wrong-type");
}
