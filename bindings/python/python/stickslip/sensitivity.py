"""Sensitivities: derivatives of functionals of a contact with respect to gap, loads, friction and moduli, by the adjoint.

Differences of solves need at least one solve for each input. The adjoint gives the derivatives of a functional with respect to
all inputs, such as the gap of each cell, with one linear solve. The method ``sensitivity`` of :class:`stickslip.NormalSolver`,
:class:`stickslip.TangentialSolver` and :class:`stickslip.CoupledSolver` computes them:

>>> import stickslip
>>> from stickslip.sensitivity import Functional
>>> grid = stickslip.Grid.square(48, 3.0)
>>> bodies = stickslip.HalfSpace(grid, (stickslip.Material(1.0, 0.3), stickslip.Material.rigid()))
>>> solver = stickslip.NormalSolver(bodies, stickslip.surface.sphere(grid, 10.0), force=0.1)
>>> contact = solver.solve()
>>> found = solver.sensitivity(contact, Functional.approach())
>>> round(found.normal_load * 0.1 / found.value, 2)  # Hertz: the approach grows as the power 2/3 of the force
0.67
>>> found.gap.shape
(48, 48)

The sets of the cells are constant in the derivatives: contact, stick and slip. If a cell is exactly on the boundary of its set,
the derivative is valid on one side only. A tangential contact has a given pressure; :meth:`NormalSolver.chain`
continues its sensitivities to the gap and the normal load.
"""

from ._stickslip import Functional, Sensitivity

__all__ = ["Functional", "Sensitivity"]
