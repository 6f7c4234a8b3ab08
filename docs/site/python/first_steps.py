# %%
import stickslip as ss

radius, force = 3.5e-3, 100.0  # radius of the ball, m, and normal force, N
steel = ss.Material(213e9, 0.29)  # Young's modulus, Pa, and Poisson's ratio
pair = ss.ElasticPair(steel, steel)

# The grid must extend beyond the contact, and the contact radius must span enough
# cells. Hertz's theory gives the radius.
hertz = ss.analytical.HertzSphere(pair, radius=radius, load=force)
grid = ss.Grid.square(128, 3.0 * hertz.contact_radius)
bodies = ss.HalfSpace(grid, pair)

# The gap between the unloaded surfaces: zero at the point of first contact, and
# positive elsewhere.
ball = ss.surface.sphere(grid, radius)

# Press the ball onto the plate. Warnings are issued through the module `warnings`.
normal = ss.NormalProblem(bodies, ball, force=force).solve()
print(f"largest pressure {normal.pressure.max():.3e} Pa")
print(f"contact area {normal.contact_area:.3e} m2 in {normal.contact_cells} cells")
print(normal.report)
assert abs(normal.pressure.max() / hertz.max_pressure - 1.0) < 3e-4

# Drag body 2, the plate, along +x with 20 N. Friction can carry 0.5 x 100 N, so part
# of the contact slips and the rest sticks.
tangential = ss.TangentialProblem(bodies, normal, 0.5, force_x=20.0).solve()
print(f"{100.0 * tangential.stick_ratio:.1f} % of the contact sticks")
print(f"shift of body 2: {tangential.shift[0]:.3e} m")
exact = ss.analytical.CattaneoMindlin(hertz, friction=0.5, force=20.0)
assert abs(tangential.stick_ratio - exact.stick_ratio) < 0.02

# A map of the zones: `#` is stick, `-` is slip, `.` is no contact.
signs = {ss.Zone.STICK: "#", ss.Zone.SLIP: "-", ss.Zone.SEPARATED: "."}
for row in tangential.zones[::8, ::4]:
    print("".join(signs[zone] for zone in row))
