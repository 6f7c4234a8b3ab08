#!/usr/bin/env python3
"""Writes tests/crate_items.txt, the public items of the crate and the methods of its types as listed by rustdoc. Run
`cargo doc --no-deps -p stickslip --features dense,x3p` first. With --check, the script fails if the list has changed."""

import html.parser
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
LIST = HERE / "tests" / "crate_items.txt"


class Items(html.parser.HTMLParser):
    """Collects the texts of the links to items, each with its kind and its page."""

    def __init__(self) -> None:
        super().__init__()
        self.items: list[tuple[str, str, str]] = []
        self._link: tuple[str, str] | None = None

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        page = dict(attributes).get("href") or ""
        kind = pathlib.PurePath(page).name.split(".")[0]
        is_item = tag == "a" and kind in {"struct", "enum", "trait", "fn", "type"}
        self._link = (kind, page) if is_item else None

    def handle_data(self, data: str) -> None:
        if self._link:
            kind, page = self._link
            self.items.append((kind, data, page))
            self._link = None


class Methods(html.parser.HTMLParser):
    """Collects the names of the inherent methods of a type, without methods of traits."""

    def __init__(self) -> None:
        super().__init__()
        self.names: set[str] = set()
        self._is_own = False

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        place = dict(attributes).get("id") or ""
        if place.endswith("implementations-list"):
            self._is_own = place == "implementations-list"
        if self._is_own and tag == "section" and place.startswith("method."):
            self.names.add(place.removeprefix("method.").split("-")[0])


def methods(page: pathlib.Path) -> set[str]:
    parser = Methods()
    parser.feed(page.read_text())
    return parser.names


def main() -> None:
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", HERE.parent.parent / "target"))
    pages = target / "doc" / "stickslip"
    parser = Items()
    parser.feed((pages / "all.html").read_text())
    items = [f"{kind} {name}" for kind, name, _ in parser.items]
    for kind, name, page in parser.items:
        if kind in {"struct", "enum"}:
            items += [f"method {name}::{method}" for method in methods(pages / page)]
    text = "".join(f"{item}\n" for item in sorted(items))
    if "--check" not in sys.argv:
        LIST.write_text(text)
    elif LIST.read_text() != text:
        sys.exit("the public items of the crate have changed: run crate_items.py, and see what Python reaches")


if __name__ == "__main__":
    main()
