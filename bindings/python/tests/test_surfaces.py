"""Filters of surfaces, and units of surfaces from files and other packages, which the gap keeps."""

import pickle

import numpy as np
import pytest

import stickslip as ss


def wave(grid, length, unit=None):
    return ss.Field(grid, np.tile(np.sin(2.0 * np.pi * grid.x / length), (grid.ny, 1)), unit)


def test_filter_passes_half_of_wave_and_parts_add_up():
    grid = ss.Grid.square(96, 96.0)
    surface = wave(grid, 12.0) + wave(grid, 48.0)
    filtered = ss.surface.gaussian_filter(surface, s=12.0, l=48.0, periodic=True)
    left = 0.5 * (1.0 - 2.0**-16) * wave(grid, 12.0) + 0.5 * 2.0 ** (-1 / 16) * wave(grid, 48.0)
    assert np.allclose(filtered.heights, left, rtol=0, atol=1e-12)
    assert np.allclose(filtered.heights + filtered.short_waves + filtered.long_waves, surface, rtol=0, atol=1e-12)
    one = ss.surface.gaussian_filter(surface, s=12.0)
    assert one.long_waves is None and one.valid_range == ((6, 90), (6, 90))
    # The surface is constant along y.
    assert np.allclose(ss.surface.gaussian_filter(surface, l=12.0, along="y").heights, 0.0, atol=1e-12)
    rows = ss.surface.gaussian_filter(surface, s=12.0, along="x", periodic=True).heights
    assert np.allclose(rows, ss.surface.gaussian_filter(surface, s=12.0, periodic=True).heights, rtol=0, atol=1e-12)
    with pytest.raises(TypeError, match="give the nesting index"):
        ss.surface.gaussian_filter(surface)
    with pytest.raises(TypeError, match="along must be"):
        ss.surface.gaussian_filter(surface, s=12.0, along="z")
    with pytest.raises(ss.errors.BelowMinimum, match="two cells"):
        ss.surface.gaussian_filter(surface, s=1.5)


def test_filter_keeps_missing_heights():
    grid = ss.Grid.square(32, 32.0)
    heights = np.full((32, 32), 3.0)
    heights[5:9, 7] = np.nan
    filtered = ss.surface.gaussian_filter(ss.Field(grid, heights), s=6.0).heights
    assert np.array_equal(filtered.array, heights, equal_nan=True)


def test_surfaces_keep_unit(tmp_path):
    grid = ss.Grid.square(16, 16.0)
    rough = wave(grid, 8.0, "um")
    made = [
        rough + 1.0, 2.0 - rough, -rough,
        ss.surface.level(rough, "plane").heights, ss.surface.level(rough, "plane").form,
        ss.surface.fill_missing(rough).heights, ss.surface.gaussian_filter(rough, s=4.0).heights,
        ss.surface.gaussian_filter(rough, s=4.0).short_waves, ss.surface.crop(rough, (0, 4), (0, 4)),
        ss.surface.resample(rough, ss.Grid.square(8, 8.0)), ss.surface.inverted(rough), ss.surface.mirror_x(rough),
        ss.surface.gap_from_heights(rough), ss.surface.gap_between(rough, rough), ss.surface.sum([rough, rough]),
        pickle.loads(pickle.dumps(rough)),
    ]  # fmt: skip
    assert [field.unit for field in made] == ["um"] * len(made) and repr(rough).endswith(" um)")
    half = 0.5 * np.ones(grid.shape)
    scaled = [2.0 * rough, rough * half, half * rough, rough * wave(grid, 8.0), wave(grid, 8.0) * rough, rough / 2.0, rough / (half + 1.0),
              np.float64(2.0) * rough, rough - half, wave(grid, 8.0) + rough, abs(rough), +rough]  # fmt: skip
    assert [field.unit for field in scaled] == ["um"] * len(scaled)
    numbers = [rough * rough, rough / rough, 1.0 / (rough + 2.0), wave(grid, 8.0) / (rough + 2.0), rough**2, 2.0**rough]
    assert [field.unit for field in numbers] == [None] * len(numbers)

    other = rough.to_unit("mm")
    other = ss.Field(grid, other.array, "mm")
    for function in (np.add, np.subtract, np.maximum, np.fmin, np.hypot, np.arctan2, np.less, np.equal):
        with pytest.raises(ValueError, match="units um and mm: convert one of them by surface.to_unit"):
            function(rough, other)
        assert np.array_equal(function(rough, rough), function(rough.array, rough.array))
        assert np.array_equal(function(rough, half), function(rough.array, half))
    with pytest.raises(ValueError, match="units um and mm"):
        np.maximum(rough, ss.surface.fill_missing(other))
    for function in (np.multiply, np.divide):
        assert np.array_equal(function(rough, other), function(rough.array, other.array))

    metres = rough.to_unit("m")
    assert metres.unit == "m" and metres.grid.dx == pytest.approx(1e-6) and metres.max() == pytest.approx(1e-6 * rough.max())
    with pytest.raises(ValueError, match="unit of the surface is um"):
        ss.io.sdf.write(tmp_path / "a.sdf", rough)
    without = ss.Field(metres.grid, metres.array)
    for call in (lambda: ss.io.sdf.write(tmp_path / "b.sdf", without), lambda: ss.io.sdf.to_bytes(without)):
        with pytest.raises(ValueError, match="the surface has no unit: give unit='m' if its lengths are metres, or convert it"):
            call()
    assert not (tmp_path / "b.sdf").exists()
    for field, unit, message in ((without, "um", "unit of the surface is um"), (rough, "m", "units um and m"), (without, "ell", "ell is not a unit")):
        with pytest.raises(ValueError, match=message):
            ss.io.sdf.to_bytes(field, unit=unit)
    assert ss.io.sdf.to_bytes(without, unit="m") == ss.io.sdf.to_bytes(metres) == ss.io.sdf.to_bytes(metres, unit="m")
    ss.io.sdf.write(tmp_path / "a.sdf", metres)
    assert ss.io.read(tmp_path / "a.sdf").unit == ss.io.sdf.read(tmp_path / "a.sdf").unit == "m"
    with pytest.raises(ValueError, match="has no unit"):
        wave(grid, 8.0).to_unit("m")
    with pytest.raises(ValueError, match="furlong is not a unit of length"):
        rough.to_unit("furlong")


