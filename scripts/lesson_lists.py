"""Reads the lists of figures: docs/lessons/figures/NAME.json lists those of the lesson NAME. Each has a "name" and

  "tiles"   rows of pictures: {"render": what `patina render` is given, "label"}; "crop": [x, y, width], shares of the
            picture, enlarges a part; {"difference": [a, b], "times": 8} shows how far two tiles differ, which have the
            numbers of their order, from 0; null is empty; "size" is the width, and the height without "height"
  "grid"    the same by a pattern: "render" with {row} and {column}, or {cell} where a row is an object, whose null is a
            cell that does not exist
  "render"  one picture as `patina render` is given it, such as a sheet of --sweep or --lighting
  "plots"   curves, in panels side by side: "eval" is what `patina eval` is given, "x" and "y" are columns of its table;
            "each" repeats a curve with values for {name}

The graph of a render is a file that the reader can change: below docs/lessons/graphs, or an example.
"""


def cells_of(figure):
    """Labels of the columns, and for each row its label and its cells."""
    if "tiles" in figure:
        return [], [(figure.get("rows", [""] * 99)[index], row) for index, row in enumerate(figure["tiles"])]
    grid = figure["grid"]
    rows = []
    for label, row in grid["rows"].items():
        cells = []
        for column, word in grid["columns"].items():
            cell = row.get(column) if isinstance(row, dict) else ""
            text = grid["render"].replace("{column}", word).replace("{row}", row if isinstance(row, str) else label)
            cells.append({} if cell is None else {"render": text.replace("{cell}", cell)})
        rows.append((label, cells))
    return list(grid["columns"]), rows


def curves_of(panel):
    for curve in panel["curves"]:
        [(name, values)] = curve.get("each", {None: [None]}).items()
        for value in values:
            yield {key: text.replace("{%s}" % name, str(value)) if isinstance(text, str) else text
                   for key, text in curve.items()}


def has_legend(panels, index):
    """One legend serves panels with the same curves."""
    return index == len(panels) - 1 or "legend" in panels[index]


def commands_of(figure):
    """What patina is given for a figure: "render ..." and "eval ...", without sizes and output."""
    if "render" in figure:
        yield f"render {figure['render']}"
    for panel in figure.get("plots", []):
        yield from (f"eval {curve['eval']}" for curve in curves_of(panel))
    for _, row in cells_of(figure)[1] if "tiles" in figure or "grid" in figure else []:
        yield from (f"render {cell['render']}" for cell in row if "render" in (cell or {}))
