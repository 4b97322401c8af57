#include "compiler/importers/merl/merl_importer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/importers/imported_graph.h"
#include "runtime/lighting/merl.h"

namespace patina::importers {
namespace {

// A table has no mark of its own: it begins with three counts, of which none is known beforehand.
bool recognises(const Source& source) {
    return source.path.ends_with(".binary");
}

// What is measured as less than nothing is noise, or a direction that nobody could measure.
std::size_t negative_entries(const runtime::MerlTable& table) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < table.entries(); ++i) {
        count += std::any_of(table.channels.begin(), table.channels.end(),
                             [&](const std::vector<double>& channel) { return channel[i] < 0; });
    }
    return count;
}

Imported read(const Source& source, const Options& options) {
    const runtime::Outcome<runtime::MerlTable> table = runtime::read_merl(source.path);
    if (!table) return {.error = table.error};
    const std::string name = options.name.empty() ? std::filesystem::path(source.path).stem().string() : options.name;
    ImportedGraph graph(name);
    graph.workflow = "metallic-roughness";
    graph.lighting = "merl";
    graph.lighting_inputs.push_back({"_Table", "./" + name + ".exr"});
    const std::string json = graph.text();
    if (json.empty()) return {.error = fmt::format("'{}' cannot be the name of a graph: rename the file", name)};

    Imported made;
    made.graphs.push_back({.name = name + ".graph.json", .text = json});
    made.pictures.push_back({.name = name + ".exr", .linear = runtime::as_texture(table.value)});
    const runtime::MerlTable& angles = table.value;
    made.remarks.push_back({.kind = Remark::Kind::Taken,
                            .part = fmt::format("{} x {} x {} angles", angles.half, angles.difference, angles.azimuth),
                            .text = fmt::format("the texture {}.exr", name)});
    if (const std::size_t count = negative_entries(angles); count > 0) {
        made.remarks.push_back({.kind = Remark::Kind::Changed,
                                .part = fmt::format("{} of {} entries", count, angles.entries()),
                                .text = "0, because a measured value is negative"});
    }
    return made;
}

}  // namespace

Importer merl_importer() {
    return {.name = "merl",
            .reads = "measured BRDFs in the form of the MERL database (.binary)",
            .example = "patina import gold-paint.binary          # gold-paint.exr and gold-paint.graph.json next to it",
            .makes_pictures = true,
            .recognises = recognises,
            .read = read};
}

}  // namespace patina::importers
