#include "compiler/format/keys.h"

#include <algorithm>
#include <array>

#include "compiler/format/words.h"

namespace patina::graph {
namespace {

constexpr KeyInfo kSchema{"$schema", "where an editor finds the JSON Schema of this format"};
constexpr KeyInfo kVersion{"patina", "the version of the graph format: 1"};
constexpr KeyInfo kKind{"kind", "what the file is: material, subgraph, lighting, workflow or scene"};
constexpr KeyInfo kName{"name", "what people call it; otherwise the name of the file"};
constexpr KeyInfo kHelp{"help", "what it is for, in a sentence or two"};
constexpr KeyInfo kPrecision{"precision", "float or half: what the nodes compute in"};
constexpr KeyInfo kProperties{"properties", "values that can be set without compiling again", ObjectKind::Property};
constexpr KeyInfo kNodes{"nodes", "the nodes, each with an id of its own", ObjectKind::Node};
constexpr KeyInfo kMeta{"meta", "anything; carried through to the reflection"};
constexpr KeyInfo kUi{"ui", "anything; for an editor, ignored by the compiler"};

constexpr std::array kMaterial = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"workflow", "which surface inputs the material has", ObjectKind::Free, true},
    KeyInfo{"lighting", "the lighting model: a name, a file, or a lighting graph", ObjectKind::LightingUse},
    kPrecision,
    kProperties,
    kNodes,
    KeyInfo{"vertex", "what the vertex stage moves: positionOS, normalOS, tangentOS"},
    KeyInfo{"surface", "the surface inputs of the workflow and of the lighting model"},
    KeyInfo{"render", "how the surface is drawn: opaque or cutout, culling, depth", ObjectKind::Render},
    KeyInfo{"passes", "further surfaces, each drawn in a pass of its own: an outline, a glow", ObjectKind::ExtraPass},
    KeyInfo{"variants", "the combinations of variants that --variants listed compiles"},
    kMeta,
    kUi,
};

constexpr std::array kSubgraph = {
    kSchema,     kVersion,
    kKind,       kName,
    kHelp,       kPrecision,
    kProperties, KeyInfo{"inputs", "what the sub-graph takes, read as $name", ObjectKind::Input},
    kNodes,      KeyInfo{"outputs", "what the sub-graph gives, by port name", ObjectKind::Free, true},
    kMeta,       kUi,
};

constexpr std::array kLighting = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    kPrecision,
    KeyInfo{"surface", "surface inputs that the model adds, read as @surface.name", ObjectKind::Input},
    kProperties,
    kNodes,
    KeyInfo{"direct", "what one light adds, evaluated for each light", ObjectKind::Free, true},
    KeyInfo{"indirect", "what ambient light and reflections add, evaluated once"},
    KeyInfo{"final", "the colour that leaves the surface; otherwise both sums and the emission"},
    kMeta,
    kUi,
};

constexpr std::array kWorkflow = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"lighting", "the lighting model of a material that names none", ObjectKind::LightingUse},
    KeyInfo{"preview", "the input that shows a previewed node"},
    KeyInfo{"inputs", "the surface inputs that a material may set", ObjectKind::Input, true},
    kNodes,
    KeyInfo{"surface", "the members of the lighting surface, computed from the inputs", ObjectKind::Free, true},
    kMeta,
    kUi,
};

constexpr std::array kProperty = {
    KeyInfo{"name", "the name in the shader; a graph reads it as $name", ObjectKind::Free, true},
    KeyInfo{"type", "float, float2, float3, float4, color, int, bool, enum or texture2d", ObjectKind::Free, true},
    KeyInfo{"usage", "of a texture: color (sRGB), data (linear) or normal (a tangent-space normal map)"},
    KeyInfo{"values", "of an enum: its words"},
    KeyInfo{"default", "the value until somebody sets another"},
    KeyInfo{"range", "[low, high]: beyond it is a warning; of a colour that ends above 1: it is HDR"},
    KeyInfo{"hard", "true: beyond the range is an error"},
    KeyInfo{"as", "when it is bound: uniform, instance (a value for each instance), specialization or variant"},
    KeyInfo{"tiling", "of a texture: true gives it a scale and an offset"},
    KeyInfo{"sampler", "of a texture: how it is read", ObjectKind::Sampler},
    KeyInfo{"label", "what an inspector shows"},
    KeyInfo{"group", "the heading that an inspector shows it under"},
    KeyInfo{"help", "what it does, in a sentence"},
};

