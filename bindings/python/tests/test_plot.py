"""Plots of contacts, histories and reports."""

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE

pyplot = pytest.importorskip("matplotlib.pyplot")
pyplot.switch_backend("Agg")
from stickslip import plot  # noqa: E402


def bar(axes):
    """Returns the colour bar of an image."""
    [place] = axes.child_axes
    return place


def drawn(axes):
    """Returns the extent of an artist in the drawn figure."""
    axes.figure.canvas.draw()
    return axes.get_window_extent()


def sheared(scene):
    contact = scene.normal()
    return contact, ss.TangentialProblem(scene.bodies, contact, 0.5, force=(20.0, 10.0), model="vector").solve()


def dissimilar():
    bodies = ss.HalfSpace(ss.Grid.square(16, 0.3), (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))
    problem = ss.CoupledProblem(bodies, ss.surface.sphere(bodies.grid, 3.5), 0.3, normal_force=60.0, force_x=6.0)
    return problem.solve(warn=False)


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


def test_contact_plots_show_fields(scene):
    contact = scene.normal()
    axes = plot.pressure_map(contact, scale=1e3)
    [image] = axes.images
    shown = image.get_array()
    assert shown.count() == contact.contact_cells and shown.max() == contact.pressure.max()
    assert list(image.get_extent()) == [1e3 * edge for edge in scene.grid.extent]
    shear = ss.TangentialProblem(scene.bodies, contact, 0.5, force_x=20.0).solve()
    [image] = plot.stick_map(shear).images
    assert (image.get_array() == shear.zones).all()
    assert plot.field(scene.grid, scene.ball).images
    with pytest.raises(ss.errors.Shape):
        plot.field(scene.grid, [[1.0]])


def test_section_plots_rows_and_columns_of_field(scene):
    contact = scene.normal()
    axes = plot.section(scene.grid, contact.pressure, label="pressure", unit="Pa", scale=1e3, length_unit="mm")
    plot.section(scene.grid, contact.gap, axes, at=1e-4)
    over_centre, off_centre = axes.lines
    assert list(over_centre.get_xdata()) == list(1e3 * scene.grid.x)
    row = abs(scene.grid.y).argmin()
    assert list(over_centre.get_ydata()) == list(contact.pressure[row])
    assert list(off_centre.get_ydata()) == list(contact.gap[abs(scene.grid.y - 1e-4).argmin()])
    column = plot.section(scene.grid, scene.ball, along=ss.Axis.Y, at=-1e-4)
    [line] = column.lines
    assert list(line.get_ydata()) == list(scene.ball.array[:, abs(scene.grid.x + 1e-4).argmin()])
    assert column.get_xlabel() == "y"
    for wrong in ({"at": 1.0}, {"along": "z"}):
        with pytest.raises(ValueError):
            plot.section(scene.grid, scene.ball, **wrong)


def test_axes_have_labels_with_given_units(scene):
    contact = scene.normal()
    axes = plot.pressure_map(contact, scale=1e3, length_unit="mm", value_scale=1e-9, unit="GPa")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (mm)", "y (mm)")
    assert bar(axes).get_ylabel() == "pressure (GPa)"
    assert axes.images[0].get_array().max() == pytest.approx(1e-9 * contact.pressure.max())
    assert plot.field(scene.grid, scene.ball).get_xlabel() == "x"
    cycle = ss.history.Cycle(scene.history())
    axes = plot.hysteresis(cycle, axis="y", length_unit="m", unit="N")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("shift along y (m)", "tangential force along y (N)")
    axes = plot.section(scene.grid, contact.gap, label="gap", value_scale=1e6, unit="µm", scale=1e3, length_unit="mm")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (mm)", "gap (µm)")
    axes = plot.work_precision([contact.report], scale=1e3, unit="ms")
    assert axes.get_ylabel() == "time (ms)" and list(axes.lines[0].get_ydata()) == [1e3 * contact.report.time]
    with pytest.raises(ValueError):
        plot.hysteresis(cycle, axis="z")


