"""Units of relative displacements, states, images and plots, and arguments that are truth values."""

import pickle

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE

RELATIVE = r'relative displacement has the unit um, but {} has the unit mm: give Field\(grid, 0.001 \* samples, "mm"\)'


def pattern(scene, unit):
    fields = [ss.Field(scene.grid, value * np.ones(scene.grid.shape), unit) for value in (1e-3, 0.0)]
    return ss.tangential.RelativeDisplacement(*fields)


def gap(scene, unit):
    return ss.Field(scene.grid, scene.ball, unit)


def test_relative_displacement_in_another_unit_than_the_gap_is_rejected(scene):
    in_um, in_mm, plain = pattern(scene, "um"), pattern(scene, "mm"), pattern(scene, None)
    of_gap = RELATIVE.format("the gap")
    with pytest.raises(ValueError, match=of_gap):
        ss.History(scene.bodies, gap(scene, "mm"), 0.5, relative_displacement=in_um)
    with pytest.raises(ValueError, match=of_gap):
        ss.CoupledProblem(scene.bodies, gap(scene, "mm"), 0.5, normal_force=FORCE, relative_displacement=in_um)
    history = ss.History(scene.bodies, gap(scene, "mm"), 0.5, relative_displacement=in_mm)
    before = history.to_bytes()
    with pytest.raises(ValueError, match=of_gap):
        history.set_relative_displacement(in_um)
    assert history.to_bytes() == before
    for other in (in_mm, plain):
        history.set_relative_displacement(other)
        ss.History(scene.bodies, gap(scene, None), 0.5, relative_displacement=other)


def test_history_keeps_the_unit_of_a_relative_displacement_if_its_gap_has_none(scene):
    in_um = pattern(scene, "um")
    constructed = ss.History(scene.bodies, gap(scene, None), 0.5, relative_displacement=in_um)
    changed = ss.History(scene.bodies, gap(scene, None), 0.5)
    changed.set_relative_displacement(in_um)
    for history in (constructed, changed):
        assert history.unit == "um"
        with pytest.raises(ValueError, match="gap has the unit mm"):
            history.set_gap(gap(scene, "mm"))
        history.set_gap(gap(scene, "um"))


def test_tangential_solver_keeps_the_unit_of_relative_displacements(scene):
    problem = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, relative_displacement=pattern(scene, "mm"))
    for known in (problem, pickle.loads(pickle.dumps(problem))):
        solver = known.solver()
        with pytest.raises(ValueError, match=RELATIVE.format("the last one")):
            solver.set_relative_displacement(pattern(scene, "um"))
        solver.set_relative_displacement(pattern(scene, "mm"))


def test_relative_displacement_has_and_keeps_its_unit(scene):
    in_um = pattern(scene, "um")
    assert in_um.unit == pickle.loads(pickle.dumps(in_um)).unit == "um" and pattern(scene, None).unit is None
    assert in_um == pattern(scene, None) == pattern(scene, "mm") and in_um != pattern(scene, "mm")


def test_wear_laws_reject_energies_and_depths_of_different_units(scene):
    in_um, in_m = (ss.Field(scene.grid, np.ones(scene.grid.shape), unit) for unit in ("um", "m"))
    for call in (
        lambda: ss.wear.energy(1e-13, in_m, depth=in_um),
        lambda: ss.wear.threshold_energy(1e-13, 0.0, in_m, in_um),
        lambda: ss.wear.threshold_energy(1e-13, 0.0, in_m, in_m, depth=in_um),
    ):
        with pytest.raises(ValueError, match="have the units m and um"):
            call()
    assert ss.wear.energy(1e-13, in_m, depth=in_m).shape == scene.grid.shape


def test_state_of_a_history_in_another_unit_is_rejected(scene):
    in_m, in_um, plain = (ss.History(scene.bodies, gap(scene, unit), 0.5) for unit in ("m", "um", None))
    in_m.step(normal_force=FORCE)
    state, before = in_m.state(), in_um.to_bytes()
    with pytest.raises(ValueError, match="state has the unit m, but the gap of the history has the unit um: continue by History.from_state"):
        in_um.set_state(state)
    assert in_um.unit == "um" and in_um.to_bytes() == before
    plain.set_state(state)
    assert plain.unit == state.unit == "m"
    read = ss.history.State.from_bytes(state.to_bytes())
    assert read.unit is None and read == state
    in_m.set_state(read)
    assert in_m.unit == "m"


