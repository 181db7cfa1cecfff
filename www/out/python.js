import { pythonModel } from './python/model.js';

/**
 * A run as a Python script that integrates it with SciPy and holds our numbers against it.
 *
 * @typedef {import('./run-of.js').WholeRun} WholeRun
 *
 * @param {WholeRun} run
 * @param {import('../engine/engine.js').Model} table of the run's model
 * @param {{ time: ArrayLike<number> }} ours what `simulate` gave for the run at some twenty times
 * @param {{ file: string, link: string }} made the script's own name, and the address of the page as it was
 */
export function pythonOf(run, table, ours, { file, link }) {
  const model = pythonModel(run.model);
  if (!model) throw new Error(`no equations in Python for ${run.model}`);
  const { state } = table;
  const valueOf = (/** @type {string} */ name) => (name.startsWith('friction.') ? run.friction?.[name.slice('friction.'.length)] : run.parameters[name]) ?? 0;
  const rubs = valueOf('friction.moment') > 0;
  const values = table.parameters.filter(({ name }) => rubs || name !== 'friction.moment');
  const series = /** @type {Record<string, ArrayLike<number>>} */ (ours);
  return `#!/usr/bin/env python3
"""One run of a nose landing gear's wheel, computed once more by SciPy.

    python3 ${file}           prints the motion and how far our numbers are from SciPy's
    python3 ${file} --plot    draws it as well

It needs SciPy (pip install scipy), and matplotlib for the plot. It ends with exit code 1 where the two
differ by more than a millionth of the largest value.

${model.subject}${rubs ? frictionSubject : ''}

ψ is the angle of the wheel about its steering axis, counter-clockwise from above; y the lateral
deformation of the tire at its leading contact point, to the left of the wheel plane.
"""

# Written by shimmy, from ${link.replaceAll(/\s/g, '')}

import sys
${model.imports.length > 0 ? `from math import ${model.imports.join(', ')}\n` : ''}
import numpy as np
from scipy.integrate import solve_ivp

# The gear: each value under its name and its symbol.
${aligned(values.map(({ name, symbol, unit }) => [`${snake(name)} = ${symbol} = ${float(valueOf(name))}`, unit]))}

# The state, as it starts and as large as it typically is: the absolute tolerance follows from that.
NAMES = (${state.map(({ name, unit }) => `"${words(name)} (${unit})"`).join(', ')})
INITIAL = (${state.map(({ name }) => float(run.initial[name])).join(', ')})
SCALES = np.array([${state.map(({ scale }) => float(scale)).join(', ')}])

# Our own numbers: the time in s, then the state.
OURS = np.array([
${Array.from(ours.time, (time, i) => `    (${[time, ...state.map(({ name }) => series[name][i])].map(float).join(', ')}),`).join('\n')}
])
ALLOWED = 1e-6  # of the largest value


${rubs ? `${model.load}


${frictionRates}` : `${model.rates}


${smooth}`}


def plot(times, ours):
    try:
        from matplotlib import pyplot
    except ImportError:
        print("No plot: matplotlib is not here (pip install matplotlib).")
        return
    fine = np.linspace(0.0, times[-1], 4001)
    figure, axes = pyplot.subplots(len(NAMES), sharex=True)
    for axis, name, curve, points in zip(axes, NAMES, integrate(fine), ours):
        axis.plot(fine, curve, linewidth=0.8, label="SciPy")
        axis.plot(times, points, "o", markersize=4, label="shimmy")
        axis.set_ylabel(name)
    axes[0].legend(loc="upper left")
    axes[-1].set_xlabel("time (s)")
    pyplot.show()


def main():
    times, ours = OURS[:, 0], OURS[:, 1:].T
    found = integrate(times)
    difference = found - ours

    print("SciPy's motion, and in brackets its difference from ours")
    print("  time (s)" + "".join(f"{name:>34}" for name in NAMES))
    for time, values, misses in zip(times, found.T, difference.T):
        print(f"{time:10.4f}" + "".join(f"{value:22.12g}  ({miss:8.1e})" for value, miss in zip(values, misses)))

    agrees = True
    for name, misses, values in zip(NAMES, difference, ours):
        worst, largest = np.abs(misses).max(), np.abs(values).max()
        agrees &= bool(worst <= ALLOWED * largest)
        print(f"largest difference of {name}: {worst:.2e}, where the largest value is {largest:.6g}")
    print("The two agree." if agrees else "The two DISAGREE: by more than a millionth of the largest value.")

    if "--plot" in sys.argv:
        plot(times, ours)
    sys.exit(0 if agrees else 1)


if __name__ == "__main__":
    main()
`;
}

