#include "runtime/bake/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <future>
#include <optional>
#include <set>

#include "runtime/bake/baked_material.h"
#include "runtime/bake/layers.h"
#include "runtime/bake/texels.h"
#include "runtime/bake/uv_layout.h"
#include "runtime/gltf/gltf_model.h"
#include "runtime/gltf/gltf_writer.h"
#include "runtime/render/complaints.h"
#include "runtime/render/not_finite.h"
#include "runtime/render/prepare_material.h"
#include "runtime/render/render_world.h"
#include "runtime/values/material_values.h"

namespace patina::runtime {
namespace {

// The paths that draw the textures: of metallic and roughness, of the same if the workflow states f0, and of specular
// and glossiness. And the path that has all that a material is made of.
constexpr const char *kPath = "bake", *kConvertedPath = "bake-converted", *kSpecularPath = "bake-specular",
                     *kWholePath = "forward";
// The workflow that states f0.
constexpr std::string_view kSpecularWorkflow = "specular-glossiness";
const std::vector<std::string> kTargets = {"bakedColor", "bakedReflection", "bakedNormal", "bakedEmission",
                                           "bakedCutoff"};
constexpr const char *kValuePath = "bake-value", *kValueTarget = "bakedValue";
// The lighting model without lighting, and that of glTF, with an input that is no layer.
constexpr std::string_view kUnlit = "unlit", kModel = "gltf", kEmissiveStrength = "emissiveStrength";

class Baking {
public:
    Baking(const Compiler& compiler, const BakeRequest& request, RenderMachine& machine)
        : compiler_(compiler), request_(request), machine_(machine) {}

    BakeOutcome run() {
        Outcome<World> world = world_of_graph(request_.render);
        if (!world) return failed(world.error);
        if (!look_at(world.value.materials[0])) return std::move(out_);
        const std::shared_ptr<const Mesh> mesh = world.value.objects[0].mesh;
        Outcome<UvLayout> layout = uv_layout(*mesh, request_.render.size);
        if (!layout) {
            refuse(fmt::format("the mesh '{}' cannot be baked: {}", request_.render.mesh, layout.error));
            return std::move(out_);
        }
        say_overlap(layout.value);
        world.value.objects[0].mesh = std::make_shared<const Mesh>(std::move(layout.value.mesh));
        world.value.view.samples = 1;
        world.value.view.background = glm::vec4(0);
        std::vector<Image> drawn = draw(world.value, path_, kTargets);
        if (drawn.empty()) return std::move(out_);
        std::optional<std::vector<LayerValue>> layers = draw_layers(world.value);
        if (!layers) return std::move(out_);
        const BakedMaterial made = baked_material(request_.name,
                                                  {.color = std::move(drawn[0]),
                                                   .reflection = std::move(drawn[1]),
                                                   .normal = std::move(drawn[2]),
                                                   .emission = std::move(drawn[3]),
                                                   .cutoff = std::move(drawn[4])},
                                                  *layers, state_);
        for (const BakedMaterial::Loss& loss : made.losses) lose(loss.what, loss.why);
        report_not_finite(made.not_finite, world.value, path_, kTargets, "the textures");
        for (const LayerValue& layer : *layers)
            report_not_finite(layer.not_finite, showing(world.value, layer.input), kValuePath, {kValueTarget},
                              fmt::format("'{}'", layer.input));
        write(made, *mesh);
        return std::move(out_);
    }

private:
    // --- what is said

    BakeOutcome failed(std::string error) {
        out_.error = std::move(error);
        return std::move(out_);
    }
    bool refuse(std::string_view why) {
        report({complaint(request_.render.graph, Severity::Error, Complaint::CannotBake, {why})});
        return false;
    }
    void lose(std::string_view what, std::string_view why) {
        report({complaint(request_.render.graph, Severity::Warning, Complaint::NotBaked, {what, why})});
    }
    // The graph is compiled twice, and says the same.
    void report(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& each : diagnostics)
            if (said_.insert(to_text(each)).second) out_.diagnostics.push_back(each);
    }

    void say_overlap(const UvLayout& layout) {
        constexpr double kLeast = 0.001;
        if (layout.overlap < kLeast) return;
        report({complaint(request_.render.graph, Severity::Warning, Complaint::OverlappingUvs,
                          {request_.render.mesh, fmt::format("{:.1f}", 100 * layout.overlap)})});
    }

