#include "compiler/base/file_names.h"

#include <algorithm>
#include <filesystem>

#include "compiler/base/letters.h"
#include "compiler/base/text.h"

namespace patina {
namespace {

bool may_stand_in_scheme(char c) {
    return is_letter(c) || is_digit(c) || c == '+' || c == '-' || c == '.';
}

// "wet/./a/../rust.png" -> "wet/rust.png"
std::string without_dots(std::string_view path) {
    std::string made;
    while (!path.empty()) {
        const std::size_t slash = std::min(path.find('/'), path.size());
        const std::string_view part = path.substr(0, slash);
        path.remove_prefix(std::min(slash + 1, path.size()));
        if (part.empty() || part == ".") continue;
        if (part == "..") {
            const std::size_t parent = made.rfind('/');
            made.resize(parent == made.npos ? 0 : parent);
            continue;
        }
        if (!made.empty()) made += '/';
        made += part;
    }
    return made;
}

// As Windows reads it: everything after the first dot is ignored, and case does not count.
bool is_device(std::string_view stem) {
    std::string word = small_letters(std::string(stem));
    while (word.ends_with(' ')) word.pop_back();
    for (const char* device : {"con", "prn", "aux", "nul"})
        if (word == device) return true;
    return word.size() == 4 && (word.starts_with("com") || word.starts_with("lpt")) && is_digit(word[3]);
}

}  // namespace

std::string_view scheme_of(std::string_view path) {
    const std::size_t colon = path.find("://");
    if (colon == path.npos || colon == 0 || !is_letter(path[0])) return {};
    const std::string_view scheme = path.substr(0, colon);
    return std::all_of(scheme.begin(), scheme.end(), may_stand_in_scheme) ? path.substr(0, colon + 3)
                                                                          : std::string_view();
}

bool is_file_name(std::string_view text) {
    return text.starts_with("./") || text.starts_with("../") || text.starts_with('/') || !scheme_of(text).empty();
}

std::string portable_name(std::string name) {
    if (name.empty()) return "graph";
    constexpr std::string_view kRefused = "<>:\"/\\|?*";
    for (char& c : name)
        if (kRefused.find(c) != kRefused.npos || static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '_';
    for (std::size_t from = 0, bad = 0; !is_utf8(std::string_view(name).substr(from), bad); from += bad + 1)
        name[from + bad] = '_';
    if (is_device(std::string_view(name).substr(0, name.find('.')))) name[0] = '_';
    return name;
}

std::string join_names(const std::string& from, const std::string& name) {
    namespace fs = std::filesystem;
    if (!scheme_of(name).empty()) return name;
    const std::string_view scheme = scheme_of(from);
    if (scheme.empty()) {
        if (fs::path(name).is_absolute()) return name;
        return (fs::path(from).parent_path() / name).lexically_normal().generic_string();
    }
    std::string_view folder = std::string_view(from).substr(scheme.size());
    folder = name.starts_with('/') ? std::string_view() : folder.substr(0, folder.rfind('/') + 1);
    return std::string(scheme) + without_dots(std::string(folder) + name);
}

}  // namespace patina
