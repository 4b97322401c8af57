"""The sections of docs/conventions.md that scripts/reference writes: semantics, and the values of the engine."""
from reference_text import cell, code, end, plain, table

# A rate of the library: its title, and what its values have in common.
RATES = {
    "vertex": ("Of the mesh", "These values exist for each vertex and are interpolated."),
    "pixel": ("Of the pixel",
              "Computed where they are read. The vertex stage (the `vertex` block, and nodes that are pinned to it) cannot read "
              "these: `@fragCoord`, `@frontFacing`, `@screenUV`, `@sceneColor`, `@sceneDepth`, derivatives."),
    "uniform": ("Of the frame and of the object", "The same for all that is drawn at once."),
    "lighting": ("In a lighting graph", "Only lighting graphs read these values; the pass provides them."),
}
SEMANTICS = """What mesh, camera, engine and light provide, read as `@uv0` in a port or an expression of a
[graph](graph-format.md#values). Lengths are metres, `OS`, `WS`, `VS` and `TS` are object, world, view and tangent space.

"""
ENGINE = """The members of the engine's uniform blocks, and its textures. A material reads some of them: its reflection says which, and the
offset of each. The engine, which is the program that draws, sets all of them. Only the block of the material's own properties
is not in this list. The numbers must be finite: Patina replaces 0 times such a number by 0. An engine may have names of its own
for blocks ([engines](engines.md)). `E/pi` is the radiance of a white Lambert surface. What has a row under "only with" is read
if one of these switches or rendering paths is on. No switch moves a value: a shader declares the values of a block up to the
last one that it may read. So one structure with all of them fits every shader. In a draw of instances, the values of the object
are arrays. The properties of the instances come after the values that are always declared, and before those that a switch adds.

"""


def semantics(values):
    text = SEMANTICS
    for rate, (title, about) in RATES.items():
        rows = [[code("@" + each["name"]), each["type"], cell(each.get("doc", ""))] for each in values["semantics"]
                if each["rate"] == rate]
        text += f"### {title}\n\n{about}\n\n" + table(["semantic", "type", "what"], rows)
    return end(text)


def engine_row(value):
    about = cell(value.get("doc", "")) + (" A draw of instances has one for each." if value["ofObject"] else "")
    with_words = ", ".join(code(name) for name in value.get("with", []))
    return [code(value["name"]), value["type"], cell(value.get("unit", "")), cell(value.get("space", "")), about, with_words]


def engine_values(values):
    text = ENGINE
    for each in values["blocks"]:
        name = each.get("name")
        text += f"### {code(name) if name else 'Textures'}\n\n"
        text += plain(each["doc"]) + "\n\n" if each.get("doc") else ""
        text += table(["name", "type", "unit", "space", "what", "only with"], [engine_row(value) for value in each["values"]])
    return end(text)


# What stands between the markers, by the name that these have.
SECTIONS = {"semantics": semantics, "engine values": engine_values}
