"""Stresses below a dragged ball: von Mises stress on planes, the depth of the largest shear stress, a volume for
ParaView."""

# %% Surface tractions
# The contact is a pressed and dragged ball, as in the previous tutorials. Units are mm, N and MPa.

import pathlib
import tempfile

import numpy as np

import stickslip as ss

grid = ss.Grid.square(64, 0.4)
steel = ss.Material(210e3, 0.3)  # MPa, mm
bodies = ss.HalfSpace(grid, (steel, steel))
contact = ss.NormalProblem(bodies, ss.surface.sphere(grid, 5.0), force=100.0).solve()
tangential = ss.TangentialProblem(bodies, contact, 0.3, force_x=25.0).solve()
hertz = ss.analytical.HertzSphere(bodies.pair, radius=5.0, load=100.0)

# %% Planes
# Stresses on planes at chosen depths are computed by fast Fourier transforms. Under the pressure alone, the largest shear
# stress is on the axis at a depth of 0.48 contact radii; friction moves it towards the surface.

# All depths are larger than one cell side. At the surface itself, the stress at the edge of a sheared contact converges
# only with the square root of the cell size, which causes a warning.
depths = np.linspace(0.05, 1.5, 30) * hertz.contact_radius
planes = ss.subsurface.Planes(bodies, depths)
pressed, dragged = planes.solve_all("one", contact), planes.solve_all("one", (contact, tangential))
print("depth / a   von Mises / p0, pressed   dragged")
for still, moved in zip(pressed[::4], dragged[::4]):
    print(
        f"{still.depth / hertz.contact_radius:9.2f}   {still.von_mises.max() / hertz.max_pressure:23.3f}"
        f"   {moved.von_mises.max() / hertz.max_pressure:7.3f}"
    )
deepest = max(pressed, key=lambda plane: plane.max_shear.max())
assert abs(deepest.depth / hertz.contact_radius - 0.48) < 0.1
assert abs(deepest.max_shear.max() / hertz.max_pressure - 0.31) < 0.01

# %% Points
# The stress tensor at arbitrary points is computed by sums over the cells; stress is positive in tension.

below = ss.subsurface.at_points(bodies, "one", contact, [(0.0, 0.0, depth) for depth in depths])
largest = int(below.max_shear.argmax())
print(f"largest shear stress on the axis at the depth {depths[largest]:.3f} mm: {below[largest].stress}")
assert abs(below.max_shear.max() / deepest.max_shear.max() - 1.0) < 0.01

# %% A volume for other programs
# ParaView and other programs based on VTK read all planes as one image.

with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "stress.vti"
    planes.write_vti(file, "one", (contact, tangential))
    print(f"volume for ParaView: {file.stat().st_size} bytes")

# %% Plots
# The sections through the planes at y = 0 show the von Mises stress and the stress along x.

try:
    from stickslip import plot
    import matplotlib.pyplot as pyplot
except ImportError:
    print("no matplotlib, no picture")
else:
    _, axes = pyplot.subplots(2, 1, figsize=(7, 7))
    plot.stress_section(dragged, axes[0], length_unit="mm", unit="MPa")
    plot.stress_section(dragged, axes[1], of="xx", length_unit="mm", unit="MPa", cmap="coolwarm", vmin=-1750, vmax=1750)
    pyplot.savefig("subsurface.png")
