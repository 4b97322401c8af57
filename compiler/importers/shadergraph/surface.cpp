// What the graph gives to its target: the surface and the vertex block of a material, or the outputs of a sub-graph;
// and the settings of the target as the material's render state.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "compiler/importers/patterns.h"
#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/shadergraph/lost_settings.h"
#include "compiler/importers/shadergraph/settings.h"

namespace patina::importers::shadergraph {
namespace {

struct BlockRow {
    std::string_view block, input;
    Type type;
    double otherwise;  // the input's own default, which is not written; below 0: it is always written
};
constexpr BlockRow kLit[] = {
    {"BaseColor", "baseColor", Type::Float3, -1},
    {"SpriteColor", "baseColor", Type::Float4, -1},
    {"NormalTS", "normalTS", Type::Float3, -1},
    {"NormalOS", "normalOS", Type::Float3, -1},
    {"NormalWS", "normalWS", Type::Float3, -1},
    {"Metallic", "metallic", Type::Float, 0},
    {"Specular", "specular", Type::Float3, -1},
    {"Smoothness", "smoothness", Type::Float, 0.5},
    {"Occlusion", "occlusion", Type::Float, 1},
    {"Emission", "emission", Type::Float3, 0},
    {"Alpha", "alpha", Type::Float, 1},
    {"AlphaClipThreshold", "alphaClip", Type::Float, 0.5},
    {"AmbientOcclusion", "occlusion", Type::Float, 1},
};
constexpr BlockRow kUnlit[] = {
    {"BaseColor", "color", Type::Float3, -1},
    {"SpriteColor", "color", Type::Float4, -1},
    {"FullscreenColor", "color", Type::Float3, -1},
    {"Alpha", "alpha", Type::Float, 1},
    {"AlphaClipThreshold", "alphaClip", Type::Float, 0.5},
};
constexpr BlockRow kVertex[] = {{"Position", "positionOS", Type::Float3, -1},
                                {"Normal", "normalOS", Type::Float3, -1},
                                {"Tangent", "tangentOS", Type::Float3, -1}};

const BlockRow* row_of(std::span<const BlockRow> rows, std::string_view block) {
    const auto found = std::ranges::find(rows, block, &BlockRow::block);
    return found == rows.end() ? nullptr : &*found;
}

// A constant vector keeps its size: the type of an output follows from it.
GraphValue output_value(const Term& term) {
    return term.is_constant() && width(term.type) > 1 ? "= " + term.text() : term.value();
}

}  // namespace

Term GraphMaker::block_value(const Block& block, Type type) {
    const Term made = input(block.node, block.slot);
    if (Term value = converted(made, type); value.type != Type::None) return value;
    approximate(block.node, fmt::format("it takes {} and has {}: it is a constant", word(type), word(made.type)));
    return stand_in(type);
}

// The remark of a block whose value was read.
void GraphMaker::say_block(std::string part, std::string text, Place place) {
    const std::string wrong = take_misreads();
    remark(wrong.empty() ? Remark::Kind::Taken : Remark::Kind::Changed, std::move(part),
           wrong.empty() ? text : text + ": " + wrong, place);
}

// The remark of a block whose value nothing reads. `is_there`: the target has it with its settings.
void GraphMaker::say_unread(const Block& block, const std::string& part, bool is_there, std::string_view lost) {
    if (!is_there) {
        remark(Remark::Kind::Taken, part,
               block.name == "Alpha" ? "an opaque surface does not read it"
                                     : "the target has no such block with these settings",
               block.place);
        return;
    }
    const Slot* slot = node(block.node).slot(block.slot);
    const bool is_default = !is_linked(block.node, block.slot) && slot && has_default(*slot, block.name);
    const std::string wrong = take_misreads();
    if (is_default && wrong.empty())
        remark(Remark::Kind::Taken, part, "it has its default", block.place);
    else
        remark(Remark::Kind::Changed, part, std::string(lost) + (wrong.empty() ? "" : ": ") + wrong, block.place);
}

void GraphMaker::add_pinned(std::string id, const Block& block) {
    const Term term = input(block.node, block.slot);
    written(term, fmt::format("the node '{}'", id));
    file_.types[id] = term.type;
    file_.add({.id = std::move(id), .expression = term.text(), .more = {{"stage", "vertex"}}}, {block.node});
}

// Multiplies the color of the surface by alpha, or fades it to white where alpha is low.
void GraphMaker::weigh(const Term& color, const Term& alpha, bool is_faded) {
    const Term made = terms::computed(is_faded ? "lerp(float3(1), a, b)" : "a * b", {color, alpha}, Type::Float3);
    for (GraphMember& each : file_.surface)
        if (each.key == "color" || each.key == "baseColor") each.value = made.value();
}

void GraphMaker::make_surface() {
    const Settings settings = read_settings(graph_);
    for (const SettingRemark& each : settings.remarks) remark(each.kind, each.part, each.text, each.place);
    file_.workflow = settings.workflow();
    file_.lighting = settings.lighting;
    std::set<std::pair<bool, std::string_view>> inputs;  // of the vertex block or the surface, that have a value
    const auto is_second = [&](const BlockRow& row, const std::string& part, const Block& block) {
        const bool is_new = inputs.emplace(block.is_vertex, row.input).second;
        if (!is_new)
            remark(Remark::Kind::Changed, part, "a second block for the same input: the first one counts", block.place);
        return !is_new;
    };
    Term alpha, color, clip = number_term(0.5);
    // Such a surface reads no alpha of its own, unless it is clipped; but a material may make another kind of it.
    const bool is_in_color =
        (settings.is_weighted || settings.is_faded) && !settings.is_overridable && !settings.is_clipped_blend;
    const std::string_view alpha_input = is_in_color ? "the colour, which it weights" : "'surface.alpha'";
    for (const Block& block : graph_.blocks) {
        const std::string part = fmt::format("block '{}'", block.name);
        const bool is_set = is_linked(block.node, block.slot);
        if (const std::size_t hash = block.name.find('#'); block.is_vertex && hash != block.name.npos) {
            const std::string& id = interpolator(std::string_view(block.name).substr(0, hash));
            if (file_.owners.contains(id)) {
                remark(Remark::Kind::Changed, part, "a second block of this name: the first one counts", block.place);
                continue;
            }
            add_pinned(id, block);
            say_block(part, fmt::format("the node '{}', computed for each vertex", id), block.place);
            continue;
        }
        if (block.is_vertex) {
            const BlockRow* row = row_of(kVertex, block.name);
            if (!row) {
                say_unread(block, part, settings.loses(block.name), "the vertex block of a graph has no such value");
            } else if (!is_set) {
                remark(Remark::Kind::Taken, part, "the mesh's own", block.place);
            } else if (!is_second(*row, part, block)) {
                const Term term = block_value(block, row->type);
                written(term, fmt::format("'vertex.{}'", row->input));
                file_.types["vertex." + std::string(row->input)] = term.type;
                file_.vertex.push_back({std::string(row->input), term.value()});
                say_block(part, fmt::format("'vertex.{}'", row->input), block.place);
            }
            continue;
        }
        const BlockRow* row = row_of(settings.is_lit ? std::span<const BlockRow>(kLit) : kUnlit, block.name);
        const bool is_active = row && settings.uses(block.name);
        if (!is_active) {
            say_unread(block, part, settings.loses(block.name), "the workflow has no such input");
            continue;
        }
        if (is_second(*row, part, block)) continue;
        std::string key(row->input);
        if (settings.is_specular && key == "smoothness") key = "glossiness";
        if (!node(block.node).slot(block.slot)) {
            remark(Remark::Kind::LeftOut, part, "the file does not have its slot", block.place);
            file_.surface.push_back({key, stand_in(row->type == Type::Float4 ? Type::Float3 : row->type).value()});
            continue;
        }
        Term term = block_value(block, row->type);
        if (block.name == "SpriteColor") {  // a colour with its alpha
            alpha = swizzled(term, "w");
            alpha.owner = term.owner;
            term = swizzled(named(term), "xyz");
        }
        const std::string where = key == "alpha" ? std::string(alpha_input) : fmt::format("'surface.{}'", key);
        written(term, where);
        say_block(part, where, block.place);
        if (key == "alpha") {
            alpha = term;
            continue;
        }
        if (key == "alphaClip") {
            clip = term;
        }
        if (key.starts_with("normal") && !is_set) continue;
        const bool is_stated = key == "alphaClip" && settings.is_clipped_blend;  // else nothing is clipped
        if (!is_set && term.is_constant() && row->otherwise >= 0 && !is_stated &&
            std::ranges::all_of(term.numbers, [&](double each) { return each == row->otherwise; }))
            continue;
        if ((key == "color" || key == "baseColor") && settings.is_tinted) {
            // The engine multiplies a sprite by the colour of its vertices.
            term = term.with(terms::computed("a * @vertexColor.rgb", {term}, Type::Float3).tree, term.type);
        }
        if (key == "color" || key == "baseColor") color = term;
        file_.surface.push_back({key, term.value()});
    }
    if (settings.is_tinted) {
        Term tint = link("@vertexColor.a", Type::Float);
        const bool is_one = alpha.type == Type::None || (alpha.is_constant() && alpha.numbers[0] == 1);
        if (!is_one) tint = terms::computed("a * @vertexColor.a", {alpha}, Type::Float);
        tint.nodes = alpha.nodes;
        alpha = tint;
    }
    if (alpha.type != Type::None && settings.is_clipped_blend && settings.is_overridable) {
        // A material may turn off the clipping of the graph: blended pixels below the threshold are not seen.
        const Term whole = alpha.owner ? named(alpha) : alpha;
        Term kept = terms::computed("a < b ? 0 : a", {whole, clip}, Type::Float);
        kept.nodes = alpha.nodes;
        alpha = kept;
    }
    if (alpha.type != Type::None && !(alpha.is_constant() && alpha.numbers[0] == 1)) {
        const bool is_in_both = (settings.is_weighted || settings.is_faded) && !is_in_color;
        if (is_in_both && alpha.owner) alpha = named(alpha);
        if (settings.is_weighted || settings.is_faded) weigh(color, alpha, settings.is_faded);
        written(alpha, alpha_input);
        if (!is_in_color) file_.surface.push_back({"alpha", alpha.value()});
    }
    if (!settings.render.empty()) file_.more.push_back({"render", GraphValue::object(settings.render)});
}

void GraphMaker::make_outputs() {
    file_.kind = "subgraph";
    Names names;
    for (const Block& block : graph_.blocks) {
        const Slot* slot = node(block.node).slot(block.slot);
        const Type type = slot ? type_of(block.node, *slot) : Type::None;
        const std::string part = fmt::format("output '{}'", block.name);
        const std::string name = names.unique(camel_case(block.name), "out");
        ports_.outputs.push_back({.slot = block.slot, .name = name, .type = type});
        if (!is_value(type)) {
            const std::string value = is_texture(type) ? input(block.node, block.slot).text() : std::string();
            for (const SubgraphPorts::Input& each : ports_.inputs)
                if (value == "$" + each.name) ports_.outputs.back().passes = each.name;
            const bool is_passed = !ports_.outputs.back().passes.empty();
            remark(is_passed ? Remark::Kind::Taken : Remark::Kind::LeftOut, part,
                   is_passed ? fmt::format("the texture of the input '{}'", ports_.outputs.back().passes)
                             : fmt::format("an output of a sub-graph cannot be {}", word(type)),
                   block.place);
            continue;
        }
        const Term term = input(block.node, block.slot);
        written(term, fmt::format("the output '{}'", name));
        file_.types["outputs." + name] = term.type;
        file_.outputs.push_back({name, output_value(term)});
        say_block(part, fmt::format("the output '{}'", name), block.place);
    }
}

}  // namespace patina::importers::shadergraph
