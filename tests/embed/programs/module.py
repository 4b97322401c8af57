"""Imports examples/embed_python/patina.py and calls all of it. Usage: module.py FOLDER_OF_THE_MODULE LIBPATINA"""
import sys

sys.path.insert(0, sys.argv[1])
from patina import Compiler, Error

compiler = Compiler(sys.argv[2])
MODES = """{
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [{ "name": "_Mode", "type": "enum", "values": ["Dry", "Wet"], "as": "variant" }],
  "surface": { "baseColor": "= float3(0.5, 0.4, 0.3 * float(int($_Mode)))" }
}"""
SCENE = """{
  "patina": 1,
  "kind": "scene",
  "camera": { "position": [0, 1, 4] },
  "materials": [{ "name": "modes", "graph": "modes.graph.json" }],
  "objects": [{ "id": "ball", "mesh": "sphere", "material": "modes" }]
}"""
files = {"modes.graph.json": MODES, "ball.scene.json": SCENE}

variants = compiler.compile_variants("modes.graph.json", read=files.get, targets=["glsl"])
assert variants.ok, variants.messages
assert variants.combinations == [{"_Mode": "Dry"}, {"_Mode": "Wet"}], variants.combinations
assert variants.program_of == [0, 1] and len(variants.programs) == 2
assert all(program.shaders for program in variants.programs)
assert variants.dependencies == ["modes.graph.json"] and variants.missing == [], variants
few = compiler.compile_variants("modes.graph.json", limit=1, read=files.get)
assert not few.ok and "[too-many]" in few.messages, few.messages

scene = compiler.read_scene("ball.scene.json", read=files.get)
assert scene.ok, scene.messages
assert scene.scene["objects"][0]["material"] == "modes" and scene.scene["camera"]["fov"] == 30, scene.scene
assert scene.dependencies == ["ball.scene.json"] and scene.missing == [], scene

result = compiler.compile_file("modes.graph.json", read=files.get, targets=["hlsl"], switches={"_Mode": "Wet"})
assert result.ok and result.dependencies == ["modes.graph.json"], result.messages
assert {shader.language for shader in result.shaders} == {"hlsl"}
result = compiler.compile_file("gone.graph.json", read=files.get)
assert not result.ok and result.missing == ["gone.graph.json"], result


def broken(path):
    raise OSError("the pack is damaged: " + path)


result = compiler.compile_file("modes.graph.json", read=broken)
assert not result.ok and "the pack is damaged: modes.graph.json" in result.messages, result.messages
assert result.diagnostics[0]["code"] == "cannot-read"

assert next(node for node in compiler.nodes() if node["name"] == "Lerp")["inputs"]
assert "forward" in [path["name"] for path in compiler.paths()]
assert compiler.engines()[0]["name"] == "vulkan"
own = Compiler(sys.argv[2], files={"dots.node.hlsl": "/// Dots.\n[node(\"Mine\")]\nfloat Dots(float s = 4) { return s; }\n"})
assert "Dots" in [node["name"] for node in own.nodes()]
try:
    compiler.compile_variants("modes.graph.json", wanted="none", read=files.get)
    raise AssertionError("an impossible word is accepted")
except Error as error:
    assert "a word is impossible" in str(error)
print("the module works")
