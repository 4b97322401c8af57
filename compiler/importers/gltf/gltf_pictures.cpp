#include "compiler/importers/gltf/gltf_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "runtime/gltf/gltf_file.h"
#include "runtime/picture/formats/picture_kind.h"

namespace patina::importers::gltf {
namespace {

namespace fs = std::filesystem;

// Numbers of samplers, as OpenGL has them.
constexpr int kNearest = 9728, kRepeat = 10497, kClamp = 33071, kMirror = 33648;

std::string_view wrap_word(int wrap) {
    return wrap == kClamp ? "clamp" : wrap == kMirror ? "mirror" : "repeat";
}

// "a%20b.png" names "a b.png".
std::string decoded(std::string_view uri) {
    std::string made;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool is_coded = uri[i] == '%' && i + 2 < uri.size() &&
                              std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                              std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
        made += is_coded ? static_cast<char>(std::stoi(std::string(uri.substr(i + 1, 2)), nullptr, 16)) : uri[i];
        if (is_coded) i += 2;
    }
    return made;
}

// Why a picture of a model cannot be read, or nothing. Its pixels are not decoded: that would take longer than all else
// of an import.
std::string fault_of(std::string_view bytes) {
    constexpr std::array<std::string_view, 3> kOfModels = {"PNG", "JPEG", "WebP"};
    const runtime::PictureKind* const kind = runtime::picture_kind(bytes);
    if (bytes.empty()) return "has no bytes";
    if (!kind || std::find(kOfModels.begin(), kOfModels.end(), kind->name) == kOfModels.end())
        return "is neither a PNG nor a JPEG file: convert it";
    const std::string_view damage = runtime::damage_of(*kind, bytes);
    return damage.empty() ? "" : fmt::format("is a {} file {}", kind->name, damage);
}

// "image/png": the kinds of models have their own names there, in small letters.
std::string mime_type(const runtime::PictureKind& kind) {
    std::string type = "image/" + std::string(kind.name);
    std::transform(type.begin(), type.end(), type.begin(), [](unsigned char c) { return std::tolower(c); });
    return type;
}

}  // namespace

Object element(const Context& context, std::string_view list, std::size_t index) {
    const Json* all = context.root.find(list);
    const bool is_there = all && all->kind == Json::Kind::Array && index < all->elements.size();
    return {context.report, is_there ? &all->elements[index] : nullptr, fmt::format("{}[{}]", list, index)};
}

std::size_t count_of(const Context& context, std::string_view list) {
    const Json* all = context.root.find(list);
    return all ? all->elements.size() : 0;
}

std::string reference_to(const Context& context, const std::string& file) {
    const fs::path to = fs::absolute(file).lexically_normal();
    const fs::path from = fs::absolute(context.folder.empty() ? "." : context.folder).lexically_normal();
    std::string name = (to.parent_path().lexically_relative(from) / to.filename()).generic_string();
    return name.starts_with("../") || name.starts_with("./") ? name : "./" + name;
}

std::string file_name(std::string_view name, std::string_view otherwise, OwnNames& taken) {
    constexpr std::size_t kLongest = 80;
    std::string made;
    for (const char letter : name.empty() ? otherwise : name) {
        const auto byte = static_cast<unsigned char>(letter);
        const bool is_plain = std::isalnum(byte) || byte >= 0x80 || letter == '-' || letter == '.';
        // Not in the middle of a letter: the bytes that follow its first are 0x80 to 0xbf.
        if (made.size() >= kLongest && (byte & 0xc0) != 0x80) break;
        if (is_plain || (!made.empty() && made.back() != '_')) made += is_plain ? letter : '_';
    }
    while (!made.empty() && (made.front() == '.' || made.front() == '-')) made.erase(0, 1);
    while (!made.empty() && (made.back() == '.' || made.back() == '_')) made.pop_back();
    if (made.empty()) made = otherwise;
    return taken.own(made);
}

const TextureFile& Pictures::texture(std::size_t index, const std::string& name) {
    const auto [found, is_new] = textures_.try_emplace(index);
    if (!is_new) return found->second;
    Object texture = element(context_, "textures", index);
    if (const std::optional<std::size_t> image = picture_of(texture)) {
        found->second.file = file_of(*image, name);
        texture.taken("source", fmt::format("the file {}", found->second.file));
    }
    if (const auto sampler = texture.index("sampler", "samplers", count_of(context_, "samplers"))) {
        found->second.sampler = sampler_of(*sampler);
        texture.taken("sampler", "the property's \"sampler\"");
    }
    texture.taken("name", "not needed: graphs name the file");
    texture.rest();
    return found->second;
}

