# %%
import warnings

import stickslip as ss

# A periodic square with a side of 100 micrometres, in micrometres and megapascals.
grid = ss.Grid.square(256, 100.0)
rubber = ss.Material(18.75, 0.5)
bodies = ss.HalfSpace(grid, (rubber, ss.Material.rigid()), boundary="periodic")

rough = ss.surface.SelfAffine(rms_slope=0.3, hurst=0.8, roll_off_wavelength=25.0, seed=7).generate(grid)
print(ss.surface.Statistics(rough.heights))
gap = ss.surface.gap_from_heights(rough.heights)
mean_pressure = 0.01 * bodies.pair.contact_modulus
with warnings.catch_warnings():
    warnings.simplefilter("ignore", ss.ContactWarning)  # steep slopes and small spots
    contact = ss.NormalProblem(bodies, gap, force=mean_pressure * grid.area, tolerance=1e-6).solve()

# Theory and simulations: area = (1.6 to 2.5) p / (E* times rms slope).
fraction = contact.contact_area_corrected / grid.area
assert 1.6 < fraction / 0.01 * 0.3 < 2.5
print(f"{len(contact.spots)} spots on {100.0 * fraction:.1f} % of the area")
for warning in contact.warnings:
    print(warning)
# %%
import stickslip as ss

measured = ss.io.read("surface.sdf")  # heights, m; NaN if missing
levelled = ss.surface.level(measured, "plane").heights
# The filter ignores missing heights, so the holes are filled after it.
filtered = ss.surface.gaussian_filter(levelled, s=2.5e-6).heights
heights = ss.surface.fill_missing(filtered).heights
gap = ss.surface.gap_from_heights(heights)

steel = ss.Material(210e9, 0.3)
bodies = ss.HalfSpace(gap.grid, (steel, steel))
contact = ss.NormalProblem(bodies, gap, force=10.0).solve()
print(f"contact area {contact.contact_area_corrected:.3e} m2")
