#include "compiler/exporters/mtlx/flatten.h"

#include <map>

#include "compiler/ir/rebuild.h"

namespace patina::exporters::mtlx {
namespace {

constexpr std::size_t kMost = 20'000;  // instructions

struct Flattening {
    lower::Lowered& lowered;
    bool is_too_long = false;

    // Values that loops carry, after their last rounds.
    std::map<std::pair<const ir::Copy*, std::uint32_t>, std::vector<ir::Value>> carried{};

    bool open(ir::Copy& copy, ir::Value value);
    bool write_out(ir::Copy& copy, ir::Value value);
    const ir::Function* body_of(const ir::Inst& inst) const;
};

// Of a call, or of a value that the graph interpolates; null: it stays.
const ir::Function* Flattening::body_of(const ir::Inst& inst) const {
    if (inst.op == ir::Op::Semantic) {
        const lower::SemanticRecipe& semantic = lowered.semantics[inst.data];
        return semantic.recipe && !semantic.declaration ? &lowered.module[semantic.recipe] : nullptr;
    }
    if (inst.op != ir::Op::Call) return nullptr;
    const ir::Function& callee = lowered.module.functions[inst.data];
    const bool is_kept =
        ir::is_elsewhere(callee) || callee.name == kUnpackNormal || callee.name == kToWorld || has_node(callee.name);
    return is_kept ? nullptr : &callee;
}

// A document has no loops: the rounds one after the other. False: nobody knows how many there are.
bool Flattening::write_out(ir::Copy& copy, ir::Value value) {
    const ir::Inst& loop = copy.from[value];
    const auto args = copy.from.args(loop);
    const auto begin = copy.to.constant_of(copy.map[args[0].index]), end = copy.to.constant_of(copy.map[args[1].index]);
    if (loop.is_light_loop || loop.is_while || begin.empty() || end.empty()) return false;
    const double first = begin[0], last = end[0];
    std::vector<ir::Value> values;
    for (const ir::Value each : args.subspan(2)) values.push_back(copy.map[each.index]);
    const std::vector<ir::Value>& body = copy.from.blocks[loop.data].insts;
    const ir::Type type = copy.from[body[0]].type;
    for (double i = first; i < last && !is_too_long; ++i) {
        copy.map[body[0].index] = copy.to.constant(type, {i});
        copy.changed[body[0].index] = 1;
        for (std::size_t each = 0; each < values.size(); ++each) {
            copy.map[body[each + 1].index] = values[each];
            copy.changed[body[each + 1].index] = 1;
        }
        ir::copy_block(copy, loop.data);
        const auto yielded = ir::yielded(copy.from, loop.data);
        for (std::size_t each = 0; each < values.size(); ++each) values[each] = copy.map[yielded[each].index];
        is_too_long = is_too_long || copy.to.function().insts.size() > kMost;
    }
    carried[{&copy, value.index}] = std::move(values);
    return true;
}

// True if the instruction is replaced: a call by the body of what it calls, and a loop by its rounds.
bool Flattening::open(ir::Copy& copy, ir::Value value) {
    const ir::Inst& call = copy.from[value];
    if (call.op == ir::Op::For) return write_out(copy, value);
    if (call.op == ir::Op::Result) {
        const auto loop = carried.find({&copy, copy.from.args(call)[0].index});
        if (loop == carried.end()) return false;
        copy.map[value.index] = loop->second[call.data];
        return true;
    }
    const ir::Function* const body = body_of(call);
    is_too_long = is_too_long || copy.to.function().insts.size() > kMost;
    if (!body || is_too_long) return false;
    std::vector<ir::Value> given;
    for (const ir::Value each : copy.from.args(call)) given.push_back(copy.map[each.index]);
    ir::Value result;
    ir::Copy inner{.from = *body, .to = copy.to, .origin = call.origin ? call.origin : copy.origin};
    inner.map.resize(body->insts.size());
    inner.changed.resize(body->insts.size());
    inner.rewrite = [&](ir::Copy& own, ir::Value each) {
        const ir::Inst& inst = (*body)[each];
        if (inst.op == ir::Op::Param) {
            own.map[each.index] = given[inst.data];
        } else if (inst.op == ir::Op::Return) {
            if (inst.operand_count > 0) result = own.map[body->args(inst)[0].index];
        } else {
            return open(own, each);
        }
        return true;
    };
    ir::copy_block(inner, 0);
    if (call.name) copy.to.name(result, call.name);
    copy.map[value.index] = result;
    return true;
}

}  // namespace

std::optional<ir::Function> flatten(lower::Lowered& lowered, const ir::Function& function) {
    ir::Function made = ir::shell(function);
    Flattening flattening{lowered};
    ir::Builder builder(lowered.module, made);
    ir::Copy copy{.from = function, .to = builder, .rewrite = [&](ir::Copy& own, ir::Value each) {
                      return flattening.open(own, each);
                  }};
    ir::copy_body(copy);
    if (flattening.is_too_long) return std::nullopt;
    return made;
}

}  // namespace patina::exporters::mtlx
