#!/usr/bin/env python3
"""Fails if a page of a folder links to a page, picture or anchor in the folder that does not exist. Does not check links to
other sites.
links.py FOLDER"""

import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """The links of a page and its anchors."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.places: set[str] = {"", "top"}
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name in {"href", "src"} and value:
                self.links.append(value)
            elif name in {"id", "name"} and value:
                self.places.add(value)


def main() -> None:
    folder = pathlib.Path(sys.argv[1]).resolve()
    pages = {file: Page(file.read_text()) for file in folder.rglob("*.html")}
    dead, tried = [], 0
    for file, page in pages.items():
        for link in page.links:
            address = urllib.parse.urlsplit(link)
            if address.scheme or address.netloc:
                continue
            tried += 1
            target = (file.parent / urllib.parse.unquote(address.path)).resolve() if address.path else file
            target = target / "index.html" if target.is_dir() else target
            place = urllib.parse.unquote(address.fragment)
            if not target.exists() or target in pages and place not in pages[target].places:
                dead.append(f"{file.relative_to(folder)}: {link}")
    print(f"{len(pages)} pages, {tried} links within them, {len(dead)} dead", *dead, sep="\n")
    # A folder without links is not a site: Sphinx wrote no output, or wrote it to a different folder.
    sys.exit(bool(dead) or not tried)


if __name__ == "__main__":
    main()
