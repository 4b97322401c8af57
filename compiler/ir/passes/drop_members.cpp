#include <algorithm>
#include <utility>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// Finds what is read, over all functions at once. The set only grows. A member of a struct is read when something
// extracts it; until then, the values that were put there wait.
class Reads {
public:
    Reads(const Module& module, std::span<const FunctionId> entries, std::span<const FunctionId> called)
        : module_(module), live_(module.functions.size()) {
        for (const Struct& each : module.structs) members_.emplace_back(each.members.size());
        waiting_.resize(members_.size());
        for (std::size_t i = 0; i < members_.size(); i++) waiting_[i].resize(members_[i].size());
        for (const Function& function : module.functions) {
            if (!is_elsewhere(function)) continue;
            read_whole(function.result);
            for (const Param& param : function.params) read_whole(param.type);
        }
        for (const FunctionId entry : entries) {
            read_whole(module[entry].result);
            call(entry.index);
        }
        for (const FunctionId function : called) call(function.index);
        do {
            while (!work_.empty()) {
                const auto [function, value] = work_.back();
                work_.pop_back();
                visit(function, value);
            }
        } while (keep_one_member());
    }

    bool is_called(std::size_t function) const { return !live_[function].values.empty(); }
    const Liveness& live(std::size_t function) const { return live_[function]; }
    const std::vector<std::uint8_t>& members(std::uint32_t structure) const { return members_[structure]; }

private:
    struct Part {
        std::uint32_t function = 0;
        Value value{};
    };

    void read_whole(Type type) {
        if (type.kind != Kind::Struct) return;
        for (std::uint32_t i = 0; i < members_[type.ref].size(); i++) {
            read(type.ref, i);
            read_whole(module_.structs[type.ref].members[i].type);
        }
    }

    // No struct may be empty: if no member of one is read, its first member stays.
    bool keep_one_member() {
        for (std::uint32_t i = 0; i < members_.size(); i++) {
            const bool is_read = std::count(members_[i].begin(), members_[i].end(), 1) > 0;
            if (is_read || members_[i].empty() || waiting_[i][0].empty()) continue;
            read(i, 0);
            return true;
        }
        return false;
    }

    void read(std::uint32_t structure, std::uint32_t member) {
        if (std::exchange(members_[structure][member], 1) != 0) return;
        for (const Part& part : std::exchange(waiting_[structure][member], {})) need(part.function, part.value);
    }

    void need(std::uint32_t f, Value value) {
        if (std::exchange(live_[f].values[value.index], 1) == 0) work_.push_back({f, value});
    }

    void need_part(std::uint32_t f, Type type, std::uint32_t member, Value value) {
        if (type.kind != Kind::Struct || members_[type.ref][member] != 0) return need(f, value);
        waiting_[type.ref][member].push_back({f, value});
    }

    bool discards(std::uint32_t f) const {
        const Function& function = module_.functions[f];
        return std::any_of(function.insts.begin(), function.insts.end(),
                           [](const Inst& inst) { return inst.op == Op::DiscardIf; });
    }

    void call(std::uint32_t f) {
        if (is_called(f)) return;
        const Function& function = module_.functions[f];
        live_[f].values.resize(function.insts.size());
        live_[f].operands.assign(function.operands.size(), 1);
        for (const Value value : function.blocks[0].insts) {
            const Inst& inst = function[value];
            const bool acts = has(inst.op, Effect) || (inst.op == Op::Call && discards(inst.data));
            if (acts) need(f, value);
        }
    }

    void need_yields(std::uint32_t f, std::uint32_t block) {
        for (const Value value : yielded(module_.functions[f], block)) need(f, value);
    }

    void visit(std::uint32_t f, Value value) {
        const Function& function = module_.functions[f];
        const Inst& inst = function[value];
        const auto args = function.args(inst);
        if (inst.op == Op::Construct) {
            for (std::uint32_t i = 0; i < args.size(); i++) need_part(f, inst.type, i, args[i]);
            return;
        }
        if (inst.op == Op::Insert) {
            need(f, args[0]);
            return need_part(f, inst.type, inst.data, args[1]);
        }
        if (inst.op == Op::Extract && function[args[0]].type.kind == Kind::Struct)
            read(function[args[0]].type.ref, inst.data);
        if (inst.op == Op::Call) call(inst.data);
        if (inst.op == Op::If || inst.op == Op::For) need_yields(f, inst.data);
        if (inst.op == Op::If) need_yields(f, inst.data + 1);
        for (const Value arg : args) need(f, arg);
    }