def test_statistics_have_iso_names_and_skip_missing_heights():
    grid = ss.Grid.square(32, 32.0)
    surface = wave(grid, 8.0) + 0.1 * np.random.default_rng(3).normal(size=grid.shape)
    found = ss.surface.Statistics(surface)
    assert (found.Sa, found.Sq, found.Ssk, found.Sku) == (
        found.arithmetic_mean_height, found.rms_height, found.skewness, found.kurtosis,
    )  # fmt: skip
    assert (found.Sp, found.Sv, found.Sz) == (found.highest_peak, found.deepest_valley, found.height_range)
    assert (found.Sdq, found.Sdr) == (found.finite_difference_rms_slope, found.developed_area_ratio)
    slopes = [np.diff(surface.array, axis=1).ravel(), np.diff(surface.array, axis=0).ravel()]
    assert found.Sdq == pytest.approx(np.sqrt(sum(np.mean(slope**2) for slope in slopes)))
    assert list(found.to_dict())[:3] == ["measured_points", "mean_height", "spectral_rms_slope"]
    assert found.to_dict()["Sq"] == found.Sq and found.measured_points == grid.cells

    heights = surface.array.copy()
    heights[5:9, 7] = np.nan
    holed = ss.surface.Statistics(ss.Field(grid, heights))
    measured = heights[~np.isnan(heights)]
    assert holed.measured_points == grid.cells - 4 == measured.size
    assert holed.mean_height == pytest.approx(measured.mean()) and holed.Sq == pytest.approx(measured.std())
    assert np.isnan(holed.spectral_rms_slope) and holed.Sdq == pytest.approx(found.Sdq, rel=0.05)
    with pytest.raises(ss.errors.Undetermined):
        ss.surface.Statistics(ss.Field(grid, np.nan))


