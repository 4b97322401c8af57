#include "compiler/api/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "compiler/api/describe/describe.h"
#include "compiler/base/cancellation.h"
#include "compiler/base/text.h"
#include "compiler/interpret/interpret.h"
#include "compiler/link/check_reads.h"
#include "compiler/lower/declare.h"
#include "compiler/nodelang/parse.h"

namespace patina {

using emit::Typed;
using nodelang::Expr;

namespace {

// Outside a graph there is no mesh and no camera. So a port that would read them needs an argument, and an expression
// needs a name with a value.
class NoGraph : public emit::Environment {
public:
    enum class Asked { Node, Expression };
    NoGraph(Diagnostics& diagnostics, std::span<const NamedValue> names, Asked asked)
        : diagnostics_(diagnostics), names_(names), asked_(asked) {}
    Typed name(const Expr& expr, emit::Scope& scope) override {
        for (const NamedValue& named : names_) {
            if (named.name == expr.text && has_type(named)) return value_of(named, *scope.builder);
        }
        DiagnosticRecord& record = diagnostics_.report(Code::UnknownName, expr.span, "value", expr.text);
        if (asked_ == Asked::Expression) record.note(fmt::format("give it a value: {}=0.5", expr.text));
        return {};
    }
    Typed property(const Expr& expr, emit::Scope&) override {
        DiagnosticRecord& record = diagnostics_.report(Code::UnknownProperty, expr.span, expr.text);
        if (asked_ == Asked::Expression) record.note(kNameInstead);
        return {};
    }
    Typed semantic(std::string_view name, Span span, emit::Scope&) override {
        not_here(span, name)
            .note(asked_ == Asked::Expression
                      ? kNameInstead
                      : "give a value to every port whose default reads the mesh, the camera or a light");
        return {};
    }
    Typed file(const Expr& expr, emit::Scope&) override {
        not_here(expr.span, expr.text);
        return {};
    }

    bool hides(std::string_view name) const override {
        return std::any_of(names_.begin(), names_.end(), [&](const NamedValue& named) { return named.name == name; });
    }

private:
    static bool has_type(const NamedValue& named) {
        const std::size_t count = named.values.size();
        return named.is_matrix ? count == 4 || count == 9 || count == 16 : count >= 1 && count <= 4;
    }

    static Typed value_of(const NamedValue& named, ir::Builder& builder) {
        std::vector<ir::Value> parts;
        for (double value : named.values) parts.push_back(builder.constant(ir::kFloat, {value}));
        const auto count = static_cast<unsigned>(parts.size());
        if (count == 1) return {.value = parts[0], .type = ir::kFloat};
        const unsigned size = count == 4 ? 2 : count == 9 ? 3 : 4;  // of a matrix
        const ir::Type row = ir::Type::vector(ir::Scalar::Float, named.is_matrix ? size : count);
        if (!named.is_matrix) return {.value = builder.construct(row, parts), .type = row};
        std::vector<ir::Value> rows;
        for (unsigned i = 0; i < size; ++i)
            rows.push_back(builder.construct(row, std::span(parts).subspan(i * size, size)));
        const ir::Type type = ir::Type::matrix(ir::Scalar::Float, size, size);
        return {.value = builder.construct(type, rows), .type = type};
    }

    static constexpr const char* kNameInstead = "write a plain name for it, and give the name a value: x=0.5";

    DiagnosticRecord& not_here(Span span, std::string_view name) {
        return diagnostics_.report(
            Code::SemanticNotHere, span, name,
            asked_ == Asked::Expression ? "an expression outside of a graph" : "an evaluation of one node");
    }

    Diagnostics& diagnostics_;
    std::span<const NamedValue> names_;
    Asked asked_;
};

// To emit an expression takes as long as so many steps of the interpreter.
constexpr std::uint64_t kStepsOfAnExpression = 16;

struct Bench {
    ir::Module module;
    emit::Emitter emitter;
    ir::Function function{};
    ir::Builder builder;
    NoGraph environment;
    emit::Scope scope;

