// Keywords: properties whose value is known before a shader runs. Variants are known when it is compiled, and
// specialization constants when its pipeline is made.
#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/resolve/material.h"

namespace patina::resolve {
namespace {

constexpr std::array<std::string_view, 2> kBools = {"false", "true"};

bool is_switch(const Session& session, std::string_view name) {
    const auto& switches = session.paths->switches;
    return std::any_of(switches.begin(), switches.end(),
                       [&](const paths::SwitchDecl& each) { return each.variable->name == name; });
}

// CompileOptions::switches could not distinguish the two.
void check_name(Session& session, const format::Property& property) {
    if (!format::is_keyword(property.binding) || !is_switch(session, property.name)) return;
    session.diagnostics.report(Code::DuplicateId, property.name_span, "switch", property.name)
        .note("the first is a switch of the rendering paths");
}

void choose(Session& session, MaterialProperty& entry, const std::string& word) {
    const format::Property& property = *entry.property;
    if (!format::is_keyword(property.binding)) {
        if (is_switch(session, property.name)) return;  // the name means the switch
        const bool can_be = property.type == PropertyType::Bool || property.type == PropertyType::Enum;
        session.diagnostics.report(Code::NotAKeyword, {}, property.name, to_string(property.binding))
            .note(
                property.name_span,
                can_be
                    ? "add \"as\": \"variant\" or \"specialization\" here, or set it when the material is drawn"
                    : "only a bool or an enum can be a variant or a constant: set this one when the material is drawn");
        return;
    }
    if (const std::optional<double> value = keyword_value(session, property, word)) {
        entry.chosen = *value;
        entry.is_chosen = true;
    }
}

}  // namespace

void check_listed(Session& session, const Material& material) {
    for (const format::ListedVariant& listed : material.graph->graph->variants) {
        for (const format::ListedVariant::Value& value : listed.values) {
            const auto found = material.property_index.find(value.name);
            const format::Property* property =
                found == material.property_index.end() ? nullptr : material.properties[found->second].property;
            if (!property || property->binding != Binding::Variant) {
                std::vector<std::string_view> known;
                for (const MaterialProperty& entry : material.properties) {
                    if (entry.property->binding == Binding::Variant) known.push_back(entry.property->name);
                }
                session.diagnostics.report(Code::UnknownWord, value.name_span, value.name, "a variant of this graph")
                    .note(known.empty() ? "the graph has no variants" : Diagnostics::suggestion(value.name, known));
                continue;
            }
            const bool is_bool = property->type == PropertyType::Bool;
            if (value.is_bool != is_bool) {
                session.diagnostics
                    .report(Code::WrongJsonType, value.value_span, fmt::format("'{}'", property->name),
                            is_bool ? "true or false" : values_text(*property),
                            is_bool ? "a string" : std::string_view(value.word))
                    .note(property->name_span, "the property is here");
                continue;
            }
            const std::vector<std::string_view> words = keyword_words(*property);
            if (std::find(words.begin(), words.end(), value.word) != words.end()) continue;
            session.diagnostics
                .report(Code::UnknownWord, value.value_span, value.word, fmt::format("a value of '{}'", property->name))
                .note(Diagnostics::suggestion(value.word, words));
        }
    }
}

std::optional<double> keyword_value(Session& session, const format::Property& property, const std::string& word) {
    const std::vector<std::string_view> words = keyword_words(property);
    if (word.empty() && property.type != PropertyType::Bool) {
        session.diagnostics.report(Code::ImpossibleValue, {}, property.name, values_text(property))
            .note(fmt::format("write {}={}", property.name, words[0]))
            .note(property.name_span, "the property is here");
        return {};
    }
    const auto found = std::find(words.begin(), words.end(), word.empty() ? "true" : word);
    if (found != words.end()) return static_cast<double>(found - words.begin());
    session.diagnostics.report(Code::UnknownWord, {}, word, fmt::format("a value of '{}'", property.name))
        .note(Diagnostics::suggestion(word, words))
        .note(property.name_span, "the property is here");
    return {};
}

std::vector<std::string_view> keyword_words(const format::Property& property) {
    if (property.type == PropertyType::Bool) return {kBools.begin(), kBools.end()};
    return {property.values.begin(), property.values.end()};
}

void choose_keywords(Session& session, Material& material, std::size_t first) {
    for (std::size_t i = first; i < material.properties.size(); ++i)
        check_name(session, *material.properties[i].property);
    for (const auto& [name, word] : session.options.switches) {
        const auto found = material.property_index.find(name);
        if (found != material.property_index.end() && found->second >= first)
            choose(session, material.properties[found->second], word);
    }
}

const MaterialProperty* keyword_named(const Material& material, const nodelang::Expr& expr) {
    if (expr.kind != nodelang::Expr::Kind::Property) return nullptr;
    const auto found = material.property_index.find(expr.text);
    if (found == material.property_index.end()) return nullptr;
    const MaterialProperty& entry = material.properties[found->second];
    return format::is_keyword(entry.property->binding) ? &entry : nullptr;
}

std::string values_text(const format::Property& property) {
    if (property.type == PropertyType::Bool) return "a bool";
    return fmt::format("one of {}", enumerate(keyword_words(property)));
}

std::vector<std::string_view> keyword_names(const Material& material) {
    std::vector<std::string_view> names;
    for (const MaterialProperty& entry : material.properties) {
        if (format::is_keyword(entry.property->binding)) names.push_back(entry.property->name);
    }
    return names;
}

}  // namespace patina::resolve
