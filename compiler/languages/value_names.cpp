// Chooses the name of a variable: the author's, or one that says what the value is.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "compiler/base/spelling.h"
#include "compiler/ir/hints.h"
#include "compiler/languages/body.h"

namespace patina::languages {

using namespace ir;

namespace {

constexpr std::size_t kLongest = 32;  // of a name that is made of the names of operands

struct Fallback {
    Op op;
    std::string_view name;
};
constexpr Fallback kFallbacks[] = {
    {Op::Add, "sum"},           {Op::Sub, "difference"},    {Op::Mul, "product"},         {Op::MatMul, "product"},
    {Op::Div, "ratio"},         {Op::Mod, "remainder"},     {Op::Neg, "opposite"},        {Op::Dot, "projection"},
    {Op::Length, "size"},       {Op::Distance, "size"},     {Op::Normalize, "direction"}, {Op::Cross, "perpendicular"},
    {Op::Reflect, "reflected"}, {Op::Refract, "refracted"}, {Op::Lerp, "blend"},          {Op::Select, "choice"},
    {Op::Sample, "texel"},      {Op::SampleBias, "texel"},  {Op::SampleLevel, "texel"},   {Op::SampleGrad, "texel"},
    {Op::TexelLoad, "texel"},   {Op::TextureSize, "size"},  {Op::Ddx, "slopeX"},          {Op::Ddy, "slopeY"},
    {Op::Fwidth, "slope"},      {Op::Pow, "power"},         {Op::Exp, "power"},           {Op::Exp2, "power"},
    {Op::Sqrt, "root"},         {Op::Less, "test"},         {Op::LessEqual, "test"},      {Op::Greater, "test"},
    {Op::GreaterEqual, "test"}, {Op::Equal, "test"},        {Op::NotEqual, "test"},       {Op::And, "test"},
    {Op::Or, "test"},           {Op::Not, "test"},          {Op::Index, "element"},       {Op::Saturate, "limited"},
    {Op::Min, "limited"},       {Op::Max, "limited"},       {Op::Clamp, "limited"},       {Op::Transpose, "transposed"},
};

// How the name of a value is made of those of its operands: "dot(n, l)" -> "nDotL".
struct Pattern {
    Op op;
    std::string_view before, between, behind;
};
constexpr Pattern kPatterns[] = {
    {Op::Add, "", "plus", ""},      {Op::Sub, "", "minus", ""},
    {Op::Mul, "", "times", ""},     {Op::Div, "", "over", ""},
    {Op::Dot, "", "dot", ""},       {Op::Cross, "", "cross", ""},
    {Op::Length, "", "", "length"}, {Op::Normalize, "", "", "direction"},
    {Op::Sqrt, "sqrt", "", ""},     {Op::Abs, "abs", "", ""},
    {Op::Neg, "minus", "", ""},     {Op::Sin, "sin", "", ""},
    {Op::Cos, "cos", "", ""},       {Op::Exp, "exp", "", ""},
    {Op::Exp2, "exp2", "", ""},     {Op::Floor, "floor", "", ""},
    {Op::Frac, "fract", "", ""},    {Op::Saturate, "saturated", "", ""},
};

std::string_view word_of(Op op) {
    const auto found =
        std::find_if(std::begin(kFallbacks), std::end(kFallbacks), [&](const Fallback& f) { return f.op == op; });
    return found == std::end(kFallbacks) ? "value" : found->name;
}

}  // namespace

// The purpose of a value says more than its computation, so a value that is stored in a struct is named after the
// member.
void Body::find_member_names() {
    member_of_.resize(function_.insts.size());
    const auto note = [&](Value value, Type structure, std::uint32_t member) {
        Value named = plan_.resolve(value);
        if (function_[named].op == Op::Swizzle) named = plan_.resolve(function_.args(function_[named])[0]);
        member_of_[named.index] = writer_.module.structs[structure.ref].members[member].name;
    };
    for (const Inst& inst : function_.insts) {
        if (inst.type.kind != Kind::Struct) continue;
        const std::span<const Value> args = function_.args(inst);
        if (inst.op == Op::Insert) note(args[1], inst.type, inst.data);
        if (inst.op != Op::Construct) continue;
        for (std::uint32_t i = 0; i < args.size(); ++i) note(args[i], inst.type, i);
    }
}

// The id path, within the function, of the node that an instruction comes from; empty if there is none.
std::string_view Body::path_of(OriginId origin) const {
    return origin ? writer_.module.origins[origin.index].path_in_function() : "";
}

// The id of the node.
std::string_view Body::node_of(OriginId origin) const {
    const std::string_view id = path_of(origin);
    return id.substr(id.rfind('/') + 1);
}

// --- values of sub-graphs

namespace {

// The path of a value that a graph names: that of its node, or "node/output" for an output of a sub-graph.
std::string path_to(std::string_view node_path, std::string_view name) {
    const std::string_view node = node_path.substr(node_path.rfind('/') + 1);
    return node == name ? std::string(node_path) : fmt::format("{}/{}", node_path, name);
}

// The last `count` ids before the last one of a path: "rust_layer" of "a/rust/layer/t" and 2. Fewer if it is shorter.
std::string instances(std::string_view path, std::size_t count) {
    std::size_t end = path.rfind('/');
    std::string made;
    for (; count > 0 && end != path.npos; --count) {
        const std::size_t before = end == 0 ? path.npos : path.rfind('/', end - 1);
        const std::size_t begin = before == path.npos ? 0 : before + 1;
        made = fmt::format("{}{}{}", path.substr(begin, end - begin), made.empty() ? "" : "_", made);
        end = before;
    }
    return made;
}

}  // namespace

void Body::find_paths() {
    if (std::exchange(has_paths_, true)) return;
    const auto add = [&](std::string_view name, std::string path) {
        std::vector<std::string>& paths = paths_[std::string(name)];
        if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(std::move(path));
    };
    for (const Variable& variable : plan_.variables) {
        const OriginId origin = function_[variable.like].origin;
        const std::string_view path = path_of(origin);
        if (path.empty()) continue;
        add(node_of(origin), std::string(path));
        const Hint hint = hint_of(writer_.module, variable.hint);
        if (!hint.name.empty() && hint.callee.empty()) add(hint.name, path_to(path, hint.name));
    }
}

// If several values or nodes have the name, in different sub-graphs or in different uses of one: the use to which this
// one belongs, in as few words as distinguish it from the others. Otherwise empty.
std::string Body::instance_of(std::string_view name, bool is_authors, OriginId origin) {
    const std::string_view node_path = path_of(origin);
    if (node_path.empty()) return {};
    const std::string path = is_authors ? path_to(node_path, name) : std::string(node_path);
    if (path.find('/') == path.npos) return {};
    find_paths();
    const auto found = paths_.find(std::string(is_authors ? name : node_of(origin)));
    if (found == paths_.end()) return {};
    const std::vector<std::string>& paths = found->second;
    if (paths.size() < 2) return {};
    for (std::size_t count = 1;; ++count) {
        std::string mine = instances(path, count);
        const bool is_only = std::all_of(paths.begin(), paths.end(), [&](const std::string& other) {
            return other == path || instances(other, count) != mine;
        });
        if (is_only || mine == instances(path, count + 1)) return mine;
    }
}

// The name of a value that has one: a variable, an input, a member or a component of these. Otherwise empty.
std::string Body::noun(Value v) const {
    const Inst& inst = function_[v];
    if (is_variable(v)) return names_[plan_.variable[v.index]];
    if (inst.op == Op::Param) return entry_ ? writer_.module.stage.inputs[inst.data].name : params_[inst.data];
    if (inst.op == Op::Global) {
        const std::string& name = writer_.globals[inst.data];
        return writer_.module.globals[inst.data].is_foreign()
                   ? ""
                   : name.substr(std::min(name.find_first_not_of('_'), name.size()));
    }
    if (inst.op != Op::Extract && inst.op != Op::Swizzle) return {};
    const Value from = arg(v, 0);
    const Type type = function_[from].type;
    if (inst.op == Op::Extract && type.kind == Kind::Struct)
        return writer_.module.structs[type.ref].members[inst.data].name;
    const std::string whole = type.is_vector() ? noun(from) : std::string();
    if (whole.empty()) return {};
    std::string letters;
    for (unsigned i = 0; i < inst.type.width(); ++i)
        letters += "XYZW"[inst.op == Op::Extract ? inst.data : inst.data >> (2 * i) & 3];
    return letters == std::string_view("XYZW").substr(0, letters.size()) && letters.size() > 1 ? whole
                                                                                               : whole + letters;
}

// "oneMinusMetallic", "roughnessSquared", "normalDotViewDir"; empty if an operand has no name, or the name is too long.
std::string Body::name_of_operands(Value v) const {
    const auto* const pattern = std::find_if(std::begin(kPatterns), std::end(kPatterns),
                                             [&](const Pattern& p) { return p.op == function_[v].op; });
    if (pattern == std::end(kPatterns)) return {};
    const auto word = [&](std::uint32_t i) {
        const Inst& operand = function_[arg(v, i)];
        if (operand.op != Op::Constant) return noun(arg(v, i));
        const auto numbers = module().numbers_of(module().constants[operand.data]);
        return std::string(std::all_of(numbers.begin(), numbers.end(), [](double n) { return n == 1; }) ? "one" : "");
    };
    const std::string first = word(0);
    if (first.empty()) return {};
    std::string name = joined(pattern->before, first);
    if (args(v) == 2) {
        const std::string second = word(1);
        if (second.empty()) return {};
        name = first == second && pattern->op == Op::Mul ? joined(first, "squared")
                                                         : joined(joined(name, pattern->between), second);
    }
    name = joined(name, pattern->behind);
    return name.size() <= kLongest ? name : std::string();
}

std::string Body::name_without_hint(Value v) const {
    const Inst& inst = function_[v];
    if (inst.type.kind == Kind::Struct) {
        const std::string name = camel_case(writer_.plain(writer_.module.structs[inst.type.ref].name));
        return writer_.names.is_free(name) ? name : initials(name);
    }
    if (!member_of_[v.index].empty()) return std::string(member_of_[v.index]);
    if (inst.op == Op::Construct && inst.type.is_matrix()) return "basis";
    if (const std::string_view callee = hint_of(writer_.module, inst.name).callee; !callee.empty()) {
        return std::string(callee);
    }
    if (inst.op == Op::Call) {
        const std::string name = camel_case(writer_.plain(writer_.module.functions[inst.data].name));
        return writer_.names.is_free(name) ? name : joined(name, "Value");
    }
    const std::uint32_t variable = plan_.variable[v.index];
    const bool changes = variable == Plan::kNone || plan_.variables[variable].writes > 1;
    if (std::string name = changes ? "" : name_of_operands(v); !name.empty()) return name;
    // A step in the computation of a node's value is named after the node.
    const std::string_view last = node_of(inst.origin);
    const std::string_view step = word_of(inst.op);
    return step.starts_with(last) ? std::string(step) : joined(last, step);
}

// Two values may want one name. Values of sub-graphs then have the name of the node that uses the sub-graph before
// theirs: "rust_edge". A local of an inlined function adds its origin: the node or the function, whichever is shorter.
std::string Body::declare(NameId id, std::string_view otherwise, OriginId origin) {
    const Hint hint = hint_of(writer_.module, id);
    const std::string_view wanted = hint.name.empty() ? otherwise : hint.name;
    const bool is_authors = !hint.name.empty() && hint.callee.empty();
    const bool is_free = writer_.names.is_free(safe_identifier(wanted));
    // A step of a node's computation is named after the node.
    const bool is_of_node = is_authors || (hint.name.empty() && wanted.starts_with(node_of(origin)));
    if (is_of_node || !is_free) {
        const std::string instance = instance_of(wanted, is_authors, origin);
        if (!instance.empty()) return writer_.names.declare(fmt::format("{}_{}", instance, wanted));
    }
    if (hint.callee.empty() || is_free) return writer_.names.declare(wanted);
    std::array whose = {node_of(origin), hint.callee};
    if (whose[1].size() < whose[0].size()) std::swap(whose[0], whose[1]);
    for (const std::string_view each : whose) {
        if (each.empty() || each == wanted) continue;
        const std::string longer = safe_identifier(joined(each, wanted));
        if (writer_.names.is_free(longer)) return writer_.names.declare(longer);
    }
    return writer_.names.declare(wanted);
}

}  // namespace patina::languages
