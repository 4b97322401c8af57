// The messages for a picture of a single material: nothing of it is visible.
#include "runtime/render/render_request.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace patina::runtime {
namespace {

std::vector<std::string> codes_of(const std::string& graph) {
    const Compiler compiler;
    RenderMachine machine;
    const RenderOutcome outcome =
        render(compiler, {.graph = graph, .size = 24, .samples = 2, .options = {.via = "cpu"}}, machine);
    EXPECT_TRUE(outcome.ok) << outcome.error;
    std::vector<std::string> codes;
    for (const Diagnostic& diagnostic : outcome.diagnostics) codes.push_back(diagnostic.code);
    return codes;
}

// The balloon's material lifts it above what the camera sees; a glow is seen before nothing, too.
TEST(RenderRequest, AnEmptyPictureIsToldOf) {
    const std::string folder = "examples/surfaces/";
    EXPECT_EQ(codes_of(folder + "balloon.graph.json"), std::vector<std::string>{"nothing-seen"});
    for (const char* seen : {"halo.graph.json", "facets.graph.json", "balloon.scene.json"})
        EXPECT_EQ(codes_of(folder + seen), std::vector<std::string>{}) << seen;
}

}  // namespace
}  // namespace patina::runtime
