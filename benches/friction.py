"""Motions of the torsional gear with dry friction by SciPy: tests/friction-reference.json.

Nothing of the engine has a part in it. The right-hand side is written once more from the equations; a motion is cut into
phases (slipping either way, or sticking) and at every kink of the tire's and the spring's laws by SciPy's own events, and
each phase is integrated by DOP853 to rtol 1e-13. The file's "referenceError" is the largest difference, relative to a
series' largest value, between that and Radau at rtol 1e-11.

    pip install scipy
    python3 benches/friction.py > tests/friction-reference.json
"""

import json
import sys

import numpy as np
from scipy.integrate import solve_ivp

DEGREE = np.pi / 180
DEFAULTS = {
    "velocity": 50.0, "casterLength": 0.1, "halfContactLength": 0.1, "relaxationLength": 0.3,
    "momentOfInertia": 1.0, "torsionalStiffness": 1e5, "dampingConstant": 10.0,
    "verticalForce": 9000.0, "sideForceDerivative": 20.0, "aligningMomentDerivative": 2.0,
    "sideForceLimitAngle": 5 * DEGREE, "aligningMomentLimitAngle": 10 * DEGREE,
    "treadWidthMomentConstant": 270.0, "freeplayAngle": 0.0,
}
STATES = ["torsionAngle", "torsionRate", "lateralDeformation"]


class Gear:
    def __init__(self, run):
        p = {**DEFAULTS, **run.get("parameters", {})}
        self.p, self.linear = p, run["model"] == "torsional-linear"
        self.friction = run["friction"]["moment"]
        self.levels = []  # (state, level): where a law changes
        if not self.linear:
            for angle in (p["sideForceLimitAngle"], p["aligningMomentLimitAngle"]):
                reach = p["relaxationLength"] * np.tan(angle)
                self.levels += [(2, reach), (2, -reach)]
            if p["freeplayAngle"] > 0:
                self.levels += [(0, p["freeplayAngle"]), (0, -p["freeplayAngle"])]

    def load(self, x):
        """All moments about the steering axis but friction's and those of the rate."""
        p, (psi, _, y) = self.p, x
        q = y / p["relaxationLength"]
        side, aligning = p["sideForceDerivative"] * p["verticalForce"], p["aligningMomentDerivative"] * p["verticalForce"]
        if self.linear:
            return -p["torsionalStiffness"] * psi - (aligning + p["casterLength"] * side) * q
        alpha, delta, alpha_g = np.arctan(q), p["sideForceLimitAngle"], p["aligningMomentLimitAngle"]
        force = side * np.clip(alpha, -delta, delta)
        moment = -aligning * alpha_g / np.pi * np.sin(np.pi * alpha / alpha_g) if abs(alpha) <= alpha_g else 0.0
        gap = p["freeplayAngle"]
        spring = psi - np.clip(psi, -gap, gap)
        return -p["torsionalStiffness"] * spring + moment - p["casterLength"] * force

    def rate(self, x, phase):
        p, (psi, rate, y) = self.p, x
        slip = p["velocity"] * psi + (p["casterLength"] - p["halfContactLength"]) * rate - p["velocity"] / p["relaxationLength"] * y
        if phase == 0:
            return [0.0, 0.0, slip]
        damping = p["dampingConstant"] + p["treadWidthMomentConstant"] / p["velocity"]
        return [rate, (self.load(x) - damping * rate - self.friction * phase) / p["momentOfInertia"], slip]

    def phase(self, x):
        if x[1] != 0:
            return int(np.sign(x[1]))
        load = self.load(x)
        return 0 if abs(load) <= self.friction else int(np.sign(load))


def falling(function):
    function.terminal, function.direction = True, -1
    return function


