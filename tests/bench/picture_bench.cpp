// Benchmarks of what draws: a preview, 20 snapshots with the memory that they take, prefiltering, an import and a bake.
// Google Benchmark's options apply; the table at the end is the best of the repetitions.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "runtime/lighting/environment_file.h"
#include "runtime/picture/image.h"
#include "runtime/render/render_request.h"
#include "tests/bench/command.h"
#include "tests/bench/figures.h"

namespace patina::bench {
namespace {

namespace fs = std::filesystem;

// PATINA_EXAMPLES, PATINA_COMMAND and PATINA_SCRATCH are paths; bench.cmake gives them.
const std::string kScratch = PATINA_SCRATCH "/pictures/";
const std::string kRustedSteel = PATINA_EXAMPLES "/rusted_steel.graph.json";
std::size_t memory_of_snapshots = 0;

void run_command(benchmark::State& state, const std::vector<std::string>& words, std::size_t* most_bytes) {
    for ([[maybe_unused]] auto iteration : state) {
        const CommandRun run = run_patina(words);
        if (!run.ok) return state.SkipWithError("patina fails");
        if (most_bytes) *most_bytes = std::max(*most_bytes, run.most_bytes);
    }
}

// It overwrites nothing.
void import_model(benchmark::State& state, const std::string& model, const std::string& folder) {
    for ([[maybe_unused]] auto iteration : state) {
        state.PauseTiming();
        fs::remove_all(folder);
        state.ResumeTiming();
        if (!run_patina({"import", model, "-q", "-o", folder}).ok) return state.SkipWithError("patina fails");
    }
}

// 20 snapshots of 256 x 256 pixels, with their references: the examples as balls, and then as rings.
bool make_snapshots(const std::string& folder) {
    fs::create_directories(folder);
    int count = 0;
    for (const char* mesh : {"sphere", "torus"}) {
        for (const fs::directory_entry& entry : fs::directory_iterator(PATINA_EXAMPLES)) {
            const std::string graph = entry.path().string();
            if (!graph.ends_with(".graph.json") || count == 20) continue;
            std::ofstream(fs::path(folder) / (std::to_string(count++) + ".snapshot.json"))
                << R"({ "patina": 1, "size": 256, "mesh": ")" << mesh << R"(", "graph": ")" << graph << "\" }";
        }
    }
    return count == 20 && run_patina({"snapshot", folder, "--update", "--quiet"}).ok;
}

// A sky with a small bright sun, 1024 x 512.
bool make_panorama(const std::string& path) {
    runtime::Image image = runtime::make_image(1024, 512);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const float up = std::cos(std::numbers::pi_v<float> * (float(y) + 0.5f) / float(image.height));
            const bool is_sun = std::hypot(float(x) - 300, float(y) - 120) < 6;
            const float light = is_sun ? 500.0f : 0.3f + 0.4f * up;
            const auto pixel = image.at(x, y);
            pixel[0] = light, pixel[1] = light, pixel[2] = 1.2f * light;
        }
    }
    return runtime::save_exr(path, image).empty();
}

// A preview as an editor draws it: the picture of a material that changes all the time.
void preview(benchmark::State& state) {
    static const Compiler compiler;
    static runtime::RenderMachine machine;
    runtime::RenderRequest request{
        .graph = kRustedSteel, .size = 256, .samples = 1, .environment = kScratch + "sky.exr"};
    double roughness = 0;
    for ([[maybe_unused]] auto iteration : state) {
        request.overrides["_Polish"] = std::to_string(roughness = std::fmod(roughness + 0.1, 1.0));
        if (!runtime::render(compiler, request, machine).ok) return state.SkipWithError("no picture");
    }
}

// `is_kept`: the map of an earlier start is found.
void prefilter(benchmark::State& state, bool is_kept) {
    setenv("XDG_CACHE_HOME", (kScratch + "cache").c_str(), 1);
    for ([[maybe_unused]] auto iteration : state) {
        state.PauseTiming();
        if (!is_kept) fs::remove_all(kScratch + "cache");
        runtime::load_environment({.path = kScratch + "sky.exr", .rotation = 1});  // a process keeps its last one
        state.ResumeTiming();
        const auto loaded = runtime::load_environment({.path = kScratch + "sky.exr"});
        if (!loaded) return state.SkipWithError(loaded.error.c_str());
        benchmark::DoNotOptimize(loaded.value->map());
    }
}

