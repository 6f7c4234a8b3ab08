"""Closed forms to compare with: each is an object with its numbers, and functions of position that take numbers or arrays."""

from ._stickslip import (
    CattaneoMindlin,
    CattaneoMindlinEllipse,
    CattaneoMindlinLine,
    Cone,
    ConePartialSlip,
    FlatPunch,
    HertzEllipse,
    HertzLine,
    HertzSphere,
    LubkinTorsion,
    MindlinDeresiewicz,
    MindlinFullStick,
    NoSlipPunch,
    NoSlipSphere,
    Persson,
    PopovLimitingShape,
    RoughSphere,
    RoundedPunch,
    SpencePressing,
    Westergaard,
    WestergaardPartialSlip,
    linear_stick_ratio,
)

__all__ = [name for name in dir() if not name.startswith("_")]
