"""Progress bars of ``progress=True``."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from . import Iteration
    from .adaptive import GridRecord
    from .rolling import CreepForce


def _tqdm(**options: Any) -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped]
    except ImportError as error:
        raise ImportError("progress=True requires tqdm: pip install 'stickslip[progress]'") from error
    return tqdm(**options)


class _Bar:
    """Progress bar of tqdm that counts the calls."""

    unit: str

    def __init__(self, total: int | None = None) -> None:
        self._bar = _tqdm(unit=self.unit, total=total)

    def close(self) -> None:
        self._bar.close()


class Bar(_Bar):
    """Progress bar that shows products and residual of a solve."""

    unit = " products"

    def __call__(self, iteration: Iteration) -> None:
        self._bar.update(1)
        self._bar.set_postfix(residual=f"{iteration.residual:.1e}", free=iteration.free, refresh=False)


@contextmanager
def cycle_bar(cycles: int, done: int, is_shown: bool) -> Iterator[Callable[[int], object]]:
    """Provides a function that advances a progress bar by the given number of cycles, or does nothing."""
    if not is_shown:
        yield lambda advance: None
        return
    bar = _tqdm(total=cycles, initial=done, unit=" cycles")
    try:
        yield bar.update
    finally:
        bar.close()


class PointBar(_Bar):
    """Progress bar that shows the solved points of a creep curve."""

    unit = " points"

    def __call__(self, point: CreepForce) -> None:
        self._bar.update(1)


def is_stop(answer: object) -> bool:
    """Returns whether a callback returned ``False``, which ends the call. ``None`` and all other values continue it."""
    return isinstance(answer, (bool, np.bool_)) and not answer


class GridBar(_Bar):
    """Progress bar that shows the grids of a solve and their estimated errors."""

    unit = " grids"

    def __call__(self, record: GridRecord) -> None:
        self._bar.update(1)
        errors = {name: f"{error:.1e}" for name, error in record.estimates.items()}
        self._bar.set_postfix(cells=record.grid.cells, **errors, refresh=False)
