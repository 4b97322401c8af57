// Makes the derived slots when a pass first requests them: the part of a slot that is linear in a value, the remainder
// of the slot, and the packing of values for which a G-buffer has no room.
//
//   [slot] [part("final", "sum.direct")] float3 added(LightingSurface surface, LightSum sum);
//   [slot] [without("indirect", "EnvironmentRadiance")] float3 indirect_near(LightingSurface surface);
//   [slot] [pack("direct", "added")] [holds("diffuseColor", "f0")] Extras packSurface(LightingSurface surface);
//   [slot] [unpack("packSurface")] LightingSurface unpackSurface(LightingSurface surface, Extras extras);
#include <fmt/format.h>

#include <algorithm>

#include "compiler/ir/linear/linear_part.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;

using Making = paths::SlotDecl::Making;

const paths::SlotDecl* find_slot(const Lowering& lowering, std::string_view name) {
    return lowering.session.paths->slot(name);
}

// The slot's function; the slot may itself be derived.
const emit::Slot* slot_named(Lowering& lowering, std::string_view name) {
    const paths::SlotDecl* slot = find_slot(lowering, name);
    if (slot && slot->is_derived()) return &derived_slot(lowering, *slot).slot;
    return emit::find_slot(lowering.emitter.known, name);
}

std::optional<std::uint32_t> member_index(const ir::Module& module, Type structure, std::string_view name) {
    if (structure.kind != ir::Kind::Struct) return {};
    const std::vector<ir::Member>& members = module.structs[structure.ref].members;
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        if (members[i].name == name) return i;
    }
    return {};
}

// "sum.direct": a member of a parameter of the slot; "EnvironmentRadiance": the result of this function.
struct LinearIn {
    std::optional<ir::Seed> seed{};
    bool is_absent = false;  // the slot does not call the function
    std::string why_not{};
};
LinearIn source_named(Lowering& lowering, const FunctionDecl& of, ir::FunctionId function, std::string_view name) {
    const ir::Module& module = lowering.out.module;
    const std::size_t dot = name.find('.');
    if (dot != name.npos) {
        for (std::uint32_t i = 0; i < of.params.size(); ++i) {
            if (of.params[i].name != name.substr(0, dot)) continue;
            const auto member = member_index(module, module[function].params[i].type, name.substr(dot + 1));
            if (member) return {.seed = ir::Seed::of_member(i, *member)};
        }
        return {.why_not = fmt::format("'{}' has no '{}'", of.name, name)};
    }
    const FunctionDecl* callee = lowering.session.declarations->function(name);
    if (!callee) return {.why_not = fmt::format("there is no function '{}'", name)};
    const std::vector<emit::InstanceInfo> made = lowering.emitter.instances.of(*callee);
    if (made.empty()) return {.is_absent = true};
    if (made.size() > 1) return {.why_not = fmt::format("it calls '{}' in two precisions", name)};
    return {.seed = ir::Seed::of_calls(made.front().id)};
}

// A part may read only one member of its parameter's struct, that in which it is linear. The other members are not
// known where the part is used.
std::string other_member_of(const ir::Module& module, ir::FunctionId function, const ir::Seed& seed) {
    if (seed.callee) return {};
    for (const ir::MemberRead& read : ir::members_read(module, function, seed.param)) {
        if (read.member != seed.member)
            return module.structs[module[function].params[seed.param].type.ref].members[read.member].name;
    }
    return {};
}

ir::Origin origin_of(const ir::Module& module, ir::OriginId id) {
    return id ? module.origins[id.index] : ir::Origin{};
}

// The graph's own slot at the end of the chain of derived slots.
std::string_view root_of(const Lowering& lowering, std::string_view of) {
    for (const paths::SlotDecl* slot = find_slot(lowering, of); slot; slot = find_slot(lowering, of)) {
        if (slot->making != Making::Part && slot->making != Making::Without) break;
        of = slot->of;
    }
    return of;
}

DerivedSlot not_linear(const Lowering& lowering, std::string_view of, std::string_view name,
                       const ir::LinearPart& found) {
    return {.why_not = fmt::format("'{}' must be linear in '{}', but {}", root_of(lowering, of), name, found.reason),
            .where = origin_of(lowering.out.module, found.origin)};
}

