#include <algorithm>
#include <optional>
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

    // The constant that every caller has as the argument.
    std::optional<std::vector<double>> constant_of(std::uint32_t f, std::uint32_t param) const {
        const auto numbers = [&](const Site& site) -> std::optional<std::vector<double>> {
            const Inst& inst = caller(site)[argument(site, param)];
            if (inst.op != Op::Constant) return {};
            const auto all = module_.numbers_of(module_.constants[inst.data]);
            return std::vector<double>(all.begin(), all.end());
        };
        const auto first = numbers(sites_[f].front());
        const bool is_same = first && at_all(f, [&](const Site& site) { return numbers(site) == first; });
        return is_same ? first : std::nullopt;
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
        std::vector<std::optional<std::vector<double>>> constants(count);
        std::vector<std::uint32_t> twins(count);
        bool changes = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            Param& param = module_.functions[f].params[i];
            constants[i] = constant_of(f, i);
            twins[i] = twin_of(f, i);
            changes = changes || constants[i] || twins[i] != i;
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
                      c.map[v.index] = constants[inst.data] ? c.to.constant(inst.type, *constants[inst.data])
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
