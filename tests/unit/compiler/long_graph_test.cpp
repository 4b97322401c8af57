// Graphs of ten thousand nodes are graphs like any other: no recursion over their length, and nothing that is made for
// each node is as large as the graph.
#include <gtest/gtest.h>

#include <algorithm>

#include "patina/patina.h"
#include "tests/bench/long_graphs.h"

namespace patina {
namespace {

using bench::long_graph;
using bench::Shape;

const Shader& fragment(const Result& result, Target target) {
    const auto is_wanted = [&](const Shader& s) { return s.stage == Stage::Fragment && s.target == target; };
    return *std::find_if(result.shaders.begin(), result.shaders.end(), is_wanted);
}

auto lines_of(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

class LongGraph : public testing::TestWithParam<Shape> {};

TEST_P(LongGraph, PrintsOneStatementForEachNode) {
    const Compiler compiler;
    const Result small = compiler.compile_text("long.graph.json", long_graph(GetParam(), 100));
    const Result large = compiler.compile_text("long.graph.json", long_graph(GetParam(), 10'000));
    ASSERT_TRUE(small.ok && large.ok);
    for (const Target& target : {Target::Glsl, Target::Hlsl}) {
        const std::string& text = fragment(large, target).text;
        // A comment, a statement and a gap.
        EXPECT_EQ(lines_of(text) - lines_of(fragment(small, target).text), 3 * 9'900);
        EXPECT_NE(text.find(" n9999 = n9998 * "), std::string::npos);
    }
}

TEST_P(LongGraph, IsKeptForTheInterpreter) {
    CompileOptions options;
    options.keep_programs = true;
    const Result result = Compiler().compile_text("long.graph.json", long_graph(GetParam(), 10'000), options);
    ASSERT_TRUE(result.ok);
    EXPECT_NE(result.program, nullptr);
}

// Quadratic memory and time would show here first: 40,000 nodes on a line of 3 MB.
TEST_P(LongGraph, MayStandOnOneLine) {
    const Result result = Compiler().compile_text("long.graph.json", long_graph(GetParam(), 40'000, " "));
    ASSERT_TRUE(result.ok);
    const std::vector<LineOrigin>& map = fragment(result, Target::Glsl).line_map;
    const auto last = std::find_if(map.begin(), map.end(), [](const LineOrigin& o) { return o.node == "n39999"; });
    ASSERT_NE(last, map.end());
    EXPECT_EQ(last->source_line, 1);
    EXPECT_GT(last->source_column, 2'000'000);
    EXPECT_EQ(last->source_text, "");
}

INSTANTIATE_TEST_SUITE_P(Shapes, LongGraph, testing::Values(Shape::Chain, Shape::Ladder),
                         [](const auto& shape) { return shape.param == Shape::Chain ? "Chain" : "Ladder"; });

}  // namespace
}  // namespace patina
