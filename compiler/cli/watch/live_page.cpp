#include "compiler/cli/watch/live_page.h"

#include <fmt/format.h>

#include <filesystem>

#include "compiler/cli/watch/page_frame.h"
#include "compiler/json/json_writer.h"

namespace patina::cli {
namespace {

std::string with_ending(const std::string& picture, const char* ending) {
    return std::filesystem::path(picture).replace_extension(ending).string();
}

// The name of a file in the page's folder, as a part of an address between quotes.
std::string address_of(const std::string& path) {
    std::string address;
    for (const unsigned char c : std::filesystem::path(path).filename().string()) {
        const bool is_plain = std::isalnum(c) || std::string_view("-._~").find(char(c)) != std::string_view::npos;
        address += is_plain ? std::string(1, char(c)) : fmt::format("%{:02X}", c);
    }
    return address;
}

void replace(std::string& text, std::string_view word, std::string_view by) {
    text.replace(text.find(word), word.size(), by);
}

}  // namespace

std::string page_path(const std::string& picture) {
    return with_ending(picture, ".html");
}

std::string state_path(const std::string& picture) {
    return with_ending(picture, ".js");
}

std::string page_text(const std::string& picture) {
    std::string text(kLivePage);
    replace(text, "@PICTURE@", address_of(picture));
    replace(text, "@STATE@", address_of(state_path(picture)));
    return text;
}

std::string state_text(const PageState& state) {
    return fmt::format("patina({{\"version\": {}, \"subject\": {}, \"ok\": {}, \"text\": {}}});\n", state.version,
                       json_text(state.subject), state.ok, json_text(state.text));
}

}  // namespace patina::cli
