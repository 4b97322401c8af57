#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "compiler/base/spelling.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

struct Site {
    std::uint32_t function;
    Value call;
};

// What is needed of one function. All of it only grows.
struct Need {
    Liveness live;
    std::vector<std::uint8_t> params;
    std::vector<std::uint8_t> members;  // of the result struct
    bool is_called = false;
    bool whole_result = false;
    Value return_value;
    std::vector<Site> sites;
    std::vector<Value> owners;  // of LoopIndex and LoopCarried: the For
};

bool returns_struct(const Function& function) {
    return function.result.kind == Kind::Struct;
}

// The origin of one member of a struct value, through constructs and inserts: the member's own value, or the struct
// from which it must be extracted.
struct MemberSource {
    Value value;
    bool is_member = false;
};
MemberSource member_source(const Function& function, Value whole, std::uint32_t member) {
    while (function[whole].op == Op::Insert) {
        if (function[whole].data == member) return {function.args(whole)[1], true};
        whole = function.args(whole)[0];
    }
    if (function[whole].op == Op::Construct) return {function.args(whole)[member], true};
    return {whole, false};
}

// Finds the needed values, over all functions at once. A parameter that a callee reads makes arguments needed; a member
// that a caller takes makes a part of the callee's result needed. Each instruction is looked at once.
class Analysis {
public:
    explicit Analysis(const Module& module) : module_(module), needs_(module.functions.size()) {}

    std::vector<Need> run() {
        const std::vector<std::uint8_t> is_root = roots();
        for (std::uint32_t f = 0; f < is_root.size(); f++) {
            if (is_root[f] == 0) continue;
            call(f);
            need_result(f);
            // Functions that are called from outside keep their signature; only a stage's entry may lose inputs.
            const bool is_plain = !module_.stage.entry && module_.functions[f].linkage == Linkage::Internal;
            if (is_plain) std::fill(needs_[f].params.begin(), needs_[f].params.end(), 1);
        }
        while (!work_.empty()) {
            const Site next = work_.back();
            work_.pop_back();
            visit(next.function, next.call);
        }
        return std::move(needs_);
    }

private:
    // The entry; without an entry the exported functions; without these, the functions that nothing calls.
    std::vector<std::uint8_t> roots() const {
        std::vector<std::uint8_t> is_root(module_.functions.size(), 0);
        if (module_.stage.entry) {
            is_root[module_.stage.entry.index] = 1;
            return is_root;
        }
        for (std::size_t f = 0; f < is_root.size(); f++) {
            is_root[f] = module_.functions[f].linkage == Linkage::Exported ? 1 : 0;
        }
        if (std::count(is_root.begin(), is_root.end(), 1) > 0) return is_root;
        std::fill(is_root.begin(), is_root.end(), 1);
        for (const Function& function : module_.functions) {
            for (const Inst& inst : function.insts) {
                if (inst.op == Op::Call) is_root[inst.data] = 0;
            }
        }
        return is_root;
    }

    // Other texts call the function, so its result and its own parameters must stay.
    void need_signature(std::uint32_t f) {
        const std::vector<Param>& params = module_.functions[f].params;
        for (std::size_t i = 0; i < params.size(); i++) {
            if (!params[i].is_semantic) needs_[f].params[i] = 1;
        }
        need_result(f);
    }

    void need(std::uint32_t f, Value value) {
        std::uint8_t& live = needs_[f].live.values[value.index];
        if (live != 0) return;
        live = 1;
        work_.push_back({f, value});
    }

    // A value that is read as a whole.
    void need_all(std::uint32_t f, Value value) {
        need(f, value);
        const Inst& inst = module_.functions[f][value];
        if (inst.op == Op::Call) need_result(inst.data);
    }

    void need_member(std::uint32_t f, Value value, std::uint32_t member) {
        need(f, value);
        const Inst& inst = module_.functions[f][value];
        if (inst.op == Op::Call) need_result_member(inst.data, member);
    }

    // False if the condition is the constant false.
    bool discards(const Function& function, Value value) const {
        if (function[value].op != Op::DiscardIf) return false;
        const Inst& condition = function[function.args(value)[0]];
        return condition.op != Op::Constant || module_.numbers_of(module_.constants[condition.data])[0] != 0;
    }

    // The body of a rendering pass may discard, even if nothing reads its result.
    bool calls_discard(const Inst& inst) const {
        if (inst.op != Op::Call) return false;
        const Function& callee = module_.functions[inst.data];
        return std::any_of(callee.blocks[0].insts.begin(), callee.blocks[0].insts.end(),
                           [&](Value value) { return discards(callee, value); });
    }

