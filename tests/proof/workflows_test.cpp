// One surface described in two ways: metallic and roughness, or specular colour and glossiness. Pairs that convert
// exactly give the same light in double, and the same picture through GLSL and through HLSL. Models with Unity's
// grazing term are the exception: Unity's two set-ups reflect the surroundings differently, and so do these models.
#include <gtest/gtest.h>

#include <fstream>

#include "proof/quadrature.h"
#include "runtime/lighting/model.h"
#include "runtime/picture/compare.h"
#include "runtime/render/render_request.h"

namespace patina::proof {
namespace {

using runtime::Model;
using runtime::Triple;
using Words = std::vector<std::pair<std::string, std::string>>;

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

std::string words(const Triple& color) {
    char text[100];
    std::snprintf(text, sizeof text, "%.17g,%.17g,%.17g", color[0], color[1], color[2]);
    return text;
}

// A metallic surface, and the same in specular terms: f0 is mixed of 0.04 and the base colour, and the diffuse colour
// that the specular workflow will scale by one minus its strongest channel is given undone.
struct Pair {
    const char* name;
    Triple base;
    double metallic, roughness;

    Triple specular() const {
        Triple f0{};
        for (std::size_t c = 0; c < 3; ++c) f0[c] = 0.04 * (1 - metallic) + base[c] * metallic;
        return f0;
    }
    // `share`: what a dielectric scatters of its base colour.
    Triple diffuse(double share) const {
        const Triple f0 = specular();
        const double rest = 1 - std::max({f0[0], f0[1], f0[2]});
        Triple color{};
        for (std::size_t c = 0; c < 3 && metallic < 1; ++c) color[c] = share * (1 - metallic) * base[c] / rest;
        return color;
    }
    Words metallic_words() const {
        return {{"baseColor", words(base)},
                {"metallic", std::to_string(metallic)},
                {"roughness", std::to_string(roughness)}};
    }
    Words specular_words(double share) const {
        return {{"baseColor", words(diffuse(share))},
                {"specular", words(specular())},
                {"glossiness", std::to_string(1 - roughness)}};
    }
};

constexpr Pair kPairs[] = {
    {"plastic", {0.8, 0.4, 0.1}, 0, 0.3},
    {"gold", {1, 0.77, 0.34}, 1, 0.4},
    {"worn paint", {0.6, 0.2, 0.7}, 0.5, 0.5},
    {"dust on steel", {0.5, 0.5, 0.45}, 0.9, 0.7},
    {"white", {1, 1, 1}, 0.25, 1},
    {"black", {0, 0, 0}, 0, 0.1},
};

std::vector<std::string> lit_models() {
    std::vector<std::string> names;
    for (const ModelInfo& model : compiler().lighting_models()) {
        if (model.name != "unlit" && model.name != "merl") names.push_back(model.name);
    }
    return names;
}

// Unity's set-up leaves a dielectric 0.96 of its base colour; glTF takes no share but Fresnel's.
double diffuse_share(const std::string& model) {
    return model == "gltf" ? 1 : 0.96;
}

// Models whose reflection of the surroundings reads oneMinusReflectivity, which the two workflows define differently.
bool has_grazing_term(const std::string& model) {
    return model.starts_with("unity-brdf") || model == "cl-pbr-specular";
}

// The largest relative difference of one pair under one model, over directions.
double difference(const std::string& model, const Pair& pair, const runtime::ModelLight& light) {
    static const Sequence points(4);
    Words by_metallic = pair.metallic_words(), by_specular = pair.specular_words(diffuse_share(model));
    // By default it reflects a picture of its own.
    if (model == "cl-pbr-specular") {
        by_metallic.emplace_back("_Surroundings", "Scene");
        by_specular.emplace_back("_Surroundings", "Scene");
    }
    Model metallic(compiler(), {.model = model, .values = by_metallic});
    Model specular(compiler(), {.model = model, .workflow = "specular-glossiness", .values = by_specular});
    if (!metallic.ok() || !specular.ok()) return INFINITY;
    double worst = 0;
    for (std::size_t i = 0; i < 60; ++i) {
        const runtime::ModelPoint point{.l = on_hemisphere(points(i, 0), points(i, 1)),
                                        .v = on_hemisphere(points(i, 2), points(i, 3))};
        const Triple a = metallic.color(point, light), b = specular.color(point, light);
        for (std::size_t c = 0; c < 3; ++c)
            worst = std::max(worst, std::abs(a[c] - b[c]) / std::max({1e-3, std::abs(a[c]), std::abs(b[c])}));
    }
    return worst;
}

TEST(Workflows, GiveTheSameLight) {
    for (const std::string& name : lit_models()) {
        double worst = 0;
        for (const Pair& pair : kPairs) {
            runtime::ModelLight light{.ambient = {0.7, 0.8, 0.9}, .environment = {0.4, 0.3, 0.2}};
            if (has_grazing_term(name)) light.environment = {};
            const double off = difference(name, pair, light);
            EXPECT_LE(off, 1e-6) << name << ", " << pair.name;
            worst = std::max(worst, off);
        }
        std::printf("%-24s differs by at most %.1e\n", name.c_str(), worst);
    }
}

// What UnityStandardCore.cginc computes: SpecularSetup sets oneMinusReflectivity = 1 - max(specular), and BRDF1
// reflects the surroundings by surfaceReduction * FresnelLerp(specular, grazingTerm, nv).
double unity_reflection(double specular, double strongest, double smoothness, double nv) {
    const double roughness = std::max((1 - smoothness) * (1 - smoothness), 0.002);
    const double grazing = std::min(smoothness + strongest, 1.0);
    return (specular + (grazing - specular) * std::pow(1 - nv, 5)) / (roughness * roughness + 1);
}

TEST(Workflows, SpecularSetupReflectsAsUnitys) {
    const Triple speculars[] = {{0.56, 0.57, 0.58}, {0.3, 0.2, 0.1}, {0.04, 0.04, 0.04}, {0, 0, 0}, {1, 0.5, 0.25}};
    for (const Triple& specular : speculars) {
        const double strongest = std::max({specular[0], specular[1], specular[2]});
        for (const double smoothness : {0.0, 0.2, 0.5, 0.9, 1.0}) {
            Model model(compiler(), {.model = "unity-brdf1",
                                     .workflow = "specular-glossiness",
                                     .values = {{"baseColor", "0,0,0"},
                                                {"specular", words(specular)},
                                                {"glossiness", std::to_string(smoothness)}}});
            ASSERT_TRUE(model.ok());
            for (const double nv : {0.05, 0.2, 0.7, 1.0}) {
                const runtime::ModelPoint point{.v = {std::sqrt(1 - nv * nv), 0, nv}};
                const Triple seen = model.color(point, {.light = {0, 0, 0}, .environment = {1, 1, 1}});
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(seen[c], unity_reflection(specular[c], strongest, smoothness, nv), 1e-9);
            }
        }
    }
    // Figures for iron and a coloured plastic, glossiness 0.2, n.v 0.2.
    EXPECT_NEAR(unity_reflection(0.56, 0.58, 0.2, 0.2), 0.448, 0.0005);
    EXPECT_NEAR(unity_reflection(0.58, 0.58, 0.2, 0.2), 0.458, 0.0005);
    EXPECT_NEAR(unity_reflection(0.1, 0.3, 0.2, 0.2), 0.164, 0.0005);
}

// --- pictures

std::string graph_file(const std::string& name, const std::string& model, const std::string& workflow,
                       const Words& surface) {
    std::string inputs;
    for (const auto& [input, value] : surface) {
        const bool is_color = value.find(',') != std::string::npos;
        inputs += (inputs.empty() ? "" : ", ") + ("\"" + input + "\": ") + (is_color ? "[" + value + "]" : value);
    }
    const std::string path = testing::TempDir() + name + ".graph.json";
    std::ofstream(path) << R"({ "patina": 1, "workflow": ")" << workflow << R"(", "lighting": ")" << model
                        << R"(", "surface": { )" << inputs << " } }";
    return path;
}

