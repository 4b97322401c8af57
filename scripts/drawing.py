"""What all parts of scripts/pictures share: running patina, writing text, letters on pictures, plots as SVG files."""
import io
import os
import re
import subprocess
import sys

try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
    from PIL import ImageFont
except ImportError as missing:
    sys.exit(f"scripts/pictures: {missing}; install it with scripts/setup --docs")

PATINA = "build/patina"
matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "patina", "font.sans-serif": ["DejaVu Sans"], "font.size": 9, "axes.grid": True,
    "grid.color": "#dddddd", "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.6,
    "legend.frameon": False})


def patina(*arguments):
    ran = subprocess.run([PATINA, *arguments], capture_output=True, text=True)
    if ran.returncode != 0:
        sys.exit(f"patina {' '.join(arguments)}\n{ran.stderr}")
    return ran.stdout


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def font(size):
    return ImageFont.truetype(os.path.join(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf"), size)


def save_svg(figure, path, numbered=False):
    """`numbered`: the areas that clip curves have numbers, for the names of round ones differ from run to run."""
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    # A hundredth of a point is invisible, and so is an element that draws nothing. Words between tags stay.
    text = re.sub(r">[^<]*<|\d+\.\d{3,}", lambda found: found.group() if found.group().startswith(">")
                  else f"{float(found.group()):.2f}", text.getvalue())
    text = re.sub(r"\s*<metadata>.*</metadata>", "", text, flags=re.DOTALL)
    for number, name in enumerate(re.findall(r'<clipPath id="(\w+)"', text) if numbered else []):
        text = text.replace(name, f"clip{number}")
    write(path, text)
