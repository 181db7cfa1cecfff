//! Planes of two parameters at random, and the eigenvalues in them.

use nalgebra::{Complex, Matrix3};
use shimmy::{
    Run,
    model::{Model, System, Torsional},
    parameter::Parameter,
    real::Dual,
    stability::{CurveKind, EndKind, HopfCurve, Links, Plane, Variation},
};

use super::random::Random;

/// Both links at work.
pub const LINKED: Links = Links { relaxation_length: true, tread_width_moment_constant: true };

/// A gear with these values, in the order of its table.
pub fn run_with<M: Model<3>>(values: &[f64]) -> Run {
    M::PARAMETERS
        .iter()
        .zip(values)
        .fold(Run::of(M::NAME).unwrap(), |run, (p, value)| run.with(p.name, *value).unwrap())
}

/// The eigenvalues at rest, from the right-hand side by dual numbers: nothing of the closed form is in it.
pub fn eigenvalues<M: Model<3>>(values: &[f64]) -> [Complex<f64>; 3] {
    let system = M::new(values);
    let at_rest = std::array::from_fn(|i| Dual::<3>::variable(0.0, i));
    let rates = system.rate(Dual::from(0.0), system.mode(0.0, &[0.0; 3]), &at_rest);
    Matrix3::from_fn(|row, column| rates[row].slope[column]).complex_eigenvalues().into()
}

/// Within the sliders' ranges; a third of the gears has freeplay.
pub fn random_values(random: &mut Random, table: &[Parameter]) -> Vec<f64> {
    let value = |parameter: &Parameter| match parameter.name {
        "freeplayAngle" if !random.once_in(3) => 0.0,
        _ if random.once_in(20) => parameter.min,
        _ => random.between(parameter.min, parameter.max),
    };
    table.iter().map(value).collect()
}

