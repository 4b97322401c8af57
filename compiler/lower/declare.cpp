#include "compiler/lower/declare.h"

#include <algorithm>

namespace patina::graph {

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
                              .slot = 0,
                              .set = module.blocks[block].set,
                              .span = span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

ir::GlobalId add_resource(ir::Module& module, std::string name, ir::Kind kind, std::uint32_t set, std::uint32_t slot,
                          Span span) {
    module.globals.push_back({.name = std::move(name), .type = Type::of(kind), .slot = slot, .set = set, .span = span});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

std::optional<ir::Kind> texture_kind(std::string_view type) {
    if (type == "Texture2D") return ir::Kind::Texture2D;
    if (type == "TextureCube") return ir::Kind::TextureCube;
    return {};
}

// Not bound to a switch or a path, or to one that is on.
bool is_wanted(const nodelang::VariableDecl& variable, std::span<const std::string_view> on) {
    const nodelang::Attribute* with = variable.attribute("with");
    if (!with) return true;
    const std::vector<std::string_view> words = attribute_words(*with);
    return std::find_first_of(words.begin(), words.end(), on.begin(), on.end()) != words.end();
}

// Bools stay bools: no uniform block holds them.
ir::GlobalId add_keyword(ir::Module& module, const MaterialProperty& entry) {
    const Property& property = *entry.property;
    module.globals.push_back({.name = property.name,
                              .type = property.type == PropertyType::Bool ? ir::kBool : ir::kInt,
                              .keyword = static_cast<std::uint32_t>(module.keywords.size()),
                              .set = kMaterialSet,
                              .span = property.span});
    module.keywords.push_back({.property = property.name, .value = entry.chosen, .values = property.values});
    return {static_cast<std::uint32_t>(module.globals.size() - 1)};
}

}  // namespace

Type property_type(PropertyType type) {
    switch (type) {
        case PropertyType::Float: return ir::kFloat;
        case PropertyType::Float2: return ir::kFloat2;
        case PropertyType::Float3: return ir::kFloat3;
        case PropertyType::Float4:
        case PropertyType::Color: return ir::kFloat4;
        case PropertyType::Int:
        case PropertyType::Bool:
        case PropertyType::Enum: return ir::kInt;
        case PropertyType::Texture2D: return Type::of(ir::Kind::Texture2D);
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
        // Compilers differ on what may follow an array or a matrix in its last 16 bytes: nothing does here.
        if (before.alignment == 16 && last.type.kind == ir::Kind::Array) end = round_up(end, 16);
        if (last.type.is_matrix()) end = round_up(end, 16);
    }
    const std::uint32_t offset = round_up(end, e.alignment);
    block.members.push_back({.name = std::move(name), .type = type, .offset = offset, .padding = (offset - end) / 4});
    block.size = round_up(offset + e.size, 16);
}

namespace {

// What included files declare, and in whose place it stands.
void declare_foreign(const Stages& stages, const nodelang::Declarations& declarations, nodelang::Emitter& emitter) {
    const nodelang::Scope scope{.declarations = &declarations};
    for (const nodelang::VariableDecl* variable : stages.foreign) {
        const std::string_view spelling = nodelang::attribute_text(*variable->attribute("foreign"));
        emitter.module().globals.push_back({.name = std::string(variable->name),
                                            .type = emitter.type(variable->type, scope),
                                            .set = kForeignSet,
                                            .span = variable->span,
                                            .spelling = std::string(spelling.empty() ? variable->name : spelling)});
        emitter.set_extern(variable, {static_cast<std::uint32_t>(emitter.module().globals.size() - 1)});
    }
    for (const GivenDecl& given : stages.given) {
        const nodelang::VariableDecl* replaced = given.variable ? declarations.variable(given.what) : nullptr;
        if (!replaced || !replaced->attribute("extern")) continue;
        emitter.share_extern(replaced, given.variable);
        if (replaced->attribute("perObject"))
            emitter.module().globals[emitter.extern_global(*given.variable)->index].is_of_object = true;
    }
}

}  // namespace

EngineGlobals declare_engine(const Stages& stages, const nodelang::Declarations& declarations,
                             nodelang::Emitter& emitter, std::span<const std::string_view> on) {
    EngineGlobals made;
    ir::Module& module = emitter.module();
    const nodelang::Scope scope{.declarations = &declarations};
    std::uint32_t textures = 0, targets = 0;
    std::vector<const nodelang::VariableDecl*> externs = stages.externs;
    std::erase_if(externs, [&](const nodelang::VariableDecl* each) { return !is_wanted(*each, on); });
    std::stable_partition(externs.begin(), externs.end(),
                          [](const nodelang::VariableDecl* each) { return !each->attribute("with"); });
    for (const nodelang::VariableDecl* each : externs) {
        const nodelang::VariableDecl& variable = *each;
        const nodelang::Attribute* attribute = variable.attribute("extern");
        if (const std::optional<ir::Kind> kind = texture_kind(variable.type.name)) {
            const std::string texture(variable.name);
            const std::uint32_t set = attribute ? kEngineSet : kTargetSet;
            std::uint32_t& slot = attribute ? textures : targets;
            const ir::GlobalId global = add_resource(module, texture, *kind, set, slot, variable.span);
            emitter.set_extern(&variable, global);
            if (const nodelang::Attribute* reads = variable.attribute("reads"))
                made.reads[global.index] = nodelang::attribute_text(*reads);
            add_resource(module, texture + "Sampler", ir::Kind::Sampler, set, slot, variable.span);
            ++slot;
            continue;
        }
        const std::string_view name = nodelang::attribute_text(*attribute);
        auto block = std::find_if(module.blocks.begin(), module.blocks.end(),
                                  [&](const ir::UniformBlock& b) { return b.name == name; });
        if (block == module.blocks.end()) {
            module.blocks.push_back({.name = std::string(name),
                                     .set = kEngineSet,
                                     .slot = static_cast<std::uint32_t>(module.blocks.size()),
                                     .size = 0,
                                     .members = {}});
            block = module.blocks.end() - 1;
        }
        const Type type = emitter.type(variable.type, scope);
        const auto index = static_cast<std::uint32_t>(block - module.blocks.begin());
        const ir::GlobalId global = add_block_global(module, index, std::string(variable.name), type, variable.span);
        emitter.set_extern(&variable, global);
        if (variable.attribute("perObject")) made.per_object.insert(global.index);
    }
    declare_foreign(stages, declarations, emitter);
    for (const nodelang::VariableDecl* older : stages.repeated) {
        const nodelang::VariableDecl* newer = declarations.variable(older->name);
        if (newer) emitter.share_extern(older, newer);
    }
    return made;
}

std::vector<PropertyGlobals> declare_material(const Material& material, ir::Module& module, bool keep_variants,
                                              std::optional<std::uint32_t> instances) {
    std::vector<PropertyGlobals> globals;
    std::uint32_t constant_id = 0;
    module.blocks.push_back({.name = "Material", .set = kMaterialSet, .slot = 0, .size = 0, .members = {}});
    const auto block = static_cast<std::uint32_t>(module.blocks.size() - 1);
    std::uint32_t slot = 0;
    for (const MaterialProperty& entry : material.properties) {
        const Property& property = *entry.property;
        PropertyGlobals& made = globals.emplace_back();
        if (is_keyword(property.binding)) {
            const bool is_variant = property.binding == Binding::Variant;
            if (!is_variant || (keep_variants && !entry.is_chosen)) made.keyword = add_keyword(module, entry);
            if (!is_variant) module.keywords.back().constant_id = constant_id++;
            continue;
        }
        if (property.type != PropertyType::Texture2D) {
            const bool is_of_instance = instances && property.binding == Binding::Instance;
            made.value = add_block_global(module, is_of_instance ? *instances : block, property.name,
                                          property_type(property.type), property.span);
            // Whatever block it is in, the name is the artist's.
            module.globals[made.value.index].set = kMaterialSet;
            continue;
        }
        made.texture = add_resource(module, property.name, ir::Kind::Texture2D, kMaterialSet, slot, property.span);
        made.sampler =
            add_resource(module, "sampler" + property.name, ir::Kind::Sampler, kMaterialSet, slot, property.span);
        if (property.tiling) {
            made.tiling = add_block_global(module, block, property.name + "_ST", ir::kFloat4, property.span);
        }
        ++slot;
    }
    // A material without numeric properties has no block.
    if (module.blocks[block].members.empty()) module.blocks.pop_back();
    return globals;
}

}  // namespace patina::graph
