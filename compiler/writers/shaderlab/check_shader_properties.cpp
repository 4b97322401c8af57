// Reports what a ShaderLab file cannot express about a property. Materials store a value under the property's name, so
// the name is never changed: if Unity uses it already, the property is refused.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "compiler/format/words.h"
#include "compiler/writers/shaderlab/dialect.h"
#include "compiler/writers/shaderlab/share_samplers.h"

namespace patina::writers::shaderlab {
namespace {

// Describes the value with this name that Unity fills for a texture, or that its macros declare.
std::string beside_texture(const resolve::Material& material, std::string_view name) {
    constexpr std::pair<std::string_view, std::string_view> kBeside[] = {
        {"", "_ST"}, {"", "_TexelSize"}, {"", "_HDR"}, {"sampler", ""}};
    for (const resolve::MaterialProperty& entry : material.properties) {
        if (!is_texture(entry.property->type)) continue;
        for (const auto& [before, behind] : kBeside) {
            if (name == fmt::format("{}{}{}", before, entry.property->name, behind))
                return fmt::format("a name that Unity uses for the texture '{}'", entry.property->name);
        }
    }
    return {};
}

// Why a property cannot have the name; empty if it can.
std::string why_taken(const resolve::Material& material, const engines::Engine& engine, std::string_view name) {
    if (const std::string_view declarer = engine.declarer_of(name); !declarer.empty())
        return fmt::format("a name that {} declares", declarer);
    if (languages::is_reserved_word(name)) return "a reserved word of HLSL or GLSL";
    if (languages::safe_identifier(name) != name) return "a name that GLSL reserves";
    if (material.graph->graph->render.is_overridable && is_state_property(name))
        return "a name that \"materialOverride\" needs";
    return beside_texture(material, name);
}

struct Keyword {
    const format::Property* property;
    std::string name;
    std::string_view value{};  // for an enum
    Span where;

    // "of the value 'Wet' of '_Mode'"
    std::string owner() const {
        return value.empty() ? fmt::format("of '{}'", property->name)
                             : fmt::format("of the value '{}' of '{}'", value, property->name);
    }
};

// The keywords of a property.
std::vector<Keyword> keywords_of(const format::Property& property) {
    if (property.values.empty())
        return {{.property = &property, .name = keyword_of(property.name, {}), .where = property.name_span}};
    std::vector<Keyword> made;
    for (std::size_t i = 0; i < property.values.size(); ++i)
        made.push_back({.property = &property,
                        .name = keyword_of(property.name, property.values[i]),
                        .value = property.values[i],
                        .where = property.value_spans[i]});
    return made;
}

class Names {
public:
    Names(const resolve::Material& material, resolve::Session& session)
        : material_(material), engine_(session.engine), paths_(*session.paths), diagnostics_(session.diagnostics) {}

    void check(const format::Property& property, bool is_keyword) {
        const std::string why = why_taken(material_, engine_, property.name);
        if (!why.empty() && is_foreign_color(property)) return refuse_type(property);
        if (!why.empty()) return static_cast<void>(refuse(property, why));
        if (!is_keyword) return values_.push_back(&property);
        for (Keyword& each : keywords_of(property)) {
            const std::string_view declarer = engine_.declarer_of(each.name);
            const Keyword* other = with_keyword(each.name);
            if (other) {
                refuse(each, *other);
            } else if (!declarer.empty()) {
                diagnostics_.report(
                    Code::TakenName, each.where,
                    fmt::format("the keyword '{}' {} is a name that {} declares", each.name, each.owner(), declarer));
            } else {
                keywords_.push_back(std::move(each));
            }
        }
    }

    // A keyword that is on is a macro, so no value can have its name.
    void finish() {
        for (const format::Property* each : values_) {
            if (const Keyword* keyword = with_keyword(each->name))
                refuse(*each, "the keyword " + keyword->owner()).note(keyword->where, "the other declaration is here");
        }
    }

private:
    const Keyword* with_keyword(std::string_view name) const {
        for (const Keyword& each : keywords_) {
            if (each.name == name) return &each;
        }
        return nullptr;
    }