    Effort* effort;

    Bench(const EvaluationContext& context, Diagnostics& diagnostics, NoGraph::Asked asked)
        : emitter{.module = module,
                  .diagnostics = diagnostics,
                  .options = {.fold = false},
                  .growth = context.effort ? &context.effort->growth : nullptr},
          builder(module, function, {.fold = false}),
          environment(diagnostics, context.names, asked),
          effort(context.effort) {
        lower::declare_engine(*context.library.engine({}), context.library.paths, context.library.declarations,
                              emitter);
        function.name = "evaluate";
        scope.builder = &builder;
        scope.declarations = &context.declarations;
        scope.environment = &environment;
    }

    // False, with an error, for a value that only a renderer can provide.
    bool is_whole(Diagnostics& diagnostics, Span at) const {
        const auto read = [&](const ir::Function& made) {
            return std::find_if(made.insts.begin(), made.insts.end(),
                                [](const ir::Inst& inst) { return inst.op == ir::Op::Global; });
        };
        std::vector<const ir::Function*> functions = {&function};
        for (const ir::Function& made : module.functions) functions.push_back(&made);
        if (!link::has_no_foreign(diagnostics, module, "the interpreter", at)) return false;
        for (const ir::Function* made : functions) {
            const auto found = read(*made);
            if (found == made->insts.end()) continue;
            diagnostics.report(Code::SemanticNotHere, at, module.globals[found->data].name, "an evaluation of one node")
                .note("a renderer provides it: use `patina render --node`, `patina trace` or `patina eval --model`");
            return false;
        }
        return true;
    }

