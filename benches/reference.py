"""The reference of the benchmark: the torsional gear integrated by Taylor series in 128-bit floats.

No Runge-Kutta formula and no polynomial of the engine has a part in it. Within one mode (which
side of |alpha| = delta, |alpha| = alpha_g and |psi| = psi_fp the state is on) the solution is
analytic, and its Taylor coefficients follow from the equations by the recurrences of power series:
with q = 1 + x^2, alpha = arctan x obeys alpha' q = x', and sin and cos of a series obey
s' = c u', c' = -s u'. A step ends where a switch changes sign, so no step straddles a kink.

    pip install gmpy2
    python3 benches/reference.py            prints the states of the case at its times
"""

import json
import sys
from pathlib import Path

import gmpy2
from gmpy2 import mpfr

PSI, RATE, Y = range(3)
SAMPLES = 24  # points a step at which switches and their slopes are looked at

DEFAULTS = {
    "velocity": 50.0, "casterLength": 0.1, "halfContactLength": 0.1, "relaxationLength": 0.3,
    "momentOfInertia": 1.0, "torsionalStiffness": 1e5, "dampingConstant": 10.0,
    "verticalForce": 9000.0, "sideForceDerivative": 20.0, "aligningMomentDerivative": 2.0,
    "sideForceLimitAngle": None, "aligningMomentLimitAngle": None,  # 5 and 10 degrees
    "treadWidthMomentConstant": 270.0, "freeplayAngle": 0.0,
}


class Gear:
    """The torsional gear: Taylor coefficients of its motion in the mode that holds."""

    def __init__(self, parameters, linear=False):
        values = {**DEFAULTS, **parameters}
        degree = gmpy2.const_pi() / 180
        get = lambda name: mpfr(values[name])
        self.linear = linear
        self.v, self.e, self.a = get("velocity"), get("casterLength"), get("halfContactLength")
        self.sigma, self.inertia = get("relaxationLength"), get("momentOfInertia")
        self.k, self.c = get("torsionalStiffness"), get("dampingConstant")
        self.kappa, self.freeplay = get("treadWidthMomentConstant"), get("freeplayAngle")
        self.side = get("sideForceDerivative") * get("verticalForce")
        self.aligning = get("aligningMomentDerivative") * get("verticalForce")
        limit = lambda name, default: default * degree if values[name] is None else get(name)
        self.delta = limit("sideForceLimitAngle", 5)
        self.alpha_g = limit("aligningMomentLimitAngle", 10)
        # Every switch: (state, threshold); its mode is whether the state lies above the threshold.
        self.switches = []
        if not linear:
            for angle in (self.delta, self.alpha_g):
                reach = self.sigma * gmpy2.tan(angle)
                self.switches += [(Y, reach), (Y, -reach)]
            if self.freeplay > 0:
                self.switches += [(PSI, self.freeplay), (PSI, -self.freeplay)]

    def mode(self, state):
        return [state[which] > threshold for which, threshold in self.switches]

    def series(self, state, mode, order):
        """Coefficients of psi, its rate and y, lowest power first."""
        psi, rate, y = [state[PSI]], [state[RATE]], [state[Y]]
        damping = self.c + self.kappa / self.v
        side_sign = aligning_on = spring_sign = None
        inside_side = True
        if not self.linear:
            above, below = mode[0], not mode[1]
            inside_side = not (above or below)
            side_sign = 1 if above else -1
            aligning_on = not mode[2] and mode[3]
        gap = 0
        if self.freeplay > 0 and not self.linear:
            gap = 1 if mode[4] else (-1 if not mode[5] else None)
        x, q, alpha, sine, cosine = [], [], [], [], []
        stretch = gmpy2.const_pi() / self.alpha_g
        for n in range(order):
            x.append(y[n] / self.sigma)
            if self.linear:
                force, moment = self.side * x[n], -self.aligning * x[n]
            else:
                q.append(sum(x[i] * x[n - i] for i in range(n + 1)) + (1 if n == 0 else 0))
                if n == 0:
                    alpha.append(gmpy2.atan(x[0]))
                    s, c = gmpy2.sin_cos(stretch * alpha[0])
                    sine.append(s)
                    cosine.append(c)
                else:
                    past = sum(i * alpha[i] * q[n - i] for i in range(1, n))
                    alpha.append((n * x[n] - past) / (n * q[0]))
                    if aligning_on:
                        u = [i * stretch * alpha[i] for i in range(n + 1)]
                        sine.append(sum(u[i] * cosine[n - i] for i in range(1, n + 1)) / n)
                        cosine.append(-sum(u[i] * sine[n - i] for i in range(1, n + 1)) / n)
                constant = self.side * self.delta * side_sign if n == 0 else mpfr(0)
                force = self.side * alpha[n] if inside_side else constant
                moment = -self.aligning / stretch * sine[n] if aligning_on else mpfr(0)
            if gap is None:
                spring = mpfr(0)
            else:
                spring = psi[n] - (gap * self.freeplay if n == 0 else 0)
            torque = -self.k * spring - damping * rate[n] + moment - self.e * force
            psi.append(rate[n] / (n + 1))
            rate.append(torque / self.inertia / (n + 1))
            slip = self.v * psi[n] + (self.e - self.a) * rate[n] - self.v * x[n]
            y.append(slip / (n + 1))
        return psi, rate, y


