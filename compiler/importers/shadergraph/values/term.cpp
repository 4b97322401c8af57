#include "compiler/importers/shadergraph/values/term.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"

namespace patina::importers::shadergraph {
namespace {

constexpr std::string_view kComponents = "xyzw", kChannels = "rgba";

std::size_t index_of(char component) {
    const std::size_t at = kComponents.find(component);
    return at != kComponents.npos ? at : std::min<std::size_t>(kChannels.find(component), 3);
}

bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '$' ||
           c == '@' || c == '.';
}

// The text of the vector's component.
std::string part_component(const Term::Part& part, std::size_t component) {
    if (part.width == 1) return part.text;
    return at_least(part.text, kPrimary) + "." + kComponents[component];
}

// float3(a, b.xy) of single components, with neighbours of the same vector joined.
Term from_parts(const Term& term, std::string_view components) {
    std::vector<std::pair<std::size_t, std::size_t>> places;  // of each component: the part, and the place in it
    for (std::size_t i = 0; i < term.parts.size(); ++i)
        for (std::size_t j = 0; j < term.parts[i].width; ++j) places.push_back({i, j});
    Term made{
        .type = vector_type(components.size()), .is_color = term.is_color, .nodes = term.nodes, .owner = term.owner};
    for (std::size_t at = 0; at < components.size();) {
        const auto [index, begin] = places[std::min(index_of(components[at]), places.size() - 1)];
        const Term::Part& part = term.parts[index];
        std::size_t count = 1;
        while (at + count < components.size() && part.width > 1 && begin + count < part.width &&
               places[std::min(index_of(components[at + count]), places.size() - 1)] == std::pair(index, begin + count))
            ++count;
        if (count == part.width && begin == 0)
            made.parts.push_back(part);
        else if (count == 1)
            made.parts.push_back({part_component(part, begin), 1});
        else
            made.parts.push_back(
                {at_least(part.text, kPrimary) + "." + std::string(kComponents.substr(begin, count)), count});
        at += count;
    }
    if (made.parts.size() == 1) {
        made.base = made.parts[0].text;
        made.parts.clear();
        return made;
    }
    std::string list;
    for (const Term::Part& part : made.parts) list += (list.empty() ? "" : ", ") + part.text;
    made.base = fmt::format("{}({})", word(made.type), list);
    return made;
}

Term wrapped(const Term& term, Type type, std::string text, std::vector<Term::Part> parts = {}) {
    Term made{
        .type = type, .base = std::move(text), .parts = std::move(parts), .nodes = term.nodes, .owner = term.owner};
    made.is_color = term.is_color;
    return made;
}

}  // namespace

void Term::add_nodes(const Term& part) {
    for (const std::size_t node : part.nodes)
        if (std::ranges::find(nodes, node) == nodes.end()) nodes.push_back(node);
}

// IEC 61966-2-1. Values above 1 go on as the engine's function does.
double linear(double srgb) {
    if (srgb <= 0.04045) return srgb / 12.92;
    return srgb < 1 ? std::pow((srgb + 0.055) / 1.055, 2.4) : std::pow(srgb, 2.2);
}

std::string Term::text() const {
    if (type == Type::Bool && is_constant()) return numbers[0] != 0 ? "true" : "false";
    if (is_matrix(type) && is_constant()) {
        std::string list;
        for (const double each : numbers) list += (list.empty() ? "" : ", ") + digits(each);
        return fmt::format("{}({})", word(type), list);
    }
    if (numbers.size() == 1) return digits(numbers[0]);
    if (is_constant()) {
        const bool is_same = std::ranges::all_of(numbers, [&](double each) { return each == numbers[0]; });
        std::string list;
        for (const double each : numbers)
            if (!is_same || list.empty()) list += (list.empty() ? "" : ", ") + digits(each);
        return fmt::format("{}({})", word(type), list);
    }
    return swizzle.empty() ? base : at_least(base, kPrimary) + "." + swizzle;
}

bool Term::is_link() const {
    return !is_constant() && !base.empty() && std::ranges::all_of(base, is_word) && !(base[0] >= '0' && base[0] <= '9');
}

