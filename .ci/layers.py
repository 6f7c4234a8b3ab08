#!/usr/bin/env python3
"""Fails on a dependency that points up through the layers, on a sum over cells outside the one place for sums,
or on a library file of two ideas. Reads every path of the source: `use` trees, `super`, paths in expressions,
macros, attributes and visibilities. Tests itself first; with --self-test it does nothing else."""

import pathlib
import re
import sys

# The modules of the crate by layer, lowest first, and the modules each may use: those named, of its own layer or of
# a lower one.
FOUNDATION = {
    "buffer", "clock", "error", "report", "boundary", "cell_value", "discretisation", "neighbours", "grid", "field", "layers", "material", "parallel", "per_cell", "pool", "serial", "warning",
    "gauss", "jacobi", "digest", "ranks", "share", "shown", "layout", "reduce", "watch",
}
ENGINE = FOUNDATION | {"operator", "influence", "kernel", "fft", "half_space", "cgm", "levels", "window"}
LAYERS = [
    ("words every layer speaks", {
        "buffer": {"error"},
        "clock": set(),
        "serial": {"error"},
        "report": {"error", "serial"},
        "error": {"report"},
        "watch": {"error", "ranks", "report"},
        "parallel": {"error"},
        "digest": set(),
        "ranks": {"digest", "error", "parallel"},
        "share": {"parallel", "layout", "ranks"},
        "layout": {"error", "report", "parallel", "ranks", "share"},
        "reduce": {"layout", "ranks"},
        "per_cell": {"buffer", "error"},
        "shown": set(),
        "pool": {"error"},
        "gauss": set(),
        "jacobi": set(),
        "boundary": set(),
        "cell_value": set(),
        "neighbours": set(),
        "discretisation": {"boundary", "cell_value", "field", "neighbours", "reduce"},
        "grid": {"error", "layout"},
        "warning": {"error", "grid"},
        "field": {"buffer", "error", "grid", "layout", "parallel", "per_cell", "serial", "shown"},
        "layers": {"error"},
        "material": {"error", "layers", "serial"},
        "coupling": {"material"},
    }),
    ("operators, kernels, transforms, closed forms, shapes; no physics of contact; and pages to read", {
        "operator": {"error", "layout", "report"},
        "contact_map": {"boundary", "buffer", "error", "grid", "neighbours", "survey", "warning"},
        "survey": {"contact_map", "grid", "parallel", "ranks", "warning"},
        "window": {"grid", "layout", "parallel", "ranks"},
        "levels": {"buffer", "error", "parallel"},
        "influence": FOUNDATION | {"kernel"},
        "kernel": FOUNDATION | {"influence", "operator"},
        "fft": FOUNDATION | {"operator", "influence", "kernel"},
        "guide": set(),
        "analytical": {"error", "material", "grid", "field"},
        "surface": {"error", "fft", "grid", "field", "layout", "parallel", "ranks", "reduce", "report", "serial", "share", "watch"},
        "io": {"error", "grid", "field", "ranks", "share"},
    }),
    ("the engine, and what it works on", {
        "half_space": FOUNDATION | {"contact_map", "survey", "levels", "operator", "influence", "kernel", "fft", "io", "surface", "window"},
        "cgm": {"buffer", "clock", "error", "layout", "report", "parallel", "per_cell", "operator", "ranks", "reduce", "serial", "watch"},
        "contact": ENGINE,
        "dense": FOUNDATION | {"operator", "influence", "kernel", "half_space", "cgm"},
    }),
    ("the two problems", {
        "normal": ENGINE | {"contact_map", "survey", "contact"},
        "tangential": ENGINE | {"contact_map", "survey", "coupling", "contact", "normal"},
    }),
    ("both problems at once", {
        "coupled": ENGINE | {"contact_map", "contact", "normal", "tangential"},
    }),
    ("what follows from a solution", {
        "stiffness": ENGINE | {"contact", "coupled", "normal", "tangential"},
    }),
    ("what goes on through many steps", {
        "history": ENGINE
        | {"contact_map", "coupling", "contact", "normal", "tangential", "coupled", "stiffness", "io"},
    }),
    ("what is told of all of these", {
        "edges": {"boundary", "buffer", "cell_value", "error", "field", "grid", "history", "layers", "neighbours", "normal", "parallel", "shown", "spots", "tangential"},
        "spots": FOUNDATION | {"contact_map", "half_space", "normal", "tangential", "history"},
        "rolling": ENGINE | {"contact", "contact_map", "normal", "tangential", "history"},
        "subsurface": FOUNDATION | {"influence", "fft", "half_space", "io", "normal", "tangential", "coupled", "history"},
    }),
]
# Of some modules, others may use these items only: the tangential problem reads the normal solution, never how it
# was found.
ITEMS = {("tangential", "normal"): {"NormalSolution"}}

