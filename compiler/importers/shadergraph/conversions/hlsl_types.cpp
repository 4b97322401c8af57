#include "compiler/importers/shadergraph/conversions/hlsl_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace patina::importers::shadergraph {
namespace {

constexpr std::pair<std::string_view, Kind> kScalars[] = {
    {"float", Kind::Float}, {"half", Kind::Float}, {"int", Kind::Int}, {"uint", Kind::Uint}, {"bool", Kind::Bool}};

constexpr std::pair<std::string_view, Rule> kFunctions[] = {
    {"abs", Rule::Numbers},     {"acos", Rule::Float},       {"all", Rule::AnyOrAll},    {"any", Rule::AnyOrAll},
    {"asfloat", Rule::AsFloat}, {"asin", Rule::Float},       {"asint", Rule::AsInt},     {"asuint", Rule::AsUint},
    {"atan", Rule::Float},      {"atan2", Rule::Float},      {"ceil", Rule::Float},      {"clamp", Rule::Numbers},
    {"cos", Rule::Float},       {"cosh", Rule::Float},       {"cross", Rule::Float},     {"ddx", Rule::Float},
    {"ddy", Rule::Float},       {"degrees", Rule::Float},    {"distance", Rule::Scalar}, {"dot", Rule::Scalar},
    {"exp", Rule::Float},       {"exp2", Rule::Float},       {"floor", Rule::Float},     {"fmod", Rule::Float},
    {"frac", Rule::Float},      {"fwidth", Rule::Float},     {"isinf", Rule::Test},      {"isnan", Rule::Test},
    {"length", Rule::Scalar},   {"lerp", Rule::Float},       {"log", Rule::Float},       {"log10", Rule::Float},
    {"log2", Rule::Float},      {"mad", Rule::Numbers},      {"max", Rule::Numbers},     {"min", Rule::Numbers},
    {"mul", Rule::Product},     {"normalize", Rule::Float},  {"pow", Rule::Float},       {"radians", Rule::Float},
    {"rcp", Rule::Float},       {"reflect", Rule::Float},    {"refract", Rule::First},   {"round", Rule::Float},
    {"rsqrt", Rule::Float},     {"saturate", Rule::Float},   {"sign", Rule::Sign},       {"sin", Rule::Float},
    {"sinh", Rule::Float},      {"smoothstep", Rule::Float}, {"sqrt", Rule::Float},      {"step", Rule::Float},
    {"tan", Rule::Float},       {"tanh", Rule::Float},       {"trunc", Rule::Float}};

}  // namespace

Type type_of(std::string_view word) {
    if (word == "Texture2D" || word == "TextureCube" || word == "Texture2DArray" || word == "Texture3D")
        return {.kind = Kind::Texture};
    for (const auto& [scalar, kind] : kScalars) {
        if (!word.starts_with(scalar)) continue;
        const std::string_view rest = word.substr(scalar.size());
        const auto is_size = [](char c) { return c >= '2' && c <= '4'; };
        if (rest.empty()) return {.kind = kind};
        if (rest.size() == 1 && is_size(rest[0])) return {.kind = kind, .size = rest[0] - '0'};
        if (rest.size() == 3 && is_size(rest[0]) && rest[1] == 'x' && is_size(rest[2]))
            return {.kind = kind, .size = rest[0] - '0', .columns = rest[2] - '0'};
    }
    return {};
}

std::string word_for(Kind kind, int size) {
    const std::string_view scalar = kind == Kind::Bool   ? "bool"
                                    : kind == Kind::Int  ? "int"
                                    : kind == Kind::Uint ? "uint"
                                                         : "float";
    return size > 1 ? fmt::format("{}{}", scalar, size) : std::string(scalar);
}

Rule rule_of(std::string_view function) {
    const auto found = std::ranges::find(kFunctions, function, &std::pair<std::string_view, Rule>::first);
    return found == std::end(kFunctions) ? Rule::None : found->second;
}

Type product(const Type& a, const Type& b) {
    if (a.kind != Kind::Float || b.kind != Kind::Float || a.is_array || b.is_array) return {};
    if (a.columns > 0 && b.columns > 0 && a.columns == b.size)
        return {.kind = Kind::Float, .size = a.size, .columns = b.columns};
    if (a.columns > 0 && b.columns == 0 && a.columns == b.size) return {.kind = Kind::Float, .size = a.size};
    if (a.columns == 0 && b.columns > 0 && a.size == b.size) return {.kind = Kind::Float, .size = b.columns};
    return {};
}

}  // namespace patina::importers::shadergraph
