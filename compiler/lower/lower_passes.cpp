// Lowers the passes of the requested path: their two functions, their own recipes of semantics, and the engine
// functions that they replace. If the path cannot draw the material, its fallback is lowered.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/format/words.h"
#include "compiler/ir/linear/linear_part.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

using ir::Op;
using nodelang::FunctionDecl;
using nodelang::VariableDecl;

class Passes {
public:
    explicit Passes(Lowering& lowering)
        : lowering_(lowering), paths_(*lowering.session.paths), environment_(lowering) {}

    void run() {
        emit::Emitter& emitter = lowering_.emitter;
        emitter.known.make_slot = [this](const FunctionDecl& slot, Span at) { return slot_of(slot, at); };
        // Statics of the surface are known already, unless materials choose its kind (lower.cpp).
        emitter.known.make_static = [this, of_surface = emitter.known.make_static](const VariableDecl& variable,
                                                                                   ir::Builder* builder) {
            const std::optional<double> known = static_value(variable);
            return known || !of_surface ? emit::StaticValue{.constant = known} : of_surface(variable, builder);
        };
        const std::vector<std::string>& wanted = lowering_.session.request.passes;
        if (lowering_.material.pass) return lower_extra();
        if (wanted.empty() && lowering_.session.request.path == resolve::kAllPaths) {
            lower_all();
        } else if (wanted.empty()) {
            lower_path(lowering_.session.path);
        } else {
            lowering_.out.path = lowering_.session.path;
            for (const std::string& name : wanted)
                if (!is_extra(name)) named_pass(name);
        }
    }

private:
    // --- selection of passes

    bool is_extra(std::string_view name) const {
        const std::vector<format::ExtraPass>& passes = lowering_.material.graph->graph->passes;
        return std::any_of(passes.begin(), passes.end(),
                           [&](const format::ExtraPass& pass) { return pass.name == name; });
    }

    void lower_extra() {
        Lowered& out = lowering_.out;
        out.path = lowering_.session.path;
        const paths::PassDecl* pass = paths_.pass_for_extra(out.path);
        const std::string& name = lowering_.material.pass->name;
        if (const Refusal refusal = pass ? lower_pass(*pass) : Refusal{"no pass has [extra]"})
            report(Code::PassRefused, refusal, name, refusal.reason);
        for (LoweredPass& made : out.passes) made.name = name;
    }

    void named_pass(const std::string& name) {
        const paths::PassDecl* pass = paths_.pass(name);
        if (!pass) {
            std::vector<std::string_view> known;
            for (const paths::PassDecl& each : paths_.passes) known.push_back(each.name);
            lowering_.session.diagnostics.report(Code::UnknownPass, {}, name)
                .note(Diagnostics::suggestion(name, known));
        } else if (const Refusal refusal = lower_pass(*pass)) {
            report(Code::PassRefused, refusal, pass->name, refusal.reason);
        }
    }

    // Every pass that can draw the material.
    void lower_all() {
        lowering_.out.path = resolve::kAllPaths;
        for (const std::string_view path : paths_.names()) {
            begin_path();
            for (const paths::PassDecl* pass : optional_first(paths_.passes_of(path))) {
                const Refusal refusal = lower_pass(*pass);
                if (!refusal || refusal.is_vain || pass->is_optional || pass->state.fallback.empty()) continue;
                lowering_.out.passes.resize(first_of_path_);  // the path cannot draw the material
                break;
            }
        }
        in_order_of([&](const LoweredPass& pass) { return pass.declaration - paths_.passes.data(); });
    }

    // A pass may ask which other passes are drawn with it. So the optional passes are lowered first.
    void begin_path() { first_of_path_ = lowering_.out.passes.size(); }
    static std::vector<const paths::PassDecl*> optional_first(std::vector<const paths::PassDecl*> passes) {
        std::stable_partition(passes.begin(), passes.end(),
                              [](const paths::PassDecl* pass) { return pass->is_optional; });
        return passes;
    }
    template <class Place>
    void in_order_of(const Place& place) {
        std::sort(lowering_.out.passes.begin(), lowering_.out.passes.end(),
                  [&](const LoweredPass& a, const LoweredPass& b) { return place(a) < place(b); });
    }

