#include "runtime/render/render_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "patina/validate.h"
#include "runtime/cpu/cpu_render.h"
#include "runtime/cpu/cpu_trace.h"
#include "runtime/frame/frame_plan.h"
#include "runtime/frame/tiles.h"
#include "runtime/render/complaints.h"
#include "runtime/render/object_textures.h"
#include "runtime/render/prepare_material.h"
#include "runtime/values/scene_values.h"

namespace patina::runtime {
namespace {

constexpr std::string_view kPicture = "color";
constexpr const char* kBackgroundPath = "backdrop";

// The properties of an object that its shaders depend on, in addition to its graph.
struct Variant {
    std::size_t material = 0;
    bool lightmap = false, shadow_mask = false;
    friend bool operator==(const Variant&, const Variant&) = default;
};

using Spirv = std::vector<std::uint32_t>;

// The size of a module, without the instructions that only name things or describe its source (sections 3.52.1 to 3 of
// the SPIR-V specification): a longer name does not make a shader slower.
std::size_t bytes_without_names(const Spirv& module) {
    constexpr std::size_t kHeader = 5;  // words
    constexpr std::uint32_t kFirstDebug = 2, kLastDebug = 8, kNoLine = 317, kModuleProcessed = 330;
    std::size_t words = std::min(module.size(), kHeader);
    for (std::size_t at = kHeader; at < module.size();) {
        const std::uint32_t opcode = module[at] & 0xffff, length = std::max(module[at] >> 16, 1u);
        const bool is_debug =
            (opcode >= kFirstDebug && opcode <= kLastDebug) || opcode == kNoLine || opcode == kModuleProcessed;
        if (!is_debug) words += length;
        at += length;
    }
    return words * sizeof(std::uint32_t);
}

// A pass of the material reads this target.
bool reads(const Reflection& reflection, std::string_view target) {
    for (const Pass& pass : reflection.passes)
        for (const Texture& texture : reflection.textures)
            if (texture.reads == target && std::ranges::find(pass.textures, texture.name) != pass.textures.end())
                return true;
    return false;
}

class Drawing {
public:
    Drawing(const Compiler& compiler, const World& world, const RenderOptions& options, RenderMachine& machine)
        : compiler_(compiler), world_(world), options_(options), machine_(machine) {}

    RenderOutcome run() {
        find_variants();
        prepare();
        if (!ok_) return std::move(outcome_);
        if (std::string error = no_picture(); !error.empty()) return failed(std::move(error));
        Outcome<Frame> frame = plan();
        if (!frame) return failed(frame.error);
        if (wants_tiles(frame.value, options_.most_target_bytes)) {
            const std::string reason = whole_reason(frame.value);
            if (!reason.empty()) {
                if (std::string error = too_large_frame(frame.value, reason); !error.empty()) return failed(error);
            } else {
                frame = plan_tiles();
                if (!frame) return failed(frame.error);
            }
        }
        if (options_.progress) frame.value.progress = [this](double share) { options_.progress(share, {}); };
        return draw(frame.value);
    }

    // Everything but the picture; materials that no object has, too.
    RenderOutcome check() {
        is_drawing_ = false;
        find_variants();
        for (std::size_t i = 0; i < world_.materials.size(); ++i) {
            const auto is_of = [&](const Variant& variant) { return variant.material == i; };
            if (std::any_of(variants_.begin(), variants_.end(), is_of)) continue;
            variants_.push_back({.material = i});
            spread_.materials.push_back(world_.materials[i]);
        }
        prepare();
        if (!ok_) return std::move(outcome_);
        // All paths at once draw no frame.
        const Outcome<Frame> frame = options_.path == "all" ? Outcome<Frame>(Frame{}) : plan();
        if (!frame) return failed(frame.error);
        outcome_.ok = true;
        return std::move(outcome_);
    }