constexpr std::array kNode = {
    KeyInfo{"id", "the name that links use; an identifier", ObjectKind::Free, true},
    KeyInfo{"node", "a library node, ./x.subgraph.json or ./x.node.hlsl"},
    KeyInfo{"in", "the values at its input ports"},
    KeyInfo{"expr", "an expression, in place of a node"},
    KeyInfo{"stage", "vertex: computed there, and its readers get it interpolated; fragment: never for vertices"},
    kPrecision,
    KeyInfo{"note", "a remark, copied into the shader"},
};

constexpr std::array kInput = {
    KeyInfo{"name", "an identifier", ObjectKind::Free, true},
    KeyInfo{"type", "float, float2, float3, float4, color, int, bool or texture2d", ObjectKind::Free, true},
    KeyInfo{"default", "the value if it is left open; without one it must be given"},
    KeyInfo{"range", "[low, high]: beyond it is a warning"},
    KeyInfo{"hard", "true: beyond the range is an error"},
    KeyInfo{"help", "what it does, in a sentence"},
    KeyInfo{"gives", "of a workflow: the input that this one is another way to say"},
    KeyInfo{"as", "of a workflow: an expression that converts it to the one it gives"},
};

constexpr std::array kSampler = {
    KeyInfo{"wrap", "beyond the edges: repeat, clamp or mirror"},
    KeyInfo{"filter", "between the texels: linear or nearest"},
    KeyInfo{"anisotropy", "1 to 16 samples along a slanted surface"},
};

constexpr std::array kRender = {
    KeyInfo{"surface", "opaque, or cutout with alphaClip"},
    KeyInfo{"cull", "the faces that are not drawn: back, front or off"},
    KeyInfo{"depthWrite", "whether it hides what is behind it"},
    KeyInfo{"depthTest", "how its depth compares to what is there: lessEqual, ..."},
    KeyInfo{"depthOffset", "[factor, units]: how far its depth is moved away from the camera, as glPolygonOffset does"},
    KeyInfo{"stencil", "which pixels it is drawn at, and how it marks them", ObjectKind::Stencil},
    KeyInfo{"queue", "the order of drawing, 0 to 5000; opaque surfaces are at 2000"},
    KeyInfo{"bounds", "where the vertex stage moves the mesh: metres around it, or a box in object space"},
};

constexpr std::array kStencil = {
    KeyInfo{"reference", "the number that is compared and written, 0 to 255; 0 otherwise"},
    KeyInfo{"readMask", "the bits that are compared, 0 to 255; all otherwise"},
    KeyInfo{"writeMask", "the bits that are written, 0 to 255; all otherwise"},
    KeyInfo{"test", "how the reference compares to what is there: equal, notEqual, ...; always otherwise"},
    KeyInfo{"pass",
            "what becomes of it where the surface is drawn: keep, replace, zero, increment, ...; keep otherwise"},
    KeyInfo{"fail", "what becomes of it where the stencil test fails; keep otherwise"},
    KeyInfo{"depthFail", "what becomes of it where only the depth test fails; keep otherwise"},
};

constexpr std::array kExtraPass = {
    KeyInfo{"name", "the pass's name; an identifier", ObjectKind::Free, true},
    KeyInfo{"workflow", "which surface inputs it has; the material's otherwise"},
    KeyInfo{"lighting", "its lighting model; the material's otherwise, or that of its own workflow",
            ObjectKind::LightingUse},
    KeyInfo{"vertex", "what the vertex stage moves; as the material's otherwise"},
    KeyInfo{"surface", "its surface inputs; as the material's otherwise, or the defaults of its own workflow"},
    KeyInfo{"render", "how it is drawn; as the material otherwise", ObjectKind::Render},
};

constexpr std::array kLightingUse = {
    KeyInfo{"use", "the lighting model: a name or a file", ObjectKind::Free, true},
    KeyInfo{"in", "values at the model's inputs"},
};

// --- scenes

constexpr KeyInfo kPosition{"position", "where it is, in metres: [x, y, z], y up"};
constexpr KeyInfo kColor{"color", "\"#rrggbb\", or linear: a grey or [r, g, b]"};