# Sums over cells have one home, which fixes their order: elsewhere in these modules nothing may look like one.
REDUCTIONS_IN = ("cgm", "contact", "normal", "tangential", "coupled", "history", "rolling")
REDUCTIONS = [
    ("parallel::fold", re.compile(r"\bparallel\s*::\s*fold\b")),
    (".sum::<f64>()", re.compile(r"\.\s*sum\s*::\s*<\s*f(?:32|64)\s*>")),
]
REDUCING_ITEMS = {("parallel", "fold")}

LONGEST_FILE = 600
CRATE = "stickslip"

TOKEN = re.compile(
    r"""(?P<space>\s+|//[^\n]*)
      | (?P<comment>/\*)
      | (?P<raw>b?r(?P<hashes>\#*)".*?"(?P=hashes))
      | (?P<string>b?"(?:\\.|[^"\\])*")
      | (?P<char>b?'(?:\\(?:x..|u\{[^}]*\}|.)|[^'\\])')
      | (?P<lifetime>'\w+)
      | (?P<word>(?:r\#)?[A-Za-z_]\w*)
      | (?P<number>\d[\w.]*?(?=\.\.|\W|$))
      | (?P<mark>::|.)""",
    re.VERBOSE | re.DOTALL,
)
PATH_IN_STRING = re.compile(r'"((?:crate|super|self)(?:::\w+)+)"')


def tokens(source):
    """The code as (token, line) without comments; of a string only what is a path, as serde's attributes have it."""
    found, at, line = [], 0, 1
    while at < len(source):
        match = TOKEN.match(source, at)
        kind, text, end = match.lastgroup, match.group(), match.end()
        if kind == "comment":
            depth, end = 1, match.end()
            while depth and end < len(source):
                if source.startswith("/*", end):
                    depth, end = depth + 1, end + 2
                elif source.startswith("*/", end):
                    depth, end = depth - 1, end + 2
                else:
                    end += 1
            text = source[at:end]
        elif kind == "string":
            path = PATH_IN_STRING.fullmatch(text)
            parts = re.findall(r"\w+|::", path.group(1)) if path else ['""']
            found.extend((part, line) for part in parts)
            found.append((";", line) if path else ("", line))
        elif kind in ("raw", "char"):
            found.append(('""', line))
        elif kind in ("word", "mark", "number", "lifetime"):
            found.append((text.removeprefix("r#"), line))
        line += text.count("\n")
        at = end
    return [pair for pair in found if pair[0]]


def module_of(path):
    """The path of the module in a file."""
    parts = [part.removesuffix(".rs") for part in pathlib.PurePosixPath(path).parts[1:]]
    return parts[:-1] if parts[-1] in ("mod", "lib") else parts


def is_word(token):
    return re.fullmatch(r"[A-Za-z_]\w*", token) is not None


