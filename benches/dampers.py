"""Where the tests' damper loops come from: the equations as they are printed, by SciPy.

    python3 benches/dampers.py > tests/damper-reference.json

z and w are integrated as they stand, by DOP853 at a tolerance of 1e-13, piece by piece between the turns of the piston and
of the element, so that no kink of |v| lies within a step.
"""

import json

import numpy as np
from scipy.integrate import solve_ivp

SPENCER = dict(c0a=2100, c0b=350, k0=4690, c1a=28300, c1b=295, k1=500, x0=0.143, aa=14000, ab=69500,
               gamma=3.63e6, beta=3.63e6, A=301, n=2)
RD1005 = dict(c0a=784, c0b=1803, k0=3610, c1a=14649, c1b=34622, k1=840, x0=0.0245, aa=12441, ab=38430,
              gamma=136320, beta=2059020, A=58, n=2)
NAMES = dict(c0a='viscousDampingBase', c0b='viscousDampingSlope', k0='stiffness', c1a='seriesDampingBase',
             c1b='seriesDampingSlope', k1='accumulatorStiffness', x0='offset', aa='hysteresisGainBase',
             ab='hysteresisGainSlope', gamma='gamma', beta='beta', A='amplitude', n='exponent')


def series(p, u):
    """c0, k0, alpha, c1, k1, x0 of the modified model."""
    return (p['c0a'] + p['c0b'] * u, p['k0'], p['aa'] + p['ab'] * u, p['c1a'] + p['c1b'] * u, p['k1'], p['x0'])


def yang(i):
    return (437097 * i**3 - 1545407 * i**2 + 1641376 * i + 457741, 137810,
            16566 * i**3 - 87071 * i**2 + 168326 * i + 15114,
            -9363108 * i**3 + 5334183 * i**2 + 48788640 * i - 2791630, 617.31, 0.18)


def rise(p, i, critical):
    p0, p1, p2 = p
    if i <= critical:
        return p0 + p1 * i
    return p0 + p1 * critical + (p1 * (i - critical) if p2 == 0 else p1 / p2 * (1 - np.exp(-p2 * (i - critical))))


def loop(force, hysteresis, in_series, amplitude, frequency, cycles, samples):
    """Rows t, F, z, w. force(x, v, z, w) gives F and the element's velocity."""
    gamma, beta, A, n = hysteresis
    w0 = 2 * np.pi * frequency
    motion = lambda t: (amplitude * np.sin(w0 * t), amplitude * w0 * np.cos(w0 * t))

    def rate(t, y):
        x, v = motion(t)
        slip = force(x, v, y[0], y[1])[1]
        z = y[0]
        dz = -gamma * abs(slip) * z * abs(z)**(n - 1) - beta * slip * abs(z)**n + A * slip
        return [dz, v - slip]

    times = np.arange(samples) * cycles / frequency / samples
    t, y, rows = 0.0, np.zeros(2), []
    zmax = (A / (beta + gamma))**(1 / n)
    atol = [1e-14 * zmax, 1e-14 * amplitude]

    def turn(t, y):
        return force(*motion(t), y[0], y[1])[1]

    turn.terminal = True
    end = cycles / frequency
    while t < end - 1e-15:
        solution = solve_ivp(rate, (t, end), y, method='DOP853', rtol=1e-13, atol=atol, events=turn, dense_output=True,
                             max_step=0.02 / frequency)
        last = solution.t[-1]
        for time in times[(times >= t) & (times < last)]:
            state = solution.sol(time)
            x, v = motion(time)
            rows.append([time, force(x, v, *state)[0], state[0], state[1] if in_series else 0.0])
        t, y = last, solution.y[:, -1]
        if solution.status == 1:  # past the turn, by a step in which nothing changes
            t += 1e-13 / frequency
    return rows


def side(c0, k0, x0, alpha, f0=0.0):
    return lambda x, v, z, w: (c0 * v + k0 * (x - x0) + alpha * z + f0, v)


