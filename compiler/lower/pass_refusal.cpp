// Checks whether a pass can draw a material: a lighting graph may read values that the pass lacks. There is one check
// for all paths, over what the lowered functions read. It reports the graph node that reads the value.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "compiler/ir/linear/linear_part.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

using ir::FunctionId;
using ir::Inst;
using ir::Op;
using ir::SemanticId;

// What is known about a function on the way to it from the pass.
struct VisitedPlace {
    std::string_view slot{};      // the slot that it belongs to; empty: the pass's own function
    std::string_view semantic{};  // the semantic of the slot whose recipe this is
    bool at_vertex = false;
    ir::OriginId origin{};  // the innermost node
    Span span{};            // the innermost function of a pass or recipe
    bool is_given = false;  // the span is that of a function with [gives]
};

class Walk {
public:
    Walk(Lowering& lowering, const LoweredPass& pass)
        : lowering_(lowering), module_(lowering.out.module), pass_(pass), declaration_(*pass.declaration) {}

    Refusal run() {
        visit(pass_.vertex, {.at_vertex = true, .span = declaration_.vertex->name_span});
        visit(pass_.fragment, {.span = declaration_.fragment->name_span});
        return refusal_;
    }

private:
    void refuse(const VisitedPlace& place, std::string reason) {
        if (!refusal_)
            refusal_ = {.reason = std::move(reason),
                        .where = place.origin ? module_.origins[place.origin.index] : ir::Origin{}};
    }

    static ir::StageKind stage_of(const VisitedPlace& place) {
        return place.at_vertex ? ir::StageKind::Vertex : ir::StageKind::Fragment;
    }

    // A function that replaces another one may call the one that it replaces.
    void visit(FunctionId function, const VisitedPlace& place) {
        const bool is_usual = std::find(replacing_.begin(), replacing_.end(), function) != replacing_.end();
        const auto* other = is_usual ? nullptr : pass_.replacement_of(function, stage_of(place));
        if (!other) return look_into(function, place);
        replacing_.push_back(function);
        look_into(other->by, place);
        replacing_.pop_back();
    }

    void look_into(FunctionId function, VisitedPlace place) {
        if (const std::string_view slot = lowering_.slot_name(function); !slot.empty()) {
            place.slot = slot;
            if (!lowering_.is_packing(slot)) check_members(function, place);
        }
        if (!seen_.emplace(function.index, !place.slot.empty(), place.at_vertex).second) return;
        // References into the module are safe here, because visiting does not change it.
        for (const Inst& inst : module_[function].insts) {
            if (refusal_) return;
            VisitedPlace here = place;
            if (inst.origin && (!here.origin || !module_.origins[inst.origin.index].id.empty()))
                here.origin = inst.origin;
            if (inst.op == Op::Call) visit({inst.data}, here);
            if (inst.op == Op::Semantic) semantic({inst.data}, here);
            if (inst.op == Op::Global) global({inst.data}, here);
            if (ir::has(inst.op, ir::Derivative) && is_graph(here)) derivative(inst.op, here);
        }
    }

    // Who reads the value, in words: a slot that a graph gives. A slot without parameters is the surface itself.
    std::string said(const VisitedPlace& place) const {
        const paths::SlotDecl* slot = lowering_.session.paths->slot(place.slot);
        while (slot && slot->is_derived() && !slot->of.empty()) slot = lowering_.session.paths->slot(slot->of);
        if (slot && slot->function->params.empty()) return "the surface";
        return fmt::format("'{}'", slot ? slot->name() : place.slot);
    }

    void derivative(Op op, const VisitedPlace& place) {
        if (place.at_vertex) {
            if (op == Op::Sample) return;  // in the vertex stage it reads level 0
            refuse(place, fmt::format("{} uses derivatives, which the vertex stage does not have", said(place)));
        } else if (!draws_objects()) {
            refuse(place, fmt::format("{} uses derivatives, and neighbouring pixels may belong to other objects here",
                                      said(place)));
        }
    }

