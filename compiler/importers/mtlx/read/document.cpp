#include "compiler/importers/mtlx/read/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <pugixml.hpp>
#include <set>

#include "compiler/base/disk/disk.h"
#include "compiler/base/text.h"
#include "compiler/importers/source_text.h"

namespace patina::importers::mtlx {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDocuments[] = {".mtlx"};
constexpr std::size_t kMostElements = 200000, kDeepest = 32, kMostFiles = 200;
constexpr double kNewest = 1.39;

struct Place {
    int line = 0, column = 0;
};

class Reader {
public:
    Reader(const std::vector<std::string>& folders, Document& document) : folders_(folders), document_(document) {}

    // Adds the file's elements to the root.
    std::string read(const fs::path& path, bool is_main) {
        std::error_code wrong;
        const std::string key = fs::weakly_canonical(path, wrong).string();
        if (!seen_.insert(key).second) return {};
        if (seen_.size() > kMostFiles)
            return fmt::format("{}: it includes more than {} files", path.string(), kMostFiles);
        std::string why;
        const std::optional<std::string> read =
            is_main ? read_text(path.string(), why) : read_named_text(path.string(), kDocuments, why);
        if (!read) return why;
        const std::string& text = *read;
        if (text.empty()) return fmt::format("{}: the file is empty", path.string());
        const std::vector<std::size_t> lines = line_starts(text);
        std::size_t bad = 0;
        if (!is_utf8(text, bad)) return located(path, place_of(lines, bad), "this byte is not UTF-8");

        pugi::xml_document xml;
        const pugi::xml_parse_result parsed =
            xml.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
        if (!parsed) return located(path, place_of(lines, static_cast<std::size_t>(parsed.offset)), message_of(parsed));
        const pugi::xml_node root = xml.document_element();
        if (std::string_view(root.name()) != "materialx")
            return located(
                path, place_of(lines, static_cast<std::size_t>(std::max<std::ptrdiff_t>(root.offset_debug(), 1) - 1)),
                fmt::format("the outermost element is '{}': a MaterialX document begins with 'materialx'",
                            shown(root.name())));
        File from{.path = path, .lines = lines, .is_main = is_main};
        Element top;
        if (std::string error = take(root, from, Element{.folder = path.parent_path().string()}, 0, top);
            !error.empty())
            return error;
        if (is_main) {
            document_.root.attributes = top.attributes;
            document_.root.category = top.category;
            document_.root.colorspace = top.colorspace;
            document_.root.line = top.line;
            document_.root.column = top.column;
            if (const auto version = read_number(top.attribute("version"))) document_.version = *version;
            if (document_.version > kNewest + 0.0001 || document_.version < 0)
                document_.problems.push_back(
                    {"version",
                     fmt::format("it is {}, and this importer knows 1.36 to 1.39", shown(top.attribute("version"))),
                     false, top.line, top.column});
        }
        for (Element& each : top.children) document_.root.children.push_back(std::move(each));
        return {};
    }

private:
    struct File {
        fs::path path;
        const std::vector<std::size_t>& lines;
        bool is_main;
    };

    static std::vector<std::size_t> line_starts(std::string_view text) {
        std::vector<std::size_t> made = {0};
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') made.push_back(i + 1);
        return made;
    }
    static Place place_of(const std::vector<std::size_t>& lines, std::size_t offset) {
        const auto line = std::ranges::upper_bound(lines, offset) - lines.begin();
        return {static_cast<int>(line), static_cast<int>(offset - lines[static_cast<std::size_t>(line - 1)] + 1)};
    }
    static std::string located(const fs::path& path, Place place, std::string_view text) {
        return fmt::format("{}:{}:{}: {}", path.string(), place.line, place.column, text);
    }
    static std::string shown(std::string_view text) { return std::string(text.substr(0, 60)); }

    static std::string_view message_of(const pugi::xml_parse_result& parsed) {
        switch (parsed.status) {
            case pugi::status_end_element_mismatch:
                return "this end tag is not that of the open element: is the file cut off?";
            case pugi::status_no_document_element: return "the file has no element: it is no XML";
            case pugi::status_bad_attribute: return "this attribute is broken: write name=\"value\"";
            case pugi::status_bad_start_element:
            case pugi::status_unrecognized_tag: return "this tag is broken";
            case pugi::status_bad_end_element: return "this end tag is broken";
            case pugi::status_bad_doctype: return "this document type declaration is broken";
            case pugi::status_bad_comment: return "this comment has no end";
            case pugi::status_bad_cdata: return "this CDATA section has no end";
            case pugi::status_bad_pcdata: return "this text is broken";
            case pugi::status_bad_pi: return "this processing instruction is broken";
            case pugi::status_out_of_memory: return "there is not enough memory to read it";
            case pugi::status_ok:
            case pugi::status_file_not_found:
            case pugi::status_io_error:
            case pugi::status_internal_error:
            case pugi::status_append_invalid_root: break;
        }
        return "this is no XML";
    }

