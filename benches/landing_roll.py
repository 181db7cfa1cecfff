"""Landing rolls by SciPy: tests/landing-reference.json.

Nothing of the engine has a part in it: the equations are those of damped_gear.py with a speed that falls, by LSODA at rtol
1e-9 in steps of at most 0.2 ms. The file has ψ at some early times, and the largest |ψ| in each second.

    pip install scipy
    python3 benches/landing_roll.py > tests/landing-reference.json
"""

import json
import sys

import numpy as np
import scipy
from scipy.integrate import solve_ivp

from damped_gear import Damped


class Rolling(Damped):
    def __init__(self, run):
        damper = run.get("damper") or {"model": "bouc-wen", "parameters": {
            "viscousDamping": 0.0, "stiffness": 0.0, "offset": 0.0, "hysteresisGain": 0.0, "gamma": 1.0, "beta": 1.0,
            "exponent": 2.0, "amplitude": 1e-9}}
        super().__init__({**run, "damper": damper})
        self.roll, self.base = run, dict(self.p)
        self.linked = (run.get("linked") or {}).get("treadWidthMomentConstant", False)

    def velocity(self, t):
        return max(self.roll["touchdownVelocity"] - self.roll["deceleration"] * t, self.roll["finalVelocity"])

    def rolling(self, t, x):
        v = self.velocity(t)
        weight = 1 - self.roll.get("liftFraction", 0.0) * (v / self.roll["touchdownVelocity"]) ** 2
        self.p["velocity"], self.p["verticalForce"] = v, self.base["verticalForce"] * weight
        self.p["treadWidthMomentConstant"] = self.base["treadWidthMomentConstant"] * (weight if self.linked else 1)
        rate = self.rate(x, 0)
        runway = self.roll.get("disturbance")
        if runway and runway["start"] <= t < runway["start"] + runway["duration"]:
            way = lambda t: self.roll["touchdownVelocity"] * t - 0.5 * self.roll["deceleration"] * t * t
            phase = 2 * np.pi * (way(t) - way(runway["start"])) / runway["wavelength"]
            rate[1] += runway["moment"] * np.sin(phase) / self.p["momentOfInertia"]
        return rate


def cases():
    roll = {"model": "torsional", "touchdownVelocity": 80, "deceleration": 3, "finalVelocity": 5}
    of = lambda c, **more: {**roll, "parameters": {"dampingConstant": c}, "initial": {"torsionAngle": 0.01}, **more}
    damper = lambda current: {"model": "modified-bouc-wen", "command": current, "parameters": {}}
    yield "c = 20", of(20)
    yield "c = 40, lift and runway", of(40, liftFraction=0.5, linked={"treadWidthMomentConstant": True},
                                        disturbance={"moment": 150, "wavelength": 1.5, "start": 3, "duration": 0.5})
    yield "c = 20, 0 A", of(20, damper=damper(0.0))
    yield "c = 20, 0.5 A", of(20, damper=damper(0.5))


def solve(run):
    gear = Rolling(run)
    x = np.zeros(len(gear.states))
    x[0] = run["initial"]["torsionAngle"]
    if gear.lag:
        x[-1] = gear.command
    end = (run["touchdownVelocity"] - run["finalVelocity"]) / run["deceleration"]
    scale = np.array([0.1, 30.0, 0.02, 5e-3, 1e-3, 1.0][: len(x)])
    early, late = [0.25, 0.5, 0.75, 1.0], np.arange(0.0, end, 5e-5)
    times = np.unique(np.concatenate([early, late]))
    jumps = sorted({0.0, end, *(run["disturbance"]["start"] + np.array([0, run["disturbance"]["duration"]])
                                if "disturbance" in run else [])})
    psi, found = [], []
    for start, stop in zip(jumps, jumps[1:]):
        at = times[(times >= start) & (times < stop)]
        part = solve_ivp(gear.rolling, (start, stop), x, "LSODA", t_eval=np.append(at, stop), rtol=1e-9,
                         atol=1e-11 * scale, max_step=2e-4)
        psi += part.y[0, :-1].tolist()
        found += at.tolist()
        x = part.y[:, -1]
    psi, found = np.array(psi), np.array(found)
    peaks = [float(np.max(np.abs(psi[(found >= second) & (found < second + 1)]))) for second in range(int(end))]
    return {"times": early, "torsionAngle": [float(psi[np.searchsorted(found, t)]) for t in early], "peaks": peaks}


def main():
    source = (f"SciPy {scipy.__version__}, solve_ivp (benches/landing_roll.py): LSODA at rtol 1e-9. peaks: the largest |ψ| of 20,000 "
              "values in each second.")
    lines = []
    for name, run in cases():
        lines.append(json.dumps({"id": name, "run": run, "expect": solve(run)}, ensure_ascii=False))
        print(name, file=sys.stderr)
    rolls = ",\n".join(lines)
    print(f'{{"source": {json.dumps(source, ensure_ascii=False)},\n "rolls": [\n{rolls}\n]}}')


if __name__ == "__main__":
    main()
