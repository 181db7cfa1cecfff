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
  const series = /** @type {Record<string, ArrayLike<number>>} */ (ours);
  return `#!/usr/bin/env python3
"""One run of a nose landing gear's wheel, computed once more by SciPy.

    python3 ${file}           prints the motion and how far our numbers are from SciPy's
    python3 ${file} --plot    draws it as well

It needs SciPy (pip install scipy), and matplotlib for the plot. It ends with exit code 1 where the two
differ by more than a millionth of the largest value.

${model.subject}

ψ is the angle of the wheel about its steering axis, counter-clockwise from above; y the lateral
deformation of the tire at its leading contact point, to the left of the wheel plane.
"""

# Written by shimmy, from ${link.replaceAll(/\s/g, '')}

import sys
${model.imports.length > 0 ? `from math import ${model.imports.join(', ')}\n` : ''}
import numpy as np
from scipy.integrate import solve_ivp

# The gear: each value under its name and its symbol.
${aligned(table.parameters.map(({ name, symbol, unit }) => [`${snake(name)} = ${symbol} = ${float(run.parameters[name])}`, unit]))}

# The state, as it starts and as large as it typically is: the absolute tolerance follows from that.
NAMES = (${state.map(({ name, unit }) => `"${words(name)} (${unit})"`).join(', ')})
INITIAL = (${state.map(({ name }) => float(run.initial[name])).join(', ')})
SCALES = np.array([${state.map(({ scale }) => float(scale)).join(', ')}])

# Our own numbers: the time in s, then the state.
OURS = np.array([
${Array.from(ours.time, (time, i) => `    (${[time, ...state.map(({ name }) => series[name][i])].map(float).join(', ')}),`).join('\n')}
])
ALLOWED = 1e-6  # of the largest value


${model.rates}


def integrate(times):
    """SciPy's motion at these times. Where the equations have a kink, the tight tolerance makes it step finely."""
    motion = solve_ivp(
        rates, (0.0, times[-1]), INITIAL, method="DOP853", t_eval=times, rtol=1e-12, atol=1e-14 * SCALES
    )
    if not motion.success:
        sys.exit(f"SciPy gave up: {motion.message}")
    return motion.y


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

/** Lines of code with their comments one under the other. @param {[code: string, comment: string][]} lines */
function aligned(lines) {
  const width = Math.max(...lines.map(([code]) => code.length));
  return lines.map(([code, comment]) => `${code.padEnd(width)}  # ${comment}`).join('\n');
}

/** @param {string} name `torsionAngle` → `torsion_angle` */
function snake(name) {
  return name.replaceAll(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
}

/** @param {string} name `torsionAngle` → `torsion angle` */
function words(name) {
  return snake(name).replaceAll('_', ' ');
}

/** A number that reads back to the last bit, and as a float. @param {number} value */
function float(value) {
  return Number.isInteger(value) && Math.abs(value) < 1e15 ? `${Object.is(value, -0) ? 0 : value}.0` : String(value);
}
