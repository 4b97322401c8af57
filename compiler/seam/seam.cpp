#include "compiler/seam/seam.h"

#include <algorithm>
#include <new>

namespace patina {
namespace {

constexpr std::size_t kMessage = 480;  // bytes of a message; a longer one is cut

// Formats into the string's own room.
template <class... Words>
void write(std::string& into, Code code, const Words&... words) {
    std::array<char, kMessage> letters;
    const auto end = fmt::format_to_n(letters.data(), letters.size(), fmt::runtime(info(code).message), words...).out;
    into.assign(letters.data(), static_cast<std::size_t>(end - letters.data()));
}

// " in the pass 'forward'", or nothing.
ShortName during(const Trail& trail) {
    ShortName text;
    if (trail.pass.text().empty()) return text;
    std::array<char, 2 * sizeof(ShortName)> letters;
    const auto end = fmt::format_to_n(letters.data(), letters.size(), " in the pass '{}'", trail.pass.text()).out;
    text = {letters.data(), static_cast<std::size_t>(end - letters.data())};
    return text;
}

void write_internal(std::string& into, std::string_view why, const Trail& trail) {
    std::array<char, kMessage> letters;
    const auto end = fmt::format_to_n(letters.data(), letters.size(), "{}{}", why, during(trail).text()).out;
    write(into, Code::Internal, std::string_view(letters.data(), static_cast<std::size_t>(end - letters.data())));
}

}  // namespace

void ShortName::operator=(std::string_view name) {
    size_ = name.copy(letters_.data(), letters_.size());
}

TrailGuard::~TrailGuard() {
    const bool is_known = !trail_.node.text().empty() || !trail_.pass.text().empty();  // by an inner one
    if (is_known || std::uncaught_exceptions() <= exceptions_) return;
    trail_.node = diagnostics_.context_node();
    trail_.port = diagnostics_.context_port();
    if (pass_) trail_.pass = *pass_;
}

Unexpected::Unexpected(std::string_view file) : room_(1) {
    Diagnostic& error = room_.front();
    error.file = file;
    error.message.reserve(kMessage);
    for (std::string* name : {&error.node, &error.port}) name->reserve(sizeof(ShortName));
    error.code.reserve(std::max(info(Code::OutOfMemory).name.size(), info(Code::Internal).name.size()));
}

std::vector<Diagnostic> Unexpected::describe(const Trail& trail) {
    Diagnostic& error = room_.front();
    Code code = Code::Internal;
    try {
        throw;
    } catch (const std::bad_alloc&) {
        code = Code::OutOfMemory;
        write(error.message, code, during(trail).text());
    } catch (const std::exception& exception) {
        write_internal(error.message, exception.what(), trail);
    } catch (...) {
        write_internal(error.message, "an unknown exception", trail);
    }
    error.code = info(code).name;
    error.node = trail.node.text();
    error.port = trail.port.text();
    return std::move(room_);
}

}  // namespace patina
