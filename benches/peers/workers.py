"""Solver processes, one for each code and environment; requests are sequential."""

import json
import os
import pathlib
import select
import subprocess
import time

HERE = pathlib.Path(__file__).resolve().parent
THREAD_VARIABLES = (
    "OMP_NUM_THREADS",
    "RAYON_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
)
# Pause before each request: the threads of the previous code may still spin for a moment, which must not slow down the
# next code.
PAUSE = 0.05


class Worker:
    """Process that replies to each line of input with one line. A process that does not answer in time is replaced."""

    def __init__(self, command, threads, patience, environment=None):
        self.command, self.patience = command, patience
        settings = {name: str(threads) for name in THREAD_VARIABLES}
        self.environment = {**os.environ, **settings, **(environment or {})}
        self.process = None

    def ask(self, line):
        if self.process is None:
            self._start()
        time.sleep(PAUSE)
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        return self._read(self.patience)

    def close(self):
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process = None

    def _start(self):
        self.process = subprocess.Popen(
            self.command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            env=self.environment,
        )
        self._read(120)

    def _read(self, patience):
        ready, _, _ = select.select([self.process.stdout], [], [], patience)
        line = self.process.stdout.readline() if ready else ""
        if not line:
            self.close()
            return {"status": f"not done in {patience:.0f} s" if not ready else "crashed"}
        return json.loads(line)


class Ours:
    """The library under test, which also computes the errors of all solutions."""

    def __init__(self, binary, threads, patience, folder):
        self.worker = Worker([binary, "serve"], threads, patience)
        self.folder = folder

    def solve(self, problem, scene, tolerance, output=None):
        output = output or self.folder / "ours.f64"
        words = [problem, scene["gap"], scene["cells"], scene["pressure"]]
        if problem == "shear":
            words += [scene["friction"], scene["loading"]]
        return self.worker.ask(" ".join(str(word) for word in [*words, tolerance, output]))

    def truth(self, problem, scene):
        """Returns the file of the reference solution of a scene, which is computed once."""
        path = self.folder / f"{problem}-{scene['scene'].replace('%', '')}-{scene['cells']}.f64"
        if not path.exists():
            answer = self.solve(problem, scene, 1e-11, path)
            if answer["status"] != "converged":
                raise SystemExit(f"the reference of {path.stem} has not converged: {answer}")
        return path

    def judge(self, problem, scene, found):
        total = scene["pressure"]
        if problem == "shear":
            total *= scene["friction"] * scene["loading"]
        component = "zz" if problem == "press" else "xx"
        truth = self.truth(problem, scene)
        return self.worker.ask(f"judge {component} {found} {truth} {scene['cells']} {total}")

    def measured(self, problem, scene, tolerance):
        answer = self.solve(problem, scene, tolerance)
        return {**answer, **self.judge(problem, scene, self.folder / "ours.f64")}


class Peer:
    """A peer in the virtual environment."""

    def __init__(self, code, python, threads, patience, folder, environment):
        command = [python, str(HERE / "worker.py")]
        self.worker = Worker(command, threads, patience, environment)
        self.code, self.output = code, folder / "peer.f64"

    def solve(self, problem, scene, options, tolerance):
        request = {
            **scene,
            "code": self.code,
            "problem": problem,
            "setting": options,
            "tolerance": tolerance,
            "output": str(self.output),
        }
        return self.worker.ask(json.dumps(request))

    def measured(self, problem, scene, options, tolerance, judge):
        answer = self.solve(problem, scene, options, tolerance)
        if "whole" in answer:
            answer |= judge.judge(problem, scene, self.output)
        return answer
