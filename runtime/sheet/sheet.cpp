#include "runtime/sheet/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "patina/graph_view.h"
#include "runtime/files/find_files.h"
#include "runtime/page/drawing.h"
#include "runtime/picture/image.h"
#include "runtime/picture/tone.h"
#include "runtime/render/prepare_material.h"
#include "runtime/render/render_jobs.h"

namespace patina::runtime {
namespace {

constexpr int kNodeSize = 96, kNodeSamples = 2;

// How a kind of file is shown. `whole` is the preview that stands for all of it, `node` comes before a node's name.
struct FileKind {
    std::string_view ending, name, whole, node;
    bool is_drawn = true;
};
constexpr FileKind kKinds[] = {
    {".graph.json", "material", "", ""},
    {".scene.json", "scene", "", ""},
    {".subgraph.json", "sub-graph", "part", "part/"},
    {".lighting.json", "lighting graph", "", "lighting/"},
    {".workflow.json", "workflow", "", "", false},
};

const FileKind* kind_of(const std::string& path) {
    const auto found = std::ranges::find_if(kKinds, [&](const FileKind& kind) { return path.ends_with(kind.ending); });
    return found == std::end(kKinds) ? nullptr : found;
}

bool is_number(const std::string& type) {
    return !type.empty() && std::ranges::none_of(type, [](char c) { return c >= '2' && c <= '4'; });
}

// What a picture of 0 to 1 would not show. A vector may be a colour, whose light is above 1. A vector with a component
// below 0 is no colour, and is shown as a normal map shows normals.
std::optional<DataRange> range_of(const DataSummary& values, bool is_number) {
    constexpr double kVisible = 0.5 / 255;
    if (values.low < -kVisible && !is_number) {
        const double most = std::max(-values.low, values.high);
        return DataRange{.low = -most, .high = most};
    }
    if (values.low > -kVisible && (values.high < 1 + kVisible || !is_number)) return std::nullopt;
    return DataRange{.low = std::min(values.low, 0.0), .high = std::max(values.high, 0.0)};
}

// The work on one file.
class Work {
public:
    Work(const Compiler& compiler, const SheetOptions& options, RenderMachine& machine, SheetEntry& entry)
        : compiler_(compiler),
          options_(options),
          machine_(machine),
          entry_(entry),
          kind_(*kind_of(entry.file)),
          request_(options.request) {
        // A scene has meshes, lights and a camera of its own.
        if (kind_.name == "scene") request_ = {.samples = options.request.samples, .options = options.request.options};
        request_.graph = entry.file;
        request_.options.accept_parts = true;
    }

    void run() {
        if (kind_.is_drawn && !draw_whole()) return;
        if (kind_.name != "scene") draw_graph();
        entry_.ok = entry_.error.empty() && std::ranges::none_of(entry_.diagnostics, [](const Diagnostic& each) {
                        return each.severity == Severity::Error;
                    });
    }

private:
    RenderOutcome picture(std::string preview, int size, int samples, std::optional<DataRange> range = {}) const {
        RenderRequest request = request_;
        request.options.preview = std::move(preview);
        request.size = size;
        request.height = 0;
        request.samples = samples;
        request.range = range;
        return render(compiler_, request, machine_);
    }

    std::string png_of(const Image& linear) {
        Outcome<std::string> png = encode_png(linear);
        if (!png) entry_.error = png.error;
        return std::move(png.value);
    }

    bool draw_whole() {
        RenderOutcome drawn = picture(std::string(kind_.whole), options_.size, options_.request.samples);
        entry_.diagnostics = std::move(drawn.diagnostics);
        entry_.error = std::move(drawn.error);
        entry_.missing_machine = drawn.missing_machine;
        if (!drawn.ok) return false;
        drawn.image = toned(std::move(drawn.image), {.exposure = drawn.exposure});
        entry_.picture = png_of(drawn.image);
        entry_.thumbnail = options_.size % 2 == 0 ? png_of(box_filtered(drawn.image, 2)) : entry_.picture;
        return true;
    }

