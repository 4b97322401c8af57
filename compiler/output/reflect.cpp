#include "compiler/output/reflect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <map>

#include "compiler/base/file_names.h"
#include "compiler/format/read_graph.h"
#include "compiler/format/words.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/link/canonical_hash.h"

namespace patina::output {

using link::LinkedPass;

using format::Property;

namespace {

std::string hlsl_register(char kind, const ir::BindingPlace& place) {
    return fmt::format("{}{}, space{}", kind, place.slot, place.set);
}

bool is_texture(const ir::Global& global) {
    return global.type.is_texture();
}

// True if each instance has its own value of the member.
bool is_of_instance(const lower::Lowered& lowered, const ir::UniformBlock& block, std::size_t member) {
    const ir::Module& module = lowered.module;
    return std::any_of(lowered.instance_globals.begin(), lowered.instance_globals.end(), [&](std::uint32_t each) {
        const ir::Global& global = module.globals[each];
        return &module.blocks[global.block] == &block && global.member == member;
    });
}

ValueType value_type(const ir::Module& module, const ir::Type& type) {
    const std::optional<ValueType> found = from_word<ValueType>(module.type_name(type));
    assert(found && "blocks and vertex inputs hold numbers");
    return found.value_or(ValueType::Float);
}

Block reflect_block(const lower::Lowered& lowered, const ir::UniformBlock& block) {
    const ir::Module& module = lowered.module;
    Block made{.name = block.name,
               .is_material = block.group == ir::Group::Material,
               .set = block.place.set,
               .binding = block.place.binding,
               .hlsl_register = hlsl_register('b', block.place),
               .size = block.size,
               .matrices = block.matrices_by_rows ? MatrixOrder::Rows : MatrixOrder::Columns,
               .members = {}};
    for (const ir::BlockMember& member : block.members) {
        const bool is_array = member.type.kind == ir::Kind::Array;
        const lower::Extent extent = lower::extent(module, member.type);
        const ir::Type element = is_array ? module.arrays[member.type.ref].element : member.type;
        made.members.push_back({.name = member.name,
                                .type = value_type(module, element),
                                .offset = member.offset,
                                .size = extent.size,
                                .array_count = is_array ? module.arrays[member.type.ref].count : 0,
                                .array_stride = extent.stride,
                                .is_of_instance = is_of_instance(lowered, block, made.members.size())});
    }
    return made;
}

// The path from the graph's folder to the file, however the two were named on the command line. It is made from the
// names alone; links are not followed.
std::string path_from_graph(const std::string& file, const std::string& graph) {
    namespace fs = std::filesystem;
    std::error_code failure;
    const auto whole = [&](const std::string& path) { return fs::absolute(path, failure).lexically_normal(); };
    const std::string relative = whole(file).lexically_relative(whole(graph).parent_path()).generic_string();
    if (failure || relative.empty()) return fs::path(file).generic_string();
    return relative.find_first_of("./") == relative.npos ? "./" + relative : relative;  // "white" means a default
}

void set_default(Texture& texture, const resolve::MaterialProperty& entry, const std::string& graph,
                 const FileSystem& files) {
    texture.default_texture = from_word<TextureDefault>(entry.texture_path).value_or(TextureDefault::White);
    if (!entry.is_file) return;
    texture.default_texture = TextureDefault::File;
    const bool is_of_program = files.resolve || !scheme_of(entry.texture_path).empty();
    texture.default_file = is_of_program ? entry.texture_path : path_from_graph(entry.texture_path, graph);
}

TextureDimension dimension_of(ir::Kind kind) {
    if (kind == ir::Kind::TextureCube) return TextureDimension::Cube;
    if (kind == ir::Kind::Texture2DArray) return TextureDimension::Array;
    return kind == ir::Kind::Texture3D ? TextureDimension::Volume : TextureDimension::Flat;
}

// The binding of a texture and its sampler, and their names in the shaders.
Texture bound_texture(const ir::Global& texture, const ir::Global& sampler) {
    return {.name = texture.name,
            .identifier = texture.name,
            .dimension = dimension_of(texture.type.kind),
            .usage = TextureUsage::Data,
            .is_material = texture.group == ir::Group::Material,
            .set = texture.place.set,
            .binding = texture.place.binding,
            .hlsl_register = hlsl_register('t', texture.place),
            .sampler_name = sampler.name,
            .sampler_binding = sampler.place.binding,
            .sampler_register = hlsl_register('s', sampler.place),
            .tiling = {},
            .sampler = {.wrap = Wrap::Clamp}};
}

Texture reflect_texture(const ir::Module& module, const resolve::MaterialProperty& entry,
                        const lower::PropertyGlobals& globals, const std::string& graph, const FileSystem& files,
                        const SourceMap& sources) {
    const Property& property = *entry.property;
    Texture made = bound_texture(module.globals[globals.texture.index], module.globals[globals.sampler.index]);
    made.name = property.name;
    made.usage = property.usage;
    set_default(made, entry, graph, files);
    if (globals.tiling) made.tiling = module.globals[globals.tiling.index].name;
    made.sampler = property.sampler;
    made.grid = property.grid;
    made.handedness = property.handedness;
    made.swizzle = property.swizzle;
    made.place = format::place_of(sources, property.name_span);
    return made;
}

patina::Property reflect_property(const ir::Module& module, const resolve::MaterialProperty& entry,
                                  const lower::PropertyGlobals& globals) {
    const Property& property = *entry.property;
    patina::Property made{.name = property.name,
                          .identifier = property.name,
                          .type = property.type,
                          .value = property.value,
                          .numbers = property.numbers,
                          .sampler = property.type == PropertyType::Sampler ? property.sampler : Sampler{},
                          .binding = property.binding,
                          .range = property.range,
                          .hard = property.hard,
                          .values = property.values,
                          .label = property.label,
                          .group = property.group,
                          .help = property.help,
                          .block = {},
                          .offset = 0,
                          .size = 0};
    if (format::is_keyword(property.binding)) made.value = {entry.chosen};
    if (globals.keyword) {
        made.identifier = module.globals[globals.keyword.index].name;
        made.constant_id = module.keywords[module.globals[globals.keyword.index].keyword].constant_id;
    }
    if (globals.texture) made.identifier = module.globals[globals.texture.index].name;
    if (property.type == PropertyType::Sampler) made.identifier = module.globals[globals.sampler.index].name;
    if (globals.value) {
        const ir::Global& global = module.globals[globals.value.index];
        const ir::BlockMember& member = module.blocks[global.block].members[global.member];
        made.identifier = global.name;
        made.block = module.blocks[global.block].name;
        made.offset = member.offset;
        const bool is_of_instances = member.type.kind == ir::Kind::Array && !is_array(property.type);
        const lower::Extent extent = lower::extent(module, member.type);
        made.size = is_of_instances ? lower::extent(module, module.arrays[member.type.ref].element).size : extent.size;
        made.instance_stride = is_of_instances ? extent.stride : 0;
    }
    return made;
}

// Of a property that is a sampler, or of a sampler that is named at a port.
BoundSampler reflect_sampler(const ir::Module& module, const resolve::MaterialProperty& entry,
                             const lower::PropertyGlobals& globals) {
    const ir::Global& sampler = module.globals[globals.sampler.index];
    return {.name = entry.property->name,
            .identifier = sampler.name,
            .is_property = !entry.is_at_port,
            .set = sampler.place.set,
            .binding = sampler.place.binding,
            .hlsl_register = hlsl_register('s', sampler.place),
            .sampler = entry.property->sampler};
}

// Globals that a stage still reads after tidying.
void mark_used(const ir::Module& stage, std::vector<bool>& used) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == ir::Op::Global) used[inst.data] = true;
        }
    }
}

