// patina docs: the reference as Markdown. It has a page for each node and each lighting model, an index of each kind,
// one page of semantics and one of what the engine gives.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "compiler/cli/commands/commands.h"
#include "compiler/cli/files.h"
#include "compiler/cli/outputs.h"
#include "compiler/cli/pages/model_cost.h"
#include "compiler/cli/pages/pages.h"
#include "patina/engine_values.h"

namespace patina::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string folder;
    bool check = false;
};

using Pages = std::map<std::string, std::string>;  // path below the folder -> text

constexpr const char* kIndex = "README.md";
constexpr const char* kFolders[] = {"nodes", "models"};

// If scripts/pictures has drawn a picture of the node or model, it goes before the section "In a graph".
void add_picture(Page& page, const std::string& folder, const std::string& name, std::string_view caption) {
    std::error_code ignored;
    if (!fs::exists(folder + "/" + name, ignored)) return;
    const auto before = std::ranges::find(page.sections, "In a graph", &Section::title);
    Section section{.title = "Picture"};
    section.pictures.push_back({.path = name, .caption = page.title + ": " + std::string(caption)});
    page.sections.insert(before, std::move(section));
}

void add_nodes(Pages& pages, const Compiler& compiler, const std::string& folder) {
    std::string index =
        std::string(kWritten) +
        "# Nodes\n\nEach says what it computes, from which paper, and what must hold; `patina node NAME` "
        "shows the same.\n";
    std::string category;
    for (const NodeInfo& node : compiler.nodes()) {
        if (node.category != category) {
            category = node.category;
            index += "\n## " + category + "\n\n| node | |\n|---|---|\n";
        }
        index += fmt::format("| [{}]({}.md) | {} |\n", node.name, node.name, escaped(first_sentence(node.doc)));
        Page page = node_page(node, compiler);
        add_picture(page, folder + "/nodes", "plots/" + node.name + ".svg", "its value");
        add_picture(page, folder + "/nodes", "pictures/" + node.name + ".png", "drawn");
        pages["nodes/" + node.name + ".md"] = to_markdown(page, kIndex);
    }
    pages[std::string("nodes/") + kIndex] = index;
}

void add_models(Pages& pages, const Compiler& compiler, const std::string& folder) {
    std::string index =
        std::string(kWritten) +
        "# Lighting models\n\nEach is a graph of [nodes](../nodes/README.md); `patina model NAME` shows the "
        "same. [The gallery](../gallery.md) has their pictures side by side. The cost is the number of "
        "SPIR-V instructions of the optimised fragment shader, [measured](../cost.md) for each pixel and for each "
        "light. The model's page names the shader.\n\n"
        "| model | per pixel | per light | |\n|---|---|---|---|\n";
    for (const ModelInfo& model : compiler.lighting_models()) {
        const ModelCost cost = cost_of(compiler, model);
        index +=
            fmt::format("| [{}]({}.md) | {} | {} | {} |\n", model.name, model.name, cost.fragment.once.instructions,
                        cost.fragment.per_light.instructions, escaped(first_sentence(model.doc)));
        Page page = model_page(compiler, model);
        add_picture(page, folder + "/models", "pictures/" + model.name + ".png", "rendered");
        pages["models/" + model.name + ".md"] = to_markdown(page, kIndex);
    }
    pages[std::string("models/") + kIndex] = index;
}

// The page of semantics: what a material or a lighting graph reads with '@'.
void add_semantics(Pages& pages, const Compiler& compiler) {
    struct Rate {
        std::string_view name, title, text;
    };
    static constexpr Rate kRates[] = {
        {"vertex", "Of the mesh", "These values exist for each vertex and are interpolated."},
        {"pixel", "Of the pixel",
         "Computed where they are read. The vertex stage (the `vertex` block, and nodes that are pinned to it) has "
         "none of these: `@fragCoord`, `@frontFacing`, `@screenUV`, `@sceneColor`, `@sceneDepth`, derivatives."},
        {"uniform", "Of the frame and of the object", "The same for all that is drawn at once."},
        {"lighting", "In a lighting graph", "Only lighting graphs read these values; the pass provides them."},
    };
    std::string text = std::string(kWritten) +
                       "# Semantics\n\nWhat mesh, camera, engine and light provide, read as `@uv0` in a port or an "
                       "expression of a [graph](graph-format.md#values). Lengths are metres, `OS`, `WS`, `VS` and "
                       "`TS` are object, world, view and tangent space ([conventions](conventions.md)).\n";
    for (const Rate& rate : kRates) {
        std::string rows;
        for (const SemanticInfo& semantic : compiler.semantics()) {
            if (semantic.rate != rate.name) continue;
            std::string doc = semantic.doc;
            std::ranges::replace(doc, '\n', ' ');
            rows += fmt::format("| `@{}` | {} | {} |\n", semantic.name, semantic.type, escaped(doc));
        }
        if (rows.empty()) continue;
        text += fmt::format("\n## {}\n\n{}\n\n| semantic | type | |\n|---|---|---|\n{}", rate.title, rate.text, rows);
    }
    pages["semantics.md"] = text;
}