class Reader:
    """All paths of a file within the crate, each absolute, with its line and whether a test alone has it."""

    def __init__(self, path, source):
        self.tokens = tokens(source)
        self.module = module_of(path)
        self.paths = []
        self.tests = set()
        self.read()

    def token(self, at):
        return self.tokens[at][0] if 0 <= at < len(self.tokens) else ""

    def read(self):
        at, depth, inline, outer = 0, 0, [], self.module
        while at < len(self.tokens):
            token, line = self.tokens[at]
            here = outer + [name for name, _, _ in inline]
            if any(is_test for _, _, is_test in inline):
                self.tests.add(line)
            if token == "mod" and is_word(self.token(at + 1)) and self.token(at + 2) == "{":
                before = "".join(self.token(i) for i in range(at - 7, at))
                inline.append((self.token(at + 1), depth, before.endswith("#[cfg(test)]")))
                depth, at = depth + 1, at + 3
            elif token == "use" and self.token(at + 1) != "<" and self.token(at - 1) != "::":
                at = self.tree(at + 1, None, here)
            elif self.base(at, here) is not None and self.token(at - 1) not in ("::", "."):
                at = self.expression(at, here)
            else:
                if token == "{":
                    depth += 1
                elif token == "}":
                    depth -= 1
                    if inline and inline[-1][1] == depth:
                        inline.pop()
                at += 1

    def base(self, at, here):
        """The module that a path begins in, if the path is one within the crate."""
        token, is_followed = self.token(at), self.token(at + 1) == "::"
        if token in ("crate", CRATE) and is_followed:
            return []
        if token == "self" and is_followed:
            return here
        if token == "super" and (is_followed or self.token(at - 1) == "in"):
            return here[:-1]
        return None

    def expression(self, at, here):
        start, path = at, self.base(at, here)
        at += 1
        while self.token(at) == "::" and self.token(at + 1) == "super":
            path, at = path[:-1], at + 2
        found = list(path)
        while self.token(at) == "::" and is_word(self.token(at + 1)):
            found.append(self.token(at + 1))
            at += 2
        if self.token(at) == "::" and self.token(at + 1) in ("{", "*"):
            # A `use` tree that a macro takes apart.
            return self.tree(at + 1, found, here)
        self.add(found, start)
        return at

    def tree(self, at, prefix, here):
        """Reads a tree of `use`, from its start or from within a group; paths of other crates do not count."""
        start, is_first = at, prefix is None
        if self.token(at) == "::":
            at, prefix, is_first = at + 1, (prefix if prefix is not None else [None]), False
        while True:
            token = self.token(at)
            if token == "{":
                at += 1
                while self.token(at) not in ("}", ""):
                    at = self.tree(at, None if is_first else prefix, here)
                    if self.token(at) == ",":
                        at += 1
                return at + 1
            if token == "*":
                self.add((prefix or []) + ["*"], start)
                return at + 1
            if token == "$":
                at += 1
                continue
            if not is_word(token):
                return at + 1
            if token == "super":
                prefix = (here if is_first else prefix)[:-1]
            elif token in ("crate", CRATE) and is_first:
                prefix = []
            elif token == "self":
                prefix = here if is_first else prefix
            elif is_first:
                prefix = [None, token]
            else:
                prefix = prefix + [token]
            at, is_first = at + 1, False
            if self.token(at) == "::":
                at += 1
                continue
            if self.token(at) == "as":
                at += 2
            self.add(prefix, start)
            return at

    def add(self, path, at):
        if path[:1] != [None]:
            self.paths.append((tuple(path), self.tokens[at][1]))


def exports(source):
    """The module behind each item that the root of the crate hands on."""
    reader = Reader("src/lib.rs", source)
    found, at = {}, 0
    while at < len(reader.tokens):
        if reader.token(at) == "use":
            module, at = reader.token(at + 1), at + 2
            while reader.token(at) != ";":
                if is_word(reader.token(at)):
                    found[reader.token(at)] = module
                at += 1
        at += 1
    return found


def uses(path, source, exported):
    """The modules that a file uses besides its own, each with the item of it and the line."""
    own = module_of(path)[0]
    found = set()
    for parts, line in Reader(path, source).paths:
        if not parts:
            parts = ("*",)
        module = exported.get(parts[0], parts[0])
        item = parts[0] if module != parts[0] else (parts[1:] + ("*",))[0]
        if module != own:
            found.add((module, item, line))
    return found


