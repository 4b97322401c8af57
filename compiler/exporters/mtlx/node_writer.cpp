#include "compiler/exporters/mtlx/node_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "compiler/exporters/mtlx/flatten.h"
#include "compiler/exporters/mtlx/smoothing.h"
#include "compiler/ir/hints.h"

namespace patina::exporters::mtlx {
namespace {

enum class Class { Vectors, Colors, Number, Scalar };
struct OpRow {
    ir::Op op;
    std::string_view category, inputs;
    Class what;
};
constexpr OpRow kOps[] = {
#define MTLX_OP(op, category, inputs, what) {ir::Op::op, category, inputs, Class::what},
#include "compiler/exporters/mtlx/ops.def"
#undef MTLX_OP
};

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        words.emplace_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

}  // namespace

bool Ref::is_all(double number) const {
    return is_number() && std::all_of(numbers.begin(), numbers.end(), [&](double each) { return each == number; });
}

std::string type_word(unsigned width, bool is_color) {
    if (width == 1) return "float";
    return fmt::format("{}{}", is_color && width > 2 ? "color" : "vector", width);
}

unsigned width_of(std::string_view type) {
    return type.empty() || type.back() < '2' || type.back() > '4' ? 1 : static_cast<unsigned>(type.back() - '0');
}

NodeWriter::NodeWriter(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered,
                       const ir::Function& function, std::string folder)
    : session_(session),
      material_(material),
      lowered_(lowered),
      module_(lowered.module),
      function_(function),
      folder_(std::move(folder)) {}

Span NodeWriter::span_of(ir::Value value) const {
    const ir::OriginId origin = function_[value].origin;
    const Span span = origin ? module_.origins[origin.index].span : Span{};
    return span ? span : reader_;
}

void NodeWriter::refuse(ir::Value value, std::string_view what) {
    const Span span = span_of(value);
    if (!reported_.insert(fmt::format("{} {}", span.begin, what)).second) return;
    session_.diagnostics.report(Code::NoCounterpart, span, what);
}

void NodeWriter::differs(Span span, std::string_view text) {
    if (!reported_.insert(fmt::format("{} {}", span.begin, text)).second) return;
    session_.diagnostics.report(Code::ExportDiffers, span, text);
}

std::optional<std::vector<double>> NodeWriter::constant(ir::Value value) const {
    const ir::Inst& inst = function_[value];
    if (inst.op == ir::Op::Constant) {
        const auto numbers = module_.numbers_of(module_.constants[inst.data]);
        return std::vector<double>(numbers.begin(), numbers.end());
    }
    if (inst.op == ir::Op::Global) {
        // The tiling of a texture, which a document does not have as a value of its own.
        for (const lower::PropertyGlobals& each : lowered_.property_globals)
            if (each.tiling && each.tiling.index == inst.data) return std::vector<double>{1, 1, 0, 0};
        return std::nullopt;
    }
    if (inst.op == ir::Op::Swizzle || (inst.op == ir::Op::Extract && inst.type.is_scalar())) {
        const auto whole = constant(function_.args(value)[0]);
        if (!whole) return std::nullopt;
        if (inst.op == ir::Op::Extract) return std::vector<double>{(*whole)[inst.data]};
        std::vector<double> made;
        for (unsigned i = 0; i < inst.type.width(); ++i) made.push_back((*whole)[(inst.data >> (2 * i)) & 3u]);
        return made;
    }
    if (inst.op != ir::Op::Construct || !inst.type.is_vector()) return std::nullopt;
    std::vector<double> made;
    for (const ir::Value each : function_.args(value)) {
        const auto part = constant(each);
        if (!part) return std::nullopt;
        made.insert(made.end(), part->begin(), part->end());
    }
    if (made.size() == 1) made.assign(inst.type.width(), made[0]);
    return made;
}

std::string_view NodeWriter::semantic(ir::Value value) const {
    const ir::Inst& inst = function_[value];
    return inst.op == ir::Op::Semantic ? std::string_view(module_.semantics[inst.data].name) : std::string_view();
}

std::string_view NodeWriter::callee(ir::Value value) const {
    const ir::Inst& inst = function_[value];
    return inst.op == ir::Op::Call ? std::string_view(module_.functions[inst.data].name) : std::string_view();
}

void NodeWriter::write_input(Element& element, const Argument& argument) {
    Element& input = element.children.emplace_back(Element{.category = "input"});
    input.add("name", argument.name).add("type", argument.type);
    if (!argument.colorspace.empty()) input.add("colorspace", argument.colorspace);
    const Ref& ref = argument.value;
    if (ref.kind == Ref::Kind::Node) {
        input.add("nodename", ref.name);
    } else if (ref.kind == Ref::Kind::Input) {
        input.add("interfacename", ref.name);
    } else {
        std::vector<double> numbers = ref.numbers;
        const unsigned width = width_of(argument.type);
        if (numbers.size() == 1) numbers.assign(width, numbers[0]);
        input.add("value", numbers_text(numbers));
    }
}

Ref NodeWriter::node(std::string_view category, std::string type, std::vector<Argument> arguments,
                     std::vector<std::pair<std::string, std::string>> words) {
    Element element{.category = std::string(category)};
    std::string key = fmt::format("{} {}", category, type);
    for (Argument& each : arguments) {
        each.value = as(each.value, each.type);
        write_input(element, each);
    }
    for (const auto& [name, value] : words) {
        const bool is_whole = name == "index";
        element.children.push_back(
            {"input", {{"name", name}, {"type", is_whole ? "integer" : "string"}, {"value", value}}});
    }
    for (const Element& each : element.children)
        for (const auto& [name, value] : each.attributes) key += fmt::format("\n{}={}", name, value);
    Ref& known = nodes_[key];
    if (!known.name.empty()) return known;
    // The author's name for the value, or the node that it comes from, or what reads it.
    std::string wanted(category);
    if (!wanted_.empty()) {
        wanted = wanted_;
    } else if (current_) {
        const ir::Inst& inst = function_[current_];
        const std::string_view hint = ir::hint_of(module_, inst.name).name;
        if (!hint.empty()) {
            wanted = hint;
        } else if (inst.origin && !module_.origins[inst.origin.index].id.empty()) {
            const std::string& id = module_.origins[inst.origin.index].id;
            wanted = fmt::format("{}_{}", id.substr(id.rfind('/') + 1), category);
        } else if (!reader_name_.empty()) {
            wanted = fmt::format("{}_{}", reader_name_, category);
        }
    }
    known = {.kind = Ref::Kind::Node, .name = names_.unique(wanted), .type = type};
    element.attributes = {{"name", known.name}, {"type", std::move(type)}};
    graph_.children.push_back(std::move(element));
    return known;
}

Ref NodeWriter::as(const Ref& ref, const std::string& type) {
    if (ref.is_number() || ref.type == type) return ref;
    const unsigned from = width_of(ref.type), to = width_of(type);
    // Only the kind changes, a float is spread, or the alpha is left out.
    const bool is_known = from == to || from == 1 || (from == 4 && to == 3);
    if (!is_known) return join(std::vector<Ref>(to, component(ref, 0)), type.starts_with("color"));
    if (from == 4 && to == 3 && ref.is_color() != type.starts_with("color"))
        return as(as(ref, type_word(3, ref.is_color())), type);
    wanted_ = fmt::format("{}_{}", ref.name, type);
    const Ref made = node("convert", type, {{.name = "in", .value = ref, .type = ref.type}});
    wanted_.clear();
    return made;
}

Ref NodeWriter::component(const Ref& ref, unsigned index) {
    if (ref.is_number()) return {.numbers = {ref.numbers[ref.numbers.size() == 1 ? 0 : index]}};
    if (ref.type == "float") return ref;
    if (const auto parts = joined_.find(ref.name); parts != joined_.end()) return parts->second[index];
    wanted_ = fmt::format("{}_{}", ref.name, (ref.is_color() ? "rgba" : "xyzw")[index]);
    const Ref made =
        node("extract", "float", {{.name = "in", .value = ref, .type = ref.type}}, {{"index", std::to_string(index)}});
    wanted_.clear();
    return made;
}

Ref NodeWriter::join(const std::vector<Ref>& parts, bool is_color) {
    if (std::all_of(parts.begin(), parts.end(), [](const Ref& each) { return each.is_number(); })) {
        Ref made;
        for (const Ref& each : parts) made.numbers.push_back(each.numbers[0]);
        return made;
    }
    std::vector<Argument> arguments;
    for (std::size_t i = 0; i < parts.size(); ++i)
        arguments.push_back({.name = fmt::format("in{}", i + 1), .value = parts[i], .type = "float"});
    const auto width = static_cast<unsigned>(parts.size());
    const Ref made = node(fmt::format("combine{}", width), type_word(width, is_color), std::move(arguments));
    joined_[made.name] = parts;
    return made;
}

Ref NodeWriter::combine(std::string_view category, const Ref& a, const Ref& b) {
    if (category == "multiply" && b.is_all(1)) return a;
    unsigned width = 1;
    bool is_color = false;
    for (const Ref* each : {&a, &b}) {
        width = std::max(width, each->is_number() ? static_cast<unsigned>(each->numbers.size()) : width_of(each->type));
        is_color = is_color || each->is_color();
    }
    const std::string type = type_word(width, is_color);
    const bool is_float = !b.is_number() && b.type == "float";
    return node(
        category, type,
        {{.name = "in1", .value = a, .type = type}, {.name = "in2", .value = b, .type = is_float ? "float" : type}});
}

Ref NodeWriter::one(std::string_view category, const Ref& in) {
    std::string type = in.is_number() ? type_word(static_cast<unsigned>(in.numbers.size())) : in.type;
    if ((category == "exp" || category == "sqrt" || category == "ln") && in.is_color())
        type = type_word(width_of(type));
    return node(category, type, {{.name = "in", .value = in, .type = type}});
}

Ref NodeWriter::truncated(const Ref& in) {
    return combine("multiply", one("sign", in), one("floor", one("absval", in)));
}

// Operations that one node computes.
std::optional<Ref> NodeWriter::arithmetic(ir::Value value) {
    const ir::Inst& inst = function_[value];
    const auto row =
        std::find_if(std::begin(kOps), std::end(kOps), [&](const OpRow& each) { return each.op == inst.op; });
    if (row == std::end(kOps)) return std::nullopt;
    std::vector<ir::Value> operands(function_.args(value).begin(), function_.args(value).end());
    if (inst.type.is_integer() && (inst.op == ir::Op::Div)) return std::nullopt;
    const auto is_spread = [&](ir::Value v) {
        return function_[v].op == ir::Op::Construct && function_.args(v).size() == 1 && !constant(v);
    };
    // A number that is spread stands second.
    if ((inst.op == ir::Op::Add || inst.op == ir::Op::Mul) && is_spread(operands[0]))
        std::swap(operands[0], operands[1]);
    std::vector<Ref> refs;
    bool is_color = false;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const bool stays = row->what == Class::Number && i > 0 && is_spread(operands[i]);
        refs.push_back(this->value(stays ? function_.args(operands[i])[0] : operands[i]));
        is_color = is_color || refs.back().is_color();
    }
    if (inst.op == ir::Op::Mul && refs[1].is_all(1)) return refs[0];
    if (inst.op == ir::Op::Add && refs[1].is_all(0)) return refs[0];
    if (inst.op == ir::Op::Dot || inst.op == ir::Op::Length || inst.op == ir::Op::Distance)
        if (function_[operands[0]].type.is_scalar()) return std::nullopt;
    current_ = value;
    const unsigned width = function_[operands[0]].type.width();
    const bool takes_colors = row->what == Class::Colors || row->what == Class::Number;
    const std::string type = type_word(width, is_color && takes_colors);
    std::vector<Argument> arguments;
    const std::vector<std::string> names = words_of(row->inputs);
    for (std::size_t i = 0; i < refs.size(); ++i) {
        const bool is_float = row->what == Class::Number && i > 0 && refs[i].type == "float";
        arguments.push_back({.name = names[i], .value = refs[i], .type = is_float ? "float" : type});
    }
    return node(row->category, row->what == Class::Scalar ? "float" : type, std::move(arguments));
}

