/** Values of parameters by name, SI units, those of elements by dotted names too; a missing one takes its default. */
export type Parameters = Record<string, number>;
/** One parameter of a table. `min`, `max`: a slider's range; what is valid is wider, see `doc`. */
export interface Parameter { name: string; symbol: string; unit: string; default: number; min: number; max: number; scale: 'linear' | 'log'; doc: string }
/** One state variable of a table. `scale`: its typical size. */
export interface StateVariable { name: string; symbol: string; unit: string; scale: number; doc: string }
/** A model's tables. */
export interface Model {
  name: string;
  title: string;
  parameters: Parameter[];
  /** of the dry friction that it takes, by the dotted names that reach them; empty where it takes none */
  friction: Parameter[];
  state: StateVariable[];
}
/** The tables of a gear with what is on it: `parameters` of the model and, by dotted names, of its elements. */
export interface RunTables { parameters: Parameter[]; state: StateVariable[] }
/** A method of integration. `order` 0: depends on the run. */
export interface Method { name: string; title: string; order: number; adaptive: boolean; stiff: boolean; doc: string }
/** A run; only `model` is required. SI units. */
export interface Run {
  model: string;
  parameters?: Parameters | null;
  /** dry friction about the steering axis, M_f in N m; absent, null and 0: none */
  friction?: { moment?: number | null } | null;
  /** a damper on the gear; absent and null: none */
  damper?: DamperOnGear | null;
  /** a control law; absent and null: none. `damper.command` is then what the law `passive` commands. */
  control?: Control | null;
  initial?: Record<string, number> | null;
  /** s; 2 */
  duration?: number | null;
  /** `auto` */
  method?: string | null;
  /** 1e-8 */
  rtol?: number | null;
  /** rtol/100 × each state's scale; a number applies to all states as it is */
  atol?: number | null;
  /** s, of method `rk4`; 1e-4 */
  step?: number | null;
  /** 1e7 */
  maxSteps?: number | null;
  /** ascending, ≥ 0; the last one ends the run */
  times?: Float64Array | number[] | null;
  /** 2 … 1e7, equally spaced from 0 to the duration; not together with `times` */
  samples?: number | null;
  /** 2 … 1e7, for drawing: the solver's steps and the first state's turns, thinned to about so many rows without losing a peak; not together with `times` or `samples` */
  rows?: number | null;
  /** any of the next four: a landing roll, v(t) = v₀ − bt from t = 0 on, in the place of `velocity`. What is known of a constant speed alone (linear theory, an outlook, cycles, forces, energy) refuses it. m/s; 80 */
  touchdownVelocity?: number | null;
  /** m/s²; 3 */
  deceleration?: number | null;
  /** m/s, from then on constant; 5. The roll's duration where none is given ends there. */
  finalVelocity?: number | null;
  /** λ of F_z(v) = F_z [1 − λ (v/v₀)²], from 0 to below 1; 0 */
  liftFraction?: number | null;
  /** of a landing roll: κ follows F_z(v) */
  linked?: { treadWidthMomentConstant?: boolean | null } | null;
  /** an uneven stretch of runway: the moment M sin(2πs/λ) over the way s from its start on; refused where a landing roll is */
  disturbance?: Runway | null;
}
/** `moment`: N m, 100. `wavelength`: m, 2. `start`: s, 0. `duration`: s, 1e6. By dotted names: `disturbance.moment`. */
export interface Runway { moment?: number | null; wavelength?: number | null; start?: number | null; duration?: number | null }
/** A magnetorheological damper, driven by the turning wheel through a lever: x = rψ, M_d = rF. Its states come after the gear's, and its values are reached by dotted names: `damper.command`, `damper.leverArm`, `damper.parameters.gamma`. What would preload the gear is 0 by default, and `forceScale` 0.01. */
export interface DamperOnGear {
  /** a name of `dampers()` */
  model: string;
  /** m; 0.1 */
  leverArm?: number | null;
  /** A or V */
  command?: number | null;
  parameters?: Record<string, number> | null;
}
/** A control law at work: of `modified-bouc-wen` and `current-dependent-bouc-wen`, or `active` in the place of a damper. By dotted names: `control.lag`, `control.parameters.gain`. */
export interface Control {
  /** a name of `controls()` */
  law: string;
  /** s; 1/190. A damper with a lag of its own keeps that. */
  lag?: number | null;
  /** s, from when on the command is 0; 1e6 */
  failureTime?: number | null;
  parameters?: Record<string, number> | null;
}
/** A control law: `common` are the parameters that every law has, beside its own. `semiActive`: it commands a damper; otherwise it takes the place of one. */
export interface ControlLaw { name: string; title: string; parameters: Parameter[]; common: Parameter[]; semiActive: boolean; doc: string }
/** Times and one array per state variable, under its name; of a damper those that it has. */
export interface Columns {
  time: Float64Array;
  torsionAngle: Float64Array;
  torsionRate: Float64Array;
  lateralDeformation: Float64Array;
  /** z of a damper */
  hysteresis?: Float64Array;
  /** w of a damper in series, m */
  internalDisplacement?: Float64Array;
  /** u of a damper whose coil takes its time; of the law `active` its moment, N m */
  effectiveCommand?: Float64Array;
}
/** A trajectory: its columns, where piecewise laws changed, and what it has cost. */
export interface Trajectory extends Columns {
  events: { time: Float64Array; kind: Uint8Array; kinds: string[] };
  stats: { method: string; steps: number; rejected: number; evaluations: number; events: number; stiff: boolean };
}
/** A landing roll: its trajectory, and the speed at its times in m/s. */
export interface Landing extends Trajectory { velocity: Float64Array }
/** Least and greatest value of the first state, stretch by stretch. */
export interface Envelope { time: Float64Array; low: Float64Array; high: Float64Array }
/** What becomes of a motion. */
export interface Outlook {
  verdict: 'shimmies' | 'dies-out' | 'rattles' | 'grows' | 'rests';
  /** it is there already, and stays */
  settled: boolean;
  /** where it rests, dry friction holds it away from the middle */
  held: boolean;
  /** largest |·| of every state in the motion it goes to */
  amplitude: Record<string, number>;
  /** Hz */
  frequency: number | null;
  /**
   * the first cycle from here: amplitude of the first state; `stable` of a swing that repeats from here on: false on an
   * unstable cycle, from which the smallest push leads away; null while it changes, and at rest
   */
  present: { amplitude: number; frequency: number | null; trend: 'growing' | 'falling' | 'steady'; stable: boolean | null };
  /** cycle by cycle, up to the arrival */
  envelope: Envelope;
  /** one period of the motion it goes to; empty where it goes to rest or beyond */
  orbit: Columns;
}
/** A limit cycle nearby: of a gear with slightly other parameters, say. */
export interface CycleGuess {
  /** s */
  period: number;
  /** a state on it; one that is not named is 0 */
  state: Record<string, number>;
}
/** A motion that repeats, isolated from others that do. Where none is found the numbers are null and the lists empty. */
export interface LimitCycle {
  found: boolean;
  /** s */
  period: number | null;
  /** Hz */
  frequency: number | null;
  /** largest |·| of every state on it */
  amplitude: Record<string, number>;
  /** Floquet multipliers by falling size, the trivial one (1) among them; of a pair the positive imaginary part first */
  multipliers: ComplexNumber[];
  /** all other multipliers are within the unit circle: neighbours come nearer */
  stable: boolean | null;
  /** the second half mirrors the first */
  symmetric: boolean | null;
  /** one period, its first point twice, from where the first state rises through zero */
  orbit: Columns;
}
/** A limit cycle as describing functions predict it from its first harmonic. */
export interface PredictedCycle {
  /** rad, m, rad */
  amplitude: { torsionAngle: number; lateralDeformation: number; slipAngle: number };
  /** Hz */
  frequency: number;
  stable: boolean;
}
/** Rest and limit cycles over the range of a parameter. The ends may come in either order: the answer is the same. */
export interface BifurcationSpec {
  model: string;
  parameters?: Parameters | null;
  /** dry friction, as in a `Run`; `friction.moment` may be the parameter */
  friction?: Run['friction'];
  damper?: Run['damper'];
  control?: Run['control'];
  parameter: string;
  from: number;
  to: number;
  /** what follows the parameter, as in a `Variation` */
  linked?: Variation['linked'];
  /** a cycle nearby whose branch is wanted, at a `value` of the parameter: its own in `parameters` */
  cycle?: (CycleGuess & { value?: number | null }) | null;
  /** most points of a branch, 2 … 10 000; 400 */
  points?: number | null;
  /** longest step along the parameter, in parts of its range, 1e-4 … 0.1; 0.025 */
  step?: number | null;
  /** how near special points are located, in parts of the range and of the cycle's size, 1e-9 … 1e-3; 1e-6 */
  tolerance?: number | null;
  /** at how many values motions from small and large starts are simulated, to find cycles that no branch has, 0 … 100; 4 */
  probes?: number | null;
}
/** What the branches are made of is under the parameter's own name, too: `equilibria.velocity`, `cycles[0].velocity`, `points[0].velocity`. */
export interface Bifurcation {
  /** the parameter's name */
  parameter: string;
  equilibria: EquilibriumBranch;
  cycles: CycleBranch[];
  /** those of rest by rising value, then those of each branch in its order */
  points: SpecialPoint[];
}
/** The gear at rest by rising values of the parameter, those of `points` among them: one array a quantity. With dry friction as if the wheel turned freely: it sticks, and no branch begins there. */
export interface EquilibriumBranch {
  /** by state */
  state: Record<string, Float64Array>;
  /** 1/s: largest real part of an eigenvalue */
  growthRate: Float64Array;
  /** Hz: of that eigenvalue; 0 where it is real */
  frequency: Float64Array;
  /** how many eigenvalues are right of the imaginary axis */
  unstable: Uint8Array;
  /** 1: all small motions fade */
  stable: Uint8Array;
  [parameter: string]: any;
}
/** Neighbouring limit cycles, in their order along the branch: one array a quantity. Special points are among them. */
export interface CycleBranch {
  /** largest |·| of the first state; 0 at a Hopf point at which the branch begins or ends */
  amplitude: Float64Array;
  /** s */
  period: Float64Array;
  /** Hz */
  frequency: Float64Array;
  /** by state: largest |·| */
  amplitudes: Record<string, Float64Array>;
  /** by state: where on the cycle the first state rises through zero; with `period` a guess for `limitCycle` */
  state: Record<string, Float64Array>;
  /** Floquet multipliers, as many a cycle as there are states: re, im, re, im, … The trivial one (1, as computed) first, the others by falling size, of a pair the positive imaginary part first */
  multipliers: Float64Array;
  /** how many multipliers are outside of the unit circle */
  unstable: Uint8Array;
  /** 1: none is, neighbours come nearer */
  stable: Uint8Array;
  /** 1: the second half mirrors the first */
  symmetric: Uint8Array;
  /** what is at the first and at the last cycle: a Hopf point; the end of the range; each other; a cycle that shrinks to nothing elsewhere, as a gap closes; one that grows beyond bounds; the most points asked for; none found beyond */
  ends: [BranchEnd, BranchEnd];
  [parameter: string]: any;
}
export type BranchEnd = 'hopf' | 'range' | 'closed' | 'rest' | 'large' | 'points' | 'lost';
/** A point at which rest or cycles change. */
export interface SpecialPoint {
  kind: 'hopf' | 'fold' | 'neimark-sacker' | 'period-doubling' | 'branch-point' | 'divergence';
  /** largest |·| of the first state; at rest 0, or where it rests */
  amplitude: number;
  /** Hz: of the cycle, or of the eigenvalues that cross */
  frequency: number;
  /** which of `cycles` it is on, of a Hopf point which of them is born there; null where none */
  branch: number | null;
  /** its place on that branch; of `hopf` and `divergence` in `equilibria` */
  index: number;
  /** of a Hopf point: which way its branch goes. Supercritical: cycles are where rest is unstable; degenerate: the gear is linear */
  criticality: 'supercritical' | 'subcritical' | 'degenerate' | null;
  /** what tells that: the first Lyapunov coefficient where the laws are smooth around rest; where a kink is nearer than a fifth of the first state's typical size, the branch's direction beyond that kink */
  by: 'lyapunov' | 'branch' | null;
  /** of a Hopf point, 1/s over the first state's unit squared: by how much the growth rate of a swing changes with the square of its amplitude, within the laws' pieces at rest */
  lyapunov: number | null;
  [parameter: string]: any;
}
/** Curves of folds in a plane. `seeds`: as many rows and columns of it have their diagram made to find folds, 1 … 100; 4. */
export interface FoldSpec extends Plane { seeds?: number | null }
/** A curve in a plane at which two limit cycles meet and vanish, as a polyline: beside a `HopfCurve` to be drawn as one. */
export interface FoldCurve {
  x: Float64Array;
  y: Float64Array;
  /** Hz, of the cycle */
  frequency: Float64Array;
  /** of the cycle: largest |·| of its first state */
  amplitude: Float64Array;
  kind: 'fold';
  /** the last point is the first */
  closed: boolean;
  /** all other multipliers are within the unit circle: one of the two cycles is stable, and ends here */
  bounds: boolean;
}
/** What linear theory says of a gear at rest. */
export interface RouthHurwitz {
  stable: boolean;
  /** first column of the Routh array */
  column: number[];
  /** m/s, ascending: where eigenvalues cross the imaginary axis; of the torsional gears every v > 0, of others 0.1 … 2000 */
  criticalVelocities: number[];
  /** N m s/rad: the largest c > 0 at which a pair crosses */
  criticalDamping: number | null;
}
/** A complex number. */
export interface ComplexNumber { re: number; im: number }
/** Routh's array of the characteristic polynomial. */
export interface RouthArray {
  /** highest power (1) first */
  coefficients: number[];
  /** from sⁿ to s⁰, as the array goes on with them */
  rows: number[][];
  /** by row: a zero pivot among other numbers, or nothing but zeros */
  special: (null | 'zero-pivot' | 'zero-row')[];
  /** by row: a special one as it came out. Of a zero row the derivative of the polynomial above takes the place; one with p leading zeros is multiplied by 1 + (−1)ᵖ(s/ω₀)²ᵖ, which is positive on the imaginary axis */
  replaced: (null | number[])[];
  /** in the right half plane: the changes of sign in the first column */
  unstableRoots: number;
  /** on the imaginary axis */
  neutralRoots: number;
  stable: boolean;
}
/** A value of a parameter at which eigenvalues cross the imaginary axis: a pair, with its frequency in Hz, or a real one (0 Hz). */
export interface Crossing { value: number; kind: 'hopf' | 'divergence'; frequency: number }
/** One motion Re(shape e^{λt}) of the linearised gear. */
export interface Eigenmode {
  /** λ in 1/s */
  eigenvalue: ComplexNumber;
  /** −Re λ/|λ|; null where λ is 0 */
  dampingRatio: number | null;
  /** |λ|/2π in Hz */
  naturalFrequency: number;
  /** s, where it fades */
  timeToHalf: number | null;
  /** s, where it grows */
  timeToDouble: number | null;
  /** the state that is 1 in `shape`: the first, or the largest where the first takes no part */
  reference: string;
  /** by state, beside the reference: amplitude ratio, and by how much its phase lags in rad */
  shape: Record<string, ComplexNumber & { amplitude: number; lag: number }>;
  energyFlow: EnergyFlow | null;
}
/** Where a mode's energy comes from and goes, as rates of growth in 1/s: tire = damper + treadWidth + mrDamper + stored, and stored = Re λ. */
export interface EnergyFlow {
  /** fed in by the tire */
  tire: number;
  /** taken by the damper */
  damper: number;
  /** taken by the tread's width */
  treadWidth: number;
  /** taken by a magnetorheological damper */
  mrDamper: number;
  /** stored in the wheel's turning */
  kinetic: number;
  /** stored in the spring */
  spring: number;
  /** kinetic + spring */
  stored: number;
}
/** One parameter's range, in its SI unit. `linked`: what follows it, σ = 3a with a, κ = 0.15 a² c_Fα F_z with a, c_Fα and F_z. */
export interface Variation {
  parameter: string;
  from: number;
  to: number;
  linked?: { relaxationLength?: boolean | null; treadWidthMomentConstant?: boolean | null } | null;
}
/** A part of a parameter's range in which a small swing does not fade. An end is a boundary of stability, or the range's own. */
export interface UnstableInterval { from: number; to: number; fromKind: 'hopf' | 'divergence' | 'range'; toKind: 'hopf' | 'divergence' | 'range' }
/** An axis of a plane: a parameter's range, in its SI unit. `count`: the cells of a map. */
export interface Axis { parameter: string; from: number; to: number; count?: number }
/** Two parameters of a model that vary; the others as in `parameters`. `linked`: what follows them, σ = 3a with a, κ = 0.15 a² c_Fα F_z with a, c_Fα and F_z. */
export interface Plane {
  model: string;
  parameters?: Parameters | null;
  /** linear theory leaves it out */
  friction?: { moment?: number | null } | null;
  /** as in a `Run`; `damper.command` and the like may be on an axis. Stability is judged without the eigenvalue that a hysteresis has at zero. */
  damper?: Run['damper'];
  control?: Run['control'];
  x: Axis;
  y: Axis;
  linked?: { relaxationLength?: boolean | null; treadWidthMomentConstant?: boolean | null } | null;
}
/** Curves in a plane; an axis may reach a thousand times as far as its slider. `accuracy`: how far straight lines between points may be from the curve, in parts of the plane, 1e-7 … 0.01; 1e-6. */
export interface CurveSpec extends Plane { accuracy?: number | null }
/** A map of `x.count` × `y.count` cells, 1e7 at most in all. */
export interface MapSpec extends Plane {
  x: Axis & { count: number };
  y: Axis & { count: number };
  /** `['stable', 'growthRate']` */
  quantities?: ('stable' | 'growthRate' | 'frequency' | 'kind')[] | null;
  /** the cells from this column and row on, so many of them; all that are left */
  tile?: { column?: number | null; row?: number | null; columns?: number | null; rows?: number | null } | null;
}
/** Stability at the centres of cells: row by row from `y.from` up, each from `x.from` on. Linear theory; with freeplay at rest in the gap, without the spring. */
export interface StabilityMap {
  /** 1: all small motions fade */
  stable: Uint8Array;
  /** 100 × stable cells / cells */
  stablePercent: number;
  /** %: the same share of the area, by the exact boundary; of a tile, in the tile */
  stableArea: number;
  /** 1/s: largest real part of an eigenvalue */
  growthRate?: Float64Array;
  /** Hz: of that eigenvalue; 0 where it is real */
  frequency?: Float64Array;
  /** 1 where that eigenvalue is one of a pair, as `kinds` says; unstable and monotonic is divergent */
  kind?: Uint8Array;
  kinds?: ['monotonic', 'oscillatory'];
}
/**
 * A curve in a plane at which eigenvalues cross the imaginary axis, as a polyline: straight lines are within the `accuracy`
 * asked for from it. What crosses is left of the axis at the curve's own left (x to the right, y up). It ends at the edge
 * of the plane, exactly, or where what crosses changes.
 */
