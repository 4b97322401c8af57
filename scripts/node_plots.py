"""The plots of nodes on their pages: docs/nodes/plots/NAME.svg, by docs/nodes/plots.json and families.json.

A line of plots.json is what is drawn of a node:

  node     the node whose outputs are plotted
  over     the main variable: an input of the node, or a name that `in` reads as $name; NAME=FROM..TO:COUNT
  label    of the axis
  in       what the inputs are given, as `patina eval` reads it; {name} is the value of the curve
  curves   an input, or a name that `in` reads, and its value for each curve
  outputs  columns of `patina eval`: a list, or what to call each; "out" without it
  y        "log"; limits: of that axis
  strip    true: a band of colours for each curve, instead of lines

The "plots" of a family in families.json have several nodes on the same axes, each with a line of plots.json:

  plot     the name of the file; title: above the plot
  nodes    a name, or an object: the "node"; what else its inputs are given, "set"; "own": true if it keeps a plot of its own
  panels   an input and its values, a panel for each; {name} in "set" is the value. Without it there is one panel
  over, label, y, limits   as above; without them, those of the first node
"""
import csv
import glob
import io
import json
import os

import numpy
from drawing import patina, save_svg
from matplotlib import pyplot

FOLDER = "docs/nodes/plots"
COLOURS = {"red": "#c23b3b", "green": "#3b8f4a", "blue": "#3b62c2"}
STYLES = ["-", "--", "-.", ":"]


def evaluated(node, over, inputs):
    text = patina("eval", node, over, *[f"{name}={value}" for name, value in inputs.items()])
    return list(csv.DictReader(io.StringIO(text)))


def table(plot, curve, value):
    inputs = {name: text.replace("{%s}" % curve, str(value)) for name, text in plot.get("in", {}).items()}
    if curve and inputs == plot.get("in", {}):
        inputs[curve] = str(value)
    return evaluated(plot["node"], plot["over"], inputs)


def curves_of(plot):
    [(curve, values)] = plot.get("curves", {None: [None]}).items()
    return curve, values


def outputs_of(plot):
    """Columns of `patina eval`, by what to call each."""
    outputs = plot.get("outputs", ["out"])
    return {column: column for column in outputs} if isinstance(outputs, list) else outputs


def axis_of(plot):
    return plot["over"].split("=")[0]


def finish(axes, plot):
    if plot.get("y") == "log":
        axes.set_yscale("log")
        axes.minorticks_off()
    if "limits" in plot:
        axes.set_ylim(*plot["limits"])
    axes.margins(x=0)
    axes.tick_params(bottom=False, left=False)


# --- one node

def draw_strip(plot):
    """The colours that a node returns, encoded as screens need them, a band for each curve."""
    curve, values = curves_of(plot)
    axis = axis_of(plot)
    figure, grid = pyplot.subplots(len(values), 1, figsize=(5, 0.9 + 0.32 * len(values)), sharex=True, squeeze=False)
    for axes, value in zip(grid[:, 0], values):
        rows = table(plot, curve, value)
        linear = numpy.clip([[float(row[f"out.{c}"]) for c in "xyz"] for row in rows], 0, 1)
        encoded = numpy.where(linear <= 0.0031308, linear * 12.92, 1.055 * linear ** (1 / 2.4) - 0.055)
        ends = float(rows[0][axis]), float(rows[-1][axis])
        axes.imshow(encoded[None, :, :], aspect="auto", extent=(*ends, 0, 1), interpolation="nearest")
        axes.grid(False)
        axes.tick_params(bottom=False, left=False, labelleft=False)
        axes.spines[:].set_visible(False)
        if curve:
            axes.set_ylabel(f"{value}", rotation=0, horizontalalignment="right", verticalalignment="center")
    axes.set_xlabel(plot.get("label", axis))
    grid[0, 0].set_title(plot["node"] + (f", by {curve}" if curve else ""), loc="left", fontsize=10)
    save_svg(figure, f"{FOLDER}/{plot['node']}.svg")


def draw(plot):
    if plot.get("strip"):
        return draw_strip(plot)
    curve, values = curves_of(plot)
    outputs, axis = outputs_of(plot), axis_of(plot)
    figure, axes = pyplot.subplots(figsize=(5, 3.1))
    for index, value in enumerate(values):
        rows = table(plot, curve, value)
        for number, (name, column) in enumerate(outputs.items()):
            words = ([f"{value}"] if curve else []) + ([name] if len(outputs) > 1 else [])
            colour = COLOURS.get(name, f"C{index if curve else number}")
            style = ["-", "--", ":", "-."][number % 4] if curve else "-"
            axes.plot([float(row[axis]) for row in rows], [float(row[column]) for row in rows], style, color=colour,
                      label=" ".join(words))
    finish(axes, plot)
    axes.set_xlabel(plot.get("label", axis))
    axes.set_title(plot["node"], loc="left", fontsize=10)
    if curve or len(outputs) > 1:
        axes.legend(title=curve, loc="center left", bbox_to_anchor=(1, 0.5))
    save_svg(figure, f"{FOLDER}/{plot['node']}.svg")


# --- several nodes

def member_of(entry):
    return {"node": entry} if isinstance(entry, str) else entry


