// The example graphs, and the library's lighting models. Every graph of examples/ compiles without a complaint, and
// both other compilers accept its shaders; its picture, in the scene of its snapshot, is the same through GLSL, HLSL
// and the CPU. Every lighting model works under every workflow with
// lighting, with each of its choices.
#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "patina/validate.h"
#include "runtime/picture/compare.h"
#include "runtime/snapshot/find_cases.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

// Files in and below a folder whose names end so, sorted.
std::vector<std::string> files_of(const fs::path& folder, const std::string& ending) {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().string().ends_with(ending)) files.push_back(entry.path().lexically_normal());
    }
    std::sort(files.begin(), files.end());
    return files;
}

// A name for a test: letters, digits and underscores.
std::string word(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return text;
}

void expect_accepted(const Result& result) {
    for (const Diagnostic& d : result.diagnostics) ADD_FAILURE() << to_text(d);
    ASSERT_TRUE(result.ok);
    ASSERT_FALSE(result.reflection.passes.empty());
    EXPECT_EQ(result.shaders.size(), 4 * result.reflection.passes.size());  // of each two stages, two targets
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << shader.file_name << "\n" << validated.log;
    }
}

// --- every example

class Example : public testing::TestWithParam<std::string> {};

TEST_P(Example, CompilesForBothTargets) {
    expect_accepted(compiler().compile_file(GetParam()));
}

// One of the graph, or of the scene with the same name in its folder.
TEST_P(Example, HasAPicture) {
    std::string scene = GetParam();
    scene.replace(scene.rfind(".graph.json"), std::string::npos, ".scene.json");
    for (const PlannedCase& each : find_cases("tests/snapshots").cases) {
        const fs::path shown = fs::path(each.request.graph).lexically_normal();
        if (shown == GetParam() || shown == scene) return;
    }
    ADD_FAILURE() << "no *.snapshot.json in tests/snapshots shows " << GetParam();
}

INSTANTIATE_TEST_SUITE_P(All, Example, testing::ValuesIn(files_of("examples", ".graph.json")),
                         [](const auto& info) { return word(fs::path(info.param).stem().stem()); });

// --- pictures of them

// At an outline, and at a hard step of the material, the two may fall to different sides.
void expect_alike(const Image& glsl, const Image& other, const char* via) {
    const Comparison difference = compare(glsl, other, 3.01 / 255);
    EXPECT_TRUE(difference.same_size);
    EXPECT_LE(difference.share, 0.005) << via << ", the worst at " << difference.worst_x << ", " << difference.worst_y;
    EXPECT_LE(difference.average, 0.001) << via;
}

class Picture : public testing::TestWithParam<PlannedCase> {};

TEST_P(Picture, IsTheSameThroughGlslHlslAndTheCpu) {
    static RenderMachine machine;
    RenderRequest request = GetParam().request;
    request.options.exact_textures = true;
    request.options.exact_targets = true;  // how a GPU rounds to ten bits is its own business
    request.options.validation = true;
    const auto draw = [&](const char* via) {
        request.options.via = via;
        RenderOutcome outcome = render(compiler(), request, machine);
        for (const Diagnostic& d : outcome.diagnostics) {
            // What the CPU cannot sample, and materials of a scene that its path hands on to another.
            const bool is_expected = d.code == "no-anisotropy" || d.code == "path-refused" || d.code == "path-loses";
            if (!is_expected) ADD_FAILURE() << via << ": " << to_text(d);
        }
        EXPECT_TRUE(outcome.ok) << via << ": " << outcome.error;
        encode_srgb(outcome.image);
        return outcome;
    };
    const RenderOutcome cpu = draw("cpu"), glsl = draw("glsl"), hlsl = draw("hlsl");
    if (!cpu.ok || !glsl.ok || !hlsl.ok) return;
    expect_alike(glsl.image, hlsl.image, "hlsl");
    // The CPU says where it samples textures otherwise.
    if (cpu.diagnostics.empty()) expect_alike(glsl.image, cpu.image, "cpu");
}

std::vector<PlannedCase> pictures() {
    std::vector<PlannedCase> cases = find_cases("tests/snapshots").cases;
    std::erase_if(cases, [](const PlannedCase& each) {
        return !fs::path(each.request.graph).lexically_normal().string().starts_with("examples/") ||
               !each.request.options.preview.empty();
    });
    return cases;
}

INSTANTIATE_TEST_SUITE_P(All, Picture, testing::ValuesIn(pictures()),
                         [](const auto& info) { return word(fs::path(info.param.name).filename()); });

// --- every model under every workflow

// A model's choices: each word of each of its variants, as "in" says it, and one empty text for its defaults.
std::vector<std::string> choices_of(const std::string& model) {
    std::ifstream file("nodes/models/" + model + ".lighting.json");
    std::stringstream text;
    text << file.rdbuf();
    rapidjson::Document json;
    json.Parse<rapidjson::kParseCommentsFlag | rapidjson::kParseTrailingCommasFlag>(text.str().c_str());
    EXPECT_TRUE(json.IsObject()) << model;
    std::vector<std::string> choices = {""};
    if (!json.IsObject() || !json.HasMember("properties")) return choices;
    for (const auto& property : json["properties"].GetArray()) {
        if (!property.HasMember("as") || std::string_view(property["as"].GetString()) != "variant") continue;
        const std::string name = property["name"].GetString();
        if (std::string_view(property["type"].GetString()) == "bool") {
            for (const char* value : {"true", "false"}) choices.push_back("\"" + name + "\": " + value);
            continue;
        }
        for (const auto& value : property["values"].GetArray())
            choices.push_back("\"" + name + "\": \"" + value.GetString() + "\"");
    }
    return choices;
}

class Model : public testing::TestWithParam<std::string> {};

TEST_P(Model, WorksUnderEveryWorkflow) {
    for (const ModelInfo& workflow : compiler().workflows()) {
        if (workflow.name == "unlit") continue;  // it has no lighting
        for (const std::string& choice : choices_of(GetParam())) {
            const std::string text = R"({ "patina": 1, "workflow": ")" + workflow.name +
                                     R"(", "lighting": { "use": ")" + GetParam() + R"(", "in": { )" + choice + " } } }";
            SCOPED_TRACE(text);
            expect_accepted(compiler().compile_text("model.graph.json", text));
        }
    }
}

std::vector<std::string> models() {
    std::vector<std::string> names;
    for (const ModelInfo& model : compiler().lighting_models()) names.push_back(model.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, Model, testing::ValuesIn(models()), [](const auto& info) { return word(info.param); });

}  // namespace
}  // namespace patina::runtime
