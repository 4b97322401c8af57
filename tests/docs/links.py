#!/usr/bin/env python3
"""Every link in every page of the repository leads somewhere, and every page is near.

    links.py ROOT       ROOT: the repository

A relative link leads to a file or a folder, and its #anchor to a heading as GitHub names it. Each page below docs/ is at most
two clicks from README.md; a page in Chinese, from README.zh.md.
"""

import collections
import os
import pathlib
import re
import sys
import urllib.parse

# What builds and package managers make (.gitignore): in the root, and anywhere.
MADE_IN_ROOT = re.compile(r"build.*|out")
MADE = re.compile(r"\..*|node_modules")
CLICKS = 2


def pages(root):
    for folder, folders, files in os.walk(root):
        is_root = pathlib.Path(folder) == root
        folders[:] = sorted(name for name in folders
                            if not MADE.fullmatch(name) and not (is_root and MADE_IN_ROOT.fullmatch(name)))
        yield from (pathlib.Path(folder) / name for name in sorted(files) if name.endswith(".md"))


def without_blocks(text):
    """The lines outside of blocks of code; a line of a block is empty."""
    fence = None
    for line in text.splitlines():
        found = re.match(r"\s*(```+|~~~+)", line)
        if fence is None and found:
            fence = found.group(1)
            yield ""
        elif fence is not None:
            if found and found.group(1).startswith(fence) and line.strip() == found.group(1):
                fence = None
            yield ""
        else:
            yield line


def anchor_of(heading):
    """A heading's anchor: its text in lower case, without punctuation, with a hyphen for each space."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).lower()
    return re.sub(r"[^\w\- ]", "", text).replace(" ", "-")


def anchors_of(text):
    found = set()
    count = collections.Counter()
    for line in without_blocks(text):
        heading = re.match(r"#{1,6} +(.*?)(?: +#+)?$", line)
        if heading:
            anchor = anchor_of(heading.group(1))
            found.add(f"{anchor}-{count[anchor]}" if count[anchor] else anchor)
            count[anchor] += 1
        found.update(re.findall(r"<\w+[^>]*\b(?:id|name)=\"([^\"]+)\"", line))
    return found


def targets_of(text):
    """The targets of the links and pictures of a page, each with its line."""
    for number, line in enumerate(without_blocks(text), 1):
        line = re.sub(r"(`+)(?:(?!\1).)+\1", "code", line)
        targets = re.findall(r"\]\(\s*<?([^)\s>]*)[^)]*\)", line)
        targets += re.findall(r"<(?:a|img)\b[^>]*\b(?:href|src)=\"([^\"]*)\"", line)
        targets += re.findall(r"^\[[^\]]+\]: *(\S+)", line)
        yield from ((number, target) for target in targets)


def bad_links(root, texts):
    anchors = {page: anchors_of(text) for page, text in texts.items()}
    for page, text in texts.items():
        for number, target in targets_of(text):
            if re.match(r"[a-z]+:", target):
                continue
            where = f"{page.relative_to(root)}:{number}: {target!r}"
            name, _, anchor = target.partition("#")
            path = resolved(page, name)
            if not target or not path.exists():
                yield f"{where}: there is no such file"
            elif anchor and anchor not in anchors.get(path, ()):
                yield f"{where}: the page has no such heading"


def resolved(page, name):
    return pathlib.Path(os.path.normpath(page.parent / urllib.parse.unquote(name))) if name else page


def reached(texts, start):
    """How many clicks each page is from the first one."""
    clicks = {start: 0}
    waiting = collections.deque([start])
    while waiting:
        page = waiting.popleft()
        for _, target in targets_of(texts[page]):
            path = resolved(page, target.partition("#")[0])
            if path in texts and path not in clicks:
                clicks[path] = clicks[page] + 1
                waiting.append(path)
    return clicks


def far_pages(root, texts):
    chinese = root / "docs/lessons/zh"
    clicks = {name: reached(texts, root / name) for name in ("README.md", "README.zh.md")}
    for page in texts:
        if root / "docs" not in page.parents:
            continue
        start = "README.zh.md" if chinese in page.parents else "README.md"
        count = clicks[start].get(page)
        if count is None:
            yield f"{page.relative_to(root)}: no link leads to it from {start}"
        elif count > CLICKS:
            yield f"{page.relative_to(root)}: it is {count} clicks from {start}, more than {CLICKS}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    texts = {page: page.read_text(encoding="utf-8") for page in pages(root)}
    wrong = [*bad_links(root, texts), *far_pages(root, texts)]
    count = sum(1 for text in texts.values() for _ in targets_of(text))
    print("\n".join(wrong) or f"{len(texts)} pages, {count} links: all is well")
    sys.exit(1 if wrong or count < 1000 else 0)


if __name__ == "__main__":
    main()