    // `options.via` is "cpu".
    TraceOutcome trace(const TraceWish& wish) {
        is_tracing_ = true;
        find_variants();
        prepare();
        TraceOutcome traced;
        if (ok_) outcome_.error = no_picture();
        if (ok_ && outcome_.error.empty()) {
            Outcome<Frame> frame = plan();
            if (options_.progress) frame.value.progress = [this](double share) { options_.progress(share, {}); };
            Outcome<PixelTrace> pixel = frame ? cpu_trace(frame.value, wish) : Failure{frame.error};
            outcome_.error = pixel.error;
            traced.trace = std::move(pixel.value);
            traced.ok = outcome_.error.empty();
        }
        if (traced.ok) name_traced(traced);
        traced.diagnostics = std::move(outcome_.diagnostics);
        traced.error = std::move(outcome_.error);
        return traced;
    }

private:
    // The first that draws objects as the camera sees them.
    static std::string shown_pass(const PreparedMaterial& material) {
        for (const Pass& pass : material.compiled.reflection.passes)
            if (pass.draws == PassDraws::Objects && pass.lights != PassLights::Shadowed) return pass.name;
        return "";
    }

    // The names for the things that a trace found, and the messages about its material.
    void name_traced(TraceOutcome& traced) {
        for (std::size_t object : traced.trace.seen) traced.seen.push_back(world_.objects[object].name);
        traced.pass = traced.trace.object || compiled_.empty() ? traced.trace.pass : shown_pass(*compiled_.front());
        if (!traced.trace.object) return;
        const std::size_t object = *traced.trace.object;
        const WorldMaterial& material = world_.materials[world_.objects[object].material];
        traced.object = world_.objects[object].name;
        traced.material = material.name;
        traced.graph = material.graph;
        traced.instances = world_.objects[object].instances.size();
        const Reflection& reflection = compiled_[spread_.objects[object].material]->compiled.reflection;
        if (const auto warning = anisotropy_warning(material.graph, reflection, traced.pass)) report({*warning});
    }

    // Checks each material, the textures of the objects, and the shaders; reports as many problems as possible.
    void prepare() {
        for (std::size_t i = 0; i < variants_.size(); ++i) compile(i);
        choose_backdrop();
        compile_background();
        ObjectTextures loaded = load_object_textures(world_);
        report(loaded.diagnostics);
        add_dependencies(loaded.files);
        ok_ &= loaded.ok;
        if (!ok_) return;
        object_textures_ = std::move(loaded.textures);
        give_instance_values();
        if (!ok_) return;
        for (const auto& material : compiled_) drawn_.push_back(drawn_material(*material));
    }

    // Empty, or why nothing would be seen: no pass draws into the picture.
    std::string no_picture() const {
        std::vector<std::string> drawn;
        if (variants_.empty() || !options_.also_shown.empty()) return "";
        for (std::size_t i = 0; i < variants_.size(); ++i) {
            for (const Pass& pass : compiled_[i]->compiled.reflection.passes) {
                for (const RenderTarget& target : pass.targets) {
                    if (target.name == kPicture) return "";
                    if (std::find(drawn.begin(), drawn.end(), target.name) == drawn.end()) drawn.push_back(target.name);
                }
            }
        }
        std::string error = fmt::format("the path '{}' draws no picture: ", path_name());
        if (drawn.empty()) return error + "its passes write only depth: use 'patina compile' for it";
        error +=
            fmt::format("none of its passes writes the target '{}', only '{}'", kPicture, fmt::join(drawn, "', '"));
        const auto is_near = [](const std::string& name) {
            return suggestion(name, {std::string(kPicture)}).starts_with("did you mean");
        };
        const auto near = std::find_if(drawn.begin(), drawn.end(), is_near);
        return near == drawn.end() ? error : fmt::format("{}; did you mean '{}' by '{}'?", error, kPicture, *near);
    }

