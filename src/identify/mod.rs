//! A damper's values from records of its force: a genetic algorithm, and a polish at its end.
//!
//! The error of values is rms(F − F̂)/rms(F) of all records together. A parameter is a *gene* from 0 to 1 between its
//! bounds, logarithmic where it spans decades. A generation is *asked* for, its errors are found anywhere, and *told*:
//! workers can share it. All that is random comes from one seed: the same seed is the same way, step by step.
//!
//! The algorithm is our own. What crates of genetic algorithms bring is threads and random generators of the system, which
//! a module in a page has not, while a generation that is handed out and taken back, and replayed by its seed, is what they
//! lack; its operators are a hundred lines.
//!
//! # Example
//! ```
//! use shimmy::{identify::{Identification, IdentificationSpec, RecordSpec}, run::Value};
//!
//! let record = |entries: &[(&str, Value)]| Value::Record(entries.iter().map(|(k, v)| (k.to_string(), v.clone())).collect());
//! let damper = record(&[("model", Value::Text("bouc-wen".into()))]);
//! let measured = RecordSpec::read(&record(&[("damper", damper)]))?.record()?;
//! let numbers = |values: &[f64]| Value::Numbers(values.to_vec());
//! let measured = record(&[
//!     ("displacement", numbers(&measured.displacement)),
//!     ("force", numbers(&measured.force)),
//!     ("interval", Value::Number(measured.interval)),
//! ]);
//! let spec = record(&[("model", Value::Text("bouc-wen".into())), ("records", Value::Records(vec![measured]))]);
//! let mut identification = Identification::new(IdentificationSpec::read(&spec)?);
//! while !identification.done() {
//!     identification.step();
//! }
//! assert!(identification.best_error() < 0.005);
//! # Ok::<(), shimmy::Error>(())
//! ```

mod gene;
mod genetic;
mod identifiability;
mod jacobian;
mod polish;
mod record;
mod replay;
mod spec;

pub use identifiability::{Direction, Identifiability, Spread};
pub use record::{Record, RecordSpec, differentiated};
pub use spec::IdentificationSpec;

use self::polish::Polish;
use crate::{
    error::{Code, Error, Result, shown},
    random::Random,
};

/// A search that has become better by less than a thousandth in so many generations stagnates.
const STAGNATION: usize = 60;
const BETTER: f64 = 1e-3;

/// The forces of found values along a record.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The record's command.
    pub command: f64,
    /// rms(F − F̂)/rms(F) of this record.
    pub error: f64,
    /// F̂ \[N\]
    pub force: Vec<f64>,
}

/// An identification on its way.
#[derive(Clone, Debug)]
pub struct Identification {
    spec: IdentificationSpec,
    random: Random,
    population: Vec<Vec<f64>>,
    best: Vec<f64>,
    best_error: f64,
    /// The best and the mean error of every generation so far, and of every step of the polish.
    history: [Vec<f64>; 2],
    /// The generation that was better than the ones before by more than a thousandth, and its error.
    progress: (usize, f64),
    polish: Option<Polish>,
    done: bool,
}

impl Identification {
    /// Before its first generation.
    pub fn new(spec: IdentificationSpec) -> Self {
        let mut random = Random::seeded(spec.seed);
        let population = genetic::first(spec.population, spec.genes.len(), &mut random);
        let best = population[0].clone();
        Self {
            spec,
            random,
            population,
            best,
            best_error: f64::INFINITY,
            history: [Vec::new(), Vec::new()],
            progress: (0, f64::INFINITY),
            polish: None,
            done: false,
        }
    }

    /// What was asked.
    pub fn spec(&self) -> &IdentificationSpec {
        &self.spec
    }

    /// Nothing is left to do: all generations have been, or it stagnates, and the best is polished.
    pub fn done(&self) -> bool {
        self.done
    }

    /// The best is being polished: [`Identification::ask`] gives nobody.
    pub fn polishing(&self) -> bool {
        self.polish.is_some()
    }