def test_material_ratio_of_gaussian_heights():
    stats = pytest.importorskip("scipy.stats")
    grid = ss.Grid.square(256, 1.0)
    heights = np.random.default_rng(5).normal(scale=2.0, size=grid.shape)
    heights[0, :3] = np.nan
    found = ss.surface.MaterialRatio(ss.Field(grid, heights))
    assert found.measured_points == grid.cells - 3 and found.core_height == found.Sk
    # Sk of a normal distribution is 2.574 standard deviations. The limits of the core are at half of Sk.
    assert found.Sk == pytest.approx(2.574 * 2.0, rel=0.02)
    tail = stats.norm.sf(2.574 / 2)
    assert found.Smr1 == pytest.approx(tail, abs=5e-3) and found.Smr2 == pytest.approx(1.0 - tail, abs=5e-3)
    peak = 2.0 * 2.0 * (stats.norm.pdf(2.574 / 2) / tail - 2.574 / 2)
    assert found.Spk == pytest.approx(peak, rel=0.05) and found.Svk == pytest.approx(peak, rel=0.05)
    ratios = np.array([0.1, 0.5, 0.9])
    assert np.allclose(found.height(ratios), stats.norm.isf(ratios, scale=2.0), atol=0.05)
    assert np.allclose(found.material_ratio(found.height(ratios)), ratios, atol=1e-4)
    assert isinstance(found.height(0.5), float)
    assert set(found.to_dict()) == {"measured_points", "Sk", "Spk", "Svk", "Smr1", "Smr2"}


def test_autocorrelation_of_waves_and_thresholds():
    grid = ss.Grid.square(128, 128.0)
    crossed = ss.Field(grid, np.cos(np.pi * grid.x / 32.0) + np.cos(np.pi * grid.y / 32.0)[:, None], "um")
    found = ss.surface.Autocorrelation(crossed, periodic=True)
    k = np.pi / 32.0
    assert found.Sal == found.decay_length() == pytest.approx(np.sqrt(2.0) * np.arccos(0.2) / k, rel=2e-3)
    assert found.Str == found.texture_aspect_ratio() == pytest.approx(found.Sal * k / np.arccos(-0.6), rel=3e-3)
    assert found.decay_length(0.5) < found.Sal
    lags = found.values
    assert lags.shape == (129, 129) and lags[64, 64] == 1.0
    expected = 0.5 * (np.cos(k * lags.grid.x) + np.cos(k * lags.grid.y)[:, None])
    assert np.allclose(lags, expected, rtol=0, atol=1e-12)
    assert found.to_dict() == {"Sal": found.Sal, "Str": found.Str}
    # A surface with edges has no pairs beyond them.
    assert ss.surface.Autocorrelation(crossed).Sal == pytest.approx(found.Sal, rel=0.1)
    everything = ss.surface.parameters(crossed, periodic=True)
    assert everything["Sal"] == found.Sal and everything["Sq"] == pytest.approx(1.0) and "Smr1" in everything


def test_smooth_surfaces_have_no_outliers_by_default():
    grid = ss.Grid.square(40, 40.0)
    x, y = np.meshgrid(grid.x, grid.y)
    radius = np.hypot(x, y)
    surfaces = (np.sqrt(np.maximum(300.0 - radius**2, 0.0)), np.maximum(x, 0.0), np.sin(0.7 * x) * np.sin(0.5 * y), 1.0 * (radius < 9.0))
    for heights in surfaces:
        assert ss.surface.remove_outliers(ss.Field(grid, heights)).outlier_cells == 0
        heights[5, 7] += 30.0
        found = ss.surface.remove_outliers(ss.Field(grid, heights)).outliers
        assert list(zip(*np.nonzero(found))) == [(5, 7)]


def test_outliers_are_removed_or_interpolated():
    grid = ss.Grid.square(64, 64.0)
    clean = wave(grid, 32.0, "um") + 0.01 * np.random.default_rng(7).normal(size=grid.shape)
    heights = clean.array.copy()
    spikes = [(3, 4), (20, 30), (20, 31), (50, 9)]
    for row, column in spikes:
        heights[row, column] += 2.0
    heights[10, 10] = np.nan
    found = ss.surface.remove_outliers(ss.Field(grid, heights, "um"), threshold=8.0)
    assert sorted(zip(*np.nonzero(found.outliers))) == sorted(spikes) and found.outlier_cells == len(spikes)
    assert found.heights.unit == "um" and np.isnan(found.heights).sum() == len(spikes) + 1
    interpolated = found.interpolated()
    assert interpolated.unit == "um" and np.isnan(interpolated[10, 10]) and np.isnan(interpolated).sum() == 1
    assert np.abs(interpolated - clean)[found.outliers].max() < 0.1
    assert np.array_equal(np.asarray(found), found.heights, equal_nan=True) and repr(found) == "WithoutOutliers(4 outliers)"
    again = pickle.loads(pickle.dumps(found))
    assert np.array_equal(again.outliers, found.outliers) and again.heights.unit == "um"
    with pytest.raises(ss.errors.BelowMinimum, match="radius"):
        ss.surface.remove_outliers(clean, radius=0)


