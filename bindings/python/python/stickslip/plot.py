"""Plots with matplotlib, which is installed by ``pip install 'stickslip[plot]'``.

Every function draws into ``axes``, or into new axes, and returns the axes. A figure without a layout engine gets the
constrained layout, so that labels do not overlap. Colour bars have the height of their image. A field on a single row or
column of cells, such as the grid of a line contact, is drawn as a profile: a line over the cells.

The package does not prescribe units and only appends the given units to the labels. ``length_unit`` is the unit of
coordinates and shifts after multiplication by ``scale`` (1e3 shows metres as millimetres). ``unit`` is the unit of the
drawn values after multiplication by ``value_scale``. Labels have the form ``x (mm)``. Without a factor, lengths of a Field, a
history or a normal solution with a unit are converted into the unit of the label. Lengths of objects without a unit are not
converted: ``length_unit`` is then a name only, and requires the factor ``scale``.

Colour bars of values without sign, such as pressure, start at zero. Values with both signs have colours with zero in the
middle. The options ``cmap``, ``vmin``, ``vmax`` and ``norm`` replace these defaults.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._checks import kind, refuse_type, require, require_entries
from ._enums import Zone
from ._plot_arguments import check_factors, factor
from ._plot_axes import add_colour_bar, colour_limits, draw_image, place_legend_above, prepare_axes, with_unit
from ._stickslip import CoupledRollingSolution, CoupledSolution, Field, Grid, NormalSolution, TangentialSolution
from .errors import Shape

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from . import Report
    from .history import Cycle
    from .subsurface import Plane

_COLOURS = {Zone.SEPARATED: "white", Zone.STICK: "tab:blue", Zone.SLIP: "tab:orange"}

# Objects that have tractions and zones.
_SHEARED = "a tangential, coupled or rolling solution, a state or a history"

# Colours of contact spots.
_SPOTS = ("tab:blue", "tab:orange", "tab:green", "tab:red", "tab:purple", "tab:brown", "tab:pink")

_STRESSES = {"von_mises": "von Mises", "max_shear": "largest shear stress", "hydrostatic": "mean normal stress"}


def _with_grid(grid: Any, values: Any) -> tuple[Grid, Any]:
    """Returns the grid and the values of a plot, whose first argument is a grid or a field."""
    if isinstance(grid, Grid):
        if values is None:
            raise TypeError("give the values as the second argument, or a Field instead of the grid")
        return grid, values
    field = getattr(grid, "heights", grid)
    if values is not None or not isinstance(field, Field):
        remedy = ": give solution.grid, solution.pressure" if hasattr(grid, "pressure") and hasattr(grid, "grid") else ""
        if isinstance(grid, np.ndarray):
            remedy = ": give grid, array"
        raise TypeError(
            f"the first argument must be a Grid, or a Field without further values, got {type(grid).__name__}{remedy}"
        )
    return field.grid, field


def _half(solution: Any, *names: str) -> Any:
    """Returns the half of a coupled solution that has the drawn fields; other objects are returned unchanged."""
    if isinstance(solution, (CoupledSolution, CoupledRollingSolution)):
        return next(getattr(solution, name) for name in names if hasattr(solution, name))
    return solution


def _require_solution(solution: Any, attributes: tuple[str, ...], due: str) -> None:
    """Raises an error unless an object is a solution with these fields. The message for an array states how to draw it."""
    if isinstance(solution, (np.ndarray, Field)):
        refuse_type("solution", f"must be {due}, got {kind(solution)}: draw an array by plot.field(grid, array)")
    require("solution", solution, attributes, due)


def _spots_of(solution: Any) -> Any:
    """Returns the contact spots of an object, with stick ratios if it has tractions."""
    if isinstance(solution, CoupledSolution):
        return solution.tangential.spots(solution.normal)
    if isinstance(solution, (tuple, list)):
        if [type(part) for part in solution] != [NormalSolution, TangentialSolution]:
            raise TypeError("a pair for spots must be (normal, shear), a normal and a tangential solution")
        return solution[1].spots(solution[0])
    if isinstance(solution, TangentialSolution):
        raise TypeError("a tangential solution has no pressure: give (normal, shear)")
    spots = getattr(_half(solution, "normal"), "spots", solution)
    require("spots", spots, ("labels", "grid"), "ContactSpots, a normal or coupled solution, a history, or (normal, shear)")
    return spots


def _samples(grid: Grid, values: Any) -> Any:
    """Returns the values of the cells of a grid, with their mask."""
    if hasattr(values, "dims") or hasattr(values, "columns") or isinstance(values, Field):
        values = Field(grid, values)  # checks the labels of xarray and pandas, and the grid of a field
    samples = values if np.ma.isMaskedArray(values) else np.asarray(values)
    if samples.shape != grid.shape:
        error = Shape(f"values has shape {samples.shape}, expected (ny, nx) = {grid.shape}")
        error.quantity, error.expected, error.found = "values", grid.shape, samples.shape
        raise error
    return samples


def _component(axis: str) -> int:
    """Returns the index of an axis of the plane."""
    if str(axis) not in ("x", "y"):
        raise ValueError(f"the axis must be 'x' or 'y', got {axis!r}")
    return ("x", "y").index(str(axis))


def _place(grid: Grid, along: str, at: float) -> tuple[int, int]:
    """Returns the index of the axis of a line of cells, and the row or column of cells nearest to its position."""
    direction = _component(along)
    edges = grid.extent[2:] if direction == 0 else grid.extent[:2]
    if not edges[0] <= at <= edges[1]:
        raise ValueError(f"the section at {at} lies outside the grid, which extends from {edges[0]} to {edges[1]}")
    across = grid.y if direction == 0 else grid.x
    return direction, int(np.abs(across - at).argmin())


def _profile_axis(grid: Grid) -> str | None:
    """Returns the axis of a grid with a single row or column of cells; ``None`` for other grids."""
    if grid.ny == 1:
        return "x"
    return "y" if grid.nx == 1 else None


def field(
    grid: Grid | Field,
    values: Any = None,
    axes: Axes | None = None,
    *,
    label: str = "",
    unit: str = "",
    value_scale: float | None = None,
    scale: float | None = None,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws a field as an image with a colour bar, or as a profile if the grid has a single row or column of cells. The colours
    of a field with values of both signs have zero in the middle.

    Parameters
    ----------
    grid : Grid or Field
        The cells, or a field (or a surface with ``heights``), which contains its cells and its values.
    values : Field or array_like of shape (ny, nx), optional
        The values to draw; masked cells remain white. Not given together with a field.
    axes : matplotlib Axes, optional
        Axes to draw into; new axes by default.
    label, unit : str, default ""
        Name of the values, and their unit after multiplication by ``value_scale``.
    value_scale : float, optional
        Factor for the values, such as 1e-9 to show Pa as GPa. The default is 1. If the values have a unit and ``unit`` is a unit of
        length, the default converts them.
    scale : float, optional
        Factor for the coordinates, such as 1e3 to show metres as millimetres. The default is 1. If the field or the history has a
        unit and ``length_unit`` is a unit of length, the default converts the coordinates.
    length_unit : str, default ""
        Unit of the coordinates after multiplication by ``scale``.
    **options
        Options of ``imshow``, or of ``plot`` for a profile.

    Raises
    ------
    Shape
    TypeError
        If the first argument is a grid without values, or neither a grid nor a field.
    ArgumentType
        If ``axes`` are no Axes, or a factor is no number.
    """
    check_factors(scale=scale, value_scale=value_scale)
    grid, values = _with_grid(grid, values)
    own = getattr(values, "unit", None)
    scale, value_scale = factor(scale, own, length_unit), factor(value_scale, own, unit)
    samples = _samples(grid, values)
    along = _profile_axis(grid)
    if along is not None:
        return section(
            grid, samples, axes, along=along, label=label, unit=unit, value_scale=value_scale, scale=scale,
            length_unit=length_unit, **options,
        )  # fmt: skip
    axes = prepare_axes(axes)
    samples = value_scale * samples
    image = draw_image(axes, grid, samples, scale, length_unit, **colour_limits(samples, options))
    add_colour_bar(axes, image, with_unit(label, unit))
    return axes


