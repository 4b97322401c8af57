// The nodes of lighting, colour and safe arithmetic on all corners of what their ports take, and on points between:
// always a finite number, and one inside the range that the output documents. On the CPU in double and in float, and
// the corners on the GPU through GLSL and through HLSL.
#include "proof/domain.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "compiler/resolve/check_graph.h"
#include "proof/term.h"
#include "witness/bench.h"

namespace patina::proof {
namespace {

using nodelang::FunctionDecl;
using nodelang::ParamDecl;

bool is_tried(const FunctionDecl& function) {
    const nodelang::Attribute* node = function.attribute("node");
    if (!node) return false;
    const std::string_view path = nodelang::attribute_text(*node);
    return path.starts_with("Lighting/") || path.starts_with("Color/") || path.starts_with("Math/Safe/") ||
           path.starts_with("Vector/Normal/") || path == "Vector/Safe Normalize";
}

// A texture, or a struct such as a gradient.
bool takes_more_than_numbers(const FunctionDecl& function) {
    return std::any_of(function.params.begin(), function.params.end(), [](const ParamDecl& p) {
        return p.type.name.starts_with("Texture") || library().declarations.structure(p.type.name);
    });
}

// A node with each word of its drop-downs; true and false of a const bool. Const numbers keep their default.
struct Form {
    const FunctionDecl* function = nullptr;
    std::map<std::string, std::string> constants{};

    std::string text() const {
        std::string words(function->name);
        for (const auto& [name, word] : constants) words += " " + word;
        return words;
    }
};

std::vector<Form> all_forms() {
    std::vector<Form> forms;
    for (const FunctionDecl* each : resolve::all_functions(library())) {
        const FunctionDecl& function = *each;
        if (!is_tried(function)) continue;
        std::vector<Form> own = {{.function = &function}};
        for (const ParamDecl& param : function.params) {
            std::vector<std::string_view> words;
            if (const nodelang::EnumDecl* drop_down = library().declarations.enumeration(param.type.name))
                words = drop_down->values;
            if (param.is_const && param.type.name == "bool") words = {"true", "false"};
            if (words.empty()) continue;
            std::vector<Form> more;
            for (const Form& form : own) {
                for (const std::string_view word : words) {
                    more.push_back(form);
                    more.back().constants[std::string(param.name)] = word;
                }
            }
            own = std::move(more);
        }
        forms.insert(forms.end(), own.begin(), own.end());
    }
    return forms;
}

// What one output may be.
struct Output {
    std::string name;
    std::string_view type;
    std::array<double, 2> range{-INFINITY, INFINITY};

