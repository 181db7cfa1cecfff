"""Motions of the torsional gear with a magnetorheological damper by SciPy: tests/damped-gear-reference.json.

Nothing of the engine has a part in it. The right-hand side is written once more from the equations, with the hysteresis
variable as the stiff equation that it is: ż = (A − (γ sign(vz) + β)|z|ⁿ) v at the velocity v of its ends. A motion is cut
where dry friction stops the wheel or lets it go, by SciPy's own events; all other kinks are left to the error control of
DOP853 at rtol 1e-11, in steps of some microseconds. The file's "referenceError" is the largest difference, relative to a
series' largest value, from the same at rtol 1e-9.

    pip install scipy
    python3 benches/damped_gear.py > tests/damped-gear-reference.json
"""

import json
import sys

import numpy as np
import scipy
from scipy.integrate import solve_ivp

DEGREE = np.pi / 180
GEAR = {
    "velocity": 50.0, "casterLength": 0.1, "halfContactLength": 0.1, "relaxationLength": 0.3,
    "momentOfInertia": 1.0, "torsionalStiffness": 1e5, "dampingConstant": 10.0,
    "verticalForce": 9000.0, "sideForceDerivative": 20.0, "aligningMomentDerivative": 2.0,
    "sideForceLimitAngle": 5 * DEGREE, "aligningMomentLimitAngle": 10 * DEGREE,
    "treadWidthMomentConstant": 270.0, "freeplayAngle": 0.0,
}
SPENCER = {
    "viscousDampingBase": 2100.0, "viscousDampingSlope": 350.0, "stiffness": 4690.0,
    "seriesDampingBase": 28300.0, "seriesDampingSlope": 295.0, "accumulatorStiffness": 500.0, "offset": 0.0,
    "hysteresisGainBase": 14000.0, "hysteresisGainSlope": 69500.0, "gamma": 3.63e6, "beta": 3.63e6, "exponent": 2.0,
    "amplitude": 301.0, "commandRate": 190.0,
}
YANG = {"gamma": 647.46, "beta": 647.46, "exponent": 10.0, "amplitude": 2679.0, "stiffness": 137810.0,
        "accumulatorStiffness": 617.31, "forceScale": 0.01}


def coefficients(model, p, u):
    """c₀, k₀, α, c₁ (None side by side), k₁, preload, force scale."""
    if model == "bouc-wen":
        return (p["viscousDamping"], p["stiffness"], p["hysteresisGain"], None, 0.0,
                -p["stiffness"] * p.get("offset", 0.0), 1.0)
    if model == "modified-bouc-wen":
        return (p["viscousDampingBase"] + p["viscousDampingSlope"] * u, p["stiffness"],
                p["hysteresisGainBase"] + p["hysteresisGainSlope"] * u,
                p["seriesDampingBase"] + p["seriesDampingSlope"] * u, p["accumulatorStiffness"],
                -p["accumulatorStiffness"] * p["offset"], 1.0)
    if model == "modified-bouc-wen-cubic":
        return (437097 * u**3 - 1545407 * u**2 + 1641376 * u + 457741, p["stiffness"],
                16566 * u**3 - 87071 * u**2 + 168326 * u + 15114,
                -9363108 * u**3 + 5334183 * u**2 + 48788640 * u - 2791630, p["accumulatorStiffness"], 0.0,
                p["forceScale"])

    def rising(name):
        base, slope, fading, knee = p[name + "Base"], p[name + "Slope"], p[name + "Saturation"], p["criticalCurrent"]
        if u <= knee:
            return base + slope * u
        beyond = u - knee
        return base + slope * knee + (slope * beyond if fading == 0 else slope / fading * (1 - np.exp(-fading * beyond)))
    return rising("viscousDamping"), rising("stiffness"), rising("hysteresisGain"), None, 0.0, rising("preload"), 1.0


