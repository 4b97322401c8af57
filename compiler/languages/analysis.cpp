#include "compiler/languages/analysis.h"

#include <algorithm>

#include "compiler/ir/hints.h"
#include "compiler/ir/passes/passes.h"

namespace patina::languages {

using namespace ir;

namespace {

constexpr unsigned kMaxDepth = 12;   // of operations in one expression
constexpr unsigned kMaxWidth = 96;   // columns of an expression, estimated
constexpr unsigned kNameWidth = 10;  // of a variable without a hint

// Lays out the order and the blocks, and finds the Result of each slot.
void lay_out(Analysis& a, BlockId block) {
    for (Value v : a.function.blocks[block.index].insts) {
        const Inst& inst = a[v];
        a.block[v.index] = block;
        a.position[v.index] = static_cast<std::uint32_t>(a.order.size());
        a.order.push_back(v);
        if (inst.op == Op::If || inst.op == Op::For) {
            a.results[v.index].resize(slot_count(a.function, v));
            const std::uint32_t blocks = inst.op == Op::If ? 2 : 1;
            for (std::uint32_t i = 0; i < blocks; ++i) {
                a.owner[inst.data + i] = v;
                lay_out(a, {inst.data + i});
            }
            a.end[v.index] = static_cast<std::uint32_t>(a.order.size()) - 1;
        }
        if (inst.op == Op::Result) {
            const Value structure = a.function.args(v)[0];
            Value& first = a.results[structure.index][inst.data];
            if (!first) {
                first = v;
                // The slot's variable is declared in the block of the If or For, wherever its value is first read.
                a.block[v.index] = a.block[structure.index];
                a.position[v.index] = a.end[structure.index];
            }
            a.same_as[v.index] = first;
        }
    }
}

// A struct that is made of all members of another struct, in order, is that struct.
Value source_of_copy(const Analysis& a, Value v) {
    const Inst& inst = a[v];
    if (inst.op != Op::Construct || inst.type.kind != Kind::Struct || a.args(v) == 0) return {};
    Value source;
    for (std::uint32_t i = 0; i < a.args(v); ++i) {
        const Value member = a.arg(v, i);
        if (a[member].op != Op::Extract || a[member].data != i) return {};
        const Value from = a.arg(member, 0);
        if (a[from].type != inst.type || (source && from != source)) return {};
        source = from;
    }
    return source;
}

void note_read(Analysis& a, Value read, Value reader, BlockId where, unsigned times) {
    unsigned& reads = a.reads[read.index];
    a.only_reader[read.index] = reads == 0 && times == 1 ? reader : Value{};
    reads = std::min(reads + times, 1000u);
    if (reads == times) a.read_block[read.index] = where;
    if (where != a.block[read.index]) a.read_elsewhere[read.index] = true;
}

void count_reads(Analysis& a) {
    for (auto it = a.order.rbegin(); it != a.order.rend(); ++it) {
        const Value v = *it;
        const Inst& inst = a[v];
        if (!a.is_live(v)) continue;
        if (inst.op == Op::Result) {
            a.reads[a.function.args(v)[0].index]++;
            continue;
        }
        const Value reader = a.only_reader[v.index];
        const bool is_output = a.is_entry && inst.op == Op::Construct && inst.type.kind == Kind::Struct && reader &&
                               a[reader].op == Op::Return;
        if (is_output) a.outputs = v;
        const bool is_free = a.is_free(v);
        for (std::uint32_t i = 0; i < a.args(v); ++i) {
            if (inst.op == Op::Yield && !a.is_slot_read(a.owner[a.block[v.index].index], i)) continue;
            const Value read = a.arg(v, i);
            const bool is_limit = inst.op == Op::For && i == 1;  // computed again in every iteration
            const BlockId where = is_limit ? BlockId{inst.data} : is_free ? a.read_block[v.index] : a.block[v.index];
            note_read(a, read, is_free ? Value{} : v, where, is_free ? a.reads[v.index] : 1);
            if (is_free && a.read_elsewhere[v.index]) a.read_elsewhere[read.index] = true;
        }
    }
}

// If a variable receives the value anyway, the value needs none of its own.
bool has_receiver(const Analysis& a, Value v) {
    const Value reader = a.only_reader[v.index];
    if (!reader) return false;
    const Op op = a[reader].op;
    return op == Op::Yield || (op == Op::For && a.arg(reader, 0) != v && a.arg(reader, 1) != v);
}

// True for the member of a struct that has the same name: the member says already what the value is.
bool is_named_by_member(const Analysis& a, Value v, Value reader) {
    if (a[reader].op != Op::Construct || a[reader].type.kind != Kind::Struct) return false;
    const std::vector<Member>& members = a.module.structs[a[reader].type.ref].members;
    for (std::uint32_t i = 0; i < a.args(reader); ++i) {
        if (a.arg(reader, i) == v) return members[i].name == hint_of(a.module, a[v].name).local;
    }
    return false;
}

// A foreign function whose call is statements.
bool is_statements(const Analysis& a, Value v) {
    return a[v].op == Op::Call && a.module.functions[a[v].data].spelling.find("{result}") != std::string::npos;
}

bool must_stand(const Analysis& a, Value v) {
    const Inst& inst = a[v];
    if (is_leaf(inst.op) || !a.is_read(v) || a.is_free(v) || v == a.outputs || a.is_test(v)) return false;
    const Value reader = a.only_reader[v.index];
    const bool is_returned = reader && a[reader].op == Op::Return && !a.is_entry;
    const bool is_built = inst.op == Op::Construct || inst.op == Op::Insert || inst.op == Op::Select;
    if (inst.op == Op::Insert || (is_built && is_aggregate(inst.type))) return true;
    if (inst.op == Op::TextureSize) return true;
    if (is_statements(a, v)) return true;
    if (a.reads[v.index] > 1 || a.read_elsewhere[v.index]) return true;
    if (has_receiver(a, v)) return false;
    if (a.has_name(v)) return !is_returned && !(reader && is_named_by_member(a, v, reader));
    if (is_aggregate(inst.type)) return inst.op == Op::Call && !is_returned;
    const bool is_texel = info(inst.op).rule == TypeRule::Texel;
    return (is_texel || has(inst.op, Traits::Derivative)) && !is_returned;
}

struct Cost {
    unsigned depth = 0, width = 0;
};

unsigned own_width(const Analysis& a, Value v) {
    const Inst& inst = a[v];
    if (inst.op == Op::Constant) return inst.type.is_matrix() ? 5 * inst.type.components() : 5;
    if (inst.op == Op::Call) return static_cast<unsigned>(a.module.functions[inst.data].name.size()) + 2 * a.args(v);
    if (inst.op == Op::Global) return static_cast<unsigned>(a.module.globals[inst.data].name.size());
    if (inst.op == Op::Extract) {
        const Type from = a[a.arg(v, 0)].type;
        return from.kind == Kind::Struct
                   ? 1 + static_cast<unsigned>(a.module.structs[from.ref].members[inst.data].name.size())
                   : 2;
    }
    if (inst.op == Op::Param) return static_cast<unsigned>(a.function.params[inst.data].name.size()) + 2;
    if (a.is_free(v) || has(inst.op, Traits::Effect)) return 2;
    const bool is_operator = inst.op >= Op::Add && inst.op <= Op::ShiftRight;
    return is_operator ? 3 : 6 + 2 * a.args(v);
}

// Measures expressions from the first value to the last, and moves operands of expressions that are too big to read
// into variables.
class Folding {
public:
    explicit Folding(Analysis& analysis) : a_(analysis), cost_(analysis.function.insts.size()) {}

