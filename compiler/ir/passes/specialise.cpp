#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "compiler/base/spelling.h"
#include "compiler/ir/passes/dependence.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// A call in a copy may need a further copy; at this depth it calls the general function instead.
constexpr int kMaxDepth = 32;
// All copies together may have as many instructions as the module, or this many if the module is smaller.
constexpr std::size_t kMinBudget = 4000;

// A constant argument: which parameter, and what.
struct Known {
    std::uint32_t param;
    Type type;
    std::vector<double> numbers;
    friend bool operator<(const Known& a, const Known& b) {
        if (a.param != b.param) return a.param < b.param;
        return a.numbers < b.numbers;
    }
};

struct Request {
    std::uint32_t callee;  // in the old module
    std::vector<Known> known;
    friend bool operator<(const Request& a, const Request& b) {
        return std::tie(a.callee, a.known) < std::tie(b.callee, b.known);
    }
};

// True if constants for these parameters decide a branch, a choice or a loop, or half of the work.
bool is_worth_it(const Function& callee, std::uint64_t params) {
    const std::vector<std::uint8_t> now = settled(callee, params, Globals::Vary);
    std::uint32_t work = 0, done = 0;
    for (std::size_t i = 0; i < callee.insts.size(); i++) {
        const Inst& inst = callee.insts[i];
        const auto args = callee.args(inst);
        const auto is_settled = [&](std::size_t k) { return now[args[k].index] != 0; };
        // A condition that is constant without any argument is decided in the general function as well.
        const auto is_news = [&](std::size_t k) { return is_settled(k) && callee[args[k]].op != Op::Constant; };
        if ((inst.op == Op::If || inst.op == Op::Select) && is_news(0)) return true;
        if (inst.op == Op::For && is_settled(0) && is_settled(1) && (is_news(0) || is_news(1))) return true;
        if (!is_work(inst.op)) continue;
        work++;
        done += now[i] != 0 ? 1 : 0;
    }
    return done > 0 && 2 * done >= work;
}

std::size_t work_of(const Function& function) {
    return static_cast<std::size_t>(
        std::count_if(function.insts.begin(), function.insts.end(), [](const Inst& inst) { return is_work(inst.op); }));
}

bool calls_something(const Function& function) {
    return std::any_of(function.insts.begin(), function.insts.end(), [](const Inst& i) { return i.op == Op::Call; });
}

class Specialiser {
public:
    explicit Specialiser(Module& module) : module_(module), old_(std::move(module.functions)), verdicts_(old_.size()) {
        module_.functions.clear();
        for (const Function& function : old_) budget_ += function.insts.size();
        budget_ = std::max(budget_, kMinBudget);
    }

    void run() {
        if (!may_specialise()) {
            module_.functions = std::move(old_);
            return;
        }
        for (std::uint32_t f = 0; f < old_.size(); f++) general_.push_back(build(f, {}, 0));
        if (module_.stage.entry) module_.stage.entry = general_[module_.stage.entry.index];
        name_versions();
    }

private:
    // In many stages no constant argument decides anything.
    bool may_specialise() {
        return std::any_of(old_.begin(), old_.end(), [&](const Function& function) {
            return std::any_of(function.insts.begin(), function.insts.end(), [&](const Inst& inst) {
                if (inst.op == Op::Call) return worth(constant_arguments(function, inst));
                return inst.op == Op::Extract &&
                       constant_member(old_, function[function.args(inst)[0]], inst.data) != nullptr;
            });
        });
    }

    Request constant_arguments(const Function& function, const Inst& call) const {
        Request request{.callee = call.data, .known = {}};
        const auto args = function.args(call);
        for (std::uint32_t i = 0; i < args.size() && i < kMaxSettledParams; i++) {
            const Inst& arg = function[args[i]];
            if (arg.op != Op::Constant) continue;
            const auto numbers = module_.numbers_of(module_.constants[arg.data]);
            request.known.push_back({i, arg.type, {numbers.begin(), numbers.end()}});
        }
        return request;
    }

    // The constant that a call always returns as this member; otherwise null.
    static const Inst* constant_member(const std::vector<Function>& functions, const Inst& call, std::uint32_t index) {
        if (call.op != Op::Call || call.type.kind != Kind::Struct || is_elsewhere(functions[call.data])) return nullptr;
        const Function& callee = functions[call.data];
        const Inst& whole = callee[callee.args(callee.blocks[0].insts.back())[0]];
        if (whole.op != Op::Construct) return nullptr;
        const Inst& member = callee[callee.args(whole)[index]];
        return member.op == Op::Constant ? &member : nullptr;
    }

    FunctionId build(std::uint32_t f, const std::vector<Known>& known, int depth) {
        const Function& old = old_[f];
        if (known.empty() && !calls_something(old)) return add(old);
        return add(copy_for(old, known, [&](Copy& copy, Value v) {
            const Inst& inst = copy.from[v];
            if (inst.op == Op::Call) return call(copy, v, depth);
            return inst.op == Op::Extract && extract(copy, v);
        }));
    }

    // The function for these arguments; `rewrite` may change more of it.
    Function copy_for(const Function& old, const std::vector<Known>& known,
                      const std::function<bool(Copy&, const Value&)>& rewrite) {
        Function made = shell(old);
        made.params.clear();
        std::vector<std::uint32_t> kept(old.params.size());  // new index of each parameter that stays
        for (std::uint32_t i = 0; i < old.params.size(); i++) {
            kept[i] = static_cast<std::uint32_t>(made.params.size());
            if (find(known, i) == nullptr) made.params.push_back(old.params[i]);
        }
        Builder builder(module_, made);
        Copy copy{.from = old, .to = builder, .rewrite = [&](Copy& c, Value v) {
                      const Inst& inst = c.from[v];
                      if (inst.op != Op::Param) return rewrite(c, v);
                      const Known* constant = find(known, inst.data);
                      c.map[v.index] =
                          constant ? c.to.constant(constant->type, constant->numbers) : c.to.param(kept[inst.data]);
                      return true;
                  }};
        copy_body(copy);
        return made;
    }