    Outcome<Frame> plan() {
        if (!compiled_.empty()) spread_.view.camera.clip_depth = compiled_.front()->compiled.reflection.clip_depth;
        Outcome<Frame> frame =
            plan_frame(spread_, drawn_,
                       {.path = path_name(),
                        .shadow_atlas_size = options_.shadow_atlas_size,
                        .exact = options_.exact_targets,
                        .shown_format = options_.stated_formats ? std::nullopt : std::optional(TargetFormat::Rgba32F),
                        .background = background_,
                        .object_textures = object_textures_,
                        .instance_values = instance_values_});
        return frame ? with_further_targets(std::move(frame.value)) : std::move(frame);
    }

    Outcome<Frame> with_further_targets(Frame frame) const {
        for (const std::string& name : options_.also_shown) {
            const auto found = std::find_if(frame.targets.begin(), frame.targets.end(),
                                            [&](const FrameTarget& target) { return target.name == name; });
            if (found == frame.targets.end())
                return Failure{fmt::format("no pass of the path '{}' writes the target '{}'", path_name(), name)};
            frame.also_shown.push_back(std::size_t(found - frame.targets.begin()));
        }
        return frame;
    }

    // The materials again, for targets that hold one tile.
    Outcome<Frame> plan_tiles() {
        is_in_tiles_ = true;
        compiled_.clear();
        drawn_.clear();
        instance_values_.clear();
        outcome_.dependencies.clear();
        outcome_.shaders.clear();
        spirv_.clear();
        prepare();
        if (!ok_) return Failure{outcome_.error};
        Outcome<Frame> frame = plan();
        if (!frame) return frame;
        frame.value.tile = tile_side(frame.value, options_.most_target_bytes);
        frame.value.largest_viewport = options_.largest_viewport;
        return frame;
    }

    // Empty, or why a picture that cannot be drawn in tiles for this reason cannot be drawn as a whole either.
    std::string too_large_frame(const Frame& frame, const std::string& reason) {
        const Scene& view = world_.view;
        const auto bytes_with = [&](int width, int height, int samples) {
            return target_bytes(frame, width * samples, height * samples);
        };
        const auto fits = [&](int width, int height, int samples) {
            const int side = std::max(width, height) * samples;
            return side <= kLargestImage && bytes_with(width, height, samples) <= options_.most_whole_bytes;
        };
        if (fits(view.width, view.height, view.samples)) return "";
        std::string error = fmt::format(
            "{}, so the picture cannot be drawn in tiles; {} x {} pixels of {} x {} samples at once need {:.1f} GiB of "
            "render targets, and the limit is {:.1f} GiB and {} samples on a side: ",
            reason, view.width, view.height, view.samples, view.samples,
            gibibytes(bytes_with(view.width, view.height, view.samples)), gibibytes(options_.most_whole_bytes),
            kLargestImage);
        int samples = view.samples - 1;
        while (samples > 0 && !fits(view.width, view.height, samples)) samples--;
        if (samples > 0) return error + fmt::format("use --samples {}", samples);
        int divisor = 2;
        const auto part = [&](int side) { return std::max(side / divisor, 1); };
        while (!fits(part(view.width), part(view.height), 1)) divisor++;
        return error + fmt::format("use --samples 1 and a smaller picture, of {} x {} pixels", part(view.width),
                                   part(view.height));
    }
    static double gibibytes(std::size_t bytes) { return double(bytes) / double(std::size_t(1) << 30); }

    bool on_cpu() const { return options_.via == "cpu"; }
    Target target() const { return {.engine = options_.engine, .language = options_.via == "hlsl" ? "hlsl" : "glsl"}; }

    RenderOutcome failed(std::string error) {
        outcome_.ok = false;
        outcome_.error = std::move(error);
        ok_ = false;
        return std::move(outcome_);
    }

    // --- materials

