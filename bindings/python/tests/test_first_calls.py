"""Objects and files that a first program gives in a wrong form: messages name the value and the remedy."""

import bz2
import gzip
import os
import re

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE

pandas = pytest.importorskip("pandas")


def with_hole(scene, value):
    """Returns the gap as a table whose entry in row 3 and column 5 is a missing value."""
    gap = pandas.DataFrame(np.array(scene.ball)).astype("Float64")
    gap.iloc[3, 5] = value
    return gap


def test_missing_values_of_pandas_are_missing_points(scene):
    table = with_hole(scene, pandas.NA)
    for given in (table, table.to_numpy(), table.to_numpy().tolist()):
        field = ss.Field(scene.grid, given)
        assert np.isnan(field[3, 5]) and np.isnan(field).sum() == 1 and field[3, 6] == scene.ball[3, 6]
        with pytest.raises(ss.errors.Sample, match=r"gap at row 3, column 5 .* is nan.* \(surface.fill_missing fills missing heights\)"):
            ss.NormalProblem(scene.bodies, given, force=FORCE)
        with pytest.raises(ss.errors.Sample, match="row 3, column 5"):
            scene.history().set_gap(given)
        assert ss.surface.fill_missing(field).heights.max() < np.inf
        with pytest.raises(ss.errors.Sample, match="row 3, column 5"):
            ss.wear.energy(1e-13, given, grid=scene.grid)
        with pytest.raises(ss.errors.Sample, match="row 3, column 5"):
            ss.Friction(given, grid=scene.grid)
    assert ss.Field(scene.grid, with_hole(scene, 0.5))[3, 5] == 0.5
    pressure = scene.hertz.pressure(pandas.array([0.0, pandas.NA], dtype="Float64"))
    assert pressure[0] > 0.0 and np.isnan(pressure[1])


@pytest.mark.parametrize("missing", [pandas.NA, pandas.NaT])
def test_missing_number_is_named(scene, missing):
    named = f"got the missing value {missing} \\(replace or remove missing values\\)"
    for call, argument in (
        (lambda: ss.NormalProblem(scene.bodies, scene.ball, force=missing), "force"),
        (lambda: ss.Material(213e9, missing), "poisson_ratio"),
        (lambda: ss.Grid(missing, 4, 1.0, 1.0), "nx"),
        (lambda: ss.Friction(missing), "coefficient of friction"),
        (lambda: ss.TangentialProblem(scene.bodies, scene.normal(), missing, force_x=1.0), "coefficient of friction"),
        (lambda: ss.LoadStep(force=(1.0, missing)), r"force must be a pair \(x, y\)"),
        (lambda: ss.history.LoadPath([(0.0, 1.0), (missing, 2.0)]), "steps must be a sequence of pairs"),
        (lambda: ss.surface.crop(scene.ball, (0, missing), (0, 4)), "columns must be a pair"),
        (lambda: scene.ball + missing, "other field"),
    ):
        with pytest.raises(TypeError, match=f"{argument}.*{named}"):
            call()


