"""Ctrl-C in a terminal session: a solve or a loop ends, the state is unchanged, and the session continues."""

import fcntl
import os
import pty
import select
import signal
import subprocess
import sys
import termios
import time

import pytest

TIMEOUT = 60

PREPARE = """
import stickslip as ss
grid = ss.Grid.square({cells}, 1.0)
bodies = ss.HalfSpace(grid, (ss.Material(1.0, 0.3), ss.Material.rigid()), boundary='{boundary}')
heights = ss.surface.SelfAffine(rms_slope=0.1, seed=3).generate(grid).heights
gap = ss.surface.gap_from_heights(heights)
history = ss.History(bodies, gap, 0.3)
done = history.step(normal_force=0.001)
before = history.to_bytes()
"""


def at_a_terminal():
    """Gives the terminal to the child, which then receives Ctrl-C even if the tests run in the background."""
    fcntl.ioctl(0, termios.TIOCSCTTY, 0)
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Session:
    """Interactive interpreter on its own terminal."""

    def __init__(self):
        self.terminal, child = pty.openpty()
        environment = {**os.environ, "PYTHON_BASIC_REPL": "1", "TERM": "dumb"}
        self.process = subprocess.Popen(
            [sys.executable, "-q", "-i"],
            stdin=child,
            stdout=child,
            stderr=child,
            env=environment,
            start_new_session=True,
            preexec_fn=at_a_terminal,
        )
        os.close(child)
        self.text = ""

    def send(self, text):
        os.write(self.terminal, text.encode())

    def wait_for(self, expected):
        """Reads until the text has appeared, and discards it."""
        end = time.monotonic() + TIMEOUT
        while expected not in self.text:
            ready, _, _ = select.select([self.terminal], [], [], max(0.0, end - time.monotonic()))
            if not ready:
                raise AssertionError(f"no {expected!r} in {self.text[-2000:]!r}")
            self.text += os.read(self.terminal, 65536).decode(errors="replace")
        self.text = self.text.split(expected, 1)[1]

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.terminal)


@pytest.fixture
def session():
    session = Session()
    session.wait_for(">>> ")
    yield session
    session.close()


def interrupt(session, statement, after=0.3):
    """Types a statement and then Ctrl-C, and waits for the prompt. The tests of the crate cover the interruption of long
    calls."""
    session.send(f"print('star' + 'ted'); {statement}\n")
    session.wait_for("started")
    time.sleep(after)
    session.send("\x03")  # the terminal converts this character to a signal
    session.wait_for("KeyboardInterrupt")
    session.wait_for(">>> ")


def prepare(session, cells, boundary="periodic"):
    for line in PREPARE.format(cells=cells, boundary=boundary).strip().splitlines():
        session.send(line + "\n")
    session.send("print('rea' + 'dy')\n")
    session.wait_for("ready")


def goes_on(session):
    session.send("print('unchanged', history.to_bytes() == before)\n")
    session.wait_for("unchanged True")
    session.send("print('goes on', history.step(normal_force=0.002).normal_force > 0.0019)\n")
    session.wait_for("goes on True")


def test_ctrl_c_ends_long_solve(session):
    prepare(session, 512)
    interrupt(session, "history.step(normal_force=0.3, force_x=0.05)")
    goes_on(session)


def test_ctrl_c_ends_long_loop_of_short_solves(session):
    prepare(session, 48)
    interrupt(session, "[history.step(normal_force=0.001 + 1e-6 * k) for k in range(10**9)]")
    session.send("history.set_state(ss.history.State.from_bytes(before)); \n")
    goes_on(session)


def test_ctrl_c_ends_small_slow_contact(session):
    # The solve runs on the calling thread, where the observer checks for signals. A slow operator makes the solve long.
    prepare(session, 16)
    session.send("import numpy as np, time\n")
    slow = "ss.cgm.minimise(lambda x: (time.sleep(0.05), np.linspace(1.0, 1e4, 2000) * x)[1], -np.ones(2000))"
    interrupt(session, slow)
    goes_on(session)