    // Objects with baked light need other shaders than those without: each combination becomes a material of its own.
    void find_variants() {
        spread_ = world_;
        spread_.materials.clear();
        for (WorldObject& object : spread_.objects) {
            const Variant wanted{.material = object.material,
                                 .lightmap = !object.lightmap.empty(),
                                 .shadow_mask = !object.shadow_mask.empty()};
            auto found = std::find(variants_.begin(), variants_.end(), wanted);
            if (found == variants_.end()) {
                found = variants_.insert(found, wanted);
                spread_.materials.push_back(world_.materials[wanted.material]);
            }
            object.material = static_cast<std::size_t>(found - variants_.begin());
        }
    }

    std::vector<std::pair<std::string, std::string>> switches_of(const Variant& variant) const {
        const Scene& view = world_.view;
        const auto any_light = [&](auto has) { return std::any_of(view.lights.begin(), view.lights.end(), has); };
        std::vector<std::pair<std::string, std::string>> switches;
        const auto set = [&](const char* name, bool value) {
            if (value) switches.emplace_back(name, "true");
        };
        set("shadows", any_light([](const Light& light) { return light.shadow.casts; }));
        set("cookies", any_light([](const Light& light) { return light.cookie != nullptr; }));
        set("fog", view.fog.mode != FogMode::None);
        set("reflectionProbes", !view.probes.empty());
        set("lightmap", variant.lightmap);
        set("shadowMask", variant.shadow_mask);
        const MixedLighting& mixed = view.mixed_lighting;
        set("subtractive", variant.lightmap && mixed.mode == LightMixing::Subtractive);
        set("distanceShadowMask", mixed.mode == LightMixing::DistanceShadowMask);
        set("shadowsFade", mixed.shadow_distance.has_value());
        set("tiles", is_in_tiles_);
        switches.insert(switches.end(), options_.switches.begin(), options_.switches.end());
        return switches;
    }

    Result compile_for(const Variant& variant, const std::string& path) const {
        CompileOptions options = compile_options(options_);
        if (is_drawing_) options.targets = {target()};
        if (is_tracing_) options.targets.clear();  // what is run is the program, not a text
        options.passes()->path = path;
        options.switches = switches_of(variant);
        options.keep_programs = on_cpu();
        return compile_material(compiler_, world_.materials[variant.material], std::move(options));
    }

    void add_dependencies(const std::vector<std::string>& files) {
        outcome_.dependencies.insert(outcome_.dependencies.end(), files.begin(), files.end());
    }

    // Several variants of one graph say the same.
    void report(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            if (said_.insert(to_text(diagnostic)).second) outcome_.diagnostics.push_back(diagnostic);
        }
    }

    void compile(std::size_t index) {
        const Variant& variant = variants_[index];
        const WorldMaterial& material = world_.materials[variant.material];
        Result compiled = compile_for(variant, options_.path);
        if (compiled.ok) {
            const std::string stated = compiled.reflection.path;
            const std::string path = path_for(world_.view.camera, compiled.reflection);
            if (path != stated && !path.empty()) {
                // The problem is the camera, not the material: it is reported once.
                report({complaint({}, Severity::Warning, Complaint::PathRefused, {stated, path})});
                compiled = compile_for(variant, path);
            }
        }
        report(compiled.diagnostics);
        auto made = std::make_unique<PreparedMaterial>(prepare_material(material, std::move(compiled), options_));
        report(made->diagnostics);
        if (!made->error.empty()) outcome_.error = made->error;
        add_dependencies(made->compiled.dependencies);
        add_dependencies(made->compiled.missing);
        add_dependencies(made->loaded.files);
        if (made->ok) finish(material, *made);
        ok_ &= made->ok;
        compiled_.push_back(std::move(made));
    }

    // A picture of the surroundings is seen through glass.
    void choose_backdrop() {
        const Scene& view = world_.view;
        if (!view.is_default_background || !view.picture_intensity) return;
        const auto reads_picture = [](const auto& material) { return reads(material->compiled.reflection, kPicture); };
        if (std::ranges::any_of(compiled_, reads_picture)) spread_.view.backdrop = SceneBackdrop::Environment;
    }

