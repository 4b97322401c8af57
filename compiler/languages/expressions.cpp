#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/bits.h"
#include "compiler/languages/body.h"
#include "compiler/languages/literals.h"

namespace patina::languages {

using namespace ir;

namespace {

constexpr std::string_view kComponents = "xyzw";

// Appends an element to a list with commas.
void append(std::string& list, std::string_view element) {
    if (!list.empty()) list += ", ";
    list += element;
}

Text call_text(std::string_view function, std::string_view arguments) {
    std::string text;
    text.reserve(function.size() + arguments.size() + 2);
    text.append(function).append("(").append(arguments).append(")");
    return {std::move(text), Precedence::Postfix};
}

// The spelling of a foreign value may end in a swizzle ("v.vertex.xyz"), from which another swizzle takes components.
std::string without_swizzle(std::string text) {
    const std::size_t dot = text.rfind('.');
    if (dot != text.npos && kComponents.starts_with(std::string_view(text).substr(dot + 1)) && text.size() > dot + 1)
        text.resize(dot);
    return text;
}

bool is_identity(std::string_view letters, Type of) {
    return letters.size() == of.width() && letters == kComponents.substr(0, of.width());
}

}  // namespace

Text Body::expression(Value value) const {
    const Value v = plan_.resolve(value);
    const std::uint32_t variable = plan_.variable[v.index];
    return variable == Plan::kNone ? formula(v) : Text{names_[variable]};
}

Text Body::formula(Value v) const {
    const Spelling& spelling = (*writer_.language.spellings)[static_cast<std::size_t>(function_[v].op)];
    switch (spelling.form) {
        case Form::Prefix: return prefix(v, spelling);
        case Form::Infix: return infix(v, spelling);
        case Form::Function: return call(v, spelling);
        case Form::Shared: return shared(v);
        case Form::Own: return writer_.language.expression(*this, v);
        case Form::Statement: return {};
    }
    return {};
}

std::string Body::arguments(Value v, std::uint32_t from) const {
    std::string list;
    for (std::uint32_t i = from; i < args(v); ++i) append(list, argument(v, i));
    return list;
}

// --- operators and functions

// True for a vector whose expression shows that it repeats a scalar.
bool Body::repeats_scalar(Value v) const {
    const Inst& inst = function_[v];
    if (is_variable(v) || !inst.type.is_vector()) return false;
    if (is_splat(function_, v)) return true;
    if (inst.op != Op::Constant) return false;
    const auto numbers = module().numbers_of(module().constants[inst.data]);
    const auto bits = [](double number) { return bits_as<std::uint64_t>(number); };
    return std::all_of(numbers.begin(), numbers.end(), [&](double n) { return bits(n) == bits(numbers[0]); });
}

// The scalar that such a vector repeats.
Text Body::scalar_of(Value v) const {
    const Inst& inst = function_[v];
    if (inst.op != Op::Constant) return expression(arg(v, 0));
    const double number = module().numbers_of(module().constants[inst.data])[0];
    return literal(writer_.language, inst.type.scalar, number);
}

Text Body::operand(Value v, std::uint32_t i, bool as_scalar) const {
    const Value value = arg(v, i);
    return as_scalar && repeats_scalar(value) ? scalar_of(value) : expression(value);
}

Text Body::prefix(Value v, const Spelling& spelling) const {
    if (!spelling.of_vectors.empty() && function_[v].type.is_vector()) return call(v, spelling);
    std::string text = at_least(Precedence::Unary, expression(arg(v, 0)));
    if (text.starts_with(spelling.text)) text = "(" + text + ")";  // not --x
    return {std::string(spelling.text) + text, Precedence::Unary};
}

Text Body::infix(Value v, const Spelling& spelling) const {
    if (!spelling.of_vectors.empty() && function_[arg(v, 0)].type.is_vector()) return call(v, spelling);
    const bool right_may = (spelling.scalars & (kEither | kSecond)) != 0, left_may = (spelling.scalars & kEither) != 0;
    const bool right_is_scalar = right_may && repeats_scalar(arg(v, 1));
    Text left = operand(v, 0, left_may && !right_is_scalar), right = operand(v, 1, right_is_scalar);
    // Few readers know the precedence of bit operators and shifts, so they get parentheses: a ^ (b >> 16u).
    const bool is_of_bits = spelling.precedence >= Precedence::BitOr && spelling.precedence <= Precedence::BitAnd;
    if (is_of_bits || spelling.precedence == Precedence::Shift) {
        for (Text* side : {&left, &right}) {
            const bool is_operator = side->precedence < Precedence::Unary;
            if (is_operator && side->precedence != spelling.precedence) *side = {"(" + side->text + ")"};
        }
    }
    std::string text = at_least(spelling.precedence, std::move(left));

    std::string_view sign = spelling.text;
    // a + -1.0 is printed as a - 1.0, and a - -1.0 as a + 1.0, which is exact.
    const bool is_sum = sign == "+" || sign == "-";
    if (is_sum && right.precedence == Precedence::Unary && right.text.starts_with('-') &&
        right.text.find_first_of("0123456789") == 1) {
        sign = sign == "+" ? "-" : "+";
        right.text.erase(0, 1);
    }
    const std::string right_text = at_least(above(spelling.precedence), std::move(right));
    text.reserve(text.size() + sign.size() + right_text.size() + 2);
    return {text.append(" ").append(sign).append(" ").append(right_text), spelling.precedence};
}

Text Body::call(Value v, const Spelling& spelling) const {
    const Inst& inst = function_[v];
    std::vector<Value> operands(args(v));
    for (std::uint32_t i = 0; i < args(v); ++i) operands[i] = arg(v, i);
    const auto may_be_scalar = [&](std::size_t i) { return (spelling.scalars >> i & 1) != 0; };
    // min and max get the limit last, which is usual, and GLSL requires a scalar limit there.
    const auto is_limit = [&](Value operand) {
        return repeats_scalar(operand) || function_[operand].op == Op::Constant;
    };
    if (has(inst.op, Commutes) && may_be_scalar(1) && is_limit(operands[0]) && !is_limit(operands[1])) {
        std::swap(operands[0], operands[1]);
    }
    bool scalars = inst.type.is_vector();
    for (std::size_t i = 0; i < operands.size(); ++i) {
        if (may_be_scalar(i) && !repeats_scalar(operands[i])) scalars = false;
    }
    std::string list;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        append(list, scalars && may_be_scalar(i) ? scalar_of(operands[i]).text : expression(operands[i]).text);
    }
    const bool of_vectors = !spelling.of_vectors.empty() && function_[operands[0]].type.is_vector();
    return call_text(of_vectors ? spelling.of_vectors : spelling.text, list);
}

