#include "compiler/importers/terms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"
#include "compiler/importers/values.h"

namespace patina::importers::terms {
namespace {

using nodelang::arg;
using nodelang::Expr;

constexpr std::string_view kComponents = "xyzw", kChannels = "rgba";

std::size_t index_of(char component) {
    const std::size_t at = kComponents.find(component);
    return at != kComponents.npos ? at : std::min<std::size_t>(kChannels.find(component), 3);
}

// An argument of float3(a, b.xy).
struct Part {
    Tree tree;
    std::size_t width = 1;
};

// The arguments of float3(a, b.xy), or the term as the only part.
std::vector<Part> parts_of(const Term& term) {
    if (term.widths.empty()) return {{term.expression(), std::max<std::size_t>(width(term.type), 1)}};
    std::vector<Part> parts;
    // float3(a) has three parts and one argument.
    for (std::size_t i = 0; i < term.widths.size(); ++i)
        parts.push_back({arg(term.tree, std::min(i, term.tree->args.size() - 1)), term.widths[i]});
    return parts;
}

// A vector of components of the parts, with neighbours of the same part joined: "a", "b.xy".
std::vector<Part> chosen(const std::vector<Part>& parts, std::string_view components) {
    std::vector<std::pair<std::size_t, std::size_t>> places;  // of each component: the part, and the place in it
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < parts[i].width; ++j) places.push_back({i, j});
    std::vector<Part> made;
    for (std::size_t at = 0; at < components.size();) {
        const auto place = places[std::min(index_of(components[at]), places.size() - 1)];
        const Part& part = parts[place.first];
        std::size_t count = 1;
        const auto goes_on = [&](std::size_t next) {
            return next < components.size() && place.second + count < part.width &&
                   places[std::min(index_of(components[next]), places.size() - 1)] ==
                       std::pair(place.first, place.second + count);
        };
        while (part.width > 1 && goes_on(at + count)) ++count;
        if (count == part.width)
            made.push_back(part);
        else
            made.push_back({nodelang::member(part.tree, kComponents.substr(place.second, count)), count});
        at += count;
    }
    return made;
}

bool is_same(const Tree& a, const Tree& b) {
    return a == b || printed(*a) == printed(*b);
}

Term of_parts(const Term& term, Type type, const std::vector<Part>& parts) {
    if (parts.size() == 1 && parts[0].width == width(type)) return term.with(parts[0].tree, type);
    const bool is_one_number = std::ranges::all_of(
        parts, [&](const Part& each) { return each.width == 1 && is_same(each.tree, parts[0].tree); });
    std::vector<Tree> arguments;
    std::vector<std::size_t> widths;
    for (const Part& part : parts) {
        widths.push_back(part.width);
        if (!is_one_number || arguments.empty()) arguments.push_back(part.tree);
    }
    return term.with(nodelang::call(word(type), std::move(arguments)), type, std::move(widths));
}

// The first rows and columns of a matrix.
Term corner(const Term& term, Type type) {
    const std::size_t rows = width(type);
    if (term.is_constant()) {
        Term made = term;
        made.type = type;
        made.numbers.clear();
        for (std::size_t i = 0; i < rows * rows; ++i)
            made.numbers.push_back(term.numbers[i / rows * width(term.type) + i % rows]);
        return made;
    }
    std::vector<Tree> list;
    for (std::size_t i = 0; i < rows; ++i)
        list.push_back(nodelang::member(nodelang::index(term.expression(), nodelang::number(static_cast<double>(i))),
                                        kComponents.substr(0, rows)));
    return term.with(nodelang::call(word(type), std::move(list)), type);
}

}  // namespace

bool Term::is_all(double value) const {
    return is_constant() && std::ranges::all_of(numbers, [&](double each) { return each == value; });
}

Tree Term::expression() const {
    if (!is_constant()) return tree ? tree : nodelang::name("");
    if (type == Type::Bool) return nodelang::flag(numbers[0] != 0);
    if (numbers.size() == 1) return nodelang::number(numbers[0]);
    std::vector<Tree> list;
    for (const double each : numbers) list.push_back(nodelang::number(each));
    if (is_vector(type) && is_all(numbers[0])) list.resize(1);
    return nodelang::call(word(type), std::move(list));
}

std::string Term::text() const {
    return printed(*expression());
}

bool Term::is_link() const {
    if (is_constant() || !tree) return false;
    const Expr* root = tree.get();
    while (root->kind == Expr::Kind::Member) root = root->args[0];
    return root->kind == Expr::Kind::Name || root->kind == Expr::Kind::Property || root->kind == Expr::Kind::Semantic;
}

bool Term::is_short() const {
    if (is_constant() || is_link() || !tree || tangent) return true;
    constexpr std::size_t kShort = 24;
    return !widths.empty() && text().size() <= kShort && std::ranges::all_of(tree->args, [](const Expr* part) {
        return nodelang::precedence_of(*part) >= Precedence::Postfix;
    });
}

