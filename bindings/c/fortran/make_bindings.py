#!/usr/bin/env python3
"""Writes stickslip_bindings.f90, the interface of include/stickslip.h for Fortran: make_bindings.py HEADER > MODULE.

It knows the C that cbindgen writes, no other, and fails on a type that it does not know."""

import re
import sys

NUMBERS = {
    "int32_t": "integer(c_int32_t)",
    "stickslip_status": "integer(c_int32_t)",
    "uint32_t": "integer(c_int32_t)",
    "uint64_t": "integer(c_int64_t)",
    "uint8_t": "integer(c_int8_t)",
    "size_t": "integer(c_size_t)",
    "double": "real(c_double)",
    "char": "character(kind=c_char)",
}
# Parameters that point to many entries; all others point to one.
ARRAYS = {
    "gap", "pressure", "depth", "buffer", "bytes", "histories", "loads", "codes",
    "depths", "points", "responses", "values", "heights",
}
# Fortran does not tell the constant from the function.
RENAMED = {"STICKSLIP_ABI_VERSION": "STICKSLIP_ABI_VERSION_COMPILED"}
WIDTH = 120


def wrapped(text, indent):
    """A line of Fortran, continued where it is too long."""
    lines, rest = [], " " * indent + text
    while len(rest) > WIDTH:
        cut = rest.rindex(",", 0, WIDTH - 2) + 1
        lines.append(rest[:cut] + " &")
        rest = " " * (indent + 4) + rest[cut:].lstrip()
    return lines + [rest]


class Header:
    def __init__(self, text):
        self.structs, self.opaque = set(re.findall(r"^\} (stickslip_\w+);", text, re.M)), set()
        for name in re.findall(r"^typedef struct (stickslip_\w+) \1;", text, re.M):
            self.opaque.add(name)
        self.functions = {m for m in re.findall(r"^typedef \w+ \(\*(stickslip_\w+)\)", text, re.M)}

    def member(self, declared):
        """A member of a struct."""
        found = re.fullmatch(r"(const )?(\w+) (\*?)(\w+)((?:\[\w+\])*)", declared)
        kind, pointer, name, shape = found[2], found[3], found[4], re.findall(r"\[(\w+)\]", found[5])
        if pointer:
            kind = "type(c_ptr)"
        elif kind in self.functions:
            kind = "type(c_funptr)"
        else:
            kind = NUMBERS.get(kind) or self.struct(kind)
        # The first index is the fastest in Fortran, the last in C.
        return f"{kind} :: {name}" + (f"({', '.join(reversed(shape))})" if shape else "")

    def struct(self, kind):
        if kind not in self.structs:
            raise SystemExit(f"unknown type {kind}")
        return f"type({kind})"

    def parameter(self, declared):
        """A parameter of a function: its name and declaration."""
        found = re.fullmatch(r"(const )?(\w+) (\*const \*|\**)(\w+)", declared)
        is_const, kind, stars, name = found[1], found[2], found[3], found[4]
        many = "(*)" if name in ARRAYS else ""
        if not stars:
            return name, f"{NUMBERS[kind]}, value :: {name}"
        if kind in self.opaque or kind == "void":
            if stars == "*":
                return name, f"type(c_ptr), value :: {name}"
            return name, f"type(c_ptr), intent({'in' if many else 'out'}) :: {name}{many}"
        base = NUMBERS.get(kind) or self.struct(kind)
        intent = "in" if is_const else "inout" if kind == "double" and many else "out"
        # What is left out is NULL.
        optional = "" if kind == "double" and many else ", optional"
        return name, f"{base}, intent({intent}){optional} :: {name}{many}"

    def function(self, declared):
        found = re.fullmatch(r"(const )?(\w+) (\*?)(\w+)\((.*)\);", declared)
        kind, pointer, name, inside = found[2], found[3], found[4], found[5]
        parameters = [] if inside == "void" else [self.parameter(one) for one in inside.split(", ")]
        result = "type(c_ptr)" if pointer else NUMBERS.get(kind) or self.struct(kind)
        names = ", ".join(name for name, _ in parameters)
        lines = wrapped(f"function {name}({names}) result(answer) bind(c)", 8)
        lines += ["            import"]
        for _, declaration in parameters:
            lines += wrapped(declaration, 12)
        return lines + [f"            {result} :: answer", f"        end function {name}"]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    header = Header(text)
    body = text[text.index("#include <stdint.h>"):]
    constants, types, functions, comment = [], {}, [], []
    lines = iter(body.splitlines())
    for line in lines:
        if line.startswith("//"):
            comment.append(line[2:].strip())
            continue
        note, here = comment, line
        comment = []
        if found := re.fullmatch(r"#define (STICKSLIP_\w+) (\d+)", line):
            name = RENAMED.get(found[1], found[1])
            kind = "c_int8_t" if name in ("STICKSLIP_SEPARATED", "STICKSLIP_STICK", "STICKSLIP_SLIP") else "c_int32_t"
            constants += [f"    ! {row}".rstrip() for row in note]
            constants += [f"    integer({kind}), parameter, public :: {name} = {found[2]}"]
        elif line == "typedef struct {":
            members, inner = [], []
            for row in lines:
                row = row.strip()
                if row.startswith("//"):
                    inner.append(f"        ! {row[2:].strip()}".rstrip())
                elif row.startswith("}"):
                    name = row[2:-1]
                    break
                else:
                    members += inner + ["        " + header.member(row[:-1])]
                    inner = []
            types[name] = [f"    ! {row}".rstrip() for row in note] + [f"    type, bind(c), public :: {name}"]
            types[name] += members + [f"    end type {name}"]
        elif re.match(r"(const )?\w+ \*?stickslip_\w+\(", line):
            while not here.endswith(";"):
                here += " " + next(lines).strip()
            functions += [f"        ! {row}".rstrip() for row in note] + header.function(here) + [""]
            name = re.search(r"(stickslip_\w+)\(", here)[1]
            constants += []
            types.setdefault("public", []).append(f"    public :: {name}")
    public = types.pop("public")
    print("! The interface of stickslip.h for Fortran, made from it by make_bindings.py: do not edit. The rules at the head of")
    print("! stickslip.h hold here too. Objects are of type(c_ptr); an optional argument that is left out is NULL; a matrix has")
    print("! its column first. The module stickslip has types that free themselves.")
    print("module stickslip_bindings")
    print("    use, intrinsic :: iso_c_binding")
    print("    implicit none")
    print("    private")
    print("\n".join([""] + public + [""] + constants))
    for rows in types.values():
        print("\n".join([""] + rows))
    print("\n    interface")
    print("\n".join(functions).rstrip())
    print("    end interface")
    print("end module stickslip_bindings")


if __name__ == "__main__":
    main()
