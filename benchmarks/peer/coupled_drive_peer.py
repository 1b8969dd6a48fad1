#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Torque-twist curves of the coupled drive model in plain numpy and scipy.

The peer of strainwave's curve of a drive of size 25, ratio 100: the vectorised dense Newton of
tools/reference/coupled_drive.py (Cholesky factors, only the closed contacts in the Hessian), set
up, assembled and loaded torque by torque up to T3 = 1.6 T2; it never imports strainwave.  For one
thread set OMP_NUM_THREADS=1 and OPENBLAS_NUM_THREADS=1.

    coupled_drive_peer.py --repeat 5
    {"twist_at_T3": ... [rad], "seconds_11": ..., "seconds_200": ...}     (medians, whole curves)
"""
import argparse
import json
import statistics
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "reference"))

import coupled_drive  # noqa: E402


def curve(points, **changes):
    """Torques and twists of a drive that is set up from its dimensions."""
    drive = coupled_drive.typical(25, 100, **changes)
    last = coupled_drive.torques(drive)[-1]
    loads = last * np.arange(1, points + 1) / points
    # 1e-9 of the contact forces: enough for a curve; the last Newton step is more accurate
    results = coupled_drive.Coupled(drive, tolerance=1e-9).curve(loads)
    return loads, np.array([twist for _, twist, _ in results])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--repeat", type=int, default=1, metavar="N")
    parser.add_argument("--no-warping", action="store_true", help="diaphragm without warping")
    parser.add_argument("--support", type=float, default=0.0, metavar="S",
                        help="support of the circular spline, 0 rigid to 1 free")
    options = parser.parse_args()
    changes = {"diaphragm_warping": not options.no_warping, "spline_support": options.support,
               "tooth": "straight", "tips": "relieved"}
    result = {}
    for points in (11, 200):
        times = []
        for _ in range(max(1, options.repeat)):
            start = time.perf_counter()
            _, twist = curve(points, **changes)
            times.append(time.perf_counter() - start)
        result["twist_at_T3"] = twist[-1]
        result[f"seconds_{points}"] = statistics.median(times)
    print(json.dumps(result))


if __name__ == "__main__":
    main()