export interface HopfCurve {
  x: Float64Array;
  y: Float64Array;
  /** Hz; 0 of a divergence */
  frequency: Float64Array;
  kind: 'hopf' | 'divergence';
  /** the last point is the first */
  closed: boolean;
  /** it bounds what is stable: all other eigenvalues are left of the axis */
  bounds: boolean;
}
/** What a job has of a map: the cells so far. `stablePercent`: null before the first; `stableArea`: null before the last. */
export type UnfinishedMap = Omit<StabilityMap, 'stablePercent' | 'stableArea'> & { stablePercent: number | null; stableArea: number | null };
/** An axis of basins: a parameter's or a state's range, in its SI unit, cut into `count` cells. */
export type BasinsAxis = { from: number; to: number; count: number } & ({ parameter: string; state?: null } | { state: string; parameter?: null });
/** Basins to be found: over two states, two parameters or one of each; 1e6 cells at most. */
export interface BasinsSpec {
  model: string;
  parameters?: Parameters | null;
  friction?: Run['friction'];
  damper?: Run['damper'];
  control?: Run['control'];
  /** where a motion starts, but for the states on the axes; at rest, or where the axes are parameters a tenth of the first state's typical size from it */
  initial?: Record<string, number> | null;
  x: BasinsAxis;
  y: BasinsAxis;
  linked?: Plane['linked'];
  /** s that a motion has to settle, at most 1000; 10 */
  duration?: number | null;
  /** coarse first, then finer where neighbours end differently; false: every cell is followed. true */
  refine?: boolean | null;
  /** the cells from this column and row on, so many of them; all that are left */
  tile?: MapSpec['tile'];
}
/** How a motion ends: at rest; in a cycle that lives on the freeplay; in one that the tire sustains; beyond the model's range (0.5 rad) or without bounds; not yet, or never the same. */
export type MotionKind = 'rest' | 'rattle' | 'shimmy' | 'divergence' | 'unsettled';
/** Where the motions from the centres of cells end: row by row from `y.from` up, each from `x.from` on. A cell that is not known yet has 255 for kind and ending, and amplitude 0. */
export interface Basins {
  /** of each cell, as `kinds` says */
  kind: Uint8Array;
  kinds: MotionKind[];
  /** of the first state, in its unit: 0 at rest, 1000 without bounds. Of a cell that was not followed it lies between its neighbours' */
  amplitude: Float64Array;
  /** of each cell, the place in `endings` */
  ending: Uint8Array;
  /** by kind, and by amplitude. Where both axes are states, amplitudes of a kind that are, in their order, more than 2 % apart are of two endings; where parameters vary, each kind is one */
  endings: { kind: MotionKind; low: number; high: number; cells: number }[];
  /** by what part endings of a kind are apart: 0.02, or 1 where each kind is one */
  apart: number;
  /** how many cells were followed; the others lie between some that end alike */
  followed: number;
}
/** One motion carried on as a parameter goes there and back; over a plane, along x in each row. Where it has come to rest, or left all bounds, it starts anew at the next. */
export interface SweepSpec {
  model: string;
  parameters?: Parameters | null;
  friction?: Run['friction'];
  damper?: Run['damper'];
  control?: Run['control'];
  /** where a motion starts; a hundredth of the first state's typical size from rest */
  initial?: Record<string, number> | null;
  /** where the way back begins when the way there has ended at rest; three times the first state's typical size */
  start?: Record<string, number> | null;
  /** of one parameter the values from end to end, of a plane the centres of cells */
  over: (Axis & { count: number }) | { x: Axis & { count: number }; y: Axis & { count: number } };
  /** the state whose amplitude is measured; the first */
  measure?: string | null;
  linked?: Plane['linked'];
  /** s that a motion has to settle at each value, at most 1000; 10 */
  duration?: number | null;
  /** whole rows */
  tile?: MapSpec['tile'];
}
/**
 * One way of a sweep, cell by cell and row by row: 255 and 0 where it has not come to yet. An amplitude is 0 at rest, 1000
 * without bounds. `settled`: 0 also where the motion was still on its way when its time was over, or never repeats.
 */
