# %%
import stickslip as ss

titanium, steel = ss.Material(114e9, 0.32), ss.Material(210e9, 0.3)
grid = ss.Grid.square(32, 0.6e-3)
bodies = ss.HalfSpace(grid, (titanium, steel))
history = ss.History(bodies, ss.surface.sphere(grid, 10e-3), 0.6)

# Press in as many steps as a tolerance of the tractions requires.
steps = history.press(normal_force=100.0, tolerance=0.05)
print(f"pressed in {steps} steps")
# Pressing alone causes shear.
assert history.traction[0].max() > 0.0

# Shear under the same normal force.
step = history.step(force_x=20.0, warn=False)  # the slip zone is narrower than two cells
print(f"shift {step.shift[0]:e} m, stick ratio {step.stick_ratio:.2f}")
# %%
import stickslip as ss

grid = ss.Grid.square(64, 64.0)
body = ss.Material(1.0, 0.0)
bodies = ss.HalfSpace(grid, (body, body))
ball = ss.surface.sphere(grid, 576.0)

# Press and shift proportionally in one step. Without slip, F = kappa W shift / approach.
load = ss.LoadStep(approach=1.0, shift_x=0.28)
history = ss.History(bodies, ball, 0.5)
ratio = history.step(load).tangential_force[0] / history.normal.force
assert abs(ratio - 0.28) < 1e-6

# One step is enough.
history = ss.History(bodies, ball, 0.5)
error = ss.history.AdaptiveSteps(history, 1e-3).error(history, load)
assert error.traction < 1e-5

# The rule of codes that use the state at the beginning of the step only.
history = ss.History(bodies, ball, 0.5, entry_rule="whole_step")
ratio = history.step(load).tangential_force[0] / history.normal.force
assert ratio > 1.26 * 0.28
