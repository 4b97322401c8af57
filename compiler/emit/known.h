// What emission must know of declarations without a body in the language: which function fills a slot, which global an
// [extern] variable is, which value a [static] has. Emission reads this and never changes it. If an entry is missing,
// one of the two makers makes it.
//
//   emitter.known.slots["direct"] = {.function = direct, .result = ir::kFloat3};
//   emitter.known.externs[&variable] = global;
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/ir/ir.h"
#include "compiler/nodelang/ast.h"

namespace patina::ir {
class Builder;
}

namespace patina::emit {

// A function that a pass calls and that the graph provides.
struct Slot {
    ir::FunctionId function;
    ir::Type result{};
    bool needs_quad = false;
};

// The value of a [static]: 0 or 1, or a bool that was emitted. Neither: it is not known here.
struct StaticValue {
    std::optional<double> constant{};
    ir::Value emitted{};
};

struct Known {
    std::map<std::string, Slot, std::less<>> slots{};
    std::map<const nodelang::VariableDecl*, ir::GlobalId> externs{};
    std::map<const nodelang::VariableDecl*, double> statics{};  // [static] variables, which are 0 or 1
    // Members that a struct gets beyond those of its declaration, before anything reads the struct.
    std::map<const nodelang::StructDecl*, std::vector<ir::Member>> extra_members{};
    // Makes a slot or a static that is not listed above. If there is no such slot, the maker reports why at `at`. A
    // static that keywords decide is emitted, if there is a builder.
    std::function<const Slot*(const nodelang::FunctionDecl& slot, Span at)> make_slot{};
    std::function<StaticValue(const nodelang::VariableDecl& variable, ir::Builder* builder)> make_static{};
};

const Slot* find_slot(const Known& known, std::string_view name);
// The name of the slot that the function fills, or empty.
std::string_view slot_name(const Known& known, ir::FunctionId function);
std::optional<ir::GlobalId> find_extern(const Known& known, const nodelang::VariableDecl& variable);
// `variable` means the same global as `known_as`.
void share_extern(Known& known, const nodelang::VariableDecl& variable, const nodelang::VariableDecl& known_as);
StaticValue static_value(const Known& known, const nodelang::VariableDecl& variable, ir::Builder* builder);

}  // namespace patina::emit
