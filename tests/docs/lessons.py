#!/usr/bin/env python3
"""The lessons keep their word: each figure is shown, each graph checks and is linked, each printed command runs.

    lessons.py ROOT PATINA [figures]      ROOT: the repository; PATINA: the command

With "figures", it runs what the figures are made by instead, in pictures of a few pixels.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

LIMIT = 6 * 1024 * 1024


def files_of(figures):
    """The graphs, scenes and lighting graphs that figures are made of."""
    return set(re.findall(r"[\w./-]+\.json", json.dumps(figures)))


def pictures_of(lesson, figures):
    return [f"{lesson}-{figure['name']}.{'svg' if 'plots' in figure else 'png'}" for figure in figures]


def bad_figures(root, lesson, figures, text):
    shown = re.findall(r"!\[[^\]]*\]\(pictures/([^)]*)\)", text)
    made = pictures_of(lesson, figures)
    for name in set(shown) ^ set(made):
        yield f"{lesson}: {name} is {'not shown' if name in made else 'no figure of docs/lessons/figures'}"
    for name in made:
        if not (root / "docs/lessons/pictures" / name).exists():
            yield f"{lesson}: run scripts/pictures lessons:{lesson}, which makes {name}"
    for name in files_of(figures):
        link = os.path.relpath(root / name, root / "docs/lessons")
        if f"]({link})" not in text:
            yield f"{lesson}: the page does not link {name}, of which a figure is made"


def bad_folder(root, figures):
    folder = root / "docs/lessons"
    made = {name for lesson in figures for name in pictures_of(lesson, figures[lesson])}
    for path in (folder / "pictures").iterdir():
        if path.name not in made:
            yield f"docs/lessons/pictures/{path.name} is no figure"
    size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
    if size > LIMIT:
        yield f"docs/lessons has {size} bytes: at most {LIMIT} are allowed"


def bad_graphs(root, patina, used):
    graphs = sorted(path for path in (root / "docs/lessons/graphs").rglob("*.json"))
    for graph in graphs:
        # A figure's scene names its materials, and a material its lighting graph.
        others = [other.read_text(encoding="utf-8") for other in graph.parent.glob("*.json") if other != graph]
        if graph.relative_to(root).as_posix() not in used and not any(f"{graph.name}\"" in text for text in others):
            yield f"{graph.relative_to(root)} makes no figure"
    checked = [str(path) for path in graphs if path.name.endswith((".graph.json", ".scene.json", ".lighting.json"))]
    ran = subprocess.run([patina, "check", *checked], capture_output=True, encoding="utf-8")
    if ran.returncode != 0 or "warning" in ran.stderr:
        yield ran.stdout + ran.stderr


def bad_coefficients(root, patina):
    """The lesson about spherical harmonics prints what its picture gives, and its graph has the same numbers."""
    folder = root / "docs/lessons"
    ran = subprocess.run([patina, "env", "--json", str(folder / "graphs/harmonics/sky.exr")], capture_output=True, encoding="utf-8")
    if ran.returncode != 0:
        yield ran.stderr
        return
    words = [[f"{number:.3f}" for number in row] for row in json.loads(ran.stdout)["coefficients"]]
    for name in "harmonics.md", "graphs/harmonics/sum.graph.json":
        numbers = re.findall(r"-?\d\.\d{3}\b", (folder / name).read_text(encoding="utf-8"))
        if numbers != [word for row in words for word in row]:
            yield f"{name} has other coefficients than sky.exr, whose are {words}"


def commands_of(text):
    for block in re.findall(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield from (line for line in block.splitlines() if line.startswith("build/patina "))


def figure_commands(root, figures):
    sys.path.insert(0, str(root / "scripts"))
    import lesson_lists
    for lesson, listed in figures.items():
        for command in dict.fromkeys(command for figure in listed for command in lesson_lists.commands_of(figure)):
            small = " --size 8 --samples 1 -o x.png" if command.startswith("render") else ""
            yield lesson, f"build/patina {re.sub(r' --(size|samples) [0-9]+', '', command) if small else command}{small}"


def bad_commands(root, patina, commands):
    with tempfile.TemporaryDirectory() as work:
        for name, target in ("build", pathlib.Path(patina).resolve().parent), ("docs", root / "docs"), ("examples", root / "examples"):
            os.symlink(target, f"{work}/{name}")
        for lesson, command in commands:
            ran = subprocess.run(["bash", "-c", command], cwd=work, capture_output=True, encoding="utf-8")
            if ran.returncode != 0:
                yield f"{lesson}: {command}\n{ran.stdout}{ran.stderr}"


def main():
    root, patina = pathlib.Path(sys.argv[1]).resolve(), os.path.abspath(sys.argv[2])
    folder = root / "docs/lessons"
    pages = {path.stem: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.md"))}
    figures = {path.stem: json.loads(path.read_text(encoding="utf-8"))["figures"] for path in sorted((folder / "figures").glob("*.json"))}
    wrong = []
    if sys.argv[3:] == ["figures"]:
        commands = list(figure_commands(root, figures))
    else:
        commands = [(name, command) for name, text in pages.items() for command in commands_of(text)]
        wrong += [f"docs/lessons/figures/{name}.json has no page" for name in figures.keys() - pages.keys()]
        for name, text in pages.items():
            wrong += bad_figures(root, name, figures.get(name, []), text)
        wrong += bad_folder(root, figures)
        wrong += bad_graphs(root, patina, set().union(*map(files_of, figures.values())))
        wrong += bad_coefficients(root, patina)
    wrong += bad_commands(root, patina, commands)
    print("\n".join(wrong) or f"{len(figures)} lessons, {sum(map(len, figures.values()))} figures, {len(commands)} commands: all is well")
    sys.exit(1 if wrong or len(commands) < 20 else 0)


if __name__ == "__main__":
    main()
