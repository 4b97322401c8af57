// How the surface is drawn. What a shader of Unity obeys are its keywords and the numbers of its render state; the
// numbers of its inspector (_Mode, _Surface, _Blend) only set these.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/importers/unitymaterial/material_maker.h"

namespace patina::importers::unitymaterial {
namespace {

// Blend factors, by Unity's numbers.
constexpr int kZero = 0, kOne = 1, kDstColor = 2, kSrcColor = 3, kSrcAlpha = 5, kOneMinusSrcAlpha = 10;

struct Blend {
    int source, destination;
    std::string_view kind;
    bool is_weighted = false;
};
constexpr Blend kBlends[] = {
    {kOne, kZero, "opaque"},
    {kSrcAlpha, kOneMinusSrcAlpha, "fade"},
    {kOne, kOneMinusSrcAlpha, "transparent"},
    {kSrcAlpha, kOne, "additive", true},
    {kOne, kOne, "additive"},
    {kDstColor, kZero, "multiply"},
    {kZero, kSrcColor, "multiply"},
};

// Numbers of the inspector, which keywords and render states repeat.
constexpr const char* kInspector[] = {"_Mode",
                                      "_Surface",
                                      "_Blend",
                                      "_AlphaClip",
                                      "_WorkflowMode",
                                      "_SmoothnessTextureChannel",
                                      "_SmoothnessSource",
                                      "_SpecularHighlights",
                                      "_GlossyReflections",
                                      "_EnvironmentReflections",
                                      "_ReceiveShadows",
                                      "_QueueOffset",
                                      "_BlendModePreserveSpecular",
                                      "_ClearCoat"};

constexpr const char* kInspectorAlone = "it concerns the inspector alone, which sets keywords and other numbers by it";

int whole(const MaterialMaker& maker, const std::string& property, int otherwise) {
    return static_cast<int>(std::clamp(std::round(maker.number(property, otherwise)), -1.0, 100.0));
}

class StateReader {
public:
    explicit StateReader(MaterialMaker& maker) : maker_(maker) {}

    RenderState read() {
        if (has_fixed_state_)
            fixed();
        else if (is_high_definition_)
            high_definition();
        else
            blending();
        if (state_.is_clipped && state_.kind == "opaque") state_.kind = "cutout";
        if (state_.kind != "opaque") render_.push_back({"surface", state_.kind});
        faces();
        depth();
        queue();
        inspector();
        if (!render_.empty()) maker_.graph.more.push_back({"render", GraphValue::object(render_)});
        return state_;
    }

private:
    // The built-in Unlit shaders.
    void fixed() {
        const Family family = maker_.shader().family;
        if (family == Family::UnlitTransparent) state_.kind = "fade";
        state_.is_clipped = family == Family::UnlitCutout;
    }

    // The pipeline's shader multiplies colours by alpha itself, so its blend factors do not tell the modes apart.
    void high_definition() {
        state_.is_clipped = maker_.keyword("_ALPHATEST_ON", "alpha is compared with '_AlphaCutoff'");
        maker_.taken("_AlphaCutoffEnable", kInspectorAlone);
        const bool is_blended = maker_.keyword("_SURFACE_TYPE_TRANSPARENT", "'_BlendMode' is the kind of the surface");
        for (const char* each : {"_SurfaceType", "_SrcBlend", "_DstBlend", "_AlphaSrcBlend", "_AlphaDstBlend"})
            maker_.taken(each, "the keyword _SURFACE_TYPE_TRANSPARENT and '_BlendMode' say it");
        for (const char* each :
             {"_BLENDMODE_ALPHA", "_BLENDMODE_ADD", "_BLENDMODE_PRE_MULTIPLY", "_BLENDMODE_PRESERVE_SPECULAR_LIGHTING"})
            maker_.keyword(each, "'_BlendMode' says it");
        if (!is_blended) {
            for (const char* each : {"_BlendMode", "_EnableBlendModePreserveSpecularLighting"})
                maker_.taken(each, "it has no effect: the surface is not blended");
            return;
        }
        const std::size_t mode = choice("_BlendMode", 0, 4);
        const bool keeps_highlights = maker_.number("_EnableBlendModePreserveSpecularLighting", 1) != 0;
        state_.kind = mode == 1 ? "additive" : mode == 0 && !keeps_highlights ? "fade" : "transparent";
        state_.is_weighted = mode == 1;
        std::string difference;
        if (mode == 1) difference = ": alpha weights its colour alone, and not its highlights and its emission";
        if (mode == 4) difference = ": the colour is multiplied by alpha, which Unity expects of the textures";
        maker_.note("_BlendMode", difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
                    fmt::format("the kind of the surface: '{}'{}", state_.kind, difference));
        maker_.taken("_EnableBlendModePreserveSpecularLighting",
                     keeps_highlights ? "alpha does not weaken highlights" : "alpha weakens highlights, too");
        maker_.taken("_ZTestTransparent", "the nearer surface is seen");
    }

