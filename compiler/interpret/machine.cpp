// The memory of a machine for its callers: the layout of a value, and writing values before the machine runs.
#include "compiler/interpret/machine.h"

#include <algorithm>

#include "compiler/interpret/interpret.h"
#include "compiler/interpret/rounding.h"

namespace patina::interpret {

std::size_t flat_size(const ir::Module& module, ir::Type type) {
    switch (type.kind) {
        case ir::Kind::Void:
        case ir::Kind::Error: return 0;
        case ir::Kind::Numeric: return type.components();
        case ir::Kind::Texture2D:
        case ir::Kind::TextureCube:
        case ir::Kind::Texture2DArray:
        case ir::Kind::Texture3D:
        case ir::Kind::Sampler: return 1;
        case ir::Kind::Array: {
            const ir::Array& array = module.arrays[type.ref];
            return array.count * flat_size(module, array.element);
        }
        case ir::Kind::Struct: {
            std::size_t sum = 0;
            for (const ir::Member& member : module.structs[type.ref].members) sum += flat_size(module, member.type);
            return sum;
        }
    }
    return 0;
}

void append_slot_types(const ir::Module& module, ir::Type type, std::vector<ir::Type>& into) {
    if (type.is_numeric()) {
        into.insert(into.end(), type.components(), ir::Type::scalar_of(type.scalar));
    } else if (type.is_opaque()) {
        into.push_back(type);
    } else {
        for (std::uint32_t i = 0; i < ir::part_count(module, type); ++i) {
            append_slot_types(module, ir::part_type(module, type, i), into);
        }
    }
}

void Machine::set_argument(std::size_t component, unsigned lane, double value) {
    const ir::Type type = argument_types[component];
    at(first_argument + static_cast<Slot>(component))[lane] =
        type.is_numeric() ? fit(type.scalar, precision, value) : value;
}

void set_uniform(Machine& machine, const ir::Module& module, ir::GlobalId global, std::span<const double> components) {
    const Slot slot = machine.globals[global.index];
    if (slot == kNowhere) return;
    std::vector<ir::Type> types;
    append_slot_types(module, module.globals[global.index].type, types);
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (types[i].is_opaque()) continue;
        const double value = i < components.size() ? fit(types[i].scalar, machine.precision, components[i]) : 0;
        std::fill_n(machine.at(slot + static_cast<Slot>(i)), kLanes, value);
    }
}

void set_texture(Machine& machine, ir::GlobalId global, std::shared_ptr<const TextureData> texture) {
    const auto is_whole = [&](const TextureLevel& level) {
        return level.width > 0 && level.height > 0 && level.depth > 0 &&
               level.texels.size() >=
                   4 * static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height) *
                       static_cast<std::size_t>(level.depth) * static_cast<std::size_t>(texture->layers);
    };
    const bool is_usable = texture && texture->layers > 0 && !texture->levels.empty() &&
                           std::all_of(texture->levels.begin(), texture->levels.end(), is_whole);
    machine.textures[global.index] = is_usable ? std::move(texture) : nullptr;
}

}  // namespace patina::interpret
