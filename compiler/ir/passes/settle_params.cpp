#include <algorithm>
#include <string>
#include <vector>

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
            if (function.linkage == Linkage::Internal && !sites_[f].empty()) settle(f);
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

    // True if every caller has the same constant as the argument, or reads the same element of a uniform array.
    bool is_settled(std::uint32_t f, std::uint32_t param) const {
        const Site& first = sites_[f].front();
        const Value value = argument(first, param);
        const bool is_constant = caller(first)[value].op == Op::Constant;
        if (!is_constant && !is_element(caller(first), value)) return false;
        return at_all(f, [&](const Site& site) {
            return is_same_read(caller(first), value, caller(site), argument(site, param));
        });
    }
    // "ambientSH[2].xyz"
    bool is_element(const Function& function, Value value) const {
        const Inst& inst = function[value];
        if (inst.op != Op::Extract && inst.op != Op::Swizzle) return false;
        const Value whole = function.args(inst)[0];
        const Inst& from = function[whole];
        return (from.op == Op::Global && from.type.kind == Kind::Array) || is_element(function, whole);
    }
    bool is_same_read(const Function& a, Value x, const Function& b, Value y) const {
        const Inst &left = a[x], &right = b[y];
        if (left.op != right.op || left.type != right.type) return false;
        if (left.op == Op::Constant) {
            const auto one = module_.numbers_of(module_.constants[left.data]),
                       other = module_.numbers_of(module_.constants[right.data]);
            return std::equal(one.begin(), one.end(), other.begin(), other.end());
        }
        if (left.data != right.data) return false;
        return left.op == Op::Global || ((left.op == Op::Extract || left.op == Op::Swizzle) &&
                                         is_same_read(a, a.args(left)[0], b, b.args(right)[0]));
    }
    // The same in the function that is being made.
    Value read_again(Builder& to, const Function& from, Value value) const {
        const Inst& inst = from[value];
        if (inst.op == Op::Constant || inst.op == Op::Global) return to.emit(inst.op, inst.type, {}, inst.data);
        return to.emit(inst.op, inst.type, {read_again(to, from, from.args(inst)[0])}, inst.data);
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
        std::vector<bool> settled(count);
        std::vector<std::uint32_t> twins(count);
        bool changes = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            Param& param = module_.functions[f].params[i];
            settled[i] = is_settled(f, i);
            twins[i] = twin_of(f, i);
            changes = changes || settled[i] || twins[i] != i;
            const std::string name = param.is_semantic ? name_of(f, i) : std::string();
            if (!name.empty()) param.name = name;
        }
        if (!changes) return;
        const Function from = module_.functions[f];
        Function made = shell(from);
        Builder builder(module_, made);
        Copy copy{.from = from, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      const Inst& inst = c.from[v];
                      if (inst.op != Op::Param) return false;
                      const Site& site = sites_[f].front();
                      c.map[v.index] = settled[inst.data] ? read_again(c.to, caller(site), argument(site, inst.data))
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
