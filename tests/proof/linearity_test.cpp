// What of each lighting model is linear in what: the diffuse colour of the surface, the surroundings, the sum of the
// lights. Rendering paths stand on it that multiply by one of them elsewhere. Which models are is known from their
// formulas; that the linear part is the right one is shown by evaluating the functions with and without.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "compiler/interpret/interpret.h"
#include "compiler/ir/linear/linear_part.h"
#include "compiler/ir/verify.h"
#include "proof/lowered.h"
#include "proof/term.h"

namespace patina::proof {
namespace {

using interpret::Flat;
using ir::FunctionId;
using ir::LinearPart;
using ir::Seed;

constexpr const char* kWorkflow = "metallic-roughness";

// A model by its formula: is `direct` a multiple of the diffuse colour plus the rest, or does it not read that colour;
// and what becomes of it if the base colour takes that place.
struct Formula {
    bool has_diffuse_color = false;
    bool is_linear_in_base_color = true;
    bool has_environment = true;  // mirrors it
};
const std::map<std::string, Formula> kFormulas = {
    {"blinn-phong", {.has_diffuse_color = true}},
    {"cl-pbr-specular", {.has_diffuse_color = true}},
    {"cook-torrance", {.has_diffuse_color = true}},
    // Its sheen and its tints are off, and nothing else reads the hue, for which the brightness divides.
    {"disney-principled", {}},
    // The base colour is f0 as well, and (1 - F) base colour has its square.
    {"energy-conserving", {.is_linear_in_base_color = false}},
    {"gltf", {.is_linear_in_base_color = false}},
    {"half-lambert", {.has_diffuse_color = true, .has_environment = false}},
    {"lambert", {.has_diffuse_color = true, .has_environment = false}},
    {"merl", {.has_environment = false}},
    {"openpbr", {.is_linear_in_base_color = false}},
    {"pbr-direct-indirect", {}},
    {"phong", {.has_diffuse_color = true}},
    {"toon", {.has_environment = false}},
    {"unity-brdf1", {.has_diffuse_color = true}},
    {"unity-brdf2", {.has_diffuse_color = true}},
    {"unity-brdf3", {.has_diffuse_color = true}},
    {"unlit", {.has_environment = false}},
};

// Semantics are what a pass gives; here each is a number.
void settle_semantics(ir::Module& module, std::mt19937& random) {
    std::uniform_real_distribution<double> number(0.1, 0.9);
    std::map<std::uint32_t, std::uint32_t> constants;
    for (ir::Function& function : module.functions) {
        for (ir::Inst& inst : function.insts) {
            if (inst.op != ir::Op::Semantic) continue;
            const auto [found, is_new] =
                constants.try_emplace(inst.data, static_cast<std::uint32_t>(module.constants.size()));
            if (is_new) {
                module.constants.push_back({inst.type, static_cast<std::uint32_t>(module.numbers.size())});
                for (unsigned i = 0; i < inst.type.components(); ++i) module.numbers.push_back(number(random));
            }
            inst.op = ir::Op::Constant;
            inst.data = found->second;
        }
    }
}

Flat evaluate(const ir::Module& module, FunctionId function, const std::vector<Flat>& arguments) {
    interpret::Resources resources;
    for (const ir::Global& global : module.globals) {
        Flat& values = resources.uniforms.emplace_back();
        if (!global.type.is_opaque()) values.assign(interpret::flat_size(module, global.type), 0.3);
    }
    resources.textures.resize(module.globals.size());  // unbound: white
    return interpret::run(module, function, {arguments, arguments, arguments, arguments}, resources, Precision::Double)
        .lanes[0];
}

FunctionId push(ir::Module& module, ir::Function function) {
    module.functions.push_back(std::move(function));
    EXPECT_EQ(ir::verify(module), "");
    return {static_cast<std::uint32_t>(module.functions.size() - 1)};
}

// Any numbers are good enough for a surface, a light and a sum: linearity does not ask what they mean.
std::vector<Flat> arguments_of(const ir::Module& module, FunctionId function, std::mt19937& random) {
    std::uniform_real_distribution<double> number(0.1, 0.9);
    std::vector<Flat> arguments;
    for (const ir::Param& param : module[function].params) {
        Flat& values = arguments.emplace_back(interpret::flat_size(module, param.type));
        for (double& value : values) value = number(random);
    }
    return arguments;
}

// f(x) = A x + f without x, where that is f(0).
void expect_affine(ir::Module& module, FunctionId f, const Seed& seed, const LinearPart& part, bool fold,
                   const std::string& text) {
    ASSERT_TRUE(part.function) << text << ": " << part.reason;
    const FunctionId linear = push(module, *part.function);
    const FunctionId rest = push(module, ir::without(module, f, seed, {.fold = fold}));
    const double tolerance = fold ? 1e-6 : 1e-9;  // constants that are folded are rounded to float
    std::mt19937 random(1);
    for (int i = 0; i < 20; ++i) {
        const std::vector<Flat> arguments = arguments_of(module, f, random);
        const Flat whole = evaluate(module, f, arguments), a = evaluate(module, linear, arguments),
                   b = evaluate(module, rest, arguments);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(a[c] + b[c], whole[c], tolerance * (1e-3 + std::abs(a[c]) + std::abs(b[c]))) << text;
        if (seed.callee) continue;
        std::uint32_t first = 0;  // of x among the parameter's components
        const ir::Type type = module[f].params[seed.param].type;
        for (std::uint32_t m = 0; m < seed.member; ++m)
            first += static_cast<std::uint32_t>(interpret::flat_size(module, ir::part_type(module, type, m)));
        std::vector<Flat> at_zero = arguments;
        for (std::uint32_t c = 0; c < 3; ++c) at_zero[seed.param][first + c] = 0;
        const Flat zero = evaluate(module, f, at_zero);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(b[c], zero[c], tolerance * (1e-3 + std::abs(zero[c]))) << text;
    }
}

TEST(Linearity, KnowsEveryModel) {
    std::set<std::string> models, known;
    for (const auto& [name, graph] : library().lighting_models) models.insert(name);
    for (const auto& [name, formula] : kFormulas) known.insert(name);
    EXPECT_EQ(models, known);
}

TEST(Linearity, OfDirectInTheDiffuseColor) {
    for (const auto& [name, formula] : kFormulas) {
        for (const bool fold : {true, false}) {
            LoweredMaterial made(material_of(name, kWorkflow), "proof.graph.json", {.fold = fold});
            ASSERT_TRUE(made.ok());
            std::mt19937 random(7);
            settle_semantics(made.module(), random);
            const FunctionId direct = made.slot("direct");
            const Seed seed = Seed::of_member(0, made.surface_member("diffuseColor"));
            const ir::LinearOptions options{.componentwise = true, .build = {.fold = fold}};
            const LinearPart part = linear_part(made.module(), direct, seed, options);
            EXPECT_EQ(part.depends, formula.has_diffuse_color) << name;
            expect_affine(made.module(), direct, seed, part, fold, name);
        }
    }
}

TEST(Linearity, OfDirectInTheBaseColor) {
    for (const auto& [name, formula] : kFormulas) {
        LoweredMaterial made(material_of(name, kWorkflow));
        const Seed seed = Seed::of_member(0, made.surface_member("baseColor"));
        const LinearPart part = linear_part(made.module(), made.slot("direct"), seed, {.componentwise = true});
        EXPECT_EQ(part.function.has_value(), formula.is_linear_in_base_color) << name << ": " << part.reason;
        if (part.function) continue;
        // It is said where in the lighting graph.
        ASSERT_TRUE(part.origin) << name;
        EXPECT_GT(made.module().origins[part.origin.index].span.end, 0u) << name;
    }
}

TEST(Linearity, OfIndirectInTheSurroundings) {
    int models = 0;
    for (const auto& [name, formula] : kFormulas) {
        for (const bool fold : {true, false}) {
            LoweredMaterial made(material_of(name, kWorkflow), "proof.graph.json", {.fold = fold});
            std::mt19937 random(7);
            settle_semantics(made.module(), random);
            const FunctionId environment = made.function("EnvironmentRadiance");
            EXPECT_EQ(static_cast<bool>(environment), formula.has_environment) << name;
            if (!environment) continue;
            const Seed seed = Seed::of_calls(environment);
            const FunctionId indirect = made.slot("indirect");
            const ir::LinearOptions options{.componentwise = true, .build = {.fold = fold}};
            const LinearPart part = linear_part(made.module(), indirect, seed, options);
            expect_affine(made.module(), indirect, seed, part, fold, name);
            models += part.depends ? 1 : 0;
        }
    }
    EXPECT_GE(models, 18);
}

TEST(Linearity, OfFinalInTheSumOfTheLights) {
    for (const auto& [name, formula] : kFormulas) {
        for (const bool fold : {true, false}) {
            LoweredMaterial made(material_of(name, kWorkflow), "proof.graph.json", {.fold = fold});
            const FunctionId final = made.slot("final");
            const Seed seed = Seed::of_member(1, 0);
            const ir::LinearOptions options{.componentwise = true, .build = {.fold = fold}};
            const LinearPart part = linear_part(made.module(), final, seed, options);
            EXPECT_TRUE(part.depends) << name;
            expect_affine(made.module(), final, seed, part, fold, name);
        }
    }
}

// What such a `final` makes of two lights is not the sum of what it makes of each.
TEST(Linearity, ToneMappingInFinalIsNotLinear) {
    const std::string text = R"json({ "patina": 1, "workflow": "metallic-roughness", "surface": {}, "lighting": {
        "patina": 1, "kind": "lighting", "name": "Tone mapped",
        "nodes": [ { "id": "bright", "expr": "@sum.direct + @sum.indirect" },
                   { "id": "mapped", "expr": "bright / (1 + bright)" } ],
        "direct": "= @surface.diffuseColor * @light.radiance",
        "final": "= mapped + @surface.emission" } })json";
    LoweredMaterial made(text);
    ASSERT_TRUE(made.ok());
    const LinearPart part = linear_part(made.module(), made.slot("final"), Seed::of_member(1, 0));
    EXPECT_FALSE(part.function);
    EXPECT_EQ(part.reason, "'div' is not linear");
    ASSERT_TRUE(part.origin);
    EXPECT_EQ(made.module().origins[part.origin.index].id, "mapped");
}

