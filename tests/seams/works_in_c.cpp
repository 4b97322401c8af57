// The functions of patina_c.h, as works.h has them.
#include <algorithm>

#include "patina/patina_c.h"
#include "works.h"

namespace patina::testing {
namespace {

constexpr const char* kGraph = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [{ "name": "_Wet", "type": "bool", "as": "variant" }],
  "nodes": [{ "id": "half", "node": "./half.subgraph.json" }],
  "surface": { "baseColor": "= lerp(float3(0.2, 0.3, 0.4), half * float3(1, 1, 1), float($_Wet))" }
})json";
constexpr const char* kPart = R"({ "patina": 1, "kind": "subgraph", "outputs": { "out": 0.5 } })";

void read(void*, const char* path, patina_reply* reply) {
    const std::string_view name = path;
    if (name.ends_with("half.subgraph.json")) patina_reply_text(reply, kPart, std::char_traits<char>::length(kPart));
    if (name.ends_with("g.graph.json")) patina_reply_text(reply, kGraph, std::char_traits<char>::length(kGraph));
}

constexpr patina_callbacks kFiles = {
    .user = nullptr, .read = read, .exists = nullptr, .resolve = nullptr, .cancelled = nullptr};

using Freed = std::unique_ptr<patina_compiler, void (*)(patina_compiler*)>;

// The C functions have compilers of their own. `call` adds what it gets to the text, and returns a status.
template <class Call>
Work in_c(std::string name, const Call& call) {
    return {std::move(name), [=](const Compiler&, Plan& plan) {
                patina_compiler* made = nullptr;
                patina_compiler_create(PATINA_C_ABI, nullptr, 0, &made);
                const Freed compiler(made, patina_compiler_free);
                std::string text;
                text.reserve(std::size_t{1} << 20);  // that the test needs no memory of its own
                const auto status = within(plan, [&] { return call(made, text); });
                Answer answer{.text = text};
                if (!status) return Answer{.escaped = "std::bad_alloc"};
                answer.has_error = *status != PATINA_OK;
                answer.is_without_memory = *status == PATINA_OUT_OF_MEMORY;
                return answer;
            }};
}

}  // namespace

std::vector<Work> works_in_c() {
    std::vector<Work> works;
    works.push_back(in_c("CCompile", [](patina_compiler* compiler, std::string& text) {
        patina_result* result = nullptr;
        const patina_status status = patina_compile_file(
            compiler, "g.graph.json", R"({"targets": ["glsl"], "switches": {"_Wet": true}})", &kFiles, &result);
        text += patina_result_messages(result);
        for (size_t i = 0; i < patina_result_shader_count(result); ++i) text += patina_result_shader(result, i)->text;
        text += patina_result_reflection(result);
        patina_result_free(result);
        return status;
    }));
    works.push_back(in_c("CKeys", [](patina_compiler* compiler, std::string& text) {
        char key[PATINA_KEY_SIZE];
        patina_status status = patina_cache_key(compiler, "g.graph.json", nullptr, 0, nullptr, &kFiles, key);
        text += key;
        if (status == PATINA_OK) status = patina_library_hash(compiler, key);
        text += key;
        return status;
    }));
    works.push_back(in_c("CVariants", [](patina_compiler* compiler, std::string& text) {
        patina_plan* plan = nullptr;
        patina_variants* variants = nullptr;
        patina_status status = patina_plan_variants(compiler, "g.graph.json", "all", PATINA_VARIANT_LIMIT,
                                                    R"({"targets": ["glsl"]})", &kFiles, &plan);
        if (status == PATINA_OK) status = patina_compile_variants(compiler, plan, &variants);
        for (size_t i = 0; i < patina_plan_count(plan); ++i) text += patina_plan_combination(plan, i);
        for (size_t i = 0; i < patina_variants_program_count(variants); ++i)
            text += patina_result_shader(patina_variants_program(variants, i), 0)->text;
        patina_variants_free(variants);
        patina_plan_free(plan);
        return status;
    }));
    works.push_back(in_c("CScene", [](patina_compiler* compiler, std::string& text) {
        patina_scene* scene = nullptr;
        const patina_status status =
            patina_read_scene(compiler, "examples/scenes/beads.scene.json", nullptr, nullptr, &scene);
        text += patina_scene_json(scene);
        patina_scene_free(scene);
        return status;
    }));
    works.push_back(in_c("CLists", [](patina_compiler* compiler, std::string& text) {
        const patina_node* nodes = nullptr;
        const patina_path* paths = nullptr;
        const patina_engine* engines = nullptr;
        size_t count = 0;
        if (const patina_status status = patina_nodes(compiler, &nodes, &count); status != PATINA_OK) return status;
        text += std::to_string(count);
        if (const patina_status status = patina_paths(compiler, &paths, &count); status != PATINA_OK) return status;
        text += paths[0].json;
        if (const patina_status status = patina_engines(compiler, &engines, &count); status != PATINA_OK) return status;
        text += engines[0].json;
        return PATINA_OK;
    }));
    works.push_back(in_c("CCreate", [](patina_compiler*, std::string& text) {
        const char* const node = "/// Dots.\n[node(\"Procedural/Dots\")]\nfloat Dots(float s = 4) { return s; }\n";
        const patina_library_file file{
            .name = "mine/dots.node.hlsl", .text = node, .size = std::char_traits<char>::length(node)};
        patina_compiler* made = nullptr;
        const patina_status status = patina_compiler_create(PATINA_C_ABI, &file, 1, &made);
        text += made ? "made" : "";
        patina_compiler_free(made);
        return status;
    }));
    return works;
}

}  // namespace patina::testing