GraphValue Term::value() const {
    if (type == Type::Gradient && !tree && gradient) return gradient_value(*gradient);
    if (is_constant() && type == Type::Bool) return numbers[0] != 0;
    if (is_constant() && is_vector(type)) {
        if (is_all(numbers[0])) return static_cast<float>(numbers[0]);
        return list_of(std::vector<float>(numbers.begin(), numbers.end()));
    }
    return is_link() ? text() : "= " + text();
}

Term Term::with(Tree other, Type other_type, std::vector<std::size_t> its_widths) const {
    Term made{.type = other_type, .tree = std::move(other), .widths = std::move(its_widths)};
    made.is_color = is_color;
    made.name = name;
    made.nodes = nodes;
    made.owner = owner;
    return made;
}

Term number_term(double value) {
    return {.type = Type::Float, .numbers = {value}};
}

Term constant(std::vector<double> values) {
    const Type type = vector_type(values.size());
    return {.type = type, .numbers = std::move(values)};
}

Term flag_term(bool value) {
    return {.type = Type::Bool, .numbers = {value ? 1.0 : 0.0}};
}

Term white() {
    return constant({1, 1, 1, 1});
}

Term stand_in(Type type) {
    switch (type) {
        case Type::Float2: return constant({1, 0});
        case Type::Float3: return constant({1, 0, 1});
        case Type::Float4: return constant({1, 0, 1, 1});
        case Type::Bool: return flag_term(false);
        case Type::Matrix2:
        case Type::Matrix3:
        case Type::Matrix4: {
            Term made{.type = type};
            const std::size_t rows = width(type);
            for (std::size_t i = 0; i < rows * rows; ++i) made.numbers.push_back(i % (rows + 1) == 0 ? 1 : 0);
            return made;
        }
        case Type::Gradient: {
            Term made{.type = type};
            made.gradient = std::make_shared<const Gradient>(
                Gradient{.colors = {{.time = 0, .value = {1, 0, 1}}}, .alphas = {{.time = 0, .value = {1}}}});
            return made;
        }
        case Type::Sampler: return link("trilinearRepeat", type);  // what a slot has if nothing is connected
        case Type::None:
        case Type::Float:
        case Type::Texture2D:
        case Type::Texture2DArray:
        case Type::Texture3D:
        case Type::Cubemap:
        case Type::Connection:
        case Type::VirtualTexture: break;
    }
    return number_term(1);
}

Term of_tree(Tree tree, Type type) {
    double value = 0;
    if (nodelang::is_number(*tree, value)) return number_term(value == 0 ? 0 : value);
    if (tree->kind == Expr::Kind::Bool) return flag_term(tree->number != 0);
    Term made{.type = type, .tree = std::move(tree)};
    const std::size_t count = made.tree->args.size();
    const bool is_vector_call =
        made.tree->kind == Expr::Kind::Call && count > 1 && count <= 4 && made.tree->text == word(vector_type(count));
    if (!is_vector_call) return made;
    made.widths.assign(count, 1);
    std::vector<double> numbers;
    for (const Expr* const each : made.tree->args)
        if (nodelang::is_number(*each, value)) numbers.push_back(value);
    return numbers.size() == count ? constant(numbers) : made;
}

Term link(std::string_view text, Type type) {
    const std::vector<std::string_view> names = split(text, ".");
    Tree tree = nodelang::name(names.empty() ? text : names[0]);
    for (std::size_t i = 1; i < names.size(); ++i) tree = nodelang::member(std::move(tree), names[i]);
    return {.type = type, .tree = std::move(tree)};
}

Term color_link(std::string_view text) {
    Term made = link(text, Type::Float4);
    made.is_color = true;
    return made;
}

Term expression(std::string_view text, Type type) {
    const Tree tree = nodelang::parsed_tree(text);
    // What is no expression is refused by the compiler, and its message is that of the import.
    return tree ? of_tree(tree, type) : Term{.type = type, .tree = nodelang::name(text)};
}

Term swizzled(const Term& term, std::string_view components) {
    const std::size_t count = std::max<std::size_t>(width(term.type), 1);
    const Type type = vector_type(components.size());
    if (components.find_first_of("01") != components.npos) {
        std::vector<Part> parts;
        std::vector<double> numbers;
        for (const char each : components) {
            const Term one =
                each == '0' || each == '1' ? number_term(each - '0') : swizzled(term, std::string_view(&each, 1));
            parts.push_back({one.expression(), 1});
            if (one.is_constant()) numbers.push_back(one.numbers[0]);
        }
        if (numbers.size() == components.size()) {
            Term made = constant(numbers);
            made.nodes = term.nodes;
            return made;
        }
        return components.size() == 1 ? term.with(parts[0].tree, type) : of_parts(term, type, parts);
    }
    Term made = term;
    made.type = type;
    if (components != "xy") made.from_top.reset();
    made.tangent.reset();
    if (term.is_constant()) {
        made.numbers.clear();
        for (const char each : components)
            made.numbers.push_back(term.numbers[std::min(index_of(each), term.numbers.size() - 1)]);
        return made;
    }
    if (!term.widths.empty()) {
        Term parts = of_parts(term, type, chosen(parts_of(term), components));
        parts.from_top = made.from_top;
        return parts;
    }
    if (count <= 1) {
        if (components.size() == 1) return made;
        return term.with(nodelang::call(word(type), {term.expression()}), type);
    }
    const std::string_view letters = term.is_color ? kChannels : kComponents;
    const Tree whole = term.whole();
    const std::size_t whole_width = term.whole_width > 0 ? term.whole_width : count;
    const std::string before(term.whole_width > 0 ? term.components() : letters.substr(0, count));
    std::string all;
    for (const char each : components) all += before[std::min(index_of(each), before.size() - 1)];
    const bool is_whole = all == letters.substr(0, whole_width);
    made.tree = is_whole ? whole : nodelang::member(whole, all);
    made.whole_width = is_whole ? 0 : whole_width;
    return made;
}

