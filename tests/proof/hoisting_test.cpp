// A fragment shader computes nothing inside its loop over the lights that does not depend on the light: of every
// lighting model under every workflow, and of the examples. Nor does a vertex shader that is lit. Read off the rates of
// the finished IR, in the loop itself and in what is called there.
//
// Nothing that computes is exempt. Constants, parameters and globals stand at the head of a function, and a Yield
// computes nothing: it hands on what was made, which may come from outside the loop. In a function that is called from
// the loop, taking values apart and putting them together is no computation (is_work).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "compiler/ir/dump.h"
#include "compiler/ir/passes/dependence.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/languages/plan.h"
#include "compiler/link/identifiers.h"
#include "compiler/link/link.h"
#include "patina/patina.h"
#include "proof/lowered.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

using ir::Function;
using ir::Inst;
using ir::Module;
using ir::Op;
using ir::Rate;
using ir::Value;

// What a light loop of the module computes for nothing, a line each.
class Search {
public:
    explicit Search(const Module& module) : module_(module), plans_(module) {}

    std::vector<std::string> run() {
        for (std::uint32_t f = 0; f < module_.functions.size(); ++f) {
            const Function& function = module_.functions[f];
            const std::vector<Rate> rates = ir::rates(module_, function);
            for (const Inst& inst : function.insts) {
                if (inst.op != Op::For || !inst.is_light_loop) continue;
                ++loops;
                block(f, rates, inst.data);
            }
        }
        return std::move(found_);
    }

    int loops = 0;
    int instructions = 0;  // that were looked at

private:
    void report(const Function& function, Value value, std::string_view what) {
        found_.push_back(fmt::format("{} %{} {} {}: {}", function.name, value.index, ir::info(function[value].op).text,
                                     module_.name_of(function[value].name), what));
    }

    void block(std::uint32_t f, const std::vector<Rate>& rates, std::uint32_t index) {
        const Function& function = module_.functions[f];
        for (const Value value : function.blocks[index].insts) {
            const Inst& inst = function[value];
            ++instructions;
            if (inst.op == Op::If || inst.op == Op::For) block(f, rates, inst.data);
            if (inst.op == Op::If) block(f, rates, inst.data + 1);
            if (inst.op == Op::Yield) continue;
            if (rates[value.index] != Rate::Light) report(function, value, "does not depend on the light");
            if (inst.op == Op::Call) call(inst, function, rates);
        }
        printed_inside(f, index);
    }

    // A value that was made before the loop would be computed in it again if its text stood there.
    void printed_inside(std::uint32_t f, std::uint32_t index) {
        const Function& function = module_.functions[f];
        const languages::Plan& plan = plans_.of({f});
        const std::vector<Value>& inside = function.blocks[index].insts;
        for (const Value value : inside) {
            for (const Value arg : function.args(value)) {
                const Value read = plan.resolve(arg);
                if (std::ranges::find(inside, read) != inside.end()) continue;
                if (ir::is_work(function[read].op) && !plan.stands[read.index])
                    report(function, read, "is written out inside the loop");
            }
        }
    }

    // A function that is called in the loop, its parameters being as often new as the arguments.
    void call(const Inst& inst, const Function& caller, const std::vector<Rate>& rates) {
        std::vector<Rate> arguments;
        for (const Value arg : caller.args(inst)) arguments.push_back(rates[arg.index]);
        if (!visited_.insert({inst.data, arguments}).second) return;
        Function callee = module_.functions[inst.data];
        for (std::size_t i = 0; i < arguments.size(); ++i) callee.params[i].rate = arguments[i];
        const std::vector<Rate> inside = ir::rates(module_, callee);
        for (std::uint32_t i = 0; i < callee.insts.size(); ++i) {
            const Inst& called = callee.insts[i];
            ++instructions;
            if (called.op == Op::Call) call(called, callee, inside);
            if (ir::is_work(called.op) && inside[i] != Rate::Light)
                report(callee, {i}, "does not depend on the light that it is called for");
        }
    }

    const Module& module_;
    languages::Plans plans_;
    std::set<std::pair<std::uint32_t, std::vector<Rate>>> visited_;
    std::vector<std::string> found_;
};

bool gives(const ModelInfo& workflow, const std::string& name) {
    return std::any_of(workflow.outputs.begin(), workflow.outputs.end(),
                       [&](const auto& output) { return output.first == name; });
}

// Every input of the surface varies: a property times a coordinate of the mesh. `left_out`: the model's own inputs
// whose names begin so.
std::string varying_material(const ModelInfo& model, const ModelInfo& workflow, std::string_view left_out = "-") {
    std::string properties, surface;
    for (const std::vector<ModelInputInfo>* inputs : {&workflow.inputs, &model.inputs}) {
        for (const ModelInputInfo& input : *inputs) {
            if (inputs == &model.inputs && (input.name.starts_with(left_out) || gives(workflow, input.name))) continue;
            if (!input.gives.empty() || input.default_value.find('@') != std::string::npos) continue;
            const char* comma = properties.empty() ? "" : ", ";
            properties += fmt::format(R"({}{{ "name": "_{}", "type": "{}" }})", comma, input.name,
                                      input.type == "color3" ? "color" : input.type);
            surface += fmt::format(R"({}"{}": "= $_{}{} * @uv0.x")", comma, input.name, input.name,
                                   input.type == "color3" ? ".rgb" : "");
        }
    }
    return fmt::format(
        R"({{ "patina": 1, "workflow": "{}", "lighting": "{}", "properties": [ {} ], "surface": {{ {} }} }})",
        workflow.name, model.name, properties, surface);
}