Value Term::value() const {
    if (type == Type::Gradient && base.empty() && gradient) return gradient_value(*gradient);
    if (is_constant() && type == Type::Bool) return patina::importers::flag(numbers[0] != 0);
    if (is_constant() && is_vector(type)) {
        const bool is_same = std::ranges::all_of(numbers, [&](double each) { return each == numbers[0]; });
        if (is_same) return patina::importers::number(static_cast<float>(numbers[0]));
        const std::vector<float> floats(numbers.begin(), numbers.end());
        return list(floats);
    }
    return patina::importers::text(is_link() ? text() : "= " + text());
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

Term link(std::string text, Type type) {
    return {.type = type, .base = std::move(text)};
}

Term expression(std::string text, Type type) {
    Term made{.type = type, .base = std::move(text)};
    // float4(a, b, c) gives its parts to those who take some of the components; which are vectors is not known here.
    return made;
}

Term swizzled(const Term& term, std::string_view components) {
    const std::size_t count = width(term.type);
    Term made = term;
    made.type = vector_type(components.size());
    if (components != "xy") made.from_top.clear();
    if (term.is_constant()) {
        made.numbers.clear();
        for (const char each : components)
            made.numbers.push_back(term.numbers[std::min(index_of(each), term.numbers.size() - 1)]);
        return made;
    }
    if (!term.parts.empty()) {
        Term parts = from_parts(term, components);
        parts.from_top = made.from_top;
        return parts;
    }
    if (count <= 1) {
        if (components.size() == 1) return made;
        made.base = fmt::format("{}({})", word(made.type), term.text());
        made.swizzle.clear();
        return made;
    }
    const std::string_view letters = term.is_color ? kChannels : kComponents;
    std::string before = term.swizzle;
    if (before.empty()) {
        before = letters.substr(0, count);
        made.base_width = count;
    }
    made.swizzle.clear();
    for (const char each : components) made.swizzle += before[std::min(index_of(each), before.size() - 1)];
    if (made.swizzle == letters.substr(0, 4)) made.swizzle.clear();
    if (made.swizzle == letters.substr(0, count) && term.swizzle.empty()) made.swizzle.clear();
    return made;
}

Term vector_term(Type type, std::span<const Term> arguments) {
    Term made{.type = type};
    std::vector<Term> joined;
    for (const Term& each : arguments) {
        made.add_nodes(each);
        made.is_color |= each.is_color;
        Term* last = joined.empty() ? nullptr : &joined.back();
        const bool is_next = last && !each.swizzle.empty() && !last->swizzle.empty() && each.base == last->base;
        if (!is_next) {
            joined.push_back(each);
            continue;
        }
        last->swizzle += each.swizzle;
        last->type = vector_type(last->swizzle.size());
        last->add_nodes(each);
    }
    // One of them may have a size that is not known.
    std::size_t rest = width(type);
    for (const Term& each : joined) rest -= std::min(rest, width(each.type));
    for (Term& each : joined)
        if (each.type == Type::None) each.type = vector_type(rest);
    for (Term& each : joined)
        if (each.swizzle.size() == each.base_width &&
            std::string_view(each.is_color ? kChannels : kComponents).starts_with(each.swizzle))
            each.swizzle.clear();
    if (joined.size() == 1 && joined[0].type == type) return joined[0];
    made.is_color &= type == Type::Float4;
    if (std::ranges::all_of(joined, &Term::is_constant)) {
        for (const Term& each : joined)
            made.numbers.insert(made.numbers.end(), each.numbers.begin(), each.numbers.end());
        return made;
    }
    for (const Term& each : joined) {
        made.base += (made.base.empty() ? "" : ", ") + each.text();
        made.parts.push_back({each.text(), width(each.type)});
    }
    made.base = fmt::format("{}({})", word(type), made.base);
    return made;
}

Term flipped(const Term& term) {
    if (!term.from_top.empty()) {
        Term made = link(term.from_top, Type::Float2);
        made.nodes = term.nodes;
        return made;
    }
    if (term.is_constant() && term.numbers.size() > 1) return constant({term.numbers[0], 1 - term.numbers[1]});
    const Term u = swizzled(term, "x"), v = swizzled(term, "y");
    const std::string one_minus = "1 - " + at_least(v.text(), kProduct);
    return wrapped(term, Type::Float2, fmt::format("float2({}, {})", u.text(), one_minus),
                   {{u.text(), 1}, {one_minus, 1}});
}

Term converted(const Term& term, Type type, bool may_stay_number) {
    if (term.type == type || type == Type::None) return term;
    if (term.type == Type::None) return {};
    if (type == Type::Bool) {
        if (!is_vector(term.type)) return {};
        if (term.is_constant()) return flag_term(term.numbers[0] != 0);
        return wrapped(term, Type::Bool, at_least(swizzled(term, "x").text(), kCompare) + " != 0");
    }
    if (is_vector(type)) {
        if (term.type == Type::Bool) {
            const Term made = term.is_constant() ? number_term(term.numbers[0])
                                                 : wrapped(term, Type::Float, fmt::format("float({})", term.text()));
            return converted(made, type, may_stay_number);
        }
        if (!is_vector(term.type)) return {};
        const std::size_t from = width(term.type), to = width(type);
        if (from > to) return swizzled(term, kComponents.substr(0, to));
        if (from == 1) {
            if (may_stay_number) return term;
            if (term.is_constant()) return constant(std::vector<double>(to, term.numbers[0]));
            return wrapped(term, type, fmt::format("{}({})", word(type), term.text()));
        }
        // What is missing is 0, but the fourth component is 1.
        if (term.is_constant()) {
            Term made = term;
            made.type = type;
            while (made.numbers.size() < to) made.numbers.push_back(made.numbers.size() == 3 ? 1 : 0);
            return made;
        }
        std::vector<Term::Part> parts = term.parts.empty() ? std::vector<Term::Part>{{term.text(), from}} : term.parts;
        for (std::size_t i = from; i < to; ++i) parts.push_back({i == 3 ? "1" : "0", 1});
        std::string list;
        for (const Term::Part& part : parts) list += (list.empty() ? "" : ", ") + part.text;
        return wrapped(term, type, fmt::format("{}({})", word(type), list), parts);
    }
    if (is_matrix(type) && is_matrix(term.type) && width(type) < width(term.type)) {
        const std::size_t rows = width(type);
        if (term.is_constant()) {
            Term made{.type = type};
            for (std::size_t i = 0; i < rows * rows; ++i)
                made.numbers.push_back(term.numbers[i / rows * width(term.type) + i % rows]);
            return made;
        }
        std::string list;
        for (std::size_t i = 0; i < rows; ++i)
            list += fmt::format("{}{}[{}].{}", i > 0 ? ", " : "", at_least(term.text(), kPrimary), i,
                                kComponents.substr(0, rows));
        return wrapped(term, type, fmt::format("{}({})", word(type), list));
    }
    return {};
}

}  // namespace patina::importers::shadergraph
