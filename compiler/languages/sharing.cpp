// Decides which values share a variable. A variable holds one value at a time. A value may take over another's variable
// if nothing reads the other value afterwards, or only members that the new value leaves unchanged.
#include <algorithm>

#include "compiler/ir/hints.h"
#include "compiler/languages/analysis.h"

namespace patina::languages {

using namespace ir;

namespace {

class Sharing {
public:
    Sharing(const Analysis& analysis, Plan& plan) : a_(analysis), plan_(plan) {
        joined_.reserve(16);
        plan_.variables.reserve(16);
    }

    void run() {
        for (Value v : a_.order) {
            if (!a_.is_live(v) || a_.same_as[v.index] != v) continue;
            const Op op = a_[v].op;
            if (op == Op::If) make_if_slots(v);
            if (op == Op::For) make_for_slots(v);
            if (op == Op::Yield) give_to_slots(v);
            if (!a_.stands[v.index]) continue;
            variable(v) = variable_for(v);
            plan_.variables[find(variable(v))].writes++;
        }
        for (std::uint32_t& id : plan_.variable) {
            if (id != Plan::kNone) id = find(id);
        }
        for (std::uint32_t& id : plan_.slots) {
            if (id != Plan::kNone) id = find(id);
        }
    }

private:
    std::uint32_t& variable(Value v) { return plan_.variable[v.index]; }
    std::uint32_t find(std::uint32_t id) const {
        while (joined_[id] != id) id = joined_[id];
        return id;
    }
    std::uint32_t make(Value like, NameId hint, BlockId block, Value result = {}) {
        const auto id = static_cast<std::uint32_t>(plan_.variables.size());
        plan_.variables.push_back(
            {.type = a_[like].type, .hint = hint, .like = like, .result = result, .block = block});
        joined_.push_back(id);
        return id;
    }
    void suggest(std::uint32_t id, NameId hint) {
        NameId& current = plan_.variables[find(id)].hint;
        if (!is_name(current)) current = hint;
    }

    bool is_name(NameId hint) const { return !a_.module.name_of(hint).empty(); }

    // True if a new value, made at `position` of `block`, may overwrite the variable of `old`.
    bool can_take_over(Value old, BlockId block, std::uint32_t position) {
        return is_changeable(old, block) && a_.last_read[old.index] <= position &&
               std::all_of(kept_.begin(), kept_.end(), [&](Value kept) {
                   return find(variable(kept)) != find(variable(old)) || a_.last_read[kept.index] <= position;
               });
    }
    bool is_changeable(Value old, BlockId block) const {
        return plan_.variable[old.index] != Plan::kNone && a_[old].op != Op::LoopIndex && a_.block[old.index] == block;
    }

    // `surface.alpha = 1;` True if the assignment changes no member that is read later of `old`, or of an earlier value
    // of its variable.
    bool can_change_member(Value old, Value insert) {
        if (!is_changeable(old, a_.block[insert.index])) return false;
        const auto is_untouched = [&](Value held) {
            return a_.last_read[held.index] <= a_.position[insert.index] || !reads_whole_or_member(held, insert);
        };
        return is_untouched(old) && std::all_of(kept_.begin(), kept_.end(), [&](Value kept) {
                   return find(variable(kept)) != find(variable(old)) || is_untouched(kept);
               });
    }
    // True if something after `insert` reads the member of `held` that it changes, or all of `held`.
    bool reads_whole_or_member(Value held, Value insert) const {
        return std::any_of(a_.order.begin() + a_.position[held.index], a_.order.end(), [&](Value reader) {
            if (!a_.is_live(reader) || a_[reader].op == Op::Result) return false;
            const bool is_other = a_[reader].op == Op::Extract && a_[reader].data != a_[insert].data;
            for (std::uint32_t i = 0; i < a_.args(reader); ++i) {
                const bool is_limit = a_[reader].op == Op::For && i == 1;
                const std::uint32_t at = is_limit ? a_.end[reader.index] : a_.computed_at(reader);
                if (a_.arg(reader, i) == held && !is_other && at > a_.position[insert.index]) return true;
            }
            return false;
        });
    }

    std::uint32_t variable_for(Value v) {
        const Inst& inst = a_[v];
        if (inst.op == Op::Result) return slot(a_.function.args(v)[0], inst.data);
        if (inst.op == Op::LoopCarried) return slot(a_.owner[a_.block[v.index].index], inst.data);
        const BlockId block = a_.block[v.index];
        if (inst.op == Op::Insert) {
            const Value old = a_.arg(v, 0);
            if (can_change_member(old, v)) {
                if (a_.last_read[old.index] > a_.position[v.index]) kept_.push_back(old);
                suggest(variable(old), inst.name);
                return variable(old);
            }
        } else if (!is_aggregate(inst.type) && a_.has_name(v)) {
            if (const Value old = same_name_read_by(v)) return variable(old);
        }
        return make(v, inst.name, block);
    }
    // `x = x * 2`: a variable of the author, for which each assignment makes a new value.
    Value same_name_read_by(Value v) {
        Value found;
        const auto local = [&](Value each) { return hint_of(a_.module, a_[each].name).local; };
        for_each_read(plan_, a_.function, v, [&](Value read) {
            const bool same = local(read) == local(v) && a_[read].type == a_[v].type;
            if (same && can_take_over(read, a_.block[v.index], a_.position[v.index])) found = read;
        });
        return found;
    }

