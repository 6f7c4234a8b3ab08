"""Wear of the gap over many cycles, with jumps over cycles that equal the last cycle."""

from __future__ import annotations

import contextlib
import errno
import itertools
import os
import shutil
import zipfile
import zlib
from collections.abc import Callable
from dataclasses import dataclass, fields
from numbers import Real
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import read_only
from ._checks import check_call, check_whole, kind, path_of, refuse_type
from ._enums import WearEnding
from ._progress import cycle_bar, is_stop
from ._remarks import warn
from ._stickslip import Cycle, Field, HalfSpace, History, State
from ._tables import to_frame
from ._wear_resume import check_contact, check_resume
from ._wear_laws import CycleWear, JumpLaw, JumpWear, Limits, digest, law_in_words
from ._wear_remarks import largest_displacement, remarks_on_limits, remarks_on_wear
from .errors import ArgumentRange, File, Format, StickslipError

if TYPE_CHECKING:
    from .history import FrettingLoop

# Numbers in the names of partial files.
_PARTIAL_FILES = itertools.count()

# Exceptions of NumPy for a file that is not an archive of arrays, or is damaged.
_DAMAGE = (ValueError, TypeError, LookupError, AttributeError, EOFError, zipfile.BadZipFile, zlib.error)


class _WithArrays:
    """A dataclass whose arrays are read-only. A change in place would otherwise change a run, or have no effect."""

    def __post_init__(self) -> None:
        self._protect(self.__dict__)

    def __setstate__(self, attributes: dict[str, Any]) -> None:
        # Pickled arrays of NumPy are writable.
        self._protect(attributes)

    def _protect(self, attributes: dict[str, Any]) -> None:
        for name, value in list(attributes.items()):
            object.__setattr__(self, name, read_only(value) if isinstance(value, np.ndarray) else value)