runtime::Image picture(const std::string& graph, const std::string& via) {
    static runtime::RenderMachine machine;
    runtime::RenderRequest request{.graph = graph, .size = 64, .samples = 1, .options = {.via = via}};
    runtime::RenderOutcome outcome = runtime::render(compiler(), request, machine);
    EXPECT_TRUE(outcome.ok) << graph << ": " << outcome.error;
    runtime::encode_srgb(outcome.image);
    return runtime::quantized(outcome.image);
}

// One through GLSL, the other through HLSL.
void expect_same_pictures(const std::string& model, const Pair& pair) {
    const std::string a = graph_file("metallic", model, "metallic-roughness", pair.metallic_words());
    const std::string b =
        graph_file("specular", model, "specular-glossiness", pair.specular_words(diffuse_share(model)));
    const runtime::Comparison comparison = runtime::compare(picture(a, "glsl"), picture(b, "hlsl"), 1.0 / 255);
    EXPECT_TRUE(comparison.same_size);
    EXPECT_LE(comparison.largest, 1.001 / 255) << model << ", " << pair.name;
}

TEST(Workflows, GiveTheSamePicture) {
    for (const Pair& pair : kPairs) expect_same_pictures("cook-torrance", pair);
    for (const std::string& model : lit_models()) {
        if (!kSanitized && !has_grazing_term(model)) expect_same_pictures(model, kPairs[2]);
    }
    // Without metal, both set-ups of Unity have the same oneMinusReflectivity.
    expect_same_pictures("unity-brdf1", kPairs[0]);
}

}  // namespace
}  // namespace patina::proof
