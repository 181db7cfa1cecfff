//! Limit cycles: motions that repeat, with all that their neighbours do.
//!
//! A start is brought near a cycle by following the motion ([`crate::outlook`]), or given. *Shooting* then asks for the state
//! and the period after which the motion is back, by Newton's method, with the derivative of the arrival with respect to the
//! start. That comes from the variational equations d′ = J(x(t)) d along each step of the motion: a step ends at
//! each kink, across which the field is continuous, so that nothing jumps there; where dry friction turns, it jumps, and
//! what that does to neighbours is known in closed form. The derivative over one period has the *Floquet
//! multipliers* as eigenvalues: one is 1 (along the cycle), the others say whether a neighbour comes nearer.
//!
//! Over the range of a parameter cycles form branches ([`Bifurcation`]): born at Hopf points, folding, or there without either.
//!
//! *Describing functions* ([`Predicted`]) ask the first harmonic alone: all cycles at once, within some per cent.

mod continuation;
mod describing;
mod flow;
mod shooting;
mod square;
mod start;
mod vector;

use nalgebra::Complex;

pub use self::{
    continuation::{
        Bifurcation, BifurcationSpec, BranchEnd, Criticality, CycleBranch, CyclePoint, FoldCurve, FoldCurves, FoldSpec,
        PointKind, RestBranch, SpecialPoint, Told,
    },
    describing::{Amplitudes, Predicted},
    start::Guess,
};
use self::{
    flow::{Carrier, Flow, Swing},
    shooting::Periodic,
    start::starts,
    vector::vector,
};
use crate::{
    error::Result,
    few::padded,
    live::Columns,
    model::Gear,
    outlook::{End, look_ahead},
    run::Posed,
};

/// Most steps on the way to a cycle: six seconds take some ten thousand.
const MOST_STEPS: u64 = 300_000;
/// A cycle rises through zero at most so often.
const MOST_ROUNDS: u32 = 4;
/// A cycle farther from the motion that led there is another one.
const NEAR: f64 = 0.2;

/// What the trivial multiplier may be wrong by, and how many times finer than usual motions are followed where it is by more:
/// of all that is known of a cycle its neighbours suffer first where it turns sharply.
const TRIVIAL: f64 = 3e-7;
const FINEST: f64 = 16.0;

/// Neighbours that leave by less than this part in a round seem to stay: they have orbits beside the cycle, or nearly so.
const LEAVING: f64 = 1e-5;

/// A motion that repeats, isolated from others that do.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitCycle {
    /// \[s\].
    pub period: f64,
    /// 1/period \[Hz\].
    pub frequency: f64,
    /// Largest |·| of every state on it, where it turns.
    pub amplitude: Vec<f64>,
    /// Floquet multipliers by falling size, the trivial one (1) among them; of a pair the positive imaginary part first.
    pub multipliers: Vec<Complex<f64>>,
    /// All others are within the unit circle: neighbours come nearer.
    pub stable: bool,
    /// The second half mirrors the first.
    pub symmetric: bool,
    /// One period, its first point twice, from where the first state rises through zero, if it does.
    pub orbit: Columns,
}

/// The limit cycle of a run: near the guess, or the one that its motion settles on.
pub(crate) fn limit_cycle<S: Gear<N>, const N: usize>(
    posed: &Posed<S, N>,
    guess: Option<&Guess>,
) -> Result<Option<LimitCycle>> {
    let scales = posed.tables.description.state;
    let scaled = |x: &[f64]| vector(x.len(), &|i| x[i] / scales[i].scale);
    if let Some(guess) = guess {
        let mut carrier = Carrier::of(posed, guess.period)?;
        if let Some(found) = shooting::guessed(&mut carrier, &scaled(&guess.state), guess.period)? {
            return told(&mut carrier, found);
        }
    }
    let horizon = posed.run.horizon();
    for x in starts(&posed.run)? {
        let mut motion = posed.motion(horizon / 20.0)?;
        motion.restart(0.0, padded(&x, 0.0)).map_err(|failure| crate::integrate::failed(failure, 0.0))?;
        let look = look_ahead(motion, scales, horizon, posed.run.max_steps().min(MOST_STEPS))?;
        let (End::Repeats, Some(cycle)) = (look.end, look.destination) else { continue };
        let mut carrier = Carrier::of(posed, cycle.period)?;
        if let Some(found) = settled(&mut carrier, scaled(&look.motion.state()[..scales.len()]), cycle.period)? {
            return told(&mut carrier, found);
        }
    }
    Ok(None)
}

/// The cycle that a motion has settled on, now at `x`: a stable one where there is one, over one or several times the time
/// between two rises through zero.
fn settled(flow: &mut dyn Flow, x: Vec<f64>, between: f64) -> Result<Option<Periodic>> {
    let mut arrival = Arrival::at(x, between);
    while !arrival.advance(flow)? {}
    Ok(arrival.best)
}

/// The same, one search at a time.
struct Arrival {
    x: Vec<f64>,
    between: f64,
    searches: u32,
    best: Option<Periodic>,
}

impl Arrival {
    fn at(x: Vec<f64>, between: f64) -> Self {
        Self { x, between, searches: 0, best: None }
    }

    /// Searches once; says whether there is nothing more to search for.
    fn advance(&mut self, flow: &mut dyn Flow) -> Result<bool> {
        let Self { x, between, searches, best } = self;
        let found = if *searches == 0 {
            shooting::periodic(flow, x, *between)?
        } else {
            let odd = shooting::is_odd(flow, x);
            shooting::whole(flow, x, f64::from(*searches) * *between, odd)?
        };
        let near = found.filter(|found| shooting::gap(&found.x, x, 1.0) < NEAR);
        if near.as_ref().is_some_and(|found| best.is_none() || found.stable) {
            *best = near;
        }
        *searches += 1;
        Ok(*searches > MOST_ROUNDS || best.as_ref().is_some_and(|best| best.stable))
    }
}

/// Whether a motion that repeats, now at `x`, is on a cycle that its neighbours stay with: none where it does not get round.
///
/// # Errors
/// A matrix so extreme that its eigenvalues leave the numbers.
pub(crate) fn holds<S: Gear<N>, const N: usize>(
    posed: &Posed<S, N>,
    x: &[f64; N],
    period: f64,
) -> Result<Option<bool>> {
    let scales = posed.tables.description.state;
    let mut carrier = Carrier::of(posed, period)?;
    let x = vector(scales.len(), &|i| x[i] / scales[i].scale);
    let Some((_, around)) = carrier.carry(&x, period, true) else { return Ok(None) };
    let (_, others) = shooting::multipliers(&around, &carrier.rate(&x))?;
    Ok(Some(others.iter().all(|value| value.norm() < 1.0 + LEAVING)))
}

fn told(flow: &mut dyn Flow, mut found: Periodic) -> Result<Option<LimitCycle>> {
    let mut fineness = 2.0;
    while (found.trivial - 1.0).abs() > TRIVIAL && fineness <= FINEST {
        flow.pace(found.period, fineness);
        let Some(finer) = shooting::periodic(flow, &found.x, found.period)? else { break };
        found = finer;
        fineness *= 2.0;
    }
    let Periodic { x, period, multipliers, stable, symmetric, .. } = found;
    let Swing { amplitude, rise, .. } = flow.swing(&x, period)?;
    let orbit = flow.orbit(&rise, period)?;
    Ok(Some(LimitCycle { period, frequency: 1.0 / period, amplitude, multipliers, stable, symmetric, orbit }))
}
