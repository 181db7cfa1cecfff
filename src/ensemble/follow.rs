//! Motions from their starts to their ends.

use std::{cell::RefCell, rc::Rc};

use super::{
    bundle::Bundle,
    field::Field,
    judge::{Judge, LOST, NOISE, NOISE_OF_GAP, Verdict},
    lanes::{LANES, Lanes},
};
use crate::{
    Code, Run,
    error::Result,
    model::Prepared,
    outlook::{self, HORIZON, Lookout, Outlook, TRUSTED},
};

/// Steps of a stretch before its amplitude is measured, and those over which it is: four swings.
const AHEAD: usize = 600;
const MEASURED: usize = 400;
/// Amplitudes so near to each other, in parts of them, are of one motion of a gear.
const SAME: f64 = 1e-3;

/// How a motion ends: the order is that of [`super::KINDS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// At rest.
    Rest = 0,
    /// In a cycle that lives on the freeplay: without the gap it would die out.
    Rattle = 1,
    /// In a cycle that the tire sustains.
    Shimmy = 2,
    /// Beyond the range of the model, 0.5 rad, or without bounds.
    Divergence = 3,
    /// Still on its way, or never repeating, when its time was over.
    Unsettled = 4,
}

impl Fate {
    /// The fate of a number.
    pub fn numbered(number: u8) -> Option<Self> {
        [Self::Rest, Self::Rattle, Self::Shimmy, Self::Divergence, Self::Unsettled].get(usize::from(number)).copied()
    }

    /// Public name.
    pub fn name(self) -> &'static str {
        super::KINDS[self as usize]
    }
}

/// A motion to follow.
#[derive(Clone, Debug)]
pub(super) struct Start {
    /// Whose it is.
    pub place: usize,
    /// All parameters, in table order.
    pub values: Vec<f64>,
    /// The state.
    pub x: Vec<f64>,
}

/// A motion at its end.
#[derive(Clone, Debug)]
pub(super) struct Settled {
    pub fate: Fate,
    /// Largest |·| of every state: 0 at rest, [`LOST`] where it grows without bounds.
    pub amplitude: Vec<f64>,
    /// A state in it.
    pub x: Vec<f64>,
}

/// Who sends motions on their way, and is told of their ends.
pub(super) trait Errand {
    /// The model, and how long each motion has to settle.
    fn field(&self) -> &Field;
    /// The next one, if there is any now.
    fn next(&mut self) -> Option<Start>;
    /// Whether a motion that has not settled in its time is worth what it takes to tell where it goes.
    fn is_patient(&self) -> bool {
        false
    }
    /// The motion of this place has ended.
    fn settled(&mut self, place: usize, settled: Settled);
}

/// A gear made ready, and what is known of it.
#[derive(Debug)]
struct Ready {
    values: Vec<f64>,
    prepared: Prepared,
    /// Cycles that it has, and what they live on.
    known: RefCell<Vec<(f64, Fate)>>,
}

/// A motion in a lane.
#[derive(Clone, Debug)]
struct Motion {
    place: usize,
    ready: Rc<Ready>,
    judge: Judge,
    /// How many it has in all, and how many are left.
    stretches: usize,
    left: usize,
    /// The cycle that it has come to, while it is tried without the gap.
    cycle: Option<Settled>,
}

/// A motion that is followed by itself.
struct Alone {
    start: Start,
    lookout: Box<dyn Lookout>,
}

/// Motions on their way.
pub(super) struct Followers {
    bundle: Bundle,
    motions: [Option<Motion>; LANES],
    alone: Option<Alone>,
    /// Those that lanes have not brought to their end.
    late: Vec<Start>,
    /// The gear that came last: of a plane of starts it is the same for all.
    ready: Option<Rc<Ready>>,
}

impl Followers {
    /// Without any yet.
    pub fn new() -> Self {
        let motions = [const { None }; LANES];
        Self { bundle: Bundle::at_rest(), motions, alone: None, late: Vec::new(), ready: None }
    }

    /// Takes motions while there is room, and follows all for a stretch, or the one that is followed by itself. False where
    /// there was none.
    ///
    /// # Errors
    /// As [`Run::outlook`], of motions that are followed by themselves.
    pub fn advance(&mut self, errand: &mut dyn Errand) -> Result<bool> {
        if let Some(late) = self.late.pop() {
            let time = errand.field().duration.min(HORIZON);
            self.set_off_alone(errand, late, time)?;
        }
        if let Some(alone) = &mut self.alone {
            if let Some(settled) = ended(alone.lookout.advance(), &alone.start.x)? {
                errand.settled(alone.start.place, settled);
                self.alone = None;
            }
            return Ok(true);
        }
        for lane in 0..LANES {
            while self.motions[lane].is_none() {
                let Some(start) = errand.next() else { break };
                let field = errand.field();
                match self.ready(&field.run, &start.values) {
                    Some(ready) => self.set_off(lane, start, ready, field.duration),
                    None => {
                        let time = field.duration;
                        self.set_off_alone(errand, start, time)?;
                        return Ok(true);
                    }
                }
            }
        }
        if self.motions.iter().all(Option::is_none) {
            return Ok(false);
        }
        self.bundle.advance(AHEAD);
        let reach = self.bundle.measure(MEASURED).map(Lanes::each);
        for (lane, motion) in self.motions.iter_mut().enumerate() {
            let of_lane = |each: &[f64; LANES]| each[lane];
            let Some(going) = motion else { continue };
            let reach = [of_lane(&reach[0]), of_lane(&reach[1]), of_lane(&reach[2])];
            if let Some(settled) = going.judged(&mut self.bundle, lane, reach) {
                if settled.fate == Fate::Unsettled && errand.is_patient() {
                    self.late.push(Start { place: going.place, values: going.ready.values.clone(), x: settled.x });
                } else {
                    errand.settled(going.place, settled);
                }
                *motion = None;
            }
        }
        Ok(true)
    }

