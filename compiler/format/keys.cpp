#include "compiler/format/keys.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/format/forms.h"
#include "patina/scene.h"

namespace patina::format {
namespace {

constexpr std::string_view kVariants =
    R"({"type":"array","items":{"type":"object","additionalProperties":{"anyOf":[{"type":"boolean"},{"type":"string"}]}}})";
constexpr std::string_view kNamedValues = R"({"type":"object","propertyNames":{"$ref":"#/$defs/identifier"},)"
                                          R"("additionalProperties":{"$ref":"#/$defs/value"}})";
constexpr std::string_view kIdentifiers =
    R"({"type":"array","minItems":1,"uniqueItems":true,"items":{"$ref":"#/$defs/identifier"}})";
constexpr std::string_view kGrid =
    R"({"type":"array","items":{"type":"integer","minimum":1,"maximum":256},"minItems":2,"maxItems":2})";
constexpr std::string_view kColorKeys =
    R"({"type":"array","items":{"type":"array","prefixItems":[{"type":"number","minimum":0,"maximum":1},)"
    R"({"anyOf":[{"type":"string","pattern":"^#([0-9a-fA-F]{3}|[0-9a-fA-F]{6})$"},)"
    R"({"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3}]}],"minItems":2,"maxItems":2},)"
    R"("minItems":1,"maxItems":8})";
constexpr std::string_view kAlphaKeys =
    R"({"type":"array","items":{"type":"array","prefixItems":[{"type":"number","minimum":0,"maximum":1},)"
    R"({"type":"number","minimum":0,"maximum":1}],"minItems":2,"maxItems":2},"minItems":1,"maxItems":8})";
constexpr std::string_view kCurveKeys =
    R"({"type":"array","minItems":1,"maxItems":16,"items":{"type":"array","items":{"type":"number"},"minItems":2,"maxItems":4}})";
constexpr std::string_view kBox =
    R"({"type":"array","items":{"type":"array","items":{"type":"number"},"minItems":3,"maxItems":3},)"
    R"("minItems":2,"maxItems":2})";
constexpr std::string_view kSet =
    R"({"type":"object","additionalProperties":{"anyOf":[{"type":"number"},{"type":"boolean"},{"type":"string"},)"
    R"({"type":"array","items":{"type":"number"},"minItems":2,"maxItems":4}]}})";

constexpr KeyInfo kSchema{"$schema", "the JSON Schema of this format, for editors", text()};
constexpr KeyInfo kVersion{"patina", "the version of the graph format: 1", schema(R"({"const":1})")};
constexpr KeyInfo kKind{"kind", "what the file is: material, subgraph, lighting, workflow or scene",
                        words<ObjectKind>()};
constexpr KeyInfo kName{"name", "the name that people see; default: the name of the file", text()};
constexpr KeyInfo kHelp{"help", "the purpose, in a sentence or two", text()};
constexpr KeyInfo kPrecision{"precision", "the precision that nodes compute in: float or half", words<Precision>()};
constexpr KeyInfo kProperties{"properties", "values that can be set without compiling again",
                              objects(ObjectKind::Property)};
constexpr KeyInfo kNodes{"nodes", "the nodes, each with a unique id", objects(ObjectKind::Node)};
constexpr KeyInfo kMeta{"meta", "any data; copied to the reflection"};
constexpr KeyInfo kUi{"ui", "any data for an editor; the compiler ignores it"};

constexpr std::array kMaterial = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"workflow", "the workflow, which defines the surface inputs", library("workflow"), true},
    KeyInfo{"lighting",
            "the lighting model: a name, a file, or a lighting graph",
            {library("model"), object(ObjectKind::LightingUse), definition("lighting")}},
    kPrecision,
    kProperties,
    kNodes,
    KeyInfo{"vertex", "the values that the vertex stage changes: positionOS, normalOS, tangentOS", values()},
    KeyInfo{"surface", "the surface inputs of the workflow and of the lighting model", values()},
    KeyInfo{"render", "the render state: kind of surface, culling, depth", object(ObjectKind::Render)},
    KeyInfo{"passes", "extra surfaces, each drawn in its own pass: an outline, a glow", objects(ObjectKind::ExtraPass)},
    KeyInfo{"variants", "the combinations of variants that --variants listed compiles", schema(kVariants), false, true},
    KeyInfo{"budget", "the most that a stage of a pass may cost; 'patina check' measures it",
            object(ObjectKind::Budget)},
    kMeta,
    kUi,
};

