"""The pictures of nodes on their pages, by docs/nodes/pictures.json: docs/nodes/pictures/FAMILY.png has a panel of each node of a
family, in rows, with the nodes' names; docs/nodes/pictures/NAME.png is a row of all panels of a node that has several.

    node     the node
    panels   what is drawn and its caption: an expression of a colour or a number, which reads `uv`: (0, 0) is the upper left corner
             of the panel, (1, 1) the lower right one; with "mesh", it is what the mesh has
    texture  a file that the expression reads as $_Texture; the mesh for a panel that is not a flat square: "mesh"
    shown    the caption of the panel that stands for the node in the picture of its family; the first one without it
    usage    of the texture: "color" without it; "normal" or "data"
"""
import glob
import json
import os
import tempfile

from PIL import Image, ImageDraw

from drawing import font, patina

SIDE, GAP, LETTERS, COLUMNS = 160, 8, 20, 5
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
    families = drawn_families(pictures)
    several = [picture for picture in pictures if is_alone(picture, families)]
    os.makedirs("docs/nodes/pictures", exist_ok=True)
    names = [picture["node"] for picture in several] + list(families)
    for path in set(glob.glob("docs/nodes/pictures/*.png")) - {f"docs/nodes/pictures/{name}.png" for name in names}:
        os.remove(path)
    with tempfile.TemporaryDirectory() as folder:
        graphs = {}  # by mesh: one run of patina draws them all
        for picture in pictures:
            for number, expression in enumerate(picture["panels"].values()):
                graph = write_graph(folder, picture, expression, f"{picture['node']}{number}")
                graphs.setdefault(picture.get("mesh"), []).append(graph)
        for mesh, paths in graphs.items():
            patina("render", *paths, "-o", folder, "--size", str(SIDE), *(["--mesh", mesh] if mesh else FLAT))
        for picture in several:
            panels = enumerate(picture["panels"])
            files = [(caption, f"{folder}/{picture['node']}{number}.png") for number, caption in panels]
            # Few colours make small files; a family has too many for that.
            save(picture["node"], joined(files, len(files)).quantize(128))
        for family, members in families.items():
            save(family, joined([(each["node"], f"{folder}/{each['node']}{shown(each)}.png") for each in members], COLUMNS))


def drawn_families(pictures):
    """By the page of a family, the pictures of its nodes, if there are several."""
    with open("docs/nodes/families.json", encoding="utf-8") as file:
        families = json.load(file)["families"]
    files = {node["name"]: node["file"].removeprefix("nodes/").removesuffix(".node.hlsl")
             for node in json.loads(patina("nodes", "--json"))}
    found = {}
    for picture in pictures:
        name = picture["node"]
        family = [f for f in families if name in f["from"]] or [f for f in families if files[name] in f["from"]]
        found.setdefault(family[0]["page"], []).append(picture)
    return {page: members for page, members in found.items() if len(members) > 1}


def is_alone(picture, families):
    """True if the row of its family does not show all of it."""
    return len(picture["panels"]) > 1 or not any(picture in members for members in families.values())


def shown(picture):
    """The number of the panel that stands for the node."""
    return list(picture["panels"]).index(picture["shown"]) if "shown" in picture else 0


def save(name, sheet):
    sheet.save(f"docs/nodes/pictures/{name}.png", optimize=True)


def joined(panels, columns):
    """One picture of captions and files, in rows."""
    width, rows = min(len(panels), columns), -(-len(panels) // columns)
    sheet = Image.new("RGB", (width * (SIDE + GAP) - GAP, rows * (SIDE + LETTERS + GAP) - GAP), "white")
    draw = ImageDraw.Draw(sheet)
    for number, (caption, file) in enumerate(panels):
        left, top = number % columns * (SIDE + GAP), number // columns * (SIDE + LETTERS + GAP)
        sheet.paste(Image.open(file).convert("RGB"), (left, top))
        draw.text((left, top + SIDE + 4), caption, "black", font(11))
    return sheet
