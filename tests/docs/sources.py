#!/usr/bin/env python3
"""docs/sources.md keeps its word: each item, error and option has one row, which leads somewhere, and every link is good.

The pages of nodes and models are generated: a link to one is good if the library has the node or model.

    sources.py ROOT PATINA      ROOT: the repository; PATINA: the command, which knows the nodes of the library
"""

import pathlib
import re
import subprocess
import sys

ITEMS = [str(number) for number in range(1, 172)]
ERRORS = [f"E{number}" for number in range(1, 80)]
OPTIONS = [f"O{number}" for number in range(1, 30)]


def anchors(page):
    """The headings of a page as a link names them."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def bad_links(page, nodes, models):
    for target in re.findall(r"\]\(([^)]*)\)", page.read_text(encoding="utf-8")):
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        node, model = re.fullmatch(r"nodes/(\w+)\.md", name), re.fullmatch(r"models/([\w-]+)\.md", name)
        if node and node.group(1) not in nodes:
            yield f"{target}: the library has no such node"
        elif model and model.group(1) not in models:
            yield f"{target}: the library has no such lighting model"
        elif not node and not model and not path.exists():
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
    root, patina = pathlib.Path(sys.argv[1]), sys.argv[2]
    page = root / "docs" / "sources.md"
    listed = subprocess.run([patina, "nodes"], check=True, capture_output=True, encoding="utf-8").stdout
    nodes = set(re.findall(r"^  (\w+)", listed, re.MULTILINE))
    models = {path.name.partition(".")[0] for path in root.glob("nodes/models/*.lighting.json")}
    wrong = [*bad_rows(page), *bad_links(page, nodes, models)]
    print("\n".join(wrong) or f"{len(ITEMS)} items, {len(ERRORS)} errors, {len(OPTIONS)} options, {len(nodes)} nodes in the library: all is well")
    sys.exit(1 if wrong or not nodes else 0)


if __name__ == "__main__":
    main()
