"""Creates the pages of the site from other sources: READMEs, the guide and the module docs of the crate with their pictures, the
C header, and the Python examples, which are executed."""

import base64
import contextlib
import importlib
import io
import os
import pathlib
import pkgutil
import re
import sys

import stickslip

ROOT = pathlib.Path(__file__).resolve().parents[2]
CRATE = "https://docs.rs/stickslip/latest/stickslip"
# The address of the project, or None if Cargo.toml does not state it; files outside the site then have no link.
REPOSITORY = next(iter(re.findall(r'^repository = "(.*)"', (ROOT / "Cargo.toml").read_text(), re.M)), None)

# The pages of the guide with their titles, in the order of src/guide/mod.rs.
GUIDE = {
    "first_steps": "First steps",
    "which_model": "Which model",
    "nomenclature": "Nomenclature",
    "troubleshooting": "Results that look wrong",
    "theory": "Theory",
    "grids_and_steps": "Grids and load steps",
    "accuracy": "Accuracy and speed",
    "validation": "Validation",
    "hard_cases": "Hard cases",
    "errata": "Errata of the paper",
    "rough_surfaces": "Rough surfaces",
    "load_steps": "Growing contacts and dissimilar bodies",
    "fretting_and_wear": "Fretting and wear",
    "rolling": "Rolling",
    "coatings": "Coatings",
    "sensitivities": "Sensitivities",
    "subsurface_stress": "Stresses below the surface",
    "embedding": "Contacts in a simulator",
    "memory_and_errors": "Memory, time and errors",
    "studies": "Parameter studies",
    "distributed": "One contact on several machines",
}
# Each page with its file and, if only a part is included, its first heading and the heading after it.
INCLUDED = {
    "introduction": ("README.md", "# stickslip", "## Two commands"),
    "python": ("bindings/python/README.md",),
    "c": ("bindings/c/README.md",),
    "gallery": ("examples/README.md",),
    "comparison": ("README.md", "## Speed against error", "## What is modelled, and what is not"),
    "measurements": ("benches/README.md",),
    "changes": ("CHANGELOG.md",),
    **{f"guide/{name}": (f"src/guide/{name}.md",) for name in GUIDE},
    "methods/solver": ("src/cgm/mod.rs",),
    "methods/influence": ("src/influence/mod.rs",),
    "methods/normal": ("src/normal/mod.rs",),
    "methods/tangential": ("src/tangential/mod.rs",),
    "methods/coupled": ("src/coupled/mod.rs",),
    "methods/history": ("src/history/mod.rs",),
    "methods/wear": ("src/history/wear/mod.rs",),
    "methods/rolling": ("src/rolling/mod.rs",),
    "methods/layers": ("src/bodies/layers/mod.rs",),
    "methods/edges": ("src/edges/mod.rs",),
    "methods/stiffness": ("src/stiffness/mod.rs",),
    "methods/subsurface": ("src/subsurface/mod.rs",),
    "methods/adaptive": ("src/adaptive/mod.rs",),
    "methods/sensitivity": ("src/sensitivity/mod.rs",),
}
TITLES = {
    "python": "Python",
    "c": "C, C++ and Fortran",
    "gallery": "Gallery",
    "measurements": "Measurements",
    "comparison": "Speed, and comparison with other codes",
    **{f"guide/{name}": title for name, title in GUIDE.items()},
    "methods/solver": "Solver and certificate",
    "methods/influence": "Influence coefficients",
    "methods/normal": "Normal contact",
    "methods/tangential": "Tangential contact",
    "methods/coupled": "Bodies of different materials",
    "methods/history": "Histories",
    "methods/wear": "Wear",
    "methods/rolling": "Steady rolling",
    "methods/layers": "Coated bodies",
    "methods/edges": "Edges inside the cells",
    "methods/stiffness": "Stiffness",
    "methods/subsurface": "Stresses and displacements",
    "methods/adaptive": "Contacts of required accuracy",
    "methods/sensitivity": "Sensitivities",
}
PYTHON = (
    "Each program on this page is in Rust, followed by the same program in Python. The [tutorials]({up}tutorials/press.md), the "
    "[Python reference]({up}api/index.md) and the [C reference]({up}c_reference.md) show further calls."
)
RUST = (
    "The code on this page is in Rust. The [tutorials]({up}tutorials/press.md), the [Python reference]({up}api/index.md) and the "
    "[C reference]({up}c_reference.md) show the calls of the other languages."
)
TUTORIALS = ("press", "shear", "rough", "dissimilar", "subsurface", "wear")
PAGE_OF = {files[0]: page for page, files in INCLUDED.items() if len(files) == 1}
# A part of a page in a source file: a line of its docs, or a file. The pictures are files that contain an element with their data.
DOCS = re.compile(r'^ *//[/!](?P<line>.*)$|^ *#!?\[.*include_str!\("(?P<file>[^"]+)"\).*\]$', re.M)
DATA = re.compile(r'<img alt="(?P<alt>[^"]*)" src="data:image/(?P<kind>\w+)[^,]*;base64,(?P<data>[^"]*)"[^>]*>')
IMAGE = re.compile(r'(?:!\[(?P<text>[^\]]*)\]\((?P<file>[^)]*)\)|<img src="(?P<source>[^"]*)"[^>]*alt="(?P<alt>[^"]*)">)')
# A link whose text can be code, and whose target can contain parentheses: `[`sum`](crate::surface::sum())`.
LINK = re.compile(r"(?<!!)\[(?P<words>`[^`]*`|[^\]\[]+)\]\((?P<target>[^()\s]*(?:\(\))?[^()\s]*)\)")
DEFINITION = re.compile(r"^(?P<name>\[[^\]]+\]): (?P<target>crate\S*)$", re.M)
# The name of an item without a target: [`History`].
NAME = re.compile(r"(?<!\])\[`(?P<name>[\w:]+(?:\(\))?)`\](?![(\[:])")