@dataclass(frozen=True, eq=False)
class WearHistory(_WithArrays):
    """Quantities during wear, as read-only arrays with one entry per computed gap.

    Each entry describes the cycle that was computed on this gap. The last entry describes the final gap, unless the run was
    stopped or interrupted before its cycle was computed.
    """

    cycles: NDArray[Any]
    """Number of cycles that wore the gap in this run and the runs that it resumes."""
    jump: NDArray[Any]
    """Number of cycles that the computed cycle represents; zero in the last entry of a complete run."""
    computed_cycles: NDArray[Any]
    """Number of cycles that were computed on this gap until one closed."""
    worn_volume: NDArray[Any]
    """Volume removed so far."""
    max_depth: NDArray[Any]
    """Largest depth removed so far (a length)."""
    dissipated_energy: NDArray[Any]
    """Energy dissipated so far, including the cycles jumped over."""
    energy_per_cycle: NDArray[Any]
    """Energy dissipated in the cycle."""
    contact_area: NDArray[Any]
    """Area of the contact at the end of the cycle, with the correction of ``contact_area_corrected``."""
    contact_radius: NDArray[Any]
    """Radius of a circle with this area (a length)."""
    approach: NDArray[Any]
    """Approach at the end of the cycle (a length)."""
    normal_force: NDArray[Any]
    """Normal force at the end of the cycle."""
    force_amplitude_x: NDArray[Any]
    """Half the range of the tangential force along x."""
    force_amplitude_y: NDArray[Any]
    """Half the range of the tangential force along y."""
    shift_amplitude_x: NDArray[Any]
    """Half the range of the shift along x (a length)."""
    shift_amplitude_y: NDArray[Any]
    """Half the range of the shift along y (a length)."""
    cyclic_residual: NDArray[Any]
    """:attr:`Cycle.cyclic_residual` of the cycle."""

    @staticmethod
    def _of(rows: tuple[tuple[float, ...], ...]) -> WearHistory:
        names = [field.name for field in fields(WearHistory)]
        columns = np.array(rows, dtype=float).reshape(len(rows), len(names)).T
        whole = {"cycles", "jump", "computed_cycles"}
        return WearHistory(*(column.astype(int) if name in whole else column for name, column in zip(names, columns)))

    def __len__(self) -> int:
        return len(self.cycles)

    def to_dict(self) -> dict[str, NDArray[Any]]:
        """Returns the arrays by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}

    def to_frame(self) -> Any:
        """Returns a :class:`pandas.DataFrame` with one row per computed gap (requires pandas)."""
        return to_frame(self.to_dict())

    def __repr__(self) -> str:
        return f"WearHistory({len(self)} gaps)"


@dataclass(frozen=True, eq=False)
class WearSnapshot(_WithArrays):
    """State of a run between two cycles, from which :func:`run` resumes.

    The results are bitwise identical to those of an uninterrupted run, provided that its jumps were not shortened. The last
    jump of a run is shortened to the requested number of cycles, so that a continuation with more cycles has other jumps.
    The arrays are read-only.

    Snapshots can be pickled, and saved to a file by :meth:`save`.
    """

    state: State
    """State of the history, with the worn gap."""
    cycles: int
    """Number of cycles that wore the gap in this run and the runs that it resumes."""
    depth: NDArray[Any]
    """Depth removed from both bodies together in this run and the runs that it resumes (lengths)."""
    dissipation: NDArray[Any]
    """Energy that each cell dissipated in this run and the runs that it resumes, including the cycles jumped over."""
    dissipated_energy: float
    """Energy dissipated so far, including the cycles jumped over: the sum of ``dissipation``, except for round-off."""
    rows: tuple[tuple[float, ...], ...]
    """Entries of :class:`WearHistory`."""
    law: str
    """The wear law, in words. A run resumes with the same law only."""
    loop: str
    """The steps of the cycle, in words. A run resumes with the same steps only."""
    first_step: int
    """:attr:`History.steps` at the start of the first of these runs. Wear before this step is part of the gap, and is not counted."""

    @property
    def history(self) -> WearHistory:
        """The quantities during wear so far."""
        return WearHistory._of(self.rows)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Saves the snapshot to a file, which is replaced completely or not at all. A symbolic link is followed.

        Raises
        ------
        ArgumentType, ArgumentRange
            If the path is not a path, or is empty.
        File
            If the file cannot be written.
        """
        name = path_of(path)
        target = os.path.realpath(name)
        # Several threads may save snapshots to one file.
        partial = f"{target}.{os.getpid()}.{next(_PARTIAL_FILES)}.part"
        try:
            if os.path.exists(target) and not (os.path.isfile(target) or os.path.isdir(target)):
                raise OSError(errno.EINVAL, "the path is not a regular file")
            with open(partial, "wb") as file:
                np.savez_compressed(
                    file,
                    state=np.frombuffer(self.state.to_bytes(), np.uint8),
                    cycles=self.cycles,
                    depth=self.depth,
                    dissipation=self.dissipation,
                    dissipated_energy=self.dissipated_energy,
                    rows=np.array(self.rows, dtype=float),
                    law=self.law,
                    loop=self.loop,
                    first_step=self.first_step,
                )
            if os.path.isfile(target):
                with contextlib.suppress(OSError):
                    shutil.copymode(target, partial)  # some file systems have no permissions
            os.replace(partial, target)
        except OSError as cause:
            raise _not_written(name, cause) from cause
        finally:
            with contextlib.suppress(OSError):
                os.remove(partial)  # after the renaming there is none

    @staticmethod
    def load(path: str | os.PathLike[str]) -> WearSnapshot:
        """Loads a snapshot written by :meth:`save`.

        Raises
        ------
        Format
            If the file is not a snapshot or is damaged. The attribute ``file`` is its path.
        OSError
            If the file cannot be read.
        """
        name = path_of(path)
        with open(name, "rb") as opened:
            try:
                with np.load(opened, allow_pickle=False) as file:
                    return WearSnapshot(
                        State.from_bytes(file["state"].tobytes()),
                        int(file["cycles"]),
                        file["depth"],
                        file["dissipation"],
                        float(file["dissipated_energy"]),
                        tuple(tuple(map(float, row)) for row in file["rows"]),
                        str(file["law"]),
                        str(file["loop"]),
                        int(file["first_step"]),
                    )
            except (*_DAMAGE, StickslipError) as cause:
                opened.seek(0)
                problem, remedy = _not_a_snapshot(opened.read(4))
                error = Format(f"{name}: {problem}: {remedy}")
                error.file, error.format, error.place, error.problem = name, "snapshot", "file", problem
                raise error from cause

    def restored(self, bodies: HalfSpace) -> History:
        """Returns a history in the state of the snapshot, on the same bodies."""
        return History.from_state(bodies, self.state)

    def __repr__(self) -> str:
        return f"WearSnapshot(cycles={self.cycles}, max_depth={self.depth.max():g}, counted from step {self.first_step})"


