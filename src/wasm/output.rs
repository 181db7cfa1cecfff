//! From results to plain JavaScript objects.

use nalgebra::Complex;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::record::{Record, list, numbers};
use crate::{
    Error, Run,
    cycles::{Bifurcation, CycleBranch, CyclePoint, FoldCurve, LimitCycle, Predicted, SpecialPoint},
    energy::Energy,
    ensemble::{self, Basins, Ending, Sweep, Way},
    integrate::{Stats, Trajectory},
    live::{Columns, Envelope},
    model::{
        laws::{ForceColumns, ForceLaws, Forces, Kinks},
        torsional::LinkedParameters,
    },
    outlook::Outlook,
    parameter::StateVariable,
    scenario::Landing,
    section::Section,
    spectrum::Spectrum,
    stability::{
        Crossing, Eigenmode, EnergyFlow, HopfCurve, KINDS, RouthArray, RouthHurwitz, StabilityMap, UnstableInterval,
    },
};

/// The tables, as they are. Results are written field by field: serde's code for a type is several times theirs.
pub(super) fn table(value: &impl Serialize) -> Result<JsValue, JsValue> {
    value.serialize(&serde_wasm_bindgen::Serializer::new().serialize_maps_as_objects(true)).map_err(JsValue::from)
}

/// An `Error` with its data as properties.
#[inline(never)]
pub(super) fn error(error: Error) -> JsValue {
    let suggestion = error.suggestion.map_or(JsValue::NULL, JsValue::from_str);
    Record::onto(js_sys::Error::new(&error.to_string()).into())
        .text("code", error.code.name())
        .text("field", &error.field)
        .text("value", &error.value)
        .text("allowed", &error.allowed)
        .value("suggestion", suggestion)
        .done()
}

/// One number per state.
#[inline(never)]
pub(super) fn by_state(states: &[StateVariable], values: &[f64]) -> Record {
    states.iter().zip(values).fold(Record::new(), |record, (state, value)| record.number(state.name, *value))
}

/// `time` and one array per state.
#[inline(never)]
fn columns_of(states: &[StateVariable], time: &[f64], columns: &[Vec<f64>]) -> Record {
    let record = Record::new().series("time", time);
    states.iter().zip(columns).fold(record, |record, (state, column)| record.series(state.name, column))
}

pub(super) fn columns(states: &[StateVariable], columns: &Columns) -> JsValue {
    columns_of(states, &columns.time, &columns.states).done()
}

#[inline(never)]
pub(super) fn envelope(envelope: &Envelope) -> JsValue {
    Record::new().series("time", &envelope.time).series("low", &envelope.low).series("high", &envelope.high).done()
}

pub(super) fn trajectory(run: &Run, trajectory: &Trajectory) -> JsValue {
    trajectory_of(run, trajectory).done()
}

/// A trajectory, and the speed at its times.
pub(super) fn landing(run: &Run, landing: &Landing) -> JsValue {
    trajectory_of(run, &landing.trajectory).series("velocity", &landing.velocity).done()
}

#[inline(never)]
fn trajectory_of(run: &Run, trajectory: &Trajectory) -> Record {
    let Trajectory { time, states, events, stats, scheme } = trajectory;
    let happened = Record::new().series("time", &events.time).bytes("kind", &events.kind).names("kinds", events.kinds);
    columns_of(run.description().state, time, states)
        .record("events", happened)
        .record("stats", statistics(*stats, scheme.name()))
}

fn statistics(stats: Stats, method: &str) -> Record {
    Record::new()
        .text("method", method)
        .number("steps", stats.steps as f64)
        .number("rejected", stats.rejected as f64)
        .number("evaluations", stats.evaluations as f64)
        .number("events", stats.events as f64)
        .truth("stiff", stats.stiff)
}

pub(super) fn outlook(run: &Run, outlook: &Outlook) -> JsValue {
    let states = run.description().state;
    let present = Record::new()
        .number("amplitude", outlook.present_amplitude)
        .maybe("frequency", outlook.present_frequency)
        .text("trend", outlook.trend.name())
        .value("stable", outlook.stable.map_or(JsValue::NULL, JsValue::from_bool));
    Record::new()
        .text("verdict", outlook.verdict.name())
        .truth("settled", outlook.settled)
        .truth("held", outlook.held)
        .record("amplitude", by_state(states, &outlook.amplitude))
        .maybe("frequency", outlook.frequency)
        .record("present", present)
        .value("envelope", envelope(&outlook.envelope))
        .value("orbit", columns(states, &outlook.orbit))
        .done()
}

