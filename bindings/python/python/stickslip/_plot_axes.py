"""Axes, images and colour bars of plots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._plot_arguments import check_axes
from ._stickslip import Grid

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def prepare_axes(axes: Axes | None) -> Axes:
    """Returns given axes, or axes of a new figure. A figure without a layout engine gets the constrained layout."""
    check_axes(axes)
    if axes is None:
        try:
            import matplotlib.pyplot as pyplot
        except ImportError as error:
            raise ImportError("stickslip.plot requires matplotlib: pip install 'stickslip[plot]'") from error
        axes = pyplot.subplots()[1]
    # For a subfigure, take the whole figure.
    figure: Any = getattr(axes.figure, "figure", axes.figure)
    if figure.get_layout_engine() is None:
        from ._layout import SettledLayout

        # Wider than the defaults, so that the label of a colour bar is not mistaken for the label of the next axes.
        figure.set_layout_engine(SettledLayout(w_pad=0.1, h_pad=0.08))
    return axes


def with_unit(name: str, unit: str) -> str:
    """Returns a label with its unit."""
    return f"{name} ({unit})" if name and unit else name or unit


def draw_image(axes: Axes, grid: Grid, values: Any, scale: float, length_unit: str, **options: Any) -> Any:
    """Draws the values of the cells of a grid as an image at their coordinates."""
    left, right, bottom, top = (scale * edge for edge in grid.extent)
    options = {"interpolation": "nearest", **options}
    image = axes.imshow(values, origin="lower", extent=(left, right, bottom, top), **options)
    axes.set_xlabel(with_unit("x", length_unit))
    axes.set_ylabel(with_unit("y", length_unit))
    return image


def colour_limits(values: Any, options: dict[str, Any], from_zero: bool = False) -> dict[str, Any]:
    """Returns the options of an image with default limits of its colours."""
    shown = np.ma.masked_invalid(values).compressed()
    if shown.size == 0 or {"norm", "vmin", "vmax"} & options.keys():
        return options
    low, high = float(shown.min()), float(shown.max())
    if low < 0.0 < high:
        most = max(-low, high)
        return {"cmap": "RdBu_r", "vmin": -most, "vmax": most, **options}
    return {"vmin": 0.0, **options} if from_zero and high > 0.0 else options


def add_colour_bar(axes: Axes, image: Any, label: str, **options: Any) -> Any:
    """Adds a colour bar next to an image, with the height of the image."""
    place = axes.inset_axes((1.04, 0.0, 0.05, 1.0))
    return axes.figure.colorbar(image, cax=place, label=label, **options)


def place_legend_above(axes: Axes) -> Axes:
    """Places the legend above the axes, where it covers no line."""
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    return axes