def test_history_and_report_plots_show_data(scene):
    history = scene.history()
    history.step(normal_force=FORCE)
    cycle = ss.history.Cycle(history)
    for force in (20.0, -20.0, 20.0):
        history.step(force_x=force)
        cycle.add(history)
    [line] = plot.hysteresis(cycle).lines
    assert list(line.get_ydata()) == pytest.approx([0.0, 20.0, -20.0, 20.0], abs=1e-9)
    assert plot.stick_map(history).images and plot.pressure_map(history.state()).images
    reports = [scene.normal(tolerance=tolerance).report for tolerance in (1e-2, 1e-6)]
    [line] = plot.work_precision({"ball": reports}).lines
    assert list(line.get_xdata()) == [report.energy_error_bound for report in reports]
    pyplot.close("all")


def test_colour_bars_have_height_of_image_and_equal_width(scene):
    contact, shear = sheared(scene)
    planes = ss.subsurface.Planes(scene.bodies, np.linspace(0.0, 5e-5, 3)).solve_all("one", contact)
    figure, axes = pyplot.subplots(2, 3, figsize=(12, 8))
    plot.pressure_map(contact, axes[0, 0])
    plot.stick_map(shear, axes[0, 1])
    plot.traction_map(shear, axes[0, 2])
    plot.spot_map(contact, axes[1, 0])
    plot.field(scene.grid, scene.ball, axes[1, 1])
    plot.stress_section(planes, axes[1, 2])
    assert figure.get_layout_engine() is not None
    left, _ = pyplot.figure().subfigures(1, 2)
    assert plot.field(scene.grid, scene.ball, left.subplots()).images and left.get_layout_engine() is not None
    for picture in axes.flat:
        of_bar, of_picture = drawn(bar(picture)), drawn(picture)
        assert (of_bar.y0, of_bar.y1) == pytest.approx((of_picture.y0, of_picture.y1), abs=1.0)
        assert of_bar.width == pytest.approx(0.05 * of_picture.width, abs=1.0)


def test_texts_do_not_overlap(scene):
    contact, shear = sheared(scene)
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 4))
    plot.pressure_map(contact, axes[0], unit="Pa")
    plot.stick_map(shear, axes[1], length_unit="m")
    plot.work_precision({"ball": [contact.report], "other": [contact.report]}, axes[2])
    figure.canvas.draw()
    renderer = figure.canvas.get_renderer()
    for place in axes:
        inside = place.get_window_extent()
        legend = place.get_legend()
        assert legend is None or not legend.get_window_extent(renderer).overlaps(inside)
        assert not place.texts
    tight = [place.get_tightbbox(renderer) for place in axes]
    assert tight[0].x1 <= tight[1].x0 and tight[1].x1 <= tight[2].x0 and tight[2].x1 <= figure.bbox.x1


def test_texts_are_inside_figure_drawn_once(scene):
    _, shear = sheared(scene)
    grid = ss.Grid.square(64, 0.4)
    bodies = ss.HalfSpace(grid, (ss.Material(210e3, 0.3), ss.Material(210e3, 0.3)))
    contact = ss.NormalProblem(bodies, ss.surface.sphere(grid, 5.0), force=100.0).solve()
    planes = ss.subsurface.Planes(bodies, np.linspace(0.0075, 0.222, 30)).solve_all("one", contact)
    # The spacing of ticks is 0.025 mm after the layout and 0.05 mm before.
    figure, axes = pyplot.subplots(2, 1, figsize=(7, 7))
    for place in axes:
        plot.stress_section(planes, place, length_unit="mm", unit="MPa")
    other, places = pyplot.subplots(2, 2, figsize=(11, 8))
    for place in places.flat:
        plot.stick_map(shear, place, scale=1e3, length_unit="mm")
    for picture, parts in ((figure, axes), (other, places.flat)):
        picture.canvas.draw()
        for place in parts:
            tight, whole = place.get_tightbbox(picture.canvas.get_renderer()), picture.bbox
            assert tight.x0 >= 0.0 and tight.x1 <= whole.x1 and tight.y0 >= 0.0 and tight.y1 <= whole.y1