    void lower_path(const std::string& path) {
        Lowered& out = lowering_.out;
        out.passes.clear();
        out.path = path;
        begin_path();
        std::vector<const paths::PassDecl*> passes;
        for (const paths::SwitchDecl& each : paths_.switches) {
            const paths::PassDecl* brought = each.brings.empty() ? nullptr : paths_.pass(each.brings);
            const bool is_there = std::find(passes.begin(), passes.end(), brought) != passes.end();
            if (brought && !is_there && lowering_.is_on(each.variable->name) && brought->path != path)
                passes.push_back(brought);
        }
        const std::size_t own = passes.size();
        for (const paths::PassDecl* pass : paths_.passes_of(path)) passes.push_back(pass);
        std::vector<std::pair<const paths::PassDecl*, Refusal>>
            left_out;                // reported only if the path draws the material
        std::set<std::string> told;  // one error may stop several passes
        for (const paths::PassDecl* pass : optional_first(passes)) {
            const Refusal refusal = lower_pass(*pass);
            if (refusal.is_news) left_out.emplace_back(pass, refusal);
            if (!refusal || refusal.is_news || refusal.is_vain || pass->is_optional) continue;
            const bool is_own = std::find(passes.begin() + std::ptrdiff_t(own), passes.end(), pass) != passes.end();
            if (is_own && !pass->state.fallback.empty()) {
                // If a path leaves a kind of surface to its fallback by design, there is no warning.
                if (has_blend(*pass)) report(Code::PathRefused, refusal, path, refusal.reason, pass->state.fallback);
                tried_.insert(path);
                if (!tried_.contains(pass->state.fallback)) return lower_path(pass->state.fallback);
            }
            if (!has_blend(*pass)) {
                if (is_own) left_out.emplace_back(pass, refusal);
            } else if (told.insert(refusal.reason).second) {
                report(Code::PassRefused, refusal, known_as(*pass), refusal.reason);
            }
        }
        for (const auto& [pass, refusal] : left_out) report_left_out(*pass, refusal);
        in_order_of([&](const LoweredPass& p) { return std::find(passes.begin(), passes.end(), p.declaration); });
    }

    void report_left_out(const paths::PassDecl& pass, Refusal refusal) {
        if (lowering_.session.diagnostics.has_errors()) return;
        if (refusal.advice.empty()) refusal.advice = pass.otherwise;
        report(Code::PassLeftOut, refusal, known_as(pass), refusal.reason);
    }

    template <class... Words>
    void report(Code code, const Refusal& refusal, const Words&... words) {
        const Span whole = lowering_.material.graph->graph->span;
        const bool is_graph = refusal.where.span.begin != refusal.where.span.end;
        DiagnosticRecord& record = lowering_.session.diagnostics.report(
            code, is_graph ? refusal.where.span : Span{whole.begin, whole.begin + 1}, words...);
        record.at(refusal.where.id);
        if (!refusal.advice.empty()) record.note(refusal.advice);
    }

    static std::string quoted(std::string_view name) {
        return name.empty() ? "a lighting graph of its own" : fmt::format("'{}'", name);
    }
    static std::string list_of(const std::vector<std::string_view>& names) {
        std::string list;
        for (std::size_t i = 0; i < names.size(); ++i)
            list += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + quoted(names[i]);
        return list;
    }

    // --- one pass

    // Every pass draws opaque surfaces: a material that chooses its kind has all passes.
    SurfaceKind surface() const {
        const format::RenderState& render = lowering_.material.graph->graph->render;
        return render.is_overridable ? SurfaceKind::Opaque : render.surface;
    }

    static bool draws_objects(const paths::PassDecl& pass) { return pass.state.draws == PassDraws::Objects; }

