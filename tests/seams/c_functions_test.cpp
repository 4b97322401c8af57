// patina_c.h: what it gives of scenes, variants and lists, and what it refuses.
#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include "patina/patina.h"
#include "patina/patina_c.h"

namespace patina {
namespace {

constexpr std::string_view kGraph = R"json({
  "patina": 1,
  "workflow": "metallic-roughness",
  "properties": [
    { "name": "_Mode", "type": "enum", "values": ["Dry", "Wet", "Icy"], "as": "variant" },
    { "name": "_Same", "type": "bool", "as": "variant" }
  ],
  "surface": { "baseColor": "= float3(0.5, 0.4, 0.1 + 0.3 * float(int($_Mode)))" }
})json";

template <class Object>
using Owned = std::unique_ptr<Object, void (*)(Object*)>;

class CFunctions : public ::testing::Test {
protected:
    CFunctions() : compiler_(nullptr, patina_compiler_free) {
        patina_compiler* made = nullptr;
        EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, nullptr, 0, &made), PATINA_OK);
        compiler_.reset(made);
    }
    patina_compiler* compiler() const { return compiler_.get(); }

    patina_status compile(const patina_callbacks& callbacks, std::string& messages) const {
        patina_result* result = nullptr;
        const patina_status status = patina_compile_file(compiler(), "g.graph.json", nullptr, &callbacks, &result);
        messages = patina_result_messages(result);
        patina_result_free(result);
        return status;
    }

private:
    Owned<patina_compiler> compiler_;
};

rapidjson::Document parsed(const char* text) {
    rapidjson::Document json;
    json.Parse(text);
    EXPECT_FALSE(json.HasParseError()) << text;
    return json;
}

void read(void*, const char* path, patina_reply* reply) {
    if (std::string_view(path) == "g.graph.json") patina_reply_text(reply, kGraph.data(), kGraph.size());
}

patina_callbacks files() {
    patina_callbacks made{};
    made.read = read;
    return made;
}

