"""Execution of all examples in a separate folder, and of the examples in docstrings and READMEs."""

import doctest
import os
import pathlib
import pkgutil
import importlib
import re
import subprocess
import sys

import pytest

import stickslip as ss

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"
OF_PEERS = {"against_peers.py"}  # requires the packages that it compares


def run(arguments, folder):
    environment = {**os.environ, "MPLBACKEND": "Agg", "PYTHONWARNINGS": "error::UserWarning"}
    answer = subprocess.run(
        [sys.executable, *arguments], cwd=folder, env=environment, capture_output=True, text=True, timeout=300
    )
    assert answer.returncode == 0, answer.stderr
    return answer.stdout


@pytest.mark.parametrize("name", sorted({path.name for path in EXAMPLES.glob("*.py")} - OF_PEERS))
def test_example_runs(name, tmp_path):
    assert run([str(EXAMPLES / name)], tmp_path)


def modules():
    return ["stickslip"] + [found.name for found in pkgutil.walk_packages(ss.__path__, "stickslip.")]


def test_docstring_examples_run():
    tried = 0
    for name in modules():
        module = importlib.import_module(name)
        for test in doctest.DocTestFinder(exclude_empty=True).find(module, name.split(".")[-1]):
            outcome = doctest.DocTestRunner().run(test)
            assert outcome.failed == 0, test.name
            tried += outcome.attempted
    assert tried > 60


@pytest.mark.parametrize("readme", [EXAMPLES.parent / "README.md", EXAMPLES.parents[2] / "README.md"])
def test_readme_examples_run(readme, tmp_path):
    blocks = re.findall(r"```python\n(.*?)```", readme.read_text(), re.S)
    assert blocks
    # The examples for clusters are covered by the tests of ranks, on fewer cells.
    blocks = [block for block in blocks if "mpi4py" not in block]
    run(["-c", "\n".join(blocks)], tmp_path)


PLAN = ["--cells", "16", "--cut-off", "4", "--seeds", "1-3", "--pressures", "0.02,0.1"]


def study(folder, out, *options):
    run([str(EXAMPLES / "study.py"), *PLAN, "--workers", "2", "--out", out, *options], folder)
    return sorted((folder / out).read_bytes().splitlines())


def test_study_rows_are_equal_for_all_engines(tmp_path):
    rows = study(tmp_path, "processes.csv")
    assert len(rows) == 2 + 12
    shards = [study(tmp_path, f"part-{part}.csv", "--shard", f"{part}/2") for part in (1, 2)]
    assert sorted({*shards[0], *shards[1]}) == rows and len(shards[0]) + len(shards[1]) == 2 * 2 + 12
    # The study continues after an incomplete last line and skips a damaged line.
    text = (tmp_path / "processes.csv").read_bytes()
    lines = text.split(b"\n")
    lines[5] = lines[5][:30]
    (tmp_path / "cut.csv").write_bytes(b"\n".join(lines)[:-60])
    assert set(study(tmp_path, "cut.csv")) == {*rows, lines[5]}
    pytest.importorskip("distributed")
    assert study(tmp_path, "dask.csv", "--engine", "dask") == rows
