//! What becomes of a motion: does it shake, die out, rattle, or grow beyond the model.

mod approach;
mod look;
mod watch;

use self::look::Look;
pub(crate) use self::{
    look::{Ahead, look_ahead},
    watch::End,
};
use crate::{
    cycles,
    error::{Error, Result},
    integrate::{Integrator, failed},
    live::{Columns, Envelope},
    model::Gear,
    run::Posed,
};

/// How far ahead one looks where the run does not say, in s.
pub(crate) const HORIZON: f64 = 6.0;
/// Swings beyond this leave the range of the kinematics (vψ for v sin ψ), in rad.
pub(crate) const TRUSTED: f64 = 0.5;
/// A swing whose amplitude changes by less than this from the first cycle on repeats from the start.
const STAYS: f64 = 1e-6;
/// Points of the orbit.
const ORBIT: usize = 128;

/// The verdict, in one word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Goes to a limit cycle that the tire sustains.
    Shimmies,
    /// Goes to rest.
    DiesOut,
    /// Goes to a limit cycle that lives on the freeplay: without the gap it would die out.
    Rattles,
    /// Grows beyond the range of the model.
    Grows,
    /// Is at rest, or comes to rest away from the middle, as where dry friction holds the wheel, or a hysteresis that may rest
    /// anywhere.
    Rests,
}

impl Verdict {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Shimmies => "shimmies",
            Self::DiesOut => "dies-out",
            Self::Rattles => "rattles",
            Self::Grows => "grows",
            Self::Rests => "rests",
        }
    }
}

/// Which way the amplitude goes now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trend {
    /// From cycle to cycle it gets larger.
    Growing,
    /// From cycle to cycle it gets smaller.
    Falling,
    /// It stays.
    Steady,
}

impl Trend {
    /// Public name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Growing => "growing",
            Self::Falling => "falling",
            Self::Steady => "steady",
        }
    }
}

/// What becomes of a motion if nothing changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Outlook {
    /// In one word.
    pub verdict: Verdict,
    /// It has arrived there from the start on, and stays: it is not on an unstable cycle.
    pub settled: bool,
    /// Where it rests, dry friction holds it away from the middle.
    pub held: bool,
    /// Largest |·| of every state over a cycle of the motion it goes to.
    pub amplitude: Vec<f64>,
    /// Cycles per second of that motion; none where it does not oscillate.
    pub frequency: Option<f64>,
    /// Amplitude of the first state in the first cycle.
    pub present_amplitude: f64,
    /// Frequency of the first cycle.
    pub present_frequency: Option<f64>,
    /// Which way the amplitude goes at the start.
    pub trend: Trend,
    /// Of a swing that repeats from the start on: whether its neighbours stay with it. Where they do not, it is on an
    /// unstable cycle, and the smallest push decides where it goes. None of a motion that changes, or of rest.
    pub stable: Option<bool>,
    /// Least and greatest value of the first state, cycle by cycle, up to the arrival or the horizon.
    pub envelope: Envelope,
    /// One period of the motion it goes to; empty where it goes to rest or beyond.
    pub orbit: Columns,
}

/// An outlook under way: what takes long is done bit by bit.
pub trait Lookout {
    /// Looks a little further, for a fraction of a millisecond; gives the outlook once it is there.
    ///
    /// # Errors
    /// As [`crate::Run::outlook`].
    fn advance(&mut self) -> Result<Option<Outlook>>;
}

/// Steps of a motion at a time: a fraction of a millisecond.
pub(crate) const STEPS: usize = 500;

/// What a run's lookout does now.
enum Stage<S, const N: usize> {
    Resting(Outlook),
    Ahead(Box<Ahead<S, N>>),
    /// It repeats: whether it does so without the gap, too.
    Gapless(Box<Look<S, N>>, Box<Ahead<S, N>>),
    Over,
}

/// The lookout of a run.
pub(crate) struct Looking<S: 'static, const N: usize> {
    posed: Posed<S, N>,
    stage: Stage<S, N>,
}

impl<S: Gear<N>, const N: usize> Looking<S, N> {
    /// At the start of a run.
    pub fn of(posed: Posed<S, N>) -> Result<Self> {
        let motion = posed.motion(posed.run.horizon() / 20.0)?;
        let stage = if motion.derivative().iter().all(|rate| *rate == 0.0) {
            Stage::Resting(resting(&posed.initial()[..posed.system.width()], posed.system.sticks()))
        } else {
            Stage::Ahead(Self::ahead(&posed, motion))
        };
        Ok(Self { posed, stage })
    }

