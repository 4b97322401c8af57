// Graphs compiled for Unity, given as text, and what is asked of the result.
//
//   const std::string text = shader(material(R"("surface": { "metallic": 1 })"));
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "patina/patina.h"

namespace patina::unity {

inline const Target kUnity{"unity", "hlsl"};

inline const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

inline Result for_unity(const std::string& graph) {
    CompileOptions options;
    options.targets = {kUnity};
    Result result = compiler().compile_file(graph, options);
    EXPECT_TRUE(result.ok) << graph;
    return result;
}

inline Result of_text(const std::string& text, const std::string& path = "forward") {
    CompileOptions options;
    options.targets = {kUnity};
    options.request = CompileOptions::Passes{.path = path};
    return compiler().compile_text("t.graph.json", text, options);
}

inline std::string shader(const std::string& text) {
    const Result result = of_text(text);
    for (const Diagnostic& d : result.diagnostics) EXPECT_NE(d.severity, Severity::Error) << to_text(d);
    return result.shaders.empty() ? std::string() : result.shaders.front().text;
}

inline std::string material(const std::string& rest) {
    return R"({ "patina": 1, "workflow": "metallic-smoothness", "lighting": "unity-brdf1", )" + rest + " }";
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline Diagnostic first_error(const Result& result) {
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::Error) return d;
    }
    return {};
}

}  // namespace patina::unity
