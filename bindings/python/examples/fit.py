"""Friction coefficient and contact modulus fitted to a measured force-shift curve, with the exact Jacobian of sensitivities."""

# %% A measured curve
# A ball is pressed on a flat and sheared until it slides. A rig measures the tangential force at prescribed shifts. Here the
# measurement is computed at known values, and noise of 0.3 N is added. The shift only grows, so each point is a separate
# tangential problem from the unsheared state.
#
# The contact modulus E* changes the tangential stiffness, and also the contact area and the pressure. Both bodies have the same
# moduli with a constant Poisson's ratio. The example needs SciPy (`pip install "stickslip[fit]"`).

import functools

import numpy as np
from scipy.optimize import least_squares

import stickslip as ss
from stickslip.sensitivity import Functional

RADIUS, FORCE, POISSON_RATIO = 3.5e-3, 100.0, 0.29
# Friction coefficient, and contact modulus in GPa.
TRUE, INITIAL = np.array([0.42, 116.0]), np.array([0.3, 80.0])
NOISE = 0.3

grid = ss.Grid.square(96, 0.4e-3)
ball = ss.surface.sphere(grid, RADIUS)
shifts = np.linspace(0.4e-6, 3.0e-6, 14)
solves = {"normal": 0, "tangential": 0}


# %% Forces and their Jacobian
# Each tangential solve supplies one row of the Jacobian by the sensitivity of the force. The row contains the derivatives
# at a constant pressure. The method `chain` of the normal solver adds the change of the pressure. The cache stores the last
# result, because the optimiser computes the forces and the Jacobian at the same parameters.


@functools.lru_cache(maxsize=1)
def curve(friction, modulus, has_jacobian):
    """Returns the forces at all shifts and, if requested, their derivatives with respect to both parameters."""
    steel = ss.Material(2e9 * modulus * (1.0 - POISSON_RATIO**2), POISSON_RATIO)
    bodies = ss.HalfSpace(grid, (steel, steel))
    presser = ss.NormalSolver(bodies, ball, force=FORCE, tolerance=1e-10)
    normal = presser.solve()
    solves["normal"] += 1
    shearer = ss.TangentialProblem(bodies, normal, friction, shift_x=0.0, tolerance=1e-10).solver()
    forces, found = [], []
    for shift in shifts:
        # Near sliding, the stick zone contains few cells, which causes a warning.
        sheared = shearer.solve(shift_x=shift, warn=False)
        solves["tangential"] += 1
        forces.append(sheared.force[0])
        if has_jacobian:
            found.append(shearer.sensitivity(sheared, Functional.tangential_force("x")))
    rows = [(one.friction_coefficient, 1e9 * one.contact_modulus) for one in presser.chain(normal, found)]
    return np.array(forces), np.array(rows)


# %% The fit
# The same fit runs twice: with the exact Jacobian, and with differences of forces. Differences require one more curve for
# each parameter and step.

exact, _ = curve(*TRUE, False)
measured = exact + NOISE * np.random.default_rng(7).standard_normal(len(shifts))


def fit(has_jacobian, jac):
    curve.cache_clear()
    solves.update(normal=0, tangential=0)
    found = least_squares(
        lambda parameters: curve(*parameters, has_jacobian)[0] - measured,
        INITIAL,
        jac=jac,
        x_scale=(0.1, 10.0),
        diff_step=1e-6,
    )
    assert found.success
    return found, dict(solves)


def jacobian(parameters):
    return curve(*parameters, True)[1]


found, own_solves = fit(True, jacobian)
differences, their_solves = fit(False, "2-point")
# The covariance of the parameters follows from the Jacobian at the solution.
uncertainty = NOISE * np.sqrt(np.diag(np.linalg.inv(found.jac.T @ found.jac)))

print("                           true   initial   fitted, with standard error   fitted with differences")
names = ("friction coefficient", "contact modulus, GPa")
for name, *values, error, other in zip(names, TRUE, INITIAL, found.x, uncertainty, differences.x):
    true, initial, value = values
    print(f"{name:20}   {true:8.3f}  {initial:8.3f}   {value:14.4f} +- {error:9.4f}   {other:23.4f}")
for name, count in (("exact Jacobian", own_solves), ("differences", their_solves)):
    print(f"{name:14}: {count['normal']} normal and {count['tangential']} tangential solves")
difference = np.abs(found.jac - differences.jac).max(axis=0) / np.abs(found.jac).max(axis=0)
print(f"largest difference between the Jacobians: {difference.max():.1e} of the largest entry of a column")
assert (np.abs(found.x - TRUE) < 3.0 * uncertainty).all()
assert np.allclose(found.x, differences.x, rtol=1e-4)

# %% Plot
# The plot shows the measured forces with the curves of the initial and the fitted parameters.

try:
    import matplotlib.pyplot as pyplot
except ImportError:
    print("no matplotlib, no picture")
else:
    pyplot.plot(shifts * 1e6, measured, "o", label="measured")
    pyplot.plot(shifts * 1e6, curve(*INITIAL, False)[0], "--", label="initial parameters")
    pyplot.plot(shifts * 1e6, curve(*found.x, False)[0], label="fitted parameters")
    pyplot.xlabel("shift, µm")
    pyplot.ylabel("tangential force, N")
    pyplot.legend()
    pyplot.savefig("fit.png")
