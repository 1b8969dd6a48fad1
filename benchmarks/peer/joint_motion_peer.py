#!/usr/bin/env python3
"""Motion of a joint with a catalogue spring, hysteresis, a breathing crack and a kinematic error, in scipy.

The peer of benchmarks/motion_benchmark.cpp, written the way an engineer would write it with
`scipy.integrate.solve_ivp`; it never imports strainwave.

    joint_motion_peer.py --duration 2
    {"method": {"error_rad": ..., "real_time": ...}, ...}

Each method runs with the loosest relative tolerance of 1e-3, 1e-4, ... whose output angle is within
--error of that of DOP853 at 1e-13.  `real_time` is the simulated time over the CPU time.
"""
import argparse
import json
import time
from math import copysign, cos, sin

from scipy.integrate import solve_ivp

RATIO = -100.0
J_M, J_L = 1e-4, 1.0
STIFFNESS, CORNERS = (3.1e4, 5e4, 5.7e4), (14.0, 48.0)
DAMPING, B_M, B_L = 10.0, 1e-3, 0.5
SIGMA, LIMIT = 1e5, 3.0  # Dahl
CRACK, ORDER = 2e-6, 2.02
ERRORS = ((2, 2e-4, 0.3), (4, 5e-5, 1.1), (1, 3e-5, 0.0))
T_M, T_EXT = -0.6094395102, -40.0
START = (0.0, -209.4395102, 0.0, 2.094395102, 0.0)


def elastic_torque(twist, crack):
    """Torque of the catalogue spring in series with a compliance."""
    size, torque, at = abs(twist), 0.0, 0.0
    for stiffness, corner in zip(STIFFNESS, CORNERS + (float("inf"),)):
        compliance = 1 / stiffness + crack
        end = at + (corner - torque) * compliance
        if size <= end:
            return copysign(torque + (size - at) / compliance, twist)
        torque, at = corner, end
    raise AssertionError


def rate(_, x):
    theta, omega, angle, speed, z = x
    error = slope = 0.0
    for order, amplitude, phase in ERRORS:
        error += amplitude * sin(order * theta + phase)
        slope += amplitude * order * cos(order * theta + phase)
    arm = 1 / RATIO + slope
    twist = theta / RATIO + error - angle
    turning = arm * omega - speed
    opening = CRACK * (1 + cos(ORDER * theta)) / 2 if twist > 0 else 0.0
    opening_slope = -CRACK * ORDER * sin(ORDER * theta) / 2 if twist > 0 else 0.0
    elastic = elastic_torque(twist, opening)
    torque = elastic + DAMPING * turning + z
    return (omega,
            (T_M - B_M * omega - arm * torque + elastic * elastic / 2 * opening_slope) / J_M,
            speed,
            (torque - B_L * speed + T_EXT) / J_L,
            SIGMA * (turning - abs(turning) * z / LIMIT))


def run(method, tolerance, duration):
    start = time.process_time()
    solution = solve_ivp(rate, (0, duration), START, method=method, rtol=tolerance, atol=tolerance * 1e-3,
                         t_eval=(duration,))
    return solution.y[2, -1], time.process_time() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--duration", type=float, default=2.0, metavar="S")
    parser.add_argument("--error", type=float, default=1e-6, metavar="RAD")
    options = parser.parse_args()
    exact, _ = run("DOP853", 1e-13, options.duration)
    result = {"exact": exact}
    for method in ("RK45", "DOP853", "LSODA", "Radau"):
        for digits in range(3, 13):
            angle, seconds = run(method, 10.0 ** -digits, options.duration)
            if abs(angle - exact) <= options.error:
                result[method] = {"error_rad": abs(angle - exact), "relative_tolerance": 10.0 ** -digits,
                                  "real_time": options.duration / seconds}
                break
    print(json.dumps(result))


if __name__ == "__main__":
    main()
