"""Functions of the C header, with arguments in the form of C++ and Fortran: an array and its count are one argument."""

import re
import sys
import textwrap
from dataclasses import dataclass, replace
from pathlib import Path

from table import FILES, OTHERS

sys.path.insert(0, str(Path(__file__).parent.parent / "fortran"))
from make_bindings import NUMBERS, declarations  # noqa: E402

WIDTH = 120
# Arrays with a value for each cell.
CELLS = {"gap", "pressure", "depth", "slip_distance"}
# Arguments that may be left out where they are not the purpose of the function.
OPTIONAL = {"boundary", "hardness", "settings", "options", "limits", "relative"}
OBJECTS = {object.c: object for file in FILES for object in file.objects}
# Names of methods in C++ and Fortran, by their C functions.
NAMES = {f"stickslip_{owner.c}_{method.c}": {
    "cpp": method.cpp and (owner.cpp if method.cpp == "new" else f"{owner.cpp}::{method.cpp}"),
    "f": method.f and f"{owner.f}%{method.f}"} for owner in OBJECTS.values() for method in owner.methods}


@dataclass(frozen=True)
class Argument:
    """Argument of a wrapper. The kinds are self, object, cells, changed_cells, paired_cells, filled_cells, array,
    filled_array, struct,
    number, flag, index, tractions, displacement, per_cell, body, observer, result and made."""

    kind: str
    name: str
    type: str
    is_const: bool = True
    is_optional: bool = False
    # Name of the array that has the length of a filled array.
    like: str = ""


def short(name):
    return name.removeprefix("stickslip_")


class Function:
    """C function with its arguments and its documentation."""

    def __init__(self, notes, declared, owner=None):
        found = re.fullmatch(r"(const )?(\w+) (\*?)(\w+)\((.*)\);", declared)
        self.c, self.type, self.is_pointer = found[4], found[2], bool(found[3])
        self.notes = " ".join(note or "\n" for note in notes)
        self.raw = [] if found[5] == "void" else [self.parameter(one) for one in found[5].split(", ")]
        self.names = [name for *_, name in self.raw]
        # Pattern of several arguments together.
        groups = {"warnings": "buffer capacity count", "spots": "buffer capacity count labels cells",
                  "bytes": "buffer capacity length", "edges": "edges centres means cells"}
        self.group = next((group for group, names in reversed(groups.items())
                           if self.names[-len(names.split()):] == names.split()), "")
        if self.is_pointer:
            self.group = "zones" if self.type == "uint8_t" else "field"
        last = len(self.names) - len(groups.get(self.group, "count" if self.is_pointer else "").split())
        self.arguments = list(self.merge(self.raw[:last], owner))

    @staticmethod
    def parameter(declared):
        found = re.fullmatch(r"(const )?(\w+) (\*const \*|\**)(\w+)", declared)
        return bool(found[1]), found[2], found[3], found[4]

    def merge(self, raw, owner):
        is_setter = "_set_" in self.c
        counts = {name: after[3] for (*_, name), after in zip(raw, raw[1:])
                  if after[1] == "size_t" and not after[2] and re.fullmatch(r"count|length|layers_\d_count", after[3])}
        is_self_found, last_array = False, ""
        for is_const, kind, stars, name in raw:
            def argument(form, **options):
                return Argument(form, {"half_space": "bodies"}.get(name, name), kind, is_const, **options)

            if name in counts.values():
                continue
            if short(kind) in OBJECTS and stars == "**":
                yield argument("made")
            elif owner and not is_self_found and kind == f"stickslip_{owner.c}":
                is_self_found = True
                yield argument("self")
            elif short(kind) in OBJECTS:
                yield argument("object", is_optional=f"{name} (may be NULL)" in self.notes)
            elif name in counts and is_const and name in CELLS:
                yield argument("cells")
            elif name in counts and is_const:
                last_array = name
                yield argument("array")
            elif name == "along_x":
                # The array has the count of the array that follows it.
                yield argument("paired_cells")
            elif name in counts:
                yield argument("filled_cells" if name == "values" else "changed_cells")
            elif kind in ("stickslip_observer", "stickslip_step_observer"):
                yield argument("observer")
            elif stars and is_const:
                special = {"stickslip_tractions": "tractions"}
                if not self.is_created():
                    special |= {"stickslip_per_cell": "per_cell", "stickslip_relative_displacement": "displacement"}
                is_optional = not is_setter and (name in OPTIONAL or kind == "stickslip_rolling_load")
                yield argument(special.get(kind, "struct"), is_optional=is_optional)
            elif stars and last_array:
                yield argument("filled_array", like=last_array)
            elif stars:
                is_optional = f"{name} (may be NULL)" in self.notes or "either pointer may be NULL" in self.notes
                yield argument("result", is_optional=is_optional)
            elif name.startswith("with_"):
                yield argument("flag", is_optional=True)
            else:
                yield argument("index" if name == "index" else "number")

    def is_created(self):
        return any(stars == "**" for _, _, stars, _ in self.raw)

    def of(self, *kinds):
        return [argument for argument in self.arguments if argument.kind in kinds]


