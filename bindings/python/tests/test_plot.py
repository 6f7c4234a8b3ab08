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
