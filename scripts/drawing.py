"""What all parts of scripts/pictures share: running patina, writing text, letters on pictures, plots as SVG files."""
import functools
import io
import os
import re
import subprocess
import sys
import tempfile

try:
    import matplotlib

    matplotlib.use("Agg")
    from fontTools.ttLib import TTFont  # a part of matplotlib's package
    from matplotlib import font_manager, pyplot
    from PIL import ImageFont
except ImportError as missing:
    sys.exit(f"scripts/pictures: {missing}; install it with scripts/setup --docs")

PATINA = "build/patina"
# A collection of fonts, whose face 2 has the characters as they are written in simplified Chinese.
CHINESE, SIMPLIFIED = "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc", 2
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


def is_chinese(text):
    return any(character >= "\u3000" for character in text)


def chinese_font():
    if not os.path.exists(CHINESE):
        sys.exit(f"scripts/pictures: there is no {CHINESE}; install it with scripts/setup --docs")
    return CHINESE


def font(size, text=""):
    """The font for a text: Chinese needs another one, a little larger to be read."""
    if is_chinese(text):
        return ImageFont.truetype(chinese_font(), size + 1, index=SIMPLIFIED)
    return ImageFont.truetype(os.path.join(matplotlib.get_data_path(), "fonts/ttf/DejaVuSans.ttf"), size)


@functools.cache
def simplified():
    """A file with one face, for matplotlib reads only the first one of a collection. It is removed when the script ends."""
    file = tempfile.NamedTemporaryFile(suffix=".otf")
    TTFont(chinese_font(), fontNumber=SIMPLIFIED).save(file.name)
    return file


def chinese_plots():
    """The settings of a plot with Chinese text: letters are curves, which show where no such font is installed."""
    font_manager.fontManager.addfont(simplified().name)
    return {"svg.fonttype": "path", "font.sans-serif": ["Noto Sans CJK SC"]}


def save_svg(figure, path, numbered=False):
    """`numbered`: the areas that clip curves have numbers, for the names of round ones differ from run to run."""
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    # A hundredth of a point is invisible, and so is an element that draws nothing. Words stay, between tags and in comments,
    # and scales, by which letters become small.
    text = re.sub(r">[^<]*<|!--.*?-->|scale\([^)]*\)|\d+\.\d{3,}",
                  lambda found: found.group() if found.group()[0] in ">!s" else f"{float(found.group()):.2f}", text.getvalue())
    text = re.sub(r"\s*<metadata>.*</metadata>", "", text, flags=re.DOTALL)
    for number, name in enumerate(re.findall(r'<clipPath id="(\w+)"', text) if numbered else []):
        text = text.replace(name, f"clip{number}")
    write(path, text)
