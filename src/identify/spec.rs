//! What is asked of an identification.

use super::{
    Fit, Identification,
    gene::Gene,
    record::{MOST, Record, rms, seed},
    replay::replay,
};
use crate::{
    element::damper::{Description, named},
    error::{Code, Error, Result, shown},
    run::{Fields, Value},
    stability::whole,
};

/// Most individuals of a generation.
const MOST_INDIVIDUALS: usize = 10_000;
/// Parameters that stay at their defaults where no bounds ask for them: the form of the model, and what no record at
/// steady commands can tell.
const HELD: [&str; 3] = ["exponent", "commandRate", "forceScale"];
/// Error of values with which the model has no meaning.
pub(super) const HOPELESS: f64 = 1e6;

/// A damper model, records, and how to look for its values.
#[derive(Clone, Debug)]
pub struct IdentificationSpec {
    /// The model.
    pub damper: &'static Description,
    /// What was measured.
    pub records: Vec<Record>,
    /// Values of all parameters in table order; those that are looked for have another one in every individual.
    pub(super) base: Vec<f64>,
    /// What is looked for.
    pub(super) genes: Vec<Gene>,
    /// Individuals of a generation.
    pub population: usize,
    /// Generations at most.
    pub generations: usize,
    /// Of all that is random.
    pub seed: u64,
    /// The best is polished at the end.
    pub polish: bool,
    /// Root mean square of all forces.
    pub(super) size: f64,
}

impl IdentificationSpec {
    /// Reads a record `{model, records, bounds, population, generations, seed, polish}`. `bounds` are `{name: [low, high]}`;
    /// a parameter without takes its table's, but for `exponent`, `commandRate` and `forceScale`, which then stay at their
    /// defaults. Equal bounds hold a parameter.
    ///
    /// # Errors
    /// Anything but known keys with valid values; the error names the field.
    pub fn read(input: &Value) -> Result<Self> {
        let keys = ["model", "records", "bounds", "population", "generations", "seed", "polish"];
        let fields = Fields::of("identification", input, &keys)?;
        let missing = || Error::missing("model", "the name of a damper, such as bouc-wen");
        let damper = named(fields.text("model")?.ok_or_else(missing)?)?;
        let records = records(&fields, damper)?;
        let (base, genes) = genes(&fields, damper)?;
        let forces: Vec<f64> = records.iter().flat_map(|record| record.force.iter().copied()).collect();
        Ok(Self {
            damper,
            records,
            base,
            genes,
            population: whole(&fields, "population", [4, MOST_INDIVIDUALS])?.unwrap_or(60),
            generations: whole(&fields, "generations", [1, 1_000_000])?.unwrap_or(500),
            seed: seed(&fields)?,
            polish: fields.truth("polish")?.unwrap_or(true),
            size: rms(&forces),
        })
    }

    /// Before its first generation.
    pub fn begin(self) -> Identification {
        Identification::new(self)
    }

    /// As the records and genes of this one, in another way.
    #[must_use]
    pub fn seeded(&self, seed: u64) -> Self {
        Self { seed, ..self.clone() }
    }