    // Runs the emitted code and returns the flattened value. `where`: what is run, for the error if it takes too long.
    std::vector<double> run(Typed value, Precision precision, Span where) {
        function.result = value.type;
        builder.ret(value.value);
        module.functions.push_back(std::move(function));
        interpret::Resources resources;
        resources.uniforms.resize(module.globals.size());
        for (std::size_t i = 0; i < module.globals.size(); ++i) {
            resources.uniforms[i].resize(interpret::flat_size(module, module.globals[i].type), 0);
        }
        resources.textures.resize(module.globals.size());
        const ir::FunctionId id{static_cast<std::uint32_t>(module.functions.size() - 1)};
        interpret::QuadResult result =
            interpret::run(module, id, {}, resources, precision, effort ? &effort->steps : nullptr);
        if (!result.is_whole) {
            emitter.diagnostics.report(Code::OverBudget, where, "steps of the interpreter", Effort::kMostSteps + 1,
                                       Effort::kMostSteps);
            throw Stopped{.is_reported = true};
        }
        return std::move(result.lanes[0]);
    }
};

// The loosest tolerance among the ops of all functions. Their errors do not cancel reliably.
void tolerance_of(const ir::Module& module, double& relative, double& absolute) {
    for (const ir::Function& function : module.functions) {
        for (const ir::Inst& inst : function.insts) {
            relative = std::max(relative, ir::info(inst.op).relative);
            absolute = std::max(absolute, ir::info(inst.op).absolute);
        }
    }
}

// Splits a value into outputs with types and names ("float3 out").
std::vector<EvalOutput> split_outputs(const ir::Module& module, const Typed& value, std::span<const double> flat) {
    std::vector<EvalOutput> outputs;
    if (!value.outputs) {
        outputs.push_back({.name = "out", .type = module.type_name(value.type), .values = {flat.begin(), flat.end()}});
        return outputs;
    }
    std::size_t at = 0;
    const ir::Struct& structure = module.structs[value.type.ref];
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const std::size_t size = interpret::flat_size(module, structure.members[i].type);
        const auto begin = flat.begin() + static_cast<std::ptrdiff_t>(at);
        outputs.push_back({.name = value.outputs->names[i],
                           .type = module.type_name(structure.members[i].type),
                           .values = {begin, begin + static_cast<std::ptrdiff_t>(size)}});
        at += size;
    }
    return outputs;
}

// Runs the code emitted for `value`, unless emitting failed.
Evaluation evaluated(Bench& bench, const Typed& value, Precision precision, Diagnostics& diagnostics, Span where) {
    Evaluation evaluation;
    if (!value.ok() || !bench.is_whole(diagnostics, where)) return evaluation;
    tolerance_of(bench.module, evaluation.relative, evaluation.absolute);
    const std::vector<double> flat = bench.run(value, precision, where);
    evaluation.outputs = split_outputs(bench.module, value, flat);
    evaluation.ok = true;
    return evaluation;
}

std::optional<std::vector<double>> constant(const EvaluationContext& context, const Expr& expr,
                                            std::optional<ir::Type> type, Diagnostics& diagnostics) {
    Bench bench(context, diagnostics, NoGraph::Asked::Node);
    Typed value =
        emit::primary(bench.emitter, emit::expression(bench.emitter, expr, bench.scope), bench.scope, expr.span);
    if (type) value = emit::convert(bench.emitter, value, *type, bench.scope, expr.span, "the value");
    if (!value.ok()) return {};
    return bench.run(value, Precision::Double, expr.span);
}

// An argument of a test's call, as numbers that a test can pass to a GPU.
std::optional<NodeTest::Argument> read_argument(const EvaluationContext& context, const nodelang::ParamDecl& param,
                                                const Expr& expr, Diagnostics& diagnostics) {
    NodeTest::Argument argument{.name = std::string(param.name), .type = {}, .values = {}, .enumerator = {}};
    if (context.declarations.enumeration(param.type.name)) {
        argument.type = param.type.name;
        argument.enumerator = expr.text;
        return argument;
    }
    Bench bench(context, diagnostics, NoGraph::Asked::Node);
    const Typed value =
        emit::primary(bench.emitter, emit::expression(bench.emitter, expr, bench.scope), bench.scope, expr.span);
    if (!value.ok()) return {};
    ir::Type type = value.type;
    if (param.type.name != "floatN") {
        type = emit::type(bench.emitter, param.type, bench.scope);
    } else if (type.scalar != ir::Scalar::Float) {
        type = type.with_scalar(ir::Scalar::Float);
    }
    argument.type = bench.module.type_name(type);
    std::optional<std::vector<double>> values = constant(context, expr, type, diagnostics);
    if (!values) return {};
    argument.values = std::move(*values);
    return argument;
}

std::optional<NodeTest> read_test(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                                  std::string_view line, std::uint32_t base, nodelang::Ast& ast,
                                  Diagnostics& diagnostics) {
    const Span span{base, base + static_cast<std::uint32_t>(line.size())};
    const auto refuse = [&](std::string_view why) {
        diagnostics.report(Code::BadTestLine, span, why);
        return std::nullopt;
    };
    const std::size_t equals = line.find("==");
    if (equals == std::string_view::npos) return refuse("it has no ==");
    std::string_view right = line.substr(equals + 2);
    const std::size_t within = right.find(" within ");
    std::optional<double> relative;
    if (within != std::string_view::npos) {
        std::string_view number = right.substr(within + 8);
        number = number.substr(0, number.find_last_not_of(' ') + 1);
        relative = read_number(number);
        if (!relative || !(*relative > 0 && std::isfinite(*relative)))
            return refuse(fmt::format("'within' needs a relative tolerance above 0, not '{}'", number));
        right = right.substr(0, within);
    }
    const auto offset = static_cast<std::uint32_t>(right.data() - line.data());
    const Expr* left_expr =
        nodelang::parse_expression({.text = line.substr(0, equals), .base = base}, ast, diagnostics);
    const Expr* right_expr = nodelang::parse_expression({.text = right, .base = base + offset}, ast, diagnostics);
    if (!left_expr || !right_expr) return {};
    NodeTest test{.node = std::string(function.name),
                  .text = std::string(line),
                  .file = {},
                  .arguments = {},
                  .output = "out",
                  .expected = {},
                  .actual = {}};
    const Expr* call = left_expr;
    if (call->kind == Expr::Kind::Member) {
        test.output = call->text;
        call = call->args[0];
    }
    if (call->kind != Expr::Kind::Call || call->text != function.name)
        return refuse("its left side is not a call of the node");
    std::vector<const Expr*> arguments(function.params.size(), nullptr);
    std::size_t next = 0;
    for (std::size_t i = 0; i < function.params.size() && next < call->args.size(); ++i) {
        if (!function.params[i].is_input()) continue;
        arguments[i] = call->args[next++];
        std::optional<NodeTest::Argument> argument =
            read_argument(context, function.params[i], *arguments[i], diagnostics);
        if (!argument) return {};
        test.arguments.push_back(std::move(*argument));
    }
    const Evaluation evaluation = evaluate_call(context, function, arguments, Precision::Double, diagnostics, span);
    if (!evaluation.ok) return {};
    const auto output = std::find_if(evaluation.outputs.begin(), evaluation.outputs.end(),
                                     [&](const EvalOutput& o) { return o.name == test.output; });
    if (output == evaluation.outputs.end()) return refuse("the node has no such output");
    const std::optional<std::vector<double>> expected = constant(context, *right_expr, {}, diagnostics);
    if (!expected) return {};
    test.actual = output->values;
    test.expected = *expected;
    if (test.expected.size() == 1) test.expected.resize(test.actual.size(), test.expected[0]);
    test.relative = relative.value_or(std::max(evaluation.relative, 1e-5));
    test.absolute = std::max(evaluation.absolute, 1e-6);
    const Position position = context.sources.resolve(base);
    test.file = position.file;
    test.line = position.line;
    return test;
}

}  // namespace

