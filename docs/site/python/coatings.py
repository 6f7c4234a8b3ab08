# %%
import stickslip as ss

# In mm, N and MPa: steel, and a coating 30 micrometres thick with twice the modulus of steel.
steel = ss.Material(210e3, 0.3)
coated = steel.coated([ss.layers.Layer(420e3, 0.3, thickness=0.03)])
grid = ss.Grid.square(64, 0.6)
ball = ss.surface.sphere(grid, 10.0)


def pressed(material):
    bodies = ss.HalfSpace(grid, (material, material))
    normal = ss.NormalProblem(bodies, ball, force=100.0).solve()
    return ss.TangentialProblem(bodies, normal, 0.3, force_x=15.0).solve(), normal


(sheared, normal), (bare_sheared, bare) = pressed(coated), pressed(steel)
# The coating is stiffer than steel: area and shift decrease, and the pressure increases.
assert normal.contact_area < bare.contact_area
assert normal.pressure.max() > bare.pressure.max()
assert sheared.shift[0] < bare_sheared.shift[0]
# %%
import math

import stickslip as ss

steel = ss.Material(210e3, 0.3)
thickness = 0.03
coated = steel.coated([ss.layers.Layer(420e3, 0.3, thickness=thickness)])
grid = ss.Grid.square(48, 0.6)
bodies = ss.HalfSpace(grid, (coated, steel))
contact = ss.NormalProblem(bodies, ss.surface.sphere(grid, 10.0), force=100.0).solve()
# Both sides of the interface: a depth equal to the thickness is in the coating, the next larger number is below it.
planes = ss.subsurface.Planes(bodies, [thickness, math.nextafter(thickness, 1.0)])
coating, base = (planes.solve(index, "one", contact).get(24, 24) for index in (0, 1))
assert abs(coating.zz / base.zz - 1.0) < 1e-9
assert abs(coating.xx / base.xx - 1.0) > 0.01
