"""Draws the figures of docs/lessons, whose lists lesson_lists reads."""
import csv
import glob
import io
import json
import os
import shlex
import tempfile

import numpy
from drawing import font, patina, save_svg
from lesson_lists import cells_of, curves_of
from matplotlib import pyplot
from PIL import Image, ImageChops, ImageDraw

FIGURES, PICTURES = "docs/lessons/figures", "docs/lessons/pictures"
GAP, LINE = 4, 17


def lessons(name="*"):
    for path in sorted(glob.glob(f"{FIGURES}/{name}.json")):
        lesson = os.path.basename(path).removesuffix(".json")
        with open(path, encoding="utf-8") as file:
            figures = json.load(file)["figures"]
        made = set()
        for figure in figures:
            made.add(f"{PICTURES}/{lesson}-{figure['name']}.{'svg' if 'plots' in figure else 'png'}")
            draw_figure(figure, f"{PICTURES}/{lesson}-{figure['name']}")
        for gone in set(glob.glob(f"{PICTURES}/{lesson}-*")) - made:
            os.remove(gone)


def draw_figure(figure, path):
    if "render" in figure:
        patina("render", *shlex.split(figure["render"]), "-o", f"{path}.png")
    elif "plots" in figure:
        plots(figure, path)
    else:
        tiles(figure, path)


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


def tiles(figure, path):
    size = figure.get("size", 192)
    tall = figure.get("height", size)
    columns, rows = cells_of(figure)
    margin = 8 + max([font(11).getbbox(label)[2] for label, _ in rows]) if any(label for label, _ in rows) else 0
    count = max(len(row) for _, row in rows)
    labelled = any("label" in (cell or {}) for _, row in rows for cell in row)
    height = tall + GAP + (LINE if labelled else 0)
    sheet = Image.new("RGB", (margin + count * (size + GAP) - GAP, (LINE if columns else 0) + len(rows) * height), "white")
    pen = ImageDraw.Draw(sheet)
    for number, label in enumerate(columns):
        pen.text((margin + number * (size + GAP), 0), label, fill="black", font=font(11))
    before = []
    with tempfile.TemporaryDirectory() as folder:
        for index, (label, row) in enumerate(rows):
            y = (LINE if columns else 0) + index * height
            pen.text((0, y + tall / 2 - 6), label, fill="black", font=font(11))
            for number, cell in enumerate(row):
                before.append(picture_of(cell, before, (size, tall), folder))
                x = margin + number * (size + GAP)
                sheet.paste(before[-1], (x, y))
                pen.text((x, y + tall + 1), (cell or {}).get("label", ""), fill="black", font=font(11))
    sheet.save(f"{path}.png", optimize=True)


# --- curves

def draw(axes, panel):
    if "scale" in panel:
        axes.set_yscale(panel["scale"])
        axes.minorticks_off()
    if "limits" in panel:
        axes.set_ylim(*panel["limits"])
    for number, curve in enumerate(curves_of(panel)):
        rows = list(csv.DictReader(io.StringIO(patina("eval", *shlex.split(curve["eval"])))))
        x, y = ([float(row[curve[which]]) for row in rows] for which in ("x", "y"))
        if panel.get("polar"):
            x = numpy.radians(x)
        axes.plot(x, y, curve.get("style", "-"), color=curve.get("color", f"C{number}"), label=curve.get("label", ""),
                  markersize=4)
    axes.set_title(panel.get("title", ""), loc="left", fontsize=10)
    if panel.get("polar"):
        axes.set_theta_zero_location("N")
        axes.set_theta_direction(-1)
        axes.set_thetalim(-numpy.pi / 2, numpy.pi / 2)
        axes.tick_params(labelsize=7)
    else:
        axes.set_xlabel(panel.get("xlabel", ""))
        axes.set_ylabel(panel.get("ylabel", ""))
        axes.margins(x=0.08 if "equal" in panel else 0)
        axes.tick_params(bottom=False, left=False)
        if "equal" in panel:
            axes.set_aspect("equal")


def plots(figure, path):
    panels = figure["plots"]
    polar = [panel.get("polar", False) for panel in panels]
    width, height = figure.get("size", [3.6 * len(panels) + 1, 3.1])
    canvas = pyplot.figure(figsize=(width, height))
    for index, panel in enumerate(panels):
        axes = canvas.add_subplot(1, len(panels), index + 1, projection="polar" if polar[index] else None)
        draw(axes, panel)
        # One legend serves panels with the same curves.
        if index == len(panels) - 1 or "legend" in panel:
            axes.legend(title=panel.get("legend"), loc=panel.get("legendAt", "center left"),
                        bbox_to_anchor=panel.get("legendPlace", [1.02, 0.5]), fontsize=8)
    canvas.tight_layout()
    save_svg(canvas, f"{path}.svg", numbered=True)