pub(super) fn energy(energy: &Energy) -> JsValue {
    Record::new()
        .number("duration", energy.duration)
        .number("tire", energy.tire)
        .number("damper", energy.damper)
        .number("treadWidth", energy.tread_width)
        .number("friction", energy.friction)
        .number("mrDamper", energy.fitted)
        .number("kinetic", energy.kinetic)
        .number("spring", energy.spring)
        .number("stored", energy.stored)
        .done()
}

pub(super) fn forces(forces: &Forces) -> JsValue {
    Record::new()
        .number("slipAngle", forces.slip_angle)
        .number("sideForce", forces.side_force)
        .number("aligningMoment", forces.aligning_moment)
        .truth("sideForceLimited", forces.side_force_limited)
        .number("springAngle", forces.spring_angle)
        .number("springTorque", forces.spring_torque)
        .number("frictionTorque", forces.friction_torque)
        .number("damperForce", forces.damper_force)
        .number("damperTorque", forces.damper_torque)
        .done()
}

pub(super) fn forces_along(columns: &ForceColumns) -> JsValue {
    Record::new()
        .series("slipAngle", &columns.slip_angle)
        .series("sideForce", &columns.side_force)
        .series("aligningMoment", &columns.aligning_moment)
        .series("springTorque", &columns.spring_torque)
        .series("frictionTorque", &columns.friction_torque)
        .series("damperForce", &columns.damper_force)
        .series("damperTorque", &columns.damper_torque)
        .done()
}

pub(super) fn force_laws(laws: &ForceLaws) -> JsValue {
    let Kinks { side_force_limit_angle, aligning_moment_limit_angle, freeplay_angle } = laws.kinks;
    let kinks = Record::new()
        .maybe("sideForceLimitAngle", side_force_limit_angle)
        .maybe("aligningMomentLimitAngle", aligning_moment_limit_angle)
        .maybe("freeplayAngle", freeplay_angle);
    Record::new()
        .series("slipAngle", &laws.slip_angle)
        .series("sideForce", &laws.side_force)
        .series("aligningMoment", &laws.aligning_moment)
        .series("torsionAngle", &laws.torsion_angle)
        .series("restoringMoment", &laws.restoring_moment)
        .record("kinks", kinks)
        .done()
}

pub(super) fn linked_parameters(linked: &LinkedParameters) -> JsValue {
    Record::new()
        .number("relaxationLength", linked.relaxation_length)
        .number("treadWidthMomentConstant", linked.tread_width_moment_constant)
        .done()
}

pub(super) fn spectrum(spectrum: &Spectrum) -> JsValue {
    let peak = spectrum.peak.map_or(JsValue::NULL, |peak| {
        Record::new().number("frequency", peak.frequency).number("amplitude", peak.amplitude).done()
    });
    Record::new()
        .series("frequency", &spectrum.frequency)
        .series("amplitude", &spectrum.amplitude)
        .value("peak", peak)
        .done()
}

pub(super) fn routh_hurwitz(verdict: &RouthHurwitz) -> JsValue {
    Record::new()
        .truth("stable", verdict.stable)
        .numbers("column", &verdict.column)
        .numbers("criticalVelocities", &verdict.critical_velocities)
        .maybe("criticalDamping", verdict.critical_damping)
        .done()
}

pub(super) fn routh_array(array: &RouthArray) -> JsValue {
    let special = list(&array.special, |special| special.map_or(JsValue::NULL, |special| special.name().into()));
    let replaced = list(&array.replaced, |row| row.as_ref().map_or(JsValue::NULL, |row| numbers(row)));
    Record::new()
        .numbers("coefficients", &array.coefficients)
        .value("rows", list(&array.rows, |row| numbers(row)))
        .value("special", special)
        .value("replaced", replaced)
        .number("unstableRoots", array.unstable_roots as f64)
        .number("neutralRoots", array.neutral_roots as f64)
        .truth("stable", array.stable)
        .done()
}

pub(super) fn unstable_interval(interval: &UnstableInterval) -> JsValue {
    Record::new()
        .number("from", interval.from)
        .number("to", interval.to)
        .text("fromKind", interval.from_kind.name())
        .text("toKind", interval.to_kind.name())
        .done()
}

pub(super) fn crossing(crossing: &Crossing) -> JsValue {
    Record::new()
        .number("value", crossing.value)
        .text("kind", crossing.kind.name())
        .number("frequency", crossing.frequency)
        .done()
}

