#!/usr/bin/python3
"""K of a group of straight cracks by Gauss-Chebyshev quadrature in numpy, and many lives by a sum of Gauss and Legendre.

    benchmarks/peer/crack_group_peer.py --cracks 10 --repeat 5

Cracks and points are those of `crack_groups` of the benchmarks, the lives those of
`lives_of_constant_amplitude`.  Prints K and mean life with the seconds of each as JSON.
"""
import argparse
import json
import math
import time

import numpy as np


def crack_group(count, n=40):
    """K_I of the first tip ahead under equal tension 1 in all directions."""
    number = np.arange(count)
    centre = 3.0 * (number % 10) + 3.0j * (number // 10)
    angle = 0.1 * number
    k = np.arange(n)
    density = np.cos((2 * k + 1) * np.pi / (2 * n))
    force = np.cos(np.arange(1, n) * np.pi / n)
    turn = np.exp(1j * angle)
    at = (centre[:, None] + turn[:, None] * force).ravel()
    source = (centre[:, None] + turn[:, None] * density).ravel()
    d = at[:, None] - source
    plane = np.repeat(turn**2, n - 1)[:, None]
    # A dislocation of density A: N - iT = P A + Q conj(A) on a plane of the angle.
    P = 1 / d - plane * np.conj(d) / d**2
    Q = 1 / np.conj(d) + plane / d
    m, w = count * n, np.pi / n
    matrix = np.zeros((2 * m, 2 * m))
    right = np.zeros(2 * m)
    rows = count * (n - 1)
    matrix[:rows, :m] = w * (P + Q).real
    matrix[:rows, m:] = -w * (P - Q).imag
    matrix[rows:2 * rows, :m] = w * (P + Q).imag
    matrix[rows:2 * rows, m:] = w * (P - Q).real
    right[:rows] = -1.0
    for j in range(count):  # each crack is closed at its ends
        matrix[2 * rows + j, j * n:(j + 1) * n] = 1
        matrix[2 * rows + count + j, m + j * n:m + (j + 1) * n] = 1
    solution = np.linalg.solve(matrix, right)
    A = (solution[:m] + 1j * solution[m:])[:n]
    theta = (2 * k + 1) * np.pi / (2 * n)
    end = np.sum((-1.0)**k * A / np.tan(theta / 2)) / n  # value of the polynomial at the tip ahead
    return 2 * np.pi * end.real * math.sqrt(np.pi)  # the first crack lies along x


def mean_life(count=100000, nodes=24):
    """Mean of lives by Paris' law with coefficients of their own."""
    x, weight = np.polynomial.legendre.leggauss(nodes)
    low, high = math.log(1e-3), math.log(1e-2)
    a = np.exp(low + (high - low) * (x + 1) / 2)
    coefficient = 6.9e-12 * (1 + 1e-6 * np.arange(count))
    rate = coefficient[:, None] * np.power(1.12 * 200 * np.sqrt(np.pi * a), 3.0)
    return float(np.mean((a / rate) @ weight * (high - low) / 2))


def best(function, repeat):
    fastest = math.inf
    for _ in range(repeat):
        start = time.perf_counter()
        value = function()
        fastest = min(fastest, time.perf_counter() - start)
    return {"value": value, "seconds": fastest}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cracks", type=int, default=10)
    parser.add_argument("--repeat", type=int, default=5)
    given = parser.parse_args()
    print(json.dumps({"group": best(lambda: crack_group(given.cracks), given.repeat),
                      "lives": best(mean_life, given.repeat)}))


if __name__ == "__main__":
    main()
