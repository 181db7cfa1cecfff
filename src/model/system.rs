//! What a model offers to an integrator.

use super::{Description, laws::Laws, torsional::Prepared};
use crate::{
    parameter::{Parameter, StateVariable},
    real::{Dual, Real},
    stability::{Ring, TorsionalTheory},
};

/// Which piece of each piecewise law holds: two bits a kink (see [`crate::element::Side`]), or a friction
/// ([`crate::element::friction::Rubbing`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mode(pub u32);

impl Mode {
    /// The side of kink `kink`.
    #[inline(always)]
    pub fn side(self, kink: usize) -> crate::element::Side {
        use crate::element::Side;
        match (self.0 >> (2 * kink)) & 3 {
            0 => Side::Within,
            1 => Side::Above,
            _ => Side::Below,
        }
    }

    /// The bits from kink `kink` on: its side in the lowest two.
    #[inline(always)]
    pub fn sides(self, kink: usize) -> u32 {
        self.0 >> (2 * kink)
    }

    /// The same mode with kink `kink` on another side.
    #[must_use]
    pub fn with_side(self, kink: usize, side: crate::element::Side) -> Self {
        self.with(kink, side as u32)
    }

    /// The same mode with other bits for kink `kink`: two.
    #[must_use]
    pub fn with(self, kink: usize, bits: u32) -> Self {
        Self(self.0 & !(3 << (2 * kink)) | bits << (2 * kink))
    }
}

/// First-order equations ẋ = f(t, mode, x) in `N` states, smooth within a mode, with the switches at which the mode
/// changes.
///
/// Within a step the mode is held: `rate` must continue each piece smoothly some way past its end.
pub trait System<const N: usize>: Clone {
    /// How many switches there are (two a symmetric kink).
    const SWITCHES: usize = 0;

    /// How many of them, the last ones, are of an element that is seldom there: they are looked at where [`System::minds`].
    const SELDOM: usize = 0;

    /// How many of the states there are, the first ones: the others are room that other gears need, and stay 0.
    #[inline(always)]
    fn width(&self) -> usize {
        N
    }

    /// Where the search for an equilibrium begins, and a bit for each state that may have any value there: it keeps this one.
    fn rest(&self) -> ([f64; N], u32) {
        ([0.0; N], 0)
    }

    /// The fastest rate \[1/s\] at which something fades that its Jacobian at rest does not show: no fixed step may be longer
    /// than the time that takes.
    #[inline(always)]
    fn fading(&self, mode: Mode, x: &[f64; N]) -> f64 {
        let _ = (mode, x);
        0.0
    }

    /// Names of the kinds of events, as `event_kind` counts them.
    const EVENT_KINDS: &'static [&'static str] = &[];

    /// ẋ.
    fn rate<R: Real>(&self, t: R, mode: Mode, x: &[R; N]) -> [R; N];

    /// ∂f/∂x by dual numbers: exact, row by row.
    fn jacobian(&self, t: f64, mode: Mode, x: &[f64; N]) -> [[f64; N]; N] {
        let seeded: [Dual<N>; N] = std::array::from_fn(|i| Dual::variable(x[i], i));
        self.rate(Dual::from(t), mode, &seeded).map(|row| row.slope)
    }

    /// The mode in which a motion at `x` goes on.
    fn mode(&self, t: f64, x: &[f64; N]) -> Mode {
        let _ = (t, x);
        Mode::default()
    }

    /// Value of switch `which`: positive as long as the mode holds on its account, `None` where it does not apply in
    /// this mode. The switch happens where the value falls through 0.
    #[inline(always)]
    fn switch<R: Real>(&self, which: usize, t: R, mode: Mode, x: &[R; N]) -> Option<R> {
        let _ = (which, t, mode, x);
        None
    }

    /// Whether the last [`System::SELDOM`] switches can apply in this mode.
    #[inline(always)]
    fn minds(&self, mode: Mode) -> bool {
        let _ = mode;
        true
    }

    /// The mode after switch `which`, which has fallen through 0 at `t` and `x`. Where a law goes on from a definite place (a wheel
    /// that sticks does not turn), the state is brought there exactly, and by no more than it has been located to.
    fn cross(&self, which: usize, t: f64, mode: Mode, x: &mut [f64; N]) -> Mode {
        let _ = (which, t, x);
        mode
    }

    /// Index into `EVENT_KINDS` of switch `which`.
    fn event_kind(&self, which: usize) -> usize {
        which
    }
}

/// A system that a live motion can be made of.
pub trait Gear<const N: usize>: System<N> + 'static {
    /// The state just after an impulse: an angular one in N m s about the steering axis.
    fn kicked(&self, x: &[f64; N], impulse: f64) -> [f64; N];

    /// The same gear without freeplay, where it has any: what a rattle is told by.
    fn without_freeplay(&self) -> Option<Self> {
        None
    }

    /// The same motion so many times as large.
    fn scaled(&self, x: &[f64; N], factor: f64) -> [f64; N] {
        x.map(|x| x * factor)
    }

    /// Whether dry friction can hold it.
    fn sticks(&self) -> bool {
        false
    }
}

/// A system with its tables: everything that a listed model has.
pub trait Model<const N: usize>: 'static {
    /// The system that moves.
    type System: Gear<N>;

    /// Public name.
    const NAME: &'static str;
    /// One line for people.
    const TITLE: &'static str;
    /// Parameters, in the order of `new`'s values.
    const PARAMETERS: &'static [Parameter];
    /// All values that a run of it holds: its parameters, and after them those of the elements that it takes, by dotted
    /// names. Whoever gives values may leave elements out.
    const TABLE: &'static [Parameter] = Self::PARAMETERS;
    /// State variables, in the order of the state.
    const STATE: &'static [StateVariable];

    /// The system for checked parameter values, in table order.
    fn new(values: &[f64]) -> Self::System;

    /// A system that rests where that of `new` does and answers a small push there as it does, for maps and searches that ask
    /// of many: of a gear whose laws take their time to prepare, with straight ones.
    fn at_rest(values: &[f64]) -> Self::System {
        Self::new(values)
    }

    /// Its force laws one by one, for checked parameter values in table order; none where it has no such laws.
    fn laws(values: &[f64]) -> Option<Laws> {
        let _ = values;
        None
    }

    /// Made ready for an ensemble, for checked parameter values in table order; none where each motion is followed by itself.
    fn prepared(values: &[f64]) -> Option<Prepared> {
        let _ = values;
        None
    }

    /// Its linear theory, where there is a closed form, for parameters in table order.
    fn linear_theory<T: Ring>(values: &[T]) -> Option<TorsionalTheory<T>> {
        let _ = values;
        None
    }
}

/// A model as data: its tables, and the way to its system.
#[derive(Debug)]
pub struct Tables<S> {
    /// The tables.
    pub description: Description,
    /// The system for checked parameter values, in table order.
    pub new: fn(&Description, &[f64]) -> S,
}

impl<S> Tables<S> {
    /// Those of the model `M`.
    pub fn of<const N: usize, M: Model<N, System = S>>() -> &'static Self {
        const { &Self { description: Description::of::<N, M>(), new: |_, values| M::new(values) } }
    }

    /// The system for checked parameter values, in table order.
    pub fn system(&self, values: &[f64]) -> S {
        (self.new)(&self.description, values)
    }
}
