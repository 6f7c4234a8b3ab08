#!/usr/bin/env python3
"""Writes python/stickslip/_stickslip.pyi with the docstrings of the module and the type hints that it contains with the
feature `stubs`. Needs maturin (`pip install maturin`), and compiles the crate in the development profile."""

import ast
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
HEADER = "# Written by stubs.py from the hints of the module.\n"


def readable(text: str) -> str:
    """Returns the stubs with readable type hints and unchanged docstrings, without the signatures that precede some of them."""
    text = re.sub(r'^( *"""\n) *\w+\(.*\)\n *--\n\s*?\n', r"\1", text, flags=re.M)
    parts = re.split(r'^( *"""\n.*?^ *"""\n)', text, flags=re.M | re.S)
    parts[::2] = [hints(part) for part in parts[::2]]
    imports = (
        "from collections.abc import Callable, Iterator, Sequence\nfrom typing import Any, Final, final\n\n"
        "from numpy import bool_, float64, uint8, uint32, uint64\nfrom numpy.typing import ArrayLike, NDArray\n"
    )
    # The docstring of the module comes first.
    text = "".join([*parts[:2], imports, names(text), *parts[2:]])
    return HEADER + re.sub(r"\n{3,}", "\n\n", text)


def names(text: str) -> str:
    """Returns the text of ``__all__``, or an empty text if it exists: only some versions of maturin write it."""
    nodes = ast.parse(text).body
    targets = [node.target for node in nodes if isinstance(node, ast.AnnAssign)]
    of_values = [target.id for target in targets if isinstance(target, ast.Name)]
    of_others = [node.name for node in nodes if isinstance(node, ast.ClassDef | ast.FunctionDef)]
    of_others = [name for name in of_others if name != "__getattr__"]
    is_written = any(isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__" for node in nodes)
    lines = [f'    "{name}",\n' for name in sorted({*of_values, *of_others})]
    return "" if is_written else f"\n__all__ = [\n{''.join(lines)}]\n"


def hints(text: str) -> str:
    text = text.replace("SupportsFloat | SupportsIndex", "float").replace("SupportsIndex", "int")
    while (shorter := re.sub(r"Supports(?:LenAnd)?GetItem\[(?:int, )?", "Sequence[", text)) != text:
        text = shorter
    text = re.sub(r"(: (?:Sequence\[)+float\]+)", r"\1 | NDArray[Any]", text)
    text = re.sub(r"\bCallable(?!\[)", "Callable[[NDArray[float64], NDArray[float64]], ArrayLike]", text)
    text = re.sub(r"\bdict(?!\[)", "dict[str, Any]", text)
    text = re.sub(r"\btuple(?!\[)", "tuple[Any, ...]", text)
    # Truth values are read by a function, which has no type hint.
    text = re.sub(r"(?<=, )(\w+)\s*=\s*(True|False)(?=[,)])", r"\1: bool = \2", text)
    # Loads given by position are accepted only to be rejected with the names of their keywords.
    text = text.replace("*positional", "*")
    text = re.sub(r"(\*\w+)(?=[,)])", r"\1: Any", text)
    text = re.sub(r"(?<!\w)ndarray", "NDArray[Any]", text)
    text = re.sub(r"^from (_typeshed|collections\.abc|numpy|numpy\.typing|typing) import .*\n", "", text, flags=re.M)
    return re.sub(r"^ *def __getattr__.*\n", "", text, flags=re.M)


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        command = ["maturin", "generate-stubs", "--profile", "dev", "--features", "stubs", "--out", folder]
        subprocess.run(command, cwd=HERE, check=True)
        made = pathlib.Path(folder, "stickslip", "_stickslip.pyi").read_text()
    (HERE / "python" / "stickslip" / "_stickslip.pyi").write_text(readable(made))


if __name__ == "__main__":
    main()
