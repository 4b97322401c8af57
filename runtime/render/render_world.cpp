#include "runtime/render/render_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "patina/validate.h"
#include "runtime/scene/scene_values.h"
#include "runtime/scene/view.h"
#include "runtime/values/engine_values.h"

namespace patina::runtime {
namespace {

constexpr std::string_view kPicture = "color";

// What the shaders of an object depend on beside its graph.
struct Variant {
    std::size_t material = 0;
    bool lightmap = false, shadow_mask = false;
    friend auto operator<=>(const Variant&, const Variant&) = default;
};

using Spirv = std::vector<std::uint32_t>;

// A material that has been compiled, and everything that its draws point to.
struct Compiled {
    Result result;
    MaterialValues values;
    LoadedTextures loaded;
};

Diagnostic complaint(const std::string& file, Severity severity, std::string code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    diagnostic.file = file;
    return diagnostic;
}

class Drawing {
public:
    Drawing(const Compiler& compiler, const World& world, const WorldOptions& options, RenderMachine& machine)
        : compiler_(compiler), world_(world), options_(options), machine_(machine) {}

    RenderOutcome run() {
        find_variants();
        prepare();
        if (!ok_) return std::move(outcome_);
        if (std::string error = no_picture(); !error.empty()) return failed(std::move(error));
        Outcome<Frame> frame = plan();
        if (!frame) return failed(frame.error);
        frame.value.progress = options_.progress;
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

private:
    // Each material, the pictures of the objects, and the shaders; tells of as much as there is.
    void prepare() {
        for (std::size_t i = 0; i < variants_.size(); ++i) compile(i);
        load_object_textures();
        if (!ok_) return;
        give_instance_values();
        if (!ok_) return;
        for (const auto& material : compiled_) drawn_.push_back(drawn_material(*material));
    }

    // Empty, or why nothing would be seen: no pass draws into the picture.
    std::string no_picture() const {
        std::vector<std::string> drawn;
        if (compiled_.empty()) return "";
        for (const auto& material : compiled_) {
            for (const Pass& pass : material->result.reflection.passes) {
                for (const RenderTarget& target : pass.targets) {
                    if (target.name == kPicture) return "";
                    if (std::find(drawn.begin(), drawn.end(), target.name) == drawn.end()) drawn.push_back(target.name);
                }
            }
        }
        std::string error = fmt::format("the path '{}' draws no picture: ", path_name());
        if (drawn.empty()) return error + "its passes write depth alone, which 'patina compile' is for";
        error += fmt::format("no pass of it writes the target '{}', but '{}'", kPicture, fmt::join(drawn, "', '"));
        const auto is_near = [](const std::string& name) {
            return suggestion(name, {std::string(kPicture)}).starts_with("did you mean");
        };
        const auto near = std::find_if(drawn.begin(), drawn.end(), is_near);
        return near == drawn.end() ? error : fmt::format("{}; did you mean '{}' by '{}'?", error, kPicture, *near);
    }

    Outcome<Frame> plan() const {
        return plan_frame(spread_, drawn_,
                          {.path = path_name(),
                           .shadow_atlas_size = options_.shadow_atlas_size,
                           .exact = options_.exact_targets,
                           .shown_format = options_.stated_formats ? "" : "rgba32f",
                           .object_textures = object_textures_,
                           .instance_values = instance_values_});
    }

    bool on_cpu() const { return options_.via == "cpu"; }
    Target target() const { return options_.via == "hlsl" ? Target::Hlsl : Target::Glsl; }

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
        set("lightmap", variant.lightmap);
        set("shadowMask", variant.shadow_mask);
        const MixedLighting& mixed = view.mixed_lighting;
        set("subtractive", variant.lightmap && mixed.mode == LightMixing::Subtractive);
        set("distanceShadowMask", mixed.mode == LightMixing::DistanceShadowMask);
        set("shadowsFade", mixed.shadow_distance.has_value());
        switches.insert(switches.end(), options_.switches.begin(), options_.switches.end());
        return switches;
    }

