#include "compiler/emit/known.h"

namespace patina::emit {

const Slot* find_slot(const Known& known, std::string_view name) {
    const auto found = known.slots.find(name);
    return found == known.slots.end() ? nullptr : &found->second;
}

std::string_view slot_name(const Known& known, ir::FunctionId function) {
    for (const auto& [name, slot] : known.slots) {
        if (slot.function == function) return name;
    }
    return {};
}

std::optional<ir::GlobalId> find_extern(const Known& known, const nodelang::VariableDecl& variable) {
    const auto found = known.externs.find(&variable);
    return found == known.externs.end() ? std::nullopt : std::optional(found->second);
}

void share_extern(Known& known, const nodelang::VariableDecl& variable, const nodelang::VariableDecl& known_as) {
    if (const std::optional<ir::GlobalId> global = find_extern(known, known_as)) known.externs[&variable] = *global;
}

StaticValue static_value(const Known& known, const nodelang::VariableDecl& variable, ir::Builder* builder) {
    const auto found = known.statics.find(&variable);
    if (found != known.statics.end()) return {.constant = found->second};
    return known.make_static ? known.make_static(variable, builder) : StaticValue{};
}

}  // namespace patina::emit
