// patina paths: the rendering paths of the library with their passes.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "compiler/base/text.h"
#include "compiler/cli/commands/commands.h"
#include "compiler/cli/pages/library_json.h"
#include "compiler/cli/pages/page.h"

namespace patina::cli {
namespace {

// "objects once, lights: all"
std::string summary(const PassInfo& pass) {
    const Pass& state = pass.state;
    std::string text = fmt::format("{} {}{}", to_string(state.draws), state.each == PassEach::Once ? "" : "for each ",
                                   to_string(state.each));
    if (state.lights != PassLights::None) text += fmt::format(", lights: {}", to_string(state.lights));
    if (state.camera != PassCamera::Any) text += fmt::format("; {} camera", to_string(state.camera));
    if (!state.fallback.empty()) text += fmt::format("; else the path {}", state.fallback);
    if (pass.is_optional) text += "; where it can";
    return text;
}

// "into color (rgba16f), depth"
std::string target_line(const PassInfo& pass) {
    std::string text = "into ";
    for (const RenderTarget& target : pass.state.targets)
        text += fmt::format("{} ({}), ", target.name, to_string(target.format));
    return text + pass.state.depth_target;
}

// "opaque and cutout: one, zero": surfaces with the same blending share a line.
std::vector<std::string> blend_lines(const PassInfo& pass) {
    std::vector<std::pair<std::string, std::vector<std::string_view>>> groups;
    for (const auto& [surface, blend] : pass.blends) {
        const bool is_alike = blend.source == blend.source_alpha && blend.destination == blend.destination_alpha;
        const std::string factors = fmt::format("{}, {}", to_string(blend.source), to_string(blend.destination)) +
                                    (is_alike ? ""
                                              : fmt::format("; alpha {}, {}", to_string(blend.source_alpha),
                                                            to_string(blend.destination_alpha)));
        auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == factors; });
        if (group == groups.end()) group = groups.insert(groups.end(), {factors, {}});
        group->second.push_back(surface ? to_string(*surface) : "every surface");
    }
    std::vector<std::string> lines;
    for (const auto& [factors, surfaces] : groups) lines.push_back(fmt::format("{}: {}", enumerate(surfaces), factors));
    return lines;
}

void print_path(const Console& console, const PathInfo& path) {
    print(heading(console, path.name) + "\n  " + first_sentence(path.doc) + "\n");
    std::size_t width = 0;
    for (const PassInfo& pass : path.passes) width = std::max(width, pass.state.name.size());
    for (const PassInfo& pass : path.passes) {
        print(fmt::format("  {:<{}}  {}\n", pass.state.name, width, summary(pass)));
        std::vector<std::string> lines = blend_lines(pass);
        lines.insert(lines.begin(), target_line(pass));
        for (const std::string& line : lines) print(fmt::format("  {:<{}}    {}\n", "", width, line));
    }
}

Exit list_paths(const Console& console, const std::string& name, bool json) {
    const Compiler compiler;
    std::vector<PathInfo> paths = compiler.paths();
    if (!name.empty()) {
        std::vector<std::string> known;
        for (const PathInfo& path : paths) known.push_back(path.name);
        std::erase_if(paths, [&](const PathInfo& path) { return path.name != name; });
        if (paths.empty()) {
            const std::string advice = suggestion(name, known);
            complain(console, Complaint::UnknownPath, {name, advice.empty() ? "'patina paths' lists them" : advice});
            return Exit::Wrong;
        }
    }
    if (json) {
        print(to_json(paths));
        return Exit::Ok;
    }
    for (const PathInfo& path : paths) {
        if (&path != &paths.front()) print("\n");
        print_path(console, path);
    }
    return Exit::Ok;
}

}  // namespace

void add_paths(Program& program) {
    CLI::App& command = add_command(program, "paths", {"patina paths", "patina paths deferred", "patina paths --json"});
    auto json = std::make_shared<bool>(false);
    auto name = std::make_shared<std::string>();
    command.add_option("PATH", *name, "Show only this path")->type_name(" ");
    command.add_flag("--json", *json, "Print everything about each path as JSON");
    set_work(program, command, [json, name](const Console& console) { return list_paths(console, *name, *json); });
}

}  // namespace patina::cli
