#!/usr/bin/env python3
"""Writes THIRD_PARTY.md of the Python package and of the C library: each crate that is compiled into them, on any
platform, with its licence. With --check it fails if a file has changed. Needs cargo and the registry."""

import json
import pathlib
import re
import subprocess
import sys
import textwrap

HERE = pathlib.Path(__file__).parent
PACKAGES = {"stickslip-python": HERE / "python", "stickslip-c": HERE / "c"}
# Of the licences that a crate offers, the first of these is taken.
LICENCES = ("MIT", "Apache-2.0", "BSD-2-Clause")
MIT = (HERE.parent / "LICENSE").read_text().split("\n\n", 2)[2]
HEADER = """\
# Third-party notices

Compiled into this package, with their licences: these crates, and the standard library of Rust.

"""


def cargo(*arguments: str) -> str:
    return subprocess.run(["cargo", *arguments], cwd=HERE, check=True, capture_output=True, text=True).stdout


def compiled(package: str) -> list[str]:
    """The crates, as name and version, that are linked into a package on any platform."""
    edges = ["--edges", "normal,no-proc-macro", "--target", "all", "--prefix", "none"]
    lines = cargo("tree", "--package", package, *edges, "--format", "{p}").splitlines()
    return sorted({" ".join(line.split()[:2]) for line in lines if not line.startswith("stickslip")})


def licence(crate: dict) -> tuple[str, str]:
    """The licence that is taken of those offered, and its text in the source of the crate."""
    offered = re.split(r" OR |/", crate["license"])
    taken = next((name for name in LICENCES if name in offered), None)
    if taken is None:
        sys.exit(f"{crate['name']}: none of {', '.join(LICENCES)} in its licence, {crate['license']}")
    return taken, text(crate, taken)


def text(crate: dict, name: str) -> str:
    folder = pathlib.Path(crate["manifest_path"]).parent
    word = name.split("-")[0].upper()
    files = sorted(path for path in folder.iterdir() if path.name.upper().startswith(("LICENSE", "LICENCE", "COPYING")))
    of_name = [path for path in files if word in path.name.upper()]
    alone = [path for path in files if path.stem.upper() in {"LICENSE", "LICENCE", "COPYING"}]
    for path in of_name or alone:
        return path.read_text().strip()
    if name != "MIT":
        sys.exit(f"{crate['name']}: no text of its licence {name}")
    holders = ", ".join(re.sub(r" *<.*?>", "", author) for author in crate["authors"]) or f"the authors of {crate['name']}"
    return f"Copyright (c) {holders}\n\n{MIT}".strip()


def notices(package: str, crates: dict[str, dict]) -> str:
    by_text: dict[tuple[str, str], list[str]] = {}
    for name in compiled(package):
        taken, words = licence(crates[name])
        by_text.setdefault((taken, textwrap.dedent(words)), []).append(name)
    standard = f"Copyright (c) The Rust Project contributors\n\n{MIT}".strip()
    by_text.setdefault(("MIT", standard), []).append("std (Rust)")
    parts = []
    for (taken, words), names in sorted(by_text.items(), key=lambda item: item[1]):
        words = "\n".join(line.rstrip() for line in words.splitlines())
        parts.append(f"## {', '.join(names)}: {taken}\n\n```text\n{words}\n```\n")
    return HEADER + "\n".join(parts)


def main() -> None:
    metadata = json.loads(cargo("metadata", "--format-version", "1"))
    crates = {f"{crate['name']} v{crate['version']}": crate for crate in metadata["packages"]}
    for package, folder in PACKAGES.items():
        file, words = folder / "THIRD_PARTY.md", notices(package, crates)
        if "--check" not in sys.argv:
            file.write_text(words)
        elif file.read_text() != words:
            sys.exit(f"{file} is not that of Cargo.lock: run bindings/third_party.py")


if __name__ == "__main__":
    main()
