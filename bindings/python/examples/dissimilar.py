"""An aluminium ball on steel: pressing alone makes the rim slip, and pressure and traction are found together."""

# %% Different materials
# Where Dundurs' beta is not zero a pressure moves the surfaces of the bodies along each other by different amounts. Friction
# opposes that, so pressing alone makes the rim slip, and the traction changes the pressure.

import stickslip as ss

FORCE, STEPS = 60.0, 24  # N, steps while the contact radius grows to that of the force

grid = ss.Grid.square(128, 0.3)
bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))  # MPa, mm
ball = ss.surface.sphere(grid, 3.5)
print(f"Dundurs' beta {bodies.pair.dundurs_beta:.3f}")

# %% Pressed in steps, and at once
# Spence's closed form is that of a contact that grows; a problem that is loaded at once comes to another state.

# The history of pressing matters. Spence's stick radius is that of a contact which grows cell by cell: steps in equal parts
# of the radius come to it, the more of them the closer. They begin at a quarter, where the stick zone has enough cells.
print("friction   stick radius / contact radius: in steps   Spence   at once   estimated error of the pressure")
for friction in (0.075, 0.1, 0.125):
    history = ss.History(bodies, ball, friction, tolerance=1e-6)
    for part in range(STEPS // 4, STEPS + 1):
        step = history.step(normal_force=FORCE * (part / STEPS) ** 3)
    spence = ss.analytical.SpencePressing.round(bodies.pair, friction)
    # A problem presses at once, to another answer, of which its one warning tells.
    contact = ss.CoupledProblem(bodies, ball, friction, normal_force=FORCE, tolerance=1e-6).solve(warn=False)
    assert [remark.kind for remark in contact.warnings] == ["pressed_at_once"]
    print(
        f"{friction:8.3f}   {step.stick_ratio**0.5:39.3f}   {spence.stick_radius:6.3f}"
        f"   {contact.tangential.stick_ratio**0.5:7.3f}   {contact.report.error_estimate.pressure:31.1e}"
    )
    assert abs(step.stick_ratio**0.5 - spence.stick_radius) < 0.03

# %% One-way coupling
# The pressure of a contact without friction is cheaper, and off by a few per cent here.

one_way = ss.History(bodies, ball, friction, coupling="one_way", model="vector")
for part in range(STEPS // 4, STEPS + 1):
    one_way.step(normal_force=FORCE * (part / STEPS) ** 3)
moved = abs(one_way.pressure - history.pressure).max() / history.pressure.max()
print(f"one-way coupling, which leaves the pressure as it would be without friction, is off by {moved:.1%} of its largest value")
