#include "runtime/render/preview_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "runtime/render/complaints.h"
#include "runtime/render/prepare_material.h"
#include "runtime/values/material_values.h"

namespace patina::runtime {
namespace {

// The path that draws hiding objects, and the path that shows a value, for every path of the picture.
constexpr const char *kHidingPath = "depth-only", *kShowingPath = "forward";

bool has_error(const Result& result, std::string_view code) {
    return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                       [&](const Diagnostic& each) { return each.code == code; });
}

// The preview's own text is a file of this name (compiler/resolve/material.cpp).
bool is_about_port(const Diagnostic& diagnostic) {
    return diagnostic.severity == Severity::Error && diagnostic.file == "preview";
}

// The only errors are about the previewed port.
bool is_sound(const Result& result) {
    return std::all_of(result.diagnostics.begin(), result.diagnostics.end(),
                       [](const Diagnostic& each) { return each.severity != Severity::Error || is_about_port(each); });
}

// A pass that shows the object reads a target that is not its own depth: the picture, or shadow maps.
bool reads_picture(const Reflection& reflection) {
    for (const Pass& pass : reflection.passes)
        for (const Texture& texture : reflection.textures)
            if (pass.lights != PassLights::Shadowed && !texture.reads.empty() && texture.reads != pass.depth_target &&
                std::count(pass.textures.begin(), pass.textures.end(), texture.name) > 0)
                return true;
    return false;
}

// A preview has no lighting, so the properties of the material's lighting have no place in it.
template <class Values>
void keep_known(const std::set<std::string>& known, Values& values) {
    std::erase_if(values.overrides, [&](const auto& each) { return !known.contains(each.first); });
    std::erase_if(values.set, [&](const SceneValue& each) { return !known.contains(each.property); });
}

std::set<std::string> known_properties(const Reflection& reflection) {
    const std::vector<std::string> names = property_names(reflection);
    return {names.begin(), names.end()};
}

std::set<std::string> instance_properties(const Reflection& reflection) {
    std::set<std::string> names;
    for (const Property& property : reflection.properties)
        if (property.instance_stride > 0) names.insert(property.name);
    return names;
}

class Preview {
public:
    Preview(const Compiler& compiler, const World& world, const PreviewWish& wish, const RenderOptions& options)
        : compiler_(compiler), world_(world), wish_(wish), options_(options) {}

    ScenePreview make() {
        if (!choose()) return std::move(made_);
        for (const std::size_t material : materials_) {
            made_.materials.push_back(world_.materials[material].name);
            made_.reads_picture |= reads_picture(probe(material).reflection);
        }
        made_.options = options_;
        made_.options.path = kHidingPath;
        made_.world = world_before();
        made_.ok = !has_failed_;
        if (made_.reads_picture && made_.ok) made_.with_picture = world_with_picture();
        return std::move(made_);
    }

private:
    bool refuse(Diagnostic diagnostic) {
        made_.diagnostics.push_back(std::move(diagnostic));
        return false;
    }
    Diagnostic error(Complaint what, std::initializer_list<std::string_view> words) const {
        return complaint(wish_.scene, Severity::Error, what, words);
    }

    // --- which objects

    bool is_used(std::size_t material) const {
        return std::any_of(world_.objects.begin(), world_.objects.end(),
                           [&](const WorldObject& object) { return object.material == material; });
    }

    // The material with the port in place of its surface, compiled once.
    const Result& probe(std::size_t material) {
        const auto [found, is_new] = probes_.try_emplace(material);
        if (is_new) {
            WorldMaterial shown = world_.materials[material];
            shown.preview = wish_.port;
            shown.path = kShowingPath;
            found->second = compiled(shown);
        }
        return found->second;
    }

    // Without its texts: what counts is the reflection, or the errors. A node may read the shadow of a light.
    Result compiled(const WorldMaterial& material) const {
        CompileOptions options = compile_options(options_);
        options.request = CompileOptions::Passes(*options.passes());
        options.targets.clear();
        const std::vector<Light>& lights = world_.view.lights;
        if (std::any_of(lights.begin(), lights.end(), [](const Light& light) { return light.shadow.casts; }))
            options.switches.emplace_back("shadows", "true");
        return compile_material(compiler_, material, std::move(options));
    }

