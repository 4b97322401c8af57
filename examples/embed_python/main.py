#!/usr/bin/python3
"""Compiles a graph and prints the GLSL, as examples/embed does in C++: through ctypes, with no other module.

Usage: main.py LIBPATINA      (the shared library: /opt/patina/lib/libpatina.so)
"""
import ctypes
import json
import sys
from ctypes import CFUNCTYPE, POINTER, byref, c_char_p, c_int, c_size_t, c_uint32, c_void_p

ABI = 1  # PATINA_C_ABI of the header that this file follows
OK = 0

GRAPH = {
    "patina": 1,
    "workflow": "metallic-roughness",
    "lighting": "unity-brdf1",
    "properties": [{"name": "_Tint", "type": "color", "default": "#c9a27e"}],
    "nodes": [{"id": "dots", "node": "./dots.node.hlsl", "in": {"scale": 8}}],
    "surface": {"baseColor": "= $_Tint.rgb * (0.5 + 0.5 * dots)", "roughness": 0.4},
}
FILES = {"dots.node.hlsl": b"""
/// Round dots, a grid of them.
[node("Procedural/Dots")]
float Dots(float2 uv = uv0, float scale = 4) {
    float2 cell = frac(uv * scale) - 0.5;
    return smoothstep(0.35, 0.3, length(cell));
}
"""}


class Callbacks(ctypes.Structure):  # patina_callbacks
    Read = CFUNCTYPE(None, c_void_p, c_char_p, c_void_p)
    _fields_ = [("user", c_void_p), ("read", Read), ("exists", CFUNCTYPE(c_int, c_void_p, c_char_p)),
                ("resolve", CFUNCTYPE(None, c_void_p, c_char_p, c_char_p, c_void_p)),
                ("cancelled", CFUNCTYPE(c_int, c_void_p))]


class Shader(ctypes.Structure):  # patina_shader
    _fields_ = [("file_name", c_char_p), ("text", c_char_p), ("size", c_size_t), ("pass_name", c_char_p),
                ("stage", c_char_p), ("engine", c_char_p), ("language", c_char_p)]


def load(path):
    """The library, with the types of the functions that this program calls."""
    library = ctypes.CDLL(path)
    for name, result, *arguments in [
            ("patina_compiler_create", c_int, c_uint32, c_void_p, c_size_t, POINTER(c_void_p)),
            ("patina_compiler_free", None, c_void_p),
            ("patina_status_text", c_char_p, c_int),
            ("patina_reply_text", None, c_void_p, c_char_p, c_size_t),
            ("patina_compile", c_int, c_void_p, c_char_p, c_char_p, c_size_t, c_char_p, POINTER(Callbacks),
             POINTER(c_void_p)),
            ("patina_result_messages", c_char_p, c_void_p),
            ("patina_result_shader_count", c_size_t, c_void_p),
            ("patina_result_shader", POINTER(Shader), c_void_p, c_size_t),
            ("patina_result_reflection", c_char_p, c_void_p),
            ("patina_result_free", None, c_void_p)]:
        function = getattr(library, name)
        function.restype, function.argtypes = result, arguments
    return library


def main():
    library = load(sys.argv[1])
    compiler, result = c_void_p(), c_void_p()
    status = library.patina_compiler_create(ABI, None, 0, byref(compiler))
    if status != OK:
        sys.exit(library.patina_status_text(status).decode())

    @Callbacks.Read
    def read(_, path, reply):
        text = FILES.get(path.decode())
        if text is not None:
            library.patina_reply_text(reply, text, len(text))

    graph, options = json.dumps(GRAPH).encode(), json.dumps({"targets": ["glsl"]}).encode()
    status = library.patina_compile(compiler, b"dotted.graph.json", graph, len(graph), options,
                                    byref(Callbacks(read=read)), byref(result))
    sys.stderr.write(library.patina_result_messages(result).decode())
    for i in range(library.patina_result_shader_count(result)):
        shader = library.patina_result_shader(result, i).contents
        print(f"// ---- {shader.file_name.decode()}\n{shader.text.decode()}")
    if status == OK:
        reflection = json.loads(library.patina_result_reflection(result))
        print("//", ", ".join(each["name"] for each in reflection["properties"]))
    library.patina_result_free(result)
    library.patina_compiler_free(compiler)
    sys.exit(status != OK)


main()
