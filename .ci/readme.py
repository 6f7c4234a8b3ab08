#!/usr/bin/env python3
"""Looks for dead relative links and pictures in the READMEs, which registries show. With a folder: writes the example of the
crate's README there as src/main.rs."""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r'\]\(([^)\s]+)\)|(?:src|href)="([^"]+)"')


def dead(readme: pathlib.Path, tracked: set[str]) -> list[str]:
    """Links and pictures that are no file or folder of the repository. On PyPI, which knows no repository, all that are
    relative."""
    text = re.sub(r"^```.*?^```$", "", readme.read_text(), flags=re.M | re.S)
    links = [(first or second).split("#")[0] for first, second in LINK.findall(text)]
    relative = [link for link in links if link and not link.startswith(("http:", "https:", "mailto:"))]
    if readme.parent.name == "python":
        return relative
    places = {link: (readme.parent / link).resolve().relative_to(ROOT).as_posix() for link in relative}
    return [link for link, place in places.items() if not any(f"{file}/".startswith(f"{place}/") for file in tracked)]


def main() -> None:
    if len(sys.argv) > 1:
        example = re.search(r"```rust\n(.*?)```", (ROOT / "README.md").read_text(), re.S)[1]
        pathlib.Path(sys.argv[1], "src", "main.rs").write_text(example)
        return
    listed = subprocess.run(["git", "ls-files"], cwd=ROOT, check=True, capture_output=True, text=True).stdout
    tracked = set(listed.splitlines())
    found = {file: dead(ROOT / file, tracked) for file in sorted(tracked) if file.endswith("README.md")}
    for file, links in found.items():
        print(f"{file}: {', '.join(links) or 'ok'}")
    sys.exit(any(found.values()))


if __name__ == "__main__":
    main()