constexpr std::array kScene = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"camera", "where the scene is seen from", ObjectKind::Camera, true},
    KeyInfo{"ambient", "light from all around: studio, none, a colour, or sky, horizon and ground",
            ObjectKind::Ambient},
    KeyInfo{"environment", "what mirrors show: studio, or none for what the ambient light says"},
    KeyInfo{"fog", "what distance does to colours", ObjectKind::Fog},
    KeyInfo{"mixedLighting", "how real-time shadows agree with baked light", ObjectKind::MixedLighting},
    KeyInfo{"background", "the colour behind everything"},
    KeyInfo{"time", "seconds; what @time is"},
    KeyInfo{"pixelLightCount", "how many lights an additive path computes per pixel, 0 to 16; 4 otherwise"},
    KeyInfo{"lights", "the lights, at most 16", ObjectKind::Light},
    KeyInfo{"materials", "graphs by name, with values for their properties", ObjectKind::SceneMaterial},
    KeyInfo{"objects", "meshes, each with a place and a material", ObjectKind::SceneObject, true},
    kMeta,
    kUi,
};

constexpr std::array kCamera = {
    KeyInfo{"position", kPosition.help, ObjectKind::Free, true},
    KeyInfo{"target", "the point that it looks at; [0, 0, 0] otherwise"},
    KeyInfo{"fov", "vertical field of view in degrees, 1 to 170; 30 otherwise"},
    KeyInfo{"orthographic", "parallel projection, in place of fov: the height of the picture in metres"},
    KeyInfo{"near", "metres to where the picture begins; 0.05 otherwise"},
    KeyInfo{"far", "metres to where it ends; 100 otherwise"},
};

constexpr std::array kAmbient = {
    KeyInfo{"sky", "the colour that comes from above"},
    KeyInfo{"horizon", "the colour that comes from the sides"},
    KeyInfo{"ground", "the colour that comes from below"},
};

constexpr std::array kFog = {
    KeyInfo{"mode", "linear, exp or exp2", ObjectKind::Free, true},
    kColor,
    KeyInfo{"density", "exp and exp2: per metre; 0.05 otherwise"},
    KeyInfo{"start", "linear: metres to where it begins; 5 otherwise"},
    KeyInfo{"end", "linear: metres to where nothing else is seen; 50 otherwise"},
};

constexpr std::array kMixedLighting = {
    KeyInfo{"mode", "shadowMask, distanceShadowMask or subtractive", ObjectKind::Free, true},
    KeyInfo{"shadowColor", "subtractive: the colour that no shadow falls below on a lightmap; black otherwise"},
    KeyInfo{"shadowDistance", "metres to where real-time shadows end; otherwise they do not"},
    KeyInfo{"shadowFade", "metres before that over which they fade; a fifth of it otherwise"},
};

constexpr std::array kLight = {
    KeyInfo{"type", "directional, point or spot", ObjectKind::Free, true},
    kPosition,
    KeyInfo{"direction", "directional: towards the light; spot: where it points"},
    kColor,
    KeyInfo{"intensity", "what the colour is multiplied by; 1 otherwise"},
    KeyInfo{"range", "point and spot: metres, no light beyond; 10 otherwise"},
    KeyInfo{"inner", "spot: degrees from its axis with full light; 20 otherwise"},
    KeyInfo{"outer", "spot: degrees from its axis beyond which there is none; 30 otherwise"},
    KeyInfo{"renderMode", "auto, important (always per pixel) or notImportant"},
    KeyInfo{"shadow", "directional and spot: true, or how", ObjectKind::Shadow},
    KeyInfo{"cookie", "directional and spot: a picture that it shines through, whose red is what is let through"},
    KeyInfo{"cookieSize", "directional: metres that the cookie spans; 10 otherwise"},
};

constexpr std::array kShadow = {
    KeyInfo{"strength", "how dark, 0 to 1; 1 otherwise"},
    KeyInfo{"bias", "metres along the light's direction; 0.05 otherwise"},
    KeyInfo{"normalBias", "texels of the shadow map that surfaces shrink by; 0.4 otherwise"},
};

constexpr std::array kSceneMaterial = {
    KeyInfo{"name", "what objects call it; an identifier", ObjectKind::Free, true},
    KeyInfo{"graph", "a file, from the scene's folder", ObjectKind::Free, true},
    KeyInfo{"set", "values of the graph's properties"},
};