    std::size_t components() const {
        const std::string_view as = type == "floatN" ? "float3" : type;
        return std::isdigit(as.back()) ? static_cast<std::size_t>(as.back() - '0') : 1;
    }
};

std::vector<Output> outputs_of(const FunctionDecl& function) {
    std::vector<Output> outputs;
    const std::string_view path = nodelang::attribute_text(*function.attribute("node"));
    // The factors of a BRDF are never below zero, whether they say where they end or not.
    const bool is_factor = path.starts_with("Lighting/Distribution/") || path.starts_with("Lighting/Visibility/") ||
                           path.starts_with("Lighting/Fresnel/");
    const auto add = [&](std::string name, std::string_view type, std::span<const nodelang::Attribute> attributes) {
        Output& output = outputs.emplace_back(Output{.name = std::move(name), .type = type});
        if (is_factor) output.range[0] = 0;
        if (const auto range = resolve::range_of(attributes)) output.range = *range;
    };
    if (function.result.name != "void") add("out", function.result.name, function.attributes);
    for (const ParamDecl& param : function.params) {
        if (param.is_out) add(std::string(param.name), param.type.name, param.attributes);
    }
    return outputs;
}

// "" or what is wrong with a value. `slack`: of the range, relative to its larger end.
std::string fault(const Output& output, double value, double slack) {
    if (!std::isfinite(value)) return "is not finite";
    const auto [low, high] = output.range;
    const double room = std::isfinite(high) ? slack * std::max(std::abs(low), std::abs(high)) : 0;
    return value >= low - room && value <= high + room
               ? ""
               : "is outside its range, " + testing::PrintToString(low) + " to " + testing::PrintToString(high) + ",";
}

std::string joined(const double* values, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += (i ? ", " : "") + testing::PrintToString(values[i]);
    return text;
}

// Tells the first fault of each form, output and witness: one is enough to look at.
class Faults {
public:
    void add(const Form& form, const Output& output, const std::string& witness, const std::string& what, double value,
             const std::string& inputs) {
        if (what.empty() || !told_.insert(form.text() + output.name + witness).second) return;
        ADD_FAILURE() << form.text() << " (" << inputs << ")." << output.name << " " << what << " " << witness << ": "
                      << value;
    }

private:
    std::set<std::string> told_;
};

// What a node gives at its corners and between.
struct Tried {
    std::size_t forms = 0, evaluations = 0;
};
// judge(output, value) is what is wrong with a value, or "".
template <class Judge>
Tried try_all(Arithmetic arithmetic, const std::string& witness, Judge&& judge,
              const std::set<std::string_view>& but = {}) {
    constexpr std::size_t most = kSanitized ? 1000 : 60000, between = kSanitized ? 100 : 4000;
    Faults faults;
    Tried tried;
    for (const Form& form : all_forms()) {
        if (takes_more_than_numbers(*form.function) || but.contains(form.function->name)) continue;
        Term term = Term::node(*form.function, form.constants, arithmetic);
        if (term.reads_globals()) continue;
        const Domain domain = domain_of(*form.function);
        const std::vector<Output> outputs = outputs_of(*form.function);
        const std::size_t corners = domain.corners(most);
        std::vector<double> in(domain.inputs() + 1);
        const auto fill = [&](std::size_t i, double* to) {
            i < corners ? domain.corner(i, most, to) : domain.point(i - corners, to);
        };
        term.each(corners + between, fill, [&](std::size_t i, const double* out) {
            for (const Output& output : outputs) {
                for (std::size_t c = 0; c < output.components(); ++c) {
                    const double value = *out++;
                    const std::string what = judge(output, value);
                    if (what.empty()) continue;
                    fill(i, in.data());
                    faults.add(form, output, witness, what, value, joined(in.data(), domain.inputs()));
                }
            }
        });
        ++tried.forms;
        tried.evaluations += corners + between;
    }
    std::printf("%s: %zu nodes and forms of nodes, %zu evaluations\n", witness.c_str(), tried.forms, tried.evaluations);
    return tried;
}

TEST(Domain, EveryNodeIsFiniteAndInItsRangeOnTheCpu) {
    const auto within = [](double slack) {
        return [slack](const Output& output, double value) { return fault(output, value, slack); };
    };
    EXPECT_GE(try_all({.precision = Precision::Double}, "in double", within(1e-12)).forms, 100u);
    EXPECT_GE(try_all({.precision = Precision::Float}, "in float", within(1e-6)).forms, 100u);
}

// Half precision ends at 65504, so a highlight may be infinite there. But nothing is without a value.
TEST(Domain, NothingIsNanInHalfPrecision) {
    // A sum over a thousand directions is for making tables, in as many digits as there are.
    try_all({.half = true}, "in half",
            [](const Output&, double value) { return std::string(std::isnan(value) ? "is NaN" : ""); },
            {"SplitSumIntegral"});
}

// --- on the GPU: the inputs come out of a texture, a point a pixel, a port a row

constexpr std::size_t kWidth = 64;

std::string call_text(const Form& form, const Output& output) {
    std::string text;
    std::size_t row = 0;
    for (const ParamDecl& param : form.function->params) {
        if (param.is_out) continue;
        text += text.empty() ? "" : ", ";
        if (param.is_const) {
            const auto word = form.constants.find(std::string(param.name));
            text +=
                word != form.constants.end() ? word->second : std::string(library().sources.text(param.initial->span));
            continue;
        }
        const std::size_t components = Output{.name = {}, .type = param.type.name}.components();
        text += "a" + std::to_string(row++) + "." + std::string("xyzw").substr(0, components);
    }
    return std::string(form.function->name) + "(" + text + ")" + (output.name == "out" ? "" : "." + output.name);
}

std::string graph_of(const Form& form, const Output& output) {
    std::size_t rows = 0;
    for (const ParamDecl& param : form.function->params) rows += !param.is_out && !param.is_const;
    std::string nodes;
    for (std::size_t i = 0; i < rows; ++i) {
        const std::string row = "floor(@fragCoord.y) * " + std::to_string(rows) + " + " + std::to_string(i);
        nodes += witness::load_node("a" + std::to_string(i), "@fragCoord.x", row) + ",\n";
    }
    nodes += R"({ "id": "value", "expr": ")" + call_text(form, output) + R"(" })";
    const std::string_view colors[] = {"float3(value, 0, 0)", "float3(value, 0)", "value", "value.xyz"};
    return R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + witness::data_property() +
           " ],\n\"nodes\": [\n" + nodes +
           " ],\n\"surface\": { \"color\": \"= " + std::string(colors[output.components() - 1]) +
           "\", \"alpha\": \"= " + (output.components() == 4 ? "value.w" : "1") + "\" } }";
}

// The corners of a domain as texels.
runtime::Image texels_of(const FunctionDecl& function, const Domain& domain, std::size_t corners, std::size_t most) {
    std::vector<std::size_t> sizes;
    for (const ParamDecl& param : function.params) {
        if (!param.is_out && !param.is_const) sizes.push_back(Output{.name = {}, .type = param.type.name}.components());
    }
    const std::size_t rows = (corners + kWidth - 1) / kWidth * std::max<std::size_t>(1, sizes.size());
    runtime::Image texels = runtime::make_image(kWidth, static_cast<int>(rows));
    std::vector<double> in(domain.inputs() + 1);
    for (std::size_t i = 0; i < corners; ++i) {
        domain.corner(i, most, in.data());
        const double* from = in.data();
        for (std::size_t port = 0; port < sizes.size(); ++port) {
            const std::span<float> texel =
                texels.at(static_cast<int>(i % kWidth), static_cast<int>(i / kWidth * sizes.size() + port));
            for (std::size_t c = 0; c < sizes[port]; ++c) texel[c] = static_cast<float>(*from++);
        }
    }
    return texels;
}

TEST(Domain, EveryNodeIsFiniteAndInItsRangeOnTheGpu) {
    constexpr std::size_t most = kSanitized ? 256 : 8192;
    witness::Bench bench;
    Faults faults;
    std::size_t draws = 0;
    for (const Form& form : all_forms()) {
        if (takes_more_than_numbers(*form.function) || Term::node(*form.function, form.constants).reads_globals())
            continue;
        const Domain domain = domain_of(*form.function);
        const std::size_t corners = domain.corners(most);
        const runtime::Image texels = texels_of(*form.function, domain, corners, most);
        const witness::Inputs inputs{.width = kWidth,
                                     .height = static_cast<int>((corners + kWidth - 1) / kWidth),
                                     .data = witness::texture_of(texels)};
        std::vector<double> in(domain.inputs() + 1);
        for (const Output& output : outputs_of(*form.function)) {
            const auto material = bench.compile(graph_of(form, output));
            if (!material) continue;
            for (const Target& target : {Target::Glsl, Target::Hlsl}) {
                const runtime::Image image = bench.draw(*material, target, inputs);
                if (image.pixels.empty()) continue;
                ++draws;
                for (std::size_t i = 0; i < corners; ++i) {
                    const std::span<const float> pixel =
                        image.at(static_cast<int>(i % kWidth), static_cast<int>(i / kWidth));
                    for (std::size_t c = 0; c < output.components(); ++c) {
                        const std::string what = fault(output, static_cast<double>(pixel[c]), 1e-4);
                        if (what.empty()) continue;
                        domain.corner(i, most, in.data());
                        faults.add(form, output, target == Target::Glsl ? "in GLSL" : "in HLSL", what,
                                   static_cast<double>(pixel[c]), joined(in.data(), domain.inputs()));
                    }
                }
            }
        }
    }
    std::printf("%zu draws\n", draws);
    bench.expect_silence();
}

}  // namespace
}  // namespace patina::proof
