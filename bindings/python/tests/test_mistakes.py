"""Mistakes in calls that would compute a plausible result of a different problem."""

import collections
import copy
import io
import pickle
import re
import warnings

import numpy as np
import pytest

import stickslip as ss

STEEL = ss.Material(213e9, 0.29)
FORCE = 100.0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene: ss.TangentialProblem(scene.bodies, scene.normal(), 0.5), "tangential load by force_x=, shift_x=.* force_x=0.0 for no"),
        (lambda scene: ss.TangentialLoad(), "tangential load by force_x=, shift_x="),
        (lambda scene: ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.5), "creepage_x= or force_x=: creepage_x=0.0 for free"),
        (lambda scene: ss.NormalProblem(scene.bodies, scene.ball), "normal load by force= or approach="),
        (lambda scene: ss.CoupledProblem(scene.bodies, scene.ball, 0.5, force_x=1.0), "normal load by normal_force= or approach="),
        (lambda scene: scene.history().press(tolerance=0.1), "normal load by normal_force= or approach="),
    ],
)
def test_missing_load_message_names_keywords(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene)


def test_load_is_optional_where_something_else_loads_the_contact(scene):
    contact = scene.normal()
    stretched = ss.tangential.RelativeDisplacement.bulk_strain(scene.grid, ((1e-4, 0.0), (0.0, 0.0)))
    assert ss.TangentialProblem(scene.bodies, contact, 0.5, relative_displacement=stretched).solve(warn=False).traction[0].any()
    # A zero load is stated, and a pressed contact of dissimilar bodies needs no tangential load.
    still = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=0.0)
    assert not pickle.loads(pickle.dumps(still)).solve().traction[0].any()
    pair = ss.HalfSpace(scene.grid, (STEEL, ss.Material(70e9, 0.33)))
    assert ss.CoupledProblem(pair, scene.ball, 0.3, normal_force=FORCE).solve(warn=False).tangential.traction[0].any()


def test_zones_compare_equal_to_their_names(scene):
    shear = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve()
    history = scene.history()
    history.step(normal_force=FORCE)
    history.step(force_x=20.0)
    for zones in (shear.zones, history.zones, history.state().zones, pickle.loads(pickle.dumps(shear.zones)), shear.zones.copy(), shear.zones[20:]):
        numbers = np.array(zones)
        assert type(numbers) is np.ndarray and numbers.dtype == np.uint8 and np.unique(zones).tolist() == [0, 1, 2]
        for zone in ss.Zone:
            name = zone.name.lower()
            for mask in (zones == name, name == zones, zones == zone, zones == np.array(name), ~(zones != name)):
                assert type(mask) is np.ndarray and mask.dtype == bool and np.array_equal(mask, numbers == int(zone)), name
        named = np.array(["separated", "stick", "slip"])[numbers]
        assert (zones == named).all() and (zones == numbers).all() and not (zones != named.tolist()).any()
        for wrong in ("Stick", "gross slip", b"stick", ["stick", "no"]):
            with pytest.raises(ValueError, match="is not a zone"):
                zones == wrong  # noqa: B015
            with pytest.raises(ValueError, match="is not a zone"):
                zones != wrong  # noqa: B015
    for cell in shear.zones[32]:
        assert isinstance(cell, ss.Zone) and cell == cell.name.lower() and (cell == "stick") == (cell == 1) == (not cell != "stick")
    assert ss.Zone("slip") is ss.Zone.SLIP and {ss.Zone.STICK: 5}[shear.zones[32, 32]] == 5
    with pytest.raises(ValueError, match="'Slip' is not a zone"):
        shear.zones[32, 32] == "Slip"  # noqa: B015


def test_results_computed_from_zones_are_numbers(scene):
    zones = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve().zones
    numbers = np.array(zones)
    for result, expected in (
        (zones + 1, numbers + 1), (zones > 0, numbers > 0), (zones.sum(axis=0), numbers.sum(axis=0)), (np.diff(zones), np.diff(numbers)),
        (np.where(zones == "slip", 1.0, 0.0), np.where(numbers == 2, 1.0, 0.0)), (zones.astype(float) / 2, numbers / 2),
    ):  # fmt: skip
        assert type(result) is np.ndarray and np.array_equal(result, expected)
    assert zones.sum() == numbers.sum() and type(zones.sum()) is type(numbers.sum()) and zones.max() == 2
    assert zones.tolist() == numbers.tolist() and zones.astype(float)[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        zones[0, 0] = 2


def test_combined_zones_compare_equal_to_their_names(scene):
    zones = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve().zones
    numbers = np.array(zones)
    for function in (
        lambda given: np.concatenate([given, given]), lambda given: np.stack([given, given]), lambda given: np.vstack([given, given]),
        lambda given: np.hstack((given, given)), lambda given: np.append(given, given), lambda given: np.where(numbers > 1, given, given),
        lambda given: np.pad(given, 1), lambda given: np.broadcast_to(given, (2, 64, 64)), lambda given: np.block([[given, given]]),
        lambda given: np.delete(given, 0, 0), lambda given: np.roll(given, 1), lambda given: np.unique(given), np.copy,
    ):  # fmt: skip
        combined = function(zones)
        assert np.array_equal(combined == "stick", function(numbers) == 1) and (combined == "stick").any()
        with pytest.raises(ValueError, match="is not a zone"):
            combined == "Stick"  # noqa: B015
    assert type(np.concatenate([zones, zones.astype(float)])) is type(np.diff(zones)) is np.ndarray


def test_arrays_on_another_grid_are_rejected(scene):
    normal = scene.normal()
    tangential = ss.TangentialProblem(scene.bodies, normal.pressure, 0.5, force_x=20.0).solve()
    history = scene.history()
    history.step(normal_force=FORCE)
    step, state = history.step(force_x=20.0), history.state()
    other = ss.Grid.square(64, 1.0)
    bodies = ss.HalfSpace(other, scene.bodies.pair)
    solver = ss.NormalProblem(scene.bodies, scene.ball, force=FORCE).solver()
    superposed = ss.tangential.JaegerSuperposition(normal, scene.normal(), scene.bodies.pair, 0.5)
    assert superposed.grid == step.grid == step.keep().grid == scene.grid
    arrays = [normal.pressure, normal.gap, tangential.traction[0], tangential.slip[1], state.pressure, state.accumulated_slip, solver.gap,
              history.pressure, history.gap_as_set, history.traction[1], history.accumulated_slip, step.slip[0], step.keep().slip_distance]  # fmt: skip
    for array in arrays:
        assert type(array) is np.ndarray and array.shape == other.shape and not array.flags.writeable
        for call in (
            lambda: ss.NormalProblem(bodies, array, force=1.0),  # noqa: B023
            lambda: ss.TangentialProblem(bodies, array, 0.5, force_x=0.0),  # noqa: B023
            lambda: ss.Field(other, array),  # noqa: B023
            lambda: ss.Field(other, 1.0) + array,  # noqa: B023
            lambda: ss.wear.energy(1e-13, array, grid=other),  # noqa: B023
        ):
            with pytest.raises(ss.errors.GridMismatch, match=r"is on a grid of \[64, 64\] cells"):
                call()
        # Copies, results of arithmetic and arrays in another order do not contain the grid.
        for plain in (np.array(array), 2.0 * array, array[::-1], pickle.loads(pickle.dumps(array))):
            assert ss.Field(other, plain).grid == other
        assert ss.Field(scene.grid, array).grid == scene.grid
    assert ss.Field(other, scene.ball.array).grid == other
    with pytest.raises(ss.errors.GridMismatch):
        ss.wear.archard(1e-13, history.pressure, ss.Field(other, 1.0))


def test_energies_per_area_are_rejected_by_the_wear_laws(scene):
    rolling = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.3, force_x=10.0).solve()
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    history.step(force_x=20.0)
    cycle.add(history)
    area = scene.grid.cell_area
    density = cycle.dissipation / area
    for per_area in (rolling.dissipation_per_area, 2.0 * rolling.dissipation_per_area, density, density + density, density / 3.0):
        assert isinstance(per_area, np.ndarray) and per_area.shape == scene.grid.shape
        for call in (
            lambda: ss.wear.energy(1e-13, per_area, grid=scene.grid),  # noqa: B023
            lambda: ss.wear.threshold_energy(1e-13, 1.0, per_area, cycle.dissipation),  # noqa: B023
            lambda: ss.wear.threshold_energy(1e-13, 1.0, cycle.dissipation, per_area),  # noqa: B023
        ):
            with pytest.raises(TypeError, match=r"energies per area, and the law divides .*: multiply them by grid\.cell_area"):
                call()
        # A coefficient times an energy per area is a depth.
        assert np.allclose(ss.wear.energy(1e-13, per_area * area), 1e-13 * per_area, rtol=1e-12, atol=0.0)
        history.set_gap(scene.ball + 1e-13 * per_area)
    assert np.allclose(density * area, cycle.dissipation) and (density * area).grid == scene.grid
    plain = (density + np.zeros(scene.grid.shape), np.array(density), density.sum(axis=0), density > 0.0)
    assert all(type(result) is np.ndarray for result in plain)
    assert isinstance(density.sum(), float) and isinstance(density[3, 3], float)
    copied = pickle.loads(pickle.dumps(density))
    assert type(copied) is type(density) and np.array_equal(copied, density)
    assert (copied * area).grid == scene.grid
    assert type(rolling.dissipation_per_area[3:] * area) is type(density)


