"""Coated bodies: layers on a body, and the response of coated bodies to waves."""

from ._stickslip import Layer, WaveResponse

__all__ = ["Layer", "WaveResponse"]
