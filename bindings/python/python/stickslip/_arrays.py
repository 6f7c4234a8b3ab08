"""Arrays of the energies of cells, which contain their grid, and read-only arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

if TYPE_CHECKING:
    from ._stickslip import Grid


def read_only(array: ArrayLike) -> NDArray[Any]:
    """Returns a read-only view of an array."""
    view = np.asarray(array).view()
    view.flags.writeable = False
    return view


class CellEnergies(np.ndarray[Any, np.dtype[np.float64]]):
    """Array of one energy per cell with its grid, from which the wear laws take the area of a cell. The grid is ``None`` if the
    shape differs from that of the grid. A quotient by the area of a cell is a plain array."""

    grid: Grid | None

    def __array_finalize__(self, source: Any) -> None:
        grid = getattr(source, "grid", None)
        self.grid = grid if grid is not None and grid.shape == self.shape else None

    def _is_per_area(self, context: Any) -> bool:
        """Returns whether an operation of NumPy divides by the area of a cell."""
        if self.grid is None or context is None or context[0] is not np.true_divide:
            return False
        divisor = context[1][1]
        return isinstance(divisor, (float, np.floating)) and abs(float(divisor) / self.grid.cell_area - 1.0) < 1e-9

    def __reduce__(self) -> tuple[Any, ...]:
        reduced: Any = super().__reduce__()
        restore, arguments, state = reduced
        return restore, arguments, (self.grid, state)

    def __setstate__(self, state: Any) -> None:
        self.grid, own = state
        super().__setstate__(own)

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        if array.shape != self.shape or array.dtype != np.float64 or self._is_per_area(context):
            return np.asarray(array)[()]
        energies = array.view(CellEnergies)
        energies.grid = self.grid
        return energies
