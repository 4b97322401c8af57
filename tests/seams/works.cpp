#include "works.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "patina/complaints.h"
#include "patina/engine_values.h"
#include "patina/export_mtlx.h"
#include "patina/graph_builder.h"
#include "patina/graph_diff.h"
#include "patina/graph_merge.h"
#include "patina/graph_view.h"
#include "patina/interpret.h"
#include "patina/output_name.h"
#include "patina/text_diff.h"
#include "patina/variants.h"

namespace patina::testing {
namespace {

// The tests run in the root of the sources.
std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

const std::string kChecker = "examples/graphs/checker.graph.json", kToon = "examples/graphs/toon.graph.json",
                  kBlend = "examples/graphs/height_blend.subgraph.json", kScene = "examples/scenes/beads.scene.json",
                  kNode = "examples/graphs/noise3.node.hlsl", kWrong = "wrong.graph.json", kModes = "modes.graph.json";

// Options that are made before allocations fail, as the others here are.
const CompileOptions kUsual;

// Three programs, for three modes.
constexpr const char* kModesText = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [{ "name": "_Mode", "type": "enum", "values": ["Dry", "Wet", "Icy"], "as": "variant" }],
  "surface": { "baseColor": "= float3(0.5, 0.4, 0.1 + 0.3 * float(int($_Mode)))", "roughness": 0.5 }
})json";
// An unknown node, an unknown port, and a value of the wrong type.
constexpr const char* kWrongText = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "nodes": [
    { "id": "a", "node": "Lrep", "in": { "a": 1 } },
    { "id": "b", "node": "Lerp", "in": { "x": 1, "t": "a" } }
  ],
  "surface": { "baseColor": "= b + float2(1, 2)", "roughness": "b" }
})json";

void add(std::string& text, const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& each : diagnostics) text += to_json(each) + "\n";
}

// Fills in what the diagnostics say.
Answer answer_of(std::string text, bool ok, std::vector<Diagnostic> diagnostics) {
    Answer answer{.text = std::move(text), .has_error = !ok, .diagnostics = std::move(diagnostics)};
    add(answer.text, answer.diagnostics);
    answer.is_without_memory =
        !ok && (answer.diagnostics.empty() || std::ranges::any_of(answer.diagnostics, [](const Diagnostic& each) {
                    return each.code == "out-of-memory";
                }));
    return answer;
}

std::string text_of(const Result& result) {
    std::string text;
    for (const Shader& shader : result.shaders) {
        text += shader.file_name + "\n" + shader.text;
        for (const LineOrigin& line : shader.line_map)
            text += line.node + " " + std::to_string(line.line) + " " + std::to_string(line.source_line) + "\n";
    }
    if (result.ok) text += result.reflection.to_json();
    for (const std::string& file : result.dependencies) text += file + "\n";
    for (const Dump& dump : result.dumps) text += dump.text;
    return text;
}

// A function whose results have diagnostics. `call` runs it, and `text` says what it gave. The call gets a copy of
// `given` for itself, which is made before allocations fail.
template <class Given, class Call, class Text>
Work with_result(std::string name, const Given& given, const Call& call, const Text& text) {
    return {std::move(name), [=](const Compiler& compiler, Plan& plan) {
                Given own = given;
                const auto result = within(plan, [&] { return call(compiler, own); });
                if (!result) return Answer{.escaped = "std::bad_alloc"};
                return answer_of(text(*result), result->ok, result->diagnostics);
            }};
}
template <class Call, class Text>
Work with_result(std::string name, const Call& call, const Text& text) {
    return with_result(
        std::move(name), 0, [=](const Compiler& compiler, int) { return call(compiler); }, text);
}

Work compiling(std::string name, const std::string& path, std::string text, const CompileOptions& options) {
    return with_result(
        std::move(name), text,
        [=](const Compiler& compiler, std::string& own) {
            return own.empty() ? compiler.compile_file(path, options)
                               : compiler.compile_text(path, std::move(own), options);
        },
        text_of);
}

// A function of plain values: a text, or nothing if it threw.
template <class Call>
Work with_value(std::string name, const Call& call) {
    return {std::move(name), [=](const Compiler& compiler, Plan& plan) {
                const auto text = within(plan, [&] { return call(compiler); });
                if (!text) return Answer{.is_without_memory = true};
                return Answer{.text = *text};
            }};
}

// The files of the texts above, and the disk for all others.
FileSystem files() {
    FileSystem made = disk();
    made.read = [on_disk = made.read](const std::string& path) -> std::optional<std::string> {
        return path == kModes ? std::optional<std::string>(kModesText) : on_disk(path);
    };
    made.exists = [on_disk = made.exists](const std::string& path) { return path == kModes || on_disk(path); };
    return made;
}