def test_ctrl_c_ends_stresses_at_many_points(session):
    prepare(session, 256, "non_periodic")
    # The array of points is created in milliseconds. Its sums of 65 536 million terms take longer than the time limit of
    # the test.
    session.send("import numpy as np, time; points = np.full((4 * 10**6, 3), 0.1)\n")
    session.send("start = time.process_time(); few = ss.subsurface.at_points(bodies, 'one', history, points[:2000])\n")
    session.send("print('enough' if 2000 * (time.process_time() - start) > 60.0 else 'too few')\n")
    session.wait_for("\nenough")
    interrupt(session, "ss.subsurface.at_points(bodies, 'one', history, points)", after=1.0)
    goes_on(session)


# Long work other than a solve: the preparation, and the statement to be interrupted.
LONG = {
    "stiffness": (
        "contact = ss.NormalProblem(bodies, gap, force=0.02).solve()",
        "[contact.stiffness(bodies) for _ in range(100)]",
    ),
    "sensitivity": (
        "solver = ss.NormalSolver(bodies, gap, force=0.02); contact = solver.solve()",
        "solver.sensitivities(contact, [ss.sensitivity.Functional.elastic_energy()] * 1000)",
    ),
    "planes": (
        "planes = ss.subsurface.Planes(bodies, [0.01 * k for k in range(100)])",
        "planes.solve_all('one', history)",
    ),
    "volume": (
        "planes = ss.subsurface.Planes(bodies, [0.01 * k for k in range(100)])",
        "planes.write_vti('/dev/shm/stickslip_interrupted.vti', 'one', history)",
    ),
    "surface": (
        "rough = ss.surface.SelfAffine(rms_height=1.0, skewness=0.5, kurtosis=3.0, seed=1, cropped=True)",
        "[rough.generate(grid) for _ in range(100)]",
    ),
}


@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_ends_long_work_other_than_solve(session, name):
    prepare(session, 256)
    before, statement = LONG[name]
    session.send(before + "\n")
    interrupt(session, statement)
    goes_on(session)


def test_custom_signal_handler_lets_solve_continue():
    code = (
        PREPARE.format(cells=256, boundary="periodic")
        + """
import os, signal, threading
seen = []
signal.signal(signal.SIGUSR1, lambda *_: seen.append(1))
threading.Timer(0.05, lambda: os.kill(os.getpid(), signal.SIGUSR1)).start()
step = history.step(normal_force=0.3)
print(len(seen), step.normal_force)
"""
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=TIMEOUT, check=True)
    count, force = answer.stdout.split()
    assert count == "1" and float(force) == pytest.approx(0.3)


CREEP = """
import os, signal, threading
import stickslip as ss
grid = ss.Grid.square({cells}, 0.4e-3)
steel = ss.Material(213e9, 0.29)
bodies = ss.HalfSpace(grid, (steel, steel))
normal = ss.NormalProblem(bodies, ss.surface.sphere(grid, 3.5e-3), force=100.0).solve()
solver = ss.rolling.RollingProblem(bodies, normal, 0.5, creepage_x=1e-4).solver()
points = [(1e-4 * (1 + k % 40), 0.0, 0.0) for k in range(10**5)]
calls = []
def interrupt(iteration):
    calls.append(iteration)
    if len(calls) == 200:
        os.kill(os.getpid(), signal.SIGINT)
try:
    solver.creep_forces(points, progress=interrupt)
    print("completed")
except KeyboardInterrupt as error:
    print("interrupted", len(calls) == 200 and list(error.partial)[:200] == calls)
print(solver.creep_forces(points[:3])[2].force[0] > 0.0)
threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    solver.creep_forces(points)
    print("completed")
except KeyboardInterrupt as error:
    print("interrupted", len(error.partial) > 0)
"""


@pytest.mark.parametrize("cells", [24, 96])  # on the calling thread, and in the pool
def test_ctrl_c_ends_creep_forces_between_points(cells):
    code = CREEP.format(cells=cells)
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=TIMEOUT)
    assert answer.stdout.split() == ["interrupted", "True", "True", "interrupted", "True"], answer.stderr