    void blending() {
        const int source = whole(maker_, "_SrcBlend", kOne), destination = whole(maker_, "_DstBlend", kZero);
        const auto blend = std::ranges::find_if(
            kBlends, [&](const Blend& each) { return each.source == source && each.destination == destination; });
        std::string difference;
        if (blend != std::end(kBlends)) {
            state_.kind = blend->kind;
            state_.is_weighted = blend->is_weighted;
        } else {
            state_.kind = destination == kZero ? "opaque" : destination == kOne ? "additive" : "fade";
            difference =
                fmt::format("the blend factors {} and {} of Unity are none that a graph has", source, destination);
        }
        guess();
        const bool is_cut = maker_.keyword("_ALPHATEST_ON", "alpha is compared with '_Cutoff'");
        state_.is_clipped = state_.is_clipped || is_cut;
        const std::string text = fmt::format("the kind of the surface: '{}'", state_.kind);
        const bool is_premultiplied = maker_.keyword("_ALPHAPREMULTIPLY_ON", text);
        maker_.keyword("_ALPHABLEND_ON", text);
        maker_.keyword("_SURFACE_TYPE_TRANSPARENT", text);
        state_.is_alpha_modulated = maker_.keyword("_ALPHAMODULATE_ON", "alpha fades the colour to white");
        if (state_.kind == "transparent" && !is_premultiplied && !maker_.shader().is_guessed)
            difference = "the colour is multiplied by alpha, which Unity expects of the textures";
        if (state_.kind == "additive" && is_premultiplied && source == kOne)
            difference = "alpha does not weight the diffuse colour";
        if (state_.kind == "additive" && state_.is_weighted && !is_unlit())
            difference = "alpha weights its colour alone, and not its highlights and its emission";
        for (const char* each : {"_SrcBlend", "_DstBlend"})
            maker_.note(each, difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed,
                        difference.empty() ? text : text + ": " + difference);
        for (const char* each : {"_SrcBlendAlpha", "_DstBlendAlpha"})
            maker_.taken(each, "it concerns the alpha of the picture alone");
        maker_.taken("_AlphaToMask", "it concerns several samples a pixel alone");
    }

    // A shader that is not known may say it in its tags alone.
    void guess() {
        const Setting* tags = maker_.source().setting("stringTagMap");
        if (!maker_.shader().is_guessed || state_.kind != "opaque" || !tags) return;
        for (const std::string& word : tags->words) {
            if (word == "RenderType=Transparent") state_.kind = "fade";
            if (word == "RenderType=TransparentCutout") state_.is_clipped = true;
        }
    }

    bool is_unlit() const { return maker_.shader().family == Family::Unlit; }

    void faces() {
        if (maker_.shader().family == Family::Standard && !maker_.shader().is_guessed) return;
        static constexpr std::string_view kWords[] = {"off", "front", "back"};
        if (is_high_definition_) return both_sides(kWords);
        if (has_fixed_state_) return;
        const std::string_view cull = kWords[choice("_Cull", 2, 2)];
        maker_.taken("_Cull", fmt::format("\"cull\": \"{}\"", cull));
        if (cull != "back") render_.push_back({"cull", cull});
    }

    // One of Unity's numbers, from 0 to the last one.
    std::size_t choice(const std::string& property, int otherwise, int last) {
        const double stated = maker_.number(property, otherwise),
                     nearest = std::clamp(std::round(stated), 0.0, 1.0 * last);
        if (nearest != stated)
            maker_.note(
                property, Remark::Kind::Changed,
                fmt::format("{} is none of its numbers, which are 0 to {}: {} counts", digits(stated), last, nearest));
        return static_cast<std::size_t>(nearest);
    }

