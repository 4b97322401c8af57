#!/usr/bin/env python3
"""docs/sources.md keeps its word: each item, error and option has one row, which leads somewhere, and every link is good.

    sources.py ROOT      ROOT: the repository
"""

import pathlib
import re
import sys

ITEMS = [str(number) for number in range(1, 172)]
ERRORS = [f"E{number}" for number in range(1, 80)]
OPTIONS = [f"O{number}" for number in range(1, 30)]


def anchors(page):
    """The headings of a page as a link names them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def bad_links(page):
    for target in re.findall(r"\]\(([^)]*)\)", page.read_text(encoding="utf-8")):
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        if not path.exists():
            yield f"{target}: there is no such file"
        elif anchor and anchor not in anchors(path):
            yield f"{target}: the page has no such heading"


def bad_rows(page):
    rows = {}
    text = page.read_text(encoding="utf-8")
    for said in f"They name {len(ITEMS)} things", f"{len(OPTIONS)} options":
        if said not in text:
            yield f"the page does not say '{said}'"
    for line in text.splitlines():
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if cells and re.fullmatch(r"[EO]?\d+", cells[0]):
            rows.setdefault(cells[0], []).append(cells[1:])
    for key in ITEMS + ERRORS + OPTIONS:
        if len(rows.get(key, [])) != 1:
            yield f"row {key}: there are {len(rows.get(key, []))} of it"
    for key in rows.keys() - set(ITEMS + ERRORS + OPTIONS):
        yield f"row {key}: there is no such item"
    for key, found in rows.items():
        for cells in found:
            if not all(cells) or len(cells) != (3 if key.startswith("E") else 2):
                yield f"row {key}: a cell is missing or empty"
            elif not re.search(r"\]\(|(differs?|not planned)[^|:]*: ", cells[-1]):
                yield f"row {key}: leads nowhere: {cells[-1]}"


def main():
    page = pathlib.Path(sys.argv[1]) / "docs" / "sources.md"
    wrong = [*bad_rows(page), *bad_links(page)]
    print("\n".join(wrong) or f"{len(ITEMS)} items, {len(ERRORS)} errors, {len(OPTIONS)} options: all is well")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
