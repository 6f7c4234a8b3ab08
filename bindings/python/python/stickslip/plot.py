"""Pictures with matplotlib, which ``pip install 'stickslip[plot]'`` brings along.

Every function draws into ``axes``, or into new ones, and returns them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._enums import Zone

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from . import Grid, Report
    from .history import Cycle


def _axes(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    try:
        import matplotlib.pyplot as pyplot
    except ImportError as error:
        raise ImportError("stickslip.plot needs matplotlib: pip install 'stickslip[plot]'") from error
    return pyplot.subplots()[1]


def _image(axes: Axes, grid: Grid, values: Any, scale: float, **options: Any) -> Any:
    """Draws values of the cells of a grid where they are."""
    left, right, bottom, top = (scale * edge for edge in grid.extent)
    image = axes.imshow(values, origin="lower", extent=(left, right, bottom, top), **options)
    axes.set_xlabel("x")
    axes.set_ylabel("y")
    return image


def field(
    grid: Grid, values: Any, axes: Axes | None = None, *, label: str = "", scale: float = 1.0, **options: Any
) -> Axes:
    """Draws a field as an image with a bar of colours.

    Parameters
    ----------
    grid : Grid
        The cells.
    values : Field or array_like of shape (ny, nx)
        What is drawn; masked values are left white.
    axes : matplotlib Axes, optional
        Where it is drawn; new axes by default.
    label : str, default ""
        Of the bar of colours.
    scale : float, default 1
        Factor of the coordinates, such as 1e3 to show metres as millimetres.
    **options
        Of ``imshow``.
    """
    axes = _axes(axes)
    shown = values if np.ma.isMaskedArray(values) else np.asarray(values)
    image = _image(axes, grid, shown, scale, **options)
    axes.figure.colorbar(image, ax=axes, label=label)
    return axes


def pressure_map(solution: Any, axes: Axes | None = None, *, scale: float = 1.0, **options: Any) -> Axes:
    """Draws the pressure of a normal solution, a state or a history; white where nothing touches."""
    pressure = np.asarray(solution.pressure)
    return field(
        solution.grid, np.ma.masked_equal(pressure, 0.0), axes, label="pressure", scale=scale, **options
    )


def stick_map(solution: Any, axes: Axes | None = None, *, scale: float = 1.0) -> Axes:
    """Draws the stick zone and the slip zone of a tangential solution, a state or a history."""
    axes = _axes(axes)
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    colours = {Zone.SEPARATED: "white", Zone.STICK: "tab:blue", Zone.SLIP: "tab:orange"}
    _image(
        axes,
        solution.grid,
        solution.zones,
        scale,
        cmap=ListedColormap([colours[zone] for zone in Zone]),
        vmin=-0.5,
        vmax=2.5,
        interpolation="nearest",
    )
    shown = (Zone.STICK, Zone.SLIP)
    axes.legend(handles=[Patch(color=colours[zone], label=zone.name.lower()) for zone in shown])
    return axes


def hysteresis(cycle: Cycle, axes: Axes | None = None, *, axis: str = "x", **options: Any) -> Axes:
    """Draws the loop of force over shift of a cycle along an axis."""
    axes = _axes(axes)
    component = {"x": 0, "y": 1}[str(axis)]
    points = cycle.points
    axes.plot(
        [point.shift[component] for point in points], [point.force[component] for point in points], **options
    )
    axes.set_xlabel("shift")
    axes.set_ylabel("tangential force")
    return axes


def work_precision(
    reports: Mapping[str, Iterable[Report]] | Iterable[Report], axes: Axes | None = None, **options: Any
) -> Axes:
    """Draws wall time over the certified error of solves to several tolerances; a line for each name, if named."""
    axes = _axes(axes)
    named = reports if isinstance(reports, Mapping) else {"": reports}
    for name, line in named.items():
        line = list(line)
        axes.loglog(
            [report.energy_error_bound for report in line],
            [report.time for report in line],
            marker="o",
            label=name or None,
            **options,
        )
    if any(named):
        axes.legend()
    axes.invert_xaxis()
    axes.set_xlabel("certified error, relative, in the energy norm")
    axes.set_ylabel("time, s")
    return axes
