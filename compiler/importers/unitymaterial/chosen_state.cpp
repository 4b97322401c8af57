#include "compiler/importers/unitymaterial/chosen_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "compiler/importers/values.h"

namespace patina::importers::unitymaterial {
namespace {

using json::Json;
using Words = std::span<const std::string_view>;

// By Unity's numbers.
constexpr std::string_view kBlends[] = {"fade", "transparent", "additive", "multiply"};
constexpr std::string_view kFaces[] = {"off", "front", "back"};
constexpr std::string_view kTests[] = {"always",  "never",    "less",         "equal", "lessEqual",
                                       "greater", "notEqual", "greaterEqual", "always"};

struct State {
    std::string_view surface, cull, test;
    bool writes_depth = true;
    friend bool operator==(const State&, const State&) = default;
};

std::string_view word_of(const Json& render, std::string_view key, std::string_view otherwise) {
    const Json* found = render.find(key);
    return found ? std::string_view(found->string) : otherwise;
}

bool is_solid(std::string_view surface) {
    return surface == "opaque" || surface == "cutout";
}

State state_of(const Json& render) {
    const std::string_view surface = word_of(render, "surface", "opaque");
    const Json* writes = render.find("depthWrite");
    return {.surface = surface,
            .cull = word_of(render, "cull", "back"),
            .test = word_of(render, "depthTest", "lessEqual"),
            .writes_depth = writes ? writes->boolean : is_solid(surface)};
}

class Reader {
public:
    Reader(MaterialMaker& maker, const State& own, bool is_lit) : maker_(maker), own_(own), is_lit_(is_lit) {}

    State read() {
        State made = own_;
        made.surface = surface();
        made.cull = chosen("_Cull", kFaces, own_.cull);
        made.test = chosen("_ZTest", kTests, own_.test);
        made.writes_depth = number("_ZWrite", own_.writes_depth) != 0;
        maker_.taken("_ZWrite", fmt::format("\"depthWrite\": {}", made.writes_depth));
        for (const char* each : {"_SrcBlend", "_DstBlend", "_SrcBlendAlpha", "_DstBlendAlpha", "_ZWriteControl",
                                 "_AlphaToMask", "_QueueOffset", "_QueueControl"})
            maker_.taken(each, "it follows from the kind of the surface");
        for (const char* each :
             {"_SURFACE_TYPE_TRANSPARENT", "_ALPHATEST_ON", "_ALPHAPREMULTIPLY_ON", "_ALPHAMODULATE_ON"})
            maker_.note_keyword(each, Remark::Kind::Taken, "it repeats '_Surface', '_Blend' and '_AlphaClip'");
        return made;
    }

private:
    int number(const char* name, int otherwise) const {
        return static_cast<int>(std::clamp(std::round(maker_.number(name, otherwise)), 0.0, 100.0));
    }

    std::string_view chosen(const char* name, Words words, std::string_view own) {
        if (!maker_.source().numbers.contains(name)) return own;
        const std::string_view word = words[std::min<std::size_t>(std::size_t(number(name, 0)), words.size() - 1)];
        maker_.taken(name, fmt::format("'{}'", word));
        return word;
    }

    std::string_view surface() {
        const bool is_solid_before = is_solid(own_.surface);
        const bool blends = number("_Surface", is_solid_before ? 0 : 1) != 0;
        const bool clips = number("_AlphaClip", own_.surface == "cutout") != 0;
        std::string_view kind = clips ? "cutout" : "opaque";
        if (blends) kind = is_solid_before ? kBlends[0] : own_.surface;
        if (blends && maker_.source().numbers.contains("_Blend")) kind = kBlends[std::min(number("_Blend", 0), 3)];
        const bool keeps_highlights = is_lit_ && number("_BlendModePreserveSpecular", 0) != 0;
        if (blends && kind == "fade" && keeps_highlights) kind = "transparent";
        const std::string text = fmt::format("the kind of the surface: '{}'", kind);
        const bool is_weighted = kind == "additive" || kind == "multiply";
        for (const char* each : {"_Surface", "_BlendModePreserveSpecular"}) maker_.taken(each, text);
        maker_.note("_Blend", is_weighted ? Remark::Kind::Changed : Remark::Kind::Taken,
                    is_weighted ? text + ", which does not depend on alpha" : text);
        maker_.note("_AlphaClip", blends && clips ? Remark::Kind::Changed : Remark::Kind::Taken,
                    blends && clips ? "a surface that blends is not clipped" : text);
        return kind;
    }

    MaterialMaker& maker_;
    const State& own_;
    bool is_lit_;
};

GraphValue render_of(const Json& render, const State& state) {
    GraphMembers members;
    if (state.surface != "opaque") members.push_back({"surface", state.surface});
    if (state.cull != "back") members.push_back({"cull", state.cull});
    if (state.writes_depth != is_solid(state.surface)) members.push_back({"depthWrite", state.writes_depth});
    if (state.test != "lessEqual") members.push_back({"depthTest", state.test});
    for (const json::JsonMember& each : render.members) {
        const std::string_view key = each.key;
        if (key != "surface" && key != "cull" && key != "depthWrite" && key != "depthTest")
            members.push_back({each.key, value_of(each.value)});
    }
    return GraphValue::object(std::move(members));
}

}  // namespace

std::optional<std::string> with_chosen_state(MaterialMaker& maker, const Json& root, std::uint32_t begin,
                                             std::string_view text) {
    const Json* render = root.find("render");
    const Json* is_open = render ? render->find("materialOverride") : nullptr;
    if (!is_open || !is_open->boolean) return {};
    const State own = state_of(*render);
    const State made = Reader(maker, own, word_of(root, "workflow", "") != "unlit").read();
    if (made == own) return {};
    std::string changed(text.substr(0, render->span.begin - begin));
    changed += render_of(*render, made).json();
    changed += text.substr(render->span.end - begin);
    return in_canonical_form(std::move(changed));
}

}  // namespace patina::importers::unitymaterial