// A texture may have a picture in a newer format, and one that every program reads.
std::optional<std::size_t> Pictures::picture_of(Object& texture) {
    const std::size_t count = count_of(context_, "images");
    const auto plain = texture.index("source", "images", count);
    Object webp = texture.extension("EXT_texture_webp");
    const auto other = webp.index("source", "images", count);
    if (plain || !other) {
        webp.left_out("source", "the picture in 'source' is used");
        if (!plain) {
            context_.report.add(Remark::Kind::LeftOut, texture.path(), "it has no picture in a format that is read",
                                texture.json());
        }
        return plain;
    }
    webp.taken("source", "the picture of the texture");
    return other;
}

GraphMembers Pictures::sampler_of(std::size_t index) {
    const auto [found, is_new] = samplers_.try_emplace(index);
    if (!is_new) return found->second;
    Object sampler = element(context_, "samplers", index);
    if (sampler && sampler.json()->members.empty())
        context_.report.add(Remark::Kind::Taken, sampler.path(), "the default of a property", sampler.json());
    const auto word_of = [&](std::string_view key, double otherwise) {
        return static_cast<int>(sampler.number(key, 0, 1e6).value_or(otherwise));
    };
    const int s = word_of("wrapS", kRepeat), t = word_of("wrapT", kRepeat);
    if (s != kRepeat) found->second.push_back({"wrap", wrap_word(s)});
    sampler.taken("wrapS", fmt::format("\"wrap\": \"{}\"", wrap_word(s)));
    if (s == t)
        sampler.taken("wrapT", fmt::format("\"wrap\": \"{}\"", wrap_word(s)));
    else if (sampler.has("wrapT"))
        sampler.changed("wrapT", fmt::format("\"wrap\": \"{}\", as along u: a sampler has one word", wrap_word(s)));
    else
        sampler.changed("wrapS", fmt::format("\"wrap\": \"{}\" along v too: a sampler has one word", wrap_word(s)));
    const int large = word_of("magFilter", 0), small = word_of("minFilter", 0);
    const bool is_nearest = large == kNearest;
    if (is_nearest) found->second.push_back({"filter", "nearest"});
    const std::string filter = is_nearest ? "\"filter\": \"nearest\"" : "\"filter\": \"linear\", the default";
    sampler.taken("magFilter", filter);
    // 9984 and 9986 take the nearest texel; 9987 is linear between texels and levels.
    const bool is_same = is_nearest ? small == 9984 : small == 9987;
    if (is_same || small == 0)
        sampler.taken("minFilter", filter);
    else
        sampler.changed("minFilter", filter + ", and mip levels: a sampler has one word for both sizes");
    sampler.taken("name", "not needed: a sampler has no name");
    sampler.rest();
    return found->second;
}

std::string Pictures::file_of(std::size_t index, const std::string& name) {
    const auto [found, is_new] = files_.try_emplace(index);
    if (!is_new) return found->second;
    Object image = element(context_, "images", index);
    const tinygltf::Image& known = context_.file.images[index];
    const std::string_view bytes = runtime::picture_bytes(context_.file, index);
    const bool is_file = known.bufferView < 0 && !known.uri.empty();
    const std::string uri = is_file ? decoded(known.uri) : std::string();
    if (is_file && bytes.empty()) {
        context_.report.wrong(image.path() + ".uri", fmt::format("the file '{}' cannot be read", uri), image.json());
        return {};
    }
    if (const std::string fault = fault_of(bytes); !fault.empty()) {
        context_.report.wrong(image.path() + (is_file ? " ('" + uri + "')" : ""), fault, image.json());
        return {};
    }
    if (is_file) {
        found->second = reference_to(context_, (fs::path(context_.path).parent_path() / uri).string());
        image.taken("uri", fmt::format("the file {}, where it is", found->second));
    } else {
        const std::string file = file_name(known.name, name, names_).append(runtime::picture_kind(bytes)->endings[0]);
        copies.push_back({.name = file, .bytes = std::string(bytes)});
        found->second = "./" + file;
        image.taken(known.bufferView < 0 ? "uri" : "bufferView", fmt::format("the file {}", file));
    }
    const runtime::PictureKind& kind = *runtime::picture_kind(bytes);
    const std::string stated = image.word("mimeType").value_or(""), held = mime_type(kind);
    if (!stated.empty() && stated != held)
        image.changed("mimeType", fmt::format("'{}' is wrong: the bytes are a {} file, '{}'", json::shown(stated),
                                              kind.name, held));
    image.taken("mimeType", "the ending of the file");
    image.taken("name", fmt::format("the file {}", found->second));
    image.rest();
    return found->second;
}

}  // namespace patina::importers::gltf