def test_energies_are_rejected_by_archards_law(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    step = history.step(force_x=20.0)
    for given in ((history.pressure, step.dissipation), (step.dissipation, step.slip_distance)):
        with pytest.raises(TypeError, match="contains energies of cells"):
            ss.wear.archard(1e-13, *given)


def test_first_loop_between_turning_points_has_a_warning(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    for repeat in range(2):
        cycle.begin(history)
        for side in (1.0, -1.0, 1.0):
            history.step(force_x=20.0 * side)
            cycle.add(history)
        assert [warning.kind for warning in cycle.warnings] == (["open_cycle"] if repeat == 0 else [])


def test_energies_on_another_grid_are_rejected(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    step = history.step(force_x=20.0)
    cycle.add(history)
    other = ss.Grid.square(64, 1.0)
    kept, state = step.keep(), history.state()
    for energy in (step.dissipation, kept.dissipation, cycle.dissipation, history.accumulated_dissipation, state.accumulated_dissipation,
                   step.dissipation_midpoint, 2.0 * cycle.dissipation, cycle.dissipation + history.accumulated_dissipation):  # fmt: skip
        assert energy.grid == scene.grid and isinstance(energy, np.ndarray)
        with pytest.raises(ss.errors.GridMismatch, match="energy"):
            ss.wear.energy(1e-13, energy, grid=other)
        with pytest.raises(ss.errors.GridMismatch, match="energy"):
            ss.wear.threshold_energy(1e-13, 1.0, energy, energy, grid=other)
        # The area of a cell is known without a grid.
        depth = ss.wear.energy(1e-13, energy)
        assert np.array_equal(depth, ss.wear.energy(1e-13, np.array(energy), grid=scene.grid)) and type(depth) is np.ndarray
    energy = cycle.dissipation
    assert energy[3:].grid is None and type(energy > 0.0) is type(energy.sum(axis=0)) is np.ndarray
    assert isinstance(energy.sum(), float) and isinstance(energy[3, 3], float) and type(np.array(energy)) is np.ndarray
    for copied in (pickle.loads(pickle.dumps(energy)), copy.copy(energy), copy.deepcopy(energy)):
        assert np.array_equal(copied, energy) and type(copied) is type(energy)
        assert copied.grid == scene.grid and np.array_equal(ss.wear.energy(1e-13, copied), ss.wear.energy(1e-13, energy))
    assert pickle.loads(pickle.dumps(energy[3:])).grid is None
    with pytest.raises(ValueError, match="read-only"):
        energy[0, 0] = 1.0
    with pytest.raises(TypeError, match="an array does not contain the sides"):
        ss.wear.energy(1e-13, np.array(energy))


def test_dissipated_energy_is_that_of_mindlin(scene):
    history = ss.History(scene.bodies, scene.ball, 0.5, tolerance=1e-8)
    history.step(normal_force=FORCE)
    exact = ss.analytical.CattaneoMindlin(scene.hertz, force=30.0, friction=0.5).energy_per_cycle
    loop, cycle = ss.history.FrettingLoop(ss.history.LoadPath.triangle((30.0, 0.0), 4), lambda force: ss.LoadStep(force=force)), ss.history.Cycle(history)
    for _ in range(2):
        loop.cycle(history, cycle)
    assert cycle.energy.dissipated_energy == pytest.approx(exact, rel=5e-3)
    assert cycle.dissipation.sum() == pytest.approx(cycle.energy.dissipated_energy, rel=1e-12)
    assert cycle.energy.dissipated_energy_midpoint < 0.8 * exact


def test_gap_of_exports_is_described_as_loaded_or_unloaded(scene):
    pytest.importorskip("xarray")
    history = scene.history()
    history.step(normal_force=FORCE)
    assert ss.io.to_xarray(scene.normal()).gap.attrs["long_name"].startswith("Gap under load")
    for solution in (history, history.state()):
        dataset = ss.io.to_xarray(solution)
        assert dataset.unloaded_gap.attrs["long_name"].startswith("The gap before loading") and "gap" not in dataset
    for function in (ss.io.to_xarray, ss.io.vti.write):
        assert "``gap`` is the gap under load" in " ".join(function.__doc__.split())


def test_numpy_functions_of_processed_surfaces_reject_different_units(scene):
    fields = {unit: ss.Field(scene.grid, scene.ball.array, unit) for unit in ("um", "mm")}
    makers = (
        lambda field: ss.surface.level(field, "plane"),
        ss.surface.fill_missing,
        lambda field: ss.surface.gaussian_filter(field, s=5e-5),
        lambda field: ss.surface.remove_outliers(field),
    )
    for make in makers:
        one, other = make(fields["um"]), make(fields["mm"])
        for pair in ((one, other), (one, fields["mm"]), (fields["um"], other)):
            for function in (np.add, np.subtract, np.maximum, np.hypot, np.less):
                with pytest.raises((ValueError, TypeError), match=r"units um and mm|which has heights: give its \.heights"):
                    function(*pair)
        heights = np.asarray(one)
        assert np.array_equal(np.add(one, one), 2.0 * heights) and np.array_equal(np.multiply(one, other), heights * np.asarray(other))
        assert np.array_equal(np.abs(one), np.abs(heights)) and np.array_equal(np.subtract(heights, one), 0.0 * heights)
        assert np.add.reduce(one, axis=0).shape == (64,)
        for call in (lambda *pair: np.stack(pair), np.array_equal, lambda a, b: np.where(heights > 0.0, a, b)):
            for pair in ((one, other), (fields["um"], fields["mm"]), (fields["um"], other)):
                with pytest.raises(ValueError, match="units um and mm"):
                    call(*pair)
        assert np.stack([one, one]).shape == (2, 64, 64) and np.array_equal(np.dot(one, other), np.dot(heights, np.asarray(other)))
    assert np.allclose(fields["um"], scene.ball.array) and np.mean(fields["mm"], axis=0).shape == (64,) and np.shape(fields["um"]) == (64, 64)


def test_coordinates_of_xarray_arguments_must_agree_with_the_grid(scene):
    xarray = pytest.importorskip("xarray")
    grid, gap = scene.grid, scene.ball.array

    def of(y, x, **attributes):
        return xarray.DataArray(gap, {"y": y, "x": x}, ("y", "x"), attrs=attributes)

    reference = ss.NormalProblem(scene.bodies, gap, force=FORCE).solve().pressure
    for array in (of(grid.y, grid.x), of(grid.y + 1.0, grid.x).T, of(grid.y, grid.x).drop_vars("y")):
        assert np.array_equal(ss.NormalProblem(scene.bodies, array, force=FORCE).solve().pressure, reference)
    with pytest.raises(ValueError, match=r'gap has decreasing coordinates along y: sort it by \.sortby\("y"\)'):
        ss.NormalProblem(scene.bodies, of(grid.y[::-1], grid.x), force=FORCE)
    pandas = pytest.importorskip("pandas")
    for table in (pandas.DataFrame(gap), pandas.DataFrame(gap, grid.y, grid.x)):
        assert np.array_equal(ss.NormalProblem(scene.bodies, table, force=FORCE).solve().pressure, reference)
    with pytest.raises(ValueError, match=r"gap has decreasing coordinates along y: sort it by \.sort_index\(axis=0\)"):
        ss.NormalProblem(scene.bodies, pandas.DataFrame(gap, grid.y[::-1], grid.x), force=FORCE)
    for wrong in (pandas.DataFrame(gap, grid.y, 1e3 * grid.x), of(grid.y, 1e3 * grid.x), of(grid.y, np.sort(grid.x**2)), of(grid.y, np.arange(64))):
        with pytest.raises(ValueError, match=r"gap has coordinates from .* along x, which do not agree with 64 cells .* give \.values"):
            ss.NormalProblem(scene.bodies, wrong, force=FORCE)
    with pytest.raises(ValueError, match="units mm and um"):
        ss.Field(grid, ss.Field(grid, gap, "um"), "mm")
    with pytest.raises(ValueError, match="units um and mm"):
        ss.Field(grid, gap, "um") + of(grid.y, grid.x, units="mm")
    assert ss.Field(grid, of(grid.y, grid.x, units="mm")).unit == "mm" and ss.Field(grid, of(grid.y, grid.x, units="Pa")).unit is None


def test_labels_of_pandas_tables_must_rise(scene):
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame(scene.ball.array)

    def problem(given):
        return ss.NormalProblem(scene.bodies, given, force=FORCE)

    for reversed_, axis, number in ((table.iloc[::-1], "y", 0), (table.iloc[:, ::-1], "x", 1)):
        with pytest.raises(ValueError, match=rf"gap has decreasing coordinates along {axis}: sort it by \.sort_index\(axis={number}\)"):
            problem(reversed_)
        assert np.array_equal(ss.Field(scene.grid, reversed_.sort_index(axis=number)).array, scene.ball.array)
    shuffled = table.sample(frac=1.0, random_state=0)
    message = r"gap has coordinates along y that do not rise: sort it by \.sort_index\(axis=0\), or give \.values to ignore the coordinates"
    decimal = table.set_axis(scene.grid.y).sample(frac=1.0, random_state=0)
    for given in (shuffled, shuffled.set_axis([str(label) for label in shuffled.index]), decimal):
        with pytest.raises(ValueError, match=message):
            problem(given)
    with pytest.raises(ValueError, match="samples has coordinates along y that do not rise"):
        ss.Field(scene.grid, shuffled)
    with pytest.raises(ValueError, match=r"gap has coordinates from 0\.0 to 126\.0 along y"):
        problem(table.set_axis(range(0, 128, 2)))
    accepted = (
        table.set_axis(range(5, 69)), table.set_axis([str(label) for label in range(64)], axis=1), table.set_axis([f"row {k}" for k in range(64)]),
        table.set_axis([repr(float(x)) for x in scene.grid.x], axis=1), pandas.DataFrame(shuffled.sort_index()), table.convert_dtypes(),
    )  # fmt: skip
    for given in accepted:
        assert np.array_equal(ss.Field(scene.grid, given).array, scene.ball.array)
    assert np.array_equal(ss.Field(scene.grid, shuffled.values).array, shuffled.to_numpy())


def test_arithmetic_with_tables_keeps_axes(scene):
    pandas = pytest.importorskip("pandas", minversion="2.1")
    field = scene.ball + ss.surface.sinusoidal(scene.grid, 1e-6, 1e-4)
    table = pandas.DataFrame(field.array + 1e-6 * np.arange(64.0))
    for total in (table + field, field + table, np.add(table, field)):
        assert isinstance(total, ss.Field) and np.array_equal(total.array, table.to_numpy() + field.array)
    assert np.array_equal((table - field).array, table.to_numpy() - field.array)
    with pytest.raises(ValueError, match="other field has decreasing coordinates along y"):
        table.iloc[::-1] + field


def test_masked_cells_are_missing_points(scene):
    gap = np.ma.masked_array(scene.ball.array, mask=False)
    assert np.array_equal(ss.NormalProblem(scene.bodies, gap, force=FORCE).solve().pressure, scene.normal().pressure)
    gap[3, 5] = np.ma.masked
    history = scene.history()
    for call in (
        lambda: ss.NormalProblem(scene.bodies, gap, force=FORCE),
        lambda: ss.TangentialProblem(scene.bodies, gap, 0.5, force_x=1.0),
        lambda: history.set_gap(gap),
        lambda: history.set_gap(history.gap_as_set + gap),
        lambda: ss.NormalProblem(scene.bodies, scene.ball + gap, force=FORCE),
        lambda: ss.Friction(gap, grid=scene.grid),
        lambda: ss.NormalProblem(scene.bodies, scene.ball, force=FORCE, hardness=1e9 + gap),
    ):
        with pytest.raises(ss.errors.Sample, match="row 3, column 5 .* is nan"):
            call()
    measured = ss.Field(scene.grid, gap)
    assert np.isnan(measured[3, 5]) and ss.surface.fill_missing(measured).filled_cells == 1


def test_missing_coordinates_have_no_values(scene):
    hertz, radii = scene.hertz, np.ma.masked_array([0.0, 1e-5, 1e-3], [False, True, False])
    for values in (hertz.pressure(radii), hertz.gap(radii), hertz.displacement(np.array([0.0, np.nan, 1e-3]))):
        assert np.isnan(values).tolist() == [False, True, False]
    ellipse = ss.analytical.HertzEllipse(scene.bodies.pair, radius_x=3e-3, radius_y=4e-3, load=FORCE)
    assert np.isnan(ellipse.pressure(radii, 0.0)).tolist() == [False, True, False] and np.isnan(ellipse.pressure(0.0, np.nan))
    with pytest.raises(ss.errors.Sample, match="is nan"):
        ss.subsurface.at_points(scene.bodies, "one", scene.normal(), np.ma.masked_array([[0.0, 0.0, 1e-5]], [[0, 0, 1]]))


def test_load_path_of_pandas_table_is_that_of_its_rows():
    pandas = pytest.importorskip("pandas")
    values = [(1e-6, 0.0), (0.0, 2e-6)]
    path = ss.history.LoadPath(pandas.DataFrame(values, columns=["x", "y"]))
    assert path.cycles(1) == ss.history.LoadPath(values).cycles(1) == values


def test_units_of_heights_and_coordinates_must_agree(scene):
    xarray = pytest.importorskip("xarray")
    grid = scene.grid

    def heights(unit, of_coordinates):
        array = xarray.DataArray(1e6 * scene.ball.array, {"y": grid.y, "x": grid.x}, ("y", "x"), attrs={"units": unit})
        for axis in ("x", "y"):
            array[axis].attrs["units"] = of_coordinates
        return array

    micrometres = heights("um", "m")
    message = r'gap has the unit um, but its coordinates along x have the unit m: convert it by io\.from_xarray\(array\)\.to_unit\("m"\)'
    for call in (
        lambda: ss.NormalProblem(scene.bodies, micrometres, force=FORCE),
        lambda: scene.history().set_gap(micrometres),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(ValueError, match="samples has the unit um, but its coordinates along x have the unit m"):
        ss.Field(grid, micrometres)
    converted = ss.io.from_xarray(micrometres).to_unit("m")
    assert np.allclose(converted, scene.ball.array, rtol=1e-14) and converted.grid.dx == pytest.approx(grid.dx, rel=1e-12)
    with pytest.raises(TypeError, match=r"contain their grid: convert an array of xarray by io\.from_xarray\(array\)$"):
        ss.surface.level(micrometres, "plane")
    # A pressure has no unit of length, and one unit has several names.
    pressure = heights("Pa", "m")
    assert ss.TangentialProblem(scene.bodies, pressure, 0.5, force_x=0.0).friction_capacity > 0.0
    assert ss.Field(grid, heights("um", "\u00b5m")).unit == "um"


def test_surfaces_without_unit_take_the_unit_of_the_other(scene):
    plain, stated = ss.Field(scene.grid, 1.0), ss.Field(scene.grid, 2.0, "um")
    assert (plain + stated).unit == (stated - plain).unit == ss.surface.gap_between(plain, stated).unit == "um"
    assert "takes the unit of the other operand" in " ".join(ss.Field.__doc__.split())


def test_exported_pairs_belong_to_one_grid(scene):
    pytest.importorskip("xarray")
    coarse = ss.HalfSpace(ss.Grid.square(64, 0.4e-3), (STEEL, STEEL))
    other = ss.NormalProblem(coarse, ss.surface.sphere(coarse.grid, 3.5e-3), force=FORCE).solve()
    shear = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, force_x=20.0).solve()
    for export in (ss.io.to_xarray, ss.io.vti.to_bytes):
        with pytest.raises(ValueError, match="the solutions of a pair must be on one grid, got Grid"):
            export((other, shear))


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda scene, mask: ss.NormalProblem(scene.bodies, mask, force=1.0), "gap must be real numbers, got truth values: .* mask.astype"),
        (lambda scene, mask: ss.TangentialProblem(scene.bodies, mask, 0.5, force_x=1.0), "pressure must be real numbers, got truth values"),
        (lambda scene, mask: scene.history().set_friction(mask), "coefficient of friction must be real numbers, got truth values"),
        (lambda scene, mask: scene.history(hardness=mask), "hardness must be real numbers, got truth values"),
    ],
)
def test_masks_instead_of_numbers_are_rejected(scene, call, message):
    with pytest.raises(TypeError, match=message):
        call(scene, scene.ball.array > 0.0)


