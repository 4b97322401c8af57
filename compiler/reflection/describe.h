// The room `reflection` writes and reads the JSON of a Reflection and makes its JSON Schema. All three come from one
// description: the key of each member, and its meaning. It compiles nothing.
//
// `Fields` is WriteFields, ReadFields or SchemaFields. It gets
//   key(name, member, doc)                  a key that is always there
//   optional(name, member, default, doc)    a key that is left out for the default
//   key_if(condition, name, member, doc)    a key that is there if something else is so
// and a function for each key whose value is not simply a member.
#pragma once

#include <type_traits>

#include "patina/reflection.h"

namespace patina::reflection {

// What is written is const.
template <class Fields, class T>
using Given = std::conditional_t<Fields::kWrites, const T, T>;

template <class Fields>
void describe(Fields& f, Given<Fields, Switch>& s) {
    f.key("name", s.name, "the name in CompileOptions::switches and -D");
    f.key("value", s.value, "what the shaders were compiled for");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Property>& p) {
    const Property usual{};
    f.key("name", p.name, "as the graph has it");
    f.key("identifier", p.identifier, "in the shaders");
    f.key("type", p.type, "its type");
    f.optional("as", p.binding, usual.binding, "when it gets its value");
    f.optional("constantId", p.constant_id, usual.constant_id, "of a specialization constant");
    f.property_default(p);
    f.optional("range", p.range, usual.range, "lowest and highest value");
    f.optional("hard", p.hard, usual.hard, "the range is a limit, not a hint");
    f.optional("values", p.values, usual.values, "of an enum: its words, by index");
    f.optional("label", p.label, usual.label, "for an inspector");
    f.optional("group", p.group, usual.group, "for an inspector");
    f.optional("help", p.help, usual.help, "for an inspector");
    f.optional("block", p.block, usual.block, "the block that holds it");
    f.key_if(!p.block.empty(), "offset", p.offset, "bytes from the start of the block");
    f.key_if(!p.block.empty(), "size", p.size, "bytes");
    f.optional("instanceStride", p.instance_stride, usual.instance_stride, "bytes to the value of the next instance");
}

template <class Fields>
void describe(Fields& f, Given<Fields, BlockMember>& m) {
    const BlockMember usual{};
    f.key("name", m.name, "in the shaders");
    f.key("type", m.type, "of one element, spelled as in HLSL");
    f.key("offset", m.offset, "bytes from the start of the block");
    f.key("size", m.size, "bytes, of the whole array if it is one");
    f.optional("count", m.array_count, usual.array_count, "of an array: its elements");
    f.optional("stride", m.array_stride, usual.array_stride, "of an array: bytes from element to element");
    f.optional("instance", m.is_of_instance, usual.is_of_instance, "an element for each instance of a draw");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Block>& b) {
    const Block usual{};
    f.key("name", b.name, "in the shaders");
    f.key("material", b.is_material, "it holds the graph's properties; other blocks are the engine's");
    f.key("set", b.set, "descriptor set, and HLSL register space");
    f.key("binding", b.binding, "in its set, of GLSL and of HLSL after the shifts");
    f.key("register", b.hlsl_register, "of HLSL");
    f.key("size", b.size, "bytes");
    f.optional("matrices", b.matrices, usual.matrices, "how a matrix lies in the block");
    f.key("members", b.members, "in the order of their offsets");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Texture>& t) {
    const Texture usual{};
    f.key("name", t.name, "the property's");
    f.key("identifier", t.identifier, "in the shaders");
    f.key("dimension", t.dimension, "its kind");
    f.key("usage", t.usage, "color: sRGB, decoded when it is sampled; data: linear; normal: 2x - 1");
    f.optional("handedness", t.handedness, usual.handedness, "what the green of a normal map counts");
    f.optional("swizzle", t.swizzle, usual.swizzle, "the channels that the shaders take");
    f.key("material", t.is_material, "it is a property; other textures are the engine's");
    f.texture_default(t);
    f.optional("grid", t.grid, usual.grid, "columns and rows of the layers in a picture's file");
    f.optional("reads", t.reads, usual.reads, "the target of another pass that is bound here");
    f.key("set", t.set, "descriptor set, and HLSL register space");
    f.key("binding", t.binding, "in its set");
    f.key("register", t.hlsl_register, "of HLSL");
    f.key("sampler", t.sampler_name, "in the shaders; textures that share it have the same binding");
    f.key("samplerBinding", t.sampler_binding, "in the set");
    f.key("samplerRegister", t.sampler_register, "of HLSL");
    f.optional("tiling", t.tiling, usual.tiling, "the member of the material's block with scale and offset");
    f.key_if(!t.tiling.empty(), "tilingDefault", t.tiling_default, "what that member starts as");
    f.key("wrap", t.sampler.wrap, "of the sampler");
    f.key("filter", t.sampler.filter, "of the sampler; linear is trilinear");
    f.key("anisotropy", t.sampler.anisotropy, "of the sampler, 1 to 16");
}

template <class Fields>
void describe(Fields& f, Given<Fields, BoundSampler>& s) {
    const BoundSampler usual{};
    f.key("name", s.name, "the property's, or that of a sampler which textures share");
    f.key("identifier", s.identifier, "in the shaders");
    f.optional("property", s.is_property, usual.is_property, "a program can set it");
    f.key("set", s.set, "descriptor set, and HLSL register space");
    f.key("binding", s.binding, "in its set");
    f.key("register", s.hlsl_register, "of HLSL");
    f.key("wrap", s.sampler.wrap, "of a property: its default");
    f.key("filter", s.sampler.filter, "linear is trilinear");
    f.key("anisotropy", s.sampler.anisotropy, "1 to 16");
}

template <class Fields>
void describe(Fields& f, Given<Fields, RenderTarget>& t) {
    f.key("name", t.name, "passes that name the same target draw into the same image");
    f.key("location", t.location, "of the fragment stage's output");
    f.key("format", t.format, "of a pixel");
    f.key("blendSource", t.blend.source, "factor of the new colour");
    f.key("blendDestination", t.blend.destination, "factor of the colour that is there");
    f.key("blendSourceAlpha", t.blend.source_alpha, "factor of the new alpha");
    f.key("blendDestinationAlpha", t.blend.destination_alpha, "factor of the alpha that is there");
}

template <class Fields>
void describe(Fields& f, Given<Fields, VertexInput>& v) {
    f.key("name", v.name, "what the mesh has: positionOS, normalOS, tangentOS, uv0, vertexColor");
    f.key("type", v.type, "spelled as in HLSL");
    f.key("location", v.location, "of GLSL");
    f.key("semantic", v.hlsl_semantic, "of HLSL");
}

template <class Fields>
void describe(Fields& f, Given<Fields, ShaderFile>& s) {
    f.key("stage", s.stage, "vertex or fragment");
    f.key("language", s.language, "as a target names it");
    f.key("file", s.file, "its name");
}

// All keys, or none.
template <class Fields>
void describe_stencil(Fields& f, Given<Fields, Stencil>& s) {
    const bool is_used = s.is_used();
    f.key_if(is_used, "stencilTest", s.test, "(reference & read mask) to (what is there & read mask)");
    f.key_if(is_used, "stencilPass", s.pass, "what happens where both tests pass");
    f.key_if(is_used, "stencilFail", s.fail, "where the stencil test fails");
    f.key_if(is_used, "stencilDepthFail", s.depth_fail, "where only the depth test fails");
    f.stencil_reference(is_used, s);
    f.key_if(is_used, "stencilReadMask", s.read_mask, "0 to 255");
    f.key_if(is_used, "stencilWriteMask", s.write_mask, "0 to 255");
}

template <class Fields>
void describe(Fields& f, Given<Fields, CostCounts>& c) {
    for (const CostFigure& figure : kCostFigures) f.key(figure.name, c.*figure.count, figure.doc);
}

template <class Fields>
void describe(Fields& f, Given<Fields, StageCost>& c) {
    f.key("once", c.once, "for each vertex or pixel");
    f.key("perLight", c.per_light, "for each light");
    f.key("varyings", c.varyings, "components that go from the vertex stage to the fragment stage");
    f.key("registers", c.registers, "components of values that are live at the worst point");
}

template <class Fields>
void describe(Fields& f, Given<Fields, PassCost>& c) {
    f.key("vertex", c.vertex, "of the vertex stage");
    f.key("fragment", c.fragment, "of the fragment stage");
    f.key("uniformBytes", c.uniform_bytes, "of the material's blocks that the pass reads");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Pass>& p) {
    const Pass usual{};
    f.key("name", p.name, "of the pass");
    f.optional("extra", p.is_extra, usual.is_extra, "a pass that the material adds; it is drawn by its own queue");
    f.key("draws", p.draws, "what is drawn");
    f.key("each", p.each, "how often");
    f.key("lights", p.lights, "the lights that the pass is given");
    f.key("camera", p.camera, "the cameras that it works for");
    f.optional("fallback", p.fallback, usual.fallback, "the path for another camera");
    f.key("cull", p.cull, "the faces that are not drawn; front faces are counter-clockwise");
    f.key("depthTarget", p.depth_target, "the target with the depth");
    f.key("depthWrite", p.depth_write, "it writes depth");
    f.key("depthTest", p.depth_test, "the new depth to the depth that is there");
    f.optional("depthBias", p.depth_bias, usual.depth_bias, "in units of the depth format");
    f.optional("depthSlopeBias", p.depth_slope_bias, usual.depth_slope_bias, "times the slope");
    describe_stencil(f, p.stencil);
    f.key("queue", p.queue, "lower numbers are drawn first");
    f.optional("readsElsewhere", p.reads_elsewhere, usual.reads_elsewhere,
               "it reads a target at other pixels than its own");
    f.optional("movesVertices", p.moves_vertices, usual.moves_vertices, "the drawn bounds are not the mesh's own");
    f.optional("bounds", p.bounds, usual.bounds, "of an extra pass: as those of the material");
    f.key("targets", p.targets, "the images that it draws into; empty: depth only");
    f.key("vertexInputs", p.vertex_inputs, "of the vertex stage");
    f.optional("shaders", p.shaders, usual.shaders, "the files of its stages");
    f.key("blocks", p.blocks, "that either stage reads");
    f.key("textures", p.textures, "that either stage reads");
    f.optional("samplers", p.samplers, usual.samplers, "those of the key samplers that either stage reads");
    f.key("vertexReads", p.vertex_reads, "blocks, textures and such samplers that the vertex stage reads");
    f.key("fragmentReads", p.fragment_reads, "blocks, textures and such samplers that the fragment stage reads");
    f.optional("keywords", p.keywords, usual.keywords, "properties that either stage reads before it runs");
    f.optional("hash", p.hash, usual.hash, "of the pass's computations; it does not depend on the graph's names");
    f.optional("cost", p.cost, usual.cost, "what it costs; there with 'patina compile --cost'");
}

template <class Fields>
void describe(Fields& f, Given<Fields, ShaderFunction::Parameter>& p) {
    f.key("name", p.name, "of the parameter");
    f.key("type", p.type, "spelled as in HLSL");
}

template <class Fields>
void describe(Fields& f, Given<Fields, ShaderFunction>& s) {
    f.key("name", s.name, "with its prefix");
    f.key("stage", s.stage, "where it can be called");
    f.key("engine", s.is_engines, "the engine defines it");
    f.key("result", s.result, "its type, spelled as in HLSL");
    f.key("parameters", s.parameters, "in order");
}

template <class Fields>
void describe(Fields& f, Given<Fields, SetLayout>& s) {
    f.key("set", s.set, "descriptor set");
    f.key("hash", s.hash, "equal hash, equal blocks and bindings");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Reflection::Shifts>& s) {
    f.key("set", s.set, "register space");
    f.key("buffers", s.buffers, "of registers b");
    f.key("textures", s.textures, "of registers t");
    f.key("samplers", s.samplers, "of registers s");
}

template <class Fields>
void describe(Fields& f, Given<Fields, WrittenFile>& w) {
    f.key("file", w.file, "its name");
    f.key("hash", w.hash, "FNV-1a of its bytes, 64 bits");
}

template <class Fields>
void describe(Fields& f, Given<Fields, Reflection>& r) {
    const Reflection usual{};
    f.version("patina", Reflection::kVersion, "the version of this format");
    f.key("name", r.name, "the graph's");
    f.key("workflow", r.workflow, "the graph's");
    f.key("lighting", r.lighting, "the lighting model");
    f.key("surface", r.surface, "how the material covers what is behind it");
    f.key("path", r.path, "the rendering path of the passes");
    f.optional("movesVertices", r.moves_vertices, usual.moves_vertices, "the drawn bounds are not the mesh's own");
    f.optional("bounds", r.bounds, usual.bounds, "a margin around the mesh's bounds, or a box");
    f.optional("clipDepth", r.clip_depth, usual.clip_depth, "the order of depth");
    f.optional("mostInstances", r.most_instances, usual.most_instances, "how many instances one draw can hold");
    f.key("switches", r.switches, "optional parts of the passes");
    f.key("layoutHash", r.layout_hash, "equal hash, equal blocks and bindings in all sets");
    f.key("sets", r.sets, "descriptor sets with a block or a texture");
    f.key("properties", r.properties, "of the material");
    f.key("blocks", r.blocks, "uniform blocks");
    f.key("textures", r.textures, "with their samplers");
    f.optional("samplers", r.samplers, usual.samplers, "those that nodes name; the others are bound with a texture");
    f.key("passes", r.passes, "in the order in which they are drawn");
    f.optional("functions", r.functions, usual.functions, "for an engine's own shaders; there are no passes then");
    f.key("hlslShifts", r.hlsl_shifts, "by set: what glslang adds to HLSL registers to get bindings");
    f.optional("files", r.files, usual.files, "that were written with it; a file with another hash is of another run");
    f.meta(r.meta);
}

}  // namespace patina::reflection