    // Values may ask for other variants than the graph's own: then it is compiled once more, for them.
    Result compile_for(const Variant& variant, const std::string& path) const {
        const WorldMaterial& material = world_.materials[variant.material];
        Result made = compile_with(variant, path, {});
        if (!made.ok || material.overrides.empty()) return made;
        const Spelling spelling = material.set.empty() ? Spelling::Words : Spelling::Json;
        const auto wanted = keywords_of(made.reflection, material.overrides, spelling);
        return wanted.empty() ? made : compile_with(variant, path, wanted);
    }

    Result compile_with(const Variant& variant, const std::string& path,
                        const std::vector<std::pair<std::string, std::string>>& keywords) const {
        CompileOptions options;
        if (is_drawing_) options.targets = {target()};
        options.path = path;
        options.switches = switches_of(variant);
        options.switches.insert(options.switches.end(), keywords.begin(), keywords.end());
        options.include_dirs = options_.include_dirs;
        options.preview = options_.preview;
        options.keep_programs = on_cpu();
        return compiler_.compile_file(world_.materials[variant.material].graph, options);
    }

    // Several variants of one graph say the same.
    void report(const std::vector<Diagnostic>& diagnostics) {
        for (const Diagnostic& diagnostic : diagnostics) {
            if (said_.insert(to_text(diagnostic)).second) outcome_.diagnostics.push_back(diagnostic);
        }
    }

    // The CPU reference samples without anisotropy.
    void warn_of_anisotropy(const WorldMaterial& material, const Reflection& reflection) {
        std::string names;
        for (const Texture& texture : reflection.textures) {
            const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
                return std::count(pass.textures.begin(), pass.textures.end(), texture.name) > 0;
            });
            if (is_read && texture.sampler.anisotropy > 1) names += (names.empty() ? "'" : ", '") + texture.name + "'";
        }
        if (!names.empty())
            report({complaint(material.graph, Severity::Warning, "no-anisotropy",
                              "the CPU reference samples without anisotropy: " + names)});
    }

    // A draw binds one cookie (engine_values.h), whatever lights it loops over.
    void warn_of_cookies(const WorldMaterial& material, const Reflection& reflection) {
        const std::vector<Light>& lights = world_.view.lights;
        const auto cookies = std::count_if(lights.begin(), lights.end(), [](const Light& l) { return has_cookie(l); });
        for (const Pass& pass : reflection.passes) {
            const bool is_read = std::count(pass.textures.begin(), pass.textures.end(), "lightCookie") > 0;
            if (cookies < 2 || !is_read || pass.each != "once" || pass.lights != "all") continue;
            report({complaint(material.graph, Severity::Warning, "one-cookie",
                              fmt::format("the pass '{}' draws all lights at once and has one of their {} cookies, the "
                                          "first; paths that draw each light by itself have every light's own",
                                          pass.name, cookies))});
        }
    }