def test_bytes_of_any_kind_are_read(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    state, matrix, points = history.state(), b"1,2\n3,7\n", b"0 0 1\n1 0 2\n0 1 3\n1 1 7\n"
    array, surface = ss.io.npy.to_bytes(scene.ball), ss.io.sdf.to_bytes(scene.ball, unit="m")
    for read, content in (
        (lambda content: ss.History.from_bytes(scene.bodies, content).to_bytes(), history.to_bytes()),
        (ss.history.State.from_bytes, state.to_bytes()),
        (lambda content: ss.io.csv.parse(content, cell=(1.0, 1.0)), matrix),
        (lambda content: ss.io.npy.parse(content, cell=(1.0, 1.0)), array),
        (ss.io.xyz.parse, points),
        (ss.io.sdf.parse, surface),
    ):
        whole = read(content)
        assert whole == read(bytearray(content)) == read(memoryview(content)) == read(memoryview(content[::-1])[::-1])
        for wrong, found in ((content.decode("latin-1"), r"str: convert text by text.encode\(\)"), (list(content), "list")):
            with pytest.raises(ss.errors.ArgumentType, match=f"bytes must be bytes, got {found}"):
                read(wrong)


@pytest.mark.parametrize(("number", "found"), [(3.0, "3.0"), (3.5, "3.5"), (np.float64(1e30), "1e\\+30"), (np.float32(2.5), "2.5")])
def test_fractional_count_of_cells_is_named(scene, number, found):
    for call in (lambda: ss.surface.crop(scene.ball, (0, number), (0, 4)), lambda: ss.surface.crop(scene.ball, (0, 4), (number, 9))):
        with pytest.raises(TypeError, match=rf"must be a pair \(first, end\) of whole numbers, got {found}: give a number of cells as an int"):
            call()
    with pytest.raises(ss.errors.ArgumentType, match=f"nx must be a whole number, got {found}"):
        ss.Grid(number, 4, 1.0, 1.0)


def test_grid_in_another_unit_is_named(scene):
    micrometres = ss.Field(ss.Grid(64, 64, 1e6 * scene.grid.dx, 1e6 * scene.grid.dy), 1e6 * np.array(scene.ball), "um")
    with pytest.raises(ss.errors.GridMismatch, match=r"different units, convert the surface by surface.to_unit"):
        ss.NormalProblem(scene.bodies, micrometres, force=FORCE)
    assert ss.NormalProblem(scene.bodies, micrometres.to_unit("m"), force=FORCE).solve().force == pytest.approx(FORCE)
    for other in (ss.Grid(64, 64, scene.grid.dx, 10.0 * scene.grid.dy), ss.Grid(32, 64, 1e6 * scene.grid.dx, 1e6 * scene.grid.dy)):
        with pytest.raises(ss.errors.GridMismatch, match=r"\]$"):
            ss.NormalProblem(scene.bodies, ss.Field(other, 1.0), force=FORCE)


def test_wrong_entry_of_a_pair_is_named():
    with pytest.raises(TypeError, match=r"force must be a pair \(x, y\), got None as an entry"):
        ss.LoadStep(force=(1.0, None))
    with pytest.raises(TypeError, match=r"force must be a pair \(x, y\), got tuple of length 3"):
        ss.LoadStep(force=(1.0, 2.0, 3.0))


def test_image_of_plain_arrays_asks_for_the_grid(scene):
    pressure = np.array(scene.normal().pressure)
    for fields in ({"pressure": pressure}, {"traction": (pressure, pressure)}):
        with pytest.raises(TypeError, match=r"give grid= .*or create a Field by Field\(grid, array\)"):
            ss.io.vti.to_bytes(fields)
        assert ss.io.vti.to_bytes(fields, grid=scene.grid)
    with pytest.raises(TypeError, match="the names of the fields must be text, got int"):
        ss.io.vti.to_bytes({1: scene.ball})
    with pytest.raises(TypeError, match="a vector must have two components, got 3"):
        ss.io.vti.to_bytes({"normal": (scene.ball, scene.ball, scene.ball)})


def test_compressed_file_is_named_and_read_after_decompression(tmp_path):
    text = b"1.5,2.5\n3.5,7.5\n"
    for name, compress in (("gzip", gzip.compress), ("bzip2", bz2.compress)):
        file = tmp_path / f"heights.{name}"
        file.write_bytes(compress(text))
        for read in (ss.io.xyz.read, ss.io.asc.read, ss.io.sdf.read, ss.io.sur.read, ss.io.x3p.read, ss.io.read):
            with pytest.raises(ss.errors.Format, match=f"heights.{name}: .*are compressed by {name}: decompress them first"):
                read(file)
        for read in (ss.io.csv.read, ss.io.npy.read):
            with pytest.raises(ss.errors.Format, match=f"are compressed by {name}: decompress them first"):
                read(file, cell=(1.0, 1.0))
    with gzip.open(tmp_path / "heights.gzip") as opened:
        assert ss.io.csv.parse(opened.read(), cell=(1.0, 1.0)) == ss.io.csv.parse(text, cell=(1.0, 1.0))
    np.savez(tmp_path / "heights.npz", heights=np.ones((2, 2)))
    with pytest.raises(ss.errors.Format, match=r"heights.npz: .*NPZ file: save one array by numpy.save"):
        ss.io.npy.read(tmp_path / "heights.npz", cell=(1.0, 1.0))


@pytest.mark.parametrize(("shape", "remedy"), [((2, 4, 5), r"save one plane, such as array\[0\]"), ((5,), "reshape it to two axes"), ((), "reshape")])
def test_array_file_without_two_axes_states_shape_and_remedy(tmp_path, shape, remedy):
    np.save(tmp_path / "array.npy", np.zeros(shape))
    for read in (ss.io.npy.read, ss.io.npy.grid):
        with pytest.raises(ss.errors.Format, match=rf"the array has the shape {re.escape(str(shape))}, expected \(ny, nx\): {remedy}"):
            read(tmp_path / "array.npy", cell=(1.0, 1.0))


def test_files_in_an_absent_folder_raise_the_same_error(scene, tmp_path):
    history = scene.history()
    history.step(normal_force=FORCE)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 4)
    loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=FORCE, shift=shift))
    snapshot = ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 5).snapshot
    for write, name in (
        (history.save, "a.state"), (snapshot.save, "a.npz"), (lambda file: ss.io.csv.write(file, scene.ball), "a.csv"),
        (lambda file: ss.io.npy.write(file, scene.ball), "a.npy"), (lambda file: ss.io.sdf.write(file, scene.ball, unit="m"), "a.sdf"),
        (lambda file: ss.io.vti.write(file, history), "a.vti"), (ss.io.pvd.PvdWriter, "a.pvd"),
    ):  # fmt: skip
        file = tmp_path / "absent" / name
        with pytest.raises(ss.errors.File, match=f"^{re.escape(str(file))}: No such file or directory") as refused:
            write(file)
        assert refused.value.filename == refused.value.path == str(file) and refused.value.errno == 2
    # A folder is not replaced, and a failed call leaves no file.
    with pytest.raises(ss.errors.File, match=re.escape(str(tmp_path))):
        snapshot.save(tmp_path)
    assert os.listdir(tmp_path) == [] and not list(tmp_path.parent.glob(f"{tmp_path.name}.*"))


