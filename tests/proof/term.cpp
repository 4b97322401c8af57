#include "proof/term.h"

#include <gtest/gtest.h>

#include "compiler/lower/declare.h"
#include "compiler/nodelang/embedded.h"
#include "compiler/nodelang/parse.h"
#include "compiler/writers/writers.h"

namespace patina::proof {

using nodelang::Expr;

const resolve::Library& library() {
    static const std::unique_ptr<resolve::Library> loaded =
        resolve::load_library(nodelang::embedded_files(), writers::printable());
    return *loaded;
}

namespace {

std::string words_of(const Diagnostics& diagnostics) {
    std::string text;
    for (const DiagnosticRecord& record : diagnostics.records()) text += record.message + "\n";
    return text;
}

}  // namespace

// A function of the inputs alone that calls `function` and gives back all that it gives.
Term::Term(const nodelang::FunctionDecl& function, const nodelang::Declarations& declarations,
           const std::map<std::string, std::string>& constants, Arithmetic arithmetic) {
    Diagnostics diagnostics;
    ir::Module module;
    emit::Emitter emitter{.module = module, .diagnostics = diagnostics, .options = {.fold = false}};
    lower::declare_engine(*library().engine({}), library().paths, library().declarations, emitter);
    ir::Function outer{};
    outer.name = "term";
    ir::Builder builder(module, outer, {.fold = false});
    emit::Scope scope{.builder = &builder, .declarations = &declarations, .generic_width = 3};
    nodelang::Ast ast;
    std::vector<const Expr*> arguments(function.params.size(), nullptr);
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const nodelang::ParamDecl& param = function.params[i];
        if (param.is_out) continue;
        if (param.is_const) {
            const auto given = constants.find(std::string(param.name));
            if (given == constants.end()) continue;
            arguments[i] = nodelang::parse_expression({.text = given->second}, ast, diagnostics);
            continue;
        }
        const ir::Type type = emit::type(emitter, param.type, scope);
        outer.params.push_back({std::string(param.name), type, ir::Rate::Pixel});
        const ir::Value value = builder.param(static_cast<std::uint32_t>(outer.params.size() - 1));
        scope.locals.push_back({.name = param.name, .value = {.value = value, .type = type}, .constant = {}});
        arguments[i] = &ast.exprs.emplace_back(Expr{.kind = Expr::Kind::Name, .text = param.name});
    }
    emit::Typed value = emit::call(emitter, function, declarations, arguments, scope, {}, arithmetic.half);
    if (!value.ok()) {
        ADD_FAILURE() << function.name << ": " << words_of(diagnostics);
        std::abort();
    }
    outer.result = value.type;
    builder.ret(value.value);
    module.functions.push_back(std::move(outer));
    for (const ir::Function& made : module.functions) {
        for (const ir::Inst& inst : made.insts) reads_globals_ |= inst.op == ir::Op::Global;
    }
    const ir::FunctionId id{static_cast<std::uint32_t>(module.functions.size() - 1)};
    machine_ = interpret::make_machine(module, id, arithmetic.precision);
}

Term Term::of(const std::string& text, Arithmetic arithmetic) {
    Diagnostics diagnostics;
    nodelang::Ast ast;
    nodelang::Declarations declarations;
    declarations.parent = &library().declarations;
    nodelang::parse_file({.text = text}, ast, diagnostics);
    nodelang::index_declarations(ast, declarations, diagnostics);
    if (diagnostics.error_count() > 0 || ast.functions.empty()) {
        ADD_FAILURE() << text << ": " << words_of(diagnostics);
        std::abort();
    }
    return Term(ast.functions.back(), declarations, {}, arithmetic);
}

Term Term::node(const nodelang::FunctionDecl& function, const std::map<std::string, std::string>& constants,
                Arithmetic arithmetic) {
    return Term(function, library().declarations, constants, arithmetic);
}

std::vector<double> Term::at(const std::vector<double>& arguments) {
    std::vector<double> result;
    each(
        1, [&](std::size_t, double* in) { std::copy(arguments.begin(), arguments.end(), in); },
        [&](std::size_t, const double* out) { result.assign(out, out + outputs()); });
    return result;
}

}  // namespace patina::proof
