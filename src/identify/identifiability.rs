//! What the records fix, and what they do not.

use super::{
    Fit, IdentificationSpec,
    jacobian::{Normal, eigen},
};
use crate::error::{Code, Error, Result};

/// A direction is weak where going a third of the bounds' distance along it changes the forces by less than this part of
/// their root mean square.
const TELLS: f64 = 0.003;
const FAR: f64 = 1.0 / 3.0;
/// A gene that takes part in a weak direction by more than this (of 1 in all) is not fixed.
const TAKES_PART: f64 = 0.05;

/// What is known of the values that several seeds have found.
#[derive(Clone, Debug)]
pub struct Identifiability {
    /// Errors of what was given, in its order.
    pub errors: Vec<f64>,
    /// Which of it is best.
    pub best: usize,
    /// What was looked for.
    pub parameters: Vec<Spread>,
    /// Directions along which the forces hardly change, the weakest first.
    pub weak: Vec<Direction>,
    /// The best beside each record.
    pub fits: Vec<Fit>,
}

/// A parameter over several seeds.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// Its name.
    pub name: &'static str,
    /// Of the best.
    pub value: f64,
    /// Least and greatest of all.
    pub range: [f64; 2],
    /// Their distance in parts of the bounds', on the scale on which it is looked for.
    pub spread: f64,
    /// How far it goes at least, in the same parts, before the error grows to 1 % beside a perfect fit: the others follow as
    /// they fit best. 1 where the bounds alone hold it.
    pub slack: f64,
    /// The records fix it: it takes no part in a weak direction.
    pub fixed: bool,
}

/// A direction in the space of parameters, of length 1 in parts of the bounds' distances.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction {
    /// How much the forces change along it, in parts of their root mean square a bounds' distance.
    pub change: f64,
    /// By name, in the order of the table: what takes part by more than a twentieth.
    pub parts: Vec<(&'static str, f64)>,
}

impl IdentificationSpec {
    /// What the records fix: from the best of a population, usually what several seeds have found, by the forces' derivatives
    /// there, and from how far the population lies apart.
    ///
    /// A Bouc–Wen element has a direction that no record of forces can tell, whatever its noise: z → qz with α → α/q,
    /// A → qA, γ → q¹⁻ⁿγ and β → q¹⁻ⁿβ.
    ///
    /// # Errors
    /// Not a whole number of individuals, or none; a best that the model refuses.
    pub fn identifiability(&self, population: &[f64]) -> Result<Identifiability> {
        let individuals: Vec<&[f64]> = self.individuals(population)?.collect();
        let errors: Vec<f64> = individuals.iter().map(|values| self.error(values)).collect();
        let best = (0..errors.len()).min_by(|a, b| errors[*a].total_cmp(&errors[*b]));
        let Some(best) = best else {
            return Err(Error::new(Code::OutOfRange, "population", "none", "one individual at least"));
        };
        let fits = self.fits(individuals[best])?;
        let genes = self.units(individuals[best]);
        let normal = Normal::at(self, &genes).ok_or_else(|| Error::beyond_numbers("the force"))?;
        let pairs = eigen(&normal.matrix);
        let change = |value: f64| value.max(0.0).sqrt();
        let is_weak = |value: f64| change(value) * FAR < TELLS;
        let spread = |(i, gene): (usize, &super::gene::Gene)| {
            let values: Vec<f64> = individuals.iter().map(|values| values[gene.place]).collect();
            let range = [
                values.iter().copied().fold(f64::INFINITY, f64::min),
                values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ];
            let taken: f64 =
                pairs.iter().filter(|(value, _)| is_weak(*value)).map(|(_, vector)| vector[i] * vector[i]).sum();
            // The farthest point of the ellipsoid gᵀJᵀJg = 0.01² along this gene, none of its axes longer than the bounds.
            let along = |(value, vector): &(f64, Vec<f64>)| {
                let largest = vector.iter().fold(0.0, |most: f64, part| part.abs().max(most));
                vector[i] * (0.01 / change(*value)).min(1.0 / largest)
            };
            let reach = pairs.iter().map(|pair| along(pair).powi(2)).sum::<f64>().sqrt();
            Spread {
                name: gene.parameter.name,
                value: individuals[best][gene.place],
                range,
                spread: gene.unit(range[1]) - gene.unit(range[0]),
                slack: reach.min(1.0),
                fixed: taken < TAKES_PART,
            }
        };
        let direction = |(value, vector): &(f64, Vec<f64>)| {
            let parts = self.genes.iter().zip(vector).map(|(gene, part)| (gene.parameter.name, *part));
            Direction {
                change: change(*value),
                parts: parts.filter(|(_, part)| part * part > TAKES_PART * TAKES_PART).collect(),
            }
        };
        Ok(Identifiability {
            parameters: self.genes.iter().enumerate().map(spread).collect(),
            weak: pairs.iter().filter(|(value, _)| is_weak(*value)).map(direction).collect(),
            errors,
            best,
            fits,
        })
    }
}
