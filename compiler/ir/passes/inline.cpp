#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "compiler/ir/hints.h"
#include "compiler/ir/passes/dependence.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// The text of a function of so few operations is as easy to read where it is called.
constexpr std::uint32_t kSmall = 3;
// A function of the library with a single call may have more: its comment, signature and braces are longer than that.
// What a graph's author wrote has no comment, and stays. So does what other stages may call as well.
constexpr std::uint32_t kSmallOnce = 6;
// A struct of so few numbers, such as the coverage that a shadow reads of a surface, says no more than the numbers.
constexpr std::size_t kFewNumbers = 2;
// The lines of a function besides its body: a comment, the signature, braces and an empty line.
constexpr std::size_t kLinesAround = 5;
// How long a function may be that is inlined because its calls would repeat what costs much.
constexpr std::size_t kMostRepeated = 256;
// How many instructions may be copied in one module; then calls stay calls. Functions that are always inlined and call
// others twice would double the text at each level.
constexpr std::size_t kBudget = 1u << 18;
constexpr int kMaxDepth = 32;
// How deep blocks may be nested by inlining, because IR passes and printers walk them by recursion.
constexpr std::size_t kMaxNesting = 200;

bool holds_opaque(const Module& module, Type type, int depth = 0) {
    if (type.is_opaque()) return true;
    if (type.kind != Kind::Struct || depth > 8) return false;
    const std::vector<Member>& members = module.structs[type.ref].members;
    return std::any_of(members.begin(), members.end(),
                       [&](const Member& m) { return holds_opaque(module, m.type, depth + 1); });
}

// What the pass must know of a finished function to inline it.
struct Callee {
    bool always = false;
    std::size_t nesting = 0;
    std::vector<std::pair<std::uint64_t, bool>> verdicts;  // by settled parameters: does anything become hoistable
    std::unordered_map<std::uint32_t, NameId> locals;      // by hint in the callee: the hint where it is inlined
};

// How deep blocks are nested. The index of a block is higher than that of the block around it.
std::size_t nesting_of(const Function& function) {
    std::vector<std::size_t> depth(function.blocks.size());
    std::size_t deepest = 0;
    for (std::size_t block = 0; block < depth.size(); block++) {
        deepest = std::max(deepest, depth[block]);
        for (const Value value : function.blocks[block].insts) {
            const Inst& inst = function[value];
            if (inst.op == Op::If || inst.op == Op::For) depth[inst.data] = depth[block] + 1;
            if (inst.op == Op::If) depth[inst.data + 1] = depth[block] + 1;
        }
    }
    return deepest;
}

bool is_few_numbers(const Module& module, Type type) {
    if (type.kind != Kind::Struct) return false;
    const std::vector<Member>& members = module.structs[type.ref].members;
    return members.size() <= kFewNumbers &&
           std::all_of(members.begin(), members.end(), [](const Member& m) { return m.type.is_scalar(); });
}

// The values of a function that are the same in each call: those that it computes from globals and semantics alone.
std::vector<std::uint8_t> same_at_all_calls(const Function& function) {
    std::uint64_t semantics = 0;
    for (std::size_t i = 0; i < function.params.size() && i < kMaxSettledParams; i++) {
        if (function.params[i].is_semantic) semantics |= std::uint64_t{1} << i;
    }
    return settled(function, semantics, Globals::Settled);
}

// True if the calls of such a function make the text longer than copies of its body, which share all values that are
// the same in each call. Compilers find equal arithmetic in several calls, but they repeat samples and loops.
bool is_shorter_inlined(const Module& module, const Function& function, std::size_t calls) {
    if (calls <= 1) return true;
    const std::vector<std::uint8_t> same = same_at_all_calls(function);
    std::size_t own = 0;
    bool repeats_much = false;
    for (std::size_t i = 0; i < function.insts.size(); i++) {
        const Op op = function.insts[i].op;
        if (same[i] == 0)
            own += is_work(op) ? 1 : 0;
        else
            repeats_much = repeats_much || op == Op::Call || has(op, Derivative) || info(op).rule == TypeRule::Texel;
    }
    if (repeats_much && function.insts.size() <= kMostRepeated) return true;
    // A struct has a line for each member where it is declared, and one where it is put together.
    const std::size_t members =
        function.result.kind == Kind::Struct ? module.structs[function.result.ref].members.size() : 0;
    const std::size_t around = kLinesAround + (members > 0 ? 2 * members + 3 : 0);
    return (calls - 1) * own <= around + calls;
}

