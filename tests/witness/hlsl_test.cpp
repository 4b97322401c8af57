// Node files that are read by HLSL's rules: the `test:` lines of tests/hlsl, by the CPU interpreter in double, and on
// the GPU through GLSL and through HLSL. The lines have what HLSL's rules give, worked out by hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "witness/node_tests.h"

namespace patina::witness {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

// The text with one of its nodes; the others are functions that it may call.
std::string with_node(const std::string& text, const std::string& name) {
    static const std::regex kNode(R"((?:///[^\n]*\n)*\[node\([^\n]*\)\]\n(\w+ (\w+)\())");
    std::string made;
    std::size_t end = 0;
    for (std::sregex_iterator each(text.begin(), text.end(), kNode); each != std::sregex_iterator(); ++each) {
        const auto begin = static_cast<std::size_t>(each->position(0));
        made += text.substr(end, begin - end) + ((*each)[2] == name ? each->str(0) : each->str(1));
        end = begin + static_cast<std::size_t>(each->length(0));
    }
    return made + text.substr(end);
}

std::vector<std::string> nodes_of(const std::string& text) {
    static const std::regex kName(R"(\[node\([^\n]*\)\]\n\w+ (\w+)\()");
    std::vector<std::string> made;
    for (std::sregex_iterator each(text.begin(), text.end(), kName); each != std::sregex_iterator(); ++each)
        made.push_back((*each)[1]);
    return made;
}

TEST(HlslFiles, EveryLineHoldsEverywhere) {
    Bench bench;
    std::size_t lines = 0, drawn = 0;
    for (const auto& file : std::filesystem::directory_iterator("tests/hlsl")) {
        const std::string text = text_of(file.path());
        for (const std::string& name : nodes_of(text)) {
            SCOPED_TRACE(file.path().filename().string() + ": " + name);
            const std::map<std::string, std::string> files = {{"one.node.hlsl", with_node(text, name)}};
            CompileOptions options;
            options.files.read = [&](const std::string& path) -> std::optional<std::string> {
                const auto found = files.find(path);
                return found == files.end() ? std::nullopt : std::optional(found->second);
            };
            const NodeFileResult result = bench.compiler().check_node_file("one.node.hlsl", options);
            for (const Diagnostic& each : result.diagnostics) ADD_FAILURE() << to_text(each);
            EXPECT_FALSE(result.tests.empty());
            for (const NodeTest& test : result.tests) expect_passed(test, "the CPU");
            lines += result.tests.size();
            for (const Batch& batch : batches_of(result.tests)) {
                if (batch.tests[0].actual.empty()) continue;
                std::string node = R"("node": "./one.node.hlsl", "in": {)";
                for (std::size_t i = 0; i < batch.tests[0].arguments.size(); ++i)
                    node += (i > 0 ? ", " : "") + ("\"" + batch.tests[0].arguments[i].name + "\": \"") +
                            argument_text(batch.tests[0].arguments[i], i) + "\"";
                const auto material =
                    bench.compile(graph_of(batch, batch.tests[0].actual.size(), false, node + " }"), files);
                if (material) drawn += expect_passed_when_drawn(bench, *material, batch);
            }
        }
    }
    EXPECT_GT(lines, 0u);
    EXPECT_EQ(drawn, 2 * lines);
    bench.expect_silence();
}

}  // namespace
}  // namespace patina::witness
