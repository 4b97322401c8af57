#include "compiler/importers/gltf/gltf_rest.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace patina::importers::gltf {
namespace {

void report_nodes(const Context& context, const runtime::GltfModel& model) {
    std::vector<std::size_t> parts(model.nodes.size());
    for (const runtime::ModelPart& part : model.parts) ++parts[part.node_index];
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Object node = element(context, "nodes", i);
        for (const std::string_view key : {"translation", "rotation", "scale", "matrix", "children"})
            node.taken(key, "the place of the objects, read from the file");
        node.taken("name", "the scene's name for it");
        node.taken("camera", "see the camera");
        if (node.has("mesh") && parts[i] == 0) node.left_out("mesh", "no object of the scene shows it");
        node.taken("mesh", fmt::format("{} of the scene's objects", parts[i]));
        node.taken("skin", "its rest pose");
        node.taken("weights", "the mesh as these weights shape it");
        node.extension("KHR_lights_punctual").all_taken("see the light");
        node.rest();
    }
}

void report_meshes(const Context& context) {
    for (std::size_t i = 0; i < count_of(context, "meshes"); ++i) {
        Object mesh = element(context, "meshes", i);
        mesh.taken("name", "not needed: the scene names the node");
        mesh.taken("weights", "the mesh as these weights shape it");
        const Json* primitives = mesh.json()->find("primitives");
        for (std::size_t k = 0; primitives && k < primitives->elements.size(); ++k) {
            Object primitive(context.report, &primitives->elements[k],
                             fmt::format("{}.primitives[{}]", mesh.path(), k));
            Object attributes = primitive.child("attributes");
            for (const std::string_view name :
                 {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0", "TEXCOORD_1", "TEXCOORD_2", "TEXCOORD_3", "COLOR_0",
                  "JOINTS_0", "WEIGHTS_0", "JOINTS_1", "WEIGHTS_1"})
                attributes.taken(name, "read from the file");
            attributes.rest();
            for (const std::string_view key : {"indices", "mode", "targets"})
                primitive.taken(key, "read from the file");
            primitive.taken("material", "the object's material");
            primitive.extension("KHR_draco_mesh_compression").all_taken("read from the file");
            primitive.extension("KHR_materials_variants").all_taken("a scene for each variant");
            primitive.rest();
        }
        mesh.taken("primitives", "the objects' meshes, read from the file");
        mesh.rest();
    }
}

void report_scenes(const Context& context) {
    const int shown = std::max(context.file.defaultScene, 0);
    for (std::size_t i = 0; i < count_of(context, "scenes"); ++i) {
        Object scene = element(context, "scenes", i);
        if (i == static_cast<std::size_t>(shown)) {
            scene.taken("nodes", "the scene's objects");
            scene.taken("name", "not needed: the scene is named after the file");
        } else {
            scene.left_out("nodes", "the file's default scene is another one");
            scene.taken("name", "the file's default scene is another one");
        }
        scene.rest();
    }
}

// "textures[3]" for every remark on that texture or on something inside.
std::set<std::string> elements_with_remarks(const Report& report) {
    std::set<std::string> made;
    for (const Remark& remark : report.remarks) made.insert(remark.part.substr(0, remark.part.find(']') + 1));
    return made;
}

// Lists whose elements are either used by what has been reported, or by nothing.
void report_unused(const Context& context, std::string_view list, const std::set<std::string>& known,
                   std::string_view why) {
    for (std::size_t i = 0; i < count_of(context, list); ++i) {
        const Object each = element(context, list, i);
        if (!known.contains(each.path()))
            context.report.add(Remark::Kind::LeftOut, each.path(), std::string(why), each.json());
    }
}

}  // namespace

void report_rest(const Context& context, const runtime::GltfModel& model) {
    const std::set<std::string> known = elements_with_remarks(context.report);
    for (const std::string_view list : {"textures", "images", "samplers"})
        report_unused(context, list, known, "no material reads it");
    report_unused(context, "cameras", known, "no node of the file's scene has it");
    report_nodes(context, model);
    report_meshes(context);
    report_scenes(context);
    for (const std::string& each : model.left_out) {
        const std::size_t colon = each.find(": ");
        context.report.add(Remark::Kind::LeftOut, each.substr(0, colon), each.substr(colon + 2), nullptr);
    }
    Object root(context.report, &context.root, "");
    if (Object lights = root.extension("KHR_lights_punctual"); lights) {
        const Json* list = lights.json()->find("lights");
        const std::size_t count = list ? list->elements.size() : 0;
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_shown = std::any_of(model.lights.begin(), model.lights.end(),
                                              [&](const runtime::ModelLight& light) { return light.index == i; });
            if (!is_shown)
                context.report.add(Remark::Kind::LeftOut, fmt::format("{}.lights[{}]", lights.path(), i),
                                   "no node of the file's scene has it", &list->elements[i]);
        }
    }
    if (Object variants = root.extension("KHR_materials_variants"); variants)
        variants.taken("variants", "a scene for each variant");
    for (std::size_t i = 0; i < count_of(context, "animations"); ++i) {
        const Object animation = element(context, "animations", i);
        context.report.add(Remark::Kind::LeftOut, animation.path(), "the scene shows the rest pose", animation.json());
    }
    for (const std::string_view list : {"accessors", "bufferViews", "buffers"})
        root.taken(list, "read from the file when the scene is drawn");
    root.taken("asset", "data about the file");
    root.taken("scene", "the scene that is drawn");
    root.taken("skins", "the rest pose");
    for (const std::string_view list : {"extensionsUsed", "extensionsRequired"})
        root.taken(list, "each extension is reported where it is used");
    for (const std::string_view known :
         {"materials", "textures", "images", "samplers", "cameras", "nodes", "meshes", "scenes", "animations"})
        root.skip(known);
    root.rest();
}

}  // namespace patina::importers::gltf
