#include <algorithm>
#include <utility>

#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"

namespace patina::ir {
namespace {

// For each instruction of a function, the deepest loop on which it depends, as the number of loops around that loop's
// body; 0: none. The loops around one position are nested, so the number identifies the loop.
class Levels {
public:
    explicit Levels(const Function& function) : function_(function), levels_(function.insts.size()), loops_(levels_) {
        block(0, 0);
    }

    std::uint32_t of(Value value) const { return levels_[value.index]; }
    // The loop's own number.
    std::uint32_t of_loop(Value value) const { return loops_[value.index]; }

private:
    // The highest level of anything in the block; `loops` enclose it.
    std::uint32_t block(std::uint32_t index, std::uint32_t loops) {
        std::uint32_t highest = 0;
        for (const Value value : function_.blocks[index].insts) {
            levels_[value.index] = level(value, loops);
            highest = std::max(highest, levels_[value.index]);
        }
        return highest;
    }

    std::uint32_t level(Value value, std::uint32_t loops) {
        const Inst& inst = function_[value];
        if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) return loops;
        std::uint32_t highest = 0;
        for (const Value arg : function_.args(inst)) highest = std::max(highest, levels_[arg.index]);
        if (inst.op == Op::If) {
            highest = std::max(highest, block(inst.data, loops));
            highest = std::max(highest, block(inst.data + 1, loops));
        } else if (inst.op == Op::For) {
            loops_[value.index] = loops + 1;
            block(inst.data, loops + 1);
            highest = std::max(highest, highest_below(inst.data, loops + 1));
        }
        return highest;
    }

    // The deepest loop that the block depends on, other than the loop itself.
    std::uint32_t highest_below(std::uint32_t index, std::uint32_t loop) const {
        std::uint32_t highest = 0;
        for (const Value value : function_.blocks[index].insts) {
            const Inst& inst = function_[value];
            if (of(value) < loop) highest = std::max(highest, of(value));
            for (const Value arg : function_.args(inst)) {
                if (of(arg) < loop) highest = std::max(highest, of(arg));
            }
            if (inst.op == Op::If || inst.op == Op::For) highest = std::max(highest, highest_below(inst.data, loop));
            if (inst.op == Op::If) highest = std::max(highest, highest_below(inst.data + 1, loop));
        }
        return highest;
    }

    const Function& function_;
    std::vector<std::uint32_t> levels_;
    std::vector<std::uint32_t> loops_;
};

class Scheduler {
public:
    explicit Scheduler(const Function& from) : levels_(from), done_(from.insts.size()) {}

    bool rewrite(Copy& copy, Value value) {
        if (std::exchange(done_[value.index], 1) != 0) return true;
        if (copy.from[value].op != Op::For) return false;
        hoist(copy, copy.from[value].data, levels_.of_loop(value));
        copy_plain(copy, value);
        return true;
    }

private:
    // Emits, before the loop with this number, the instructions of its body that depend on outer loops only.
    void hoist(Copy& copy, std::uint32_t block, std::uint32_t loop) {
        for (const Value value : copy.from.blocks[block].insts) {
            const Inst& inst = copy.from[value];
            if (done_[value.index] != 0 || inst.op == Op::Yield) continue;
            if (levels_.of(value) < loop) {
                copy_inst(copy, value);
            } else if (inst.op == Op::If) {
                hoist(copy, inst.data, loop);
                hoist(copy, inst.data + 1, loop);
            } else if (inst.op == Op::For) {
                hoist(copy, inst.data, loop);
            }
        }
    }

    const Levels levels_;
    std::vector<std::uint8_t> done_;
};

bool has_loop(const Function& function) {
    return std::any_of(function.insts.begin(), function.insts.end(), [](const Inst& i) { return i.op == Op::For; });
}

}  // namespace

Module schedule(Module module) {
    std::vector<Function> old = std::move(module.functions);
    module.functions.clear();
    module.functions.reserve(old.size());
    for (Function& function : old) {
        if (!has_loop(function)) {
            module.functions.push_back(std::move(function));
            continue;
        }
        Function made = take_shell(function);
        Builder builder(module, made);
        Scheduler scheduler(function);
        Copy copy{
            .from = function, .to = builder, .rewrite = [&](Copy& c, Value v) { return scheduler.rewrite(c, v); }};
        copy_body(copy);
        module.functions.push_back(std::move(made));
        function = {};  // its memory serves the next one
    }
    return module;
}

}  // namespace patina::ir