    bool has_blend(const paths::PassDecl& pass) const {
        return !draws_objects(pass) || blend_of(pass, surface()) || pass.blends.empty();
    }

    // The engine may read the depth or the lit colour that a pass leaves, so the pass must hold the nearest surface.
    Refusal refusal_of_depth(const paths::PassDecl& pass) const {
        const format::RenderState& render = lowering_.material.graph->graph->render;
        if (!has_own_passes() || !(pass.is_alone || pass.state.targets.empty()) || render.is_overridable) return {};
        const ir::Origin where{.span = {render.span.begin, render.span.begin + 1}};
        if (!render.depth_write.value_or(true))
            return {.reason = "it writes depth, and the material does not", .where = where, .is_news = true};
        const Compare test = render.depth_test.value_or(Compare::LessEqual);
        if (test == Compare::Less || test == Compare::LessEqual || test == Compare::Equal) return {};
        return {.reason =
                    fmt::format("it keeps the nearest surface, and the material's depth test is '{}'", to_string(test)),
                .where = where,
                .is_news = true};
    }

    // Unlit materials look the same without this pass.
    Refusal refusal_of_lighting(const paths::PassDecl& pass) const {
        const format::Graph& graph = *lowering_.material.graph->graph;
        const format::LightingUse& use = graph.lighting;
        const Span inlined{use.span.begin, use.span.begin + 1};
        const std::vector<std::string>& paths = lowering_.session.engine.paths;
        const bool is_of_other = !pass.is_optional && !pass.along.empty() && pass.along.front() != paths.front();
        return {.reason =
                    fmt::format("it is for materials lit by {}, and this material is lit by {}", list_of(pass.lighting),
                                quoted(use.inlined ? std::string_view() : lowering_.material.lighting_name)),
                .where = {.span = !use.present  ? graph.workflow_span
                                  : use.inlined ? inlined
                                                : use.span},
                .advice = is_of_other ? fmt::format("use --path {}", paths.front()) : std::string(),
                .is_news = pass.is_optional && is_drawn_again(pass)};
    }

    // True if another pass of the path draws the object again, once for each light.
    bool is_drawn_again(const paths::PassDecl& pass) const {
        if (lowering_.material.pass) return false;
        const std::vector<const paths::PassDecl*> others = paths_.passes_of(pass.path);
        return std::any_of(others.begin(), others.end(), [&](const paths::PassDecl* other) {
            return draws_objects(*other) && other->state.each == PassEach::Light &&
                   other->state.lights != PassLights::Shadowed && has_blend(*other) && !vain_part(*other);
        });
    }

    // If a material states a stencil, the pass must not use the stencil itself, and only one pass may draw the object.
    Refusal refusal_of_stencil(const paths::PassDecl& pass) const {
        const std::optional<format::StencilState>& stencil = lowering_.material.graph->graph->render.stencil;
        if (!stencil || !draws_objects(pass) || pass.state.targets.empty()) return {};
        const ir::Origin where{.span = {stencil->span.begin, stencil->span.begin + 1}};
        if (pass.has_stencil)
            return {.reason = "the material has a stencil, and the pass sets the stencil itself",
                    .where = where,
                    .is_news = has_own_passes()};
        if (has_own_passes() && pass.state.each != PassEach::Light) return {};  // the other pass reports it
        if (!stencil->changes() || stencil->test == Compare::Always || !is_drawn_again(pass)) return {};
        Refusal refusal{
            .reason = "the path draws an object once for each light, and the stencil changes the value that it tests",
            .where = where};
        if (has_own_passes())
            refusal.advice =
                "set \"test\" to \"always\", or \"pass\", \"fail\" and \"depthFail\" to \"keep\", or use the workflow "
                "\"unlit\"";
        return refusal;
    }

    // True if the engine draws passes of its own, which it selects by tag; then no frame of ours decides.
    bool has_own_passes() const { return lowering_.session.engine.has_own_passes(); }