// Depth writes and the queue by kind of surface, if the material states nothing; the queues are Unity's.
struct SurfaceRow {
    SurfaceKind kind;
    int queue;
    bool depth_write;
};
constexpr SurfaceRow kSurfaceRows[] = {
    {SurfaceKind::Opaque, 2000, true},       {SurfaceKind::Cutout, 2450, true},    {SurfaceKind::Fade, 3000, false},
    {SurfaceKind::Transparent, 3000, false}, {SurfaceKind::Additive, 3000, false}, {SurfaceKind::Multiply, 3000, false},
};

const SurfaceRow& row_of(SurfaceKind kind) {
    return *std::find_if(std::begin(kSurfaceRows), std::end(kSurfaceRows),
                         [&](const SurfaceRow& row) { return row.kind == kind; });
}

// The depth test of a pass that draws an object again for each light: equal to the depth that the first pass left. If
// the material writes no depth, it is the material's test.
Compare depth_test_of_repetition(const format::RenderState& render, bool writes, Compare stated) {
    const Compare test = render.depth_test.value_or(Compare::LessEqual);
    using enum Compare;
    if (!writes || test == Never) return test;
    return test == Less || test == LessEqual ? stated : Equal;
}

bool is_repetition(const Pass& pass) {
    return pass.each == PassEach::Light && pass.lights != PassLights::Shadowed;
}

