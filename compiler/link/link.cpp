#include "compiler/link/link.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "compiler/base/spelling.h"
#include "compiler/ir/fold/facts.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/ir/rebuild.h"
#include "compiler/link/target_reads.h"

namespace patina::link {

using ir::Op;
using ir::SemanticId;
using ir::Type;
using ir::Value;
using paths::SemanticSource;

namespace {

// --- semantics to parameters

// Gives the instruction new operands; the old ones stay in the pool, unused.
void set_operands(ir::Function& function, ir::Inst& inst, std::span<const Value> operands) {
    inst.first_operand = static_cast<std::uint32_t>(function.operands.size());
    inst.operand_count = static_cast<std::uint32_t>(operands.size());
    function.operands.insert(function.operands.end(), operands.begin(), operands.end());
}

// The semantics that a function needs, sorted: its own and those of the functions that it calls.
std::vector<SemanticId> needs_of(const ir::Function& function, const std::vector<std::vector<SemanticId>>& known) {
    std::vector<SemanticId> needs;
    for (const ir::Inst& inst : function.insts) {
        if (inst.op == Op::Semantic) needs.push_back({inst.data});
        if (inst.op == Op::Call) needs.insert(needs.end(), known[inst.data].begin(), known[inst.data].end());
    }
    std::sort(needs.begin(), needs.end());
    needs.erase(std::unique(needs.begin(), needs.end()), needs.end());
    return needs;
}

// The needs of every function. A function that a pass replaces also has the needs of its replacement, so that callers
// pass the same values in every pass. Parameters that a stage does not read are pruned later.
std::vector<std::vector<SemanticId>> all_needs(const lower::Lowered& lowered, std::span<const ir::Function> functions) {
    std::vector<std::vector<SemanticId>> needs(functions.size());
    for (std::uint32_t i = 0; i < functions.size(); ++i) needs[i] = needs_of(functions[i], needs);
    const auto join = [&](ir::FunctionId into, ir::FunctionId from) {
        std::vector<SemanticId> both;
        std::set_union(needs[into.index].begin(), needs[into.index].end(), needs[from.index].begin(),
                       needs[from.index].end(), std::back_inserter(both));
        const bool grows = both.size() > needs[into.index].size();
        needs[into.index] = std::move(both);
        return grows;
    };
    for (bool grows = true; grows;) {
        grows = false;
        for (const lower::LoweredPass& pass : lowered.passes) {
            for (const auto& given : pass.replaced) grows |= join(given.what, given.by) || join(given.by, given.what);
        }
        if (!grows) break;
        for (std::uint32_t i = 0; i < functions.size(); ++i) {
            for (const ir::Inst& inst : functions[i].insts) {
                if (inst.op == Op::Call) join({i}, {inst.data});
            }
        }
    }
    return needs;
}

void thread_function(const ir::Module& module, ir::Function& function, const std::vector<SemanticId>& own,
                     const std::vector<std::vector<SemanticId>>& needs) {
    if (own.empty()) return;
    // The Param instructions come first in the function, so that they dominate every use.
    std::vector<Value> params;
    for (SemanticId semantic : own) {
        const ir::Semantic& info = module.semantics[semantic.index];
        ir::Inst inst{};
        inst.op = Op::Param;
        inst.type = info.type;
        inst.data = static_cast<std::uint32_t>(function.params.size());
        function.params.push_back({info.name, info.type, info.rate, true, info.from_bottom, info.is_unit});
        function.insts.push_back(inst);
        params.push_back({static_cast<std::uint32_t>(function.insts.size() - 1)});
    }
    const auto param_of = [&](SemanticId semantic) {
        const auto at = std::lower_bound(own.begin(), own.end(), semantic) - own.begin();
        return static_cast<std::uint32_t>(at);
    };
    const std::size_t original = function.insts.size() - params.size();
    for (std::size_t i = 0; i < original; ++i) {
        ir::Inst& inst = function.insts[i];
        if (inst.op == Op::Semantic) {
            inst.data = function.insts[params[param_of({inst.data})].index].data;
            inst.op = Op::Param;
        } else if (inst.op == Op::Call && !needs[inst.data].empty()) {
            const std::span<const Value> before = function.args(inst);
            std::vector<Value> operands(before.begin(), before.end());
            for (SemanticId semantic : needs[inst.data]) operands.push_back(params[param_of(semantic)]);
            set_operands(function, inst, operands);
        }
    }
    std::vector<Value>& body = function.blocks[0].insts;
    body.insert(body.begin(), params.begin(), params.end());
}

// --- entry functions

constexpr std::uint32_t kNumberedLater = 0xffffffffu;  // a location

class EntryBuilder {
public:
    EntryBuilder(const Linked& linked, const lower::LoweredPass& pass, ir::StageKind stage, ir::BuildOptions options)
        : linked_(linked),
          pass_(pass),
          module_(linked.lowered.module),
          builder_(module_, entry_, options),
          imported_(linked.functions.size()) {
        module_.stage.kind = stage;
        module_.stage.shares_functions = linked.lowered.keeps_functions;
        entry_.name = "main";
    }