Callee describe(const Module& module, const Function& function, std::size_t calls) {
    const bool takes_opaque = std::any_of(function.params.begin(), function.params.end(),
                                          [&](const Param& p) { return holds_opaque(module, p.type); });
    const auto work = static_cast<std::size_t>(
        std::count_if(function.insts.begin(), function.insts.end(), [](const Inst& i) { return is_work(i.op); }));
    // To make a struct takes a line for each member. Stages that share the function should not repeat these.
    const bool is_shared = function.linkage == Linkage::Exported && function.result.kind == Kind::Struct;
    const bool is_once = calls == 1 && !function.comment.empty() && function.linkage == Linkage::Internal &&
                         !module.stage.shares_functions && !is_follower(module, function);
    const bool is_little = (work <= (is_once ? kSmallOnce : kSmall) && !is_shared) ||
                           (calls == 1 && is_few_numbers(module, function.result));
    const bool is_wanted = function.always_inline || takes_opaque || is_little ||
                           (function.inline_if_shorter && is_shorter_inlined(module, function, calls));
    return {.always = is_wanted && !ir::is_elsewhere(function),
            .nesting = nesting_of(function),
            .verdicts = {},
            .locals = {}};
}

bool has_settled_work(const Function& callee, std::uint64_t params) {
    const std::vector<std::uint8_t> now = settled(callee, params, Globals::Settled);
    for (std::size_t i = 0; i < callee.insts.size(); i++) {
        if (now[i] != 0 && is_work(callee.insts[i].op)) return true;
    }
    return false;
}

// Which values of the function that is being made change from light to light, while a light loop is open.
class LightRate {
public:
    void enter() { depth_++; }
    void leave() { depth_--; }
    bool in_loop() const { return depth_ > 0; }

    bool varies(const Function& function, Value value) {
        look_at_new(function);
        return varies_[value.index] != 0;
    }

    // Also called before a loop is entered, so that values before the loop do not vary.
    void look_at_new(const Function& function) {
        while (varies_.size() < function.insts.size()) {
            const Inst& inst = function.insts[varies_.size()];
            const auto args = function.args(inst);
            // Instructions are made in order, so operands are known; what a structure yields may depend on anything in
            // it.
            const bool by_itself = inst.op == Op::LoopIndex || inst.op == Op::LoopCarried || inst.op == Op::Result;
            const bool by_operand =
                std::any_of(args.begin(), args.end(), [&](Value v) { return varies_[v.index] != 0; });
            varies_.push_back((in_loop() && by_itself) || by_operand ? 1 : 0);
        }
    }

private:
    int depth_ = 0;
    std::vector<std::uint8_t> varies_;
};

class Inliner {
public:
    explicit Inliner(Module& module) : module_(module), old_(std::move(module.functions)) {
        module_.functions.clear();
        module_.functions.reserve(old_.size());
        calls_.resize(old_.size());
        for (const Function& function : old_) {
            for (const Inst& inst : function.insts) {
                if (inst.op == Op::Call) calls_[inst.data]++;
            }
        }
    }

    // Callees come first, so a body that is copied has its own calls decided already.
    void run() {
        for (Function& old : old_) {
            module_.functions.push_back(calls_something(old) ? inlined(old) : std::move(old));
            callees_.push_back(describe(module_, module_.functions.back(), calls_[callees_.size()]));
        }
    }

private:
    static bool calls_something(const Function& function) {
        return std::any_of(function.insts.begin(), function.insts.end(),
                           [](const Inst& inst) { return inst.op == Op::Call; });
    }

    Function inlined(Function& old) {
        Function made = take_shell(old);
        Builder builder(module_, made);
        light_ = {};
        Copy copy{.from = old, .to = builder, .rewrite = [&](Copy& c, Value v) { return rewrite(c, v, 0); }};
        copy_body(copy);
        old = {};  // its memory serves the next one
        return made;
    }

    bool rewrite(Copy& copy, Value value, int depth) {
        const Inst& inst = copy.from[value];
        if (inst.op == Op::For && inst.is_light_loop) {
            light_.look_at_new(copy.to.function());
            light_.enter();
            copy_plain(copy, value);
            light_.leave();
            return true;
        }
        if (inst.op != Op::Call || !wants_inlining(copy, inst) || depth >= kMaxDepth) return false;
        const std::size_t size = module_.functions[inst.data].insts.size();
        if (size > budget_ || copy.to.depth() + callees_[inst.data].nesting > kMaxNesting) return false;
        budget_ -= size;
        copy.map[value.index] = inline_call(copy, inst, depth);
        return true;
    }

