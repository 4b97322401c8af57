// A stand-in for a {fmt} that the program brings: it defines two functions of {fmt} 9 under their usual names. If the
// library defined or called them, the program would not link, or would end here.
#include <cstdlib>
#include <string>

namespace fmt {
inline namespace v9 {

class appender {};
template <typename Char>
class basic_string_view {};
template <typename Output, typename Char>
class basic_format_context {};
template <typename Context>
class basic_format_args {};

std::string vformat(basic_string_view<char>, basic_format_args<basic_format_context<appender, char>>) {
    std::abort();
}

namespace detail {
void throw_format_error(const char*) {
    std::abort();
}
}  // namespace detail

}  // namespace v9
}  // namespace fmt