    ir::Builder& builder() { return builder_; }
    ir::Module& module() { return module_; }

    // Calls a function whose parameters are all semantics. `original`: with the mesh's attributes before the material
    // changes them.
    Value call(ir::FunctionId function, bool original = false) {
        std::vector<Value> arguments;
        for (SemanticId semantic : linked_.needs[function.index]) arguments.push_back(value(semantic, original));
        return builder_.call(imported(function), arguments);
    }

    // A node that is pinned to the vertex stage has one value, from the unchanged mesh, for readers in both stages.
    Value value(SemanticId semantic, bool original = false) {
        const lower::SemanticRecipe& recipe = linked_.lowered.semantics[semantic.index];
        original = original || (recipe.source == SemanticSource::Vertex && !recipe.declaration);
        std::vector<Value>& known = original ? originals_ : values_;
        known.resize(module_.semantics.size());
        if (known[semantic.index]) return known[semantic.index];
        const bool outside = std::exchange(reads_usual_, false);
        const Value made = make(semantic, original);
        // Inside a recipe of the pass, a value may be made from the usual value of the semantic. Other readers must not
        // get it.
        if (!reads_usual_) known[semantic.index] = made;
        reads_usual_ = !giving_.empty() && (reads_usual_ || outside);
        if (builder_[made].op != Op::Param && builder_[made].op != Op::Global) {
            builder_.name(made, module_.intern(module_.semantics[semantic.index].name));
        }
        return made;
    }

    // The value as the library changes it for every pass (lower::Wraps).
    Value wrapped(ir::FunctionId wrap, Value value) {
        return wraps(wrap) ? builder_.call(imported(wrap), {&value, 1}) : value;
    }

    // Ends the entry function. Its outputs are those of the stage, in order.
    ir::Module finish(std::string struct_name, std::vector<ir::StageVariable> outputs, std::span<const Value> values) {
        ir::Struct made{.name = std::move(struct_name), .members = {}};
        for (const ir::StageVariable& output : outputs) made.members.push_back({output.name, output.type});
        module_.structs.push_back(std::move(made));
        entry_.result = Type::structure(static_cast<std::uint32_t>(module_.structs.size() - 1));
        builder_.ret(builder_.construct(entry_.result, values));
        module_.stage.outputs = std::move(outputs);
        module_.functions.push_back(std::move(entry_));
        module_.stage.entry = {static_cast<std::uint32_t>(module_.functions.size() - 1)};
        return std::move(module_);
    }

private:
    // A light's view is no part of the picture.
    bool wraps(ir::FunctionId wrap) const { return wrap && pass_.declaration->state.lights != PassLights::Shadowed; }

    // Copies a function into the stage, after the functions that it calls. A function that replaces another one in this
    // pass may call the replaced one.
    ir::FunctionId imported(ir::FunctionId function) {
        const bool is_usual = std::find(replacing_.begin(), replacing_.end(), function) != replacing_.end();
        if (const auto* other = is_usual ? nullptr : pass_.replacement_of(function, module_.stage.kind)) {
            replacing_.push_back(function);
            const ir::FunctionId made = imported(other->by);
            replacing_.pop_back();
            return made;
        }
        if (imported_[function.index]) return imported_[function.index];
        ir::Function copy = linked_.functions[function.index];
        // The fragment stage of a pass without targets does not share functions. So it has no inputs that it does not
        // read.
        const bool shares = in_vertex_stage() || !pass_.declaration->state.targets.empty();
        if (linked_.lowered.keeps_functions && shares && !ir::is_elsewhere(copy)) copy.linkage = ir::Linkage::Exported;
        ir::renumber_calls(copy, [&](std::uint32_t callee) { return imported({callee}).index; });
        if (const ir::FunctionId wrap = linked_.lowered.wraps.reads; wraps(wrap) && wrap != function)
            wrap_reads(copy, linked_.lowered.picture_reads, imported(wrap), linked_.functions[wrap.index].result);
        module_.functions.push_back(std::move(copy));
        return imported_[function.index] = {static_cast<std::uint32_t>(module_.functions.size() - 1)};
    }