/** Motion without friction. */
const smooth = `def integrate(times):
    """SciPy's motion at these times. Where the equations have a kink, the tight tolerance makes it step finely."""
    motion = solve_ivp(
        rates, (0.0, times[-1]), INITIAL, method="DOP853", t_eval=times, rtol=1e-12, atol=1e-14 * SCALES
    )
    if not motion.success:
        sys.exit(f"SciPy gave up: {motion.message}")
    return motion.y`;

const frictionSubject = `

Dry friction adds the moment -M_f sign ψ'. Where ψ' = 0 it is as much as is needed to stay there, up to
M_f: the wheel sticks until the other moments are larger.`;

/** Motion with friction, one phase after the other: SciPy's events find where the wheel stops and where it is let go. */
const frictionRates = `def rates(time, state, sense):
    """The equations above; sense is the sign of ψ', or 0 where friction holds the wheel."""
    ψ, ψ_rate, y = state

    ψ_acceleration = (load(ψ, y) - (c + κ / v) * ψ_rate - M_f * sense) / I_z if sense else 0.0
    y_rate = v * ψ + (e - a) * ψ_rate - v / σ * y
    return ψ_rate, ψ_acceleration, y_rate


def stop(time, state, sense):
    """Falls through zero where the wheel stops, or where friction can no longer hold it."""
    return sense * state[1] if sense else M_f - abs(load(state[0], state[2]))


stop.terminal, stop.direction = True, -1


def integrate(times):
    """SciPy's motion at these times, from stop to stop. Where the equations have a kink, the tight tolerance makes it
    step finely."""
    time, state, found = 0.0, np.array(INITIAL), []
    sense = np.sign(state[1]) or (np.sign(load(state[0], state[2])) if stop(0.0, state, 0) < 0 else 0)
    while len(found) < len(times):
        motion = solve_ivp(
            rates, (time, times[-1]), state, method="DOP853", t_eval=times[len(found):], args=(sense,), events=stop,
            rtol=1e-12, atol=1e-14 * SCALES
        )
        if motion.status < 0:
            sys.exit(f"SciPy gave up: {motion.message}")
        found += list(np.transpose(motion.y)) if len(motion.t) else []
        if motion.status == 1:
            time, state = motion.t_events[0][-1], np.array(motion.y_events[0][-1])
            torque = load(state[0], state[2])
            if sense:
                state[1] = 0.0
                sense = np.sign(torque) if abs(torque) > M_f else 0
            else:
                sense = np.sign(torque)
    return np.transpose(found)`;

/** Lines of code with their comments one under the other. @param {[code: string, comment: string][]} lines */
function aligned(lines) {
  const width = Math.max(...lines.map(([code]) => code.length));
  return lines.map(([code, comment]) => `${code.padEnd(width)}  # ${comment}`).join('\n');
}

/** @param {string} name `torsionAngle` → `torsion_angle` */
function snake(name) {
  return name.replaceAll('.', '_').replaceAll(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

/** @param {string} name `torsionAngle` → `torsion angle` */
function words(name) {
  return snake(name).replaceAll('_', ' ');
}

/** A number that reads back to the last bit, and as a float. @param {number} value */
function float(value) {
  return Number.isInteger(value) && Math.abs(value) < 1e15 ? `${Object.is(value, -0) ? 0 : value}.0` : String(value);
}