class Damped:
    def __init__(self, run):
        self.p = {**GEAR, **run.get("parameters", {})}
        self.friction = run.get("friction", {}).get("moment", 0.0)
        damper = run["damper"]
        self.model, self.d = damper["model"], damper["parameters"]
        if self.model == "modified-bouc-wen":
            self.d = {**SPENCER, **self.d}
        if self.model == "modified-bouc-wen-cubic":
            self.d = {**YANG, **self.d}
        self.command, self.lever = damper.get("command", 0.0), damper.get("leverArm", 0.1)
        self.states = ["torsionAngle", "torsionRate", "lateralDeformation", "hysteresis"]
        series = self.model.startswith("modified")
        if series:
            self.states.append("internalDisplacement")
        self.lag = self.d.get("commandRate", 0.0) if series else 0.0
        if self.lag:
            self.states.append("effectiveCommand")

    def damper(self, x):
        """F, and the rates of its states."""
        u = x[-1] if self.lag else self.command
        c0, k0, alpha, c1, k1, preload, scale = coefficients(self.model, self.d, u)
        way, velocity, z = self.lever * x[0], self.lever * x[1], x[3]
        rates = []
        if c1 is None:
            force, ends = c0 * velocity + k0 * way + alpha * z + preload, velocity
        else:
            inner = (alpha * z + c0 * velocity + k0 * (way - x[4])) / (c0 + c1)
            force, ends = c1 * inner + k1 * way + preload, velocity - inner
            rates.append(inner)
        d = self.d
        rate = (d["amplitude"] - (d["gamma"] * np.sign(ends * z) + d["beta"]) * abs(z) ** d["exponent"]) * ends
        if self.lag:
            rates.append(-self.lag * (x[-1] - self.command))
        return scale * force, [rate, *rates]

    def load(self, x):
        """All moments but friction's on a wheel that does not turn."""
        return self.moment([x[0], 0.0, *x[2:]])

    def moment(self, x):
        p, (psi, rate, y) = self.p, x[:3]
        alpha = np.arctan(y / p["relaxationLength"])
        delta, alpha_g = p["sideForceLimitAngle"], p["aligningMomentLimitAngle"]
        side, aligning = p["sideForceDerivative"] * p["verticalForce"], p["aligningMomentDerivative"] * p["verticalForce"]
        force = side * np.clip(alpha, -delta, delta)
        moment = -aligning * alpha_g / np.pi * np.sin(np.pi * alpha / alpha_g) if abs(alpha) <= alpha_g else 0.0
        spring = psi - np.clip(psi, -p["freeplayAngle"], p["freeplayAngle"])
        damping = p["dampingConstant"] + p["treadWidthMomentConstant"] / p["velocity"]
        return (moment - p["casterLength"] * force - p["torsionalStiffness"] * spring - damping * rate
                - self.lever * self.damper(x)[0])

    def rate(self, x, phase):
        p = self.p
        slip = (p["velocity"] * x[0] + (p["casterLength"] - p["halfContactLength"]) * x[1]
                - p["velocity"] / p["relaxationLength"] * x[2])
        _, rates = self.damper(x)
        if phase == 0 and self.friction:
            return [0.0, 0.0, slip, *rates]
        return [x[1], (self.moment(x) - phase * self.friction) / p["momentOfInertia"], slip, *rates]


def phase_at(gear, x):
    if not gear.friction:
        return 0
    if x[1] != 0:
        return int(np.sign(x[1]))
    load = gear.load(x)
    return int(np.sign(load)) if abs(load) > gear.friction else 0


def solve(run, rtol):
    gear = Damped(run)
    x = [run["initial"].get(name, 0.0) for name in gear.states]
    if gear.lag and "effectiveCommand" not in run["initial"]:
        x[-1] = gear.command
    scale = [0.1, 30.0, 0.02, 1.0 if gear.model.endswith("cubic") else 5e-3, 1e-3, 1.0][: len(x)]
    times, t, rows = run["times"], 0.0, []
    phase = phase_at(gear, x)
    while t < times[-1] or not rows:
        events = []
        if gear.friction and phase:
            stop = lambda t, x, phase=phase: phase * x[1]
            stop.terminal, stop.direction = True, -1
            events.append(stop)
        elif gear.friction:
            release = lambda t, x: gear.friction - abs(gear.load(x))
            release.terminal, release.direction = True, -1
            events.append(release)
        found = solve_ivp(lambda t, x: gear.rate(x, phase), (t, times[-1]), x, "DOP853", rtol=rtol,
                          atol=[1e-3 * rtol * s for s in scale], max_step=2e-5, dense_output=True, events=events or None)
        rows += [found.sol(time).tolist() for time in times if t <= time < found.t[-1] or (not rows and time == t)]
        t, x = found.t[-1], found.y[:, -1].tolist()
        if gear.friction and found.status == 1:
            load = gear.load(x)
            x[1] = 0.0
            phase = int(np.sign(load)) if phase == 0 or abs(load) > gear.friction else 0
    rows.append(x)
    return gear.states, np.array(rows)