    // A material without an object, after the others, whose path draws the surroundings.
    void compile_background() {
        spread_.materials.resize(variants_.size());
        if (spread_.view.backdrop == SceneBackdrop::Color) return;
        const WorldMaterial material{.name = "the background", .graph = "background"};
        CompileOptions options;
        options.request = CompileOptions::Passes{.path = kBackgroundPath};
        options.targets = is_drawing_ && !is_tracing_ ? std::vector{target()} : std::vector<Target>();
        options.keep_programs = on_cpu();
        const bool is_blurred = spread_.view.backdrop == SceneBackdrop::Blurred;
        options.switches = {{"blurredBackground", is_blurred ? "true" : "false"},
                            {"tiles", is_in_tiles_ ? "true" : "false"}};
        Result compiled = compiler_.compile_text(material.graph, R"({ "patina": 1, "workflow": "unlit" })", options);
        report(compiled.diagnostics);
        auto made = std::make_unique<PreparedMaterial>(prepare_material(material, std::move(compiled), options_));
        if (made->ok) finish(material, *made);
        ok_ &= made->ok;
        background_ = spread_.materials.size();
        spread_.materials.push_back(material);
        compiled_.push_back(std::move(made));
    }

    // Adds the values that the world sets in the material, and the messages about how it will be drawn.
    void finish(const WorldMaterial& material, PreparedMaterial& made) {
        const Reflection& reflection = made.compiled.reflection;
        if (is_drawing_) add_engine_textures(made.loaded.textures, reflection, world_.view);
        report(cookie_warnings(material.graph, reflection, world_.view));
        if (is_pass_file()) report(unknown_value_warnings(options_.path, reflection));
        if (!on_cpu() || is_tracing_) return;
        if (const auto warning = anisotropy_warning(material.graph, reflection)) report({*warning});
    }

    // The material's values, but for those that an instance has itself.
    void give_instance_values() {
        instance_values_.resize(spread_.objects.size());
        for (std::size_t i = 0; i < spread_.objects.size(); ++i) {
            const WorldObject& object = spread_.objects[i];
            const PreparedMaterial& made = *compiled_[object.material];
            const Reflection& reflection = made.compiled.reflection;
            for (const WorldInstance& instance : object.instances) {
                const SceneFaults faults = check_values(reflection, spread_.materials[object.material], instance);
                report(faults.diagnostics);
                ok_ &= faults.ok;
                if (!faults.ok) continue;
                const Outcome<MaterialValues> own = material_values(reflection, instance.overrides);
                if (!own) {
                    ok_ = false;
                    outcome_.error = object.name + ": " + own.error;
                    return;
                }
                MaterialValues& values = instance_values_[i].emplace_back(made.values);
                for (const auto& [name, number] : own.value.numbers)
                    if (instance.overrides.contains(name)) values.numbers[name] = number;
            }
        }
    }

    // --- shaders

    // Materials that differ in their values alone have the same text; so have lighting passes of one lighting graph.
    const Spirv* spirv_of(const Shader& shader) {
        const auto [found, is_new] = spirv_.try_emplace(shader.text);
        if (!is_new) return &found->second;
        if (!on_cpu()) {
            Validated validated = validate(shader);
            report(validated.diagnostics);
            found->second = std::move(validated.spirv);
            if (!validated.ok) ok_ = false;
            // A driver takes memory and time for all calls written out, and nobody can stop it.
            if (const std::optional<Diagnostic> why = too_large(shader, found->second); validated.ok && why) {
                report({*why});
                ok_ = false;
            }
        }
        outcome_.shaders.push_back(
            {.file_name = shader.file_name, .text = shader.text, .spirv_bytes = bytes_without_names(found->second)});
        return &found->second;
    }