    fn ahead(posed: &Posed<S, N>, motion: Integrator<S, N>) -> Box<Ahead<S, N>> {
        let Posed { run, tables, .. } = posed;
        Box::new(Ahead::of(motion, tables.description.state, run.horizon(), run.max_steps()))
    }

    /// The motion without its gap, where there is one and that matters.
    fn gapless(&self, look: &Look<S, N>) -> Result<Option<Box<Ahead<S, N>>>> {
        let repeats =
            matches!((&look.end, &look.destination), (End::Repeats, Some(cycle)) if cycle.amplitude[0] <= TRUSTED);
        let Some(system) = self.posed.system.without_freeplay().filter(|_| repeats) else { return Ok(None) };
        let mut motion = self.posed.motion(self.posed.run.horizon() / 20.0)?;
        motion.replace(system.into(), 0.0, *look.motion.state()).map_err(|failure| failed(failure, 0.0))?;
        Ok(Some(Self::ahead(&self.posed, motion)))
    }
}

impl<S: Gear<N>, const N: usize> Lookout for Looking<S, N> {
    fn advance(&mut self) -> Result<Option<Outlook>> {
        match std::mem::replace(&mut self.stage, Stage::Over) {
            Stage::Resting(outlook) => return Ok(Some(outlook)),
            Stage::Ahead(mut ahead) => {
                if !ahead.follow(STEPS)? {
                    self.stage = Stage::Ahead(ahead);
                    return Ok(None);
                }
                let look = Box::new(ahead.seen()?);
                match self.gapless(&look)? {
                    Some(ahead) => self.stage = Stage::Gapless(look, ahead),
                    None => return told(&self.posed, *look, false).map(Some),
                }
            }
            Stage::Gapless(look, mut ahead) => {
                if ahead.follow(STEPS)? {
                    let dies = matches!(ahead.seen()?.end, End::Dies | End::Stops);
                    return told(&self.posed, *look, dies).map(Some);
                }
                self.stage = Stage::Gapless(look, ahead);
            }
            Stage::Over => {}
        }
        Ok(None)
    }
}

/// What a look shows; `rattles`: where it repeats, without the gap it would not.
fn told<S: Gear<N>, const N: usize>(posed: &Posed<S, N>, mut look: Look<S, N>, rattles: bool) -> Result<Outlook> {
    let x = posed.initial();
    let (mut amplitude, frequency) = match &look.destination {
        Some(cycle) if !matches!(look.end, End::Stops) => (cycle.amplitude, Some(1.0 / cycle.period)),
        _ => (std::array::from_fn(|i| look.motion.state()[i].abs()), None),
    };
    let verdict = match look.end {
        End::Dies => Verdict::DiesOut,
        End::Grows => Verdict::Grows,
        End::Stops => Verdict::Rests,
        End::Repeats if amplitude[0] > TRUSTED => Verdict::Grows,
        End::Repeats if rattles => Verdict::Rattles,
        End::Repeats => Verdict::Shimmies,
    };
    let (present_amplitude, present_frequency, trend) = present(&look, x[0]);
    let width = posed.system.width();
    let mut orbit = Columns { time: Vec::new(), states: vec![Vec::new(); width] };
    let mut stable = None;
    if let (End::Repeats, Some(cycle)) = (&look.end, look.destination) {
        if look.cycles.first().is_some_and(|first| (first.amplitude[0] / cycle.amplitude[0] - 1.0).abs() < STAYS) {
            stable = cycles::holds(posed, look.motion.state(), cycle.period)?;
        }
        let round = once_round(&mut look, cycle.period)?;
        amplitude = std::array::from_fn(|i| amplitude[i].max(round.1[i]));
        if verdict != Verdict::Grows {
            orbit = round.0;
        }
    }
    let arrived = matches!(verdict, Verdict::Shimmies | Verdict::Rattles)
        && (present_amplitude / amplitude[0] - 1.0).abs() < 1e-3;
    Ok(Outlook {
        verdict,
        settled: arrived && stable != Some(false),
        held: verdict == Verdict::Rests && look::held(&look.motion),
        amplitude: if verdict == Verdict::DiesOut { vec![0.0; width] } else { amplitude[..width].to_vec() },
        frequency: if verdict == Verdict::DiesOut { None } else { frequency },
        present_amplitude,
        present_frequency,
        trend: if arrived { Trend::Steady } else { trend },
        stable,
        envelope: envelope(&look, x[0]),
        orbit,
    })
}