def cases():
    times = [round(0.02 * i, 12) for i in range(11)]
    def of(name, parameters, damper, initial, **more):
        return name, {"model": "torsional", "parameters": parameters, "damper": damper, "initial": initial, "times": times, **more}
    simple = {"viscousDamping": 2450.0, "stiffness": 2000.0, "offset": 0.0, "hysteresisGain": 83500.0, "gamma": 3.63e6,
              "beta": 3.63e6, "exponent": 2.0, "amplitude": 301.0}
    yield of("modified", {"velocity": 80, "dampingConstant": 0},
             {"model": "modified-bouc-wen", "leverArm": 0.1, "command": 1.2, "parameters": {}}, {"torsionAngle": 0.05})
    yield of("modified, coil under way", {"velocity": 50, "dampingConstant": 20},
             {"model": "modified-bouc-wen", "leverArm": 0.12, "command": 1.0, "parameters": {}},
             {"torsionAngle": 0.05, "effectiveCommand": 0.0, "internalDisplacement": 0.001})
    yield of("modified, RD-1005-3", {"velocity": 80, "dampingConstant": 0},
             {"model": "modified-bouc-wen", "leverArm": 0.1, "command": 0.5, "parameters": {
                 "viscousDampingBase": 784, "viscousDampingSlope": 1803, "stiffness": 3610, "seriesDampingBase": 14649,
                 "seriesDampingSlope": 34622, "accumulatorStiffness": 840, "hysteresisGainBase": 12441,
                 "hysteresisGainSlope": 38430, "gamma": 136320, "beta": 2059020, "amplitude": 58}}, {"torsionAngle": 0.1})
    yield of("cubic", {"velocity": 50, "dampingConstant": 0},
             {"model": "modified-bouc-wen-cubic", "leverArm": 0.1, "command": 1.0, "parameters": {}}, {"torsionAngle": 0.1})
    yield of("current-dependent", {"velocity": 80, "dampingConstant": 0},
             {"model": "current-dependent-bouc-wen", "leverArm": 0.1, "command": 1.4, "parameters": {
                 "criticalCurrent": 0.8, "viscousDampingBase": 2000, "viscousDampingSlope": 400, "viscousDampingSaturation": 1.5,
                 "stiffnessBase": 300, "stiffnessSlope": 100, "stiffnessSaturation": 0,
                 "hysteresisGainBase": 14000, "hysteresisGainSlope": 69500, "hysteresisGainSaturation": 2.0,
                 "preloadBase": 3.0, "preloadSlope": -1.0, "preloadSaturation": 1.0,
                 "gamma": 3.0e6, "beta": 1.0e6, "exponent": 2, "amplitude": 250}}, {"torsionAngle": 0.05})
    yield of("with freeplay", {"velocity": 80, "dampingConstant": 0, "freeplayAngle": 0.5 * DEGREE},
             {"model": "bouc-wen", "leverArm": 0.1, "parameters": simple}, {"torsionAngle": 0.03, "torsionRate": 5.0})
    yield of("n = 1", {"velocity": 40, "dampingConstant": 5},
             {"model": "bouc-wen", "leverArm": 0.1, "parameters": {**simple, "gamma": 30000.0, "beta": 15000.0, "exponent": 1.0}},
             {"torsionAngle": 0.08, "hysteresis": -0.001})
    yield of("n = 3.5", {"velocity": 60, "dampingConstant": 5},
             {"model": "bouc-wen", "leverArm": 0.08, "parameters": {**simple, "gamma": 6e9, "beta": -2e9, "exponent": 3.5}},
             {"torsionAngle": 0.08})
    yield of("with friction, sticking", {"velocity": 60, "dampingConstant": 5},
             {"model": "bouc-wen", "leverArm": 0.1, "parameters": simple}, {"torsionAngle": 0.03}, friction={"moment": 300})
    yield of("modified with friction", {"velocity": 60, "dampingConstant": 5, "freeplayAngle": 1 * DEGREE},
             {"model": "modified-bouc-wen", "leverArm": 0.1, "command": 0.3, "parameters": {}}, {"torsionAngle": 0.06},
             friction={"moment": 60})


def main():
    source = (f"SciPy {scipy.__version__}, solve_ivp (benches/damped_gear.py): DOP853 at rtol 1e-11 on the stiff equations as "
              "they are. referenceError: its largest difference from the same at rtol 1e-9, relative to a series' largest value.")
    out = []
    for name, run in cases():
        states, rows = solve(run, 1e-11)
        _, loose = solve(run, 1e-9)
        error = max(np.max(np.abs(rows[:, i] - loose[:, i])) / max(np.max(np.abs(rows[:, i])), 1e-300) for i in range(len(states)))
        print(name, error, file=sys.stderr)
        expect = {state: rows[:, i].tolist() for i, state in enumerate(states)}
        out.append({"id": name, "run": run, "referenceError": float(error), "expect": expect})
    lines = ",\n".join(json.dumps(case, ensure_ascii=False) for case in out)
    print(f'{{"source": {json.dumps(source, ensure_ascii=False)},\n "trajectories": [\n{lines}\n]}}')


if __name__ == "__main__":
    main()
