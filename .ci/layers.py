#!/usr/bin/env python3
"""Fails on a dependency that points up through the layers, or on a library file of two ideas."""

import pathlib
import re
import sys

# Each module of the crate and the modules it may use, lowest layer first. `Item` limits a use to
# the items named.
FOUNDATION = {"clock", "error", "report", "boundary", "grid", "field", "material", "parallel", "serial"}
ALLOWED = {
    # L0: words every layer speaks
    "clock": set(),
    "serial": {"error"},
    "report": {"error", "serial"},
    "error": {"report"},
    "parallel": {"error"},
    "boundary": set(),
    "grid": {"error"},
    "field": {"error", "grid", "parallel", "serial"},
    "material": {"error", "serial"},
    # L1: operators, kernels, transforms, closed forms, shapes; no physics of contact; and pages to read
    "operator": set(),
    "contact_map": {"boundary", "grid"},
    "window": {"grid", "parallel"},
    "influence": FOUNDATION,
    "fft": FOUNDATION | {"operator", "influence"},
    "guide": set(),
    "analytical": {"error", "material", "grid", "field"},
    "surface": {"error", "grid", "field", "parallel", "serial"},
    "io": {"error", "grid", "field"},
    # L2: the engine, and what it works on
    "half_space": FOUNDATION | {"operator", "influence", "fft", "window"},
    "cgm": {"clock", "error", "report", "parallel", "operator"},
    "stage": FOUNDATION | {"operator", "influence", "fft", "half_space", "cgm", "window"},
    "dense": FOUNDATION | {"operator", "influence", "half_space", "cgm"},
    # L4: what goes on through many steps
    "history": FOUNDATION
    | {"operator", "influence", "fft", "half_space", "cgm", "contact_map", "window", "stage", "normal", "tangential", "io"},
    # L3: the two problems
    "normal": FOUNDATION
    | {"operator", "influence", "fft", "half_space", "cgm", "contact_map", "window", "stage"},
    "tangential": FOUNDATION
    | {"influence", "half_space", "cgm", "contact_map", "window", "stage", "normal"},
}
# The tangential problem reads the normal solution, never how it was found.
ITEMS = {("tangential", "normal"): {"NormalSolution"}}
LONGEST_FILE = 400

USE = re.compile(r"\bcrate::(\w+)(?:::(\{[^}]*\}|\w+))?", re.DOTALL)


def main() -> int:
    faults = []
    for path in sorted(pathlib.Path("src").rglob("*.rs")):
        parts = path.relative_to("src").parts
        module = parts[0].removesuffix(".rs")
        lines = path.read_text().splitlines()
        if len(lines) > LONGEST_FILE:
            faults.append(f"{path}: {len(lines)} lines, more than {LONGEST_FILE}")
        if module == "lib":
            continue
        if module not in ALLOWED:
            faults.append(f"{path}: module {module} has no layer in .ci/layers.py")
            continue
        code = "\n".join("" if line.strip().startswith("//") else line for line in lines)
        for used, items in USE.findall(code):
            if used == module:
                continue
            if used not in ALLOWED[module]:
                faults.append(f"{path}: {module} may not use {used}")
            limit = ITEMS.get((module, used))
            named = set(re.findall(r"\w+", items))
            if limit is not None and not named <= limit:
                faults.append(f"{path}: of {used}, {module} may use {sorted(limit)} only")
    for fault in faults:
        print(fault)
    print(f"layers: {len(faults)} faults")
    return 1 if faults else 0


sys.exit(main())