    // A pass's own recipe may read the semantic that it computes; that read gets the usual recipe.
    std::optional<Value> given(SemanticId semantic, bool original) {
        const auto* recipe = pass_.recipe_of(semantic, module_.stage.kind);
        if (!recipe) return {};
        if (std::find(giving_.begin(), giving_.end(), semantic) != giving_.end()) {
            reads_usual_ = true;
            return {};
        }
        giving_.push_back(semantic);
        const Value made = call(recipe->by, original);
        giving_.pop_back();
        if (giving_.empty()) reads_usual_ = false;
        return made;
    }

    bool in_vertex_stage() const { return module_.stage.kind == ir::StageKind::Vertex; }

    Value make(SemanticId semantic, bool original) {
        const lower::SemanticRecipe& recipe = linked_.lowered.semantics[semantic.index];
        const bool is_of_mesh = original && recipe.source == SemanticSource::Attribute;
        if (const auto made = is_of_mesh ? std::nullopt : given(semantic, original)) return *made;
        switch (recipe.source) {
            case SemanticSource::Attribute:
                if (!in_vertex_stage()) return varying(semantic);
                // A material moves objects only, and not the screen or the volumes of lights.
                if (recipe.override && !original && pass_.declaration->state.draws == PassDraws::Objects)
                    return call(recipe.override, true);
                return attribute(semantic);
            case SemanticSource::Builtin: return builtin(semantic);
            case SemanticSource::Vertex: return in_vertex_stage() ? call(recipe.recipe, original) : varying(semantic);
            case SemanticSource::Pixel:
            case SemanticSource::Uniform: return call(recipe.recipe, original);
            case SemanticSource::Extern:
            case SemanticSource::Given: break;  // globals and parameters: never a semantic instruction
        }
        return {};
    }

    Value input(ir::StageVariable variable, ir::Rate rate) {
        entry_.params.push_back({variable.name, variable.type, rate, false, variable.from_bottom});
        module_.stage.inputs.push_back(std::move(variable));
        return builder_.param(static_cast<std::uint32_t>(entry_.params.size() - 1));
    }

    Value attribute(SemanticId semantic) {
        // The mesh's own value is one input, for all readers.
        originals_.resize(module_.semantics.size());
        if (originals_[semantic.index]) return originals_[semantic.index];
        if (const std::optional<ir::GlobalId> global = pass_.attribute_of(semantic))
            return originals_[semantic.index] =
                       builder_.emit(Op::Global, module_.semantics[semantic.index].type, {}, global->index);
        const lower::SemanticRecipe& recipe = linked_.lowered.semantics[semantic.index];
        const ir::Semantic& info = module_.semantics[semantic.index];
        const Value made = input({.name = info.name,
                                  .type = info.type,
                                  .location = recipe.location.value_or(kNumberedLater),
                                  .semantic = std::string(recipe.hlsl),
                                  .from_bottom = info.from_bottom},
                                 ir::Rate::Vertex);
        originals_[semantic.index] = made;
        return made;
    }

    Value varying(SemanticId semantic) {
        const ir::Semantic& info = module_.semantics[semantic.index];
        return once(semantic, {.name = info.name, .type = info.type, .semantic = {}, .from_bottom = info.from_bottom});
    }

    // One input for all readers.
    Value once(SemanticId semantic, ir::StageVariable variable) {
        inputs_.resize(module_.semantics.size());
        Value& known = inputs_[semantic.index];
        if (!known) known = input(std::move(variable), ir::Rate::Pixel);
        return known;
    }

    Value builtin(SemanticId semantic) {
        const ir::Builtin which = linked_.lowered.semantics[semantic.index].declaration->builtin;
        const ir::Semantic& info = module_.semantics[semantic.index];
        // Only the vertex stage knows the instance, and passes it on.
        if (!in_vertex_stage() && which == ir::Builtin::InstanceIndex) return varying(semantic);
        // A vertex does not belong to one face, so it counts as seen from the front.
        if (in_vertex_stage() && which == ir::Builtin::FrontFacing) return builder_.constant(info.type, {1});
        const Value made = once(semantic, {.name = info.name, .type = info.type, .builtin = which, .semantic = {}});
        return which == ir::Builtin::FragCoord ? wrapped(linked_.lowered.wraps.pixel, made) : made;
    }

