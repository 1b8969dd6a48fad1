#!/usr/bin/env python3
"""Backbone of a Duffing oscillator by harmonic balance in numpy: the peer of
benchmarks/motion_benchmark.cpp, backbone_of_200_points/0.

It shares no code with strainwave.  Alternating frequency and time over 128 samples, with the
tangent in closed form, Newton's method, and a straight line through two points as the next guess.
It prints the seconds for 200 points with 9 harmonics, the last frequency, and that of the closed
form by an elliptic integral.
"""
import json
import time

import numpy as np

K, K3, J, H, POINTS = 5e4, 1e10, 0.5, 9, 200
SAMPLES = 128
ANGLE = 2 * np.pi * np.arange(SAMPLES) / SAMPLES
BASIS = np.cos(np.outer(ANGLE, np.arange(H + 1)))
PROJECT = BASIS.T * np.where(np.arange(H + 1) == 0, 1, 2)[:, None] / SAMPLES
SQUARES = np.arange(H + 1) ** 2
HALF_RANGE = (1 - (-1.0) ** np.arange(H + 1)) / 2  # of a cosine series


def solve(u, amplitude):
    for _ in range(20):
        x, omega = u[:-1], u[-1]
        twist = BASIS @ x
        residual = PROJECT @ (K * twist + K3 * twist**3) - J * omega**2 * SQUARES * x
        slope = PROJECT @ ((K + 3 * K3 * twist**2)[:, None] * BASIS) - np.diag(J * omega**2 * SQUARES)
        matrix = np.zeros((H + 2, H + 2))
        matrix[:-1, :-1] = slope * amplitude
        matrix[:-1, -1] = -2 * J * omega**2 * SQUARES * x
        matrix[-1, :-1] = HALF_RANGE
        step = np.linalg.solve(matrix, np.append(residual, HALF_RANGE @ x / amplitude - 1))
        u = u - step * np.append(np.full(H + 1, amplitude), omega)
        if np.linalg.norm(step) < 1e-9:
            return u
    raise RuntimeError("no convergence")


def backbone():
    amplitudes = 5e-3 * np.arange(1, POINTS + 1) / POINTS
    u = np.zeros(H + 2)
    u[1], u[-1] = amplitudes[0], np.sqrt(K / J)
    before = u
    for amplitude in amplitudes:
        before, u = u, solve(2 * u - before, amplitude)
    return u[-1] / (2 * np.pi)


def closed_form(amplitude):
    bent = K3 / J * amplitude**2
    square = K / J + bent
    a, b = 1.0, np.sqrt(1 - bent / (2 * square))  # K(m) by the arithmetic-geometric mean
    for _ in range(60):
        a, b = (a + b) / 2, np.sqrt(a * b)
    return np.sqrt(square) / (4 * np.pi / (2 * a))


def main():
    times = []
    for _ in range(5):
        start = time.process_time()
        last = backbone()
        times.append(time.process_time() - start)
    print(json.dumps({"seconds": sorted(times)[2], "last_hertz": last, "exact": closed_form(5e-3)}))


if __name__ == "__main__":
    main()