def test_labels_and_points_in_csv_are_rejected():
    header = b"0,.5,1,1.5,2,2.5,3,3.5,4\n1,7,5,6,6,3,2,2,5\n3,4,9,5,5,1,1,6,1\n"
    with pytest.raises(ss.errors.Format, match="skip_rows = 1"):
        ss.io.csv.parse(header, cell=(1.0, 1.0))
    assert ss.io.csv.parse(header, cell=(1.0, 1.0), skip_rows=1).array[0].tolist() == [1, 7, 5, 6, 6, 3, 2, 2, 5]
    points = b"".join(b"%d %d %d\n" % (i % 3, i // 3, i * i % 7) for i in range(9))
    with pytest.raises(ss.errors.Format, match="read the file as XYZ"):
        ss.io.csv.parse(points, cell=(1.0, 1.0))
    assert ss.io.csv.parse(points, cell=(1.0, 1.0), without_labels=True).shape == (9, 3)
    x, y = np.meshgrid(np.arange(12.0), np.arange(10.0))
    inclined = ss.Field(ss.Grid(12, 10, 1.0, 1.0), 0.3 * x + 0.17 * y)
    assert ss.io.csv.parse(ss.io.csv.to_bytes(inclined), cell=(1.0, 1.0)) == inclined


def test_pairs_of_solutions_with_different_loads_are_not_exported(scene, tmp_path):
    contact = scene.normal()
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=0.1 * FORCE).solve(warn=False)
    lighter = ss.NormalProblem(scene.bodies, scene.ball, force=0.5 * FORCE).solve(warn=False)
    ss.io.vti.write(tmp_path / "pair.vti", (contact, shear))
    with pytest.raises(ss.errors.OutdatedSolution):
        ss.io.vti.write(tmp_path / "mixed.vti", (lighter, shear))
    assert not (tmp_path / "mixed.vti").exists()


def test_loop_whose_load_ignores_the_path_is_rejected(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    loop = ss.history.FrettingLoop(ss.history.LoadPath.sine((1e-6, 0.0), 8), lambda shift: ss.LoadStep(normal_force=FORCE))
    with pytest.raises(ValueError, match="equal steps for all values of the path"):
        loop.run(history, 2)
    with pytest.raises(ValueError, match="equal steps for all values of the path"):
        ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 100)
    # The sine contains the values 0.0 and -0.0 along y.
    beside = ss.history.FrettingLoop(
        ss.history.LoadPath.sine((2e-6, 0.0), 20), lambda shift: ss.LoadStep(normal_force=FORCE, shift_x=shift[1])
    )
    with pytest.raises(ValueError, match="equal steps for all values of the path"):
        beside.run(history, 2)
    assert history.steps == 1


def test_loop_without_slip_warns_unless_friction_is_large(scene):
    path = ss.history.LoadPath.sine((2e-6, 0.0), 20)  # lengths, given as forces
    loop = ss.history.FrettingLoop(path, lambda force: ss.LoadStep(normal_force=FORCE, force=force))

    def pressed(friction):
        history = ss.History(scene.bodies, scene.ball, friction)
        history.step(normal_force=FORCE)
        return history

    with pytest.warns(ss.ContactWarning, match="no cell slips in the cycle, .* a length given as a force"):
        assert loop.run(pressed(0.5), 2).last.energy.dissipated_energy == 0.0
    with pytest.warns(ss.ContactWarning, match="no cell slips in the cycle"):
        assert ss.wear.run(pressed(0.5), loop, ss.wear.EnergyLaw(1e-13), 100).depth.max() == 0.0
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        loop.run(pressed(1e6), 1)
    assert not any("no cell slips" in str(warning.message) for warning in caught)


def test_comparison_of_choices_with_unknown_names_raises(scene):
    report = scene.normal().report
    assert report.status == "converged" and report.status != "stalled" and "converged" == report.status
    assert report.status in ("stalled", "converged") and report.status != 1 and report.status is not None
    assert {report.status: 1}["converged"] == 1 and ss.Axis.X == ss.influence.Direction.X and ss.Status.STALLED != ss.Axis.X
    for compare in (lambda: report.status == "ok", lambda: "ok" != report.status, lambda: report.status in ("ok",)):
        with pytest.raises(ValueError, match="'ok' is not a name of Status: use 'unsolved', 'converged', 'iteration_limit', "):
            compare()
    with pytest.raises(ValueError, match="'partial slip' is not a name of Regime: use 'full_stick', 'partial_slip', 'gross_slip'"):
        assert ss.history.Regime.PARTIAL_SLIP == "partial slip"
    assert np.array_equal(np.array([report.status]) == "converged", [True])


def test_comparison_of_warnings_with_strings_raises(scene):
    found = ss.NormalProblem(scene.bodies, scene.ball, force=2e3).solve(warn=False).warnings
    assert "contact_at_edge" in [warning.kind for warning in found]
    assert found[0] in found and found[0] != 1 and len({found[0], pickle.loads(pickle.dumps(found[0]))}) == 1
    for compare in (lambda: "contact_at_edge" in found, lambda: found[0] == "contact_at_edge", lambda: found[0] != "contact_at_edge"):
        with pytest.raises(ValueError, match=r"a warning is not a string: .* \[warning\.kind for warning in solution\.warnings\]"):
            compare()


def test_grid_that_differs_from_that_of_a_field_is_rejected(scene, tmp_path):
    other, ones = ss.Grid.square(64, 1.0), ss.Field(scene.grid, 1.0)
    calls = {
        "coefficient of friction": lambda grid: ss.Friction(ones, grid=grid),
        "hardness": lambda grid: ss.normal.Hardness(ones, grid=grid),
        "along_x": lambda grid: ss.tangential.RelativeDisplacement(ones, ones, grid=grid),
        "field": lambda grid: ss.io.vti.write(tmp_path / "field.vti", {"ones": ones}, grid=grid),
        "solution": lambda grid: ss.io.vti.to_bytes(ones, grid=grid),
    }
    for name, call in calls.items():
        call(scene.grid)
        with pytest.raises(ss.errors.GridMismatch, match=f"^{name} is on a grid of"):
            call(other)


def test_number_as_relative_displacement_is_rejected(scene):
    with pytest.raises(ss.errors.ArgumentType, match=r"along_x must be .*, got the number 0\.001: for a uniform along_x give Field"):
        ss.tangential.RelativeDisplacement(1e-3, 0.0, grid=scene.grid)


def test_columns_of_tables_of_points_are_recognised_by_name(scene):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    contact = scene.normal()
    solver = ss.rolling.RollingProblem(scene.bodies, contact, 0.3, creepage_x=1e-5).solver()
    table = pandas.DataFrame({"spin": [0.0], "creepage_x": [0.002], "creepage_y": [0.0]})
    assert solver.creep_forces(table).force[0][0] == pytest.approx(solver.creep_forces([(0.002, 0.0, 0.0)]).force[0][0], rel=1e-6)
    points = pandas.DataFrame({"depth": [5e-5], "x": [1e-5], "y": [0.0]})
    by_name, by_position = (ss.subsurface.at_points(scene.bodies, "one", contact, given) for given in (points, [(1e-5, 0.0, 5e-5)]))
    assert np.array_equal(by_name.von_mises, by_position.von_mises)
    array = table.to_xarray().to_dataarray("name").transpose("index", "name")
    assert array.coords["name"].values.tolist() == ["spin", "creepage_x", "creepage_y"]
    assert solver.creep_forces(array).force[0][0] == pytest.approx(solver.creep_forces(table).force[0][0], rel=1e-6)
    with pytest.raises(ss.errors.ArgumentType, match="points must have the coordinates creepage_x, creepage_y, spin, got a, b, c: rename them"):
        solver.creep_forces(array.assign_coords(name=["a", "b", "c"]))
    with pytest.raises(ss.errors.ArgumentType, match="points must have the columns creepage_x, creepage_y, spin, got .*: rename them"):
        solver.creep_forces(table.rename(columns={"spin": "creepage_x"}))
    pairs = [(1.0, 2.0), (3.0, 4.0)]
    path = ss.history.LoadPath(pairs)
    assert ss.history.LoadPath(pandas.DataFrame(pairs)) == ss.history.LoadPath(pandas.DataFrame(pairs, columns=["x", "y"])) == path
    named = pandas.DataFrame(pairs, columns=["x", "y"])
    turned = xarray.DataArray(np.transpose(pairs), dims=("axis", "step"), coords={"axis": ["x", "y"]})
    for table in (named[["y", "x"]], named.T, turned, turned.T, turned.assign_coords(step=[0.0, 1.0])):
        assert ss.history.LoadPath(table) == path
    with pytest.raises(ss.errors.ArgumentType, match=r"steps must have the columns x, y, got u, v: rename them, or give \.to_numpy"):
        ss.history.LoadPath(pandas.DataFrame(pairs, columns=["u", "v"]))


def test_entries_of_labelled_pairs_are_recognised_by_name():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    expected = ss.LoadStep(shift=(1.0, 2.0))
    pair = collections.namedtuple("pair", "y x")
    for shift in (
        pandas.Series([2.0, 1.0], index=["y", "x"]),
        pandas.Series([1.0, 2.0]),
        pandas.DataFrame({"y": [2.0], "z": [3.0], "x": [1.0]}).iloc[0],
        xarray.DataArray([2.0, 1.0], dims="axis", coords={"axis": ["y", "x"]}),
        xarray.DataArray([1.0, 2.0], dims="axis"),
        np.array((2.0, 1.0), dtype=[("y", float), ("x", float)]),
        np.array([1.0, 2.0]),
        pair(2.0, 1.0),
        [1.0, 2.0],
    ):
        assert ss.LoadStep(shift=shift) == expected, shift
    labels = pandas.Series([2.0, 1.0], index=["y", "x"])
    assert ss.LoadStep(spring=ss.Spring(position=labels, stiffness=1.0)) == ss.LoadStep(spring=ss.Spring(position=(1.0, 2.0), stiffness=1.0))
    assert ss.history.LoadPath(pandas.Series([(1.0, 2.0), (3.0, 4.0)], index=[0.5, 1.0])) == ss.history.LoadPath([(1.0, 2.0), (3.0, 4.0)])
    for index in (["a", "b"], [1, 0], ["x", "x"], ["X", "Y"]):
        message = f"force must have the labels x, y, got {index[0]}, {index[1]}: rename them, or give a tuple"
        with pytest.raises(ss.errors.ArgumentType, match=message):
            ss.LoadStep(force=pandas.Series([2.0, 1.0], index=index))
    with pytest.raises(TypeError, match=r"force must be a pair \(x, y\), got Series of length 3"):
        ss.LoadStep(force=pandas.Series([2.0, 1.0, 3.0]))


def test_coordinates_of_closed_forms_are_combined_by_name():
    xarray = pytest.importorskip("xarray")
    ellipse = ss.analytical.HertzEllipse((ss.Material(213e9, 0.29),) * 2, radius_x=3e-3, radius_y=6e-3, load=FORCE)
    x, y = xarray.DataArray([0.0, 5e-5], dims="x"), xarray.DataArray([0.0, 2e-5], dims="y")
    with pytest.raises(ValueError, match=r"have the dimensions \(x\) and \(y\), .*: broadcast them by xarray.broadcast"):
        ellipse.pressure(x, y)
    both = ellipse.pressure(*xarray.broadcast(x, y))
    assert both.shape == (2, 2) and both[1, 0] == ellipse.pressure(5e-5, 0.0) and ellipse.pressure(x, 0.0)[1] == both[1, 0]
    assert (ellipse.pressure(x, y[0]) == ellipse.pressure(x, 0.0)).all()
    assert (ellipse.pressure(y[0], x) == ellipse.pressure(0.0, x)).all()
    with pytest.raises(TypeError, match="coordinates must be real numbers, got truth values"):
        ellipse.pressure(np.array([True, False]), 0.0)


def test_results_with_equal_content_are_equal(scene):
    history, other = scene.history(), scene.history()
    for one in (history, other):
        one.step(normal_force=FORCE, warn=False)
    assert history.state() == other.state() == pickle.loads(pickle.dumps(history)).state() and history.state() != 1.0
    other.step(force_x=10.0)
    assert history.state() != other.state()
    rolling = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.3, creepage_x=1e-4).solve(warn=False)
    rough = ss.surface.SelfAffine(rms_slope=0.1, seed=1).generate(scene.grid).heights
    surfaces = [ss.surface.level(rough, "plane"), ss.surface.fill_missing(rough), ss.surface.gaussian_filter(rough, s=3e-5)]
    for result in (rolling, *surfaces):
        assert result == pickle.loads(pickle.dumps(result)) and result != history.state()
    assert surfaces[0] != ss.surface.level(rough, "mean")


