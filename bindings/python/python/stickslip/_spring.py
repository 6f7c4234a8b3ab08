"""Spring that drags a body."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Spring:
    """Spring that drags body 2, along one axis or along both axes. The force is stiffness (position - shift).

    Position and stiffness are given by keyword only, because two numbers in the wrong order would be another valid spring.

    Examples
    --------
    >>> import stickslip as ss
    >>> drag = ss.LoadStep(spring_x=ss.Spring(position=1e-6, stiffness=1e7))
    >>> oblique = ss.LoadStep(spring=ss.Spring(position=(1e-6, 2e-6), stiffness=1e7))
    """

    position: float | tuple[float, float]
    """Position of the far end, or a pair (x, y) for springs along both axes (lengths). Its distance from the shift must not exceed a
    million sides of the grid."""
    stiffness: float
    """Stiffness (a force over a length, positive)."""
