#include "compiler/importers/unitymaterial/unitymaterial_importer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/base/letters.h"
#include "compiler/importers/unitymaterial/graph_instance.h"
#include "compiler/importers/unitymaterial/material_maker.h"
#include "compiler/importers/unitymaterial/parents.h"

namespace patina::importers {
namespace {

namespace fs = std::filesystem;
using namespace unitymaterial;

bool recognises(const Source& source) {
    const std::string ending = small_letters(fs::path(source.path).extension().string());
    return ending == ".mat";
}

Remark remark(Remark::Kind kind, std::string part, std::string text, Place place) {
    return {.kind = kind, .part = std::move(part), .text = std::move(text), .line = place.line, .column = place.column};
}

// A material whose shader is not known, and of which no property has a known name.
void make_refused(MaterialMaker& maker) {
    maker.graph.workflow = "unlit";
    maker.node({.id = "refused",
                .expression = "float3(1, 0, 1)",
                .more = {{"note", "The shader of the material is not known."}}});
    maker.set("color", link("refused", Type::Float3));
}

void make(MaterialMaker& maker) {
    const Family family = maker.shader().family;
    if (family == Family::Unknown) {
        make_refused(maker);
        return;
    }
    const RenderState state = make_render_state(maker);
    if (family == Family::Standard || family == Family::UniversalLit)
        make_lit(maker, state);
    else if (family == Family::HighDefinitionLit)
        make_high_definition(maker, state);
    else if (family == Family::SimpleLit)
        make_simple_lit(maker, state);
    else if (family == Family::BakedLit)
        make_baked_lit(maker, state);
    else
        make_unlit(maker, state);
}

void report_file(const MaterialFile& file, const Shader& shader, const std::string& what, Assets& assets,
                 std::vector<Remark>& into) {
    const bool is_unknown = shader.family == Family::Unknown;
    const std::string text = is_unknown                  ? shader.difference + ": the surface is magenta"
                             : shader.difference.empty() ? what
                                                         : what + ": " + shader.difference;
    const Remark::Kind kind = is_unknown                  ? Remark::Kind::LeftOut
                              : shader.difference.empty() ? Remark::Kind::Taken
                                                          : Remark::Kind::Changed;
    into.push_back(remark(kind, is_unknown || shader.is_guessed ? "shader" : fmt::format("shader '{}'", shader.name),
                          text, file.shader_place));
    for (const std::string& parent : file.parents)
        into.push_back(remark(Remark::Kind::Taken, fmt::format("parent '{}'", parent),
                              "its values, where the material has none of its own", file.parent_place));
    if (!file.parent.is_none())
        into.push_back(
            remark(Remark::Kind::LeftOut, "setting 'm_Parent'",
                   fmt::format("no material in {} has the GUID {}: the shader's defaults stand for its values",
                               assets.folders(), file.parent.guid.empty() ? "(none)" : file.parent.guid),
                   file.parent_place));
    for (const Problem& each : file.problems)
        into.push_back({.kind = Remark::Kind::Changed,
                        .part = each.part,
                        .text = each.text,
                        .line = each.place.line,
                        .column = each.place.column,
                        .file = each.file});
}

Imported read(const Source& source, const Options& options) {
    const std::string name = options.name.empty() ? fs::path(source.path).stem().string() : options.name;
    const std::string folder = options.folder.empty() ? fs::path(source.path).parent_path().string() : options.folder;
    Assets assets(source.path, options.include_dirs);
    const MaterialFile file = read_with_parents(source.path, assets);
    if (!file.error.empty()) return {.error = file.error};
    const Shader shader = shader_of(file, assets);
    Pictures pictures(assets, folder);
    MaterialMaker maker(file, shader, pictures, name);
    Imported made;
    std::string what;
    if (shader.family == Family::ShaderGraph) {
        made = make_instance(maker, name, {.folder = folder, .include_dirs = options.include_dirs});
        if (!made.error.empty()) return made;
        what = fmt::format("'{}', a scene with the values of the material", made.scene);
    } else {
        make(maker);
        const std::string error =
            maker.graph.refuse_invalid({}, [&](const Diagnostic& wrong, const std::string& reason) {
                made.remarks.push_back(
                    remark(Remark::Kind::LeftOut, fmt::format("'{}.{}'", wrong.node, wrong.port), reason, {}));
            });
        if (!error.empty()) return {.error = fmt::format("{}: {}", source.path, error)};
        const std::string json = maker.graph.text();
        if (json.empty()) return {.error = fmt::format("{}: a name in it is not UTF-8", source.path)};
        made.graphs.push_back({.name = name + ".graph.json", .text = json});
        what = fmt::format("the workflow '{}'", maker.graph.workflow);
        if (!maker.graph.lighting.empty()) what += fmt::format(", lit by '{}'", maker.graph.lighting);
    }
    std::vector<Remark> of_graph = std::move(made.remarks);
    made.remarks.clear();
    report_file(file, shader, what, assets, made.remarks);
    for (Remark& each : maker.finish()) made.remarks.push_back(std::move(each));
    made.remarks.insert(made.remarks.end(), of_graph.begin(), of_graph.end());
    for (const Remark& each : made.remarks) made.has_refused |= each.kind == Remark::Kind::LeftOut;
    return made;
}

}  // namespace

Importer unitymaterial_importer() {
    return {.name = "unitymaterial",
            .reads = "Unity's materials (.mat)",
            .example = "patina import Rock.mat -o rock --report",
            .makes_pictures = false,
            .keeps_report = true,
            .recognises = recognises,
            .read = read};
}

}  // namespace patina::importers
