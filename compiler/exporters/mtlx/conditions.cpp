// Choices. A node of MaterialX compares two numbers and chooses, so a condition is never a value of its own.
#include <algorithm>

#include "compiler/exporters/mtlx/node_writer.h"

namespace patina::exporters::mtlx {

Ref NodeWriter::choose(ir::Value condition, unsigned index, const Ref& yes, const Ref& no) {
    const ir::Inst& inst = function_[condition];
    const auto args = function_.args(condition);
    if (const auto numbers = constant(condition))
        return (*numbers)[std::min<std::size_t>(index, numbers->size() - 1)] != 0 ? yes : no;

    unsigned width = 1;
    bool is_color = false;
    for (const Ref* each : {&yes, &no}) {
        width = std::max(width, each->is_number() ? static_cast<unsigned>(each->numbers.size()) : width_of(each->type));
        is_color = is_color || each->is_color();
    }
    const std::string type = type_word(width, is_color);
    const auto compared = [&](std::string_view category, const Ref& a, const Ref& b, const Ref& in1, const Ref& in2) {
        return node(category, type,
                    {{.name = "value1", .value = a, .type = "float"},
                     {.name = "value2", .value = b, .type = "float"},
                     {.name = "in1", .value = in1, .type = type},
                     {.name = "in2", .value = in2, .type = type}});
    };
    const auto side = [&](std::size_t i) { return component(value(args[i]), index); };
    if (inst.op == ir::Op::Not) return choose(args[0], index, no, yes);
    if (inst.op == ir::Op::And) return choose(args[0], index, choose(args[1], index, yes, no), no);
    if (inst.op == ir::Op::Or) return choose(args[0], index, yes, choose(args[1], index, yes, no));
    if (inst.op == ir::Op::Any || inst.op == ir::Op::All) {
        const bool is_any = inst.op == ir::Op::Any;
        Ref made = is_any ? no : yes;
        for (unsigned i = function_[args[0]].type.width(); i-- > 0;)
            made = is_any ? choose(args[0], i, yes, made) : choose(args[0], i, made, no);
        return made;
    }
    if (inst.op == ir::Op::Select)
        return choose(args[0], index, choose(args[1], index, yes, no), choose(args[2], index, yes, no));
    if (inst.op == ir::Op::Result && function_[args[0]].op == ir::Op::If) {
        const ir::Inst& branch = function_[args[0]];
        const auto yielded = [&](std::uint32_t block) {
            return choose(function_.args(function_.blocks[block].insts.back())[inst.data], index, yes, no);
        };
        return choose(function_.args(args[0])[0], 0, yielded(branch.data), yielded(branch.data + 1));
    }
    if (inst.op == ir::Op::Convert) return compared("ifequal", side(0), {.numbers = {0}}, no, yes);
    if (args.size() == 2 && !function_[args[0]].type.is_bool()) {
        if (inst.op == ir::Op::Greater) return compared("ifgreater", side(0), side(1), yes, no);
        if (inst.op == ir::Op::GreaterEqual) return compared("ifgreatereq", side(0), side(1), yes, no);
        if (inst.op == ir::Op::Less) return compared("ifgreater", side(1), side(0), yes, no);
        if (inst.op == ir::Op::LessEqual) return compared("ifgreatereq", side(1), side(0), yes, no);
        if (inst.op == ir::Op::Equal) return compared("ifequal", side(0), side(1), yes, no);
        if (inst.op == ir::Op::NotEqual) return compared("ifequal", side(0), side(1), no, yes);
    }
    if (args.size() == 2 && (inst.op == ir::Op::Equal || inst.op == ir::Op::NotEqual)) {
        const bool is_equal = inst.op == ir::Op::Equal;
        const Ref &same = is_equal ? yes : no, &other = is_equal ? no : yes;
        return choose(args[0], index, choose(args[1], index, same, other), choose(args[1], index, other, same));
    }
    refuse(condition, "this condition");
    return no;
}

}  // namespace patina::exporters::mtlx
