"""Fields as matrices in text files."""

from .._stickslip import csv_parse as parse
from .._stickslip import csv_read as read
from .._stickslip import csv_to_bytes as to_bytes
from .._stickslip import csv_write as write

__all__ = ["parse", "read", "to_bytes", "write"]