def test_solver_keeps_axes_and_twist_without_keyword(scene):
    normal, both = scene.normal(), {"model": "vector", "tolerance": 1e-9}
    solver = ss.TangentialProblem(scene.bodies, normal, 0.5, force=(20.0, 10.0), twist=1e-4, **both).solver()
    loads = [({"force_x": 5.0}, {"force": (5.0, 10.0)}), ({"shift_y": 2e-7}, {"force_x": 5.0, "shift_y": 2e-7})]
    for change, whole in loads:
        kept = solver.solve(**change)
        cold = ss.TangentialProblem(scene.bodies, normal, 0.5, twist=1e-4, **whole, **both).solve()
        assert kept.force == pytest.approx(cold.force, rel=1e-6) and kept.shift == pytest.approx(cold.shift, rel=1e-6)
    assert solver.solve(twist=0.0).force == pytest.approx(kept.force, rel=0.2)
    # A rejected load is not kept, and an object replaces the whole load.
    with pytest.raises(ss.errors.BeyondFrictionCapacity):
        solver.solve(force_x=60.0)
    assert solver.solve().force[0] == pytest.approx(5.0)
    assert solver.solve(ss.TangentialLoad(force_y=3.0)).force == pytest.approx((0.0, 3.0), abs=1e-9)
    scalar = ss.TangentialProblem(scene.bodies, normal, 0.5, force_x=20.0).solver()
    with pytest.raises(ss.errors.ObliqueLoad):
        scalar.solve(force_y=10.0)
    assert scalar.solve(force_x=0.0, force_y=10.0).force == pytest.approx((0.0, 10.0))


