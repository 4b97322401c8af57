#include "compiler/importers/shadergraph/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "compiler/importers/shadergraph/lost_settings.h"

namespace patina::importers::shadergraph {
namespace {

// Materials of targets, by a part of their class. The first row that fits counts.
struct Material {
    std::string_view in_name;
    bool is_lit;
    std::string_view difference;   // empty: the material does the same
    std::string_view blocks = {};  // that it has in any case, and the surface lacks
};
constexpr std::string_view kAny = "*";  // blocks of many kinds
constexpr Material kMaterials[] = {
    {"SpriteUnlit", false, ""},
    {"SpriteCustomLit", false, "2D lights are not known: it is drawn without light", "SpriteMask NormalTS"},
    {"SpriteLit", false, "2D lights are not known: it is drawn without light", "SpriteMask NormalTS"},
    {"HDUnlit", false, "", "Emission"},
    {"Unlit", false, ""},
    {"UniversalLit", true, ""},
    {"BuiltInLit", true, ""},
    {"PBRMasterNode", true, ""},
    {"HDLit", true, "it is lit as the built-in pipeline does", "BentNormal"},
    {"Decal", true, "it is drawn on its mesh, and not projected on what is behind it", "NormalAlpha MAOSAlpha"},
    {"Fullscreen", false, "it is drawn on its mesh, and not over the whole picture",
     "FullscreenEyeDepth FullscreenLinear01Depth FullscreenRawDepth"},
    {"Canvas", false, "it is drawn on its mesh, and not on a canvas", "Emission"},
    {"SixWay", true, "it is lit as a surface, without maps for six directions", kAny},
    {"Terrain", true, "it is drawn on its mesh, without the layers of a terrain", kAny},
    {"Fabric", true, "it is lit as a surface without fibres", kAny},
    {"Vfx", false, "it is drawn on its mesh, and not on particles", kAny},
    {"VFX", false, "it is drawn on its mesh, and not on particles", kAny},
};

const Material* material_of(std::string_view name) {
    const auto found = std::ranges::find_if(
        kMaterials, [&](const Material& each) { return name.find(each.in_name) != std::string_view::npos; });
    return found == std::end(kMaterials) ? nullptr : &*found;
}

// Settings that change nothing that a graph says.
struct Known {
    std::string_view key, label, text;
};
constexpr Known kEditorOnly[] = {
    {"m_CustomEditorGUI", "Custom Editor GUI", "it concerns the editor alone"},
    {"m_SupportVFX", "Support VFX Graph", "it concerns the editor alone"},
    {"m_OverrideEnabled", "Override ShaderGUI", "it concerns the editor alone"},
    {"m_ShaderGUIOverride", "ShaderGUI", "it concerns the editor alone"},
    {"m_DOTSInstancing", "DOTS Instancing", "it concerns the engine's way of drawing alone"},
};

class Reader {
public:
    explicit Reader(const TargetSettings& target) : target_(target) {}