@dataclass(frozen=True, eq=False)
class WearResult:
    """Result of :func:`run`."""

    ending: WearEnding
    """Reason for the end."""
    last: Cycle
    """The last computed cycle."""
    snapshot: WearSnapshot
    """The state at the end."""
    snapshots: tuple[WearSnapshot, ...]
    """The snapshots requested by ``snapshot_every``."""

    @property
    def cycles(self) -> int:
        """Number of cycles that wore the gap in this run and the runs that it resumes."""
        return self.snapshot.cycles

    @property
    def depth(self) -> NDArray[Any]:
        """Depth removed from both bodies together in this run and the runs that it resumes (lengths)."""
        return self.snapshot.depth

    @property
    def dissipation(self) -> NDArray[Any]:
        """Energy that each cell dissipated in this run and the runs that it resumes, including the cycles jumped over."""
        return self.snapshot.dissipation

    @property
    def history(self) -> WearHistory:
        """The quantities during wear."""
        return self.snapshot.history

    def __repr__(self) -> str:
        counted = f"counted from step {self.snapshot.first_step}"
        return f"WearResult(cycles={self.cycles}, ending='{self.ending}', {len(self.snapshot.rows)} gaps, {counted})"


def run(
    history: History,
    loop: FrettingLoop,
    law: Callable[[History, Cycle], ArrayLike] | JumpLaw,
    cycles: int,
    *,
    max_depth: float | None = None,
    largest_depth: float | Callable[[History], float] | None = None,
    largest_jump: int | None = None,
    max_residual: float = 0.05,
    settling: int = 10,
    snapshot_every: int | None = None,
    progress: Callable[[WearSnapshot], object] | bool | None = None,
    resume: WearSnapshot | None = None,
) -> WearResult:
    """Wears the gap of a history over many cycles, with jumps over cycles that equal the last computed cycle.

    On every gap, cycles are computed until one closes; it represents the following cycles. :class:`CycleJump` returns their
    number, limited by the stability of the worn gap and by the arguments. The depth of these cycles is removed from both
    bodies together, that is, it is added to the gap. Without slip, as in full stick, the depth is zero, and the remaining
    cycles are jumped over at once. The result then has the regime ``result.last.regime == "full_stick"`` and a depth of zero, and
    a warning is issued unless the coefficient of friction exceeds 5.

    Cycles, depth and energy are counted from the start of the run. A second run on the same history counts from zero, but its
    gap contains the wear of the first run; to continue the counts, pass ``resume=result.snapshot``.

    Parameters
    ----------
    history : History
        A history that is in contact. Its gap is worn, and it ends in the state of the result.
    loop : FrettingLoop
        The steps of a cycle. Every step must prescribe the normal load, because the gap changes. ``until_steady`` has no
        effect; ``max_residual`` replaces it.
    law : callable or JumpLaw
        A function of history and cycle that returns the depth that the cycle removes in each cell (lengths, not negative)
        as an array of shape (ny, nx), such as :class:`EnergyLaw` or :class:`ArchardLaw`. A single number is rejected, because
        it would also wear the cells outside the contact. The depth of a jump is this depth times the number of cycles.
        A law that depends on the energy dissipated before, such as :class:`ThresholdEnergyLaw`, is a :class:`JumpLaw` instead.
        See the notes for the properties of the history that a law must not use.
    cycles : int
        Total number of cycles, at most 2**53. It counts from the first cycle and includes the cycles of ``resume``, whose number
        must not be larger. With an equal number, the run adds no cycle and issues a warning.
    max_depth : float, optional
        The run ends when the largest depth removed since the start has reached this value (a length). The last jump is
        shortened to whole cycles, and exceeds the value by less than the depth of one cycle.
    largest_depth : float or callable, optional
        The largest depth that a jump may remove in any cell (a length), or a function of the history that returns it, such
        as ``lambda history: 0.05 * history.approach``. By default, only the stability limits a jump.
    largest_jump : int, optional
        The largest number of cycles of a jump.
    max_residual : float, default 0.05
        The largest :attr:`Cycle.cyclic_residual` of a cycle that represents the following cycles, at least 0 and less than 1.
    settling : int, default 10
        The largest number of cycles that are computed on a gap until one closes.
    snapshot_every : int, optional
        Number of cycles after which a snapshot is added to :attr:`WearResult.snapshots`, at the next end of a jump. A jump is not
        divided: a jump over 5000 cycles adds one snapshot, also for ``snapshot_every=100``. With ``largest_jump=100``, every
        interval of 100 cycles has its snapshot.
    progress : callable or bool, optional
        A function that is called after each jump with a :class:`WearSnapshot`. The run ends with the status "stopped" if the
        function returns ``False``.
        ``True`` shows a progress bar of the cycles (requires tqdm).
    resume : WearSnapshot, optional
        A snapshot from which the run continues. The state of the history is replaced by that of the snapshot. The law and the
        steps of the loop must be those of the snapshot. Bodies, model, coupling, friction, settings, hardness, entry rule,
        permanent set and pattern of relative displacement of the history must be those of the snapshot too. Its gap must be the
        gap of the snapshot, with or without the depth removed before. ``resume.restored(bodies)`` is such a history. The limits,
        such as ``largest_depth`` and ``settling``, may differ. Laws other than the three laws of this module are compared by
        their names only. Patterns are compared only if both displacements are not zero.

    Returns
    -------
    WearResult

    Raises
    ------
    ArgumentType
        If an argument has a wrong type, for example if ``loop`` and ``law`` are swapped, or if the law is a function with a wrong
        number of parameters.
    ArgumentRange
        If ``cycles``, ``max_residual``, ``settling``, ``largest_jump`` or ``snapshot_every`` is out of range, or if the snapshot
        contains more cycles.
    EmptyContact
        If the history is not in contact, for example because it has not been pressed.
    ValueError
        If the load of the loop is equal for different values of its path.
    Shape
        If the law does not return an array of shape (ny, nx).
    TypeError
        If the law returns energies, such as ``1e-13 * cycle.dissipation``, which lacks the division by the cell area.
    ValueError
        If the depth of a :class:`JumpLaw` decreases with the number of cycles.
    SnapshotMismatch
        If the law, the steps of the loop, or a property of the history that is listed at ``resume`` differs from that of the
        snapshot.
    CycleNotClosed
        If no cycle closed among the cycles computed on a gap.
    NoWholeCycle
        If one cycle removes more than ``largest_depth``, or more than the stability of the worn gap allows. The message names
        the smaller limit.

    Notes
    -----
    A law must take slip, pressure and energy from the cycle. The properties ``accumulated_dissipation``, ``accumulated_slip``,
    ``slip`` and ``steps`` of the history contain the computed steps only, without the cycles jumped over, but with
    cycles repeated until one closes. ``history.last_step`` is the last step of the cycle, not the cycle. The energy including
    the cycles jumped over is the argument ``dissipation`` of :meth:`JumpLaw.depth_of_jump`.

    The length of a jump of a :class:`JumpLaw` is limited by the cells that wear at its end. Their depth changes with their
    pressure by the depth of the next cycle times the number of cycles, divided by the pressure. Cells below a threshold
    set no limit.

    After an exception, also after Ctrl-C, the history is in the state after the last jump, and the attribute ``snapshot``
    of the exception contains it. Pass it as ``resume`` to continue.

    In addition to the warnings of its cycles, a run issues a :class:`~stickslip.errors.ContactWarning` of these kinds:

    - ``negligible_wear``: a complete run removed at most 1e-10 of the approach although cells dissipated energy. Common causes
      are a coefficient or a threshold in another unit. With a threshold, the depth without the threshold counts, and an energy
      per area below 1 % of the threshold has a warning of its own. A coefficient of zero has none.
    - ``ineffective_largest_depth``, ``ineffective_max_depth``: a finite number given for ``largest_depth`` or ``max_depth``
      exceeds 1000 times the approach at the start, as micrometres given as metres.
    - ``inconsistent_law``: a :class:`JumpLaw` ignores the energy dissipated before; see :meth:`JumpLaw.depth_of_jump`.
    - ``no_cycles_left``: the snapshot of ``resume`` already contains all cycles.

    A resumed run equals an uninterrupted run bitwise, except that the last jump of a complete run is shortened to the
    requested number of cycles. With more cycles, an uninterrupted run would have made this jump in full.

    Examples
    --------
    >>> import stickslip as ss
    >>> grid = ss.Grid.square(32, 0.3e-3)
    >>> steel = ss.Material(213e9, 0.29)
    >>> history = ss.History(ss.HalfSpace(grid, (steel, steel)), ss.surface.sphere(grid, 3.5e-3), 0.5)
    >>> step = history.step(normal_force=100.0)
    >>> path = ss.history.LoadPath.triangle((1e-6, 0.0), 8)
    >>> loop = ss.history.FrettingLoop(path, lambda shift: ss.LoadStep(normal_force=100.0, shift=shift))
    >>> result = ss.wear.run(history, loop, ss.wear.EnergyLaw(1e-13), 2000)
    >>> result.cycles, str(result.ending), bool(result.history.worn_volume[-1] > 0.0)
    (2000, 'cycle_limit', True)
    """
    _check_types(history, loop, law, progress, resume)
    _check(cycles, settling, largest_jump, snapshot_every)
    for name, value in (("max_depth", max_depth), ("max_residual", max_residual)):
        if (isinstance(value, bool) or not isinstance(value, Real)) and not (name == "max_depth" and value is None):
            refuse_type(name, f"must be a number, got {kind(value)}")
    try:
        max_depth = None if max_depth is None else float(max_depth)
    except OverflowError:
        error = ArgumentRange("max_depth must fit in a float, got a larger integer: omit max_depth for no limit")
        error.argument = "max_depth"
        raise error from None
    if max_depth is not None and not max_depth >= 0.0:
        error = ArgumentRange(f"max_depth must not be negative, got {max_depth}")
        error.argument = "max_depth"
        raise error
    if not 0.0 <= max_residual < 1.0:
        error = ArgumentRange(
            f"max_residual must be at least 0 and less than 1, got {max_residual}: five per cent are max_residual=0.05"
        )
        error.argument = "max_residual"
        raise error
    loop._check_loads()
    given = {"law": law_in_words(law), "loop": _loop_in_words(loop)}
    if resume is None:
        check_contact(history.contact)
        done, rows, total_energy = 0, [], 0.0
        depth, dissipation = np.zeros(history.grid.shape), np.zeros(history.grid.shape)
        counts: dict[str, Any] = {**given, "first_step": history.steps}
    else:
        check_resume(resume, cycles, given, history)
        history.set_state(resume.state)
        done, rows, total_energy = resume.cycles, list(resume.rows), resume.dissipated_energy
        depth, dissipation = resume.depth.copy(), resume.dissipation.copy()
        counts = {**given, "first_step": resume.first_step}
        # The last entry of a complete run describes the gap from which the run continues.
        if rows and rows[-1][1] == 0.0:
            rows.pop()
    cycle = Cycle(history)
    snapshots: list[WearSnapshot] = []
    wear = JumpWear(law, history) if isinstance(law, JumpLaw) else CycleWear(law)

    def taken() -> WearSnapshot:
        return WearSnapshot(history.state(), done, depth, dissipation, total_energy, tuple(rows), **counts)

    snapshot = taken()
    with cycle_bar(cycles, done, progress is True) as bar:
        try:
            warn(remarks_on_limits(largest_displacement(history), largest_depth=largest_depth, max_depth=max_depth))
            while True:
                computed = _settle(history, loop, cycle, settling, max_residual)
                row = _row(history, cycle, done, computed, depth, total_energy)
                is_worn_out = max_depth is not None and depth.max() >= max_depth
                if done >= cycles or is_worn_out:
                    ending = WearEnding.DEPTH if is_worn_out else WearEnding.CYCLE_LIMIT
                    rows.append(row)
                    snapshot = taken()
                    warn(remarks_on_wear(law, history, snapshot))
                    return WearResult(ending, cycle, snapshot, tuple(snapshots))
                limit = largest_depth(history) if callable(largest_depth) else largest_depth
                limits = Limits(min(cycles - done, largest_jump or cycles), cycles - done, limit, max_depth, max_residual)
                jump, removed = wear.jump(history, cycle, depth, dissipation, limits)
                depth = depth + removed
                dissipation = dissipation + jump * np.asarray(cycle.dissipation)
                history.set_gap(Field(history.grid, history.gap_as_set + removed))
                done += jump
                total_energy += jump * cycle.energy.dissipated_energy
                rows.append((row[0], float(jump), *row[2:]))
                snapshot = taken()
                if snapshot_every is not None and done // snapshot_every > (done - jump) // snapshot_every:
                    snapshots.append(snapshot)
                bar(jump)
                if callable(progress) and is_stop(progress(snapshot)):
                    return WearResult(WearEnding.STOPPED, cycle, snapshot, tuple(snapshots))
        except BaseException as error:
            history.set_state(snapshot.state)
            error.snapshot = snapshot  # type: ignore[attr-defined]
            raise