constexpr std::array kSubgraph = {
    kSchema,     kVersion,
    kKind,       kName,
    kHelp,       kPrecision,
    kProperties, KeyInfo{"inputs", "the inputs of the sub-graph, read as $name", objects(ObjectKind::Input)},
    kNodes,      KeyInfo{"outputs", "the outputs of the sub-graph, by port name", schema(kNamedValues), true},
    kMeta,       kUi,
};

constexpr std::array kLighting = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    kPrecision,
    KeyInfo{"surface", "surface inputs that the model adds, read as @surface.name", objects(ObjectKind::Input)},
    kProperties,
    kNodes,
    KeyInfo{"direct", "the contribution of one light, evaluated for each light", value(), true},
    KeyInfo{"indirect", "the contribution of ambient light and reflections, evaluated once", value()},
    KeyInfo{"final", "the colour of the surface; default: direct + indirect + emission", value()},
    kMeta,
    kUi,
};

constexpr std::array kWorkflow = {
    kSchema,
    kVersion,
    kKind,
    kName,
    kHelp,
    KeyInfo{"lighting",
            "the lighting model of materials that do not set one",
            {library("model"), object(ObjectKind::LightingUse), definition("lighting")}},
    KeyInfo{"preview", "the input that a previewed node is connected to; such a workflow has no lighting",
            identifier()},
    KeyInfo{"inputs", "the surface inputs that a material may set", objects(ObjectKind::Input), true},
    kNodes,
    KeyInfo{"surface", "the members of the lighting surface, computed from the inputs", values(), true},
    kMeta,
    kUi,
};

constexpr std::array kProperty = {
    KeyInfo{"name", "the name in the shader; a graph reads it as $name", identifier(), true},
    KeyInfo{"type",
            "float, float2, float3, float4, color, int, bool, enum, float2x2, float3x3, float4x4, gradient, curve, "
            "texture2d, textureCube, texture2dArray, texture3d or sampler",
            words<PropertyType>(), true},
    KeyInfo{"usage", "of a texture: color (sRGB), data (linear) or normal (a tangent-space normal map)",
            words<TextureUsage>()},
    KeyInfo{"handedness", "of a normal map: opengl (green is up, +y) or directx (green is down)", words<Handedness>()},
    KeyInfo{"swizzle", "of a texture: the channels that are read, one to four of r, g, b, a, 0 and 1",
            pattern("^[rgba01]{1,4}$")},
    KeyInfo{"values", "of an enum: its values", schema(kIdentifiers)},
    KeyInfo{"default", "the default value", {any_of(kDefaultTextures), any_of(kSamplerNames), value()}},
    KeyInfo{"range", "[low, high]: a value outside is a warning; a colour whose high is above 1 is HDR", numbers(2)},
    KeyInfo{"hard", "true: a value outside the range is an error", boolean()},
    KeyInfo{"as", "how it is bound: uniform, instance (a value for each instance), specialization or variant",
            words<Binding>()},
    KeyInfo{"tiling", "of a texture2d: true gives it a scale and an offset", boolean()},
    KeyInfo{"grid", "of a texture2dArray and a texture3d: [columns, rows] of its layers in the picture", schema(kGrid)},
    KeyInfo{"sampler",
            "of a texture: its own sampler, or the name of one that textures share",
            {any_of(kSamplerNames), object(ObjectKind::Sampler)}},
    KeyInfo{"label", "the name that an inspector shows", text()},
    KeyInfo{"group", "the heading in an inspector", text()},
    KeyInfo{"help", "the effect, in a sentence", text()},
};

