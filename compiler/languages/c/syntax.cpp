// How languages that descend from C write declarations, signatures, loops, structs and guards.
#include <fmt/format.h>

#include "compiler/languages/language.h"

namespace patina::languages {
namespace {

std::string variable(std::string_view type, std::string_view name, std::string_view sizes) {
    std::string text;
    text.reserve(type.size() + 1 + name.size() + sizes.size());
    return text.append(type).append(" ").append(name).append(sizes);
}

std::string signature(std::string_view result, std::string_view name, std::span<const std::string> params) {
    return fmt::format("{} {}({})", result, name, fmt::join(params, ", "));
}

std::string loop(std::string_view type, std::string_view index, std::string_view begin, std::string_view end) {
    return fmt::format("for ({3} {0} = {1}; {0} < {2}; ++{0}) {{", index, begin, end, type);
}

std::string only_where(std::string_view condition, std::string_view statement) {
    return fmt::format("if ({}) {}", condition, statement);
}

std::string open_struct(std::string_view name) {
    return fmt::format("struct {}", name);
}

std::string once(std::string_view name) {
    return fmt::format("#ifndef {}", name);
}

std::string define(std::string_view name, std::string_view value) {
    return value.empty() ? fmt::format("#define {}", name) : fmt::format("#define {} {}", name, value);
}

std::string only_if(std::string_view condition) {
    return fmt::format("#if {}", condition);
}

std::string else_if(std::string_view condition) {
    return fmt::format("#elif {}", condition);
}

}  // namespace

const Syntax kCSyntax = {
    .local = variable,
    .parameter = variable,
    .member = variable,
    .signature = signature,
    .loop = loop,
    .only_where = only_where,
    .open_struct = open_struct,
    .member_end = ";",
    .close_struct = "};",
    .once = once,
    .define = define,
    .only_if = only_if,
    .else_if = else_if,
    .otherwise = "#else",
    .end_guard = "#endif",
};

}  // namespace patina::languages
