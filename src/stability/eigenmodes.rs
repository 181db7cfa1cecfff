//! What a gear does at an eigenvalue: how its states swing together, and where the swing's energy comes from.

use std::f64::consts::{LN_2, TAU};

use super::{
    eigenvalues::{balance, eigenvalues},
    elimination::Triangle,
};
use crate::{
    error::{Error, Result},
    model::laws::Laws,
    parameter::StateVariable,
};
use nalgebra::{Complex, DMatrix};

/// A state that is smaller than this part of the largest, each measured by its typical size, takes no part in the motion.
const ABSENT: f64 = 1e-9;
/// An eigenvalue that is smaller than this part of the largest may be zero.
const STILL: f64 = 1e-13;

/// One motion x(t) = Re(z e^{λt}) of the linearised equations.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenmode {
    /// λ \[1/s\].
    pub eigenvalue: Complex<f64>,
    /// −Re λ/|λ|: 1 fades without a swing, 0 swings for ever, below 0 grows; none where λ = 0.
    pub damping_ratio: Option<f64>,
    /// |λ|/2π \[Hz\].
    pub natural_frequency: f64,
    /// ln 2/−Re λ where it fades \[s\].
    pub time_to_half: Option<f64>,
    /// ln 2/Re λ where it grows \[s\].
    pub time_to_double: Option<f64>,
    /// Which state is 1 in `shape`: the first, or the largest where the first takes no part.
    pub reference: usize,
    /// z, in the order of the state table: |z| is the amplitude and arg z the lead of each state, measured by the reference.
    pub shape: Vec<Complex<f64>>,
    /// Where its energy comes from; none where the model has no force laws or the gear does not turn.
    pub energy_flow: Option<EnergyFlow>,
}

/// The energy that goes through a mode's steering motion in one cycle, each part as a rate of growth \[1/s\]: `tire` =
/// `damper` + `tread_width` + `fitted` + `stored`, and `stored` = Re λ.
///
/// # Equations
/// With ψ = Re(Ψ e^{λt}) every moment about the axis is M = Re(μ e^{λt}), and its power Mψ̇, meaned over the phase of the
/// swing, is ½ Re(μ λ̄Ψ̄) e^{2 Re λ t}. The energy ½I_zψ̇² + ½kψ², meaned likewise, is
/// E = ¼(I_z|λ|² + k)|Ψ|² e^{2 Re λ t}, and rises by 2 Re λ E. What raises it is the power of all moments but the spring's:
///
/// ```text
/// 2 Re λ E = P_tire + P_damper + P_tread,   so that
/// Re λ = P_tire/2E + P_damper/2E + P_tread/2E
/// ```
///
/// Each part here is its mean power over twice the mean energy; damper and tread width count what they take out, as in
/// [`crate::energy::Energy`]. Of a real eigenvalue nothing needs to be meaned, and the same holds at every instant.
///
/// The power of a linear law and the energy are quadratic in the state, and the mean of a quadratic form over the phase is
/// half the sum of its values at Re z and at Im z: so the laws' own accounts of power and energy are asked at these two.
///
/// # Limits
/// With freeplay the gear swings in its gap: k = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyFlow {
    /// Fed in by the tire.
    pub tire: f64,
    /// Taken by the damper.
    pub damper: f64,
    /// Taken by the width of the tread.
    pub tread_width: f64,
    /// Taken by a damper on the gear: what its springs store within a cycle comes back.
    pub fitted: f64,
    /// Stored in the wheel's turning.
    pub kinetic: f64,
    /// Stored in the spring.
    pub spring: f64,
    /// `kinetic` + `spring`.
    pub stored: f64,
}

