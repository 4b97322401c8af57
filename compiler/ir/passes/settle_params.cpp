#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "compiler/ir/passes/dependence.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

struct Site {
    std::uint32_t caller;
    Value call;
};

class Settler {
public:
    explicit Settler(Module& module) : module_(module), sites_(module.functions.size()) {}

    // From the last function to the first, so that all callers of a function are done before it.
    void run() {
        for (std::uint32_t f = static_cast<std::uint32_t>(module_.functions.size()); f-- > 0;) {
            const Function& function = module_.functions[f];
            const bool may_change = function.linkage == Linkage::Internal && !module_.stage.shares_functions &&
                                    !is_follower(module_, function);
            if (may_change && !sites_[f].empty()) settle(f);
            for (std::uint32_t i = 0; i < module_.functions[f].insts.size(); ++i) {
                const Inst& inst = module_.functions[f].insts[i];
                if (inst.op == Op::Call) sites_[inst.data].push_back({f, {i}});
            }
        }
    }

private:
    const Function& caller(const Site& site) const { return module_.functions[site.caller]; }
    Value argument(const Site& site, std::uint32_t param) const {
        return caller(site).args(caller(site)[site.call])[param];
    }
    template <class Holds>
    bool at_all(std::uint32_t f, const Holds& holds) const {
        return std::all_of(sites_[f].begin(), sites_[f].end(), holds);
    }

    // True if the value is read from globals alone, at places that are constants, or is a constant. What an included
    // file declares may be known to the entry function alone: Unity's values of the mesh are its parameter.
    bool is_read(const Function& function, Value value) const {
        const Inst& inst = function[value];
        if (inst.op == Op::Constant) return true;
        if (inst.type.is_opaque()) return false;
        if (inst.op == Op::Global) return module_.globals[inst.data].group != Group::Included;
        const auto args = function.args(inst);
        const bool is_part = inst.op == Op::Swizzle || inst.op == Op::Extract || inst.op == Op::Index;
        return is_part && std::all_of(args.begin(), args.end(), [&](Value arg) { return is_read(function, arg); });
    }
    // For values that are read so.
    bool is_same_read(const Function& a, Value in_a, const Function& b, Value in_b) const {
        const Inst &left = a[in_a], &right = b[in_b];
        if (left.op != right.op || left.type != right.type) return false;
        if (left.op == Op::Constant) {
            const auto x = module_.numbers_of(module_.constants[left.data]);
            const auto y = module_.numbers_of(module_.constants[right.data]);
            return std::equal(x.begin(), x.end(), y.begin(), y.end());
        }
        const auto x = a.args(left), y = b.args(right);
        return left.data == right.data && std::equal(x.begin(), x.end(), y.begin(), y.end(),
                                                     [&](Value m, Value n) { return is_same_read(a, m, b, n); });
    }
    // The argument of the first caller, if every caller has the same constant or reads the same of globals.
    std::optional<Value> same_of(std::uint32_t f, std::uint32_t param) const {
        const Function& first = caller(sites_[f].front());
        const Value value = argument(sites_[f].front(), param);
        const bool is_same = is_read(first, value) && at_all(f, [&](const Site& site) {
                                 return is_same_read(first, value, caller(site), argument(site, param));
                             });
        return is_same ? std::optional(value) : std::nullopt;
    }
    Value read_again(const Function& from, Value value, Builder& to) const {
        const Inst inst = from[value];
        if (inst.op == Op::Constant) {
            // A copy, because the constant that is made may move the numbers.
            const auto numbers = module_.numbers_of(module_.constants[inst.data]);
            return to.constant(inst.type, std::vector<double>(numbers.begin(), numbers.end()));
        }
        std::vector<Value> args;
        for (const Value arg : from.args(inst)) args.push_back(read_again(from, arg, to));
        return to.emit(inst.op, inst.type, args, inst.data);
    }
    // An earlier parameter that is the same value in every call.
    std::uint32_t twin_of(std::uint32_t f, std::uint32_t param) const {
        for (std::uint32_t other = 0; other < param; ++other) {
            if (at_all(f, [&](const Site& site) { return argument(site, other) == argument(site, param); }))
                return other;
        }
        return param;
    }
    // The name of the parameter that every caller has as the argument, if it is the same in all callers.
    std::string name_of(std::uint32_t f, std::uint32_t param) const {
        const auto name = [&](const Site& site) -> std::string {
            const Inst& inst = caller(site)[argument(site, param)];
            return inst.op == Op::Param ? caller(site).params[inst.data].name : std::string();
        };
        const std::string first = name(sites_[f].front());
        return at_all(f, [&](const Site& site) { return name(site) == first; }) ? first : std::string();
    }

    void settle(std::uint32_t f) {
        const std::size_t count = module_.functions[f].params.size();
        std::vector<std::optional<Value>> settled(count);
        std::vector<std::uint32_t> twins(count);
        bool changes = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            Param& param = module_.functions[f].params[i];
            settled[i] = same_of(f, i);
            twins[i] = twin_of(f, i);
            changes = changes || settled[i] || twins[i] != i;
            const std::string name = param.is_semantic ? name_of(f, i) : std::string();
            if (!name.empty()) param.name = name;
        }
        if (!changes) return;
        const Function from = module_.functions[f];
        const Function& first = caller(sites_[f].front());
        Function made = shell(from);
        Builder builder(module_, made);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      const Inst& inst = c.from[v];
                      if (inst.op != Op::Param) return false;
                      c.map[v.index] = settled[inst.data] ? read_again(first, *settled[inst.data], c.to)
                                                          : c.to.param(twins[inst.data]);
                      return true;
                  }};
        copy_body(copy);
        module_.functions[f] = std::move(made);
    }

    Module& module_;
    std::vector<std::vector<Site>> sites_;
};

}  // namespace

Module settle_params(Module module) {
    Settler(module).run();
    return module;
}

}  // namespace patina::ir