def test_coefficient_that_replaces_a_capped_law_issues_a_warning(scene):
    capped, normal = ss.Friction(0.5, max_shear_stress=8e8), scene.normal()
    assert capped.max_shear_stress == 8e8 and ss.Friction(0.5).max_shear_stress is None
    message = r"has no max_shear_stress, but the last law had 8e\+08: give Friction\(coefficient, max_shear_stress=8e\+08\) to keep it"
    metals = ss.HalfSpace(scene.grid, (ss.Material(70e9, 0.33), ss.Material(210e9, 0.3)))
    for target in (
        ss.History(scene.bodies, scene.ball, capped),
        ss.TangentialProblem(scene.bodies, normal, capped, force_x=1.0).solver(),
        ss.CoupledProblem(metals, scene.ball, capped, normal_force=FORCE).solver(),
        ss.rolling.RollingProblem(scene.bodies, normal, capped, creepage_x=1e-4).solver(),
        ss.rolling.CoupledRollingProblem(scene.bodies, scene.ball, capped, normal_force=FORCE, creepage_x=1e-4).solver(),
    ):
        assert target.friction == capped
        with pytest.warns(ss.ContactWarning, match=message):
            target.set_friction(0.6)
        assert target.friction == ss.Friction(0.6)
        coefficients = np.full(scene.grid.shape, 0.4)
        coefficients[0, 0] = 0.0
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            target.set_friction(0.6)
            target.set_friction(capped)
            target.set_friction(ss.Friction(0.6))
            target.set_friction(ss.Friction(coefficients, max_shear_stress=8e8, grid=scene.grid))
        with pytest.warns(ss.ContactWarning, match=message):
            target.set_friction(coefficients)


