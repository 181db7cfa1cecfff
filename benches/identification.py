"""Generations a second of SciPy's differential evolution on the search of `javascript/identification.js`: the simple
Bouc-Wen damper, 60 individuals, 4 records of 500 samples, one core. The model is written with numpy over the whole
population at once, with the closed form of z between samples, as a script would that wants to be fast: for gamma = beta,
which leaves a parameter out and makes it simpler than ours.
"""

import json
import time

import numpy as np
import scipy
from scipy.optimize import differential_evolution

GENERATIONS = 60
MOTIONS = [(0.015, 2.5), (0.011, 2), (0.005, 4.5), (0.008, 4)]
TRUE = np.array([5000.0, 2500.0, 0.038, 88000.0, 1e6])
BOUNDS = [(np.log(100), np.log(2e4)), (np.log(100), np.log(2e4)), (-0.2, 0.2), (np.log(1e3), np.log(5e5)), (np.log(1e4), np.log(2e7))]
A = 120.0


def forces(values, x, v):
    """Of the individuals in columns, along one record."""
    c, k, x0, alpha, gamma = values
    rate, most = np.sqrt(2 * gamma * A), np.sqrt(A / (2 * gamma))
    z = np.zeros_like(c)
    out = np.empty((len(x), len(c)))
    out[0] = c * v[0] + k * (x[0] - x0)
    for i in range(1, len(x)):
        dx = x[i] - x[i - 1]
        heading = 1.0 if dx >= 0 else -1.0
        zeta, way = heading * z, abs(dx)
        back = np.maximum(-zeta, 0) / A  # the way to zero is straight where beta = gamma
        rest = np.maximum(way - back, 0)
        tanh = np.tanh(rate * rest)
        start = np.maximum(zeta, 0)
        away = (start + most * tanh) / (1 + start * tanh / most)
        z = heading * np.where(way < back, zeta + A * way, away)
        out[i] = c * v[i] + k * (x[i] - x0) + alpha * z
    return out


times = np.arange(500) * 3 / 500
records = []
for amplitude, frequency in MOTIONS:
    phase = 2 * np.pi * times
    x, v = amplitude * np.sin(phase), amplitude * 2 * np.pi * frequency * np.cos(phase)
    records.append((x, v, forces(TRUE[:, None], x, v)[:, 0]))
size = np.sqrt(np.mean(np.concatenate([record[2] for record in records]) ** 2))


def error(genes):
    values = np.array([genes[2] if i == 2 else np.exp(gene) for i, gene in enumerate(genes)])
    squares = sum(((forces(values, x, v) - f[:, None]) ** 2).sum(axis=0) for x, v, f in records)
    return np.sqrt(squares / 2000) / size


start = np.random.default_rng(1).uniform(*np.array(BOUNDS).T, size=(60, len(BOUNDS)))
began = time.perf_counter()
differential_evolution(error, BOUNDS, init=start, maxiter=GENERATIONS, tol=0, atol=0, polish=False, vectorized=True,
                       updating="deferred", seed=1)
seconds = time.perf_counter() - began
print(json.dumps({"identification": {"what": f"SciPy {scipy.__version__} differential_evolution, numpy: bouc-wen with γ = β, 5 parameters",
                                     "perSecond": GENERATIONS / seconds}}))
