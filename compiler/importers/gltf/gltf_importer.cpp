#include "compiler/importers/gltf/gltf_importer.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "compiler/importers/gltf/gltf_material.h"
#include "compiler/importers/gltf/gltf_rest.h"
#include "compiler/importers/gltf/gltf_scene.h"
#include "compiler/importers/gltf/gltf_text.h"
#include "patina/patina.h"
#include "runtime/gltf/gltf_file.h"

namespace patina::importers {
namespace {

using namespace gltf;

bool recognises(const Source& source) {
    return source.start.starts_with("glTF") || source.path.ends_with(".gltf") || source.path.ends_with(".glb");
}

// --- which material a primitive shows

const Json* primitive_of(const Context& context, const runtime::ModelPart& part) {
    const int mesh = context.file.nodes[part.node_index].mesh;
    const Json* primitives = element(context, "meshes", static_cast<std::size_t>(mesh)).json()->find("primitives");
    return &primitives->elements[part.primitive];
}

// Its material for one variant, or without variants. `count`: the number of materials, which stands for "none".
std::size_t material_of(const Context& context, const runtime::ModelPart& part, std::optional<std::size_t> variant) {
    const std::size_t count = count_of(context, "materials"), own = part.material.value_or(count);
    if (!variant) return own;
    Object primitive(context.report, primitive_of(context, part), fmt::format("the mesh of '{}'", part.node));
    Object extension = primitive.extension("KHR_materials_variants");
    const Json* mappings = extension ? extension.json()->find("mappings") : nullptr;
    if (!mappings) return own;
    for (const Json& each : mappings->elements) {
        Object mapping(context.report, &each, extension.path() + ".mappings");
        const Json* variants = mapping ? each.find("variants") : nullptr;
        if (!variants) continue;
        for (const Json& number : variants->elements) {
            if (number.kind == Json::Kind::Number && number.number == static_cast<double>(*variant))
                return mapping.index("material", "materials", count).value_or(own);
        }
    }
    return own;
}

void note_use(const Context& context, const runtime::ModelPart& part, MaterialUse& use) {
    const Json* attributes = primitive_of(context, part)->find("attributes");
    use.has_colors = use.has_colors || (attributes && attributes->find("COLOR_0"));
    for (std::size_t set = 0; set < use.lacks_coordinates.size(); ++set) {
        if (!attributes || !attributes->find(fmt::format("TEXCOORD_{}", set))) use.lacks_coordinates[set] = true;
    }
    const glm::mat3 turn(part.object_to_world);
    const float x = glm::length(turn[0]), y = glm::length(turn[1]), z = glm::length(turn[2]);
    const auto differ = [](float a, float b) { return std::abs(a - b) > 1e-4f * b; };
    use.is_scaled = use.is_scaled || differ(x, 1) || differ(y, 1) || differ(z, 1);
    use.is_stretched = use.is_stretched || differ(x, y) || differ(x, z);
}

struct Variant {
    std::string name{};
    std::optional<std::size_t> index{};  // nothing: the file's own materials
};

// The file without variants, and each of them.
std::vector<Variant> variants_of(const Context& context) {
    std::vector<Variant> made = {{}};
    Object root(context.report, &context.root, "");
    Object extension = root.extension("KHR_materials_variants");
    const Json* list = extension ? extension.json()->find("variants") : nullptr;
    for (std::size_t i = 0; list && i < list->elements.size(); ++i) {
        Object variant(context.report, &list->elements[i], fmt::format("{}.variants[{}]", extension.path(), i));
        made.push_back({.name = variant.word("name").value_or(fmt::format("variant {}", i)), .index = i});
    }
    return made;
}

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
    std::vector<std::string> names;
    for (const Variant& each : variants)
        if (each.index) names.push_back(each.name);
    return names;
}

// "'a.glb' has no cameras, so there is no 'Front'".
std::string nothing_named(const std::string& path, const std::string& what, const std::string& name,
                          const std::vector<std::string>& known) {
    if (known.empty()) return fmt::format("'{}' has no {}s, so there is no '{}'", path, what, name);
    const std::string advice = suggestion(name, known);
    return fmt::format("'{}' has no {} '{}'{}{}", path, what, name, advice.empty() ? "" : "; ", advice);
}

// --- all of it

Imported import_model(const Context& context, const runtime::GltfModel& model, const Options& options) {
    Imported made;
    const std::vector<Variant> variants = variants_of(context);
    std::vector<Variant> wanted = variants;
    if (!options.variant.empty()) {
        std::erase_if(wanted, [&](const Variant& each) { return each.name != options.variant; });
        if (wanted.empty())
            return {.error = nothing_named(context.path, "variant", options.variant, names_of(variants))};
    }
    const runtime::ModelCamera* camera = find_camera(model, options.camera);
    if (!camera && !options.camera.empty()) {
        std::vector<std::string> names;
        for (const runtime::ModelCamera& each : model.cameras) names.push_back(each.node);
        return {.error = nothing_named(context.path, "camera", options.camera, names)};
    }

    const std::size_t count = count_of(context, "materials");
    OwnNames names = names_of_files();
    std::vector<MaterialUse> uses(count + 1);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string name = element(context, "materials", i).word("name").value_or("");
        uses[i].name = file_name(name, fmt::format("material-{}", i), names);
    }
    uses[count].name = file_name("default", "default", names);
    bool needs_default = false;
    for (const Variant& variant : variants) {
        for (const runtime::ModelPart& part : model.parts) {
            const std::size_t material = material_of(context, part, variant.index);
            note_use(context, part, uses[material]);
            needs_default = needs_default || material == count;
        }
    }
    Pictures pictures(context);
    for (std::size_t i = 0; i < count + (needs_default ? 1 : 0); ++i) {
        const std::string json = material_graph(context, pictures, i, uses[i]).text();
        if (json.empty()) return {.error = fmt::format("{}: materials[{}].name is not UTF-8", context.path, i)};
        made.graphs.push_back({.name = uses[i].name + ".graph.json", .text = json});
    }
    made.copies = std::move(pictures.copies);