impl Eigenmode {
    /// One mode for each eigenvalue of a Jacobian, in their order. Of a multiple eigenvalue all are the same.
    ///
    /// # Errors
    /// A matrix so extreme that they leave the numbers.
    pub(crate) fn all(jacobian: &DMatrix<f64>, states: &[StateVariable], laws: Option<Laws>) -> Result<Vec<Self>> {
        let size = jacobian.iter().fold(f64::MIN_POSITIVE, |most, entry| most.max(entry.abs()));
        let mut balanced = jacobian.map(|entry| entry / size);
        let sizes = balance(&mut balanced);
        let laws = laws.map(|laws| laws.linearised());
        let values = eigenvalues(jacobian)?;
        let still = STILL * values.iter().fold(0.0, |most: f64, value| most.max(value.norm()));
        let mut modes: Vec<Self> = Vec::with_capacity(values.len());
        for eigenvalue in values {
            let mode = match modes.last() {
                // The other one of a pair.
                Some(first) if eigenvalue.im < 0.0 => {
                    Self { eigenvalue, shape: first.shape.iter().map(Complex::conj).collect(), ..first.clone() }
                }
                _ => {
                    let shift = Complex::new(eigenvalue.re / size, eigenvalue.im / size);
                    let vector = eigenvector(&balanced, shift);
                    let shape = vector.iter().zip(&sizes).map(|(part, size)| part * *size).collect();
                    Self::of(
                        eigenvalue,
                        shape,
                        states,
                        laws.filter(|laws| {
                            // A wheel that nothing turns back stands anywhere, without energy.
                            laws.stiffness > 0.0 || eigenvalue.norm() > still
                        }),
                    )?
                }
            };
            modes.push(mode);
        }
        Ok(modes)
    }

    fn of(
        eigenvalue: Complex<f64>,
        mut shape: Vec<Complex<f64>>,
        states: &[StateVariable],
        laws: Option<Laws>,
    ) -> Result<Self> {
        let measured: Vec<f64> = shape.iter().zip(states).map(|(part, state)| part.norm() / state.scale).collect();
        let most = (0..shape.len()).fold(0, |most, i| if measured[i] > measured[most] { i } else { most });
        let reference = if measured[0] > ABSENT * measured[most] { 0 } else { most };
        let one = shape[reference];
        for (i, part) in shape.iter_mut().enumerate() {
            *part = if i == reference { 1.0.into() } else { *part / one };
        }
        let (growth, size) = (eigenvalue.re, eigenvalue.norm());
        let time = |rate: f64| Some(LN_2 / rate).filter(|time| rate > 0.0 && time.is_finite());
        let energy_flow = laws.filter(|_| reference == 0).map(|laws| EnergyFlow::of(growth, &shape, &laws));
        let parts = shape.iter().flat_map(|part| [part.re, part.im]);
        let flows =
            energy_flow.iter().flat_map(|flow| [flow.tire, flow.damper, flow.tread_width, flow.fitted, flow.stored]);
        if parts.chain(flows).chain([size]).any(|part| !part.is_finite()) {
            return Err(Error::beyond_numbers("the modes"));
        }
        Ok(Self {
            eigenvalue,
            damping_ratio: (size > 0.0).then(|| -growth / size),
            natural_frequency: size / TAU,
            time_to_half: time(-growth),
            time_to_double: time(growth),
            reference,
            shape,
            energy_flow,
        })
    }
}

impl EnergyFlow {
    /// Of a shape in which ψ is 1, and which has energy.
    fn of(growth: f64, shape: &[Complex<f64>], laws: &Laws) -> Self {
        let parts: [Vec<f64>; 2] =
            [shape.iter().map(|part| part.re).collect(), shape.iter().map(|part| part.im).collect()];
        let [(kinetic, spring), (more_kinetic, more_spring)] = parts.each_ref().map(|x| laws.stored(x));
        let (kinetic, spring) = (kinetic + more_kinetic, spring + more_spring);
        let energy = kinetic + spring;
        let [power, more] = parts.each_ref().map(|x| laws.power(x));
        let rate = |power: f64| power / (2.0 * energy);
        let (kinetic, spring) = (growth * (kinetic / energy), growth * (spring / energy));
        Self {
            tire: rate(power.tire + more.tire),
            damper: rate(power.damper + more.damper),
            tread_width: rate(power.tread_width + more.tread_width),
            fitted: rate(power.fitted + more.fitted),
            kinetic,
            spring,
            stored: kinetic + spring,
        }
    }
}

/// A direction that `matrix` turns into `eigenvalue` times itself, by inverse iteration.
fn eigenvector(matrix: &DMatrix<f64>, eigenvalue: Complex<f64>) -> Vec<Complex<f64>> {
    // Any start that is not by some symmetry without a share in the direction.
    let mut vector: Vec<Complex<f64>> =
        (0..matrix.nrows()).map(|i| Complex::new(1.0, 0.3) / (i as f64 + 1.7)).collect();
    for _ in 0..3 {
        vector = Triangle::of(matrix, eigenvalue, &vector).solution(f64::EPSILON);
        let most = vector.iter().fold(0.0, |most: f64, part| most.max(part.norm()));
        vector.iter_mut().for_each(|part| *part = Complex::new(part.re / most, part.im / most));
    }
    vector
}