    const Linked& linked_;
    const lower::LoweredPass& pass_;
    std::vector<SemanticId> giving_;
    std::vector<ir::FunctionId> replacing_;
    ir::Module module_;
    ir::Function entry_{};
    ir::Builder builder_;
    std::vector<Value> values_, originals_, inputs_;
    bool reads_usual_ = false;  // what is being made reads the usual value of a semantic that the pass gives
    std::vector<ir::FunctionId> imported_;
};

// Finds the semantics that are unit vectors in every pass.
void note_unit_semantics(lower::Lowered& lowered) {
    ir::Module& module = lowered.module;
    const auto gives_unit = [&](ir::FunctionId function) {
        return function && ir::returns_unit(module, module[function]);
    };
    for (std::uint32_t i = 0; i < module.semantics.size(); ++i) {
        const lower::SemanticRecipe& semantic = lowered.semantics[i];
        // An interpolated vector does not keep its length.
        if (semantic.source != SemanticSource::Pixel && semantic.source != SemanticSource::Uniform) continue;
        module.semantics[i].is_unit =
            gives_unit(semantic.recipe) &&
            std::all_of(lowered.passes.begin(), lowered.passes.end(), [&](const lower::LoweredPass& pass) {
                return std::all_of(pass.recipes.begin(), pass.recipes.end(),
                                   [&](const auto& given) { return given.what.index != i || gives_unit(given.by); });
            });
    }
}

// Makes the functions that passes share as short as possible for all of them. Removes members that are always the same,
// and members that no function reads that an entry may call.
void tidy_shared(lower::Lowered& lowered) {
    std::vector<ir::FunctionId> entries, called;
    const auto add = [&](ir::FunctionId function) {
        if (function) called.push_back(function);
    };
    for (const lower::SemanticRecipe& semantic : lowered.semantics) {
        add(semantic.recipe);
        add(semantic.override);
    }
    for (const lower::LoweredPass& pass : lowered.passes) {
        entries.insert(entries.end(), {pass.vertex, pass.fragment});
        for (const auto& given : pass.recipes) add(given.by);
        for (const auto& given : pass.replaced) add(given.by);
    }
    note_unit_semantics(lowered);
    lowered.module = ir::settle_members(std::move(lowered.module));
    lowered.module = ir::drop_members(std::move(lowered.module), entries, called);
}

std::vector<ir::OriginId> readers_of(const ir::Module& module) {
    std::vector<ir::OriginId> readers(module.semantics.size());
    for (const ir::Function& function : module.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == Op::Semantic && inst.origin && !readers[inst.data]) readers[inst.data] = inst.origin;
        }
    }
    return readers;
}

}  // namespace

Linked link(lower::Lowered lowered) {
    if (lowered.keeps_functions) tidy_shared(lowered);
    std::vector<ir::OriginId> readers = readers_of(lowered.module);
    std::vector<ir::Function> functions = std::move(lowered.module.functions);
    lowered.module.functions.clear();
    const std::vector<std::vector<SemanticId>> needs = all_needs(lowered, functions);
    for (std::uint32_t i = 0; i < functions.size(); ++i) {
        thread_function(lowered.module, functions[i], needs[i], needs);
    }
    return {.lowered = std::move(lowered),
            .functions = std::move(functions),
            .needs = needs,
            .readers = std::move(readers)};
}

namespace {

std::vector<ir::StageText> texts_of(const paths::PassDecl& pass) {
    std::vector<ir::StageText> texts = pass.vertex_texts;
    texts.insert(texts.end(), pass.fragment_texts.begin(), pass.fragment_texts.end());
    return texts;
}

// True if the pass, or a function that its fragment stage calls, has lines at the end of the vertex stage.
bool reads_mesh_at_end(const paths::PassDecl& pass, const ir::Module& fragment) {
    const auto is_at_end = [](const ir::StageText& text) { return text.place == "vertex end"; };
    const auto has_line = [&](const std::vector<ir::StageText>& texts) {
        return std::any_of(texts.begin(), texts.end(), is_at_end);
    };
    return has_line(pass.vertex_texts) || has_line(pass.fragment_texts) ||
           std::any_of(fragment.functions.begin(), fragment.functions.end(),
                       [&](const ir::Function& function) { return has_line(function.texts); });
}

}  // namespace