    // The function runs at all.
    void call(std::uint32_t f) {
        Need& need = needs_[f];
        if (need.is_called) return;
        const Function& function = module_.functions[f];
        need.is_called = true;
        need.live.values.resize(function.insts.size());
        need.live.operands.resize(function.operands.size());
        need.params.resize(function.params.size());
        need.members.resize(part_count(module_, function.result));
        if (function.blocks.size() > 1) need.owners.resize(function.insts.size());
        for (std::uint32_t i = 0; i < function.insts.size(); i++) {
            if (function.insts[i].op != Op::For) continue;
            const std::vector<Value>& body = function.blocks[function.insts[i].data].insts;
            for (std::uint32_t k = 0; k + 1 < function.insts[i].operand_count; k++) need.owners[body[k].index] = {i};
        }
        for (const Value value : function.blocks[0].insts) {
            if (discards(function, value) || calls_discard(function[value])) need_all(f, value);
        }
        const Value end = function.blocks[0].insts.back();
        need.live.values[end.index] = 1;
        if (function[end].operand_count > 0) need.return_value = function.args(end)[0];
        if (function.linkage != Linkage::Internal) need_signature(f);
    }

    void need_result(std::uint32_t f) {
        call(f);
        if (std::exchange(needs_[f].whole_result, true) || !needs_[f].return_value) return;
        need_all(f, needs_[f].return_value);
    }

    void need_result_member(std::uint32_t f, std::uint32_t member) {
        call(f);
        if (!returns_struct(module_.functions[f])) return need_result(f);
        std::vector<std::uint8_t>& members = needs_[f].members;
        if (std::exchange(members[member], 1) != 0) return;
        // If all members are needed, the struct stays as it is.
        if (std::find(members.begin(), members.end(), 0) == members.end()) return need_result(f);
        const MemberSource source = member_source(module_.functions[f], needs_[f].return_value, member);
        if (source.is_member) {
            need_all(f, source.value);
        } else {
            need_member(f, source.value, member);
        }
    }

    void need_param(std::uint32_t f, std::uint32_t param) {
        if (std::exchange(needs_[f].params[param], 1) != 0) return;
        for (const Site site : needs_[f].sites) {
            need_all(site.function, module_.functions[site.function].args(site.call)[param]);
        }
    }

    void visit_call(std::uint32_t f, Value value) {
        const std::uint32_t callee = module_.functions[f][value].data;
        call(callee);
        needs_[callee].sites.push_back({f, value});
        const auto args = module_.functions[f].args(value);
        for (std::size_t i = 0; i < args.size(); i++) {
            if (needs_[callee].params[i] != 0) need_all(f, args[i]);
        }
    }

    void need_yielded(std::uint32_t f, std::uint32_t block, std::uint32_t index) {
        const Function& function = module_.functions[f];
        const Inst& yield = function[function.blocks[block].insts.back()];
        std::uint8_t& live = needs_[f].live.operands[yield.first_operand + index];
        if (std::exchange(live, 1) == 0) need_all(f, function.args(yield)[index]);
    }

    void need_carried(std::uint32_t f, const Inst& loop, std::uint32_t index) {
        const Function& function = module_.functions[f];
        need_all(f, function.args(loop)[index + 2]);
        need_yielded(f, loop.data, index);
    }

    void visit(std::uint32_t f, Value value) {
        const Function& function = module_.functions[f];
        const Inst& inst = function[value];
        const auto args = function.args(inst);
        if (inst.op == Op::Call) return visit_call(f, value);
        if (inst.op == Op::Param) return need_param(f, inst.data);
        if (inst.op == Op::Extract) return need_member(f, args[0], inst.data);
        if (inst.op == Op::LoopIndex) return need(f, needs_[f].owners[value.index]);
        if (inst.op == Op::LoopCarried) return need_carried(f, function[needs_[f].owners[value.index]], inst.data);
        if (inst.op == Op::Result) {
            need(f, args[0]);
            const Inst& structure = function[args[0]];
            if (structure.op == Op::For) return need_carried(f, structure, inst.data);
            need_yielded(f, structure.data, inst.data);
            return need_yielded(f, structure.data + 1, inst.data);
        }
        // A loop's initial values are needed by what is carried.
        const std::size_t count = inst.op == Op::For ? 2 : args.size();
        for (std::size_t i = 0; i < count; i++) need_all(f, args[i]);
        if (inst.is_while) need_carried(f, inst, inst.operand_count - 3);
    }

    const Module& module_;
    std::vector<Need> needs_;
    std::vector<Site> work_;
};