void add_compilations(std::vector<Work>& works) {
    const std::vector<Target> all = {Target::Glsl, Target::Hlsl, {"unity", "hlsl"}};
    works.push_back(compiling("AllEngines", kChecker, {}, {.targets = all}));
    works.push_back(compiling("OwnLighting", kToon, {}, {.targets = {Target::Glsl}}));
    works.push_back(compiling("Deferred", kChecker, {},
                              {.targets = {Target::Glsl}, .request = CompileOptions::Passes{.path = "deferred"}}));
    works.push_back(compiling(
        "Functions", kChecker, {},
        {.targets = {Target::Glsl, Target::Hlsl}, .request = CompileOptions::Functions{.prefix = "Checker_"}}));
    works.push_back(compiling("Preview", kToon, {},
                              {.targets = {Target::Glsl}, .request = CompileOptions::Preview{.port = "phase"}}));
    works.push_back(compiling("Part", kBlend, {}, {.targets = {Target::Glsl}, .accept_parts = true}));
    works.push_back(compiling("GivenText", kModes, kModesText, {.targets = {Target::Glsl}, .hashes = true}));
    works.push_back(compiling("Wrong", kWrong, kWrongText, {}));
    works.push_back(compiling("Dumps", kChecker, {},
                              {.targets = {Target::Glsl}, .dump = {"graph", "ir", "tidy"}, .keep_programs = true}));
    works.push_back(with_result(
        "Built",
        [](const Compiler& compiler) {
            GraphBuilder graph("dots.graph.json");
            try {  // the builder is a container, and throws as one
                graph.set("workflow", "metallic-roughness");
                graph.property("_Tint", PropertyType::Color, "#c9a27e");
                const GraphNode noise = graph.node("noise", "GradientNoise", {{"scale", 8}});
                graph.surface("baseColor", "= $_Tint.rgb * noise").surface("roughness", noise);
            } catch (const std::bad_alloc&) {
                return Result{};
            }
            return compiler.compile(graph, kUsual);
        },
        text_of));
}

void add_variants(std::vector<Work>& works) {
    const CompileOptions options{.targets = {Target::Glsl}, .files = files()};
    const auto plan_text = [](const VariantPlan& plan) {
        std::string text;
        for (std::size_t i = 0; i < plan.count; ++i)
            for (const auto& [name, value] : plan.combination(i)) text += name + "=" + value + "\n";
        return text;
    };
    for (const auto& [name, wanted] :
         {std::pair("PlanAll", VariantsWanted::All), std::pair("PlanReachable", VariantsWanted::Reachable)}) {
        works.push_back(with_result(
            name,
            [=, wanted = wanted](const Compiler& compiler) {
                return compiler.plan_variants(kModes, wanted, options, kVariantLimit);
            },
            plan_text));
    }
    const auto set_text = [](const VariantSet& set) {
        std::string text;
        for (const VariantProgram& program : set.programs) text += program.hash + text_of(program.result);
        for (const std::size_t program : set.program_of) text += std::to_string(program);
        return text;
    };
    works.push_back(with_result(
        "Variants", options,
        [=, plan = Compiler().plan_variants(kModes, VariantsWanted::All, options, kVariantLimit)](
            const Compiler& compiler, CompileOptions& own) {
            return compiler.compile_variants(kModes, plan, std::move(own));
        },
        set_text));
}

void add_other_results(std::vector<Work>& works) {
    works.push_back(with_result(
        "Scene", [](const Compiler& compiler) { return compiler.read_scene(kScene, kUsual); },
        [](const SceneResult& read) {
            std::string text = read.scene.name;
            for (const SceneMaterial& each : read.scene.materials) text += each.name + each.graph.path;
            for (const SceneObject& each : read.scene.objects) text += each.id + std::to_string(each.instances.size());
            return text;
        }));
    works.push_back(with_result(
        "NodeFile", [](const Compiler& compiler) { return compiler.check_node_file(kNode, kUsual); },
        [](const NodeFileResult& result) {
            std::string text = result.node.name + result.node.doc;
            for (const NodeTest& test : result.tests) text += test.text + (passed(test) ? " passed" : " failed");
            return text;
        }));
    const auto numbers = [](const EvalResult& result) {
        std::string text;
        for (const EvalOutput& output : result.outputs)
            for (const double value : output.values) text += std::to_string(value) + " ";
        return text;
    };
    works.push_back(with_result(
        "Evaluate", [](const Compiler& compiler) { return compiler.evaluate("GradientNoise", {}); }, numbers));
    works.push_back(with_result(
        "Expression", [](const Compiler& compiler) { return compiler.evaluate_expression("sqrt(2) * PI", {}); },
        numbers));
    const std::string toon = read(kToon);
    works.push_back(with_result(
        "Format", toon,
        [](const Compiler& compiler, std::string& text) { return compiler.format(kToon, std::move(text)); },
        [](const Compiler::Formatted& formatted) { return formatted.text; }));
    works.push_back(with_result(
        "View", [](const Compiler& compiler) { return view_graph(compiler, kToon, kUsual); },
        [](const GraphView& view) {
            std::string text;
            for (const GraphBox& box : view.boxes)
                for (const GraphPort& port : box.outputs) text += port.name + " " + port.type + "\n";
            return text + std::to_string(view.edges.size());
        }));
    works.push_back(with_result(
        "Mtlx", [](const Compiler& compiler) { return export_mtlx(compiler, kChecker); },
        [](const MtlxExport& made) { return made.text; }));
    const std::string reflection = Compiler().compile_file(kChecker).reflection.to_json();
    works.push_back(with_result(
        "ReadReflection", [=](const Compiler&) { return Reflection::from_json(reflection); },
        [](const ReadReflection& read) { return read.reflection.to_json(); }));
    works.push_back(with_result(
        "Matrix", [](const Compiler&) { return read_array_value(PropertyType::Float2x2, "[[1, 0], [0, 1]]"); },
        [](const ReadNumbers& read) { return std::to_string(read.numbers.size()); }));
}