constexpr std::array kNode = {
    KeyInfo{"id", "the name that links use: an identifier", identifier(), true},
    KeyInfo{"node", "a library node, ./x.subgraph.json or ./x.node.hlsl", library("node")},
    KeyInfo{"in", "the values at its input ports", values()},
    KeyInfo{"expr", "an expression, instead of a node", pattern("^[^=]")},
    KeyInfo{"stage", "vertex: computed per vertex and interpolated; fragment: an error where the vertex stage needs it",
            words<NodeStage>()},
    kPrecision,
    KeyInfo{"note", "a comment, copied into the shader", text()},
};

constexpr std::array kInput = {
    KeyInfo{"name", "an identifier", identifier(), true},
    KeyInfo{"type",
            "float, float2, float3, float4, color, color3, int, bool, float2x2, float3x3, float4x4, gradient, curve, "
            "texture2d, textureCube, texture2dArray, texture3d or sampler",
            any_of(kInputTypes), true},
    KeyInfo{"default", "the value if the input is not connected; without a default the input is required", value()},
    KeyInfo{"range", "[low, high]: a value outside is a warning", numbers(2)},
    KeyInfo{"hard", "true: a value outside the range is an error", boolean()},
    KeyInfo{"help", "the effect, in a sentence", text()},
    KeyInfo{"gives", "of a workflow: the input that this one sets in another form", identifier()},
    KeyInfo{"as", "of a workflow: the expression that converts it to the input in 'gives'", pattern("^=")},
};

constexpr std::array kSampler = {
    KeyInfo{"wrap", "the wrap mode beyond the edges: repeat, clamp or mirror", words<Wrap>()},
    KeyInfo{"filter", "the filter between texels: linear or nearest", words<Filter>()},
    KeyInfo{"anisotropy", "the anisotropy of the filter, 1 to 16", integer(1, 16)},
};

constexpr std::array kGradient = {
    KeyInfo{"colors", "1 to 8 keys [time, colour]; times from 0 to 1, ascending", schema(kColorKeys), true},
    KeyInfo{"alphas", "1 to 8 keys [time, alpha]; default: opaque", schema(kAlphaKeys)},
    KeyInfo{"blend", "from key to key: linear, fixed (the next key's value) or perceptual (in OkLab)",
            words<GradientBlend>()},
};

constexpr std::array kCurve = {
    KeyInfo{"keys", "1 to 16 keys [time, value] or [time, value, slope before it, slope after it], in order",
            schema(kCurveKeys), true},
};

constexpr std::array kRender = {
    KeyInfo{"surface", "opaque, cutout (with alphaClip), transparent, fade, additive or multiply",
            words<SurfaceKind>()},
    KeyInfo{"cull", "the faces that are not drawn: back, front or off", words<Cull>()},
    KeyInfo{"depthWrite", "whether the surface writes depth", boolean()},
    KeyInfo{"depthTest", "the comparison with the stored depth: lessEqual, ...", words<Compare>()},
    KeyInfo{"depthOffset",
            "[factor, units]: the distance that depth is moved away from the camera, as with glPolygonOffset",
            numbers(2)},
    KeyInfo{"stencil", "the stencil test and the stencil operations", object(ObjectKind::Stencil)},
    KeyInfo{"queue", "the render queue, 0 to 5000; opaque surfaces have 2000", integer(0, 5000)},
    KeyInfo{"bounds",
            "the bounds of the displaced mesh: metres around the mesh, or a box in object space",
            {number(0, kFarthest), schema(kBox)}},
    KeyInfo{"materialOverride",
            "whether materials of the engine can change surface, cull, depthWrite, depthTest and alpha clipping",
            boolean()},
};

constexpr std::array kStencil = {
    KeyInfo{"reference", "the value to compare and to write, 0 to 255; default: 0", integer(0, 255)},
    KeyInfo{"readMask", "the bits to compare, 0 to 255; default: all", integer(0, 255)},
    KeyInfo{"writeMask", "the bits to write, 0 to 255; default: all", integer(0, 255)},
    KeyInfo{"test", "the comparison of the reference with the stored value: equal, notEqual, ...; default: always",
            words<Compare>()},
    KeyInfo{"pass", "the operation where the surface is drawn: keep, replace, zero, increment, ...; default: keep",
            words<StencilOp>()},
    KeyInfo{"fail", "the operation where the stencil test fails; default: keep", words<StencilOp>()},
    KeyInfo{"depthFail", "the operation where only the depth test fails; default: keep", words<StencilOp>()},
};