def test_unstated_marks_of_missing_points_are_rejected():
    text = b"1.5,2.5\n-9999,4\n"
    with pytest.raises(ss.errors.Format, match=r"1 number with the value -9999\.0 may mark missing points: set the option missing"):
        ss.io.csv.parse(text, cell=(1.0, 1.0))
    assert np.isnan(ss.io.csv.parse(text, cell=(1.0, 1.0), missing=-9999)[1, 0])
    assert ss.io.csv.parse(text, cell=(1.0, 1.0), missing=np.nan)[1, 0] == -9999.0
    with pytest.raises(ss.errors.Format, match=r"may mark missing points, besides the mark -999\.0: set the option missing to -9999\.0"):
        ss.io.csv.parse(text, cell=(1.0, 1.0), missing=-999)
    for mark in (-9999.0, -3.4028234663852886e38, 9.969209968386869e36):
        for kind in (np.float64, np.float32):
            file = io.BytesIO()
            np.save(file, np.array([[1.5, 2.5], [mark, 4.0]], kind))
            with pytest.raises(ss.errors.Format, match="may mark missing points: set the option missing"):
                ss.io.npy.parse(file.getvalue(), cell=(1.0, 1.0))
            assert np.isnan(ss.io.npy.parse(file.getvalue(), cell=(1.0, 1.0), missing=mark)[1, 0])
            assert ss.io.npy.parse(file.getvalue(), size=(1.0, 1.0), missing=np.nan)[1, 0] == kind(mark)


def test_marks_of_missing_points_of_xarray_are_missing_heights():
    xarray = pytest.importorskip("xarray")
    along = {"y": [0.0, 1.0], "x": [0.0, 1.0]}
    for kind in (np.float64, np.float32):
        for mark in (-9999.0, 1e20):
            for place in ("attrs", "encoding"):
                for name in ("_FillValue", "missing_value"):
                    array = xarray.DataArray(np.array([[1.5, mark], [2.5, 4.0]], kind), along, ("y", "x"))
                    setattr(array, place, {name: mark})
                    field = ss.io.from_xarray(array)
                    assert np.isnan(field[0, 1]) and field[1, 0] == 2.5
                    assert array.values[0, 1] == kind(mark)
    array = xarray.DataArray(np.array([[1, -32768], [-1, 4]], np.int16), along, ("y", "x"), attrs={"missing_value": [-32768, -1]})
    assert np.isnan(ss.io.from_xarray(array).array).tolist() == [[False, True], [True, False]]
    # The marks of packed numbers are no heights.
    array = xarray.DataArray([[1.0, 0.0], [2.0, 4.0]], along, ("y", "x"))
    array.encoding = {"_FillValue": 0, "scale_factor": 0.1}
    assert ss.io.from_xarray(array)[0, 1] == 0.0


def test_labels_of_a_bulk_strain_are_recognised():
    pandas = pytest.importorskip("pandas")
    xarray = pytest.importorskip("xarray")
    grid = ss.Grid.square(4, 1.0)
    bulk = ss.tangential.RelativeDisplacement.bulk_strain
    expected = bulk(grid, [[1e-3, 2e-4], [2e-4, -3e-3]])
    assert bulk(grid, pandas.DataFrame([[1e-3, 2e-4], [2e-4, -3e-3]])) == expected
    for labels in (["x", "y"], ["y", "x"]):
        values = [[1e-3, 2e-4], [2e-4, -3e-3]] if labels[0] == "x" else [[-3e-3, 2e-4], [2e-4, 1e-3]]
        assert bulk(grid, pandas.DataFrame(values, labels, labels)) == expected
        assert bulk(grid, xarray.DataArray(values, {"i": labels, "j": labels}, ("i", "j"))) == expected
    with pytest.raises(TypeError, match="strain must have the labels x and y along both axes, got xx, yy"):
        bulk(grid, pandas.DataFrame([[1e-3, 0.0], [0.0, 0.0]], ["xx", "yy"], ["xx", "yy"]))


def test_relative_displacement_in_two_units_is_rejected():
    grid = ss.Grid.square(4, 1.0)
    along = {unit: ss.Field(grid, np.ones(grid.shape), unit) for unit in ("um", "mm")}
    with pytest.raises(ValueError, match="have the units um and mm"):
        ss.tangential.RelativeDisplacement(along["um"], along["mm"])
    ss.tangential.RelativeDisplacement(along["um"], along["um"])


def solvers_of(scene, gap):
    """Returns objects whose gap can be replaced, each with its function that replaces it."""
    normal = ss.NormalSolver(scene.bodies, gap, force=FORCE)
    coupled = ss.CoupledProblem(scene.bodies, gap, 0.5, normal_force=FORCE).solver()
    rolling = ss.rolling.CoupledRollingProblem(scene.bodies, gap, 0.5, normal_force=FORCE, force_x=0.0).solver()
    unpickled = pickle.loads(pickle.dumps(ss.NormalProblem(scene.bodies, gap, force=FORCE))).solver()
    solvers = [normal, coupled, rolling, unpickled]
    history = ss.History(scene.bodies, gap, 0.5)
    return [(solver, solver.set_gap) for solver in solvers] + [
        (normal, lambda gap: normal.solve(gap=gap)),
        (history, history.set_gap),
    ]


def test_new_gap_in_another_unit_is_rejected(scene):
    in_m = ss.Field(scene.grid, scene.ball, "m")
    in_um = ss.Field(scene.grid, 1e6 * scene.ball.array, "um")
    message = r'gap has the unit um, but the last gap had the unit m: give Field\(grid, 1e-6 \* heights, "m"\) if the sides .* in m'
    for solver, set_gap in solvers_of(scene, in_m):
        name = "gap_as_set" if isinstance(solver, ss.History) else "gap"
        before = getattr(solver, name)
        with pytest.raises(ValueError, match=message):
            set_gap(in_um)
        assert np.array_equal(getattr(solver, name), before)
        # A gap without a unit has the unit of the last gap.
        set_gap(2.0 * scene.ball.array)
        with pytest.raises(ValueError, match=message):
            set_gap(in_um)
        set_gap(2.0 * in_m)
    for _, set_gap in solvers_of(scene, scene.ball):
        set_gap(in_m)  # the first unit
        with pytest.raises(ValueError, match=message):
            set_gap(in_um)