def test_line_of_cells_is_drawn_as_profile():
    grid = ss.Grid.line(64, 0.02)
    steel = ss.Material(210e3, 0.3)
    bodies = ss.HalfSpace(grid, (steel, steel), boundary=("periodic_along_y", 50.0))
    contact = ss.NormalProblem(bodies, ss.surface.cylinder(grid, 20.0), force=200.0).solve()
    shear = ss.TangentialProblem(bodies, contact, 0.5, force_x=50.0).solve()
    axes = plot.pressure_map(contact, unit="MPa", length_unit="mm", scale=2.0)
    assert not axes.images and axes.get_ylabel() == "pressure (MPa)"
    assert list(axes.lines[0].get_ydata()) == list(contact.pressure[0])
    assert list(axes.lines[0].get_xdata()) == list(2.0 * grid.x)
    axes = plot.traction_map(shear, unit="MPa")
    assert list(axes.lines[0].get_ydata()) == list(shear.traction[0][0]) and axes.get_ylabel() == "shear traction (MPa)"
    axes = plot.stick_map(shear)
    assert list(axes.lines[0].get_ydata()) == list(shear.zones[0])
    assert [label.get_text() for label in axes.get_yticklabels()] == ["separated", "stick", "slip"]
    assert list(plot.spot_map(contact).lines[0].get_ydata(orig=True)[contact.contact[0]]) == [contact.spots[0].mean_pressure] * int(
        contact.contact.sum()
    )


def test_traction_map_shows_magnitude_and_arrows(scene):
    _, shear = sheared(scene)
    axes = plot.traction_map(shear, arrows=8, value_scale=1e-9, unit="GPa")
    size = np.hypot(*shear.traction)
    assert axes.images[0].get_array().max() == pytest.approx(1e-9 * size.max())
    assert bar(axes).get_ylabel() == "shear traction (GPa)"
    [arrows] = axes.collections
    columns = np.flatnonzero(shear.zones.any(axis=0))
    assert 40 < arrows.U.size < 150 and np.ptp(columns) > 8
    assert np.nanmax(np.hypot(arrows.U, arrows.V)) <= size.max()
    assert plot.traction_map(scene.history()).images  # without contact


def test_spot_map_shows_properties(scene):
    x, y = np.meshgrid(scene.grid.x, scene.grid.y)
    gap = np.minimum((x - 0.07e-3) ** 2, (x + 0.07e-3) ** 2 + 1e-12) / 2e-3 + y**2 / 2e-3
    contact = ss.NormalProblem(scene.bodies, gap, force=5.0).solve()
    [image] = plot.spot_map(contact, by="load", unit="N").images
    shown = image.get_array()
    assert set(shown.compressed()) == {spot.load for spot in contact.spots} and shown.count() == contact.contact_cells
    assert plot.spot_map(contact.spots, by="area").images
    for wrong in ("colour", "stick_ratio"):
        with pytest.raises(ValueError, match="stick_ratio"):
            plot.spot_map(contact, by=wrong)


def test_neighbouring_spots_differ_in_colour(scene):
    x, y = np.meshgrid(scene.grid.x, scene.grid.y)
    gap = np.minimum((x - 0.07e-3) ** 2, (x + 0.07e-3) ** 2) / 2e-3 + y**2 / 2e-3
    contact = ss.NormalProblem(scene.bodies, gap, force=5.0).solve()
    axes = plot.spot_map(contact, by="number")
    shown = axes.images[0].get_array()
    assert len(contact.spots) == 2 and len(set(shown.compressed())) == 2 and shown.count() == contact.contact_cells
    assert not axes.child_axes


def test_colours_start_at_zero_or_have_it_in_the_middle(scene):
    contact, shear = sheared(scene)
    planes = ss.subsurface.Planes(scene.bodies, [1e-5, 2e-5]).solve_all("one", contact)
    for axes in (plot.pressure_map(contact), plot.traction_map(shear), plot.spot_map(contact)):
        assert axes.images[0].get_clim()[0] == 0.0
    assert plot.stress_section(planes).collections[0].get_clim()[0] == 0.0
    low, high = plot.stress_section(planes, of="xz").collections[0].get_clim()
    assert low == -high < 0.0
    [image] = plot.field(scene.grid, scene.ball.array - 1e-6).images
    assert image.get_clim()[0] == -image.get_clim()[1] and image.get_cmap().name == "RdBu_r"
    assert plot.pressure_map(contact, vmin=1.0).images[0].get_clim()[0] == 1.0


