"""Arrays of the energies of cells and of energies per area, which contain their grid, and read-only arrays."""

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


def _is_area(number: Any, grid: Grid) -> bool:
    """Returns whether a number is the area of a cell."""
    return isinstance(number, (float, np.floating)) and abs(float(number) / grid.cell_area - 1.0) < 1e-9


class _GridArray(np.ndarray[Any, np.dtype[np.float64]]):
    """Array of one number per cell with its grid. The grid is ``None`` if the shape differs from that of the grid."""

    grid: Grid | None

    def __array_finalize__(self, source: Any) -> None:
        grid = getattr(source, "grid", None)
        self.grid = grid if grid is not None and grid.shape == self.shape else None

    @classmethod
    def of(cls, array: NDArray[Any], grid: Grid | None) -> Any:
        """Returns a view of an array of numbers on this grid."""
        view = array.view(cls)
        view.grid = grid
        return view

    def __reduce__(self) -> tuple[Any, ...]:
        reduced: Any = super().__reduce__()
        restore, arguments, state = reduced
        return restore, arguments, (self.grid, state)

    def __setstate__(self, state: Any) -> None:
        self.grid, own = state
        super().__setstate__(own)


class CellEnergies(_GridArray):
    """Array of one energy per cell with its grid, from which the wear laws take the area of a cell. A quotient by the area of a
    cell is an array of energies per area."""

    def _is_divided_by_area(self, context: Any) -> bool:
        """Returns whether an operation of NumPy divides by the area of a cell."""
        if self.grid is None or context is None or context[0] is not np.true_divide:
            return False
        return _is_area(context[1][1], self.grid)

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        if array.shape != self.shape or array.dtype != np.float64:
            return np.asarray(array)[()]
        if self._is_divided_by_area(context):
            return EnergiesPerArea.of(array, self.grid)
        return CellEnergies.of(array, self.grid)


class EnergiesPerArea(_GridArray):
    """Array of one energy per area of each cell. The wear laws reject it, because they divide energies by the area of a cell. Its
    product with the area of a cell is an array of energies. A result that also depends on a plain array is a plain array."""

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        inputs = () if context is None else context[1]
        is_mixed = any(np.ndim(given) > 0 and not isinstance(given, EnergiesPerArea) for given in inputs)
        if array.shape != self.shape or array.dtype != np.float64 or is_mixed:
            return np.asarray(array)[()]
        grid = self.grid
        if grid is not None and context is not None and context[0] is np.multiply:
            if any(_is_area(given, grid) for given in inputs):
                return CellEnergies.of(array, grid)
        return EnergiesPerArea.of(array, grid)