    DiagnosticRecord& refuse(const format::Property& property, const std::string& why) {
        return diagnostics_.report(Code::TakenName, property.name_span,
                                   fmt::format("'{}' is {}: rename the property", property.name, why));
    }

    // A material may have a colour that an included file declares, with the type that it has there.
    bool is_foreign_color(const format::Property& property) const {
        return std::any_of(paths_.foreign.begin(), paths_.foreign.end(), [&](const paths::ForeignDecl& each) {
            return each.variable->name == property.name && !each.include.empty();
        });
    }

    void refuse_type(const format::Property& property) {
        const bool is_color = property.type == PropertyType::Color;
        diagnostics_.report(Code::TakenName, property.name_span,
                            fmt::format("'{}' must {}, because {} declares it as a colour{}", property.name,
                                        is_color ? "not have \"as\": \"instance\"" : "have the type color",
                                        engine_.declarer_of(property.name), is_color ? " of all instances" : ""));
    }

    // With the same keyword, two choices would be one.
    void refuse(const Keyword& keyword, const Keyword& other) {
        const bool is_same_enum = keyword.property == other.property;
        DiagnosticRecord& refused = diagnostics_.report(
            Code::TakenName, keyword.where,
            fmt::format("the keyword '{}' {} is also that {}", keyword.name, keyword.owner(),
                        is_same_enum ? fmt::format("of its value '{}'", other.value) : other.owner()));
        refused.note(other.where, "the other declaration is here");
        if (is_same_enum) refused.note("Unity writes keywords in capitals");
    }

    const resolve::Material& material_;
    const engines::Engine& engine_;
    const paths::PathDeclarations& paths_;
    Diagnostics& diagnostics_;
    std::vector<const format::Property*> values_;
    std::vector<Keyword> keywords_;
};

void check_list(const format::Property& property, bool is_keyword, Diagnostics& diagnostics) {
    const std::size_t most = is_keyword ? kMostKeywords : kMostPairs;
    if (property.type != PropertyType::Enum || property.values.size() <= most) return;
    DiagnosticRecord& report =
        diagnostics.report(Code::InspectorLimit, property.name_span, property.name,
                           fmt::format("it lists at most {} values, and there are {}", most, property.values.size()));
    if (is_keyword) report.note("the number does not set the keyword: enable the keyword from a script");
}

constexpr std::string_view kNoEscapes = "has no escapes, so write it without them";

// Reports labels and names of groups that ShaderLab shows differently. A group is reported once.
class Texts {
public:
    explicit Texts(resolve::Session& session) : session_(session) {}

    void check(const format::Property& property) {
        const std::string label = quoted(property.label), header = header_words(property.group);
        if (label != property.label)
            session_.diagnostics.report(Code::InspectorText, property.label_span, fmt::format("\"{}\"", label), "label",
                                        session_.sources.text(property.label_span), kNoEscapes);
        if (header != property.group && groups_.insert(property.group).second)
            session_.diagnostics.report(
                Code::InspectorText, property.group_span, header.empty() ? "no header" : fmt::format("\"{}\"", header),
                "group", session_.sources.text(property.group_span), "takes letters, digits and spaces there");
    }

private:
    resolve::Session& session_;
    std::set<std::string_view> groups_;
};

}  // namespace

void check_shader_name(const resolve::Material& material, resolve::Session& session) {
    const format::Graph& graph = *material.graph->graph;
    const std::string name = shader_name(graph.name);
    if (name == graph.name) return;
    const bool is_given = graph.name_span.begin != graph.name_span.end;
    session.diagnostics.report(
        Code::InspectorText, is_given ? graph.name_span : Span{graph.span.begin, graph.span.begin + 1},
        fmt::format("\"{}\"", listed_name(graph.name)), "name",
        is_given ? std::string(session.sources.text(graph.name_span)) : fmt::format("\"{}\"", graph.name),
        quoted(graph.name) != graph.name ? kNoEscapes : "makes a menu of each part between slashes");
}

void check_keywords(const resolve::Material& material, const Reflection& reflection, Diagnostics& diagnostics) {
    constexpr std::size_t kMost = 64;
    const auto is_read = [&](const format::Property& property) {
        return std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
            return std::find(pass.keywords.begin(), pass.keywords.end(), property.name) != pass.keywords.end();
        });
    };
    std::size_t count = 0;
    const format::Property* first = nullptr;  // the first that is too many
    for (const resolve::MaterialProperty& entry : material.properties) {
        if (!is_read(*entry.property)) continue;
        count += keywords_of(*entry.property).size();
        if (count > kMost && !first) first = entry.property;
    }
    if (first)
        diagnostics.report(Code::KeywordLimit, first->name_span, count, "Unity before 2021.2", kMost, first->name);
}