    DrawnMaterial drawn_material(const PreparedMaterial& material) {
        DrawnMaterial drawn{.reflection = &material.compiled.reflection,
                            .values = material.values,
                            .textures = material.loaded.textures};
        for (const Pass& pass : material.compiled.reflection.passes) {
            DrawnPass& made = drawn.passes[pass.name];
            made.stages.program = material.compiled.program.get();
            for (const Shader& shader : material.compiled.shaders) {
                if (shader.pass != pass.name) continue;
                if (shader.stage == Stage::Fragment) made.fragment = shader.text;
                const Spirv* spirv = spirv_of(shader);
                if (on_cpu() || shader.target != target()) continue;
                (shader.stage == Stage::Vertex ? made.stages.vertex_spirv : made.stages.fragment_spirv) = *spirv;
            }
        }
        return drawn;
    }

    // The requested path as reflections name it.
    bool is_pass_file() const { return options_.path.ends_with(".hlsl"); }
    std::string path_name() const {
        if (!is_pass_file()) return options_.path;
        const std::string name = std::filesystem::path(options_.path).filename().string();
        return name.substr(0, name.find('.', 1));
    }

    // --- drawing

    Outcome<std::vector<Image>> gpu_draw(const Frame& frame) {
        std::string error = open_machine(options_.device, options_.validation, machine_);
        if (error.empty()) error = machine_.renderer->beyond_limits(frame);
        outcome_.missing_machine = !error.empty();
        if (!error.empty()) return Failure{error};
        const std::size_t messages_before = machine_.renderer->messages().size();
        outcome_.device = machine_.renderer->device_name();
        outcome_.driver = machine_.renderer->driver();
        Outcome<std::vector<Image>> images = machine_.renderer->draw_all(frame);
        const std::vector<std::string>& messages = machine_.renderer->messages();
        if (images && messages.size() > messages_before)
            return Failure{"the Vulkan validation layer reports: " + messages[messages_before]};
        return images;
    }

    RenderOutcome draw(const Frame& frame) {
        if (on_cpu()) outcome_.device = "CPU reference";
        Outcome<std::vector<Image>> images = on_cpu() ? cpu_draw_all(frame) : gpu_draw(frame);
        if (!images) return failed(images.error);
        outcome_.image = std::move(images.value.front());
        outcome_.also_shown.assign(std::make_move_iterator(images.value.begin() + 1),
                                   std::make_move_iterator(images.value.end()));
        if (!compiled_.empty()) outcome_.reflection = compiled_.front()->compiled.reflection;
        outcome_.draws = frame.steps.size();
        outcome_.tiles = tiles_of(frame).size();
        outcome_.ok = true;
        return std::move(outcome_);
    }

    const Compiler& compiler_;
    const World& world_;
    const RenderOptions& options_;
    RenderMachine& machine_;
    RenderOutcome outcome_{};
    bool ok_ = true;
    bool is_drawing_ = true;
    bool is_in_tiles_ = false;
    bool is_tracing_ = false;
    World spread_{};  // the world, with a material for each variant
    std::vector<Variant> variants_{};
    std::optional<std::size_t> background_{};                    // a material of `spread_`
    std::vector<std::unique_ptr<PreparedMaterial>> compiled_{};  // one for each variant, and the background's
    std::vector<DrawnMaterial> drawn_{};                         // in their order
    std::vector<std::vector<LoadedTexture>> object_textures_{};
    std::vector<std::vector<MaterialValues>> instance_values_{};  // by object
    std::map<std::string, Spirv> spirv_{};                        // by text
    std::set<std::string> said_{};
};

}  // namespace

RenderOutcome draw_world(const Compiler& compiler, const World& world, const RenderOptions& options,
                         RenderMachine& machine) {
    return Drawing(compiler, world, options, machine).run();
}

TraceOutcome trace_world(const Compiler& compiler, const World& world, RenderOptions options, const TraceWish& wish) {
    options.via = "cpu";
    RenderMachine none;
    return Drawing(compiler, world, options, none).trace(wish);
}

RenderOutcome check_world(const Compiler& compiler, const World& world, const RenderOptions& options) {
    RenderMachine none;
    return Drawing(compiler, world, options, none).check();
}

}  // namespace patina::runtime
