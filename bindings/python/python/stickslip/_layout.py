"""Layout of figures that have no layout yet."""

from __future__ import annotations

from typing import Any

from matplotlib.layout_engine import ConstrainedLayoutEngine


class SettledLayout(ConstrainedLayoutEngine):
    """The constrained layout, executed twice, because the tick labels depend on the size that the first pass gives to axes
    with equal aspect."""

    def execute(self, fig: Any) -> Any:
        super().execute(fig)
        return super().execute(fig)