def test_images_reject_fields_of_different_units(scene, tmp_path):
    with pytest.raises(ValueError, match="have the units m and um"):
        ss.io.vti.write(tmp_path / "a.vti", {"a": gap(scene, "m"), "b": gap(scene, "um")})
    with pytest.raises(ValueError, match="have the units m and um"):
        ss.io.vti.to_bytes({"a": (gap(scene, "m"), gap(scene, "um"))})
    assert not list(tmp_path.iterdir())
    assert ss.io.vti.to_bytes({"a": gap(scene, "m"), "b": scene.ball.array, "c": gap(scene, "m")}, grid=scene.grid)


@pytest.mark.parametrize(("name", "proposed"), [("a.vti.gz", "a.vti"), (".vti", "fields.vti"), ("a.png", "a.vti"), ("a0.5", "a0.5.vti")])
def test_proposed_name_of_an_image_has_one_ending(scene, tmp_path, name, proposed):
    with pytest.raises(ss.errors.ArgumentRange) as caught:
        ss.io.vti.write(tmp_path / name, scene.ball)
    assert str(caught.value).endswith(f'give "{tmp_path / proposed}"')


def test_proposed_name_of_a_series_has_one_ending(tmp_path):
    with pytest.raises(ss.errors.ArgumentRange, match=r'give ".*fields\.pvd"'):
        ss.io.pvd.PvdWriter(tmp_path / ".pvd")


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("warn", lambda scene, flag: scene.history().step(normal_force=FORCE, warn=flag)),
        ("warn", lambda scene, flag: ss.NormalProblem(scene.bodies, scene.ball, force=FORCE).solve(warn=flag)),
        ("permanent_set", lambda scene, flag: scene.history(hardness=1e9, permanent_set=flag)),
        ("periodic", lambda scene, flag: ss.surface.parameters(scene.ball, periodic=flag)),
        ("cropped", lambda scene, flag: ss.surface.SelfAffine(rms_height=1e-7, seed=1, cropped=flag)),
        ("next_step", lambda scene, flag: stepped(scene).stiffness(next_step=flag)),
        ("return_exceptions", lambda scene, flag: ss.History.step_all([scene.history()], [ss.LoadStep(normal_force=FORCE)], return_exceptions=flag)),
    ],
)
def test_truth_values_are_named_and_may_be_those_of_numpy(scene, name, call):
    for wrong, found in (("no", "'no'"), (1, "1"), (None, "None"), (np.ones(3), "ndarray")):
        with pytest.raises(ss.errors.ArgumentType, match=f"^{name} must be True or False, got {found}") as caught:
            call(scene, wrong)
        assert caught.value.argument == name
    call(scene, np.bool_(True))


