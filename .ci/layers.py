#!/usr/bin/env python3
"""Fails if an import does not point to a lower layer, if a sum over cells is outside parallel/reduce.rs, or if a library
file is too long. The script first tests itself; with --self-test it stops after this test."""

import pathlib
import re
import sys

# Folders and files directly in src, lowest layer first. A folder uses folders of lower layers only, so that no two folders
# depend on each other. CONTRIBUTING.md describes each folder.
LAYERS = [
    "support",
    "report",
    "error",
    "memory",
    "parallel",
    "grid numerics observer operator",
    "bodies cgm files warning",
    "analytical influence",
    "fft",
    "half_space",
    "contact dense io surface",
    "normal",
    "tangential",
    "coupled",
    "rolling",
    "history",
    "spots stiffness subsurface",
    "edges sensitivity",
    "adaptive",
    "guide lib",
]
# A folder that may use only these items of the other folder: a tangential problem reads a normal solution, not its solver.
ITEMS = {("tangential", "normal"): {"NormalSolution"}}

# All sums over cells are in parallel/reduce.rs, which fixes their order. These folders must not contain such sums.
WITHOUT_SUMS = ("cgm", "contact", "normal", "tangential", "coupled", "history", "rolling")
SUM = re.compile(r"parallel\s*::\s*(?:\{[^}]*\b)?fold\b|\.\s*sum\s*::\s*<\s*f(?:32|64)\s*>")

LONGEST_FILE = 600

COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|(b?r(#*)".*?"\2|b?"(?:\\.|[^"\\])*"|\'(?:\\.[^\']*|[^\'\\])\')', re.DOTALL)
PATH = re.compile(r"\b(?:crate|stickslip)\s*::\s*(\{|\w+)(?:\s*::\s*(\{[^;]*?\}|\w+|\*))?")


def code(source):
    """Returns the source without comments. Strings are kept only if they are paths, as in attributes of serde."""

    def kept(match):
        text = match.group(1) or ""
        return text if re.fullmatch(r'"crate(::\w+)+"', text) else "\n" * match.group(0).count("\n")

    return COMMENT.sub(kept, source)


def without_tests(source):
    return source.split("#[cfg(test)]\nmod ")[0]


def exports(lib):
    """Returns the folder of each item that the root of the crate exports."""
    found = {}
    for folder, rest in re.findall(r"pub use (\w+)::([^;]+);", code(lib)):
        for name in re.findall(r"(\w+)\s*(?=[,}]|$)", rest):
            found[name if name != "self" else rest.split("::")[0]] = folder
    return found


def uses(source, exported):
    """Yields the folders that the code uses, each with the items and the line."""
    text = code(source)
    for match in PATH.finditer(text):
        first, rest = match.groups()
        line = text.count("\n", 0, match.start()) + 1
        if first == "{":
            yield "crate::{..}", "", line
            continue
        items = re.findall(r"\w+", rest or "") if first not in exported else [first]
        for item in items or ["*"]:
            yield exported.get(first, first), item, line
    for match in re.finditer(r"\bsuper\s*::\s*super\b", text):
        yield "super::super", "", text.count("\n", 0, match.start()) + 1


def faults_of(path, source, exported, height):
    """Yields the faults of a file; `path` is relative to src."""
    own = pathlib.PurePosixPath(path).parts[0].removesuffix(".rs")
    if len(source.splitlines()) > LONGEST_FILE:
        yield f"{path}: more than {LONGEST_FILE} lines"
    if own not in height:
        yield f"{path}: {own} has no layer in .ci/layers.py"
        return
    for used, item, line in uses(source, exported):
        if used == own:
            continue
        if used not in height:
            yield f"{path}:{line}: write the path {used} from the root of the crate, one folder at a time"
        elif height[used] >= height[own]:
            yield f"{path}:{line}: {own} may not use {used}: it is not in a lower layer"
        elif item not in ITEMS.get((own, used), {item}):
            yield f"{path}:{line}: {own} may not use {used}::{item}"
    if own in WITHOUT_SUMS:
        text = code(without_tests(source))
        for match in SUM.finditer(text):
            yield f"{path}:{text.count(chr(10), 0, match.start()) + 1}: a sum outside parallel/reduce.rs"


# A file, its source, and its number of faults if layer a is below b and b is below c.
SNIPPETS = [
    ("a.rs", "use crate::b::C;", 1),
    ("a/x.rs", "use crate::a::y::Z;", 0),
    ("b.rs", "use crate::a::{C, d::E};", 0),
    ("b/x.rs", "fn f() -> crate::c::D { crate::c::e::<crate::a::F>() }", 2),
    ("b.rs", "use crate::{a, c};", 1),
    ("b/x/y.rs", "use super::super::z;", 1),
    ("b.rs", "use crate::Item;", 1),
    ("b.rs", "// use crate::c;\n/* crate::c */ /// [`crate::c`]\nfn f() { g(\"crate::c is text\") }", 0),
    ("b.rs", '#[serde(with = "crate::c::number")] struct S;', 1),
    ("b.rs", "macro_rules! m { () => { $crate::c::d() }; }", 1),
    ("b.rs", "fn f(c: char) { c == '\"' || crate::c::d() } // \"", 1),
    ("b.rs", "fn f<'a>(x: &'a crate::c::D) {}", 1),
    ("e.rs", "", 1),
    ("cgm/x.rs", "fn f() { x.iter()\n  .sum::<f64>() + crate::parallel::fold(1) }", 2),
    ("cgm/x.rs", "fn f() { x.iter().sum::<usize>() }\n#[cfg(test)]\nmod tests { fn f() { y.sum::<f64>() } }", 0),
]


def self_test():
    height = {"a": 0, "parallel": 0, "b": 1, "cgm": 1, "c": 2}
    for path, source, expected in SNIPPETS:
        found = list(faults_of(path, source, {"Item": "c"}, height))
        if len(found) != expected:
            yield f"self-test: {path}: {source!r}: {found}, expected {expected} faults"
    if exports("pub use a::b::{self, C};\npub use d::e::F;") != {"b": "a", "C": "a", "F": "d"}:
        yield "self-test: exports"


def main(arguments):
    faults = list(self_test())
    print(f"self-test: {len(SNIPPETS)} snippets, {len(faults)} faults")
    if arguments != ["--self-test"]:
        src = pathlib.Path("src")
        height = {folder: place for place, layer in enumerate(LAYERS) for folder in layer.split()}
        for folder in height:
            if not (src / f"{folder}.rs").is_file() and not (src / folder / "mod.rs").is_file():
                faults.append(f"LAYERS: {folder} is not in src")
        exported = exports((src / "lib.rs").read_text())
        for path in sorted(src.rglob("*.rs")):
            if path != src / "lib.rs":
                faults += faults_of(path.relative_to(src).as_posix(), path.read_text(), exported, height)
    print(*faults, f"layers: {len(faults)} faults", sep="\n")
    return 1 if faults else 0


sys.exit(main(sys.argv[1:]))
