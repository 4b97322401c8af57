#include "compiler/cli/watch/changes.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/cli/files.h"
#include "patina/text_diff.h"

namespace patina::cli {
namespace {

using runtime::OutputFile;

constexpr std::size_t kMostLines = 12;  // of a file

const OutputFile* find(const Compiled& made, std::string_view path) {
    const auto& files = made.files.files;
    const auto found = std::ranges::find(files, path, &OutputFile::path);
    return found == files.end() ? nullptr : &*found;
}

const Shader* shader_of(const Compiled& made, std::string_view path) {
    const auto found = std::ranges::find_if(made.result.shaders, [&](const Shader& shader) {
        return path.ends_with(shader.file_name) &&
               (path.size() == shader.file_name.size() || path[path.size() - shader.file_name.size() - 1] == '/');
    });
    return found == made.result.shaders.end() ? nullptr : &*found;
}

std::optional<CostCounts> cost_of(const Compiled& made, const Shader& shader) {
    if (!made.costs || shader.target != Target::Glsl) return {};
    for (const MeasuredPass& pass : *made.costs) {
        if (pass.name == shader.pass)
            return (shader.stage == Stage::Vertex ? pass.cost.vertex : pass.cost.fragment).total();
    }
    return {};
}

// ", 212 -> 215 instructions, 3 -> 4 texture reads", or nothing if that is not known.
std::string cost_text(const Compiled& before, const Compiled& after, const Shader& shader) {
    const std::optional<CostCounts> was = cost_of(before, shader), is = cost_of(after, shader);
    if (!is) return {};
    const CostCounts old = was.value_or(*is);
    std::string text;
    // Instructions always, and what else is different.
    const auto add = [&](std::uint32_t before_it, std::uint32_t after_it, std::string_view what, bool always) {
        if (before_it != after_it)
            text += fmt::format(", {} -> {} {}", before_it, after_it, what);
        else if (always)
            text += fmt::format(", {} {}", after_it, what);
    };
    add(old.instructions, is->instructions, "instructions", true);
    add(old.transcendental, is->transcendental, "transcendental", false);
    add(old.textures, is->textures, "texture reads", false);
    add(old.derivatives, is->derivatives, "derivatives", false);
    return text;
}

void add_lines(const std::vector<DiffLine>& diff, std::vector<std::string>& lines) {
    std::size_t count = 0;
    for (const DiffLine& line : diff) {
        const bool is_added = line.kind == DiffLine::Kind::Added;
        if (!is_added && line.kind != DiffLine::Kind::Removed) continue;
        if (count++ < kMostLines)
            lines.push_back(fmt::format("  {:>5}  {}{}", is_added ? line.new_line : line.old_line, is_added ? '+' : '-',
                                        line.text));
    }
    if (count > kMostLines) lines.push_back(fmt::format("         {} more lines", count - kMostLines));
}

}  // namespace

std::vector<std::string> changes_of(const Compiled& before, const Compiled& after, const Target& shown) {
    std::vector<std::string> lines;
    for (const OutputFile& file : after.files.files) {
        const OutputFile* old = find(before, file.path);
        if (old && old->bytes == file.bytes) continue;
        const Shader* shader = shader_of(after, file.path);
        if (!old || !shader) {
            lines.push_back(file.path + (old ? "  differs" : "  is new"));
            continue;
        }
        const std::vector<DiffLine> diff = differences(old->bytes, file.bytes);
        const auto count = [&](DiffLine::Kind kind) { return std::ranges::count(diff, kind, &DiffLine::kind); };
        lines.push_back(fmt::format("{}  +{} -{}{}", file.path, count(DiffLine::Kind::Added),
                                    count(DiffLine::Kind::Removed), cost_text(before, after, *shader)));
        if (shader->target == shown) add_lines(diff, lines);
    }
    for (const OutputFile& file : before.files.files)
        if (!find(after, file.path)) lines.push_back(file.path + "  is not made any more");
    return lines;
}

}  // namespace patina::cli
