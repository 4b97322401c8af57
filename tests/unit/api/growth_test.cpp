// Twice as much takes about twice as many steps. They are counted by the questions whether the work should go on, so
// that the speed of the machine plays no part.
#include <gtest/gtest.h>

#include <algorithm>

#include "patina/graph_diff.h"
#include "tests/unit/api/large_texts.h"

namespace patina {
namespace {

// A text with `count` of something, and what reads it.
struct Growing {
    const char* name;
    std::string (*text)(int count);
    std::vector<Diagnostic> (*work)(const std::string& text, const Limits& limits);
    bool is_error = false;  // it is refused: also in no more steps
};

std::vector<Diagnostic> compiled(const std::string& text, const Limits& limits) {
    CompileOptions options;
    options.limits = limits;
    return compiler().compile_text("g.graph.json", text, options).diagnostics;
}
std::vector<Diagnostic> checked(const std::string& text, const Limits& limits) {
    CompileOptions options;
    options.limits = limits;
    options.files.read = [&](const std::string&) { return std::optional<std::string>(text); };
    return compiler().check_node_file("g.node.hlsl", options).diagnostics;
}
std::vector<Diagnostic> formatted(const std::string& text, const Limits& limits) {
    return compiler().format("g.graph.json", text, limits).diagnostics;
}
// With a node more at the beginning, so that each of the others stands elsewhere.
std::vector<Diagnostic> compared(const std::string& text, const Limits& limits) {
    const std::size_t at = text.find(R"({ "id": "n0")");
    std::string other = text;
    other.insert(at, R"({ "id": "first", "expr": "1" }, )");
    return diff_graphs({"before", text}, {"after", other}, limits).diagnostics;
}

std::string many_properties(int count) {
    std::string text = R"({ "patina": 1, "workflow": "unlit", "properties": [ )";
    for (int i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + (R"({ "name": "p)" + std::to_string(i)) + R"(", "type": "float" })";
    return text + R"( ], "surface": { "color": "= $p)" + std::to_string(count - 1) + R"(" } })";
}
std::string unknown_nodes(int count) {
    std::string text = R"({ "patina": 1, "workflow": "unlit", "nodes": [ { "id": "n0", "expr": "1" })";
    for (int i = 1; i < count; ++i) text += R"(, { "id": "n)" + std::to_string(i) + R"(", "node": "Lrep" })";
    return text + R"( ], "surface": { "color": 1 } })";
}
std::string calls_that_double(int count) {
    return doubling(count) + node("return h0(uv.x);");
}

const Growing kGrowing[] = {
    {"a chain of nodes, compiled", chain_of_nodes, compiled},
    {"a chain of nodes, formatted", chain_of_nodes, formatted},
    {"a chain of nodes, compared", chain_of_nodes, compared},
    {"many properties", many_properties, compiled},
    {"nodes with unknown names", unknown_nodes, compiled, true},
    {"functions that call the next one twice", calls_that_double, checked, true},
};

TEST(Growth, TwiceAsMuchTakesTwiceAsManySteps) {
    for (const Growing& growing : kGrowing) {
        const auto questions_of = [&](int count) {
            int asked = 0;
            Limits limits;
            limits.cancelled = [&] { return ++asked, false; };
            const std::vector<Diagnostic> found = growing.work(growing.text(count), limits);
            const bool has_error = std::any_of(found.begin(), found.end(),
                                               [](const Diagnostic& each) { return each.severity == Severity::Error; });
            EXPECT_EQ(has_error, growing.is_error) << growing.name << "\n" << said(found);
            return asked;
        };
        questions_of(1000);  // what the compiler reads once and keeps
        const int few = questions_of(1000), many = questions_of(2000);
        EXPECT_GT(few, 1) << growing.name;
        EXPECT_LT(many, 2.6 * few + 4) << growing.name;
    }
}

}  // namespace
}  // namespace patina
