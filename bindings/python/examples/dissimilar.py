"""An aluminium ball on steel: pressing alone makes the rim slip, and pressure and shear are found together."""

import stickslip as ss

grid = ss.Grid.square(48, 0.3)
bodies = ss.HalfSpace(grid, (ss.Material(70e3, 0.33), ss.Material(210e3, 0.3)))  # MPa, mm
ball = ss.surface.sphere(grid, 3.5)
print(f"Dundurs' beta {bodies.pair.dundurs_beta:.3f}")

print("friction   stick radius / contact radius   Spence   estimated error of the pressure")
for friction in (0.05, 0.1, 0.3):
    # The history of pressing matters: a few steps, as the contact grows.
    history = ss.History(bodies, ball, friction, tolerance=1e-6)
    for part in range(1, 9):
        step = history.step(normal_force=60.0 * (part / 8) ** 3)
    spence = ss.analytical.SpencePressing.round(bodies.pair, friction)
    contact = ss.CoupledProblem(bodies, ball, friction, normal_force=60.0, tolerance=1e-6).solve()
    estimate = contact.report.error_estimate
    print(f"{friction:8.2f}   {step.stick_ratio**0.5:29.3f}   {spence.stick_radius:6.3f}   {estimate.pressure:31.1e}")
    assert abs(step.stick_ratio**0.5 - spence.stick_radius) < 0.08

one_way = ss.History(bodies, ball, 0.3, coupling="one_way", model="vector")
one_way.step(normal_force=60.0)
print(f"one-way coupling moves the pressure by {abs(one_way.pressure - history.pressure).max() / history.pressure.max():.1%}")
