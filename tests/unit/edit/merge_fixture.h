// A graph, and what three-way merges of its versions must be.
#pragma once

#include <gtest/gtest.h>

#include "patina/graph_merge.h"

namespace patina {

// A graph in which `{}` of each list are its lines.
struct Lines {
    std::string properties = R"(    { "name": "_Amount", "type": "float", "default": 0.5 },
    { "name": "_Tint", "type": "color", "default": "#c9a27e" }
)";
    std::string nodes = R"json(    // How much rust there is.
    { "id": "mask", "node": "GradientNoise", "in": { "uv": "@uv0", "scale": 4 } },
    { "id": "edge", "expr": "saturate(mask * $_Amount)" }
)json";
    std::string surface = R"("baseColor": "= $_Tint.rgb * edge", "roughness": 0.5)";
    std::string more;  // after the surface

    std::string text() const {
        return "{\n  \"patina\": 1,\n  \"workflow\": \"metallic-roughness\",\n  \"properties\": [\n" + properties +
               "  ],\n  \"nodes\": [\n" + nodes + "  ],\n  \"surface\": { " + surface + " }" + more + "\n}\n";
    }
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

class Merges : public testing::Test {
public:
    static MergeResult merge(const std::string& base, const std::string& ours, const std::string& theirs) {
        static const Compiler compiler;
        return merge_graphs(compiler, {"base.json", base}, {"ours.json", ours}, {"theirs.json", theirs},
                            {.path = "merged.graph.json"});
    }

    static void expect_clean(const std::string& base, const std::string& ours, const std::string& theirs,
                             const std::string& wanted) {
        const MergeResult merged = merge(base, ours, theirs);
        for (const Diagnostic& each : merged.diagnostics) ADD_FAILURE() << to_text(each);
        EXPECT_EQ(merged.state, MergeState::Clean);
        EXPECT_EQ(merged.text, wanted);
    }

    // The sides of the conflict's text, as someone gets them who takes one side everywhere.
    static std::string side_of(const std::string& text, bool ours) {
        std::string made;
        char in = ' ';
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = text.find('\n', at) + 1;
            const std::string line = text.substr(at, end - at);
            at = end;
            if (line.starts_with("<<<<<<<") || line.starts_with("=======") || line.starts_with(">>>>>>>")) {
                in = line[0];
                continue;
            }
            if (in != (ours ? '=' : '<')) made += line;
        }
        return made;
    }

    // `wanted`: parts of the messages and of their notes.
    static MergeResult expect_conflict(const std::string& base, const std::string& ours, const std::string& theirs,
                                       const std::vector<std::string>& wanted) {
        MergeResult merged = merge(base, ours, theirs);
        EXPECT_EQ(merged.state, MergeState::Conflicts);
        EXPECT_FALSE(merged.diagnostics.empty());
        std::string said;
        for (const Diagnostic& each : merged.diagnostics) said += to_text(each) + "\n";
        for (const std::string& part : wanted) EXPECT_NE(said.find(part), said.npos) << part << "\nin\n" << said;
        const Compiler compiler;
        for (const bool side : {true, false}) {
            const Result compiled = compiler.compile_text("side.graph.json", side_of(merged.text, side));
            EXPECT_TRUE(compiled.ok) << merged.text << to_text(compiled.diagnostics.front());
        }
        return merged;
    }
};

}  // namespace patina
