#include "compiler/link/target_reads.h"

#include <algorithm>
#include <optional>

#include "compiler/ir/liveness.h"

namespace patina::link {
namespace {

using ir::Op;
using ir::Value;
using Globals = std::set<std::uint32_t>;

bool is_sample(Op op) {
    return op == Op::Sample || op == Op::SampleBias || op == Op::SampleLevel || op == Op::SampleGrad;
}

// The global that a value is: itself, or as a part that was put into a composite and taken out again.
std::optional<std::uint32_t> global_of(const ir::Function& function, Value value) {
    const ir::Inst& inst = function[value];
    if (inst.op == Op::Global) return inst.data;
    if (inst.op != Op::Extract) return {};
    const Value whole = function.args(inst)[0];
    if (function[whole].op != Op::Construct || inst.data >= function.args(whole).size()) return {};
    return global_of(function, function.args(whole)[inst.data]);
}

bool is_one_of(const ir::Function& function, Value value, const Globals& globals) {
    const std::optional<std::uint32_t> global = global_of(function, value);
    return global && globals.contains(*global);
}

// The value is one of the globals, or a composite that holds one.
bool holds_one_of(const ir::Function& function, Value value, const Globals& globals) {
    if (is_one_of(function, value, globals)) return true;
    if (function[value].op != Op::Construct) return false;
    const auto parts = function.args(value);
    return std::any_of(parts.begin(), parts.end(), [&](Value part) { return is_one_of(function, part, globals); });
}

template <class Predicate>
bool any_inst(const ir::Module& stage, Predicate predicate) {
    return std::any_of(stage.functions.begin(), stage.functions.end(), [&](const ir::Function& function) {
        return std::any_of(function.insts.begin(), function.insts.end(),
                           [&](const ir::Inst& inst) { return predicate(function, inst); });
    });
}

bool reads_any(const ir::Module& stage, const Globals& globals) {
    return any_inst(stage, [&](const ir::Function&, const ir::Inst& inst) {
        return inst.op == Op::Global && globals.contains(inst.data);
    });
}

// The stage asks for the size of a target, or for a texel by its number.
bool counts_texels(const ir::Module& stage, const Globals& globals) {
    return any_inst(stage, [&](const ir::Function& function, const ir::Inst& inst) {
        return (inst.op == Op::TextureSize || inst.op == Op::TexelLoad) &&
               is_one_of(function, function.args(inst)[0], globals);
    });
}

// Follows coordinates back to the semantic that they are, through the calls of one fragment stage.
class OwnPixel {
public:
    OwnPixel(const Linked& linked, const lower::LoweredPass& pass)
        : linked_(linked), pass_(pass), needed_(linked.functions.size()) {
        reach(pass.fragment);
    }

    bool is_everywhere() const {
        for (std::uint32_t i = 0; i < linked_.functions.size(); ++i) {
            if (needed_[i] && !is_in({i})) return false;
        }
        return true;
    }

private:
    // What the stage may call: more than it does, where a pass replaces a function or a recipe.
    void reach(ir::FunctionId function) {
        if (!function || needed_[function.index]) return;
        const ir::Function& body = linked_.functions[function.index];
        std::vector<ir::Inst>& needed = needed_[function.index].emplace();
        const ir::Liveness live = ir::live_in(body);
        for (std::size_t i = 0; i < body.insts.size(); ++i) {
            if (live.values[i]) needed.push_back(body.insts[i]);
        }
        if (const auto* other = pass_.replacement_of(function, ir::StageKind::Fragment)) reach(other->by);
        for (const ir::Inst& inst : needed) {
            if (inst.op == Op::Call) reach({inst.data});
        }
        for (const ir::SemanticId semantic : linked_.needs[function.index]) {
            if (const auto* given = pass_.recipe_of(semantic, ir::StageKind::Fragment)) reach(given->by);
            reach(linked_.lowered.semantics[semantic.index].recipe);
        }
    }

    // Every target that the function reads is read at the own pixel, and handed to nobody.
    bool is_in(ir::FunctionId id) const {
        const ir::Function& function = linked_.functions[id.index];
        const Globals& globals = linked_.lowered.picture_reads;
        for (const ir::Inst& inst : *needed_[id.index]) {
            const auto args = function.args(inst);
            if (is_sample(inst.op) && is_one_of(function, args[0], globals) && !is_own(id, args[2])) return false;
            const bool is_handed_on = inst.op == Op::Call && std::any_of(args.begin(), args.end(), [&](Value argument) {
                                          return holds_one_of(function, argument, globals);
                                      });
            if (is_handed_on) return false;
        }
        return true;
    }

