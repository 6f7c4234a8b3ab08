"""Closed-form solutions for comparison. Each is an object with scalar results and functions of position, which accept
numbers or arrays.

In the formulas, E* is the contact modulus of the pair. G and nu are shear modulus and Poisson's ratio of the single body
with the compliance of both bodies (:class:`~stickslip.ElasticPair` has all three). mu is the coefficient of friction, W
the normal load, a the contact radius or half-width, and p_0 the largest pressure. Johnson (1985) is K. L. Johnson,
Contact Mechanics. The references are those of the Rust crate, whose documentation contains the derivations.
"""

from ._stickslip import (
    BentallJohnson,
    Carter,
    CattaneoMindlin,
    CattaneoMindlinEllipse,
    CattaneoMindlinLine,
    Cone,
    ConePartialSlip,
    FlatPunch,
    HertzEllipse,
    HertzLine,
    HertzSphere,
    KalkerCoefficients,
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
    VermeulenJohnson,
    Westergaard,
    WestergaardPartialSlip,
    linear_stick_ratio,
)

__all__ = [
    "BentallJohnson",
    "Carter",
    "CattaneoMindlin",
    "CattaneoMindlinEllipse",
    "CattaneoMindlinLine",
    "Cone",
    "ConePartialSlip",
    "FlatPunch",
    "HertzEllipse",
    "HertzLine",
    "HertzSphere",
    "KalkerCoefficients",
    "LubkinTorsion",
    "MindlinDeresiewicz",
    "MindlinFullStick",
    "NoSlipPunch",
    "NoSlipSphere",
    "Persson",
    "PopovLimitingShape",
    "RoughSphere",
    "RoundedPunch",
    "SpencePressing",
    "VermeulenJohnson",
    "Westergaard",
    "WestergaardPartialSlip",
    "linear_stick_ratio",
]
