// Every value of the lighting reference on the GPU, through GLSL and through HLSL. A term that is a node or an
// expression is a graph whose inputs come out of a texture, one row of the reference a pixel; a term that is a lighting
// model is the middle of a square in the forward pass, with exactly the row's normal, light, viewer and surroundings.
// In float, to the row's own tolerance.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "witness/term_graphs.h"

namespace patina::witness {
namespace {

using namespace reference;

constexpr std::size_t kModelRows = 26;  // of kRows

const Json& term_of(const Json& row) {
    return read_json("tests/terms/terms.json")[row["term"].GetString()];
}

// Rows that one graph computes.
struct Batch {
    std::string text;
    const Json* term = nullptr;
    std::vector<std::size_t> widths;
    std::vector<const Json*> rows;
    std::vector<RowInputs> inputs;
};

std::vector<Batch> batches_of(const Compiler& compiler) {
    std::map<std::string, std::size_t> found;  // by the graph without its last node
    std::vector<Batch> batches;
    for (const Json& row : rows().GetArray()) {
        const Json& term = term_of(row);
        if (term.HasMember("model")) continue;
        RowInputs inputs = row_inputs(row, term);
        const std::string key = std::string(row["term"].GetString()) + term_graph(compiler, term, inputs, {});
        const auto [place, is_new] = found.emplace(key, batches.size());
        if (is_new) {
            // Of the CPU only the shape of the result is asked for.
            const auto result = evaluate_term(compiler, row["term"].GetString(), inputs_of(row), true);
            EXPECT_TRUE(result.ok) << shown(row);
            batches.push_back({.text = term_graph(compiler, term, inputs, result.widths),
                               .term = &term,
                               .widths = result.widths,
                               .rows = {},
                               .inputs = {}});
        }
        batches[place->second].rows.push_back(&row);
        batches[place->second].inputs.push_back(std::move(inputs));
    }
    return batches;
}

Image texels_of(const Batch& batch) {
    const std::size_t count = std::max<std::size_t>(batch.inputs[0].texels.size(), 1);
    Image image = runtime::make_image(static_cast<int>(batch.rows.size()), static_cast<int>(count));
    for (std::size_t x = 0; x < batch.rows.size(); ++x) {
        for (std::size_t y = 0; y < batch.inputs[x].texels.size(); ++y) {
            for (std::size_t c = 0; c < 4; ++c)
                image.at(static_cast<int>(x), static_cast<int>(y))[c] =
                    static_cast<float>(batch.inputs[x].texels[y][c]);
        }
    }
    return image;
}

// All of a row's numbers, in the order of the term's "out".
std::vector<double> expected_numbers(const Json& row) {
    const Json& term = term_of(row);
    const auto expected = expected_of(row);
    std::vector<double> numbers;
    const auto append = [&](const std::string& name) {
        ASSERT_TRUE(expected.contains(name)) << shown(row) << ": " << name;
        numbers.insert(numbers.end(), expected.at(name).begin(), expected.at(name).end());
    };
    if (!term.HasMember("out") || !term["out"].IsObject()) {
        append("out");
    } else {
        for (const auto& member : term["out"].GetObject()) append(member.name.GetString());
    }
    return numbers;
}

class TermsTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;
    std::set<std::pair<const Json*, Target>> checked;

    void expect_row(const Json& row, Target target, const std::vector<double>& actual) {
        const std::vector<double> expected = expected_numbers(row);
        ASSERT_EQ(actual.size(), expected.size()) << shown(row);
        const bool is_quadrature = is_integral(row["term"].GetString());
        const double relative = is_quadrature ? 1e-3 : row["rtolF32"].GetDouble();
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_LE(std::abs(actual[i] - expected[i]), std::max(1e-6, relative * std::abs(expected[i])))
                << (target == Target::Glsl ? "GLSL: " : "HLSL: ") << shown(row) << "\n  number " << i << " is "
                << actual[i] << ", not " << expected[i] << " within " << relative;
        }
        EXPECT_TRUE(checked.emplace(&row, target).second);
    }
};

TEST_F(TermsTest, NodesAndExpressions) {
    for (const Batch& batch : batches_of(bench->compiler())) {
        const auto material = bench->compile(batch.text);
        if (!material) continue;
        const Inputs inputs{.width = static_cast<int>(batch.rows.size()),
                            .height = static_cast<int>(batch.widths.size()),
                            .data = texture_of(texels_of(batch))};
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Image image = bench->draw(*material, target, inputs);
            if (image.pixels.empty()) continue;
            for (int x = 0; x < image.width; ++x) {
                std::vector<double> actual;
                for (std::size_t y = 0; y < batch.widths.size(); ++y) {
                    const auto pixel = image.at(x, static_cast<int>(y));
                    actual.insert(actual.end(), pixel.begin(), pixel.begin() + batch.widths[y]);
                }
                expect_row(*batch.rows[static_cast<std::size_t>(x)], target, actual);
            }
        }
    }
    // None is left out, and none is looked at twice.
    EXPECT_EQ(checked.size(), 2 * (kRows - kModelRows));
}

// --- models

