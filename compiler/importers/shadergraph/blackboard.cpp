// Properties, keywords and dropdowns: properties of a material, or inputs of a sub-graph.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/letters.h"
#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/values.h"

namespace patina::importers::shadergraph {
namespace {

// "#c9a27e" if the colour is one of eight bits a channel, else linear numbers.
GraphValue color_value(const std::vector<double>& srgb, bool is_hdr) {
    std::string hex = "#";
    for (std::size_t i = 0; i < 4; ++i) {
        const double steps = srgb[i] * 255;
        if (is_hdr || steps < -0.01 || steps > 255.01 || std::abs(steps - std::round(steps)) > 0.01) hex.clear();
        if (hex.empty()) break;
        if (i < 3 || srgb[3] != 1) hex += fmt::format("{:02x}", static_cast<int>(std::round(steps)));
    }
    if (!hex.empty()) return hex;
    std::vector<float> numbers;
    for (std::size_t i = 0; i < 4; ++i)
        if (i < 3 || srgb[3] != 1) numbers.push_back(static_cast<float>(i == 3 || is_hdr ? srgb[i] : linear(srgb[i])));
    return list_of(numbers);
}

// What a property says of itself, beside its name and type.
struct Declaration {
    std::string type{};
    std::optional<GraphValue> value{};
    GraphMembers more{};
    std::string help{};
    std::string difference{};  // what the graph does not say
};

// Letters and digits alone, in small letters.
std::string plain(std::string_view name) {
    std::string made;
    for (const char c : identifier(name))
        if (c != '_') made += to_lower(c);
    return made;
}

constexpr int kSlider = 1, kInteger = 2;

bool is_whole_number(const Property& property) {
    const int kind = whole_in(property.json, "m_FloatType", 0, 0, 3);
    return kind == kInteger || (kind == kSlider && whole_in(property.json, "m_SliderType", 0, 0, 2) == kInteger);
}

void add(std::string& differences, std::string_view another) {
    if (!another.empty()) differences += (differences.empty() ? "" : "; ") + std::string(another);
}

// A range is as wide as the default needs.
void add_range(const Property& property, double value, Declaration& made) {
    double low = number_of(property.json, "m_RangeValues.x"), high = number_of(property.json, "m_RangeValues.y", 1);
    if (made.type == "int") {
        constexpr double kMost = 1e9;
        low = std::clamp(std::round(low), -kMost, kMost);
        high = std::clamp(std::round(high), -kMost, kMost);
    }
    if (low >= high)
        return add(made.difference, fmt::format("its range begins at {} and ends at {}: it has none", low, high));
    if (value < low || value > high)
        add(made.difference,
            fmt::format("its default {} is outside of its range, {} to {}, which reaches it here", value, low, high));
    made.more.push_back({"range", GraphValue::list({static_cast<float>(std::min(low, value)),
                                                    static_cast<float>(std::max(high, value))})});
}

// "0 is Low, 5 is High"
std::string words_of_list(const Property& property) {
    const std::vector<Json>& words = elements_of(property.json, "m_EnumNames");
    const std::vector<Json>& values = elements_of(property.json, "m_EnumValues");
    std::string made;
    for (std::size_t i = 0; i < std::min(words.size(), values.size()); ++i)
        made += fmt::format("{}{} is {}", made.empty() ? "" : ", ", values[i].number, words[i].string);
    return made;
}

// The input of a sub-graph takes whatever number is connected, as in the engine.
Declaration number_declaration(const Property& property, bool is_input) {
    Declaration made{.type = "float"};
    const double value = number_of(property.json, "m_Value");
    const int kind = whole_in(property.json, "m_FloatType", 0, 0, 3);
    if (!is_input && is_whole_number(property)) {
        made.type = "int";
        const double whole = std::round(std::clamp(value, -1e9, 1e9));
        made.value = whole;
        if (value != std::round(value)) made.difference = "its default is not a whole number";
        if (value != std::clamp(value, -1e9, 1e9))
            made.difference = fmt::format(
                "its default is {}, and a whole number ends at a thousand million: {} is taken", value, whole);
        if (kind == kSlider) add_range(property, whole, made);
        return made;
    }
    made.value = static_cast<float>(value);
    if (kind == kSlider) {
        add_range(property, value, made);
        if (whole_of(property.json, "m_SliderType") == 1) add(made.difference, "its slider is even, without a power");
    }
    if (kind == 3 && !is_input) made.help = words_of_list(property);
    if (kind == 3)
        add(made.difference, made.help.empty() ? "it is a number, without the words of its list"
                                               : "it is a number, and its help has the words of its list");
    return made;
}

Declaration color_declaration(const Property& property) {
    const bool is_hdr = whole_in(property.json, "m_ColorMode", 0, 0, 1) == 1;
    const std::vector<double> value = vector_of(property.json, "m_Value", 4);
    Declaration made{.type = "color", .value = color_value(value, is_hdr)};
    if (!is_hdr) return made;
    double high = 16;
    for (const double each : value) high = std::max(high, std::ceil(each));
    made.more.push_back({"range", GraphValue::list({0.0, high})});
    return made;
}

// A keyword that the engine knows.
bool is_of_engine(const Property& keyword) {
    return whole_in(keyword.json, "m_KeywordDefinition", 0, 0, 3) == 2 || !flag_of(keyword.json, "m_IsEditable", true);
}

Declaration keyword_declaration(const Property& property) {
    Declaration made{.type = "bool"};
    const std::vector<KeywordEntry> entries = keyword_entries(property);
    if (!entries.empty()) {
        made.type = "enum";
        std::vector<GraphValue> all;
        std::string help;
        for (const KeywordEntry& each : entries) {
            all.emplace_back(each.word);
            if (plain(each.shown) != plain(each.word))
                help += fmt::format("{}{} is {}", help.empty() ? "" : ", ", each.word, each.shown);
            made.difference += (made.difference.empty() || each.difference.empty() ? "" : "; ") + each.difference;
        }
        made.more.push_back({"values", GraphValue::list(std::move(all))});
        if (!help.empty()) made.help = help;
        const int chosen = whole_in(property.json, "m_Value", 0, 0, static_cast<int>(entries.size()) - 1);
        made.value = entries[static_cast<std::size_t>(chosen)].word;
    } else {
        made.value = flag_of(property.json, "m_Value");
    }
    if (whole_in(property.json, "m_KeywordDefinition", 0, 0, 3) != 3) made.more.push_back({"as", "variant"});
    if (is_of_engine(property)) add(made.difference, "the engine sets it; here it is a variant with a default");
    return made;
}

Declaration declaration_of(const Property& property, bool is_input) {
    const std::string_view kind = property.kind;
    if (kind == "Vector1") return number_declaration(property, is_input);
    if (kind == "Color") return color_declaration(property);
    if (kind == "Keyword") return keyword_declaration(property);
    if (kind == "Boolean") return {.type = "bool", .value = flag_of(property.json, "m_Value")};
    if (is_vector(type_of_property(kind))) {
        const std::size_t count = width(type_of_property(kind));
        const std::vector<double> value = vector_of(property.json, "m_Value", count);
        return {.type = fmt::format("float{}", count),
                .value = list_of(std::vector<float>(value.begin(), value.end()))};
    }
    const Type type = type_of_property(kind);
    if (type == Type::Sampler) {
        NearestSampler sampler = nearest_sampler(whole_in(property.json, "m_Value.m_filter", 0, 0, 2),
                                                 whole_in(property.json, "m_Value.m_wrap", 0, 0, 3),
                                                 whole_in(property.json, "m_Value.m_anisotropic", 0, 0, 4));
        return {.type = "sampler", .value = sampler.name, .difference = std::move(sampler.difference)};
    }
    if (type == Type::Gradient)
        return {.type = "gradient", .value = gradient_value(gradient_of(member(property.json, "m_Value")))};
    if (is_matrix(type)) {
        std::vector<GraphValue> all;
        for (std::size_t row = 0; row < width(type); ++row) {
            std::vector<float> numbers;
            for (std::size_t column = 0; column < width(type); ++column)
                numbers.push_back(
                    static_cast<float>(number_of(property.json, fmt::format("m_Value.e{}{}", row, column))));
            all.push_back(list_of(numbers));
        }
        return {.type = std::string(word(type)), .value = GraphValue::list(std::move(all))};
    }
    return {};
}

bool is_texture(std::string_view kind) {
    return kind.starts_with("Texture") || kind == "Cubemap";
}

// How the engine's shader declares a property.
enum class Scope { Undeclared, Global, Material, Instance };
Scope scope_of(const Property& property) {
    if (!flag_of(property.json, "overrideHLSLDeclaration"))
        return flag_of(property.json, "m_GPUInstanced") ? Scope::Instance : Scope::Material;
    return static_cast<Scope>(whole_in(property.json, "hlslDeclarationOverride", 2, 0, 3));
}

// A value for each instance, if a property of the type can have that.
void add_scope(const Property& property, Declaration& made) {
    const bool is_bound = std::ranges::find(made.more, "as", &GraphMember::key) != made.more.end();
    const bool is_number = made.type == "int" || made.type == "bool" || made.type == "enum" || made.type == "color" ||
                           made.type.starts_with("float");
    const bool is_matrix = made.type.find('x') != made.type.npos;
    if (scope_of(property) == Scope::Instance && !is_bound && is_number && !is_matrix)
        made.more.push_back({"as", "instance"});
    else
        add(made.difference, scope_difference(property));
    add(made.difference, hidden_difference(property));
}

}  // namespace

std::string_view hidden_difference(const Property& property) {
    return property.is_exposed && property.is_hidden ? "inspectors show it here, and do not in the engine" : "";
}

std::string_view scope_difference(const Property& property) {
    switch (scope_of(property)) {
        case Scope::Undeclared: return "the project's own code declares it; here it is a property of the material";
        case Scope::Global: return "it has one value for all materials, which scripts set; here each has its own";
        case Scope::Instance: return "it has one value for all instances";
        case Scope::Material: break;
    }
    // Those are never exposed.
    const Type type = type_of_property(property.kind);
    if (type == Type::Sampler || type == Type::Gradient || patina::importers::terms::is_matrix(type)) return {};
    if (property.is_exposed) return "";
    if (property.kind == "Keyword")
        return is_of_engine(property)
                   ? ""
                   : "it is not exposed: scripts or the engine set it; here it is a property of the material";
    return "it is not exposed: scripts alone set it; here it is a property of the material";
}

std::vector<KeywordEntry> keyword_entries(const Property& keyword) {
    std::vector<KeywordEntry> made;
    if (whole_in(keyword.json, "m_KeywordType", 0, 0, 1) == 0) return made;
    Names words;
    for (const Json& entry : elements_of(keyword.json, "m_Entries")) {
        KeywordEntry each{.shown = std::string(text_of(&entry, "displayName")), .id = whole_of(&entry, "id")};
        std::string reference(text_of(&entry, "referenceName"));
        if (reference.empty()) reference = each.shown;
        each.word = words.unique(identifier(reference), "Value");
        if (each.word != identifier(reference))
            each.difference = fmt::format("its entry '{}' is called '{}'", reference, each.word);
        made.push_back(std::move(each));
    }
    return made;
}

KeywordUse GraphMaker::keyword_use(std::size_t index, const Property& keyword) const {
    constexpr int kPredefined = 2, kAll = 63, kVertex = 1, kFragment = 2;
    if (graph_.is_subgraph || whole_in(keyword.json, "m_KeywordDefinition", 0, 0, 3) >= kPredefined)
        return KeywordUse::Declared;
    const int stages = whole_in(keyword.json, "m_KeywordStages", kAll, 0, kAll);
    const bool is_in_vertex = in_vertex_.contains(index), is_in_fragment = in_fragment_.contains(index);
    const bool lacks_vertex = is_in_vertex && !(stages & kVertex);
    const bool lacks_fragment = is_in_fragment && !(stages & kFragment);
    if (lacks_vertex == is_in_vertex && lacks_fragment == is_in_fragment) return KeywordUse::Off;
    return lacks_vertex ? KeywordUse::OffInVertex : lacks_fragment ? KeywordUse::OffInFragment : KeywordUse::Declared;
}

const Property* GraphMaker::property(std::string_view id) const {
    const auto found = std::ranges::find(graph_.properties, id, &Property::id);
    return id.empty() || found == graph_.properties.end() ? nullptr : &*found;
}

std::string GraphMaker::property_name(const Property& property) const {
    const auto found = properties_.find(property.id);
    return found == properties_.end() ? std::string() : found->second;
}

std::string GraphMaker::name_for_texture(std::string_view property) const {
    const std::size_t mark = property.rfind('_');
    const std::string_view end = mark == property.npos ? std::string_view() : property.substr(mark + 1);
    const bool is_made = end.size() >= 6 && end.find_first_not_of("0123456789abcdefABCDEF") == end.npos;
    for (const Property& each : graph_.properties)
        if (is_made && property_name(each) == property && !camel_case(each.name).empty()) return camel_case(each.name);
    return camel_case(property);
}

void GraphMaker::read_blackboard() {
    for (const Property& property : graph_.properties) {
        const bool is_keyword = property.kind == "Keyword";
        const bool is_input = graph_.is_subgraph && !is_keyword;
        const std::string kind = is_keyword ? "keyword" : property.kind == "Dropdown" ? "dropdown" : "property";
        const std::string part = fmt::format("{} '{}'", kind, property.name);
        const Type type = type_of_property(property.kind);
        std::string wanted = is_input ? camel_case(property.name) : identifier(property.reference);
        if (wanted.empty()) wanted = camel_case(property.name);
        const std::string name = file_.property_names.unique(wanted, "property");
        const std::string renamed = is_input || name == property.reference || property.reference.empty()
                                        ? ""
                                        : fmt::format("the shader calls it '{}'", property.reference);
        properties_[property.id] = name;
        SubgraphPorts::Input port{.name = name, .guid = property.guid, .reference = property.reference, .type = type};
        port.is_perceptual = type == Type::Gradient && gradient_of(member(property.json, "m_Value")).is_perceptual();
        if (is_vector(type) && property.kind != "Color")
            port.numbers = type == Type::Float ? std::vector<double>{number_of(property.json, "m_Value")}
                                               : vector_of(property.json, "m_Value", width(type));
        Declaration made = declaration_of(property, is_input);
        const std::string what =
            is_input ? fmt::format("the input '{}'", name) : fmt::format("the property '{}'", name);
        if (is_texture(property.kind)) {
            if (is_input) {
                made.type = type == Type::Texture2D   ? "texture2d"
                            : type == Type::Texture3D ? "texture3d"
                            : type == Type::Cubemap   ? "textureCube"
                                                      : "texture2dArray";
            } else {
                // Declared at the end, when it is known how it is sampled.
                textures_[name].renamed = renamed;
                file_.properties.push_back({.name = name, .type = {}});
                continue;
            }
        } else if (property.kind == "Dropdown") {
            if (!is_input) {
                remark(Remark::Kind::Changed, part, "a material has no dropdowns: its first entry counts",
                       property.place);
                continue;
            }
            port.is_dropdown = true;
            int chosen = -1;
            for (const Json& entry : elements_of(property.json, "m_Entries")) {
                if (whole_of(&entry, "id") == whole_of(property.json, "m_Value"))
                    chosen = static_cast<int>(port.entries.size());
                port.entries.emplace_back(text_of(&entry, "displayName"));
            }
            if (chosen < 0)
                made.difference = fmt::format("no entry has the number {}: the first one is taken",
                                              whole_of(property.json, "m_Value"));
            made.type = "int";
            made.value = static_cast<double>(std::max(chosen, 0));
            port.numbers = {static_cast<double>(std::max(chosen, 0))};
        } else if (made.type.empty()) {
            remark(Remark::Kind::Changed, part, "a graph has no such property", property.place);
            if (is_input) ports_.inputs.push_back(port);
            continue;
        }
        for (const std::string& each : {renamed, property.misread, take_misreads()}) add(made.difference, each);
        if (!is_input) add_scope(property, made);
        if (is_input) {
            std::erase_if(made.more, [](const GraphMember& each) { return each.key != "range"; });
            file_.inputs.push_back(
                {.name = name, .type = made.type, .value = made.value, .more = std::move(made.more)});
            ports_.inputs.push_back(port);
        } else {
            ImportedProperty declared{
                .name = name, .type = made.type, .value = made.value, .more = std::move(made.more)};
            if (property.name != name && !property.name.empty()) declared.more.push_back({"label", property.name});
            if (!property.group.empty()) declared.more.push_back({"group", property.group});
            if (!made.help.empty()) declared.more.push_back({"help", made.help});
            file_.properties.push_back(std::move(declared));
        }
        remark(made.difference.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, part,
               what + (made.difference.empty() ? "" : ": " + made.difference), property.place);
    }
}

Term GraphMaker::property_term(std::size_t index) {
    const Property* found = property(node(index).refers);
    const Type type = found ? type_of_property(found->kind) : Type::None;
    if (type == Type::None) {
        Term made = number_term(0);
        approximate(index, "the graph has no such property: it is 0");
        for (const Slot& slot : node(index).slots)
            if (!slot.is_input && is_value(type_of(index, slot))) made = converted(made, type_of(index, slot));
        return made;
    }
    if (type == Type::VirtualTexture) return {.type = type};
    const std::string name = "$" + property_name(*found);
    if (type == Type::Gradient) {
        Term made = link(name, type);
        made.gradient = std::make_shared<const Gradient>(gradient_of(member(found->json, "m_Value")));
        made.nodes = {index};
        return made;
    }
    Term made = link(name, type);
    made.is_color = found->kind == "Color";
    if (found->kind == "Vector1" && !graph_.is_subgraph && is_whole_number(*found))
        made.tree = nodelang::call("float", {made.tree});
    made.nodes = {index};
    return made;
}

std::string GraphMaker::connected_input(const Property& property) {
    const auto port = std::ranges::find(ports_.inputs, property.guid, &SubgraphPorts::Input::guid);
    if (port == ports_.inputs.end()) return "false";
    if (port->connected.empty()) {
        port->connected = file_.property_names.unique(port->name + "Connected", "connected");
        file_.inputs.push_back({.name = port->connected, .type = "bool", .value = false});
    }
    return port->connected;
}

}  // namespace patina::importers::shadergraph
