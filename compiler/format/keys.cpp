#include "compiler/format/keys.h"

#include <algorithm>
#include <array>

#include "compiler/format/words.h"

namespace patina::graph {
namespace {

constexpr KeyInfo kSchema{"$schema", "the JSON Schema of this format, for editors"};
constexpr KeyInfo kVersion{"patina", "the version of the graph format: 1"};
constexpr KeyInfo kKind{"kind", "what the file is: material, subgraph, lighting, workflow or scene"};
constexpr KeyInfo kName{"name", "the name that people see; default: the name of the file"};
constexpr KeyInfo kHelp{"help", "the purpose, in a sentence or two"};
constexpr KeyInfo kPrecision{"precision", "the precision that nodes compute in: float or half"};
constexpr KeyInfo kProperties{"properties", "values that can be set without compiling again", ObjectKind::Property};
constexpr KeyInfo kNodes{"nodes", "the nodes, each with a unique id", ObjectKind::Node};
constexpr KeyInfo kMeta{"meta", "any data; copied to the reflection"};
constexpr KeyInfo kUi{"ui", "any data for an editor; the compiler ignores it"};

constexpr std::array kMaterial = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"workflow", "the workflow, which defines the surface inputs", ObjectKind::Free, true},
    KeyInfo{"lighting", "the lighting model: a name, a file, or a lighting graph", ObjectKind::LightingUse},
    kPrecision,
    kProperties,
    kNodes,
    KeyInfo{"vertex", "the values that the vertex stage changes: positionOS, normalOS, tangentOS"},
    KeyInfo{"surface", "the surface inputs of the workflow and of the lighting model"},
    KeyInfo{"render", "the render state: kind of surface, culling, depth", ObjectKind::Render},
    KeyInfo{"passes", "extra surfaces, each drawn in its own pass: an outline, a glow", ObjectKind::ExtraPass},
    KeyInfo{"variants", "the combinations of variants that --variants listed compiles", ObjectKind::Free, false, true},
    KeyInfo{"budget", "the most that a stage of a pass may cost; 'patina check' measures it", ObjectKind::Budget},
    kMeta,
    kUi,
};

constexpr std::array kSubgraph = {
    kSchema,     kVersion,
    kKind,       kName,
    kHelp,       kPrecision,
    kProperties, KeyInfo{"inputs", "the inputs of the sub-graph, read as $name", ObjectKind::Input},
    kNodes,      KeyInfo{"outputs", "the outputs of the sub-graph, by port name", ObjectKind::Free, true},
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
    KeyInfo{"direct", "the contribution of one light, evaluated for each light", ObjectKind::Free, true},
    KeyInfo{"indirect", "the contribution of ambient light and reflections, evaluated once"},
    KeyInfo{"final", "the colour of the surface; default: direct + indirect + emission"},
    kMeta,
    kUi,
};

constexpr std::array kWorkflow = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"lighting", "the lighting model of materials that do not set one", ObjectKind::LightingUse},
    KeyInfo{"preview", "the input that a previewed node is connected to; such a workflow has no lighting"},
    KeyInfo{"inputs", "the surface inputs that a material may set", ObjectKind::Input, true},
    kNodes,
    KeyInfo{"surface", "the members of the lighting surface, computed from the inputs", ObjectKind::Free, true},
    kMeta,
    kUi,
};

constexpr std::array kProperty = {
    KeyInfo{"name", "the name in the shader; a graph reads it as $name", ObjectKind::Free, true},
    KeyInfo{"type",
            "float, float2, float3, float4, color, int, bool, enum, float2x2, float3x3, float4x4, gradient, curve, "
            "texture2d, textureCube, texture2dArray, texture3d or sampler",
            ObjectKind::Free, true},
    KeyInfo{"usage", "of a texture: color (sRGB), data (linear) or normal (a tangent-space normal map)"},
    KeyInfo{"handedness", "of a normal map: opengl (green is up, +y) or directx (green is down)"},
    KeyInfo{"swizzle", "of a texture: the channels that are read, one to four of r, g, b, a, 0 and 1"},
    KeyInfo{"values", "of an enum: its values"},
    KeyInfo{"default", "the default value"},
    KeyInfo{"range", "[low, high]: a value outside is a warning; a colour whose high is above 1 is HDR"},
    KeyInfo{"hard", "true: a value outside the range is an error"},
    KeyInfo{"as", "how it is bound: uniform, instance (a value for each instance), specialization or variant"},
    KeyInfo{"tiling", "of a texture2d: true gives it a scale and an offset"},
    KeyInfo{"grid", "of a texture2dArray and a texture3d: [columns, rows] of its layers in the picture"},
    KeyInfo{"sampler", "of a texture: its own sampler, or the name of one that textures share", ObjectKind::Sampler},
    KeyInfo{"label", "the name that an inspector shows"},
    KeyInfo{"group", "the heading in an inspector"},
    KeyInfo{"help", "the effect, in a sentence"},
};