    // True if the pass leaves the picture as it is where its light is 0.
    static bool only_adds(const paths::PassDecl& pass) {
        return pass.state.each == PassEach::Light ||
               (!pass.blends.empty() &&
                std::all_of(pass.blends.begin(), pass.blends.end(),
                            [](const paths::BlendRow& row) { return row.blend.destination == BlendFactor::One; }));
    }

    // A slot that is always 0, although the pass needs it. Only for passes that add light, or that a material can do
    // without.
    std::optional<std::string_view> vain_part(const paths::PassDecl& pass) const {
        if (!only_adds(pass) && !pass.is_optional) return {};
        for (const std::string_view name : pass.needs) {
            const paths::SlotDecl* slot = paths_.slot(name);
            if (!slot) continue;
            const DerivedSlot* part = slot->is_derived() ? &derived_slot(lowering_, *slot) : nullptr;
            if (part ? part->slot.function && part->is_zero : is_always_zero(name)) return name;
        }
        return {};
    }

    Refusal lower_pass(const paths::PassDecl& pass) {
        if (!pass.vertex || !pass.fragment) return {};  // reported when its file was read
        if (!has_blend(pass))
            return {.reason = fmt::format("it does not draw '{}' surfaces", to_string(surface())),
                    .is_vain = vain_part(pass).has_value()};
        if (const Refusal refusal = refusal_of_stencil(pass)) return refusal;
        if (const Refusal refusal = refusal_of_depth(pass)) return refusal;
        const std::string_view model = lowering_.material.lighting_name;
        const auto& models = pass.lighting;
        if (!models.empty() && std::find(models.begin(), models.end(), model) == models.end())
            return refusal_of_lighting(pass);
        const std::vector<format::ExtraPass>& added = lowering_.material.graph->graph->passes;
        if (pass.is_alone && !added.empty())
            return {.reason = fmt::format("where it is drawn, '{}' is not drawn", added.front().name),
                    .where = {.span = added.front().name_span},
                    .is_news = true};
        for (const std::string_view name : pass.needs) {
            const paths::SlotDecl* slot = paths_.slot(name);
            if (!slot) return {.reason = fmt::format("it needs '{}', which nothing provides", name)};
            const DerivedSlot* part = slot->is_derived() ? &derived_slot(lowering_, *slot) : nullptr;
            if (part && !part->slot.function) return {.reason = part->why_not, .where = part->where};
        }
        if (const auto vain = vain_part(pass))
            return {.reason = fmt::format("'{}' is always 0", *vain), .is_vain = true};
        for (const std::string_view name : pass.excludes) {
            if (lowering_.is_on(name)) return {.reason = fmt::format("it does not support '{}'", name)};
        }
        const nodelang::Declarations& declarations = *lowering_.session.declarations;
        emit::Emitter& emitter = lowering_.emitter;
        LoweredPass made{.declaration = &pass, .name = std::string(pass.name)};
        pass_ = pass.name;
        emitter.instances.forget_passing();
        made.vertex = emit::semantic_function(emitter, *pass.vertex, declarations, environment_, true);
        made.fragment = emit::semantic_function(emitter, *pass.fragment, declarations, environment_, false);
        if (!made.vertex || !made.fragment) return {};
        lower_recipes();
        lower_given_recipes(made);
        lower_recipes();
        while (lower_given_functions(made)) lower_recipes();
        if (lowering_.session.diagnostics.has_errors()) return {};
        if (may_be_refused(pass)) {
            if (Refusal refusal = refusal_of(lowering_, made)) return refusal;
        }
        lowering_.out.passes.push_back(std::move(made));
        return {};
    }

    bool is_always_zero(std::string_view slot) const {
        const emit::Slot* found = emit::find_slot(lowering_.emitter.known, slot);
        if (!found || !found->function) return false;
        const ir::Module& module = lowering_.out.module;
        const ir::Function& function = module[found->function];
        const ir::Value result = function.args(function.blocks[0].insts.back())[0];
        return is_zero(module, function, result);
    }

