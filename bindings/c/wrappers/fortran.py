"""Fortran modules of objects: types that free themselves, with procedures that are one call each."""

import re

from model import NUMBERS, OBJECTS, WIDTH, comment, documentation, ordered, short

STATUS = "integer(c_int32_t), intent(out), optional :: status"
OBSERVER = "type({}), intent(in), optional :: observer"
CHANGES = [(r"and returns their number", "and writes their number to taken"),
           (r"number index, counted from zero", "number index, counted from one"),
           (r"index is not less than the number of depths", "no depth has this number")]
RANK = {"cells": ":, :", "changed_cells": ":, :", "paired_cells": ":, :", "filled_cells": ":, :", "array": ":",
        "filled_array": ":"}


def broken(text, indent):
    """Returns a line of Fortran, split into continuation lines if it is too long."""
    lines, rest = [], " " * indent + text
    while len(rest) > WIDTH:
        cut = max(rest.rfind(mark, 0, WIDTH - 2) for mark in (", ", " .or. ")) + 1
        lines.append(rest[:cut].rstrip() + " &")
        rest = " " * (indent + 4) + rest[cut:].lstrip()
    return lines + [rest]


def base(kind):
    return NUMBERS.get(kind) or f"type({kind})"


class Procedure:
    """Procedure of a type, or of a module, for a C function."""

    def __init__(self, header, owner, method):
        self.owner, self.method = owner, method
        self.function = header.function(owner, method)
        self.name = f"{owner.c}_{method.f}" if owner else method.f
        made = self.function.of("made")
        self.is_created = bool(made)
        self.grid = "this%grid"
        if made or not owner:
            grids = [one.name for one in self.function.of("object") if OBJECTS[short(one.type)].has_grid]
            names = [one.name for one in self.function.arguments]
            self.grid = f"{grids[0]}%grid" if grids else "grid" if "grid" in names else ""
        self.checks, self.locals, self.before = [], [], []

    def inputs(self):
        found = self.function.of("object", "cells", "changed_cells", "paired_cells", "filled_cells", "array", "struct",
                                 "per_cell", "displacement", "tractions", "number", "flag", "index", "observer")
        return ordered(found + self.function.of("filled_array"), self.method.f_order) if self.method.f_order else \
            ordered(found, "")

    def dummy(self, one):
        """Returns the names and the declarations of an argument, and notes its checks."""
        name, optional = one.name, ", optional" if one.is_optional else ""
        if one.kind == "object":
            if one.is_optional:
                self.locals.append(f"type({one.type}) :: {name}_handle")
                self.before.append(f"if (present({name})) {name}_handle = {name}%handle")
            return [name], [f"class({OBJECTS[short(one.type)].f}), intent(in){optional} :: {name}"]
        if one.kind in ("displacement", "tractions"):
            declared = "real(c_double), intent(in), target, contiguous"
            if one.kind == "tractions":
                self.checks.append(f"all_fit({self.grid}, pressure, x, y, status)")
                return ["pressure", "x", "y"], [f"{declared} :: pressure(:, :)",
                                                f"{declared}, optional :: x(:, :), y(:, :)"]
            self.checks += [f"fits('{axis}', shape({axis}), {self.grid}, status)" for axis in "xy"]
            return ["x", "y"], [f"{declared} :: x(:, :), y(:, :)"]
        if one.kind in RANK:
            if RANK[one.kind] == ":, :":
                self.checks.append(f"fits('{name}', shape({name}), {self.grid}, status)")
            if one.kind == "filled_array":
                return [name], [f"{base(one.type)}, allocatable, intent(out) :: {name}(:)"]
            intent = "in" if one.is_const else "inout"
            return [name], [f"{base(one.type)}, intent({intent}), contiguous :: {name}({RANK[one.kind]})"]
        if one.kind == "flag":
            self.locals.append(f"integer(c_int32_t) :: {name}_number")
            self.before += [f"{name}_number = 0",
                            f"if (present({name})) {name}_number = merge(1_c_int32_t, 0_c_int32_t, {name})"]
            return [name], [f"logical, intent(in), optional :: {name}"]
        if one.kind == "index":
            return [name], [f"integer, intent(in) :: {name}"]
        if one.kind == "per_cell":
            return [name], [f"real(c_double), intent(in) :: {name}"]
        return [name], [f"{base(one.type)}, intent(in){optional} :: {name}"]

    def expression(self, one):
        if one.kind in RANK and one.kind not in ("filled_array", "paired_cells"):
            return f"{one.name}, size({one.name}, kind=c_size_t)"
        mark = "_" if one.is_optional else "%"
        return {"self": "this%handle", "object": f"{one.name}{mark}handle", "made": "made", "flag": f"{one.name}_number",
                "index": f"int({one.name} - 1, c_size_t)", "tractions": "tractions_of(pressure, x, y)",
                "displacement": "stickslip_relative_displacement(c_loc(x), c_loc(y), size(x, kind=c_size_t))",
                "per_cell": f"stickslip_per_cell({one.name})"}.get(one.kind, one.name)

    def call(self, more=""):
        arguments = [self.expression(one) for one in self.function.arguments]
        return f"{self.function.c}({', '.join(arguments + ([more] if more else []))})"

    def write(self):
        """Returns the lines of the procedure."""
        function, group = self.function, self.function.group
        results = function.of("result")
        is_function = group in ("field", "zones") or (len(results) == 1 and not results[0].is_optional)
        outputs = [] if is_function else [one for one in results]
        inputs, filled = self.inputs(), [] if self.method.f_order else function.of("filled_array")
        observers = [one for one in inputs if one.kind == "observer"]
        names, declared = [], []
        for one in [one for one in inputs if one not in observers] + filled:
            more, lines = self.dummy(one)
            names, declared = names + more, declared + lines
        for one in outputs:
            names.append(one.name)
            declared.append(f"{base(one.type)}, intent(out){', optional' if one.is_optional else ''} :: {one.name}")
        more, lines = self.group_outputs()
        names, declared = names + more, declared + lines
        if function.of("made") and function.of("self"):
            names.append("copy")
            declared.append(f"class({self.owner.f}), intent(inout) :: copy")
        names += ["observer"] * len(observers)
        declared += [OBSERVER.format(one.type) for one in observers] + [STATUS]
        body, locals_ = self.body(group, is_function, results)
        is_changed = (self.is_created and not function.of("self")) or self.method.creates
        this = [f"class({self.owner.f}), intent({'inout' if is_changed else 'in'}) :: this"] if self.owner else []
        kind = "function" if is_function else "subroutine"
        head = f"{kind} {self.name}({', '.join((['this'] if self.owner else []) + names + ['status'])})"
        notes = function.notes + " The first call creates the object." * self.method.creates
        lines = comment(documentation(notes, "f", CHANGES), "! ", 4)
        lines += broken(head + (" result(found)" if is_function else ""), 4)
        if is_function:
            samples = {"field": "real(c_double)", "zones": "integer(c_int8_t)"}.get(group)
            found = f"{samples}, pointer :: found(:, :)" if samples else f"{base(results[0].type)} :: found"
            locals_ = [found] + locals_
            if self.checks and results and results[0].type in NUMBERS:
                self.before.insert(0, "found = 0")
        for one in this + declared + locals_ + self.locals:
            lines += broken(one, 8)
        for one in function.of("index"):
            message = f"'the {one.name} must be at least 1'"
            lines += [f"        if ({one.name} < 1) then", f"            call refuse(STICKSLIP_LENGTH, {message}, status)",
                      "            return", "        end if"]
        allocated = [f"allocate ({one.name}(size({one.like})))" for one in function.of("filled_array")]
        for one in self.before + allocated + [f"if (.not. {check}) return" for check in self.checks] + body:
            lines += broken(one, 8)
        return lines + [f"    end {kind} {self.name}"]

    def group_outputs(self):
        """Returns the names and the declarations of the results that several arguments of C describe."""
        shape = "allocatable, intent(out), optional"
        return {
            "warnings": (["warnings"], ["type(stickslip_warning), allocatable, intent(out) :: warnings(:)"]),
            "bytes": (["bytes"], ["integer(c_int8_t), allocatable, intent(out) :: bytes(:)"]),
            "spots": (["spots", "labels"], ["type(stickslip_spot), allocatable, intent(out) :: spots(:)",
                                            f"integer(c_int32_t), {shape} :: labels(:, :)"]),
            "edges": (["edges", "centres", "means"], ["type(stickslip_edges), intent(out) :: edges",
                                                      f"real(c_double), {shape} :: centres(:, :), means(:, :)"]),
        }.get(self.function.group, ([], []))

    def body(self, group, is_function, results):
        """Returns the statements and the local variables."""
        count, code = "integer(c_size_t) :: count", "integer(c_int32_t) :: code"
        report = "call report_status(code, status)"
        if group in ("field", "zones"):
            return [f"first = {self.call('count')}",
                    f"found => {'plane' if group == 'field' else 'map_of_zones'}(first, count, this%grid, status)"], \
                ["type(c_ptr) :: first", count]
        if group in ("warnings", "bytes"):
            to, length = ("warnings", "count") if group == "warnings" else ("bytes", "length")
            return [f"code = {self.call(f'capacity=0_c_size_t, {length}=count')}", "if (code == STICKSLIP_OK) then",
                    f"    allocate ({to}(count))",
                    f"    code = {self.call(f'{to}, size({to}, kind=c_size_t), count')}", "end if", report], [count, code]
        if group == "spots":
            spots = "spots, size(spots, kind=c_size_t), count, "
            return [f"code = {self.call('capacity=0_c_size_t, count=count, cells=0_c_size_t')}",
                    "if (code == STICKSLIP_OK) then", "    allocate (spots(count))", "    if (present(labels)) then",
                    "        allocate (labels(this%grid%nx, this%grid%ny))",
                    f"        code = {self.call(spots + 'labels, size(labels, kind=c_size_t)')}", "    else",
                    f"        code = {self.call(spots + 'cells=0_c_size_t')}", "    end if", "end if", report], [count, code]
        if group == "edges":
            # Local arrays replace the arguments, because gfortran does not pass on an absent allocatable argument.
            return ["if (present(centres)) allocate (at_centres(this%grid%nx, this%grid%ny))",
                    "if (present(means)) allocate (over_cells(this%grid%nx, this%grid%ny))",
                    f"code = {self.call('edges, at_centres, over_cells, this%grid%nx * this%grid%ny')}",
                    "if (present(centres)) call move_alloc(at_centres, centres)",
                    "if (present(means)) call move_alloc(over_cells, means)", report], \
                ["real(c_double), allocatable :: at_centres(:, :), over_cells(:, :)", code]
        if self.is_created:
            to, grid = ("copy", "this%grid") if self.function.of("self") else ("this", self.grid)
            grid = f"{grid}, " if self.owner.has_grid else ""
            return [f"code = {self.call()}", f"call {self.owner.c}_take({to}, made, {grid}code, status)"], \
                [f"type(stickslip_{self.owner.c}) :: made", code]
        call = self.call()
        if is_function:
            call = re.sub(rf"\b{results[0].name}\)$", "found)", call)
        if self.method.creates:
            source = self.function.of("object")[0].name
            grid = [f"    this%grid = {source}%grid"] if self.owner.has_grid else []
            return ["if (c_associated(this%address())) then", f"    code = {call}", "else",
                    f"    code = stickslip_{self.owner.c}_new({source}%handle, this%handle)",
                    f"    if (code == STICKSLIP_OK) call this%own(c_funloc(stickslip_{self.owner.c}_free))", *grid,
                    "end if", report], [code]
        return [f"call report_status({call}, status)"], []