    std::uint32_t& slot(Value structure, std::uint32_t index) {
        return plan_.slots[plan_.first_slot[structure.index] + index];
    }
    void open_slots(Value structure) {
        plan_.first_slot[structure.index] = static_cast<std::uint32_t>(plan_.slots.size());
        plan_.slots.resize(plan_.slots.size() + slot_count(a_.function, structure), Plan::kNone);
    }
    NameId result_name(Value structure, std::uint32_t index) const {
        const Value result = a_.results[structure.index][index];
        return result ? a_[result].name : NameId{};
    }
    Value yielded(BlockId block, std::uint32_t index) const {
        return a_.arg(a_.function.blocks[block.index].insts.back(), index);
    }

    // If the else block computes nothing, the variables start with its values. A value that nothing reads afterwards
    // passes its variable on: `if (wet) { albedo = albedo * 0.5; }`.
    void make_if_slots(Value v) {
        open_slots(v);
        const BlockId then_block{a_[v].data}, else_block{a_[v].data + 1};
        const bool is_plain = has_plain_else(plan_, a_.function, v);
        std::vector<std::uint32_t> taken;
        for (std::uint32_t i = 0; i < slot_count(a_.function, v); ++i) {
            if (!a_.is_slot_read(v, i)) continue;
            const Value otherwise = yielded(else_block, i), then = yielded(then_block, i);
            NameId name = result_name(v, i);
            if (!is_name(name)) name = a_[then].name;
            if (!is_name(name)) name = a_[otherwise].name;
            if (is_plain && can_take_over(otherwise, a_.block[v.index], a_.end[v.index])) {
                const std::uint32_t id = find(variable(otherwise));
                if (std::find(taken.begin(), taken.end(), id) == taken.end()) {
                    taken.push_back(id);
                    slot(v, i) = id;
                    suggest(id, name);
                    continue;
                }
            }
            slot(v, i) = make(is_leaf(a_[then].op) ? otherwise : then, name, a_.block[v.index], a_.results[v.index][i]);
        }
    }

    void make_for_slots(Value v) {
        open_slots(v);
        const BlockId body{a_[v].data};
        std::vector<NameId> names(slot_count(a_.function, v));
        for (Value inside : a_.function.blocks[body.index].insts) {
            if (a_[inside].op == Op::LoopCarried) names[a_[inside].data] = a_[inside].name;
        }
        std::vector<std::uint32_t> taken;
        for (std::uint32_t i = 0; i < names.size(); ++i) {
            const Value initial = a_.arg(v, 2 + i);
            for (NameId name : {result_name(v, i), a_[initial].name, a_[yielded(body, i)].name}) {
                if (!is_name(names[i])) names[i] = name;
            }
            if (can_take_over(initial, a_.block[v.index], a_.position[v.index])) {
                const std::uint32_t id = find(variable(initial));
                if (std::find(taken.begin(), taken.end(), id) == taken.end()) {
                    taken.push_back(id);
                    slot(v, i) = id;
                    suggest(id, names[i]);
                    continue;
                }
            }
            slot(v, i) = make(yielded(body, i), names[i], a_.block[v.index]);
        }
    }

    // A value that a branch computes only to yield it is written directly to the result's variable.
    void give_to_slots(Value yield) {
        const BlockId block = a_.block[yield.index];
        const Value structure = a_.owner[block.index];
        if (a_[structure].op == Op::For) return;
        for (std::uint32_t i = 0; i < a_.args(yield); ++i) {
            const Value v = a_.arg(yield, i);
            if (slot(structure, i) == Plan::kNone || variable(v) == Plan::kNone) continue;
            const std::uint32_t to = find(slot(structure, i)), from = find(variable(v));
            const bool is_fresh = plan_.variables[to].result == a_.results[structure.index][i];
            if (!is_fresh || to == from || plan_.variables[from].block != block) continue;
            if (a_[v].type.kind == Kind::Array || a_[v].op == Op::LoopIndex) continue;
            joined_[from] = to;
            plan_.variables[to].writes += plan_.variables[from].writes;
            suggest(to, plan_.variables[from].hint);
        }
    }

    const Analysis& a_;
    Plan& plan_;
    std::vector<std::uint32_t> joined_;  // union of variables, by index
    std::vector<Value> kept_;            // values whose members are read after others have changed
};

}  // namespace

void share_variables(const Analysis& analysis, Plan& plan) {
    Sharing(analysis, plan).run();
}

}  // namespace patina::languages
