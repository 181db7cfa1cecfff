//! Boundaries that are zeros of polynomials.

use super::{Boundary, Crossing, CurveKind, Point};
use crate::{
    few::sort_few,
    stability::{
        Plane,
        polynomial::{
            form::{Form, Patch, column, put_column},
            line::{Bernstein, Crossings, DEEPEST, Line, parts},
        },
    },
};

/// How often the square is cut in four at most, and how many boxes are looked at: a curve that meets itself takes some at
/// every size, one that is double everywhere would take all.
const FINEST: u32 = 26;
const MOST_BOXES: usize = 2_000;
/// Bernstein coefficients below this part of the largest are rounding.
const ROUNDING: f64 = 1e-15;
/// What a condition may be at a point of its curve, beside the size of its terms there.
const ON_CURVE: f64 = 1e-7;
/// ω² below this part of what it is the sum of is 0: a curve is known to 1e-10 of the plane.
const NO_SWING: f64 = 1e-9;

/// The torsional gears: stable where both polynomials are positive.
pub(super) struct ClosedForm {
    calms: Form,
    stays: Form,
    /// a₁ σ I_z
    swings: Form,
    /// σ I_z
    inertia: Form,
}

impl ClosedForm {
    /// That of a plane, where its model has one.
    pub fn of(plane: &Plane) -> Option<Self> {
        let theory = plane.theory()?;
        Some(Self {
            calms: Form::of(&theory.calms()),
            stays: Form::of(&theory.stays()),
            swings: Form::of(&theory.swings()),
            inertia: Form::of(&(theory.relaxation_length * theory.moment_of_inertia)),
        })
    }

    fn form(&self, kind: CurveKind) -> &Form {
        match kind {
            CurveKind::Hopf => &self.calms,
            CurveKind::Divergence => &self.stays,
        }
    }
}

impl Boundary for ClosedForm {
    fn test(&self, kind: CurveKind, at: Point) -> (f64, Point) {
        self.form(kind).slope(at)
    }

    fn seeds(&self, kind: CurveKind) -> Vec<[Point; 2]> {
        let form = self.form(kind);
        let b = form.bernstein();
        let largest = b.as_flattened().iter().fold(0.0_f64, |most, b| most.max(b.abs()));
        let mut search = Search {
            form,
            transposed: form.transposed(),
            rounding: ROUNDING * largest,
            boxes: Vec::new(),
            seeds: Vec::new(),
        };
        search.boxes.push((b, [[0.0, 1.0]; 2], FINEST));
        for index in 0.. {
            let Some((b, ends, finer)) = search.boxes.get(index).copied() else { break };
            search.visit(&b, ends, if search.boxes.len() < MOST_BOXES { finer } else { 0 });
        }
        search.seeds.into_iter().map(|seed| [seed, seed]).collect()
    }

    /// At a₂a₁ = a₀ a pair is on the axis where a₁ > 0; otherwise it is two real eigenvalues of one size. The third one is
    /// −a₂. At a₀ = 0 the other two are left of the axis where a₁ > 0.
    fn crossing(&self, kind: CurveKind, at: Point) -> Option<Crossing> {
        let swings = self.swings.at(at);
        let square = if swings > NO_SWING * self.swings.size(at) { swings / self.inertia.at(at) } else { 0.0 };
        match kind {
            CurveKind::Hopf => {
                (square > 0.0).then(|| Crossing { frequency: square.sqrt() / std::f64::consts::TAU, bounds: true })
            }
            CurveKind::Divergence => Some(Crossing { frequency: 0.0, bounds: square > 0.0 }),
        }
    }

    fn holds(&self, kind: CurveKind, at: Point) -> bool {
        let form = self.form(kind);
        form.at(at).abs() <= ON_CURVE * form.size(at) + ROUNDING * form.size([1.0; 2])
    }

    fn stable(&self, at: Point) -> bool {
        self.calms.at(at) > 0.0 && self.stays.at(at) > 0.0
    }

    /// Where either condition changes in the row, and what holds between.
    fn stable_part(&self, y: f64) -> Option<f64> {
        let [calms, stays] = [&self.calms, &self.stays].map(|form| {
            let mut crossings = Crossings::default();
            let holds = form.row(y).cross(f64::NAN, &mut crossings);
            (holds, crossings)
        });
        let holds = |(first, crossings): &(bool, Crossings), x: f64| {
            *first != (crossings.list().iter().filter(|crossing| **crossing < x).count() % 2 == 1)
        };
        let mut cuts = [calms.1.list(), stays.1.list(), &[0.0, 1.0]].concat();
        sort_few(&mut cuts, |a, b| a < b);
        let stable = |two: &&[f64]| {
            let middle = two[0].midpoint(two[1]);
            holds(&calms, middle) && holds(&stays, middle)
        };
        Some(cuts.windows(2).filter(stable).map(|two| two[1] - two[0]).sum())
    }
}

