# SPDX-License-Identifier: Apache-2.0
"""The cup of size 25 that the wave generator bends oval, for CalculiX with large rotations.

A quarter of the cup between two planes of symmetry, of 20-node hexahedra.  The radial displacement of the
band of the bore is prescribed; it comes from our own solution, so that both programs solve the same
problem, and everything else is compared.  The bore of the diaphragm is held.

N, mm, MPa.
"""
import pathlib
import subprocess
import tempfile

import numpy as np

import calculix

STEEL = (206e3, 0.3)
BORE, INNER, OUTER = 18.4, 31.2495 - 0.453, 31.2495
RIM_INNER, RIM_OUTER = 31.4005 - 0.755, 31.4005
BOTTOM, BARREL, RIM = 0.762, 17.2, 9.5
BAND = (BOTTOM + BARREL + (RIM - 9.2) / 2, BOTTOM + BARREL + (RIM + 9.2) / 2)


def lines(*stretches):
    """Coordinates at half steps; each stretch is (from, to, cells, ratio of the last to the first cell)."""
    nodes = []
    for start, end, cells, ratio in stretches:
        lengths = ratio ** (np.arange(cells) / max(cells - 1, 1))
        corners = start + (end - start) * np.concatenate([[0], np.cumsum(lengths / lengths.sum())])
        both = np.sort(np.concatenate([corners, (corners[1:] + corners[:-1]) / 2]))
        nodes.extend(both if not nodes else both[1:])
    return np.array(nodes)


def mesh(fine):
    """points [r, theta, z], cells."""
    round_ = lines((0, np.pi / 2, 10 * fine, 1))
    wall = lines((INNER, OUTER, 1, 1))
    rim = lines((RIM_INNER, INNER, 1, 1), (INNER, OUTER, 1, 1), (OUTER, RIM_OUTER, 1, 1))
    plate = lines((BORE, INNER, 5 * fine, 0.25))
    bottom = lines((0, BOTTOM, 1, 1))
    end = BOTTOM + BARREL
    blocks = [(plate, bottom), (wall, bottom),
              (wall, lines((BOTTOM, BOTTOM + 4, 5 * fine, 4), (BOTTOM + 4, end - 4, 5 * fine, 1),
                           (end - 4, end, 5 * fine, 0.25))),
              (rim, lines((end, BAND[0], 1, 1), (BAND[0], BAND[1], 6 * fine, 1),
                          (BAND[1], end + RIM, 1, 1)))]
    points, cells = [], []
    number = {}
    for r, z in blocks:
        ids = np.empty((len(r), len(round_), len(z)), dtype=int)
        for i, j, k in np.ndindex(ids.shape):
            place = (r[i], round_[j], z[k])
            key = tuple(np.round(place, 7))
            if key not in number:
                number[key] = len(points)
                points.append(place)
            ids[i, j, k] = number[key]
        cells.append(calculix.grid_cells(ids))
    points, cells, _ = calculix.used_only(np.array(points), np.concatenate(cells))
    return points, cells


def solve(fine, radial, large):
    """(points [r, theta, z], displacement, stress) by node, in cylindrical components.

    radial: function of points, the displacement of the band.
    """
    points, cells = mesh(fine)
    r, theta, z = points.T
    place = np.column_stack([r * np.cos(theta), r * np.sin(theta), z])
    held = np.flatnonzero(abs(r - BORE) < 1e-6)
    band = np.flatnonzero((abs(r - RIM_INNER) < 1e-6) & (z > BAND[0] - 1e-6) & (z < BAND[1] + 1e-6))
    at_start, at_end = abs(theta) < 1e-9, abs(theta - np.pi / 2) < 1e-9
    given = radial(points[band])
    in_band = np.isin(np.arange(len(points)), band)

    def write(path):
        with open(path, "w") as file:
            file.write("*NODE,NSET=ALL\n")
            np.savetxt(file, np.column_stack([np.arange(1, len(place) + 1), place]),
                       fmt="%d,%.12e,%.12e,%.12e")
            file.write("*ELEMENT,TYPE=C3D20R,ELSET=BODY\n")
            for n, cell in enumerate(cells + 1):
                text = [str(i) for i in (n + 1, *cell)]
                file.write(",".join(text[:15]) + ",\n" + ",".join(text[15:]) + "\n")
            file.write(f"*MATERIAL,NAME=STEEL\n*ELASTIC\n{STEEL[0]},{STEEL[1]}\n"
                       "*SOLID SECTION,ELSET=BODY,MATERIAL=STEEL\n*NSET,NSET=BAND\n")
            file.writelines(f"{n + 1}\n" for n in band)
            file.write("*TRANSFORM,TYPE=C,NSET=BAND\n0,0,0,0,0,1\n*BOUNDARY\n")
            file.writelines(f"{n + 1},1,3\n" for n in held)
            file.writelines(f"{n + 1},2\n" for n in np.flatnonzero((at_start | (at_end & in_band)) & ~np.isin(
                np.arange(len(points)), held)))
            file.writelines(f"{n + 1},1\n" for n in np.flatnonzero(at_end & ~in_band & ~np.isin(
                np.arange(len(points)), held)))
            file.write(f"*STEP{',NLGEOM' if large else ''}\n*STATIC\n0.5,1\n*BOUNDARY\n")
            file.writelines(f"{n + 1},1,1,{u:.12e}\n" for n, u in zip(band, given))
            file.write("*NODE FILE\nU\n*EL FILE\nS\n*NODE PRINT,NSET=BAND,FREQUENCY=100\nU\n*END STEP\n")

    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder) / "job"
        write(job.with_suffix(".inp"))
        done = subprocess.run(["ccx", "job"], cwd=folder, stdout=subprocess.PIPE, text=True, check=True,
                              stderr=subprocess.STDOUT)
        if "*ERROR" in done.stdout:
            raise RuntimeError("ccx failed:\n" + done.stdout[-2000:])
        found = last_fields(job.with_suffix(".frd").read_text(), len(points))
    turn = np.zeros((len(points), 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(theta)
    turn[:, 0, 1], turn[:, 1, 0], turn[:, 2, 2] = np.sin(theta), -np.sin(theta), 1
    u = np.einsum("nij,nj->ni", turn, found["DISP"])
    xx, yy, zz, xy, yz, zx = found["STRESS"].T
    s = np.moveaxis(np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]), 2, 0)
    s = np.einsum("nij,njk,nlk->nil", turn, s, turn)
    return points, u, s


def last_fields(text, count):
    """Fields of the last increment in ccx's .frd file: name -> [node, component]."""
    fields, name, width = {}, None, {"DISP": 3, "STRESS": 6}
    for line in text.splitlines():
        if line.startswith(" -4"):
            name = line.split()[1]
            if name in width:
                fields[name] = np.zeros((count, width[name]))
        elif line.startswith(" -1") and name in width:
            node = int(line[3:13]) - 1
            for i in range(width[name]):
                fields[name][node, i] = float(line[13 + 12 * i:25 + 12 * i])
        elif line.startswith(" -3"):
            name = None
    return fields