    bool draws_objects() const { return declaration_.state.draws == PassDraws::Objects; }
    bool is_graph(const VisitedPlace& place) const { return !place.slot.empty(); }

    void semantic(SemanticId id, const VisitedPlace& place) {
        if (given(id, place)) return;
        const SemanticRecipe& recipe = lowering_.out.semantics[id.index];
        VisitedPlace inside = place;
        // An interpolator of the graph is no name that a reader knows: what it reads is.
        if (place.semantic.empty() && is_graph(place) && recipe.declaration)
            inside.semantic = module_.semantics[id.index].name;
        const std::string_view name = inside.semantic.empty() ? module_.semantics[id.index].name : inside.semantic;
        const nodelang::VariableDecl* variable = recipe.declaration ? recipe.declaration->variable : nullptr;
        if (is_lacking(module_.semantics[id.index].name, variable, fmt::format("@{}", name), place)) return;
        const ir::Builtin builtin = recipe.declaration ? recipe.declaration->builtin : ir::Builtin::None;
        const bool is_interpolated = recipe.source == paths::SemanticSource::Vertex ||
                                     recipe.source == paths::SemanticSource::Attribute ||
                                     builtin == ir::Builtin::InstanceIndex;  // which the vertex stage passes on
        if (is_interpolated && is_graph(place) && !draws_objects())
            return refuse(place, fmt::format("{} reads '@{}', which the pass cannot provide", said(place), name));
        if (builtin == ir::Builtin::FragCoord && is_graph(place) && place.at_vertex)
            return refuse(place, fmt::format("{} reads '@{}', which vertices do not have", said(place), name));
        if (recipe.source == paths::SemanticSource::Builtin && !is_graph(place))
            check_builtin(*recipe.declaration, place);
        if (!recipe.recipe) return;
        if (recipe.declaration && !place.is_given) inside.span = recipe.declaration->function->name_span;
        inside.at_vertex = place.at_vertex || recipe.source == paths::SemanticSource::Vertex;
        visit(recipe.recipe, inside);
    }

    // Visits the pass's own recipe; false if it has none here. Such a recipe may read the usual value.
    bool given(SemanticId id, const VisitedPlace& place) {
        if (std::find(giving_.begin(), giving_.end(), id) != giving_.end()) return false;
        const auto* recipe = pass_.recipe_of(id, stage_of(place));
        const auto* at_vertices = pass_.recipe_of(id, ir::StageKind::Vertex);
        const bool is_interpolated = !recipe && at_vertices && !at_vertices->in_fragment_stage;
        if (is_interpolated) recipe = at_vertices;
        if (!recipe) return false;
        giving_.push_back(id);
        visit(recipe->by, {.at_vertex = place.at_vertex || is_interpolated, .span = recipe->span, .is_given = true});
        giving_.pop_back();
        return true;
    }

    // A pass file may read a value that its stage does not have.
    void check_builtin(const paths::SemanticDecl& semantic, const VisitedPlace& place) {
        const bool is_of_pixel = semantic.builtin == ir::Builtin::FragCoord;
        const bool is_of_vertex =
            semantic.builtin == ir::Builtin::VertexIndex || semantic.builtin == ir::Builtin::InstanceIndex;
        if (place.at_vertex ? !is_of_pixel : !is_of_vertex) return;
        DiagnosticRecord& record = lowering_.session.diagnostics.report(
            Code::NoSuchStageValue, place.span, semantic.name, place.at_vertex ? "vertex" : "fragment");
        if (place.is_given && place.at_vertex)
            record.note("put [fragment] on the function, so that the vertex stage keeps the usual value");
    }

