#include <algorithm>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// By function: true if it reads neighbouring pixels, itself or in a function that it calls.
std::vector<bool> functions_with_derivatives(const Module& module) {
    std::vector<bool> found(module.functions.size());
    for (std::size_t f = 0; f < module.functions.size(); f++) {
        const std::vector<Inst>& insts = module.functions[f].insts;
        found[f] = std::any_of(insts.begin(), insts.end(), [&](const Inst& inst) {
            return has(inst.op, Derivative) || (inst.op == Op::Call && found[inst.data]);
        });
    }
    return found;
}

class Search {
public:
    Search(const Module& module, const Function& function)
        : function_(function), callees_(functions_with_derivatives(module)) {}

    bool needs_neighbours(Value value) const {
        const Inst& inst = function_[value];
        if (has(inst.op, Derivative)) return true;
        if (inst.op == Op::Call) return callees_[inst.data];
        if (inst.op == Op::If) return block_needs(inst.data) || block_needs(inst.data + 1);
        return inst.op == Op::For && block_needs(inst.data);
    }

private:
    bool block_needs(std::uint32_t block) const {
        const std::vector<Value>& insts = function_.blocks[block].insts;
        return std::any_of(insts.begin(), insts.end(), [&](Value v) { return needs_neighbours(v); });
    }

    const Function& function_;
    std::vector<bool> callees_;
};

}  // namespace

Module legalize_discard(Module module) {
    if (!module.stage.entry) return module;
    Function& entry = module[module.stage.entry];
    const std::vector<Value>& body = entry.blocks[0].insts;
    const Search search(module, entry);
    const auto end =
        std::find_if(body.rbegin(), body.rend(), [&](Value v) { return search.needs_neighbours(v); }).base();
    if (std::none_of(body.begin(), end, [&](Value v) { return entry[v].op == Op::DiscardIf; })) return module;
    const Value last = end[-1];
    Function old = std::move(entry);
    Function made = take_shell(old);
    Builder builder(module, made);
    std::vector<Value> waiting;
    bool is_past = false;
    Copy copy{.from = old, .to = builder, .rewrite = [&](Copy& c, Value v) {
                  if (c.from[v].op == Op::DiscardIf && !is_past) {
                      waiting.push_back(v);
                      return true;
                  }
                  if (v != last) return false;
                  copy_plain(c, v);
                  is_past = true;
                  for (const Value discard : waiting) copy_plain(c, discard);
                  return true;
              }};
    copy_body(copy);
    module[module.stage.entry] = std::move(made);
    return module;
}

}  // namespace patina::ir
