//! The motions that the cells of a plane end in.

use super::{UNKNOWN, follow::Fate};

/// Amplitudes that differ by less than this part from one cell to another one are of one motion.
pub(super) const APART: f64 = 0.02;
/// Most that are told apart: what a byte can name.
const MOST: usize = 250;

/// A motion that cells end in.
///
/// Of one gear, cells of one kind are sorted by amplitude: where two in turn are more than 2 % apart a new ending begins.
/// Where parameters vary, amplitudes do so without a gap, and all cells of a kind are one ending.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ending {
    /// Of which kind.
    pub fate: Fate,
    /// The smallest amplitude among its cells.
    pub low: f64,
    /// The largest one.
    pub high: f64,
    /// How many cells.
    pub cells: usize,
}

/// The endings that there are.
#[derive(Clone, Debug)]
pub(super) struct Endings {
    list: Vec<Ending>,
    one_gear: bool,
}

impl Endings {
    /// None yet. `one_gear`: told apart by amplitude, too.
    pub fn new(one_gear: bool) -> Self {
        Self { list: Vec::new(), one_gear }
    }

    /// Takes a cell into an ending, or begins one; endings that it brings together become one.
    pub fn take(&mut self, fate: Fate, amplitude: f64, cells: usize) {
        let mut one = Ending { fate, low: amplitude, high: amplitude, cells };
        let one_gear = self.one_gear;
        self.list.retain(|ending| {
            let joins = near(ending, fate, amplitude, one_gear);
            if joins {
                one.low = one.low.min(ending.low);
                one.high = one.high.max(ending.high);
                one.cells += ending.cells;
            }
            !joins
        });
        self.list.push(one);
    }

    /// Those there are: by kind, and by amplitude within one; a byte names them.
    pub fn sorted(&self) -> Vec<Ending> {
        let mut list = self.list.clone();
        crate::few::sort_few(&mut list, |a, b| (a.fate as u8, a.low) < (b.fate as u8, b.low));
        list.truncate(MOST);
        list
    }

    /// The place of a cell's ending among those sorted.
    pub fn place(sorted: &[Ending], fate: Fate, amplitude: f64) -> u8 {
        let within = |ending: &Ending| ending.fate == fate && (ending.low..=ending.high).contains(&amplitude);
        sorted.iter().position(within).map_or(UNKNOWN, |place| place as u8)
    }
}

/// Whether an amplitude belongs to an ending.
fn near(ending: &Ending, fate: Fate, amplitude: f64, one_gear: bool) -> bool {
    let part = 1.0 - APART;
    ending.fate == fate && (!one_gear || (amplitude >= ending.low * part && amplitude * part <= ending.high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_join_whatever_their_order_and_others_do_not() {
        let amplitudes = [0.100, 0.2, 0.1015, 0.103, 0.199, 0.1045, 0.3];
        for turn in 0..amplitudes.len() {
            let mut endings = Endings::new(true);
            for i in 0..amplitudes.len() {
                endings.take(Fate::Shimmy, amplitudes[(i + turn) % amplitudes.len()], 1);
            }
            endings.take(Fate::Rattle, 0.2, 4);
            endings.take(Fate::Rest, 0.0, 1);
            endings.take(Fate::Rest, 0.0, 1);
            let sorted = endings.sorted();
            let told: Vec<_> =
                sorted.iter().map(|ending| (ending.fate, ending.low, ending.high, ending.cells)).collect();
            let (rest, rattle, shimmy) = (Fate::Rest, Fate::Rattle, Fate::Shimmy);
            let expected = [
                (rest, 0.0, 0.0, 2),
                (rattle, 0.2, 0.2, 4),
                (shimmy, 0.1, 0.1045, 4),
                (shimmy, 0.199, 0.2, 2),
                (shimmy, 0.3, 0.3, 1),
            ];
            assert_eq!(told, expected);
            assert_eq!(Endings::place(&sorted, Fate::Shimmy, 0.103), 2);
            assert_eq!(Endings::place(&sorted, Fate::Divergence, 0.103), UNKNOWN);
        }
    }

    #[test]
    fn where_parameters_vary_a_kind_is_one_ending() {
        let mut endings = Endings::new(false);
        for amplitude in [0.1, 0.4, 0.2] {
            endings.take(Fate::Shimmy, amplitude, 1);
        }
        endings.take(Fate::Divergence, f64::INFINITY, 1);
        endings.take(Fate::Divergence, 0.6, 1);
        let sorted = endings.sorted();
        assert_eq!(sorted.len(), 2);
        assert_eq!((sorted[0].low, sorted[0].high, sorted[1].high), (0.1, 0.4, f64::INFINITY));
        assert_eq!(Endings::place(&sorted, Fate::Divergence, f64::INFINITY), 1);
    }
}
