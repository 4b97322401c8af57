#include "runtime/lighting/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "runtime/lighting/environment.h"
#include "runtime/lighting/split_sum.h"

namespace patina::runtime {
namespace {

// A word of the command line as a JSON value: a number, a list of numbers, true, false, or a string.
std::string as_json(const std::string& word) {
    if (const std::optional<std::vector<double>> numbers = read_numbers(word)) {
        std::string text;
        for (double number : *numbers) text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
        return numbers->size() == 1 ? text : "[" + text + "]";
    }
    if (word == "true" || word == "false") return word;
    std::string text = "\"";
    for (char c : word) {
        if (c == '"' || c == '\\') text += '\\';
        text += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return text + "\"";
}

std::string model_name(const std::string& model) {
    const bool is_file = model.ends_with(".json") && !model.starts_with(".") && !model.starts_with("/");
    return is_file ? "./" + model : model;
}

using Words = std::vector<std::pair<std::string, std::string>>;

std::string as_members(const Words& words) {
    std::string text;
    for (const auto& [name, word] : words)
        text += (text.empty() ? "\n    " : ",\n    ") + as_json(name) + ": " + as_json(word);
    return text;
}

constexpr std::string_view kMaterial = "--model";

// The caller does not know the material that is made here. So each error is reported as an error of a value.
void place_in_value(Diagnostic& diagnostic, const Words& values) {
    for (Diagnostic& note : diagnostic.notes) place_in_value(note, values);
    if (diagnostic.file != kMaterial) return;
    for (const auto& [name, word] : values) {
        const std::string before = "    " + as_json(name) + ": \"";
        const int begin = static_cast<int>(before.size());
        if (!diagnostic.source_line.starts_with(before + word + "\"") || diagnostic.column <= begin) continue;
        diagnostic.file = name;
        diagnostic.source_line = word;
        diagnostic.line = diagnostic.end_line = 1;
        diagnostic.column -= begin;
        diagnostic.end_column -= begin;
        return;
    }
    diagnostic.file.clear();
    diagnostic.source_line.clear();
    diagnostic.line = diagnostic.column = diagnostic.end_line = diagnostic.end_column = 0;
}

// The smallest material that asks the question.
Result compile(const Compiler& compiler, const ModelChoice& choice, const Words& surface, const Words& properties) {
    const std::string material = "{\n  \"patina\": 1,\n  \"workflow\": " + as_json(choice.workflow) +
                                 ",\n  \"lighting\": { \"use\": " + as_json(model_name(choice.model)) + ", \"in\": {" +
                                 as_members(properties) + "} },\n  \"surface\": {" + as_members(surface) + "}\n}\n";
    CompileOptions options;
    options.targets = {};
    options.request = CompileOptions::Passes{.only = {"forward"}};
    options.keep_programs = true;
    Result result = compiler.compile_text(std::string(kMaterial), material, options);
    for (Diagnostic& diagnostic : result.diagnostics) place_in_value(diagnostic, choice.values);
    return result;
}

// A name that the surface lacks may be a property of the lighting graph. If the lighting graph lacks it too, the
// surface's message is more helpful.
Result compile(const Compiler& compiler, const ModelChoice& choice) {
    Result first = compile(compiler, choice, choice.values, {});
    Words surface, properties;
    for (const auto& value : choice.values) {
        const bool is_unknown =
            std::any_of(first.diagnostics.begin(), first.diagnostics.end(), [&](const Diagnostic& d) {
                return d.code == "unknown-surface-input" &&
                       d.message.find("'" + value.first + "'") != std::string::npos;
            });
        (is_unknown ? properties : surface).push_back(value);
    }
    if (properties.empty()) return first;
    Result second = compile(compiler, choice, surface, properties);
    const bool is_unknown = std::any_of(second.diagnostics.begin(), second.diagnostics.end(),
                                        [](const Diagnostic& d) { return d.code == "unknown-port"; });
    return is_unknown ? first : second;
}

std::shared_ptr<const TextureData> even_cube(float value) {
    TextureData data{.levels = {{.width = 1, .height = 1, .texels = std::vector<float>(24, value)}},
                     .sampler = {.wrap = Wrap::Clamp},
                     .layers = 6};
    return std::make_shared<const TextureData>(std::move(data));
}

std::shared_ptr<const TextureData> one_texel(std::array<float, 4> texel) {
    TextureData data{.levels = {{.width = 1, .height = 1, .texels = {texel.begin(), texel.end()}}}, .sampler = {}};
    return std::make_shared<const TextureData>(std::move(data));
}

// As textures.h has it: what a texture of the usage "color" holds is decoded.
std::array<float, 4> texel_of(const Texture& texture) {
    const float half = texture.usage == TextureUsage::Color ? 0.21404114f : 0.5f;  // ((0.5 + 0.055) / 1.055)^2.4
    if (texture.default_texture == TextureDefault::Black) return {0, 0, 0, 1};
    if (texture.default_texture == TextureDefault::Gray) return {half, half, half, 1};
    if (texture.default_texture == TextureDefault::Bump) return {half, half, 1, 1};
    return {1, 1, 1, 1};
}

}  // namespace

std::optional<std::vector<double>> read_numbers(const std::string& word) {
    const auto is_between = [](char c) {
        return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == '[' || c == ']';
    };
    std::vector<double> numbers;
    const char* at = word.data();
    const char* end = at + word.size();
    while (at != end) {
        if (is_between(*at)) {
            ++at;
            continue;
        }
        double value = 0;
        const auto [next, failure] = std::from_chars(at + (*at == '+' ? 1 : 0), end, value);
        if (failure != std::errc() || !std::isfinite(value) || (next != end && !is_between(*next))) return {};
        numbers.push_back(value);
        at = next;
    }
    if (numbers.empty()) return {};
    return numbers;
}

std::map<std::string, Triple*> named_inputs(ModelPoint& point, ModelLight& light) {
    return {{"n", &point.n},
            {"l", &point.l},
            {"v", &point.v},
            {"t", &point.t},
            {"light", &light.light},
            {"ambient", &light.ambient},
            {"environment", &light.environment}};
}

struct Model::Impl {
    std::vector<Diagnostic> diagnostics;
    std::shared_ptr<const Program> program;
    std::optional<Interpreter> stage;
    std::shared_ptr<const TextureData> dark = even_cube(0), bright = even_cube(1);
    bool reads_environment = false;

