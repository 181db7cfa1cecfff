//! Motions of one model side by side, by the classical method with a fixed step.

use super::lanes::Lanes;
use crate::{
    model::Laned,
    real::{Number, Sums},
};

/// Motions in lanes, each of a gear of its own.
#[derive(Clone, Debug)]
pub struct Bundle {
    gears: Laned<Lanes>,
    x: [Lanes; 3],
}

/// A step of W. Kutta's method (*Z. Math. Phys.* 46 (1901) 435–453), with the time in steps. State by state in so many words:
/// the compiler, which weighs loops for the module's sake, would leave them as loops.
#[inline(always)]
pub fn step<R: Sums<R>>(gear: &Laned<R>, x: &[R; 3], [half, third, sixth]: [R; 3]) -> [R; 3] {
    let moved = |k: &[R; 3]| [x[0].plus(k[0], half), x[1].plus(k[1], half), x[2].plus(k[2], half)];
    let a = moved(&gear.rate(x));
    let b = moved(&gear.rate(&a));
    let k3 = gear.rate(&b);
    let c = [x[0] + k3[0], x[1] + k3[1], x[2] + k3[2]];
    let k4 = gear.rate(&c);
    // x + (k₁ + 2k₂ + 2k₃ + k₄)/6, of the states that are there already.
    let end = |i: usize| (k4[i] * sixth).plus((a[i] - x[i]) + (b[i] + b[i]) + c[i], third);
    [end(0), end(1), end(2)]
}

impl Bundle {
    /// Nothing that moves, in any lane.
    pub fn at_rest() -> Self {
        Self { gears: Laned(Laned::REST.0.map(Lanes::all)), x: [Lanes::all(0.0); 3] }
    }

    /// Puts a gear and its state into a lane.
    pub fn load(&mut self, lane: usize, gear: &Laned<f64>, x: [f64; 3]) {
        for (numbers, number) in self.gears.0.iter_mut().zip(gear.0) {
            *numbers = numbers.with(lane, number);
        }
        for (lanes, x) in self.x.iter_mut().zip(x) {
            *lanes = lanes.with(lane, x);
        }
    }

    /// The state in a lane.
    pub fn state(&self, lane: usize) -> [f64; 3] {
        self.x.map(|x| x.each()[lane])
    }

    /// Goes on by so many steps.
    #[inline(never)]
    pub fn advance(&mut self, steps: usize) {
        let weights = [0.5, 1.0 / 3.0, 1.0 / 6.0].map(Lanes::all);
        let (gears, mut x) = (self.gears, self.x);
        for _ in 0..steps {
            x = step(&gears, &x, weights);
        }
        self.x = x;
    }

    /// Goes on by so many steps, and measures how far each state goes: the largest |·| where steps end, of the first state
    /// where it turns.
    #[inline(never)]
    pub fn measure(&mut self, steps: usize) -> [Lanes; 3] {
        let mut before = self.x[0];
        self.advance(1);
        let weights = [0.5, 1.0 / 3.0, 1.0 / 6.0].map(Lanes::all);
        let eighth = Lanes::all(0.125);
        let (gears, mut x) = (self.gears, self.x);
        let [mut turn, mut first, mut second] = [Lanes::all(0.0); 3];
        for _ in 1..steps {
            let next = step(&gears, &x, weights);
            // The vertex of the parabola through three states. Where the middle one is not the farthest, the clamped one is
            // none, but not farther out either.
            let (rise, fall) = (x[0] - before, x[0] - next[0]);
            let bend = rise + fall;
            let lean = (rise - fall).clamped(bend.abs());
            turn = turn.or_larger((x[0] + lean * lean / bend * eighth).abs());
            (first, second) = (first.or_larger(x[1].abs()), second.or_larger(x[2].abs()));
            (before, x) = (x[0], next);
        }
        self.x = x;
        [turn, first, second]
    }
}