    // The value is the place of the pixel itself.
    bool is_own(ir::FunctionId id, Value value) const {
        const ir::Function& function = linked_.functions[id.index];
        const ir::Inst& inst = function[value];
        if (inst.op != Op::Param) return false;
        const std::vector<ir::SemanticId>& needs = linked_.needs[id.index];
        const std::size_t plain = function.params.size() - needs.size();
        if (inst.data < plain) return is_own_in_calls(id, inst.data);
        const ir::SemanticId semantic = needs[inst.data - plain];
        return linked_.lowered.wraps.own_pixel == semantic && !pass_.recipe_of(semantic, ir::StageKind::Fragment);
    }

    bool is_own_in_calls(ir::FunctionId callee, std::uint32_t param) const {
        bool is_called = false;
        for (std::uint32_t i = 0; i < linked_.functions.size(); ++i) {
            if (!needed_[i]) continue;
            const ir::Function& caller = linked_.functions[i];
            for (const ir::Inst& inst : *needed_[i]) {
                if (inst.op != Op::Call || !calls(inst.data, callee)) continue;
                is_called = true;
                if (!is_own({i}, caller.args(inst)[param])) return false;
            }
        }
        return is_called;
    }

    bool calls(std::uint32_t named, ir::FunctionId callee) const {
        if (named == callee.index) return true;
        const auto* other = pass_.replacement_of({named}, ir::StageKind::Fragment);
        return other && other->by == callee;
    }

    const Linked& linked_;
    const lower::LoweredPass& pass_;
    // By function: the instructions that its result needs, if the stage may call it. Nodes that nothing reads are
    // among the others.
    std::vector<std::optional<std::vector<ir::Inst>>> needed_;
};

}  // namespace

void wrap_reads(ir::Function& function, const Globals& globals, ir::FunctionId wrap, ir::Type type) {
    for (std::size_t b = 0; b < function.blocks.size(); ++b) {
        std::vector<Value> insts;
        for (const Value value : function.blocks[b].insts) {
            const ir::Inst inst = function[value];
            if (is_sample(inst.op) && is_one_of(function, function.args(inst)[0], globals)) {
                const std::size_t coordinate = inst.first_operand + 2;
                ir::Inst call{};
                call.op = Op::Call;
                call.type = type;
                call.data = wrap.index;
                call.origin = inst.origin;
                call.first_operand = static_cast<std::uint32_t>(function.operands.size());
                call.operand_count = 1;
                function.operands.push_back(function.operands[coordinate]);
                function.insts.push_back(call);
                const Value place{static_cast<std::uint32_t>(function.insts.size() - 1)};
                function.operands[coordinate] = place;
                insts.push_back(place);
            }
            insts.push_back(value);
        }
        function.blocks[b].insts = std::move(insts);
    }
}

bool reads_elsewhere(const Linked& linked, const lower::LoweredPass& pass, const ir::Module& fragment,
                     const ir::Module& vertex) {
    const Globals& globals = linked.lowered.picture_reads;
    if (globals.empty()) return false;
    if (reads_any(vertex, globals)) return true;
    if (!reads_any(fragment, globals)) return false;
    return counts_texels(fragment, globals) || !OwnPixel(linked, pass).is_everywhere();
}

std::uint32_t unread_targets(const lower::LoweredPass& pass, std::span<const LinkedPass> passes) {
    const std::uint32_t most = pass.declaration->optional_targets;
    if (most == 0) return 0;
    std::set<std::string_view> read;
    for (const LinkedPass& each : passes) {
        for (const ir::Module* stage : {&each.fragment, &each.vertex}) {
            for (const ir::Function& function : stage->functions) {
                for (const ir::Inst& inst : function.insts) {
                    const auto target = each.lowered->reads.find(inst.data);
                    if (inst.op == Op::Global && target != each.lowered->reads.end()) read.insert(target->second);
                }
            }
        }
    }
    const std::vector<RenderTarget>& targets = pass.declaration->state.targets;
    std::uint32_t unread = 0;
    while (unread < most && !read.contains(targets[targets.size() - 1 - unread].name)) ++unread;
    return unread;
}

}  // namespace patina::link
