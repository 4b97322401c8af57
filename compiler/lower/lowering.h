// Functions that the files of lower() share. Private to compiler/lower/lower*.cpp, keep_values.cpp and
// pass_refusal.cpp.
#pragma once

#include "compiler/lower/graph_scope.h"

namespace patina::lower {

ir::FunctionId add_function(ir::Module& module, ir::Function function);
ir::Type input_type(Lowering& lowering, const format::Input& input);
// The type that a word of a graph means: "color3", "texture2d", "gradient".
ir::Type type_of_word(Lowering& lowering, std::string_view word, Span span);

// A previewed value of any type as a colour: a scalar is grey, two components are red and green.
emit::Typed as_color(Lowering& lowering, emit::Typed value, GraphScope& scope, Span span);
// surface(): all values that the workflow and the lighting model take from the graph, in one struct. `members`: the
// inputs behind its members.
ir::FunctionId lower_surface(Lowering& lowering, std::vector<const format::Input*>& members);
// lightingSurface(): the workflow's set-up, over the surface.
ir::FunctionId lower_setup(Lowering& lowering, const nodelang::FunctionDecl& slot, ir::FunctionId surface,
                           std::span<const format::Input* const> members);
// The function of a lighting graph, in a material that does not set all inputs of the model. The defaults of unset
// inputs are constants, and everything that they switch off is left out (unset_inputs.cpp). Its first parameter is the
// lighting surface.
ir::Function without_unset_inputs(Lowering& lowering, ir::Function function);
// Leaves such inputs out of the structs of the surface. For functions, whose text shows these structs.
void leave_out_unset_inputs(Lowering& lowering);
// Fills the slots that the material, its workflow and its lighting graph provide.
void lower_slots(Lowering& lowering);

// A derived slot (derived_slots.cpp).
const DerivedSlot& derived_slot(Lowering& lowering, const paths::SlotDecl& slot);
// The members of the lighting surface that a pack slot stores.
std::vector<std::string_view> packed_members(Lowering& lowering, std::string_view slot);

// What all passes do while a switch is on (lower_wraps.cpp).
void lower_wraps(Lowering& lowering, std::span<const std::string_view> on);

// The passes of the requested path, or of its fallback.
void lower_passes(Lowering& lowering);
// The functions for an engine's own shaders, instead of passes (lower_functions.cpp).
void lower_functions(Lowering& lowering);
// Records how the engine stores the values of properties, and adds lines of the engine's file to each stage that calls
// its functions (keep_values.cpp).
void keep_values(Lowering& lowering);
void give_texts(Lowering& lowering);
// Why a pass cannot draw this material, found in its functions (pass_refusal.cpp); empty if it can.
struct Refusal {
    std::string reason{};
    ir::Origin where{};
    std::string advice{};  // may be empty
    bool is_news = false;  // report a warning, even if the pass is optional
    bool is_vain = false;  // the pass would change nothing: it is left out without a warning
    explicit operator bool() const { return !reason.empty(); }
};
Refusal refusal_of(Lowering& lowering, const LoweredPass& pass);

// The names in nodes/stage and nodes/passes: they can mean semantics only.
class LibraryEnvironment : public emit::Environment {
public:
    explicit LibraryEnvironment(Lowering& lowering) : lowering_(lowering) {}
    emit::Typed name(const nodelang::Expr& expr, emit::Scope& scope) override {
        return semantic(expr.text, expr.span, scope);
    }
    emit::Typed property(const nodelang::Expr&, emit::Scope&) override { return {}; }
    emit::Typed file(const nodelang::Expr&, emit::Scope&) override { return {}; }
    emit::Typed semantic(std::string_view name, Span span, emit::Scope& scope) override {
        const auto found = lowering_.session.paths->semantic_index.find(name);
        if (found == lowering_.session.paths->semantic_index.end()) {
            lowering_.session.diagnostics.report(Code::UnknownSemantic, span, name);
            return {};
        }
        const paths::SemanticDecl& semantic = lowering_.session.paths->semantics[found->second];
        if (semantic.source == paths::SemanticSource::Extern)
            return emit::extern_value(lowering_.emitter, *semantic.variable, scope);
        const ir::Type type = lowering_.out.module.semantics[found->second].type;
        return {.value = scope.builder->emit(ir::Op::Semantic, type, {}, found->second), .type = type};
    }

private:
    Lowering& lowering_;
};

}  // namespace patina::lower
