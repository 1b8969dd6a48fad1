# SPDX-License-Identifier: Apache-2.0
"""The charts of the library, drawn by matplotlib: the numbers, labels and colours are those of the
SVG, which carries them."""

from __future__ import annotations

import html
import json
import math
import re
from typing import Any, Optional, Sequence

Panel = dict[str, Any]


def panels_of(svg: str) -> list[Panel]:
    """The panels of a chart, from the numbers in its SVG.

    >>> import strainwave as sw
    >>> [panel["kind"] for panel in panels_of(sw.read("cracked_size25.toml").torsion().svg())]
    ['lines', 'lines', 'lines', 'lines']

    Raises:
        ValueError: if the picture is not a chart
    """
    found = re.search(r'<metadata class="numbers">(.*?)</metadata>', svg, re.S)
    if not found:
        raise ValueError("this picture carries no numbers, so it is not a chart of strainwave")
    panels: list[Panel] = json.loads(html.unescape(found.group(1)))["panels"]
    return panels


def draw(svg: str, ax: Any) -> Any:
    """Draws a chart.

    Args:
        ax: axes of matplotlib, one for each panel, or one alone if there is one panel; None: new ones

    Returns:
        the axes, one alone if there is one panel
    """
    panels = panels_of(svg)
    axes = _axes(panels, ax)
    for panel, one in zip(panels, axes):
        {"lines": _lines, "bars": _bars, "contours": _contours}[panel["kind"]](panel, one)
        title = "\n".join(text for text in (panel["title"], panel["subtitle"]) if text)
        one.set_title(title, loc="left", fontsize="medium")
        one.set_xlabel(panel["x_label"])
    return axes[0] if len(axes) == 1 else axes


def _axes(panels: list[Panel], ax: Any) -> Sequence[Any]:
    if ax is None:
        try:
            from matplotlib import pyplot
        except ImportError as error:
            raise ImportError("plot() needs matplotlib, which is not installed; svg() gives the "
                              "same chart without matplotlib") from error
        heights = [max(3.5, 0.3 * len(panel.get("labels", ()))) for panel in panels]
        _, made = pyplot.subplots(len(panels), figsize=(8, sum(heights)), squeeze=False,
                                  layout="constrained", gridspec_kw={"height_ratios": heights})
        return list(made.flat)
    given = list(ax.flat) if hasattr(ax, "flat") else list(ax) if isinstance(ax, (list, tuple)) else [ax]
    if len(given) != len(panels):
        raise ValueError(f"the chart has {len(panels)} panels; pass as many axes, not {len(given)}")
    return given


def _numbers(values: Sequence[Optional[float]]) -> list[float]:
    return [math.nan if value is None else value for value in values]


def _lines(panel: Panel, ax: Any) -> None:
    for place, series in enumerate(panel["series"]):
        lengths = [float(length) for length in series["dashes"].split()]
        width = 2.5 if place == 0 else 1.5  # the first line is the widest, as in the SVG
        style: Any = (0, [length / width for length in lengths]) if lengths else "-"
        x, y = _numbers(series["x"]), _numbers(series["y"])
        ax.plot(x, y, color=series["colour"], linestyle=style, linewidth=width, label=series["label"])
        if series["end"] and x:
            ax.plot(x[-1], y[-1], "o", color=series["colour"])
    ax.set_xscale(panel["x_scale"])
    ax.set_yscale(panel["y_scale"])
    ax.set_ylabel(panel["y_label"])
    ax.grid(True, alpha=0.3)
    if any(series["label"] for series in panel["series"]):
        ax.legend(title=panel["legend_title"] or None, fontsize="small")


def _bars(panel: Panel, ax: Any) -> None:
    rows = len(panel["labels"])
    height = 0.8 / max(len(panel["series"]), 1)
    for place, series in enumerate(panel["series"]):
        at = [row - 0.4 + height * (place + 0.5) for row in range(rows)]
        ax.barh(at, _numbers(series["values"]), height, color=series["colour"], label=series["label"])
    ax.set_yticks(range(rows), panel["labels"], fontsize="small")
    ax.invert_yaxis()
    ax.axvline(0, color="#222222", linewidth=0.8)
    ax.grid(True, axis="x", alpha=0.3)
    if any(series["label"] for series in panel["series"]):
        ax.legend(fontsize="small")


def _contours(panel: Panel, ax: Any) -> None:
    import numpy as np

    x, y = _numbers(panel["x"]), _numbers(panel["y"])
    values = np.array(_numbers(panel["values"])).reshape(len(x), len(y)).T
    if panel["levels"]:  # none if all values are the same
        lines = ax.contour(x, y, values, levels=panel["levels"], colors=panel["colours"])
        ax.clabel(lines, fontsize="small")
    ax.set_xlim(min(x), max(x))
    ax.set_ylim(min(y), max(y))
    ax.set_xscale(panel["x_scale"])
    ax.set_yscale(panel["y_scale"])
    ax.set_ylabel(panel["y_label"])
    ax.text(1.0, 1.0, panel["value_label"], transform=ax.transAxes, ha="right", va="bottom",
            fontsize="small")
