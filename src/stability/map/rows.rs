//! Rows of a map where stability is a matter of polynomials.

use super::{Cells, MapSpec, Tile};
use crate::{
    error::Result,
    stability::{
        Surface, TorsionalTheory,
        polynomial::{
            cubic,
            form::Form,
            line::{Crossings, Line},
        },
    },
};

/// The conditions over the unit square, and what one row hands to the next.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    stays: Condition,
    /// Not everywhere k + T > 0.
    may_fall: bool,
    calms: Condition,
    rates: Option<Rates>,
}

impl Rows {
    pub fn of(theory: &TorsionalTheory<Surface>, spec: &MapSpec) -> Self {
        let stays = Condition::of(&theory.stays());
        Self {
            may_fall: !stays.form.positive(),
            stays,
            calms: Condition::of(&theory.calms()),
            rates: spec.quantities.any().then(|| Rates::of(theory, spec.tile)),
        }
    }

    /// Makes the next row.
    pub fn advance(&mut self, spec: &MapSpec, cells: &mut Cells) -> Result<()> {
        let Tile { column, row, columns, .. } = spec.tile;
        let start = cells.made;
        let y = spec.centre(1, row + start / columns);
        let across = spec.counts[0] as f64;
        // How many cells have their centre before a place.
        let before = |place: f64| ((place * across - 0.5).ceil() as usize).saturating_sub(column).min(columns);
        let row = &mut cells.stable[start..start + columns];

        let mut holds = self.calms.row(y);
        let mut from = 0;
        for place in self.calms.crossings.list() {
            let to = before(*place);
            if holds {
                row[from..to].fill(1);
                cells.stable_count += to - from;
            }
            (from, holds) = (to, !holds);
        }
        if holds {
            row[from..].fill(1);
            cells.stable_count += columns - from;
        }
        if self.may_fall {
            let mut holds = self.stays.row(y);
            let mut from = 0;
            for to in self.stays.crossings.list().iter().map(|place| before(*place)).chain([columns]) {
                if !holds {
                    let fallen = &mut row[from..to];
                    cells.stable_count -= fallen.iter().map(|stable| usize::from(*stable)).sum::<usize>();
                    fallen.fill(0);
                }
                (from, holds) = (to, !holds);
            }
        }
        if let Some(rates) = &mut self.rates {
            rates.advance(&self.stays.form.row(y), y, spec, cells)?;
        }
        cells.made += columns;
        Ok(())
    }
}

/// A polynomial that is positive where the condition holds, and where it changes its sign in the row that is being made.
#[derive(Clone, Debug)]
struct Condition {
    form: Form,
    crossings: Crossings,
    /// The first of them in the row before.
    before: f64,
}

impl Condition {
    fn of(surface: &Surface) -> Self {
        Self { form: Form::of(surface), crossings: Crossings::default(), before: 0.0 }
    }

    /// Goes to a row, and tells whether it holds at its left end.
    #[inline]
    fn row(&mut self, y: f64) -> bool {
        let first = self.crossings.first();
        let holds = self.form.row_in_line(y).cross(2.0 * first - self.before, &mut self.crossings);
        self.before = first;
        holds
    }
}

/// What the characteristic polynomial is made of, and the roots of the row before.
#[derive(Clone, Debug)]
struct Rates {
    damps: Form,
    swings: Form,
    /// σ I_z
    inertia: Form,
    velocity: Form,
    starts: Vec<f64>,
}

impl Rates {
    fn of(theory: &TorsionalTheory<Surface>, tile: Tile) -> Self {
        Self {
            damps: Form::of(&theory.damps()),
            swings: Form::of(&theory.swings()),
            inertia: Form::of(&(theory.relaxation_length * theory.moment_of_inertia)),
            velocity: Form::of(&theory.velocity),
            starts: vec![0.0; tile.columns],
        }
    }

    /// The next row, at `y`.
    fn advance(&mut self, stays: &Line, y: f64, spec: &MapSpec, cells: &mut Cells) -> Result<()> {
        let [damps, swings, inertia, velocity] =
            [&self.damps, &self.swings, &self.inertia, &self.velocity].map(|form| form.row(y));
        let degrees = [&damps, &swings, &inertia, &velocity, stays].map(|line| line.degree);
        debug_assert!(degrees.into_iter().zip([3, 2, 1, 1, 1]).all(|(degree, most)| degree <= most), "{degrees:?}");
        let (d, w, q, v, s) = (damps.power, swings.power, inertia.power, velocity.power, stays.power);
        let mut start = 0.0;
        for (index, above) in self.starts.iter_mut().enumerate() {
            let x = spec.centre(0, spec.tile.column + index);
            let v = v[0] + x * v[1];
            let q = q[0] + x * q[1];
            let scale = 1.0 / (v * q);
            let a2 = (d[0] + x * (d[1] + x * (d[2] + x * d[3]))) * scale;
            let a1 = (w[0] + x * (w[1] + x * w[2])) * v * scale;
            let a0 = (s[0] + x * s[1]) * v * v * scale;
            // Those of the row before stand for themselves, so that cells need not wait for each other.
            if *above == 0.0 {
                *above = start;
            }
            let (real, imaginary) = cubic::rightmost(a2, a1, a0, above);
            start = *above;
            cells.note(cells.made + index, real, imaginary)?;
        }
        Ok(())
    }
}