constexpr std::array kSceneObject = {
    KeyInfo{"id", "its own name; an identifier", ObjectKind::Free, true},
    KeyInfo{"mesh", "sphere, plane, cube, capsule or torus", ObjectKind::Free, true},
    KeyInfo{"segments", "how fine the mesh is, 3 to 512"},
    KeyInfo{"material", "the name of a material of this scene", ObjectKind::Free, true},
    kPosition,
    KeyInfo{"rotation", "degrees about the axes, [x, y, z]; it is turned about z, then x, then y"},
    KeyInfo{"scale", "a number, or one for each axis; greater than 0"},
    KeyInfo{"lightmap", "a picture of baked light, by the mesh's second texture coordinates"},
    KeyInfo{"lightmapEncoding", "how the lightmap holds light: hdr (as it is), rgbm or dldr; hdr otherwise"},
    KeyInfo{"shadowMask", "a picture of the baked shadows of four lights"},
    KeyInfo{"instances", "it is drawn once at each of these places", ObjectKind::SceneInstance},
};

constexpr std::array kSceneInstance = {
    KeyInfo{"position", "where it is within the object, in metres"},
    KeyInfo{"rotation", "degrees about the axes, as an object's"},
    KeyInfo{"scale", "a number, or one for each axis; greater than 0"},
    KeyInfo{"set", "values of properties that each instance has"},
};

// --- nodes/engines/NAME/engine.json

constexpr std::array kEngine = {
    kVersion,
    KeyInfo{"name", "what people call the engine", ObjectKind::Free, true},
    KeyInfo{"help", "what comes out for it, in a sentence", ObjectKind::Free, true},
    KeyInfo{"languages", "languages that its shaders can be written in", ObjectKind::Free, true},
    KeyInfo{"file", "the format of the file that holds all passes; otherwise each stage is a file"},
    KeyInfo{"passes", "the file of its own rendering path; otherwise it draws the library's paths"},
    KeyInfo{"include", "a file with text that its files may need a part of"},
    KeyInfo{"variants", "chosen: the shaders hold one combination; keywords: they hold all"},
    KeyInfo{"instances", "arrays: uniform blocks hold them; engine: the engine's own text does"},
    KeyInfo{"sets", "descriptor sets and bindings, by owner", ObjectKind::EngineSets, true},
    KeyInfo{"blocks", "what uniform blocks are called here, by the library's names"},
    KeyInfo{"vertexInputs", "what its meshes have", ObjectKind::EngineVertexInput},
    KeyInfo{"clip", "the conventions of clip space", ObjectKind::EngineClip, true},
    KeyInfo{"matrices", "how matrices lie in uniform blocks: columns or rows", ObjectKind::Free, true},
    KeyInfo{"storage", "how it keeps values of materials, by type"},
    KeyInfo{"textureSizes", "what the size of a texture is called, behind the texture's name"},
    KeyInfo{"samplers", "what samplers are called after: ofProperties or ofTextures"},
    KeyInfo{"limits", "what shaders must not exceed", ObjectKind::EngineLimits, true},
    KeyInfo{"names", "names that are taken", ObjectKind::EngineNames},
};
constexpr std::array kEngineSets = {
    KeyInfo{"engine", "values of camera, frame, object and lights", ObjectKind::EngineSet, true},
    KeyInfo{"material", "properties of the material", ObjectKind::EngineSet, true},
    KeyInfo{"targets", "targets of other passes", ObjectKind::EngineSet, true},
};
constexpr std::array kEngineSet = {
    KeyInfo{"set", "the descriptor set", ObjectKind::Free, true},
    KeyInfo{"buffers", "binding of the first uniform block; 0 otherwise"},
    KeyInfo{"textures", "binding of the first texture; otherwise they follow the buffers"},
    KeyInfo{"samplers", "binding of the first sampler; otherwise they follow the textures"},
};
constexpr std::array kEngineVertexInput = {
    KeyInfo{"semantic", "of the library: positionOS", ObjectKind::Free, true},
    KeyInfo{"hlsl", "its HLSL semantic: POSITION", ObjectKind::Free, true},
    KeyInfo{"location", "its location; otherwise those that a pass reads are numbered in order"},
};
constexpr std::array kEngineClip = {
    KeyInfo{"depth", "z of what the camera sees: nearToFar (0 to 1) or reversed (1 to 0)", ObjectKind::Free, true},
};
constexpr std::array kEngineLimits = {
    KeyInfo{"varyings", "vectors from the vertex stage to the fragment stage", ObjectKind::Free, true},
    KeyInfo{"varyingsNote", "what of the engine's own takes some of them"},
    KeyInfo{"blockBytes", "bytes of a uniform block", ObjectKind::Free, true},
};
constexpr std::array kEngineNames = {
    KeyInfo{"owner", "who declares the taken names, in words", ObjectKind::Free, true},
    KeyInfo{"taken", "names that the engine's text declares"},
    KeyInfo{"prefixes", "all names that begin so are the engine's"},
    KeyInfo{"own", "names that the written file declares"},
    KeyInfo{"ownNearProperties", "names that only properties must not have"},
    KeyInfo{"instead", "what functions of the library are called here"},
};

}  // namespace