def stepped(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    return history


def test_missing_value_of_a_table_of_loads_is_named():
    pandas = pytest.importorskip("pandas")
    table = pandas.DataFrame({"x": [1e-6, pandas.NA], "y": [0.0, 0.0]})
    with pytest.raises(TypeError, match="steps must be a sequence of pairs .*, got the missing value <NA>"):
        ss.history.LoadPath(table)


def test_table_of_text_is_rejected_as_text():
    pandas = pytest.importorskip("pandas")
    grid = ss.Grid(4, 4, 1.0, 1.0)
    for text in ("1,5", "1.5"):
        for values in (pandas.DataFrame(np.full((4, 4), text)), np.full((4, 4), text, dtype=object)):
            with pytest.raises(TypeError, match="samples must be real numbers, got text"):
                ss.Field(grid, values)


@pytest.mark.parametrize(
    ("values", "found"),
    [
        (np.full((2, 3), "1.5"), "text"),
        (np.full((2, 3), "1.5", dtype=object), "text"),
        (np.ones((2, 3), bool), "truth values"),
        (np.ones((2, 3), complex), "complex"),
        (np.ones((2, 3), "m8[s]"), "times"),
    ],
)
def test_array_of_xarray_must_contain_real_numbers(values, found):
    xarray = pytest.importorskip("xarray")
    coordinates = {"y": [0.0, 1.0], "x": [0.0, 1.0, 2.0]}
    with pytest.raises(ss.errors.ArgumentType, match=f"the heights must be real numbers, got {found}"):
        ss.io.from_xarray(xarray.DataArray(values, coordinates, ("y", "x")))
    along = values[0].astype("M8[s]") if found == "times" else values[0]
    with pytest.raises(ss.errors.ArgumentType, match=f"the coordinates along x must be real numbers, got {found}"):
        ss.io.from_xarray(xarray.DataArray(np.ones((2, 3)), {"y": [0.0, 1.0], "x": along}, ("y", "x")))


def test_dataset_of_a_history_has_the_unit_of_its_lengths(scene):
    pytest.importorskip("xarray")
    history = ss.History(scene.bodies, gap(scene, "m"), 0.5)
    history.step(normal_force=FORCE)
    for dataset in (ss.io.to_xarray(history), ss.io.to_xarray(history.state())):
        named = {name for name, variable in dataset.variables.items() if variable.attrs.get("units") == "m"}
        assert {"x", "y", "unloaded_gap", "slip_x", "accumulated_slip"} <= named
        assert not named & {"pressure", "traction_x", "zones", "contact", "accumulated_dissipation"}


def test_object_without_heights_is_no_topography():
    with pytest.raises(ss.errors.ArgumentType, match=r"topography must have heights\(\) and physical_sizes, .* ndarray: create a Field"):
        ss.surface.from_topography(np.zeros((4, 4)))


def test_normal_solution_has_the_unit_of_its_gap(scene):
    in_mm = gap(scene, "mm")
    problem = ss.NormalProblem(scene.bodies, in_mm, force=FORCE)
    solver = problem.solver()
    history = ss.History(scene.bodies, in_mm, 0.5)
    history.step(normal_force=FORCE)
    for solution in (problem.solve(), solver.solve(), history.normal, history.state().normal):
        assert solution.unit == "mm" and pickle.loads(pickle.dumps(solution)).unit == "mm"
    with pytest.raises(ss.errors.NotConverged) as caught:
        ss.NormalProblem(scene.bodies, in_mm, force=FORCE, tolerance=1e-9).solve(progress=lambda iteration: False)
    assert caught.value.last_iterate.unit == "mm"
    plain = scene.normal()
    assert plain.unit is None and plain == problem.solve()
    assert problem.solve() != ss.NormalProblem(scene.bodies, gap(scene, "um"), force=FORCE).solve()
    unknown = ss.NormalSolver(scene.bodies, scene.ball, force=FORCE)
    assert unknown.solve().unit is None and unknown.solve(gap=in_mm).unit == "mm"


def test_relative_displacement_in_another_unit_than_the_normal_solution_is_rejected(scene):
    normal = ss.NormalProblem(scene.bodies, gap(scene, "mm"), force=FORCE).solve()
    message = RELATIVE.format("the gap of the normal solution")
    with pytest.raises(ValueError, match=message):
        ss.TangentialProblem(scene.bodies, normal, 0.5, relative_displacement=pattern(scene, "um"))
    solver = ss.TangentialProblem(scene.bodies, normal, 0.5, relative_displacement=pattern(scene, None)).solver()
    with pytest.raises(ValueError, match=message):
        solver.set_relative_displacement(pattern(scene, "um"))
    solver.set_relative_displacement(pattern(scene, "mm"))
    with pytest.raises(ValueError, match="gap has the unit um, but the last gap had the unit mm"):
        solver.set_pressure(ss.NormalProblem(scene.bodies, gap(scene, "um"), force=FORCE).solve())
    solver.set_pressure(scene.normal())
    later = ss.TangentialProblem(scene.bodies, scene.normal(), 0.5, relative_displacement=pattern(scene, "um")).solver()
    with pytest.raises(ValueError, match=message):
        later.set_pressure(normal)


def test_rolling_solver_rejects_gaps_in_another_unit(scene):
    def presser(unit):
        return ss.NormalSolver(scene.bodies, gap(scene, unit), force=FORCE)

    solver = ss.rolling.RollingProblem(scene.bodies, presser("mm").solve(), 0.3, creepage_x=1e-4).solver()
    for change in (lambda: solver.set_normal_solver(presser("um")), lambda: solver.set_pressure(presser("um").solve())):
        with pytest.raises(ValueError, match="gap has the unit um, but the last gap had the unit mm"):
            change()
    solver.set_normal_solver(presser("mm"))
    solver.set_pressure(presser(None).solve())


def test_plot_and_dataset_of_a_normal_solution_have_the_unit_of_its_gap(scene):
    pyplot = pytest.importorskip("matplotlib.pyplot")
    pytest.importorskip("xarray")
    normal = ss.NormalProblem(scene.bodies, gap(scene, "m"), force=FORCE).solve()
    for solution, factor in ((normal, 1e6), (scene.normal(), 1.0)):
        axes = ss.plot.pressure_map(solution, length_unit="um")
        assert axes.get_xlim() == pytest.approx([factor * edge for edge in scene.grid.extent[:2]])
    pyplot.close("all")
    dataset = ss.io.to_xarray(normal)
    assert dataset.gap.attrs["units"] == dataset.x.attrs["units"] == "m" and "units" not in dataset.pressure.attrs


def test_unit_of_one_coordinate_alone_is_rejected():
    xarray = pytest.importorskip("xarray")
    along = np.arange(4) + 0.5
    for known, missing in (("x", "y"), ("y", "x")):
        coordinates = {known: (known, along, {"units": "um"}), missing: (missing, along)}
        array = xarray.DataArray(np.zeros((4, 4)), dims=("y", "x"), coords=coordinates, attrs={"units": "nm"})
        message = f'along {known} have the unit um, those along {missing} have none, and the heights have the unit nm: set array."{missing}'
        with pytest.raises(ValueError, match=message):
            ss.io.from_xarray(array)
        assert ss.io.from_xarray(array.assign_attrs(units="um")).grid == ss.Grid(4, 4, 1.0, 1.0)


POINTS = "".join(f"{x + 0.5} {y + 0.5} {x * y}\n" for y in range(4) for x in range(4))


@pytest.mark.parametrize(
    ("header", "units", "message"),
    [
        ("# X[um] Y[um] Z[nm]", {"unit": "um"}, 'line 1: the header states the unit nm of Z, but the argument unit is um: give height_unit="nm"'),
        ("# X[um] Y[um] Z[nm]", {"unit": "mm"}, 'the unit um of X, but the argument unit is mm: give unit="um"'),
        ("# sample\n# X (\u00b5m), Y (\u00b5m), Z (nm)", {"unit": "um", "height_unit": "mm"}, 'line 2: .* of Z, but the argument height_unit is mm'),
        ("# y [mm] z [um]", {"unit": "um"}, 'the unit mm of Y, but the argument unit is um: give unit="mm"'),
    ],
)
def test_header_of_points_that_contradicts_the_unit_is_rejected(tmp_path, header, units, message):
    path, text = tmp_path / "points.xyz", f"{header}\n{POINTS}"
    path.write_text(text, encoding="utf-8")
    for read in (lambda: ss.io.xyz.read(path, **units), lambda: ss.io.xyz.parse(text.encode(), **units)):
        with pytest.raises(ValueError, match=message):
            read()
    assert ss.io.xyz.read(path).unit is None


def test_header_of_matrix_that_contradicts_the_unit_is_rejected(tmp_path):
    path, text = tmp_path / "matrix.csv", b"# Z [nm]\n1.5 2\n3 4\n"
    path.write_bytes(text)
    sides = {"cell": (1.0, 1.0), "unit": "um"}
    for read in (lambda **units: ss.io.csv.read(path, **sides, **units), lambda **units: ss.io.csv.parse(text, **sides, **units)):
        with pytest.raises(ValueError, match='line 1: the header states the unit nm of Z, .* give height_unit="nm"'):
            read()
        assert read(height_unit="nm").max() == pytest.approx(4e-3)


def test_header_of_points_that_agrees_with_the_unit_is_accepted():
    header = b"# X[um] Y[um] Z[nm]\n"
    assert ss.io.xyz.parse(header + POINTS.encode(), unit="\u00b5m", height_unit="nm").max() == pytest.approx(9e-3)
    for other in (b"# X[px] Y[px] Z[a.u.]\n", b"# max[nm] X Y Z\n", b""):
        assert ss.io.xyz.parse(other + POINTS.encode(), unit="um").unit == "um"