def test_numbers_convert_to_tables(scene):
    pandas = pytest.importorskip("pandas")
    contact = scene.normal()
    series = ss.surface.Statistics(wave(ss.Grid.square(16, 16.0), 8.0)).to_series()
    assert isinstance(series, pandas.Series) and series.name == "Statistics" and series["Sq"] == pytest.approx(0.5**0.5)
    report = contact.report.to_dict()
    assert report["status"] == contact.report.status and report["products"] == contact.report.products
    assert contact.report.to_series()["time"] == contact.report.time
    spots = contact.spots.to_frame()
    assert list(spots.columns)[:2] == ["cells", "area"] and spots["load"].sum() == pytest.approx(contact.force)
    assert np.isnan(spots["stick_ratio"][0]) and spots["centroid_x"][0] == contact.spots[0].centroid[0]
    assert contact.spots[0].to_dict()["centroid_y"] == contact.spots[0].centroid[1]

    points = [(0.0, 0.0, 1e-5), (1e-5, 0.0, 2e-5)]
    stresses = ss.subsurface.at_points(scene.bodies, "one", contact, points)
    frame = stresses.to_frame()
    assert np.array_equal(frame["normal_stress_zz"], stresses.normal_stress[2]) and len(frame) == 2
    assert np.array_equal(frame["shear_stress_xz"], stresses.shear_stress[1])
    assert np.array_equal(frame["displacement_z"], stresses.displacement[2])
    assert np.array_equal(stresses.to_dict()["von_mises"], stresses.von_mises)

    history = scene.history(tolerance=1e-6)
    history.step(normal_force=100.0)
    path = ss.history.LoadPath.triangle((1e-6, 0.0), 4)
    loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=100.0, shift=shift))
    cycle = loop.run(history, 1).last
    frame = cycle.points.to_frame()
    assert np.array_equal(frame["force_x"], cycle.points.force[0]) and len(frame) == 5
    assert cycle.energy.to_dict()["work"] == cycle.energy.work
    # The name in the repr is the path to the number.
    assert f" energy.dissipated_energy={cycle.energy.dissipated_energy:.6g}," in repr(cycle)
    worn = ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 100).history
    assert np.array_equal(worn.to_frame()["cycles"], worn.cycles)


def test_unknown_units_are_rejected(tmp_path):
    grid = ss.Grid.square(4, 4.0)

    class Topography:
        physical_sizes, unit = (4.0, 4.0), "furlong"

        def heights(self):
            return np.zeros((4, 4))

    ss.io.npy.write(tmp_path / "a.npy", ss.Field(grid, 1.0))
    for call in (
        lambda: ss.Field(grid, 1.0, "furlong"),
        lambda: ss.surface.from_topography(Topography()),
        lambda: ss.surface.gap_from_heights(Topography()),
        lambda: ss.io.npy.read(tmp_path / "a.npy", size=(1.0, 1.0), unit="furlong"),
        lambda: ss.io.npy.read(tmp_path / "a.npy", size=(1.0, 1.0), unit="um", height_unit="furlong"),
    ):
        with pytest.raises(ValueError, match="furlong is not a unit of length: the units are km, m, .* and pm"):
            call()
    for unit, metres in [("km", 1e3), ("mm", 1e-3), ("\u03bcm", 1e-6), ("nm", 1e-9), ("\u00c5", 1e-10), ("pm", 1e-12)]:
        assert ss.Field(grid, 1.0, unit).to_unit("m").max() == metres


