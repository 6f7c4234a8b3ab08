"""A steel ball pressed on steel: force versus approach, and comparison of the pressure with Hertz."""

# %% Bodies and gap
# A ball of radius 3.5 mm touches a flat of the same steel, on 128 x 128 cells of a square of side 0.4 mm. Any consistent
# system of units can be used, here metres, newtons and pascals. The gap is the distance between the surfaces before
# loading.

import numpy as np

import stickslip as ss

RADIUS = 3.5e-3

grid = ss.Grid.square(128, 0.4e-3)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
solver = ss.NormalSolver(bodies, ss.surface.sphere(grid, RADIUS), force=0.0)

# %% Force versus approach
# A solver keeps its buffers and starts from its last solution. The report of each solution contains a certified bound on
# the error of the pressure in the energy norm. It does not include the discretisation error, which the comparison with
# Hertz shows.

print("force, N   approach, um   Hertz, um   max. pressure, GPa   certified error")
for force in np.linspace(20.0, 100.0, 5):
    contact = solver.solve(force=force)
    hertz = ss.analytical.HertzSphere(bodies.pair, radius=RADIUS, load=force)
    print(
        f"{force:8.0f}   {contact.approach * 1e6:12.4f}   {hertz.approach * 1e6:9.4f}"
        f"   {contact.pressure.max() / 1e9:18.4f}   {contact.report.energy_error_bound:15.1e}"
    )
    assert abs(contact.approach / hertz.approach - 1.0) < 1e-3

# %% Pressure cell by cell
# The pressure is a read-only array of shape (ny, nx), x fastest. Summed over the cells, it differs from Hertz by about
# 1e-3. This is the error of cells of uniform pressure, which decreases with finer cells but not with a tighter tolerance.

x, y = np.meshgrid(grid.x, grid.y)
exact = hertz.pressure(np.hypot(x, y))
difference = np.abs(contact.pressure - exact).sum() / exact.sum()
print(f"pressure under {force:.0f} N: differs from Hertz by {difference:.1e}, summed over the cells")
assert difference < 3e-3

# %% Plots
# Plots need matplotlib, `pip install "stickslip[plot]"`. Scales and units of the axes are given, because the package does
# not prescribe any.

try:
    from stickslip import plot
    import matplotlib.pyplot as pyplot
except ImportError:
    print("no matplotlib, no picture")
else:
    _, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4))
    lengths, pressures = {"scale": 1e3, "length_unit": "mm"}, {"value_scale": 1e-9, "unit": "GPa"}
    plot.pressure_map(contact, left, **lengths, **pressures)
    plot.section(grid, contact.pressure, right, label="pressure", **lengths, **pressures)
    plot.section(grid, exact, right, label="pressure", **lengths, **pressures, linestyle="--")
    for line, name in zip(right.lines, ("computed", "Hertz")):
        line.set_label(name)
    right.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    pyplot.savefig("press.png")