    Triple run(const ModelPoint& point, const ModelLight& light, bool with_environment);
};

Model::Model(const Compiler& compiler, const ModelChoice& choice, Precision precision)
    : impl_(std::make_unique<Impl>()) {
    Result compiled = compile(compiler, choice);
    impl_->diagnostics = std::move(compiled.diagnostics);
    if (!compiled.ok) return;
    impl_->program = std::move(compiled.program);
    Interpreter& stage = impl_->stage.emplace(*impl_->program, "forward", Stage::Fragment, precision);
    for (const Property& property : compiled.reflection.properties) {
        stage.set_value(property.identifier, property.value);
    }
    for (const Texture& texture : compiled.reflection.textures) {
        if (texture.is_material) stage.set_texture(texture.identifier, one_texel(texel_of(texture)));
    }
    for (const Pass& pass : compiled.reflection.passes) {
        const auto reads = [&](std::string_view name) {
            return std::find(pass.textures.begin(), pass.textures.end(), name) != pass.textures.end();
        };
        if (reads("splitSumTable")) stage.set_texture("splitSumTable", split_sum_table());
        impl_->reads_environment = impl_->reads_environment || reads("environmentMap");
    }
    stage.set_value("lightCount", std::array{1.0});
    stage.set_value("cameraForwardWS", std::array{0.0, 0.0, -1.0});
}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;

bool Model::ok() const {
    return impl_->stage.has_value();
}

const std::vector<Diagnostic>& Model::diagnostics() const {
    return impl_->diagnostics;
}

// The point is the world's origin; the camera stands where v points to.
Triple Model::Impl::run(const ModelPoint& given, const ModelLight& light, bool with_environment) {
    const auto four = [](const Triple& t) { return std::array{t[0], t[1], t[2], 0.0}; };
    // Only the directions matter; the squares of very long and very short vectors would overflow.
    ModelPoint point = given;
    for (Triple* direction : {&point.n, &point.l, &point.v, &point.t}) {
        const double largest =
            std::max({std::abs((*direction)[0]), std::abs((*direction)[1]), std::abs((*direction)[2])});
        if (largest > 0 && (largest > 1e6 || largest < 1e-6))
            for (double& component : *direction) component /= largest;
    }
    stage->set_value("cameraPositionWS", point.v);
    stage->set_value("lightPosition", four(point.l));  // w = 0: a direction
    stage->set_value("lightColor", four(light.light));
    stage->set_value("lightAxis", std::array{0.0, 0.0, -1.0, 0.0});
    stage->set_value("lightCone", std::array{-1.0, -2.0, 0.0, 0.0});
    const double mean = std::sqrt(4 * std::acos(-1.0));
    stage->set_value("ambientSH",
                     std::array{light.ambient[0] * mean, light.ambient[1] * mean, light.ambient[2] * mean});
    if (reads_environment) stage->set_texture("environmentMap", with_environment ? bright : dark);

    QuadInputs quad;
    for (std::vector<double>& lane : quad.lanes) {
        for (const StageValue& input : stage->inputs()) {
            std::array<double, 4> value{};
            if (input.name == "vertexNormalWS") value = four(point.n);
            if (input.name == "vertexTangentWS") value = {point.t[0], point.t[1], point.t[2], 1};
            if (input.name == "frontFacing") value[0] = 1;
            lane.insert(lane.end(), value.begin(), value.begin() + input.components);
        }
    }
    const QuadOutputs outputs = stage->run(quad);
    return {outputs.lanes[0][0], outputs.lanes[0][1], outputs.lanes[0][2]};
}

Triple Model::direct(const ModelPoint& point) {
    return color(point, {});
}

Triple Model::color(const ModelPoint& point, const ModelLight& light) {
    Triple sum = impl_->run(point, light, false);
    if (light.environment == Triple{} || !impl_->reads_environment) return sum;
    // Texels hold floats: what an environment of 1 adds is scaled afterwards.
    const Triple lit = impl_->run(point, light, true);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += (lit[c] - sum[c]) * light.environment[c];
    return sum;
}

}  // namespace patina::runtime
