"""Copies and views of arrays, and conversions between fields, arrays, files and datasets."""

import gc
import subprocess
import sys
from fractions import Fraction

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE, address


def test_solution_arrays_are_views(scene):
    contact = scene.normal()
    assert address(contact.pressure) == address(contact.pressure)
    assert contact.pressure.base is contact and contact.pressure.dtype == np.float64
    assert contact.pressure.flags.c_contiguous and not contact.pressure.flags.writeable
    with pytest.raises(ValueError):
        contact.pressure[0, 0] = 1.0
    with pytest.raises(ValueError):
        contact.pressure.setflags(write=True)
    pressure = contact.pressure
    total = pressure.sum()
    del contact
    gc.collect()
    assert pressure.sum() == total


def test_field_is_no_output_of_numpy():
    field = ss.Field(ss.Grid(3, 2, 1.0, 1.0), np.ones((2, 3)))
    for change in (
        lambda: np.add.at(field, (0, 0), 1.0),
        lambda: np.add(np.ones((2, 3)), 1.0, out=field),
        lambda: np.negative(field, out=field),
    ):
        with pytest.raises(ss.errors.ArgumentType, match="a Field does not change"):
            change()
    assert np.array_equal(field, np.ones((2, 3)))


def test_thousands_of_threads_are_rejected():
    with pytest.raises(ss.errors.ArgumentRange, match="at most 1024, got 10000"):
        ss.set_num_threads(10_000)


def test_field_argument_is_shared_not_copied(scene):
    values = np.random.default_rng(1).random(scene.grid.shape)
    field = ss.Field(scene.grid, values)
    assert address(field.array) == address(field.array) == address(np.asarray(field))
    assert address(field) != address(values)  # copied once into its own memory
    assert np.array_equal(field.array, values)
    assert np.array_equal(np.array(field, dtype=np.float32), values.astype(np.float32))
    fortran = ss.Field(scene.grid, np.asfortranarray(values))
    assert fortran == field
    assert ss.Field(scene.grid, values.tolist()) == field
    assert ss.Field(scene.grid, 2.0).integral() == pytest.approx(2.0 * scene.grid.area)


def test_operator_reads_and_writes_arrays_in_place(scene):
    operator = scene.bodies.operator("zz")
    x, out = np.ones(scene.grid.shape), np.zeros(scene.grid.shape)
    seen = []

    class Watched(np.ndarray):
        def __array_finalize__(self, parent):
            seen.append(self.__array_interface__["data"][0])

    watched = x.view(Watched)
    seen.clear()
    result = operator.apply(watched, out=out)
    assert result is out and out.min() > 0.0
    assert all(place == address(x) for place in seen)
    with pytest.raises(ValueError, match="overlap"):
        operator.apply(x, out=x)
    with pytest.raises(ValueError, match="4096"):
        operator.apply(np.ones(7))


def test_solver_reuses_memory_of_dropped_solutions(scene):
    solver = ss.NormalSolver(scene.bodies, scene.ball, force=FORCE)
    places = set()
    for force in np.linspace(50.0, 100.0, 10):
        contact = solver.solve(force=force)
        places.add(address(contact.pressure))
    assert len(places) == 2  # the loop owns one solution while the next is computed
    held = [solver.solve(force=force) for force in (60.0, 70.0, 80.0)]
    assert [round(contact.force) for contact in held] == [60, 70, 80]
    kept = contact.pressure.copy()
    solver.solve(force=20.0)
    assert np.array_equal(contact.pressure, kept)