def _not_a_snapshot(start: bytes) -> tuple[str, str]:
    """Returns the problem of a file that is not a snapshot, by its first bytes, and the remedy."""
    for mark, name, program in ((b"\x1f\x8b", "gzip", "gunzip"), (b"BZh", "bzip2", "bunzip2"), (b"\xfd7zX", "xz", "unxz")):
        if start.startswith(mark):
            return f"the file is compressed by {name}", f"decompress it by {program}"
    if start == b"\x93STK":
        return "the file is a saved history", "load it by History.load"
    problem = "the file is not a snapshot of wear.run, or it is damaged"
    return problem, "give a file written by WearSnapshot.save"


def _not_written(name: str, cause: OSError) -> File:
    """Returns the exception for a file that cannot be written, as other writers raise it."""
    problem = f"{cause.strerror} (os error {cause.errno})"
    error = File(f"{name}: {problem}")
    error.path = error.filename = name
    error.problem = error.strerror = problem
    error.errno = cause.errno
    return error


def _check_types(history: object, loop: object, law: object, progress: object, resume: object) -> None:
    from .history import FrettingLoop  # this module is imported by `history`

    if not isinstance(history, History):
        refuse_type("history", f"must be a History, got {kind(history)}")
    if not isinstance(loop, FrettingLoop):
        refuse_type("loop", f"must be a FrettingLoop, got {kind(loop)}: the order is history, loop, law, cycles")
    if isinstance(law, type) or not (callable(law) or isinstance(law, JumpLaw)):
        remedy = "give a function of history and cycle, such as EnergyLaw(coefficient)"
        refuse_type("law", f"must be a function that returns the depth, got {kind(law)}: {remedy}")
    if isinstance(law, JumpLaw):
        check_call("law.depth_of_jump", law.depth_of_jump, "history", "cycle", "dissipation", "cycles")
    else:
        check_call("law", law, "history", "cycle")
    if not (progress is None or isinstance(progress, (bool, np.bool_)) or callable(progress)):
        refuse_type("progress", f"must be a function, True or None, got {kind(progress)}")
    if callable(progress):
        check_call("progress", progress, "snapshot")
    if not (resume is None or isinstance(resume, WearSnapshot)):
        remedy = "give result.snapshot or WearSnapshot.load(path)"
        refuse_type("resume", f"must be a WearSnapshot, got {kind(resume)}: {remedy}")


