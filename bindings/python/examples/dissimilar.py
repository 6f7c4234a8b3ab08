"""An aluminium ball on steel: pressing alone makes the rim slip, and pressure and traction are found together."""

# %% Different materials
# Where Dundurs' beta is not zero a pressure moves the surfaces of the bodies along each other by different amounts. Friction
# opposes that, so pressing alone makes the rim slip, and the traction changes the pressure.

import stickslip as ss

FORCE, TOLERANCE = 60.0, 0.01  # N, relative change of the tractions that more steps may cause

grid = ss.Grid.square(128, 0.3)
bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))  # MPa, mm
ball = ss.surface.sphere(grid, 3.5)
print(f"Dundurs' beta {bodies.pair.dundurs_beta:.3f}")

# %% Pressed in steps, and at once
# Spence's closed form is that of a contact that grows; a problem that is loaded at once comes to another state.

# The history of pressing matters. Spence's stick radius belongs to a contact which grows cell by cell. ``press`` takes as many
# steps of equal growth of the radius as a tolerance needs.
print("friction   steps   stick radius / contact radius: in steps   Spence   at once   estimated error of the pressure")
for friction in (0.075, 0.1, 0.125):
    history = ss.History(bodies, ball, friction, tolerance=1e-6)
    steps = history.press(normal_force=FORCE, tolerance=TOLERANCE)
    step = history.last_step
    spence = ss.analytical.SpencePressing.round(bodies.pair, friction)
    # A problem presses at once, to another answer, of which its one warning tells.
    contact = ss.CoupledProblem(bodies, ball, friction, normal_force=FORCE, tolerance=1e-6).solve(warn=False)
    assert [remark.kind for remark in contact.warnings] == ["single_load_step"]
    print(
        f"{friction:8.3f}   {steps:5d}   {step.stick_ratio**0.5:39.3f}   {spence.stick_radius:6.3f}"
        f"   {contact.tangential.stick_ratio**0.5:7.3f}   {contact.report.error_estimate.pressure:31.1e}"
    )
    assert abs(step.stick_ratio**0.5 - spence.stick_radius) < 0.03

# %% One-way coupling
# The pressure of a contact without friction is cheaper, and off by a few per cent here.

one_way = ss.History(bodies, ball, friction, coupling="one_way", model="vector")
one_way.press(normal_force=FORCE, tolerance=TOLERANCE)
moved = abs(one_way.pressure - history.pressure).max() / history.pressure.max()
print(f"one-way coupling, which leaves the pressure as it would be without friction, is off by {moved:.1%} of its largest value")
