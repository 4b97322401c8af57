// Lists the keys of the graph format, of engines and of JSON options. Each object has its keys in canonical order, with
// their help and the forms of their values. The reader refuses other keys and numbers outside of their limits, `fmt`
// sorts by this order, and the JSON Schema is generated from it.
//
//   for (const KeyInfo& key : keys_of(ObjectKind::Node)) ...   // id, node, expr, in, ...
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string_view>

#include "compiler/json/json.h"

namespace patina::format {

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

// The limit of positions and sizes in metres. A float is still exact to a tenth of a metre there.
inline constexpr double kFarthest = 1e6;

// One form of a value. forms.h has a function for each.
struct Form {
    enum class Of {
        Anything,
        Text,
        Pattern,  // a text that `text`, a regular expression, matches
        Words,    // one of `words`
        Identifier,
        Boolean,
        Integer,  // from `low` to `high`
        Number,
        Numbers,  // an array of `count` numbers
        Color,    // of a scene: #rrggbb, a grey, or three linear numbers
        ColorWithAlpha,
        Object,      // of `kind`
        Objects,     // an array of at most `count` of them; 0: of any number
        Definition,  // of the schema: `text` is its name
        Library,     // which names of the library: "node", "model", "workflow"
        Schema       // `text` is its JSON Schema
    };
    Of of = Of::Anything;
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    std::size_t count = 0;
    ObjectKind kind = ObjectKind::Free;
    std::string_view text{};
    std::span<const std::string_view> words{};
};

// A value has one of them.
struct Forms {
    std::array<Form, 3> all{};
    std::size_t count = 0;

    constexpr Forms() = default;
    constexpr Forms(const Form& only) : all{only}, count(1) {}
    constexpr Forms(const Form& first, const Form& second) : all{first, second}, count(2) {}
    constexpr Forms(const Form& first, const Form& second, const Form& third) : all{first, second, third}, count(3) {}
};

struct KeyInfo {
    std::string_view name;
    std::string_view help;
    Forms value = {};
    bool required = false;  // in addition to the "patina" and "kind" of a file
    bool is_set = false;    // the order of the array has no meaning

    // The kind of the value or, if it is an array, of its elements.
    constexpr ObjectKind holds() const {
        for (const Form& form : value.all)
            if (form.kind != ObjectKind::Free) return form.kind;
        return ObjectKind::Free;
    }
};

// In the order in which `fmt` writes them; empty for Free.
std::span<const KeyInfo> keys_of(ObjectKind kind);
const KeyInfo* find_key(ObjectKind kind, std::string_view name);
// The form of the value of a key that has this one.
const Form& form_of(ObjectKind kind, std::string_view key, Form::Of of);

// "a property", "a material", ...
std::string_view describe(ObjectKind kind);
// The name of such an object in the JSON Schema; empty if it is not there.
std::string_view definition_of(ObjectKind kind);
// The key that distinguishes an object of this kind from the other objects of its list: "id" of a node; empty if there
// is none.
std::string_view identity_of(ObjectKind kind);
// Whether the order of a list of such objects has a meaning.
bool is_ordered(ObjectKind kind);

// The kind of a file's top-level object, by its "kind"; a material if that is absent or unknown.
ObjectKind top_level_kind(const json::Json& root);
// The kind of a key's value. It distinguishes a lighting graph from a { "use": ... }.
ObjectKind value_kind(const KeyInfo& key, const json::Json& value);

}  // namespace patina::format
