// The keys of the graph format: which stand in which object, in canonical order, and what each is for. The reader
// refuses what is not here, `fmt` sorts by it, and the JSON Schema is made from it. It says nothing about values.
//
//   for (const KeyInfo& key : keys_of(ObjectKind::Node)) ...   // id, node, expr, in, ...
#pragma once

#include <span>
#include <string_view>

#include "compiler/json/json.h"

namespace patina::graph {

// Free: an object whose keys are the author's (ports, "meta", "ui").
enum class ObjectKind {
    Free,
    Material,
    Subgraph,
    Lighting,
    Workflow,
    Property,
    Node,
    Input,
    Sampler,
    Render,
    Stencil,
    ExtraPass,
    LightingUse,
    Scene,
    Camera,
    Ambient,
    Fog,
    MixedLighting,
    Light,
    Shadow,
    SceneMaterial,
    SceneObject,
    SceneInstance,
    Engine,
    EngineSets,
    EngineSet,
    EngineVertexInput,
    EngineClip,
    EngineLimits,
    EngineNames
};

struct KeyInfo {
    std::string_view name;
    std::string_view help;
    ObjectKind holds = ObjectKind::Free;  // what the value is, or each element of it if it is an array
    bool required = false;                // beside the "patina" and "kind" of a file
};

// In the order in which `fmt` writes them; empty for Free.
std::span<const KeyInfo> keys_of(ObjectKind kind);
const KeyInfo* find_key(ObjectKind kind, std::string_view name);

// "a property", "a material", ...
std::string_view describe(ObjectKind kind);

// What a file's top-level object is, by its "kind"; a material if that says nothing known.
ObjectKind top_level_kind(const Json& root);
// The same for the value of a key: tells a lighting graph from a { "use": ... }.
ObjectKind value_kind(const KeyInfo& key, const Json& value);

}  // namespace patina::graph