class Header:
    """Functions, types and constants of the header, with their documentation."""

    def __init__(self, text):
        self.declared = {re.search(r"(stickslip_\w+)\(", one)[1]: (notes, one) for notes, one in declarations(text)}
        self.defaults = {name for name in self.declared if name.endswith("_default")}
        self.notes = {}
        for notes, name in re.findall(r"((?:^//.*\n)+)(?:typedef struct stickslip_|#define )(\w+) ", text, re.M):
            self.notes[name] = " ".join(line[2:].strip() for line in notes.splitlines())
        self.wrapped = set()

    def function(self, owner, method):
        """Returns the function of a method: the variant with an observer if it exists, with the plain documentation."""
        prefix = f"{owner.c}_" if owner and not method.is_apart else ""
        name = f"stickslip_{prefix}{method.c}"
        notes = self.declared[name][0]
        observed = name + "_observed" if name + "_observed" in self.declared else name
        self.wrapped |= {name, observed}
        function = Function(notes, self.declared[observed][1], owner)
        function.arguments = [replace(one, name=method.renamed.get(one.name, one.name)) for one in function.arguments]
        return function

    def check(self):
        """Exits unless each function has a method or is listed as a function without one."""
        free = {f"stickslip_{object}_free" for object in OBJECTS}
        rest = set(self.declared) - self.wrapped - self.defaults - free - {f"stickslip_{name}" for name in OTHERS}
        if rest:
            raise SystemExit(f"wrappers/table.py has no method for {', '.join(sorted(rest))}")


def ordered(arguments, order):
    """Returns arguments in a given order, or required before optional ones."""
    if not order:
        return sorted(arguments, key=lambda one: (one.kind == "observer", one.is_optional))
    by_name = {one.name: one for one in arguments}
    if set(by_name) != set(order.split()):
        raise SystemExit(f"wrappers/table.py: {order} are not the arguments {', '.join(by_name)}")
    return [by_name[name] for name in order.split()]


# Parts of the documentation that concern only C.
DROPPED = r"NULL|With a capacity of 0|If the buffer is too small|A call without a buffer|length receives the number"
CHANGED = [
    (r",? and writes its number of cells to count \(may be NULL\)", ""),
    (r"[;,] (returns|or) NULL on failure|; either pointer may be NULL| \(may be NULL\)", ""),
    (r", and writes their number to taken", ", and returns their number"),
    (r" to a buffer of capacity entries, and their number to count|, to buffer, and their number to count", ""),
    (r" to (values|forces|responses|heights)(, which has count entries)?\b| and writes them to (forces|responses)", ""),
    (r"\(lengths, (zero or positive, )?(count entries, )?copied\)|\(lengths, count entries\)", r"(lengths)"),
    (r" \(count entries, (zero or positive, )?copied\)", ""), (r" at count (points|depths)", r" at \1"),
    (r"^Writes to \w+ the|^Writes (the|STICKSLIP)", lambda found: "Returns " + (found[1] or "the")),
    (r"Displacements are also computed if with_displacements is nonzero\.", "with_displacements adds displacements."),
    (r"\b([Aa]) NULL (\w+) means", r"\1n omitted \2 means"), (r"\bNULL (\w+) mean\b", r"omitted \1 mean"),
    (r",? like stickslip_\w+_warnings|, and (forces|responses) is unchanged", ""),
]


def documentation(notes, language, changes=()):
    """Returns the documentation of a function without the parts that concern only C, with the names of the language."""
    for pattern, by in [*CHANGED, *changes]:
        notes = re.sub(pattern, by, notes)
    kept = [one for one in re.split(r"(?<=\.)\s+", notes.strip()) if not re.search(DROPPED, one)]

    def name(found):
        return NAMES.get(found[0].removesuffix("_observed"), {}).get(language) or found[0]

    return re.sub(r"\bstickslip_\w+", name, " ".join(kept))


def comment(text, prefix, indent):
    return textwrap.wrap(text, WIDTH, initial_indent=" " * indent + prefix, subsequent_indent=" " * indent + prefix,
                         break_long_words=False, break_on_hyphens=False)


def read(path):
    return Header(Path(path).read_text(encoding="utf-8"))


__all__ = ["FILES", "NUMBERS", "OBJECTS", "WIDTH", "comment", "documentation", "ordered", "read", "short"]