    bool choose() {
        if (!wish_.object.empty()) {
            const Outcome<std::size_t> found = find_object(world_, wish_.object);
            if (!found) return refuse(unknown_object(world_, wish_.object, wish_.scene));
            object_ = found.value;
            return has_port(world_.objects[found.value].material);
        }
        if (!wish_.material.empty()) {
            std::vector<std::string> names;
            for (const WorldMaterial& material : world_.materials) names.push_back(material.name);
            const auto found = std::find(names.begin(), names.end(), wish_.material);
            if (found == names.end()) {
                Diagnostic unknown = error(Complaint::UnknownInScene, {"material", wish_.material});
                unknown.notes.push_back(note(suggestion(wish_.material, names)));
                return refuse(std::move(unknown));
            }
            const std::size_t material = std::size_t(found - names.begin());
            if (!is_used(material)) return refuse(error(Complaint::UnusedMaterial, {wish_.material}));
            return has_port(material);
        }
        return choose_materials();
    }

    // The compiler says why not, at the port.
    bool has_port(std::size_t material) {
        materials_.push_back(material);
        const Result& result = probe(material);
        for (const Diagnostic& each : result.diagnostics) {
            const auto is_same = [&](const Diagnostic& known) { return to_text(known) == to_text(each); };
            if (std::ranges::none_of(made_.diagnostics, is_same)) made_.diagnostics.push_back(each);
        }
        if (!result.ok) advise_on_path(made_.diagnostics);
        return result.ok;
    }

    // All materials that have the port.
    bool choose_materials() {
        std::vector<std::size_t> with_port, with_node, without;
        for (std::size_t i = 0; i < world_.materials.size(); ++i) {
            if (!is_used(i)) continue;
            const Result& result = probe(i);
            if (!is_sound(result)) return has_port(i);
            (result.ok ? with_port : has_error(result, "dangling-link") ? without : with_node).push_back(i);
        }
        for (const std::size_t i : with_port) has_port(i);
        if (!with_port.empty()) return true;
        if (with_node.empty() && without.size() != 1) return refuse(nowhere(without));
        return has_port(with_node.empty() ? without.front() : with_node.front());
    }

    // No material has the node. Says where a similar node is, or which nodes there are.
    Diagnostic nowhere(const std::vector<std::size_t>& materials) {
        Diagnostic unknown = error(Complaint::NoSuchPort, {wish_.port});
        std::vector<Diagnostic> near, all;
        for (std::size_t i : materials) {
            for (const Diagnostic& each : probe(i).diagnostics) {
                if (!is_about_port(each)) continue;
                for (const Diagnostic& advice : each.notes) {
                    Diagnostic said = note(fmt::format("in '{}': {}", world_.materials[i].name, advice.message));
                    if (advice.message.starts_with("did you mean")) near.push_back(said);
                    all.push_back(std::move(said));
                }
            }
        }
        unknown.notes = near.empty() ? std::move(all) : std::move(near);
        std::vector<Diagnostic> one = {std::move(unknown)};
        advise_on_path(one);
        return std::move(one.front());
    }

    // "wall/albedo" is a node in a sub-graph "wall"; an object of this name has an option.
    void advise_on_path(std::vector<Diagnostic>& diagnostics) const {
        const std::size_t slash = wish_.port.find('/');
        if (slash == std::string::npos || diagnostics.empty()) return;
        const std::string head = wish_.port.substr(0, slash), rest = wish_.port.substr(slash + 1);
        const auto is_named = [&](const auto& each) { return each.name == head; };
        const bool is_object = std::any_of(world_.objects.begin(), world_.objects.end(), is_named);
        if (!is_object && std::none_of(world_.materials.begin(), world_.materials.end(), is_named)) return;
        diagnostics.back().notes.push_back(
            note(fmt::format("'{0}' is {1}: choose it with --{2} {0} --node {3}", head,
                             is_object ? "an object" : "a material", is_object ? "object" : "material", rest)));
    }

    bool is_chosen(std::size_t object) const {
        return object_ ? object == *object_ : std::ranges::count(materials_, world_.objects[object].material) > 0;
    }

    // --- the worlds

    // Those that show the port, added in their order.
    void add_shown(World& world) {
        for (const std::size_t material : materials_) {
            WorldMaterial& shown = world.materials.emplace_back(world_.materials[material]);
            shown.preview = wish_.port;
            shown.path = kShowingPath;
            keep_known(known_properties(probe(material).reflection), shown);
        }
    }

