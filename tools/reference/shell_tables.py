"""Writes src/sif/shell_tables.hpp, which the library interpolates.

Nodes are Chebyshev-Lobatto in u = lambda/(lambda + 3), in cos(2 beta), in alpha and in ln(r/t).
Tabulated are (nn - 1)/lambda^2, (tt - 1)/lambda^2, bn, bt, tn, nt, cn, ct over lambda^2, those odd in
beta (tn, nt, cn, bt) over sin(2 beta) as well; of the finite angle the excess over the shallow shell,
K over alpha^2 and the linear part over alpha.  Computed by shell_crack.py and
circumferential_crack.py.  Takes a minute.
"""
from pathlib import Path

import numpy as np

import circumferential_crack
import shell_crack

NAMES = ("nn", "tn", "bn", "cn", "nt", "tt", "bt", "ct")
ODD = ("tn", "nt", "cn", "bt")
LAMBDA_SCALE = 3.0


def lobatto(n, a, b):
    return a + (b - a) * (1 - np.cos(np.pi * np.arange(n) / (n - 1))) / 2


def lambdas(n, largest):
    u = lobatto(n, 0.0, largest / (largest + LAMBDA_SCALE))
    lam = LAMBDA_SCALE * u / (1 - u)
    lam[0] = 3e-3  # the limit
    return lam


def transformed(result, name, lam, beta):
    value = result[name] - (1 if name in ("nn", "tt") else 0)
    if name in ("bn", "bt"):
        value = value if lam > 0.01 else 0.0
    else:
        value /= lam ** 2
    return value / np.sin(2 * beta) if name in ODD else value


def array(name, shape, rows, comment):
    text = f"/// {comment}\ninline constexpr double {name}{''.join(f'[{n}]' for n in shape)} = {{\n"
    flat = np.reshape(rows, (-1, shape[-1]))
    depth = len(shape) - 1
    per_block = shape[-2] if depth == 2 else None
    for k, row in enumerate(flat):
        if depth == 2 and k % per_block == 0:
            text += "    {\n"
        text += "    {" + ", ".join(f"{v:.7g}" for v in row) + "},\n"
        if depth == 2 and k % per_block == per_block - 1:
            text += "    },\n"
    return text + "};\n"


def main():
    beta = np.arccos(np.cos(np.pi * np.arange(7) / 6)) / 2
    beta[0], beta[-1] = 5e-3, np.pi / 2 - 5e-3  # the limits of the odd ones
    lam = lambdas(12, 8.0)
    inclined = [[shell_crack.solve(x, b, terms=10) for x in lam] for b in beta]
    ends = {0: [shell_crack.solve(x, 0.0, terms=10) for x in lam],
            6: [shell_crack.solve(x, np.pi / 2, terms=10) for x in lam]}
    shell = [[[transformed((ends[j] if j in ends and name not in ODD else inclined[j])[i], name,
                           lam[i], beta[j]) for i in range(12)] for j in range(7)] for name in NAMES]
    lam = lambdas(16, 24.0)
    results = [shell_crack.solve(x, np.pi / 2, terms=20) for x in lam]
    long_names = ("nn", "bn", "tt", "ct")
    circumferential = [[transformed(r, name, x, np.pi / 2) for r, x in zip(results, lam)]
                       for name in long_names]
    alpha, log_rt = lobatto(6, 0.05 * np.pi, 0.5 * np.pi), lobatto(4, np.log(5), np.log(60))
    excess = np.zeros((6, 6, 4))
    for j, y in enumerate(log_rt):
        for i, a in enumerate(alpha):
            r = circumferential_crack.solve(a, np.exp(-y))
            s = shell_crack.solve((12 * 0.91) ** 0.25 * a * np.exp(y / 2), np.pi / 2, terms=20)
            pairs = (("t", "nn"), ("tb", "bn"), ("b", "nn"), ("bb", "bn"), ("s", "tt"), ("sc", "ct"))
            for k, (f, g) in enumerate(pairs):
                excess[k, i, j] = (r[f] - s[g]) / a ** (1 if k % 2 else 2)
    source = Path(__file__).resolve().parents[2] / "src"
    write(source / "sif" / "shell_tables.hpp", "strainwave::sif", [
        array("kShellTable", (8, 7, 12), shell,
              "Shallow shell: nn, tn, bn, cn, nt, tt, bt, ct over cos(2 beta) and lambda <= 8."),
        array("kCircumferentialTable", (4, 16), circumferential,
              "Shallow shell, beta = 90 degrees: nn, bn, tt, ct over lambda <= 24."),
        array("kFiniteAngleTable", (6, 6, 4), excess,
              "What a finite angle adds: t, tb, b, bb, s, sc over alpha and ln(r/t).")])


def write(path, namespace, arrays):
    text = f"""// SPDX-License-Identifier: Apache-2.0
#pragma once

// Written by tools/reference/shell_tables.py, which describes the columns; nu = 0.3.

namespace {namespace} {{

// clang-format off
"""
    text += "\n".join(arrays)
    path.write_text(text + f"// clang-format on\n\n}}  // namespace {namespace}\n", encoding="ascii")


if __name__ == "__main__":
    main()
