#!/usr/bin/env python3
"""scripts/reference says what is out of date, writes it, and removes what is superfluous; what it writes has no bad links.

    reference_test.py ROOT PATINA      ROOT: the repository; PATINA: the command, which knows the library
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from sources import anchors


def copied(root, folder):
    """What the script needs, in a folder of the test's own."""
    for name in "scripts", "docs/nodes", "docs/models", "nodes":
        shutil.copytree(root / name, folder / name)
    shutil.copy(root / "docs/conventions.md", folder / "docs/conventions.md")


def run(folder, patina, *arguments):
    ran = subprocess.run([sys.executable, "-B", folder / "scripts/reference", *arguments, patina], capture_output=True, encoding="utf-8")
    return ran.returncode, ran.stdout + ran.stderr


def expect(condition, what, text=""):
    if not condition:
        sys.exit(f"{what}\n{text[-3000:]}")


def check_changes(folder, patina):
    """A page that differs, one that is missing and one that is superfluous are shown, then put right."""
    expect(run(folder, patina)[0] == 0, "scripts/reference fails")
    changed, missing, gone = folder / "docs/nodes/fresnel.md", folder / "docs/models/unity.md", folder / "docs/nodes/Gone.md"
    before = changed.read_text(encoding="utf-8")
    changed.write_text(before.replace("# Fresnel", "# Changed"), encoding="utf-8")
    missing.unlink()
    gone.write_text(before.splitlines()[0] + "\n", encoding="utf-8")
    mine = folder / "docs/nodes/mine.md"
    mine.write_text("mine\n", encoding="utf-8")
    code, text = run(folder, patina, "--check")
    expect(code == 1, "--check finds nothing", text)
    for words in "-# Changed", "+# Fresnel", "--- /dev/null\n+++ docs/models/unity.md", "--- docs/nodes/Gone.md\n+++ /dev/null":
        expect(words in text, f"--check does not show '{words}'", text)
    expect("mine" not in text and "# Changed" in changed.read_text(encoding="utf-8"), "--check wrote or complains too much", text)
    run(folder, patina)
    code, text = run(folder, patina, "--check")
    expect(code == 0 and not text, "what was written is out of date", text)
    expect(not gone.exists() and mine.exists(), "the wrong files were removed")
    mine.unlink()


def check_errors(folder, patina):
    page = folder / "docs/conventions.md"
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace("<!-- generated: semantics -->", ""), encoding="utf-8")
    code, said = run(folder, patina, "--check")
    expect(code == 1 and "must have the lines '<!-- generated: semantics -->'" in said, "a marker is missing", said)
    page.write_text(text, encoding="utf-8")
    families = folder / "docs/nodes/families.json"
    text = families.read_text(encoding="utf-8")
    families.write_text(text.replace('"lighting/fog"', '"lighting/fgo"'), encoding="utf-8")
    code, said = run(folder, patina, "--check")
    expect(code == 1 and "0 families have the node Fog" in said, "a file without a family", said)
    families.write_text(text, encoding="utf-8")


def check_links(root, nodes):
    """Each node has an anchor of its own, and each link of the pages leads somewhere."""
    places = {}
    for page in [*(root / "docs/nodes").glob("*.md"), *(root / "docs/models").glob("*.md"), root / "docs/conventions.md"]:
        text = page.read_text(encoding="utf-8")
        places.setdefault(page.parent.name, []).extend(re.findall(r"^### (\w+)$", text, re.MULTILINE))
        heads = [head.lower() for head in re.findall(r"^#+ (.*)$", text, re.MULTILINE)]
        expect(len(heads) == len(set(heads)), f"{page}: two headings have one anchor")
        for target in re.findall(r"\]\(([^)\s]*)\)", re.sub(r"`[^`\n]*`", "", text)):
            name, _, anchor = target.partition("#")
            path = (page.parent / name).resolve() if name else page
            expect("://" in target or path.exists(), f"{page}: there is no {target}")
            expect(not anchor or anchor in anchors(path), f"{page}: {target}: the page has no such heading")
    expect(sorted(places["nodes"]) == sorted(nodes), "not every node has one chapter")


def main():
    root, patina = pathlib.Path(sys.argv[1]), sys.argv[2]
    nodes = [node["name"] for node in json.loads(subprocess.check_output([patina, "nodes", "--json"]))]
    check_links(root, nodes)
    with tempfile.TemporaryDirectory() as name:
        copied(root, pathlib.Path(name))
        check_changes(pathlib.Path(name), patina)
        check_errors(pathlib.Path(name), patina)
    print(f"{len(nodes)} nodes: all is well")


if __name__ == "__main__":
    main()