    bool wants_inlining(Copy& copy, const Inst& call) {
        Callee& callee = callees_[call.data];
        if (callee.always) return true;
        if (!light_.in_loop()) return false;
        std::uint64_t steady = 0;
        const auto args = copy.from.args(call);
        for (std::size_t i = 0; i < args.size() && i < kMaxSettledParams; i++) {
            if (!light_.varies(copy.to.function(), copy.map[args[i].index])) steady |= std::uint64_t{1} << i;
        }
        for (const auto& [params, verdict] : callee.verdicts) {
            if (params == steady) return verdict;
        }
        callee.verdicts.emplace_back(steady, has_settled_work(module_.functions[call.data], steady));
        return callee.verdicts.back().second;
    }

    Value inline_call(Copy& outer, const Inst& call, int depth) {
        const Function& callee = module_.functions[call.data];
        const auto args = outer.from.args(call);
        const std::size_t before = outer.to.function().insts.size();
        Value result;
        Copy copy{.from = callee,
                  .to = outer.to,
                  .origin = call.origin ? call.origin : outer.origin,
                  .rewrite = [&](Copy& c, Value v) {
                      const Inst& inst = c.from[v];
                      if (inst.op == Op::Param) {
                          c.map[v.index] = outer.map[args[inst.data].index];
                          return true;
                      }
                      if (inst.op == Op::Return) {
                          if (inst.operand_count == 1) result = c.map[c.from.args(inst)[0].index];
                          return true;
                      }
                      return rewrite(c, v, depth + 1);
                  }};
        copy_body(copy);
        if (callee.inline_if_shorter) {
            move_nodes(outer.to, copy.origin, before);
        } else {
            name_locals(outer.to, call, before);
            name_result(outer.to, result, call, before);
        }
        return result;
    }

    // The nodes of a sub-graph get the path of the node that uses it here. The path distinguishes their names.
    void move_nodes(Builder& to, OriginId user, std::size_t before) {
        for (std::size_t i = before; i < to.function().insts.size(); i++) {
            OriginId& origin = to.function().insts[i].origin;
            if (origin) origin = moved(origin, user);
        }
    }

    OriginId moved(OriginId node, OriginId user) {
        Origin origin = module_.origins[node.index];
        if (!user || origin.function_path == 0) return node;
        if (origin.path_in_function().empty()) return user;
        OriginId& made = moved_[{node, user}];
        if (made) return made;
        const Origin& at = module_.origins[user.index];
        origin.id = fmt::format("{}/{}", at.id, origin.path_in_function());
        origin.function_path = at.function_path;
        module_.origins.push_back(std::move(origin));
        return made = {static_cast<std::uint32_t>(module_.origins.size() - 1)};
    }

    void name_locals(Builder& to, const Inst& call, std::size_t before) {
        Callee& callee = callees_[call.data];
        for (std::size_t i = before; i < to.function().insts.size(); i++) {
            const Value value{static_cast<std::uint32_t>(i)};
            const NameId name = to[value].name;
            if (!name) continue;
            NameId& local = callee.locals[name.index];
            if (!local) local = inlined_local(module_, module_.functions[call.data].name, name);
            to.rename(value, local);
        }
    }

    // The call's name replaces the callee's name of the result, because it tells the reader what the value is. If the
    // call has none, the callee's name says it. A struct is called after its type, and a texel is a texel, unless the
    // callee names them.
    void name_result(Builder& to, Value result, const Inst& call, std::size_t before) {
        if (!result) return;
        const bool is_made_here = result.index >= before;
        NameId name = call.name;
        const bool says_itself = to[result].type.kind == Kind::Struct || info(to[result].op).rule == TypeRule::Texel;
        if (!name && is_made_here && !says_itself)
            name = inlined_result(module_, module_.functions[call.data].name, to[result].name);
        if (!name) return;
        if (is_made_here)
            to.rename(result, name);
        else
            to.name(result, name);
    }

    Module& module_;
    std::vector<Function> old_;
    std::vector<std::size_t> calls_;  // of each function
    std::vector<Callee> callees_;
    std::map<std::pair<OriginId, OriginId>, OriginId> moved_;  // by node, and by the node that uses its sub-graph
    LightRate light_;
    std::size_t budget_ = kBudget;
};

}  // namespace

Module inline_calls(Module module) {
    Inliner(module).run();
    return module;
}

}  // namespace patina::ir