    // Warns of the texels, and names the node that is the cause of the first one. The textures in `where` hold 0 there.
    // `world`, `path` and `targets` are what was drawn.
    void report_not_finite(const NotFinite& found, const World& world, const char* path,
                           const std::vector<std::string>& targets, std::string_view where) {
        if (found.count == 0) return;
        RenderOptions options = draw_options();
        options.path = path;
        options.also_shown = targets;
        const std::optional<Cause> cause =
            cause_at(compiler_, world, options, {.x = found.first_x, .y = found.first_y});
        const std::size_t size = std::size_t(request_.render.size);
        Diagnostic warning = complaint(
            request_.render.graph, Severity::Warning, Complaint::PixelsNotFinite,
            {std::to_string(found.count), std::to_string(size * size), std::to_string(found.first_x),
             std::to_string(found.first_y), fmt::format("{}; they are 0 in {}", cause ? words_of(*cause) : "", where)});
        if (cause) blame(warning, *cause);
        report({warning});
    }

    // --- the material

    // What the reflection of the whole material says; false if it cannot be baked.
    bool look_at(const WorldMaterial& material) {
        CompileOptions options = compile_options(request_.render.options);
        options.targets.clear();
        options.passes()->path = kWholePath;
        const Result whole = compile_material(compiler_, material, std::move(options));
        report(whole.diagnostics);
        out_.dependencies = whole.dependencies;
        const std::string& mesh = request_.render.mesh;
        if (is_model_name(mesh)) out_.dependencies.push_back(mesh.substr(0, mesh.find('#')));
        if (!whole.ok) return false;
        const Reflection& reflection = whole.reflection;
        out_.lighting = reflection.lighting;
        out_.is_unlit = reflection.lighting == kUnlit;
        path_ = request_.is_specular                       ? kSpecularPath
                : reflection.workflow == kSpecularWorkflow ? kConvertedPath
                                                           : kPath;
        state_ = {.surface = reflection.surface, .is_unlit = out_.is_unlit, .is_specular = request_.is_specular};
        if (reflection.surface == SurfaceKind::Additive || reflection.surface == SurfaceKind::Multiply) {
            return refuse(fmt::format("glTF has no surface of the kind '{}': use opaque, cutout, fade or transparent",
                                      to_string(reflection.surface)));
        }
        if (reflection.surface == SurfaceKind::Transparent && !out_.is_unlit)
            lose("the full strength of reflections on a transparent surface",
                 "the alpha mode BLEND of glTF fades them, too, as 'fade' does");
        for (const Pass& pass : reflection.passes) {
            if (pass.is_extra) {
                lose(fmt::format("the pass '{}'", pass.name), "a glTF material is drawn once");
                continue;
            }
            if (pass.cull == Cull::Front) {
                return refuse("glTF draws front faces: \"cull\" must be back or off");
            }
            state_.is_double_sided = pass.cull == Cull::Off;
        }
        say_fixed(material);
        if (!out_.is_unlit) find_layers(material);
        if (reflection.moves_vertices)
            lose("the movement of the vertices", "the model has the positions and normals of the mesh");
        return true;
    }

    // The inputs of the lighting model that the graph sets: a preview of any other is an error. Inputs that glTF can
    // have are stored.
    void find_layers(const WorldMaterial& material) {
        for (const ModelInfo& model : compiler_.lighting_models()) {
            if (model.name != out_.lighting) continue;
            for (const ModelInputInfo& input : model.inputs) {
                CompileOptions options = compile_options(request_.render.options);
                options.targets.clear();
                if (!compile_material(compiler_, showing(material, input.name), std::move(options)).ok) continue;
                const std::string named = fmt::format("'{}'", input.name);
                if (out_.lighting != kModel)
                    lose(named, fmt::format("only the layers of the lighting model '{}' are baked", kModel));
                else if (request_.is_specular && input.name != kEmissiveStrength)
                    lose(named, "glTF allows no layer together with specular and glossiness");
                else if (is_layer(input.name) || input.name == kEmissiveStrength)
                    layers_.push_back(input.name);
                else
                    lose(named, input.type == "float3" ? "its normal map in tangent space is not made"
                                                       : "glTF has no such input");
            }
        }
    }

    static WorldMaterial showing(WorldMaterial material, const std::string& input) {
        material.preview = "surface." + input;
        return material;
    }

    // A value that the request sets: the switch of the pass, and what the model loses by it.
    struct Fixed {
        std::string_view name;
        bool is_on;
        std::string_view what, why;
    };
    std::array<Fixed, 3> fixed() const {
        const RenderRequest& request = request_.render;
        const bool has_light = !request.lights.empty() || !request.ambient.empty() || !request.environment.empty();
        return {Fixed{"fixedTime", request.time.has_value(), "how the surface changes with the time",
                      "it is as at the second of --time"},
                Fixed{"fixedView", !request.camera.empty(), "how the surface changes with the view",
                      "it is as --camera sees it, from every side"},
                Fixed{"fixedLight", has_light, "how the surface changes with light",
                      "it is as in the light of --light, --env and --ambient"}};
    }

