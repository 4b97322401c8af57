#include "compiler/importers/shadergraph/code/engine_words.h"

#include <fmt/format.h>

#include <vector>

#include "compiler/importers/names.h"
#include "compiler/importers/shadergraph/code/hlsl_text.h"

namespace patina::importers::shadergraph {
namespace {

bool is_of_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Calls and values of the engine: what stands for them, and the parameter that brings it.
struct EngineWord {
    std::string_view word;
    bool is_call;  // its arguments are dropped, or, if `keeps` is true, kept
    bool keeps;
    std::string_view ours, parameter;
};
constexpr EngineWord kEngine[] = {
    {"GetMainLight", true, false, "engineLight", "[hidden] Light engineLight = light"},
    {"TransformWorldToShadowCoord", true, false, "float4(0)", ""},
    {"SampleSH", true, true, "AmbientIrradiance", ""},
    {"distanceAttenuation", false, false, "attenuation", ""},
    {"shadowAttenuation", false, false, "shadow", ""},
    {"_WorldSpaceCameraPos", false, false, "engineCamera", "[hidden] float3 engineCamera = cameraPositionWS"},
    {"_Time", false, false, "(float4(0.05, 1, 2, 3) * engineTime)", "[hidden] float engineTime = time"},
    {"_SinTime", false, false, "sin(float4(0.125, 0.25, 0.5, 1) * engineTime)", "[hidden] float engineTime = time"},
    {"_CosTime", false, false, "cos(float4(0.125, 0.25, 0.5, 1) * engineTime)", "[hidden] float engineTime = time"},
    {"_TimeParameters", false, false, "float4(engineTime, sin(engineTime), cos(engineTime), 0)",
     "[hidden] float engineTime = time"},
    {"_ScreenParams", false, false, "float4(engineScreen, 1 + 1 / engineScreen)",
     "[hidden] float2 engineScreen = screenSize"},
    {"unity_ObjectToWorld", false, false, "objectToWorld", ""},
    {"UNITY_MATRIX_M", false, false, "objectToWorld", ""},
    {"GetObjectToWorldMatrix", true, false, "objectToWorld", ""},
    {"unity_WorldToObject", false, false, "worldToObject", ""},
    {"UNITY_MATRIX_I_M", false, false, "worldToObject", ""},
    {"GetWorldToObjectMatrix", true, false, "worldToObject", ""},
    {"UNITY_MATRIX_V", false, false, "worldToView", ""},
    {"GetWorldToViewMatrix", true, false, "worldToView", ""},
    {"GetCameraPositionWS", true, false, "engineCamera", "[hidden] float3 engineCamera = cameraPositionWS"},
};

// Functions of the engine's pipelines that change a vector's space: what stands for a call, and the function that makes
// a unit vector of it unless the second argument is "false".
struct SpaceChange {
    std::string_view word, ours, unit{};
};
constexpr SpaceChange kSpaces[] = {
    {"TransformObjectToWorld", "mul(unity_ObjectToWorld, float4({}, 1)).xyz"},
    {"TransformWorldToObject", "mul(unity_WorldToObject, float4({}, 1)).xyz"},
    {"TransformWorldToView", "mul(UNITY_MATRIX_V, float4({}, 1)).xyz"},
    {"TransformObjectToWorldDir", "mul(unity_ObjectToWorld, float4({}, 0)).xyz", "SafeNormalize"},
    {"TransformWorldToObjectDir", "mul(unity_WorldToObject, float4({}, 0)).xyz", "normalize"},
    {"TransformObjectToWorldNormal", "mul(float4({}, 0), unity_WorldToObject).xyz", "SafeNormalize"},
    {"TransformWorldToObjectNormal", "mul(float4({}, 0), unity_ObjectToWorld).xyz", "SafeNormalize"},
};

void change_space(std::string& code, const SpaceChange& change) {
    for (std::size_t at = 0; (at = code.find(change.word, at)) != code.npos;) {
        const std::size_t begin = at;
        at += change.word.size();
        const std::size_t open = code.find_first_not_of(" \t\n", at);
        const bool is_inside = begin > 0 && is_of_word(code[begin - 1]);
        if (open == code.npos || code[open] != '(' || is_inside) continue;
        const std::size_t end = behind_bracket(code, open);
        const std::vector<std::string> arguments =
            terms::arguments_of(std::string_view(code).substr(open + 1, end - open - 2));
        const bool is_definition = !arguments.empty() && arguments[0].starts_with("float3 ");
        if (arguments.empty() || arguments.size() > 2 || is_definition) continue;
        const bool keeps = arguments.size() == 2 && arguments[1] == "false";
        if (arguments.size() == 2 && (change.unit.empty() || (!keeps && arguments[1] != "true"))) continue;
        std::string ours(change.ours);
        ours.replace(ours.find("{}"), 2, arguments[0]);
        if (!change.unit.empty() && !keeps) ours = fmt::format("{}({})", change.unit, ours);
        code.replace(begin, end - begin, ours);
        at = begin;  // a call in the arguments
    }
}

}  // namespace

void with_engine_words(std::string& code, std::string& parameters) {
    for (const SpaceChange& each : kSpaces) change_space(code, each);
    for (const EngineWord& each : kEngine) {
        bool is_used = false;
        for (std::size_t at = 0; (at = code.find(each.word, at)) != code.npos;) {
            std::size_t end = at + each.word.size();
            const bool is_word = has_identifier(std::string_view(code).substr(at, each.word.size() + 1), each.word) &&
                                 (at == 0 || !is_of_word(code[at - 1]));
            if (!is_word) {
                at = end;
                continue;
            }
            is_used = true;
            const std::size_t open = code.find_first_not_of(' ', end);
            if (each.is_call && !each.keeps && open != code.npos && code[open] == '(') end = behind_bracket(code, open);
            code.replace(at, end - at, each.ours);
            at += each.ours.size();
        }
        if (is_used && parameters.find(each.parameter) == parameters.npos)
            parameters += (parameters.empty() ? "" : ", ") + std::string(each.parameter);
    }
}

std::string as_written(std::string text) {
    for (const EngineWord& each : kEngine) {
        const bool is_matrix = each.word.starts_with("unity_") || each.word.starts_with("UNITY_");
        if (each.parameter.empty() && !is_matrix) continue;
        for (std::size_t at = 0; (at = text.find(each.ours, at)) != text.npos; at += each.word.size())
            text.replace(at, each.ours.size(), each.word);
    }
    return text;
}

}  // namespace patina::importers::shadergraph
