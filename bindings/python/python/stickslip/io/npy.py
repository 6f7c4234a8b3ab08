"""Fields in NPY files."""

from .._stickslip import npy_grid as grid
from .._stickslip import npy_parse as parse
from .._stickslip import npy_read as read
from .._stickslip import npy_to_bytes as to_bytes
from .._stickslip import npy_write as write

__all__ = ["grid", "parse", "read", "to_bytes", "write"]