    fn set_off_alone(&mut self, errand: &mut dyn Errand, start: Start, time: f64) -> Result<()> {
        let run = &errand.field().run;
        // The ends of an axis are valid each by itself: with the other values a damper may not take what lies between.
        run.description().check(&start.values)?;
        let lookout = run.placed(&start.values, &start.x, time).problem().lookout()?;
        self.alone = Some(Alone { start, lookout });
        Ok(())
    }

    /// The gear of these parameters, if lanes can take it.
    fn ready(&mut self, run: &Run, values: &[f64]) -> Option<Rc<Ready>> {
        if !self.ready.as_ref().is_some_and(|ready| ready.values == values) {
            let prepared = (run.description().prepared)(values)?;
            self.ready = Some(Rc::new(Ready { values: values.to_vec(), prepared, known: RefCell::default() }));
        }
        self.ready.clone()
    }

    fn set_off(&mut self, lane: usize, start: Start, ready: Rc<Ready>, time: f64) {
        let Prepared { step, gear, gapless, small } = &ready.prepared;
        let noise = if gapless.is_some() { NOISE_OF_GAP } else { NOISE };
        self.bundle.load(lane, gear, [start.x[0], start.x[1] * step, start.x[2]]);
        let judge = Judge::new(*small, noise);
        let stretches = (time / (step * (AHEAD + MEASURED) as f64)).ceil() as usize;
        self.motions[lane] = Some(Motion { place: start.place, judge, stretches, left: stretches, ready, cycle: None });
    }
}

impl Motion {
    /// The end of the motion in this lane after a stretch with these amplitudes, or nothing where it goes on.
    fn judged(&mut self, bundle: &mut Bundle, lane: usize, reach: [f64; 3]) -> Option<Settled> {
        let Prepared { step, gapless, small, .. } = &self.ready.prepared;
        let verdict = self.judge.hear(if reach.iter().all(|reach| reach.is_finite()) { reach[0] } else { f64::NAN });
        self.left = self.left.saturating_sub(1);
        if self.cycle.is_some() {
            let fate = match verdict {
                Some(Verdict::Rests) => Fate::Rattle,
                None if self.left > 0 => return None,
                _ => Fate::Shimmy,
            };
            let cycle = self.cycle.take()?;
            self.ready.known.borrow_mut().push((cycle.amplitude[0], fate));
            return Some(Settled { fate, ..cycle });
        }
        let (fate, amplitude) = match verdict {
            Some(Verdict::Rests) => (Fate::Rest, 0.0),
            Some(Verdict::Diverges) => (Fate::Divergence, LOST),
            Some(Verdict::Repeats(amplitude)) if amplitude > TRUSTED => (Fate::Divergence, amplitude),
            Some(Verdict::Repeats(amplitude)) => (Fate::Shimmy, amplitude),
            None if self.left > 0 => return None,
            None => (Fate::Unsettled, self.judge.last()),
        };
        // The first state's amplitude is known better than the others', which go with it.
        let scale = if amplitude > 0.0 { amplitude / reach[0] } else { 0.0 };
        let others = [reach[1] / step, reach[2]].map(|reach| if amplitude < LOST { reach * scale } else { amplitude });
        let [psi, change, y] = bundle.state(lane);
        let mut settled =
            Settled { fate, amplitude: vec![amplitude, others[0], others[1]], x: vec![psi, change / step, y] };
        if let (Fate::Shimmy, Some(gapless)) = (fate, gapless) {
            let known = self.ready.known.borrow();
            match known.iter().find(|(other, _)| (other - amplitude).abs() < SAME * amplitude) {
                Some((_, known)) => settled.fate = *known,
                None => {
                    bundle.load(lane, gapless, [psi, change, y]);
                    self.judge = Judge::new(*small, NOISE);
                    self.left = self.stretches;
                    self.cycle = Some(settled);
                    return None;
                }
            }
        }
        Some(settled)
    }
}

/// The end of a motion that is followed by itself, from a state; nothing where it goes on.
fn ended(seen: Result<Option<Outlook>>, from: &[f64]) -> Result<Option<Settled>> {
    let outlook = match seen {
        // It has not come to its end in as many steps as it may take, or as time can tell apart.
        Err(error) if matches!(error.code, Code::StepLimit | Code::StepTooSmall) => {
            let amplitude = from.iter().map(|x| x.abs()).collect();
            return Ok(Some(Settled { fate: Fate::Unsettled, amplitude, x: from.to_vec() }));
        }
        seen => seen?,
    };
    let Some(outlook) = outlook else { return Ok(None) };
    let width = from.len();
    let fate = match outlook.verdict {
        outlook::Verdict::Shimmies => Fate::Shimmy,
        outlook::Verdict::DiesOut | outlook::Verdict::Rests => Fate::Rest,
        outlook::Verdict::Rattles => Fate::Rattle,
        outlook::Verdict::Grows => Fate::Divergence,
    };
    let amplitude = match fate {
        Fate::Rest => vec![0.0; width],
        // What grew so far would have grown on.
        Fate::Divergence if outlook.frequency.is_none() || outlook.amplitude[0] > LOST => vec![LOST; width],
        _ => outlook.amplitude,
    };
    let first = outlook.orbit.states.iter().map(|column| column.first().copied());
    let x = first.collect::<Option<Vec<f64>>>().unwrap_or_else(|| vec![0.0; width]);
    Ok(Some(Settled { fate, amplitude, x }))
}
