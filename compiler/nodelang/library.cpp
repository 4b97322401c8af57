#include "compiler/nodelang/library.h"

#include <algorithm>

#include "compiler/nodelang/constants.h"

namespace patina::nodelang {
namespace {

template <class Decl>
const Decl* find(const std::unordered_map<std::string_view, const Decl*>& map, std::string_view name) {
    const auto found = map.find(name);
    return found == map.end() ? nullptr : found->second;
}

// Declarations that have not been read come last: most names in the text of a function are of its own locals.
template <class Decl>
const Decl* find(const std::unordered_map<std::string_view, const Decl*>& map,
                 const std::unordered_map<std::string_view, const Unread*>& unread, StableList<Decl> Ast::*kind,
                 std::string_view name) {
    if (const Decl* found = find(map, name)) return found;
    const Unread* other = find(unread, name);
    if (!other || (other->ast().*kind).empty()) return nullptr;
    return &(other->ast().*kind).front();
}

template <class Decl>
void add(std::unordered_map<std::string_view, const Decl*>& map, const Decl& decl, Span Decl::*name,
         const std::unordered_map<std::string_view, const Unread*>& unread, Diagnostics& diagnostics) {
    const auto [existing, is_new] = map.emplace(decl.name, &decl);
    if (unread.contains(decl.name)) diagnostics.report(Code::Redefinition, decl.*name, decl.name);
    if (!is_new)
        diagnostics.report(Code::Redefinition, decl.*name, decl.name)
            .note(existing->second->*name, "the first is here");
}

}  // namespace

const FunctionDecl* Declarations::function(std::string_view name) const {
    const FunctionDecl* own = find(functions, unread, &Ast::functions, name);
    return own || !parent ? own : parent->function(name);
}
const StructDecl* Declarations::structure(std::string_view name) const {
    const StructDecl* own = find(structs, unread, &Ast::structs, name);
    return own || !parent ? own : parent->structure(name);
}
const EnumDecl* Declarations::enumeration(std::string_view name) const {
    const EnumDecl* own = find(enums, unread, &Ast::enums, name);
    return own || !parent ? own : parent->enumeration(name);
}
const VariableDecl* Declarations::variable(std::string_view name) const {
    const VariableDecl* own = find(variables, unread, &Ast::variables, name);
    return own || !parent ? own : parent->variable(name);
}
const Declarations& Declarations::home_of(std::string_view function_name) const {
    return functions.contains(function_name) || unread.contains(function_name) || !parent
               ? *this
               : parent->home_of(function_name);
}

std::vector<std::string_view> Declarations::function_names() const {
    std::vector<std::string_view> names;
    for (const Declarations* scope = this; scope; scope = scope->parent) {
        for (const auto& [name, decl] : scope->functions) {
            if (decl->attribute("node")) names.push_back(name);
        }
        for (const auto& [name, other] : scope->unread) {
            const StableList<FunctionDecl>& own = other->ast().functions;
            if (!own.empty() && own.front().attribute("node")) names.push_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

void index_declarations(Ast& ast, Declarations& into, Diagnostics& diagnostics) {
    for (const FunctionDecl& f : ast.functions) {
        const auto first = into.functions.find(f.name);
        const bool is_overload =
            first != into.functions.end() && f.is_hlsl && !f.attribute("node") && !first->second->attribute("node");
        if (is_overload)
            into.overloads[f.name].push_back(&f);
        else
            add(into.functions, f, &FunctionDecl::name_span, into.unread, diagnostics);
    }
    for (const StructDecl& s : ast.structs) add(into.structs, s, &StructDecl::span, into.unread, diagnostics);
    for (const EnumDecl& e : ast.enums) add(into.enums, e, &EnumDecl::span, into.unread, diagnostics);
    for (const VariableDecl& v : ast.variables) add(into.variables, v, &VariableDecl::span, into.unread, diagnostics);
    check_constants(ast, into, diagnostics);
}

std::string_view attribute_text(const Attribute& attribute, std::size_t index) {
    if (index >= attribute.args.size()) return {};
    return attribute.args[index]->text;
}

// Reads line by line: a sentence ends with a full stop at the end of a line.
std::string first_sentence(std::string_view doc) {
    std::string sentence;
    while (!doc.empty() && !sentence.ends_with('.')) {
        std::string_view line = doc.substr(0, doc.find('\n'));
        doc.remove_prefix(std::min(line.size() + 1, doc.size()));
        if (const std::size_t marker = line.find("///"); marker != std::string_view::npos)
            line.remove_prefix(marker + 3);
        if (sentence.empty()) line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        sentence += line;
    }
    return sentence;
}

}  // namespace patina::nodelang
