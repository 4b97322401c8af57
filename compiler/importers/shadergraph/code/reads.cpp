#include "compiler/importers/shadergraph/code/reads.h"

#include <algorithm>

namespace patina::importers::shadergraph {
namespace {

using nodelang::Expr;
using nodelang::Stmt;

constexpr std::string_view kFunctions[] = {
    "abs",          "acos",        "all",       "any",     "asfloat",    "asin",        "asint",     "asuint",
    "atan",         "atan2",       "ceil",      "clamp",   "cos",        "cosh",        "countbits", "cross",
    "ddx",          "ddx_coarse",  "ddx_fine",  "ddy",     "ddy_coarse", "ddy_fine",    "degrees",   "determinant",
    "distance",     "dot",         "dst",       "exp",     "exp2",       "f16tof32",    "f32tof16",  "faceforward",
    "firstbithigh", "firstbitlow", "floor",     "fma",     "fmod",       "frac",        "frexp",     "fwidth",
    "isfinite",     "isinf",       "isnan",     "ldexp",   "length",     "lerp",        "lit",       "log",
    "log10",        "log2",        "mad",       "max",     "min",        "modf",        "mul",       "normalize",
    "pow",          "radians",     "rcp",       "reflect", "refract",    "reversebits", "round",     "rsqrt",
    "saturate",     "sign",        "sin",       "sincos",  "sinh",       "smoothstep",  "sqrt",      "step",
    "tan",          "tanh",        "transpose", "trunc"};

const Expr& root_of(const Expr& expr) {
    const Expr* root = &expr;
    while (root->kind == Expr::Kind::Member || root->kind == Expr::Kind::Index) root = root->args[0];
    return *root;
}

}  // namespace

void Reads::add(const nodelang::TypeName& type) {
    if (!type.name.empty()) words.push_back({.kind = Word::Kind::Type, .text = type.name});
    add(type.array_size);
}

void Reads::add(const Expr* expr) {
    if (!expr) return;
    const auto assign = [&](const Expr& target) {
        if (const Expr& root = root_of(target); root.kind == Expr::Kind::Name) assigned.insert(root.text);
    };
    if (expr->kind == Expr::Kind::Name) words.push_back({.kind = Word::Kind::Name, .text = expr->text});
    if (expr->kind == Expr::Kind::Assign || expr->kind == Expr::Kind::AssignLater) assign(*expr->args[0]);
    if (expr->kind == Expr::Kind::Call) {
        words.push_back({.kind = Word::Kind::Call, .text = expr->text, .arguments = expr->args.size()});
        for (const Expr* arg : expr->args) assign(*arg);
    }
    for (const Expr* arg : expr->args) add(arg);
}

void Reads::add(const nodelang::Statements& list) {
    for (const Stmt* stmt : list) {
        add(stmt->type);
        if (stmt->kind == Stmt::Kind::Declare) declared.insert(stmt->name);
        if (const Expr* target = stmt->target; target && root_of(*target).kind == Expr::Kind::Name)
            assigned.insert(root_of(*target).text);
        for (const Expr* each : {stmt->target, stmt->value, stmt->limit}) add(each);
        for (const nodelang::Statements* each : {&stmt->body, &stmt->alternative, &stmt->step}) add(*each);
    }
}

void Reads::add(const nodelang::FunctionDecl& function) {
    for (const nodelang::ParamDecl& param : function.params) {
        declared.insert(param.name);
        add(param.type);
        add(param.initial);
    }
    add(function.result);
    add(function.body);
}

bool is_of_hlsl(std::string_view word) {
    for (const std::string_view scalar : {"float", "half", "int", "uint", "bool", "double"})
        if (word.starts_with(scalar)) return word.substr(scalar.size()).find_first_not_of("1234x") == word.npos;
    return word == "void" || word.starts_with("Texture") || word.starts_with("Sampler") ||
           std::ranges::find(kFunctions, word) != std::end(kFunctions);
}

}  // namespace patina::importers::shadergraph