    std::string take(pugi::xml_node node, const File& from, const Element& around, std::size_t depth, Element& made) {
        const Place place =
            place_of(from.lines, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 1) - 1));
        if (depth > kDeepest)
            return located(from.path, place, fmt::format("elements are nested more than {} deep", kDeepest));
        if (++elements_ > kMostElements)
            return located(from.path, place, fmt::format("there are more than {} elements", kMostElements));
        made.category = node.name();
        if (from.is_main) {
            made.line = place.line;
            made.column = place.column;
        }
        made.colorspace = around.colorspace;
        made.fileprefix = around.fileprefix;
        made.folder = around.folder;
        for (const pugi::xml_attribute each : node.attributes()) {
            if (made.has(each.name()))
                return located(from.path, place,
                               fmt::format("'{}' has two attributes '{}'", shown(node.name()), shown(each.name())));
            made.attributes.push_back({each.name(), each.value()});
        }
        // Version 1.39 may say <node nodetype="mix"> for <mix>.
        if (made.category == "node" && made.has("nodetype")) made.category = made.attribute("nodetype");
        if (made.has("colorspace")) made.colorspace = made.attribute("colorspace");
        if (made.has("fileprefix")) made.fileprefix += made.attribute("fileprefix");
        std::set<std::string> names;
        for (const pugi::xml_node each : node.children()) {
            if (each.type() != pugi::node_element) continue;
            if (std::string_view(each.name()) == "xi:include") {
                if (std::string error = include(each, from); !error.empty()) return error;
                continue;
            }
            Element child;
            if (std::string error = take(each, from, made, depth + 1, child); !error.empty()) return error;
            // Names are those of a scope, whatever the elements are.
            if (!child.name().empty() && !names.insert(std::string(child.name())).second)
                document_.problems.push_back({fmt::format("'{}'", shown(child.name())),
                                              "a second element has this name: the first one counts", true, child.line,
                                              child.column});
            else
                made.children.push_back(std::move(child));
        }
        return {};
    }

    std::string include(pugi::xml_node node, const File& from) {
        const std::string name = node.attribute("href").value();
        const Place place =
            place_of(from.lines, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 1) - 1));
        std::vector<fs::path> candidates = {from.path.parent_path() / name};
        for (const std::string& folder : folders_) candidates.push_back(fs::path(folder) / name);
        for (const fs::path& each : candidates) {
            if (!name.empty() && is_on_disk(each.string())) return read(each, false);
        }
        // What the standard library declares is known.
        const bool is_standard =
            name.find("stdlib") != name.npos || name.find("pbrlib") != name.npos || name.find("bxdf") != name.npos ||
            fs::path(name).filename() == "standard_surface.mtlx" || name.find("libraries/") != name.npos;
        if (!is_standard)
            document_.problems.push_back({fmt::format("include '{}'", shown(name)),
                                          "the file is not there: what it defines is missing", true,
                                          from.is_main ? place.line : 0, from.is_main ? place.column : 0});
        return {};
    }

    const std::vector<std::string>& folders_;
    Document& document_;
    std::set<std::string> seen_{};
    std::size_t elements_ = 0;
};

// A name of a file has a token's text for "[token]": that of the nearest element around.
void put_tokens(Element& element, std::vector<Element*>& around) {
    if (element.type() == "filename")
        for (auto& [key, text] : element.attributes) {
            if (key != "value") continue;
            for (auto scope = around.rbegin(); scope != around.rend(); ++scope)
                for (Element& token : (*scope)->children) {
                    if (token.category != "token" || token.name().empty()) continue;
                    const std::string written = fmt::format("[{}]", token.name());
                    const std::string meant(token.attribute("value"));
                    for (std::size_t at = text.find(written); at != text.npos;
                         at = text.find(written, at + meant.size())) {
                        text.replace(at, written.size(), meant);
                        token.is_in_names = true;
                    }
                }
        }
    around.push_back(&element);
    for (Element& each : element.children) put_tokens(each, around);
    around.pop_back();
}

}  // namespace

std::string_view Element::attribute(std::string_view name) const {
    const auto found =
        std::ranges::find(attributes, name, [](const auto& each) -> std::string_view { return each.first; });
    return found == attributes.end() ? std::string_view() : found->second;
}

bool Element::has(std::string_view name) const {
    return std::ranges::any_of(attributes, [&](const auto& each) { return each.first == name; });
}

const Element* Element::child(std::string_view wanted, std::string_view name) const {
    const auto found = std::ranges::find_if(children, [&](const Element& each) {
        return (wanted.empty() || each.category == wanted) && each.name() == name;
    });
    return found == children.end() ? nullptr : &*found;
}

std::string read_document(const std::string& path, const std::vector<std::string>& folders, Document& document) {
    std::string error = Reader(folders, document).read(path, true);
    std::vector<Element*> around;
    if (error.empty()) put_tokens(document.root, around);
    return error;
}

}  // namespace patina::importers::mtlx