def motion(gear, start, times, **method):
    """States at the times, and how often it stopped and was let go."""
    t, x, phase = 0.0, np.array(start, float), gear.phase(start)
    sides = [np.sign(x[which] - level) or 1.0 for which, level in gear.levels]
    out, stops, releases = [], 0, 0
    while t < times[-1]:
        events = [
            falling(lambda _, x, side=side, which=which, level=level: side * (x[which] - level))
            for side, (which, level) in zip(sides, gear.levels)
            if not (phase == 0 and which == 0)
        ]
        kept = [i for i, (which, _) in enumerate(gear.levels) if not (phase == 0 and which == 0)]
        if phase:
            events.append(falling(lambda _, x: phase * x[1]))
        else:
            events.append(falling(lambda _, x: gear.friction - abs(gear.load(x))))
        wanted = [time for time in times if t < time or (t == 0 and time == 0)]
        span = solve_ivp(lambda _, x: gear.rate(x, phase), (t, times[-1]), x, t_eval=wanted, events=events,
                         atol=1e-16, max_step=2e-3, **method)
        out += list(np.transpose(span.y)) if len(span.t) else []
        if span.status == 0:
            break
        which = next(i for i, found in enumerate(span.t_events) if len(found))
        t, x = span.t_events[which][0], np.array(span.y_events[which][0])
        if which < len(kept):
            sides[kept[which]] *= -1
        elif phase:
            x[1] = 0.0
            phase, before = gear.phase(x), phase
            stops += 1
            assert phase != before
        else:
            phase = int(np.sign(gear.load(x)))
            releases += 1
    return np.array(out), stops, releases


def cases():
    def case(name, friction, start, duration, model="torsional", **parameters):
        times = [round(duration * i / 20, 12) for i in range(21)]
        initial = dict(zip(STATES, start))
        run = {"model": model, "parameters": parameters, "friction": {"moment": friction}, "initial": initial, "times": times}
        return {"id": name, "run": run}

    yield case("shakes", 40, [0.05, 0, 0], 0.4, velocity=80, dampingConstant=20)
    yield case("dies and sticks", 80, [0.05, 0, 0], 0.2, velocity=30, dampingConstant=60)
    yield case("held, then let go", 100, [0.9e-3, 0, 0], 0.3, velocity=2, dampingConstant=5)
    yield case("sticks in every swing", 1000, [0.1, 0, 0], 1.0, velocity=5, dampingConstant=0,
               torsionalStiffness=2000, casterLength=0.05)
    yield case("creeps home", 100, [0.1, 0, 0], 1.0, velocity=2, dampingConstant=20, torsionalStiffness=500)
    yield case("rattles", 20, [0.03, 0, 0], 0.4, velocity=50, dampingConstant=100, freeplayAngle=1 * DEGREE)
    yield case("straight laws", 30, [0.02, 1, 0.001], 0.3, model="torsional-linear", velocity=60, dampingConstant=25)


def main():
    out = []
    for case in cases():
        run = case["run"]
        start, times = [run["initial"][name] for name in STATES], run["times"]
        gear = Gear(run)
        best, stops, releases = motion(gear, start, times, method="DOP853", rtol=1e-13)
        other, *same = motion(gear, start, times, method="Radau", rtol=1e-11)
        largest = np.abs(best).max(axis=0)
        error = (np.abs(best - other) / largest).max()
        print(case["id"], stops, releases, same, error, best[-1], file=sys.stderr)
        case |= {"stops": stops, "releases": releases, "referenceError": float(error)}
        case["expect"] = {name: [float(v) for v in best[:, i]] for i, name in enumerate(STATES)}
        out.append(case)
    import scipy
    source = f"SciPy {scipy.__version__}, solve_ivp with events (benches/friction.py): DOP853 at rtol 1e-13, phase by phase and kink by kink. referenceError: its largest difference from Radau at rtol 1e-11, relative to a series' largest value. stops, releases: how often the wheel stopped, and was let go after it had stuck."
    rows = ",\n".join(json.dumps(case) for case in out)
    print(f'{{"source": {json.dumps(source)},\n "trajectories": [\n{rows}\n]}}')


if __name__ == "__main__":
    main()
