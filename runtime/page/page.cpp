#include "runtime/page/page.h"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "runtime/page/escaped.h"
#include "runtime/page/page_frame.h"

namespace patina::runtime {

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t j = 0; j < 3; j++)
            three = three << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
        for (std::size_t j = 0; j < 4; j++) text += i + j <= bytes.size() ? kDigits[three >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

std::string picture_tag(std::string_view png, std::string_view what, std::string_view css) {
    return fmt::format("<img{} loading=\"lazy\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
                       css.empty() ? "" : fmt::format(" class=\"{}\"", css), escaped(what), base64(png));
}

std::string kind_button(std::string_view kind, std::size_t count, std::string_view ending) {
    return fmt::format("<button type=\"button\" data-state=\"{0}\" aria-pressed=\"false\">{1} {0}{2}</button> ", kind,
                       count, ending);
}

std::string make_page(const Page& page) {
    const std::pair<std::string_view, std::string> parts[] = {
        {"@TITLE@", escaped(page.title)}, {"@TOOLS@", page.tools}, {"@CONTENT@", page.content}};
    std::string made;
    for (std::string_view rest = kPageFrame; !rest.empty();) {
        std::size_t at = rest.npos;
        const std::pair<std::string_view, std::string>* next = nullptr;
        for (const auto& part : parts) {
            const std::size_t found = rest.find(part.first);
            if (found >= at) continue;
            at = found;
            next = &part;
        }
        made += rest.substr(0, at);
        if (!next) break;
        made += next->second;
        rest.remove_prefix(at + next->first.size());
    }
    return made;
}

std::string folder_name(const std::string& folder) {
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(folder, ignored);
    return whole.has_filename()                 ? whole.filename().string()
           : whole.parent_path().has_filename() ? whole.parent_path().filename().string()
                                                : folder;
}

}  // namespace patina::runtime
