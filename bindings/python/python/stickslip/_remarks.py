"""The remarks on solutions as warnings of Python."""

from __future__ import annotations

import sys
import warnings

from .errors import ContactWarning


def warn(remarks: list[tuple[str, str]]) -> None:
    """Warns of remarks, each its kind and its sentence, at the line from which the package is called.

    The filters of ``warnings`` know a warning by its sentence. So that a loop of loads does not warn again of the same
    with another number of cells, a kind that was shown at a place counts as shown there, whatever its numbers.
    """
    frame = sys._getframe(1)
    while frame.f_globals.get("__name__", "").split(".")[0] == __package__ and frame.f_back is not None:
        frame = frame.f_back
    line, registry = frame.f_lineno, frame.f_globals.setdefault("__warningregistry__", {})
    for kind, sentence in remarks:
        place = (kind, ContactWarning, line)
        if registry.get((registry.get(place), ContactWarning, line)):
            registry[sentence, ContactWarning, line] = True
        name = frame.f_globals.get("__name__", "<unknown>")
        warnings.warn_explicit(sentence, ContactWarning, frame.f_code.co_filename, line, name, registry)
        registry[place] = sentence
