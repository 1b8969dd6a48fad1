#!/usr/bin/python3
"""A life by Paris' law by scipy's `quad` to 1e-9, with an integrand in numpy and one in plain Python.

    benchmarks/peer/crack_life_peer.py --repeat 200

C 6.9e-12, m 3, K = 1.12 * 200 MPa sqrt(pi a), 1 to 10 mm, as in `growth_life` of the benchmarks.
Prints the cycles and the seconds of each as JSON.
"""
import argparse
import json
import math
import time

import numpy as np
from scipy.integrate import quad

C, M, STRESS = 6.9e-12, 3.0, 1.12 * 200.0


def in_numpy(a):
    return 1 / (C * np.power(STRESS * np.sqrt(np.pi * a), M))


def in_python(a):
    return 1 / (C * (STRESS * math.sqrt(math.pi * a)) ** M)


def measured(integrand, repeat):
    best = math.inf
    for _ in range(repeat):
        start = time.perf_counter()
        cycles, _ = quad(integrand, 1e-3, 1e-2, epsrel=1e-9, epsabs=0)
        best = min(best, time.perf_counter() - start)
    return {"cycles": cycles, "seconds": best}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--repeat", type=int, default=200)
    repeat = parser.parse_args().repeat
    print(json.dumps({"numpy": measured(in_numpy, repeat), "python": measured(in_python, repeat)}))


if __name__ == "__main__":
    main()
