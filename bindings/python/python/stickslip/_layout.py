"""The layout of figures that were given none."""

from __future__ import annotations

from typing import Any

from matplotlib.layout_engine import ConstrainedLayoutEngine


class SettledLayout(ConstrainedLayoutEngine):
    """The constrained layout, twice: the names of ticks depend on the size that it gives to axes of true proportions."""

    def execute(self, fig: Any) -> Any:
        super().execute(fig)
        return super().execute(fig)
