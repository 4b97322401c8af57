#include "compiler/importers/gltf/gltf_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>

#include "compiler/base/disk/disk.h"
#include "compiler/importers/gltf/gltf_object.h"

namespace patina::importers::gltf {
namespace {

namespace fs = std::filesystem;

// The JSON of either form; empty if the file or its first chunk is cut off.
std::string json_of(const std::string& path, bool& is_binary) {
    constexpr std::size_t kHeaders = 20;
    const DiskFile head = read_beginning(path, kHeaders);
    if (!head.bytes) return {};
    is_binary = head.bytes->starts_with("glTF");
    std::uint64_t size = head.size, before = 0;
    if (is_binary) {
        if (head.bytes->size() < kHeaders) return {};
        before = kHeaders;
        size = 0;
        for (std::size_t i = 0; i < 4; ++i)
            size |= std::uint64_t{static_cast<unsigned char>((*head.bytes)[12 + i])} << (8 * i);
        if (size > head.size - kHeaders) return {};
    }
    // One byte more than the parser takes: it says that there are too many.
    DiskFile file = read_beginning(path, static_cast<std::size_t>(before + std::min(size, kMostTextBytes + 1)));
    if (!file.bytes || file.bytes->size() < before) return {};
    std::string text = std::move(*file.bytes);
    text.erase(0, static_cast<std::size_t>(before));
    // A glb's text is padded with spaces, by some programs with zeros.
    while (!text.empty() && text.back() == '\0') text.pop_back();
    return text;
}

// The deepest part of the way "meshes[0].primitives[1].mode" that the file has; null if it has none of it.
const Json* deepest(const Json& root, std::string_view way) {
    const Json* at = &root;
    const Json* found = nullptr;
    while (!way.empty() && at) {
        if (way.front() == '[') {
            std::size_t index = 0;
            const auto [end, error] = std::from_chars(way.data() + 1, way.data() + way.size(), index);
            if (error != std::errc() || at->kind != Json::Kind::Array) return found;
            at = index < at->elements.size() ? &at->elements[index] : nullptr;
            way.remove_prefix(std::min<std::size_t>(static_cast<std::size_t>(end - way.data()) + 1, way.size()));
        } else {
            if (way.front() == '.') way.remove_prefix(1);
            const std::string_view key = way.substr(0, way.find_first_of(".["));
            at = at->kind == Json::Kind::Object ? at->find(key) : nullptr;
            way.remove_prefix(key.size());
        }
        if (at) found = at;
    }
    return found;
}

std::string with_line(const GltfText& text, const std::string& path, const Json* at, const std::string& mistake) {
    if (text.is_binary || !at) return path + ": " + mistake;
    const Position position = text.sources.resolve(at->span.begin);
    return fmt::format("{}:{}:{}: {}", path, position.line, position.column, mistake);
}

constexpr std::array kLists = {"accessors", "animations", "buffers",  "bufferViews", "cameras", "images",  "materials",
                               "meshes",    "nodes",      "samplers", "scenes",      "skins",   "textures"};
constexpr std::array kTypes = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};

// The bytes that a base64 text stands for.
std::size_t bytes_of_base64(std::string_view text) {
    while (!text.empty() && text.back() == '=') text.remove_suffix(1);
    return text.size() * 3 / 4;
}

// What is wrong with one element of a list; empty: nothing. `key`: the member that is wrong.
std::string element_mistake(std::string_view list, const Json& element, std::string_view folder, std::string& key) {
    const auto member = [&](std::string_view name) {
        key = name;
        return element.find(name);
    };
    if (list == "accessors") {
        if (const Json* type = member("type");
            type &&
            (type->kind != Json::Kind::String || std::find(kTypes.begin(), kTypes.end(), type->string) == kTypes.end()))
            return "there is no such type; it is one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 and MAT4";
        if (const Json* count = member("count"); count && (count->kind != Json::Kind::Number || !(count->number >= 1)))
            return "an accessor has at least one element";
    }
    if (list == "buffers") {
        const Json* length = element.find("byteLength");
        const Json* uri = member("uri");
        if (uri && uri->kind == Json::Kind::String && uri->string.starts_with("data:")) {
            const std::size_t comma = uri->string.find(";base64,");
            if (comma == std::string::npos) return "a data URI of a buffer is base64: 'data:...;base64,...'";
            const std::size_t held = bytes_of_base64(std::string_view(uri->string).substr(comma + 8));
            if (length && length->kind == Json::Kind::Number && length->number > static_cast<double>(held)) {
                key = "byteLength";
                return fmt::format("the buffer shall have {:.0f} bytes, and its data URI holds {}", length->number,
                                   held);
            }
        } else if (uri && uri->kind == Json::Kind::String) {
            const DiskFile held = look_on_disk((fs::path(folder) / uri->string).string());
            if (uri->string.find("%") == std::string::npos && !held.bytes)
                return fmt::format("the file '{}' cannot be read", json::shown(uri->string));
            if (held.bytes && length && length->kind == Json::Kind::Number &&
                length->number > static_cast<double>(held.size)) {
                key = "byteLength";
                return fmt::format("the buffer shall have {:.0f} bytes, and the file '{}' has fewer", length->number,
                                   json::shown(uri->string));
            }
        }
    }
    return {};
}

}  // namespace