using Stages = std::vector<std::pair<std::string, Module>>;  // by pass

Stages linked_stages(LoweredMaterial& made, ir::StageKind kind) {
    Stages stages;
    link::name_interface(made.module());
    const link::Linked linked = link::link(std::move(made.lowered()));
    for (const lower::LoweredPass& pass : linked.lowered.passes) {
        Module stage = link::link_fragment(linked, pass, {});
        if (kind == ir::StageKind::Vertex) {
            Module fragment = ir::tidy(std::move(stage));
            stage = link::link_vertex(linked, pass, fragment, {});
        }
        stages.emplace_back(std::string(pass.declaration->name), std::move(stage));
    }
    return stages;
}

// The number of light loops that the pass `counted` has.
int expect_nothing_left_in_loops(Stages stages, const std::string& name, std::string_view counted = "forward") {
    int loops = 0;
    for (auto& [pass, linked] : stages) {
        const Module tidied = ir::tidy(std::move(linked));
        Search search(tidied);
        for (const std::string& line : search.run()) ADD_FAILURE() << name << ", pass " << pass << ": " << line;
        // Nor does what a language needs besides put anything there.
        for (const char* target : {"glsl", "hlsl"}) {
            const std::optional<Module> rewritten = languages::find_language(target)->legalize(tidied);
            if (!rewritten) continue;
            for (const std::string& line : Search(*rewritten).run())
                ADD_FAILURE() << name << ", pass " << pass << ", " << target << ": " << line;
        }
        if (pass == counted) loops += search.loops;
        EXPECT_TRUE(search.loops == 0 || search.instructions > 10) << name;
    }
    return loops;
}

TEST(Hoisting, OfEveryModelUnderEveryWorkflow) {
    const Compiler compiler;
    for (const ModelInfo& model : compiler.lighting_models()) {
        for (const ModelInfo& workflow : compiler.workflows()) {
            if (workflow.name == "unlit" && model.name != "unlit") continue;  // it has no lighting
            const std::string name = model.name + " under " + workflow.name;
            LoweredMaterial made(varying_material(model, workflow));
            ASSERT_TRUE(made.ok()) << name;
            const int loops = expect_nothing_left_in_loops(linked_stages(made, ir::StageKind::Fragment), name);
            // What is lit by no light has no loop.
            EXPECT_EQ(loops, model.name == "unlit" ? 0 : 1) << name;
        }
    }
}

// The path that lights vertices has one loop, too, whatever is split.
TEST(Hoisting, OfLitVertices) {
    const Compiler compiler;
    for (const ModelInfo& model : compiler.lighting_models()) {
        for (const ModelInfo& workflow : compiler.workflows()) {
            if (workflow.name == "unlit" && model.name != "unlit") continue;  // it has no lighting
            const std::string name = model.name + " under " + workflow.name + ", at vertices";
            // Vertices cannot see the scene behind them.
            LoweredMaterial made(varying_material(model, workflow, "transmission"), "proof.graph.json", {}, "vertex");
            ASSERT_TRUE(made.ok()) << name;
            const int loops = expect_nothing_left_in_loops(linked_stages(made, ir::StageKind::Vertex), name, "vertex");
            EXPECT_EQ(loops, model.name == "unlit" ? 0 : 1) << name;
        }
    }
}

TEST(Hoisting, OfTheExamples) {
    int graphs = 0, loops = 0;
    for (const auto& file : std::filesystem::directory_iterator("examples/graphs")) {
        const std::string path = file.path().string();
        if (!path.ends_with(".graph.json")) continue;
        std::ifstream in(path, std::ios::binary);
        LoweredMaterial made(std::string(std::istreambuf_iterator<char>(in), {}), path);
        ASSERT_TRUE(made.ok()) << path;
        loops += expect_nothing_left_in_loops(linked_stages(made, ir::StageKind::Fragment), path);
        ++graphs;
    }
    EXPECT_GT(graphs, 9);
    EXPECT_GT(loops, 9);
}

// The search can fail: without one IR pass, it finds a computation in the loop or in a function that it calls.
TEST(Hoisting, TakesBothPasses) {
    const Compiler compiler;
    const ModelInfo& workflow = compiler.workflows().front();
    std::set<std::string> without_schedule, without_inlining;
    for (const ModelInfo& model : compiler.lighting_models()) {
        LoweredMaterial made(varying_material(model, workflow));
        ASSERT_TRUE(made.ok());
        for (auto& [pass, linked] : linked_stages(made, ir::StageKind::Fragment)) {
            if (pass != "forward") continue;
            const Module pruned = ir::specialise(ir::prune(std::move(linked)));
            if (!Search(ir::inline_calls(pruned)).run().empty()) without_schedule.insert(model.name);
            if (!Search(ir::schedule(pruned)).run().empty()) without_inlining.insert(model.name);
        }
    }
    for (const ModelInfo& model : compiler.lighting_models()) {
        // These read of the surface only what the pass has made before the loop, as it is.
        const bool is_plain = model.name == "lambert" || model.name == "half-lambert" || model.name == "unlit";
        EXPECT_EQ(without_schedule.contains(model.name), !is_plain) << model.name;
        EXPECT_EQ(without_inlining.contains(model.name), model.name != "unlit") << model.name;
    }
}

}  // namespace
}  // namespace patina::proof