def write(folder: pathlib.Path) -> None:
    """Writes all pages into the folder, in addition to the existing pages."""
    listed = re.findall(r"^pub mod (\w+) \{\}$", (ROOT / "src/guide/mod.rs").read_text(), re.M)
    if listed != list(GUIDE):
        sys.exit(f"docs/site/pages.py: the guide has the pages {', '.join(listed)}")
    for page, (file, *part) in INCLUDED.items():
        put(folder / f"{page}.md", included(folder, page, file, *part))
    for name in TUTORIALS:
        put(folder / "tutorials" / f"{name}.md", tutorial(folder, name))
    put(folder / "c_reference.md", c_reference())
    for name, text in api():
        put(folder / "api" / f"{name}.md", text)


def put(file: pathlib.Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def included(folder: pathlib.Path, page: str, file: str, first: str = "", end: str = "") -> str:
    if page.startswith("guide/"):
        name = page.removeprefix("guide/")
        guide = (ROOT / "src/guide/mod.rs").read_text()
        attributes = re.search(rf"((?:^(?:///|#\[).*\n)+)^pub mod {name} \{{\}}$", guide, re.M)[1]
        text = docs(folder, page, "src/guide/mod.rs", attributes)
    elif file.endswith(".rs"):
        lines = (ROOT / file).read_text().splitlines()
        text = docs(folder, page, file, "\n".join(line for line in lines if line.startswith(("//!", "#![cfg_attr(doc, "))))
    else:
        text = (ROOT / file).read_text()
    if first:
        text = text[text.index(first) + len(first) : text.index(end)]
    if page in TITLES:
        text = re.sub(r"\A# .*\n", "", text)
    parts = re.split(r"(^ *```.*?^ *```$)", text, flags=re.M | re.S)
    # If there are headings of the first level, all headings move one level down, below the title.
    below = page in TITLES and any(re.search(r"^# ", part, re.M) for part in parts[::2])
    parts[::2] = [prose(folder, page, file, re.sub(r"^#", "##", part, flags=re.M) if below else part) for part in parts[::2]]
    parts[1::2] = [code(part) for part in parts[1::2]]
    title = f"# {TITLES[page]}\n\n" if page in TITLES else ""
    in_rust = [place for place, part in enumerate(parts) if part.startswith("```rust")]
    in_python = programs(page)
    for place, program in zip(in_rust, in_python):
        parts[place] += f"\n\nIn Python:\n\n```python\n{program}\n```"
    if in_python and len(in_python) != len(in_rust):
        sys.exit(f"docs/site/python: {page} has {len(in_rust)} programs in Rust, but {len(in_python)} in Python")
    note = f"{(PYTHON if in_python else RUST).format(up=up(page))}\n\n"
    note = note if in_rust and page.startswith(("guide/", "methods/")) else ""
    return title + note + "".join(parts)


def programs(page: str) -> list[str]:
    """Returns the Python programs of a page of the guide, in the order of its programs in Rust."""
    file = ROOT / "docs" / "site" / "python" / f"{page.removeprefix('guide/')}.py"
    if not page.startswith("guide/") or not file.exists():
        return []
    return [part.strip("\n") for part in re.split(r"^# %%\n", file.read_text(), flags=re.M)[1:]]


def docs(folder: pathlib.Path, page: str, file: str, source: str) -> str:
    """Returns the docs that consist of lines and of included files: text, and pictures, which become files of the site."""
    parts = []
    for match in DOCS.finditer(source):
        if match["file"] is None:
            parts.append(match["line"].removeprefix(" "))
        elif match["file"].endswith(".html"):
            included = ROOT / pathlib.Path(file).parent / match["file"]
            picture = DATA.search(included.read_text())
            # The gallery has pictures of the same names.
            copy = folder / "pictures" / "docs" / f"{included.stem}.{picture['kind']}"
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_bytes(base64.b64decode(picture["data"]))
            parts.append(f"\n![{picture['alt']}]({up(page)}pictures/docs/{copy.name})\n")
        else:
            parts.append((ROOT / pathlib.Path(file).parent / match["file"]).read_text())
    return "\n".join(parts)


def code(block: str) -> str:
    """Returns a code block for display: Rust without its hidden lines, formulas as math blocks."""
    head, *lines = block.splitlines()
    language = head.strip().removeprefix("```")
    if language == "math":
        return "\n".join([head.replace("```math", "```{math}"), *lines])
    if language in {"", "rust", "no_run", "ignore"} and any("use stickslip" in line or "?;" in line for line in lines):
        lines = [line for line in lines if not line.lstrip().startswith("# ") and line.strip() != "#"]
        return "\n".join([head.replace(f"```{language}", "```rust"), *lines])
    return block


def prose(folder: pathlib.Path, page: str, file: str, text: str) -> str:
    text = re.sub(r"\$`([^`]*)`\$", r"${\1}$", text)
    text = IMAGE.sub(lambda match: picture(folder, page, file, match), text)
    text = DEFINITION.sub(lambda match: f"{match['name']}: {of_crate(page, match['target'])}", text)
    text = LINK.sub(lambda match: link(page, file, match), text)
    return NAME.sub(lambda match: f"[`{match['name'].removeprefix('crate::')}`]({of_crate(page, match['name'])})", text)


def picture(folder: pathlib.Path, page: str, file: str, match: re.Match) -> str:
    """Copies a picture of the repository to the pages and returns its Markdown."""
    if (match["file"] or "").startswith(f"{up(page)}pictures/docs/"):
        return match[0]
    source = (ROOT / file).parent / (match["file"] or match["source"])
    copy = folder / "pictures" / source.name
    copy.parent.mkdir(exist_ok=True)
    copy.write_bytes(source.read_bytes())
    words = match["text"] or match["alt"]
    return f"![{words}]({up(page)}pictures/{source.name})"


def up(page: str) -> str:
    return "../" * page.count("/")


def link(page: str, file: str, match: re.Match) -> str:
    words, target = match["words"], match["target"]
    if target.startswith(("http", "#", "mailto")):
        return match[0]
    if "::" in target or target.startswith(("crate", "fn@")) or re.fullmatch(r"[A-Z]\w*|\w+\(\)", target):
        return f"[{words}]({of_crate(page, target)})"
    path, _, place = target.partition("#")
    found = os.path.normpath((ROOT / file).parent / path)
    inside = os.path.relpath(found, ROOT)
    if not os.path.exists(found):
        sys.exit(f"{file}: no {target}")
    if inside in PAGE_OF:
        return f"[{words}]({up(page)}{PAGE_OF[inside]}.md{'#' + place if place else ''})"
    return in_repository(words, inside)


def in_repository(words: str, inside: object) -> str:
    """Returns a link to a file of the repository, or only its text if the project has no address."""
    return f"[{words}]({REPOSITORY}/blob/HEAD/{inside})" if REPOSITORY else words


def of_crate(page: str, target: str) -> str:
    """Returns the target of a link between items of the crate: a page of the site, the page of a module, or a search."""
    path, _, place = re.sub(r"^(fn|mod|struct)@", "", target).removesuffix("()").partition("#")
    names = [name for name in path.split("::") if name not in {"crate", "self", "super"}]
    inside = "/".join(names)
    anchor = f"#{place}" if place else ""
    for file in (f"src/{inside}.md", f"src/{inside}/mod.rs", f"src/bodies/{inside}/mod.rs"):
        if file in PAGE_OF:
            return f"{up(page)}{PAGE_OF[file]}.md{anchor}"
    is_module = any((ROOT / "src" / (inside + end)).exists() for end in (".md", ".rs", "/mod.rs"))
    if not names or is_module:
        return f"{CRATE}/{inside}{'/' if names else ''}index.html{anchor}"
    return f"{CRATE}/index.html?search={'%3A%3A'.join(names[-2:])}"


def cells(source: str) -> list[tuple[str, str, str]]:
    """Returns heading, prose and code of each cell of an example: `# %% Heading`, then comment lines as prose, then code."""
    found = []
    for part in re.split(r"^# %% ", source, flags=re.M)[1:]:
        heading, _, rest = part.partition("\n")
        comment = re.match(r"(?:#.*\n)*", rest)[0]
        words = "\n".join(line.removeprefix("#").removeprefix(" ") for line in comment.splitlines())
        found.append((heading, words, rest[len(comment) :].strip("\n")))
    return found


def tutorial(folder: pathlib.Path, name: str) -> str:
    """Returns the page of an example, executed cell by cell. A failed assertion fails the build of the site."""
    file = ROOT / "bindings" / "python" / "examples" / f"{name}.py"
    source = file.read_text()
    title, _, _ = source.partition("\n")
    title = re.split("[:,;]", title.strip('."'))[0]
    namespace = {"__name__": "__main__"}
    pictures = folder / "tutorials" / "pictures"
    pictures.mkdir(parents=True, exist_ok=True)
    inside = file.relative_to(ROOT)
    parts = [f"# {title}\n", f"The code of this page is in {in_repository(f'`{name}.py`', inside)}.\n"]
    for heading, words, lines in cells(source):
        before, printed = set(pictures.iterdir()), io.StringIO()
        with contextlib.chdir(pictures), contextlib.redirect_stdout(printed):
            exec(compile(lines, str(file), "exec"), namespace)
        parts.append(f"## {heading}\n\n{words}\n\n```python\n{lines}\n```\n")
        if printed.getvalue():
            parts.append(f"```text\n{printed.getvalue()}```\n")
        parts += [f"![{heading}](pictures/{new.name})\n" for new in sorted(set(pictures.iterdir()) - before)]
    return "\n".join(parts)


def api() -> list[tuple[str, str]]:
    """Returns a page for each public module, and their list. Each name is on one page, of a submodule if there is one."""
    submodules = [name for _, name, _ in pkgutil.walk_packages(stickslip.__path__, "stickslip.") if "._" not in name]
    pages, documented = [], set()
    for name in [*submodules, "stickslip"]:
        module = importlib.import_module(name)
        members = set(getattr(module, "__all__", ())) or {member for member in vars(module) if member[0] != "_"}
        # Readers and writers have functions of the same name in each module.
        excluded = members & documented if name.count(".") < 2 else set()
        pages.append((name.removeprefix("stickslip."), page_of_module(name, excluded)))
        documented |= members
    names = "\n".join(name for name, _ in [pages[-1], *pages[:-1]])
    text = "`help(...)` of each name prints the same text."
    return [*pages, ("index", f"# Python reference\n\n{text}\n\n```{{toctree}}\n:maxdepth: 1\n\n{names}\n```\n")]


def page_of_module(name: str, excluded: set[str]) -> str:
    option = f"   :exclude-members: {', '.join(sorted(excluded))}\n" if excluded else ""
    return f"# {name}\n\n```{{eval-rst}}\n.. automodule:: {name}\n{option}```\n"


def c_reference() -> str:
    """Returns the functions and types of the header, each with the comment above it."""
    header = (ROOT / "bindings" / "c" / "include" / "stickslip.h").read_text()
    comment = re.match(r"/\*(.*?)\*/", header, re.S)[1]
    rules = "\n".join(line.removeprefix(" *").removeprefix(" ") for line in comment.splitlines())
    parts = [f"# C reference\n\n{said(rules.strip())}\n"]
    constants = re.findall(r"((?:^//.*\n)+)#define (STICKSLIP_\w+) (.*)\n", header, re.M)
    declarations = re.findall(r"((?:^//.*\n)+)((?:^(?!//|#|\n).*\n)+)", header, re.M)
    types = [(words, lines) for words, lines in declarations if lines.startswith("typedef")]
    functions = [(words, lines) for words, lines in declarations if not lines.startswith("typedef")]
    parts.append("## Functions\n")
    parts += [entry(words, re.search(r"\bstickslip_\w+(?=\()", lines)[0], lines) for words, lines in functions]
    parts.append("## Types\n")
    parts += [entry(words, re.findall(r"\bstickslip_\w+", lines)[-1], lines) for words, lines in types]
    parts.append("## Constants\n\n| name | value | |\n|---|---|---|")
    parts += [f"| `{name}` | {value} | {' '.join(said(words).split())} |" for words, name, value in constants]
    return "\n".join(parts) + "\n"


def entry(words: str, name: str, lines: str) -> str:
    return f"### {name}\n\n{said(words)}\n```c\n{lines}```\n"


def said(comment: str) -> str:
    """Returns the text of a comment with escaped markup characters."""
    return re.sub(r"([*_|<\[\]])", r"\\\1", re.sub(r"^// ?", "", comment, flags=re.M))
