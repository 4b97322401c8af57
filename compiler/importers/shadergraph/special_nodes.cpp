// Nodes that no row of the table can say: their inputs depend on the file, or their value is no number.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/letters.h"
#include "compiler/importers/patterns.h"
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {
namespace {

// --- constants

void color(GraphMaker& maker, std::size_t node) {
    const Node& at = maker.node(node);
    std::vector<double> value = vector_of(at.json, "m_Color.color", 4);
    // Nodes of the first version converted HDR colours, too.
    if (whole_of(at.json, "m_Color.mode") == 0 || at.version < 1)
        for (std::size_t i = 0; i < 3; ++i) value[i] = linear(value[i]);
    maker.set(node, 0, constant(value));
}

void matrix(GraphMaker& maker, std::size_t node, std::size_t rows) {
    Term made{.type = matrix_type(rows)};
    for (std::size_t row = 0; row < rows; ++row) {
        const std::vector<double> numbers = vector_of(maker.node(node).json, fmt::format("m_Row{}", row), rows);
        made.numbers.insert(made.numbers.end(), numbers.begin(), numbers.end());
    }
    maker.set(node, 0, made);
}
void matrix2(GraphMaker& maker, std::size_t node) {
    matrix(maker, node, 2);
}
void matrix3(GraphMaker& maker, std::size_t node) {
    matrix(maker, node, 3);
}
void matrix4(GraphMaker& maker, std::size_t node) {
    matrix(maker, node, 4);
}

void engine_matrix(GraphMaker& maker, std::size_t node) {
    static constexpr std::string_view kKinds[] = {"ObjectToWorld", "WorldToObject", "WorldToView", "ViewToWorld",
                                                  "ViewToClip",    "ClipToView",    "WorldToClip", "ClipToWorld"};
    const Json* json = maker.node(node).json;
    const int kind = member(json, "m_MatrixType") ? whole_of(json, "m_MatrixType") : whole_of(json, "m_matrix");
    if (kind < 0 || kind >= static_cast<int>(std::size(kKinds))) {
        maker.refuse(node, fmt::format("its matrix is {}, which this importer does not know", kind));
        return;
    }
    ImportedNode made{.id = {}, .node = "TransformationMatrix"};
    if (kind > 0) made.inputs.push_back({"kind", kKinds[kind]});
    // The engine's depth in clip space depends on the device.
    if (kind > 3) maker.approximate(node, "in clip space, the depth is 0 at the near plane and 1 at the far one");
    maker.set(node, 0, link(maker.add_node(node, std::move(made)), Type::Matrix4));
}

void sampler_state(GraphMaker& maker, std::size_t node) {
    const Json* json = maker.node(node).json;
    const NearestSampler sampler = nearest_sampler(
        whole_in(json, "m_filter", 0, 0, 2), whole_in(json, "m_wrap", 0, 0, 3), whole_in(json, "m_aniso", 0, 0, 4));
    if (!sampler.difference.empty()) maker.approximate(node, sampler.difference);
    maker.set(node, 0, link(std::string(sampler.name), Type::Sampler));
    maker.taken(node, fmt::format("the sampler '{}'", sampler.name));
}

void texture_asset(GraphMaker& maker, std::size_t node) {
    const Node& at = maker.node(node);
    const Type type = at.slots.empty() ? Type::Texture2D : maker.type_of(node, at.slots.front());
    maker.set(node, 0,
              maker.texture_constant(node, type, at.json, type == Type::Cubemap ? "m_Cubemap" : "m_Texture", 0));
}

// --- vectors and matrices

// Two matrices, or a matrix and a vector, are multiplied as such; what is connected decides.
void multiply(GraphMaker& maker, std::size_t node) {
    const auto first = maker.linked_term(node, 0), second = maker.linked_term(node, 1);
    const bool is_first = first && is_matrix(first->type), is_second = second && is_matrix(second->type);
    if (!is_first && !is_second) {
        apply_rule(maker, node);
        return;
    }
    std::size_t rows = 4;
    if (is_first) rows = std::min(rows, width(first->type));
    if (is_second) rows = std::min(rows, width(second->type));
    const auto operand = [&](const std::optional<Term>& linked, int slot) {
        if (linked && is_matrix(linked->type)) return converted(maker.named(*linked), matrix_type(rows));
        if (linked) return converted(*linked, vector_type(rows));
        const Slot* own = maker.node(node).slot(slot);
        if (!own) return converted(maker.without_slot(node, slot), vector_type(rows));
        std::vector<double> row;
        for (std::size_t i = 0; i < rows; ++i) row.push_back(number_of(own->json, fmt::format("m_Value.e0{}", i)));
        return constant(row);
    };
    const Term a = operand(first, 0), b = operand(second, 1);
    const Type type = is_first && is_second ? matrix_type(rows) : vector_type(rows);
    maker.set(node, 2, terms::computed("mul(a, b)", {a, b}, type));
}

void matrix_split(GraphMaker& maker, std::size_t node) {
    const bool is_column = whole_of(maker.node(node).json, "m_Axis") == 1;
    Term matrix = maker.named(maker.input(node, 0));
    if (is_column) {
        matrix = terms::computed("transpose(a)", {matrix}, matrix.type);
        matrix.owner = node;
        matrix = maker.named(matrix);
    }
    const std::size_t rows = width(matrix.type);
    for (int i = 0; i < 4; ++i) {
        const bool exists = static_cast<std::size_t>(i) < rows;
        if (!maker.is_used(node, i + 1)) continue;
        Term row = exists ? terms::computed("a[b]", {matrix, number_term(i)}, vector_type(rows))
                          : constant(std::vector<double>(rows, 0.0));
        maker.set(node, i + 1, row);
    }
}

void append(GraphMaker& maker, std::size_t node) {
    const auto part = [&](int slot, std::size_t most) {
        const auto linked = maker.linked_term(node, slot);
        const Term made = linked ? *linked : converted(maker.input(node, slot), Type::Float);
        const Term value = made.type == Type::Bool ? converted(made, Type::Float) : made;
        return width(value.type) > most ? converted(value, vector_type(most)) : value;
    };
    const Term a = part(0, 3), b = part(1, 4 - width(a.type));
    const Term parts[] = {a, b};
    maker.set(node, 2, terms::vector_of(vector_type(width(a.type) + width(b.type)), parts));
}

void swizzle(GraphMaker& maker, std::size_t node) {
    const Node& at = maker.node(node);
    const Term from = maker.linked_term(node, 0).value_or(maker.input(node, 0));
    std::string mask(text_of(at.json, "_maskInput"));
    static constexpr std::string_view kLetters = "xyzwrgba";
    for (char& c : mask) {
        const std::size_t found = kLetters.find(to_lower(c));
        c = found == kLetters.npos ? '?' : kLetters[found % 4];
    }
    if (mask.empty() && member(at.json, "m_RedChannel")) {  // the first version: always four
        for (const std::string_view key : {"m_RedChannel", "m_GreenChannel", "m_BlueChannel", "m_AlphaChannel"})
            mask += kLetters[static_cast<std::size_t>(whole_in(at.json, key, 0, 0, 3))];
    }
    if (mask.empty()) mask = "xxxx";
    if (mask.size() > 4 || mask.find('?') != mask.npos) {
        maker.refuse(node, fmt::format("'{}' is no list of one to four components", text_of(at.json, "_maskInput")));
        return;
    }
    // The input is as wide as the highest component that is read, and what it lacks is 0 or, the fourth, 1.
    std::size_t needs = 1;
    for (const char c : mask) needs = std::max(needs, kLetters.find(c) + 1);
    Term value = from.type == Type::Bool ? converted(from, Type::Float) : from;
    if (width(value.type) < needs) value = converted(value, vector_type(needs));
    if (!value.is_constant() && value.widths.empty()) value = maker.named(value);
    Term made = swizzled(value, mask);
    made.nodes.insert(node);
    maker.set(node, 1, made);
}

// --- the mesh and the screen

void uv(GraphMaker& maker, std::size_t node) {
    maker.set(node, 0, maker.coordinates(node, whole_of(maker.node(node).json, "m_OutputChannel")));
}

bool is_default_screen(const Node& node) {
    return whole_of(node.json, "m_ScreenSpaceType") == 0;
}

void screen_position(GraphMaker& maker, std::size_t node) {
    if (!is_default_screen(maker.node(node))) {
        apply_rule(maker, node);
        return;
    }
    Slot slot{.kind = "ScreenPosition", .is_input = true, .json = maker.node(node).json};
    maker.set(node, 0, maker.bound(node, slot, {}));
}

void custom_interpolator(GraphMaker& maker, std::size_t node) {
    const std::string name(text_of(maker.node(node).json, "customBlockNodeName"));
    for (const Block& block : maker.graph().blocks) {
        if (!block.is_vertex || block.name.substr(0, block.name.find('#')) != name) continue;
        // "Blend#3#nointerpolation"
        const std::size_t qualifier = block.name.find('#', std::min(block.name.find('#'), block.name.size() - 1) + 1);
        if (qualifier != block.name.npos)
            maker.approximate(node, fmt::format("its value is interpolated in the usual way, not as '{}'",
                                                block.name.substr(qualifier + 1)));
        const Slot* slot = maker.node(block.node).slot(block.slot);
        const Type type = slot ? maker.type_of(block.node, *slot) : Type::Float4;
        // The block becomes a node of this name, which is computed for each vertex.
        maker.set(node, 0, link(maker.interpolator(name), type));
        maker.taken(node, fmt::format("the node '{}'", maker.interpolator(name)));
        return;
    }
    maker.refuse(node, fmt::format("the vertex context has no custom interpolator '{}'", name));
}

// --- choices

void property_node(GraphMaker& maker, std::size_t node) {
    if (!maker.property(maker.node(node).refers)) {
        maker.refuse(node, "the graph does not have its property");
        return;
    }
    maker.set(node, 0, maker.property_term(node));
}

// A condition, and the slot that it chooses.
using Case = std::pair<Term, int>;

// The last one counts for every other value.
void choose(GraphMaker& maker, std::size_t node, int output, const std::vector<Case>& cases) {
    std::vector<Term> values;
    for (const Case& each : cases) {
        Term value = maker.input(node, each.second);
        if (value.text().size() > 40) value = maker.named(value);
        values.push_back(std::move(value));
    }
    Term made = values.back();
    for (std::size_t i = cases.size() - 1; i-- > 0;) {
        made = terms::computed("a ? b : c", {cases[i].first, values[i], made}, values.back().type);
        made.type = values.back().type;
    }
    maker.set(node, output, made);
}

void keyword(GraphMaker& maker, std::size_t node) {
    const Property* keyword = maker.property(maker.node(node).refers);
    if (!keyword) {
        maker.refuse(node, "the graph has no such keyword");
        return;
    }
    const std::string name = "$" + maker.property_name(*keyword);
    const std::vector<KeywordEntry> entries = keyword_entries(*keyword);
    std::vector<Case> cases;
    if (entries.empty()) cases = {{link(name, Type::Bool), 1}, {Term{}, 2}};
    for (const KeywordEntry& each : entries)
        cases.push_back(
            {terms::computed("a == b", {link(name, Type::None), link(each.word, Type::None)}, Type::Bool), each.id});
    const KeywordUse use = maker.keyword_use(node, *keyword);
    if (use == KeywordUse::Off) cases.erase(cases.begin(), cases.end() - 1);
    if (use == KeywordUse::OffInVertex || use == KeywordUse::OffInFragment)
        maker.approximate(node, fmt::format("the {} stage, too, has the keyword, which the engine declares for the {} "
                                            "stage alone",
                                            use == KeywordUse::OffInVertex ? "vertex" : "fragment",
                                            use == KeywordUse::OffInVertex ? "fragment" : "vertex"));
    choose(maker, node, 0, cases);
}

// The first case that holds counts, else the fallback.
void switch_cases(GraphMaker& maker, std::size_t node) {
    static constexpr std::string_view kWords[] = {"==", "!=", "<", "<=", ">", ">="};
    constexpr int kFallback = 1, kOutput = 2, kFirst = 3;
    const Json* json = maker.node(node).json;
    const std::vector<Json>& entries =
        elements_of(json, flag_of(json, "m_useProperty") ? "m_casesFromUpstreamEnumProperty" : "m_cases");
    Term number = maker.input(node, 0);
    if (flag_of(json, "m_floorPredicate", true)) {
        number = terms::computed("floor(a)", {number}, Type::Float);
        number.owner = node;
        number.nodes.insert(node);
    }
    if (entries.size() > 1) number = maker.named(number);
    std::vector<Case> cases;
    for (const Json& each : entries)
        cases.push_back({terms::computed(fmt::format("a {} b", kWords[whole_in(&each, "comparisonType", 0, 0, 5)]),
                                         {number, number_term(number_of(&each, "threshold"))}, Type::Bool),
                         kFirst + static_cast<int>(cases.size())});
    cases.push_back({Term{}, kFallback});
    choose(maker, node, kOutput, cases);
}

void dropdown(GraphMaker& maker, std::size_t node) {
    const Property* dropdown = maker.property(maker.node(node).refers);
    if (!dropdown) {
        maker.refuse(node, "the graph has no such dropdown");
        return;
    }
    std::vector<Case> cases;
    const Term chosen = link("$" + maker.property_name(*dropdown), Type::None);
    for (const Json& entry : elements_of(dropdown->json, "m_Entries"))
        cases.push_back(
            {terms::computed("a == b", {chosen, number_term(static_cast<double>(cases.size()))}, Type::Bool),
             whole_of(&entry, "id")});
    if (cases.empty())
        maker.refuse(node, "its dropdown has no entries");
    else
        choose(maker, node, 0, cases);
}

void branch_on_connection(GraphMaker& maker, std::size_t node) {
    // The state comes from a property, through wires only.
    std::size_t at = node;
    int slot = 0;
    const Property* property = nullptr;
    for (const Edge& edge : maker.graph().edges)
        if (edge.to == at && edge.to_slot == slot) property = maker.property(maker.node(edge.from).refers);
    if (property && maker.graph().is_subgraph) {
        choose(maker, node, 3, {{link("$" + maker.connected_input(*property), Type::Bool), 1}, {Term{}, 2}});
        return;
    }
    // In a material, and without a property, nothing is connected.
    Term made = maker.input(node, 2);
    made.nodes.insert(node);
    maker.set(node, 3, made);
}

struct Special {
    std::string_view kind;
    void (*make)(GraphMaker& maker, std::size_t node);
};
constexpr Special kSpecial[] = {
    {"ColorNode", color},
    {"Matrix2Node", matrix2},
    {"Matrix3Node", matrix3},
    {"Matrix4Node", matrix4},
    {"TransformationMatrixNode", engine_matrix},
    {"SamplerStateNode", sampler_state},
    {"Texture2DAssetNode", texture_asset},
    {"Texture2DArrayAssetNode", texture_asset},
    {"Texture3DAssetNode", texture_asset},
    {"CubemapAssetNode", texture_asset},
    {"GradientNode", make_gradient},
    {"SampleGradient", make_sample_gradient},
    {"SampleGradientNode", make_sample_gradient},
    {"MultiplyNode", multiply},
    {"MatrixSplitNode", matrix_split},
    {"AppendVectorNode", append},
    {"SwizzleNode", swizzle},
    {"UVNode", uv},
    {"ScreenPositionNode", screen_position},
    {"CustomInterpolatorNode", custom_interpolator},
    {"PropertyNode", property_node},
    {"KeywordNode", keyword},
    {"SwitchNode", switch_cases},
    {"DropdownNode", dropdown},
    {"BranchOnInputConnectionNode", branch_on_connection},
    {"SubGraphNode", make_subgraph_node},
    {"CustomFunctionNode", make_custom_function},
};

}  // namespace

bool apply_special(GraphMaker& maker, std::size_t node) {
    const auto found = std::ranges::find(kSpecial, maker.node(node).kind, &Special::kind);
    if (found == std::end(kSpecial)) return false;
    found->make(maker, node);
    return true;
}

std::vector<std::string_view> special_classes() {
    std::vector<std::string_view> made;
    for (const Special& each : kSpecial) made.push_back(each.kind);
    return made;
}

}  // namespace patina::importers::shadergraph
