"""Checks of arguments, with exceptions that name the argument."""

from __future__ import annotations

import inspect
import os
from collections.abc import Sequence
from numbers import Integral, Real
from typing import NoReturn

import numpy as np

from .errors import ArgumentRange, ArgumentType


def kind(value: object) -> str:
    """Returns the class of an object, in words."""
    if isinstance(value, type):
        return f"the class {value.__name__}"
    return "None" if value is None else f"an object of the class {type(value).__name__}"


def refuse_type(name: str, problem: str) -> NoReturn:
    """Raises an error for an argument of a wrong type."""
    error = ArgumentType(f"{name} {problem}")
    error.argument = name
    raise error


def check_whole(name: str, value: object, smallest: int, remedy: str = "") -> None:
    """Raises an error unless a value is a whole number of at least the smallest."""
    if isinstance(value, bool) or not isinstance(value, Real):
        refuse_type(name, f"must be a whole number, got {kind(value)}{remedy}")
    is_whole = isinstance(value, Integral) or float(value).is_integer()
    if not is_whole or value < smallest:
        error = ArgumentRange(f"{name} must be a whole number of at least {smallest}, got {value}")
        error.argument = name
        raise error
    if not value <= 2**53:
        error = ArgumentRange(f"{name} must be at most 2**53, got {value}")
        error.argument = name
        raise error


def path_of(path: object) -> str:
    """Returns a path as text, or raises an error."""
    try:
        name = os.fsdecode(path)  # type: ignore[arg-type]
    except TypeError:
        refuse_type("path", f"must be a path, got {kind(path)}")
    if not name:
        error = ArgumentRange("path must not be empty")
        error.argument = "path"
        raise error
    return name


def check_call(name: str, function: object, *parameters: str) -> None:
    """Raises an error if a function does not accept these arguments by position. Functions without a signature are not checked."""
    try:
        signature = inspect.signature(function)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return
    try:
        signature.bind(*parameters)
    except TypeError:
        due = "one argument" if len(parameters) == 1 else f"{len(parameters)} arguments"
        refuse_type(name, f"must accept {due} by position ({', '.join(parameters)}), got a function with the parameters {signature}")


def require(name: str, value: object, attributes: Sequence[str], due: str, entry: str = "") -> None:
    """Raises an error unless an argument, or an entry of it, has the attributes that are read."""
    if isinstance(value, type) or not all(hasattr(value, attribute) for attribute in attributes):
        refuse_type(name, f"must be {due}, got {entry}{kind(value)}")


def require_entries(name: str, value: object, attributes: Sequence[str], due: str) -> None:
    """Raises an error unless an argument is a sequence whose entries have these attributes."""
    if isinstance(value, (str, np.ndarray)) or not isinstance(value, Sequence):
        refuse_type(name, f"must be {due}, got {kind(value)}")
    for entry in value:
        require(name, entry, attributes, due, "a sequence with ")