def test_readers_convert_heights_to_unit_of_lengths(tmp_path):
    heights = np.array([[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]])  # nanometres over cells of micrometres
    grid = ss.Grid(3, 2, 0.5, 0.25)
    rows = [f"{x} {y} {z}\n" for row, y in zip(heights, grid.y) for z, x in zip(row, grid.x)]
    (tmp_path / "a.xyz").write_text("".join(rows))
    ss.io.npy.write(tmp_path / "a.npy", ss.Field(grid, heights))
    ss.io.csv.write(tmp_path / "a.csv", ss.Field(grid, heights))
    for name, options in [("xyz", {}), ("npy", {"cell": (0.5, 0.25)}), ("csv", {"size": (1.5, 0.5)})]:
        module = getattr(ss.io, name)
        file = tmp_path / f"a.{name}"
        for read, source in [(module.read, file), (module.parse, file.read_bytes())]:
            surface = read(source, unit="um", height_unit="nm", **options)
            assert surface.unit == "um" and np.array_equal(surface, heights / 1000.0), name
            assert (surface.grid.dx, surface.grid.dy) == pytest.approx((0.5, 0.25), rel=1e-12)
            assert np.array_equal(read(source, unit="nm", height_unit="um", **options), heights * 1000.0)
            plain = read(source, unit="um", **options)
            assert plain.unit == "um" and np.array_equal(plain, heights)
            assert read(source, **options).unit is None
            with pytest.raises(ValueError, match="units um and nm"):
                surface + ss.Field(grid, 1.0, "nm")
            with pytest.raises(TypeError, match="height_unit= .* give unit= too"):
                read(source, height_unit="nm", **options)
    marked = ss.io.csv.parse(b"1 -999\n3 4\n", cell=(1.0, 1.0), missing=-999.0, unit="um", height_unit="nm")
    assert np.isnan(marked[0, 1]) and marked[1, 1] == 0.004


def test_surfaces_with_different_units_are_rejected():
    grid = ss.Grid.square(16, 16.0)
    one, two, unknown = wave(grid, 8.0, "um"), wave(grid, 8.0, "nm"), wave(grid, 8.0)
    for call in (lambda a, b: a + b, lambda a, b: a - b, ss.surface.gap_between, lambda a, b: ss.surface.sum([a, b])):
        with pytest.raises(ValueError, match="the units um and nm"):
            call(one, two)
        assert call(one, unknown).unit == call(unknown, one).unit == "um"
        assert call(one, wave(grid, 8.0, "\u00b5m")).unit == "um"
    assert one != two and one == unknown


def test_surfaces_convert_to_datasets_and_images(tmp_path):
    pytest.importorskip("xarray")
    grid = ss.Grid(6, 4, 0.5, 1.0)
    rough = ss.surface.SelfAffine(rms_height=0.1, cut_off_wavelength=2.0, seed=0).generate(grid)
    dataset = ss.io.to_xarray(rough)
    assert np.array_equal(dataset.heights, rough.heights) and np.array_equal(dataset.x, grid.x)
    assert dataset.attrs["rms_slope"] == rough.rms_slope and "units" not in dataset.x.attrs
    measured = ss.Field(grid, rough.heights.array, "um")
    levelled, filtered = ss.surface.level(measured, "plane"), ss.surface.gaussian_filter(measured, l=2.5)
    for surface, other in [(levelled, "form"), (filtered, "long_waves")]:
        dataset = ss.io.to_xarray(surface)
        assert dataset.heights.attrs["units"] == dataset.x.attrs["units"] == "um"
        assert np.array_equal(dataset[other], getattr(surface, other))
    filled = ss.io.to_xarray(ss.surface.fill_missing(measured))
    assert filled.attrs["filled_cells"] == 0 and np.array_equal(filled.heights, measured)

    assert ss.io.vti.to_bytes(rough) == ss.io.vti.to_bytes({"heights": rough.heights})
    assert ss.io.vti.to_bytes(measured) == ss.io.vti.to_bytes({"values": measured})
    ss.io.vti.write(tmp_path / "surface.vti", levelled)
    assert (tmp_path / "surface.vti").read_bytes() == ss.io.vti.to_bytes({"heights": levelled.heights, "form": levelled.form})
    series = ss.io.pvd.PvdWriter(tmp_path / "series.pvd")
    series.write(0.0, rough)
    assert len(series) == 1
    for wrong in (1.0, [rough], None):
        with pytest.raises(TypeError, match="expected a solution, a pair .*, a state, a history, a Field, a surface"):
            ss.io.vti.to_bytes(wrong)


def test_random_surface_requires_seed():
    with pytest.raises(TypeError, match="seed"):
        ss.surface.SelfAffine(rms_height=1.0)
    first, other = (ss.surface.SelfAffine(rms_height=1.0, seed=seed).generate(ss.Grid.square(32, 1.0)) for seed in (0, 1))
    assert first != other


