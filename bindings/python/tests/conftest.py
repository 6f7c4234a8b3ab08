"""Fixtures shared by many tests."""

import numpy as np
import pytest

import stickslip as ss

RADIUS, FORCE = 3.5e-3, 100.0


class Scene:
    """Contact of a steel ball with steel, with its closed-form solution."""

    def __init__(self, cells, side=0.3e-3):
        steel = ss.Material(213e9, 0.29)
        self.grid = ss.Grid.square(cells, side)
        self.bodies = ss.HalfSpace(self.grid, (steel, steel))
        self.ball = ss.surface.sphere(self.grid, RADIUS)
        self.hertz = ss.analytical.HertzSphere(self.bodies.pair, radius=RADIUS, load=FORCE)

    def normal(self, **options):
        return ss.NormalProblem(self.bodies, self.ball, force=FORCE, **options).solve()

    def history(self, **options):
        return ss.History(self.bodies, self.ball, 0.5, **options)


@pytest.fixture(scope="session")
def scene():
    return Scene(64)


@pytest.fixture(scope="session")
def large():
    """Contact with more cells than the limit up to which a solve runs on the calling thread."""
    return Scene(128)


@pytest.fixture(scope="session")
def rough():
    """Contact whose solve takes long enough to be interrupted."""
    grid = ss.Grid.square(512, 1.0)
    bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()), boundary="periodic")
    heights = ss.surface.SelfAffine(rms_slope=0.1, seed=3, roll_off_wavelength=0.25).generate(grid).heights
    return bodies, ss.surface.gap_from_heights(heights)


def address(array):
    return np.asarray(array).__array_interface__["data"][0]
