"""Warnings about solutions, issued through Python's ``warnings``."""

from __future__ import annotations

import sys
import warnings

from .errors import ContactWarning


def warn(remarks: list[tuple[str, str]]) -> None:
    """Issues warnings, given as pairs of kind and sentence, for the line from which the package is called.

    The filters of ``warnings`` identify a warning by its sentence. A loop over loads would therefore repeat a warning
    whenever its number of cells changes. To avoid this, a kind that was shown at a location counts as shown there,
    whatever its numbers.
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
        warning = ContactWarning(sentence)
        warning.kind = kind
        warnings.warn_explicit(warning, ContactWarning, frame.f_code.co_filename, line, name, registry)
        registry[place] = sentence
