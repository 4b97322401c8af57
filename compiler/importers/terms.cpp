#include "compiler/importers/terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina::importers::terms {
namespace {

constexpr std::string_view kComponents = "xyzw", kChannels = "rgba";

std::size_t index_of(char component) {
    const std::size_t at = kComponents.find(component);
    return at != kComponents.npos ? at : std::min<std::size_t>(kChannels.find(component), 3);
}

// The parts of float3(a, b.xy), or the term as the only part.
std::vector<Term::Part> parts_of(const Term& term) {
    return term.parts.empty() ? std::vector<Term::Part>{{term.text(), std::max<std::size_t>(width(term.type), 1)}}
                              : term.parts;
}

// A vector of components of the parts, with neighbours of the same part joined: "a", "b.xy".
std::vector<Term::Part> chosen(const std::vector<Term::Part>& parts, std::string_view components) {
    std::vector<std::pair<std::size_t, std::size_t>> places;  // of each component: the part, and the place in it
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < parts[i].width; ++j) places.push_back({i, j});
    std::vector<Term::Part> made;
    for (std::size_t at = 0; at < components.size();) {
        const auto place = places[std::min(index_of(components[at]), places.size() - 1)];
        const Term::Part& part = parts[place.first];
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
            made.push_back(
                {at_least(part.text, kPrimary) + "." + std::string(kComponents.substr(place.second, count)), count});
        at += count;
    }
    return made;
}

// The term with another text.
Term rewritten(const Term& term, Type type, std::string text, std::vector<Term::Part> parts = {}) {
    Term made{.type = type, .base = std::move(text), .parts = std::move(parts)};
    made.is_color = term.is_color;
    made.name = term.name;
    made.nodes = term.nodes;
    made.owner = term.owner;
    return made;
}

Term of_parts(const Term& term, Type type, std::vector<Term::Part> parts) {
    if (parts.size() == 1 && parts[0].width == width(type)) return rewritten(term, type, parts[0].text);
    const bool is_one_number = std::ranges::all_of(
        parts, [&](const Term::Part& each) { return each.width == 1 && each.text == parts[0].text; });
    std::string list;
    for (const Term::Part& part : parts)
        if (!is_one_number || list.empty()) list += (list.empty() ? "" : ", ") + part.text;
    return rewritten(term, type, fmt::format("{}({})", word(type), list), std::move(parts));
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
    std::string list;
    for (std::size_t i = 0; i < rows; ++i)
        list += fmt::format("{}{}[{}].{}", i > 0 ? ", " : "", at_least(term.text(), kPrimary), i,
                            kComponents.substr(0, rows));
    return rewritten(term, type, fmt::format("{}({})", word(type), list));
}

bool is_of_link(char c) {
    return is_word_letter(c) || c == '$' || c == '@' || c == '.';
}

}  // namespace

bool Term::is_all(double value) const {
    return is_constant() && std::ranges::all_of(numbers, [&](double each) { return each == value; });
}

std::string Term::text() const {
    if (type == Type::Bool && is_constant()) return numbers[0] != 0 ? "true" : "false";
    if (numbers.size() == 1) return digits(numbers[0]);
    if (is_constant()) {
        const bool is_one_number = is_vector(type) && is_all(numbers[0]);
        std::string list;
        for (const double each : numbers)
            if (!is_one_number || list.empty()) list += (list.empty() ? "" : ", ") + digits(each);
        return fmt::format("{}({})", word(type), list);
    }
    return swizzle.empty() ? base : at_least(base, kPrimary) + "." + swizzle;
}

bool Term::is_link() const {
    return !is_constant() && !base.empty() && std::ranges::all_of(base, is_of_link) && !is_digit(base[0]);
}

bool Term::is_short() const {
    if (is_constant() || is_link() || base.empty() || !tangent.empty()) return true;
    constexpr std::size_t kShort = 24;
    return !parts.empty() && base.size() <= kShort &&
           std::ranges::all_of(parts, [](const Part& part) { return precedence_of(part.text) == kPrimary; });
}

