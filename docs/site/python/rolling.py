# %%
import stickslip as ss

# A steel ball that rolls on a plane, in mm, N and MPa.
steel = ss.Material(210e3, 0.28)
hertz = ss.analytical.HertzEllipse(ss.ElasticPair(steel, steel), radius_x=10.0, radius_y=10.0, load=100.0)
grid = ss.Grid.square(32, 2.6 * hertz.semi_axes[0])
bodies = ss.HalfSpace(grid, (steel, steel))
normal = ss.NormalProblem(bodies, ss.surface.sphere(grid, 10.0), force=100.0).solve()

# The creep curve; each point starts from the previous one.
friction = 0.3
solver = ss.rolling.RollingProblem(bodies, normal, friction, creepage_x=0.0).solver()
creepages = [0.5e-3, 1e-3, 2e-3, 4e-3]
curve = solver.creep_forces([(creepage, 0.0, 0.0) for creepage in creepages])
for creepage, force in zip(creepages, curve.force[0]):
    exact = ss.analytical.VermeulenJohnson(hertz, friction=friction, creepage=(creepage, 0.0))
    assert abs(force - exact.force[0]) < 0.03 * friction * 100.0

# A braking force instead of a creepage: the same solve determines the creepage.
rolling = solver.solve(force_x=-20.0, creepage_y=0.0)
assert rolling.creepage[0] < 0.0
# %%
import math

import numpy as np
import stickslip as ss

grid = ss.Grid.square(32, 0.020)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
gap = ss.surface.sphere(grid, 0.5)
normal = ss.NormalProblem(bodies, gap, force=80e3).solve()
rolling = ss.rolling.RollingProblem(bodies, normal, 0.3, creepage_x=1e-3).solve()

coefficient, length = 1e-14, 1e3  # m3/J, m
circumference = 2 * math.pi * 0.5
energy = rolling.dissipation_per_area  # the bodies roll along x, so a line is a row
energy = energy * (rolling.work / (energy.sum() * grid.cell_area))
depths = length / circumference * coefficient * grid.dx * energy.sum(axis=1)
worn = gap + np.broadcast_to(depths[:, np.newaxis], grid.shape)

assert abs(depths.max() / 4.1e-9 - 1) < 0.01  # 4.13 nm in the limit of small cells
volume = circumference * grid.dy * depths.sum()
assert abs(volume / (coefficient * length * rolling.work) - 1) < 1e-9
# %%
import stickslip as ss

grid = ss.Grid.square(24, 3.0)
body = ss.Material.from_shear_modulus(1.0, 0.25)
bodies = ss.HalfSpace(grid, (body, body))
history = ss.History(bodies, ss.surface.sphere(grid, 1.0), 0.3, model="vector")
history.step(normal_force=1.0, warn=False)  # the contact is large for the radius of the ball
speed, time_step, way = 1.0, 0.08, 0.0
for _ in range(10):
    way += speed * time_step
    cells = int(way / grid.dx)
    if cells > 0:
        way -= cells * grid.dx
        history.step(roll=ss.history.Rolling(cells, creepage_x=0.05), warn=False)
assert history.last_step.tangential_force[0] > 0.0
# %%
import math

import stickslip as ss

grid = ss.Grid.square(24, 3.0)
body = ss.Material.from_shear_modulus(1.0, 0.25)
bodies = ss.HalfSpace(grid, (body, body))
press = ss.NormalProblem(bodies, ss.surface.sphere(grid, 1.0), force=1.0, tolerance=1e-3)
normal = press.solve(warn=False)
wheel = ss.rolling.RollingProblem(bodies, normal, 0.3, creepage_x=0.0, tolerance=1e-3).solver()
wheel.set_normal_solver(press.solver())
for step in range(20):
    phase = 0.1 * step
    wheel.set_normal_load(normal_force=1.0 + 0.2 * math.sin(phase))
    rolling = wheel.solve(creepage_x=0.05 * math.sin(phase), creepage_y=0.01, spin=0.02, warn=False)
    assert rolling.force[0] < wheel.friction_capacity