def test_gap_of_xarray_in_another_unit_is_rejected(scene):
    xarray = pytest.importorskip("xarray")
    history = ss.History(scene.bodies, ss.Field(scene.grid, scene.ball, "m"), 0.5)
    assert history.unit == "m"
    with pytest.raises(ValueError, match="gap has the unit nm, but the last gap had the unit m"):
        history.set_gap(xarray.DataArray(1e9 * scene.ball.array, dims=("y", "x"), attrs={"units": "nm"}))
    assert ss.History.from_state(scene.bodies, history.state()).unit == "m"
    assert ss.History.from_bytes(scene.bodies, history.to_bytes()).unit is None


def test_history_of_adaptive_contact_has_unit_of_its_gap(scene):
    gap = ss.Field(scene.grid, scene.ball, "m")
    region = ss.adaptive.Region.rectangle((-0.14e-3, 0.14e-3), (-0.14e-3, 0.14e-3))
    step, target = ss.LoadStep(normal_force=FORCE, force_x=20.0), {"stick_ratio": 0.1}
    options = {"force": FORCE, "friction": 0.5, "first_step": step, "target": target}
    contact = ss.adaptive.AdaptiveProblem(scene.bodies.pair, gap, region, **options).solve(warn=False)
    assert contact.history.unit == "m"
    assert contact.normal.unit == "m"


def test_coupled_solution_has_unit_of_gap(scene):
    ball = ss.Field(scene.grid, scene.ball, unit="m")
    problem = ss.CoupledProblem(scene.bodies, ball, 0.3, normal_force=FORCE, force_x=10.0)
    solution = problem.solve()
    assert solution.normal.unit == problem.solver().solve().normal.unit == pickle.loads(pickle.dumps(solution)).normal.unit == "m"
    plain = ss.CoupledProblem(scene.bodies, scene.ball, 0.3, normal_force=FORCE, force_x=10.0).solve()
    # A solution without a unit is equal to solutions in any unit.
    assert plain.normal.unit is None and plain == solution
    solver = ss.CoupledProblem(scene.bodies, scene.ball, 0.3, normal_force=FORCE, force_x=10.0).solver()
    solver.set_gap(ball)
    assert solver.solve().normal.unit == "m"



def test_wear_depth_in_another_unit_is_rejected(scene):
    in_um = ss.Field(scene.grid, np.ones(scene.grid.shape), "um")
    in_m = ss.Field(scene.grid, np.ones(scene.grid.shape), "m")
    with pytest.raises(ValueError, match="have the units m and um"):
        ss.wear.archard(1e-13, np.ones(scene.grid.shape), in_m, depth=in_um)
    history = ss.History(scene.bodies, ss.Field(scene.grid, scene.ball, "m"), 0.5)
    history.step(normal_force=FORCE, warn=False)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 4)
    loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=FORCE, shift=shift))
    with pytest.raises(ValueError, match="have the units m and um"):
        ss.wear.run(history, loop, lambda history, cycle: 1e-3 * in_um, 10)


@pytest.mark.parametrize("wrong", [-1e-13, np.nan, np.inf])
def test_wear_laws_reject_wrong_coefficients_at_once(wrong):
    several = np.full((3, 2), 1e-13)
    several[1, 1] = wrong
    for law in (ss.wear.EnergyLaw, ss.wear.ArchardLaw, lambda coefficient: ss.wear.ThresholdEnergyLaw(coefficient, 1e5)):
        with pytest.raises(ss.errors.NegativeOrNotFinite, match=f"wear coefficient must be non-negative and finite, got {wrong}"):
            law(wrong)
        for coefficients in (several, ss.Field(ss.Grid(2, 3, 1.0, 1.0), several), several.ravel()):
            with pytest.raises(ss.errors.Sample, match="wear coefficient"):
                law(coefficients)
        law(np.abs(np.nan_to_num(several, posinf=1.0)))
    with pytest.raises(ss.errors.NegativeOrNotFinite, match="threshold"):
        ss.wear.ThresholdEnergyLaw(1e-13, wrong)


def test_operands_of_minimise_belong_to_one_grid():
    grid = ss.Grid(6, 4, 1.0, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()))
    operator, dense = bodies.operator("zz"), ss.dense.DenseOperator.of_half_space(bodies, "zz")
    foreign = ss.Field(ss.Grid(6, 4, 2.0, 2.0), -np.ones(grid.shape))
    own, turned = ss.Field(grid, -np.ones(grid.shape)), -np.ones((6, 4))
    for wrong, error in ((foreign, ss.errors.GridMismatch), (turned, ss.errors.Shape)):
        calls = [
            lambda: ss.cgm.minimise(operator, wrong),  # noqa: B023
            lambda: ss.cgm.minimise(operator, own, start=-wrong),  # noqa: B023
            lambda: ss.cgm.minimise(operator, own, upper=-wrong),  # noqa: B023
            lambda: ss.cgm.minimise(operator, own, diagonal=-wrong),  # noqa: B023
            lambda: ss.cgm.minimise(lambda x: x, own, start=-wrong, lower_bound=1.0),  # noqa: B023
            lambda: dense.minimise(wrong),  # noqa: B023
            lambda: dense.minimise(own, lower=wrong),  # noqa: B023
            lambda: operator(wrong),  # noqa: B023
        ]
        for call in calls:
            with pytest.raises(error):
                call()
    others = ss.HalfSpace(foreign.grid, (ss.Material(1.0, 0.3), ss.Material.rigid()))
    with pytest.raises(ss.errors.GridMismatch, match="preconditioner"):
        ss.cgm.minimise(operator, own, preconditioner=others.preconditioner("zz"))
    expected = ss.cgm.minimise(operator, own).x
    for equal in (own.array, own.array.ravel(), own.array.reshape(-1, 1)):
        assert np.array_equal(ss.cgm.minimise(operator, equal).x, expected)


def test_extensions_that_paraview_does_not_recognise_are_rejected(scene, tmp_path):
    fields = {"gap": scene.ball}
    for name in ("a.vtk", "a", "a.vti.txt"):
        with pytest.raises(ss.errors.ArgumentRange, match=r'path must end in \.vti, .*, got ".*": give ".*a.*\.vti"') as caught:
            ss.io.vti.write(tmp_path / name, fields)
        assert caught.value.argument == "path"
        with pytest.raises(ss.errors.ArgumentRange, match=r"path must end in \.pvd"):
            ss.io.pvd.PvdWriter(tmp_path / name)
    for name, proposed in (("F=0.5", "F=0.5.vti"), ("F=0.5.vtk", "F=0.5.vti"), ("a", "a.vti")):
        with pytest.raises(ss.errors.ArgumentRange, match=f'{re.escape(name)}": give ".*{re.escape(proposed)}"'):
            ss.io.vti.write(tmp_path / name, fields)
    assert not list(tmp_path.iterdir())
    ss.io.vti.write(tmp_path / "A.VTI", fields)


def test_operations_on_fields_warn_of_results_that_are_not_finite_as_numpy_does():
    grid = ss.Grid(2, 2, 1.0, 1.0)
    values = np.array([[-1.0, 0.0], [4.0, np.nan]])
    field = ss.Field(grid, values)
    calls = [
        lambda operand: operand / 0.0,
        lambda operand: 1.0 / operand,
        lambda operand: operand / operand,
        lambda operand: operand**0.3,
        lambda operand: operand**-1.5,
        lambda operand: 1e308 * operand,
        lambda operand: 1e308**operand,
        lambda operand: operand + np.inf,
        lambda operand: operand / 2.0 - 1.0,
    ]
    for call in calls:
        found = []
        for operand in (values, field):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                result = call(operand)
            found.append((sorted(str(warning.message) for warning in caught), np.asarray(result)))
            assert all(warning.filename == __file__ for warning in caught)
        assert found[0][0] == found[1][0]
        assert np.array_equal(found[0][1], found[1][1], equal_nan=True)
    with np.errstate(divide="raise"), pytest.raises(FloatingPointError, match="divide by zero"):
        field / 0.0


