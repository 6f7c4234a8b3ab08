#!/usr/bin/env python3
"""Writes python/stickslip/_stickslip.pyi: the type hints that the module carries with the feature `stubs`, without its
docstrings, which `help` shows. Needs maturin (`pip install maturin`), and compiles the crate for development."""

import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
HEADER = "# Written by stubs.py from the hints of the module.\n"


def readable(text: str) -> str:
    """Hints as people write them."""
    text = re.sub(r'^ *"""\n.*?^ *"""\n', "", text, flags=re.M | re.S)
    text = text.replace("SupportsFloat | SupportsIndex", "float").replace("SupportsIndex", "int")
    while (shorter := re.sub(r"Supports(?:LenAnd)?GetItem\[(?:int, )?", "Sequence[", text)) != text:
        text = shorter
    text = re.sub(r"(: (?:Sequence\[)+float\]+)", r"\1 | NDArray[Any]", text)
    text = re.sub(r": dict(?!\[)", ": dict[str, Any]", text)
    text = re.sub(r"(\*\w+)(?=[,)])", r"\1: Any", text)
    text = re.sub(r"(?<!\w)ndarray", "NDArray[Any]", text)
    # A function whose body was its docstring.
    text = re.sub(r"^( *def .*):\n", r"\1: ...\n", text, flags=re.M)
    text = re.sub(r"^from (_typeshed|numpy|numpy\.typing|typing) import .*\n", "", text, flags=re.M)
    text = re.sub(r"^def __getattr__.*\n", "", text, flags=re.M)
    imports = (
        "from collections.abc import Sequence\nfrom typing import Any, Final, final\n\n"
        "from numpy.typing import ArrayLike, NDArray\n"
    )
    return HEADER + imports + re.sub(r"\n{3,}", "\n\n", text)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        command = ["maturin", "generate-stubs", "--profile", "dev", "--features", "stubs", "--out", folder]
        subprocess.run(command, cwd=HERE, check=True)
        made = pathlib.Path(folder, "stickslip", "_stickslip.pyi").read_text()
    (HERE / "python" / "stickslip" / "_stickslip.pyi").write_text(readable(made))


if __name__ == "__main__":
    main()