Value Term::value() const {
    if (type == Type::Gradient && base.empty() && gradient) return gradient_value(*gradient);
    if (is_constant() && type == Type::Bool) return patina::importers::flag(numbers[0] != 0);
    if (is_constant() && is_vector(type)) {
        if (is_all(numbers[0])) return patina::importers::number(static_cast<float>(numbers[0]));
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
    return {.type = type, .base = std::move(text)};
}

Term parsed(std::string text, Type type) {
    Term made = expression(std::move(text), type);
    if (const auto value = read_number(made.base)) {
        made.numbers = {*value};
        return converted(Term{.type = Type::Float, .numbers = {*value}}, type, true);
    }
    if (made.base == "true" || made.base == "false") return flag_term(made.base == "true");
    if (!made.base.starts_with("float") || made.base.size() < 8 || made.base[6] != '(' || !made.base.ends_with(')') ||
        !is_digit(made.base[5]))
        return made;
    const std::string_view inner = std::string_view(made.base).substr(7, made.base.size() - 8);
    // "float2(a, b) * float2(c)" is no such call.
    int depth = 0;
    for (const char c : inner) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth < 0) return made;
    }
    const std::vector<std::string> arguments = arguments_of(inner);
    std::string joined;
    for (const std::string& each : arguments) joined += (joined.empty() ? "" : ", ") + each;
    const auto count = static_cast<std::size_t>(made.base[5] - '0');
    if (joined != inner || arguments.size() != count) return made;
    std::vector<double> numbers;
    for (const std::string& each : arguments) {
        made.parts.push_back({each, 1});
        if (const auto value = read_number(each)) numbers.push_back(*value);
    }
    return numbers.size() == count ? constant(numbers) : made;
}

Term swizzled(const Term& term, std::string_view components) {
    const std::size_t count = std::max<std::size_t>(width(term.type), 1);
    const Type type = vector_type(components.size());
    if (components.find_first_of("01") != components.npos) {
        std::vector<Term::Part> parts;
        std::vector<double> numbers;
        for (const char each : components) {
            const Term one =
                each == '0' || each == '1' ? number_term(each - '0') : swizzled(term, std::string_view(&each, 1));
            parts.push_back({one.text(), 1});
            if (one.is_constant()) numbers.push_back(one.numbers[0]);
        }
        if (numbers.size() == components.size()) {
            Term made = constant(numbers);
            made.nodes = term.nodes;
            return made;
        }
        return components.size() == 1 ? rewritten(term, type, parts[0].text) : of_parts(term, type, parts);
    }
    Term made = term;
    made.type = type;
    if (components != "xy") made.from_top.clear();
    made.tangent.clear();
    if (term.is_constant()) {
        made.numbers.clear();
        for (const char each : components)
            made.numbers.push_back(term.numbers[std::min(index_of(each), term.numbers.size() - 1)]);
        return made;
    }
    if (!term.parts.empty()) {
        Term parts = of_parts(term, type, chosen(term.parts, components));
        parts.from_top = made.from_top;
        return parts;
    }
    if (count <= 1) {
        if (components.size() == 1) return made;
        return rewritten(term, type, fmt::format("{}({})", word(type), term.text()));
    }
    const std::string_view letters = term.is_color ? kChannels : kComponents;
    std::string before = term.swizzle;
    if (before.empty()) {
        before = letters.substr(0, count);
        made.base_width = count;
    }
    made.swizzle.clear();
    for (const char each : components) made.swizzle += before[std::min(index_of(each), before.size() - 1)];
    if (made.swizzle == letters) made.swizzle.clear();
    if (made.swizzle == letters.substr(0, count) && term.swizzle.empty()) made.swizzle.clear();
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
    return of_parts(term, Type::Float2, {{u.text(), 1}, {"1 - " + at_least(v.text(), kProduct), 1}});
}

Term converted(const Term& term, Type type, bool may_stay_number) {
    if (term.type == type || type == Type::None) return term;
    if (term.type == Type::Bool && is_vector(type)) {
        const Term made = term.is_constant() ? number_term(term.numbers[0])
                                             : rewritten(term, Type::Float, fmt::format("float({})", term.text()));
        return converted(made, type, may_stay_number);
    }
    if (type == Type::Bool && is_vector(term.type)) {
        if (term.is_constant()) return flag_term(term.numbers[0] != 0);
        return rewritten(term, Type::Bool, at_least(swizzled(term, "x").text(), kCompare) + " != 0");
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
        return of_parts(term, type, std::vector<Term::Part>(to, Term::Part{term.text(), 1}));
    }
    if (term.is_constant()) {
        Term made = term;
        made.type = type;
        while (made.numbers.size() < to) made.numbers.push_back(made.numbers.size() == 3 ? 1 : 0);
        return made;
    }
    std::vector<Term::Part> parts = parts_of(term);
    for (std::size_t i = from; i < to; ++i) parts.push_back({i == 3 ? "1" : "0", 1});
    return of_parts(term, type, std::move(parts));
}

}  // namespace patina::importers::terms