// Operations that need several nodes.
std::optional<Ref> NodeWriter::composed(ir::Value value) {
    const ir::Inst& inst = function_[value];
    const auto args = function_.args(value);
    const auto arg = [&](std::size_t i) { return this->value(args[i]); };
    const auto number = [](double each) { return Ref{.numbers = {each}}; };
    const auto wide = [&](double each) { return Ref{.numbers = std::vector<double>(inst.type.width(), each)}; };
    const auto one = [&](std::string_view category, const Ref& in) { return this->one(category, in); };
    if (inst.op == ir::Op::Neg) return combine("multiply", arg(0), number(-1));
    if (inst.op == ir::Op::Trunc) return truncated(arg(0));
    if (inst.op == ir::Op::Mod) {
        const Ref a = arg(0), b = arg(1);
        return combine("subtract", a, combine("multiply", b, truncated(combine("divide", a, b))));
    }
    if (inst.op == ir::Op::BitAnd && inst.type.scalar == ir::Scalar::Int) {
        // The low bits are a remainder.
        auto mask = constant(args[1]);
        const bool is_low = mask && std::all_of(mask->begin(), mask->end(), [](double each) {
                                return each > 0 && std::exp2(std::floor(std::log2(each + 1))) == each + 1;
                            });
        if (!is_low) return std::nullopt;
        for (double& each : *mask) each += 1;
        return combine("modulo", arg(0), {.numbers = *mask});
    }
    if (inst.op == ir::Op::Div) return truncated(combine("divide", arg(0), arg(1)));  // of integers
    if (inst.op == ir::Op::Rsqrt) return combine("divide", wide(1), one("sqrt", arg(0)));
    if (inst.op == ir::Op::Exp2) return one("exp", combine("multiply", arg(0), number(std::numbers::ln2)));
    if (inst.op == ir::Op::Log2) return combine("multiply", one("ln", arg(0)), number(1 / std::numbers::ln2));
    if (inst.op == ir::Op::Atan) {
        const Ref in = arg(0);
        const std::string type = type_word(inst.type.width());
        return node("atan2", type,
                    {{.name = "iny", .value = in, .type = type}, {.name = "inx", .value = number(1), .type = type}});
    }
    if (inst.op == ir::Op::Radians) return combine("multiply", arg(0), number(std::numbers::pi / 180));
    if (inst.op == ir::Op::Degrees) return combine("multiply", arg(0), number(180 / std::numbers::pi));
    if (inst.op == ir::Op::Tanh) {
        // 1 - 2 / (e^2x + 1)
        const Ref power = one("exp", combine("multiply", arg(0), number(2)));
        return combine("subtract", wide(1), combine("divide", wide(2), combine("add", power, number(1))));
    }
    if (inst.op == ir::Op::Dot) return combine("multiply", arg(0), arg(1));  // of numbers
    if (inst.op == ir::Op::Length) return one("absval", arg(0));
    if (inst.op == ir::Op::Distance) return one("absval", combine("subtract", arg(0), arg(1)));
    if (inst.op == ir::Op::Lerp) {
        const ir::Inst& weight = function_[args[2]];
        const bool is_spread = weight.op == ir::Op::Construct && function_.args(args[2]).size() == 1;
        const auto numbers = constant(args[2]);
        const Ref a = arg(0), b = arg(1), t = is_spread ? this->value(function_.args(args[2])[0]) : arg(2);
        const bool is_one = inst.type.is_scalar() || is_spread ||
                            (numbers && std::equal(numbers->begin() + 1, numbers->end(), numbers->begin()));
        current_ = value;
        if (!is_one) return combine("add", a, combine("multiply", combine("subtract", b, a), t));
        const std::string type = type_word(inst.type.width(), a.is_color() || b.is_color());
        return node("mix", type,
                    {{.name = "fg", .value = b, .type = type},
                     {.name = "bg", .value = a, .type = type},
                     {.name = "mix", .value = numbers ? number((*numbers)[0]) : t, .type = "float"}});
    }
    return std::nullopt;
}