def section(
    grid: Grid | Field,
    values: Any = None,
    axes: Axes | None = None,
    *,
    along: str = "x",
    at: float = 0.0,
    label: str = "",
    unit: str = "",
    value_scale: float | None = None,
    scale: float | None = None,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws a field, such as pressure, gap or traction, over a line of cells.

    Parameters
    ----------
    grid : Grid or Field
        The cells, or a field; see :func:`field`.
    values : Field or array_like of shape (ny, nx), optional
        The values to draw. Not given together with a field.
    axes : matplotlib Axes, optional
        Axes to draw into, to which a line is added; new axes by default.
    along : Axis or str, default "x"
        Axis of the line: "x" draws a row of cells, "y" a column.
    at : float, default 0
        Position of the line on the other axis (a length); the nearest row or column of cell centres is drawn.
    label, unit, value_scale, scale, length_unit : optional
        See :func:`field`.
    **options
        Options of ``plot``; ``label``, however, is the label of the axis.

    Raises
    ------
    Shape
    TypeError
        If the first argument is a grid without values, or neither a grid nor a field.
    ValueError
        If ``along`` is not an axis, or ``at`` is outside the grid.
    ArgumentType
        If ``axes`` are no Axes, or a factor is no number.
    """
    check_factors(scale=scale, value_scale=value_scale)
    grid, values = _with_grid(grid, values)
    own = getattr(values, "unit", None)
    scale, value_scale = factor(scale, own, length_unit), factor(value_scale, own, unit)
    samples = value_scale * _samples(grid, values)
    direction, place = _place(grid, along, at)
    axes = prepare_axes(axes)
    if direction == 0:
        axes.plot(scale * grid.x, samples[place], **options)
    else:
        axes.plot(scale * grid.y, samples[:, place], **options)
    axes.set_xlabel(with_unit(("x", "y")[direction], length_unit))
    axes.set_ylabel(with_unit(label, unit))
    return axes


def pressure_map(
    solution: Any,
    axes: Axes | None = None,
    *,
    unit: str = "",
    value_scale: float = 1.0,
    scale: float | None = None,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws the pressure of a normal or coupled solution, a state or a history; cells outside the contact are white.

    ``unit`` and ``value_scale`` refer to the pressure; for the other arguments see :func:`field`.
    """
    check_factors(scale=scale, value_scale=value_scale)
    solution = _half(solution, "normal")
    _require_solution(solution, ("pressure", "grid"), "a normal or coupled solution, a state or a history")
    scale = factor(scale, getattr(solution, "unit", None), length_unit)
    pressure = np.asarray(solution.pressure)
    if _profile_axis(solution.grid) is None:
        options = colour_limits(value_scale * pressure, options, from_zero=True)
        pressure = np.ma.masked_where(pressure == 0.0, pressure)
    return field(
        solution.grid,
        pressure,
        axes,
        label="pressure",
        unit=unit,
        value_scale=value_scale,
        scale=scale,
        length_unit=length_unit,
        **options,
    )


def stick_map(
    solution: Any, axes: Axes | None = None, *, scale: float | None = None, length_unit: str = ""
) -> Axes:
    """Draws the stick zone and the slip zone of a tangential, coupled or rolling solution, a state or a history.

    For ``scale`` and ``length_unit`` see :func:`field`.
    """
    check_factors(scale=scale)
    solution = _half(solution, "tangential", "rolling")
    _require_solution(solution, ("zones", "grid"), _SHEARED)
    scale = factor(scale, getattr(solution, "unit", None), length_unit)
    grid, names = solution.grid, [zone.name.lower() for zone in Zone]
    along = _profile_axis(grid)
    if along is not None:
        axes = section(grid, solution.zones, axes, along=along, scale=scale, length_unit=length_unit, drawstyle="steps-mid")
        axes.set_yticks(list(Zone), names)
        return axes
    axes = prepare_axes(axes)
    from matplotlib.colors import ListedColormap

    colours = ListedColormap([_COLOURS[zone] for zone in Zone])
    image = draw_image(axes, grid, solution.zones, scale, length_unit, cmap=colours, vmin=-0.5, vmax=2.5)
    add_colour_bar(axes, image, "", ticks=list(Zone)).ax.set_yticklabels(names)
    return axes


def traction_map(
    solution: Any,
    axes: Axes | None = None,
    *,
    arrows: int = 16,
    unit: str = "",
    value_scale: float = 1.0,
    scale: float | None = None,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws the shear traction on body 1 of a tangential, coupled or rolling solution, a state or a history: its magnitude
    in colours, and its direction by arrows whose length is proportional to the magnitude. On a single row or column of cells, both
    components are drawn as profiles.

    Parameters
    ----------
    solution : TangentialSolution, CoupledSolution, RollingSolution, CoupledRollingSolution, State or History
        The object whose traction is drawn.
    axes : matplotlib Axes, optional
        Axes to draw into; new axes by default.
    arrows : int, default 16
        Approximate number of arrows along the longer side of the loaded part.
    unit, value_scale, scale, length_unit : optional
        See :func:`field`.
    **options
        Options of ``imshow``, or of ``plot`` for a profile.
    """
    check_factors(scale=scale, value_scale=value_scale)
    solution = _half(solution, "tangential", "rolling")
    _require_solution(solution, ("traction", "grid"), _SHEARED)
    scale = factor(scale, getattr(solution, "unit", None), length_unit)
    grid = solution.grid
    x, y = (np.asarray(component) for component in solution.traction)
    names: dict[str, Any] = {"unit": unit, "value_scale": value_scale, "scale": scale, "length_unit": length_unit}
    along = _profile_axis(grid)
    if along is not None:
        loaded = {name: values for name, values in {"x": x, "y": y}.items() if values.any()} or {"x": x}
        for name, values in loaded.items():
            axes = section(grid, values, axes, along=along, label="shear traction", **names, **options)
            axes.lines[-1].set_label(f"along {name}")
        assert axes is not None
        return place_legend_above(axes) if len(loaded) > 1 else axes
    size = np.hypot(x, y)
    options = colour_limits(value_scale * size, options, from_zero=True)
    axes = field(grid, np.ma.masked_where(size == 0.0, size), axes, label="shear traction", **names, **options)
    rows, columns = (np.flatnonzero(size.any(axis=axis)) for axis in (1, 0))
    if rows.size == 0:
        return axes
    step = max(1, round(max(np.ptp(rows), np.ptp(columns)) / max(arrows, 1)))
    cells = np.ix_(range(rows[0] + step // 2, rows[-1] + 1, step), range(columns[0] + step // 2, columns[-1] + 1, step))
    loaded_cells = size[cells] > 0.0
    at_x, at_y = np.meshgrid(scale * grid.x, scale * grid.y)
    longest = scale * step * max(grid.dx, grid.dy)
    axes.quiver(
        *(values[cells][loaded_cells] for values in (at_x, at_y, x, y)), pivot="mid", color="white", edgecolor="black", linewidth=0.5,
        angles="xy", scale_units="xy", scale=size.max() / longest,
    )  # fmt: skip
    return axes


def spot_map(
    spots: Any,
    axes: Axes | None = None,
    *,
    by: str = "mean_pressure",
    unit: str = "",
    value_scale: float = 1.0,
    scale: float | None = None,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws contact spots, each coloured by one of its properties.

    Parameters
    ----------
    spots : ContactSpots, NormalSolution, pair of NormalSolution and TangentialSolution, CoupledSolution or History
        The spots, or an object that has spots. A normal solution alone has no stick ratios.
    axes : matplotlib Axes, optional
        Axes to draw into; new axes by default.
    by : str, default "mean_pressure"
        The property: "cells", "area", "load", "mean_pressure", "max_pressure", "perimeter" or "stick_ratio". "number"
        draws spots whose centres are near each other in different colours, without a colour bar.
    unit, value_scale, scale, length_unit, **options : optional
        See :func:`field`.

    Raises
    ------
    ValueError
        If spots do not have this property.
    TypeError
        If a tangential solution is given without the normal solution.
    """
    known = ("number", "cells", "area", "load", "mean_pressure", "max_pressure", "perimeter", "stick_ratio")
    if by not in known:
        raise ValueError(f"by must be one of {', '.join(known)}, got {by!r}")
    check_factors(scale=scale, value_scale=value_scale)
    scale = factor(scale, getattr(spots, "unit", None), length_unit)
    spots = _spots_of(spots)
    if by == "number":
        return _numbered(spots, axes, scale, length_unit, options)
    numbers = [getattr(spot, by) for spot in spots]
    if None in numbers:
        raise ValueError("spots of a normal contact alone have no stick_ratio: give (normal, shear)")
    labels = spots.labels
    values = np.concatenate([[0.0], numbers])[labels]
    if _profile_axis(spots.grid) is None:
        options = colour_limits(value_scale * values, options, from_zero=True)
    return field(
        spots.grid, np.ma.masked_where(labels == 0, values), axes, label=f"{by.replace('_', ' ')} of the spot", unit=unit,
        value_scale=value_scale, scale=scale, length_unit=length_unit, **options,
    )  # fmt: skip


def _numbered(spots: Any, axes: Axes | None, scale: float, length_unit: str, options: dict[str, Any]) -> Axes:
    """Draws contact spots; spots whose centres are near each other differ in colour."""
    labels, grid = spots.labels, spots.grid
    along = _profile_axis(grid)
    if along is not None:
        names: dict[str, Any] = {"scale": scale, "length_unit": length_unit}
        return section(grid, labels, axes, along=along, label="number of the spot", **names, **options)
    axes = prepare_axes(axes)
    from matplotlib.colors import ListedColormap

    centres = np.array([spot.centroid for spot in spots]).reshape(-1, 2)
    chosen = np.zeros(len(centres), dtype=int)
    for place, centre in enumerate(centres):
        # The distance to the nearest spot of each colour; the colour with the largest distance is chosen.
        distances = np.hypot(*(centres[:place] - centre).T)
        nearest = [distances[chosen[:place] == colour].min(initial=np.inf) for colour in range(len(_SPOTS))]
        chosen[place] = int(np.argmax(nearest))
    shown = np.ma.masked_where(labels == 0, np.concatenate([[0], chosen])[labels])
    defaults = {"cmap": ListedColormap(_SPOTS), "vmin": -0.5, "vmax": len(_SPOTS) - 0.5}
    draw_image(axes, grid, shown, scale, length_unit, **{**defaults, **options})
    return axes


def stress_section(
    planes: Sequence[Plane],
    axes: Axes | None = None,
    *,
    of: str = "von_mises",
    along: str = "x",
    at: float = 0.0,
    unit: str = "",
    value_scale: float = 1.0,
    scale: float = 1.0,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws a stress over a section below the surface with equal aspect; the depth increases downwards. The colours of stresses
    with both signs have zero in the middle.

    Parameters
    ----------
    planes : sequence of Plane
        Planes at two depths or more, as returned by :meth:`Planes.solve_all`.
    axes : matplotlib Axes, optional
        Axes to draw into; new axes by default.
    of : str, default "von_mises"
        The stress: "von_mises", "max_shear", "hydrostatic", or a component, "xx", "yy", "zz", "xy", "xz", "yz".
    along, at : optional
        Position of the section; see :func:`section`.
    unit, value_scale, scale, length_unit : optional
        See :func:`field`.
    **options
        Options of ``pcolormesh``.

    Raises
    ------
    ValueError
        If there are fewer than two planes, if the stress is unknown, if ``along`` is not an axis, or if ``at`` is outside
        the grid.
    """
    check_factors(scale=scale, value_scale=value_scale)
    require_entries("planes", planes, ("normal_stress",), "a sequence of Plane, as returned by Planes.solve_all")
    if len(planes) < 2:
        raise ValueError(f"a section requires planes at two depths or more, got {len(planes)}")
    planes = sorted(planes, key=lambda plane: plane.depth)
    grid = planes[0].grid
    direction, place = _place(grid, along, at)
    lines = [_stress(plane, of)[place] if direction == 0 else _stress(plane, of)[:, place] for plane in planes]
    depths = scale * np.array([plane.depth for plane in planes])
    axes = prepare_axes(axes)
    values = value_scale * np.array(lines)
    options = colour_limits(values, {"shading": "gouraud", **options}, from_zero=of in ("von_mises", "max_shear"))
    image = axes.pcolormesh(scale * (grid.x if direction == 0 else grid.y), depths, values, **options)
    axes.set_aspect("equal")
    axes.set_ylim(depths[-1], depths[0])
    axes.set_xlabel(with_unit(("x", "y")[direction], length_unit))
    axes.set_ylabel(with_unit("depth", length_unit))
    add_colour_bar(axes, image, with_unit(_STRESSES.get(of, f"stress {of}"), unit))
    return axes


def _stress(plane: Plane, of: str) -> Any:
    """Returns a stress of the cells of a plane by its name."""
    components = dict(zip(("xx", "yy", "zz"), plane.normal_stress)) | dict(zip(("xy", "xz", "yz"), plane.shear_stress))
    if of in components:
        return components[of]
    if of not in _STRESSES:
        raise ValueError(f"of must be {', '.join(_STRESSES)} or a component such as xx, got {of!r}")
    return getattr(plane, of)


def hysteresis(
    cycle: Cycle,
    axes: Axes | None = None,
    *,
    axis: str = "x",
    unit: str = "",
    value_scale: float = 1.0,
    scale: float = 1.0,
    length_unit: str = "",
    **options: Any,
) -> Axes:
    """Draws the loop of force versus shift of a cycle along an axis, "x" or "y".

    ``unit`` and ``value_scale`` refer to the force, ``length_unit`` and ``scale`` to the shift. The options are passed to
    ``plot``.
    """
    check_factors(scale=scale, value_scale=value_scale)
    component = _component(axis)
    require("cycle", cycle, ("points",), "a Cycle, such as the attribute last of the result of a loop")
    axes = prepare_axes(axes)
    points = cycle.points
    axes.plot(scale * points.shift[component], value_scale * points.force[component], **options)
    axes.set_xlabel(with_unit(f"shift along {axis}", length_unit))
    axes.set_ylabel(with_unit(f"tangential force along {axis}", unit))
    return axes


def work_precision(
    reports: Mapping[str, Iterable[Report]] | Iterable[Report],
    axes: Axes | None = None,
    *,
    scale: float = 1.0,
    unit: str = "s",
    **options: Any,
) -> Axes:
    """Draws wall time versus certified error of solves with several tolerances; one line per name if a mapping is given.

    ``scale`` is a factor for the time and ``unit`` the resulting unit, such as 1e3 and "ms". The options are passed to
    ``loglog``.
    """
    check_factors(scale=scale)
    named = reports if isinstance(reports, Mapping) else {"": reports}
    named = {name: list(line) if isinstance(line, Iterable) else line for name, line in named.items()}
    for line in named.values():
        require_entries("reports", line, ("energy_error_bound", "time"), "a sequence of Report, or sequences by name")
    axes = prepare_axes(axes)
    for name, line in named.items():
        axes.loglog(
            [report.energy_error_bound for report in line],
            [scale * report.time for report in line],
            **{"marker": "o", "label": name or None, **options},
        )
    if any(named):
        place_legend_above(axes)
    axes.invert_xaxis()
    # Tick labels between decades would overlap.
    from matplotlib.ticker import NullFormatter

    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_xlabel("certified error in the energy norm")
    axes.set_ylabel(with_unit("time", unit))
    return axes


__all__ = [
    "field",
    "hysteresis",
    "pressure_map",
    "section",
    "spot_map",
    "stick_map",
    "stress_section",
    "traction_map",
    "work_precision",
]


def __dir__() -> list[str]:
    return __all__