// The material's stencil, for passes that draw objects in colour and state none. A pass that repeats the object for
// each light does not write it, because the pass before has done so.
Stencil reflect_stencil(const format::StencilState& stencil, bool is_repetition) {
    Stencil made{.test = stencil.test,
                 .value = stencil.reference,
                 .read_mask = stencil.read_mask,
                 .write_mask = stencil.write_mask};
    if (is_repetition) return made;
    made.pass = stencil.pass;
    made.fail = stencil.fail;
    made.depth_fail = stencil.depth_fail;
    return made;
}

void set_object_state(Pass& pass, const paths::PassDecl& declaration, const format::RenderState& render) {
    const SurfaceRow& surface = row_of(render.surface);
    const bool writes = render.depth_write.value_or(surface.depth_write);
    if (!declaration.has_cull) pass.cull = render.cull;
    if (!declaration.has_depth) {
        pass.depth_write = writes;
        pass.depth_test = render.depth_test.value_or(Compare::LessEqual);
    } else if (is_repetition(pass)) {
        pass.depth_test = depth_test_of_repetition(render, writes, pass.depth_test);
    }
    if (!declaration.has_depth_bias && render.depth_offset) {
        pass.depth_slope_bias = (*render.depth_offset)[0];
        pass.depth_bias = (*render.depth_offset)[1];
    }
    if (!declaration.has_stencil && render.stencil && !pass.targets.empty())
        pass.stencil = reflect_stencil(*render.stencil, is_repetition(pass));
    pass.queue = queue_of(render);
}

Compare mirrored(Compare test) {
    switch (test) {
        case Compare::Less: return Compare::Greater;
        case Compare::LessEqual: return Compare::GreaterEqual;
        case Compare::Greater: return Compare::Less;
        case Compare::GreaterEqual: return Compare::LessEqual;
        case Compare::Never:
        case Compare::Equal:
        case Compare::NotEqual:
        case Compare::Always: break;
    }
    return test;
}

// Graphs and pass files speak of near and far; the state of a pass speaks of numbers.
void reverse_depth(Pass& pass) {
    pass.depth_test = mirrored(pass.depth_test);
    pass.depth_bias = -pass.depth_bias;
    pass.depth_slope_bias = -pass.depth_slope_bias;
}

// By global: true if the stage reads it.
std::vector<bool> used_by(const ir::Module& stage, const lower::Lowered& lowered) {
    std::vector<bool> used(lowered.module.globals.size(), false);
    if (!lowered.keeps_functions) {
        mark_used(stage, used);
        return used;
    }
    // Shared functions compute members that this pass does not read.
    const ir::FunctionId entry = stage.stage.entry;
    mark_used(ir::drop_members(stage, std::span(&entry, 1), {}), used);
    return used;
}

// The names of the blocks with a member that is used.
std::vector<std::string> blocks_read(const lower::Lowered& lowered, const std::vector<bool>& used) {
    std::vector<std::string> names;
    for (std::uint32_t block = 0; block < lowered.module.blocks.size(); ++block) {
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!used[i] || lowered.module.globals[i].block != block) continue;
            names.push_back(lowered.module.blocks[block].name);
            break;
        }
    }
    return names;
}