    void both_sides(std::span<const std::string_view> words) {
        const bool is_open = maker_.keyword("_DOUBLESIDED_ON", "\"cull\": \"off\"");
        const std::string_view cull = words[is_open ? 0 : choice("_CullMode", 2, 2)];
        for (const char* each : {"_CullMode", "_CullModeForward"})
            maker_.taken(each, fmt::format("\"cull\": \"{}\"", cull));
        for (const char* each : {"_DoubleSidedEnable", "_OpaqueCullMode", "_TransparentCullMode"})
            maker_.taken(each, kInspectorAlone);
        const bool keeps_normal = cull == "off" && whole(maker_, "_DoubleSidedNormalMode", 1) == 2;
        maker_.note("_DoubleSidedNormalMode", keeps_normal ? Remark::Kind::Changed : Remark::Kind::Taken,
                    cull != "off"  ? "it has no effect: back faces are not drawn"
                    : keeps_normal ? "the normals of back faces are turned to the viewer"
                                   : "the normals of back faces are turned to the viewer, as there");
        if (cull != "back") render_.push_back({"cull", cull});
    }

    void depth() {
        const bool otherwise = !state_.is_blended();
        if (has_fixed_state_) return;
        const bool writes = maker_.number("_ZWrite", otherwise ? 1 : 0) != 0;
        maker_.taken("_ZWrite", fmt::format("\"depthWrite\": {}", writes));
        if (writes != otherwise) render_.push_back({"depthWrite", writes});
    }

    void queue() {
        const Setting* saved = maker_.source().setting("m_CustomRenderQueue");
        const int usual = state_.is_blended() ? 3000 : state_.is_clipped ? 2450 : 2000;
        double queue = -1;
        if (saved && !read_finite(saved->text, queue)) {
            maker_.note_setting("m_CustomRenderQueue", Remark::Kind::Changed,
                                "it is not a number: the queue of the kind of the surface");
            return;
        }
        // Without a queue of its own, the material has that of the shader, which does not depend on the kind.
        if (queue < 0) queue = has_fixed_state_ || maker_.shader().is_guessed ? usual : 2000;
        // Its opaque surfaces have queues of their own, by whether decals lie on them.
        if (is_high_definition_ && !state_.is_blended() && queue >= 2000 && queue < 2500) queue = usual;
        const double inside = std::clamp(std::round(queue), 0.0, 5000.0);
        maker_.note_setting("m_CustomRenderQueue", inside == queue ? Remark::Kind::Taken : Remark::Kind::Changed,
                            inside == queue ? fmt::format("\"queue\": {}", inside)
                                            : fmt::format("\"queue\": {}, the nearest one that exists", inside));
        if (inside != usual) render_.push_back({"queue", inside});
    }

    void inspector() {
        for (const char* each : kInspector) maker_.taken(each, kInspectorAlone);
        if (maker_.keyword("_RECEIVE_SHADOWS_OFF", {}))
            maker_.change_keyword("_RECEIVE_SHADOWS_OFF", "it receives shadows");
        if (maker_.keyword("_SPECULARHIGHLIGHTS_OFF", {}))
            maker_.change_keyword("_SPECULARHIGHLIGHTS_OFF", "lights have highlights");
        for (const char* each : {"_GLOSSYREFLECTIONS_OFF", "_ENVIRONMENTREFLECTIONS_OFF"})
            if (maker_.keyword(each, {})) maker_.change_keyword(each, "the surface reflects its surroundings");
    }

    MaterialMaker& maker_;
    bool has_fixed_state_ = maker_.shader().family >= Family::UnlitTexture && !maker_.shader().is_guessed;
    bool is_high_definition_ = maker_.shader().family == Family::HighDefinitionLit;
    RenderState state_{};
    GraphMembers render_{};
};

}  // namespace

Term RenderState::weighted(const Term& color, const Term& alpha) const {
    const bool is_faded = is_alpha_modulated && !alpha.is_all(1);
    const Term made = is_faded ? computed("lerp(float3(1), a, b)", {color, alpha}, Type::Float3) : color;
    return is_weighted ? product({made, alpha}) : made;
}

RenderState make_render_state(MaterialMaker& maker) {
    return StateReader(maker).read();
}

}  // namespace patina::importers::unitymaterial
