#!/usr/bin/env python3
"""Writes stickslip_bindings.f90, the Fortran interface of include/stickslip.h: make_bindings.py HEADER > MODULE.

The script parses only C written by cbindgen, and fails on an unsupported type."""

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
# Parameters that point to arrays; all other pointers refer to one value.
ARRAYS = {
    "gap", "pressure", "depth", "buffer", "bytes", "histories", "loads", "codes",
    "depths", "points", "forces", "responses", "values", "heights", "labels", "layers_1", "layers_2", "slip_distance", "centres", "means",
    "along_x", "along_y",
}
# Arrays of numbers that may be omitted.
OPTIONAL = {"centres", "means"}
# Members of structs with a nonzero default, as ..._default() returns them; tests/reach.f90 compares the two.
INFINITE = "transfer(int(z'7FF0000000000000', c_int64_t), 0.0_c_double)"
NOT_A_NUMBER = "transfer(int(z'7FF8000000000000', c_int64_t), 0.0_c_double)"
DEFAULTS = {
    ("stickslip_settings", "tolerance"): "1e-8_c_double",
    ("stickslip_settings", "max_iterations"): "10000",
    ("stickslip_settings", "time_limit"): INFINITE,
    ("stickslip_tangential_options", "coupling"): "STICKSLIP_ONE_WAY",
    ("stickslip_rolling_options", "step"): "1",
    ("stickslip_stiffness_options", "tolerance"): "1e-11_c_double",
    ("stickslip_stiffness_options", "reversal"): "1",
    ("stickslip_friction", "max_shear_stress"): INFINITE,
    ("stickslip_jump_limits", "largest_depth"): INFINITE,
    ("stickslip_jump_limits", "cycles_left"): INFINITE,
    ("stickslip_jump_limits", "max_residual"): "0.25_c_double",
    ("stickslip_self_affine", "hurst"): "0.8_c_double",
    ("stickslip_self_affine", "skewness"): NOT_A_NUMBER,
    ("stickslip_self_affine", "kurtosis"): NOT_A_NUMBER,
}
# Fortran ignores case, so the constant needs a name that differs from the function.
RENAMED = {"STICKSLIP_ABI_VERSION": "STICKSLIP_ABI_VERSION_COMPILED"}
WIDTH = 120


def wrapped(text, indent):
    """Returns a line of Fortran, split into continuation lines if it is too long."""
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
        """Returns the type, the name and the shape of a member of a struct."""
        found = re.fullmatch(r"(const )?(\w+) (\*?)(\w+)((?:\[\w+\])*)", declared)
        kind, pointer, name, shape = found[2], found[3], found[4], re.findall(r"\[(\w+)\]", found[5])
        if pointer:
            kind = "type(c_ptr)"
        elif kind in self.functions:
            kind = "type(c_funptr)"
        else:
            kind = NUMBERS.get(kind) or self.struct(kind)
        # The first index varies fastest in Fortran, the last index in C.
        return kind, name, f"({', '.join(reversed(shape))})" if shape else ""

    def defaulted(self, struct, declared):
        """Returns a member with its default value; a struct within a struct uses the defaults of its own members."""
        kind, name, shape = self.member(declared)
        zeros = {"type(c_ptr)": "c_null_ptr", "type(c_funptr)": "c_null_funptr", NUMBERS["char"]: "c_null_char"}
        zero = zeros.get(kind, "" if kind.startswith("type") else "0")
        value = DEFAULTS.get((struct, name), zero)
        return f"{kind} :: {name}{shape}" + (f" = {value}" if value else "")

    def struct(self, kind):
        if kind not in self.structs:
            raise SystemExit(f"unknown type {kind}")
        return f"type({kind})"

    def parameter(self, declared):
        """Returns the name and the declaration of a parameter of a function."""
        found = re.fullmatch(r"(const )?(\w+) (\*const \*|\**)(\w+)", declared)
        is_const, kind, stars, name = found[1], found[2], found[3], found[4]
        many = "(*)" if name in ARRAYS else ""
        if not stars:
            return name, f"{NUMBERS[kind]}, value :: {name}"
        if kind in self.opaque or kind == "void":
            handle = "type(c_ptr)" if kind == "void" else f"type({kind})"
            if stars == "*":
                return name, f"{handle}, value :: {name}"
            return name, f"{handle}, intent({'in' if many else 'out'}) :: {name}{many}"
        base = NUMBERS.get(kind) or self.struct(kind)
        # An assumed-size array cannot have default initialisation.
        intent = "in" if is_const else "inout" if many else "out"
        # An omitted argument is passed as NULL.
        optional = "" if kind == "double" and many and name not in OPTIONAL else ", optional"
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


def declarations(text):
    """Returns the functions of the header, each with the lines of its documentation."""
    found, notes, lines = [], [], iter(text.splitlines())
    for line in lines:
        if line.startswith("//"):
            notes.append(line[2:].strip())
            continue
        if re.match(r"(const )?\w+ \*?stickslip_\w+\(", line):
            while not line.endswith(";"):
                line += " " + next(lines).strip()
            found.append((notes, line))
        notes = []
    return found


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
        note, comment = comment, []
        if found := re.fullmatch(r"#define (STICKSLIP_\w+) (\d+)", line):
            name = RENAMED.get(found[1], found[1])
            kind = "c_int8_t" if name in ("STICKSLIP_SEPARATED", "STICKSLIP_STICK", "STICKSLIP_SLIP") else "c_int32_t"
            constants += [f"    ! {row}".rstrip() for row in note]
            constants += [f"    integer({kind}), parameter, public :: {name} = {found[2]}"]
        elif found := re.fullmatch(r"typedef struct (stickslip_\w+) \1;", line):
            name = found[1]
            types[name] = [f"    ! {row}".rstrip() for row in note] + [f"    type, bind(c), public :: {name}"]
            types[name] += ["        type(c_ptr) :: address = c_null_ptr", f"    end type {name}"]
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
                    members.append((inner, row[:-1]))
                    inner = []
            types[name] = [f"    ! {row}".rstrip() for row in note] + [f"    type, bind(c), public :: {name}"]
            for notes, declared in members:
                types[name] += notes + wrapped(header.defaulted(name, declared), 8)
            types[name] += [f"    end type {name}"]
    for note, declared in declarations(body):
        functions += [f"        ! {row}".rstrip() for row in note] + header.function(declared) + [""]
    public = [f"    public :: {name}" for name in re.findall(r"function (stickslip_\w+)\(", "\n".join(functions))]
    print("! Fortran interface of stickslip.h, generated from it by make_bindings.py: do not edit. The rules at the head of")
    print("! stickslip.h apply here too. Each kind of object has a type that contains the C pointer. An omitted optional")
    print("! argument is passed as NULL. A matrix has its column index first. Members of structs have default values. The module")
    print("! stickslip has types that free themselves.")
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
