#include "compiler/importers/shadergraph/code/includes.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "compiler/base/disk/disk.h"
#include "compiler/importers/source_text.h"
#include "compiler/importers/unity/assets.h"
#include "compiler/nodelang/lex.h"

namespace patina::importers::shadergraph {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 8;
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
constexpr std::size_t kLongest = 4'000'000;  // characters of all files together

// #include "NAME"
std::string_view included(std::string_view line) {
    Diagnostics unread;
    nodelang::Lexer lexer({.text = line}, nodelang::Lexer::Dialect::Hlsl, unread);
    if (!lexer.next().is("#") || !lexer.next().is_word("include")) return {};
    const nodelang::Token name = lexer.next();
    return name.kind == nodelang::Token::Kind::String ? name.text : std::string_view();
}

class Expander {
public:
    explicit Expander(std::span<const std::string> folders) : folders_(folders) {}

    void add(const fs::path& path, std::string_view text, int depth) {
        std::error_code ignored;
        taken_.insert(fs::weakly_canonical(path, ignored));
        if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
        while (!text.empty()) {
            const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
            const std::string_view line = text.substr(0, end);
            text.remove_prefix(end);
            const std::string_view name = included(line);
            const std::optional<fs::path> file = name.empty() ? std::nullopt : find(path, name);
            if (!file) {
                made.text += line;
            } else if (depth < kDeepest && made.text.size() < kLongest && !taken_.contains(*file)) {
                std::string why;
                const std::optional<std::string> inner = read_named_text(file->string(), kIncludes, why);
                if (!inner) {
                    made.text += line;
                    continue;
                }
                ++made.count;
                add(*file, *inner, depth + 1);
                made.text += "\n";
            }
        }
    }

    Included made{};

private:
    std::optional<fs::path> find(const fs::path& from, std::string_view name) const {
        std::vector<fs::path> places = {from.parent_path()};
        places.insert(places.end(), folders_.begin(), folders_.end());
        std::error_code ignored;
        for (const fs::path& each : places)
            if (is_on_disk((each / name).string())) return fs::weakly_canonical(each / name, ignored);
        return {};
    }

    std::span<const std::string> folders_;
    std::set<fs::path> taken_{};
};

}  // namespace

Included with_includes(const std::string& path, const std::string& text, std::span<const std::string> folders) {
    Expander expander(folders);
    expander.add(path, text, 0);
    return std::move(expander.made);
}

}  // namespace patina::importers::shadergraph