    FunctionId add(Function function) {
        module_.functions.push_back(std::move(function));
        return {static_cast<std::uint32_t>(module_.functions.size() - 1)};
    }

    static const Known* find(const std::vector<Known>& known, std::uint32_t param) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const Known& k) { return k.param == param; });
        return found == known.end() ? nullptr : &*found;
    }

    bool call(Copy& copy, Value value, int depth) {
        const Inst& inst = copy.from[value];
        std::vector<Value> args;
        for (const Value arg : copy.from.args(inst)) args.push_back(copy.map[arg.index]);
        Request request{.callee = inst.data, .known = {}};
        std::vector<Value> rest;
        for (std::uint32_t i = 0; i < args.size(); i++) {
            const auto numbers = copy.to.constant_of(args[i]);
            if (numbers.empty() || i >= kMaxSettledParams) {
                rest.push_back(args[i]);
            } else {
                request.known.push_back({i, copy.to.type(args[i]), {numbers.begin(), numbers.end()}});
            }
        }
        const FunctionId version = request.known.empty() ? FunctionId() : version_for(std::move(request), depth);
        copy.to.set_origin(inst.origin);
        const Value made = version ? result_of(copy.to, version, rest) : copy.to.call(general_[inst.data], args);
        copy.to.name(made, inst.name);
        copy.map[value.index] = made;
        return true;
    }

    bool extract(Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const Value whole = copy.map[copy.from.args(inst)[0].index];
        const Inst* constant = constant_member(module_.functions, copy.to[whole], inst.data);
        if (constant == nullptr) return false;
        copy.map[value.index] = copy.to.emit(Op::Constant, constant->type, {}, constant->data);
        return true;
    }

    // If a copy only returns a constant, the call becomes that constant.
    Value result_of(Builder& to, FunctionId version, std::span<const Value> args) {
        const Function& callee = module_[version];
        const Inst& end = callee[callee.blocks[0].insts.back()];
        if (end.operand_count == 1) {
            const Inst& value = callee[callee.args(end)[0]];
            if (value.op == Op::Constant) return to.emit(Op::Constant, value.type, {}, value.data);
        }
        return to.call(version, args);
    }

    FunctionId version_for(Request request, int depth) {
        if (!worth(request) || depth >= kMaxDepth) return {};
        const auto found = versions_.find(request);
        if (found != versions_.end()) return found->second;
        const std::size_t size = old_[request.callee].insts.size();
        if (size > budget_) return {};
        budget_ -= size;
        const FunctionId made = build(request.callee, request.known, depth + 1);
        versions_.emplace(std::move(request), made);
        return made;
    }

    bool worth(const Request& request) {
        if (request.known.empty() || old_[request.callee].always_inline || is_elsewhere(old_[request.callee]))
            return false;
        std::uint64_t params = 0;
        for (const Known& known : request.known) params |= std::uint64_t{1} << known.param;
        return decides(request.callee, params) || leaves_little(request);
    }

    bool decides(std::uint32_t callee, std::uint64_t params) {
        for (const auto& [mask, verdict] : verdicts_[callee]) {
            if (mask == params) return verdict;
        }
        verdicts_[callee].emplace_back(params, is_worth_it(old_[callee], params));
        return verdicts_[callee].back().second;
    }

    // True if these constants take away half of the work, as 0 and 1 do in a product. The copy is made to see it.
    bool leaves_little(const Request& request) {
        const auto is_neutral = [](const Known& known) {
            return std::all_of(known.numbers.begin(), known.numbers.end(), [](double n) { return n == 0 || n == 1; });
        };
        if (std::none_of(request.known.begin(), request.known.end(), is_neutral)) return false;
        const auto [found, is_new] = trials_.try_emplace(request, false);
        if (!is_new) return found->second;
        const Function& old = old_[request.callee];
        const Function made = copy_for(old, request.known, [](Copy&, Value) { return false; });
        found->second = 2 * work_of(made) <= work_of(old);
        return found->second;
    }

    // Versions of one function that are still called get different names: the first version keeps the function's name.
    void name_versions() {
        if (versions_.empty()) return;
        module_ = prune(std::move(module_));
        std::set<std::string> used;
        std::vector<Function*> clashing;
        // Other texts know the names of the functions that they call or define.
        for (const Function& function : module_.functions) {
            if (function.linkage != Linkage::Internal) used.insert(function.name);
        }
        for (Function& function : module_.functions) {
            if (function.linkage == Linkage::Internal && !used.insert(function.name).second)
                clashing.push_back(&function);
        }
        std::map<std::string, unsigned> last;
        for (Function* function : clashing) {
            unsigned& number = last.try_emplace(function->name, 1).first->second;
            std::string name;
            do {
                number++;
                name = numbered(function->name, number);
            } while (!used.insert(name).second);
            function->name = std::move(name);
        }
    }

    Module& module_;
    std::vector<Function> old_;
    std::vector<FunctionId> general_;  // by old index
    std::map<Request, FunctionId> versions_;
    std::map<Request, bool> trials_;
    std::vector<std::vector<std::pair<std::uint64_t, bool>>> verdicts_;
    std::size_t budget_ = 0;
};

}  // namespace

Module specialise(Module module) {
    Specialiser(module).run();
    return module;
}

}  // namespace patina::ir
