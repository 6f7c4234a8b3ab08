"""Conversion of solutions to datasets of xarray, which is imported only on use."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .._enums import Zone
from .._stickslip import (
    CoupledRollingSolution,
    CoupledSolution,
    Field,
    Filled,
    Filtered,
    Grid,
    History,
    Levelled,
    NormalSolution,
    Plane,
    RollingSolution,
    RoughSurface,
    State,
    TangentialSolution,
)
from ..errors import ArgumentType

if TYPE_CHECKING:
    import xarray

# Names of the fields, which have one number or one vector per cell, and of the scalar results.
_FIELDS = (
    "pressure", "gap", "unloaded_gap", "contact", "traction", "slip", "zones", "displacement", "accumulated_slip",
    "accumulated_dissipation", "dissipation", "dissipation_per_area", "normal_stress", "shear_stress", "von_mises", "heights",
    "form", "short_waves", "long_waves",
)  # fmt: skip
_NUMBERS = (
    "force", "tangential_force", "approach", "moment", "shift", "twist", "creepage", "spin", "work", "stick_ratio", "is_gross_slip",
    "contact_area", "contact_area_corrected", "yielded_cells", "dissipated_energy", "elastic_energy", "steps", "rms_height",
    "rms_slope", "skewness", "kurtosis", "filled_cells",
)  # fmt: skip
# Names of the numbers of zones, by the conventions for climate and forecast data (CF).
_FLAGS = {
    "flag_values": np.array(list(Zone), np.uint8),
    "flag_meanings": " ".join(zone.name.lower() for zone in Zone),
}
# Kinds of entries of NumPy that are not real numbers, in words.
_NOT_REAL = {
    "b": "truth values: convert a mask by .astype(float)", "c": "complex: give the real part, .real", "M": "times",
    "S": "text", "T": "text", "U": "text", "m": "times",
}  # fmt: skip
# Fields that are lengths.
_LENGTHS = ("gap", "unloaded_gap", "slip_x", "slip_y", "displacement_x", "displacement_y", "accumulated_slip")
_SURFACES = (RoughSurface, Levelled, Filled, Filtered)
_PARTS = {"normal_stress": ("xx", "yy", "zz"), "shear_stress": ("xy", "xz", "yz")}


def to_xarray(solution: Any) -> xarray.Dataset:
    """Converts the fields and numbers of a solution to a dataset of xarray (``pip install xarray``).

    The dataset of a history or a state contains ``unloaded_gap`` only, and no gap under load: convert ``history.normal`` for that.

    Fields have the dimensions (y, x), with the centres of the cells as coordinates. Components of vectors are named by
    their axis, such as ``traction_x``, and components of stresses by both axes, such as ``xz``. Numbers are attributes of
    the dataset. The docstring of each field is its attribute ``long_name``: ``gap`` is the gap under load, and ``unloaded_gap``
    the gap before loading. The attributes ``flag_values`` and ``flag_meanings`` of ``zones`` contain the names of its numbers,
    by the CF conventions: ``dataset.zones == stickslip.Zone.STICK`` is the mask of the stick zone. The unit of a Field or a
    surface is kept, and the unit of a history or a state is the unit of its lengths. For other objects set
    ``dataset.x.attrs["units"]``.

    Parameters
    ----------
    solution : solution, State, History, Field, surface, or sequence of Plane
        The object to convert: a normal, tangential, coupled, rolling or coupled rolling solution, a pair of a normal and a
        tangential or rolling solution, or a rough, levelled, filled or filtered surface. In a pair, the normal force is named
        ``normal_force``. Planes, such as those of :meth:`Planes.solve_all`, have the additional dimension ``depth``.

    Raises
    ------
    ImportError
        If xarray is not installed.
    TypeError
        If the object is not of one of these types.
    ValueError
        If the planes belong to different bodies or grids.
    OutdatedSolution
        If the tangential solution of a pair was computed for a different pressure.

    Examples
    --------
    >>> import stickslip as ss
    >>> grid = ss.Grid.square(32, 0.4e-3)
    >>> steel = ss.Material(213e9, 0.29)
    >>> bodies = ss.HalfSpace(grid, (steel, steel))
    >>> contact = ss.NormalProblem(bodies, ss.surface.sphere(grid, 3.5e-3), force=100.0).solve()
    >>> dataset = ss.io.to_xarray(contact)
    >>> dict(dataset.sizes), round(dataset.attrs["force"], 6)
    ({'y': 32, 'x': 32}, 100.0)
    >>> bool(dataset.pressure.max() == contact.pressure.max())
    True
    """
    try:
        import xarray  # noqa: F401
    except ImportError as error:
        raise ImportError("to_xarray requires xarray: pip install xarray") from error
    if isinstance(solution, Field):
        return _with_units(_dataset(solution.grid, {"values": (solution.array, "Samples of the field.")}, {}), solution.unit)
    if isinstance(solution, _SURFACES):
        heights = solution.heights
        return _with_units(_dataset(heights.grid, dict(_fields(solution)), _numbers(solution)), heights.unit)
    if isinstance(solution, Sequence) and solution and all(type(part) is Plane for part in solution):
        return _volume(solution)
    halves = _halves_of(solution)
    if len(halves) == 2:
        return _halves(*halves, solution if isinstance(solution, CoupledSolution) else None)
    numbers = _numbers(solution)
    if isinstance(solution, (State, History)):
        numbers["normal_force"] = solution.normal.force
    dataset = _dataset(solution.grid, dict(_fields(solution)), numbers)
    unit = getattr(solution, "unit", None)
    return dataset if unit is None else _with_units(dataset, unit, ("x", "y", *_LENGTHS))


def fields_of(solution: Any) -> tuple[dict[str, Any], Grid]:
    """Returns the fields of a solution or a surface by name, with vectors of two components as pairs, and their grid. Called
    by the writers of images."""
    if isinstance(solution, Field):
        return {"values": solution}, solution.grid
    if isinstance(solution, _SURFACES):
        return {name: values for name, values, _ in _values(solution)}, solution.heights.grid
    found: dict[str, Any] = {}
    halves = _halves_of(solution)
    for part in (*halves, solution) if isinstance(solution, CoupledSolution) else halves:
        for name, values, _ in _values(part):
            if isinstance(values, tuple) and len(values) != 2:
                found |= {f"{name}_{axis}": component for axis, component in zip("xyz", values)}
            else:
                found[name] = values
    return found, halves[0].grid


def _halves_of(solution: Any) -> tuple[Any, ...]:
    """Returns the normal and the tangential part of a solution, or the solution itself if it has one part."""
    if isinstance(solution, CoupledSolution):
        return solution.normal, solution.tangential
    if isinstance(solution, CoupledRollingSolution):
        return solution.normal, solution.rolling
    if isinstance(solution, (NormalSolution, TangentialSolution, RollingSolution, State, History)):
        return (solution,)
    if isinstance(solution, Sequence):
        kinds = [type(part) for part in solution]
        if kinds in ([TangentialSolution, NormalSolution], [RollingSolution, NormalSolution]):
            raise TypeError(f"a pair must be in the order (normal, shear), got ({', '.join(kind.__name__ for kind in kinds)})")
        if kinds in ([NormalSolution, TangentialSolution], [NormalSolution, RollingSolution]):
            normal, shear = solution
            if normal.grid != shear.grid:
                raise ValueError(f"the solutions of a pair must be on one grid, got {normal.grid} and {shear.grid}")
            if isinstance(shear, TangentialSolution):
                # Spots require the pressure of the tangential solution, and are cheap to find.
                shear.spots(normal)
            return normal, shear
    name = type(solution).__name__
    if isinstance(solution, (list, tuple)):
        name += f" of ({', '.join(type(part).__name__ for part in solution[:3])}{', ...' if len(solution) > 3 else ''})"
    remedy = ": create a Field by Field(grid, array)" if isinstance(solution, np.ndarray) else ""
    raise TypeError(
        "expected a solution, a pair (normal, shear), a state, a history, a Field, a surface or planes, "
        f"got {name}{remedy}"
    )


def from_xarray(array: xarray.DataArray) -> Field:
    """Converts an array of xarray with the heights of a surface to a field, with the unit in its attribute ``units``.

    Coordinates with an attribute ``units`` are converted to the unit of the heights. Coordinates without it have the unit of
    the heights, unless the other coordinates have a different unit.

    Heights that equal ``_FillValue`` or ``missing_value``, in the attributes or the encoding, are missing (NaN). The encoding is
    ignored if it also contains ``scale_factor`` or ``add_offset``.

    Parameters
    ----------
    array : xarray.DataArray
        An array with the dimensions y and x, in either order, and evenly spaced coordinates.

    Raises
    ------
    ArgumentType
        If the argument is not a DataArray, for example a Dataset: give one of its variables, ``dataset["heights"]``. If heights or
        coordinates are not real numbers, such as text, times or truth values.
    ValueError
        If the array has different dimensions, if its coordinates are missing or not evenly spaced and increasing, if a unit is not
        a unit of length, if one coordinate has none and the unit of the other differs from that of the heights, or if the coordinates
        have units and the heights have none.
    """
    if not all(hasattr(array, name) for name in ("dims", "attrs", "transpose")) or hasattr(array, "data_vars"):
        variables = [str(name) for name in getattr(array, "data_vars", ())]
        remedy = f': give one of its variables, such as dataset["{variables[0]}"]' if variables else ""
        error = ArgumentType(f"array must be a DataArray of xarray, got {type(array).__name__}{remedy}")
        error.argument = "array"
        raise error
    if set(array.dims) != {"x", "y"}:
        raise ValueError(f"the array has the dimensions {tuple(array.dims)}, expected y and x")
    for axis in ("x", "y"):
        if axis not in array.coords:
            raise ValueError(
                f"the array has no coordinates along {axis}, which determine the side of the cells: give them by "
                "array.assign_coords(x=grid.x, y=grid.y), or create a Field by Field(grid, array)"
            )
    own, along = array.attrs.get("units"), [array[axis].attrs.get("units") for axis in ("x", "y")]
    if own is None and along != [None, None]:
        raise ValueError(
            f"the coordinates have the units {along[0]} along x and {along[1]} along y, but the heights have none: "
            "set array.attrs['units'] to the unit of the heights"
        )
    if own is not None:
        _factor(own, own)  # an unknown unit is rejected
    if own is not None and along.count(None) == 1:
        known, missing = ("x", "y") if along[1] is None else ("y", "x")
        unit = next(unit for unit in along if unit is not None)
        if _factor(unit, own) != 1.0:
            raise ValueError(
                f"the coordinates along {known} have the unit {unit}, those along {missing} have none, and the heights have the unit "
                f'{own}: set array["{missing}"].attrs["units"] = "{unit}"'
            )
    sides = []
    for axis in ("x", "y"):
        centres = _real(array[axis], f"the coordinates along {axis}")
        side = _side(centres, axis)
        steps = np.diff(centres)
        if not side > 0.0 or np.abs(steps - side).max() > 1e-6 * side:
            raise ValueError(f"the coordinates along {axis} must be evenly spaced and increasing")
        unit = array[axis].attrs.get("units")
        sides.append(side if unit is None or own is None else side * _factor(unit, own))
    samples = np.array(_real(array.transpose("y", "x"), "the heights"), order="C")
    for mark in _marks(array):
        samples[samples == mark] = np.nan
    grid = Grid(samples.shape[1], samples.shape[0], sides[0], sides[1])
    return Field(grid, samples, own)


def _real(values: Any, quantity: str) -> NDArray[Any]:
    """Returns an array of real numbers, or raises an error for entries that NumPy would convert by a guess."""
    entries = np.asarray(values)
    if entries.dtype == np.float16:
        error = ArgumentType(f"the type float16 of {quantity} has three digits: give array.astype(float) if this is intended")
        error.argument = "array"
        raise error
    found = _NOT_REAL.get(entries.dtype.kind)
    if entries.dtype.kind == "O":
        kinds = {np.asarray(entry).dtype.kind for entry in entries.flat}
        found = next((_NOT_REAL[kind] for kind in sorted(kinds) if kind in _NOT_REAL), None)
    if found is not None:
        error = ArgumentType(f"{quantity} must be real numbers, got {found}")
        error.argument = "array"
        raise error
    return entries.astype(float)


def _marks(array: Any) -> Iterator[float]:
    """Yields the values that mark missing points, by the CF conventions, in the precision of the array."""
    encoding = getattr(array, "encoding", {})
    # Marks of packed numbers are no heights.
    sources = [array.attrs] if {"scale_factor", "add_offset"} & set(encoding) else [array.attrs, encoding]
    for source in sources:
        for name in ("_FillValue", "missing_value"):
            for mark in np.atleast_1d(source.get(name, [])):
                yield float(np.asarray(mark).astype(array.dtype if array.dtype.kind == "f" else float))


def check_coordinates(array: Any, quantity: str, sides: tuple[float, float] | None) -> None:
    """Raises an error if the axes of an array of xarray, or of a table of pandas, have other names than y and x, or if their
    coordinates do not rise in steps of the cell sides. Called before the values are read by their position, after the axes of
    an array of xarray with the dimensions x and y were brought into the order (y, x).

    Labels of a table that are whole numbers, or numbers as text, may also rise in steps of one: they are then numbers of rows or
    columns. Labels that are no numbers are ignored. Without cell sides, as for an operand of NumPy, coordinates must only rise.
    """
    if getattr(array, "ndim", None) != 2:  # datasets have no number of dimensions
        return
    is_table = hasattr(array, "columns")
    if is_table:
        names = {"x": array.columns.name, "y": array.index.name}
        labels = {axis: part for axis, part in (("x", array.columns), ("y", array.index)) if part.dtype.kind in "fiuO"}
        remedy = "sort it by .sort_index(axis={})"
        if names["x"] == "y" or names["y"] == "x":
            raise ValueError(
                f"{quantity} is a table with rows named x or columns named y, expected rows y and columns x: give table.T"
            )
    else:
        _check_dimensions(array, quantity)
        names = {axis: axis for axis in "xy"}
        labels = {axis: array.coords[axis] for axis in ("x", "y") if axis in array.dims and axis in array.coords}
        remedy = 'sort it by .sortby("{}")'
        _check_units(array, quantity, labels)
    for axis, part in labels.items():
        try:
            along = np.asarray(part, dtype=float)
        except (TypeError, ValueError):  # names
            continue
        steps = np.diff(along)
        is_number = is_table and part.dtype.kind != "f"
        if is_number and (steps == 1.0).all():
            continue
        if names[axis] not in (None, axis):
            raise ValueError(
                f"{quantity} is a table with an axis named {names[axis]!r}, expected rows y and columns x: rename it by "
                '.rename_axis(index="y", columns="x"), or give .values to ignore the labels'
            )
        rising = remedy.format("yx".index(axis) if is_table else axis)
        if (steps < 0.0).all() and steps.size:
            raise ValueError(f"{quantity} has decreasing coordinates along {axis}: {rising}")
        if (steps < 0.0).any() or is_number and not steps.all():
            raise ValueError(
                f"{quantity} has coordinates along {axis} that do not rise: {rising}, or give .values to ignore the coordinates"
            )
        if sides is None:
            continue
        side = sides["xy".index(axis)]
        if not (np.abs(steps - side) <= 1e-3 * side).all():
            raise ValueError(
                f"{quantity} has coordinates from {along[0]} to {along[-1]} along {axis}, which do not agree with {along.size} cells "
                f"of the side {side}: convert their unit, or give .values to ignore the coordinates"
            )


def _check_dimensions(array: Any, quantity: str) -> None:
    """Raises an error if an array of xarray has other dimensions than x and y that have coordinates or start with x or y."""
    with_coordinates = {name for along in array.coords.values() for name in along.dims}
    others = [name for name in array.dims if name in with_coordinates or str(name).lower().startswith(("x", "y"))]
    if set(array.dims) != {"x", "y"} and others:
        raise ValueError(
            f"{quantity} has the dimensions {tuple(array.dims)}, expected y and x: rename them by .rename(...), "
            "or give .values to ignore the names"
        )


def _check_units(array: Any, quantity: str, labels: dict[str, Any]) -> None:
    """Raises an error if the lengths of an array of xarray have a unit that differs from that of its coordinates."""
    own = array.attrs.get("units")
    for axis, along in labels.items():
        unit = along.attrs.get("units")
        try:
            is_same = own is None or unit is None or _factor(unit, own) == 1.0
        except (TypeError, ValueError):  # not a length, such as a pressure
            continue
        if not is_same:
            raise ValueError(
                f"{quantity} has the unit {own}, but its coordinates along {axis} have the unit {unit}: "
                f'convert it by io.from_xarray(array).to_unit("{unit}")'
            )


def _side(coordinates: NDArray[Any], axis: str) -> float:
    """Returns the side of the cells along an axis."""
    if coordinates.size < 2:
        raise ValueError(
            f"the array has {coordinates.size} coordinates along {axis}, which do not determine the side of the cells: "
            "create a Field by Field(grid, array)"
        )
    # The difference of the two middle coordinates of a grid is exact, but the mean difference is rounded.
    middle = coordinates.size // 2
    side = float(coordinates[middle + coordinates.size % 2] - coordinates[middle - 1 + coordinates.size % 2])
    if side > 0.0 and np.array_equal(Grid(coordinates.size, 1, side, side).x, coordinates):
        return side
    return float(np.diff(coordinates).mean())


def _factor(unit: str, into: str) -> float:
    """Returns the factor that converts lengths from one unit to another."""
    one = Field(Grid(1, 1, 1.0, 1.0), np.ones((1, 1)), unit).to_unit(into)
    return float(one.array[0, 0])


def _values(solution: Any) -> Iterator[tuple[str, Any, str]]:
    """Yields the fields of a solution by name with their descriptions, except fields that require a product."""
    for name in _FIELDS:
        value = getattr(solution, name, None)
        if value is None or callable(value) or np.isscalar(value):
            continue
        yield name, value, str(getattr(type(solution), name).__doc__).split("\n\n")[0].replace("\n", " ")


def _fields(solution: Any) -> Iterator[tuple[str, tuple[Any, str]]]:
    """Yields the fields of a solution and the components of its vectors with their descriptions."""
    for name, value, doc in _values(solution):
        if isinstance(value, tuple):
            parts = _PARTS.get(name, tuple(f"{name}_{axis}" for axis in "xyz"))
            yield from ((part, (component, doc)) for part, component in zip(parts, value))
        else:
            yield name, (value, doc)


def _numbers(solution: Any) -> dict[str, Any]:
    """Returns the scalar results of a solution; a vector has one entry per axis."""
    numbers: dict[str, Any] = {}
    for name in _NUMBERS:
        value = getattr(solution, name, None)
        if isinstance(value, tuple):
            numbers |= {f"{name}_{axis}": component for axis, component in zip("xyz", value)}
        elif np.isscalar(value):
            numbers[name] = int(value) if isinstance(value, bool) else value
    return numbers


def _dataset(grid: Any, fields: dict[str, tuple[Any, str]], numbers: dict[str, Any]) -> xarray.Dataset:
    import xarray

    variables = {
        name: (("y", "x"), np.array(values), {"long_name": doc, **(_FLAGS if name == "zones" else {})})
        for name, (values, doc) in fields.items()
    }
    return xarray.Dataset(variables, {"y": grid.y, "x": grid.x}, numbers)


def _with_units(dataset: xarray.Dataset, unit: str | None, lengths: Sequence[str] | None = None) -> xarray.Dataset:
    """Returns a dataset with the unit of its lengths, by default of all variables, as of a surface."""
    if unit is not None:
        for name, variable in dataset.variables.items():
            if lengths is None or name in lengths:
                variable.attrs["units"] = unit
    return dataset


def _halves(normal: Any, shear: Any, both: Any) -> xarray.Dataset:
    numbers = _numbers(normal)
    numbers["normal_force"] = numbers.pop("force")
    fields = dict(_fields(normal)) | dict(_fields(shear))
    for part in (shear, both):
        numbers |= _numbers(part)
    if both is not None:
        fields |= dict(_fields(both))
    return _dataset(normal.grid, fields, numbers)


def _volume(planes: Sequence[Plane]) -> xarray.Dataset:
    import xarray

    first = planes[0]
    if any(plane.grid != first.grid or plane.body != first.body for plane in planes):
        raise ValueError("the planes must belong to one body and one grid")
    layers = [_dataset(plane.grid, dict(_fields(plane)), {}) for plane in planes]
    depths = xarray.DataArray([plane.depth for plane in planes], dims="depth", name="depth")
    return xarray.concat(layers, depths).assign_attrs(body=str(first.body))
