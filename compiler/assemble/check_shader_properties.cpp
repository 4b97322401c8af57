// What a ShaderLab file cannot say of a property. Its name is what materials keep its value under: it is never changed,
// and where Unity has it already the property is refused.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/assemble/shader_file.h"
#include "compiler/graph/words.h"
#include "compiler/targets/shaderlab/shaderlab.h"

namespace patina::assemble {
namespace {

using graph::PropertyType;
using targets::shaderlab::declarer_of;
using targets::shaderlab::keyword_of;

// What Unity fills beside a texture, and what its macros declare there.
std::string beside_texture(const graph::Material& material, std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> kBeside[] = {
        {"", "_ST"}, {"", "_TexelSize"}, {"", "_HDR"}, {"sampler", ""}};
    for (const graph::MaterialProperty& entry : material.properties) {
        if (entry.property->type != PropertyType::Texture2D) continue;
        for (const auto& [before, behind] : kBeside) {
            if (name == fmt::format("{}{}{}", before, entry.property->name, behind))
                return fmt::format("what Unity keeps of the texture '{}'", entry.property->name);
        }
    }
    return {};
}

// Why a property cannot have the name; empty: it can.
std::string why_taken(const graph::Material& material, std::string_view name) {
    if (const std::string_view declarer = declarer_of(name); !declarer.empty())
        return fmt::format("a name that {} declares", declarer);
    if (targets::is_reserved_word(name)) return "a word of HLSL or GLSL";
    if (targets::safe_identifier(name) != name) return "a name that GLSL keeps for itself";
    return beside_texture(material, name);
}

struct Named {
    const graph::Property* property;
    std::string keyword;
};

// The keywords of a property that has some.
std::vector<Named> keywords_of(const graph::Property& property) {
    if (property.values.empty()) return {{&property, keyword_of(property.name, {})}};
    std::vector<Named> made;
    for (const std::string& value : property.values) made.push_back({&property, keyword_of(property.name, value)});
    return made;
}

class Names {
public:
    Names(const graph::Material& material, Diagnostics& diagnostics) : material_(material), diagnostics_(diagnostics) {}

    void check(const graph::Property& property, bool is_keyword) {
        const std::string why = why_taken(material_, property.name);
        if (!why.empty()) return refuse(property, property.name, why);
        if (!is_keyword) return values_.push_back(&property);
        for (const Named& each : keywords_of(property)) {
            const std::string_view declarer = declarer_of(each.keyword);
            const Named* other = with_keyword(each.keyword);
            if (declarer.empty() && !other) continue;
            return refuse(property, each.keyword,
                          other ? keyword_of_another(*other) : fmt::format("a name that {} declares", declarer));
        }
        for (Named& each : keywords_of(property)) keywords_.push_back(std::move(each));
    }

    // A keyword that is on is a macro: no value can have its name.
    void finish() {
        for (const graph::Property* each : values_) {
            if (const Named* keyword = with_keyword(each->name))
                refuse(*each, each->name, keyword_of_another(*keyword));
        }
    }

private:
    const Named* with_keyword(std::string_view name) const {
        for (const Named& each : keywords_) {
            if (each.keyword == name) return &each;
        }
        return nullptr;
    }
    static std::string keyword_of_another(const Named& other) {
        return fmt::format("a keyword of '{}'", other.property->name);
    }

    void refuse(const graph::Property& property, const std::string& name, const std::string& why) {
        DiagnosticRecord& refused = diagnostics_.report(Code::TakenName, property.name_span, name, why);
        if (name != property.name) refused.note(fmt::format("it is the keyword of '{}'", property.name));
    }

    const graph::Material& material_;
    Diagnostics& diagnostics_;
    std::vector<const graph::Property*> values_;
    std::vector<Named> keywords_;
};

void check_list(const graph::Property& property, bool is_keyword, Diagnostics& diagnostics) {
    const std::size_t most = is_keyword ? kMostKeywords : kMostPairs;
    if (property.type != PropertyType::Enum || property.values.size() <= most) return;
    DiagnosticRecord& told =
        diagnostics.report(Code::InspectorLimit, property.name_span, property.name,
                           fmt::format("it lists {} values at most, and these are {}", most, property.values.size()));
    if (is_keyword) told.note("the number sets no keyword: a script has to enable the one that is meant");
}

// Labels and the names of groups, where ShaderLab makes something else of them. Of a group it is told once.
class Texts {
public:
    explicit Texts(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void check(const graph::Property& property) {
        const std::string label = quoted(property.label), header = header_words(property.group);
        if (label != property.label)
            diagnostics_.report(Code::InspectorText, property.label_span, fmt::format("\"{}\"", label), "label",
                                "has no escapes in strings");
        if (header != property.group && groups_.insert(property.group).second)
            diagnostics_.report(Code::InspectorText, property.group_span,
                                header.empty() ? "no header" : fmt::format("\"{}\"", header), "group",
                                "takes letters, digits and spaces there");
    }

private:
    Diagnostics& diagnostics_;
    std::set<std::string_view> groups_;
};

}  // namespace

void check_shader_properties(const graph::Material& material, const graph::Lowered& lowered, Diagnostics& diagnostics) {
    Names names(material, diagnostics);
    Texts texts(diagnostics);
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const graph::MaterialProperty& entry = material.properties[i];
        const graph::Property& property = *entry.property;
        const graph::PropertyGlobals& globals = lowered.property_globals[i];
        const ir::GlobalId id = globals.texture ? globals.texture : globals.value;
        if (!id && !globals.keyword) continue;  // it has been decided
        const ir::Global* global = id ? &lowered.module.globals[id.index] : nullptr;
        const bool is_theirs = global && global->in_block() &&
                               !lowered.module.blocks[global->block].members[global->member].declared_in.empty();
        if (!is_theirs) names.check(property, !id);
        check_list(property, !id, diagnostics);
        texts.check(property);
        if (entry.is_file)
            diagnostics.report(Code::NoFileDefault, property.default_span, property.name, default_word(property));
        if (const std::string words = sampler_words(property); !words.empty())
            diagnostics.report(Code::NoSampler, property.sampler_span, property.name, words);
    }
    names.finish();
}

void check_samplers(const graph::Material& material, const Reflection& reflection, Diagnostics& diagnostics) {
    constexpr std::size_t kMost = 16;
    constexpr std::size_t kUnitys = 4;  // shadow map, reflection probe, lightmap, and its directions or shadow mask
    const Pass* most = nullptr;
    for (const Pass& pass : reflection.passes) {
        if (!most || pass.textures.size() > most->textures.size()) most = &pass;
    }
    const bool is_lit = std::any_of(reflection.passes.begin(), reflection.passes.end(),
                                    [](const Pass& pass) { return pass.each == "light"; });
    const std::size_t room = is_lit ? kMost - kUnitys : kMost;
    if (!most || most->textures.size() <= room) return;
    const std::string& first = most->textures[most->textures.size() > kMost ? kMost : room];
    for (const graph::MaterialProperty& entry : material.properties) {
        if (entry.property->name != first) continue;
        const Span span = entry.property->name_span;
        if (most->textures.size() > kMost) {
            diagnostics.report(Code::TooMany, span, most->textures.size(), "textures in one pass", kMost);
        } else {
            diagnostics.report(
                Code::SamplerLimit, span, first,
                fmt::format("of {} samplers that Direct3D 11 has, shadows, probes and lightmaps need {}, and this pass "
                            "reads {}",
                            kMost, kUnitys, most->textures.size()));
        }
    }
}

}  // namespace patina::assemble