Text Body::ternary(Value v) const {
    const auto part = [&](std::uint32_t i) { return at_least(Precedence::LogicalOr, expression(arg(v, i))); };
    return {fmt::format("{} ? {} : {}", part(0), part(1), part(2)), Precedence::Ternary};
}

// --- leaves, composites, conversions, calls: the same in every language except for names

Text Body::shared(Value v) const {
    const Inst& inst = function_[v];
    const auto function_call = [&](std::string_view name) { return call_text(name, arguments(v)); };
    if (is_leaf(inst.op)) return leaf(v);
    if (inst.op == Op::Construct) return construct(v);
    if (inst.op == Op::Extract) return extract(v);
    if (inst.op == Op::Swizzle) return swizzle(v);
    if (inst.op == Op::Select) return ternary(v);
    if (inst.op == Op::Call) {
        const std::string& spelling = module().functions[inst.data].spelling;
        if (!spelling.empty()) return {spelled(v, spelling, {}), Precedence::Postfix};
        return function_call(writer_.functions[inst.data]);
    }
    const Value from = arg(v, 0);
    const Type old = function_[from].type;
    if (inst.op == Op::Convert) return old == inst.type ? expression(from) : function_call(writer_.type(inst.type));
    if (inst.op == Op::Bitcast) {
        const std::string_view name = writer_.language.bitcast(inst.type.scalar, old.scalar);
        return function_call(name.empty() ? writer_.type(inst.type) : std::string(name));
    }
    // Index
    const std::string index = argument(v, 1);
    if (old.is_matrix()) return row(from, index);
    return {fmt::format("{}[{}]", at_least(Precedence::Postfix, expression(from)), index), Precedence::Postfix};
}

