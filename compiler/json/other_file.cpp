#include "compiler/json/other_file.h"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

namespace patina::json {
namespace {

// The first whose ending fits. {} in a note is the file's name as a graph writes it.
struct OtherFile {
    std::string_view ending, what;
    std::array<std::string_view, 2> notes;
};
constexpr std::string_view kWritten = "'patina compile' makes shaders of graphs; it reads none";
constexpr std::string_view kImported = "'patina import' makes a graph of it";
constexpr OtherFile kOthers[] = {
    {".pass.hlsl", "a file of passes", {"it draws a graph with the option --path {}", "'patina check' checks it"}},
    {".frag.hlsl", "a shader", {kWritten}},
    {".vert.hlsl", "a shader", {kWritten}},
    {".hlsl", "a file of nodes", {"a graph uses it as a node: \"node\": \"{}\"", "'patina check' checks it"}},
    {".glsl", "a shader", {kWritten}},
    {".shader", "a shader", {kWritten}},
    {".mat", "a material of another program", {kImported}},
    {".shadergraph", "a shader graph of another program", {kImported}},
    {".shadersubgraph", "a shader graph of another program", {kImported}},
    {".gltf", "a model", {kImported}},
    {".mtlx", "a document of another program", {kImported}},
};

}  // namespace

bool report_other_file(std::string_view file, std::uint32_t base, Diagnostics& diagnostics) {
    for (const OtherFile& other : kOthers) {
        if (!file.ends_with(other.ending)) continue;
        const std::string own = fmt::format("{}{}", file.starts_with('/') || file.starts_with('.') ? "" : "./", file);
        DiagnosticRecord& record = diagnostics.report(Code::WrongJsonType, {base, base}, fmt::format("'{}'", file),
                                                      "a graph or a scene, which are JSON", other.what);
        for (const std::string_view note : other.notes) {
            if (!note.empty()) record.note(fmt::format(fmt::runtime(note), own));
        }
        return true;
    }
    return false;
}

std::string_view binary_kind(std::string_view bytes) {
    using namespace std::string_view_literals;
    constexpr std::pair<std::string_view, std::string_view> kKinds[] = {
        {"glTF"sv, "it is a glTF model: 'patina import' makes graphs of it, and --mesh draws a graph on it"sv},
        {"\x89PNG"sv, "it is a picture (PNG), not a graph: a graph names it at the port of a texture"sv},
        {"\xff\xd8\xff"sv, "it is a picture (JPEG), not a graph: a graph names it at the port of a texture"sv},
        {"v/1\x01"sv, "it is a picture (EXR), not a graph: a graph names it at the port of a texture"sv},
        {"\x03\x02\x23\x07"sv, "it is SPIR-V, not a graph"sv},
        {"\xff\xfe"sv, "it is UTF-16: save it as UTF-8"sv},
        {"\xfe\xff"sv, "it is UTF-16: save it as UTF-8"sv},
    };
    for (const auto& [start, kind] : kKinds) {
        if (bytes.starts_with(start)) return kind;
    }
    return {};
}

}  // namespace patina::json