fn resting(x: &[f64], sticks: bool) -> Outlook {
    Outlook {
        verdict: Verdict::Rests,
        settled: true,
        held: sticks && x[0] != 0.0,
        amplitude: x.iter().map(|x| x.abs()).collect(),
        frequency: None,
        present_amplitude: x[0].abs(),
        present_frequency: None,
        trend: Trend::Steady,
        stable: None,
        envelope: Envelope { time: vec![0.0], low: vec![x[0]], high: vec![x[0]] },
        orbit: Columns { time: Vec::new(), states: vec![Vec::new(); x.len()] },
    }
}

/// Amplitude, frequency and trend of the first cycle.
fn present<S, const N: usize>(look: &Look<S, N>, start: f64) -> (f64, Option<f64>, Trend) {
    let size = |turn: Option<&(f64, f64)>| turn.map(|(_, value)| value.abs());
    let amplitude = match (size(look.turns.first()), size(look.turns.get(1))) {
        (Some(first), Some(second)) => first.max(second),
        (Some(first), None) => first.max(start.abs()),
        _ => start.abs(),
    };
    let frequency = match look.turns.as_slice() {
        [first, _, third, ..] => Some(1.0 / (third.0 - first.0)),
        [first, second] => Some(0.5 / (second.0 - first.0)),
        _ => None,
    };
    let trend = match (look.cycles.as_slice(), &look.end) {
        ([first, .., last], _) if (last.amplitude[0] / first.amplitude[0] - 1.0).abs() < 1e-6 => Trend::Steady,
        ([first, second, ..], _) if second.amplitude[0] > first.amplitude[0] => Trend::Growing,
        ([_, _, ..], _) => Trend::Falling,
        (_, End::Grows) => Trend::Growing,
        _ => Trend::Falling,
    };
    (amplitude, frequency, trend)
}

fn envelope<S: Gear<N>, const N: usize>(look: &Look<S, N>, start: f64) -> Envelope {
    let mut envelope = Envelope { time: Vec::new(), low: Vec::new(), high: Vec::new() };
    let mut take = |t: f64, low: f64, high: f64| {
        envelope.time.push(t);
        envelope.low.push(low);
        envelope.high.push(high);
    };
    let reach = look.turns.first().map_or(start.abs(), |(_, value)| value.abs()).max(start.abs());
    match look.cycles.first() {
        Some(first) => {
            take(0.0, first.low.min(-reach), first.high.max(reach));
            for cycle in &look.cycles {
                take(cycle.start + 0.5 * cycle.period, cycle.low, cycle.high);
            }
        }
        None => {
            let last = look.motion.state()[0];
            take(0.0, start.min(0.0), start.max(0.0));
            take(look.motion.time(), last.min(0.0), last.max(0.0));
        }
    }
    envelope
}

/// One period from where the motion is, and the largest |·| of every state in it.
fn once_round<S: Gear<N>, const N: usize>(look: &mut Look<S, N>, period: f64) -> Result<(Columns, [f64; N])> {
    let width = look.motion.system().width();
    let mut columns = Columns { time: Vec::new(), states: vec![Vec::new(); width] };
    let mut amplitude = [0.0_f64; N];
    let start = look.motion.time();
    for point in 0..=ORBIT {
        let t = start + period * point as f64 / ORBIT as f64;
        while look.motion.time() < t {
            look.motion.step(f64::INFINITY).map_err(|failure| -> Error { failed(failure, start) })?;
            for (component, amplitude) in amplitude.iter_mut().enumerate() {
                if let Some((_, value)) = look.motion.turning_point(component) {
                    *amplitude = amplitude.max(value.abs());
                }
            }
        }
        columns.time.push(t - start);
        for (column, value) in columns.states.iter_mut().zip(look.motion.interpolate(t)) {
            column.push(value);
        }
    }
    Ok((columns, amplitude))
}
