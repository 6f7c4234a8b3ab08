"""C++ headers of objects: classes whose methods are one call each."""

import re

from model import OBJECTS, WIDTH, comment, documentation, ordered, short

NUMBERS = {"size_t": "std::size_t", "int32_t": "std::int32_t", "uint8_t": "std::uint8_t"}
# Structs that C++ receives by reference, with a default value instead of nullptr.
DEFAULTS = {f"stickslip_{name}" for name in ("history_options", "jump_limits", "stiffness_options", "rolling_load")}
# Results that refer to samples of an object, by the group of the function. A temporary object returns a copy.
VIEWS = {"field": ("Field", "double"), "zones": ("Zones", "std::uint8_t")}
CHANGES = [(r"\bReturns (STICKSLIP_\w+) (if|for|unless|before|without)\b", r"Throws \1 \2"),
           (r"\breturns (STICKSLIP_\w+)", r"throws \1"),
           (r"stickslip_last_error_report writes", "Error::report returns"),
           (r"observer receives its results", "observe receives its results"),
           (r"forces then contains the points .* unchanged\.", "creep_forces_into keeps the points solved before.")]
# Types of observers in C++, by their types in C.
OBSERVERS = {"stickslip_observer": "Observe", "stickslip_step_observer": "ObserveStep"}
OBSERVED = "[&](const stickslip_observer *observer)"


def broken(text, indent):
    """Returns a line. A line that is too long is split at its lambda or after commas."""
    lines, rest = [], " " * indent + text
    if len(rest) > WIDTH and (found := re.fullmatch(r"(.*\{) (return .*;) (\}.*)", text)):
        return broken(found[1], indent) + broken(found[2], indent + 4) + broken(found[3], indent)
    while len(rest) > WIDTH:
        cut = rest.rfind(", ", indent + 1, WIDTH) + 1
        if cut == 0:
            break
        lines.append(rest[:cut].rstrip())
        rest = " " * (indent + 4) + rest[cut:].lstrip()
    return lines + [rest]