GltfText read_gltf_text(const std::string& path) {
    GltfText made;
    std::string json = json_of(path, made.is_binary);
    const std::size_t first_letter = json.find_first_not_of(" \t\r\n");
    made.looks_like_json = !made.is_binary && first_letter != json.npos && json[first_letter] == '{';
    const std::uint32_t begin = made.sources.add(path, std::move(json));
    Diagnostics diagnostics;
    made.root = json::parse_json(made.sources, begin, diagnostics, json::JsonOf::OtherProgram);
    if (made.root && !diagnostics.has_errors()) return made;
    made.root = nullptr;
    if (!diagnostics.records().empty()) {
        const DiagnosticRecord& first = diagnostics.records().front();
        const Position at = made.sources.resolve(first.span.begin);
        made.error = fmt::format("{}:{}:{}: {}", path, at.line, at.column, first.message);
    }
    return made;
}

std::string shape_mistake(const GltfText& text, const std::string& path) {
    const Json& root = *text.root;
    if (root.kind != Json::Kind::Object)
        return with_line(text, path, &root, fmt::format("a glTF file is an object, not {}", describe(root.kind)));
    if (const Json* asset = root.find("asset"); !asset || asset->kind != Json::Kind::Object)
        return with_line(text, path, asset ? asset : &root,
                         "asset: a glTF file states its version in this object: \"asset\": { \"version\": \"2.0\" }");
    const std::string folder = fs::path(path).parent_path().string();
    for (const std::string_view list : kLists) {
        const Json* found = root.find(list);
        if (!found) continue;
        if (found->kind != Json::Kind::Array)
            return with_line(text, path, found, fmt::format("{}: is {}, not a list", list, describe(found->kind)));
        for (std::size_t i = 0; i < found->elements.size(); ++i) {
            const Json& element = found->elements[i];
            std::string key;
            if (element.kind != Json::Kind::Object)
                return with_line(text, path, &element,
                                 fmt::format("{}[{}]: is {}, not an object", list, i, describe(element.kind)));
            if (const std::string what = element_mistake(list, element, folder, key); !what.empty())
                return with_line(text, path, element.find(key), fmt::format("{}[{}].{}: {}", list, i, key, what));
        }
    }
    return {};
}

std::string located_mistake(const std::string& path, const std::string& error) {
    const std::string start = path + ": ";
    if (error.starts_with(start + "byte ")) return error;  // the container itself is broken
    const GltfText text = read_gltf_text(path);
    if (!text.root) return text.looks_like_json && !text.error.empty() ? text.error : error;
    if (std::string shape = shape_mistake(text, path); !shape.empty()) return shape;
    if (!error.starts_with(start)) return error;
    const std::string mistake = error.substr(start.size());
    const Json* at = deepest(*text.root, std::string_view(mistake).substr(0, mistake.find(": ")));
    return with_line(text, path, at, mistake);
}

}  // namespace patina::importers::gltf
