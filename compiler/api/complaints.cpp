#include "patina/complaints.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <array>

namespace patina {
namespace {

constexpr std::array kRows = {
#define COMPLAINT(name, code, message) ComplaintInfo{code, message, false},
#define CHECK_COMPLAINT(name, code, message) ComplaintInfo{code, message, true},
#include "patina/complaints.def"
#undef CHECK_COMPLAINT
#undef COMPLAINT
};

const ComplaintInfo& row_of(Complaint what) {
    return kRows[static_cast<std::size_t>(what)];
}

}  // namespace

std::string_view code_of(Complaint what) {
    return row_of(what).code;
}

Diagnostic complaint(Complaint what, std::initializer_list<std::string_view> words) {
    fmt::dynamic_format_arg_store<fmt::format_context> arguments;
    for (const std::string_view word : words) arguments.push_back(word);
    Diagnostic made;
    made.code = code_of(what);
    made.message = fmt::vformat(row_of(what).message, arguments);
    return made;
}

std::span<const ComplaintInfo> all_complaints() {
    return kRows;
}

}  // namespace patina
