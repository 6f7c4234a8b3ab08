# %%
import warnings

import stickslip as ss

steel = ss.Material(213e9, 0.29)
pair = ss.ElasticPair(steel, steel)


def press(grid):
    bodies, ball = ss.HalfSpace(grid, pair), ss.surface.sphere(grid, 3.5e-3)
    return ss.NormalProblem(bodies, ball, force=100.0, tolerance=1e-3).solve()


# The approach, and with it the contact, is far smaller than a grid of 1 mm.
with warnings.catch_warnings():
    warnings.simplefilter("ignore", ss.ContactWarning)  # the contact spans few cells
    coarse = press(ss.Grid.square(64, 1e-3))
fine = press(ss.Grid.square(64, 1.2 * max(coarse.contact_extent)))  # 27 cells per contact radius
radius = ss.analytical.HertzSphere(pair, radius=3.5e-3, load=100.0).contact_radius
assert abs(fine.contact_extent[0] / (2.0 * radius) - 1.0) < 0.03
