// What folding leaves in shaders. In no example graph, and in no lighting model with any value of its variants, along
// any path, is there a division by a constant zero or a constant that is not finite; and glslang warns of none of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/api/compilation.h"
#include "compiler/nodelang/embedded.h"
#include "patina/validate.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

const resolve::Library& library() {
    static const std::unique_ptr<resolve::Library> kLibrary =
        resolve::load_library(nodelang::embedded_files(), writers::printable());
    return *kLibrary;
}

bool is_zero_somewhere(const ir::Module& module, const ir::Function& function, ir::Value value) {
    const ir::Inst& inst = function[value];
    if (inst.op == ir::Op::Construct) {
        const auto parts = function.args(inst);
        return std::any_of(parts.begin(), parts.end(),
                           [&](ir::Value part) { return is_zero_somewhere(module, function, part); });
    }
    if (inst.op != ir::Op::Constant) return false;
    const auto numbers = module.numbers_of(module.constants[inst.data]);
    return std::find(numbers.begin(), numbers.end(), 0.0) != numbers.end();
}

void expect_sound(const ir::Module& stage) {
    for (const ir::Function& function : stage.functions) {
        SCOPED_TRACE(function.name);
        for (const ir::Block& block : function.blocks) {
            for (const ir::Value value : block.insts) {
                const ir::Inst& inst = function[value];
                const bool divides = inst.op == ir::Op::Div || inst.op == ir::Op::Mod;
                if (divides && is_zero_somewhere(stage, function, function.args(inst)[1]))
                    ADD_FAILURE() << "a division by a constant zero";
                if (inst.op != ir::Op::Constant) continue;
                for (const double number : stage.numbers_of(stage.constants[inst.data]))
                    EXPECT_TRUE(std::isfinite(static_cast<float>(number))) << number;
            }
        }
    }
}

// `text`: of the graph; empty: the file's.
void expect_sound(const std::string& path, const std::string& text, const std::string& along) {
    SCOPED_TRACE(path + " along " + along + "\n" + text);
    CompileOptions options;
    options.request = CompileOptions::Passes{.path = along};
    options.targets = {Target::Glsl, Target::Hlsl};
    resolve::Session session(library(), options);
    const std::optional<std::uint32_t> base =
        text.empty() ? resolve::load_source(session, path, {}) : std::optional(session.sources.add(path, text));
    ASSERT_TRUE(base);
    Result result;
    ShortName pass_now;
    Compilation compilation{.session = session, .source = *base, .path = path, .result = result, .pass = pass_now};
    compile(compilation);
    ASSERT_FALSE(session.diagnostics.has_errors());
    ASSERT_FALSE(compilation.passes.empty());
    for (const link::LinkedPass& pass : compilation.passes) {
        SCOPED_TRACE(pass.pass->name);
        expect_sound(pass.vertex);
        expect_sound(pass.fragment);
    }
    for (const Shader& shader : result.shaders) {
        const Validated validated = validate(shader);
        EXPECT_TRUE(validated.ok) << validated.log;
        EXPECT_EQ(validated.log.find("WARNING"), std::string::npos) << shader.file_name << "\n" << validated.log;
    }
}

constexpr const char* kPaths[] = {"forward", "all"};

// --- examples

class ExampleConstants : public testing::TestWithParam<std::string> {};

TEST_P(ExampleConstants, AreSound) {
    for (const char* path : kPaths) expect_sound(GetParam(), "", path);
}

std::vector<std::string> examples() {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator("examples")) {
        if (entry.path().string().ends_with(".graph.json")) files.push_back(entry.path().lexically_normal());
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::string word(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return text;
}

INSTANTIATE_TEST_SUITE_P(All, ExampleConstants, testing::ValuesIn(examples()),
                         [](const auto& info) { return word(info.param); });

// --- lighting models

// Each value of each variant of a model, as "in" says it; first nothing, for the defaults.
std::vector<std::string> choices_of(const format::Graph& model) {
    std::vector<std::string> choices = {""};
    for (const format::Property& property : model.properties) {
        if (property.binding != Binding::Variant) continue;
        const std::string name = "\"" + property.name + "\": ";
        if (property.type == PropertyType::Bool) {
            choices.push_back(name + "false");
            choices.push_back(name + "true");
        }
        for (const std::string& value : property.values) choices.push_back(name + "\"" + value + "\"");
    }
    return choices;
}

class ModelConstants : public testing::TestWithParam<std::string> {};

TEST_P(ModelConstants, AreSound) {
    const format::Graph& model = *library().lighting_models.find(GetParam())->second.get();
    for (const auto& [workflow, file] : library().workflows) {
        if (!file.get()->is_lit()) continue;
        for (const std::string& choice : choices_of(model)) {
            const std::string text = R"({ "patina": 1, "workflow": ")" + workflow + R"(", "lighting": { "use": ")" +
                                     GetParam() + R"(", "in": { )" + choice + " } } }";
            for (const char* path : kPaths) expect_sound("model.graph.json", text, path);
        }
    }
}

std::vector<std::string> models() {
    std::vector<std::string> names;
    for (const auto& [name, model] : library().lighting_models) names.push_back(name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(All, ModelConstants, testing::ValuesIn(models()),
                         [](const auto& info) { return word(info.param); });

}  // namespace
}  // namespace patina