    // Without folding, a vector is made of constants.
    static bool is_zero(const ir::Module& module, const ir::Function& function, ir::Value value) {
        const ir::Inst& inst = function[value];
        if (inst.op == Op::Construct) {
            const auto parts = function.args(inst);
            return std::all_of(parts.begin(), parts.end(),
                               [&](ir::Value part) { return is_zero(module, function, part); });
        }
        if (inst.op != Op::Constant) return false;
        const auto numbers = module.numbers_of(module.constants[inst.data]);
        return std::all_of(numbers.begin(), numbers.end(), [](double number) { return number == 0; });
    }

    // A pass of the library that draws objects has every value in the fragment stage. For the vertex stage, and for a
    // pass that draws no object or lacks values, this must be checked.
    bool may_be_refused(const paths::PassDecl& pass) const {
        return !draws_objects(pass) || !pass.holds.empty() || !pass.lacks.empty() || reads_of_pass_ ||
               lowering_.session.pass_file;
    }

    void lower_given_recipes(LoweredPass& pass) {
        for (const paths::GivenDecl& given : paths_.given) {
            if (!given.is_for(*pass.declaration)) continue;
            if (given.variable) {
                give_attribute(pass, given);
            } else if (const auto found = paths_.semantic_index.find(given.what);
                       found != paths_.semantic_index.end()) {
                give_recipe(pass, given, {found->second});
            }
        }
    }

    void give_recipe(LoweredPass& pass, const paths::GivenDecl& given, ir::SemanticId semantic) {
        const paths::SemanticSource source = paths_.semantics[semantic.index].source;
        const bool is_interpolated =
            source == paths::SemanticSource::Vertex || source == paths::SemanticSource::Attribute;
        const bool is_at_vertices = is_interpolated && !given.is_of_fragment;
        const ir::FunctionId made = emit::semantic_function(
            lowering_.emitter, *given.function, *lowering_.session.declarations, environment_, is_at_vertices);
        if (made)
            pass.recipes.push_back({.what = semantic,
                                    .by = made,
                                    .in_vertex_stage = !given.is_of_fragment,
                                    .in_fragment_stage = !is_at_vertices,
                                    .span = given.function->name_span});
    }

    // Replaces every instance of the functions that exists so far; false if there is no new one. What replaces a
    // function may call another one that is replaced, too.
    bool lower_given_functions(LoweredPass& pass) {
        const nodelang::Declarations& declarations = *lowering_.session.declarations;
        bool is_new = false;
        for (const paths::GivenDecl& given : paths_.given) {
            if (!given.is_for(*pass.declaration) || given.variable || paths_.semantic_index.contains(given.what))
                continue;
            const FunctionDecl* replaced = declarations.function(given.what);
            if (!replaced) continue;  // reported when its file was read
            for (const emit::InstanceInfo& instance : lowering_.emitter.instances.of(*replaced))
                is_new = give_function(pass, given, instance) || is_new;
        }
        return is_new && !lowering_.session.diagnostics.has_errors();
    }

    bool give_function(LoweredPass& pass, const paths::GivenDecl& given, const emit::InstanceInfo& instance) {
        if (std::any_of(pass.replaced.begin(), pass.replaced.end(),
                        [&](const Given<ir::FunctionId>& known) { return known.what == instance.id; }))
            return false;
        const ir::FunctionId made = emit::given_function(lowering_.emitter, *given.function,
                                                         *lowering_.session.declarations, environment_, instance.half);
        if (!made) return false;
        if (!is_alike(instance.id, made)) {
            lowering_.session.diagnostics.report(Code::BadAttribute, given.function->name_span, "gives",
                                                 fmt::format("replaces '{}' and must have its parameters and result; "
                                                             "further parameters need a semantic as their default",
                                                             given.what));
            return false;
        }
        pass.replaced.push_back({.what = instance.id,
                                 .by = made,
                                 .in_vertex_stage = !given.is_of_fragment,
                                 .span = given.function->name_span});
        return true;
    }