def check_layers(allowed, faults):
    """The list of layers never points up, and each of its modules exists."""
    for module in sorted({*allowed, *REDUCTIONS_IN}):
        if not any(pathlib.Path("src", name).is_file() for name in (f"{module}.rs", f"{module}/mod.rs")):
            faults.append(f"LAYERS: {module} is not a module of the crate")
    height = {module: i for i, (_, modules) in enumerate(LAYERS) for module in modules}
    for module, below in allowed.items():
        for used in below:
            if height[used] > height[module]:
                faults.append(f"LAYERS: {module} is below {used}")


def check_uses(path, source, allowed, exported, faults):
    module = module_of(path)[0]
    if module not in allowed:
        faults.append(f"{path}: module {module} has no layer in .ci/layers.py")
        return
    for used, item, line in sorted(uses(path, source, exported)):
        limit = ITEMS.get((module, used))
        if used not in allowed[module]:
            faults.append(f"{path}:{line}: {module} may not use {used}")
        elif limit is not None and item not in limit:
            faults.append(f"{path}:{line}: of {used}, {module} may use {sorted(limit)} only, not {item}")


def reductions(path, source, exported):
    """What looks like a sum over cells, tests apart."""
    reader = Reader(path, source)
    lines = {}
    for token, line in reader.tokens:
        lines.setdefault(line, []).append(token)
    ordered = [line for line in sorted(lines) if line not in reader.tests]
    # One text, so that a chain of calls may run over many lines.
    text, starts = "", []
    for line in ordered:
        starts.append((len(text), line))
        text += " ".join(lines[line]) + "\n"
    found = set()
    for name, pattern in REDUCTIONS:
        for match in pattern.finditer(text):
            found.add((max(line for start, line in starts if start <= match.start()), name))
    for module, item, line in uses(path, source, exported):
        if (module, item) in REDUCING_ITEMS and line not in reader.tests:
            found.add((line, f"{module}::{item}"))
    return sorted(found)


def check_reductions(path, source, exported, faults):
    if module_of(path)[0] in REDUCTIONS_IN:
        for line, name in reductions(path, source, exported):
            faults.append(f"{path}:{line}: {name} outside src/reduce.rs")


