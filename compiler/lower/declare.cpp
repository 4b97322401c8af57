#include "compiler/lower/declare.h"

#include <algorithm>

#include "compiler/ir/texture_kinds.h"

namespace patina::lower {

using ir::Type;

namespace {

constexpr std::uint32_t round_up(std::uint32_t value, std::uint32_t to) {
    return (value + to - 1) / to * to;
}

ir::GlobalId add_block_global(ir::Module& module, std::uint32_t block, const std::string& name, Type type, Span span) {
    add_member(module.blocks[block], module, name, type);
    module.globals.push_back({.name = name,
                              .type = type,
                              .block = block,
                              .member = static_cast<std::uint32_t>(module.blocks[block].members.size() - 1),
                              .group = module.blocks[block].group,
                              .span = span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

ir::GlobalId add_resource(ir::Module& module, std::string name, ir::Kind kind, ir::Group group, Span span) {
    module.globals.push_back({.name = std::move(name), .type = Type::of(kind), .group = group, .span = span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

// True if the value depends on no switch or path, or on one that is on.
bool is_wanted(const paths::ExternDecl& value, std::span<const std::string_view> on) {
    return value.with.empty() ||
           std::find_first_of(value.with.begin(), value.with.end(), on.begin(), on.end()) != value.with.end();
}

// The values to declare: the wanted ones and, in a block, all values before them, so that offsets stay the same. So no
// switch moves a value, and an engine fills its blocks in one way for all shaders.
std::set<const paths::ExternDecl*> held(std::span<const paths::ExternDecl* const> externs,
                                        std::span<const std::string_view> on) {
    std::set<const paths::ExternDecl*> declared;
    std::set<std::string_view> followed;  // blocks
    for (auto each = externs.rbegin(); each != externs.rend(); ++each) {
        const bool is_before_another = !(*each)->block.empty() && followed.contains((*each)->block);
        if (!is_wanted(**each, on) && !is_before_another) continue;
        declared.insert(*each);
        followed.insert((*each)->block);
    }
    return declared;
}

// What is read only with a switch or path comes last.
std::vector<const paths::ExternDecl*> in_order(const paths::PathDeclarations& paths) {
    std::vector<const paths::ExternDecl*> externs;
    for (const paths::ExternDecl& each : paths.externs) externs.push_back(&each);
    std::stable_partition(externs.begin(), externs.end(),
                          [](const paths::ExternDecl* each) { return each->with.empty(); });
    return externs;
}

ir::Group group_of(const paths::ExternDecl& value) {
    return value.is_target() ? ir::Group::Targets : ir::Group::Engine;
}

Numbering numbering_of(const engines::Engine& engine, std::span<const paths::ExternDecl* const> externs) {
    Numbering made;
    const auto add = [](auto& numbers, std::string_view name) {
        numbers.try_emplace(std::string(name), static_cast<std::uint32_t>(numbers.size()));
    };
    for (const paths::ExternDecl* each : externs) {
        if (ir::texture_kind(each->variable->type.name))
            add(made.textures[static_cast<std::size_t>(group_of(*each))], each->variable->name);
        else
            add(made.blocks, engine.block_name(each->block));
    }
    return made;
}

// The sampler of a texture: its own, or the sampler of earlier textures that share the same name.
ir::GlobalId add_sampler(ir::Module& module, const engines::Engine& engine, const format::Property& property,
                         std::map<std::string, ir::GlobalId>& shared) {
    const bool is_shared = engine.shares_samplers && !property.shared_sampler.empty();
    ir::GlobalId& known = shared[is_shared ? property.shared_sampler : std::string()];
    if (is_shared && known) return known;
    const std::string name = is_shared ? property.shared_sampler : "sampler" + property.name;
    return known = add_resource(module, name, ir::Kind::Sampler, ir::Group::Material, property.span);
}

// Keywords stay bools, because they are not in a uniform block.
ir::GlobalId add_keyword(ir::Module& module, const resolve::MaterialProperty& entry) {
    const format::Property& property = *entry.property;
    module.globals.push_back({.name = property.name,
                              .type = property.type == PropertyType::Bool ? ir::kBool : ir::kInt,
                              .keyword = static_cast<std::uint32_t>(module.keywords.size()),
                              .group = ir::Group::Material,
                              .span = property.span});
    module.keywords.push_back({.property = property.name, .value = entry.chosen, .values = property.values});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

}  // namespace

ir::Kind texture_kind(PropertyType type) {
    if (type == PropertyType::TextureCube) return ir::Kind::TextureCube;
    if (type == PropertyType::Texture2DArray) return ir::Kind::Texture2DArray;
    return type == PropertyType::Texture3D ? ir::Kind::Texture3D : ir::Kind::Texture2D;
}

Type property_type(ir::Module& module, PropertyType type) {
    switch (type) {
        case PropertyType::Float: return ir::kFloat;
        case PropertyType::Float2: return ir::kFloat2;
        case PropertyType::Float3: return ir::kFloat3;
        case PropertyType::Float4:
        case PropertyType::Color: return ir::kFloat4;
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum: return ir::kInt;
        case PropertyType::Float2x2:
        case PropertyType::Float3x3:
        case PropertyType::Float4x4: return Type::matrix(ir::Scalar::Float, 4, 4);
        case PropertyType::Gradient:
        case PropertyType::Curve:
            return module.array_of(ir::kFloat4, static_cast<std::uint32_t>(component_count(type) / 4));
        case PropertyType::Texture2D:
        case PropertyType::TextureCube:
        case PropertyType::Texture2DArray:
        case PropertyType::Texture3D: return Type::of(texture_kind(type));
        case PropertyType::Sampler: return Type::of(ir::Kind::Sampler);
    }
    return Type::error();
}

Extent extent(const ir::Module& module, Type type) {
    if (type.kind == ir::Kind::Array) {
        const ir::Array& array = module.arrays[type.ref];
        const std::uint32_t stride = round_up(extent(module, array.element).size, 16);
        return {.size = stride * array.count, .alignment = 16, .stride = stride};
    }
    if (type.is_matrix()) return {.size = 16u * type.cols, .alignment = 16, .stride = 0};
    const std::uint32_t size = 4 * type.components();
    return {.size = size, .alignment = type.components() == 3 ? 16 : size, .stride = 0};
}

void add_member(ir::UniformBlock& block, const ir::Module& module, std::string name, Type type) {
    const Extent e = extent(module, type);
    std::uint32_t end = 0;
    if (!block.members.empty()) {
        const ir::BlockMember& last = block.members.back();
        const Extent before = extent(module, last.type);
        end = last.offset + before.size;
        // Compilers differ on what may follow an array or a matrix in its last 16 bytes, so nothing is put there.
        if (before.alignment == 16 && last.type.kind == ir::Kind::Array) end = round_up(end, 16);
        if (last.type.is_matrix()) end = round_up(end, 16);
    }
    const std::uint32_t offset = round_up(end, e.alignment);
    block.members.push_back({.name = std::move(name), .type = type, .offset = offset, .padding = (offset - end) / 4});
    block.size = round_up(offset + e.size, 16);
}

namespace {

// Declares the values of included files, and the values that each of them replaces.
void declare_foreign(const paths::PathDeclarations& paths, const nodelang::Declarations& declarations,
                     emit::Emitter& emitter) {
    const emit::Scope scope{.declarations = &declarations};
    for (const paths::ForeignDecl& foreign : paths.foreign) {
        const nodelang::VariableDecl& variable = *foreign.variable;
        emitter.module.globals.push_back({.name = std::string(variable.name),
                                          .type = emit::type(emitter, variable.type, scope),
                                          .group = ir::Group::Included,
                                          .span = variable.span,
                                          .spelling = std::string(foreign.spelling)});
        emitter.known.externs[&variable] = {static_cast<std::uint32_t>(emitter.module.globals.size() - 1)};
    }
    for (const paths::GivenDecl& given : paths.given) {
        const nodelang::VariableDecl* replaced = given.variable ? declarations.variable(given.what) : nullptr;
        const paths::ExternDecl* value = replaced ? paths.extern_of(replaced) : nullptr;
        if (!value) continue;
        emit::share_extern(emitter.known, *replaced, *given.variable);
        if (value->is_per_object)
            emitter.module.globals[emit::find_extern(emitter.known, *given.variable)->index].is_of_object = true;
    }
}

}  // namespace

EngineGlobals declare_engine(const engines::Engine& engine, const paths::PathDeclarations& paths,
                             const nodelang::Declarations& declarations, emit::Emitter& emitter,
                             std::span<const std::string_view> on) {
    EngineGlobals made;
    ir::Module& module = emitter.module;
    const emit::Scope scope{.declarations = &declarations};
    for (const paths::StaticDecl& asked : paths.statics) {
        if (!asked.is_of_engine()) continue;
        const bool is_clip = asked.about == paths::StaticDecl::About::Clip;
        const std::string_view word = is_clip ? to_string(engine.clip_depth) : to_string(engine.uv_origin);
        const bool is_so = std::find(asked.words.begin(), asked.words.end(), word) != asked.words.end();
        emitter.known.statics[asked.variable] = is_so ? 1 : 0;
    }
    const std::vector<const paths::ExternDecl*> externs = in_order(paths);
    made.numbering = numbering_of(engine, externs);
    const std::set<const paths::ExternDecl*> declared = held(externs, on);
    for (const paths::ExternDecl* each : externs) {
        if (!declared.contains(each)) continue;
        const nodelang::VariableDecl& variable = *each->variable;
        if (const ir::TextureKind* kind = ir::texture_kind(variable.type.name)) {
            const std::string texture(variable.name);
            const ir::Group group = group_of(*each);
            const ir::GlobalId global = add_resource(module, texture, kind->kind, group, variable.span);
            emitter.known.externs[&variable] = global;
            if (each->is_target()) made.reads[global.index] = each->reads;
            add_resource(module, texture + "Sampler", ir::Kind::Sampler, group, variable.span);
            continue;
        }
        const std::string_view name = engine.block_name(each->block);
        auto block = std::find_if(module.blocks.begin(), module.blocks.end(),
                                  [&](const ir::UniformBlock& b) { return b.name == name; });
        if (block == module.blocks.end()) {
            module.blocks.push_back({.name = std::string(name), .members = {}});
            block = module.blocks.end() - 1;
        }
        const Type type = emit::type(emitter, variable.type, scope);
        const auto index = static_cast<std::uint32_t>(block - module.blocks.begin());
        const ir::GlobalId global = add_block_global(module, index, std::string(variable.name), type, variable.span);
        emitter.known.externs[&variable] = global;
        if (each->is_per_object) made.per_object.insert(global.index);
    }
    declare_foreign(paths, declarations, emitter);
    for (const nodelang::VariableDecl* older : paths.repeated) {
        const nodelang::VariableDecl* newer = declarations.variable(older->name);
        if (newer) emit::share_extern(emitter.known, *older, *newer);
    }
    return made;
}

std::vector<PropertyGlobals> declare_material(const engines::Engine& engine, const resolve::Material& material,
                                              ir::Module& module, bool keep_variants,
                                              std::optional<std::uint32_t> instances) {
    std::vector<PropertyGlobals> globals;
    std::map<std::string, ir::GlobalId> shared;  // samplers that textures share, by their names
    std::uint32_t constant_id = 0;
    module.blocks.push_back(
        {.name = std::string(engine.block_name("material")), .group = ir::Group::Material, .members = {}});
    const auto block = static_cast<std::uint32_t>(module.blocks.size() - 1);
    // A sampler that nodes name follows no texture (place.cpp). Textures share those that have no other name.
    globals.resize(material.properties.size());
    for (std::size_t i = 0; i < globals.size(); ++i) {
        const format::Property& property = *material.properties[i].property;
        if (property.type != PropertyType::Sampler) continue;
        // An engine whose textures have their samplers cannot set others: equal samplers are one.
        const bool is_fixed = material.properties[i].is_at_port || !engine.shares_samplers;
        const auto known = shared.find(property.shared_sampler);
        globals[i].sampler = is_fixed && known != shared.end()
                                 ? known->second
                                 : add_resource(module, is_fixed ? property.shared_sampler : property.name,
                                                ir::Kind::Sampler, ir::Group::Material, property.span);
        if (is_fixed) shared[property.shared_sampler] = globals[i].sampler;
    }
    for (std::size_t i = 0; i < globals.size(); ++i) {
        const resolve::MaterialProperty& entry = material.properties[i];
        const format::Property& property = *entry.property;
        PropertyGlobals& made = globals[i];
        if (property.type == PropertyType::Sampler) continue;
        if (format::is_keyword(property.binding)) {
            const bool is_variant = property.binding == Binding::Variant;
            if (!is_variant || (keep_variants && !entry.is_chosen)) made.keyword = add_keyword(module, entry);
            if (!is_variant) module.keywords.back().constant_id = constant_id++;
            continue;
        }
        if (!is_texture(property.type)) {
            const bool is_of_instance = instances && property.binding == Binding::Instance;
            made.value = add_block_global(module, is_of_instance ? *instances : block, property.name,
                                          property_type(module, property.type), property.span);
            // Artists see its name, so the name must not change, in any block.
            module.globals[made.value.index].group = ir::Group::Material;
            continue;
        }
        made.texture =
            add_resource(module, property.name, texture_kind(property.type), ir::Group::Material, property.span);
        made.sampler = add_sampler(module, engine, property, shared);
        if (property.tiling) {
            made.tiling = add_block_global(module, block, property.name + "_ST", ir::kFloat4, property.span);
        }
    }
    // A material without numeric properties has no block.
    if (module.blocks[block].members.empty()) module.blocks.pop_back();
    return globals;
}

}  // namespace patina::lower