def for_each_cell(procedure):
    """Returns the variant of a procedure with a coefficient for each cell instead of one coefficient."""
    lines = []
    for line in procedure:
        line = re.sub(r"((?:end )?subroutine wear\w+)_uniform", r"\1_of_cells", line)
        line = line.replace("(this, coefficient,", "(this, coefficients,")
        line = line.replace("real(c_double), intent(in) :: coefficient",
                            "real(c_double), intent(in), target, contiguous :: coefficients(:, :)")
        line = line.replace("stickslip_per_cell(coefficient)", "per_cell(coefficients, this%grid)")
        if "if (.not. fits('depth'" in line:
            lines.append(line.replace("depth", "coefficients"))
        lines.append(line)
    return lines


def solve(owner, solution):
    c = owner.c
    return f"""    ! Solves into a solution; the first solve into it creates it. If the solve does not converge, the solution
    ! contains the last iterate.
    subroutine {c}_solve(this, solution, observer, status)
        class({owner.f}), intent(in) :: this
        class({solution.f}), intent(inout) :: solution
        {OBSERVER.format("stickslip_observer")}
        {STATUS}
        integer(c_int32_t) :: code
        code = STICKSLIP_OK
        if (.not. c_associated(solution%address())) then
            code = stickslip_{solution.c}_new(this%handle, solution%handle)
            if (code == STICKSLIP_OK) call solution%own(c_funloc(stickslip_{solution.c}_free))
            solution%grid = this%grid
        end if
        if (code == STICKSLIP_OK) code = stickslip_{c}_solve(this%handle, solution%handle, observer)
        call report_status(code, status)
    end subroutine {c}_solve""".splitlines()