fn complex_of(value: Complex<f64>) -> Record {
    Record::new().number("re", value.re).number("im", value.im)
}

pub(super) fn complex(value: Complex<f64>) -> JsValue {
    complex_of(value).done()
}

pub(super) fn eigenmode(states: &[StateVariable], mode: &Eigenmode) -> JsValue {
    let shape = states.iter().zip(&mode.shape).fold(Record::new(), |shape, (state, part)| {
        let phasor = complex_of(*part).number("amplitude", part.norm()).number("lag", (-part.im).atan2(part.re));
        shape.record(state.name, phasor)
    });
    Record::new()
        .value("eigenvalue", complex(mode.eigenvalue))
        .maybe("dampingRatio", mode.damping_ratio)
        .number("naturalFrequency", mode.natural_frequency)
        .maybe("timeToHalf", mode.time_to_half)
        .maybe("timeToDouble", mode.time_to_double)
        .text("reference", states[mode.reference].name)
        .record("shape", shape)
        .value("energyFlow", mode.energy_flow.as_ref().map_or(JsValue::NULL, energy_flow))
        .done()
}

fn energy_flow(flow: &EnergyFlow) -> JsValue {
    Record::new()
        .number("tire", flow.tire)
        .number("damper", flow.damper)
        .number("treadWidth", flow.tread_width)
        .number("mrDamper", flow.fitted)
        .number("kinetic", flow.kinetic)
        .number("spring", flow.spring)
        .number("stored", flow.stored)
        .done()
}

/// Fields without a value are `null`, and lists empty, where none was found.
pub(super) fn limit_cycle(states: &[StateVariable], found: Option<&LimitCycle>) -> JsValue {
    let truth = |truth: Option<bool>| truth.map_or(JsValue::NULL, JsValue::from);
    let (amplitude, multipliers) = found.map_or((&[][..], &[][..]), |cycle| (&cycle.amplitude, &cycle.multipliers));
    let orbit = found.map_or_else(
        || columns_of(states, &[], &vec![Vec::new(); states.len()]).done(),
        |cycle| columns(states, &cycle.orbit),
    );
    Record::new()
        .truth("found", found.is_some())
        .maybe("period", found.map(|cycle| cycle.period))
        .maybe("frequency", found.map(|cycle| cycle.frequency))
        .value("stable", truth(found.map(|cycle| cycle.stable)))
        .value("symmetric", truth(found.map(|cycle| cycle.symmetric)))
        .record("amplitude", by_state(states, amplitude))
        .value("multipliers", list(multipliers, |value| complex(*value)))
        .value("orbit", orbit)
        .done()
}

pub(super) fn predicted(cycle: &Predicted) -> JsValue {
    let amplitude = Record::new()
        .number("torsionAngle", cycle.amplitude.torsion_angle)
        .number("lateralDeformation", cycle.amplitude.lateral_deformation)
        .number("slipAngle", cycle.amplitude.slip_angle);
    Record::new()
        .record("amplitude", amplitude)
        .number("frequency", cycle.frequency)
        .truth("stable", cycle.stable)
        .done()
}

/// What there is of a diagram.
pub(super) fn bifurcation(diagram: &Bifurcation) -> JsValue {
    let (parameter, states) = (diagram.parameter(), diagram.spec().run.description().state);
    let rest = diagram.rest();
    let columns =
        states.iter().zip(&rest.states).fold(Record::new(), |record, (s, column)| record.series(s.name, column));
    let equilibria = Record::new()
        .series(parameter, &rest.value)
        .record("state", columns)
        .series("growthRate", &rest.growth_rate)
        .series("frequency", &rest.frequency)
        .bytes("unstable", &rest.unstable)
        .bytes("stable", &rest.stable);
    Record::new()
        .text("parameter", parameter)
        .record("equilibria", equilibria)
        .value("cycles", list(&diagram.cycles(), |branch| cycle_branch(parameter, states, branch)))
        .value("points", list(diagram.points(), |point| special_point(parameter, point)))
        .done()
}

