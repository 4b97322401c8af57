#!/usr/bin/python3
"""Compiles a graph and prints the GLSL, as examples/embed does in C++: with the module patina.py.

Usage: main.py LIBPATINA      (the shared library: /opt/patina/lib/libpatina.so)
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from patina import Compiler

GRAPH = {
    "patina": 1,
    "workflow": "metallic-roughness",
    "lighting": "unity-brdf1",
    "properties": [{"name": "_Tint", "type": "color", "default": "#c9a27e"}],
    "nodes": [{"id": "dots", "node": "./dots.node.hlsl", "in": {"scale": 8}}],
    "surface": {"baseColor": "= $_Tint.rgb * (0.5 + 0.5 * dots)", "roughness": 0.4},
}
FILES = {"dots.node.hlsl": """
/// Round dots, a grid of them.
[node("Procedural/Dots")]
float Dots(float2 uv = uv0, float scale = 4) {
    float2 cell = frac(uv * scale) - 0.5;
    return smoothstep(0.35, 0.3, length(cell));
}
"""}


def main():
    compiler = Compiler(sys.argv[1])
    result = compiler.compile("dotted.graph.json", GRAPH, read=FILES.get, targets=["glsl"])
    sys.stderr.write(result.messages)
    for shader in result.shaders:
        print(f"// ---- {shader.file_name}\n{shader.text}")
    if result.ok:
        print("//", ", ".join(each["name"] for each in result.reflection["properties"]))
    sys.exit(not result.ok)


main()
