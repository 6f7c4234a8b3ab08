"""A rough surface is pressed: area versus load compared with Persson's law, and the cost of accuracy."""

# %% A self-affine surface
# Amplitudes decrease with a power of the wave number between two wavelengths; phases are determined by the seed. The same
# seed on a finer grid gives the same surface with more points. The contact is periodic along both axes, so it has no
# edge.

import warnings

import numpy as np

import stickslip as ss

# The shortest wave has thirteen cells. With half as many, some spots would be smaller than five cells and some slip rings
# narrower than two cells, which causes warnings.
grid = ss.Grid.square(256, 1.0)
bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()), boundary="periodic")
recipe = ss.surface.SelfAffine(rms_slope=0.1, hurst=0.8, roll_off_wavelength=0.25, cut_off_wavelength=0.05, seed=1)
heights = recipe.generate(grid).heights
print(ss.surface.Statistics(heights))

# %% Area versus load
# The area grows proportionally to the load until it saturates. The area from counting cells exceeds the true area by half
# a cell along each edge; the corrected area does not. Persson's law is asymptotic: here the area fractions differ from it
# by up to a third.

gap = ss.surface.gap_from_heights(heights)
solver = ss.NormalSolver(bodies, gap, force=0.0, tolerance=1e-6)
print("mean pressure / E* slope   area, %   Persson, %   spots")
areas = []
for reduced in (0.02, 0.05, 0.1, 0.15):
    pressure = reduced * bodies.pair.contact_modulus * 0.1
    contact = solver.solve(force=pressure * grid.area)
    persson = ss.analytical.Persson(bodies.pair, rms_slope=0.1, mean_pressure=pressure)
    areas.append(contact.contact_area_corrected / grid.area)
    print(f"{reduced:24.2f}   {100 * areas[-1]:7.2f}   {100 * persson.contact_fraction:10.2f}   {len(contact.spots):5d}")
assert np.all(np.diff(areas) > 0.0) and abs(areas[2] / 0.16 - 1.0) < 0.35

# %% The cost of accuracy
# Each report contains the number of products with the operator, the time and the certified error.

reports = [
    ss.NormalProblem(bodies, gap, force=pressure * grid.area, tolerance=tolerance).solve().report
    for tolerance in (1e-2, 1e-4, 1e-6, 1e-8)
]
for report in reports:
    print(report)

# %% Tangential load
# Pressing alone shears bodies of different materials, and the stick zone depends on the growth of the contact. ``press``
# therefore takes as many steps as a tolerance of the tractions requires. The contact is then sheared by half of the force
# of sliding. With one-way coupling, the pressure equals the pressure without friction. The vector model includes the tractions
# across the force, which the pressure causes.

history = ss.History(bodies, gap, 0.3, coupling="one_way", model="vector", tolerance=1e-6)
with warnings.catch_warnings():
    # During pressing, the slip rings are narrower than two cells, as a warning states.
    warnings.simplefilter("ignore", ss.errors.ContactWarning)
    steps = history.press(normal_force=contact.force, tolerance=0.05)
stick = history.last_step.stick_ratio
tangential = history.step(force_x=0.15 * contact.force)
print(f"pressed in {steps} steps, {100 * stick:.0f} % of the contact sticks")
print(f"at half the friction limit {100 * tangential.stick_ratio:.0f} % of the contact sticks")

# %% Plots
# Lengths are in units of the side of the grid, pressures in units of Young's modulus: E = 1, L = 1.

try:
    from stickslip import plot
    import matplotlib.pyplot as pyplot
except ImportError:
    print("no matplotlib, no picture")
else:
    _, axes = pyplot.subplots(2, 2, figsize=(11, 8))
    plot.pressure_map(contact, axes[0, 0], length_unit="L", unit="E")
    plot.stick_map(history, axes[0, 1], length_unit="L")
    plot.spot_map(contact, axes[1, 0], by="number", length_unit="L")
    plot.work_precision(reports, axes[1, 1], scale=1e3, unit="ms")
    pyplot.savefig("rough.png")