// How a function looks to its callers afterwards.
struct Signature {
    FunctionId id;
    std::vector<std::uint32_t> params;   // new index of each parameter that stays
    std::vector<std::uint32_t> members;  // of the result, if it loses any: those that stay
    bool is_as_before = false;
    bool is_narrowed() const { return !members.empty(); }
    // If one member is left, the function returns the member itself.
    bool is_bare() const { return members.size() == 1; }
};

class Rebuild {
public:
    explicit Rebuild(Module& module) : module_(module), old_(std::move(module.functions)) {
        module_.functions.clear();
        module_.functions.reserve(old_.size());
    }

    void run(const std::vector<Need>& needs) {
        signatures_.resize(old_.size());
        for (std::uint32_t f = 0; f < old_.size(); f++) {
            if (!needs[f].is_called) continue;
            if (is_needed_whole(old_[f], needs[f])) {
                keep(f);
            } else {
                function(f, needs[f]);
            }
        }
        if (module_.stage.entry) entry(needs[module_.stage.entry.index]);
    }

private:
    // True if nothing of the function goes, so that at most the indices of its callees change.
    bool is_needed_whole(const Function& function, const Need& need) const {
        const auto is_set = [](std::uint8_t needed) { return needed != 0; };
        return function.blocks.size() == 1 && (need.whole_result || !returns_struct(function)) &&
               std::all_of(need.params.begin(), need.params.end(), is_set) &&
               std::all_of(need.live.values.begin(), need.live.values.end(), is_set) &&
               std::all_of(function.insts.begin(), function.insts.end(),
                           [&](const Inst& i) { return i.op != Op::Call || signatures_[i.data].is_as_before; });
    }

    void keep(std::uint32_t f) {
        signatures_[f].id = {static_cast<std::uint32_t>(module_.functions.size())};
        signatures_[f].params.resize(old_[f].params.size());
        signatures_[f].is_as_before = true;
        std::iota(signatures_[f].params.begin(), signatures_[f].params.end(), 0u);
        renumber_calls(old_[f], [&](std::uint32_t callee) { return signatures_[callee].id.index; });
        module_.functions.push_back(std::move(old_[f]));
    }

    void function(std::uint32_t f, const Need& need) {
        Function& old = old_[f];
        Function made = take_shell(old);
        signatures_[f] = signature(need, made);
        const Signature& mine = signatures_[f];
        Builder builder(module_, made);
        Copy copy{.from = old, .to = builder, .live = &need.live, .rewrite = [&](Copy& c, Value v) {
                      return rewrite(c, v, mine);
                  }};
        copy_body(copy);
        module_.functions.push_back(std::move(made));
        old = {};  // its memory serves the next one
    }

