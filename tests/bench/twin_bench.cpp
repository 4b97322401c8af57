// Prints what the shaders of the source documents cost, and what their handwritten twins cost: instructions after
// `spirv-opt -O`, how many of them are in the loop over the lights, and bytes of text. Runs in the project's folder.
#include <cstdio>
#include <string>

#include "tests/bench/twins.h"

namespace patina::bench {
namespace {

double over(std::size_t made, std::size_t by_hand) {
    return by_hand > 0 ? double(made) / double(by_hand) : 0;
}

// A row of a Markdown table.
void print(std::string_view name, const char* stage, const Shader& made, const Shader& by_hand) {
    const StageCost ours = cost_of(made), theirs = cost_of(by_hand);
    std::printf("| %s | %s | %zu : %zu | %.2f | %zu : %zu | %zu : %zu | %.2f |\n", std::string(name).c_str(), stage,
                ours.instructions, theirs.instructions, over(ours.instructions, theirs.instructions), ours.per_light,
                theirs.per_light, ours.bytes, theirs.bytes, over(ours.bytes, theirs.bytes));
}

}  // namespace
}  // namespace patina::bench

int main() {
    using namespace patina::bench;
    std::printf(
        "| shader | stage | instructions | | for each light | bytes of text | |\n|---|---|---|---|---|---|---|\n");
    for (const Twin& twin : kTwins) {
        const patina::Result result = compiled(twin);
        const StageTexts made = stages_of(result), hand = by_hand(twin);
        if (!result.ok || hand.vertex.text.empty() || hand.fragment.text.empty()) {
            std::fprintf(stderr, "%s cannot be read: is this the project's folder?\n", std::string(twin.name).c_str());
            return 1;
        }
        print(twin.name, "vertex", made.vertex, hand.vertex);
        print(twin.name, "fragment", made.fragment, hand.fragment);
    }
}
