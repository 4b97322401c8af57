"""Draws the figures of docs/lessons, whose lists lesson_lists reads."""
import csv
import functools
import glob
import io
import json
import os
import shlex
import sys
import tempfile

import matplotlib
import numpy
from drawing import chinese_plots, font, patina, save_svg
from lesson_labels import Words, bad_labels, has_chinese, read_labels
from lesson_lists import cells_of, curves_of, has_legend
from matplotlib import pyplot
from PIL import Image, ImageChops, ImageDraw

FIGURES, PICTURES, CHINESE_PICTURES = "docs/lessons/figures", "docs/lessons/pictures", "docs/lessons/zh/pictures"
GAP, LINE = 4, 17
# Letters of both fonts stand on this line, below the top of a label.
BASE = font(11).getmetrics()[0]


def lessons(name="*"):
    labels = read_labels()
    os.makedirs(CHINESE_PICTURES, exist_ok=True)
    for path in sorted(glob.glob(f"{FIGURES}/{name}.json")):
        lesson = os.path.basename(path).removesuffix(".json")
        with open(path, encoding="utf-8") as file:
            figures = json.load(file)["figures"]
        if wrong := list(bad_labels(lesson, figures, labels)):
            sys.exit("\n".join(wrong))
        made = set()
        for figure in figures:
            # Where each picture goes, and the words of its labels.
            pictures = {f"{PICTURES}/{lesson}-{figure['name']}": Words()}
            if has_chinese(figure, labels):
                pictures[f"{CHINESE_PICTURES}/{lesson}-{figure['name']}"] = Words(labels["words"])
            made |= {f"{picture}.{'svg' if 'plots' in figure else 'png'}" for picture in pictures}
            draw_figure(figure, pictures)
        for folder in PICTURES, CHINESE_PICTURES:
            for gone in set(glob.glob(f"{folder}/{lesson}-*")) - made:
                os.remove(gone)


def draw_figure(figure, pictures):
    if "render" in figure:
        [path] = pictures
        patina("render", *shlex.split(figure["render"]), "-o", f"{path}.png")
    elif "plots" in figure:
        for path, words in pictures.items():
            with matplotlib.rc_context(chinese_plots() if words else {}):
                plots(figure, path, words)
    else:
        images = rendered_tiles(figure)
        for path, words in pictures.items():
            tiles(figure, images, words).save(f"{path}.png", optimize=True)


# --- pictures in rows

def rendered(cell, size, folder):
    x, y, share = cell.get("crop", [0, 0, 1])
    path = f"{folder}/tile.png"
    width, height = (round(length / share) for length in size)
    patina("render", *shlex.split(cell["render"]), "--width", str(width), "--height", str(height), "-o", path)
    corner = round(x * width), round(y * height)
    return Image.open(path).convert("RGB").crop((*corner, corner[0] + size[0], corner[1] + size[1]))


def picture_of(cell, before, size, folder):
    if not cell:
        return Image.new("RGB", size, "white" if cell is None else "#f4f4f4")
    if "difference" in cell:
        one, other = (before[index] for index in cell["difference"])
        return ImageChops.difference(one, other).point(lambda value: min(value * cell.get("times", 1), 255))
    return rendered(cell, size, folder)


def sizes(figure):
    size = figure.get("size", 192)
    return size, figure.get("height", size)


def rendered_tiles(figure):
    """The pictures of a figure's cells in their order."""
    images = []
    with tempfile.TemporaryDirectory() as folder:
        for _, row in cells_of(figure)[1]:
            for cell in row:
                images.append(picture_of(cell, images, sizes(figure), folder))
    return images


def tiles(figure, images, words):
    size, tall = sizes(figure)
    columns, rows = cells_of(figure)
    sides = [words[label] for label, _ in rows]
    margin = 8 + max([font(11, label).getbbox(label)[2] for label in sides]) if any(sides) else 0
    count = max(len(row) for _, row in rows)
    labelled = any("label" in (cell or {}) for _, row in rows for cell in row)
    height = tall + GAP + (LINE if labelled else 0)
    sheet = Image.new("RGB", (margin + count * (size + GAP) - GAP, (LINE if columns else 0) + len(rows) * height), "white")
    pen = ImageDraw.Draw(sheet)

    def write(x, y, label):
        pen.text((x, y + BASE), label, fill="black", font=font(11, label), anchor="ls")

    for number, label in enumerate(columns):
        write(margin + number * (size + GAP), 0, words[label])
    image = iter(images)
    for index, (_, row) in enumerate(rows):
        y = (LINE if columns else 0) + index * height
        write(0, y + tall / 2 - 6, sides[index])
        for number, cell in enumerate(row):
            x = margin + number * (size + GAP)
            sheet.paste(next(image), (x, y))
            write(x, y + tall + 1, words[(cell or {}).get("label", "")])
    return sheet


# --- curves

@functools.cache
def table(arguments):
    return list(csv.DictReader(io.StringIO(patina("eval", *shlex.split(arguments)))))


def draw(axes, panel, words):
    if "scale" in panel:
        axes.set_yscale(panel["scale"])
        axes.minorticks_off()
    if "limits" in panel:
        axes.set_ylim(*panel["limits"])
    for number, curve in enumerate(curves_of(panel)):
        rows = table(curve["eval"])
        x, y = ([float(row[curve[which]]) for row in rows] for which in ("x", "y"))
        if panel.get("polar"):
            x = numpy.radians(x)
        axes.plot(x, y, curve.get("style", "-"), color=curve.get("color", f"C{number}"), label=words[curve.get("label", "")],
                  markersize=4)
    axes.set_title(words[panel.get("title", "")], loc="left", fontsize=10)
    if panel.get("polar"):
        axes.set_theta_zero_location("N")
        axes.set_theta_direction(-1)
        axes.set_thetalim(-numpy.pi / 2, numpy.pi / 2)
        axes.tick_params(labelsize=7)
    else:
        axes.set_xlabel(words[panel.get("xlabel", "")])
        axes.set_ylabel(words[panel.get("ylabel", "")])
        axes.margins(x=0.08 if "equal" in panel else 0)
        axes.tick_params(bottom=False, left=False)
        if "equal" in panel:
            axes.set_aspect("equal")


def plots(figure, path, words):
    panels = figure["plots"]
    polar = [panel.get("polar", False) for panel in panels]
    width, height = figure.get("size", [3.6 * len(panels) + 1, 3.1])
    canvas = pyplot.figure(figsize=(width, height))
    for index, panel in enumerate(panels):
        axes = canvas.add_subplot(1, len(panels), index + 1, projection="polar" if polar[index] else None)
        draw(axes, panel, words)
        if has_legend(panels, index):
            axes.legend(title=words[panel.get("legend")], loc=panel.get("legendAt", "center left"),
                        bbox_to_anchor=panel.get("legendPlace", [1.02, 0.5]), fontsize=8)
    canvas.tight_layout()
    save_svg(canvas, f"{path}.svg", numbered=True)
