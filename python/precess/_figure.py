"""Figures of the core (data and labels, no pixels), drawn by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._names import extra

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STROKES: dict[str, dict[str, Any]] = {
    "line": {"lw": 1.2},
    "thin": {"lw": 0.4},
    "dashed": {"lw": 1.2, "ls": "--"},
    "dots": {"ls": "", "marker": ".", "ms": 3},
}
SIGNS = {"dot": "o", "ring": "o", "cross": "x", "ball": "o"}
# A row of panels is no wider than this.
MOST = 3


def draw(given: dict[str, Any]) -> Figure:
    """Draw a figure of the core."""
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        raise extra("matplotlib", "plot") from None
    panels = given["panels"]
    columns = max(1, min(MOST, len(panels)))
    rows = max(1, -(-len(panels) // columns))
    size = (4.5 * columns if columns > 1 else 6.5, 4 * rows)
    figure, grid = plt.subplots(rows, columns, figsize=size, squeeze=False, layout="constrained")
    for axes, panel in zip(grid.flat, panels, strict=False):
        _panel(axes, panel)
    for axes in list(grid.flat)[len(panels) :]:
        axes.set_visible(False)
    figure.suptitle("\n".join(filter(None, [given["title"], given["subtitle"]])), fontsize="medium")
    return figure


def _panel(axes: Axes, panel: dict[str, Any]) -> None:
    if panel["map"]:
        _map(axes, panel["map"])
    named = False
    for number, (label, x, y, ink, stroke) in enumerate(panel["curves"]):
        # Points that follow from one another have a gap between them in the core's figures: they are dots here.
        scattered = len(x) > 1 and np.isnan(x[1::2]).all()
        style = STROKES["dots"] if scattered else STROKES[stroke]
        axes.plot(x, y, color=f"C{number if ink is None else ink}", label=label or None, **style)
        named = named or bool(label)
    for label, x, y, sign, ink in panel["marks"]:
        color = "black" if ink is None else f"C{ink}"
        face = "none" if sign == "ring" else color
        axes.plot(x, y, SIGNS[sign], ms=9 if sign == "ball" else 5, color=color, mfc=face)
        if label:
            axes.annotate(label, (x, y), textcoords="offset points", xytext=(5, 5), fontsize="small")
    if panel["logarithmic"]:
        axes.set_yscale("log", nonpositive="mask")
    if panel["equal_scales"]:
        # A map ends where its grid does.
        axes.set_aspect("equal", adjustable="box" if panel["map"] else "datalim")
    axes.set(title=panel["title"], xlabel=panel["x_label"], ylabel=panel["y_label"])
    axes.set(**{f"{which}lim": panel[f"{which}_range"] for which in "xy" if panel[f"{which}_range"]})
    if named:
        axes.legend(loc="best", fontsize="small")
    axes.grid(visible=True, alpha=0.3)


def _map(axes: Axes, given: tuple[Any, ...]) -> None:
    """Draw classes on a grid, a cell about each point."""
    import matplotlib as mpl

    x, y, columns, classes, names = given
    cells = classes.reshape(-1, columns)
    half = [(b - a) / max(n - 1, 1) / 2 for (a, b), n in ((x, columns), (y, len(cells)))]
    colors = mpl.colormaps["tab10"](np.arange(10))[:, :3]
    image = np.where((cells < 0)[..., None], 0.9, colors[np.maximum(cells, 0) % 10])
    axes.imshow(
        image,
        origin="lower",
        extent=(x[0] - half[0], x[1] + half[0], y[0] - half[1], y[1] + half[1]),
        aspect="auto",
        interpolation="nearest",
    )
    for number, name in enumerate(names):
        axes.plot([], [], "s", color=colors[number % 10], label=name)
    if names:
        axes.legend(loc="upper right", fontsize="small")