glm::vec3 vector_of(const std::vector<double>& numbers) {
    return {static_cast<float>(numbers.at(0)), static_cast<float>(numbers.at(1)), static_cast<float>(numbers.at(2))};
}

// A lighting model with the row's inputs as properties of the material.
std::string model_graph(const Json& term, const RowInputs& inputs, const std::set<std::string>& of_scene) {
    std::string properties, surface;
    std::map<std::string, std::string> names;
    for (const auto& [name, numbers] : inputs.numbers) {
        const std::string type = numbers.size() == 1 ? "float" : "float" + std::to_string(numbers.size());
        properties += (properties.empty() ? "" : ", ") + std::string("{ \"name\": \"_") + name + "\", \"type\": \"" +
                      type + "\" }";
        names[name] = "$_" + name;
    }
    for (const auto& port : term["in"].GetObject()) {
        const std::optional<std::string> text = port_text(port.value, term, inputs);
        if (!text || of_scene.contains(port.name.GetString())) continue;
        surface += (surface.empty() ? "" : ", ") + std::string("\"") + port.name.GetString() +
                   "\": \"= " + renamed(*text, names) + "\"";
    }
    return std::string("{ \"patina\": 1, \"workflow\": \"") + term["workflow"].GetString() + "\", \"lighting\": \"" +
           term["model"].GetString() + "\",\n\"properties\": [ " + properties + " ],\n\"surface\": { " + surface +
           " } }";
}

// One pixel: a square that faces the viewer, whatever its vertices say about its normal.
runtime::Scene one_point(const std::map<std::string, glm::vec3>& given) {
    const auto get = [&](const char* name, glm::vec3 otherwise) {
        return given.contains(name) ? given.at(name) : otherwise;
    };
    const glm::vec3 view = get("v", {0, 0, 1}), environment = get("environment", glm::vec3(0));
    const glm::vec3 helper = std::abs(view.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(helper, view)), up = glm::cross(view, right);
    runtime::Scene scene{.camera = {.position = view * 4.0f, .orthographic_height = 1},
                         .lights = {{.direction = get("l", {0, 0, 1}), .color = get("light", glm::vec3(1))}},
                         .ambient = runtime::constant_ambient(get("ambient", glm::vec3(0))),
                         .width = 1,
                         .height = 1};
    scene.environment =
        std::make_shared<const runtime::Environment>([environment](glm::vec3) { return environment; }, 64);
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        scene.mesh.vertices.push_back({.position = right * corner.x + up * corner.y,
                                       .normal = get("n", {0, 0, 1}),
                                       .tangent = glm::vec4(get("t", {1, 0, 0}), 1),
                                       .uv0 = {0, 0}});
    }
    scene.mesh.indices = {0, 1, 2, 0, 2, 3};
    return scene;
}

TEST_F(TermsTest, Models) {
    const std::set<std::string> of_scene = {"n", "l", "v", "t", "light", "ambient", "environment"};
    std::map<std::string, Material> materials;
    for (const Json& row : rows().GetArray()) {
        const Json& term = term_of(row);
        if (!term.HasMember("model")) continue;
        const RowInputs inputs = row_inputs(row, term);
        std::vector<NamedValue> names;
        for (const auto& [name, numbers] : inputs.numbers) names.push_back({name, numbers});
        const auto value = [&](const std::string& expression) {
            const EvalResult made = bench->compiler().evaluate_expression(expression, names);
            EXPECT_TRUE(made.ok) << expression;
            return made.ok ? made.outputs[0].values : std::vector<double>(3);
        };

        const std::string text = model_graph(term, inputs, of_scene);
        if (!materials.contains(text)) {
            auto material = bench->compile(text);
            if (!material) continue;
            materials.emplace(text, std::move(*material));
        }
        std::map<std::string, glm::vec3> given;
        for (const std::string& name : of_scene) {
            const auto port = term["in"].FindMember(name.c_str());
            if (port == term["in"].MemberEnd()) continue;
            if (const auto expression = port_text(port->value, term, inputs))
                given[name] = vector_of(value(*expression));
        }
        const runtime::Scene scene = one_point(given);
        Inputs look{.scene = &scene};
        for (const auto& [name, numbers] : inputs.numbers) {
            std::string& word = look.values["_" + name];
            for (const double number : numbers) word += (word.empty() ? "" : ",") + literal(number);
        }
        for (const Target& target : {Target::Glsl, Target::Hlsl}) {
            const Image image = bench->draw(materials.at(text), target, look);
            if (image.pixels.empty()) continue;
            names.push_back({"out", {image.pixels.begin(), image.pixels.begin() + 3}});
            expect_row(row, target, value(term.HasMember("out") ? term["out"].GetString() : "out"));
            names.pop_back();
        }
    }
    EXPECT_EQ(checked.size(), 2 * kModelRows);
}

TEST_F(TermsTest, EveryRowIsOneOrTheOther) {
    std::size_t models = 0;
    for (const Json& row : rows().GetArray()) models += term_of(row).HasMember("model");
    EXPECT_EQ(models, kModelRows);
    EXPECT_EQ(rows().Size(), kRows);
}

}  // namespace
}  // namespace patina::witness