TEST(Linearity, MembersThatAModelReads) {
    const auto members = [](LoweredMaterial& made, std::string_view slot) {
        std::set<std::string> names;
        const ir::Module& module = made.module();
        const FunctionId function = made.slot(slot);
        for (const ir::MemberRead& read : members_read(module, function, 0))
            names.insert(module.structs[module[function].params[0].type.ref].members[read.member].name);
        return names;
    };
    LoweredMaterial lambert(material_of("lambert", kWorkflow));
    EXPECT_EQ(members(lambert, "direct"), (std::set<std::string>{"diffuseColor", "normalWS"}));
    EXPECT_EQ(members(lambert, "indirect"), (std::set<std::string>{"diffuseColor", "normalWS", "occlusion"}));
    EXPECT_EQ(members(lambert, "final"), (std::set<std::string>{"emission"}));
    // Smoothness is a member function of the surface, that reads the roughness.
    LoweredMaterial plain(material_of("toon", kWorkflow));
    EXPECT_EQ(members(plain, "direct"), (std::set<std::string>{"baseColor", "roughness", "normalWS"}));
    // A model's own inputs are read where the material sets them.
    LoweredMaterial toon(R"json({ "patina": 1, "workflow": "metallic-roughness", "lighting": "toon", "surface": {
        "bands": 4, "bandSoftness": 0.1, "highlight": 1, "rim": 1, "rimWidth": 0.3 } })json");
    EXPECT_EQ(members(toon, "direct"), (std::set<std::string>{"baseColor", "roughness", "normalWS", "bands",
                                                              "bandSoftness", "highlight", "rim", "rimWidth"}));
}

}  // namespace
}  // namespace patina::proof
