"""A pressed ball is dragged up to sliding, then back and forth: stick zone, hysteresis, and closed-form solutions."""

# %% A pressed ball
# The traction is computed for a given pressure, here the pressure of a normal contact.

import numpy as np

import stickslip as ss

RADIUS, FORCE, FRICTION = 3.5e-3, 100.0, 0.5

grid = ss.Grid.square(160, 0.3e-3)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
ball = ss.surface.sphere(grid, RADIUS)
hertz = ss.analytical.HertzSphere(bodies.pair, radius=RADIUS, load=FORCE)
normal = ss.NormalProblem(bodies, ball, force=FORCE).solve()

# %% Monotonic tangential load
# A tangential force below the friction limit mu P causes slip in a ring around the stick zone. Cattaneo and Mindlin
# derived the radius of the stick zone and the shift of the bodies. The stick ratio is the fraction of the contact area
# that sticks.

print("force, N   shift, um   exact, um   stick ratio   exact")
solver = ss.TangentialProblem(bodies, normal, FRICTION, force_x=0.0).solver()
for force in (10.0, 20.0, 30.0, 40.0):
    tangential = solver.solve(force_x=force)
    exact = ss.analytical.CattaneoMindlin(hertz, friction=FRICTION, force=force)
    print(
        f"{force:8.0f}   {tangential.shift[0] * 1e6:9.4f}   {exact.shift * 1e6:9.4f}"
        f"   {tangential.stick_ratio:11.3f}   {exact.stick_ratio:5.3f}"
    )
    assert abs(tangential.shift[0] / exact.shift - 1.0) < 2e-3

# %% Beyond sliding
# A force beyond the friction capacity raises an exception before any work, with both numbers. A shift of any size is
# allowed; for a large shift the contact slides.

try:
    solver.solve(force_x=60.0)
except ss.BeyondFrictionCapacity as beyond:
    print(f"{beyond.force:.0f} N are more than the {beyond.limit:.0f} N that friction holds")

# %% Reciprocating load
# A problem is loaded once, from rest. Loads with reversals need a history, which stores the slip of earlier steps. A
# cycle sums the dissipated energy of its steps, which Mindlin and Deresiewicz give in closed form.

# The memory of slip causes a loop of force versus shift. After a reversal, a step of 10 N causes slip in a ring whose
# width is 3.5 % of the contact radius, here more than two cells. A narrower ring would be poorly resolved and cause a
# warning.
history = ss.History(bodies, ball, FRICTION)
history.step(normal_force=FORCE)
cycle = ss.history.Cycle(history)
for _ in range(2):
    cycle.begin(history)
    for x, _ in ss.history.LoadPath.triangle((40.0, 0.0), 16).cycles(1):
        history.step(force_x=x)
        cycle.add(history)
exact = ss.analytical.MindlinDeresiewicz(hertz, friction=FRICTION, path=[40.0, -40.0, 40.0])
print(
    f"a cycle dissipates {cycle.energy.dissipated_energy * 1e6:.3f} uJ, exactly {exact.energy_per_cycle * 1e6:.3f} uJ"
)
assert abs(cycle.energy.dissipated_energy / exact.energy_per_cycle - 1.0) < 1e-3
assert np.isclose(cycle.points[0].force[0], cycle.points[-1].force[0], atol=1e-9)

# %% Plots
# The plots show the zones and the traction at the last force, and the loop of force versus shift.

try:
    from stickslip import plot
    import matplotlib.pyplot as pyplot
except ImportError:
    print("no matplotlib, no picture")
else:
    _, (zones, traction, loop) = pyplot.subplots(1, 3, figsize=(15, 4))
    plot.stick_map(tangential, zones, scale=1e3, length_unit="mm")
    plot.traction_map(tangential, traction, scale=1e3, length_unit="mm", value_scale=1e-9, unit="GPa")
    plot.hysteresis(cycle, loop, scale=1e6, length_unit="µm", unit="N")
    pyplot.savefig("shear.png")
