"""The pictures."""

import pytest

import stickslip as ss
from conftest import FORCE

pyplot = pytest.importorskip("matplotlib.pyplot")
pyplot.switch_backend("Agg")
from stickslip import plot  # noqa: E402


def test_pictures_of_a_contact(scene):
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
    pyplot.close("all")


def test_sections_are_the_rows_and_columns_of_a_field(scene):
    contact = scene.normal()
    axes = plot.section(scene.grid, contact.pressure, label="pressure, Pa", scale=1e3, length_unit="mm")
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
    pyplot.close("all")


def test_axes_have_names_and_the_units_given(scene):
    contact = scene.normal()
    axes = plot.pressure_map(contact, scale=1e3, length_unit="mm", pressure_unit="Pa")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x, mm", "y, mm")
    assert axes.figure.axes[1].get_ylabel() == "pressure, Pa"
    assert plot.field(scene.grid, scene.ball).get_xlabel() == "x"
    cycle = ss.history.Cycle(scene.history())
    axes = plot.hysteresis(cycle, axis="y", length_unit="m", force_unit="N")
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("shift along y, m", "tangential force along y, N")
    with pytest.raises(ValueError):
        plot.hysteresis(cycle, axis="z")
    pyplot.close("all")


def test_pictures_of_a_history_and_of_reports(scene):
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
