// Lists the keys of the graph format, of engines and of JSON options: those of each object, in canonical order, with
// their help. The reader refuses other keys, `fmt` sorts by this order, and the JSON Schema is made from it.
//
//   for (const KeyInfo& key : keys_of(ObjectKind::Node)) ...   // id, node, expr, in, ...
#pragma once

#include <span>
#include <string_view>

#include "compiler/json/json.h"

namespace patina::graph {

// Free: the author chooses the keys of the object (ports, "meta", "ui").
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
    Gradient,
    Curve,
    Render,
    Stencil,
    ExtraPass,
    LightingUse,
    Budget,
    Scene,
    Camera,
    Ambient,
    Environment,
    Probe,
    ProbeBox,
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
    EngineNames,
    Options,
    OptionsLimits
};

struct KeyInfo {
    std::string_view name;
    std::string_view help;
    ObjectKind holds = ObjectKind::Free;  // the kind of the value or, if it is an array, of its elements
    bool required = false;                // in addition to the "patina" and "kind" of a file
    bool is_set = false;                  // the order of the array has no meaning
};

// In the order in which `fmt` writes them; empty for Free.
std::span<const KeyInfo> keys_of(ObjectKind kind);
const KeyInfo* find_key(ObjectKind kind, std::string_view name);

// "a property", "a material", ...
std::string_view describe(ObjectKind kind);
// The key that distinguishes an object of this kind from the others of its list: "id" of a node; empty if there is
// none.
std::string_view identity_of(ObjectKind kind);
// Whether the order of a list of such objects has a meaning.
bool is_ordered(ObjectKind kind);

// The kind of a file's top-level object, by its "kind"; a material if that is absent or unknown.
ObjectKind top_level_kind(const Json& root);
// The kind of a key's value. It distinguishes a lighting graph from a { "use": ... }.
ObjectKind value_kind(const KeyInfo& key, const Json& value);

}  // namespace patina::graph
