//! Long work in slices, as a JavaScript class.

use std::cell::RefCell;

use js_sys::Date;
use wasm_bindgen::prelude::*;

use super::{
    call_into, input, output,
    record::{Record, list},
};
use crate::{
    cycles::{Bifurcation, BifurcationSpec, FoldCurves, FoldSpec},
    ensemble::{Basins, BasinsSpec, Sweep, SweepSpec},
    error::{Code, Error, Result, shown},
    identify::{Identification, IdentificationSpec},
    run::Value,
    scenario::LandingRoll,
    stability::{MapSpec, StabilityMap},
};

/// What is done bit by bit.
trait Work {
    /// Does some more of it: a fraction of a millisecond.
    fn advance(&mut self) -> Result<()>;
    /// Nothing is left to do.
    fn done(&self) -> bool;
    /// The part that is done, 0 … 1.
    fn fraction(&self) -> f64;
    /// What is there so far.
    fn result(&self) -> Result<JsValue>;
}

/// A kind of work, written down by the functions that do it.
macro_rules! work {
    ($($work:ty: $result:expr;)*) => {
        $(impl Work for $work {
            fn advance(&mut self) -> Result<()> {
                self.advance()
            }
            fn done(&self) -> bool {
                self.done()
            }
            fn fraction(&self) -> f64 {
                self.fraction()
            }
            fn result(&self) -> Result<JsValue> {
                $result(self)
            }
        })*
    };
}

work! {
    StabilityMap: output::stability_map;
    Bifurcation: |diagram| Ok(output::bifurcation(diagram));
    FoldCurves: |curves: &Self| Ok(list(curves.curves(), output::fold_curve));
    Basins: |basins| Ok(output::basins(basins));
    Sweep: |sweep| Ok(output::sweep(sweep));
    Identification: super::identify::progress;
    LandingRoll: |roll: &Self| Ok(output::landing(roll.run(), &roll.landing()));
}

/// A kind of jobs.
struct Kind {
    name: &'static str,
    /// What errors call what it is given.
    spec: &'static str,
    begin: fn(&Value) -> Result<Box<dyn Work>>,
}

const KINDS: [Kind; 7] = [
    Kind { name: "stabilityMap", spec: "map", begin: |spec| Ok(Box::new(MapSpec::read(spec)?.begin())) },
    Kind {
        name: "bifurcation",
        spec: "bifurcation",
        begin: |spec| Ok(Box::new(BifurcationSpec::read(spec)?.begin()?)),
    },
    Kind { name: "foldCurve", spec: "plane", begin: |spec| Ok(Box::new(FoldSpec::read(spec)?.begin()?)) },
    Kind { name: "basins", spec: "basins", begin: |spec| Ok(Box::new(BasinsSpec::read(spec)?.begin())) },
    Kind { name: "landingRoll", spec: "run", begin: |spec| Ok(Box::new(LandingRoll::read(spec)?)) },
    Kind { name: "sweep", spec: "sweep", begin: |spec| Ok(Box::new(SweepSpec::read(spec)?.begin())) },
    Kind {
        name: "identification",
        spec: "identification",
        begin: |spec| Ok(Box::new(IdentificationSpec::read(spec)?.begin())),
    },
];

/// The work of a kind before it begins.
#[inline(never)]
fn begun(kind: &str, spec: &JsValue) -> Result<Box<dyn Work>> {
    let Some(known) = KINDS.iter().find(|known| known.name == kind) else {
        return Err(Error::unknown(Code::UnknownName, "kind", kind, &KINDS.map(|known| known.name)));
    };
    (known.begin)(&input::value(spec, known.spec)?)
}

/// The work of a kind, done.
pub(super) fn whole(kind: &str, spec: &JsValue) -> std::result::Result<JsValue, JsValue> {
    let done = || {
        let mut work = begun(kind, spec)?;
        while !work.done() {
            work.advance()?;
        }
        work.result()
    };
    done().map_err(output::error)
}

/// Work that is done bit by bit.
#[wasm_bindgen]
pub struct Job(RefCell<Box<dyn Work>>);

#[wasm_bindgen]
impl Job {
    /// The work of the function of this name, with what that is given.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "keyof Jobs")] kind: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Jobs[keyof Jobs]['spec']")] spec: JsValue,
    ) -> std::result::Result<Job, JsValue> {
        let begun = input::text(&kind, "kind").and_then(|kind| begun(&kind, &spec));
        begun.map(|work| Self(RefCell::new(work))).map_err(output::error)
    }

    /// Works on for about so many milliseconds, and tells how much is done.
    #[wasm_bindgen(unchecked_return_type = "Progress")]
    pub fn advance(
        &self,
        #[wasm_bindgen(unchecked_param_type = "number")] milliseconds: JsValue,
    ) -> std::result::Result<JsValue, JsValue> {
        self.with(|work| {
            let allowed = "≥ 0 ms";
            let time = input::number(&milliseconds, "milliseconds", allowed)?;
            if time.is_nan() || time < 0.0 {
                return Err(Error::new(Code::OutOfRange, "milliseconds", shown(time), allowed));
            }
            let end = Date::now() + time;
            loop {
                work.advance()?;
                if work.done() || Date::now() >= end {
                    break;
                }
            }
            Ok(Record::new().truth("done", work.done()).number("fraction", work.fraction()).done())
        })
    }

    /// What is there so far: what the function of the job's name gives, its arrays no longer than that.
    #[wasm_bindgen(unchecked_return_type = "Jobs[keyof Jobs]['part']")]
    pub fn result(&self) -> std::result::Result<JsValue, JsValue> {
        self.with(|work| work.result())
    }
}

impl Job {
    fn with(&self, call: impl FnOnce(&mut dyn Work) -> Result<JsValue>) -> std::result::Result<JsValue, JsValue> {
        call_into(&self.0, "job", |work| call(work.as_mut()))
    }
}