    void run() {
        for (Value v : a_.order) {
            if (!a_.is_live(v)) continue;
            a_.stands[v.index] = a_.stands[v.index] || is_standing_by_nature(v) || must_stand(a_, v);
            if (info(a_[v].op).rule == TypeRule::Texel) {
                while (const Value branch = branch_within(v)) stand(branch);
            }
            measure(v);
            while (is_too_big(v)) {
                const Value biggest = biggest_operand(v);
                if (!biggest) break;
                stand(biggest);
                measure(v);
            }
        }
    }

private:
    // A choice, && or || that an expression would have in it. glslang joins texture and sampler before the coordinate
    // and makes blocks of a choice, and SPIR-V forbids to read what was joined in another block.
    Value branch_within(Value v) const {
        for (std::uint32_t i = 0; i < a_.args(v); ++i) {
            const Value operand = a_.arg(v, i);
            if (a_.stands[operand.index] || is_leaf(a_[operand].op)) continue;
            const Inst& inst = a_[operand];
            const bool is_choice = inst.op == Op::Select && a_[a_.arg(operand, 0)].type.is_scalar();
            const bool is_logic = (inst.op == Op::And || inst.op == Op::Or) && inst.type.is_scalar();
            if ((is_choice || is_logic) && can_stand(operand)) return operand;
            if (const Value inner = branch_within(operand)) return inner;
        }
        return {};
    }
    bool is_standing_by_nature(Value v) const {
        const Op op = a_[v].op;
        return op == Op::LoopIndex || op == Op::LoopCarried || op == Op::Result;
    }
    bool is_too_big(Value v) const {
        const Cost& c = cost_[v.index];
        return c.depth > kMaxDepth || (c.width > kMaxWidth && c.depth > 1);
    }
    Cost cost_as_operand(Value v) const {
        if (!a_.stands[v.index]) return cost_[v.index];
        const std::string_view name = a_.module.name_of(a_[v].name);
        return {0, name.empty() ? kNameWidth : static_cast<unsigned>(name.size())};
    }
    void measure(Value v) {
        Cost c{0, own_width(a_, v)};
        // The members of an aggregate and the values at the end of a block are separate statements.
        const Op op = a_[v].op;
        const bool is_list =
            op == Op::Yield || op == Op::For || v == a_.outputs || is_aggregate(a_[v].type) || is_statements(a_, v);
        for (std::uint32_t i = 0; i < a_.args(v); ++i) {
            if (op == Op::Result) break;
            const Cost operand = cost_as_operand(a_.arg(v, i));
            c.depth = std::max(c.depth, operand.depth + 1);
            c.width = is_list ? std::max(c.width, operand.width) : c.width + operand.width;
        }
        cost_[v.index] = c;
    }
    // A member or swizzle of a leaf or a variable is as readable as a variable, unless it is a long chain.
    bool is_access(Value v) const {
        for (int parts = 0; parts < 3 && a_.is_free(v) && a_.args(v) == 1 && !a_.stands[v.index]; ++parts)
            v = a_.arg(v, 0);
        return is_leaf(a_[v].op) || a_.stands[v.index];
    }
    bool can_stand(Value v) const { return !is_access(v) && !a_.stands[v.index] && v != a_.outputs && !a_.is_test(v); }
    Value biggest_operand(Value v) const {
        Value biggest;
        for (std::uint32_t i = 0; i < a_.args(v); ++i) {
            const Value operand = a_.arg(v, i);
            if (!can_stand(operand)) continue;
            const Cost &best = cost_[(biggest ? biggest : operand).index], &c = cost_[operand.index];
            const bool is_deep = cost_[v.index].depth > kMaxDepth;
            const bool is_bigger = is_deep ? c.depth > best.depth : c.width > best.width;
            if (!biggest || is_bigger) biggest = operand;
        }
        return biggest;
    }
    // If the value is a swizzle or member of an expression (`v.xy`), the expression gets the variable, and its parts
    // are read from that.
    void stand(Value v) {
        Value inner = v;
        std::vector<Value> chain;
        while (a_.is_free(inner) && can_stand(inner)) {
            chain.push_back(inner);
            inner = a_.arg(inner, 0);
        }
        if (!can_stand(inner)) inner = v;
        a_.stands[inner.index] = true;
        for (auto it = chain.rbegin(); it != chain.rend(); ++it) measure(*it);
    }