fn cycle_branch(parameter: &str, states: &[StateVariable], branch: &CycleBranch) -> JsValue {
    let column = |of: &dyn Fn(&CyclePoint) -> f64| branch.points.iter().map(of).collect::<Vec<f64>>();
    let flags = |of: &dyn Fn(&CyclePoint) -> u8| branch.points.iter().map(of).collect::<Vec<u8>>();
    let by_state = |of: &dyn Fn(&CyclePoint) -> &[f64]| {
        states
            .iter()
            .enumerate()
            .fold(Record::new(), |record, (i, state)| record.series(state.name, &column(&|point| of(point)[i])))
    };
    let multipliers: Vec<f64> = branch
        .points
        .iter()
        .flat_map(|point| point.multipliers.iter().flat_map(|value| [value.re, value.im]))
        .collect();
    Record::new()
        .series(parameter, &column(&|point| point.value))
        .series("amplitude", &column(&|point| point.amplitude[0]))
        .series("period", &column(&|point| point.period))
        .series("frequency", &column(&|point| 1.0 / point.period))
        .record("amplitudes", by_state(&|point| &point.amplitude))
        .record("state", by_state(&|point| &point.state))
        .series("multipliers", &multipliers)
        .bytes("unstable", &flags(&|point| point.unstable as u8))
        .bytes("stable", &flags(&|point| u8::from(point.unstable == 0)))
        .bytes("symmetric", &flags(&|point| u8::from(point.symmetric)))
        .names("ends", &branch.ends.map(|end| end.name()))
        .done()
}

fn special_point(parameter: &str, point: &SpecialPoint) -> JsValue {
    let name = |name: Option<&str>| name.map_or(JsValue::NULL, JsValue::from_str);
    Record::new()
        .text("kind", point.kind.name())
        .number(parameter, point.value)
        .number("amplitude", point.amplitude)
        .number("frequency", point.frequency)
        .maybe("branch", point.branch.map(|branch| branch as f64))
        .number("index", point.index as f64)
        .value("criticality", name(point.criticality.map(|(criticality, _)| criticality.name())))
        .value("by", name(point.criticality.map(|(_, told)| told.name())))
        .maybe("lyapunov", point.lyapunov)
        .done()
}

pub(super) fn hopf_curve(curve: &HopfCurve) -> JsValue {
    Record::new()
        .series("x", &curve.x)
        .series("y", &curve.y)
        .series("frequency", &curve.frequency)
        .text("kind", curve.kind.name())
        .truth("closed", curve.closed)
        .truth("bounds", curve.bounds)
        .done()
}

pub(super) fn fold_curve(curve: &FoldCurve) -> JsValue {
    Record::new()
        .series("x", &curve.x)
        .series("y", &curve.y)
        .series("frequency", &curve.frequency)
        .series("amplitude", &curve.amplitude)
        .text("kind", "fold")
        .truth("closed", curve.closed)
        .truth("bounds", curve.bounds)
        .done()
}

/// What there is of a map.
pub(super) fn stability_map(map: &StabilityMap) -> crate::Result<JsValue> {
    let (cells, wanted) = (map.cells(), map.spec().quantities);
    let mut record = Record::new()
        .bytes("stable", &cells.stable[..cells.made])
        .maybe("stablePercent", map.stable_percent())
        .maybe("stableArea", map.stable_area()?);
    if wanted.growth_rate {
        record = record.series("growthRate", &cells.growth_rate[..cells.made]);
    }
    if wanted.frequency {
        record = record.series("frequency", &cells.frequency[..cells.made]);
    }
    if wanted.kind {
        record = record.bytes("kind", &cells.kind[..cells.made]).names("kinds", &KINDS);
    }
    Ok(record.done())
}

/// What there is of basins.
pub(super) fn basins(basins: &Basins) -> JsValue {
    let (endings, places) = basins.endings();
    Record::new()
        .bytes("kind", basins.kind())
        .names("kinds", &ensemble::KINDS)
        .series("amplitude", basins.amplitude())
        .number("apart", basins.apart())
        .bytes("ending", &places)
        .value("endings", list(&endings, ending))
        .number("followed", basins.followed() as f64)
        .done()
}

fn ending(ending: &Ending) -> JsValue {
    Record::new()
        .text("kind", ending.fate.name())
        .number("low", ending.low)
        .number("high", ending.high)
        .number("cells", ending.cells as f64)
        .done()
}

/// What there is of a sweep.
pub(super) fn sweep(sweep: &Sweep) -> JsValue {
    let way = |way: &Way| {
        let record = Record::new().bytes("kind", &way.kind).series("amplitude", &way.amplitude);
        record.bytes("settled", &way.settled)
    };
    Record::new()
        .series("value", &sweep.values())
        .record("up", way(sweep.up()))
        .record("down", way(sweep.down()))
        .names("kinds", &ensemble::KINDS)
        .done()
}

pub(super) fn section(states: &[StateVariable], section: &Section) -> JsValue {
    let record = columns_of(states, &section.time, &section.states);
    record.series("amplitude", &section.amplitude).done()
}
