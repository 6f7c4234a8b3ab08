"""Whatever a process has used of the package, a forked one can use too; no thread is started but those asked for."""

import pathlib
import subprocess
import sys

import pytest

EVERYTHING = pathlib.Path(__file__).with_name("everything.py")
TIMEOUT = 300

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="it counts threads in /proc")


def run(*arguments):
    command = [sys.executable, str(EVERYTHING), *map(str, arguments)]
    answer = subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT)
    assert answer.returncode == 0, answer.stderr
    assert int(answer.stdout) > 400  # functions, methods and properties


# On both sides of the cells up to which all stays on the thread that calls; each in a process of its own, in which no
# smaller contact has been before.
@pytest.mark.parametrize("cells", [32, 96])
@pytest.mark.parametrize("threads", [1, 2])
def test_everything_works_in_a_forked_process(cells, threads):
    run(cells, threads)