def test_spot_map_shows_stick_ratios(scene):
    contact, shear = sheared(scene)
    coupled = dissimilar()
    for given, ratio in [((contact, shear), shear.stick_ratio), (coupled, coupled.tangential.stick_ratio)]:
        [image] = plot.spot_map(given, by="stick_ratio").images
        assert set(image.get_array().compressed()) == {ratio} and 0.0 < ratio < 1.0
    with pytest.raises(TypeError, match=r"a tangential solution has no pressure: give \(normal, shear\)"):
        plot.spot_map(shear, by="stick_ratio")
    with pytest.raises(TypeError, match=r"must be \(normal, shear\)"):
        plot.spot_map((shear, contact))


def test_maps_show_halves_of_coupled_solution(scene):
    coupled = dissimilar()
    assert (plot.stick_map(coupled).images[0].get_array() == coupled.tangential.zones).all()
    assert plot.pressure_map(coupled).images[0].get_array().max() == coupled.normal.pressure.max()
    size = np.hypot(*coupled.tangential.traction)
    assert plot.traction_map(coupled).images[0].get_array().max() == size.max()
    bodies = ss.HalfSpace(ss.Grid.square(16, 3.0), (ss.Material(2.5, 0.25), ss.Material(2.5, 0.25)))
    rolling = ss.rolling.CoupledRollingProblem(
        bodies, ss.surface.sphere(bodies.grid, 1.0), 0.3, normal_force=1.0, creepage_x=1e-3
    ).solve(warn=False)
    assert (plot.stick_map(rolling).images[0].get_array() == rolling.rolling.zones).all()
    assert plot.pressure_map(rolling).images and plot.traction_map(rolling.rolling).images


def test_fields_and_surfaces_are_drawn_without_grid(scene):
    rough = ss.surface.SelfAffine(rms_height=1e-6, seed=0).generate(scene.grid)
    for given, values in [(scene.ball, scene.ball), (rough, rough.heights)]:
        [image] = plot.field(given, unit="m").images
        assert (image.get_array() == values.array).all() and tuple(image.get_extent()) == scene.grid.extent
    [line] = plot.section(scene.ball, along="y", at=0.1e-3).lines
    row = plot.section(scene.grid, scene.ball, along="y", at=0.1e-3).lines[0]
    assert (line.get_ydata() == row.get_ydata()).all()
    with pytest.raises(TypeError, match="give the values as the second argument, or a Field"):
        plot.field(scene.grid)
    for wrong in [(scene.ball.array,), (scene.ball, scene.ball)]:
        with pytest.raises(TypeError, match="must be a Grid, or a Field without further values, got"):
            plot.field(*wrong)


def test_stress_section_matches_planes(scene):
    contact = scene.normal()
    depths = [2e-5, 0.0, 5e-5]
    planes = ss.subsurface.Planes(scene.bodies, depths).solve_all("one", contact)
    axes = plot.stress_section(planes, scale=1e3, length_unit="mm", value_scale=1e-6, unit="MPa")
    [mesh] = axes.collections
    row = abs(scene.grid.y).argmin()
    expected = [1e-6 * planes[place].von_mises[row] for place in (1, 0, 2)]
    assert np.allclose(np.asarray(mesh.get_array()).reshape(3, -1), expected, rtol=1e-12)
    assert axes.get_ylim() == pytest.approx((0.05, 0.0)) and axes.get_aspect() == 1.0
    assert (axes.get_xlabel(), axes.get_ylabel(), bar(axes).get_ylabel()) == ("x (mm)", "depth (mm)", "von Mises (MPa)")
    [mesh] = plot.stress_section(planes, of="yz", along="y", at=1e-5).collections
    column = abs(scene.grid.x - 1e-5).argmin()
    assert np.array_equal(np.asarray(mesh.get_array()).reshape(3, -1)[0], planes[1].shear_stress[2][:, column])
    for wrong in ({"of": "zx"}, {"at": 1.0}, {"along": "z"}):
        with pytest.raises(ValueError):
            plot.stress_section(planes, **wrong)
    with pytest.raises(ValueError, match="two depths"):
        plot.stress_section(planes[:1])


