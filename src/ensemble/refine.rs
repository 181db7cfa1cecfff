//! A plane made coarse first, and finer where it is not even.

use std::collections::VecDeque;

use super::{
    UNKNOWN,
    endings::{APART, Endings},
    follow::Fate,
};

/// The first cells are so far from each other, and at least so many to a side.
const COARSE: usize = 8;
const LEAST: usize = 12;

/// What is known of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    Nothing,
    /// Its neighbours around it are alike, and it is taken to be like them.
    Filled,
    /// It is to be followed, or on its way.
    Wanted,
    Followed,
}

/// The cells of a tile, row by row.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    size: [usize; 2],
    stride: usize,
    known: Vec<Known>,
    wanted: VecDeque<usize>,
    /// How many are wanted, or on their way.
    open: usize,
    /// [`Fate`] by cell, [`UNKNOWN`] where it is not known yet.
    pub kind: Vec<u8>,
    /// Of the first state; 0 where it is not known yet.
    pub amplitude: Vec<f64>,
    /// How many were followed.
    pub followed: usize,
    /// How many are known.
    pub made: usize,
    one_gear: bool,
}

impl Cells {
    /// Of `size` columns and rows; every single one is followed, unless they are `refined`.
    pub fn new(size: [usize; 2], one_gear: bool, refined: bool) -> Self {
        let count = size[0] * size[1];
        let fits = |stride: usize| stride * LEAST <= size[0].min(size[1]);
        let stride = if refined { [COARSE, 4, 2].into_iter().find(|stride| fits(*stride)).unwrap_or(1) } else { 1 };
        let mut cells = Self {
            size,
            stride,
            known: vec![Known::Nothing; count],
            wanted: VecDeque::new(),
            open: 0,
            kind: vec![UNKNOWN; count],
            amplitude: vec![0.0; count],
            followed: 0,
            made: 0,
            one_gear,
        };
        for row in cells.lattice(1) {
            for column in cells.lattice(0) {
                cells.want(column, row);
            }
        }
        cells
    }

    /// The next cell to follow.
    pub fn next(&mut self) -> Option<usize> {
        self.wanted.pop_front()
    }

    /// Notes how a cell ends.
    pub fn note(&mut self, cell: usize, fate: Fate, amplitude: f64) {
        self.known[cell] = Known::Followed;
        self.followed += 1;
        self.open -= 1;
        self.put(cell, fate as u8, amplitude);
        if self.stride == 1 {
            self.trace(cell);
        }
    }

    /// Where a cell ends otherwise than one beside it, all beside it are followed: so an edge that was met once is followed
    /// to its ends, however thin what it bounds.
    fn trace(&mut self, cell: usize) {
        let (column, row) = (cell % self.size[0], cell / self.size[0]);
        let beside = |place: usize, axis: usize| place.saturating_sub(1)..=(place + 1).min(self.size[axis] - 1);
        let (columns, rows) = (beside(column, 0), beside(row, 1));
        let differs = |other: usize| self.kind[other] != UNKNOWN && !self.alike(&[cell, other]);
        if rows.clone().any(|row| columns.clone().any(|column| differs(row * self.size[0] + column))) {
            for row in rows {
                for column in columns.clone() {
                    self.want(column, row);
                }
            }
        }
    }

    /// Once nothing is wanted any more: goes on to finer cells, if there are any to make.
    pub fn refine(&mut self) {
        if self.stride == 1 {
            return;
        }
        let [columns, rows] = [self.lattice(0), self.lattice(1)];
        let (across, along) = (columns.len().max(2) - 1, rows.len().max(2) - 1);
        let corner = |lattice: &[usize], block: usize| [lattice[block], lattice[(block + 1).min(lattice.len() - 1)]];
        let uneven: Vec<bool> = (0..across * along)
            .map(|block| !self.alike(&self.corners(corner(&columns, block % across), corner(&rows, block / across))))
            .collect();
        // A block next to an uneven one is looked at, too: what is thinner than a block ends within one.
        let near_uneven = |block: usize| {
            let (x, y) = (block % across, block / across);
            (y.saturating_sub(1)..=(y + 1).min(along - 1))
                .any(|y| (x.saturating_sub(1)..=(x + 1).min(across - 1)).any(|x| uneven[y * across + x]))
        };
        let looked_at: Vec<bool> = (0..across * along).map(near_uneven).collect();
        self.stride /= 2;
        let [finer_columns, finer_rows] = [self.lattice(0), self.lattice(1)];
        for (block, looked_at) in looked_at.iter().enumerate() {
            let (x, y) = (corner(&columns, block % across), corner(&rows, block / across));
            if *looked_at {
                for row in finer_rows.iter().filter(|row| (y[0]..=y[1]).contains(row)) {
                    for column in finer_columns.iter().filter(|column| (x[0]..=x[1]).contains(column)) {
                        self.want(*column, *row);
                    }
                }
            }
        }
        for (block, looked_at) in looked_at.iter().enumerate() {
            if !looked_at {
                self.fill(corner(&columns, block % across), corner(&rows, block / across));
            }
        }
        if self.stride == 1 {
            for cell in 0..self.kind.len() {
                if self.known[cell] == Known::Followed {
                    self.trace(cell);
                }
            }
        }
    }

    /// Nothing is left to make.
    pub fn done(&self) -> bool {
        self.made == self.kind.len() && self.stride == 1 && self.open == 0
    }

    /// Columns, or rows, that are a stride apart, with the last one.
    fn lattice(&self, axis: usize) -> Vec<usize> {
        let last = self.size[axis] - 1;
        (0..last).step_by(self.stride).chain([last]).collect()
    }