    void global(ir::GlobalId id, const VisitedPlace& place) {
        const ir::Global& global = module_.globals[id.index];
        if (global.group == ir::Group::Engine || global.group == ir::Group::Targets) {
            const nodelang::VariableDecl* variable = lowering_.session.declarations->variable(global.name);
            if (is_lacking(global.name, variable, shown_name(global.name, place), place)) return;
        }
        if (draws_objects() || !is_graph(place) || !lowering_.per_object.contains(id.index)) return;
        refuse(place, fmt::format("{} reads '{}' of the object, which the pass cannot provide", said(place),
                                  module_.globals[id.index].name));
    }

    // As the graph says it.
    std::string shown_name(const std::string& global, const VisitedPlace& place) const {
        if (!place.semantic.empty()) return fmt::format("@{}", place.semantic);
        return lowering_.session.paths->semantic(global) ? "@" + global : global;
    }

    // Refuses the material if a graph reads this value and the pass does not have it. The pass lacks its name, its
    // block, or the target that it reads. `shown`: what the graph says.
    bool is_lacking(std::string_view name, const nodelang::VariableDecl* variable, std::string_view shown,
                    const VisitedPlace& place) {
        if (!is_graph(place)) return false;
        const paths::ExternDecl* value = lowering_.session.paths->extern_of(variable);
        const auto is_it = [&](std::string_view word) {
            return word == name || (value && !word.empty() && (word == value->block || word == value->reads));
        };
        for (const std::vector<std::string_view>& row : declaration_.lacks) {
            const auto is_on = [&](std::string_view word) { return lowering_.is_on(word); };
            if (std::none_of(row.begin(), row.end(), is_it) || std::any_of(row.begin(), row.end(), is_on)) continue;
            refuse(place, fmt::format("{} reads '{}', which the pass cannot provide", said(place), shown));
            for (const std::string_view word : row) {
                const paths::SwitchDecl* off = lowering_.session.paths->switch_named(word);
                if (off && refusal_.advice.empty()) refusal_.advice = off->otherwise;
            }
            return true;
        }
        return false;
    }

    // The lighting surface is a slot's first parameter.
    void check_members(FunctionId function, const VisitedPlace& place) {
        const ir::Function& slot = module_[function];
        if (declaration_.holds.empty() || slot.params.empty() || slot.params[0].type.kind != ir::Kind::Struct) return;
        const std::vector<ir::Member> members = module_.structs[slot.params[0].type.ref].members;
        for (const ir::MemberRead& read : ir::members_read(module_, function, 0)) {
            const std::string& name = members[read.member].name;
            if (holds(name)) continue;
            VisitedPlace at = place;
            if (read.origin) at.origin = read.origin;
            refuse(at, fmt::format("{} reads '@surface.{}', which the pass cannot provide", said(place), name));
            refusal_.advice = roomier_path();
            return;
        }
    }

    // A path that stores all members that a lighting graph reads.
    std::string roomier_path() const {
        for (const paths::PassDecl& each : lowering_.session.paths->passes) {
            const bool packs = std::any_of(each.holds.begin(), each.holds.end(),
                                           [&](std::string_view name) { return lowering_.is_packing(name); });
            if (packs && each.path != declaration_.path)
                return fmt::format("use --path {}, which has room for more members of the surface", each.path);
        }
        return {};
    }

    bool holds(std::string_view member) {
        if (held_.empty()) {
            for (const std::string_view name : declaration_.holds) {
                held_.emplace(name);
                for (const std::string_view packed : packed_members(lowering_, name)) held_.emplace(packed);
            }
        }
        return held_.contains(std::string(member));
    }

    Lowering& lowering_;
    const ir::Module& module_;
    const LoweredPass& pass_;
    const paths::PassDecl& declaration_;
    Refusal refusal_;
    std::set<std::tuple<std::uint32_t, bool, bool>> seen_;
    std::vector<SemanticId> giving_;
    std::vector<FunctionId> replacing_;
    std::set<std::string> held_;
};

}  // namespace

Refusal refusal_of(Lowering& lowering, const LoweredPass& pass) {
    return Walk(lowering, pass).run();
}

}  // namespace patina::lower