/// Two parameters of a table, each with a part of its range, or all of it.
pub fn random_axes(random: &mut Random, table: &[Parameter]) -> [(&'static str, f64, f64); 2] {
    let first = random.between(0.0, table.len() as f64) as usize;
    let second = (first + 1 + random.between(0.0, (table.len() - 1) as f64) as usize) % table.len();
    [first, second].map(|index| {
        let Parameter { name, min, max, .. } = table[index];
        let (a, b) = (random.between(min, max), random.between(min, max));
        if random.once_in(2) { (name, min, max) } else { (name, a.min(b), a.max(b)) }
    })
}

/// σ = 3a and κ = 0.15 a² c_Fα F_z, where what they follow varies and they do not.
pub fn link<M: Model<3>>(values: &mut [f64], links: Links, varying: [&str; 2]) {
    let place = |name: &str| M::PARAMETERS.iter().position(|p| p.name == name).unwrap();
    let a = values[place("halfContactLength")];
    if links.relaxation_length && varying.contains(&"halfContactLength") && !varying.contains(&"relaxationLength") {
        values[place("relaxationLength")] = 3.0 * a;
    }
    let moving =
        ["halfContactLength", "sideForceDerivative", "verticalForce"].iter().any(|name| varying.contains(name));
    if links.tread_width_moment_constant && moving && !varying.contains(&"treadWidthMomentConstant") {
        values[place("treadWidthMomentConstant")] =
            0.15 * a * a * values[place("sideForceDerivative")] * values[place("verticalForce")];
    }
}

/// A plane of the torsional gear with these values.
pub struct Case {
    pub values: Vec<f64>,
    pub axes: [(&'static str, f64, f64); 2],
    pub links: Links,
    pub plane: Plane,
}

impl Case {
    pub fn of(values: Vec<f64>, axes: [(&'static str, f64, f64); 2], links: Links) -> Self {
        let plane = Plane::of(&run_with::<Torsional>(&values), axes[0], axes[1]).unwrap().linked(links);
        Self { values, axes, links, plane }
    }

    pub fn random(random: &mut Random) -> Self {
        let values = random_values(random, Torsional::PARAMETERS);
        let axes = random_axes(random, Torsional::PARAMETERS);
        Self::of(values, axes, if random.once_in(3) { LINKED } else { Links::default() })
    }

    /// The gear with these values of the two parameters.
    pub fn at(&self, x: f64, y: f64) -> Vec<f64> {
        let mut values = self.values.clone();
        for ((name, ..), value) in self.axes.into_iter().zip([x, y]) {
            // With a gap of 0 the gear is another one than with a little; an axis shows those with some.
            values[place(name)] = if name == "freeplayAngle" { value.max(f64::MIN_POSITIVE) } else { value };
        }
        link::<Torsional>(&mut values, self.links, [self.axes[0].0, self.axes[1].0]);
        values
    }

    pub fn what(&self) -> String {
        format!("{:?} {:?} {:?}", self.axes, self.links, self.values)
    }

    /// Parts of the way, for values of the parameters.
    pub fn unit(&self, x: f64, y: f64) -> [f64; 2] {
        let part = |(_, from, to): (&str, f64, f64), value: f64| (value - from) / (to - from);
        [part(self.axes[0], x), part(self.axes[1], y)]
    }

    /// Ends of the unstable parts of the row at a part of the way up: by the closed form of one variable, which shares no
    /// root finder with the curves.
    pub fn ends_of_row(&self, part: f64) -> Vec<(f64, EndKind)> {
        let ((x, from, to), (_, low, high)) = (self.axes[0], self.axes[1]);
        let values = self.at(from, low + (high - low) * part);
        let variation = Variation {
            relaxation_length_follows: self.links.relaxation_length && self.axes[1].0 != "relaxationLength",
            tread_width_moment_constant_follows: self.links.tread_width_moment_constant
                && self.axes[1].0 != "treadWidthMomentConstant",
            ..Variation::of(x, from, to)
        };
        let intervals = run_with::<Torsional>(&values).unstable_intervals(&variation).unwrap();
        intervals.iter().flat_map(|i| [(i.from, i.from_kind), (i.to, i.to_kind)]).collect()
    }

    /// The stable part of that row.
    pub fn stable_part(&self, part: f64) -> f64 {
        let ends = self.ends_of_row(part);
        1.0 - ends.chunks(2).map(|two| two[1].0 - two[0].0).sum::<f64>() / (self.axes[0].2 - self.axes[0].1)
    }

    /// Where the row at a random height in each of so many equal stripes meets the boundary, in parts of the way, and what
    /// crosses there: where no curve is near, one is missed.
    pub fn meetings(&self, random: &mut Random, stripes: u32) -> Vec<([f64; 2], CurveKind)> {
        let (_, low, high) = self.axes[1];
        let row = |stripe: u32| {
            let part = (f64::from(stripe) + random.unit()) / f64::from(stripes);
            let kind = |end: EndKind| match end {
                EndKind::Hopf => Some(CurveKind::Hopf),
                EndKind::Divergence => Some(CurveKind::Divergence),
                EndKind::Range => None,
            };
            let at = move |x| self.unit(x, low + (high - low) * part);
            self.ends_of_row(part).into_iter().filter_map(move |(x, end)| Some((at(x), kind(end)?)))
        };
        (0..stripes).flat_map(row).collect()
    }
}

pub fn place(name: &str) -> usize {
    Torsional::PARAMETERS.iter().position(|p| p.name == name).unwrap()
}

/// A gear of which one thing or other is as by default.
pub fn gear(changes: &[(&str, f64)]) -> Vec<f64> {
    let mut values: Vec<f64> = Torsional::PARAMETERS.iter().map(|p| p.default).collect();
    for (name, value) in changes {
        values[place(name)] = *value;
    }
    values
}

pub fn named(changes: &[(&str, f64)], x: (&'static str, f64, f64), y: (&'static str, f64, f64)) -> Case {
    Case::of(gear(changes), [x, y], Links::default())
}

/// How far a point is from a curve, in parts of the plane.
pub fn distance(case: &Case, curve: &HopfCurve, at: [f64; 2]) -> f64 {
    let point = |i: usize| case.unit(curve.x[i], curve.y[i]);
    (1..curve.x.len()).fold(f64::INFINITY, |least, i| {
        let (a, b) = (point(i - 1), point(i));
        let (way, to) = ([b[0] - a[0], b[1] - a[1]], [at[0] - a[0], at[1] - a[1]]);
        let part = ((way[0] * to[0] + way[1] * to[1]) / (way[0] * way[0] + way[1] * way[1])).clamp(0.0, 1.0);
        least.min((to[0] - part * way[0]).hypot(to[1] - part * way[1]))
    })
}

/// How far it is to the nearest of some curves.
pub fn nearest<'a>(case: &Case, curves: impl IntoIterator<Item = &'a HopfCurve>, at: [f64; 2]) -> f64 {
    curves.into_iter().fold(f64::INFINITY, |least, curve| least.min(distance(case, curve, at)))
}

/// ∫ f over 0 … 1 by Simpson's rule, halved where it is not good enough, jumps and roots included.
pub fn integral(f: &dyn Fn(f64) -> f64) -> f64 {
    fn part(f: &dyn Fn(f64) -> f64, ends: [f64; 2], values: [f64; 3], depth: u32) -> f64 {
        let [a, b] = ends;
        let middle = a.midpoint(b);
        let (left, right) = (f(a.midpoint(middle)), f(middle.midpoint(b)));
        let whole = (b - a) / 6.0 * (values[0] + 4.0 * values[1] + values[2]);
        let halves = (b - a) / 12.0 * (values[0] + 4.0 * left + 2.0 * values[1] + 4.0 * right + values[2]);
        if depth == 0 || (halves - whole).abs() < 1e-10 {
            return halves;
        }
        part(f, [a, middle], [values[0], left, values[1]], depth - 1)
            + part(f, [middle, b], [values[1], right, values[2]], depth - 1)
    }
    let piece = |i: usize| {
        let [a, b] = [i, i + 1].map(|i| i as f64 / 500.0);
        part(f, [a, b], [f(a), f(a.midpoint(b)), f(b)], 30)
    };
    (0..500).map(piece).sum()
}
