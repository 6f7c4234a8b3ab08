"""A pressed ball is dragged up to sliding, then to and fro: stick zone, hysteresis, and the closed forms."""

# %% A pressed ball
# The traction is found under a pressure that is given: that of a normal contact.

import numpy as np

import stickslip as ss

RADIUS, FORCE, FRICTION = 3.5e-3, 100.0, 0.5

grid = ss.Grid.square(160, 0.3e-3)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
ball = ss.surface.sphere(grid, RADIUS)
hertz = ss.analytical.HertzSphere(bodies.pair, RADIUS, FORCE)
normal = ss.NormalProblem(bodies, ball, force=FORCE).solve()

# %% Dragged once
# A tangential force below the friction limit mu P makes a ring slip around a zone that sticks. Cattaneo and Mindlin found
# the radius of the zone and the shift of the bodies; the stick ratio is the part of the contact that sticks.

print("force, N   shift, um   exact, um   stick ratio   exact")
solver = ss.TangentialProblem(bodies, normal, FRICTION, force_x=0.0).solver()
for force in (10.0, 20.0, 30.0, 40.0):
    tangential = solver.solve(force_x=force)
    exact = ss.analytical.CattaneoMindlin(hertz, FRICTION, force)
    print(
        f"{force:8.0f}   {tangential.shift[0] * 1e6:9.4f}   {exact.shift * 1e6:9.4f}"
        f"   {tangential.stick_ratio:11.3f}   {exact.stick_ratio:5.3f}"
    )
    assert abs(tangential.shift[0] / exact.shift - 1.0) < 2e-3

# %% Beyond sliding
# A force that friction cannot hold is refused before any work, with both numbers. A shift may be as large as you like: then
# the contact slides.

try:
    solver.solve(force_x=60.0)
except ss.BeyondFrictionCapacity as beyond:
    print(f"{beyond.force:.0f} N are more than the {beyond.limit:.0f} N that friction holds")

# %% To and fro
# A problem is loaded once, from rest. Loads that turn need a history, which remembers what slipped. A cycle adds up what
# its steps dissipate; Mindlin and Deresiewicz know the energy.

# What slipped on the way is remembered: a loop of force over shift. A step of 10 N after a reversal makes a ring slip that
# is 3.5 % of the contact radius wide, here more than two cells; a narrower one would be rough, of which a warning tells.
history = ss.History(bodies, ball, FRICTION)
history.step(normal_force=FORCE)
cycle = ss.history.Cycle(history)
for _ in range(2):
    cycle.begin(history)
    for x, _ in ss.history.LoadPath.triangle((40.0, 0.0), 16).cycles(1):
        history.step(force_x=x)
        cycle.add(history)
exact = ss.analytical.MindlinDeresiewicz(hertz, FRICTION, [40.0, -40.0, 40.0])
print(
    f"a cycle dissipates {cycle.energy.dissipated_energy * 1e6:.3f} uJ, exactly {exact.energy_per_cycle * 1e6:.3f} uJ"
)
assert abs(cycle.energy.dissipated_energy / exact.energy_per_cycle - 1.0) < 1e-3
assert np.isclose(cycle.points[0].force[0], cycle.points[-1].force[0], atol=1e-9)

# %% Pictures
# Zones at the last force, the traction there, and the loop of force over shift.

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