@pytest.mark.skipif(os.name == "nt", reason="links require a privilege")
def test_snapshot_follows_a_link(scene, tmp_path):
    history = scene.history()
    history.step(normal_force=FORCE)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 4)
    loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=FORCE, shift=shift))
    snapshot = ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 5).snapshot
    (tmp_path / "folder").mkdir()
    (tmp_path / "link.npz").symlink_to(tmp_path / "folder" / "whole.npz")
    snapshot.save(tmp_path / "link.npz")
    assert (tmp_path / "link.npz").is_symlink()
    assert ss.wear.WearSnapshot.load(tmp_path / "folder" / "whole.npz").cycles == snapshot.cycles
    whole = tmp_path / "folder" / "whole.npz"
    whole.chmod(0o600)
    snapshot.save(tmp_path / "link.npz")
    assert whole.stat().st_mode & 0o777 == 0o600 and [file.name for file in (tmp_path / "folder").iterdir()] == ["whole.npz"]
    with pytest.raises(ss.errors.File, match="/dev/null: the path is not a regular file"):
        snapshot.save("/dev/null")


def test_decimal_commas_between_commas_are_rejected():
    with pytest.raises(ss.errors.Format, match=r'"05" in column 2 begins with a zero.*decimal commas, separate the cells by semicolons'):
        ss.io.csv.parse(b"0,05,1,5\n0,75,1,25\n", cell=(1.0, 1.0))