Pass reflect_pass(const LinkedPass& linked) {
    const resolve::Material& material = *linked.material;
    const lower::Lowered& lowered = *linked.lowered;
    const format::RenderState& render = material.graph->graph->render;
    const paths::PassDecl& declaration = *linked.pass->declaration;
    Pass pass = declaration.state;
    pass.name = linked.pass->name;
    pass.targets.resize(pass.targets.size() - linked.left_out);
    pass.reads_elsewhere = linked.reads_elsewhere;
    if (material.pass) {
        pass.is_extra = true;
        pass.fallback.clear();
        pass.moves_vertices = !material.graph->graph->vertex.empty();
        pass.bounds = render.bounds;
    }
    if (pass.draws == PassDraws::Objects) set_object_state(pass, declaration, render);
    if (lowered.clip_depth == ClipDepth::Reversed && pass.lights != PassLights::Shadowed) reverse_depth(pass);
    if (const paths::BlendRow* blend = lower::blend_of(declaration, render.surface)) {
        for (RenderTarget& target : pass.targets) target.blend = blend->blend;
    }
    for (const ir::StageVariable& input : linked.vertex.stage.inputs) {
        if (input.builtin != ir::Builtin::None) continue;
        pass.vertex_inputs.push_back({.name = input.name,
                                      .type = value_type(linked.vertex, input.type),
                                      .location = input.location,
                                      .hlsl_semantic = input.semantic});
    }
    const std::vector<bool> vertex = used_by(linked.vertex, lowered), fragment = used_by(linked.fragment, lowered);
    pass.vertex_reads = blocks_read(lowered, vertex);
    pass.fragment_reads = blocks_read(lowered, fragment);
    std::vector<bool> either = vertex;
    for (std::size_t i = 0; i < either.size(); ++i) either[i] = vertex[i] || fragment[i];
    pass.blocks = blocks_read(lowered, either);
    const auto read = [&](std::vector<std::string>& names, std::size_t global, const std::string& name) {
        if (either[global]) names.push_back(name);
        if (vertex[global]) pass.vertex_reads.push_back(name);
        if (fragment[global]) pass.fragment_reads.push_back(name);
    };
    for (std::size_t i = 0; i < either.size(); ++i) {
        const ir::Global& global = lowered.module.globals[i];
        if (global.group != ir::Group::Material && is_texture(global)) read(pass.textures, i, global.name);
    }
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const std::string& name = material.properties[i].property->name;
        const lower::PropertyGlobals& globals = lowered.property_globals[i];
        if (globals.texture) read(pass.textures, globals.texture.index, name);
        if (globals.sampler && !globals.texture) read(pass.samplers, globals.sampler.index, name);
        if (globals.keyword && either[globals.keyword.index]) pass.keywords.push_back(name);
    }
    return pass;
}

// 64-bit FNV-1a of everything that the layout of a buffer or a descriptor set depends on.
std::string layout_hash(const Reflection& reflection) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&](const std::string& text) {
        for (unsigned char c : text + "\n") hash = (hash ^ c) * 0x100000001b3u;
    };
    for (const Block& block : reflection.blocks) {
        add(fmt::format("{} {} {} {}", block.name, block.set, block.binding, block.size));
        for (const BlockMember& m : block.members)
            add(fmt::format("{} {} {} {}", m.name, to_string(m.type), m.offset, m.size));
    }
    for (const Texture& t : reflection.textures) {
        add(fmt::format("{} {} {} {} {}", t.name, to_string(t.dimension), t.set, t.binding, t.sampler_binding));
    }
    for (const BoundSampler& s : reflection.samplers) add(fmt::format("{} {} {}", s.name, s.set, s.binding));
    return fmt::format("{:016x}", hash);
}

std::vector<SetLayout> set_layouts(const Reflection& reflection) {
    std::map<std::uint32_t, Reflection> sets;
    for (const Block& block : reflection.blocks) sets[block.set].blocks.push_back(block);
    for (const Texture& texture : reflection.textures) sets[texture.set].textures.push_back(texture);
    for (const BoundSampler& sampler : reflection.samplers) sets[sampler.set].samplers.push_back(sampler);
    std::vector<SetLayout> made;
    for (const auto& [set, part] : sets) made.push_back({.set = set, .hash = layout_hash(part)});
    return made;
}

}  // namespace