    // A pass file may declare values of an engine that only its author's engine has.
    void warn_of_unknown_values(const Reflection& reflection) {
        const std::vector<std::string> known = engine_value_names();
        for (const Block& block : reflection.blocks) {
            const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
                return std::count(pass.blocks.begin(), pass.blocks.end(), block.name) > 0;
            });
            if (block.is_material || !is_read) continue;
            for (const BlockMember& member : block.members) {
                if (std::find(known.begin(), known.end(), member.name) != known.end()) continue;
                Diagnostic unknown = complaint(
                    options_.path, Severity::Warning, "no-engine-value",
                    fmt::format("there is no value for '{}' of the block '{}': it is 0", member.name, block.name));
                if (std::string advice = suggestion(member.name, known); advice.starts_with("did you mean")) {
                    Diagnostic& note = unknown.notes.emplace_back();
                    note.severity = Severity::Note;
                    note.message = std::move(advice);
                }
                report({unknown});
            }
        }
    }

    void compile(std::size_t index) {
        const Variant& variant = variants_[index];
        const WorldMaterial& material = world_.materials[variant.material];
        auto made = std::make_unique<Compiled>();
        made->result = compile_for(variant, options_.path);
        if (made->result.ok) {
            const Reflection& reflection = made->result.reflection;
            const std::string path = path_for(world_.view.camera, reflection);
            if (path != reflection.path && !path.empty()) {
                // Of the camera, not of the material: said once.
                report({complaint({}, Severity::Warning, "path-refused",
                                  fmt::format("the path '{}' needs a perspective camera; its materials are drawn along "
                                              "the path '{}'",
                                              reflection.path, path))});
                made->result = compile_for(variant, path);
            }
        }
        report(made->result.diagnostics);
        const bool is_good = made->result.ok && give_values(material, *made);
        if (is_good) warn_of_cookies(material, made->result.reflection);
        if (is_good && is_pass_file()) warn_of_unknown_values(made->result.reflection);
        if (is_good && on_cpu()) warn_of_anisotropy(material, made->result.reflection);
        ok_ &= is_good;
        compiled_.push_back(std::move(made));
    }

    bool give_values(const WorldMaterial& material, Compiled& made) {
        const Reflection& reflection = made.result.reflection;
        const SceneFaults faults = check_values(reflection, material);
        report(faults.diagnostics);
        if (!faults.ok) return false;
        Outcome<MaterialValues> values = material_values(reflection, material.overrides);
        if (!values) {
            outcome_.error = material.name.empty() ? values.error : material.name + ": " + values.error;
            return false;
        }
        made.values = std::move(values.value);
        for (const std::string& warning : made.values.warnings) {
            if (material.set.empty()) report({complaint(material.graph, Severity::Warning, "soft-range", warning)});
        }
        const std::string folder = std::filesystem::path(material.graph).parent_path().string();
        made.loaded = load_textures(reflection, folder, made.values.textures, options_.exact_textures);
        for (std::size_t i = 0; i < made.loaded.errors.size(); ++i) {
            const ScenePlace* place = place_of_value(material, made.loaded.failed[i]);
            report({place ? diagnostic_at(*place, "bad-texture", made.loaded.errors[i])
                          : complaint(material.graph, Severity::Error, "bad-texture", made.loaded.errors[i])});
        }
        if (is_drawing_) add_engine_textures(made.loaded.textures, reflection, world_.view);
        return made.loaded.errors.empty();
    }

    // The material's values, but for those that an instance has itself.
    void give_instance_values() {
        instance_values_.resize(spread_.objects.size());
        for (std::size_t i = 0; i < spread_.objects.size(); ++i) {
            const WorldObject& object = spread_.objects[i];
            const Compiled& made = *compiled_[object.material];
            const Reflection& reflection = made.result.reflection;
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

    // --- textures of objects

    void load_object_textures() {
        std::map<std::string, LoadedTexture> known;
        object_textures_.resize(world_.objects.size());
        const auto load = [&](std::size_t object, const std::string& name, const std::string& file,
                              const ScenePlace& place, bool is_color) {
            if (file.empty()) return;
            const std::string key = (is_color ? "color " : "data ") + file;
            if (!known.contains(key)) {
                Outcome<Image> image = load_image(file);
                if (!image) {
                    report({diagnostic_at(place, "bad-texture", image.error)});
                    ok_ = false;
                    return;
                }
                if (is_color && image.value.bits <= 8) decode_srgb(image.value);
                TextureData data{.levels = mip_chain(image.value), .sampler = {.wrap = "clamp", .filter = "linear"}};
                known[key] = {.data = std::make_shared<const TextureData>(std::move(data)),
                              .format = TexelFormat::Float32};
            }
            object_textures_[object].push_back(known[key]);
            object_textures_[object].back().name = name + "Texture";
        };
        for (std::size_t i = 0; i < world_.objects.size(); ++i) {
            const WorldObject& object = world_.objects[i];
            load(i, "lightmap", object.lightmap, object.lightmap_place, true);
            load(i, "shadowMask", object.shadow_mask, object.shadow_mask_place, false);
        }
    }

    // --- shaders

    // Materials that differ in their values alone have the same text; so have lighting passes of one lighting graph.
    const Spirv* spirv_of(const Shader& shader) {
        const auto [found, is_new] = spirv_.try_emplace(shader.text);
        if (is_new) {
            Validated validated = validate(shader);
            report(validated.diagnostics);
            found->second = std::move(validated.spirv);
            if (!validated.ok) ok_ = false;
        }
        return &found->second;
    }

    DrawnMaterial drawn_material(const Compiled& material) {
        DrawnMaterial drawn{
            .reflection = &material.result.reflection, .values = material.values, .textures = material.loaded.textures};
        for (const Pass& pass : material.result.reflection.passes) {
            DrawnPass& made = drawn.passes[pass.name];
            made.stages.program = material.result.program.get();
            for (const Shader& shader : material.result.shaders) {
                if (shader.pass != pass.name) continue;
                if (shader.stage == Stage::Fragment) made.fragment = shader.text;
                if (on_cpu()) continue;
                const Spirv* spirv = spirv_of(shader);
                if (shader.target != target()) continue;
                (shader.stage == Stage::Vertex ? made.stages.vertex_spirv : made.stages.fragment_spirv) = *spirv;
            }
        }
        return drawn;
    }

    // The wanted path as reflections name it.
    bool is_pass_file() const { return options_.path.ends_with(".hlsl"); }
    std::string path_name() const {
        if (!is_pass_file()) return options_.path;
        const std::string name = std::filesystem::path(options_.path).filename().string();
        return name.substr(0, name.find('.', 1));
    }

    // --- drawing

    RenderOutcome draw(const Frame& frame) {
        Outcome<Image> image = Failure{""};
        if (on_cpu()) {
            image = cpu_draw(frame);
        } else {
            if (std::string error = open_machine(options_.device, options_.validation, machine_); !error.empty()) {
                outcome_.missing_machine = true;
                return failed(error);
            }
            if (std::string error = machine_.renderer->beyond_limits(frame); !error.empty()) {
                outcome_.missing_machine = true;
                return failed(error);
            }
            const std::size_t messages_before = machine_.renderer->messages().size();
            image = machine_.renderer->draw(frame);
            const std::vector<std::string>& messages = machine_.renderer->messages();
            if (image && messages.size() > messages_before)
                return failed("the Vulkan validation layer says: " + messages[messages_before]);
        }
        if (!image) return failed(image.error);
        outcome_.image = std::move(image.value);
        outcome_.draws = frame.steps.size();
        outcome_.ok = true;
        return std::move(outcome_);
    }

    const Compiler& compiler_;
    const World& world_;
    const WorldOptions& options_;
    RenderMachine& machine_;
    RenderOutcome outcome_{};
    bool ok_ = true;
    bool is_drawing_ = true;
    World spread_{};  // the world, with a material for each variant
    std::vector<Variant> variants_{};
    std::vector<std::unique_ptr<Compiled>> compiled_{};  // one for each variant
    std::vector<DrawnMaterial> drawn_{};                 // in their order
    std::vector<std::vector<LoadedTexture>> object_textures_{};
    std::vector<std::vector<MaterialValues>> instance_values_{};  // by object
    std::map<std::string, Spirv> spirv_{};                        // by text
    std::set<std::string> said_{};
};

}  // namespace

RenderOutcome draw_world(const Compiler& compiler, const World& world, const WorldOptions& options,
                         RenderMachine& machine) {
    return Drawing(compiler, world, options, machine).run();
}

RenderOutcome check_world(const Compiler& compiler, const World& world, const WorldOptions& options) {
    RenderMachine none;
    return Drawing(compiler, world, options, none).check();
}

}  // namespace patina::runtime
