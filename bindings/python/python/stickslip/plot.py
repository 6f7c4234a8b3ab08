"""Pictures with matplotlib, which ``pip install 'stickslip[plot]'`` brings along.

Every function draws into ``axes``, or into new ones, and returns them. Axes are called "x" and "y"; the package knows no
units, and writes those that it is given (``length_unit="mm"``) behind the names.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._enums import Zone
from .errors import Shape

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


def _label(name: str, unit: str) -> str:
    return f"{name}, {unit}" if name and unit else name or unit


def _samples(grid: Grid, values: Any) -> Any:
    """Values of the cells of a grid, masked as they were."""
    samples = values if np.ma.isMaskedArray(values) else np.asarray(values)
    if samples.shape != grid.shape:
        error = Shape(f"values has shape {samples.shape}, expected (ny, nx) = {grid.shape}")
        error.quantity, error.expected, error.found = "values", grid.shape, samples.shape
        raise error
    return samples


def _component(axis: str) -> int:
    """The place of an axis of the plane."""
    if str(axis) not in ("x", "y"):
        raise ValueError(f"expected 'x' or 'y', got {axis!r}")
    return ("x", "y").index(str(axis))


def _image(axes: Axes, grid: Grid, values: Any, scale: float, length_unit: str, **options: Any) -> Any:
    """Draws values of the cells of a grid where they are."""
    left, right, bottom, top = (scale * edge for edge in grid.extent)
    image = axes.imshow(values, origin="lower", extent=(left, right, bottom, top), **options)
    axes.set_xlabel(_label("x", length_unit))
    axes.set_ylabel(_label("y", length_unit))
    return image


def field(
    grid: Grid,
    values: Any,
    axes: Axes | None = None,
    *,
    label: str = "",
    scale: float = 1.0,
    length_unit: str = "",
    **options: Any,
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
    length_unit : str, default ""
        What coordinates are shown in.
    **options
        Of ``imshow``.

    Raises
    ------
    Shape
    """
    samples = _samples(grid, values)
    axes = _axes(axes)
    image = _image(axes, grid, samples, scale, length_unit, **options)
    axes.figure.colorbar(image, ax=axes, label=label)
    return axes


def section(
    grid: Grid,
    values: Any,
    axes: Axes | None = None,
    *,
    along: str = "x",
    at: float = 0.0,
    label: str = "",
    scale: float = 1.0,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws a field, such as pressure, gap or traction, over a line of cells.

    Parameters
    ----------
    grid : Grid
        The cells.
    values : Field or array_like of shape (ny, nx)
        What is drawn.
    axes : matplotlib Axes, optional
        Where it is drawn, a further line where there is one; new axes by default.
    along : Axis or str, default "x"
        The axis that the line is along: "x" draws a row of cells, "y" a column.
    at : float, default 0
        Position of the line on the other axis (a length): the cells whose centres are nearest to it.
    label : str, default ""
        Of the values.
    scale, length_unit : optional
        Of the coordinates, as of :func:`field`.
    **options
        Of ``plot``.

    Raises
    ------
    Shape
    ValueError
        If ``along`` is no axis, or ``at`` lies beyond the grid.
    """
    samples, direction = _samples(grid, values), _component(along)
    edges = grid.extent[2:] if direction == 0 else grid.extent[:2]
    if not edges[0] <= at <= edges[1]:
        raise ValueError(f"the section at {at} lies beyond the grid, which reaches from {edges[0]} to {edges[1]}")
    coordinates, across = (grid.x, grid.y) if direction == 0 else (grid.y, grid.x)
    place = int(np.abs(across - at).argmin())
    axes = _axes(axes)
    axes.plot(scale * coordinates, samples[place] if direction == 0 else samples[:, place], **options)
    axes.set_xlabel(_label(("x", "y")[direction], length_unit))
    axes.set_ylabel(label)
    return axes


def pressure_map(
    solution: Any,
    axes: Axes | None = None,
    *,
    scale: float = 1.0,
    length_unit: str = "",
    pressure_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws the pressure of a normal solution, a state or a history; white where nothing touches."""
    pressure = np.asarray(solution.pressure)
    return field(
        solution.grid,
        np.ma.masked_equal(pressure, 0.0),
        axes,
        label=_label("pressure", pressure_unit),
        scale=scale,
        length_unit=length_unit,
        **options,
    )


def stick_map(
    solution: Any, axes: Axes | None = None, *, scale: float = 1.0, length_unit: str = ""
) -> Axes:
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
        length_unit,
        cmap=ListedColormap([colours[zone] for zone in Zone]),
        vmin=-0.5,
        vmax=2.5,
        interpolation="nearest",
    )
    shown = (Zone.STICK, Zone.SLIP)
    axes.legend(handles=[Patch(color=colours[zone], label=zone.name.lower()) for zone in shown])
    return axes


def hysteresis(
    cycle: Cycle,
    axes: Axes | None = None,
    *,
    axis: str = "x",
    length_unit: str = "",
    force_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws the loop of force over shift of a cycle along an axis, "x" or "y"."""
    component = _component(axis)
    axes = _axes(axes)
    points = cycle.points
    axes.plot(
        [point.shift[component] for point in points], [point.force[component] for point in points], **options
    )
    axes.set_xlabel(_label(f"shift along {axis}", length_unit))
    axes.set_ylabel(_label(f"tangential force along {axis}", force_unit))
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


__all__ = ["field", "hysteresis", "pressure_map", "section", "stick_map", "work_precision"]


def __dir__() -> list[str]:
    return __all__