constexpr std::array kNode = {
    KeyInfo{"id", "the name that links use: an identifier", ObjectKind::Free, true},
    KeyInfo{"node", "a library node, ./x.subgraph.json or ./x.node.hlsl"},
    KeyInfo{"in", "the values at its input ports"},
    KeyInfo{"expr", "an expression, instead of a node"},
    KeyInfo{"stage",
            "vertex: computed per vertex and interpolated; fragment: an error where the vertex stage needs it"},
    kPrecision,
    KeyInfo{"note", "a comment, copied into the shader"},
};

constexpr std::array kInput = {
    KeyInfo{"name", "an identifier", ObjectKind::Free, true},
    KeyInfo{"type",
            "float, float2, float3, float4, color, color3, int, bool, float2x2, float3x3, float4x4, gradient, curve, "
            "texture2d, textureCube, texture2dArray, texture3d or sampler",
            ObjectKind::Free, true},
    KeyInfo{"default", "the value if the input is not connected; without a default the input is required"},
    KeyInfo{"range", "[low, high]: a value outside is a warning"},
    KeyInfo{"hard", "true: a value outside the range is an error"},
    KeyInfo{"help", "the effect, in a sentence"},
    KeyInfo{"gives", "of a workflow: the input that this one sets in another form"},
    KeyInfo{"as", "of a workflow: the expression that converts it to the input in 'gives'"},
};

constexpr std::array kSampler = {
    KeyInfo{"wrap", "the wrap mode beyond the edges: repeat, clamp or mirror"},
    KeyInfo{"filter", "the filter between texels: linear or nearest"},
    KeyInfo{"anisotropy", "the anisotropy of the filter, 1 to 16"},
};

constexpr std::array kGradient = {
    KeyInfo{"colors", "1 to 8 keys [time, colour]; times from 0 to 1, ascending", ObjectKind::Free, true},
    KeyInfo{"alphas", "1 to 8 keys [time, alpha]; default: opaque"},
    KeyInfo{"blend", "from key to key: linear, fixed (the next key's value) or perceptual (in OkLab)"},
};

constexpr std::array kCurve = {
    KeyInfo{"keys", "1 to 16 keys [time, value] or [time, value, slope before it, slope after it], in order",
            ObjectKind::Free, true},
};

constexpr std::array kRender = {
    KeyInfo{"surface", "opaque, cutout (with alphaClip), transparent, fade, additive or multiply"},
    KeyInfo{"cull", "the faces that are not drawn: back, front or off"},
    KeyInfo{"depthWrite", "whether the surface writes depth"},
    KeyInfo{"depthTest", "the comparison with the stored depth: lessEqual, ..."},
    KeyInfo{"depthOffset",
            "[factor, units]: the distance that depth is moved away from the camera, as with glPolygonOffset"},
    KeyInfo{"stencil", "the stencil test and the stencil operations", ObjectKind::Stencil},
    KeyInfo{"queue", "the render queue, 0 to 5000; opaque surfaces have 2000"},
    KeyInfo{"bounds", "the bounds of the displaced mesh: metres around the mesh, or a box in object space"},
    KeyInfo{"materialOverride",
            "whether materials of the engine can change surface, cull, depthWrite, depthTest and alpha clipping"},
};

constexpr std::array kStencil = {
    KeyInfo{"reference", "the value to compare and to write, 0 to 255; default: 0"},
    KeyInfo{"readMask", "the bits to compare, 0 to 255; default: all"},
    KeyInfo{"writeMask", "the bits to write, 0 to 255; default: all"},
    KeyInfo{"test", "the comparison of the reference with the stored value: equal, notEqual, ...; default: always"},
    KeyInfo{"pass", "the operation where the surface is drawn: keep, replace, zero, increment, ...; default: keep"},
    KeyInfo{"fail", "the operation where the stencil test fails; default: keep"},
    KeyInfo{"depthFail", "the operation where only the depth test fails; default: keep"},
};