    const Module& module_;
    std::vector<Liveness> live_;                      // by function; empty: nothing calls it
    std::vector<std::vector<std::uint8_t>> members_;  // by struct
    std::vector<std::vector<std::vector<Part>>> waiting_;
    std::vector<Part> work_;
};

// By struct and old member: the new one, and whether it stays.
struct Places {
    std::vector<std::vector<std::uint32_t>> places;
    std::vector<std::vector<std::uint8_t>> stays;

    bool keeps(Type type, std::uint32_t member) const {
        return type.kind != Kind::Struct || stays[type.ref][member] != 0;
    }
    std::uint32_t of(Type type, std::uint32_t member) const {
        return type.kind == Kind::Struct ? places[type.ref][member] : member;
    }
};

Places drop(Module& module, const Reads& reads) {
    Places made;
    for (std::uint32_t s = 0; s < module.structs.size(); s++) {
        std::vector<std::uint8_t> stays = reads.members(s);
        // A struct that nothing reaches stays as it is.
        if (std::count(stays.begin(), stays.end(), 1) == 0) std::fill(stays.begin(), stays.end(), 1);
        std::vector<std::uint32_t>& places = made.places.emplace_back();
        std::vector<Member> kept;
        for (std::uint32_t i = 0; i < stays.size(); i++) {
            places.push_back(static_cast<std::uint32_t>(kept.size()));
            if (stays[i] != 0) kept.push_back(std::move(module.structs[s].members[i]));
        }
        module.structs[s].members = std::move(kept);
        made.stays.push_back(std::move(stays));
    }
    return made;
}

bool rewrite(Copy& copy, Value value, const Places& places) {
    const Inst& inst = copy.from[value];
    const auto args = copy.from.args(inst);
    if (inst.op != Op::Construct && inst.op != Op::Insert && inst.op != Op::Extract) return false;
    const Type whole = inst.op == Op::Construct ? inst.type : copy.from[args[0]].type;
    if (whole.kind != Kind::Struct) return false;
    copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
    Value made;
    if (inst.op == Op::Construct) {
        std::vector<Value> parts;
        for (std::uint32_t i = 0; i < args.size(); i++) {
            if (places.keeps(whole, i)) parts.push_back(copy.map[args[i].index]);
        }
        made = copy.to.construct(inst.type, parts);
    } else if (inst.op == Op::Extract) {
        made = copy.to.extract(copy.map[args[0].index], places.of(whole, inst.data));
    } else if (!places.keeps(whole, inst.data)) {
        made = copy.map[args[0].index];
    } else {
        made = copy.to.emit(Op::Insert, whole, {copy.map[args[0].index], copy.map[args[1].index]},
                            places.of(whole, inst.data));
    }
    copy.to.name(made, inst.name);
    copy.map[value.index] = made;
    return true;
}

// A function that nothing reaches may read members that are gone: its body becomes empty.
void empty(Module& module, Function& function) {
    function = shell(function);
    Builder builder(module, function);
    const Type type = function.result;
    builder.ret(type == Type::none() ? Value() : builder.zero(type));
}

}  // namespace

Module drop_members(Module module, std::span<const FunctionId> entries, std::span<const FunctionId> called) {
    const Reads reads(module, entries, called);
    const Places places = drop(module, reads);
    for (std::size_t f = 0; f < module.functions.size(); f++) {
        if (is_elsewhere(module.functions[f])) continue;
        if (!reads.is_called(f)) {
            empty(module, module.functions[f]);
            continue;
        }
        Function old = std::move(module.functions[f]);
        Function made = take_shell(old);
        Builder builder(module, made);
        Copy copy{.from = old, .to = builder, .live = &reads.live(f), .rewrite = [&](Copy& c, Value v) {
                      return rewrite(c, v, places);
                  }};
        copy_body(copy);
        module.functions[f] = std::move(made);
    }
    return module;
}

}  // namespace patina::ir
