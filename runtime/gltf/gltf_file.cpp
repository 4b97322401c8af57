#include "runtime/gltf/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>

#include "compiler/base/disk/disk.h"
#include "runtime/files/bytes.h"
#include "runtime/files/files.h"
#include "runtime/gltf/gltf_draco.h"

namespace patina::runtime {
namespace {

namespace fs = std::filesystem;

// Of a file and of all buffers that it names, together. The container's own limit for a .glb is 4 GB; a file of that
// size takes several times as much memory.
constexpr std::uint64_t kMostBytes = std::uint64_t{2} << 30;

// A .glb begins with 12 bytes: its mark, its version and its size. Each chunk begins with its size and its kind.
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::string_view text_of(const std::vector<unsigned char>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool has_header_of_glb(const Bytes& bytes) {
    return bytes.has(0, kHeader) && bytes.says(0, "glTF");
}

// The text of a .glb: its first chunk.
std::optional<std::string_view> text_chunk(const Bytes& bytes) {
    const auto size = bytes.little_endian(kHeader, 4);
    return size && bytes.says(kHeader + 4, "JSON") ? bytes.part(kHeader + kChunkHeader, *size) : std::nullopt;
}

// The container with another text in its first chunk, which is padded to four bytes.
std::vector<unsigned char> with_text(std::string_view glb, std::size_t old_size, std::string text) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string made(glb);
    made.replace(kHeader + kChunkHeader, old_size, text);
    const auto put = [&](std::size_t at, std::size_t number) {
        for (std::size_t i = 0; i < 4; ++i) made[at + i] = static_cast<char>(number >> (8 * i));
    };
    put(8, made.size());
    put(kHeader, text.size());
    return {made.begin(), made.end()};
}

// Both forms of a file, as tinygltf can read it (gltf_draco.h).
std::vector<unsigned char> readable(std::vector<unsigned char> bytes) {
    const Bytes all(text_of(bytes));
    if (!has_header_of_glb(all)) {
        const std::string text = without_draco_indices(text_of(bytes));
        return {text.begin(), text.end()};
    }
    const std::string_view text = text_chunk(all).value_or("");
    if (std::string changed = without_draco_indices(text); changed != text)
        return with_text(text_of(bytes), text.size(), std::move(changed));
    return bytes;
}

// Keeps pictures as in the file, not decoded: the code that needs one decodes it. A picture in a buffer stays there:
// its view has not been checked yet.
bool keep_picture(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes,
                  int size, void*) {
    if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

// tinygltf reads files through these, which do not expand "~".
bool exists(const std::string& path, void*) {
    return is_on_disk(path);
}
std::string same(const std::string& path, void*) {
    return path;
}
// `left`: the bytes that may still be read, a std::uint64_t.
bool read_whole(std::vector<unsigned char>* out, std::string* why, const std::string& path, void* left) {
    std::uint64_t& most = *static_cast<std::uint64_t*>(left);
    const DiskFile file = read_disk(path, most);
    if (!file.bytes) {
        *why += path + ": " + (file.why.empty() ? "it cannot be read" : file.why) + "\n";
        return false;
    }
    most -= file.bytes->size();
    out->assign(file.bytes->begin(), file.bytes->end());
    return true;
}

// What is wrong with the container of a .glb, and where; empty: nothing. (glTF 2.0, section 4.4.) `size`: of the file,
// whose first bytes these are.
std::string container_mistake(std::string_view start, std::uint64_t size) {
    const Bytes bytes(start);
    if (start.empty()) return "the file is empty";
    if (start.size() < kHeader && bytes.says(0, std::string_view("glTF").substr(0, start.size())))
        return fmt::format("the file has {} bytes, less than the header of a .glb: it is cut off", start.size());
    const auto first = static_cast<unsigned char>(start[0]);
    // White space, or the mark of UTF-8.
    const bool is_text = std::string_view("{[ \t\r\n\xef").find(static_cast<char>(first)) != std::string_view::npos;
    if (!has_header_of_glb(bytes))
        return is_text ? "" : "byte 0: it begins neither with 'glTF', as a .glb does, nor with '{', as a .gltf does";
    const std::uint64_t version = *bytes.little_endian(4, 4), stated = *bytes.little_endian(8, 4);
    if (version != 2) return fmt::format("byte 4: version {} of the container is not read, only 2", version);
    if (stated > size)
        return fmt::format("byte 8: the file shall have {} bytes, and has {}: it is cut off", stated, size);
    if (stated < kHeader + kChunkHeader) return fmt::format("byte 8: {} bytes hold no chunk", stated);
    if (!bytes.says(kHeader + 4, "JSON")) return "byte 16: the first chunk is not JSON";
    // tinygltf forgets the header of the second chunk when it compares sizes.
    for (std::uint64_t at = kHeader; at + kChunkHeader <= stated && bytes.has(at, kChunkHeader);) {
        const std::uint64_t held = *bytes.little_endian(at, 4), left = stated - at - kChunkHeader;
        if (held > left)
            return fmt::format("byte {}: the {} chunk shall have {} bytes, and {} are left", at,
                               at == kHeader ? "first" : "next", held, left);
        at += kChunkHeader + held;
    }
    return {};
}

// The JSON parser's message with its place before it: ":4:7: it is broken JSON: unexpected ']'"; empty: it names none.
std::string located(const std::string& why) {
    int line = 0, column = 0;
    const std::size_t at = why.find("at line ");
    if (at == why.npos || std::sscanf(why.c_str() + at, "at line %d, column %d", &line, &column) != 2) return {};
    const std::size_t reason = why.find(" - ", at);
    return fmt::format(":{}:{}: it is broken JSON{}", line, column,
                       reason == why.npos ? "" : ": " + why.substr(reason + 3));
}

// The message, with the location, for a buffer that claims more bytes than the second chunk of a .glb has; empty for
// another message.
std::string short_chunk(const std::string& why) {
    double claimed = 0, held = 0;
    const std::size_t at = why.find("`byteLength' = ");
    if (at == why.npos || std::sscanf(why.c_str() + at, "`byteLength' = %lf, binary size = %lf", &claimed, &held) != 2)
        return {};
    return fmt::format("buffers[0].byteLength: the buffer shall have {:.0f} bytes, and the chunk BIN has {:.0f}",
                       claimed, held);
}

// The message, with the location, for a buffer whose file tinygltf refuses; empty for another message. The message has
// the size of the file, which may be any file of the machine, and a path instead of the URI.
std::string buffer_mistake(std::string_view why, std::string_view folder, std::size_t index) {
    struct Form {
        std::string_view begin, behind_file, what;
    };
    constexpr Form kForms[] = {
        {"File not found : ", "", "cannot be read"},
        {"File read error : ", " : ", "cannot be read"},
        {"File is empty : ", "", "is empty"},
        {"File size mismatch : ", ", requestedBytes ", "does not have as many bytes as 'byteLength' says"}};
    if (why.starts_with("'uri' is missing")) return fmt::format("buffers[{}]: names no file of its bytes", index);
    for (const Form& form : kForms) {
        if (!why.starts_with(form.begin)) continue;
        std::string_view file = why.substr(form.begin.size());
        if (!form.behind_file.empty()) file = file.substr(0, file.rfind(form.behind_file));
        if (!folder.empty() && file.starts_with(folder) && file.substr(folder.size()).starts_with('/'))
            file.remove_prefix(folder.size() + 1);
        return fmt::format("buffers[{}].uri: the file '{}' {}", index, file, form.what);
    }
    return {};
}

// tinygltf's messages are lines; some end in a full stop. Some quote a whole data URI.
std::string one_line(std::string text) {
    if (const std::size_t at = text.find(";base64,"); at != text.npos) text.resize(at + 8), text += "...";
    while (!text.empty() && (text.back() == '\n' || text.back() == '.' || text.back() == ' ')) text.pop_back();
    for (std::size_t at = text.find('\n'); at != text.npos; at = text.find('\n', at)) text.replace(at, 1, "; ");
    return text;
}

}  // namespace

std::string_view picture_bytes(const tinygltf::Model& model, std::size_t index) {
    const tinygltf::Image& image = model.images[index];
    if (image.bufferView < 0) return {reinterpret_cast<const char*>(image.image.data()), image.image.size()};
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(image.bufferView)];
    const std::vector<unsigned char>& buffer = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    return {reinterpret_cast<const char*>(buffer.data()) + view.byteOffset, view.byteLength};
}

Outcome<tinygltf::Model> open_gltf(const std::string& path) {
    std::vector<unsigned char> bytes;
    std::string why, warning;
    std::uint64_t left = kMostBytes;
    {
        // What is wrong with the first bytes is wrong with the file, however large that is.
        const DiskFile start = read_beginning(path, kHeader + kChunkHeader);
        if (!start.bytes) return Failure{no_file(path)};
        if (std::string mistake = container_mistake(*start.bytes, start.size); !mistake.empty())
            return Failure{path + ": " + mistake};
    }
    if (!read_whole(&bytes, &why, path, &left)) return Failure{"cannot read " + one_line(why)};
    if (std::string mistake = container_mistake(text_of(bytes), bytes.size()); !mistake.empty())
        return Failure{path + ": " + mistake};
    bytes = readable(std::move(bytes));
    tinygltf::TinyGLTF reader;
    reader.SetImageLoader(keep_picture, nullptr);
    reader.SetFsCallbacks({exists, same, read_whole, nullptr, &left});
    const std::string folder = fs::path(path).parent_path().string();
    tinygltf::Model model;
    bool is_read = false;
    try {
        is_read = has_header_of_glb(Bytes(text_of(bytes)))
                      ? reader.LoadBinaryFromMemory(&model, &why, &warning, bytes.data(),
                                                    static_cast<unsigned int>(bytes.size()), folder)
                      : reader.LoadASCIIFromString(&model, &why, &warning, reinterpret_cast<const char*>(bytes.data()),
                                                   static_cast<unsigned int>(bytes.size()), folder);
    } catch (const std::exception& error) {
        why = error.what();
    }
    if (!is_read) {
        why = one_line(why);
        // A buffer that can be read has been added to the list.
        if (const std::string mistake = buffer_mistake(why, folder, model.buffers.size()); !mistake.empty())
            return Failure{path + ": " + mistake};
        if (const std::string mistake = short_chunk(why); !mistake.empty()) return Failure{path + ": " + mistake};
        const bool is_glb = has_header_of_glb(Bytes(text_of(bytes)));
        // The parser's message quotes the text; a link may have this name and lead to any file.
        if (!is_glb && !without_links(path).ends_with(".gltf")) return Failure{path + ": it is broken JSON"};
        if (const std::string place = located(why); !place.empty() && !is_glb) return Failure{path + place};
        return Failure{path + " is not a glTF file that can be read: " + (why.empty() ? "it is broken" : why)};
    }
    if (std::string mistake = expand_draco(model); !mistake.empty()) return Failure{path + ": " + mistake};
    if (std::string mistake = mistake_in(model); !mistake.empty()) return Failure{path + ": " + mistake};
    return model;
}

}  // namespace patina::runtime
