#include "compiler/ir/ir.h"

#include <algorithm>
#include <array>

#include "compiler/ir/hints.h"

namespace patina::ir {
namespace {

constexpr std::array<std::string_view, 5> kScalarNames = {"bool", "int", "uint", "half", "float"};

std::string numeric_name(Type type) {
    std::string name(kScalarNames[static_cast<std::size_t>(type.scalar)]);
    if (type.is_matrix()) return name + std::to_string(type.rows) + "x" + std::to_string(type.cols);
    if (type.is_vector()) return name + std::to_string(type.rows);
    return name;
}

constexpr std::uint32_t kFree = 0xffffffffu;

std::uint32_t find_name(const std::vector<std::string>& names, const std::vector<std::uint32_t>& slots,
                        std::string_view name) {
    if (slots.empty()) return kFree;
    const std::size_t mask = slots.size() - 1;
    std::size_t slot = std::hash<std::string_view>{}(name)&mask;
    while (slots[slot] != kFree && names[slots[slot]] != name) slot = (slot + 1) & mask;
    return slots[slot];
}

}  // namespace

std::string_view to_string(Rate rate) {
    switch (rate) {
        case Rate::Constant: return "constant";
        case Rate::Uniform: return "uniform";
        case Rate::Vertex: return "vertex";
        case Rate::Pixel: return "pixel";
        case Rate::Light: return "light";
    }
    return "";
}

NameId Module::intern(std::string_view name) {
    if (name.empty()) return {};
    if (const std::uint32_t known = find_name(names, name_slots_, name); known != kFree) return {known};
    const auto made = static_cast<std::uint32_t>(names.size());
    names.emplace_back(name);
    index_name(made);
    return {made};
}

std::string_view Module::name_of(NameId id) const {
    return hint_of(*this, id).name;
}

void Module::index_name(std::uint32_t index) {
    if (2 * names.size() > name_slots_.size()) {
        name_slots_.assign(std::max<std::size_t>(64, 2 * name_slots_.size()), kFree);
        for (std::uint32_t i = 0; i < names.size(); i++) index_name(i);
        return;
    }
    const std::size_t mask = name_slots_.size() - 1;
    std::size_t slot = std::hash<std::string_view>{}(names[index]) & mask;
    while (name_slots_[slot] != kFree) slot = (slot + 1) & mask;
    name_slots_[slot] = index;
}

Type Module::array_of(Type element, std::uint32_t count) {
    const Array wanted{element, count};
    const auto found = std::find(arrays.begin(), arrays.end(), wanted);
    const auto index = static_cast<std::uint32_t>(found - arrays.begin());
    if (found == arrays.end()) arrays.push_back(wanted);
    return Type::array(index);
}

std::string Module::type_name(Type type) const {
    switch (type.kind) {
        case Kind::Void: return "void";
        case Kind::Numeric: return numeric_name(type);
        case Kind::Array: {
            if (type.ref >= arrays.size()) return "<no array " + std::to_string(type.ref) + ">";
            const Array& array = arrays[type.ref];
            // An array's element may be an array declared before it, never itself: anything else is not printed.
            if (array.element.kind == Kind::Array && array.element.ref >= type.ref) return "<array of itself>";
            return type_name(array.element) + "[" + std::to_string(array.count) + "]";
        }
        case Kind::Struct:
            if (type.ref >= structs.size()) return "<no struct " + std::to_string(type.ref) + ">";
            return structs[type.ref].name;
        case Kind::Texture2D: return "Texture2D";
        case Kind::TextureCube: return "TextureCube";
        case Kind::Texture2DArray: return "Texture2DArray";
        case Kind::Texture3D: return "Texture3D";
        case Kind::Sampler: return "SamplerState";
        case Kind::Error: return "<error>";
    }
    return "";
}

std::uint32_t part_count(const Module& module, Type composite) {
    if (composite.is_vector() || composite.is_matrix()) return composite.rows;
    if (composite.kind == Kind::Struct && composite.ref < module.structs.size()) {
        return static_cast<std::uint32_t>(module.structs[composite.ref].members.size());
    }
    if (composite.kind == Kind::Array && composite.ref < module.arrays.size())
        return module.arrays[composite.ref].count;
    return 0;
}

Type part_type(const Module& module, Type composite, std::uint32_t index) {
    if (index >= part_count(module, composite)) return Type::error();
    if (composite.is_vector()) return composite.with_width(1);
    if (composite.is_matrix()) return composite.with_width(composite.cols);
    if (composite.kind == Kind::Struct) return module.structs[composite.ref].members[index].type;
    return module.arrays[composite.ref].element;
}

namespace {

void mark_structs(const Module& module, Type type, std::vector<bool>& marked) {
    if (type.kind == Kind::Array) return mark_structs(module, module.arrays[type.ref].element, marked);
    if (type.kind != Kind::Struct || marked[type.ref]) return;
    marked[type.ref] = true;
    for (const Member& member : module.structs[type.ref].members) mark_structs(module, member.type, marked);
}

}  // namespace

std::vector<bool> shared_structs(const Module& module) {
    std::vector<bool> shared(module.structs.size(), false);
    for (const Function& function : module.functions) {
        if (function.linkage != Linkage::External) continue;
        mark_structs(module, function.result, shared);
        for (const Param& param : function.params) mark_structs(module, param.type, shared);
    }
    return shared;
}

}  // namespace patina::ir
