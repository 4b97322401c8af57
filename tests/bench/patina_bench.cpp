// The compiler's benchmarks: the time of a warm compile (of one pass and of all), of the whole command, of the library
// and of very long graphs, and the length of the output. Google Benchmark's options apply; the table at the end is the
// best of the repetitions.
#include <fstream>
#include <iterator>

#include "compiler/cli/pages/model_cost.h"
#include "patina/cost.h"
#include "patina/patina.h"
#include "patina/validate.h"
#include "tests/bench/command.h"
#include "tests/bench/figures.h"
#include "tests/bench/long_graphs.h"

namespace patina::bench {
namespace {

// PATINA_EXAMPLES, PATINA_COMMAND and PATINA_SCRATCH are paths; bench.cmake gives them.
const std::string kRustedSteel = PATINA_EXAMPLES "/rusted_steel.graph.json";

// docs/graph-format.md: "A few lines more and the surface has a texture and a knob".
constexpr const char* kPainted = R"({
  "patina": 1,
  "name": "Painted metal",
  "workflow": "metallic-roughness",
  "properties": [
    { "name": "_MainTex", "type": "texture2d", "usage": "color", "default": "white" },
    { "name": "_Tint", "type": "color", "default": "#f2a38a" },
    { "name": "_Roughness", "type": "float", "default": 0.35, "range": [0, 1] }
  ],
  "nodes": [
    { "id": "albedo", "node": "SampleTexture2D", "in": { "texture": "$_MainTex" } }
  ],
  "surface": { "baseColor": "= albedo.rgb * $_Tint.rgb", "metallic": 1, "roughness": "$_Roughness" }
})";

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// JSON to printed GLSL and HLSL, with a library that is loaded. `passes`: a rendering path.
void compile(benchmark::State& state, const std::string& path, const std::string& text, const std::string& passes) {
    const Compiler compiler;
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = passes};
    for ([[maybe_unused]] auto iteration : state) {
        const Result result = compiler.compile_text(path, text, options);
        if (!result.ok) return state.SkipWithError("it does not compile");
        benchmark::DoNotOptimize(result.shaders.data());
    }
}

void load_library(benchmark::State& state) {
    for ([[maybe_unused]] auto iteration : state) {
        const Compiler compiler;
        benchmark::DoNotOptimize(&compiler);
    }
}

void run_command(benchmark::State& state, const std::vector<std::string>& words) {
    for ([[maybe_unused]] auto iteration : state)
        if (!run_patina(words).ok) return state.SkipWithError("patina fails");
}

void register_all() {
    const auto add = [](const std::string& name, auto function, auto... arguments) {
        benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MinTime(0.05)
            ->Repetitions(11)
            ->ReportAggregatesOnly(false);
    };
    add("library", load_library);
    const std::string one_pass = "forward";
    add("compile/painted", compile, "painted.graph.json", std::string(kPainted), one_pass);
    add("compile/rusted_steel", compile, kRustedSteel, read(kRustedSteel), one_pass);
    add("compile/rusted_steel, all passes", compile, kRustedSteel, read(kRustedSteel), std::string("all"));
    add("patina compile", run_command, std::vector<std::string>{"compile", kRustedSteel, "-q", "-o", PATINA_SCRATCH});
    for (const int nodes : {5'000, 10'000}) {
        const std::string count = std::to_string(nodes);
        add("chain/" + count, compile, "chain.graph.json", long_graph(Shape::Chain, nodes), one_pass);
        add("ladder/" + count, compile, "ladder.graph.json", long_graph(Shape::Ladder, nodes), one_pass);
        add("ladder on one line/" + count, compile, "ladder.graph.json", long_graph(Shape::Ladder, nodes, " "),
            one_pass);
    }
}

void print_sizes() {
    const Result result = Compiler().compile_file(kRustedSteel);
    for (const Shader& shader : result.shaders) {
        const bool is_promised = shader.stage == Stage::Fragment && shader.target == Target::Glsl;
        Figures::size(shader.file_name, shader.text.size(), is_promised ? 12 * 1024 : 0);
    }
}

// Of each model's fragment shader, as its page has it.
void print_costs() {
    const Compiler compiler;
    std::printf(
        "\nSPIR-V instructions of a lighting model's fragment shader after spirv-opt -O: for each pixel, for each "
        "light\n");
    for (const ModelInfo& model : compiler.lighting_models()) {
        const cli::ModelCost cost = cli::cost_of(compiler, model);
        std::printf("  %-24s %5u %5u\n", model.name.c_str(), cost.fragment.once.instructions,
                    cost.fragment.per_light.instructions);
    }
}

// Of each pass of the textured example: how many instructions its stages have, and the fragment stage for each light.
void print_passes() {
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = "all"};
    options.targets = {Target::Glsl};
    const Result result = Compiler().compile_file(kRustedSteel, options);
    std::printf("\nSPIR-V instructions of rusted_steel's passes after spirv-opt -O: for each vertex, pixel, light\n");
    for (const MeasuredPass& pass : measure(result))
        std::printf("  %-24s %5u %5u %5u\n", pass.name.c_str(), pass.cost.vertex.total().instructions,
                    pass.cost.fragment.once.instructions, pass.cost.fragment.per_light.instructions);
}

void print_figures(const Figures& figures) {
    std::printf("\n");
    figures.time("library", 0);
    figures.time("compile/painted", 0);
    figures.time("compile/rusted_steel", 1);
    figures.time("compile/rusted_steel, all passes", 0);
    figures.time("patina compile", 20);
    for (const std::string shape : {"chain/", "ladder/", "ladder on one line/"}) {
        figures.time(shape + "10000", 0);
        figures.ratio(shape + "5000", shape + "10000", 2.5);
    }
    print_sizes();
    print_passes();
    print_costs();
}

}  // namespace
}  // namespace patina::bench

int main(int argc, char** argv) {
    return patina::bench::run(argc, argv, patina::bench::register_all, patina::bench::print_figures);
}