class Wrapper:
    """Method or function in C++ for a C function."""

    def __init__(self, header, owner, method):
        self.header, self.owner, self.method = header, owner, method
        self.function = header.function(owner, method)
        results = self.function.of("result")
        self.results = [one for one in results if not method.part or one.name == method.part]
        self.observers = [one.type for one in self.function.of("observer")]

    def type(self, argument):
        return NUMBERS.get(argument.type, argument.type)

    def inputs(self):
        """Returns the arguments of the wrapper, with a body and its layers as one argument."""
        found = self.function.of("object", "cells", "changed_cells", "array", "struct", "per_cell", "displacement",
                                 "tractions", "number", "flag", "index", "observer")
        coated = {one.name.replace("layers", "body") for one in found if one.name.startswith("layers_")}
        return [one for one in found if not one.name.startswith("layers_")], coated

    def parameter(self, one, coated):
        if one.name in coated:
            return f"const Coated &{one.name}"
        if one.kind == "object":
            of = f"{'const ' if one.is_const else ''}{OBJECTS[short(one.type)].cpp}"
            return f"{of} *{one.name} = nullptr" if one.is_optional else f"{of} &{one.name}"
        if one.kind == "observer":
            return f"const {OBSERVERS[one.type]} &observe = nullptr"
        plain = {"cells": f"const FieldArgument &{one.name}", "changed_cells": f"std::vector<double> &{one.name}",
                 "array": f"const std::vector<{self.type(one)}> &{one.name}", "flag": f"bool {one.name} = false",
                 "number": f"{self.type(one)} {one.name}", "index": f"{self.type(one)} {one.name}"}
        if one.kind in plain:
            return plain[one.kind]
        if one.is_optional and one.type in DEFAULTS:
            default = f"{one.type}_default()" if f"{one.type}_default" in self.header.defaults else "{}"
            return f"const {one.type} &{one.name} = {default}"
        return f"const {one.type} *{one.name} = nullptr" if one.is_optional else f"const {one.type} &{one.name}"

    def parameters(self):
        found, coated = self.inputs()
        return ", ".join(self.parameter(one, coated) for one in ordered(found, self.method.cpp_order))

    def expression(self, one, coated):
        if one.name in coated:
            return f"&{one.name}.base"
        if one.name.startswith("layers_"):
            layers = f"body_{one.name[-1]}.layers"
            return f"{layers}.data(), {layers}.size()"
        if one.kind == "result":
            if one not in self.results:
                return "nullptr"
            return "&found" if len(self.results) == 1 else ["&found.first", "&found.second"][self.results.index(one)]
        if one.kind == "object" and one.is_optional:
            return f"{one.name} == nullptr ? nullptr : {one.name}->get()"
        plain = {"self": "get()", "object": f"{one.name}.get()", "flag": f"{one.name} ? 1 : 0", "made": "out",
                 "number": one.name, "index": one.name, "observer": "observer", "filled_array": f"{one.name}.data()"}
        if one.kind in ("cells", "changed_cells", "filled_cells", "array"):
            return f"{one.name}.data(), {one.name}.size()"
        is_pointer = one.is_optional and one.type not in DEFAULTS
        return plain.get(one.kind, one.name if is_pointer else f"&{one.name}")

    def call(self, more=""):
        _, coated = self.inputs()
        arguments = [self.expression(one, coated) for one in self.function.arguments]
        return f"{self.function.c}({', '.join(arguments + ([more] if more else []))})"

    def notes(self, indent):
        return comment(documentation(self.function.notes, "cpp", CHANGES), "/// ", indent)

    def result(self):
        """Returns the type of the wrapper and the declaration of its result."""
        types = [self.type(one) for one in self.results]
        if filled := self.function.of("filled_cells"):
            return "std::vector<double>", f"std::vector<double> {filled[0].name}(cells());"
        if filled := self.function.of("filled_array"):
            of = f"std::vector<{filled[0].type}>"
            return of, f"{of} {filled[0].name}({filled[0].like}.size());"
        if not types:
            return "void", ""
        of = types[0] if len(types) == 1 else f"std::pair<{', '.join(types)}>"
        return of, f"{of} found{{}};"

    def body(self):
        """Returns the type of the wrapper and the lines of its body."""
        group = self.function.group
        if group in VIEWS:
            view, of = VIEWS[group]
            return view, [f"return detail::viewed<{of}>([&](std::size_t *count) {{ return {self.call('count')}; }});"]
        if group:
            types = {"warnings": "std::vector<stickslip_warning>", "spots": "Spots", "edges": "Edges",
                     "bytes": "std::vector<std::uint8_t>"}
            helper = {"warnings": "listed<stickslip_warning>(", "bytes": "listed<std::uint8_t>(",
                      "spots": "spotted(cells(), ", "edges": "edged(cells(), "}[group]
            return types[group], [f"return detail::{helper}[&](auto... to) {{ return {self.call('to...')}; }});"]
        of, declared = self.result()
        made = f"check({self.call()});"
        for kind in self.observers:
            observed = OBSERVED.replace("stickslip_observer", kind)
            made = f"detail::Watch(observe).run({observed} {{ return {self.call()}; }});"
        if self.method.then:
            return self.then_type(), [made, f"return {self.method.then}();"]
        name = next((one.name for one in self.function.of("filled_cells", "filled_array")), "found")
        return of, ([declared] if declared else []) + [made] + ([f"return {name};"] if of != "void" else [])

    def into(self, indent):
        """Returns the variant that fills a vector of the caller, and the method itself, which calls this variant."""
        cpp, filled = self.method.cpp, self.function.of("filled_array")[0]
        name, of = filled.name, f"std::vector<{filled.type}>"
        arguments = self.parameters().replace(", const Observe", f", {of} &{name}, const Observe")
        notes = f"Fills a vector like {cpp}. After a failure the vector contains the entries computed before."
        body = [f"{name}.assign({filled.like}.size(), {{}});",
                f"detail::Watch(observe).run({OBSERVED} {{ return detail::kept({self.call()}, {name}); }});"]
        plain = [f"{of} {name};", f"{cpp}_into({filled.like}, {name}, observe);", f"return {name};"]
        return self.notes(indent) + self.define(f"{of} {cpp}({self.parameters()})", plain, indent) + \
            comment(notes, "/// ", indent) + self.define(f"void {cpp}_into({arguments})", body, indent)

    def then_type(self):
        then = next(one for one in self.owner.methods if one.name == self.method.then)
        return Wrapper(self.header, self.owner, then).result()[0]

    def lines(self, scope, known, indent):
        """Returns the wrapper, and its definition apart from the class if it uses a class that follows."""
        if self.method.into:
            return self.into(indent), []
        cpp, made = self.method.cpp, self.function.of("made")
        later = [one for one in self.function.of("object") if OBJECTS[short(one.type)].cpp not in known]
        arguments = self.parameters()
        if made and self.method.name.startswith("new"):
            is_explicit = sum("=" not in one for one in arguments.split(", ")) <= 1
            head, result = f"{scope}({arguments})", "explicit " if is_explicit else ""
            body = [f": own_(detail::made<Own>([&](auto **out) {{ return {self.call()}; }})) {{}}"]
        elif made:
            result, head = ("" if self.function.of("self") else "static ") + scope + " ", f"{cpp}({arguments})"
            body = [f"return {scope}(detail::made<Own>([&](auto **out) {{ return {self.call()}; }}));"]
        else:
            result, body = self.body()
            result, head = result + " ", f"{cpp}({arguments})"
        selves = self.function.of("self")
        head += " const" if selves and selves[0].is_const else ""
        start = "" if self.owner else "inline "
        if self.function.group in VIEWS:
            names = ", ".join(one.name for one in self.function.of("number"))
            copy = temporary(VIEWS[self.function.group][1], cpp, arguments, names)
            return self.notes(indent) + self.define(result + head + " &", body, indent) + copy, []
        if not later:
            return self.notes(indent) + self.define(start + result + head, body, indent), []
        plain = re.sub(r" = [^,)]+(\(\))?", "", head)
        apart = self.define(f"inline {result.replace('explicit ', '')}{scope}::{plain}", body, 0)
        return self.notes(indent) + broken(f"{result}{head};", indent), apart

    @staticmethod
    def define(head, body, indent):
        if body[0].startswith(":"):
            one = f"{head} {body[0]}"
            if len(one) + indent <= WIDTH:
                return [" " * indent + one]
            return broken(head, indent) + broken(body[0], indent + 4)
        one = f"{head} {{ {body[0]} }}"
        if len(body) == 1 and len(one) + indent <= WIDTH:
            return [" " * indent + one]
        lines = broken(head + " {", indent)
        for line in body:
            lines += broken(line, indent + 4)
        return lines + [" " * indent + "}"]