# Where a snippet stands, what it says, and the (module, item) it uses.
SNIPPETS = [
    ("src/a.rs", "use crate::b;", {("b", "*")}),
    ("src/a.rs", "use crate::b::C;", {("b", "C")}),
    ("src/a.rs", "use crate::b::{C, d::E, self};", {("b", "C"), ("b", "d"), ("b", "*")}),
    ("src/a.rs", "use crate::{b, c::d};", {("b", "*"), ("c", "d")}),
    ("src/a.rs", "use crate::{\n  b::{C, d::{E, F}},\n  g as h, // i\n  j::*,\n};", {("b", "C"), ("b", "d"), ("g", "*"), ("j", "*")}),
    ("src/a.rs", "use {crate::b::C, std::fmt, crate::d};", {("b", "C"), ("d", "*")}),
    ("src/a.rs", "pub(crate) use crate::b::C as D;", {("b", "C")}),
    ("src/a.rs", "use super::b::C;", {("b", "C")}),
    ("src/a.rs", "use super::{b, c::D};", {("b", "*"), ("c", "D")}),
    ("src/a/mod.rs", "use super::b::C;", {("b", "C")}),
    ("src/a/x.rs", "use super::y::Z;", set()),
    ("src/a/x.rs", "use super::super::b::C;", {("b", "C")}),
    ("src/a/x.rs", "use super::{super::b::C, y::Z};", {("b", "C")}),
    ("src/a/x/y.rs", "fn f() { super::super::super::b::c() }", {("b", "c")}),
    ("src/a/x/mod.rs", "fn f() { super::super::b::c() }", {("b", "c")}),
    ("src/a.rs", "mod tests { use super::*; use super::super::b::C; }", {("b", "C")}),
    ("src/a.rs", "mod x { mod y { fn f() { super::super::super::b::c() } } } fn g() { super::d::e() }", {("b", "c"), ("d", "e")}),
    ("src/a.rs", "fn f() -> crate::b::C { crate::d::e::<crate::g::H>(1) }", {("b", "C"), ("d", "e"), ("g", "H")}),
    ("src/a.rs", "impl Trait<crate::b::C> for D { type E = [crate::g::H; crate::i::J]; }", {("b", "C"), ("g", "H"), ("i", "J")}),
    ("src/a.rs", "macro_rules! m { ($x:ident) => { $crate::b::c(crate::d::$x) }; }", {("b", "c"), ("d", "*")}),
    ("src/a.rs", "m! { use crate::{b::C, d}; }", {("b", "C"), ("d", "*")}),
    ("src/a.rs", "m!(crate::b::{C, D});", {("b", "C"), ("b", "D")}),
    ("src/a/x.rs", "pub(in crate::a) fn f() {} pub(in crate::b) fn g() {}", {("b", "*")}),
    ("src/a.rs", "pub(crate) fn f() {} pub(super) fn g() {}", set()),
    ("src/a/x.rs", "pub(in super::super) fn f() {}", {("*", "*")}),
    ("src/a.rs", '#[serde(with = "crate::b::c")] struct S;', {("b", "c")}),
    ("src/a.rs", 'fn f() { g("crate::b is no path here", "super::c, nor here") }', set()),
    ("src/a.rs", "// use crate::b;\n/// [`crate::c`]\n/* crate::d /* crate::e */ crate::f */ fn g() {}", set()),
    ("src/a.rs", r"""fn f<'a>(c: char) { c == '"' || c == '\''; crate::b::c() } // " """, {("b", "c")}),
    ("src/a.rs", 'const S: &str = r#"use crate::b; " "#; use crate::c;', {("c", "*")}),
    ("src/a.rs", "use crate::*;", {("*", "*")}),
    ("src/a.rs", "use crate as root;", {("*", "*")}),
    ("src/a.rs", "use super as root;", {("*", "*")}),
    ("src/a.rs", "use crate::Item;", {("b", "Item")}),
    ("src/a.rs", "use stickslip::b::C;", {("b", "C")}),
    ("src/a.rs", "use std::fmt; use ::rayon::prelude::*; use self::x::Y; use x::Z;", set()),
    ("src/a.rs", "fn f() -> impl Fn() + use<'_, T> { self::x::y; self.b.c() }", set()),
]
SUMS = [
    ("fn f() { parallel::fold(1) }", 1),
    ("use crate::parallel::{fold, update};", 1),
    ("fn f() { x.iter()\n  .map(g)\n  .sum::<f64>() }", 1),
    ("fn f() { x.iter().fold(0.0, f64::max) + h.iter().sum::<f32>() }", 1),
    ("fn f() { x.iter().sum::<usize>() } // .fold(", 0),
    ("#[cfg(test)]\nmod tests {\n  fn f() { x.fold(0) }\n}", 0),
]


def self_test():
    faults = []
    for path, source, expected in SNIPPETS:
        found = {(module, item) for module, item, _ in uses(path, source, {"Item": "b"})}
        if found != expected:
            faults.append(f"self-test: {path}: {source!r} uses {sorted(found)}, expected {sorted(expected)}")
    for source, expected in SUMS:
        found = reductions("src/a.rs", source, {})
        if len(found) != expected:
            faults.append(f"self-test: {source!r} reduces {found}, expected {expected} times")
    return faults


def main(arguments):
    faults = self_test()
    print(f"self-test: {len(SNIPPETS) + len(SUMS)} snippets, {len(faults)} faults")
    if arguments != ["--self-test"]:
        allowed = {module: below for _, modules in LAYERS for module, below in modules.items()}
        exported = exports(pathlib.Path("src/lib.rs").read_text())
        check_layers(allowed, faults)
        for path in sorted(pathlib.Path("src").rglob("*.rs")):
            source, path = path.read_text(), path.as_posix()
            lines = len(source.splitlines())
            if lines > LONGEST_FILE:
                faults.append(f"{path}: {lines} lines, more than {LONGEST_FILE}")
            if path != "src/lib.rs":
                check_uses(path, source, allowed, exported, faults)
                check_reductions(path, source, exported, faults)
    for fault in faults:
        print(fault)
    print(f"layers: {len(faults)} faults")
    return 1 if faults else 0


sys.exit(main(sys.argv[1:]))