constexpr std::array kExtraPass = {
    KeyInfo{"name", "the name of the pass: an identifier", ObjectKind::Free, true},
    KeyInfo{"workflow", "the workflow; default: the material's"},
    KeyInfo{"lighting", "the lighting model; default: the material's, or that of the pass's own workflow",
            ObjectKind::LightingUse},
    KeyInfo{"vertex", "the values that the vertex stage changes; default: the material's"},
    KeyInfo{"surface", "the surface inputs; default: the material's, or the defaults of the pass's own workflow"},
    KeyInfo{"render", "the render state; default: the material's", ObjectKind::Render},
};

constexpr std::array kLightingUse = {
    KeyInfo{"use", "the lighting model: a name or a file", ObjectKind::Free, true},
    KeyInfo{"in", "values for the properties of the model"},
};

constexpr std::array kBudget = {
    KeyInfo{"maxInstructions", "the most SPIR-V instructions of a stage of any pass"},
    KeyInfo{"maxTextures", "the most texture reads of a stage of any pass"},
};

// --- scenes

constexpr KeyInfo kPosition{"position", "the position in metres: [x, y, z], y up"};
constexpr KeyInfo kColor{"color", "\"#rrggbb\", or linear: a number for grey, or [r, g, b]"};

constexpr std::array kScene = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"camera", "the camera", ObjectKind::Camera, true},
    KeyInfo{"ambient", "the ambient light: studio, none, a colour, or sky, horizon and ground", ObjectKind::Ambient},
    KeyInfo{
        "environment",
        "the surroundings: studio, none to reflect the ambient light, or a picture: its file, or file, rotation and "
        "intensity",
        ObjectKind::Environment},
    KeyInfo{"probes", "reflection probes: what objects near them reflect instead of the environment",
            ObjectKind::Probe},
    KeyInfo{"fog", "the fog", ObjectKind::Fog},
    KeyInfo{"mixedLighting", "the combination of real-time shadows and baked light", ObjectKind::MixedLighting},
    KeyInfo{"background",
            "what is behind everything: a colour, env (the surroundings), or blur (the same out of focus)"},
    KeyInfo{"time", "the value of @time, in seconds"},
    KeyInfo{"pixelLightCount", "the number of lights that an additive path computes per pixel, 0 to 16; default: 4"},
    KeyInfo{"lights", "the lights, at most 16", ObjectKind::Light},
    KeyInfo{"materials", "the materials: graphs with values for their properties", ObjectKind::SceneMaterial},
    KeyInfo{"objects", "the objects: meshes with a position and a material", ObjectKind::SceneObject, true},
    kMeta,
    kUi,
};

constexpr std::array kCamera = {
    KeyInfo{"position", kPosition.help, ObjectKind::Free, true},
    KeyInfo{"target", "the point that the camera looks at; default: [0, 0, 0]"},
    KeyInfo{"up", "the direction that is up in the picture, of any length; default: [0, 1, 0]"},
    KeyInfo{"fov", "the vertical field of view in degrees, 1 to 170; default: 30"},
    KeyInfo{"orthographic", "orthographic projection, instead of fov: the height of the picture in metres"},
    KeyInfo{"near", "the distance of the near plane in metres; default: 0.05"},
    KeyInfo{"far", "the distance of the far plane in metres; default: 100"},
};

constexpr std::array kEnvironment = {
    KeyInfo{"file", "the picture, relative to the scene's folder: equirectangular, or the faces of a cube",
            ObjectKind::Free, true},
    KeyInfo{"rotation", "degrees about the y axis, counter-clockwise seen from above; default: 0"},
    KeyInfo{"intensity", "the factor of its light; default: 1"},
};