def test_xarray_arrays_convert_to_surfaces():
    xarray = pytest.importorskip("xarray")
    heights = np.arange(12.0).reshape(3, 4)
    x, y = 5.0 + 0.5 * np.arange(4), 0.25 * np.arange(3)
    array = xarray.DataArray(heights, {"y": y, "x": x}, ("y", "x"), attrs={"units": "um"})
    field = ss.io.from_xarray(array)
    assert field.grid == ss.Grid(4, 3, 0.5, 0.25) and field.unit == "um" and np.array_equal(field.array, heights)
    assert ss.io.from_xarray(array.T) == field
    dataset = ss.io.to_xarray(field)
    assert dataset["values"].attrs["units"] == dataset.x.attrs["units"] == "um"
    assert ss.io.from_xarray(dataset["values"]) == field
    # The sides of the cells are exact for any grid.
    for cells in (2, 3, 7, 10, 32, 41, 64):
        own = ss.Field(ss.Grid(cells, cells + 1, 0.3e-3 / cells, 0.7 / 3.0 / cells), np.ones((cells + 1, cells)), "m")
        assert ss.io.from_xarray(ss.io.to_xarray(own)["values"]) == own, cells
    with pytest.raises(ValueError, match="1 coordinates along y, which do not determine the side of the cells: create a Field"):
        ss.io.from_xarray(array[:1])
    with pytest.raises(ValueError, match="evenly"):
        ss.io.from_xarray(array.assign_coords(x=x**2))
    with pytest.raises(ValueError, match="dimensions"):
        ss.io.from_xarray(array[0])
    for wrong, message in ((dataset, r'must be a DataArray of xarray, got Dataset: give one of its variables, such as dataset\["values"\]'),
                           (heights, "must be a DataArray of xarray, got ndarray")):  # fmt: skip
        with pytest.raises(ss.errors.ArgumentType, match=message) as caught:
            ss.io.from_xarray(wrong)
        assert caught.value.argument == "array"


def test_units_of_coordinates_of_xarray_are_converted():
    xarray = pytest.importorskip("xarray")

    def array(heights, x, y):
        axis = lambda name, count, unit: (name, 0.5 * np.arange(count), {} if unit is None else {"units": unit})
        coordinates = {"x": axis("x", 4, x), "y": axis("y", 3, y)}
        attributes = {} if heights is None else {"units": heights}
        return xarray.DataArray(np.arange(12.0).reshape(3, 4), coordinates, ("y", "x"), attrs=attributes)

    field = ss.io.from_xarray(array("um", "mm", "nm"))
    assert field.grid == ss.Grid(4, 3, 500.0, 0.5e-3) and field.unit == "um" and field.array[2, 3] == 11.0
    assert ss.io.from_xarray(array("um", None, "um")).grid == ss.Grid(4, 3, 0.5, 0.5)
    assert ss.io.from_xarray(array(None, None, None)).unit is None
    for units in (("furlong", None, None), ("um", "furlong", "mm"), ("um", "mm", "degree")):
        with pytest.raises(ValueError, match="is not a unit of length"):
            ss.io.from_xarray(array(*units))
    with pytest.raises(ValueError, match="the heights have none: set array.attrs"):
        ss.io.from_xarray(array(None, "mm", "mm"))


def test_resampling_to_grid_in_other_unit_is_rejected():
    rough = ss.Field(ss.Grid(32, 24, 1.0, 1.0), np.random.default_rng(0).random((24, 32)), "um")
    with pytest.raises(ValueError, match="smaller than one cell of the heights, .* unit of the heights, in um"):
        ss.surface.resample(rough, ss.Grid(64, 48, 0.5e-6, 0.5e-6))
    assert ss.surface.resample(rough, ss.Grid(64, 48, 0.5, 0.5)).unit == "um"
    # A profile along x lies within one row of the heights.
    assert ss.surface.resample(rough, ss.Grid(64, 1, 0.5, 0.1)).array.shape == (1, 64)


def test_float_labels_of_csv_are_rejected_and_comments_state_missing_values():
    with pytest.raises(ss.errors.Format, match="skip_rows = 1"):
        ss.io.csv.parse(b"0.0,1.0,2.0\n.1,.2,.15\n.3,.1,.2\n", cell=(1.0, 1.0))
    for comment in (b"NODATA_value -9999", b"nodata: -9999", b"missing = -9999", b"void -9999"):
        field = ss.io.csv.parse(b"# " + comment + b"\n.1,-9999\n.3,.1\n", cell=(1.0, 1.0))
        assert np.isnan(field.array[0, 1]) and field.array[1, 1] == 0.1, comment