    Settings read() {
        const Material* material = material_of(target_.material);
        if (!material) material = material_of(target_.kind);  // a target without materials, as that of effects
        is_effect_ = target_.kind == "VFXTarget" || target_.kind == "VfxMasterNode";
        is_high_definition_ = target_.kind.starts_with("HD");
        const bool is_known = material != nullptr;
        made_.is_lit = is_known && (is_effect_ ? whole("m_Lit", 0) != 0 : material->is_lit);
        is_sprite_ = target_.material.find("Sprite") != std::string::npos;
        const bool is_universal =
            target_.kind.find("Universal") != std::string::npos || target_.kind == "PBRMasterNode";
        if (made_.is_lit && is_universal) made_.lighting = "unity-brdf2";
        is_old_ = target_.kind.ends_with("MasterNode");
        is_universal_ = is_universal;
        const std::string difference(is_known ? material->difference
                                              : "this importer does not know it: it is drawn without light");
        made_.lost_blocks = is_known ? material->blocks : kAny;
        // The master nodes of this pipeline have no other slots than those that their settings want.
        if (is_old_ && is_high_definition_) made_.lost_blocks = kAny;
        workflow();
        add(difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, "Material",
            fmt::format("the workflow '{}'{}", made_.workflow(), difference.empty() ? "" : ": " + difference));
        surface();
        faces_and_depth();
        if (whole("m_AllowMaterialOverride", 0) != 0)
            material_override(difference.empty() && !is_sprite_, is_universal);
        rest();
        return std::move(made_);
    }

private:
    void add(Remark::Kind kind, std::string_view label, std::string text) {
        if (const std::string wrong = take_misreads(); !wrong.empty()) {
            text += (text.empty() ? "" : ": ") + wrong;
            if (kind == Remark::Kind::Taken) kind = Remark::Kind::Changed;
        }
        made_.remarks.push_back({.kind = kind,
                                 .part = fmt::format("setting '{}'", label),
                                 .text = std::move(text),
                                 .place = target_.place});
    }
    // The object that has the setting: the target, its material, or further settings.
    const Json* holder(std::string_view key) const {
        for (const Json* each : {target_.json, target_.material_json})
            if (member(each, key)) return each;
        for (const Json* each : target_.data)
            if (member(each, key)) return each;
        return nullptr;
    }
    // From 0 to `high`.
    int whole(std::string_view key, int otherwise, int high = 1) const {
        return whole_in(holder(key), key, otherwise, 0, high);
    }

    void workflow() {
        if (!made_.is_lit) return;
        made_.is_specular = whole(holder("m_WorkflowMode") ? "m_WorkflowMode" : "m_Model", 1) == 0;
        if (is_high_definition_ && target_.material.starts_with("HDLit")) material_type_of_lit();
        add(Remark::Kind::Taken, "Workflow Mode", fmt::format("'{}'", made_.workflow()));
        static constexpr std::string_view kNormals[] = {"NormalTS", "NormalOS", "NormalWS"};
        made_.normal_block = kNormals[whole("m_NormalDropOffSpace", 0, 2)];
        if (made_.normal_block != kNormals[0])
            add(Remark::Kind::Taken, "Fragment Normal Space", fmt::format("the block '{}'", made_.normal_block));
    }

    // Of the high definition pipeline's Lit. Newer graphs may have several, of which a material chooses one.
    void material_type_of_lit() {
        constexpr std::string_view kLabel = "Material Type", kKey = "m_MaterialType", kMask = "m_MaterialTypeMask";
        static constexpr Lit kBits[] = {Lit::Subsurface,    Lit::Standard,    Lit::Anisotropy,        Lit::Iridescence,
                                        Lit::SpecularColor, Lit::Translucent, Lit::ColoredTranslucent};
        if (!holder(kMask) && !holder(kKey)) return;
        auto chosen = static_cast<Lit>(whole(kKey, 0, 5));
        bool has_several = false;
        if (holder(kMask)) {
            const auto mask = static_cast<unsigned>(whole(kMask, 2, (1 << std::size(kBits)) - 1));
            chosen = mask == 0 ? Lit::Standard : kBits[std::countr_zero(mask)];
            has_several = std::popcount(mask) > 1;
        }
        const MaterialType& type = material_type(chosen);
        made_.is_specular = chosen == Lit::SpecularColor;
        made_.has_metal = type.has_metal;
        lose(type.blocks);
        if (chosen == Lit::Subsurface && whole("m_SSSTransmission", 1) != 0) lose("TransmissionMask Thickness");
        std::string text = fmt::format("'{}'", type.name);
        if (!type.lost.empty()) text += fmt::format(": {}", type.lost);
        if (has_several)
            text += fmt::format("{} materials cannot choose another one", type.lost.empty() ? ":" : ", and");
        add(type.lost.empty() && !has_several ? Remark::Kind::Taken : Remark::Kind::Changed, kLabel, text);
    }
    void lose(std::string_view blocks) {
        made_.lost_blocks += (made_.lost_blocks.empty() ? "" : " ") + std::string(blocks);
    }

    static bool is_set(const Json& value) { return value.number != 0 || value.boolean || !value.string.empty(); }