int queue_of(const format::RenderState& render) {
    return render.queue.value_or(row_of(render.surface).queue);
}

// True if something that the reflection lists is bound in the set.
bool is_bound(const Reflection& reflection, std::uint32_t set) {
    const auto is_there = [&](const auto& each) { return each.set == set; };
    return std::any_of(reflection.blocks.begin(), reflection.blocks.end(), is_there) ||
           std::any_of(reflection.textures.begin(), reflection.textures.end(), is_there) ||
           std::any_of(reflection.samplers.begin(), reflection.samplers.end(), is_there);
}

Reflection reflect(const resolve::Material& material, const lower::Lowered& lowered, std::span<const LinkedPass> passes,
                   const resolve::Session& session) {
    const format::Graph& graph = *material.graph->graph;
    Reflection made;
    made.name = graph.name;
    made.workflow = graph.workflow;
    made.lighting = material.lighting_name;
    made.surface = graph.render.surface;
    made.moves_vertices = !graph.vertex.empty();
    made.bounds = graph.render.bounds;
    made.path = lowered.path;
    made.clip_depth = lowered.clip_depth;
    made.most_instances = lowered.instances;
    for (const auto& [name, value] : lowered.switches) made.switches.push_back({.name = name, .value = value});
    made.meta = graph.meta;
    // Functions read the engine's values through their parameters only.
    const bool has_engine = lowered.functions.empty();
    for (const ir::UniformBlock& block : lowered.module.blocks) {
        if (has_engine || block.group == ir::Group::Material) made.blocks.push_back(reflect_block(lowered, block));
    }
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const resolve::MaterialProperty& entry = material.properties[i];
        if (entry.property->type == PropertyType::Sampler)
            made.samplers.push_back(reflect_sampler(lowered.module, entry, lowered.property_globals[i]));
        if (entry.property->type == PropertyType::Sampler && entry.is_at_port) continue;  // nothing can set it
        made.properties.push_back(reflect_property(lowered.module, entry, lowered.property_globals[i]));
        if (is_texture(entry.property->type)) {
            made.textures.push_back(reflect_texture(lowered.module, entry, lowered.property_globals[i], graph.path,
                                                    session.options.files, session.sources));
        }
    }
    for (const auto& [option, value] : material.variants) {
        patina::Property& made_option = made.lighting_options.emplace_back();
        made_option.name = made_option.identifier = option->name;
        made_option.type = option->type;
        made_option.value = {value};
        made_option.binding = option->binding;
        made_option.values = option->values;
        made_option.help = option->help;
    }
    std::sort(made.lighting_options.begin(), made.lighting_options.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    for (const LinkedPass& pass : passes) {
        made.passes.push_back(reflect_pass(pass));
        if (session.options.hashes) made.passes.back().hash = link::hash_pass(pass.vertex, pass.fragment).text();
    }
    for (std::size_t i = 0; i < lowered.module.globals.size(); ++i) {
        const ir::Global& global = lowered.module.globals[i];
        if (global.group == ir::Group::Material || !is_texture(global)) continue;
        // A value that no pass reads has no binding.
        const bool is_read = std::any_of(made.passes.begin(), made.passes.end(), [&](const Pass& pass) {
            return std::count(pass.textures.begin(), pass.textures.end(), global.name) > 0;
        });
        if (!is_read && (global.group == ir::Group::Targets || !has_engine)) continue;
        made.textures.push_back(bound_texture(global, lowered.module.globals[i + 1]));
        if (const auto target = lowered.reads.find(static_cast<std::uint32_t>(i)); target != lowered.reads.end()) {
            made.textures.back().reads = target->second;
            made.textures.back().sampler.filter = Filter::Nearest;
        }
    }
    for (const lower::SetShifts& shift : lowered.shifts) {
        if (shift.set == lowered.target_set && !is_bound(made, shift.set)) continue;
        made.hlsl_shifts.push_back(
            {.set = shift.set, .textures = shift.textures, .samplers = shift.samplers, .buffers = shift.buffers});
    }
    made.layout_hash = layout_hash(made);
    made.sets = set_layouts(made);
    return made;
}

}  // namespace patina::output