    fn want(&mut self, column: usize, row: usize) {
        let cell = row * self.size[0] + column;
        if matches!(self.known[cell], Known::Nothing | Known::Filled) {
            self.known[cell] = Known::Wanted;
            self.wanted.push_back(cell);
            self.open += 1;
        }
    }

    fn put(&mut self, cell: usize, kind: u8, amplitude: f64) {
        self.made += usize::from(self.kind[cell] == UNKNOWN);
        (self.kind[cell], self.amplitude[cell]) = (kind, amplitude);
    }

    /// These cells end alike.
    fn alike(&self, cells: &[usize]) -> bool {
        let (low, high) = cells.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), cell| {
            (low.min(self.amplitude[*cell]), high.max(self.amplitude[*cell]))
        });
        let one_motion = !self.one_gear || low >= high * (1.0 - APART) || low == high;
        one_motion && cells.iter().all(|cell| self.kind[*cell] == self.kind[cells[0]])
    }

    fn corners(&self, x: [usize; 2], y: [usize; 2]) -> [usize; 4] {
        let cell = |column: usize, row: usize| row * self.size[0] + column;
        [cell(x[0], y[0]), cell(x[1], y[0]), cell(x[0], y[1]), cell(x[1], y[1])]
    }

    /// Gives the cells within a block, of which nothing is known, its corners' ending, and amplitudes between theirs.
    fn fill(&mut self, x: [usize; 2], y: [usize; 2]) {
        let corners = self.corners(x, y);
        let [a, b, c, d] = corners.map(|corner| self.amplitude[corner]);
        let part = |place: usize, [from, to]: [usize; 2]| {
            if to > from { (place - from) as f64 / (to - from) as f64 } else { 0.0 }
        };
        // Amplitudes may be infinite, or all the same: then a mean would be none, or would round.
        let mean = |a: f64, b: f64, part: f64| if a == b { a } else { a + (b - a) * part };
        for row in y[0]..=y[1] {
            for column in x[0]..=x[1] {
                let cell = row * self.size[0] + column;
                if self.known[cell] == Known::Nothing {
                    self.known[cell] = Known::Filled;
                    let (right, up) = (part(column, x), part(row, y));
                    self.put(cell, self.kind[corners[0]], mean(mean(a, b, right), mean(c, d, right), up));
                }
            }
        }
    }

    /// The endings of the cells so far.
    pub fn endings(&self) -> Endings {
        let mut endings = Endings::new(self.one_gear);
        for (kind, amplitude) in self.kind.iter().zip(&self.amplitude) {
            if let Some(fate) = Fate::numbered(*kind) {
                endings.take(fate, *amplitude, 1);
            }
        }
        endings
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Makes a plane of which a function tells how each cell ends.
    fn made(size: [usize; 2], one_gear: bool, refined: bool, end: impl Fn(f64, f64) -> (Fate, f64)) -> Cells {
        let mut cells = Cells::new(size, one_gear, refined);
        while !cells.done() {
            match cells.next() {
                Some(cell) => {
                    let (x, y) = (cell % size[0], cell / size[0]);
                    let (fate, amplitude) = end(x as f64 / size[0] as f64, y as f64 / size[1] as f64);
                    cells.note(cell, fate, amplitude);
                }
                None => cells.refine(),
            }
        }
        cells
    }

    /// A ring of rest between two cycles, and a thin tongue into it.
    fn rings(x: f64, y: f64) -> (Fate, f64) {
        let r = (x - 0.4).hypot(y - 0.55);
        if (x - 0.4).abs() < 0.012 && y > 0.55 {
            (Fate::Rattle, 0.01)
        } else if (0.2..0.3).contains(&r) {
            (Fate::Rest, 0.0)
        } else if r < 0.2 {
            (Fate::Shimmy, 0.1)
        } else {
            (Fate::Shimmy, 0.2)
        }
    }

    #[test]
    fn refined_is_the_same_as_cell_by_cell_with_a_part_of_the_work() {
        for size in [[200, 150], [97, 203]] {
            let (all, some) = (made(size, true, false, rings), made(size, true, true, rings));
            assert_eq!(all.followed, size[0] * size[1]);
            assert!(2 * some.followed < all.followed, "{} of {}", some.followed, all.followed);
            assert!(some.kind == all.kind && some.amplitude == all.amplitude, "{size:?}");
            assert_eq!(some.endings().sorted(), all.endings().sorted());
        }
    }

    #[test]
    fn amplitudes_between_are_between() {
        let plane = |x: f64, y: f64| (Fate::Shimmy, 0.1 + 0.2 * x + 0.3 * y);
        let (all, some) = (made([160, 120], false, false, plane), made([160, 120], false, true, plane));
        assert!(10 * some.followed < all.followed);
        assert!(some.amplitude.iter().zip(&all.amplitude).all(|(a, b)| (a - b).abs() < 1e-12));
        let endless = made([20, 20], false, true, |_, _| (Fate::Divergence, f64::INFINITY));
        assert!(endless.amplitude.iter().all(|a| *a == f64::INFINITY));
    }

    #[test]
    fn planes_of_a_row_a_column_or_a_cell_are_planes() {
        for size in [[1, 1], [1, 40], [40, 1], [2, 2], [8, 9], [9, 8]] {
            let (all, some) = (made(size, true, false, rings), made(size, true, true, rings));
            assert_eq!(some.kind, all.kind, "{size:?}");
        }
    }
}