// Vectors and their components, and what structures yield.
std::optional<Ref> NodeWriter::parts(ir::Value value) {
    const ir::Inst& inst = function_[value];
    const auto args = function_.args(value);
    if (inst.op == ir::Op::Convert) {
        const ir::Type from = function_[args[0]].type;
        const Ref in = from.is_bool() ? Ref{} : this->value(args[0]);
        if (from.is_bool() && inst.type.is_scalar()) return choose(args[0], 0, {.numbers = {1}}, {.numbers = {0}});
        if (from.is_bool()) return std::nullopt;
        const ir::Op made_by = function_[args[0]].op;
        const bool is_whole = made_by == ir::Op::Floor || made_by == ir::Op::Ceil || made_by == ir::Op::Round;
        return !inst.type.is_integer() || from.is_integer() || is_whole ? in : truncated(in);
    }
    if (inst.op == ir::Op::Construct && inst.type.is_vector()) {
        if (args.size() == 1 && function_[args[0]].type.is_scalar())
            return as(this->value(args[0]), type_word(inst.type.width()));
        std::vector<Ref> components;
        bool is_color = false;
        for (const ir::Value each : args) {
            const Ref ref = this->value(each);
            is_color = is_color || ref.is_color();
            for (unsigned i = 0; i < function_[each].type.width(); ++i) components.push_back(component(ref, i));
        }
        current_ = value;
        return join(components, is_color);
    }
    if (inst.op == ir::Op::Extract && function_[args[0]].type.is_vector())
        return component(this->value(args[0]), inst.data);
    if (inst.op == ir::Op::Index && function_[args[0]].op == ir::Op::Construct) {
        const auto index = constant(args[1]);
        const auto elements = function_.args(args[0]);
        if (!index || function_[args[0]].type.kind != ir::Kind::Array) return std::nullopt;
        return this->value(elements[std::min<std::size_t>(static_cast<std::size_t>((*index)[0]), elements.size() - 1)]);
    }
    if (inst.op == ir::Op::Insert && inst.type.is_vector()) {
        const Ref whole = this->value(args[0]);
        std::vector<Ref> components;
        for (unsigned i = 0; i < inst.type.width(); ++i)
            components.push_back(i == inst.data ? this->value(args[1]) : component(whole, i));
        return join(components, whole.is_color());
    }
    if (inst.op == ir::Op::Swizzle) {
        const Ref in = this->value(args[0]);
        const auto index = [&](unsigned i) { return (inst.data >> (2 * i)) & 3u; };
        if (function_[args[0]].type.is_scalar()) return as(in, type_word(inst.type.width()));
        const bool is_start = inst.type.width() == 3 && index(0) == 0 && index(1) == 1 && index(2) == 2;
        if (is_start && !in.is_number()) return as(in, type_word(3, in.is_color()));
        std::vector<Ref> components;
        for (unsigned i = 0; i < inst.type.width(); ++i) components.push_back(component(in, index(i)));
        return inst.type.is_scalar() ? components[0] : join(components, in.is_color());
    }
    if (inst.op == ir::Op::Result) {
        const ir::Inst& branch = function_[args[0]];
        if (branch.op != ir::Op::If || inst.type.is_bool()) return std::nullopt;
        const auto yielded = [&](std::uint32_t block) {
            return this->value(function_.args(function_.blocks[block].insts.back())[inst.data]);
        };
        const Ref yes = yielded(branch.data), no = yielded(branch.data + 1);
        current_ = value;
        return choose(function_.args(args[0])[0], 0, yes, no);
    }
    if (inst.op == ir::Op::Select) {
        const Ref yes = this->value(args[1]), no = this->value(args[2]);
        current_ = value;
        if (!function_[args[0]].type.is_vector()) return choose(args[0], 0, yes, no);
        std::vector<Ref> components;
        for (unsigned i = 0; i < inst.type.width(); ++i)
            components.push_back(choose(args[0], i, component(yes, i), component(no, i)));
        return join(components, yes.is_color() || no.is_color());
    }
    if (inst.op == ir::Op::Step) {
        const Ref edge = this->value(args[0]), in = this->value(args[1]);
        std::vector<Ref> components;
        for (unsigned i = 0; i < inst.type.width(); ++i)
            components.push_back(node("ifgreatereq", "float",
                                      {{.name = "value1", .value = component(in, i), .type = "float"},
                                       {.name = "value2", .value = component(edge, i), .type = "float"},
                                       {.name = "in1", .value = {.numbers = {1}}, .type = "float"},
                                       {.name = "in2", .value = {.numbers = {0}}, .type = "float"}}));
        return components.size() == 1 ? components[0] : join(components);
    }
    return std::nullopt;
}

