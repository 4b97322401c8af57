#include "compiler/importers/shadergraph/values/term.h"

#include <fmt/format.h>

#include <algorithm>

namespace patina::importers::shadergraph {

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
            std::string_view(each.is_color ? "rgba" : "xyzw").starts_with(each.swizzle))
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

}  // namespace patina::importers::shadergraph