ir::Module link_fragment(const Linked& linked, const lower::LoweredPass& pass, ir::BuildOptions options,
                         std::uint32_t left_out) {
    EntryBuilder entry(linked, pass, ir::StageKind::Fragment, options);
    const Value result = entry.call(pass.fragment);
    const Type type = entry.builder().type(result);
    std::vector<ir::StageVariable> outputs;
    std::vector<Value> values;
    const auto add = [&](std::string name, Type of, Value value) {
        const auto location = static_cast<std::uint32_t>(outputs.size());
        const auto& guards = pass.declaration->guards;
        outputs.push_back({.name = std::move(name),
                           .type = of,
                           .location = location,
                           .guard = location < guards.size() ? std::string(guards[location]) : std::string()});
        values.push_back(value);
    };
    if (type.kind == ir::Kind::Struct) {
        const std::vector<ir::Member> members = entry.module().structs[type.ref].members;
        for (std::uint32_t i = 0; i + left_out < members.size(); ++i)
            add(members[i].name, members[i].type, entry.builder().extract(result, i));
    } else {
        add("color", type, result);
    }
    ir::Module made = entry.finish("Targets", std::move(outputs), values);
    made.stage.texts = texts_of(*pass.declaration);
    return made;
}

ir::Module link_vertex(const Linked& linked, const lower::LoweredPass& pass, const ir::Module& fragment,
                       ir::BuildOptions options) {
    EntryBuilder entry(linked, pass, ir::StageKind::Vertex, options);
    std::vector<ir::StageVariable> outputs;
    std::vector<Value> values;
    const Value position = entry.wrapped(linked.lowered.wraps.position, entry.call(pass.vertex));
    for (const ir::StageVariable& input : fragment.stage.inputs) {
        if (input.builtin != ir::Builtin::None) continue;
        const auto& semantics = linked.lowered.module.semantics;
        const auto found = std::find_if(semantics.begin(), semantics.end(),
                                        [&](const ir::Semantic& s) { return s.name == input.name; });
        outputs.push_back(input);
        values.push_back(entry.value({static_cast<std::uint32_t>(found - semantics.begin())}));
    }
    // In some passes, lines at the end of the vertex stage compute the position.
    if (entry.builder().type(position).kind != ir::Kind::Struct) {
        outputs.push_back(
            {.name = "position", .type = entry.builder().type(position), .builtin = ir::Builtin::Position});
        values.push_back(position);
    }
    // Lines at the end of the vertex stage read the mesh's values that included files declare: as the material has
    // moved them.
    const bool has_readers = reads_mesh_at_end(*pass.declaration, fragment);
    for (const auto& [semantic, global] : pass.attributes) {
        if (!has_readers || !linked.lowered.semantics[semantic.index].override) continue;
        const Value moved = entry.value(semantic);
        outputs.push_back({.name = joined("moved", linked.lowered.module.semantics[semantic.index].name),
                           .type = entry.builder().type(moved),
                           .spelling = linked.lowered.module.globals[global.index].spelling});
        values.push_back(moved);
    }
    ir::Module made = entry.finish("Varyings", std::move(outputs), values);
    made.stage.texts = texts_of(*pass.declaration);
    return made;
}

bool take_constants(ir::Module& fragment, const ir::Module& vertex) {
    const ir::Function& maker = vertex[vertex.stage.entry];
    const Value outputs = maker.args(maker.blocks[0].insts.back())[0];
    if (maker[outputs].op != Op::Construct) return false;
    std::map<std::uint32_t, std::span<const double>> known;  // by parameter
    std::size_t varying = 0;
    for (std::uint32_t i = 0; i < fragment.stage.inputs.size(); ++i) {
        if (fragment.stage.inputs[i].builtin != ir::Builtin::None) continue;
        const ir::Inst& made = maker[maker.args(outputs)[varying++]];
        if (made.op == Op::Constant) known[i] = vertex.numbers_of(vertex.constants[made.data]);
    }
    if (known.empty()) return false;
    ir::Function& entry = fragment.functions[fragment.stage.entry.index];
    const ir::Function from = std::move(entry);
    ir::Function made = ir::shell(from);
    ir::Builder builder(fragment, made, {});
    ir::Copy copy{.from = from, .to = builder, .rewrite = [&](ir::Copy& c, Value v) {
                      const auto found = known.find(from[v].data);
                      if (from[v].op != Op::Param || found == known.end()) return false;
                      c.map[v.index] = c.to.constant(from[v].type, found->second);
                      return true;
                  }};
    ir::copy_body(copy);
    fragment.functions[fragment.stage.entry.index] = std::move(made);
    return true;
}

}  // namespace patina::link
