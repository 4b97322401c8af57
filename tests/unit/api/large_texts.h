// Texts of any size, for tests of what takes long.
#pragma once

#include <string>
#include <vector>

#include "patina/patina.h"

namespace patina {

inline const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

inline std::string said(const std::vector<Diagnostic>& diagnostics) {
    std::string all;
    for (const Diagnostic& each : diagnostics) all += to_text(each) + "\n";
    return all;
}

// A graph of nodes that each read the one before.
inline std::string chain_of_nodes(int count) {
    std::string text = R"({ "patina": 1, "workflow": "unlit", "nodes": [ { "id": "n0", "expr": "@uv0.x" })";
    for (int i = 1; i < count; ++i)
        text += R"(, { "id": "n)" + std::to_string(i) + R"(", "expr": "sin(n)" + std::to_string(i - 1) + R"( + )" +
                std::to_string(i) + ")\" }";
    return text + R"( ], "surface": { "color": "= n)" + std::to_string(count - 1) + R"(" } })";
}

// Functions of which each calls the next one twice.
inline std::string doubling(int levels, const std::string& mark = "") {
    std::string text = "float h" + std::to_string(levels) + "(float x) { return sin(x); }\n";
    for (int i = levels - 1; i >= 0; --i) {
        const std::string next = "h" + std::to_string(i + 1);
        text += mark + "float h" + std::to_string(i) + "(float x) { return " + next + "(x) * " + next + "(x + 1); }\n";
    }
    return text;
}
inline std::string node(const std::string& body, const std::string& test = "") {
    return test + "[node(\"Test/F\")]\nfloat F(float2 uv = uv0) { " + body + " }\n";
}

}  // namespace patina