    bool has_clip() const {
        for (const std::string_view key : {"m_AlphaClip", "m_AlphaTest"})
            if (holder(key)) return whole(key, 0) != 0;
        return is_clipped_by_slot;
    }

    void surface() {
        made_.is_blended = is_sprite_ || whole("m_SurfaceType", 0) == 1;
        made_.is_clipped = has_clip();
        made_.is_clipped_blend = made_.is_blended && made_.is_clipped;
        std::string_view kind = made_.is_clipped ? "cutout" : "opaque";
        if (made_.is_blended) kind = blending();
        add(is_effect_ ? Remark::Kind::Changed : Remark::Kind::Taken, "Surface Type",
            fmt::format("'{}'{}", kind, is_effect_ ? ": the effect chooses how it blends" : ""));
        if (made_.is_clipped)
            add(Remark::Kind::Taken, "Alpha Clipping", made_.is_blended ? "'surface.alphaClip'" : "'cutout'");
        if (kind != "opaque") made_.render.push_back({"surface", kind});
        made_.is_tinted = is_sprite_ && whole("m_DisableTint", 0) == 0;
    }

    // The kind of a blended surface. What alpha does to the colour is done where the colour is written.
    std::string_view blending() {
        enum Mode { kAlpha, kPremultiply, kAdditive, kMultiply };
        static constexpr std::string_view kKinds[] = {"fade", "transparent", "additive", "multiply"};
        static constexpr Mode kModesOfSystem[] = {kAlpha, kAdditive, kAlpha, kAlpha, kPremultiply};
        const int mode = has_system_data() ? kModesOfSystem[whole("m_BlendMode", 0, 4)] : whole("m_AlphaMode", 0, 3);
        const std::string_view kPreserve =
            is_high_definition_ ? "m_BlendPreserveSpecular" : "m_BlendModePreserveSpecular";
        const bool can_keep = made_.is_lit && holder(kPreserve);
        const bool keeps_highlights = can_keep && whole(kPreserve, 0) != 0;
        const std::string_view kind = kKinds[mode == kAlpha && keeps_highlights ? kPremultiply : mode];
        made_.is_weighted = mode == kAdditive;
        made_.is_faded = mode == kMultiply && is_universal_ && !is_old_;
        std::string what, difference;
        if (made_.is_weighted) what = ", and alpha weights the colour";
        if (made_.is_faded) what = ", and alpha fades the colour to white";
        if (mode == kPremultiply && !is_old_)
            difference = ": the colour is multiplied by alpha, which Unity expects of what the graph computes";
        if (mode == kAdditive && made_.is_lit && !keeps_highlights)
            difference = " alone, and not highlights and emission";
        add(difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, "Blending Mode",
            fmt::format("'{}'{}{}", kind, what, difference));
        constexpr std::string_view kLabel = "Preserve Specular Lighting";
        if (can_keep && mode == kAlpha)
            add(Remark::Kind::Taken, kLabel,
                keeps_highlights ? "alpha does not weaken highlights" : "alpha weakens highlights, too");
        if (keeps_highlights && mode == kAdditive)
            add(made_.is_specular ? Remark::Kind::Taken : Remark::Kind::Changed, kLabel,
                made_.is_specular ? "alpha does not weaken highlights" : "alpha weakens the highlights of metals");
        if (keeps_highlights && (mode == kPremultiply || mode == kMultiply))
            add(Remark::Kind::Taken, kLabel, "it has no effect with this blending");
        return kind;
    }

    // Of the high definition pipeline, from its version 10: which names its settings otherwise.
    bool has_system_data() const { return is_high_definition_ && holder("m_BlendMode"); }

    // Its opaque surfaces test and write the depth in any case.
    void faces_and_depth_of_system() {
        static constexpr std::string_view kWords[] = {"off", "front", "back"};
        const int sides = whole("m_DoubleSidedMode", 0, 3);
        const std::string_view cull =
            kWords[sides != 0 ? 0 : whole(made_.is_blended ? "m_TransparentCullMode" : "m_OpaqueCullMode", 2, 2)];
        // 1: both sides have the same normal; 2 and 3: that of back faces is turned.
        const bool keeps_normal = sides == 1 && made_.is_lit;
        add(keeps_normal ? Remark::Kind::Changed : Remark::Kind::Taken, "Render Face",
            fmt::format("\"cull\": \"{}\"{}", cull,
                        keeps_normal ? ": the normals of back faces are turned to the viewer" : ""));
        if (cull != "back") made_.render.push_back({"cull", cull});
        if (!made_.is_blended) return;
        if (whole("m_ZWrite", 0) != 0) depth_write(true);
        depth_test(whole("m_ZTest", 4, 8));
    }