constexpr std::array kProbe = {
    KeyInfo{"environment", "the picture around its position: its file, or file, rotation and intensity",
            ObjectKind::Environment, true},
    KeyInfo{"position", "where the picture was taken, in metres: [x, y, z], inside the box; default: its middle"},
    KeyInfo{"box", "where objects reflect it", ObjectKind::ProbeBox, true},
    KeyInfo{"blend", "the metres outside of the box over which it fades; default: 0"},
    KeyInfo{"boxProjection", "true: what the picture shows is at the walls of the box; false: far away; default: true"},
    KeyInfo{"importance", "a number from 0 to 1000: of two probes, the more important one hides the other; default: 1"},
};

constexpr std::array kProbeBox = {
    KeyInfo{"min", "the corner with the smallest coordinates, in metres: [x, y, z]", ObjectKind::Free, true},
    KeyInfo{"max", "the corner with the largest coordinates", ObjectKind::Free, true},
};

constexpr std::array kAmbient = {
    KeyInfo{"sky", "the light from above"},
    KeyInfo{"horizon", "the light from the sides"},
    KeyInfo{"ground", "the light from below"},
};

constexpr std::array kFog = {
    KeyInfo{"mode", "linear, exp or exp2", ObjectKind::Free, true},
    kColor,
    KeyInfo{"density", "exp and exp2: the density per metre; default: 0.05"},
    KeyInfo{"start", "linear: the distance in metres where the fog begins; default: 5"},
    KeyInfo{"end", "linear: the distance in metres where the fog hides everything; default: 50"},
};

constexpr std::array kMixedLighting = {
    KeyInfo{"mode", "shadowMask, distanceShadowMask or subtractive", ObjectKind::Free, true},
    KeyInfo{"shadowColor", "subtractive: the darkest colour of a shadow on a lightmap; default: black"},
    KeyInfo{"shadowDistance", "the distance in metres where real-time shadows end; default: unlimited"},
    KeyInfo{"shadowFade", "the metres before shadowDistance over which shadows fade; default: a fifth of it"},
};

constexpr std::array kLight = {
    KeyInfo{"type", "directional, point or spot", ObjectKind::Free, true},
    kPosition,
    KeyInfo{"direction", "directional: the direction to the light; spot: the direction that it points in"},
    kColor,
    KeyInfo{"intensity", "the factor of the colour; default: 1"},
    KeyInfo{"range", "point and spot: the reach of the light in metres; default: 10"},
    KeyInfo{"inner", "spot: the angle from the axis with full light, in degrees; default: 20"},
    KeyInfo{"outer", "spot: the angle from the axis where the light ends, in degrees; default: 30"},
    KeyInfo{"renderMode", "auto, important (always per pixel) or notImportant"},
    KeyInfo{"shadow", "directional and spot: true, or the settings of the shadow", ObjectKind::Shadow},
    KeyInfo{"cookie", "directional and spot: a picture whose red channel scales the light"},
    KeyInfo{"cookieSize", "directional: the width of the cookie in metres; default: 10"},
};

constexpr std::array kShadow = {
    KeyInfo{"strength", "the darkness, 0 to 1; default: 1"},
    KeyInfo{"bias", "the bias along the light's direction in metres; default: 0.05"},
    KeyInfo{"normalBias", "the bias along the normal in texels of the shadow map; default: 0.4"},
};

constexpr std::array kSceneMaterial = {
    KeyInfo{"name", "the name that objects use: an identifier", ObjectKind::Free, true},
    KeyInfo{"graph", "the file of the graph, relative to the scene's folder", ObjectKind::Free, true},
    KeyInfo{"set", "values of the graph's properties"},
};

constexpr std::array kSceneObject = {
    KeyInfo{"id", "a unique name: an identifier", ObjectKind::Free, true},
    KeyInfo{"mesh", "sphere, plane, cube, capsule, torus, or a glTF file: model.glb, model.glb#Node", ObjectKind::Free,
            true},
    KeyInfo{"segments", "the number of segments of the mesh, 3 to 512"},
    KeyInfo{"material", "the name of a material of this scene", ObjectKind::Free, true},
    kPosition,
    KeyInfo{"rotation", "the angles about the axes in degrees, [x, y, z]; applied about z, then x, then y"},
    KeyInfo{"scale", "the scale: a number, or one for each axis; greater than 0"},
    KeyInfo{"lightmap", "a picture of baked light, read at the mesh's second texture coordinates"},
    KeyInfo{"lightmapEncoding", "the encoding of the lightmap: hdr (not encoded), rgbm or dldr; default: hdr"},
    KeyInfo{"shadowMask", "a picture with the baked shadows of four lights"},
    KeyInfo{"instances", "the instances: the object is drawn once for each", ObjectKind::SceneInstance},
};

