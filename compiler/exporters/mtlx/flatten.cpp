#include "compiler/exporters/mtlx/flatten.h"

#include "compiler/ir/rebuild.h"

namespace patina::exporters::mtlx {
namespace {

constexpr std::size_t kMost = 20'000;  // instructions

struct Flattening {
    lower::Lowered& lowered;
    bool is_too_long = false;

    bool open(ir::Copy& copy, ir::Value value);
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
        ir::is_elsewhere(callee) || callee.name == kUnpackNormal || callee.name == kToWorld || is_noise(callee.name);
    return is_kept ? nullptr : &callee;
}

// True if the instruction is replaced by the body of what it calls.
bool Flattening::open(ir::Copy& copy, ir::Value value) {
    const ir::Inst& call = copy.from[value];
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