def lifetime(owner, is_taken):
    """Returns the procedures that replace and free an object."""
    c, f = owner.c, owner.f
    grid, declared, kept = (("grid, ", "        type(stickslip_grid), intent(in) :: grid\n",
                             "            this%grid = grid\n") if owner.has_grid else ("", "", ""))
    take = f"""    ! Replaces the object by the new one. If made_with is a failure or the old object is in use, the old object remains.
    subroutine {c}_take(this, made, {grid}made_with, status)
        class({f}), intent(inout) :: this
        type(stickslip_{c}), intent(in) :: made
{declared}        integer(c_int32_t), intent(in) :: made_with
        {STATUS}
        integer(c_int32_t) :: code, given_up
        code = made_with
        if (code == STICKSLIP_OK) code = stickslip_{c}_free(this%handle)
        if (code == STICKSLIP_OK) then
            this%handle = made
            call this%own(c_funloc(stickslip_{c}_free))
{kept}        else
            given_up = stickslip_{c}_free(made)
        end if
        call report_status(code, status)
    end subroutine {c}_take

"""
    return ((take if is_taken else "") + f"""    function {c}_address(this) result(address)
        class({f}), intent(in) :: this
        type(c_ptr) :: address
        address = this%handle%address
    end function {c}_address

    ! Frees the object unless another thread is using it.
    impure elemental subroutine {c}_free(this)
        class({f}), intent(inout) :: this
        if (stickslip_{c}_free(this%handle) == STICKSLIP_OK) then
            this%handle = stickslip_{c}()
            call this%disown()
        end if
    end subroutine {c}_free

    impure elemental subroutine {c}_refuse(this, other)
        class({f}), intent(inout) :: this
        class({f}), intent(in) :: other
        call refuse_copy(this, other)
    end subroutine {c}_refuse""").splitlines()