constexpr std::array kSceneInstance = {
    KeyInfo{"position", "the position relative to the object, in metres"},
    KeyInfo{"rotation", "the angles about the axes in degrees, as of an object"},
    KeyInfo{"scale", "the scale: a number, or one for each axis; greater than 0"},
    KeyInfo{"set", "values of the properties with \"as\": \"instance\""},
};

// --- nodes/engines/NAME/engine.json

constexpr std::array kEngine = {
    kVersion,
    KeyInfo{"name", "the name of the engine that people see", ObjectKind::Free, true},
    KeyInfo{"help", "the output for this engine, in a sentence", ObjectKind::Free, true},
    KeyInfo{"languages", "the languages that its shaders can be written in", ObjectKind::Free, true},
    KeyInfo{"file", "the format of the file that holds all passes; default: each stage has its own file"},
    KeyInfo{"passes", "the file of its own passes; default: it draws the library's paths"},
    KeyInfo{"paths", "the rendering paths that its own passes are for; the first is the default"},
    KeyInfo{"include", "a file with text that its files can include in parts"},
    KeyInfo{"variants", "chosen: the shaders hold one combination; keywords: they hold all combinations"},
    KeyInfo{"instances", "arrays: uniform blocks hold instances; engine: the engine's own text holds them"},
    KeyInfo{"sets", "the descriptor sets and bindings, by owner", ObjectKind::EngineSets, true},
    KeyInfo{"blocks", "the names of uniform blocks in this engine, by the library's names"},
    KeyInfo{"vertexInputs", "the vertex inputs of its meshes", ObjectKind::EngineVertexInput},
    KeyInfo{"clip", "the conventions of clip space", ObjectKind::EngineClip, true},
    KeyInfo{"matrices", "the order of matrices in uniform blocks: columns or rows", ObjectKind::Free, true},
    KeyInfo{"uvOrigin", "the corner of a texture with the coordinates (0, 0), on the left: top (default) or bottom"},
    KeyInfo{"storage", "the types that it stores material values as, by type"},
    KeyInfo{"sharedSamplers", "true (default): a sampler can serve several textures; false: each texture has its own"},
    KeyInfo{"textureSizes", "the suffix that makes the name of a texture's size from the texture's name"},
    KeyInfo{"limits", "the limits of its shaders", ObjectKind::EngineLimits, true},
    KeyInfo{"names", "the names that shaders must not use", ObjectKind::EngineNames},
};
constexpr std::array kEngineSets = {
    KeyInfo{"engine", "values of camera, frame, object and lights", ObjectKind::EngineSet, true},
    KeyInfo{"material", "properties of the material", ObjectKind::EngineSet, true},
    KeyInfo{"targets", "targets of other passes", ObjectKind::EngineSet, true},
};
constexpr std::array kEngineSet = {
    KeyInfo{"set", "the descriptor set", ObjectKind::Free, true},
    KeyInfo{"buffers", "the binding of the first uniform block; default: 0"},
    KeyInfo{"textures", "the binding of the first texture; default: after the buffers"},
    KeyInfo{"samplers", "the binding of the first sampler; default: after the textures"},
};
constexpr std::array kEngineVertexInput = {
    KeyInfo{"semantic", "the semantic of the library: positionOS", ObjectKind::Free, true},
    KeyInfo{"hlsl", "the HLSL semantic: POSITION; default: TEXCOORD and the location"},
    KeyInfo{"location", "the location; default: the inputs that a pass reads are numbered in order"},
};
constexpr std::array kEngineClip = {
    KeyInfo{"depth", "z of what the camera sees: nearToFar (0 to 1), reversed (1 to 0) or symmetric (-1 to 1)",
            ObjectKind::Free, true},
};
constexpr std::array kEngineLimits = {
    KeyInfo{"varyings", "the number of vectors from the vertex stage to the fragment stage", ObjectKind::Free, true},
    KeyInfo{"varyingsNote", "a note that says which of them the engine uses itself"},
    KeyInfo{"blockBytes", "the size in bytes of a uniform block that most devices take", ObjectKind::Free, true},
    KeyInfo{"guaranteedBlockBytes", "the size that all devices take; default: the same"},
    KeyInfo{"samplers", "the number of samplers of a stage, those of the engine's own text included"},
};
constexpr std::array kEngineNames = {
    KeyInfo{"owner", "the text that names the owner of the taken names in messages", ObjectKind::Free, true},
    KeyInfo{"taken", "names that the engine's text declares"},
    KeyInfo{"prefixes", "prefixes of names that belong to the engine"},
    KeyInfo{"own", "names that the written file declares"},
    KeyInfo{"ownNearProperties", "names that only properties must not have"},
    KeyInfo{"instead", "the names of library functions in this engine, by the library's names"},
};
constexpr std::array kOptions = {
    KeyInfo{"targets", "languages and engines that shaders are made for"},
    KeyInfo{"path", "the rendering path"},
    KeyInfo{"passes", "the passes that are wanted, instead of all of the path"},
    KeyInfo{"preview", "a port that is shown instead of the surface"},
    KeyInfo{"functions", "a prefix: functions are made instead of passes"},
    KeyInfo{"switches", "values of switches, variants and specialization constants"},
    KeyInfo{"lighting", "a lighting model in place of the graph's own"},
    KeyInfo{"includeDirs", "folders that are searched after the graph's own"},
    KeyInfo{"root", "a folder: no file outside of it is read"},
    KeyInfo{"keepVariants", "shaders keep all values of variants without a value"},
    KeyInfo{"acceptParts", "a lighting graph or a sub-graph is compiled, too"},
    KeyInfo{"hashes", "the reflection has the hash of each pass"},
    KeyInfo{"limits", "the most that a compilation may need", ObjectKind::OptionsLimits},
};
constexpr std::array kOptionsLimits = {
    KeyInfo{"nodes", "nodes of the graph, and of each use of a sub-graph"},
    KeyInfo{"instructions", "instructions of nodes, functions and passes"},
    KeyInfo{"sourceBytes", "bytes of all texts that are read"},
    KeyInfo{"shaderBytes", "bytes of all texts that are written"},
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
        case ObjectKind::Gradient: return kGradient;
        case ObjectKind::Curve: return kCurve;
        case ObjectKind::Render: return kRender;
        case ObjectKind::Stencil: return kStencil;
        case ObjectKind::ExtraPass: return kExtraPass;
        case ObjectKind::LightingUse: return kLightingUse;
        case ObjectKind::Budget: return kBudget;
        case ObjectKind::Scene: return kScene;
        case ObjectKind::Camera: return kCamera;
        case ObjectKind::Ambient: return kAmbient;
        case ObjectKind::Environment: return kEnvironment;
        case ObjectKind::Probe: return kProbe;
        case ObjectKind::ProbeBox: return kProbeBox;
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
        case ObjectKind::Options: return kOptions;
        case ObjectKind::OptionsLimits: return kOptionsLimits;
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
        case ObjectKind::Gradient: return "a gradient";
        case ObjectKind::Curve: return "a curve";
        case ObjectKind::Render: return "the render state";
        case ObjectKind::Stencil: return "the stencil state";
        case ObjectKind::ExtraPass: return "a pass";
        case ObjectKind::LightingUse: return "a use of a lighting model";
        case ObjectKind::Budget: return "a budget";
        case ObjectKind::Scene: return "a scene";
        case ObjectKind::Camera: return "a camera";
        case ObjectKind::Ambient: return "ambient light";
        case ObjectKind::Environment: return "an environment";
        case ObjectKind::Probe: return "a probe";
        case ObjectKind::ProbeBox: return "the box of a probe";
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
        case ObjectKind::Options: return "the options";
        case ObjectKind::OptionsLimits: return "'limits'";
    }
    return {};
}

std::string_view identity_of(ObjectKind kind) {
    if (kind == ObjectKind::Node || kind == ObjectKind::SceneObject) return "id";
    const bool has_name = kind == ObjectKind::Property || kind == ObjectKind::Input || kind == ObjectKind::ExtraPass ||
                          kind == ObjectKind::SceneMaterial;
    return has_name ? "name" : "";
}

bool is_ordered(ObjectKind kind) {
    // A block holds properties in their order, and passes of one queue are drawn in theirs.
    return kind == ObjectKind::Property || kind == ObjectKind::ExtraPass;
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
