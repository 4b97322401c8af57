"""The pictures of nodes on their pages: docs/nodes/pictures/NAME.png, a row of panels for a line of docs/nodes/pictures.json.

    node     the node
    panels   what is drawn and its caption: an expression of a colour or a number, which reads `uv`: (0, 0) is the upper left corner
             of the panel, (1, 1) the lower right one; with "mesh", it is what the mesh has
    texture  a file that the expression reads as $_Texture; the mesh for a panel that is not a flat square: "mesh"
    usage    of the texture: "color" without it; "normal" or "data"
"""
import glob
import json
import os
import tempfile

from PIL import Image, ImageDraw

from drawing import font, patina

SIDE, GAP, LETTERS = 160, 8, 20
# A plane that fills the view.
FLAT = ["--mesh", "plane", "--camera", "position=0,0,0.3 target=0,0,0 fov=40"]


def write_graph(folder, picture, expression, name):
    nodes = [{"id": "uv", "expr": "@uv0" if "mesh" in picture else "@screenUV"}, {"id": "shown", "expr": expression}]
    graph = {"patina": 1, "workflow": "unlit", "nodes": nodes, "surface": {"color": "= float3(1) * shown"}}
    if "texture" in picture:
        graph["properties"] = [{"name": "_Texture", "type": "texture2d", "usage": picture.get("usage", "color"),
                                "default": os.path.abspath(picture["texture"])}]
    path = f"{folder}/{name}.graph.json"
    with open(path, "w", encoding="utf-8") as file:
        json.dump(graph, file)
    return path


def node_pictures():
    with open("docs/nodes/pictures.json", encoding="utf-8") as file:
        pictures = json.load(file)["pictures"]
    os.makedirs("docs/nodes/pictures", exist_ok=True)
    for path in set(glob.glob("docs/nodes/pictures/*.png")) - {f"docs/nodes/pictures/{p['node']}.png" for p in pictures}:
        os.remove(path)
    with tempfile.TemporaryDirectory() as folder:
        graphs = {}  # by mesh: one run of patina draws them all
        for picture in pictures:
            for number, expression in enumerate(picture["panels"].values()):
                graph = write_graph(folder, picture, expression, f"{picture['node']}{number}")
                graphs.setdefault(picture.get("mesh"), []).append(graph)
        for mesh, paths in graphs.items():
            patina("render", *paths, "-o", folder, "--size", str(SIDE), *(["--mesh", mesh] if mesh else FLAT))
        for picture in pictures:
            join(folder, picture)


def join(folder, picture):
    panels = picture["panels"]
    sheet = Image.new("RGB", (len(panels) * (SIDE + GAP) - GAP, SIDE + LETTERS), "white")
    draw = ImageDraw.Draw(sheet)
    for number, caption in enumerate(panels):
        left = number * (SIDE + GAP)
        sheet.paste(Image.open(f"{folder}/{picture['node']}{number}.png").convert("RGB"), (left, 0))
        draw.text((left, SIDE + 4), caption, "black", font(11))
    sheet.quantize(128).save(f"docs/nodes/pictures/{picture['node']}.png", optimize=True)