def value(coefficients, t):
    total = coefficients[-1] * 0
    for coefficient in reversed(coefficients):
        total = total * t + coefficient
    return total


def slope(coefficients, t):
    return value([i * c for i, c in enumerate(coefficients)][1:], t)


def bisect(function, low, high):
    """The sign change of `function` between two doubles."""
    positive = function(high) > 0
    for _ in range(60):
        middle = 0.5 * (low + high)
        if (function(middle) > 0) == positive:
            high = middle
        else:
            low = middle
    return 0.5 * (low + high)


def crossing(coefficients, threshold, above, h):
    """The first time in (0, h] at which the state leaves its side of the threshold, or None.

    Looks for it in doubles, between the extrema of the state, where it is monotone; polishes it
    by Newton's method in full precision. A start on the threshold itself counts as the right side.
    """
    rough = [float(c) for c in coefficients]
    rough[0] = float(coefficients[0] - threshold)
    if abs(rough[0]) > sum(abs(c) * float(h) ** i for i, c in enumerate(rough) if i):
        return None
    h = float(h)
    times, slopes = [0.0], [slope(rough, 0.0)]
    for i in range(1, SAMPLES + 1):
        t = h * i / SAMPLES
        now = slope(rough, t)
        if (now > 0) != (slopes[-1] > 0):
            times.append(bisect(lambda at: slope(rough, at), h * (i - 1) / SAMPLES, t))
            slopes.append(now)
        times.append(t)
        slopes.append(now)
    for before, after in zip(times, times[1:]):
        g = value(rough, after)
        if g != 0 and (g > 0) != above:
            root = mpfr(bisect(lambda at: value(rough, at), before, after))
            shifted = [coefficients[0] - threshold, *coefficients[1:]]
            for _ in range(4):
                steep = slope(shifted, root)
                if steep == 0:
                    break
                root -= value(shifted, root) / steep
            return root if root > 0 else None
    return None


def integrate(gear, state, times, order=28, tolerance=1e-30):
    """The states at the ascending times, from t = 0; and how many kinks were crossed."""
    state = [mpfr(s) for s in state]
    scale = [abs(s) for s in state]
    mode, now, crossed, found = gear.mode(state), mpfr(0), 0, []
    tolerance = mpfr(tolerance)
    for target in times:
        target = mpfr(target)
        while now < target:
            series = gear.series(state, mode, order)
            h = target - now
            for which in range(3):
                size = max(scale[which], abs(series[which][1]) * mpfr("1e-4"), mpfr("1e-12"))
                for power in (order, order - 1):
                    if (last := abs(series[which][power])) > 0:
                        h = min(h, (tolerance * size / last) ** (mpfr(1) / power))
            first = None
            for index, (which, threshold) in enumerate(gear.switches):
                t = crossing(series[which], threshold, mode[index], h)
                if t is not None and (first is None or t < first[0]):
                    first = (t, index)
            if first is not None and first[0] < h:
                h = first[0]
                mode[first[1]] = not mode[first[1]]
                crossed += 1
            now = now + h if h < target - now else target
            state = [value(s, h) for s in series]
            scale = [max(a, abs(b)) for a, b in zip(scale, state)]
        found.append(state)
    return found, crossed


def main():
    case = json.loads((Path(__file__).parent / "case.json").read_text())
    gear = Gear(case["parameters"])
    start = [case["initial"].get(name, 0) for name in case["state"]]
    fine, crossed = integrate(gear, start, case["times"])
    coarse, _ = integrate(gear, start, case["times"], order=22, tolerance=1e-22)
    for t, state, check in zip(case["times"], fine, coarse):
        apart = max(abs((a - b) / a) for a, b in zip(state, check))
        print(f"t = {t} s:", ", ".join(f"{s:.18g}" for s in state), f"  two orders differ by {apart:.1e}")
    print(f"{crossed} kinks crossed", file=sys.stderr)


if __name__ == "__main__":
    gmpy2.get_context().precision = 128
    main()
