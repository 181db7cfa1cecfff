//! A generation from the one before.

use crate::random::Random;

/// Spread of children about their parents, and of mutants about themselves: the larger, the nearer (Deb's η).
const CROSSOVER: f64 = 10.0;
const MUTATION: f64 = 20.0;
/// How many pairs are crossed, and how many genes of a pair's.
const PAIRS_CROSSED: f64 = 0.9;
const GENES_CROSSED: f64 = 0.5;

/// Genes from 0 to 1, drawn anew: from each gene's range cut into as many parts as there are individuals, each part once
/// (a Latin hypercube).
pub(super) fn first(individuals: usize, genes: usize, random: &mut Random) -> Vec<Vec<f64>> {
    let mut population = vec![vec![0.0; genes]; individuals];
    for gene in 0..genes {
        let mut parts: Vec<usize> = (0..individuals).collect();
        for i in (1..individuals).rev() {
            parts.swap(i, random.below(i + 1));
        }
        for (individual, part) in population.iter_mut().zip(parts) {
            individual[gene] = (part as f64 + random.unit()) / individuals as f64;
        }
    }
    population
}

/// The next generation.
///
/// # Method
/// The two best live on. The others are children: parents win a tournament of two; simulated binary crossover and
/// polynomial mutation in their bounded forms.
///
/// # References
/// K. Deb, R. B. Agrawal, *Complex Systems* 9 (1995) 115–148; K. Deb, M. Goyal, *Computer Science and Informatics* 26 (1996)
/// 30–45.
pub(super) fn next(population: &[Vec<f64>], errors: &[f64], random: &mut Random) -> Vec<Vec<f64>> {
    let least = |but: Option<usize>| {
        let others = (0..errors.len()).filter(|i| Some(*i) != but);
        others.min_by(|a, b| errors[*a].total_cmp(&errors[*b]))
    };
    let best = least(None);
    let elite = best.into_iter().chain(least(best));
    let mut children: Vec<Vec<f64>> = elite.map(|one| population[one].clone()).collect();
    while children.len() < population.len() {
        let mut parent = || {
            let (a, b) = (random.below(population.len()), random.below(population.len()));
            population[if errors[a] <= errors[b] { a } else { b }].clone()
        };
        let mut pair = [parent(), parent()];
        cross(&mut pair, random);
        for mut child in pair {
            mutate(&mut child, random);
            if children.len() < population.len() {
                children.push(child);
            }
        }
    }
    children
}

fn cross([a, b]: &mut [Vec<f64>; 2], random: &mut Random) {
    if random.unit() >= PAIRS_CROSSED {
        return;
    }
    for (a, b) in a.iter_mut().zip(b) {
        let apart = (*a - *b).abs();
        if random.unit() >= GENES_CROSSED || apart < 1e-14 {
            continue;
        }
        let (low, high) = (a.min(*b), a.max(*b));
        let u = random.unit();
        let spread = |room: f64| {
            let alpha = 2.0 - (1.0 + 2.0 * room / apart).powf(-(CROSSOVER + 1.0));
            let power = 1.0 / (CROSSOVER + 1.0);
            if u * alpha <= 1.0 { (u * alpha).powf(power) } else { (1.0 / (2.0 - u * alpha)).powf(power) }
        };
        let middle = 0.5 * (low + high);
        let first = (middle - 0.5 * spread(low) * apart).clamp(0.0, 1.0);
        let second = (middle + 0.5 * spread(1.0 - high) * apart).clamp(0.0, 1.0);
        (*a, *b) = if random.unit() < 0.5 { (first, second) } else { (second, first) };
    }
}

fn mutate(child: &mut [f64], random: &mut Random) {
    let chance = 1.0 / child.len() as f64;
    for gene in child {
        if random.unit() >= chance {
            continue;
        }
        let u = random.unit();
        let power = 1.0 / (MUTATION + 1.0);
        let shift = if u < 0.5 {
            (2.0 * u + (1.0 - 2.0 * u) * (1.0 - *gene).powf(MUTATION + 1.0)).powf(power) - 1.0
        } else {
            1.0 - (2.0 * (1.0 - u) + (2.0 * u - 1.0) * gene.powf(MUTATION + 1.0)).powf(power)
        };
        *gene = (*gene + shift).clamp(0.0, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn children_stay_within_bounds_and_the_best_lives_on() {
        let mut random = Random::seeded(9);
        let mut population = first(40, 5, &mut random);
        for gene in 0..5 {
            let mut parts: Vec<usize> =
                population.iter().map(|individual| (individual[gene] * 40.0) as usize).collect();
            parts.sort_unstable();
            assert_eq!(parts, (0..40).collect::<Vec<_>>(), "a Latin hypercube");
        }
        // A bowl whose middle lies in a corner region: found by selection alone.
        let error = |individual: &Vec<f64>| individual.iter().map(|x| (x - 0.9).powi(2)).sum::<f64>();
        let mut best = f64::INFINITY;
        for _ in 0..100 {
            let errors: Vec<f64> = population.iter().map(error).collect();
            let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(least <= best);
            best = least;
            population = next(&population, &errors, &mut random);
            assert!(population.iter().flatten().all(|gene| (0.0..=1.0).contains(gene)));
        }
        assert!(best < 1e-4, "{best}");
    }

    #[test]
    fn crossing_keeps_the_middle_and_mutation_the_mean() {
        // Far from the bounds both are symmetric.
        let mut random = Random::seeded(2);
        let (mut middle, mut mean) = (0.0, 0.0);
        for _ in 0..20_000 {
            let mut pair = [vec![0.48], vec![0.52]];
            cross(&mut pair, &mut random);
            middle += (pair[0][0] + pair[1][0]) / 2.0 - 0.5;
            let mut child = vec![0.5];
            mutate(&mut child, &mut random);
            mean += child[0] - 0.5;
        }
        assert!((middle / 20_000.0).abs() < 1e-3 && (mean / 20_000.0).abs() < 2e-3, "{middle} {mean}");
    }
}