    void faces_and_depth() {
        if (has_system_data()) return faces_and_depth_of_system();
        std::string_view cull = "back";
        if (is_sprite_) {  // drawn on both sides, whatever the target says
            cull = "off";
        } else if (holder("m_RenderFace")) {
            static constexpr std::string_view kWords[] = {"off", "front", "back"};
            cull = kWords[whole("m_RenderFace", 2, 2)];
        } else if (whole("m_TwoSided", 0) != 0 || holder_is_on("m_DoubleSided")) {
            cull = "off";
        }
        add(Remark::Kind::Taken, "Render Face",
            fmt::format("\"cull\": \"{}\"{}", cull, is_sprite_ ? ": sprites are two-sided" : ""));
        if (cull != "back") made_.render.push_back({"cull", cull});
        const int write = whole("m_ZWriteControl", 0, 2);
        if (write == 1 || write == 2) depth_write(write == 1);
        depth_test(whole("m_ZTestMode", 4, 8));
    }
    void depth_write(bool writes) {
        made_.render.push_back({"depthWrite", writes});
        add(Remark::Kind::Taken, "Depth Write", writes ? "true" : "false");
    }
    void depth_test(int test) {
        static constexpr std::string_view kTests[] = {"lessEqual", "never",    "less",         "equal", "lessEqual",
                                                      "greater",   "notEqual", "greaterEqual", "always"};
        if (test != 4 && test != 0) {
            made_.render.push_back({"depthTest", kTests[test]});
            add(Remark::Kind::Taken, "Depth Test", fmt::format("'{}'", kTests[test]));
        }
    }
    // The pipelines have it for the materials Lit and Unlit, each with its own list of what can be changed.
    void material_override(bool is_known, bool is_universal) {
        constexpr std::string_view kLabel = "Allow Material Override";
        if (!is_known) return add(Remark::Kind::Changed, kLabel, "materials cannot change the graph's settings");
        made_.is_overridable = true;
        made_.render.push_back({"materialOverride", true});
        add(Remark::Kind::Taken, kLabel, "\"materialOverride\": true");
        if (is_universal && made_.is_lit) {
            lose(made_.is_specular ? "Metallic" : "Specular");
            add(Remark::Kind::Changed, kLabel, "materials cannot change the workflow, nor reject shadows");
        }
        if (made_.is_clipped_blend) add(Remark::Kind::Changed, kLabel, "materials cannot turn off alpha clipping");
        if (made_.is_weighted || made_.is_faded)
            add(Remark::Kind::Changed, kLabel, "alpha changes the colour, whichever blending a material chooses");
    }
    bool holder_is_on(std::string_view key) const { return whole(key, 0) != 0; }

    void rest() {
        for (const Known& each : kEditorOnly)
            if (const Json* found = holder(each.key); found && is_set(*found->find(each.key)))
                add(Remark::Kind::Taken, each.label, std::string(each.text));
        for (const LostSetting& each : lost_settings()) lose(each);
        if (const std::string wrong = take_misreads(); !wrong.empty())
            made_.remarks.push_back(
                {.kind = Remark::Kind::Changed, .part = "settings", .text = wrong, .place = target_.place});
    }