void add_edits(std::vector<Work>& works) {
    const std::string base = read(kToon);
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = base;
        return text.replace(text.find(from), from.size(), to);
    };
    const std::string ours = with("#f4efe2", "#ffffff"), theirs = with("#2a7fc9", "#000000");
    const GraphVersion before{"a", base}, after{"b", theirs};
    works.push_back(with_result(
        "Diff", [=](const Compiler&) { return diff_graphs(before, after); },
        [](const GraphDiff& diff) {
            std::string text;
            for (const GraphChange& change : diff.changes) text += change.before + ">" + change.after + "\n";
            return text;
        }));
    works.push_back({"Merge", [=](const Compiler& compiler, Plan& plan) {
                         const MergeInput from{"base", base}, left{"ours", ours}, right{"theirs", theirs};
                         const MergeOptions options{.path = kToon};
                         const auto merged =
                             within(plan, [&] { return merge_graphs(compiler, from, left, right, options); });
                         if (!merged) return Answer{.escaped = "std::bad_alloc"};
                         const bool ok = merged->state == MergeState::Clean;
                         Answer answer = answer_of(merged->text, ok, merged->diagnostics);
                         // A merge that fails must not look like one that is done.
                         if (!ok && merged->state != MergeState::Unreadable) answer.escaped = "another state";
                         return answer;
                     }});
}

}  // namespace

std::vector<Work> works_with_results() {
    std::vector<Work> works;
    add_compilations(works);
    add_variants(works);
    add_other_results(works);
    add_edits(works);
    return works;
}

std::vector<Work> works_with_values() {
    std::vector<Work> works;
    works.push_back(with_value("Lists", [](const Compiler& compiler) {
        std::string text;
        for (const NodeInfo& node : compiler.nodes()) text += node.name + node.doc;
        for (const SemanticInfo& each : compiler.semantics()) text += each.name;
        for (const auto* models : {&compiler.workflows(), &compiler.lighting_models()})
            for (const ModelInfo& model : *models) text += model.name + model.doc;
        for (const PathInfo& path : compiler.paths()) text += path.name + path.doc;
        for (const EngineInfo& engine : compiler.engines()) text += engine.name + engine.doc;
        return text;
    }));
    works.push_back(with_value("Keys", [](const Compiler& compiler) {
        return compiler.cache_key(kChecker) + compiler.library_hash() + compiler.cache_key("m", kModesText, {});
    }));
    works.push_back(with_value("Schema", [](const Compiler& compiler) { return compiler.schema(); }));
    works.push_back(with_value("Advice", [](const Compiler& compiler) {
        return compiler.node_advice("Lrep") + suggestion("glsll", {"glsl", "hlsl"}) + output_name("a b.graph.json") +
               std::to_string(compiler.targets("unity").size()) + std::to_string(hints().size());
    }));
    works.push_back(with_value("Tests", [](const Compiler& compiler) {
        std::string text;
        for (const NodeTest& test : compiler.tests("Lerp")) text += test.text + (passed(test) ? " passed" : " failed");
        return text;
    }));
    works.push_back(with_value("LibraryDiagnostics", [](const Compiler& compiler) {
        return std::to_string(compiler.library_diagnostics().size());
    }));
    works.push_back(with_value(
        "EngineBlocks", [](const Compiler& compiler) { return std::to_string(engine_blocks(compiler).size()); }));
    works.push_back(with_value("Texts", [](const Compiler&) {
        const Diagnostic wrong = complaint(Complaint::CannotRead, {"rust.png", "no such file"});
        return to_text(wrong) + to_json(wrong) + std::to_string(differences("a\nb\n", "a\nc\n").size());
    }));
    const std::shared_ptr<const Program> program =
        Compiler().compile_file(kChecker, {.targets = {}, .keep_programs = true}).program;
    works.push_back(with_value("Interpreter", [=](const Compiler&) {
        Interpreter fragment(*program, "forward", Stage::Fragment, Precision::Double);
        std::string text;
        for (const auto& lane : fragment.run({}).lanes)
            for (const double value : lane) text += std::to_string(value) + " ";
        return text;
    }));
    return works;
}

}  // namespace patina::testing
