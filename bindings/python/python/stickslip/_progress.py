"""Progress bars of ``progress=True``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Iteration
    from .adaptive import GridRecord


class _Bar:
    """Progress bar of tqdm that counts the calls."""

    unit: str

    def __init__(self) -> None:
        try:
            from tqdm.auto import tqdm  # type: ignore[import-untyped]
        except ImportError as error:
            raise ImportError("progress=True requires tqdm: pip install 'stickslip[progress]'") from error
        self._bar: Any = tqdm(unit=self.unit)

    def close(self) -> None:
        self._bar.close()


class Bar(_Bar):
    """Progress bar that shows products and residual of a solve."""

    unit = " products"

    def __call__(self, iteration: Iteration) -> None:
        self._bar.update(1)
        self._bar.set_postfix(residual=f"{iteration.residual:.1e}", free=iteration.free, refresh=False)


class GridBar(_Bar):
    """Progress bar that shows the grids of a solve and their estimated errors."""

    unit = " grids"

    def __call__(self, record: GridRecord) -> None:
        self._bar.update(1)
        errors = {name: f"{error:.1e}" for name, error in record.estimates.items()}
        self._bar.set_postfix(cells=record.grid.cells, **errors, refresh=False)