    bool is_alike(ir::FunctionId old, ir::FunctionId made) const {
        const ir::Module& module = lowering_.out.module;
        const ir::Function &before = module[old], &now = module[made];
        return before.result == now.result &&
               std::equal(before.params.begin(), before.params.end(), now.params.begin(), now.params.end(),
                          [](const ir::Param& a, const ir::Param& b) { return a.type == b.type; });
    }

    // declare() has declared a value of the engine for this one (declare.cpp).
    void give_attribute(LoweredPass& pass, const paths::GivenDecl& given) {
        const auto semantic = paths_.semantic_index.find(given.what);
        const auto global = emit::find_extern(lowering_.emitter.known, *given.variable);
        if (semantic == paths_.semantic_index.end() || !global) return;
        if (paths_.semantics[semantic->second].source != paths::SemanticSource::Attribute) return;
        pass.attributes.push_back({{semantic->second}, *global});
        lowering_.out.module.globals[global->index].from_bottom =
            lowering_.out.module.semantics[semantic->second].from_bottom;
    }

    // Lowers the recipes of every semantic that a function reads, and of those that the recipes read.
    void lower_recipes() {
        Lowered& out = lowering_.out;
        for (; next_ < out.module.functions.size(); ++next_) {
            for (std::size_t i = 0; i < out.module.functions[next_].insts.size(); ++i) {
                const ir::Inst inst = out.module.functions[next_].insts[i];
                if (inst.op != Op::Semantic) continue;
                SemanticRecipe& recipe = out.semantics[inst.data];
                if (!recipe.declaration || !recipe.declaration->function || recipe.recipe) continue;
                reads_of_pass_ = reads_of_pass_ || recipe.declaration->is_of_pass;
                const unsigned answers = lowering_.emitter.instances.passing_answers();
                const ir::FunctionId made = emit::semantic_function(lowering_.emitter, *recipe.declaration->function,
                                                                    *lowering_.session.declarations, environment_,
                                                                    recipe.source == paths::SemanticSource::Vertex);
                if (!made) return;  // an error in the library or the user's file, which has been reported
                if (lowering_.emitter.instances.passing_answers() != answers)
                    refuse_answers(*recipe.declaration->function);
                out.semantics[inst.data].recipe = made;
            }
        }
    }

    // A recipe cannot depend on the pass, because all passes share it.
    void refuse_answers(const FunctionDecl& recipe) {
        lowering_.session.diagnostics.report(
            Code::BadAttribute, recipe.name_span, "semantic",
            "is on a function that asks a [static] which passes exist: the answer differs between paths");
    }

    // --- slots and [static] values that pass functions ask for

    const emit::Slot* slot_of(const FunctionDecl& slot, Span at) {
        const paths::SlotDecl* declared = paths_.slot(slot.name);
        if (!declared || !declared->is_derived()) return nullptr;
        const DerivedSlot& part = derived_slot(lowering_, *declared);
        if (part.slot.function) return &part.slot;
        lowering_.session.diagnostics
            .report(Code::PassRefused, at, pass_, fmt::format("it calls '{}': {}", slot.name, part.why_not))
            .note(fmt::format(
                "put [needs(\"{0}\")] on the pass, or ask whether the material has it with static(\"slot\", \"{0}\")",
                slot.name));
        return nullptr;
    }

    std::optional<double> static_value(const VariableDecl& variable) {
        const auto asked = std::find_if(paths_.statics.begin(), paths_.statics.end(),
                                        [&](const paths::StaticDecl& each) { return each.variable == &variable; });
        if (asked == paths_.statics.end() || !asked->is_of_passes()) return {};
        bool is_any = false;
        for (const std::string_view name : asked->words) is_any = holds(asked->about, name) || is_any;
        return is_any;
    }