    void lose(const LostSetting& setting) {
        const double value = number_of(holder(setting.key), setting.key, setting.otherwise);
        if (value == setting.otherwise) return;
        using Needs = LostSetting::Needs;
        const std::string_view idle = setting.needs == Needs::Blending && !made_.is_blended   ? "on an opaque surface"
                                      : setting.needs == Needs::Clipping && !made_.is_clipped ? "without alpha clipping"
                                      : setting.needs == Needs::Specular && !made_.is_specular
                                          ? "without a specular colour"
                                          : "";
        if (!idle.empty()) return add(Remark::Kind::Taken, setting.label, fmt::format("it has no effect {}", idle));
        add(Remark::Kind::Changed, setting.label, std::string(setting.text));
        if (setting.with < 0 || setting.with == value) lose(setting.blocks);
    }

public:
    bool is_clipped_by_slot = false;  // of an old file: its threshold is connected or above 0

private:
    const TargetSettings& target_;
    Settings made_{};
    bool is_sprite_ = false, is_old_ = false, is_universal_ = false, is_high_definition_ = false, is_effect_ = false;
};

// Sprites and pictures have had other blocks for their colour, which count if there is no usual one.
std::string_view color_block(const ShaderGraph& graph, std::string_view material) {
    const auto has = [&](std::string_view name) {
        return std::ranges::find(graph.blocks, name, &Block::name) != graph.blocks.end();
    };
    for (const std::string_view kind : {"Sprite", "Fullscreen"})
        for (const std::string_view block : {"SpriteColor", "FullscreenColor"})
            if (block.starts_with(kind) && material.find(kind) != material.npos && has(block) && !has("BaseColor"))
                return block;
    return "BaseColor";
}

bool is_clipped_by_slot(const ShaderGraph& graph) {
    if (!graph.is_old) return false;
    for (const Block& block : graph.blocks) {
        if (block.name != "AlphaClipThreshold") continue;
        const Slot* slot = graph.nodes[block.node].slot(block.slot);
        const bool is_linked = std::ranges::any_of(
            graph.edges, [&](const Edge& edge) { return edge.to == block.node && edge.to_slot == block.slot; });
        if (is_linked || (slot && number_of(slot->json, "m_Value") > 0)) return true;
    }
    return false;
}

}  // namespace

std::string_view Settings::workflow() const {
    if (!is_lit) return "unlit";
    return is_specular ? "specular-glossiness" : "metallic-smoothness";
}

bool Settings::uses(std::string_view block) const {
    if (block == "BaseColor" || block == "SpriteColor" || block == "FullscreenColor") return block == color_block;
    if (block.starts_with("Normal") && block.size() == normal_block.size()) return block == normal_block;
    if (block == "Metallic") return is_lit && !is_specular && has_metal;
    if (block == "Specular") return is_lit && is_specular;
    if (block == "Alpha") return is_blended || is_clipped || is_overridable;
    if (block == "AlphaClipThreshold") return is_clipped || is_overridable;
    return true;
}

bool Settings::loses(std::string_view block) const {
    if (block == "Alpha" || (block.starts_with("AlphaClipThreshold") && !is_clipped)) return false;
    if (names(lost_blocks, block)) return true;
    // Of any blocks, the settings choose among the ones for light and for the colour.
    return lost_blocks.starts_with(kAny) && (uses(block) || (!is_lit && !block.ends_with("Color")));
}

Settings read_settings(const ShaderGraph& graph) {
    if (graph.targets.empty())
        return {.remarks = {{.kind = Remark::Kind::Changed,
                             .part = "setting 'Active Targets'",
                             .text = "there is none: it is drawn without light"}}};
    const TargetSettings* chosen = &graph.targets.front();
    for (const std::string_view preferred : {"BuiltIn", "Universal"})
        for (const TargetSettings& each : graph.targets)
            if (each.kind.find(preferred) != std::string::npos) chosen = &each;
    Reader reader(*chosen);
    reader.is_clipped_by_slot = is_clipped_by_slot(graph);
    take_misreads();  // the slot's block says them
    Settings made = reader.read();
    made.color_block = color_block(graph, chosen->material);
    for (const TargetSettings& each : graph.targets)
        made.remarks.push_back({.kind = Remark::Kind::Taken,
                                .part = fmt::format("target '{}'", each.kind),
                                .text = &each == chosen ? "the workflow and the render state"
                                                        : fmt::format("the graph is that of '{}'", chosen->kind),
                                .place = each.place});
    return made;
}

}  // namespace patina::importers::shadergraph
