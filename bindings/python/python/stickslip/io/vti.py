"""Images (VTI files) for ParaView."""

from .._stickslip import vti_to_bytes as to_bytes
from .._stickslip import vti_write as write

__all__ = ["to_bytes", "write"]
