"""Checks of the snapshot from which ``wear.run`` resumes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from ._remarks import warn
from .errors import ArgumentRange, EmptyContact, SnapshotMismatch

if TYPE_CHECKING:
    from ._stickslip import History, State
    from ._wear_run import WearSnapshot

_RESTORED = "resume with resume.restored(bodies) as history, or start a new run from it after the change"
_OTHER_BODIES = "resume with a history on the bodies of the snapshot, or start a new run without resume"


def check_contact(contact: NDArray[Any]) -> None:
    """Raises an error without contact."""
    if not contact.any():
        raise EmptyContact("the history is not in contact: press it by a step with a normal load before the run")


def check_resume(resume: WearSnapshot, cycles: int, given: dict[str, str], history: History) -> None:
    """Raises an error unless a run of this history, law and loop continues from a snapshot. ``given`` contains law and loop in
    words."""
    if cycles < resume.cycles:
        error = ArgumentRange(f"cycles must be at least {resume.cycles}, the number of cycles of the snapshot, got {cycles}")
        error.argument = "cycles"
        raise error
    kept, own = resume.state, history.state()
    for name in ("grid", "boundary", "pair"):
        _compare(name, getattr(kept, name), getattr(own, name), _OTHER_BODIES)
    _compare("model", _model(kept), _model(own))
    for name, found in given.items():
        expected = getattr(resume, name)
        if found != expected:
            # The words agree up to the digest if other steps differ, or digits that are not shown.
            is_hidden = expected.split(" (digest")[0] == found.split(" (digest")[0]
            hidden = " (the difference is in other steps, or in digits that are not shown)" if is_hidden else ""
            shown = f"is {expected}, got {found}{hidden}"
            _refuse(name, shown, f"resume with the same {name}, or start a new run from resume.restored(bodies)")
    for name in ("coupling", "friction", "hardness", "settings", "entry_rule"):
        _compare(name, getattr(kept, name), getattr(own, name))
    _compare("permanent_set", kept.yielded is not None, own.yielded is not None)
    if not _may_have_one_pattern(kept.relative_displacement, own.relative_displacement):
        _refuse("relative_displacement", "differs from that of the history", _RESTORED)
    _check_gap(resume, own)
    check_contact(kept.contact)
    if cycles == resume.cycles:
        warn([(
            "no_cycles_left",
            f"the snapshot already contains {cycles} cycles, so that no cycle is added: cycles counts from the first cycle of the "
            "run, not from the snapshot",
        )])  # fmt: skip


def _refuse(name: str, shown: str, remedy: str) -> NoReturn:
    mismatch = SnapshotMismatch(f"the {name} of the snapshot {shown}: {remedy}")
    mismatch.argument = name
    raise mismatch


def _compare(name: str, kept: object, own: object, remedy: str = _RESTORED) -> None:
    """Raises an error if a property of the history differs from that of the snapshot."""
    if kept != own:
        is_shown = str(kept) != str(own)
        shown = f"is {kept}, that of the history is {own}" if is_shown else f"{kept} differs from that of the history"
        _refuse(name, shown, remedy)


def _model(state: State) -> str:
    return "vector" if state.axis is None else f"scalar along {state.axis}"


def _may_have_one_pattern(kept: tuple[Any, Any] | None, own: tuple[Any, Any] | None) -> bool:
    """Returns whether two relative displacements can be amounts of one pattern. A zero displacement can have any pattern."""
    if kept is None or own is None:
        return kept is own
    first, second = (np.ravel(parts) for parts in (kept, own))
    largest = [np.abs(parts).max() for parts in (first, second)]
    if 0.0 in largest:
        return True
    first, second = first / largest[0], second / largest[1]
    cell = np.abs(first).argmax()
    return bool(np.abs(first / first[cell] - second / (second[cell] or np.inf)).max() <= 1e-9)


def _check_gap(resume: WearSnapshot, own: State) -> None:
    """Raises an error unless the gap of a history is that of the snapshot, with or without the depth removed before."""
    kept, found = np.asarray(resume.state.gap_as_set), np.asarray(own.gap_as_set)
    # The second number allows for the round-off of the sums of a gap far from its datum.
    accepted = 1e-9 * np.ptp(kept) + 1e-13 * np.abs(kept).max()
    differences = [float(np.abs(gap - kept).max()) for gap in (found, found + resume.depth)]
    if min(differences) > accepted:
        shown = f"differs from that of the history by {min(differences):.4g}"
        _refuse("gap", shown, "resume with resume.restored(bodies) as history, or start a new run without resume")
