#!/usr/bin/env python3
"""A page in Chinese says what the English page says: the same headings, commands, pictures, formulas, tables and links.

    languages.py ROOT       ROOT: the repository

README.md and README.zh.md are such a pair, and docs/lessons/NAME.md and docs/lessons/zh/NAME.md.
"""

import itertools
import pathlib
import re
import sys

from sources import anchors


def pairs(root):
    yield root / "README.md", root / "README.zh.md"
    names = {page.name for folder in ("lessons", "lessons/zh") for page in (root / "docs" / folder).glob("*.md")}
    for name in sorted(names):
        yield root / "docs" / "lessons" / name, root / "docs" / "lessons" / "zh" / name


def without_comments(language, line):
    """The commands of a block, whose comments are in the language of the page. A `#` within a word starts no comment."""
    return re.sub(r"\s+# .*", "", line) if language == "sh" else line


def code(text):
    """The text without its blocks of code and without code between backticks, and the lines of the blocks."""
    lines = []

    def block(found):
        lines.extend([found.group(1), *(without_comments(found.group(1), line) for line in found.group(2).splitlines())])
        return ""

    text = re.sub(r"^```(\w*)\n(.*?)^```$", block, text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"`[^`\n]*`", "", text), lines


def targets(root, page, text):
    """Where the links and pictures of a page lead: a page of lessons by its name, in whatever language."""
    for bang, target in re.findall(r"(!?)\[[^\]]*\]\(([^)\s]*)\)", text.replace("\\|", "")):
        if "://" in target:
            yield bang, target, None
            continue
        name, _, anchor = target.partition("#")
        yield bang, (page.parent / name).resolve() if name else page.resolve(), anchor


def canonical(root, path):
    if isinstance(path, str):
        return path
    name = path.relative_to(root).as_posix() if path.is_relative_to(root) else path.as_posix()
    return name.replace("README.zh.md", "README.md").replace("docs/lessons/zh/", "docs/lessons/")


def parts(root, page):
    """What both pages must have, by the word for it."""
    text, lines = code(page.read_text(encoding="utf-8"))
    found = list(targets(root, page, text))
    return {
        "headings": [len(marks) for marks in re.findall(r"^(#+) ", text, re.MULTILINE)],
        "lines of code": lines,
        "pictures": [canonical(root, path) for bang, path, _ in found if bang],
        # Words move within a sentence, and so do its links.
        "links": sorted({canonical(root, path) for bang, path, _ in found if not bang} - {canonical(root, page)}
                        - {canonical(root, other) for pair in pairs(root) for other in pair if page in pair}),
        "formulas": [re.sub(r"\s|\\text\{[^}]*\}", "", formula) for formula in re.findall(r"\$\$(.*?)\$\$", text, re.DOTALL)],
        "rows of tables": [line.count("|") for line in text.splitlines() if line.startswith("|")],
    }


def bad_links(root, page):
    text, _ = code(page.read_text(encoding="utf-8"))
    for _, path, anchor in targets(root, page, text):
        if isinstance(path, str):
            continue
        if not path.exists():
            yield f"{page.relative_to(root)}: there is no file {path}"
        elif anchor and path.suffix == ".md" and anchor not in anchors(path):
            yield f"{page.relative_to(root)}: {path.name} has no heading #{anchor}"


def differences(root, english, chinese):
    missing = [page for page in (english, chinese) if not page.exists()]
    if missing:
        yield f"there is no {missing[0].relative_to(root)}"
        return
    one, other = parts(root, english), parts(root, chinese)
    for word in one:
        for first, second in itertools.zip_longest(one[word], other[word]):
            if first != second:
                yield f"{chinese.relative_to(root)}: the {word} differ: {first!r} in English, {second!r} in Chinese"
                break
    yield from bad_links(root, english)
    yield from bad_links(root, chinese)


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found = list(pairs(root))
    wrong = [line for english, chinese in found for line in differences(root, english, chinese)]
    print("\n".join(wrong) or f"{len(found)} pages in two languages: all is well")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