def temporary(of, name, parameters="", arguments=""):
    """Returns the overload of a view for temporary objects, which returns a copy of the samples."""
    return [f"    std::vector<{of}> {name}({parameters}) const && {{ return {name}({arguments}).copy(); }}"]


def solver(c, solution, f):
    """Returns the methods of a solver that create and fill a solution."""
    return f"""    /// Solves into a new solution.
    {solution} solve(const Observe &observe = nullptr) {{
        {solution} solution = new_solution();
        solve_into(solution, observe);
        return solution;
    }}
    /// Creates an empty solution of the right size.
    {solution} new_solution() const {{
        return {solution}(detail::made<{solution}::Own>(
            [&](auto **out) {{ return {f}_new(get(), out); }}));
    }}
    /// Solves into a solution of the same bodies. If the solve does not converge, the solution contains the last
    /// iterate.
    void solve_into({solution} &solution, const Observe &observe = nullptr) {{
        detail::Watch(observe).run({OBSERVED} {{
            return stickslip_{c}_solve(get(), solution.get(), observer);
        }});
    }}""".splitlines()


def class_of(header, owner, known):
    """Returns a class, and the definitions that must follow all classes of its file."""
    c = f"stickslip_{owner.c}"
    lines, apart = comment(header.notes[owner.c], "/// ", 0) + [f"class {owner.cpp} {{", "  public:"], []
    known.add(owner.cpp)
    for method in owner.methods:
        if method.cpp is None:
            continue
        if method.name == "solve" and owner.c.endswith("solver"):
            solution = owner.c.replace("solver", "solution")
            header.wrapped |= {f"{c}_solve", f"stickslip_{solution}_new"}
            lines += solver(owner.c, OBJECTS[solution].cpp, f"stickslip_{solution}")
            continue
        own, later = Wrapper(header, owner, method).lines(owner.cpp, known, 4)
        lines, apart = lines + own, apart + later
    for name in owner.fields.split() if owner.fields != "stress_xx" else []:
        notes = re.split(r"(?<=\.) ", header.notes[f"STICKSLIP_{name.upper()}"])[0]
        if name.startswith("slip") and "rolling" in owner.c:
            notes = f"Slip along {name[-1]} per unit length rolled (dimensionless)."
        lines += comment(notes, "/// ", 4)
        lines.append(f"    Field {name}() const & {{ return field(STICKSLIP_{name.upper()}); }}")
        lines += temporary("double", name)
    lines += [f"    {c} *get() const {{ return own_.get(); }}", "", "  private:"]
    if owner.c.endswith("solution"):
        lines.append(f"    friend class {owner.cpp.replace('Solution', 'Solver')};")
    lines += broken(f"using Own = detail::Owned<{c}, {c}_free>;", 4)
    lines.append(f"    explicit {owner.cpp}(Own own) : own_(std::move(own)) {{}}")
    if owner.fields:
        first = owner.fields.split()[0].upper()
        lines.append(f"    std::size_t cells() const {{ return field(STICKSLIP_{first}).size(); }}")
    return lines + ["    Own own_;", "};", ""], apart


def write(header, file):
    """Returns the text of a C++ header."""
    guard = f"STICKSLIP_{file.cpp.upper()}_HPP"
    system = [f"#include <{name}>" for name in ("cstddef", "cstdint", "utility", "vector")]
    lines = [f"// {file.title}", "// Generated by wrappers/make.py from stickslip.h: do not edit.", "",
             f"#ifndef {guard}", f"#define {guard}", "", *system, "", *(f'#include "{name}.hpp"' for name in file.includes.split()), "",
             "namespace stickslip {", ""]
    own = {object.cpp for object in file.objects}
    known, apart = {object.cpp for object in OBJECTS.values()} - own, []
    lines += [f"class {name};" for name in sorted(own)] + [""]
    for owner in file.objects:
        rows, later = class_of(header, owner, known)
        lines, apart = lines + rows, apart + later
    for method in file.functions:
        rows, _ = Wrapper(header, None, method).lines("", known, 0)
        lines += rows + [""]
    lines += apart + [""] if apart else []
    return "\n".join(lines + ["} // namespace stickslip", "", f"#endif // {guard}", ""])