DerivedSlot linear_slot(Lowering& lowering, const paths::SlotDecl& slot) {
    ir::Module& module = lowering.out.module;
    const std::string_view of = slot.of;
    const emit::Slot* whole = slot_named(lowering, of);
    const paths::SlotDecl* declared = find_slot(lowering, of);
    if (declared && declared->is_derived() && !derived_slot(lowering, *declared).slot.function) {
        DerivedSlot missing = derived_slot(lowering, *declared);
        missing.is_of_missing = true;
        return missing;
    }
    if (!whole || !whole->function || !declared) return {.why_not = fmt::format("there is no '{}'", of)};
    const std::string_view name = slot.source;
    const LinearIn source = source_named(lowering, *declared->function, whole->function, name);
    if (source.is_absent) return {.why_not = fmt::format("'{}' does not call '{}'", of, name)};
    if (!source.seed) return {.why_not = source.why_not};
    const bool componentwise = slot.is_componentwise;
    ir::LinearPart made = ir::linear_part(module, whole->function, *source.seed,
                                          {.componentwise = componentwise, .build = lowering.emitter.options});
    if (!made.function) return not_linear(lowering, of, name, made);
    made.function->name = slot.name();
    made.function->comment = nodelang::first_sentence(slot.function->doc);
    const ir::FunctionId function = add_function(module, std::move(*made.function));
    if (const std::string other = componentwise ? "" : other_member_of(module, function, *source.seed); !other.empty())
        return {.why_not = fmt::format("the way that '{}' uses '{}' also depends on '{}'", of, name, other)};
    return {.slot = {.function = function, .result = whole->result, .needs_quad = whole->needs_quad},
            .is_zero = !made.depends};
}

DerivedSlot slot_without(Lowering& lowering, const paths::SlotDecl& slot) {
    ir::Module& module = lowering.out.module;
    const std::string_view of = slot.of;
    const emit::Slot* whole = slot_named(lowering, of);
    const paths::SlotDecl* declared = find_slot(lowering, of);
    if (!whole || !whole->function || !declared) return {.why_not = fmt::format("there is no '{}'", of)};
    const std::string_view name = slot.source;
    const LinearIn source = source_named(lowering, *declared->function, whole->function, name);
    if (source.is_absent) return {.slot = *whole};
    if (!source.seed) return {.why_not = source.why_not};
    const ir::LinearPart taken =
        ir::linear_part(module, whole->function, *source.seed, {.build = lowering.emitter.options});
    if (!taken.function) return not_linear(lowering, of, name, taken);
    const ir::FunctionId function =
        add_function(module, ir::without(module, whole->function, *source.seed, lowering.emitter.options));
    return {.slot = {.function = function, .result = whole->result, .needs_quad = whole->needs_quad}};
}

// --- packing

struct Packing {
    std::vector<std::uint32_t> members;  // of the lighting surface
    unsigned numbers = 0;                // how many numbers they need
    std::string why_not;
};

Packing packing_of(Lowering& lowering, const paths::SlotDecl& slot, Type surface) {
    const ir::Module& module = lowering.out.module;
    const std::vector<ir::Member>& members = module.structs[surface.ref].members;
    std::vector<bool> is_read(members.size(), false);
    for (const std::string_view reader : slot.readers) {
        const emit::Slot* function = slot_named(lowering, reader);
        if (!function || !function->function) continue;
        for (const ir::MemberRead& read : ir::members_read(module, function->function, 0)) is_read[read.member] = true;
    }
    Packing packing;
    for (std::uint32_t i = 0; i < members.size(); ++i) {
        if (!is_read[i] || std::find(slot.holds.begin(), slot.holds.end(), members[i].name) != slot.holds.end())
            continue;
        if (!members[i].type.is_numeric() || members[i].type.is_matrix()) {
            packing.why_not = fmt::format("'@surface.{}' is not a number", members[i].name);
            continue;
        }
        packing.members.push_back(i);
        packing.numbers += members[i].type.components();
    }
    return packing;
}

// The number of components in the struct of float4 that a pack slot returns.
unsigned room_in(const ir::Module& module, Type extras) {
    return 4 * static_cast<unsigned>(module.structs[extras.ref].members.size());
}

Value as_scalar(ir::Builder& b, Value value, ir::Scalar scalar) {
    if (b.type(value).scalar == scalar) return value;
    if (scalar == ir::Scalar::Bool) return b.emit(ir::Op::NotEqual, ir::kBool, {value, b.constant(ir::kFloat, {0})});
    return b.convert(value, scalar);
}