TEST_F(CFunctions, SizesThatNothingCanHave) {
    constexpr std::size_t kHuge = std::size_t{PTRDIFF_MAX} + 1;
    patina_compiler* made = nullptr;
    patina_library_file file{.name = "a.node.hlsl", .text = "", .size = kHuge};
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, nullptr, 1, &made), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, &file, SIZE_MAX / 2, &made), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, &file, 1, &made), PATINA_BAD_ARGUMENT);
    file = {.name = "a.node.hlsl", .text = nullptr, .size = 4};
    EXPECT_EQ(patina_compiler_create(PATINA_C_ABI, &file, 1, &made), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(made, nullptr);

    patina_result* result = nullptr;
    for (const std::size_t size : {kHuge, std::size_t{SIZE_MAX}})
        EXPECT_EQ(patina_compile(compiler(), "g", "{}", size, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile(compiler(), "g", nullptr, 2, nullptr, nullptr, &result), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(result, nullptr);
    char key[PATINA_KEY_SIZE] = "x";
    EXPECT_EQ(patina_cache_key(compiler(), "g", "{}", kHuge, nullptr, nullptr, key), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_cache_key(compiler(), "g", nullptr, 2, nullptr, nullptr, key), PATINA_BAD_ARGUMENT);
    EXPECT_STREQ(key, "");

    patina_callbacks callbacks{};
    callbacks.read = [](void*, const char*, patina_reply* reply) { patina_reply_text(reply, nullptr, 7); };
    std::string messages;
    EXPECT_EQ(compile(callbacks, messages), PATINA_HAS_ERRORS);
    EXPECT_NE(messages.find("a text of an impossible size"), std::string::npos) << messages;
}

TEST_F(CFunctions, NullWhereAnObjectIsWanted) {
    EXPECT_EQ(patina_plan_variants(nullptr, "g", "all", 1, nullptr, nullptr, nullptr), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_compile_variants(compiler(), nullptr, nullptr), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_read_scene(compiler(), nullptr, nullptr, nullptr, nullptr), PATINA_BAD_ARGUMENT);
    const patina_node* nodes = nullptr;
    std::size_t count = 1;
    EXPECT_EQ(patina_nodes(nullptr, &nodes, &count), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(count, 0u);
    EXPECT_EQ(patina_nodes(compiler(), nullptr, &count), PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_plan_count(nullptr), 0u);
    EXPECT_STREQ(patina_plan_diagnostics(nullptr), "[]");
    EXPECT_EQ(patina_variants_program(nullptr, 0), nullptr);
    EXPECT_STREQ(patina_scene_json(nullptr), "");
    patina_plan_free(nullptr);
    patina_variants_free(nullptr);
    patina_scene_free(nullptr);
}

TEST_F(CFunctions, EachStatusHasItsText) {
    EXPECT_STREQ(patina_status_text(PATINA_BAD_ARGUMENT),
                 "a pointer is null that must not be, or a size or a word is impossible");
    EXPECT_STREQ(patina_status_text(static_cast<patina_status>(99)), "an unknown status");
}

// Callbacks of C++ may throw.
TEST_F(CFunctions, CallbacksThatThrow) {
    std::string messages;
    patina_callbacks callbacks{};
    callbacks.read = [](void*, const char*, patina_reply*) { throw std::runtime_error("the disk is on fire"); };
    EXPECT_EQ(compile(callbacks, messages), PATINA_HAS_ERRORS);
    EXPECT_NE(messages.find("the disk is on fire"), std::string::npos) << messages;
    callbacks.read = [](void*, const char*, patina_reply*) { throw 7; };
    EXPECT_EQ(compile(callbacks, messages), PATINA_HAS_ERRORS);
    EXPECT_NE(messages.find("[cannot-read]"), std::string::npos) << messages;
    callbacks.read = [](void*, const char*, patina_reply*) { throw std::bad_alloc(); };
    EXPECT_EQ(compile(callbacks, messages), PATINA_OUT_OF_MEMORY);
    callbacks = files();
    callbacks.cancelled = [](void*) -> int { throw std::runtime_error("the user has gone"); };
    EXPECT_EQ(compile(callbacks, messages), PATINA_HAS_ERRORS);
    EXPECT_NE(messages.find("the user has gone [cancelled]"), std::string::npos) << messages;
    callbacks = files();
    EXPECT_EQ(compile(callbacks, messages), PATINA_OK) << messages;
}

TEST_F(CFunctions, Variants) {
    const patina_callbacks callbacks = files();
    patina_plan* made = nullptr;
    EXPECT_EQ(patina_plan_variants(compiler(), "g.graph.json", "some", 8, nullptr, &callbacks, &made),
              PATINA_BAD_ARGUMENT);
    EXPECT_EQ(patina_plan_variants(compiler(), "g.graph.json", "all", 5, nullptr, &callbacks, &made),
              PATINA_HAS_ERRORS);
    EXPECT_NE(std::string(patina_plan_messages(made)).find("[too-many]"), std::string::npos)
        << patina_plan_messages(made);
    EXPECT_EQ(patina_plan_count(made), 0u);
    patina_plan_free(made);

    ASSERT_EQ(patina_plan_variants(compiler(), "g.graph.json", "all", 8, R"({"targets": ["glsl"]})", &callbacks, &made),
              PATINA_OK);
    const Owned<patina_plan> plan(made, patina_plan_free);
    ASSERT_EQ(patina_plan_count(made), 6u);
    EXPECT_STREQ(patina_plan_combination(made, 1), R"({"_Mode":"Dry","_Same":"true"})");
    EXPECT_EQ(patina_plan_combination(made, 6), nullptr);
    const rapidjson::Document axes = parsed(patina_plan_axes(made));
    ASSERT_EQ(axes.Size(), 2u);
    EXPECT_STREQ(axes[0]["property"].GetString(), "_Mode");
    EXPECT_EQ(axes[0]["values"].Size(), 3u);
    EXPECT_STREQ(axes[0]["default"].GetString(), "Dry");

    patina_variants* compiled = nullptr;
    ASSERT_EQ(patina_compile_variants(compiler(), made, &compiled), PATINA_OK);
    const Owned<patina_variants> variants(compiled, patina_variants_free);
    ASSERT_EQ(patina_variants_program_count(compiled), 3u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(patina_variants_program_of(compiled, i), i / 2);
    EXPECT_EQ(patina_variants_program_of(compiled, 6), static_cast<std::size_t>(-1));
    for (std::size_t i = 0; i < 3; ++i) {
        const patina_result* program = patina_variants_program(compiled, i);
        ASSERT_GT(patina_result_shader_count(program), 0u);
        EXPECT_EQ(std::string(patina_variants_hash(compiled, i)).size(), 32u);
        parsed(patina_result_reflection(program));
    }
    EXPECT_STRNE(patina_variants_hash(compiled, 0), patina_variants_hash(compiled, 1));
    EXPECT_EQ(patina_variants_program(compiled, 3), nullptr);
    EXPECT_EQ(patina_variants_dependency_count(compiled), 1u);
    EXPECT_STREQ(patina_variants_dependency(compiled, 0), "g.graph.json");
    EXPECT_EQ(patina_variants_missing_count(compiled), 0u);
    EXPECT_EQ(patina_variants_missing(compiled, 0), nullptr);
}

// A file that appears where one was looked for in vain would be read instead.
TEST_F(CFunctions, VariantsSayWhatWasLookedForInVain) {
    patina_callbacks callbacks{};
    callbacks.read = [](void*, const char* path, patina_reply* reply) {
        constexpr std::string_view kText = R"({ "patina": 1, "workflow": "unlit",
            "nodes": [{ "id": "a", "node": "./tints/warm.node.hlsl" }], "surface": { "color": "= a" } })";
        constexpr std::string_view kNode = "[node(\"Test/Warm\")]\nfloat Warm(float x = 0.5) { return x; }\n";
        if (std::string_view(path) == "g.graph.json") patina_reply_text(reply, kText.data(), kText.size());
        if (std::string_view(path) == "second/tints/warm.node.hlsl")
            patina_reply_text(reply, kNode.data(), kNode.size());
    };
    constexpr const char* kOptions = R"({"targets": ["glsl"], "includeDirs": ["first", "second"]})";
    patina_plan* made = nullptr;
    ASSERT_EQ(patina_plan_variants(compiler(), "g.graph.json", "all", 8, kOptions, &callbacks, &made), PATINA_OK)
        << patina_plan_messages(made);
    const Owned<patina_plan> plan(made, patina_plan_free);
    patina_variants* compiled = nullptr;
    ASSERT_EQ(patina_compile_variants(compiler(), made, &compiled), PATINA_OK) << patina_variants_messages(compiled);
    const Owned<patina_variants> variants(compiled, patina_variants_free);
    ASSERT_EQ(patina_variants_dependency_count(compiled), 2u);
    EXPECT_STREQ(patina_variants_dependency(compiled, 1), "second/tints/warm.node.hlsl");
    ASSERT_EQ(patina_variants_missing_count(compiled), 2u);
    EXPECT_STREQ(patina_variants_missing(compiled, 0), "first/tints/warm.node.hlsl");
    EXPECT_STREQ(patina_variants_missing(compiled, 1), "tints/warm.node.hlsl");
    EXPECT_EQ(patina_variants_missing(compiled, 2), nullptr);
}

TEST_F(CFunctions, Scenes) {
    patina_scene* made = nullptr;
    ASSERT_EQ(patina_read_scene(compiler(), "examples/scenes/beads.scene.json", nullptr, nullptr, &made), PATINA_OK)
        << patina_scene_messages(made);
    const Owned<patina_scene> scene(made, patina_scene_free);
    const rapidjson::Document json = parsed(patina_scene_json(made));
    EXPECT_STREQ(json["name"].GetString(), "Beads");
    EXPECT_EQ(json["camera"]["fov"].GetDouble(), 33);
    EXPECT_EQ(json["camera"]["far"].GetDouble(), 100);
    EXPECT_STREQ(json["lights"][0]["type"].GetString(), "directional");
    EXPECT_EQ(json["lights"][0]["shadow"]["strength"].GetDouble(), 1);
    EXPECT_EQ(json["objects"][1]["instances"].Size(), 100u);
    EXPECT_STREQ(json["objects"][1]["material"].GetString(), "bead");
    ASSERT_EQ(patina_scene_material_count(made), 2u);
    EXPECT_STREQ(patina_scene_graph(made, 1), json["materials"][1]["graph"].GetString());
    EXPECT_EQ(patina_scene_graph(made, 2), nullptr);
    EXPECT_EQ(patina_scene_dependency_count(made), 1u);
    EXPECT_STREQ(patina_scene_dependency(made, 0), "examples/scenes/beads.scene.json");
    EXPECT_EQ(patina_scene_dependency(made, 1), nullptr);
    EXPECT_EQ(patina_scene_missing_count(made), 0u);
    EXPECT_EQ(patina_scene_missing(made, 0), nullptr);
    patina_result* result = nullptr;
    EXPECT_EQ(patina_compile_file(compiler(), patina_scene_graph(made, 1), nullptr, nullptr, &result), PATINA_OK);
    patina_result_free(result);

    EXPECT_EQ(patina_read_scene(compiler(), "no.scene.json", nullptr, nullptr, &made), PATINA_HAS_ERRORS);
    EXPECT_STREQ(patina_scene_json(made), "");
    EXPECT_NE(std::string(patina_scene_messages(made)).find("no.scene.json"), std::string::npos);
    ASSERT_EQ(patina_scene_missing_count(made), 1u);
    EXPECT_STREQ(patina_scene_missing(made, 0), "no.scene.json");
    EXPECT_EQ(patina_scene_missing(made, 1), nullptr);
    patina_scene_free(made);
}

// Each list says what the C++ one says.
TEST_F(CFunctions, Lists) {
    const Compiler same;
    const patina_node* nodes = nullptr;
    std::size_t count = 0;
    ASSERT_EQ(patina_nodes(compiler(), &nodes, &count), PATINA_OK);
    ASSERT_EQ(count, same.nodes().size());
    for (std::size_t i = 0; i < count; ++i) {
        const NodeInfo& node = same.nodes()[i];
        EXPECT_EQ(nodes[i].name, node.name);
        EXPECT_EQ(nodes[i].category, node.category);
        EXPECT_EQ(nodes[i].doc, node.doc);
        EXPECT_EQ(nodes[i].file, node.file);
        const rapidjson::Document json = parsed(nodes[i].json);
        EXPECT_EQ(json["inputs"].Size() + json["outputs"].Size(), node.ports.size()) << node.name;
    }
    const patina_path* paths = nullptr;
    ASSERT_EQ(patina_paths(compiler(), &paths, &count), PATINA_OK);
    ASSERT_EQ(count, same.paths().size());
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(paths[i].name, same.paths()[i].name);
        EXPECT_EQ(parsed(paths[i].json)["passes"].Size(), same.paths()[i].passes.size());
    }
    const patina_engine* engines = nullptr;
    ASSERT_EQ(patina_engines(compiler(), &engines, &count), PATINA_OK);
    ASSERT_EQ(count, same.engines().size());
    EXPECT_STREQ(engines[0].name, "vulkan");
    EXPECT_TRUE(parsed(engines[0].json)["default"].GetBool());
    EXPECT_EQ(parsed(engines[0].json)["languages"].Size(), same.engines()[0].languages.size());
    // It is one list, however often it is asked for.
    const patina_engine* again = nullptr;
    ASSERT_EQ(patina_engines(compiler(), &again, &count), PATINA_OK);
    EXPECT_EQ(again, engines);
}

}  // namespace
}  // namespace patina