    const std::string stem = options.name.empty() ? std::filesystem::path(context.path).stem().string() : options.name;
    if (model.parts.empty()) {
        wanted.clear();
        context.report.add(Remark::Kind::LeftOut, "nodes", "none of them shows triangles, so there is no scene",
                           context.root.find("nodes"));
    }
    if (!wanted.empty()) {
        if (const std::string mistake = scene_mistake(model, camera); !mistake.empty())
            return {.error = fmt::format("{}: {}", context.path, mistake)};
    }
    OwnNames scenes = names_of_files();
    for (const Variant& variant : wanted) {
        SceneWish wish{.name = variant.index && options.variant.empty() ? stem + ", " + variant.name : stem,
                       .camera = camera,
                       .is_lit = options.is_lit};
        for (const MaterialUse& use : uses) wish.graphs.push_back(use.name);
        for (const runtime::ModelPart& part : model.parts)
            wish.materials.push_back(material_of(context, part, variant.index));
        const bool is_first = made.scene.empty();
        const std::string name =
            (is_first ? stem : stem + "." + file_name(variant.name, "variant", scenes)) + ".scene.json";
        made.graphs.push_back({.name = name, .text = scene_text(context, model, wish)});
        if (made.graphs.back().text.empty()) return {.error = context.path + ": the name of a node is not UTF-8"};
        if (is_first) made.scene = name;
    }
    report_view(context, model, camera);
    report_rest(context, model);
    return made;
}

Imported read(const Source& source, const Options& options) {
    // A scene names a node after a '#'.
    if (source.path.find('#') != std::string::npos)
        return {.error = source.path + ": no scene can name a file with a '#' in its path: rename it"};
    const runtime::Outcome<tinygltf::Model> file = runtime::open_gltf(source.path);
    if (!file) return {.error = located_mistake(source.path, file.error)};
    const GltfText text = read_gltf_text(source.path);
    if (!text.root) return {.error = text.error};
    if (std::string mistake = shape_mistake(text, source.path); !mistake.empty()) return {.error = std::move(mistake)};
    const runtime::Outcome<runtime::GltfModel> model = runtime::model_of(file.value, runtime::MeshDetail::Places);
    if (!model) return {.error = located_mistake(source.path, source.path + ": " + model.error)};
    Report report(source.path, text.is_binary ? nullptr : &text.sources);
    const Context context{
        .file = file.value,
        .root = *text.root,
        .report = report,
        .path = source.path,
        .folder = options.folder.empty() ? std::filesystem::path(source.path).parent_path().string() : options.folder};
    Imported made = import_model(context, model.value, options);
    if (!report.error.empty()) return {.error = report.error};
    made.remarks = std::move(report.remarks);
    return made;
}

}  // namespace

Importer gltf_importer() {
    return {.name = "gltf",
            .reads = "models in glTF 2.0 (.glb, .gltf)",
            .example = "patina import chair.glb -o chair          # a graph for each material, and chair.scene.json",
            .makes_pictures = false,
            .recognises = recognises,
            .read = read};
}

}  // namespace patina::importers