def in_series(c0, k0, alpha, c1, k1, x0):
    def force(x, v, z, w):
        dw = (alpha * z + c0 * v + k0 * (x - w)) / (c0 + c1)
        return c1 * dw + k1 * (x - x0), v - dw
    return force


cases = []


def case(model, command, parameters, excitation, rows):
    cases.append(dict(spec=dict(damper=dict(model=model, command=command, parameters=parameters),
                                excitation=dict(amplitude=excitation[0], frequency=excitation[1]),
                                cycles=excitation[2], samples=excitation[3]), rows=rows))


SIMPLE = dict(c0=5000, k0=2500, x0=0.038, alpha=88000, gamma=1e6, beta=1e6, A=120, n=2)
for changes, excitation in [({}, (0.01, 2, 1.5, 24)), (dict(gamma=400, beta=300, n=1), (0.015, 2.5, 1.5, 24)),
                            (dict(n=3, gamma=2e8, beta=1e8), (0.002, 10, 1.5, 24)),
                            (dict(gamma=136320, beta=2059020), (0.005, 50, 1.5, 24)),
                            (dict(gamma=2e6, beta=-5e5), (0.003, 5, 1.5, 24))]:
    p = {**SIMPLE, **changes}
    names = dict(gamma='gamma', beta='beta', n='exponent')
    case('bouc-wen', 1.5, {names[k]: v for k, v in changes.items()}, excitation,
         loop(side(p['c0'], p['k0'], p['x0'], p['alpha']), (p['gamma'], p['beta'], p['A'], p['n']), False, *excitation))

for p, command, excitation in [(SPENCER, 0, (0.015, 2.5, 1.5, 24)), (SPENCER, 1.5, (0.015, 2.5, 1.5, 24)),
                               (SPENCER, 0.75, (0.02, 50, 1.5, 24)), (RD1005, 1, (0.01, 3, 1.5, 24)),
                               ({**SPENCER, 'n': 1, 'gamma': 3e4, 'beta': 1e4}, 1, (0.01, 2, 1.5, 24)),
                               ({**SPENCER, 'n': 1.5, 'gamma': 3e5, 'beta': 2e5}, 1, (0.004, 2, 1.5, 24))]:
    names = {NAMES[k]: v for k, v in p.items() if v != SPENCER[k]}
    case('modified-bouc-wen', command, names, excitation,
         loop(in_series(*series(p, command)), (p['gamma'], p['beta'], p['A'], p['n']), True, *excitation))

for command, excitation in [(0.06, (0.01, 1, 1.5, 24)), (1, (0.01, 1, 1.5, 24)), (2.5, (0.003, 5, 1.5, 24))]:
    case('modified-bouc-wen-cubic', command, {}, excitation,
         loop(in_series(*yang(command)), (647.46, 647.46, 2679, 10), True, *excitation))

DEPENDENT = dict(criticalCurrent=0.7, c=(1500, 900, 2.0), k=(600, 200, 0), alpha=(12000, 60000, 3.0), f=(-70, 20, 1.0),
                 gamma=3e6, beta=2e6, A=250)
for command, excitation in [(0.4, (0.01, 2, 1.5, 24)), (1.3, (0.01, 2, 1.5, 24))]:
    d = DEPENDENT
    parameters = dict(criticalCurrent=0.7, gamma=3e6, beta=2e6, amplitude=250, exponent=2)
    for name, numbers in zip(['viscousDamping', 'stiffness', 'hysteresisGain', 'preload'],
                             [d['c'], d['k'], d['alpha'], d['f']]):
        parameters |= dict(zip([name + 'Base', name + 'Slope', name + 'Saturation'], numbers))
    c0, k0, alpha, f0 = [rise(d[key], command, 0.7) for key in ['c', 'k', 'alpha', 'f']]
    case('current-dependent-bouc-wen', command, parameters, excitation,
         loop(side(c0, k0, 0.0, alpha, f0), (d['gamma'], d['beta'], d['A'], 2), False, *excitation))

print(json.dumps(cases))
