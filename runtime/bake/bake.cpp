#include "runtime/bake/bake.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <set>

#include "runtime/bake/baked_material.h"
#include "runtime/bake/uv_layout.h"
#include "runtime/gltf/gltf_writer.h"
#include "runtime/render/complaints.h"
#include "runtime/render/prepare_material.h"
#include "runtime/render/render_world.h"

namespace patina::runtime {
namespace {

// The path that draws the textures, and one that has all that a material is made of.
constexpr const char *kPath = "bake", *kWholePath = "forward";
const std::vector<std::string> kTargets = {"bakedColor", "bakedReflection", "bakedNormal", "bakedEmission",
                                           "bakedCutoff"};
constexpr std::string_view kUnlit = "unlit";

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
        Outcome<BakedTargets> drawn = draw(std::move(world.value));
        if (!drawn) return failed(drawn.error);
        if (drawn.value.color.pixels.empty()) return std::move(out_);
        const BakedMaterial made = baked_material(request_.name, std::move(drawn.value), state_);
        report_losses(made);
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

    void report_losses(const BakedMaterial& made) {
        for (const BakedMaterial::Loss& loss : made.losses) lose(loss.what, loss.why);
        if (made.not_finite == 0) return;
        const int size = request_.render.size;
        report(
            {complaint(request_.render.graph, Severity::Warning, Complaint::PixelsNotFinite,
                       {std::to_string(made.not_finite), std::to_string(std::size_t(size) * std::size_t(size)),
                        std::to_string(made.first_x), std::to_string(made.first_y), "; they are 0 in the textures"})});
    }

    // --- the material

    // What the reflection of the whole material says; false if it cannot be baked.
    bool look_at(const WorldMaterial& material) {
        CompileOptions options = compile_options(request_.render.options);
        options.targets.clear();
        options.path = kWholePath;
        const Result whole = compile_material(compiler_, material, std::move(options));
        report(whole.diagnostics);
        out_.dependencies = whole.dependencies;
        if (!whole.ok) return false;
        const Reflection& reflection = whole.reflection;
        out_.lighting = reflection.lighting;
        out_.is_unlit = reflection.lighting == kUnlit;
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
        say_inputs(material);
        if (reflection.moves_vertices)
            lose("the movement of the vertices", "the model has the positions and normals of the mesh");
        return true;
    }

    // The inputs of the lighting model that the graph sets: a preview of any other is an error.
    void say_inputs(const WorldMaterial& material) {
        for (const ModelInfo& model : compiler_.lighting_models()) {
            if (model.name != out_.lighting) continue;
            for (const ModelInputInfo& input : model.inputs) {
                WorldMaterial shown = material;
                shown.preview = "surface." + input.name;
                CompileOptions options = compile_options(request_.render.options);
                options.targets.clear();
                if (compile_material(compiler_, shown, std::move(options)).ok)
                    lose(fmt::format("'{}'", input.name),
                         "of the surface, only the inputs of every lighting model are baked");
            }
        }
    }

    RenderOptions draw_options() const {
        const RenderRequest& request = request_.render;
        RenderOptions options = request.options;
        options.path = kPath;
        options.also_shown = kTargets;
        const auto turn_on = [&](const char* name, bool is_on) {
            if (is_on) options.switches.emplace_back(name, "true");
        };
        turn_on("fixedTime", request.time.has_value());
        turn_on("fixedView", !request.camera.empty());
        turn_on("fixedLight", !request.lights.empty() || !request.ambient.empty() || !request.environment.empty());
        turn_on("specularGlossiness", request_.is_specular);
        return options;
    }

    Outcome<BakedTargets> draw(World world) {
        world.view.samples = 1;
        world.view.background = glm::vec4(0);
        RenderOutcome drawn = draw_world(compiler_, world, draw_options(), machine_);
        report(drawn.diagnostics);
        out_.dependencies.insert(out_.dependencies.end(), drawn.dependencies.begin(), drawn.dependencies.end());
        out_.missing_machine = drawn.missing_machine;
        if (!drawn.error.empty()) return Failure{drawn.error};
        if (!drawn.ok) return BakedTargets{};
        std::vector<Image>& images = drawn.also_shown;
        return BakedTargets{.color = std::move(images[0]),
                            .reflection = std::move(images[1]),
                            .normal = std::move(images[2]),
                            .emission = std::move(images[3]),
                            .cutoff = std::move(images[4])};
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
    BakedState state_{};
    std::set<std::string> said_{};
    BakeOutcome out_{};
};

}  // namespace

BakeOutcome bake(const Compiler& compiler, const BakeRequest& request, RenderMachine& machine) {
    return Baking(compiler, request, machine).run();
}

}  // namespace patina::runtime