Ref NodeWriter::value(ir::Value value) {
    const auto known = values_.find(value.index);
    if (known != values_.end()) return known->second;
    Ref ref = made(value);
    return values_[value.index] = std::move(ref);
}

Ref NodeWriter::made(ir::Value value) {
    const ir::Inst& inst = function_[value];
    const Ref nothing{.numbers = std::vector<double>(inst.type.is_numeric() ? inst.type.components() : 1, 0.0)};
    if (auto numbers = constant(value)) return {.numbers = std::move(*numbers)};
    const bool wraps = inst.type.scalar == ir::Scalar::Uint &&
                       (inst.op == ir::Op::Add || inst.op == ir::Op::Sub || inst.op == ir::Op::Mul);
    if (wraps) {
        refuse(value, "arithmetic of 'uint', which begins at 0 again");
        return nothing;
    }
    if (!inst.type.is_numeric() || inst.type.is_matrix()) {
        refuse(value, inst.type.is_matrix() ? "a matrix that is computed" : "this value");
        return nothing;
    }
    const ir::Value before = current_;
    current_ = value;
    std::optional<Ref> found;
    if (inst.op == ir::Op::Semantic) {
        found = semantic_value(value);
    } else if (inst.op == ir::Op::Global) {
        found = global_value(value);
    } else if (inst.op == ir::Op::Sample || inst.op == ir::Op::SampleBias || inst.op == ir::Op::SampleLevel ||
               inst.op == ir::Op::SampleGrad) {
        found = sampled(value);
    } else if (callee(value) == kUnpackNormal) {
        found = unpacked_normal(value);
    } else if (callee(value) == kToWorld) {
        found = world_normal(value);
    } else {
        found = called(value);
        if (!found) found = sharp_edge(*this, value);
        if (!found) found = arithmetic(value);
        if (!found) found = composed(value);
        if (!found) found = parts(value);
    }
    current_ = before;
    if (found) return *found;
    const std::string_view op = ir::info(inst.op).text;
    refuse(value, inst.op == ir::Op::Result ? "a loop" : fmt::format("the operation '{}'", op));
    return nothing;
}

}  // namespace patina::exporters::mtlx