// The call of a foreign function, with its arguments and the name of its result, if it has one.
std::string Body::spelled(Value v, std::string_view spelling, std::string_view result) const {
    std::string text;
    while (!spelling.empty()) {
        const std::size_t open = std::min(spelling.find('{'), spelling.size());
        text += spelling.substr(0, open);
        if (open == spelling.size()) break;
        const std::size_t close = std::min(spelling.find('}', open), spelling.size());
        const std::string_view what = spelling.substr(open + 1, close - open - 1);
        const auto index = static_cast<std::uint32_t>(what.empty() ? 0 : what[0] - '0');
        text += what == "result" ? std::string(result) : index < args(v) ? argument(v, index) : std::string();
        spelling.remove_prefix(std::min(close + 1, spelling.size()));
    }
    return text;
}

Text Body::leaf(Value v) const {
    const Inst& inst = function_[v];
    if (inst.op == Op::Constant) return constant(v);
    if (inst.op == Op::Param) return entry_ ? entry_->inputs[inst.data] : Text{params_[inst.data]};
    const std::string& name = writer_.globals[inst.data];
    if (writer_.language.read && module().globals[inst.data].in_block())
        return {writer_.language.read(writer_, {inst.data}, name), Precedence::Postfix};
    const bool is_stored_as_such = !module().globals[inst.data].in_block() || Writer::stored(inst.type) == inst.type;
    if (is_stored_as_such) return {name};
    return call_text(writer_.type(inst.type), name);
}

Text Body::constant(Value v) const {
    const Type type = function_[v].type;
    const auto numbers = module().numbers_of(module().constants[function_[v].data]);
    const auto number = [&](std::size_t i) { return literal(writer_.language, type.scalar, numbers[i]); };
    if (type.is_scalar()) return number(0);
    if (repeats_scalar(v)) return writer_.language.splat(type, scalar_of(v));
    std::string list;
    for (std::size_t i = 0; i < type.components(); ++i) {
        const bool by_columns = type.is_matrix() && writer_.language.matrices_by_columns;
        const std::size_t place = by_columns ? i % type.rows * type.cols + i / type.rows : i;
        append(list, number(place).text);
    }
    return call_text(writer_.type(type), list);
}

Text Body::construct(Value v) const {
    const Type type = function_[v].type;
    if (is_splat(function_, v)) return writer_.language.splat(type, expression(arg(v, 0)));
    if (type.is_matrix()) return matrix_of_rows(v);
    if (type.is_scalar() && args(v) == 1) return expression(arg(v, 0));
    return vector_of_parts(v);
}

// (v.x, v.y, s) becomes (v.xy, s).
Text Body::vector_of_parts(Value v) const {
    const Type type = function_[v].type;
    std::string list;
    for (std::uint32_t i = 0; i < args(v);) {
        const Value first = arg(v, i);
        const auto is_component = [&](Value part) {
            return function_[part].op == Op::Extract && !is_variable(part) && function_[arg(part, 0)].type.is_vector();
        };
        std::string letters;
        const Value from = is_component(first) ? arg(first, 0) : Value{};
        for (std::uint32_t next = i; from && next < args(v) && letters.size() < 4; ++next) {
            const Value part = arg(v, next);
            if (!is_component(part) || arg(part, 0) != from) break;
            letters += kComponents[function_[part].data];
        }
        if (letters.size() < 2) {
            append(list, expression(first).text);
            ++i;
            continue;
        }
        i += static_cast<std::uint32_t>(letters.size());
        const Text source = expression(from);
        const bool whole = is_identity(letters, function_[from].type);
        const Text run =
            whole ? source : Text{at_least(Precedence::Postfix, source) + "." + letters, Precedence::Postfix};
        if (letters.size() == type.width()) return run;
        append(list, run.text);
    }
    return call_text(writer_.type(type), list);
}