    /// Generations so far, steps of the polish among them.
    pub fn generation(&self) -> usize {
        self.history[0].len()
    }

    /// The part that is done, 0 … 1.
    pub fn fraction(&self) -> f64 {
        if self.done { 1.0 } else { (self.generation() as f64 / (self.spec.generations + 1) as f64).min(0.99) }
    }

    /// The least error so far; infinite before the first generation.
    pub fn best_error(&self) -> f64 {
        self.best_error
    }

    /// The values that have it, in table order.
    pub fn best(&self) -> Vec<f64> {
        self.spec.values(&self.best)
    }

    /// Best and mean errors, generation by generation.
    pub fn history(&self) -> &[Vec<f64>; 2] {
        &self.history
    }

    /// The generation whose errors are wanted next: as many values an individual as the model has parameters, in table order,
    /// one individual after the other. Nobody where it is polishing or done: then an empty list is to be told.
    pub fn ask(&self) -> Vec<f64> {
        if self.done || self.polishing() {
            return Vec::new();
        }
        self.population.iter().flat_map(|genes| self.spec.values(genes)).collect()
    }

    /// Goes on by a generation whose errors are these, or by a step of the polish.
    ///
    /// # Errors
    /// Not one number an individual of [`Identification::ask`].
    pub fn tell(&mut self, errors: &[f64]) -> Result<()> {
        let wanted = if self.done || self.polishing() { 0 } else { self.population.len() };
        if errors.len() != wanted {
            let got = format!("{} numbers", errors.len());
            return Err(Error::new(Code::OutOfRange, "errors", got, format!("{wanted} numbers, one an individual")));
        }
        if let Some(wrong) = errors.iter().find(|error| error.is_nan() || **error < 0.0) {
            return Err(Error::new(Code::OutOfRange, "errors", shown(*wrong), "numbers ≥ 0"));
        }
        if self.done {
            return Ok(());
        }
        if let Some(polish) = &mut self.polish {
            polish.step(&self.spec);
            (self.best, self.best_error, self.done) = (polish.genes.clone(), polish.error, polish.done);
            self.note(self.best_error);
            return Ok(());
        }
        self.breed(errors);
        Ok(())
    }

    fn breed(&mut self, errors: &[f64]) {
        for (genes, error) in self.population.iter().zip(errors) {
            if *error < self.best_error {
                (self.best, self.best_error) = (genes.clone(), *error);
            }
        }
        // Of those that are hopeless there is no mean to speak of.
        let hopeful: Vec<f64> = errors.iter().copied().filter(|error| *error < spec::HOPELESS).collect();
        self.note(hopeful.iter().sum::<f64>() / hopeful.len().max(1) as f64);
        let generation = self.generation();
        if self.best_error < (1.0 - BETTER) * self.progress.1 {
            self.progress = (generation, self.best_error);
        }
        if generation >= self.spec.generations || generation - self.progress.0 >= STAGNATION {
            let polish = self.spec.polish && self.best_error < spec::HOPELESS;
            self.polish = polish.then(|| Polish::new(self.best.clone(), self.best_error));
            self.done = !polish;
            return;
        }
        self.population = genetic::next(&self.population, errors, &mut self.random);
    }

    fn note(&mut self, mean: f64) {
        self.history[0].push(self.best_error);
        self.history[1].push(mean);
    }

    /// As [`Identification::step`], as jobs call it.
    ///
    /// # Errors
    /// None.
    pub fn advance(&mut self) -> Result<()> {
        self.step();
        Ok(())
    }

    /// A generation, or a step of the polish: [`Identification::ask`], the errors, [`Identification::tell`].
    pub fn step(&mut self) {
        let errors: Vec<f64> = if self.done || self.polishing() {
            Vec::new()
        } else {
            self.population.iter().map(|genes| self.spec.error(&self.spec.values(genes))).collect()
        };
        // As many errors as individuals, and none of them NaN.
        let _ = self.tell(&errors);
    }
}
