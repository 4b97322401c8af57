#include "patina/complaints.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace patina {
namespace {

struct Row {
    std::string_view code, message;
};
constexpr std::array kRows = {
#define COMPLAINT(name, code, message) Row{code, message},
#include "patina/complaints.def"
#undef COMPLAINT
};

const Row& row_of(Complaint what) {
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

std::vector<std::string_view> complaint_codes() {
    std::vector<std::string_view> codes;
    for (const Row& row : kRows) {
        if (std::find(codes.begin(), codes.end(), row.code) == codes.end()) codes.push_back(row.code);
    }
    return codes;
}

}  // namespace patina
