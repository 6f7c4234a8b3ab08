"""Use of the package in forked processes, and the number of started threads."""

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


# The numbers of cells are below and above the limit up to which work stays on the calling thread. Each case has its own
# process, without an earlier, smaller contact.
@pytest.mark.parametrize("cells", [32, 96])
@pytest.mark.parametrize("threads", [1, 2])
def test_package_works_in_forked_process(cells, threads):
    run(cells, threads)
