#!/usr/bin/env python3
"""Writes tests/crate_items.txt, the public items of the crate as rustdoc lists them: run
`cargo doc --no-deps -p stickslip --features dense` first. With --check it fails if the list has changed."""

import html.parser
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
LIST = HERE / "tests" / "crate_items.txt"


class Items(html.parser.HTMLParser):
    """The texts of the links to items, each with its kind."""

    def __init__(self) -> None:
        super().__init__()
        self.items: list[str] = []
        self._kind = ""

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        name = pathlib.PurePath(dict(attributes).get("href") or "").name
        kind = name.split(".")[0]
        self._kind = kind if tag == "a" and kind in {"struct", "enum", "trait", "fn", "type"} else ""

    def handle_data(self, data: str) -> None:
        if self._kind:
            self.items.append(f"{self._kind} {data}")
            self._kind = ""


def main() -> None:
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", HERE.parent.parent / "target"))
    parser = Items()
    parser.feed((target / "doc" / "stickslip" / "all.html").read_text())
    text = "".join(f"{item}\n" for item in sorted(parser.items))
    if "--check" not in sys.argv:
        LIST.write_text(text)
    elif LIST.read_text() != text:
        sys.exit("the public items of the crate have changed: run crate_items.py, and see what Python reaches")


if __name__ == "__main__":
    main()
