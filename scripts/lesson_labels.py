"""What is written in the figures of docs/lessons, in English and in Chinese: docs/lessons/zh/labels.json has

  "words"   a label as docs/lessons/figures has it, and its Chinese
  "names"   words that are the same in Chinese: of models, functions and people

A figure with words has a picture of its own in docs/lessons/zh/pictures. Both languages share the picture of another one.
"""
import json
import re

from lesson_lists import cells_of, curves_of, has_legend

LABELS = "docs/lessons/zh/labels.json"


class Words(dict):
    """A label's words in a language, which are the label itself if there is nothing else."""

    def __missing__(self, label):
        return label


def read_labels(root="."):
    with open(f"{root}/{LABELS}", encoding="utf-8") as file:
        return json.load(file)


def labels_of(figure):
    """Every label that is drawn into a figure, once. A sheet that `patina render` labels has none."""
    labels = []
    panels = figure.get("plots", [])
    for index, panel in enumerate(panels):
        labels += [panel.get(key, "") for key in ("title", "xlabel", "ylabel", "legend")]
        labels += [curve.get("label", "") for curve in curves_of(panel) if has_legend(panels, index)]
    if "tiles" in figure or "grid" in figure:
        columns, rows = cells_of(figure)
        labels += columns + [label for label, _ in rows]
        labels += [(cell or {}).get("label", "") for _, row in rows for cell in row]
    return list(dict.fromkeys(label for label in labels if label))


def has_chinese(figure, labels):
    return any(label in labels["words"] for label in labels_of(figure))


def english_in(text, labels):
    """The words that are no names. A letter, perhaps with a digit, belongs to a formula: n, G1."""
    words = re.findall(r"[A-Za-z][A-Za-z0-9]*(?:-[A-Za-z0-9]+)*", text)
    return [word for word in words if not re.fullmatch(r"[A-Za-z]\d?", word) and word not in labels["names"]]


def bad_labels(lesson, figures, labels):
    """A label that would stay English by accident."""
    for figure in figures:
        for label in labels_of(figure):
            chinese = labels["words"].get(label, label)
            if words := english_in(chinese, labels):
                yield (f"{lesson}-{figure['name']}: the label '{chinese}' has English: {', '.join(words)}; write the label into "
                       f"{LABELS}, or what both languages share into its names")