/// Bernstein coefficients over a box, its ends across and along, and how often it may be cut.
type Box = (Patch, [[f64; 2]; 2], u32);

/// A search for places through which every branch of a polynomial's zeros passes.
struct Search<'a> {
    form: &'a Form,
    transposed: Form,
    rounding: f64,
    boxes: Vec<Box>,
    seeds: Vec<Point>,
}

impl Search<'_> {
    /// Looks at a box from ends to ends. Where the slope in one direction has one sign, no curve closes within it: all leave
    /// through its edges. Otherwise its quarters are to be looked at, if it may be cut `finer`.
    fn visit(&mut self, b: &Patch, ends: [[f64; 2]; 2], finer: u32) {
        let (across, along) = (self.form.across, self.form.along);
        let (mut signs, mut across_signs, mut along_signs) = ([false; 2], [false; 2], [false; 2]);
        for (i, j) in (0..=across).flat_map(|i| (0..=along).map(move |j| (i, j))) {
            self.note(&mut signs, b[j][i]);
            if i > 0 {
                self.note(&mut across_signs, b[j][i] - b[j][i - 1]);
            }
            if j > 0 {
                self.note(&mut along_signs, b[j][i] - b[j - 1][i]);
            }
        }
        if signs != [true; 2] {
            return self.lines(b, ends);
        }
        if across_signs != [true; 2] || along_signs != [true; 2] || finer == 0 {
            return self.edges(b, ends);
        }
        let [[left, right], [below, above]] = ends;
        let (middle, height) = (left.midpoint(right), below.midpoint(above));
        let (mut lower, mut upper) = (*b, *b);
        for i in 0..=across {
            let (low, high) = parts(&column(b, i), along, 0.5);
            put_column(&mut lower, i, &low);
            put_column(&mut upper, i, &high);
        }
        for (mut west, ends) in [(lower, [below, height]), (upper, [height, above])] {
            let mut east = west;
            for j in 0..=along {
                (west[j], east[j]) = parts(&west[j], across, 0.5);
            }
            self.boxes.push((west, [[left, middle], ends], finer - 1));
            self.boxes.push((east, [[middle, right], ends], finer - 1));
        }
    }

    /// Notes a sign, + or −, that is more than rounding.
    #[inline(always)]
    fn note(&self, signs: &mut [bool; 2], number: f64) {
        signs[0] |= number > self.rounding;
        signs[1] |= number < -self.rounding;
    }

    /// Where the left or the lower edge of a box is itself a line of zeros, with one sign at either side: neither of the two
    /// boxes that it parts has both. The square's own edge bounds nothing within it.
    #[inline(never)]
    fn lines(&mut self, b: &Patch, [across, along]: [[f64; 2]; 2]) {
        let zero = |b: &f64| b.abs() <= self.rounding;
        if along[0] > 0.0 && b[0][..=self.form.across].iter().all(zero) {
            self.seeds.push([across[0].midpoint(across[1]), along[0]]);
        }
        if across[0] > 0.0 && b[..=self.form.along].iter().all(|row| zero(&row[0])) {
            self.seeds.push([across[0], along[0].midpoint(along[1])]);
        }
    }

    /// Where zeros pass the left and lower edge of a box; the others are its neighbours', or the square's.
    #[inline(never)]
    fn edges(&mut self, b: &Patch, [across, along]: [[f64; 2]; 2]) {
        for end in 0..2 {
            let (i, j) = (end * self.form.across, end * self.form.along);
            if end == 0 || along[1] == 1.0 {
                let zeros = self.zeros(&self.form.row(along[end]), &b[j], across);
                self.seeds.extend(zeros.list().iter().map(|x| [*x, along[end]]));
            }
            if end == 0 || across[1] == 1.0 {
                let zeros = self.zeros(&self.transposed.row(across[end]), &column(b, i), along);
                self.seeds.extend(zeros.list().iter().map(|y| [across[end], *y]));
            }
        }
    }

    /// Zeros of a line between its ends, and at them.
    #[inline(never)]
    fn zeros(&self, line: &Line, b: &Bernstein, ends: [f64; 2]) -> Crossings {
        let mut found = Crossings::default();
        line.within(b, ends, DEEPEST, &Crossings::default(), &mut found);
        for (end, value) in ends.into_iter().zip([b[0], b[line.degree]]) {
            if value.abs() <= self.rounding {
                found.push(end);
            }
        }
        found
    }
}