    // `first`: of the materials that add_shown() added.
    WorldObject shown_object(std::size_t index, std::size_t first) {
        WorldObject object = world_.objects[index];
        const Result& own = probe(object.material);
        object.material = first + std::size_t(std::ranges::find(materials_, object.material) - materials_.begin());
        object.lightmap.clear();
        object.shadow_mask.clear();
        const std::set<std::string> known = instance_properties(own.reflection);
        for (WorldInstance& instance : object.instances) keep_known(known, instance);
        return object;
    }

    World world_before() {
        World world = world_;
        world.view.background.a = 0;
        world.view.backdrop = SceneBackdrop::Color;
        world.view.is_default_background = false;
        for (Light& light : world.view.lights) light.shadow.casts = false;  // nothing here is lit
        world.materials.clear();
        world.objects.clear();
        add_shown(world);
        std::map<std::size_t, std::optional<std::size_t>> hiding;  // by material; nothing: it is blended
        for (std::size_t i = 0; i < world_.objects.size(); ++i) {
            if (is_chosen(i)) {
                world.objects.push_back(shown_object(i, 0));
                continue;
            }
            const std::size_t own = world_.objects[i].material;
            const auto [found, is_new] = hiding.try_emplace(own);
            if (is_new) found->second = add_hiding(world_.materials[own], world);
            if (!found->second) continue;
            hiding_objects_.insert(i);
            WorldObject object = world_.objects[i];
            object.material = *found->second;
            object.lightmap.clear();
            object.shadow_mask.clear();
            const std::set<std::string> known = instance_properties(hiding_.at(*found->second));
            for (WorldInstance& instance : object.instances) keep_known(known, instance);
            world.objects.push_back(std::move(object));
        }
        return world;
    }

    // A material that hides things as this one does, which is added to the world; nothing if it hides nothing.
    std::optional<std::size_t> add_hiding(const WorldMaterial& material, World& world) {
        WorldMaterial hiding = material;
        hiding.path = kHidingPath;
        const Result result = compiled(hiding);
        if (!result.ok) {
            has_failed_ = true;
            made_.diagnostics.insert(made_.diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
            return std::nullopt;
        }
        if (result.reflection.passes.empty()) return std::nullopt;
        keep_known(known_properties(result.reflection), hiding);
        world.materials.push_back(std::move(hiding));
        hiding_[world.materials.size() - 1] = result.reflection;
        return world.materials.size() - 1;
    }

    World world_with_picture() {
        World world = world_;
        const std::size_t first = world.materials.size();
        add_shown(world);
        world.objects.clear();
        for (std::size_t i = 0; i < world_.objects.size(); ++i) {
            if (is_chosen(i))
                world.objects.push_back(shown_object(i, first));
            else if (hiding_objects_.contains(i))
                world.objects.push_back(world_.objects[i]);
        }
        return world;
    }

    const Compiler& compiler_;
    const World& world_;
    const PreviewWish& wish_;
    const RenderOptions& options_;
    ScenePreview made_{};
    bool has_failed_ = false;
    std::vector<std::size_t> materials_{};  // that show the port
    std::optional<std::size_t> object_{};   // nothing: all objects of the material
    std::map<std::size_t, Result> probes_{};
    std::map<std::size_t, Reflection> hiding_{};  // of materials of `made_.world`
    std::set<std::size_t> hiding_objects_{};
};

}  // namespace

Outcome<std::size_t> find_object(const World& world, const std::string& name) {
    const auto found = std::find_if(world.objects.begin(), world.objects.end(),
                                    [&](const WorldObject& object) { return object.name == name; });
    if (found == world.objects.end()) return Failure{"there is no object '" + name + "'"};
    return std::size_t(found - world.objects.begin());
}

Diagnostic unknown_object(const World& world, const std::string& name, const std::string& scene) {
    std::vector<std::string> names;
    for (const WorldObject& object : world.objects) names.push_back(object.name);
    Diagnostic unknown = complaint(scene, Severity::Error, Complaint::UnknownInScene, {"object", name});
    if (std::string advice = suggestion(name, names); !advice.empty()) unknown.notes.push_back(note(std::move(advice)));
    return unknown;
}

ScenePreview preview_world(const Compiler& compiler, const World& world, const PreviewWish& wish,
                           const RenderOptions& options) {
    RenderOptions own = options;
    own.preview.clear();
    if (own.path.ends_with(".hlsl")) own.switches.clear();  // the library's passes do not know those of a pass file
    return Preview(compiler, world, wish, own).make();
}

}  // namespace patina::runtime