std::span<const KeyInfo> keys_of(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::Free: return {};
        case ObjectKind::Material: return kMaterial;
        case ObjectKind::Subgraph: return kSubgraph;
        case ObjectKind::Lighting: return kLighting;
        case ObjectKind::Workflow: return kWorkflow;
        case ObjectKind::Property: return kProperty;
        case ObjectKind::Node: return kNode;
        case ObjectKind::Input: return kInput;
        case ObjectKind::Sampler: return kSampler;
        case ObjectKind::Render: return kRender;
        case ObjectKind::Stencil: return kStencil;
        case ObjectKind::ExtraPass: return kExtraPass;
        case ObjectKind::LightingUse: return kLightingUse;
        case ObjectKind::Scene: return kScene;
        case ObjectKind::Camera: return kCamera;
        case ObjectKind::Ambient: return kAmbient;
        case ObjectKind::Fog: return kFog;
        case ObjectKind::MixedLighting: return kMixedLighting;
        case ObjectKind::Light: return kLight;
        case ObjectKind::Shadow: return kShadow;
        case ObjectKind::SceneMaterial: return kSceneMaterial;
        case ObjectKind::SceneObject: return kSceneObject;
        case ObjectKind::SceneInstance: return kSceneInstance;
        case ObjectKind::Engine: return kEngine;
        case ObjectKind::EngineSets: return kEngineSets;
        case ObjectKind::EngineSet: return kEngineSet;
        case ObjectKind::EngineVertexInput: return kEngineVertexInput;
        case ObjectKind::EngineClip: return kEngineClip;
        case ObjectKind::EngineLimits: return kEngineLimits;
        case ObjectKind::EngineNames: return kEngineNames;
    }
    return {};
}

const KeyInfo* find_key(ObjectKind kind, std::string_view name) {
    for (const KeyInfo& key : keys_of(kind)) {
        if (key.name == name) return &key;
    }
    return nullptr;
}

std::string_view describe(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::Free: return "an object";
        case ObjectKind::Material: return "a material";
        case ObjectKind::Subgraph: return "a sub-graph";
        case ObjectKind::Lighting: return "a lighting graph";
        case ObjectKind::Workflow: return "a workflow";
        case ObjectKind::Property: return "a property";
        case ObjectKind::Node: return "a node";
        case ObjectKind::Input: return "an input";
        case ObjectKind::Sampler: return "a sampler";
        case ObjectKind::Render: return "the render state";
        case ObjectKind::Stencil: return "the stencil state";
        case ObjectKind::ExtraPass: return "a pass";
        case ObjectKind::LightingUse: return "a use of a lighting model";
        case ObjectKind::Scene: return "a scene";
        case ObjectKind::Camera: return "a camera";
        case ObjectKind::Ambient: return "ambient light";
        case ObjectKind::Fog: return "fog";
        case ObjectKind::MixedLighting: return "mixed lighting";
        case ObjectKind::Light: return "a light";
        case ObjectKind::Shadow: return "a shadow";
        case ObjectKind::SceneMaterial: return "a material of a scene";
        case ObjectKind::SceneObject: return "an object of a scene";
        case ObjectKind::SceneInstance: return "an instance of an object";
        case ObjectKind::Engine: return "an engine";
        case ObjectKind::EngineSets: return "the descriptor sets";
        case ObjectKind::EngineSet: return "a descriptor set";
        case ObjectKind::EngineVertexInput: return "a vertex input";
        case ObjectKind::EngineClip: return "clip space";
        case ObjectKind::EngineLimits: return "the limits";
        case ObjectKind::EngineNames: return "the names";
    }
    return {};
}

ObjectKind top_level_kind(const Json& root) {
    const Json* kind = root.find("kind");
    if (!kind) return ObjectKind::Material;
    return from_word<ObjectKind>(kind->string).value_or(ObjectKind::Material);
}

ObjectKind value_kind(const KeyInfo& key, const Json& value) {
    if (key.holds == ObjectKind::LightingUse && !value.find("use")) return ObjectKind::Lighting;
    return key.holds;
}

}  // namespace patina::graph
