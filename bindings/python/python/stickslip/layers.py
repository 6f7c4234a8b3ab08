"""Coated bodies: layers on a body, and the response of such bodies to waves."""

from ._stickslip import Layer, WaveResponse

__all__ = ["Layer", "WaveResponse"]
