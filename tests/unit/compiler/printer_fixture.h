// A module made by hand and what a printer makes of it: for the tests of the printers, not a test itself.
//
//   Fixture f({kFloat, kFloat});
//   EXPECT_EQ(f.glsl(f.b->emit(Op::Add, {f.b->param(0), f.b->param(1)})), "return a + b;\n");
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"
#include "compiler/languages/print.h"

namespace patina::languages {

using namespace ir;

// A module of one function f(a, b, c), or with whatever the test adds.
struct Fixture {
    Module module;
    Function function;
    std::unique_ptr<Builder> b;

    explicit Fixture(std::vector<Type> params = {kFloat, kFloat, kFloat}, bool fold = false) {
        function.name = "f";
        for (std::size_t i = 0; i < params.size(); ++i)
            function.params.push_back({std::string(1, "abcdefgh"[i]), params[i]});
        b = std::make_unique<Builder>(module, function, BuildOptions{.fold = fold});
    }
    Value named(Value v, std::string_view name) {
        b->name(v, module.intern(name));
        return v;
    }
    Value number(double value) { return b->constant(kFloat, {value}); }
    GlobalId global(std::string name, Type type) {
        module.globals.push_back({.name = std::move(name), .type = type, .place = {.set = 1}, .span = {}});
        return {static_cast<std::uint32_t>(module.globals.size() - 1)};
    }
    Value read(GlobalId id) { return b->emit(Op::Global, module.globals[id.index].type, {}, id.index); }

    void finish(Value result) {
        function.result = result ? b->type(result) : Type::none();
        b->ret(result);
        module.functions.push_back(function);
        EXPECT_EQ(verify(module), "");
    }
    std::string print(std::string_view target, const PrintOptions& options = {}) {
        const LanguageInfo* info = find_language(target);
        const Module legal = info->legalize(module).value_or(module);
        EXPECT_EQ(verify(legal), "");
        return info->print(legal, options).text;
    }
    // The lines of the last function's body, without their indent.
    std::string body(std::string_view target) {
        const std::string text = print(target);
        const std::size_t begin = text.rfind("\n{\n") + 3;
        std::string lines;
        for (std::size_t at = begin; at < text.size();) {
            const std::size_t end = text.find('\n', at);
            std::string line = text.substr(at, end - at);
            if (line == "}") break;
            lines += (line.starts_with("    ") ? line.substr(4) : line) + "\n";
            at = end + 1;
        }
        return lines;
    }
    std::string glsl(Value result) {
        finish(result);
        return body("glsl");
    }
    // Makes it a fragment stage whose output is the float4.
    void make_stage(Value color, std::vector<StageVariable> inputs, StageKind kind = StageKind::Fragment) {
        module.structs.push_back({"Targets", {{"color", kFloat4}}});
        const Type targets = Type::structure(static_cast<std::uint32_t>(module.structs.size() - 1));
        finish(b->construct(targets, std::span<const Value>(&color, 1)));
        const Builtin builtin = kind == StageKind::Vertex ? Builtin::Position : Builtin::None;
        module.stage = {.kind = kind,
                        .entry = {static_cast<std::uint32_t>(module.functions.size() - 1)},
                        .inputs = std::move(inputs),
                        .outputs = {{.name = "color", .type = kFloat4, .builtin = builtin, .semantic = ""}}};
    }
};

inline bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

struct SurfaceFixture : Fixture {
    Type surface;
    SurfaceFixture() : Fixture({kFloat3, kFloat, kBool}) {
        module.structs.push_back({"Surface", {{"baseColor", kFloat3}, {"metallic", kFloat}}});
        surface = Type::structure(0);
    }
    Value made(double metallic) {
        const Value parts[] = {b->param(0), number(metallic)};
        return b->construct(surface, parts);
    }
};

}  // namespace patina::languages
