"""One contact on several ranks: bitwise identical to one process, for any communicator."""

import pickle
import queue
import shutil
import subprocess
import sys
import threading

import numpy as np
import pytest

import stickslip as ss
from ranks_of_mpi import GRID, PAIR, solved

TIMEOUT = 100


class Mail:
    """Communicator of ranks that are threads of this process, with one message queue per pair of ranks."""

    def __init__(self, rank, queues):
        self.rank, self.queues = rank, queues

    def Get_rank(self):
        return self.rank

    def Get_size(self):
        return len(self.queues)

    def sendrecv(self, sendobj, dest, source):
        assert type(sendobj) is bytes and self.rank not in (dest, source)
        self.queues[self.rank][dest].put(sendobj)
        return self.queues[source][self.rank].get(timeout=TIMEOUT)


def on_ranks(size, work, kind=Mail):
    """Returns the result of the work on each of the given number of ranks, or the exception that it raised."""
    queues = [[queue.SimpleQueue() for _ in range(size)] for _ in range(size)]
    outcomes = [None] * size

    def run(rank):
        try:
            outcomes[rank] = work(kind(rank, queues))
        except BaseException as error:
            outcomes[rank] = error

    threads = [threading.Thread(target=run, args=(rank,), daemon=True) for rank in range(size)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(TIMEOUT)
        assert not thread.is_alive(), "the ranks wait for each other"
    return outcomes


@pytest.fixture(scope="module")
def alone():
    return solved(ss.HalfSpace(GRID, PAIR))


def assert_same(slabs, alone):
    """Checks that the slabs form the fields of the whole grid, and that all other results are available on every rank."""
    whole, known = alone
    for name, field in whole.items():
        assert np.array_equal(np.concatenate([fields[name] for fields, _ in slabs]), field), name
    assert all(told == known for _, told in slabs)


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("size", [1, 2, 3])
def test_ranks_as_threads_are_bitwise_identical(size, threads, alone):
    # The number of threads of the pool, two, is less than the number of ranks.
    before = ss.num_threads()
    ss.set_num_threads(threads)
    try:
        outcomes = on_ranks(size, lambda comm: solved(ss.HalfSpace.distributed(GRID, PAIR, comm)))
    finally:
        ss.set_num_threads(before)
    for outcome in outcomes:
        if isinstance(outcome, BaseException):
            raise outcome
    assert_same(outcomes, alone)


def test_saved_history_continues_on_different_ranks(tmp_path):
    def begun(bodies):
        history = ss.History(bodies, ss.surface.sphere(bodies.grid, 3.5e-3), 0.5)
        history.step(normal_force=30.0)
        history.step(force_x=9.0)
        return history

    def goes_on(history):
        return history.step(force_x=-6.0).shift, history.step(normal_force=20.0).stick_ratio

    file = tmp_path / "history"
    on_ranks(2, lambda comm: begun(ss.HalfSpace.distributed(GRID, PAIR, comm)).save(file))
    found = on_ranks(3, lambda comm: goes_on(ss.History.load(ss.HalfSpace.distributed(GRID, PAIR, comm), file)))
    assert found == 3 * [goes_on(begun(ss.HalfSpace(GRID, PAIR)))]


def test_slabs_report_their_rows():
    def rows(comm):
        bodies = ss.HalfSpace.distributed(GRID, PAIR, comm, "periodic", "centre")
        with pytest.raises(TypeError, match="ranks"):
            pickle.dumps(bodies)
        return bodies.grid

    grids = on_ranks(3, rows)
    everywhere = np.arange(GRID.ny)
    assert np.array_equal(np.concatenate([everywhere[grid.rows] for grid in grids]), everywhere)
    assert np.array_equal(np.concatenate([grid.y for grid in grids]), GRID.y)
    assert [grid.extent[2] for grid in grids[1:]] == [grid.extent[3] for grid in grids[:-1]]
    assert (grids[0].extent[2], grids[-1].extent[3]) == GRID.extent[2:]
    assert {grid.whole for grid in grids} == {GRID} == {GRID.whole}
    assert GRID.rows == slice(0, GRID.ny, 1)


def test_ranks_with_inconsistent_input_raise():
    def press(comm):
        bodies = ss.HalfSpace.distributed(GRID, PAIR, comm)
        ball = ss.surface.sphere(bodies.grid, 3.5e-3)
        with pytest.raises(ss.errors.Ranks, match="normal load"):
            ss.NormalProblem(bodies, ball, force=100.0 + comm.rank)
        if comm.rank == 1:
            ball = np.full(bodies.grid.shape, np.nan)
        with pytest.raises(ss.errors.Sample if comm.rank == 1 else ss.errors.Ranks) as told:
            ss.NormalProblem(bodies, ball, force=100.0)
        return getattr(told.value, "rank", None)

    assert on_ranks(3, press) == [1, None, 1]


@pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")
def test_communicator_exception_counts_as_lost_rank(monkeypatch):
    class Failing(Mail):
        calls = 0

        def sendrecv(self, sendobj, dest, source):
            self.calls += 1
            if self.calls > 40:
                raise ConnectionError("the cable is cut")
            return super().sendrecv(sendobj, dest, source)

    told = []
    monkeypatch.setattr(sys, "unraisablehook", lambda failure: told.append(failure.exc_value))

    def press(comm):
        bodies = ss.HalfSpace.distributed(GRID, PAIR, comm)
        ball = ss.surface.sphere(bodies.grid, 3.5e-3)
        with pytest.raises(ss.errors.Ranks) as lost:
            ss.NormalProblem(bodies, ball, force=100.0).solve()
        return lost.value.rank

    assert on_ranks(2, press, Failing) == [1, 0]
    assert len(told) == 2 and all(isinstance(error, ConnectionError) for error in told)


def test_invalid_communicators_are_rejected():
    with pytest.raises(AttributeError):
        ss.HalfSpace.distributed(GRID, PAIR, object())


@pytest.mark.parametrize("size", [2, 3])
def test_mpi_processes_are_bitwise_identical(size, alone, tmp_path):
    pytest.importorskip("mpi4py")
    launcher = shutil.which("mpirun")
    if launcher is None:
        pytest.skip("no mpirun")
    version = subprocess.run([launcher, "--version"], capture_output=True, text=True, check=False).stdout
    options = ["--oversubscribe", "--allow-run-as-root"] if "Open MPI" in version else []
    program = [sys.executable, "-m", "mpi4py", __file__.replace("test_ranks", "ranks_of_mpi"), str(tmp_path)]
    subprocess.run([launcher, *options, "-n", str(size), *program], check=True, timeout=TIMEOUT)
    assert_same([pickle.loads((tmp_path / str(rank)).read_bytes()) for rank in range(size)], alone)