def _check(cycles: int, settling: int, largest_jump: int | None, snapshot_every: int | None) -> None:
    least: dict[str, tuple[object, int]] = {"cycles": (cycles, 0), "settling": (settling, 1)}
    optional = {"largest_jump": largest_jump, "snapshot_every": snapshot_every}
    least |= {name: (value, 1) for name, value in optional.items() if value is not None}
    for name, (value, smallest) in least.items():
        check_whole(name, value, smallest)


def _loop_in_words(loop: FrettingLoop) -> str:
    """Returns the number of steps, the step of the largest value, and a digest of the path and of the loads along it."""
    values = loop._path.cycles(1)
    steps = [loop._step(value) for value in values]
    largest = max(range(len(values)), key=lambda index: np.hypot(*values[index]))
    # The last argument of the reduced form contains the exact numbers; `repr` rounds them.
    loads = b"".join(step.__reduce__()[1][-1] for step in steps)
    number = digest(np.asarray(values, dtype=float).tobytes() + loads)
    return f"{len(values)} steps with {steps[largest]!r} at the largest value (digest {number})"


def _settle(history: History, loop: FrettingLoop, cycle: Cycle, settling: int, max_residual: float) -> int:
    """Computes cycles until one closes, and returns their number."""
    for computed in range(1, settling + 1):
        loop.cycle(history, cycle)
        if cycle.cyclic_residual <= max_residual:
            return computed
    return settling


def _row(
    history: History, cycle: Cycle, done: int, computed: int, depth: NDArray[Any], total_energy: float
) -> tuple[float, ...]:
    normal = history.normal
    area = normal.contact_area_corrected
    forces, shifts = cycle.force_amplitude, cycle.shift_amplitude
    volume = float(depth.sum()) * history.grid.cell_area
    contact = (area, float(np.sqrt(area / np.pi)), history.approach, normal.force)
    energies = (total_energy, cycle.energy.dissipated_energy)
    wear = (float(done), 0.0, float(computed), volume, float(depth.max()))
    return (*wear, *energies, *contact, *forces, *shifts, cycle.cyclic_residual)
