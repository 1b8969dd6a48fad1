"""Writes src/sif/shell_row_table.hpp: what the curvature between the cracks of a row adds to K.

A row of equal through cracks round a tube, half length a, pitch p, angle beta, shell parameter lambda.
Tabulated is K of the shallow-shell row of crack_rows.py (columns nn, tn, bn, cn, nt, tt, bt, ct of
shell_crack.py) less that of a crack alone on the shell under the stress of the row in a flat sheet, over
(2 a/p)^2.  Nodes are Chebyshev-Lobatto in beta from 0 to 90 degrees, in lambda from 0 to 4, where the
difference is 0 at 0, and in the share of the largest 2 a/p from 0.1 to 1; the file holds coefficients of
Chebyshev polynomials.  Takes half an hour on one core.

    row_tables.py           writes the header
    row_tables.py --check   compares the polynomials with places between the nodes
"""
import sys
from pathlib import Path

import numpy as np

import crack_rows
from shell_tables import lobatto

ANGLES, LAMBDAS, SHARES = 9, 9, 12
LARGEST_LAMBDA, LEAST_SHARE, END, STACKED = 4.0, 0.1, 0.85, 0.15
TERMS, NU = crack_rows.TERMS, crack_rows.NU
EVEN, ODD = np.arange(0, 2 * TERMS, 2), np.arange(1, 2 * TERMS, 2)


def largest_share(beta):
    """Largest 2 a/p of the table: 0.85 for cracks in one line, 1.7 at 45 degrees, 2.2 for axial cracks."""
    slanted = np.sin(beta) ** 6
    return END / np.sqrt(slanted + STACKED * (1 - slanted))


def factors(matrix):
    """K over sigma sqrt(pi a): rows I and II of the membrane, then of bending; columns normal, shear."""
    load = np.zeros((4 * TERMS, 2))
    load[0, 0] = load[TERMS, 1] = np.pi / 2
    V, U, rotation, W = np.linalg.solve(matrix, load).reshape(4, TERMS, 2)
    flat_b = (1 - NU) * (3 + NU) / 4
    bend = flat_b * np.sqrt(3 / (1 - NU**2)) * np.sqrt((1 + NU) / (3 + NU))
    tip = (ODD + 1) * (ODD + 2) * (ODD + 3) / 2
    return np.array([(EVEN + 1) @ V / 4, (EVEN + 1) @ U / 4, bend * ((EVEN + 1) @ rotation), bend * (tip @ W)])


def excess(lam, beta, share):
    """The tabulated columns times (2 a/p)^2."""
    alone, curved = crack_rows.crack_alone(lam, beta)
    sheet = alone + crack_rows.neighbours_in_sheet(beta, 2 / share)
    row = sheet + crack_rows.curvature_of_row(lam, beta, 2 / share)
    return (factors(row) - factors(alone + curved) @ factors(sheet)[:2]).T.ravel()


def coefficients(values, axis):
    """Chebyshev coefficients of values at Lobatto nodes along one axis."""
    n = values.shape[axis]
    places = -np.cos(np.pi * np.arange(n) / (n - 1))
    return np.moveaxis(np.tensordot(np.linalg.inv(np.polynomial.chebyshev.chebvander(places, n - 1)),
                                    values, (1, axis)), 0, axis)


def computed():
    """The table at its nodes, shape (angles, lambdas, shares, columns)."""
    table = np.zeros((ANGLES, LAMBDAS, SHARES, 8))
    for i, beta in enumerate(lobatto(ANGLES, 0.0, np.pi / 2)):
        for j, lam in enumerate(lobatto(LAMBDAS, 0.0, LARGEST_LAMBDA)[1:], 1):
            for k, x in enumerate(lobatto(SHARES, LEAST_SHARE, 1.0)):
                share = x * largest_share(beta)
                table[i, j, k] = excess(lam, beta, share) / share**2
        print(f"{i + 1} of {ANGLES} angles", file=sys.stderr)
    return table


def write(table):
    for axis in range(3):
        table = coefficients(table, axis)
    sizes = "[kRowAngles][kRowLambdas][kRowShares][kRowColumns]"
    text = f"""// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

// Written by tools/reference/row_tables.py, which describes the table; nu = 0.3.

namespace strainwave::sif {{

/// Chebyshev coefficients along the angle, lambda and the share, and columns of the table.
inline constexpr std::size_t kRowAngles = {ANGLES};
inline constexpr std::size_t kRowLambdas = {LAMBDAS};
inline constexpr std::size_t kRowShares = {SHARES};
inline constexpr std::size_t kRowColumns = 8;
/// Least share of the nodes, over the largest one, and the largest 2 a/p of cracks in one line.
inline constexpr double kRowLeastShare = {LEAST_SHARE};
inline constexpr double kRowShareEnd = {END};
/// Square of this share over that of stacked cracks.
inline constexpr double kRowStacked = {STACKED};

// clang-format off
/// Coefficients of nn, tn, bn, cn, nt, tt, bt, ct over (2 a/p)^2.
inline constexpr double kRowTable{sizes} = {{
"""
    for angle in table:
        text += "    {\n"
        for lam in angle:
            text += "        {\n"
            for share in lam:
                text += "            {" + ", ".join(f"{v:.5g}" for v in share) + "},\n"
            text += "        },\n"
        text += "    },\n"
    text += "};\n// clang-format on\n\n}  // namespace strainwave::sif\n"
    source = Path(__file__).resolve().parents[2] / "src" / "sif" / "shell_row_table.hpp"
    source.write_text(text, encoding="ascii")


def interpolated(table, lam, beta, share):
    """The columns by the polynomials, times (2 a/p)^2."""
    for axis in range(3):
        table = coefficients(table, axis)
    x = (share / largest_share(beta) - LEAST_SHARE) / (1 - LEAST_SHARE)
    for place in (beta / (np.pi / 2), lam / LARGEST_LAMBDA, x):
        table = np.tensordot(np.cos(np.arange(table.shape[0]) * np.arccos(2 * place - 1)), table, (0, 0))
    return table * share**2


def check(table):
    """Largest error of K of a row, over the largest factor, at places between the nodes."""
    rng = np.random.default_rng(1)
    for _ in range(40):
        beta, lam = rng.uniform(0, np.pi / 2), rng.uniform(0.1, LARGEST_LAMBDA)
        share = rng.uniform(0.15, 1) * largest_share(beta)
        sheet = crack_rows.crack_alone(lam, beta)[0] + crack_rows.neighbours_in_sheet(beta, 2 / share)
        whole = np.abs(factors(sheet)).max()
        error = interpolated(table, lam, beta, share) - excess(lam, beta, share)
        print(f"{np.degrees(beta):5.1f} deg, lambda {lam:.2f}, 2a/p {share:.3f}: {np.abs(error).max() / whole:.1e}")


if __name__ == "__main__":
    if "--check" in sys.argv:
        check(computed())
    else:
        write(computed())