// The page of engine values: what an engine puts into its blocks, and the textures that it binds.
void add_engine_values(Pages& pages, const Compiler& compiler) {
    std::string text =
        std::string(kWritten) +
        "# What the engine gives\n\nThe members of the engine's uniform blocks, and its textures. A material reads "
        "some "
        "of them: its reflection says which, and the offset of each. The engine, which is the "
        "program that draws, fills all of them; only the block of the material's own properties is not here. The "
        "numbers must be finite: Patina replaces 0 times such a number by 0. An "
        "engine may have names of its own for blocks ([engines](engines.md)). Axes and units are those of [the "
        "conventions](conventions.md); `E/pi` is the radiance of a white Lambert surface. What has a row under \"only "
        "with\" is read if one of these switches or rendering paths is on. No switch moves a value: a shader declares "
        "the "
        "values of a block up to the last one that it may read, so one structure with all of them fits every shader. "
        "In a "
        "draw of instances, the values of the object are arrays, and the properties of the instances stand between "
        "those "
        "that are always there and those that a switch adds.\n";
    for (const EngineBlockInfo& block : engine_blocks(compiler)) {
        text += fmt::format("\n## {}\n\n", block.name.empty() ? "Textures" : "`" + block.name + "`");
        if (!block.doc.empty()) text += escaped(block.doc) + "\n\n";
        text += "| name | type | unit | space | | only with |\n|---|---|---|---|---|---|\n";
        for (const EngineValueInfo& value : block.values) {
            std::string with;
            for (const std::string& name : value.with) with += fmt::format("{}`{}`", with.empty() ? "" : ", ", name);
            text += fmt::format("| `{}` | {} | {} | {} | {}{} | {} |\n", value.name, value.type, escaped(value.unit),
                                escaped(value.space), escaped(value.doc),
                                value.is_of_object ? " A draw of instances has one for each." : "", with);
        }
    }
    pages["engine-values.md"] = text;
}

// Pages that an earlier version wrote, of nodes and models that no longer exist.
std::vector<std::string> stale(const Pages& pages, const std::string& folder) {
    std::vector<std::string> paths;
    for (const char* kind : kFolders) {
        std::error_code none;
        for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder) / kind, none)) {
            const std::string path = std::string(kind) + "/" + entry.path().filename().string();
            if (!path.ends_with(".md") || pages.contains(path)) continue;
            std::string error;
            const std::optional<std::string> text = read_file(entry.path().string(), error);
            if (text && text->starts_with(kWritten)) paths.push_back(path);
        }
    }
    std::ranges::sort(paths);
    return paths;
}

Exit compare(const Console& console, const Pages& pages, const std::string& folder) {
    std::vector<std::string> different;
    for (const auto& [path, text] : pages) {
        std::string error;
        const std::optional<std::string> there = read_file(folder + "/" + path, error);
        if (there != text) different.push_back(path);
    }
    for (const std::string& path : stale(pages, folder)) different.push_back(path);
    for (const std::string& path : different) {
        complain(console, Complaint::StalePage, {join_path(folder, path), folder});
    }
    return different.empty() ? Exit::Ok : Exit::Wrong;
}

// True if each of the files is new or a page that an earlier run wrote. Otherwise it complains.
bool is_own(const Console& console, const OutputFiles& files) {
    for (const runtime::OutputFile& file : files.files) {
        std::string error;
        const std::optional<std::string> text = read_file(file.path, error);
        if (!text || text->starts_with(kWritten)) continue;
        complain(console, Complaint::FileExists, {file.path});
        return false;
    }
    return true;
}

Exit write_docs(const Console& console, const Arguments& arguments) {
    const Compiler compiler;
    Pages pages;
    add_nodes(pages, compiler, arguments.folder);
    add_models(pages, compiler, arguments.folder);
    add_semantics(pages, compiler);
    add_engine_values(pages, compiler);
    if (arguments.check) return compare(console, pages, arguments.folder);
    OutputFiles files;
    for (const auto& [path, text] : pages) files.add(join_path(arguments.folder, path), text);
    if (!is_own(console, files) || !Outputs(console).write("docs", files)) return Exit::Wrong;
    for (const std::string& path : stale(pages, arguments.folder)) {
        std::error_code ignored;
        fs::remove(fs::path(arguments.folder) / path, ignored);
    }
    say(console, fmt::format("{}: {} pages", arguments.folder, pages.size()));
    return Exit::Ok;
}

}  // namespace

void add_docs(Program& program) {
    CLI::App& command = add_command(program, "docs", {"patina docs docs", "patina docs docs --check"});
    auto arguments = std::make_shared<Arguments>();
    command
        .add_option("DIR", arguments->folder,
                    "Folder for nodes/*.md, models/*.md, semantics.md and engine-values.md; pages of nodes and models "
                    "that no longer exist are "
                    "removed, and pages that patina has not written are not overwritten")
        ->required()
        ->type_name(" ")
        ->check(is_folder_name);
    command.add_flag("--check", arguments->check, "Write nothing; exit 1 if a page differs from what would be written");
    set_work(program, command, [arguments](const Console& console) { return write_docs(console, *arguments); });
}

}  // namespace patina::cli