    void draw_graph() {
        CompileOptions compile;
        compile.include_dirs = request_.options.include_dirs;
        const GraphView view = view_graph(compiler_, entry_.file, compile);
        if (!view.ok) {
            entry_.diagnostics = view.diagnostics;
            return;
        }
        for (const GraphBox& box : view.boxes)
            if (box.is_node) entry_.nodes.push_back(box.title);
        Drawing drawing = runtime::draw(view, node_pictures(view));
        if (!drawing.error.empty()) entry_.without_nodes = drawing.error;
        entry_.drawing = std::move(drawing.svg);
        if (kind_.is_drawn) add_shaders(std::move(compile));
    }

    BoxPictures node_pictures(const GraphView& view) {
        BoxPictures pictures;
        if (!kind_.is_drawn || !options_.node_pictures || view.boxes.size() > kMostBoxes) return pictures;
        std::string without;
        for (std::size_t i = 0; i < view.boxes.size(); ++i) {
            const GraphBox& box = view.boxes[i];
            if (!box.is_node || box.outputs.empty()) continue;
            const std::string node = std::string(kind_.node) + box.id;
            RenderOutcome drawn = picture(node, kNodeSize, kNodeSamples);
            if (const auto range = range_of(drawn.values, is_number(box.outputs[0].type)); drawn.ok && range) {
                drawn = picture(node, kNodeSize, kNodeSamples, range);
                entry_.ranges += fmt::format("{}{} {:.3g} to {:.3g}", entry_.ranges.empty() ? "" : ", ", box.id,
                                             range->low, range->high);
            }
            if (drawn.ok)
                pictures[i] = png_of(drawn.image);
            else
                without += (without.empty() ? "" : ", ") + box.id;
        }
        if (!without.empty()) entry_.without_nodes = "no picture of " + without;
        return pictures;
    }

    void add_shaders(CompileOptions compile) {
        compile.targets = {Target::Glsl};
        compile.switches = request_.options.switches;
        compile.accept_parts = true;
        compile.request = CompileOptions::Passes{.path = request_.options.path};
        if (!kind_.whole.empty()) show_port(compile, std::string(kind_.whole));
        Result compiled = compiler_.compile_file(entry_.file, compile);
        if (!compiled.ok) return;
        entry_.passes = measure(compiled);
        entry_.reflection = std::move(compiled.reflection);
        entry_.shaders = std::move(compiled.shaders);
    }

    const Compiler& compiler_;
    const SheetOptions& options_;
    RenderMachine& machine_;
    SheetEntry& entry_;
    const FileKind& kind_;
    RenderRequest request_;
};

}  // namespace

Sheet make_sheet(const Compiler& compiler, const std::string& folder, const SheetOptions& options) {
    const Outcome<std::vector<std::string>> files = files_below(folder);
    if (!files) return {.error = files.error};
    Sheet sheet;
    const std::filesystem::path root = std::filesystem::path(folder).lexically_normal();
    for (const std::string& file : files.value) {
        const FileKind* kind = kind_of(file);
        if (!kind) continue;
        const std::string stem = file.substr(0, file.size() - kind->ending.size());
        sheet.entries.push_back({.name = std::filesystem::path(stem).lexically_relative(root).generic_string(),
                                 .file = file,
                                 .kind = std::string(kind->name)});
    }
    if (sheet.entries.empty()) sheet.error = "there is no graph and no scene in '" + folder + "'";
    std::ranges::stable_sort(sheet.entries, {}, &SheetEntry::name);
    render_jobs(
        sheet.entries.size(), options.jobs,
        [&](std::size_t i, RenderMachine& machine) { Work(compiler, options, machine, sheet.entries[i]).run(); },
        [&](std::size_t i) {
            if (options.progress) options.progress(i, sheet.entries.size(), sheet.entries[i].name);
        });
    return sheet;
}

}  // namespace patina::runtime