// "m[1].xyz" or "m[1]", of row 1.
bool Body::is_start_of_row(Value v, std::uint32_t row) const {
    const Inst& inst = function_[v];
    if (is_variable(v)) return false;
    if (inst.op == Op::Extract) return inst.data == row && function_[arg(v, 0)].type.is_matrix();
    if (inst.op != Op::Swizzle || function_[arg(v, 0)].op != Op::Extract) return false;
    for (unsigned i = 0; i < inst.type.width(); ++i)
        if ((inst.data >> (2 * i) & 3) != i) return false;
    return is_start_of_row(arg(v, 0), row);
}

Value Body::corner_of(Value v) const {
    if (function_[v].op != Op::Construct || !function_[v].type.is_matrix()) return {};
    Value matrix{};
    for (std::uint32_t row = 0; row < args(v); ++row) {
        Value part = arg(v, row);
        if (!is_start_of_row(part, row)) return {};
        if (function_[part].op == Op::Swizzle) part = arg(part, 0);
        if (row == 0) matrix = arg(part, 0);
        if (arg(part, 0) != matrix) return {};
    }
    return matrix;
}

Text Body::matrix_of_rows(Value v) const {
    const Type type = function_[v].type;
    if (!writer_.language.matrices_by_columns) {
        return call_text(writer_.type(type), arguments(v));
    }
    if (const Value matrix = corner_of(v)) return call_text(writer_.type(type), expression(matrix).text);
    const Type transposed = Type::matrix(type.scalar, type.cols, type.rows);
    return {fmt::format("transpose({}({}))", writer_.type(transposed), arguments(v)), Precedence::Postfix};
}

Text Body::row(Value matrix, const std::string& index) const {
    const Text text = expression(matrix);
    if (writer_.language.matrices_by_columns) {
        return {fmt::format("transpose({})[{}]", text.text, index), Precedence::Postfix};
    }
    return {fmt::format("{}[{}]", at_least(Precedence::Postfix, text), index), Precedence::Postfix};
}

std::string Body::part(Type type, std::uint32_t index) const {
    if (type.kind == Kind::Struct) return "." + writer_.members[type.ref][index];
    if (type.is_vector()) return {'.', kComponents[index]};
    return "[" + std::to_string(index) + "]";
}

Text Body::extract(Value v) const {
    const Value from = arg(v, 0);
    const Type type = function_[from].type;
    const std::uint32_t index = function_[v].data;
    if (type.is_matrix()) return row(from, fmt::format("{}", index));
    // An element of a matrix is read without making its row.
    const bool is_row =
        function_[from].op == Op::Extract && !is_variable(from) && function_[arg(from, 0)].type.is_matrix();
    if (is_row && writer_.language.matrices_by_columns) {
        const std::string matrix = at_least(Precedence::Postfix, expression(arg(from, 0)));
        return {fmt::format("{}[{}][{}]", matrix, index, function_[from].data), Precedence::Postfix};
    }
    Text source = expression(from);
    if (may_end_in_swizzle(from)) source.text = without_swizzle(std::move(source.text));
    return {at_least(Precedence::Postfix, source) + part(type, index), Precedence::Postfix};
}

// A value of the engine, or one that it stores in a wider vector.
bool Body::may_end_in_swizzle(Value v) const {
    if (function_[v].op != Op::Global || !function_[v].type.is_vector() || is_variable(v)) return false;
    const Global& global = module().globals[function_[v].data];
    const bool is_stored_wider =
        global.in_block() && !module().blocks[global.block].members[global.member].stored_as.empty();
    return global.is_foreign() || (writer_.language.read && is_stored_wider);
}

Text Body::swizzle(Value v) const {
    const Inst& inst = function_[v];
    const Value from = arg(v, 0);
    Text source = expression(from);
    const bool is_stripped = may_end_in_swizzle(from);
    if (is_stripped) source.text = without_swizzle(std::move(source.text));
    if (function_[from].type.is_scalar()) return writer_.language.splat(inst.type, source);
    std::string letters;
    for (unsigned i = 0; i < inst.type.width(); ++i) letters += kComponents[inst.data >> (2 * i) & 3];
    if (is_identity(letters, function_[from].type) && !is_stripped) return source;
    return {at_least(Precedence::Postfix, source) + "." + letters, Precedence::Postfix};
}

}  // namespace patina::languages