def write(header, file):
    """Returns the text of a Fortran module."""
    types, procedures = [], []
    for owner in file.objects:
        bound, is_taken = [], False
        for method in owner.methods:
            if method.f is None:
                continue
            if method.name == "solve" and owner.c.endswith("solver"):
                procedures += [*solve(owner, OBJECTS[owner.c.replace("solver", "solution")]), ""]
                bound.append(f"procedure :: solve => {owner.c}_solve")
                continue
            procedure = Procedure(header, owner, method)
            is_taken |= procedure.is_created
            if procedure.function.of("per_cell"):
                procedure.name = f"{method.f}_uniform"
                lines = procedure.write()
                procedures += [*lines, "", *for_each_cell(lines), ""]
                both = f"{method.f}_uniform, {method.f}_of_cells"
                bound += [f"procedure, private :: {both}", f"generic :: {method.f} => {both}"]
                continue
            procedures += [*procedure.write(), ""]
            bound.append(f"procedure :: {method.f} => {procedure.name}")
        procedures += [*lifetime(owner, is_taken), ""]
        notes = header.notes[owner.c]
        notes += " The first solve into it creates it." if owner.c.endswith("solution") else ""
        types += [*comment(notes, "! ", 4), f"    type, extends(stickslip_object) :: {owner.f}",
                  f"        type(stickslip_{owner.c}) :: handle",
                  *["        type(stickslip_grid) :: grid"] * owner.has_grid, "    contains",
                  *(f"        {one}" for one in bound), f"        procedure :: address => {owner.c}_address",
                  f"        procedure :: free => {owner.c}_free", f"        procedure, private :: {owner.c}_refuse",
                  f"        generic :: assignment(=) => {owner.c}_refuse",
                  f"    end type {owner.f}", ""]
    functions = [method for method in file.functions if method.f is not None]
    for method in functions:
        procedures += [*Procedure(header, None, method).write(), ""]
    public = ", ".join([owner.f for owner in file.objects] + [method.f for method in functions])
    lines = [f"! {file.title}", "! Generated by wrappers/make.py from stickslip.h: do not edit.",
             f"module stickslip_{file.f}", "    use, intrinsic :: iso_c_binding", "    use stickslip_bindings"]
    lines += [f"    use stickslip_{name}" for name in (file.uses or "base").split()]
    private = ["    private", ""] + broken(f"public :: {public}", 4) if file.uses else []
    lines += ["    implicit none", *private, "", *types, "contains", "", *procedures[:-1]]
    return "\n".join([*lines, f"end module stickslip_{file.f}", ""])
