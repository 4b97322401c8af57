#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// What all values of a struct type have in one member, as far as they have been seen.
struct Member {
    std::optional<std::uint32_t> constant{};  // index into Module::constants
    bool differs = false;

    bool is_settled() const { return constant && !differs; }
};

class Members {
public:
    explicit Members(const Module& module) : module_(module) {
        for (const Struct& each : module.structs) members_.emplace_back(each.members.size());
        for (const Function& function : module.functions) look_at(function);
    }

    const Member& of(Type type, std::uint32_t member) const { return members_[type.ref][member]; }

    bool has_settled() const {
        for (const std::vector<Member>& of_struct : members_) {
            for (const Member& member : of_struct) {
                if (member.is_settled()) return true;
            }
        }
        return false;
    }

private:
    void look_at(const Function& function) {
        // Other texts, too, make the arguments of exported functions, and read their results.
        if (is_elsewhere(function) || function.linkage == Linkage::Exported) {
            come_from_elsewhere(function.result);
            for (const Param& param : function.params) come_from_elsewhere(param.type);
        }
        if (is_elsewhere(function)) return;
        for (const Inst& inst : function.insts) {
            const auto args = function.args(inst);
            if (inst.op == Op::Construct && inst.type.kind == Kind::Struct) {
                for (std::uint32_t i = 0; i < args.size(); ++i) put(function[args[i]], members_[inst.type.ref][i]);
            }
            if (inst.op == Op::Insert && inst.type.kind == Kind::Struct)
                put(function[args[1]], members_[inst.type.ref][inst.data]);
        }
    }

    void come_from_elsewhere(Type type) {
        if (type.kind != Kind::Struct) return;
        for (std::uint32_t i = 0; i < members_[type.ref].size(); ++i) {
            members_[type.ref][i].differs = true;
            come_from_elsewhere(module_.structs[type.ref].members[i].type);
        }
    }

    void put(const Inst& value, Member& into) const {
        if (value.op != Op::Constant || (into.constant && !is_same(*into.constant, value.data))) {
            into.differs = true;
        } else {
            into.constant = value.data;
        }
    }

    // By bits: 0 is not -0.
    bool is_same(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return true;
        const auto left = module_.numbers_of(module_.constants[a]), right = module_.numbers_of(module_.constants[b]);
        return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                          [](double x, double y) { return x == y && std::signbit(x) == std::signbit(y); });
    }

    const Module& module_;
    std::vector<std::vector<Member>> members_;  // by struct
};

// The member that an instruction reads; null if it reads none.
const Member* read_by(const Members& members, const Function& function, const Inst& inst) {
    if (inst.op != Op::Extract) return nullptr;
    const Type whole = function[function.args(inst)[0]].type;
    return whole.kind == Kind::Struct ? &members.of(whole, inst.data) : nullptr;
}

bool settle(Module& module) {
    const Members members(module);
    if (!members.has_settled()) return false;
    bool changed = false;
    for (Function& function : module.functions) {
        const auto reads_settled = [&](const Inst& inst) {
            const Member* member = read_by(members, function, inst);
            return member && member->is_settled();
        };
        if (std::none_of(function.insts.begin(), function.insts.end(), reads_settled)) continue;
        Function old = std::move(function);
        Function made = take_shell(old);
        Builder builder(module, made);
        Copy copy{.from = old, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      const Inst& inst = c.from[v];
                      const Member* member = read_by(members, c.from, inst);
                      if (!member || !member->is_settled()) return false;
                      // A copy, because the constant that is made may move the numbers.
                      const auto numbers = module.numbers_of(module.constants[*member->constant]);
                      c.map[v.index] = c.to.constant(inst.type, std::vector<double>(numbers.begin(), numbers.end()));
                      return true;
                  }};
        copy_body(copy);
        function = std::move(made);
        changed = true;
    }
    return changed;
}

}  // namespace

Module settle_members(Module module) {
    // The value of a member of one struct may come from a member of another one.
    for (std::size_t round = 0; round <= module.structs.size() && settle(module); ++round) {
    }
    return module;
}

}  // namespace patina::ir