void check_shader_properties(const resolve::Material& material, const lower::Lowered& lowered,
                             resolve::Session& session) {
    Diagnostics& diagnostics = session.diagnostics;
    Names names(material, session);
    Texts texts(session);
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const resolve::MaterialProperty& entry = material.properties[i];
        const format::Property& property = *entry.property;
        const lower::PropertyGlobals& globals = lowered.property_globals[i];
        const ir::GlobalId id = globals.texture ? globals.texture : globals.value;
        if (property.type == PropertyType::Sampler && !entry.is_at_port)
            diagnostics.report(Code::FixedSampler, property.name_span, property.name, property.shared_sampler);
        if (!id && !globals.keyword) continue;  // it is a constant
        const ir::Global* global = id ? &lowered.module.globals[id.index] : nullptr;
        const bool is_theirs = global && global->in_block() &&
                               !lowered.module.blocks[global->block].members[global->member].declared_in.empty();
        if (!is_theirs) names.check(property, !id);
        check_list(property, !id, diagnostics);
        texts.check(property);
        if (const std::string_view setter = script_setter(property); !setter.empty())
            diagnostics.report(Code::NoDefault, property.name_span, property.name, setter);
        if (entry.is_file)
            diagnostics.report(Code::NoFileDefault, property.default_span, property.name, default_word(property));
        if (const std::string words = sampler_words(property); !words.empty())
            diagnostics.report(Code::NoSampler, property.sampler_span, property.name, words);
    }
    names.finish();
}

void check_samplers(std::span<const LinkedPass> passes, const engines::Engine& engine, Diagnostics& diagnostics) {
    const SamplerUse use = sampler_use(passes, engine.most_samplers);
    // The first pass that is refused, or else the one that needs the most.
    const auto rank = [&](const SamplerUse::OfPass& each) {
        return each.count() > engine.most_samplers ? std::numeric_limits<std::size_t>::max() : each.wanted();
    };
    const auto worst = std::max_element(use.passes.begin(), use.passes.end(),
                                        [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    if (worst == use.passes.end() || worst->wanted() <= engine.most_samplers) return;
    const LinkedPass& pass = passes[static_cast<std::size_t>(worst - use.passes.begin())];
    const auto texture_of = [](std::string_view sampler) { return sampler.substr(std::string_view("sampler").size()); };
    const auto span_of = [&](std::string_view name) {
        for (const resolve::MaterialProperty& entry : pass.material->properties)
            if (entry.property->name == name) return entry.property->name_span;
        return pass.material->properties.front().property->name_span;
    };
    const std::size_t room = engine.most_samplers - std::min<std::size_t>(worst->of_engine, engine.most_samplers);
    const std::string need =
        fmt::format("the pass '{}' reads {} textures, and Direct3D 11 has {} samplers{}", name_of(pass),
                    worst->of_material, engine.most_samplers,
                    worst->of_engine > 0 ? fmt::format(", of which Unity's own text needs {}", worst->of_engine) : "");
    if (worst->count() > engine.most_samplers) {
        diagnostics.report(Code::TooMany, span_of({}), worst->of_material, "textures in one pass", room)
            .note(need)
            .note("textures with the same \"sampler\" can share one; textures of the vertex stage cannot");
        return;
    }
    for (const auto& [sampler, owner] : use.shared) {
        diagnostics.report(Code::SamplerLimit, span_of(texture_of(sampler)), texture_of(sampler), texture_of(owner),
                           need);
    }
}

}  // namespace patina::writers::shaderlab