constexpr std::array kExtraPass = {
    KeyInfo{"name", "the name of the pass: an identifier", identifier(), true},
    KeyInfo{"workflow", "the workflow; default: the material's", library("workflow")},
    KeyInfo{"lighting",
            "the lighting model; default: the material's, or that of the pass's own workflow",
            {library("model"), object(ObjectKind::LightingUse), definition("lighting")}},
    KeyInfo{"vertex", "the values that the vertex stage changes; default: the material's", values()},
    KeyInfo{"surface", "the surface inputs; default: the material's, or the defaults of the pass's own workflow",
            values()},
    KeyInfo{"render", "the render state; default: the material's", object(ObjectKind::Render)},
};

constexpr std::array kLightingUse = {
    KeyInfo{"use", "the lighting model: a name or a file", library("model"), true},
    KeyInfo{"in", "values for the properties of the model", values()},
};

constexpr std::array kBudget = {
    KeyInfo{"maxInstructions", "the most SPIR-V instructions of a stage of any pass", integer(0, 1'000'000'000)},
    KeyInfo{"maxTextures", "the most texture reads of a stage of any pass", integer(0, 1'000'000'000)},
};

// --- scenes

constexpr KeyInfo kPosition{"position", "the position in metres: [x, y, z], y up", vector()};
constexpr KeyInfo kColor{"color", "\"#rrggbb\", or linear: a number for grey, or [r, g, b]", color()};

constexpr std::array kScene = {
    kSchema,
    kVersion,
    KeyInfo{"kind", kKind.help, schema(R"({"const":"scene"})")},
    kName,
    kHelp,
    KeyInfo{"camera", "the camera", object(ObjectKind::Camera), true},
    KeyInfo{"ambient",
            "the ambient light: studio, none, a colour, or sky, horizon and ground",
            {words<SceneEnvironment>(), color(), object(ObjectKind::Ambient)}},
    KeyInfo{
        "environment",
        "the surroundings: studio, none to reflect the ambient light, or a picture: its file, or file, rotation and "
        "intensity",
        {text(), object(ObjectKind::Environment)}},
    KeyInfo{"probes", "reflection probes: what objects near them reflect instead of the environment",
            objects(ObjectKind::Probe, kMostSceneProbes)},
    KeyInfo{"fog", "the fog", object(ObjectKind::Fog)},
    KeyInfo{"mixedLighting", "the combination of real-time shadows and baked light", object(ObjectKind::MixedLighting)},
    KeyInfo{"background",
            "what is behind everything: a colour, env (the surroundings), or blur (the same out of focus)",
            {words<SceneBackdrop>(), color_with_alpha()}},
    KeyInfo{"time", "the value of @time, in seconds", number()},
    KeyInfo{"pixelLightCount", "the number of lights that an additive path computes per pixel, 0 to 16; default: 4",
            integer(0, kMostSceneLights)},
    KeyInfo{"lights", "the lights, at most 16", objects(ObjectKind::Light, kMostSceneLights)},
    KeyInfo{"materials", "the materials: graphs with values for their properties", objects(ObjectKind::SceneMaterial)},
    KeyInfo{"objects", "the objects: meshes with a position and a material", objects(ObjectKind::SceneObject), true},
    kMeta,
    kUi,
};

constexpr std::array kCamera = {
    KeyInfo{"position", kPosition.help, vector(), true},
    KeyInfo{"target", "the point that the camera looks at; default: [0, 0, 0]", vector()},
    KeyInfo{"up", "the direction that is up in the picture, of any length; default: [0, 1, 0]", vector()},
    KeyInfo{"fov", "the vertical field of view in degrees, 1 to 170; default: 30", number(1, 170)},
    KeyInfo{"orthographic", "orthographic projection, instead of fov: the height of the picture in metres",
            number(1e-3, kFarthest)},
    KeyInfo{"near", "the distance of the near plane in metres; default: 0.05", number(1e-4, kFarthest)},
    KeyInfo{"far", "the distance of the far plane in metres; default: 100", number(1e-3, 10 * kFarthest)},
};

constexpr std::array kEnvironment = {
    KeyInfo{"file", "the picture, relative to the scene's folder: equirectangular, or the faces of a cube", text(),
            true},
    KeyInfo{"rotation", "degrees about the y axis, counter-clockwise seen from above; default: 0", number(-1e5, 1e5)},
    KeyInfo{"intensity", "the factor of its light; default: 1", number(0, kFarthest)},
};

constexpr std::array kProbe = {
    KeyInfo{"environment",
            "the picture around its position: its file, or file, rotation and intensity",
            {text(), object(ObjectKind::Environment)},
            true},
    KeyInfo{"position", "where the picture was taken, in metres: [x, y, z], inside the box; default: its middle",
            vector()},
    KeyInfo{"box", "where objects reflect it", object(ObjectKind::ProbeBox), true},
    KeyInfo{"blend", "the metres outside of the box over which it fades; default: 0", number(0, kFarthest)},
    KeyInfo{"boxProjection", "true: what the picture shows is at the walls of the box; false: far away; default: true",
            boolean()},
    KeyInfo{"importance", "a number from 0 to 1000: of two probes, the more important one hides the other; default: 1",
            integer(0, 1000)},
};

constexpr std::array kProbeBox = {
    KeyInfo{"min", "the corner with the smallest coordinates, in metres: [x, y, z]", vector(), true},
    KeyInfo{"max", "the corner with the largest coordinates", vector(), true},
};

constexpr std::array kAmbient = {
    KeyInfo{"sky", "the light from above", color()},
    KeyInfo{"horizon", "the light from the sides", color()},
    KeyInfo{"ground", "the light from below", color()},
};

constexpr std::array kFog = {
    KeyInfo{"mode", "linear, exp or exp2", words<FogMode>(), true},
    kColor,
    KeyInfo{"density", "exp and exp2: the density per metre; default: 0.05", number(0, kFarthest)},
    KeyInfo{"start", "linear: the distance in metres where the fog begins; default: 5", number(-kFarthest, kFarthest)},
    KeyInfo{"end", "linear: the distance in metres where the fog hides everything; default: 50",
            number(-kFarthest, kFarthest)},
};

constexpr std::array kMixedLighting = {
    KeyInfo{"mode", "shadowMask, distanceShadowMask or subtractive", words<LightMixing>(), true},
    KeyInfo{"shadowColor", "subtractive: the darkest colour of a shadow on a lightmap; default: black", color()},
    KeyInfo{"shadowDistance", "the distance in metres where real-time shadows end; default: unlimited",
            number(1e-3, kFarthest)},
    KeyInfo{"shadowFade", "the metres before shadowDistance over which shadows fade; default: a fifth of it",
            number(1e-3, kFarthest)},
};

constexpr std::array kLight = {
    KeyInfo{"type", "directional, point or spot", words<LightKind>(), true},
    kPosition,
    KeyInfo{"direction", "directional: the direction to the light; spot: the direction that it points in", vector()},
    kColor,
    KeyInfo{"intensity", "the factor of the colour; default: 1", number(0, 1e6)},
    KeyInfo{"range", "point and spot: the reach of the light in metres; default: 10", number(1e-3, kFarthest)},
    KeyInfo{"inner", "spot: the angle from the axis with full light, in degrees; default: 20", number(0, 89)},
    KeyInfo{"outer", "spot: the angle from the axis where the light ends, in degrees; default: 30", number(0.1, 90)},
    KeyInfo{"renderMode", "auto, important (always per pixel) or notImportant", words<LightImportance>()},
    KeyInfo{
        "shadow", "directional and spot: true, or the settings of the shadow", {boolean(), object(ObjectKind::Shadow)}},
    KeyInfo{"cookie", "directional and spot: a picture whose red channel scales the light", text()},
    KeyInfo{"cookieSize", "directional: the width of the cookie in metres; default: 10", number(1e-3, kFarthest)},
};

constexpr std::array kShadow = {
    KeyInfo{"strength", "the darkness, 0 to 1; default: 1", number(0, 1)},
    KeyInfo{"bias", "the bias along the light's direction in metres; default: 0.05", number(0, 100)},
    KeyInfo{"normalBias", "the bias along the normal in texels of the shadow map; default: 0.4", number(0, 100)},
};

constexpr std::array kSceneMaterial = {
    KeyInfo{"name", "the name that objects use: an identifier", definition("identifier"), true},
    KeyInfo{"graph", "the file of the graph, relative to the scene's folder", text(), true},
    KeyInfo{"set", "values of the graph's properties", schema(kSet)},
};

constexpr std::array kSceneObject = {
    KeyInfo{"id", "a unique name: an identifier", identifier(), true},
    KeyInfo{"mesh", "sphere, plane, cube, capsule, torus, or a glTF file: model.glb, model.glb#Node", text(), true},
    KeyInfo{"segments", "the number of segments of the mesh, 3 to 512", integer(kLeastSegments, kMostSegments)},
    KeyInfo{"material", "the name of a material of this scene", definition("identifier"), true},
    kPosition,
    KeyInfo{"rotation", "the angles about the axes in degrees, [x, y, z]; applied about z, then x, then y", vector()},
    KeyInfo{
        "scale", "the scale: a number, or one for each axis; greater than 0", {number(1e-3, 1e3), vector(1e-3, 1e3)}},
    KeyInfo{"lightmap", "a picture of baked light, read at the mesh's second texture coordinates", text()},
    KeyInfo{"lightmapEncoding", "the encoding of the lightmap: hdr (not encoded), rgbm or dldr; default: hdr",
            words<LightmapEncoding>()},
    KeyInfo{"shadowMask", "a picture with the baked shadows of four lights", text()},
    KeyInfo{"instances", "the instances: the object is drawn once for each", objects(ObjectKind::SceneInstance)},
};

constexpr std::array kSceneInstance = {
    KeyInfo{"position", "the position relative to the object, in metres", vector()},
    KeyInfo{"rotation", "the angles about the axes in degrees, as of an object", vector()},
    KeyInfo{
        "scale", "the scale: a number, or one for each axis; greater than 0", {number(1e-3, 1e3), vector(1e-3, 1e3)}},
    KeyInfo{"set", "values of the properties with \"as\": \"instance\"", schema(kSet)},
};

// --- nodes/engines/NAME/engine.json

constexpr std::array kEngine = {
    kVersion,
    KeyInfo{"name", "the name of the engine that people see", {}, true},
    KeyInfo{"help", "the output for this engine, in a sentence", {}, true},
    KeyInfo{"languages", "the languages that its shaders can be written in", {}, true},
    KeyInfo{"file", "the format of the file that holds all passes; default: each stage has its own file"},
    KeyInfo{"passes", "the file of its own passes; default: it draws the library's paths"},
    KeyInfo{"paths", "the rendering paths that its own passes are for; the first is the default"},
    KeyInfo{"include", "a file with text that its files can include in parts"},
    KeyInfo{"variants", "chosen: the shaders hold one combination; keywords: they hold all combinations"},
    KeyInfo{"instances", "arrays: uniform blocks hold instances; engine: the engine's own text holds them"},
    KeyInfo{"sets", "the descriptor sets and bindings, by owner", object(ObjectKind::EngineSets), true},
    KeyInfo{"blocks", "the names of uniform blocks in this engine, by the library's names"},
    KeyInfo{"vertexInputs", "the vertex inputs of its meshes", object(ObjectKind::EngineVertexInput)},
    KeyInfo{"clip", "the conventions of clip space", object(ObjectKind::EngineClip), true},
    KeyInfo{"matrices", "the order of matrices in uniform blocks: columns or rows", {}, true},
    KeyInfo{"uvOrigin", "the corner of a texture with the coordinates (0, 0), on the left: top (default) or bottom"},
    KeyInfo{"storage", "the types that it stores material values as, by type"},
    KeyInfo{"sharedSamplers", "true (default): a sampler can serve several textures; false: each texture has its own"},
    KeyInfo{"textureSizes", "the suffix that makes the name of a texture's size from the texture's name"},
    KeyInfo{"limits", "the limits of its shaders", object(ObjectKind::EngineLimits), true},
    KeyInfo{"names", "the names that shaders must not use", object(ObjectKind::EngineNames)},
};
constexpr std::array kEngineSets = {
    KeyInfo{"engine", "values of camera, frame, object and lights", object(ObjectKind::EngineSet), true},
    KeyInfo{"material", "properties of the material", object(ObjectKind::EngineSet), true},
    KeyInfo{"targets", "targets of other passes", object(ObjectKind::EngineSet), true},
};
constexpr std::array kEngineSet = {
    KeyInfo{"set", "the descriptor set", {}, true},
    KeyInfo{"buffers", "the binding of the first uniform block; default: 0"},
    KeyInfo{"textures", "the binding of the first texture; default: after the buffers"},
    KeyInfo{"samplers", "the binding of the first sampler; default: after the textures"},
};
constexpr std::array kEngineVertexInput = {
    KeyInfo{"semantic", "the semantic of the library: positionOS", {}, true},
    KeyInfo{"hlsl", "the HLSL semantic: POSITION; default: TEXCOORD and the location"},
    KeyInfo{"location", "the location; default: the inputs that a pass reads are numbered in order"},
};
constexpr std::array kEngineClip = {
    KeyInfo{
        "depth", "z of what the camera sees: nearToFar (0 to 1), reversed (1 to 0) or symmetric (-1 to 1)", {}, true},
};
constexpr std::array kEngineLimits = {
    KeyInfo{"varyings", "the number of vectors from the vertex stage to the fragment stage", {}, true},
    KeyInfo{"varyingsNote", "a note for messages: which of them the engine uses itself"},
    KeyInfo{"blockBytes", "the size in bytes of a uniform block that most devices take", {}, true},
    KeyInfo{"guaranteedBlockBytes", "the size that all devices take; default: the same"},
    KeyInfo{"samplers", "the number of samplers of a stage, those of the engine's own text included"},
};
constexpr std::array kEngineNames = {
    KeyInfo{"owner", "the text that names the owner of the taken names in messages", {}, true},
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
    KeyInfo{"limits", "the most that a compilation may need", object(ObjectKind::OptionsLimits)},
};
constexpr std::array kOptionsLimits = {
    KeyInfo{"nodes", "nodes of the graph, and of each use of a sub-graph"},
    KeyInfo{"instructions", "instructions of nodes, functions and passes"},
    KeyInfo{"sourceBytes", "bytes of all texts that are read"},
    KeyInfo{"shaderBytes", "bytes of all texts that are written"},
};

// --- all kinds of objects

struct KindInfo {
    ObjectKind kind;
    std::string_view described;
    std::string_view definition;  // in the JSON Schema; empty: it is not there
    std::span<const KeyInfo> keys;
};
constexpr std::array kKinds = {
    KindInfo{ObjectKind::Free, "an object", "", {}},
    KindInfo{ObjectKind::Material, "a material", "material", kMaterial},
    KindInfo{ObjectKind::Subgraph, "a sub-graph", "subgraph", kSubgraph},
    KindInfo{ObjectKind::Lighting, "a lighting graph", "lighting", kLighting},
    KindInfo{ObjectKind::Workflow, "a workflow", "workflow", kWorkflow},
    KindInfo{ObjectKind::Property, "a property", "property", kProperty},
    KindInfo{ObjectKind::Node, "a node", "node", kNode},
    KindInfo{ObjectKind::Input, "an input", "input", kInput},
    KindInfo{ObjectKind::Sampler, "a sampler", "sampler", kSampler},
    KindInfo{ObjectKind::Gradient, "a gradient", "gradient", kGradient},
    KindInfo{ObjectKind::Curve, "a curve", "curve", kCurve},
    KindInfo{ObjectKind::Render, "the render state", "render", kRender},
    KindInfo{ObjectKind::Stencil, "the stencil state", "stencil", kStencil},
    KindInfo{ObjectKind::ExtraPass, "a pass", "pass", kExtraPass},
    KindInfo{ObjectKind::LightingUse, "a use of a lighting model", "lightingUse", kLightingUse},
    KindInfo{ObjectKind::Budget, "a budget", "budget", kBudget},
    KindInfo{ObjectKind::Scene, "a scene", "scene", kScene},
    KindInfo{ObjectKind::Camera, "a camera", "camera", kCamera},
    KindInfo{ObjectKind::Ambient, "ambient light", "ambient", kAmbient},
    KindInfo{ObjectKind::Environment, "an environment", "environment", kEnvironment},
    KindInfo{ObjectKind::Probe, "a probe", "probe", kProbe},
    KindInfo{ObjectKind::ProbeBox, "the box of a probe", "probeBox", kProbeBox},
    KindInfo{ObjectKind::Fog, "fog", "fog", kFog},
    KindInfo{ObjectKind::MixedLighting, "mixed lighting", "mixedLighting", kMixedLighting},
    KindInfo{ObjectKind::Light, "a light", "light", kLight},
    KindInfo{ObjectKind::Shadow, "a shadow", "shadow", kShadow},
    KindInfo{ObjectKind::SceneMaterial, "a material of a scene", "sceneMaterial", kSceneMaterial},
    KindInfo{ObjectKind::SceneObject, "an object of a scene", "sceneObject", kSceneObject},
    KindInfo{ObjectKind::SceneInstance, "an instance of an object", "sceneInstance", kSceneInstance},
    KindInfo{ObjectKind::Engine, "an engine", "", kEngine},
    KindInfo{ObjectKind::EngineSets, "the descriptor sets", "", kEngineSets},
    KindInfo{ObjectKind::EngineSet, "a descriptor set", "", kEngineSet},
    KindInfo{ObjectKind::EngineVertexInput, "a vertex input", "", kEngineVertexInput},
    KindInfo{ObjectKind::EngineClip, "clip space", "", kEngineClip},
    KindInfo{ObjectKind::EngineLimits, "the limits", "", kEngineLimits},
    KindInfo{ObjectKind::EngineNames, "the names", "", kEngineNames},
    KindInfo{ObjectKind::Options, "the options", "", kOptions},
    KindInfo{ObjectKind::OptionsLimits, "'limits'", "", kOptionsLimits},
};

constexpr const KindInfo& info_of(ObjectKind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}
static_assert(std::all_of(kKinds.begin(), kKinds.end(),
                          [](const KindInfo& each) { return &info_of(each.kind) == &each; }));

}  // namespace

std::span<const KeyInfo> keys_of(ObjectKind kind) {
    return info_of(kind).keys;
}

const KeyInfo* find_key(ObjectKind kind, std::string_view name) {
    for (const KeyInfo& key : keys_of(kind)) {
        if (key.name == name) return &key;
    }
    return nullptr;
}

const Form& form_of(ObjectKind kind, std::string_view key, Form::Of of) {
    const KeyInfo* found = find_key(kind, key);
    assert(found && "a key that the format does not have");
    const auto form =
        std::find_if(found->value.all.begin(), found->value.all.end(), [&](const Form& each) { return each.of == of; });
    assert(form != found->value.all.end() && "a form that the key does not have");
    return *form;
}

std::string_view describe(ObjectKind kind) {
    return info_of(kind).described;
}

std::string_view definition_of(ObjectKind kind) {
    return info_of(kind).definition;
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

ObjectKind top_level_kind(const json::Json& root) {
    const json::Json* kind = root.find("kind");
    if (!kind) return ObjectKind::Material;
    return from_word<ObjectKind>(kind->string).value_or(ObjectKind::Material);
}

ObjectKind value_kind(const KeyInfo& key, const json::Json& value) {
    if (key.holds() == ObjectKind::LightingUse && !value.find("use")) return ObjectKind::Lighting;
    return key.holds();
}

}  // namespace patina::format