Term vector_of(Type type, std::span<const Term> terms) {
    Term holds{.type = type};
    std::vector<Term> joined;
    for (const Term& each : terms) {
        holds.add_nodes(each);
        holds.is_color |= each.is_color;
        Term* const last = joined.empty() ? nullptr : &joined.back();
        const bool is_next =
            last && last->whole_width > 0 && each.whole_width > 0 && is_same(last->whole(), each.whole());
        if (!is_next) {
            joined.push_back(each);
            continue;
        }
        const std::string all = std::string(last->components()) + std::string(each.components());
        last->tree = nodelang::member(last->whole(), all);
        last->type = vector_type(all.size());
        last->add_nodes(each);
    }
    // One of them may have a size that is not known.
    std::size_t rest = width(type);
    for (const Term& each : joined) rest -= std::min(rest, width(each.type));
    for (Term& each : joined) {
        if (each.type == Type::None) each.type = vector_type(rest);
        if (each.whole_width == 0 ||
            each.components() != (each.is_color ? kChannels : kComponents).substr(0, each.whole_width))
            continue;
        each.tree = each.whole();
        each.whole_width = 0;
    }
    if (joined.size() == 1 && joined[0].type == type) return joined[0];
    holds.is_color &= type == Type::Float4;
    if (std::ranges::all_of(joined, &Term::is_constant)) {
        for (const Term& each : joined)
            holds.numbers.insert(holds.numbers.end(), each.numbers.begin(), each.numbers.end());
        return holds;
    }
    std::vector<Tree> arguments;
    for (const Term& each : joined) {
        arguments.push_back(each.expression());
        holds.widths.push_back(width(each.type));
    }
    holds.tree = nodelang::call(word(type), std::move(arguments));
    return holds;
}

Term flipped(const Term& term) {
    if (term.from_top) {
        Term made{.type = Type::Float2, .tree = term.from_top};
        made.nodes = term.nodes;
        return made;
    }
    if (term.is_constant() && term.numbers.size() > 1) return constant({term.numbers[0], 1 - term.numbers[1]});
    const Term u = swizzled(term, "x"), v = swizzled(term, "y");
    return of_parts(term, Type::Float2,
                    {{u.expression(), 1}, {nodelang::binary("-", nodelang::number(1), v.expression()), 1}});
}

Term converted(const Term& term, Type type, bool may_stay_number) {
    if (term.type == type || type == Type::None) return term;
    if (term.type == Type::Bool && is_vector(type)) {
        const Term made = term.is_constant() ? number_term(term.numbers[0])
                                             : term.with(nodelang::call("float", {term.expression()}), Type::Float);
        return converted(made, type, may_stay_number);
    }
    if (type == Type::Bool && is_vector(term.type)) {
        if (term.is_constant()) return flag_term(term.numbers[0] != 0);
        return term.with(nodelang::binary("!=", swizzled(term, "x").expression(), nodelang::number(0)), Type::Bool);
    }
    if (is_matrix(type) && is_matrix(term.type) && width(type) < width(term.type)) return corner(term, type);
    if (!is_vector(type) || !is_vector(term.type)) return {};
    const std::size_t from = width(term.type), to = width(type);
    if (from > to) return swizzled(term, (term.is_color ? kChannels : kComponents).substr(0, to));
    if (from == 1) {
        if (may_stay_number) return term;
        if (term.is_constant()) {
            Term made = term;
            made.type = type;
            made.numbers.assign(to, term.numbers[0]);
            return made;
        }
        return of_parts(term, type, std::vector<Part>(to, Part{term.expression(), 1}));
    }
    if (term.is_constant()) {
        Term made = term;
        made.type = type;
        while (made.numbers.size() < to) made.numbers.push_back(made.numbers.size() == 3 ? 1 : 0);
        return made;
    }
    std::vector<Part> parts = parts_of(term);
    for (std::size_t i = from; i < to; ++i) parts.push_back({nodelang::number(i == 3 ? 1 : 0), 1});
    return of_parts(term, type, parts);
}

}  // namespace patina::importers::terms