export interface SweepWay { kind: Uint8Array; amplitude: Float64Array; settled: Uint8Array }
/** What a motion becomes as a parameter goes there (`up`) and back (`down`): where the two differ, there are two motions. */
export interface Sweep {
  /** the parameter's values along x */
  value: Float64Array;
  up: SweepWay;
  down: SweepWay;
  kinds: MotionKind[];
}
/** A section of the states: where one of them passes a level. */
export interface SectionSpec {
  /** the first */
  state?: string | null;
  /** in the state's unit; 0 */
  level?: number | null;
  /** true; false: where it falls */
  rising?: boolean | null;
  /** s before which passages do not count; 0 */
  after?: number | null;
}
/** The passages of a motion through a section: times and states. Poincaré's map takes each to the next. */
export interface Section extends Columns {
  /** how far the section's state goes from its level between a passage and the next: one less than passages. The return map of amplitudes takes each to the next */
  amplitude: Float64Array;
}
/** The jobs by kind: what each is given, what it has on the way, what it gives in the end. */
export interface Jobs {
  stabilityMap: { spec: MapSpec; part: UnfinishedMap; result: StabilityMap };
  bifurcation: { spec: BifurcationSpec; part: Bifurcation; result: Bifurcation };
  foldCurve: { spec: FoldSpec; part: FoldCurve[]; result: FoldCurve[] };
  basins: { spec: BasinsSpec; part: Basins; result: Basins };
  sweep: { spec: SweepSpec; part: Sweep; result: Sweep };
  identification: { spec: IdentificationSpec; part: Identified; result: Identified };
  landingRoll: { spec: Run; part: Landing; result: Landing };
}
/** How far a job is. `fraction`: of the whole, 0 … 1. */
export interface Progress { done: boolean; fraction: number }
/** Energy that went through the steering motion in `duration` s, in J: tire = damper + treadWidth + friction + mrDamper + stored. */
export interface Energy {
  duration: number;
  /** fed in by the tire: ∫(M_z − e F_y)ψ̇ dt */
  tire: number;
  /** taken by the damper: ∫cψ̇² dt */
  damper: number;
  /** taken by the tread's width: ∫(κ/v)ψ̇² dt */
  treadWidth: number;
  /** taken by dry friction: ∫M_f|ψ̇| dt */
  friction: number;
  /** taken by a magnetorheological damper, for good or to be given back: ∫M_dψ̇ dt */
  mrDamper: number;
  /** rise of ½I_zψ̇² */
  kinetic: number;
  /** rise of ½k s² */
  spring: number;
  /** kinetic + spring */
  stored: number;
}
/** Forces along a motion, row by row: rad, N, N m, N m, N m, N, N m. */
export interface ForceColumns { slipAngle: Float64Array; sideForce: Float64Array; aligningMoment: Float64Array; springTorque: Float64Array; frictionTorque: Float64Array; damperForce: Float64Array; damperTorque: Float64Array }
/** What to draw of the force laws: angles in rad, each curve from −angle to +angle. */
export interface Curves {
  /** below 90°; 20° */
  slipAngle?: number | null;
  /** 20° */
  torsionAngle?: number | null;
  /** equally spaced, 2 … 100 000; 201. The kinks come on top. */
  samples?: number | null;
}
/** Force laws as curves, ascending, with every kink among the points. */
export interface ForceLaws {
  /** rad */
  slipAngle: Float64Array;
  /** F_y in N at `slipAngle` */
  sideForce: Float64Array;
  /** M_z in N m at `slipAngle` */
  aligningMoment: Float64Array;
  /** rad */
  torsionAngle: Float64Array;
  /** −k s(ψ) in N m at `torsionAngle` */
  restoringMoment: Float64Array;
  /** where the laws bend, in rad; null where they do not */
  kinks: { sideForceLimitAngle: number | null; aligningMomentLimitAngle: number | null; freeplayAngle: number | null };
}
/** Equally spaced values, 2 … 65 536; `interval` in s. */
export interface Series { values: Float64Array | number[]; interval: number }
/** Single-sided amplitude spectrum, from 0 to half of the sampling rate. `peak`: the strongest sinusoid, between the frequencies; null where nothing swings. */
export interface Spectrum { frequency: Float64Array; amplitude: Float64Array; peak: { frequency: number; amplitude: number } | null }
/** A figure or table of E. Atabay's thesis, as a run or a map to look at. */
export interface AtlasEntry {
  id: string;
  title: string;
  view: string;
  run?: Run & Record<string, any>;
  show?: string[];
  map?: Record<string, any>;
  [key: string]: any;
}
/** A damper's tables. */
export interface DamperModel {
  name: string;
  title: string;
  parameters: Parameter[];
  state: StateVariable[];
  /** a current in A, or a voltage in V */
  command: Parameter;
  /** whether the command enters: a model of one fixed command does without */
  commanded: boolean;
  /** defaults that differ on a gear: what would preload it, or what is far too large for it */
  onGear: Record<string, number>;
}
/** A damper: `model` is required. `leverArm` is a gear's, and does not enter where there is none. */
export interface Damper { model: string; command?: number | null; leverArm?: number | null; parameters?: Parameters | null }
/** How a piston is moved, from x = 0 upwards: amplitude in m (0.01) and frequency in Hz (2) go in straight lines to their last values, which are the first where they are not given. `shape`: sine. */
export interface Excitation {
  amplitude?: number | null;
  frequency?: number | null;
  endAmplitude?: number | null;
  endFrequency?: number | null;
  shape?: 'sine' | 'triangle' | null;
}
/** `cycles`: 4, at most 10 000. `samples`: 1000 in all, 2 … 1e6, equally spaced, the end excluded. */
export interface DamperResponseSpec { damper: Damper; excitation?: Excitation | null; cycles?: number | null; samples?: number | null }
/** A damper's motion, force in N and state, from z = 0, w = 0 and the settled command. */
export interface DamperResponse {
  time: Float64Array;
  displacement: Float64Array;
  velocity: Float64Array;
  force: Float64Array;
  hysteresis: Float64Array;
  /** 0 of a damper without */
  internalDisplacement: Float64Array;
}
/** A record of a damper at a steady command and equal intervals, SI units. Without `velocity` the displacement is differentiated. `command`: the model's default where it is absent. */
export interface DamperRecord {
  displacement: Float64Array | number[];
  velocity?: Float64Array | number[] | null;
  force: Float64Array | number[];
  command?: number | null;
  /** s */
  interval: number;
}
/** A record to be made. `noise`: its deviation in parts of the force's root mean square, 0; `seed`: 1. At least 8 samples. */
export interface DamperRecordSpec extends DamperResponseSpec { noise?: number | null; seed?: number | null }
/** A damper model's values to be found from records. */
export interface IdentificationSpec {
  model: string;
  records: DamperRecord[];
  /** by name [low, high]; equal ones hold a parameter. Of the others the table's min … max, but `exponent`, `commandRate` and `forceScale` stay at their defaults */
  bounds?: Record<string, number[]> | null;
  /** individuals, 4 … 10 000; 60 */
  population?: number | null;
  /** at most; 500 */
  generations?: number | null;
  /** a whole number < 2^53; 1 */
  seed?: number | null;
  /** the best is polished at the end; true */
  polish?: boolean | null;
}
/** Where an identification has come to. Errors are rms(F − F̂)/rms(F) of all records together, null before there is one. */
export interface Generation {
  generation: number;
  bestError: number | null;
  meanError: number | null;
  best: Record<string, number>;
  polishing: boolean;
  done: boolean;
}
/** A record's force by found values, and how far that is from the measured one. */
export interface DamperFit { command: number; error: number; force: Float64Array }
/** What an identification has found so far. With `model` and `parameters` it is a `Damper`. */
export interface Identified {
  model: string;
  parameters: Record<string, number>;
  error: number | null;
  generation: number;
  seed: number;
  /** by generation, steps of the polish at the end */
  history: { best: Float64Array; mean: Float64Array };
  /** by record */
  fits: DamperFit[];
}
/** What records fix of a damper's values, and what they do not. */
export interface Identifiability {
  /** of the individuals given */
  errors: Float64Array;
  /** which of them has the least */
  best: number;
  /** what was looked for. `spread`: how far apart the individuals are, `slack`: how far a value can go before the error grows to 1 % beside a perfect fit, the others following; both in parts of the bounds, on the scale on which it is looked for. `fixed`: it takes no part in a weak direction */
  parameters: { name: string; value: number; range: [number, number]; spread: number; slack: number; fixed: boolean }[];
  /** directions along which the forces hardly change, the weakest first: by how much, in parts of their root mean square a bounds' distance, and what takes part */
  weak: { change: number; parts: Record<string, number> }[];
  /** the best beside each record */
  fits: DamperFit[];
}
/** Where a piston that is led by hand is, and what its damper does: m, m/s, N. */
export interface Grip { displacement: number; velocity: number; force: number; hysteresis: number; internalDisplacement: number }
/** What the links between parameters give. */
export interface LinkedParameters { relaxationLength: number; treadWidthMomentConstant: number }
/** Forces at a state, SI. */
export interface Forces { slipAngle: number; sideForce: number; aligningMoment: number; sideForceLimited: boolean; springAngle: number; springTorque: number; frictionTorque: number; damperForce: number; damperTorque: number }
/** What every thrown `Error` carries besides its message. */
export interface ErrorData { code: string; field: string; value: string; allowed: string; suggestion: string | null }