Evaluation evaluate_call(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                         std::span<const Expr* const> arguments, Precision precision, Diagnostics& diagnostics,
                         Span span) {
    Bench bench(context, diagnostics, NoGraph::Asked::Node);
    return evaluated(bench,
                     emit::call(bench.emitter, function, context.declarations, arguments, bench.scope, span, false),
                     precision, diagnostics, span);
}

Evaluation evaluate_expression(const EvaluationContext& context, const Expr& expr, Precision precision,
                               Diagnostics& diagnostics) {
    Bench bench(context, diagnostics, NoGraph::Asked::Expression);
    const Typed value = emit::expression(bench.emitter, expr, bench.scope);
    return evaluated(bench, emit::primary(bench.emitter, value, bench.scope, expr.span), precision, diagnostics,
                     expr.span);
}

void check_functions(const EvaluationContext& context, const nodelang::Ast& ast, Diagnostics& diagnostics,
                     std::size_t first) {
    ir::Module module;
    Growth growth{.most = Limits{}.instructions};
    emit::Emitter emitter{.module = module, .diagnostics = diagnostics, .options = {.fold = true}, .growth = &growth};
    lower::declare_engine(*context.library.engine({}), context.library.paths, context.library.declarations, emitter);
    for (std::size_t i = first; i < ast.functions.size(); ++i) {
        // A pass calls slots, which only a material fills.
        if (context.sources.file(ast.functions[i].span.begin).ends_with(".pass.hlsl")) continue;
        emit::check_function(emitter, ast.functions[i], context.declarations);
    }
}

std::vector<NodeTest> node_tests(const EvaluationContext& context, const nodelang::FunctionDecl& function,
                                 Diagnostics& diagnostics) {
    std::vector<NodeTest> tests;
    nodelang::Ast ast;
    for (const Doc::TestLine& line : read_doc(function.doc).tests) {
        std::optional<NodeTest> test =
            read_test(context, function, line.text, function.doc_begin + line.offset, ast, diagnostics);
        if (test) tests.push_back(std::move(*test));
        if (Effort* const effort = context.effort) {
            const std::uint64_t took = kStepsOfAnExpression * std::exchange(effort->growth.made, 0);
            effort->steps -= std::min(effort->steps, took);
        }
    }
    return tests;
}

}  // namespace patina
