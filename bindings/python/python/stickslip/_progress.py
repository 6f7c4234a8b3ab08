"""Progress bar of ``progress=True``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import Iteration


class Bar:
    """Progress bar of tqdm that shows products and residual of a solve."""

    def __init__(self) -> None:
        try:
            from tqdm.auto import tqdm  # type: ignore[import-untyped]
        except ImportError as error:
            raise ImportError("progress=True requires tqdm: pip install 'stickslip[progress]'") from error
        self._bar: Any = tqdm(unit=" products")

    def __call__(self, iteration: Iteration) -> None:
        self._bar.update(1)
        self._bar.set_postfix(residual=f"{iteration.residual:.1e}", free=iteration.free, refresh=False)

    def close(self) -> None:
        self._bar.close()