    /// Names of the parameters that are looked for.
    pub fn names(&self) -> Vec<&'static str> {
        self.genes.iter().map(|gene| gene.parameter.name).collect()
    }

    /// Values of all parameters in table order for genes from 0 to 1.
    pub(super) fn values(&self, genes: &[f64]) -> Vec<f64> {
        let mut values = self.base.clone();
        for (gene, unit) in self.genes.iter().zip(genes) {
            values[gene.place] = gene.value(*unit);
        }
        values
    }

    /// The genes of values in table order.
    pub(super) fn units(&self, values: &[f64]) -> Vec<f64> {
        self.genes.iter().map(|gene| gene.unit(values[gene.place])).collect()
    }

    /// How well values in table order explain the records: rms(F − F̂)/rms(F) of all records together. Values that the model
    /// refuses, or that leave the numbers, have an error of 10⁶.
    pub fn error(&self, values: &[f64]) -> f64 {
        let Ok(damper) = self.damper.damper(values) else { return HOPELESS };
        let (mut sum, mut count) = (0.0, 0);
        let mut forces = Vec::with_capacity(self.records.iter().map(Record::len).max().unwrap_or(0));
        for record in &self.records {
            forces.clear();
            replay(&damper, record, &mut forces);
            for (force, measured) in forces.iter().zip(&record.force) {
                sum += (force - measured) * (force - measured);
            }
            count += record.len();
        }
        let error = (sum / count as f64).sqrt() / self.size;
        if error < HOPELESS { error } else { HOPELESS }
    }

    /// F̂ at every sample of all records, one after the other; `None` where the model refuses the values.
    pub(super) fn forces(&self, values: &[f64]) -> Option<Vec<f64>> {
        let damper = self.damper.damper(values).ok()?;
        let mut forces = Vec::new();
        for record in &self.records {
            replay(&damper, record, &mut forces);
        }
        forces.iter().all(|force| force.is_finite()).then_some(forces)
    }

    /// The errors of a population: as many values an individual as the model has parameters, in table order, one individual
    /// after the other.
    ///
    /// # Errors
    /// Not a whole number of individuals.
    pub fn fitness(&self, population: &[f64]) -> Result<Vec<f64>> {
        Ok(self.individuals(population)?.map(|values| self.error(values)).collect())
    }

    pub(super) fn individuals<'a>(&self, population: &'a [f64]) -> Result<std::slice::ChunksExact<'a, f64>> {
        let width = self.base.len();
        if !population.len().is_multiple_of(width) {
            let (got, allowed) = (format!("{} numbers", population.len()), format!("{width} an individual"));
            return Err(Error::new(Code::OutOfRange, "population", got, allowed));
        }
        Ok(population.chunks_exact(width))
    }

    /// The error of each record by itself, in parts of its own force, and the forces along it.
    ///
    /// # Errors
    /// Values that the model refuses.
    pub fn fits(&self, values: &[f64]) -> Result<Vec<Fit>> {
        let damper = self.damper.damper(values)?;
        let fit = |record: &Record| {
            let mut force = Vec::with_capacity(record.len());
            replay(&damper, record, &mut force);
            Error::unless_finite("force", &force)?;
            let off: Vec<f64> = force.iter().zip(&record.force).map(|(a, b)| a - b).collect();
            Ok(Fit { command: record.command, error: rms(&off) / rms(&record.force), force })
        };
        self.records.iter().map(fit).collect()
    }
}

fn records(fields: &Fields, damper: &Description) -> Result<Vec<Record>> {
    let allowed = "a list of records {displacement, velocity, force, command, interval}";
    let given = match fields.value("records") {
        None => return Err(Error::missing("records", allowed)),
        Some(Value::Records(records)) if !records.is_empty() => records.as_slice(),
        Some(other) => return Err(Error::new(Code::WrongType, "records", other.shown(), allowed)),
    };
    let mut records = Vec::with_capacity(given.len());
    for (i, record) in given.iter().enumerate() {
        let read = Record::read(record, damper);
        let place = format!("records[{i}]");
        records.push(
            read.map_err(|error| if error.field == "record" { error.called(&place) } else { error.within(&place) })?,
        );
    }
    let samples: usize = records.iter().map(Record::len).sum();
    if samples > MOST {
        let (got, allowed) = (format!("{samples} samples"), format!("at most {} in all", shown(MOST as f64)));
        return Err(Error::new(Code::TooLarge, "records", got, allowed));
    }
    Ok(records)
}

fn genes(fields: &Fields, damper: &'static Description) -> Result<(Vec<f64>, Vec<Gene>)> {
    let mut base = damper.defaults();
    let nothing = Value::Record(Vec::new());
    let known: Vec<_> = damper.parameters.iter().map(|parameter| parameter.name).collect();
    let bounds = Fields::of("bounds", fields.value("bounds").unwrap_or(&nothing), &known)?;
    let mut genes = Vec::new();
    for (place, parameter) in damper.parameters.iter().enumerate() {
        let (low, high) = match bounds.numbers(parameter.name)? {
            None if HELD.contains(&parameter.name) => continue,
            None => (parameter.min, parameter.max),
            Some(ends) => {
                let wrong = |value: String| {
                    let allowed = "two valid values, the lower one first";
                    Error::new(Code::OutOfRange, parameter.name, value, allowed).within("bounds")
                };
                let &[low, high] = ends.as_slice() else { return Err(wrong(format!("{} numbers", ends.len()))) };
                for end in [low, high] {
                    parameter.check(end).map_err(|error| error.within("bounds"))?;
                }
                if low > high {
                    return Err(wrong(format!("{} and {}", shown(low), shown(high))));
                }
                (low, high)
            }
        };
        base[place] = low;
        if low < high {
            genes.push(Gene::new(parameter, place, low, high));
        }
    }
    if genes.is_empty() {
        return Err(Error::new(Code::OutOfRange, "bounds", "all held", "such that a parameter is left to look for"));
    }
    Ok((base, genes))
}
