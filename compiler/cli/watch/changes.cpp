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

std::optional<std::size_t> instructions(const Version& version, const Shader& shader) {
    if (!version.costs || shader.target != Target::Glsl) return {};
    for (const runtime::PassCost& cost : *version.costs) {
        if (cost.pass == shader.pass) return (shader.stage == Stage::Vertex ? cost.vertex : cost.fragment).instructions;
    }
    return {};
}

// ", 212 -> 215 instructions", or nothing if that is not known.
std::string cost_text(const Version& before, const Version& after, const Shader& shader) {
    const std::optional<std::size_t> was = instructions(before, shader), is = instructions(after, shader);
    if (!is) return {};
    if (!was || *was == *is) return fmt::format(", {} instructions", *is);
    return fmt::format(", {} -> {} instructions", *was, *is);
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

void count_costs(Version& version) {
    if (version.made.ok && !version.costs) version.costs = runtime::costs(version.made.result);
}

std::vector<std::string> changes_of(const Version& before, const Version& after, const Target& shown) {
    std::vector<std::string> lines;
    for (const OutputFile& file : after.made.files.files) {
        const OutputFile* old = find(before.made, file.path);
        if (old && old->bytes == file.bytes) continue;
        const Shader* shader = shader_of(after.made, file.path);
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
    for (const OutputFile& file : before.made.files.files)
        if (!find(after.made, file.path)) lines.push_back(file.path + "  is not made any more");
    return lines;
}

}  // namespace patina::cli