    Signature signature(const Need& need, Function& made) {
        Signature signature{.id = {static_cast<std::uint32_t>(module_.functions.size())}, .params = {}, .members = {}};
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < made.params.size(); i++) {
            signature.params.push_back(kept);
            if (need.params[i] == 0) {
                leave_unsaid(made, made.params[i].name);
                continue;
            }
            if (kept != i) made.params[kept] = std::move(made.params[i]);
            kept++;
        }
        signature.is_as_before = kept == made.params.size();
        made.params.resize(kept);
        if (need.whole_result || !returns_struct(made)) return signature;
        for (std::uint32_t i = 0; i < need.members.size(); i++) {
            if (need.members[i] != 0) signature.members.push_back(i);
        }
        if (signature.members.size() == need.members.size()) signature.members.clear();
        if (!signature.is_narrowed()) return signature;
        signature.is_as_before = false;
        describe_rest(made, signature);
        made.result = narrowed(made.result, signature);
        return signature;
    }

    // A comment that speaks of a parameter which is gone would mislead, too.
    static void leave_unsaid(Function& made, const std::string& param) {
        if (made.comment.find(fmt::format("`{}`", param)) != std::string::npos) made.comment.clear();
    }

    // A comment about a removed member would mislead: the members that stay have texts of their own. A comment that
    // describes no member, but all of them together, stays while there are several.
    void describe_rest(Function& made, const Signature& signature) const {
        if (made.result_docs.empty()) return;
        const auto is_own = [&](const std::string& doc) { return doc == made.comment; };
        const bool is_of_all = std::none_of(made.result_docs.begin(), made.result_docs.end(), is_own) &&
                               made.comment.find('\n') == std::string::npos;
        const std::vector<Member>& members = module_.structs[made.result.ref].members;
        std::vector<std::string> docs;
        std::string comment;
        for (const std::uint32_t index : signature.members) {
            const std::string& doc = docs.emplace_back(made.result_docs[index]);
            if (doc.empty()) continue;
            if (!comment.empty()) comment += '\n';
            comment += signature.is_bare() ? sentence(doc) : members[index].name + ": " + doc;
        }
        const bool stays = is_of_all ? !signature.is_bare() : std::any_of(docs.begin(), docs.end(), is_own);
        if (!stays) made.comment = std::move(comment);
        made.result_docs = std::move(docs);
    }

    Type narrowed(Type type, const Signature& signature) {
        if (signature.is_bare()) return part_type(module_, type, signature.members[0]);
        const Struct& whole = module_.structs[type.ref];
        Struct part{.name = whole.name, .members = {}};
        for (const std::uint32_t member : signature.members) part.members.push_back(whole.members[member]);
        for (std::uint32_t i = 0; i < module_.structs.size(); i++) {
            if (is_same(module_.structs[i], part)) return Type::structure(i);
        }
        module_.structs.push_back(std::move(part));
        return Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
    }

    static bool is_same(const Struct& a, const Struct& b) {
        return a.name == b.name &&
               std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                          [](const Member& x, const Member& y) { return x.name == y.name && x.type == y.type; });
    }

    bool rewrite(Copy& copy, Value value, const Signature& mine) {
        const Inst& inst = copy.from[value];
        if (inst.op == Op::Param) {
            copy.map[value.index] = copy.to.param(mine.params[inst.data]);
            copy.changed[value.index] = 0;
            return true;
        }
        if (inst.op == Op::Call) return call(copy, value);
        if (inst.op == Op::Extract) return extract(copy, value);
        if (inst.op == Op::Return && mine.is_narrowed()) return narrowed_return(copy, value, mine);
        return false;
    }

    bool call(Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const Signature& callee = signatures_[inst.data];
        const auto args = copy.from.args(inst);
        std::vector<Value>& kept = copy.scratch;
        kept.clear();
        for (std::size_t i = 0; i < args.size(); i++) {
            const bool stays = callee.params[i] < (i + 1 < args.size() ? callee.params[i + 1] : param_count(callee));
            if (stays) kept.push_back(copy.map[args[i].index]);
        }
        copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
        const Value made = copy.to.call(callee.id, kept);
        copy.to.name(made, inst.name);
        copy.map[value.index] = made;
        copy.changed[value.index] = 0;
        return true;
    }

    std::uint32_t param_count(const Signature& callee) const {
        return static_cast<std::uint32_t>(module_[callee.id].params.size());
    }

    // A member of a call's result, which may have fewer of them now.
    Value member(Copy& copy, Value whole, std::uint32_t index) {
        const Value now = copy.map[whole.index];
        const Inst& inst = copy.from[whole];
        if (inst.op != Op::Call || !signatures_[inst.data].is_narrowed()) return copy.to.extract(now, index);
        const Signature& callee = signatures_[inst.data];
        if (callee.is_bare()) return now;
        const auto at = std::lower_bound(callee.members.begin(), callee.members.end(), index) - callee.members.begin();
        return copy.to.extract(now, static_cast<std::uint32_t>(at));
    }

    bool extract(Copy& copy, Value value) {
        const Inst& inst = copy.from[value];
        const Value whole = copy.from.args(inst)[0];
        if (copy.from[whole].op != Op::Call) return false;
        copy.to.set_origin(inst.origin ? inst.origin : copy.origin);
        const Value made = member(copy, whole, inst.data);
        copy.to.name(made, inst.name);
        // Only this member is left of the call, so the name of the whole result does not fit.
        if (inst.name && signatures_[copy.from[whole].data].is_bare()) copy.to.rename(made, inst.name);
        copy.map[value.index] = made;
        return true;
    }

    bool narrowed_return(Copy& copy, Value value, const Signature& mine) {
        const Value whole = copy.from.args(value)[0];
        copy.to.set_origin(copy.from[value].origin);
        std::vector<Value> parts;
        for (const std::uint32_t index : mine.members) {
            const MemberSource source = member_source(copy.from, whole, index);
            parts.push_back(source.is_member ? copy.map[source.value.index] : member(copy, source.value, index));
        }
        const Type result = copy.to.function().result;
        copy.to.ret(mine.is_bare() ? parts[0] : copy.to.construct(result, parts));
        return true;
    }

    void entry(const Need& need) {
        StageInterface& stage = module_.stage;
        stage.entry = signatures_[stage.entry.index].id;
        std::vector<StageVariable> inputs;
        for (std::size_t i = 0; i < stage.inputs.size(); i++) {
            if (need.params[i] != 0) inputs.push_back(std::move(stage.inputs[i]));
        }
        stage.inputs = std::move(inputs);
    }

    Module& module_;
    std::vector<Function> old_;
    std::vector<Signature> signatures_;
};

}  // namespace

Module prune(Module module) {
    const std::vector<Need> needs = Analysis(module).run();
    Rebuild(module).run(needs);
    return module;
}

}  // namespace patina::ir
