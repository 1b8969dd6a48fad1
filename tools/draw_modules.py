#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the module graph of CMakeLists.txt: docs/images/modules.svg.

    tools/draw_modules.py              write the picture
    tools/draw_modules.py --check      compare it with the committed one
    tools/draw_modules.py --self-test  draw a small graph, and notice that an edge is missing
"""

import pathlib
import sys

from check_layers import read_graph

ROOT = pathlib.Path(__file__).resolve().parents[1]
PICTURE = ROOT / "docs" / "images" / "modules.svg"
WIDTH, HEIGHT, GAP, RISE = 104, 26, 18, 64
SWEEPS = 40
# Colour, meaning, and the modules at which a method starts.
ROADS = (("#f6dfc8", "the article's method", {"article"}),
         ("#d6e4f5", "closed forms", {"contact", "fracture"}),
         ("#d5e8d4", "finite elements", {"fem"}))
WHITE = ("#ffffff", "serves all, or joins roads")


def above(depends, name):
    """All modules that a module may use through others."""
    return set().union(*({other} | above(depends, other) for other in depends[name]), set())


def shown_edges(depends):
    """The edges that no longer path implies; all edges together would be unreadable."""
    return [(name, other) for name in depends for other in sorted(depends[name])
            if not any(other in above(depends, between) for between in depends[name])]


def levels(depends):
    """Each module on the lowest level above all that it uses."""
    level = {}
    for name in depends:
        level[name] = max((level[other] + 1 for other in depends[name]), default=0)
    return level


def road(depends, name):
    """The colour of the only method that a module belongs to or uses; white for none or several."""
    mine = {name} | above(depends, name)
    colours = [colour for colour, _, starts in ROADS if starts & mine]
    return colours[0] if len(colours) == 1 else WHITE[0]


def legs(depends):
    """{level: items on it} and the edges cut at each level between their ends.

    A cut (other, k) is shared by all edges to `other` that pass level k.
    """
    level = levels(depends)
    grid = {k: [name for name in depends if level[name] == k] for k in range(max(level.values()) + 1)}
    edges = []
    for name, other in shown_edges(depends):
        stops = [name, *((other, k) for k in range(level[name] - 1, level[other], -1)), other]
        edges += [leg for leg in zip(stops, stops[1:]) if leg not in edges]
        for stop in stops[1:-1]:
            if stop not in grid[stop[1]]:
                grid[stop[1]].append(stop)
    return grid, edges


def places(grid, edges):
    """Return the horizontal middle of each stop, near the stops that it is joined to."""
    room = {stop: GAP if isinstance(stop, tuple) else WIDTH + GAP for row in grid.values() for stop in row}
    joined = {stop: [b if a == stop else a for a, b in edges if stop in (a, b)] for stop in room}
    x = {stop: i * (WIDTH + GAP) for row in grid.values() for i, stop in enumerate(row)}
    for sweep in range(SWEEPS):
        for k in sorted(grid, reverse=sweep % 2):
            row = grid[k]
            wish = {stop: sum(x[near] for near in joined[stop]) / max(len(joined[stop]), 1) for stop in row}
            row.sort(key=wish.get)
            packed, end = [], None  # neighbours keep the distance that their widths need
            for stop in row:
                packed.append(wish[stop] if end is None else max(wish[stop], end + room[stop] / 2))
                end = packed[-1] + room[stop] / 2
            shift = sum(wish[stop] - at for stop, at in zip(row, packed)) / len(row)
            x.update({stop: round(at + shift) for stop, at in zip(row, packed)})
    left = min(x[stop] - room[stop] / 2 for stop in x)
    return {stop: x[stop] - left + GAP / 2 for stop in x}


def draw(depends):
    grid, edges = legs(depends)
    x = places(grid, edges)
    across = max(x.values()) + WIDTH / 2 + GAP
    down = len(grid) * RISE + 40
    y = {stop: down - 60 - k * RISE for k, row in grid.items() for stop in row}
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {across:g} {down:g}" width="{across:g}" '
             f'height="{down:g}" font-family="sans-serif" font-size="12">',
             '<rect width="100%" height="100%" fill="white"/>']
    for name, other in edges:
        cut, goal = isinstance(name, tuple), other[0] if isinstance(other, tuple) else other
        top, bottom = y[name] + HEIGHT / 2, y[other] - HEIGHT / 2
        turn = (top + bottom) / 2
        title = f"to {goal}" if cut else f"{name} uses {goal}"
        parts.append(f'<path d="M{x[name]:g} {top - HEIGHT * cut:g} V{top:g} C{x[name]:g} {turn:g} {x[other]:g} {turn:g} '
                     f'{x[other]:g} {bottom:g}" fill="none" stroke="#888"><title>{title}</title></path>')
    for name in depends:
        uses = ", ".join(sorted(depends[name])) or "no other module"
        parts.append(f'<g><title>{name} may use {uses}</title>'
                     f'<rect x="{x[name] - WIDTH / 2:g}" y="{y[name] - HEIGHT / 2:g}" width="{WIDTH}" height="{HEIGHT}" '
                     f'rx="4" fill="{road(depends, name)}" stroke="#333"/>'
                     f'<text x="{x[name]:g}" y="{y[name] + 4:g}" text-anchor="middle">{name}</text></g>')
    for i, (colour, label, *_) in enumerate((*ROADS, WHITE)):
        at = GAP + i * (across - GAP) / 4
        parts.append(f'<rect x="{at:g}" y="{down - 24:g}" width="14" height="14" fill="{colour}" stroke="#333"/>'
                     f'<text x="{at + 20:g}" y="{down - 13:g}">{label}</text>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def self_test():
    graph = {"low": set(), "left": {"low"}, "right": {"low"}, "top": {"left", "low"}}
    picture = draw(graph)
    faults = [name for name in graph if f">{name}</text>" not in picture]
    faults += [f"{a} uses {b}" for a, b in (("left", "low"), ("right", "low"), ("top", "left"))
               if f"{a} uses {b}<" not in picture]
    if "top uses low<" in picture:
        faults.append("an edge is drawn that a longer way implies")
    if draw({**graph, "right": {"low", "left"}}) == picture:
        faults.append("a new edge leaves the picture as it was")
    return faults


def main():
    option = sys.argv[1] if len(sys.argv) > 1 else ""
    if option == "--self-test":
        faults = self_test()
    else:
        depends, _, faults = read_graph(ROOT)
        if option == "--check" and not faults and PICTURE.read_text() != draw(depends):
            faults = ["docs/images/modules.svg is not that of CMakeLists.txt: run tools/draw_modules.py"]
        elif not option and not faults:
            PICTURE.write_text(draw(depends))
    print("\n".join(faults) or "modules: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