void put(std::string& bytes, const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// A wavy square of 50 MB: positions, normals, coordinates and triangles.
void make_model(const std::string& path) {
    constexpr std::uint32_t kSide = 945;  // vertices
    std::string buffer;
    buffer.reserve(55'000'000);
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
        const float x = float(i % kSide) / (kSide - 1), y = float(i / kSide) / (kSide - 1);
        for (const float value : {x, y, 0.05f * std::sin(40 * x), 0.0f, 0.0f, 1.0f, x, y}) put(buffer, value);
    }
    const std::size_t vertices = buffer.size();
    for (std::uint32_t row = 0; row + 1 < kSide; ++row) {
        for (std::uint32_t i = row * kSide; i + 1 < (row + 1) * kSide; ++i)
            for (const std::uint32_t index : {i, i + 1, i + kSide, i + 1, i + kSide + 1, i + kSide}) put(buffer, index);
    }
    const std::string count = std::to_string(kSide * kSide);
    std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                       R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},)"
                       R"("indices":3,"material":0}]}],"materials":[{"name":"wavy"}],"accessors":[)"
                       R"({"bufferView":0,"componentType":5126,"count":)" +
                       count + R"(,"type":"VEC3","min":[0,0,-0.05],"max":[1,1,0.05]},)" +
                       R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":)" + count +
                       R"(,"type":"VEC3"},{"bufferView":0,"byteOffset":24,"componentType":5126,"count":)" + count +
                       R"(,"type":"VEC2"},{"bufferView":1,"componentType":5125,"count":)" +
                       std::to_string((buffer.size() - vertices) / 4) +
                       R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteStride":32,"byteLength":)" +
                       std::to_string(vertices) + R"(},{"buffer":0,"byteOffset":)" + std::to_string(vertices) +
                       R"(,"byteLength":)" + std::to_string(buffer.size() - vertices) +
                       R"(}],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + "}]}";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string file = "glTF";
    put(file, std::uint32_t{2});
    put(file, std::uint32_t(12 + 8 + text.size() + 8 + buffer.size()));
    put(file, std::uint32_t(text.size()));
    file += "JSON" + text;
    put(file, std::uint32_t(buffer.size()));
    file += std::string("BIN\0", 4) + buffer;
    std::ofstream(path, std::ios::binary) << file;
}

void register_all() {
    const auto add = [](const std::string& name, int repetitions, auto function, auto... arguments) {
        benchmark::RegisterBenchmark(name.c_str(), function, arguments...)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime()
            ->MinTime(0.01)
            ->Repetitions(repetitions)
            ->ReportAggregatesOnly(false);
    };
    using Words = std::vector<std::string>;
    fs::remove_all(kScratch);
    fs::create_directories(kScratch);
    std::size_t* const nothing = nullptr;
    if (make_panorama(kScratch + "sky.exr")) {
        add("prefiltering 1024 x 512", 3, prefilter, false);
        add("the same, kept", 11, prefilter, true);
        add("preview of 256 x 256", 11, preview);
    }
    if (make_snapshots(kScratch + "snapshots"))
        add("20 snapshots", 5, run_command, Words{"snapshot", kScratch + "snapshots", "-q"}, &memory_of_snapshots);
    make_model(kScratch + "wavy.glb");
    add("import of 50 MB", 5, import_model, kScratch + "wavy.glb", kScratch + "imported");
    add("bake of 1024 x 1024", 3, run_command,
        Words{"bake", kRustedSteel, "--size", "1024", "-q", "-o", kScratch + "baked"}, nothing);
}

void print_figures(const Figures& figures) {
    std::printf("\n");
    figures.time("preview of 256 x 256", 60);
    figures.time("20 snapshots", 3000);
    if (memory_of_snapshots > 0) Figures::size("memory of 20 snapshots", memory_of_snapshots, std::size_t{600} << 20);
    figures.time("prefiltering 1024 x 512", 8000);
    figures.time("the same, kept", 50);
    figures.time("import of 50 MB", 1000);
    figures.time("bake of 1024 x 1024", 3000);
}

}  // namespace
}  // namespace patina::bench

int main(int argc, char** argv) {
    return patina::bench::run(argc, argv, patina::bench::register_all, patina::bench::print_figures);
}