    // The pass is refused without such a value, at the node that reads it. So that node is the reader.
    void say_fixed(const WorldMaterial& material) {
        for (const Fixed& each : fixed()) {
            if (!each.is_on) continue;
            CompileOptions options = compile_options(draw_options(each.name));
            options.passes()->path = path_;
            options.targets.clear();
            for (Diagnostic refusal : compile_material(compiler_, material, std::move(options)).diagnostics) {
                if (refusal.severity != Severity::Error) continue;
                const Diagnostic loss = patina::complaint(Complaint::NotBaked, {each.what, each.why});
                refusal.severity = Severity::Warning;
                refusal.code = loss.code;
                refusal.message = loss.message;
                refusal.notes.clear();
                report({refusal});
            }
        }
    }

    // `left_out`: a switch that stays off.
    RenderOptions draw_options(std::string_view left_out = {}) const {
        const RenderRequest& request = request_.render;
        RenderOptions options = request.options;
        for (const Fixed& each : fixed())
            if (each.is_on && each.name != left_out) options.switches.emplace_back(each.name, "true");
        return options;
    }

    // The pixels of the targets; none after an error.
    std::vector<Image> draw(const World& world, const char* path, const std::vector<std::string>& targets) {
        RenderOptions options = draw_options();
        options.path = path;
        options.also_shown = targets;
        RenderOutcome drawn = draw_world(compiler_, world, options, machine_);
        report(drawn.diagnostics);
        out_.dependencies.insert(out_.dependencies.end(), drawn.dependencies.begin(), drawn.dependencies.end());
        out_.missing_machine = drawn.missing_machine;
        out_.error = drawn.error;
        return drawn.ok ? std::move(drawn.also_shown) : std::vector<Image>();
    }

    std::optional<std::vector<LayerValue>> draw_layers(const World& world) {
        std::vector<LayerValue> made;
        for (const std::string& input : layers_) {
            std::vector<Image> drawn = draw(showing(world, input), kValuePath, {kValueTarget});
            if (drawn.empty()) return std::nullopt;
            Image& image = drawn[0];
            const std::vector<std::uint8_t> covered = covered_texels(image);
            std::vector<std::uint8_t> broken(covered.size());
            make_finite(image, broken);
            const NotFinite found = not_finite(broken, covered, image.width);
            made.push_back({.input = input, .image = shrunk(std::move(image), covered), .not_finite = found});
        }
        return made;
    }

    World showing(World world, const std::string& input) const {
        world.materials[0] = showing(std::move(world.materials[0]), input);
        keep_known(world.materials[0]);
        return world;
    }

    // A preview has no lighting, so properties of the lighting have no place in it.
    void keep_known(WorldMaterial& shown) const {
        CompileOptions options = compile_options(request_.render.options);
        options.targets.clear();
        WorldMaterial plain = shown;
        plain.overrides.clear();
        const Result result = compile_material(compiler_, plain, std::move(options));
        const std::vector<std::string> names = property_names(result.reflection);
        std::erase_if(shown.overrides, [&](const auto& each) {
            return std::find(names.begin(), names.end(), each.first) == names.end();
        });
    }

    // --- the files

    void write(const BakedMaterial& made, const Mesh& mesh) {
        std::vector<std::future<Outcome<std::string>>> encoding;
        for (const BakedMap& map : made.maps)
            encoding.push_back(std::async(std::launch::async, [&map] { return encode_map(map); }));
        std::vector<WrittenPicture> pictures;
        std::string error;
        for (std::size_t i = 0; i < made.maps.size(); i++) {
            Outcome<std::string> png = encoding[i].get();
            if (!png) error = png.error;
            pictures.push_back({.name = request_.name + "." + made.maps[i].name, .png = std::move(png.value)});
        }
        for (std::size_t i = 0; i < made.maps.size() && error.empty(); i++) {
            if (!request_.is_exr) {
                out_.files.push_back({pictures[i].name + ".png", pictures[i].png});
                continue;
            }
            Outcome<std::string> exr = encode_exr(made.maps[i].image);
            if (!exr) error = exr.error;
            out_.files.push_back({pictures[i].name + ".exr", std::move(exr.value)});
        }
        Outcome<std::string> glb = write_glb(request_.name, mesh, made.material, pictures);
        if (error.empty()) error = glb.error;
        out_.files.push_back({request_.name + ".glb", std::move(glb.value)});
        out_.error = std::move(error);
        out_.ok = out_.error.empty();
    }

    const Compiler& compiler_;
    const BakeRequest& request_;
    RenderMachine& machine_;
    const char* path_ = kPath;  // that draws the textures
    BakedState state_{};
    std::vector<std::string> layers_{};  // inputs of the lighting model
    std::set<std::string> said_{};
    BakeOutcome out_{};
};

}  // namespace

BakeOutcome bake(const Compiler& compiler, const BakeRequest& request, RenderMachine& machine) {
    return Baking(compiler, request, machine).run();
}

}  // namespace patina::runtime
