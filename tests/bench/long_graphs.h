// Graphs of any length, for benchmarks and tests. Each node is "n0", "n1", ...; all is JSON without line breaks unless
// asked for, since a graph that a tool wrote may stand on one line.
//
//   compiler.compile_text("ladder.graph.json", long_graph(Shape::Ladder, 10'000));
#pragma once

#include <string>

namespace patina::bench {

enum class Shape {
    Chain,   // each node reads the one before it
    Ladder,  // each node reads the one before it twice: 2^n ways through it
};

inline std::string long_graph(Shape shape, int nodes, const char* line_break = "\n") {
    const auto id = [](int i) { return "n" + std::to_string(i); };
    std::string text = R"({ "patina": 1, "workflow": "metallic-roughness",)";
    text += R"( "properties": [ { "name": "_MainTex", "type": "texture2d", "usage": "color" } ], "nodes": [)";
    text += R"( { "id": "n0", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } })";
    for (int i = 1; i < nodes; ++i) {
        const std::string before = id(i - 1);
        text += "," + std::string(line_break) + R"({ "id": ")" + id(i) + R"(", "node": "Multiply", "in": { "left": ")" +
                before + R"(", "right": )" +
                (shape == Shape::Ladder ? "\"" + before + "\"" : std::string("\"$_MainTex.texelSize\"")) + " } }";
    }
    return text + R"( ], "surface": { "baseColor": ")" + id(nodes - 1) + R"(.rgb" } })";
}

}  // namespace patina::bench