    Analysis& a_;
    std::vector<Cost> cost_;
};

void find_last_reads(Analysis& a) {
    for (auto it = a.order.rbegin(); it != a.order.rend(); ++it) {
        const Value v = *it;
        const Inst& inst = a[v];
        if (!a.is_live(v) || inst.op == Op::Result) continue;
        const std::uint32_t here = a.computed_at(v);
        for (std::uint32_t i = 0; i < a.args(v); ++i) {
            std::uint32_t& last = a.last_read[a.arg(v, i).index];
            last = std::max(last, inst.op == Op::For && i == 1 ? a.end[v.index] : here);
        }
    }
}

}  // namespace

bool Analysis::is_live(Value v) const {
    const Op op = function[v].op;
    if (op == Op::Return || op == Op::DiscardIf) return true;
    if (op == Op::Yield) return is_read(owner[block[v.index].index]);
    return is_read(v);
}

std::uint32_t Analysis::computed_at(Value v) const {
    const Op op = function[v].op;
    const bool is_statement = stands[v.index] || op == Op::If || op == Op::For || has(op, Traits::Effect);
    return is_statement ? position[v.index] : last_read[v.index];
}

bool Analysis::is_slot_read(Value structure, std::uint32_t slot) const {
    // The loop itself may read a carried value.
    if (function[structure].op == Op::For) return true;
    const Value result = results[structure.index][slot];
    return result && is_read(result);
}

bool Analysis::is_free(Value v) const {
    const Inst& inst = function[v];
    if (inst.op == Op::Extract) return !function[arg(v, 0)].type.is_matrix();
    if (inst.op == Op::Swizzle) return true;
    return is_splat(function, v) && !has_name(v);
}

Analysis analyse(const Module& module, const Function& function, bool is_entry) {
    const std::size_t n = function.insts.size();
    Analysis a{.module = module, .function = function, .is_entry = is_entry};
    a.position.resize(n);
    a.end.resize(n);
    a.block.resize(n);
    a.owner.resize(function.blocks.size());
    a.same_as.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) a.same_as[i] = {i};
    a.reads.resize(n);
    a.read_block.resize(n);
    a.read_elsewhere.resize(n);
    a.only_reader.resize(n);
    a.stands.resize(n);
    a.last_read.resize(n);
    a.results.resize(n);
    a.order.reserve(n);
    if (module.tests_keywords) a.tests = keyword_values(module, function);

    lay_out(a, {0});
    for (Value v : a.order) {
        if (const Value source = source_of_copy(a, v)) a.same_as[v.index] = source;
    }
    count_reads(a);
    Folding(a).run();
    find_last_reads(a);
    return a;
}

}  // namespace patina::languages
