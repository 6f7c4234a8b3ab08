#!/usr/bin/env python3
"""Fails on a dead relative link or picture in a README, on a dead path of the repository in a document or a comment, and
on a large file.
With a folder as argument, writes the example of the crate's README to src/main.rs in this folder."""

import fnmatch
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r'\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"')
FENCE = re.compile(r"^( *)```.*?^\1```", re.M | re.S)
SPAN = re.compile(r"(`+)(.+?)\1")
WORD = re.compile(r"(?<![\w./:-])[\w.*-]*[\w*-](?:/[\w.*-]*[\w*-])*/?")
# A word of a code span with such a suffix is a path, regardless of its first part.
SOURCE = (".rs", ".py", ".toml", ".md")
HASH = re.compile(r'(?:^|\s)#+[! ](?P<line>[^\n]*)|"""(?P<block>.*?)"""', re.S)
SLASHES = re.compile(r"//[/!]?(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/", re.S)
COMMENTS = {
    **dict.fromkeys((".rs", ".c", ".h", ".cpp", ".hpp"), SLASHES),
    **dict.fromkeys((".py", ".toml", ".yml", ".sh", ".csv", "CMakeLists.txt", ""), HASH),
    ".f90": re.compile(r"!(?P<line>[^\n]*)(?P<block>)"),
}
# The changelog describes earlier versions. The notices and licences are texts of other projects.
EXEMPT = ("CHANGELOG.md", "THIRD_PARTY.md", "LICENSE")
# A file in the program of the reader.
ELSEWHERE = ("src/main.rs",)
# A larger file is usually the output of a tool that was added by mistake.
LARGEST_FILE = 512 * 1024  # bytes


class Tree:
    """The tracked files of the repository and their folders."""

    def __init__(self) -> None:
        listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
        # A file that is deleted but not staged cannot be a target.
        self.files = [file for file in listed.splitlines() if (ROOT / file).exists()]
        paths = [pathlib.PurePosixPath(file) for file in self.files]
        self.places = {place.as_posix() for path in paths for place in (path, *path.parents)}
        self.names = {path.name for path in paths}

    def has(self, place: str) -> bool:
        return place in self.places or "*" in place and bool(fnmatch.filter(self.places, place))

    def has_name(self, name: str) -> bool:
        return bool(fnmatch.filter(self.names, name))

    def dead_links(self, file: str) -> list[str]:
        """Returns links and pictures that are not files or folders of the repository. For a README on PyPI, which has no
        repository, returns all relative links."""
        text = FENCE.sub("", (ROOT / file).read_text())
        links = [(first or second).split("#")[0] for first, second in LINK.findall(text)]
        relative = [link for link in links if link and not link.startswith(("http:", "https:", "mailto:"))]
        folder = (ROOT / file).parent
        if folder.name == "python":
            return relative
        return [link for link in relative if not self.has((folder / link).resolve().relative_to(ROOT).as_posix())]

    def dead_paths(self, file: str) -> list[str]:
        """Returns words that look like paths but do not exist below the root, src/, the folder of the file or its parents."""
        folders = {parent.as_posix() for parent in pathlib.PurePosixPath(file).parents} | {"src"}
        starts = [f"{folder}/" if folder != "." else "" for folder in folders]
        dead = []
        for word, is_span in words(file, (ROOT / file).read_text()):
            first, _, rest = word.partition("/")
            if word in ELSEWHERE or first == "target" or ".." in word:
                continue
            if not rest:
                is_dead = is_span and word.endswith((".rs", ".py")) and not self.has_name(word)
            else:
                near = starts if is_span else [""]
                is_path = is_span and word.endswith(SOURCE) or any(f"{start}{first}" in self.places for start in near)
                is_dead = is_path and not any(self.has(start + word.rstrip("/")) for start in starts)
            if is_dead:
                dead.append(word)
        return dead


def kind(file: str) -> str:
    path = pathlib.PurePosixPath(file)
    return path.name if path.name in COMMENTS else path.suffix


def words(file: str, text: str) -> list[tuple[str, bool]]:
    """Returns words that might be paths and whether each is in a code span. Of a document it reads only the code spans."""
    if kind(file) == ".md":
        text = FENCE.sub("", text)
    else:
        found = COMMENTS[kind(file)].finditer(text)
        text = "\n".join(comment["line"] or comment["block"] or "" for comment in found)
    spans = " ".join(span for _, span in SPAN.findall(text))
    rest = "" if kind(file) == ".md" else SPAN.sub(" ", text)
    return [(word, True) for word in WORD.findall(spans)] + [(word, False) for word in WORD.findall(rest)]


def main() -> None:
    if len(sys.argv) > 1:
        example = re.search(r"```rust\n(.*?)```", (ROOT / "README.md").read_text(), re.S)[1]
        pathlib.Path(sys.argv[1], "src", "main.rs").write_text(example)
        return
    tree = Tree()
    read = [file for file in tree.files if kind(file) in {".md", *COMMENTS}]
    found = [(file, "link", link) for file in read if file.endswith("README.md") for link in tree.dead_links(file)]
    for file in read:
        if not any(part in file for part in EXEMPT) and not (ROOT / file).is_symlink():
            found += [(file, "path", path) for path in tree.dead_paths(file)]
    for file, what, target in found:
        print(f"{file}: dead {what} {target}")
    print(f"links and paths of {len(read)} files: {len(found)} dead")
    large = [file for file in tree.files if (ROOT / file).stat().st_size > LARGEST_FILE]
    for file in large:
        print(f"{file}: larger than {LARGEST_FILE} bytes")
    sys.exit(bool(found or large))


if __name__ == "__main__":
    main()
