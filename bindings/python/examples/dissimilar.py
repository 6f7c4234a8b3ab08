"""An aluminium ball on steel: pressing alone makes the rim slip, and pressure and traction are solved simultaneously."""

# %% Different materials
# If Dundurs' beta is not zero, a pressure displaces the two surfaces tangentially by different amounts. Friction opposes
# the relative motion, so pressing alone makes the rim slip, and the traction changes the pressure.

import stickslip as ss

FORCE, TOLERANCE = 60.0, 0.01  # N, relative change of the tractions with more steps

grid = ss.Grid.square(128, 0.3)
bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))  # MPa, mm
ball = ss.surface.sphere(grid, 3.5)
print(f"Dundurs' beta {bodies.pair.dundurs_beta:.3f}")

# %% Pressing in many steps or in one step
# Spence's closed form describes a growing contact; a problem that is loaded in one step reaches a different state.

# The load history matters. Spence's stick radius belongs to a contact that grows cell by cell. ``press`` takes
# steps with equal growth of the radius, as many as a tolerance requires.
print("friction   steps   stick radius / contact radius: in steps   Spence   at once   estimated error of the pressure")
for friction in (0.075, 0.1, 0.125):
    history = ss.History(bodies, ball, friction, tolerance=1e-6)
    steps = history.press(normal_force=FORCE, tolerance=TOLERANCE)
    step = history.last_step
    spence = ss.analytical.SpencePressing.round(bodies.pair, friction)
    # A problem presses in one step and reaches a different solution, as its only warning states.
    contact = ss.CoupledProblem(bodies, ball, friction, normal_force=FORCE, tolerance=1e-6).solve(warn=False)
    assert [remark.kind for remark in contact.warnings] == ["single_load_step"]
    print(
        f"{friction:8.3f}   {steps:5d}   {step.stick_ratio**0.5:39.3f}   {spence.stick_radius:6.3f}"
        f"   {contact.tangential.stick_ratio**0.5:7.3f}   {contact.report.error_estimate.pressure:31.1e}"
    )
    assert abs(step.stick_ratio**0.5 - spence.stick_radius) < 0.03

# %% One-way coupling
# The pressure of a contact without friction is cheaper to compute. Here the error of this pressure is a few per cent.

one_way = ss.History(bodies, ball, friction, coupling="one_way", model="vector")
one_way.press(normal_force=FORCE, tolerance=TOLERANCE)
moved = abs(one_way.pressure - history.pressure).max() / history.pressure.max()
print(f"one-way coupling, which leaves the pressure as it would be without friction, is off by {moved:.1%} of its largest value")
