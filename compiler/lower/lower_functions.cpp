// Lowers a material without a pass: the functions that an engine calls from its own shaders. [extern] functions are
// only declared, because the engine defines them. [extern] values become parameters, and so do the values of the mesh
// and the camera.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/spelling.h"
#include "compiler/format/words.h"
#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

using ir::Op;
using ir::Type;
using ir::Value;
using nodelang::FunctionDecl;

class Functions {
public:
    explicit Functions(Lowering& lowering)
        : lowering_(lowering), module_(lowering.out.module), environment_(lowering) {}

    void run() {
        if (!can_be_passed() || !lowering_.surface) return;
        add(lowering_.surface, "surface", "The surface as the graph describes it, in the words of its workflow.");
        for (const paths::ExportDecl& each : lowering_.session.paths->exports) {
            const ir::FunctionId made = emit::given_function(lowering_.emitter, *each.function,
                                                             *lowering_.session.declarations, environment_, false);
            if (made) add(made, each.name, nodelang::first_sentence(each.function->doc));
        }
        leave_out_unset_inputs(lowering_);
        add_vertex_functions();
        leave_to_engine();
        for (ir::Function& function : module_.functions) take_engine_values(function);
    }

private:
    void add(ir::FunctionId id, std::string_view name, std::string comment, bool is_vertex = false) {
        ir::Function& function = module_[id];
        function.name = name;
        function.comment = std::move(comment);
        function.always_inline = false;
        lowering_.out.functions.push_back({.id = id, .is_vertex = is_vertex});
    }

    void add_vertex_functions() {
        for (std::size_t i = 0; i < lowering_.out.semantics.size(); ++i) {
            const SemanticRecipe& semantic = lowering_.out.semantics[i];
            const std::string& name = module_.semantics[i].name;
            if (semantic.override)
                add(semantic.override, joined("vertex", name),
                    fmt::format("'{}' of the mesh, as the graph moves it.", name), true);
            if (semantic.recipe && !semantic.declaration)
                add(semantic.recipe, joined("vertex", name),
                    fmt::format("The value that is interpolated as '{}' for the surface, of the mesh before the graph "
                                "moves it.",
                                name),
                    true);
        }
    }

    // A texture cannot be a member of a parameter.
    bool can_be_passed() {
        const auto& inputs = lowering_.material.lighting->graph->inputs;
        for (const format::Input& input : inputs) {
            if (!format::texture_type(input.type)) continue;
            lowering_.session.diagnostics.report(
                Code::NotYet, input.type_span,
                fmt::format("--functions cannot pass the texture input '{}' of the lighting graph: make it a property "
                            "of the lighting graph",
                            input.name));
        }
        return !lowering_.session.diagnostics.has_errors();
    }

    void leave_to_engine() {
        for (const FunctionDecl* function : lowering_.session.library.paths.extern_functions) {
            for (const emit::InstanceInfo& instance : lowering_.emitter.instances.of(*function)) {
                ir::Function made{};
                made.name = module_[instance.id].name;
                made.comment = module_[instance.id].comment;
                made.params = module_[instance.id].params;
                made.result = module_[instance.id].result;
                made.linkage = ir::Linkage::External;
                ir::Builder builder(module_, made);
                builder.ret(builder.zero(made.result));
                module_[instance.id] = std::move(made);
            }
        }
    }

    // A member of an engine's block becomes a semantic.
    void take_engine_values(ir::Function& function) {
        for (ir::Inst& inst : function.insts) {
            if (inst.op != Op::Global || !module_.globals[inst.data].in_block()) continue;
            if (module_.globals[inst.data].group != ir::Group::Engine) continue;
            inst.op = Op::Semantic;
            inst.data = semantic_of(module_.globals[inst.data]);
        }
    }

    std::uint32_t semantic_of(const ir::Global& global) {
        const auto found = std::find_if(module_.semantics.begin(), module_.semantics.end(),
                                        [&](const ir::Semantic& s) { return s.name == global.name; });
        if (found != module_.semantics.end()) return static_cast<std::uint32_t>(found - module_.semantics.begin());
        module_.semantics.push_back({.name = global.name, .type = global.type, .rate = ir::Rate::Uniform});
        lowering_.out.semantics.push_back({.source = paths::SemanticSource::Extern});
        return static_cast<std::uint32_t>(module_.semantics.size() - 1);
    }

    Lowering& lowering_;
    ir::Module& module_;
    LibraryEnvironment environment_;
};

}  // namespace

void lower_functions(Lowering& lowering) {
    Functions(lowering).run();
}

}  // namespace patina::lower
