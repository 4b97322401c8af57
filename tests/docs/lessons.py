#!/usr/bin/env python3
"""The lessons keep their word: each figure is shown, in Chinese on a Chinese page, each graph checks and is linked, and
each printed command runs.

    lessons.py ROOT PATINA [figures]      ROOT: the repository; PATINA: the command

With "figures", it runs what the figures are made by instead, in pictures of a few pixels.
"""

import html
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(ROOT / "scripts"))
sys.dont_write_bytecode = True
from lesson_labels import Words, bad_labels, english_in, has_chinese, labels_of, read_labels
from lesson_lists import commands_of as commands_of_figure

LIMIT = 6 * 1024 * 1024


def files_of(figures):
    """The graphs, scenes and lighting graphs that figures are made of."""
    return set(re.findall(r"[\w./-]+\.json", json.dumps(figures)))


def pictures_of(lesson, figures):
    """The file of each figure."""
    return {f"{lesson}-{figure['name']}.{'svg' if 'plots' in figure else 'png'}": figure for figure in figures}


def bad_figures(root, lesson, figures, text):
    yield from bad_pictures(root / "docs/lessons", lesson, text, [f"pictures/{name}" for name in pictures_of(lesson, figures)])
    for name in files_of(figures):
        link = os.path.relpath(root / name, root / "docs/lessons")
        if f"]({link})" not in text:
            yield f"{lesson}: the page does not link {name}, of which a figure is made"


def bad_chinese_figures(root, lesson, figures, text, labels):
    """A Chinese page shows a picture with Chinese labels, or the English page's one, which has no words."""
    made = [f"pictures/{name}" if has_chinese(figure, labels) else f"../pictures/{name}"
            for name, figure in pictures_of(lesson, figures).items()]
    yield from bad_pictures(root / "docs/lessons/zh", f"zh/{lesson}", text, made)


def bad_pictures(folder, page, text, made):
    shown = re.findall(r"!\[[^\]]*\]\(([^)]*)\)", text)
    for path in sorted(set(shown) ^ set(made)):
        yield f"{page}: {path} is {'not shown' if path in made else 'no picture that this page should show'}"
    for path in made:
        if not (folder / path).exists():
            yield f"{page}: run scripts/pictures lessons, which makes {path}"


def bad_words(root, figures, labels):
    """Each label has its Chinese, which is of use; and a plot, whose file has its labels, is not older than they are."""
    used = set()
    for lesson, listed in figures.items():
        yield from bad_labels(lesson, listed, labels)
        for name, figure in pictures_of(lesson, listed).items():
            used.update(labels_of(figure))
            pictures = {f"pictures/{name}": Words()}
            if has_chinese(figure, labels):
                pictures[f"zh/pictures/{name}"] = Words(labels["words"])
            for path, words in pictures.items():
                yield from bad_plot(root / "docs/lessons" / path, [words[label] for label in labels_of(figure)])
    for label in labels["words"].keys() - used:
        yield f"docs/lessons/zh/labels.json: no figure has the label '{label}'"
    written = english_in(" ".join([*used, *labels["words"].values()]), {"names": []})
    for name in set(labels["names"]) - set(written):
        yield f"docs/lessons/zh/labels.json: no label has the name '{name}'"


def bad_plot(path, labels):
    if path.suffix != ".svg" or not path.exists():
        return
    # Letters that are drawn as curves have their text in a comment.
    drawn = {html.unescape(one or other) for one, other
             in re.findall(r">([^<>]+)</text>|<!-- (.*?) -->", path.read_text(encoding="utf-8"))}
    for label in labels:
        if label not in drawn:
            yield f"{path.name}: run scripts/pictures lessons, for '{label}' is not in it"


def bad_folders(root, figures, labels):
    made = {name: figure for lesson in figures for name, figure in pictures_of(lesson, figures[lesson]).items()}
    for path in (root / "docs/lessons/pictures").iterdir():
        if path.name not in made:
            yield f"docs/lessons/pictures/{path.name} is no figure"
    for path in (root / "docs/lessons/zh/pictures").iterdir():
        if path.name not in made or not has_chinese(made[path.name], labels):
            yield f"docs/lessons/zh/pictures/{path.name} is no figure with words"
    size = sum(path.stat().st_size for path in (root / "docs/lessons").rglob("*") if path.is_file())
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


def figure_commands(figures):
    for lesson, listed in figures.items():
        for command in dict.fromkeys(command for figure in listed for command in commands_of_figure(figure)):
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
    root, patina = ROOT, os.path.abspath(sys.argv[2])
    folder = root / "docs/lessons"
    pages = {path.stem: path.read_text(encoding="utf-8") for path in sorted(folder.glob("*.md"))}
    figures = {path.stem: json.loads(path.read_text(encoding="utf-8"))["figures"] for path in sorted((folder / "figures").glob("*.json"))}
    wrong = []
    if sys.argv[3:] == ["figures"]:
        commands = list(figure_commands(figures))
    else:
        commands = [(name, command) for name, text in pages.items() for command in commands_of(text)]
        wrong += [f"docs/lessons/figures/{name}.json has no page" for name in figures.keys() - pages.keys()]
        for name, text in pages.items():
            wrong += bad_figures(root, name, figures.get(name, []), text)
        labels = read_labels(root)
        for path in sorted((folder / "zh").glob("*.md")):
            text = path.read_text(encoding="utf-8")
            wrong += bad_chinese_figures(root, path.stem, figures.get(path.stem, []), text, labels)
        wrong += bad_words(root, figures, labels)
        wrong += bad_folders(root, figures, labels)
        wrong += bad_graphs(root, patina, set().union(*map(files_of, figures.values())))
        wrong += bad_coefficients(root, patina)
    wrong += bad_commands(root, patina, commands)
    print("\n".join(wrong) or f"{len(figures)} lessons, {sum(map(len, figures.values()))} figures, {len(commands)} commands: all is well")
    sys.exit(1 if wrong or len(commands) < 20 else 0)


if __name__ == "__main__":
    main()
