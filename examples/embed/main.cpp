// Compiles a graph from a string and prints the GLSL. It needs only the compiler library.
#include <patina/patina.h>

#include <cstdio>

int main() {
    const std::string graph = R"json({
      "patina": 1,
      "workflow": "metallic-roughness",
      "lighting": "unity-brdf1",
      "properties": [{ "name": "_Tint", "type": "color", "default": "#c9a27e" }],
      "nodes": [{ "id": "dots", "node": "./dots.node.hlsl", "in": { "scale": 8 } }],
      "surface": { "baseColor": "= $_Tint.rgb * (0.5 + 0.5 * dots)", "roughness": 0.4 }
    })json";
    const std::string dots = R"hlsl(
      /// Round dots, a grid of them.
      [node("Procedural/Dots")]
      float Dots(float2 uv = uv0, float scale = 4) {
          float2 cell = frac(uv * scale) - 0.5;
          return smoothstep(0.35, 0.3, length(cell));
      }
    )hlsl";

    const patina::Compiler compiler;  // loads the node library; keep it
    patina::CompileOptions options;
    options.targets = {patina::Target::Glsl};
    options.loader = [&](const std::string& path) -> std::optional<std::string> {
        if (path == "dots.node.hlsl") return dots;
        return std::nullopt;
    };
    const patina::Result result = compiler.compile_text("dotted.graph.json", graph, options);
    for (const patina::Diagnostic& d : result.diagnostics) std::fprintf(stderr, "%s\n", patina::to_text(d).c_str());
    for (const patina::Shader& shader : result.shaders) {
        std::printf("// ---- %s\n%s\n", shader.file_name.c_str(), shader.text.c_str());
    }
    return result.ok ? 0 : 1;
}
