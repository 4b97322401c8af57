// The functions of patina/patina_c.h for scenes.
#include <memory>

#include "compiler/capi/handles.h"
#include "compiler/capi/scene_json.h"

struct patina_scene {
    patina::SceneResult read{};
    std::string messages{}, diagnostics{}, json{};
};

using namespace patina::capi;

extern "C" {

patina_status patina_read_scene(const patina_compiler* compiler, const char* path, const char* options,
                                const patina_callbacks* callbacks, patina_scene** scene) {
    if (!scene) return PATINA_BAD_ARGUMENT;
    *scene = nullptr;
    if (!compiler || !path) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        auto made = std::make_unique<patina_scene>();
        patina::CompileOptions read;
        made->read.diagnostics = settle(*compiler, options, callbacks, read);
        if (made->read.diagnostics.empty()) made->read = compiler->compiler.read_scene(path, read);
        refuse_without_memory(made->read.ok, made->read.diagnostics);
        made->messages = messages_of(made->read.diagnostics);
        made->diagnostics = json_of(std::span<const patina::Diagnostic>(made->read.diagnostics));
        const bool is_ok = made->read.ok;
        if (is_ok)
            made->json = json_of(made->read.scene);
        else
            made->read.scene = {};
        *scene = made.release();
        return is_ok ? PATINA_OK : PATINA_HAS_ERRORS;
    });
}

const char* patina_scene_json(const patina_scene* scene) {
    return scene ? scene->json.c_str() : "";
}

size_t patina_scene_material_count(const patina_scene* scene) {
    return scene ? scene->read.scene.materials.size() : 0;
}

const char* patina_scene_graph(const patina_scene* scene, size_t material) {
    if (!scene || material >= scene->read.scene.materials.size()) return nullptr;
    return scene->read.scene.materials[material].graph.path.c_str();
}

const char* patina_scene_messages(const patina_scene* scene) {
    return scene ? scene->messages.c_str() : "";
}

const char* patina_scene_diagnostics(const patina_scene* scene) {
    return scene ? scene->diagnostics.c_str() : "[]";
}

size_t patina_scene_dependency_count(const patina_scene* scene) {
    return size_of(scene ? &scene->read.dependencies : nullptr);
}

const char* patina_scene_dependency(const patina_scene* scene, size_t index) {
    return text_at(scene ? &scene->read.dependencies : nullptr, index);
}

size_t patina_scene_missing_count(const patina_scene* scene) {
    return size_of(scene ? &scene->read.missing : nullptr);
}

const char* patina_scene_missing(const patina_scene* scene, size_t index) {
    return text_at(scene ? &scene->read.missing : nullptr, index);
}

void patina_scene_free(patina_scene* scene) {
    delete scene;
}

}  // extern "C"