ir::Function slot_shell(Lowering& lowering, const FunctionDecl& slot) {
    const emit::Scope scope{.declarations = lowering.session.declarations};
    ir::Function function{};
    function.name = slot.name;
    function.always_inline = true;
    for (const nodelang::ParamDecl& param : slot.params)
        function.params.push_back(
            {std::string(param.name), emit::type(lowering.emitter, param.type, scope), ir::Rate::Pixel});
    function.result = emit::type(lowering.emitter, slot.result, scope);
    return function;
}

DerivedSlot pack_slot(Lowering& lowering, const paths::SlotDecl& slot) {
    ir::Module& module = lowering.out.module;
    ir::Function function = slot_shell(lowering, *slot.function);
    const Packing packing = packing_of(lowering, slot, function.params[0].type);
    if (!packing.why_not.empty()) return {.why_not = packing.why_not};
    const unsigned room = room_in(module, function.result);
    if (packing.numbers > room)
        return {.why_not =
                    fmt::format("its lighting reads {} numbers that are not stored yet, and there is room for {}",
                                packing.numbers, room)};
    ir::Builder b(module, function, lowering.emitter.options);
    const Value surface = b.param(0);
    std::vector<Value> numbers;
    for (const std::uint32_t member : packing.members) {
        const Value value = b.extract(surface, member);
        const unsigned width = b.type(value).components();
        for (unsigned i = 0; i < width; ++i)
            numbers.push_back(as_scalar(b, width == 1 ? value : b.extract(value, i), ir::Scalar::Float));
    }
    numbers.resize(room, b.constant(ir::kFloat, {0}));
    std::vector<Value> fours;
    for (unsigned i = 0; i < room; i += 4) fours.push_back(b.construct(ir::kFloat4, std::span(numbers).subspan(i, 4)));
    b.ret(b.construct(function.result, fours));
    const Type result = function.result;
    return {.slot = {.function = add_function(module, std::move(function)), .result = result}};
}

DerivedSlot unpack_slot(Lowering& lowering, const paths::SlotDecl& slot) {
    ir::Module& module = lowering.out.module;
    const paths::SlotDecl* packer = find_slot(lowering, slot.of);
    if (!packer || !packer->packs()) return {.why_not = "nothing packs what it unpacks"};
    ir::Function function = slot_shell(lowering, *slot.function);
    const Packing packing = packing_of(lowering, *packer, function.result);
    ir::Builder b(module, function, lowering.emitter.options);
    const Value surface = b.param(0), extras = b.param(1);
    std::vector<Value> members;
    const std::vector<ir::Member> declared = module.structs[function.result.ref].members;
    for (std::uint32_t i = 0; i < declared.size(); ++i) members.push_back(b.extract(surface, i));
    unsigned next = 0;
    for (const std::uint32_t member : packing.members) {
        const Type type = declared[member].type;
        std::vector<Value> parts;
        for (unsigned i = 0; i < type.components(); ++i, ++next)
            parts.push_back(as_scalar(b, b.extract(b.extract(extras, next / 4), next % 4), type.scalar));
        members[member] = type.is_scalar() ? parts[0] : b.construct(type, parts);
    }
    b.ret(b.construct(function.result, members));
    const Type result = function.result;
    return {.slot = {.function = add_function(module, std::move(function)), .result = result}};
}

}  // namespace

const DerivedSlot& derived_slot(Lowering& lowering, const paths::SlotDecl& slot) {
    const auto known = lowering.derived_slots.find(slot.name());
    if (known != lowering.derived_slots.end()) return known->second;
    DerivedSlot made;
    switch (slot.making) {
        case Making::Graph: break;
        case Making::Part: made = linear_slot(lowering, slot); break;
        case Making::Without: made = slot_without(lowering, slot); break;
        case Making::Pack: made = pack_slot(lowering, slot); break;
        case Making::Unpack: made = unpack_slot(lowering, slot); break;
    }
    return lowering.derived_slots.emplace(slot.name(), std::move(made)).first->second;
}

std::vector<std::string_view> packed_members(Lowering& lowering, std::string_view slot) {
    std::vector<std::string_view> names;
    const paths::SlotDecl* packer = find_slot(lowering, slot);
    if (!packer || !packer->packs()) return names;
    const emit::Scope scope{.declarations = lowering.session.declarations};
    const Type surface = emit::type(lowering.emitter, packer->function->params[0].type, scope);
    for (const std::uint32_t member : packing_of(lowering, *packer, surface).members)
        names.push_back(lowering.out.module.structs[surface.ref].members[member].name);
    return names;
}

}  // namespace patina::lower