def test_history_arrays_are_copies_and_state_arrays_are_views(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    pressure = history.pressure
    state = history.state()
    assert address(state.pressure) == address(state.pressure) == address(state.normal.pressure)
    assert address(pressure) != address(history.pressure)
    history.step(normal_force=50.0)
    assert pressure.max() == state.pressure.max() > history.pressure.max()
    history.set_state(state)
    assert history.approach == state.approach


def test_copies_of_data_that_changes_are_read_only(scene):
    history = scene.history(hardness=2e9, permanent_set=True)
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    step = history.step(force_x=30.0)
    cycle.add(history)
    state, solver = history.state(), ss.NormalSolver(scene.bodies, scene.ball, force=FORCE)
    arrays = [
        history.unloaded_gap, history.gap_as_set, history.pressure, history.contact, *history.traction, *history.slip, history.zones,
        history.accumulated_slip, history.accumulated_dissipation, state.gap_as_set, state.yielded, state.contact, state.zones, step.dissipation,
        cycle.slip_distance, cycle.slip_pressure, *cycle.slip_amplitude, cycle.dissipation, solver.gap, solver.solve().contact,
    ]  # fmt: skip
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[...] += 1
    # A sum is a new array, which can be set.
    gap = history.gap_as_set + ss.wear.energy(1e-13, step.dissipation, grid=history.grid)
    gap[0, 0] += 1e-9
    history.set_gap(gap)
    assert history.gap_as_set[0, 0] == gap[0, 0]


def test_step_fields_are_valid_until_next_step(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    step = history.step(force_x=30.0)
    assert step.slip[0].shape == scene.grid.shape
    kept = step.keep()
    assert not kept.slip[0].flags.writeable
    history.step(force_x=10.0)
    with pytest.raises(RuntimeError, match="keep"):
        step.slip_distance
    assert step.tangential_force[0] == pytest.approx(30.0) == pytest.approx(kept.tangential_force[0])
    assert kept.dissipation.sum() == pytest.approx(kept.energy.dissipated_energy)
    assert history.last_step.tangential_force[0] == pytest.approx(10.0)


def test_coupled_solution_parts_share_memory():
    grid = ss.Grid.square(24, 0.3)
    bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    contact = ss.CoupledProblem(bodies, ss.surface.sphere(grid, 3.5), 0.1, normal_force=60.0).solve()
    pressure = contact.normal.pressure
    assert address(pressure) == address(contact.normal.pressure)
    del contact
    gc.collect()
    assert pressure.sum() * grid.cell_area == pytest.approx(60.0)


def test_field_arithmetic_is_cell_by_cell(scene):
    field = scene.ball
    assert np.allclose((2.0 * field - field + 0.0).array, field.array)
    assert (-field).max() == -field.min() and (1.0 - field).max() == 1.0 - field.min()
    assert ss.surface.sum([field, field]) == field * 2.0
    values = np.asarray(field)
    for ours, plain in [
        (field / 2.0, values / 2.0), (1.0 / (field + 1.0), 1.0 / (values + 1.0)), (field * field, values * values),
        (field / (field + 1.0), values / (values + 1.0)), (field * values, values * values), (values[0] - 1.0, field[0] - 1.0),
    ]:  # fmt: skip
        assert np.array_equal(ours, plain)
    with pytest.raises(ss.errors.GridMismatch, match="samples"):
        ss.Field(ss.Grid.square(32, 1.0), field)
    assert isinstance(field / field, ss.Field) and np.isnan((field * 0.0 / 0.0)[0, 0])
    with pytest.raises(ss.errors.GridMismatch, match="other field"):
        field * ss.Field(ss.Grid.square(64, 1.0), 1.0)
    with pytest.raises(TypeError):
        field / "2"


def test_field_arithmetic_accepts_grids_within_round_off():
    ours, theirs = ss.Grid(8, 8, 0.1 * 3, 1.0), ss.Grid(8, 8, 0.3, 1.0)
    assert ours.dx != theirs.dx
    product = ss.Field(ours, 2.0) * ss.Field(theirs, 3.0)
    assert product == ss.Field(ours, 6.0)
    with pytest.raises(ss.errors.GridMismatch):
        ss.Field(ours, 2.0) - ss.Field(ss.Grid(8, 8, 0.3 + 1e-9, 1.0), 3.0)


def test_field_arithmetic_accepts_numpy_left_operand(scene):
    field = scene.ball + 1.0
    for left in (np.full(scene.grid.shape, 3.0), np.arange(4096.0).reshape(64, 64), np.float64(3.0), np.int32(3)):
        values = field.array
        for ours, plain in [
            (left + field, left + values), (left - field, left - values), (left * field, left * values),
            (left / field, left / values),
        ]:  # fmt: skip
            assert isinstance(ours, ss.Field) and np.array_equal(ours, plain)
    with pytest.raises(ss.errors.Shape):
        np.ones((64, 1)) + field


def test_numpy_functions_treat_field_as_array(scene):
    field = scene.ball + 1.0
    for ours, plain in [
        (np.sqrt(field), np.sqrt(field.array)), (np.add.reduce(field, axis=0), field.array.sum(axis=0)),
        (field.array == field, np.ones((64, 64), bool)), (np.hypot(field, field), np.hypot(field.array, field.array)),
        (field > np.zeros((64, 64)), field.array > 0.0),
    ]:  # fmt: skip
        assert type(ours) is np.ndarray and np.array_equal(ours, plain)
    total = np.ones((64, 64))
    total += field
    assert type(total) is np.ndarray and np.array_equal(total, 1.0 + field.array)


def test_numpy_reductions_accept_fields_with_keyword_arguments(scene):
    field = scene.ball + 1.0
    values = field.array
    for name in ("max", "min", "mean", "sum", "std", "median", "ptp", "var"):
        function = getattr(np, name)
        assert function(field) == pytest.approx(function(values), rel=1e-14), name
        assert np.array_equal(function(field, axis=0), function(values, axis=0)), name
        assert function(field, axis=1, keepdims=True).shape == (64, 1), name
    for name in ("max", "min", "mean", "sum", "std"):
        method = getattr(field, name)
        assert method() == pytest.approx(getattr(values, name)(), rel=1e-14)
        assert np.array_equal(method(0), getattr(values, name)(axis=0)) and method(axis=(0, 1)) == pytest.approx(method())
    assert np.sum(field, where=values > 2.0, initial=3.0) == 3.0
    assert np.std(field, ddof=1) == pytest.approx(values.std(ddof=1), rel=1e-14)
    holed = ss.Field(scene.grid, np.where(values == values.max(), np.nan, values))
    assert holed.max(axis=0)[0] == holed.max() < values.max() and np.isnan(holed.mean())
    with pytest.raises(TypeError):
        field.max(colour="red")


def test_field_powers_and_comparisons_are_cell_by_cell(scene):
    field = scene.ball * 1e5 + 0.5
    values = field.array
    for ours, plain in [
        (field**2, values**2), (field**0.5, values**0.5), (2 ** field, 2**values), (np.float64(2.0) ** field, 2.0**values),
        (field**field, values**values), (abs(-field), values), (+field, values),
    ]:  # fmt: skip
        assert isinstance(ours, ss.Field) and np.allclose(ours, plain, rtol=1e-15, atol=0.0)
    for other in (0.6, values[::-1], ss.Field(scene.grid, 0.6)):
        plain = np.asarray(other)
        for ours, expected in [
            (field < other, values < plain), (field <= other, values <= plain), (field > other, values > plain),
            (field >= other, values >= plain),
        ]:  # fmt: skip
            assert ours.dtype == bool and np.array_equal(ours, expected)
    assert (field == field) is True and (field != field) is False and field != field + 1.0
    with pytest.raises(ss.errors.GridMismatch):
        field < ss.Field(ss.Grid.square(64, 1.0), 1.0)
    with pytest.raises(ValueError, match="units um and nm"):
        ss.Field(scene.grid, field, "um") > ss.Field(scene.grid, field, "nm")
    for wrong in (lambda: field < "1", lambda: field ** None, lambda: pow(field, 2, 3)):
        with pytest.raises(TypeError):
            wrong()


def test_surfaces_convert_to_arrays_of_their_heights(scene):
    rough = ss.surface.SelfAffine(rms_height=1e-6, seed=0).generate(scene.grid)
    field = rough.heights
    made = [rough, ss.surface.level(field, "plane"), ss.surface.fill_missing(field), ss.surface.gaussian_filter(field, s=2e-5)]
    for surface in made:
        array = np.asarray(surface)
        assert array.dtype == np.float64 and np.array_equal(array, surface.heights.array) and not array.flags.writeable
        assert np.asarray(surface, dtype=np.float32).dtype == np.float32
        copied = np.array(surface)
        assert copied.flags.writeable and np.array_equal(copied, array)
    assert address(np.asarray(rough)) == address(rough.array)


def test_field_has_shape_and_samples_of_array(scene):
    field = scene.ball
    assert field.shape == field.array.shape == scene.grid.shape
    assert field[3, 4] == field.array[3, 4] == field.get(4, 3)
    assert np.array_equal(field[2], field.array[2]) and np.array_equal(field[:, -1], field.array[:, -1])
    with pytest.raises(IndexError):
        field[64, 0]


def test_contact_mask_matches_contact_area(scene):
    contact = scene.normal()
    assert contact.contact.dtype == bool and contact.contact.shape == scene.grid.shape
    assert contact.contact.sum() == contact.contact_cells
    assert np.array_equal(contact.contact, contact.pressure > 0.0)
    history = scene.history()
    history.step(normal_force=FORCE)
    assert np.array_equal(history.contact, history.state().contact) and history.contact.sum() == contact.contact_cells
    assert np.array_equal(history.contact, history.zones != ss.Zone.SEPARATED)
    pair = (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3))
    grid = ss.Grid.square(16, 0.3)
    both = ss.CoupledProblem(ss.HalfSpace(grid, pair), ss.surface.sphere(grid, 3.5), 0.1, normal_force=60.0).solve()
    assert both.contact.sum() == both.normal.contact_cells > 0


def test_wear_laws_accept_cycle_arrays(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    for force in (30.0, -30.0):
        history.step(force_x=force)
        cycle.add(history)
    depth = ss.wear.archard(1e-14, cycle.slip_pressure, cycle.slip_distance)
    assert np.allclose(depth, 1e-14 * cycle.slip_pressure * cycle.slip_distance, rtol=1e-12, atol=0.0) and depth.max() > 0.0
    assert np.array_equal(depth, ss.wear.archard(1e-14, cycle.slip_pressure, cycle.slip_distance, grid=history.grid))
    with pytest.raises(TypeError, match=r"sides of its cells: give grid= \(such as history.grid"):
        ss.wear.energy(1e-14, np.array(cycle.dissipation))
    depth = ss.wear.energy(1e-14, cycle.dissipation, grid=history.grid)
    assert np.allclose(depth, 1e-14 * cycle.dissipation / history.grid.cell_area, rtol=1e-12, atol=0.0)


def test_total_instead_of_energy_of_each_cell_is_rejected(scene):
    grid, total, cells = scene.grid, 0.25, np.full(scene.grid.shape, 1e-9)
    energy, threshold, archard = ss.wear.energy, ss.wear.threshold_energy, ss.wear.archard
    for number, shape in ((total, ()), (np.float64(total), ()), (np.array(total), ()), (np.array([total]), (1,)), (np.array([[total]]), (1, 1))):
        calls = {
            "energy is the number 0.25, .* (64, 64): .* step.dissipation or cycle.dissipation, instead of a total":
                lambda number=number: energy(1e-13, number, grid=grid),
            "accumulated energy is the number 0.25, .* history.accumulated_dissipation, instead of a total":
                lambda number=number: threshold(1e-13, 0.0, number, cells, grid=grid),
            "^energy is the number 0.25": lambda number=number: threshold(1e-13, 0.0, cells, number, grid=grid),
            "pressure is the number 0.25, .* history.pressure or cycle.slip_pressure":
                lambda number=number: archard(1e-13, number, cells, grid=grid),
            "slip length is the number 0.25, .* step.slip_distance or cycle.slip_distance":
                lambda number=number: archard(1e-13, cells, number),
        }  # fmt: skip
        for message, call in calls.items():
            with pytest.raises(ss.errors.Shape, match=message.replace("(64, 64)", r"\(64, 64\)")) as caught:
                call()
            assert caught.value.found == shape and caught.value.expected == grid.shape
    assert energy(1e-13, cells, grid=grid).max() > 0.0 and energy(1e-13, ss.Field(grid, 1e-9)).max() > 0.0
    assert energy(1e-13, 1e-9, grid=ss.Grid.square(1, 1.0)) == 1e-22


def test_axes_of_xarray_arrays_are_recognised_by_name():
    xarray = pytest.importorskip("xarray")
    grid = ss.Grid.square(8, 1.0)
    values = np.random.default_rng(1).uniform(size=grid.shape)
    array = xarray.DataArray(values, dims=("y", "x"))
    turned = array.transpose("x", "y")
    assert turned.dims == ("x", "y") and not np.array_equal(turned, values)
    assert ss.Field(grid, turned) == ss.Field(grid, array) == ss.Field(grid, values)
    assert ss.Field(grid, values) + turned == 2.0 * ss.Field(grid, values)
    # Other names keep their order.
    assert ss.Field(grid, xarray.DataArray(values, dims=("row", "column"))) == ss.Field(grid, values)
    with pytest.raises(ss.errors.Shape):
        ss.Field(ss.Grid(4, 2, 1.0, 1.0), xarray.DataArray(np.zeros((2, 4)), dims=("x", "y")))
    narrow = xarray.DataArray(np.arange(8.0).reshape(4, 2), dims=("x", "y"))
    assert np.array_equal(ss.Field(ss.Grid(4, 2, 1.0, 1.0), narrow), narrow.T)
    depth = ss.wear.archard(1e-14, narrow, narrow)
    assert np.allclose(depth, 1e-14 * narrow.values.T**2, rtol=1e-12)


def test_axes_of_other_names_are_rejected(scene):
    xarray = pytest.importorskip("xarray")
    grid, values = scene.grid, ss.surface.ellipsoid(scene.grid, 3e-3, 6e-3).array
    along = {"x": grid.x, "y": grid.y}
    other = [
        xarray.DataArray(values.T, dims=("X", "Y"), coords={"X": grid.x, "Y": grid.y}),
        xarray.DataArray(values.T, dims=("lon", "lat"), coords={"lon": grid.x, "lat": grid.y}),
        xarray.DataArray(values.T, dims=("x_um", "y_um")),
        xarray.DataArray(values, dims=("row", "column"), coords={"row": grid.y[::-1]}),
        xarray.DataArray(values, dims=("row", "column"), coords={"y": ("row", grid.y[::-1])}),
        xarray.DataArray(values.T, dims=("x", "row")),
    ]
    for array in other:
        with pytest.raises(ValueError, match=r"gap has the dimensions \(.*\), expected y and x: rename them by \.rename"):
            ss.NormalProblem(scene.bodies, array, force=60.0)
    assert ss.Field(grid, other[0].rename(X="x", Y="y")) == ss.Field(grid, values)
    bare = xarray.DataArray(values, dims=("y", "x"))
    with pytest.raises(ValueError, match=r"the array has no coordinates along x, .* array\.assign_coords\(x=grid\.x, y=grid\.y\)"):
        ss.io.from_xarray(bare)
    assert ss.io.from_xarray(bare.assign_coords(along)) == ss.Field(grid, values)


def test_operands_and_operators_recognise_axes_by_name(scene):
    xarray = pytest.importorskip("xarray")
    field = ss.surface.ellipsoid(scene.grid, 3e-3, 6e-3)
    values = field.array
    turned = xarray.DataArray(values.T, dims=("x", "y"))
    for function in (np.add, np.subtract, np.maximum, np.hypot):
        assert np.array_equal(function(field, turned), function(values, values)), function.__name__
    assert np.array_equal(np.where(values > 1e-6, field, 2.0 * turned), np.where(values > 1e-6, values, 2.0 * values))
    product = scene.bodies.operator("zz")
    assert np.array_equal(product(turned), product(values)) and not np.array_equal(product(values.T), product(values))
    reversed_ = xarray.DataArray(values, dims=("y", "x"), coords={"y": scene.grid.y[::-1]})
    for call in (lambda: np.maximum(field, reversed_), lambda: np.where(values > 0.0, field, reversed_), lambda: product(reversed_)):
        with pytest.raises(ValueError, match="has decreasing coordinates along y"):
            call()


def test_fields_on_different_grids_are_not_combined_by_numpy_operators_and_plots(scene):
    pytest.importorskip("matplotlib").use("Agg")
    other = ss.Field(ss.Grid.square(64, 1.0), scene.ball.array)
    levelled = ss.surface.level(other, "mean")
    product, tensor = scene.bodies.operator("zz"), scene.bodies.tensor_operator()
    for call in (
        lambda: np.add(scene.ball, other),
        lambda: np.hypot(scene.ball, other),
        lambda: np.multiply(scene.ball, levelled),
        lambda: np.maximum(levelled, scene.ball),
        lambda: np.where(scene.ball > 1e-6, scene.ball, other),
        lambda: product(other),
        lambda: scene.bodies.preconditioner("zz")(other),
        lambda: ss.fft.Convolution(scene.grid, scene.bodies.pair, "zz").apply(other),
        lambda: tensor.apply((scene.ball, scene.ball, other)),
        lambda: ss.plot.field(scene.grid, other),
        lambda: ss.plot.section(scene.grid, other),
    ):
        with pytest.raises(ss.errors.GridMismatch):
            call()
    assert np.array_equal(np.hypot(scene.ball, scene.ball.array), np.hypot(scene.ball.array, scene.ball.array))
    assert np.concatenate([scene.ball, other]).shape == (128, 64) and np.array_equal(product(scene.ball), product(scene.ball.array))


def test_array_of_xarray_rejects_field_as_second_operand(scene):
    xarray = pytest.importorskip("xarray")
    field = ss.surface.ellipsoid(scene.grid, 3e-3, 6e-3)
    turned = xarray.DataArray(field.array.T, dims=("x", "y"), coords={"x": scene.grid.x, "y": scene.grid.y})
    dataset = turned.to_dataset(name="gap")
    rough = ss.surface.SelfAffine(rms_slope=0.1, seed=1).generate(scene.grid)
    levelled = ss.surface.level(rough.heights, "plane")
    for operand in (field, rough, levelled):
        name = type(operand).__name__
        first = "the Field" if operand is field else r"its \.heights"
        message = f"a {name} cannot be the second operand of an array of xarray.*: give {first} as the first operand, or convert"
        for call in (
            lambda: turned + operand,
            lambda: turned - operand,
            lambda: turned > operand,
            lambda: turned.where(turned > 0.0, operand),
            lambda: dataset + operand,
            lambda: turned.copy().__iadd__(operand),
        ):
            with pytest.raises(TypeError, match=message):
                call()
    # NumPy passes its functions to the field, whatever the order of the operands.
    assert np.array_equal(np.add(turned, field), 2.0 * field.array)
    assert np.array_equal(np.subtract(turned, levelled), field.array - levelled.heights.array)
    with pytest.raises(TypeError):
        np.add(turned, rough)
    assert np.array_equal(field + turned, 2.0 * field.array) and np.array_equal(ss.io.from_xarray(turned) + field, 2.0 * field.array)
    with pytest.raises(AttributeError, match="'Field' object has no attribute 'arrray'"):
        field.arrray
    assert not hasattr(field, "coords") and "variable" not in dir(field)


def test_axes_of_tables_are_recognised_by_name(scene):
    pandas = pytest.importorskip("pandas")
    grid, values = scene.grid, ss.surface.ellipsoid(scene.grid, 3e-3, 6e-3).array
    x, y = np.meshgrid(grid.x, grid.y)
    points = pandas.DataFrame({"x": x.ravel(), "y": y.ravel(), "gap": values.ravel()})
    table = points.pivot(index="y", columns="x", values="gap")
    turned = points.pivot(index="x", columns="y", values="gap")
    assert ss.Field(grid, table) == ss.Field(grid, turned.T) == ss.Field(grid, values)
    with pytest.raises(ValueError, match=r"gap is a table with rows named x .* expected rows y and columns x: give table\.T"):
        ss.NormalProblem(scene.bodies, turned, force=60.0)
    for axis in ("index", "columns"):
        renamed = table.rename_axis(**{axis: "lat"})
        with pytest.raises(ValueError, match=r"gap is a table with an axis named 'lat', .* \.rename_axis"):
            ss.NormalProblem(scene.bodies, renamed, force=60.0)
        assert ss.Field(grid, table.rename_axis(**{axis: None})) == ss.Field(grid, values)


def test_topography_is_transposed_and_holes_become_nan(scene):
    class Topography:
        physical_sizes = (4.0, 1.0)

        def heights(self):
            return np.ma.masked_equal(np.arange(8.0).reshape(4, 2), 5.0)

    field = ss.surface.from_topography(Topography())
    with pytest.raises(TypeError, match="gap_from_heights"):
        ss.NormalProblem(scene.bodies, Topography(), force=1.0)
    assert field.grid == ss.Grid(4, 2, 1.0, 0.5)
    assert np.array_equal(field.array[0], [0.0, 2.0, 4.0, 6.0]) and np.isnan(field.array[1, 2])
    filled = ss.surface.fill_missing(Topography())
    assert filled.filled_cells == 1 and np.isfinite(filled.heights.array).all()


def test_surfacetopography_object_is_accepted(scene):
    topography = pytest.importorskip("SurfaceTopography")
    heights = np.random.default_rng(2).random((6, 4))
    surface = topography.Topography(heights, (3.0, 2.0))
    assert np.array_equal(ss.surface.from_topography(surface).array, heights.T)
    assert ss.surface.Statistics(surface).mean_height == pytest.approx(heights.mean())


def test_surface_files_round_trip(scene, tmp_path):
    rough = ss.surface.SelfAffine(rms_height=1.0, seed=4, hurst=0.7).generate(ss.Grid.square(32, 10.0))
    assert rough.rms_height == pytest.approx(1.0) and rough.array.mean() == pytest.approx(0.0, abs=1e-12)
    assert ss.surface.Statistics(rough.heights).rms_height == pytest.approx(1.0)
    spectrum = ss.surface.PowerSpectrum(rough.heights)
    assert spectrum.moments[0] == pytest.approx(1.0, rel=1e-6) and len(spectrum.values) == len(spectrum.modes)
    sloped = rough.heights + ss.Field(rough.heights.grid, np.tile(rough.heights.grid.x, (32, 1)))
    levelled = ss.surface.level(sloped, "plane")
    assert levelled.form.max() == pytest.approx(5.0, abs=1.0)
    field = rough.heights
    ss.io.npy.write(tmp_path / "rough.npy", field)
    assert np.array_equal(np.load(tmp_path / "rough.npy"), field.array)
    assert ss.io.npy.read(tmp_path / "rough.npy", size=(10.0, 10.0)) == field
    assert ss.io.csv.parse(ss.io.csv.to_bytes(field), cell=(field.grid.dx, field.grid.dy)) == field
    ss.io.sdf.write(tmp_path / "rough.sdf", field, unit="m")
    assert ss.io.read(tmp_path / "rough.sdf").max() == pytest.approx(field.max(), rel=1e-6)
    ss.io.vti.write(tmp_path / "rough.vti", {"height": field, "vector": (field.array, field.array)}, grid=field.grid)
    assert b"height" in (tmp_path / "rough.vti").read_bytes()
    series = ss.io.pvd.PvdWriter(tmp_path / "series.pvd")
    series.write(0.0, {"height": field})
    assert len(series) == 1 and (tmp_path / "series.pvd").exists()
    contact = scene.normal()
    ss.subsurface.Planes(scene.bodies, [0.0, 1e-5, 2e-5]).write_vti(tmp_path / "stress.vti", "one", contact)
    assert (tmp_path / "stress.vti").stat().st_size > 3 * 8 * 4096


def test_subsurface_points_return_arrays(scene):
    contact = scene.normal()
    points = np.column_stack([np.zeros(5), np.zeros(5), np.linspace(1e-6, 1e-4, 5)])
    found = ss.subsurface.at_points(scene.bodies, "one", contact, points)
    assert len(found) == 5 and list(found) == [found[place] for place in range(5)] and found[-1] == found[4]
    assert ss.subsurface.at_points(scene.bodies, "one", contact, points.tolist()) == found
    for axis, displacement in enumerate(found.displacement):
        assert displacement.tolist() == [response.displacement[axis] for response in found]
    for name, component in zip(("xx", "yy", "zz", "xy", "xz", "yz"), (*found.normal_stress, *found.shear_stress)):
        assert component.tolist() == [getattr(response.stress, name) for response in found]
    for name in ("von_mises", "hydrostatic", "max_shear"):
        assert getattr(found, name).tolist() == [getattr(response.stress, name) for response in found]
    assert found.von_mises.shape == (5,) and repr(found) == "PointResults(5 points)"
    assert len(ss.subsurface.at_points(scene.bodies, "one", contact, [])) == 0
    with pytest.raises(IndexError, match="no point with index 5"):
        found[5]


def test_cycle_points_are_arrays(scene):
    history = scene.history(model="vector")
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    for force in (20.0, -20.0):
        history.step(force=(force, 5.0), twist=1e-5)
        cycle.add(history)
    points = cycle.points
    assert points.force[0] == pytest.approx([0.0, 20.0, -20.0], abs=1e-6) and points.force[1].shape == (3,)
    assert points.shift[1].tolist() == [point.shift[1] for point in points] and len(points) == 3
    assert points.twist.tolist() == [0.0, 1e-5, 1e-5] and points.moment.tolist() == [point.moment for point in points]
    assert (points.force[0].max(), points[-1].shift[0]) == (points[1].force[0], history.shift[0])


def test_topographies_with_different_units_are_rejected(scene):
    class Topography:
        physical_sizes = (4.0, 1.0)

        def __init__(self, unit):
            self.unit = unit

        def heights(self):
            return np.zeros((4, 2))

    one, two, unknown = Topography("um"), Topography("nm"), Topography(None)
    for call in (lambda *pair: ss.surface.gap_between(*pair), lambda *pair: ss.surface.sum([scene.ball, *pair][1:])):
        with pytest.raises(ValueError, match="the units um and nm"):
            call(one, two)
        assert call(one, Topography("um")) == call(one, unknown)
        assert (call(one, unknown).unit, call(unknown, two).unit) == ("um", "nm")


def test_solution_converts_to_xarray_dataset(scene):
    pytest.importorskip("xarray")
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    both = ss.io.to_xarray((contact, shear))
    assert dict(both.sizes) == {"y": 64, "x": 64} and np.array_equal(both.x, scene.grid.x)
    assert np.array_equal(both.pressure, contact.pressure) and np.array_equal(both.traction_x, shear.traction[0])
    assert both.attrs["normal_force"] == contact.force and both.attrs["force_x"] == shear.force[0]
    assert both.pressure.attrs["long_name"].startswith("Pressure p >= 0")
    assert "slip_y" in both and np.array_equal(both.zones, shear.zones)
    history = scene.history()
    history.step(normal_force=FORCE)
    for solution in (history, history.state()):
        dataset = ss.io.to_xarray(solution)
        assert np.array_equal(dataset.accumulated_slip, history.accumulated_slip)
        assert dataset.attrs["normal_force"] == pytest.approx(FORCE) and dataset.attrs["steps"] == 1
    planes = ss.subsurface.Planes(scene.bodies, [0.0, 1e-5], displacements=True).solve_all("two", contact)
    volume = ss.io.to_xarray(planes)
    assert dict(volume.sizes) == {"depth": 2, "y": 64, "x": 64} and volume.attrs["body"] == "two"
    assert volume.depth.values.tolist() == [0.0, 1e-5]
    assert np.array_equal(volume.xz[1], planes[1].shear_stress[1]) and np.array_equal(volume.displacement_z[0], planes[0].displacement[2])
    assert np.array_equal(ss.io.to_xarray(scene.ball)["values"], scene.ball)
    with pytest.raises(TypeError, match="got float"):
        ss.io.to_xarray(1.0)
    with pytest.raises(ValueError, match="one body and one grid"):
        ss.io.to_xarray([planes[0], *ss.subsurface.Planes(scene.bodies, [0.0]).solve_all("one", contact)])


def test_names_of_zones_are_attributes_of_dataset(scene, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("scipy")  # required to write netCDF
    shear = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve()
    dataset = ss.io.to_xarray(shear)
    dataset.to_netcdf(tmp_path / "zones.nc", engine="scipy")
    with xarray.open_dataset(tmp_path / "zones.nc", engine="scipy") as back:
        for zones in (dataset.zones, back.load().zones):
            assert zones.attrs["flag_meanings"] == "separated stick slip" and list(zones.attrs["flag_values"]) == [0, 1, 2]
            assert zones.attrs["flag_values"].dtype == zones.dtype
            assert np.array_equal(zones == ss.Zone.STICK, shear.zones == "stick")
    assert "flag_values" not in dataset.traction_x.attrs


def test_pair_in_wrong_order_is_named(scene):
    pytest.importorskip("xarray")
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    for export in (ss.io.to_xarray, ss.io.vti.to_bytes):
        with pytest.raises(TypeError, match=r"in the order \(normal, shear\), got \(TangentialSolution, NormalSolution\)"):
            export((shear, contact))
        with pytest.raises(TypeError, match=r"a pair \(normal, shear\), .* got tuple of \(NormalSolution, NormalSolution\)"):
            export((contact, contact))
        with pytest.raises(TypeError, match=r"got ndarray: create a Field by Field\(grid, array\)"):
            export(contact.pressure)


def test_solutions_are_written_as_images(scene):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    names = {"pressure": contact.pressure, "gap": contact.gap, "contact": contact.contact}
    assert ss.io.vti.to_bytes(contact) == ss.io.vti.to_bytes(names, grid=scene.grid)
    names |= {"traction": shear.traction, "slip": shear.slip, "zones": shear.zones}
    assert ss.io.vti.to_bytes((contact, shear)) == ss.io.vti.to_bytes(names, grid=scene.grid)
    history = scene.history()
    history.step(normal_force=FORCE)
    for loaded in (history, history.state()):
        assert b'Name="accumulated_slip"' in ss.io.vti.to_bytes(loaded)


def test_dataset_netcdf_round_trip_is_exact(scene, tmp_path):
    xarray = pytest.importorskip("xarray")
    pytest.importorskip("scipy")  # required to write netCDF
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    history = scene.history()
    history.step(normal_force=FORCE)
    planes = ss.subsurface.Planes(scene.bodies, [1e-5, 2e-5]).solve_all("one", contact)
    for solution in (contact, (contact, shear), history, planes, scene.ball):
        dataset = ss.io.to_xarray(solution)
        dataset.to_netcdf(tmp_path / "solution.nc", engine="scipy")
        with xarray.open_dataset(tmp_path / "solution.nc", engine="scipy") as back:
            assert back.load().identical(dataset)


def test_xarray_is_imported_only_on_use():
    code = "import sys, stickslip; assert not {'xarray', 'matplotlib', 'pandas'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_closed_forms_accept_numbers_and_arrays(scene):
    hertz = scene.hertz
    assert isinstance(hertz.pressure(0.0), float) and hertz.pressure(0.0) == hertz.max_pressure
    assert hertz.pressure(np.zeros((2, 3))).shape == (2, 3)
    exact = ss.analytical.CattaneoMindlin(hertz, friction=0.5, force=20.0)
    assert exact.slip(np.linspace(0.0, hertz.contact_radius, 5), 0.0).shape == (5,)
    assert exact.slip(np.zeros((1, 4)), np.zeros((3, 1))).shape == (3, 4)
    assert exact.hertz == hertz and hertz.pair == scene.bodies.pair
    with pytest.raises(ValueError, match="shapes"):
        exact.slip(np.zeros(3), np.zeros(4))
    assert 0.0 < ss.analytical.SpencePressing.round(ss.ElasticPair(ss.Material(1.0, 0.0), ss.Material.rigid()), 0.3).stick_radius < 1.0
    assert ss.analytical.linear_stick_ratio(load=100.0, friction=0.5, force=20.0) == pytest.approx(0.6)


@pytest.mark.parametrize("number", [2.0, 2, np.float64(2.0), np.float32(2.0), np.array(2.0), Fraction(2)])
def test_equality_with_a_number_is_compared_cell_by_cell(number):
    grid = ss.Grid(3, 2, 1.0, 1.0)
    field = ss.Field(grid, np.arange(6.0).reshape(2, 3), "um")
    expected = field.array == 2.0
    assert expected.sum() == 1
    for equal, unequal in ((field == number, field != number), (number == field, number != field)):
        assert equal.dtype == unequal.dtype == bool
        assert np.array_equal(equal, expected) and np.array_equal(unequal, ~expected)


def test_equality_with_an_array_is_compared_cell_by_cell():
    grid = ss.Grid(3, 2, 1.0, 1.0)
    samples = np.array([[0.0, 1.0, 2.0], [3.0, np.nan, 5.0]])
    field = ss.Field(grid, samples)
    for other in (samples, samples.tolist(), tuple(map(tuple, samples))):
        assert np.array_equal(field == other, [[True] * 3, [True, False, True]])
        assert np.array_equal(field != other, [[False] * 3, [False, True, False]])
    with pytest.raises(ss.errors.Shape):
        field == np.zeros((3, 2))


def test_equality_of_two_fields_is_one_truth_value_and_fields_have_no_hash():
    grid = ss.Grid(3, 2, 1.0, 1.0)
    field, other = ss.Field(grid, 1.0), ss.Field(grid, 2.0)
    assert (field == ss.Field(grid, 1.0)) is True and (field == other) is False and (field != other) is True
    for stranger in (None, "1.0", np.str_("1.0"), object(), ss.surface.SelfAffine(rms_height=1.0, seed=1).generate(ss.Grid.square(8, 1.0))):
        assert (field == stranger) is False and (field != stranger) is True
    with pytest.raises(TypeError, match="unhashable"):
        hash(field)


def test_samples_of_half_precision_are_rejected(scene):
    heights = np.asarray(scene.ball).astype(np.float16)
    message = r"the type float16 of {} has three digits: give array\.astype\(float\) if this is intended"
    for quantity, call in (
        ("samples", lambda: ss.Field(scene.grid, heights)),
        ("gap", lambda: ss.NormalProblem(scene.bodies, heights, force=1.0)),
        ("coefficient of friction", lambda: ss.Friction(heights, grid=scene.grid)),
    ):
        with pytest.raises(TypeError, match=message.format(quantity)):
            call()
    xarray = pytest.importorskip("xarray")
    array = xarray.DataArray(heights, dims=("y", "x"), coords={"y": scene.grid.y, "x": scene.grid.x})
    with pytest.raises(TypeError, match=message.format("the heights")):
        ss.io.from_xarray(array)
    assert ss.Field(scene.grid, np.float16(0.5)).max() == 0.5
    assert ss.Field(scene.grid, heights.astype(float)) is not None