def test_repeated_loops_and_creepages_in_per_cent_are_warned_of(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    path = ss.history.LoadPath.sine((1e-6, 0.0), 8)
    for count in range(2):
        for shift in path.cycles(1):
            history.step(shift=shift, warn=False)
            cycle.add(history)
        assert ("repeated_loop" in [warning.kind for warning in cycle.warnings]) == (count == 1)
    with pytest.warns(ss.ContactWarning, match="repeat") as issued:
        assert cycle.energy_ratio > 0.0
    assert [warning.message.kind for warning in issued] == ["repeated_loop", "open_cycle"]
    cycle.begin(history)
    for shift in path.cycles(1):
        history.step(shift=shift, warn=False)
        cycle.add(history)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert 0.0 < cycle.energy_ratio < 1.0
    rolling = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.3, creepage_x=0.2).solve(warn=False)
    warned = [str(warning) for warning in rolling.warnings if warning.kind == "large_creepage"]
    assert len(warned) == 1 and warned[0].startswith("creepage and spin move the surfaces by 20 % of the length rolled")
    solver = ss.rolling.RollingProblem(scene.bodies, scene.normal(), 0.3, creepage_x=0.0).solver()
    points = [(0.01, 0.0, 0.0), (0.1, 0.0, 0.0), (0.2, 0.0, 0.0)]
    with pytest.warns(ss.ContactWarning, match="20 % of the length rolled") as issued:
        curve = solver.creep_forces(points)
    assert len(issued) == 1
    assert [[w.kind for w in point.warnings] for point in curve] == [[], ["large_creepage"], ["large_creepage"]]


def test_depth_subtracted_from_the_gap_is_warned_of(scene):
    history, cycle = sheared(scene)
    depth = ss.wear.energy(1e-13, cycle.dissipation)
    state = history.state()
    history.set_gap(scene.ball - depth)
    with pytest.warns(ss.ContactWarning, match="cells that have slipped, and increased in none") as issued:
        step = history.step(normal_force=FORCE, force_x=-20.0)
    assert [warning.message.kind for warning in issued] == ["negative_wear"]
    [remark] = step.warnings
    assert remark.kind == "negative_wear" and remark.cells == np.count_nonzero(depth > 1e-3 * depth.max())
    history.set_state(state)
    history.set_gap(scene.ball + depth)
    assert history.step(normal_force=FORCE, force_x=-20.0).warnings == []


def sheared(scene):
    """Returns a history after a cycle of one step, and the cycle."""
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    history.step(force_x=20.0)
    cycle.add(history)
    return history, cycle


@pytest.mark.parametrize("truth", [True, np.True_, np.array(True)])
def test_truth_values_instead_of_numbers_are_rejected(scene, truth):
    for call in (
        lambda: ss.NormalProblem(scene.bodies, scene.ball, force=truth),
        lambda: scene.history().step(shift_x=truth),
        lambda: ss.Friction(truth),
        lambda: scene.history(hardness=truth),
        lambda: scene.history().set_friction(truth),
        lambda: ss.Field(scene.grid, truth),
        lambda: ss.LoadStep(spring_x=ss.Spring(position=truth, stiffness=1.0)),
        lambda: ss.wear.EnergyLaw(truth)(*sheared(scene)),
    ):
        with pytest.raises(TypeError, match="must be a real number, got a truth value"):
            call()
    with pytest.raises(TypeError, match="force must be real numbers, got truth values"):
        ss.LoadStep(force=(truth, truth))
    with pytest.raises(TypeError, match="form must be 'mean', 'plane' or the degree of a polynomial, got .*True"):
        ss.surface.level(scene.ball, truth)
    for call in (lambda: ss.Grid(truth, 3, 1.0, 1.0), lambda: ss.set_num_threads(truth), lambda: ss.Settings(max_iterations=truth)):
        with pytest.raises(ss.errors.ArgumentType, match="must be a whole number, got a truth value"):
            call()


def test_functions_with_wrong_number_of_parameters_are_rejected_before_work(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 8)
    loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=FORCE, shift=shift))

    class OldLaw:
        def depth_of_jump(self, history, cycle, cycles):
            return cycle.dissipation

    for call, message in (
        (lambda: ss.history.FrettingLoop(path, lambda x, y: ss.LoadStep(shift=(x, y))), r"load must accept one argument by position \(value\), .* \(x, y\)"),
        (lambda: loop.run(history, 1, lambda cycle: None), r"observer must accept 2 arguments by position \(history, cycle\), .* \(cycle\)"),
        (lambda: loop.run(history, 1, progress=lambda: None), r"progress must accept 2 arguments by position \(cycles, cycle\)"),
        (lambda: ss.wear.run(history, loop, lambda cycle: cycle.dissipation, 9), r"law must accept 2 arguments by position \(history, cycle\)"),
        (lambda: ss.wear.run(history, loop, OldLaw(), 9), r"law\.depth_of_jump must accept 4 arguments by position"),
        (lambda: ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 9, progress=lambda: None), "progress must accept one argument"),
    ):
        with pytest.raises(ss.errors.ArgumentType, match=message):
            call()
    assert history.steps == 1
    assert loop.run(history, 1, lambda *arguments: None, progress=lambda *arguments: None).cycles == 1


def test_shear_does_not_repeat_warnings_of_its_normal_contact(scene):
    def kinds(problem):
        with warnings.catch_warnings(record=True) as issued:
            warnings.simplefilter("always")
            solution = problem.solve()
        return solution, [str(warning.message) for warning in issued]

    contact, pressing = kinds(ss.NormalProblem(scene.bodies, scene.ball, force=1e3))
    assert any("edge of the grid" in message for message in pressing)
    for make in (
        lambda pressure: ss.TangentialProblem(scene.bodies, pressure, 0.5, force_x=100.0),
        lambda pressure: ss.TangentialProblem(scene.bodies, pressure.pressure, 0.5, force_x=100.0),
    ):
        shear, messages = kinds(make(contact))
        all_messages = [str(warning) for warning in shear.warnings]
        is_solved = make(contact).__getnewargs_ex__()[0][1] is contact
        assert messages == [message for message in all_messages if not (is_solved and message in pressing)]
        assert set(pressing) & set(all_messages)


@pytest.mark.parametrize(
    ("message", "call"),
    [
        (r"io\.csv\.read takes the sides by keyword, got Grid\(.* give cell=\(dx, dy\)", lambda scene: ss.io.csv.read("a.csv", scene.grid)),
        (r"io\.csv\.parse takes the sides by keyword", lambda scene: ss.io.csv.parse(b"1 2\n3 4\n", (1.0, 1.0))),
        (r"io\.npy\.read takes the sides by keyword", lambda scene: ss.io.npy.read("a.npy", scene.grid)),
        (r"io\.npy\.parse takes the sides by keyword", lambda scene: ss.io.npy.parse(b"", scene.grid)),
        (r"io\.npy\.grid takes the sides by keyword", lambda scene: ss.io.npy.grid("a.npy", scene.grid)),
        (r"Friction takes arguments .* got 400000000.0 by position: give max_shear_stress=",
            lambda scene: ss.Friction(0.5, 400e6)),
        (r"NormalSolver\.solve takes its load by keyword, got 50\.0 by position: give force= or approach=", lambda scene: presser(scene).solve(50.0)),
        (r"NormalSolver\.set_load takes its load by keyword, got 50\.0 by position", lambda scene: presser(scene).set_load(50.0)),
    ],
)  # fmt: skip
def test_arguments_by_position_name_their_keywords(scene, message, call):
    with pytest.raises(TypeError, match=message):
        call(scene)


def presser(scene):
    return ss.NormalSolver(scene.bodies, scene.ball, force=10.0)
