# %%
import stickslip as ss

# A cylinder on a flat specimen of titanium, 200 N/mm, in mm, N and MPa.
titanium = ss.Material(115e3, 0.32)
pair = ss.ElasticPair(titanium, titanium)
hertz = ss.analytical.HertzLine(pair, radius=50.0, load=200.0)
a, p0 = hertz.half_width, hertz.max_pressure
grid = ss.Grid.line(256, 3.0 * a / 256.0)
bodies = ss.HalfSpace(grid, pair, boundary=("periodic_along_y", 50.0))
contact = ss.NormalProblem(bodies, ss.surface.cylinder(grid, 50.0), force=200.0).solve()

planes = ss.subsurface.Planes(bodies, [0.0, 0.786 * a])
surface, deep = (planes.solve(index, "one", contact) for index in (0, 1))
# Below the middle of a line contact, sxx = szz = -p0 at the surface, and the maximum shear stress is 0.300 p0 at 0.786 a.
middle = surface.get(128, 0)
assert abs(middle.xx / p0 + 1.0) < 1e-2 and abs(middle.zz / p0 + 1.0) < 1e-3
xx, _, zz = deep.normal_stress
assert abs(0.5 * abs(xx - zz).max() / p0 - 0.300) < 1e-3
# %%
import math

import numpy as np
import stickslip as ss

titanium = ss.Material(115e3, 0.32)
pair = ss.ElasticPair(titanium, titanium)
a = ss.analytical.HertzLine(pair, radius=50.0, load=200.0).half_width
grid = ss.Grid.line(128, 3.0 * a / 128.0)
bodies = ss.HalfSpace(grid, pair, boundary=("periodic_along_y", 50.0))
# The specimen is body 1; a bulk stress of 1 MPa causes this strain.
strain = [[titanium.plane_strain_under(1.0), 0.0], [0.0, 0.0]]
bulk = ss.tangential.RelativeDisplacement.bulk_strain(grid, strain)
history = ss.History(bodies, ss.surface.cylinder(grid, 50.0), 0.6, relative_displacement=bulk)
history.step(normal_force=200.0)

planes = ss.subsurface.Planes(bodies, [0.02 * a])
series = []
for step in range(1, 61):
    phase = math.sin(math.tau * step / 40.0)
    bulk_stress = 100.0 * phase
    # The slip zone is narrow after each reversal, and the plane is less than a cell deep: both cause warnings.
    history.step(force_x=50.0 * phase, relative_displacement=bulk_stress, warn=False)
    if step > 20:
        # After the first loading: one whole cycle, including the bulk stress.
        uniform = ss.subsurface.Stress(xx=bulk_stress, yy=0.32 * bulk_stress)
        plane = planes.solve(0, "one", history, uniform_stress=uniform, warn=False)
        series.append(plane.normal_stress[0][0])
# A fatigue criterion would be evaluated here; this example computes the range of the stress along the surface.
ranges = np.ptp(series, axis=0)
worst = ranges.argmax()
# The range is largest at the edge of the contact, where fretting cracks are found, and more than twice the range of the bulk stress.
assert abs(abs(grid.x[worst]) / a - 1.0) < 0.1 and ranges[worst] > 400.0