def lines_of(shared, member, line, panel, value):
    """The curves of one node in a panel: what to call each, its rows, and the column of the value."""
    given = {name: text.replace("{%s}" % panel, str(value)) for name, text in member.get("set", {}).items()}
    over = shared.get("over", line["over"])
    curve, values = curves_of(line)
    if curve == panel or curve in given:
        values = [given.pop(curve, value)]
    for each in values:
        inputs = {name: text.replace("{%s}" % curve, str(each)) for name, text in line.get("in", {}).items()} | given
        if curve and "{%s}" % curve not in "".join(line.get("in", {}).values()):
            inputs[curve] = str(each)
        rows = evaluated(line["node"], over, inputs)
        outputs = outputs_of(line)
        for name, column in outputs.items():
            words = [line["node"]] + ([str(each)] if len(values) > 1 else []) + ([name] if len(outputs) > 1 else [])
            yield ", ".join(words), rows, column


def look(node, curve, output, outputs, is_crowded):
    """A colour for a node's curve, and a style for it, or for each of its outputs. Where curves coincide, wide lines show below narrow
    ones."""
    style = STYLES[(output if outputs > 1 else node + curve) % len(STYLES)]
    return {"color": f"C{node + curve}", "linestyle": style, "linewidth": max(3.4 - 0.5 * node, 1.6) if is_crowded else 1.6}


def draw_panel(axes, shared, lines, panel, value):
    axis = axis_of(shared)
    for number, member in enumerate(map(member_of, shared["nodes"])):
        line = lines[member["node"]]
        count = len(outputs_of(line))
        for index, (label, rows, column) in enumerate(lines_of(shared, member, line, panel, value)):
            axes.plot([float(row[axis]) for row in rows], [float(row[column]) for row in rows], label=label,
                      **look(number, index // count, index % count, count, len(shared["nodes"]) > 2))
    finish(axes, shared)
    if panel:
        axes.set_title(f"{panel} {value}", loc="left", fontsize=9)


def draw_shared(shared, lines):
    """Curves of several nodes, a panel for each value: two panels in a row, or three."""
    first = lines[member_of(shared["nodes"][0])["node"]]
    shared = {key: first[key] for key in ("over", "label", "y", "limits") if key in first} | shared
    [(panel, values)] = shared.get("panels", {None: [None]}).items()
    columns = len(values) if len(values) < 4 else 2
    count = -(-len(values) // columns)
    width, height = (5, 3.1) if len(values) == 1 else (3.6 * columns, 0.5 + 2.5 * count)
    figure, grid = pyplot.subplots(count, columns, figsize=(width, height), sharex=True, sharey=True, squeeze=False)
    for axes, value in zip(grid.flat, values):
        draw_panel(axes, shared, lines, panel, value)
    # Places are shares of the figure: letters have the same distance from all figures.
    figure.suptitle(shared["title"], x=grid[0, 0].get_position().x0, y=0.88 + (0.45 if panel else 0.15) / height,
                    verticalalignment="bottom", horizontalalignment="left", fontsize=10)
    figure.supxlabel(shared.get("label", axis_of(shared)), fontsize=9, y=0.11 - 0.55 / height)
    figure.legend(*grid[0, 0].get_legend_handles_labels(), loc="center left", bbox_to_anchor=(0.91, 0.5),
                  handlelength=3.5)
    save_svg(figure, f"{FOLDER}/{shared['plot']}.svg")


# --- all

def shared_plots():
    with open("docs/nodes/families.json", encoding="utf-8") as file:
        return [plot for family in json.load(file)["families"] for plot in family.get("plots", [])]


def plots():
    os.makedirs(FOLDER, exist_ok=True)
    with open("docs/nodes/plots.json", encoding="utf-8") as file:
        lines = {line["node"]: line for line in json.load(file)["plots"]}
    shared = shared_plots()
    without = {member["node"] for plot in shared for member in map(member_of, plot["nodes"]) if not member.get("own")}
    own = [line for name, line in lines.items() if name not in without]
    names = [line["node"] for line in own] + [plot["plot"] for plot in shared]
    for path in set(glob.glob(f"{FOLDER}/*.svg")) - {f"{FOLDER}/{name}.svg" for name in names}:
        os.remove(path)
    for plot in shared:
        draw_shared(plot, lines)
    for line in own:
        draw(line)
    albedo()


def albedo():
    """What one bounce off perfect mirrors sends back: the tables that tests/proof holds the visibility terms to."""
    with open("tests/data/directional-albedo.json", encoding="utf-8") as file:
        tables = json.load(file)
    names = [name for name in tables if name not in ("about", "ndotv", "alpha")]
    figure, grid = pyplot.subplots(2, 2, figsize=(7.2, 5), sharex=True, sharey=True)
    for axes, name in zip(grid.flat, names):
        for index, alpha in enumerate(tables["alpha"]):
            axes.plot(tables["ndotv"], tables[name][index], color=pyplot.cm.viridis(index / len(tables["alpha"])),
                      label=f"{alpha:g}")
        axes.set_title(name, loc="left", fontsize=10)
        axes.set_ylim(0, 1.02)
        axes.margins(x=0)
        axes.tick_params(bottom=False, left=False)
    for axes in grid[1]:
        axes.set_xlabel("n.v")
    figure.legend(*grid[0][0].get_legend_handles_labels(), title="alpha", loc="center left", bbox_to_anchor=(0.92, 0.5))
    save_svg(figure, "docs/images/directional-albedo.svg")
