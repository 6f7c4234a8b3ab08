"""Multiple threads, multiple processes, and nested calls."""

import concurrent.futures
import multiprocessing
import os
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import stickslip as ss
from conftest import FORCE, Scene

TIMEOUT = 60


def approach_of(force):
    # The small contact is solved on the calling thread, the large contact in the pool.
    return [
        ss.NormalProblem(scene.bodies, scene.ball, force=force).solve().approach for scene in (Scene(32), Scene(96))
    ]


FORCES = [10.0 * k for k in range(1, 9)]


@pytest.fixture(scope="module")
def expected():
    return [approach_of(force) for force in FORCES]


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes_are_bitwise_identical(method, expected):
    # The pool of this process is already in use. A forked process must not wait for its threads.
    context = multiprocessing.get_context(method)
    with context.Pool(2) as pool:
        assert pool.map_async(approach_of, FORCES).get(TIMEOUT) == expected


def test_threads_are_bitwise_identical(expected):
    with concurrent.futures.ThreadPoolExecutor(4) as pool:
        assert list(pool.map(approach_of, FORCES, timeout=TIMEOUT)) == expected


def test_results_do_not_depend_on_thread_count(large):
    before = ss.num_threads()
    try:
        answers = []
        for threads in (1, 3):
            ss.set_num_threads(threads)
            assert ss.num_threads() == threads
            answers.append(large.normal())
        assert np.array_equal(answers[0].pressure, answers[1].pressure)
        with pytest.raises(ValueError):
            ss.set_num_threads(0)
    finally:
        ss.set_num_threads(before)


def test_other_threads_run_during_solve(rough):
    bodies, gap = rough
    problem = ss.NormalProblem(bodies, gap, force=0.02)
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(1e-3)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    problem.solve()
    elapsed, while_solving = time.perf_counter() - start, counted[0]
    stop.set()
    thread.join()
    assert while_solving > 0.1 * elapsed / 1e-3


def test_history_in_use_rejects_second_thread(rough):
    bodies, gap = rough
    history = ss.History(bodies, gap, 0.3)
    refused = []

    def meddle(_):
        thread = threading.Thread(target=attempt)
        thread.start()
        thread.join()

    def attempt():
        try:
            history.approach
        except RuntimeError as error:
            refused.append(str(error))

    history.step(normal_force=0.001, progress=meddle)
    assert refused and "in use" in refused[0]
    assert history.steps == 1


@pytest.mark.parametrize("cells", [48, 96])
def test_progress_is_called_before_each_product(cells):
    scene = Scene(cells)
    seen = []
    contact = ss.NormalProblem(scene.bodies, scene.ball, force=FORCE).solve(progress=seen.append)
    assert len(seen) >= contact.report.double_precision_products
    assert all(isinstance(iteration, ss.Iteration) for iteration in seen)
    assert seen[-1].residual < seen[0].residual


@pytest.mark.parametrize("cells", [48, 96])
def test_progress_exception_ends_solve(cells):
    scene = Scene(cells)
    history = scene.history()
    history.step(normal_force=FORCE)
    before = history.to_bytes()

    def refuse(iteration):
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        history.step(force_x=20.0, progress=refuse)
    assert history.to_bytes() == before
    with pytest.raises(RuntimeError, match="cannot start within"):
        history.step(force_x=20.0, progress=lambda _: scene.normal())
    assert history.to_bytes() == before
    assert history.step(force_x=20.0).tangential_force[0] == pytest.approx(20.0)


def test_progress_bar_of_tqdm_is_shown(large, capsys):
    pytest.importorskip("tqdm")
    large_contact = ss.NormalProblem(large.bodies, large.ball, force=FORCE).solve(progress=True)
    assert large_contact.report.is_converged
    assert "residual" in capsys.readouterr().err


def test_environment_variable_sets_thread_count():
    environment = {**os.environ, "RAYON_NUM_THREADS": "3"}
    code = "import stickslip; print(stickslip.num_threads())"
    answer = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True)
    assert answer.stdout.strip() == "3"