    bool holds(paths::StaticDecl::About about, std::string_view name) {
        if (about == paths::StaticDecl::About::Pass) return is_drawn_with(name);
        return about == paths::StaticDecl::About::Slot ? has_slot(name) : lighting_reads(name);
    }

    // True if the lighting graph reads this member of the surface.
    bool lighting_reads(std::string_view member) const {
        const ir::Module& module = lowering_.out.module;
        return std::any_of(paths_.slots.begin(), paths_.slots.end(), [&](const paths::SlotDecl& slot) {
            const emit::Slot* made =
                slot.is_derived() ? nullptr : emit::find_slot(lowering_.emitter.known, slot.name());
            if (!made || !made->function) return false;
            const std::vector<ir::Param>& params = module[made->function].params;
            if (params.empty() || params[0].type.kind != ir::Kind::Struct) return false;
            const std::vector<ir::Member>& members = module.structs[params[0].type.ref].members;
            const std::vector<ir::MemberRead> reads = ir::members_read(module, made->function, 0);
            return std::any_of(reads.begin(), reads.end(),
                               [&](const ir::MemberRead& read) { return members[read.member].name == member; });
        });
    }

    bool is_drawn_with(std::string_view pass) {
        lowering_.emitter.instances.note_passing_answer();
        const auto& passes = lowering_.out.passes;
        return std::any_of(passes.begin() + std::ptrdiff_t(first_of_path_), passes.end(),
                           [&](const LoweredPass& p) { return p.declaration->name == pass; });
    }

    bool has_slot(std::string_view name) {
        const paths::SlotDecl* slot = paths_.slot(name);
        if (!slot) return false;
        if (!slot->is_derived()) return emit::find_slot(lowering_.emitter.known, name) && !is_always_zero(name);
        const DerivedSlot& part = derived_slot(lowering_, *slot);
        remark(*slot, part);
        return part.slot.function && !part.is_zero;
    }

    // Reports once what the material loses without the derived slot.
    void remark(const paths::SlotDecl& slot, const DerivedSlot& part) {
        if (part.slot.function || part.is_of_missing || slot.otherwise.empty()) return;
        if (!remarked_.insert(slot.name()).second) return;
        const paths::PassDecl* pass = paths_.pass(pass_);
        const std::string_view instead = pass ? pass->state.fallback : std::string_view();
        report(Code::PathLoses,
               {.reason = {},
                .where = part.where,
                .advice = instead.empty() ? "" : fmt::format("use the path '{}'", instead)},
               has_own_passes() ? lowering_.session.engine.own_path(lowering_.session.request.path)
                                : std::string_view(lowering_.out.path),
               slot.otherwise, part.why_not);
    }

    Lowering& lowering_;
    const paths::PathDeclarations& paths_;
    LibraryEnvironment environment_;
    std::string_view pass_;          // the pass that is being lowered
    std::size_t first_of_path_ = 0;  // the first of the passes that are drawn together
    bool reads_of_pass_ = false;     // a pass has a semantic of its own
    std::size_t next_ = 0;           // the next function whose semantics have not been lowered
    std::set<std::string_view> remarked_;
    std::set<std::string> tried_;  // paths
};

}  // namespace

// Where nothing is drawn into what they draw into, there is nothing to see of them.
bool draws_extra(const resolve::Session& session, const Lowered& lowered) {
    const paths::PassDecl* extra = session.paths->pass_for_extra(session.path);
    const auto is_shared = [&](const RenderTarget& target) {
        return std::any_of(extra->state.targets.begin(), extra->state.targets.end(),
                           [&](const RenderTarget& other) { return other.name == target.name; });
    };
    return extra && std::any_of(lowered.passes.begin(), lowered.passes.end(), [&](const LoweredPass& pass) {
               const std::vector<RenderTarget>& targets = pass.declaration->state.targets;
               return std::any_of(targets.begin(), targets.end(), is_shared);
           });
}

void lower_passes(Lowering& lowering) {
    Passes(lowering).run();
}

}  // namespace patina::lower
