#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/cancellation.h"
#include "compiler/base/spelling.h"
#include "compiler/languages/body.h"

namespace patina::languages {

using namespace ir;

namespace {

constexpr std::string_view kLoopIndices[] = {"i", "j", "k", "l"};

}  // namespace

Body::Body(Writer& writer, FunctionId id, const EntryPoint* entry)
    : writer_(writer), function_(writer.module[id]), entry_(entry), plan_(writer.plans.of(id)) {
    names_.resize(plan_.variables.size());
    find_member_names();
    commented_.resize(writer.module.origins.size());
}

std::string Body::signature() {
    if (entry_) return entry_->signature;
    std::vector<std::string> list;
    for (const Param& param : function_.params) {
        params_.push_back(writer_.names.declare(param.name));
        list.push_back(writer_.declaration(param.type, params_.back(), syntax().parameter));
    }
    const auto index = static_cast<std::size_t>(&function_ - writer_.module.functions.data());
    return syntax().signature(writer_.type(function_.result), writer_.functions[index], list);
}

void Body::print_declaration() {
    writer_.names.open();
    writer_.line(0, signature() + ";");
    writer_.names.close();
}

void Body::print() {
    writer_.names.open();
    if (entry_) {
        for (const std::string& name : entry_->names) writer_.names.declare(name);
    }
    writer_.line(0, signature(), function_.origin);
    writer_.line(0, "{");
    if (entry_ && !entry_->begin.empty()) {
        for (const std::string& line : entry_->begin) writer_.line(indent_, line);
        writer_.gap();
    }
    print_block({0});
    writer_.line(0, "}");
    writer_.names.close();
}

void Body::print_verbatim() {
    const auto index = static_cast<std::size_t>(&function_ - writer_.module.functions.data());
    const std::string& name = writer_.functions[index];
    std::string text;
    for (const ForeignCode::Part& part : function_.code.parts) {
        text += part.text;
        if (part.name != ForeignCode::kEnd)
            text += part.name == ForeignCode::kOwn ? name : writer_.helpers[index][part.name - 1];
    }
    writer_.verbatim(text, function_.origin);
    if (function_.result.kind != Kind::Struct) return;
    writer_.gap();
    writer_.names.open();
    writer_.line(0, signature(), function_.origin);
    writer_.line(0, "{");
    const std::string result = writer_.names.declare("result");
    std::string arguments;
    for (const std::string& param : params_) arguments += param + ", ";
    for (const std::string& member : writer_.members[function_.result.ref])
        arguments += fmt::format("{}.{}, ", result, member);
    arguments.resize(arguments.size() - 2);
    writer_.line(1, writer_.declaration(function_.result, result) + ";");
    writer_.line(1, fmt::format("{}({});", name, arguments));
    writer_.line(1, fmt::format("return {};", result));
    writer_.line(0, "}");
    writer_.names.close();
}

// --- variables

std::string Body::target(std::uint32_t id) {
    if (is_declared(id)) return names_[id];
    const Variable& variable = plan_.variables[id];
    const bool has_name = !writer_.module.name_of(variable.hint).empty();
    names_[id] = declare(variable.hint, has_name ? std::string() : name_without_hint(variable.like),
                         function_[variable.like].origin);
    return writer_.declaration(variable.type, names_[id]);
}

std::string Body::target(Value v) {
    return target(plan_.variable[v.index]);
}

// --- lines

// Prints a comment above the first statement of each node, and an empty line after a node's statements.
void Body::enter(OriginId origin) {
    const auto is_labelled = [&](OriginId id) { return id && !writer_.module.origins[id.index].label.empty(); };
    const auto is_node = [&](OriginId id) { return id && !writer_.module.origins[id.index].id.empty(); };
    if (origin != origin_ && (is_node(origin) || is_node(origin_)) && !at_block_start_) writer_.gap();
    if (is_labelled(origin) && !commented_[origin.index]) {
        commented_[origin.index] = true;
        const Origin& o = writer_.module.origins[origin.index];
        const std::string_view path = o.path_in_function();
        writer_.comment(indent_,
                        path.empty() ? o.label
                        : o.is_note  ? fmt::format("{}: {}", path, o.label)
                                     : fmt::format("{} \"{}\"", o.label, path),
                        origin);
    }
    origin_ = origin;
    at_block_start_ = false;
}

void Body::statement(Value v, std::string_view text) {
    enter(function_[v].origin);
    writer_.line(indent_, text, function_[v].origin);
}

void Body::assign(std::uint32_t variable, Value value, const Text& text, Value from) {
    statement(from, assignment(variable, value, text));
}

std::string Body::assignment(std::uint32_t variable, Value value, const Text& text) {
    const Op op = function_[value].op;
    const Spelling& spelling = (*writer_.language.spellings)[static_cast<std::size_t>(op)];
    const bool is_arithmetic = op == Op::Add || op == Op::Sub || op == Op::Mul || op == Op::Div;
    if (is_arithmetic && is_declared(variable)) {
        const std::string start = names_[variable] + " " + std::string(spelling.text) + " ";
        if (plan_.variable[arg(value, 0).index] == variable && text.text.starts_with(start)) {
            return fmt::format("{} {}= {};", names_[variable], spelling.text, operand(value, 1, true).text);
        }
    }
    std::string made = target(variable);
    made.reserve(made.size() + text.text.size() + 4);
    return made.append(" = ").append(text.text).append(";");
}

void Body::print_block(BlockId block) {
    for (Value v : function_.blocks[block.index].insts) {
        Cancellation::step();
        print_statement(v);
    }
}

void Body::print_statement(Value v) {
    if (!plan_.is_printed(function_, v)) return;
    const Op op = function_[v].op;
    if (op == Op::If) return print_if(v);
    if (op == Op::For) return print_for(v);
    if (op == Op::Return) return print_return(v);
    if (op == Op::DiscardIf) return statement(v, syntax().only_where(argument(v, 0), "discard;"));
    const bool is_bound_elsewhere = op == Op::LoopIndex || op == Op::LoopCarried || op == Op::Result || op == Op::Yield;
    if (!is_bound_elsewhere && is_variable(v)) print_assignment(v);
}

// --- assignments

void Body::print_assignment(Value v) {
    const Inst& inst = function_[v];
    if (writer_.language.statement(*this, v) || print_spelled(v)) return;
    if (inst.op == Op::Construct && inst.type.kind == Kind::Struct) return print_struct(v);
    if (inst.op == Op::Construct && inst.type.kind == Kind::Array) return print_array(v);
    if (inst.op == Op::Insert) return print_insert(v);
    if (inst.op == Op::Select && is_aggregate(inst.type)) return print_select(v);
    const Text text = formula(v);  // before the value's own name is declared
    assign(plan_.variable[v.index], v, text, v);
}

// Prints the call of a foreign function that consists of statements, one on each line; they declare its result.
bool Body::print_spelled(Value v) {
    if (function_[v].op != Op::Call) return false;
    const std::string& spelling = module().functions[function_[v].data].spelling;
    if (spelling.find("{result}") == spelling.npos) return false;
    const std::uint32_t id = plan_.variable[v.index];
    const bool is_new = !is_declared(id);
    if (is_new) target(id);
    const std::string result = is_new ? names_[id] : declare_helper(name_without_hint(v));
    const std::string text = spelled(v, spelling, result);
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find("; "), rest.size() - 1) + 1;
        statement(v, rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (!is_new) statement(v, fmt::format("{} = {};", names_[id], result));
    return true;
}

void Body::print_struct(Value v) {
    const std::uint32_t id = plan_.variable[v.index];
    if (!is_declared(id)) statement(v, target(v) + ";");
    for (std::uint32_t i = 0; i < args(v); ++i) {
        statement(v, names_[id] + part(function_[v].type, i) + " = " + argument(v, i) + ";");
    }
}

void Body::print_array(Value v) {
    const std::uint32_t id = plan_.variable[v.index];
    const Array& array = writer_.module.arrays[function_[v].type.ref];
    if (array.element.is_numeric() && !is_declared(id)) {
        bool is_constant = plan_.variables[id].writes == 1;
        for (std::uint32_t i = 0; i < args(v); ++i) is_constant &= function_[arg(v, i)].op == Op::Constant;
        const Language& language = writer_.language;
        const std::string value = language.array_value(writer_.type(array.element), array.count, arguments(v));
        const std::string qualifier = is_constant ? std::string(language.constant_array) + " " : "";
        return statement(v, fmt::format("{}{} = {};", qualifier, target(v), value));
    }
    if (!is_declared(id)) statement(v, target(v) + ";");
    for (std::uint32_t i = 0; i < args(v); ++i) {
        statement(v, fmt::format("{}[{}] = {};", names_[id], i, argument(v, i)));
    }
}

void Body::print_insert(Value v) {
    const std::uint32_t id = plan_.variable[v.index];
    const Value old = arg(v, 0);
    if (plan_.variable[old.index] != id) {
        const std::string text = argument(v, 0);
        statement(v, fmt::format("{} = {};", target(v), text));
    }
    statement(v, fmt::format("{}{} = {};", names_[id], part(function_[v].type, function_[v].data), argument(v, 1)));
}

// HLSL's ?: does not take structs.
void Body::print_select(Value v) {
    const std::string condition = argument(v, 0), if_true = argument(v, 1), if_false = argument(v, 2);
    statement(v, fmt::format("{} = {};", target(v), if_false));
    statement(v, syntax().only_where(condition, names_[plan_.variable[v.index]] + " = " + if_true + ";"));
}

// --- control flow

// Both sides are in one scope, so that their declarations have different names.
void Body::print_if_defined(Value v, const std::string& test) {
    for (std::uint32_t i = 0; i < slot_count(function_, v); ++i) {
        const std::uint32_t id = slot(v, i);
        if (id != Plan::kNone && !is_declared(id)) statement(v, target(id) + ";");
    }
    const auto side = [&](std::uint32_t block) {
        at_block_start_ = true;
        print_block({block});
        print_yields(function_.blocks[block].insts.back(), v);
        at_block_start_ = false;
    };
    writer_.line(0, syntax().only_if(test), function_[v].origin);
    side(function_[v].data);
    Value last = v;
    for (Value next = only_if_in_else(last); next; next = only_if_in_else(last)) {
        writer_.line(0, syntax().else_if(keyword_test(arg(next, 0))), function_[next].origin);
        side(function_[next].data);
        last = next;
    }
    if (!says_nothing({function_[last].data + 1}, last)) {
        writer_.line(0, syntax().otherwise, function_[last].origin);
        side(function_[last].data + 1);
    }
    writer_.line(0, syntax().end_guard, function_[v].origin);
}

// True if the block changes nothing: its values are those from before the branch.
bool Body::says_nothing(BlockId block, Value structure) const {
    const std::vector<Value>& insts = function_.blocks[block.index].insts;
    const Value yield = insts.back();
    for (std::uint32_t i = 0; i < args(yield); ++i) {
        if (slot(structure, i) != Plan::kNone && plan_.variable[arg(yield, i).index] != slot(structure, i))
            return false;
    }
    return std::none_of(insts.begin(), insts.end(), [&](Value v) {
        const Op op = function_[v].op;
        return plan_.is_printed(function_, v) && (op == Op::If || op == Op::For || is_variable(v));
    });
}

// The branch that is the whole else side of another one, if it can be tested and writes the same variables.
Value Body::only_if_in_else(Value v) const {
    Value only;
    const std::vector<Value>& insts = function_.blocks[function_[v].data + 1].insts;
    for (const Value inside : insts) {
        const Op op = function_[inside].op;
        if (!plan_.is_printed(function_, inside) || op == Op::Result || op == Op::Yield) continue;
        if (op != Op::If && !is_variable(inside)) continue;  // part of the expression that reads it
        if (op != Op::If || only) return {};
        only = inside;
    }
    if (!only || keyword_test(arg(only, 0)).empty()) return {};
    const Value yield = insts.back();
    for (std::uint32_t i = 0; i < args(yield); ++i) {
        if (slot(v, i) != Plan::kNone && plan_.variable[arg(yield, i).index] != slot(v, i)) return {};
    }
    return only;
}

void Body::print_if(Value v) {
    if (writer_.module.tests_keywords) {
        const std::string test = keyword_test(arg(v, 0));
        if (!test.empty()) return print_if_defined(v, test);
    }
    const BlockId then_block{function_[v].data}, else_block{function_[v].data + 1};
    const Value otherwise = function_.blocks[else_block.index].insts.back();
    const bool is_plain = has_plain_else(plan_, function_, v);
    const std::string condition = argument(v, 0);
    for (std::uint32_t i = 0; i < slot_count(function_, v); ++i) {
        const std::uint32_t id = slot(v, i);
        if (id == Plan::kNone) continue;
        if (is_plain && plan_.variable[arg(otherwise, i).index] != id) {
            const Text text = expression(arg(otherwise, i));
            assign(id, arg(otherwise, i), text, v);
        } else if (!is_plain && !is_declared(id)) {
            statement(v, target(id) + ";");
        }
    }
    statement(v, fmt::format("if ({}) {{", condition));
    print_branch(then_block, v);
    if (!is_plain) {
        writer_.line(indent_, "} else {", function_[v].origin);
        print_branch(else_block, v);
    }
    writer_.line(indent_, "}", function_[v].origin);
}

void Body::print_branch(BlockId block, Value structure) {
    writer_.names.open();
    ++indent_;
    at_block_start_ = true;
    print_block(block);
    print_yields(function_.blocks[block.index].insts.back(), structure);
    at_block_start_ = false;
    --indent_;
    writer_.names.close();
}

void Body::print_for(Value v) {
    const Inst& inst = function_[v];
    for (std::uint32_t i = 0; i < slot_count(function_, v); ++i) {
        const Value initial = arg(v, 2 + i);
        if (plan_.variable[initial.index] == slot(v, i)) continue;
        const Text text = expression(initial);
        assign(slot(v, i), initial, text, v);
    }
    const std::string begin = argument(v, 0);
    std::string end = at_least(above(Precedence::Relational), expression(arg(v, 1)));
    if (inst.is_while) end += fmt::format(" && {}", names_[slot(v, slot_count(function_, v) - 1)]);
    writer_.names.open();
    std::string index;
    const std::string fallback(kLoopIndices[std::min<std::size_t>(loops_, std::size(kLoopIndices) - 1)]);
    for (Value inside : function_.blocks[inst.data].insts) {
        if (function_[inside].op != Op::LoopIndex) continue;
        index = declare(function_[inside].name, fallback, inst.origin);
        if (is_variable(inside)) names_[plan_.variable[inside.index]] = index;
    }
    if (index.empty()) index = writer_.names.declare(fallback);
    enter(inst.origin);  // may print lines
    if (inst.is_light_loop) writer_.light_loops.push_back(writer_.next_line);
    statement(v, syntax().loop(writer_.type(function_[arg(v, 0)].type), index, begin, end));
    ++loops_;
    print_branch({inst.data}, v);
    --loops_;
    writer_.names.close();
    writer_.line(indent_, "}", inst.origin);
}

// All variables change at once: each is assigned when no other value reads it any more. A circle is broken by computing
// one value ahead.
void Body::print_yields(Value yield, Value structure) {
    struct Pending {
        std::uint32_t variable;
        Value value;
        std::string ready;  // the variable with the value that is computed ahead
    };
    std::vector<Pending> pending;
    for (std::uint32_t i = 0; i < args(yield); ++i) {
        const std::uint32_t id = slot(structure, i);
        const Value value = arg(yield, i);
        if (id != Plan::kNone && plan_.variable[value.index] != id) pending.push_back({id, value, {}});
    }
    const auto reads = [&](const Pending& p, std::uint32_t variable) {
        if (!p.ready.empty()) return false;
        if (is_variable(p.value)) return plan_.variable[p.value.index] == variable;
        bool found = false;
        for_each_read(plan_, function_, p.value, [&](Value v) { found |= plan_.variable[v.index] == variable; });
        return found;
    };
    const auto origin_of = [&](const Pending& p) { return is_leaf(function_[p.value].op) ? yield : p.value; };
    while (!pending.empty()) {
        const auto is_free = [&](const Pending& p) {
            return std::none_of(pending.begin(), pending.end(),
                                [&](const Pending& other) { return &other != &p && reads(other, p.variable); });
        };
        const auto next = std::find_if(pending.begin(), pending.end(), is_free);
        if (next == pending.end()) {
            const auto waiting =
                std::find_if(pending.begin(), pending.end(), [](const Pending& p) { return p.ready.empty(); });
            waiting->ready = writer_.names.declare(joined("next", names_[waiting->variable]));
            const std::string target = writer_.declaration(function_[waiting->value].type, waiting->ready);
            statement(origin_of(*waiting), fmt::format("{} = {};", target, expression(waiting->value).text));
            continue;
        }
        const Text text = next->ready.empty() ? expression(next->value) : Text{next->ready};
        assign(next->variable, next->value, text, origin_of(*next));
        pending.erase(next);
    }
}

void Body::print_return(Value v) {
    if (!entry_) {
        if (args(v) > 0) statement(v, fmt::format("return {};", argument(v, 0)));
        return;
    }
    const Value result = args(v) > 0 ? arg(v, 0) : Value{};
    if (!entry_->before_return.empty()) statement(v, entry_->before_return);
    for (std::uint32_t i = 0; result && i < entry_->outputs.size(); ++i) {
        const bool is_direct = result == plan_.outputs;
        const Value member = is_direct ? arg(result, i) : result;
        const std::string text =
            is_direct ? expression(member).text
                      : at_least(Precedence::Postfix, expression(result)) + part(function_[result].type, i);
        const std::string guard = i < entry_->guards.size() ? entry_->guards[i] : std::string();
        if (!guard.empty()) writer_.line(0, syntax().only_if(guard));
        statement(v, entry_->outputs[i] + (entry_->outputs[i] == "return" ? " " : " = ") + text + ";");
        if (!guard.empty()) writer_.line(0, syntax().end_guard);
    }
    for (const std::string& line : entry_->end) statement(v, line);
    if (!entry_->at_return.empty()) statement(v, entry_->at_return);
}

}  // namespace patina::languages
