// The reflection of every example, for each engine and as functions: its JSON is read back to the same, and the
// published schema describes it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "patina/patina.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

const Compiler& compiler() {
    static const Compiler kCompiler;
    return kCompiler;
}

std::string said(const std::vector<Diagnostic>& diagnostics) {
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) all += to_text(diagnostic) + "\n";
    return all;
}

std::vector<std::string> graphs() {
    std::vector<std::string> found;
    for (const char* folder : {"examples", "tests/graphs"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().string().ends_with(".graph.json")) found.push_back(entry.path().generic_string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

// What a program may ask for, so that every part of a reflection is there at least once.
std::vector<std::pair<std::string, CompileOptions>> requests() {
    CompileOptions usual, unity, functions, deferred, all, shadows;
    usual.hashes = true;
    unity.targets = {{"unity", "hlsl"}};
    functions.request = CompileOptions::Functions{.prefix = "Own_"};
    deferred.request = CompileOptions::Passes{.path = "deferred"};
    all.request = CompileOptions::Passes{.path = "all"};
    shadows.switches = {{"shadows", "true"}, {"fog", "true"}};
    return {{"as it is", usual},    {"Unity", unity},   {"functions", functions},
            {"deferred", deferred}, {"all paths", all}, {"switches", shadows}};
}

std::string file(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

class Schema {
public:
    explicit Schema(const std::string& text) {
        document_.Parse(text.c_str());
        EXPECT_FALSE(document_.HasParseError());
        schema_ = std::make_unique<rapidjson::SchemaDocument>(document_);
    }
    // Empty, or what is wrong and where.
    std::string refusal(const std::string& json) const {
        rapidjson::Document document;
        document.Parse(json.c_str());
        if (document.HasParseError()) return "no JSON";
        rapidjson::SchemaValidator validator(*schema_);
        if (document.Accept(validator)) return {};
        rapidjson::StringBuffer at;
        validator.GetInvalidDocumentPointer().StringifyUriFragment(at);
        return fmt::format("{} at {}", validator.GetInvalidSchemaKeyword(), at.GetString());
    }

private:
    rapidjson::Document document_;
    std::unique_ptr<rapidjson::SchemaDocument> schema_;
};

TEST(ReflectionJson, OfEveryExampleIsReadBackAndAsTheSchemaSays) {
    const Schema schema(Reflection::schema());
    std::size_t count = 0;
    for (const std::string& graph : graphs()) {
        for (const auto& [what, options] : requests()) {
            const Result result = compiler().compile_file(graph, options);
            if (!result.ok) continue;
            SCOPED_TRACE(graph + ", " + what);
            ++count;
            const std::string json = result.reflection.to_json();
            EXPECT_EQ(schema.refusal(json), "") << json;
            const ReadReflection read = Reflection::from_json(json);
            ASSERT_TRUE(read.ok) << said(read.diagnostics);
            EXPECT_EQ(read.reflection.to_json(), json);
        }
    }
    EXPECT_GT(count, 200u);
}

// What no JSON shows directly.
TEST(ReflectionJson, KeepsEveryMember) {
    Reflection made;
    made.name = "all";
    made.moves_vertices = true;
    made.bounds.emplace();
    made.bounds->box.emplace();
    (*made.bounds->box)[0] = {-1, -2, -3};
    (*made.bounds->box)[1] = {1, 2, 3};
    made.clip_depth = ClipDepth::Symmetric;
    made.most_instances = 7;
    made.sets = {{.set = 2, .hash = "abc"}};
    made.meta = R"({ "a": [1, 2.50] })";
    made.properties = {{.name = "_Kind",
                        .identifier = "_Kind",
                        .type = PropertyType::Enum,
                        .value = {1},
                        .binding = Binding::Specialization,
                        .constant_id = 0,
                        .range = std::array{0.0, 1.0},
                        .hard = true,
                        .values = {"A", "B"},
                        .label = "l",
                        .group = "g",
                        .help = "h",
                        .block = "Material",
                        .offset = 16,
                        .size = 4,
                        .instance_stride = 32}};
    Block block;
    block.name = "Material";
    block.size = 64;
    made.blocks = {block};
    Property on, tint;
    on.name = on.identifier = "_On";
    on.type = PropertyType::Bool;
    on.value = {1};
    tint.name = tint.identifier = "_Tint";
    tint.type = PropertyType::Color;
    tint.value = {0.1, 0.2, 0.3, 1};
    made.properties.push_back(on);
    made.properties.push_back(tint);
    Texture texture;
    texture.name = "_Map";
    texture.identifier = "_Map2";
    texture.default_texture = TextureDefault::File;
    texture.default_file = "pack://a.png";
    texture.handedness = Handedness::DirectX;
    texture.swizzle = "bgra";
    texture.grid = {4, 2};
    texture.tiling = "_Map_ST";
    texture.tiling_default = {2, 3, 0.5, 0.25};
    texture.sampler = {.wrap = Wrap::Mirror, .filter = Filter::Nearest, .anisotropy = 8};
    made.textures = {texture};
    Pass pass;
    pass.name = "p";
    pass.is_extra = pass.moves_vertices = pass.reads_elsewhere = true;
    pass.bounds = Bounds{.margin = 0.5};
    pass.depth_bias = -2;
    pass.stencil = {.test = Compare::Equal,
                    .pass = StencilOp::Replace,
                    .fail = StencilOp::Zero,
                    .depth_fail = StencilOp::Invert,
                    .value = 3,
                    .read_mask = 15,
                    .write_mask = 240};
    pass.keywords = {"_Kind"};
    pass.hash = "ff";
    pass.cost = {.vertex = {.once = {.instructions = 30, .arithmetic = 12}, .varyings = 9},
                 .fragment = {.once = {.instructions = 200, .textures = 3, .derivatives = 1},
                              .per_light = {.instructions = 60, .transcendental = 4},
                              .registers = 40},
                 .uniform_bytes = 96};
    Pass of_lighting = pass;
    of_lighting.stencil.reference = StencilReference::Lighting;
    of_lighting.stencil.value = 0;
    made.passes = {pass, of_lighting};
    const std::string json = made.to_json();
    EXPECT_EQ(Schema(Reflection::schema()).refusal(json), "") << json;
    const ReadReflection read = Reflection::from_json(json);
    ASSERT_TRUE(read.ok) << said(read.diagnostics);
    const Reflection& r = read.reflection;
    EXPECT_EQ(r.to_json(), json);
    EXPECT_TRUE(r.moves_vertices);
    EXPECT_EQ(r.bounds->box, made.bounds->box);
    EXPECT_EQ(r.clip_depth, ClipDepth::Symmetric);
    EXPECT_EQ(r.most_instances, 7u);
    EXPECT_EQ(r.sets[0].hash, "abc");
    EXPECT_EQ(r.meta, made.meta);
    const Property& kind = r.properties[0];
    EXPECT_EQ(kind.value[0], 1);
    EXPECT_EQ(kind.binding, Binding::Specialization);
    EXPECT_EQ(kind.constant_id, 0u);
    EXPECT_EQ(kind.range, made.properties[0].range);
    EXPECT_TRUE(kind.hard);
    EXPECT_EQ(kind.help, "h");
    EXPECT_EQ(kind.offset, 16u);
    EXPECT_EQ(kind.instance_stride, 32u);
    EXPECT_EQ(r.properties[1].value[0], 1);
    EXPECT_EQ(r.properties[2].value, made.properties[2].value);
    EXPECT_EQ(r.textures[0].default_texture, TextureDefault::File);
    EXPECT_EQ(r.textures[0].default_file, "pack://a.png");
    EXPECT_EQ(r.textures[0].handedness, Handedness::DirectX);
    EXPECT_EQ(r.textures[0].grid, texture.grid);
    EXPECT_EQ(r.textures[0].tiling_default, texture.tiling_default);
    EXPECT_EQ(r.textures[0].sampler, texture.sampler);
    EXPECT_TRUE(r.passes[0].is_extra && r.passes[0].moves_vertices && r.passes[0].reads_elsewhere);
    EXPECT_EQ(r.passes[0].bounds->margin, 0.5);
    EXPECT_EQ(r.passes[0].depth_bias, -2);
    EXPECT_EQ(r.passes[0].stencil.depth_fail, StencilOp::Invert);
    EXPECT_EQ(r.passes[0].stencil.value, 3);
    EXPECT_EQ(r.passes[0].stencil.write_mask, 240);
    EXPECT_EQ(r.passes[0].keywords, pass.keywords);
    EXPECT_EQ(r.passes[0].cost, pass.cost);
    EXPECT_EQ(r.passes[1].stencil.reference, StencilReference::Lighting);
}

TEST(ReflectionJson, ThatIsWrongIsRefusedAtItsPlace) {
    const std::string json = compiler().compile_file("examples/graphs/rusted_steel.graph.json").reflection.to_json();
    ASSERT_FALSE(json.empty());
    const auto refusal = [&](std::string_view old, std::string_view now) {
        std::string changed = json;
        const std::size_t at = changed.find(old);
        EXPECT_NE(at, changed.npos) << old;
        if (at != changed.npos) changed.replace(at, old.size(), now);
        const ReadReflection read = Reflection::from_json(changed, "a.reflect.json");
        EXPECT_FALSE(read.ok) << now;
        EXPECT_NE(Schema(Reflection::schema()).refusal(changed), "") << now;
        return said(read.diagnostics);
    };
    const auto has = [](const std::string& text, std::string_view part) { return text.find(part) != text.npos; };
    std::string text = refusal("\"patina\": 1", "\"patina\": 2");
    EXPECT_TRUE(has(text, "a.reflect.json:2:13: error: 'patina' must be 1")) << text;
    // Of another version, no keys are known.
    const std::vector<Diagnostic> other = Reflection::from_json("{\"patina\": 2}").diagnostics;
    ASSERT_EQ(other.size(), 1u);
    EXPECT_EQ(other[0].message, "'patina' must be 1");
    text = refusal("\"surface\": \"opaque\"", "\"surface\": \"opaqe\"");
    EXPECT_TRUE(has(text, "'opaqe' is not a value of 'surface'") && has(text, "did you mean 'opaque'?")) << text;
    text = refusal("\"layoutHash\"", "\"layoutHush\"");
    EXPECT_TRUE(has(text, "needs the key 'layoutHash'")) << text;
    text = refusal("\"passes\": [", "\"passes\": [7, ");
    EXPECT_TRUE(has(text, "'passes' must be an object, not 7")) << text;
    text = refusal("\"offset\": 0", "\"offset\": -1");
    EXPECT_TRUE(has(text, "'offset' must be a whole number from 0 to 4294967295, not -1")) << text;
    text = refusal("\"depthWrite\": true", "\"depthWrite\": \"yes\"");
    EXPECT_TRUE(has(text, "'depthWrite' must be true or false, not a string")) << text;
    for (const char* broken : {"", "[", "[]", "{ \"patina\": 1"}) EXPECT_FALSE(Reflection::from_json(broken).ok);
}

// A program would write there.
TEST(ReflectionJson, ValuesOutsideOfTheirBlockAreRefused) {
    const std::string json = compiler().compile_file("examples/graphs/rusted_steel.graph.json").reflection.to_json();
    const auto message = [&](std::string_view key, std::string_view now) {
        std::string changed = json;
        const std::size_t at = changed.find(key, changed.find("\"properties\"")) + key.size();
        changed.replace(at, changed.find_first_of(",\n", at) - at, now);
        const ReadReflection read = Reflection::from_json(changed, "a.reflect.json");
        EXPECT_FALSE(read.ok);
        return said(read.diagnostics);
    };
    EXPECT_NE(message("\"block\": ", "\"Nope\"").find("'Nope' is not one of the blocks"), std::string::npos)
        << message("\"block\": ", "\"Nope\"");
    for (const char* key : {"\"offset\": ", "\"size\": "})
        EXPECT_NE(message(key, "4000000000").find("'offset' must be inside the "), std::string::npos)
            << message(key, "4000000000");
}

// A later version may say more.
TEST(ReflectionJson, KeysThatThisVersionDoesNotKnowAreSkipped) {
    std::string json = compiler().compile_file("examples/graphs/rusted_steel.graph.json").reflection.to_json();
    json.insert(json.find("\"name\""), "\"later\": { \"a\": [1] },\n  ");
    EXPECT_TRUE(Reflection::from_json(json).ok);
}

// The compiler writes no files: who does lists them.
TEST(ReflectionJson, FilesThatWereWrittenWithItAreListed) {
    Reflection reflection = compiler().compile_file("examples/graphs/rusted_steel.graph.json").reflection;
    EXPECT_TRUE(reflection.files.empty());
    reflection.files = {{.file = "a.glsl", .hash = file_hash("a")}, {.file = "none.spv", .hash = file_hash("")}};
    const std::string json = reflection.to_json();
    const ReadReflection read = Reflection::from_json(json);
    ASSERT_TRUE(read.ok);
    ASSERT_EQ(read.reflection.files.size(), 2u);
    EXPECT_EQ(read.reflection.files[0].file, "a.glsl");
    EXPECT_EQ(read.reflection.files[0].hash, reflection.files[0].hash);
    EXPECT_EQ(read.reflection.to_json(), json);
}

// The examples of its authors.
TEST(ReflectionJson, TheHashOfAFileIsFnv1a) {
    EXPECT_EQ(file_hash(""), "cbf29ce484222325");
    EXPECT_EQ(file_hash("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(file_hash("foobar"), "85944171f73967e8");
}

TEST(ReflectionJson, TheSchemaIsTheOneInTheDocs) {
    EXPECT_EQ(file("docs/reflection.schema.json"), Reflection::schema())
        << "run patina schema --reflection -o docs/reflection.schema.json";
}

}  // namespace
}  // namespace patina
