#include "compiler/exporters/mtlx/flatten.h"

#include "compiler/ir/rebuild.h"

namespace patina::exporters::mtlx {
namespace {

constexpr std::size_t kMost = 20'000;  // instructions

struct Flattening {
    ir::Module& module;
    bool is_too_long = false;

    bool is_kept(const ir::Function& callee) const {
        return ir::is_elsewhere(callee) || callee.name == kUnpackNormal || callee.name == kToWorld;
    }
    bool open_call(ir::Copy& copy, ir::Value value);
};

// True if the instruction was a call that is opened.
bool Flattening::open_call(ir::Copy& copy, ir::Value value) {
    const ir::Inst& call = copy.from[value];
    if (call.op != ir::Op::Call) return false;
    const ir::Function& callee = module.functions[call.data];
    is_too_long = is_too_long || copy.to.function().insts.size() > kMost;
    if (is_kept(callee) || is_too_long) return false;
    std::vector<ir::Value> given;
    for (const ir::Value each : copy.from.args(call)) given.push_back(copy.map[each.index]);
    ir::Value result;
    ir::Copy inner{.from = callee, .to = copy.to, .origin = call.origin ? call.origin : copy.origin};
    inner.map.resize(callee.insts.size());
    inner.changed.resize(callee.insts.size());
    inner.rewrite = [&](ir::Copy& own, ir::Value each) {
        const ir::Inst& inst = callee[each];
        if (inst.op == ir::Op::Param) {
            own.map[each.index] = given[inst.data];
        } else if (inst.op == ir::Op::Return) {
            if (inst.operand_count > 0) result = own.map[callee.args(inst)[0].index];
        } else {
            return open_call(own, each);
        }
        return true;
    };
    ir::copy_block(inner, 0);
    if (call.name) copy.to.name(result, call.name);
    copy.map[value.index] = result;
    return true;
}

}  // namespace

std::optional<ir::Function> flatten(ir::Module& module, const ir::Function& function) {
    ir::Function made = ir::shell(function);
    Flattening flattening{module};
    ir::Builder builder(module, made);
    ir::Copy copy{.from = function, .to = builder, .rewrite = [&](ir::Copy& own, ir::Value each) {
                      return flattening.open_call(own, each);
                  }};
    ir::copy_body(copy);
    if (flattening.is_too_long) return std::nullopt;
    return made;
}

}  // namespace patina::exporters::mtlx