def test_plots_check_labels_of_pandas_and_xarray(scene):
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    gap = scene.ball.array * (1.0 + np.arange(64.0))
    transposed = xarray.DataArray(gap, {"y": scene.grid.y, "x": scene.grid.x}, ("y", "x")).T
    for values in (transposed, pandas.DataFrame(gap)):
        assert np.array_equal(ss.plot.field(scene.grid, values).images[0].get_array(), gap)
    with pytest.raises(ValueError, match="decreasing coordinates along y"):
        ss.plot.field(scene.grid, pandas.DataFrame(gap).iloc[::-1])


def test_axes_of_another_kind_are_rejected_with_the_remedy(scene):
    figure, axes = pyplot.subplots(1, 2)
    for given, remedy in (
        (pyplot.subplots(), r"give the second value of pyplot.subplots\(\)"),
        (axes, r"give one of its entries, such as axes\[0\]"),
        (figure, r"give figure.subplots\(\), or one of figure.axes"),
        ("x", "class str"),
    ):
        with pytest.raises(ss.errors.ArgumentType, match=f"^axes must be Axes of matplotlib, got .*{remedy}"):
            plot.field(scene.ball, axes=given)
        with pytest.raises(ss.errors.ArgumentType, match="^axes must be"):
            plot.pressure_map(scene.normal(), given)


def test_unit_in_place_of_a_factor_is_rejected(scene):
    contact, shear = sheared(scene)
    for call in (
        lambda **options: plot.field(scene.ball, **options),
        lambda **options: plot.section(scene.ball, **options),
        lambda **options: plot.pressure_map(contact, **options),
        lambda **options: plot.stick_map(shear, **options),
        lambda **options: plot.traction_map(shear, **options),
        lambda **options: plot.spot_map(contact, **options),
    ):
        with pytest.raises(ss.errors.ArgumentType, match="^scale must be a number, got .* str: give the unit by length_unit='um'"):
            call(scale="um")
        call(scale=np.float32(1e6))
    with pytest.raises(ss.errors.ArgumentType, match="^value_scale must be a number, .*: give the unit by unit='MPa'"):
        plot.pressure_map(contact, value_scale="MPa")


def test_lengths_of_known_unit_are_converted_into_the_unit_of_the_label(scene):
    ball = ss.Field(scene.grid, scene.ball, "m")
    axes = plot.field(ball, length_unit="\u00b5m", unit="nm")
    assert axes.get_xlabel() == "x (\u00b5m)" and axes.get_xlim()[1] == pytest.approx(1e6 * scene.grid.extent[1])
    assert axes.images[0].get_array().max() == pytest.approx(1e9 * scene.ball.max())
    line = plot.section(scene.grid, ball, length_unit="mm", unit="um").lines[0]
    assert line.get_xdata() == pytest.approx(1e3 * scene.grid.x) and line.get_ydata().max() <= 1e6 * scene.ball.max()
    # Without a unit, with another quantity and with a factor, the numbers are drawn as given.
    for drawn_field, options in ((scene.ball, {"length_unit": "um"}), (ball, {"length_unit": "a"}), (ball, {"length_unit": "um", "scale": 1.0})):
        assert plot.field(drawn_field, **options).get_xlim()[1] == pytest.approx(scene.grid.extent[1])
    history = ss.History(scene.bodies, ball, 0.5)
    history.step(normal_force=FORCE)
    history.step(force_x=20.0)
    for draw in (plot.pressure_map, plot.stick_map, plot.traction_map, plot.spot_map):
        assert draw(history, length_unit="mm").get_xlim()[1] == pytest.approx(1e3 * scene.grid.extent[1])
