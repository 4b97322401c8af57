#include "runtime/render/prepare_material.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "patina/complaints.h"
#include "runtime/render/complaints.h"
#include "runtime/values/scene_values.h"

namespace patina::runtime {
namespace {

// Where a scene gives the texture its file; else the property. `of_file`: the file is wrong, and not the property, so
// that for a file of the command line it is the graph as a whole.
FileLocation place_of(const WorldMaterial& material, const PreparedMaterial& made, const std::string& texture,
                      bool of_file) {
    if (const FileLocation* place = place_of_value(material, texture)) return *place;
    FileLocation found;
    found.file = material.graph;
    const bool is_elsewhere = of_file && made.values.textures.contains(texture);
    for (const Texture& each : made.compiled.reflection.textures)
        if (each.name == texture && !is_elsewhere) found = each.place;
    return found;
}

// If neither the graph nor a scene names the file, the user's request for the picture names it.
void note_where_it_is_set(const WorldMaterial& material, const PreparedMaterial& made, const std::string& texture,
                          Diagnostic& said) {
    const auto set = made.values.textures.find(texture);
    if (set == made.values.textures.end() || place_of_value(material, texture)) return;
    Diagnostic& note = said.notes.emplace_back();
    note.severity = Severity::Note;
    note.message =
        fmt::format("the graph does not name this file: '{}' is set to it, by --set or by a snapshot", texture);
}

void load(const WorldMaterial& material, const RenderOptions& options, PreparedMaterial& made) {
    const std::string folder = std::filesystem::path(material.graph).parent_path().string();
    made.loaded = load_textures(made.compiled.reflection, folder, made.values.textures, options.exact_textures,
                                options.files.get());
    const auto say = [&](const std::vector<TextureRemark>& remarks, Severity severity, Complaint code) {
        for (const TextureRemark& each : remarks) {
            Diagnostic& said = made.diagnostics.emplace_back(
                diagnostic_at(place_of(material, made, each.texture, severity == Severity::Error),
                              std::string(code_of(code)), each.text));
            said.severity = severity;
            note_where_it_is_set(material, made, each.texture, said);
        }
    };
    say(made.loaded.warnings, Severity::Warning, Complaint::OtherColorSpace);
    say(made.loaded.errors, Severity::Error, Complaint::BadTexture);
}

// Files in memory first, then those of the disk.
FileSystem over_disk(std::shared_ptr<const MemoryFiles> files) {
    const auto find = [files = std::move(files)](const std::string& path) {
        const auto found = files->find(std::filesystem::path(path).lexically_normal().generic_string());
        return found == files->end() ? nullptr : &found->second;
    };
    FileSystem made = disk();
    made.exists = [find, on_disk = made.exists](const std::string& path) { return find(path) || on_disk(path); };
    made.read = [find, from_disk = made.read](const std::string& path) {
        const std::string* text = find(path);
        return text ? std::optional(*text) : from_disk(path);
    };
    made.resolve = nullptr;
    return made;
}

}  // namespace

CompileOptions compile_options(const RenderOptions& options) {
    CompileOptions made;
    made.request = CompileOptions::Passes{.path = options.path};
    if (!options.preview.empty()) show_port(made, options.preview);
    made.switches = options.switches;
    made.include_dirs = options.include_dirs;
    if (options.files) made.files = over_disk(options.files);
    made.lighting = options.lighting;
    made.accept_parts = options.accept_parts;
    return made;
}

void show_port(CompileOptions& options, std::string port) {
    options.request = CompileOptions::Preview{.port = std::move(port), .passes = *options.passes()};
}

Result compile_material(const Compiler& compiler, const WorldMaterial& material, CompileOptions options) {
    if (!material.preview.empty()) {
        show_port(options, material.preview);
        // Fog would change the value.
        std::erase_if(options.switches, [](const auto& each) { return each.first == "fog"; });
        options.switches.emplace_back("fog", "false");
    }
    if (!material.path.empty()) options.passes()->path = material.path;
    Result made = compiler.compile_file(material.graph, options);
    if (!made.ok || material.overrides.empty()) return made;
    const Spelling spelling = material.set.empty() ? Spelling::Words : Spelling::Json;
    const auto wanted = keywords_of(made.reflection, material.overrides, spelling);
    if (wanted.empty()) return made;
    options.switches.insert(options.switches.end(), wanted.begin(), wanted.end());
    return compiler.compile_file(material.graph, options);
}

PreparedMaterial prepare_material(const WorldMaterial& material, Result compiled, const RenderOptions& options) {
    PreparedMaterial made{.compiled = std::move(compiled)};
    if (!made.compiled.ok) return made;
    const Reflection& reflection = made.compiled.reflection;
    SceneFaults faults = check_values(reflection, material);
    made.diagnostics = std::move(faults.diagnostics);
    if (!faults.ok) return made;
    Outcome<MaterialValues> values = material_values(reflection, material.overrides);
    if (!values) {
        made.error = material.name.empty() ? values.error : material.name + ": " + values.error;
        return made;
    }
    made.values = std::move(values.value);
    for (const std::string& warning : made.values.warnings) {
        // Values of a scene file have been reported at their location.
        if (material.set.empty())
            made.diagnostics.push_back(complaint(material.graph, Severity::Warning, Complaint::SoftRange, {warning}));
    }
    load(material, options, made);
    made.ok = made.loaded.errors.empty();
    return made;
}

}  // namespace patina::runtime
