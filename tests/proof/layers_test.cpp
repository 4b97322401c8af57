// The layers of the gltf model: each equals its closed form from the extension's specification, written once more in
// plain C++; each keeps the energy that its specification keeps; and a layer that a material does not use costs
// nothing.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <regex>
#include <span>
#include <sstream>
#include <string>

#include "patina/patina.h"
#include "proof/hemisphere.h"
#include "runtime/lighting/model.h"

namespace patina::proof {
namespace {

using runtime::Model;
using runtime::Triple;
using Words = std::vector<std::pair<std::string, std::string>>;

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

Model model_of(Words values) {
    return Model(compiler(), {.model = "gltf", .values = std::move(values)});
}

// What a light adds. Without it, a surface that lets light pass shows what is behind it, which is white here.
Triple light_adds(Model& model, const Direction& l, const Direction& v) {
    Triple sum = model.direct({.l = l, .v = v});
    const Triple rest = model.color({.l = l, .v = v}, {.light = {0, 0, 0}});
    for (std::size_t c = 0; c < 3; ++c) sum[c] -= rest[c];
    return sum;
}

// --- closed forms, at a normal along z and a tangent along x

double fifth(double cosine) {
    return std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}
double schlick(double f0, double cosine, double f90 = 1) {
    return f0 + (f90 - f0) * fifth(cosine);
}
Direction half_of(const Direction& a, const Direction& b) {
    Direction h{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const double length = std::sqrt(dot(h, h));
    for (double& c : h) c /= length;
    return h;
}
// GGX of two widths; Smith's joint visibility (Heitz 2014). For one width, both are the round ones.
double lobe(const Direction& l, const Direction& v, double along, double across) {
    const Direction h = half_of(l, v);
    const double spread = std::pow(h[0] / along, 2) + std::pow(h[1] / across, 2) + h[2] * h[2];
    const auto length = [&](const Direction& w) {
        return std::sqrt(std::pow(along * w[0], 2) + std::pow(across * w[1], 2) + w[2] * w[2]);
    };
    const double visibility = 0.5 / (l[2] * length(v) + v[2] * length(l));
    return visibility * l[2] / (along * across * spread * spread);
}

struct Lit {
    Direction l, v;
    Direction h = half_of(l, v);
    double lh = dot(l, h);
};
constexpr double kBase = 0.6, kAlpha = 0.36;
// The core model: white light, a grey base, roughness 0.6.
double core(const Lit& d, double f0 = 0.04, double f90 = 1, double diffuse = kBase) {
    const double fresnel = schlick(f0, d.lh, f90);
    return (1 - fresnel) * diffuse * d.l[2] + fresnel * lobe(d.l, d.v, kAlpha, kAlpha);
}
double clear_coat(const Lit& d) {
    const double share = 0.7 * schlick(0.04, d.v[2]);
    return core(d) * (1 - share) + share * lobe(d.l, d.v, 0.09, 0.09);
}
double lambda(double cosine, double alpha) {
    const double t = (1 - alpha) * (1 - alpha);
    const auto mixed = [&](double at_1, double at_0) { return at_1 * (1 - t) + at_0 * t; };
    const auto curve = [&](double x) {
        return mixed(21.5473, 25.3245) / (1 + mixed(3.82987, 3.32435) * std::pow(x, mixed(0.19823, 0.16801))) +
               mixed(-1.9776, -1.27393) * x + mixed(-4.32054, -4.85967);
    };
    return std::exp(cosine < 0.5 ? curve(cosine) : 2 * curve(0.5) - curve(1 - cosine));
}
double charlie(const Lit& d, double alpha) {
    const double sine = std::sqrt(1 - d.h[2] * d.h[2]);
    const double distribution = (2 + 1 / alpha) * std::pow(sine, 1 / alpha) / (2 * kPi);
    return distribution / ((1 + lambda(d.l[2], alpha) + lambda(d.v[2], alpha)) * 4 * d.l[2] * d.v[2]);
}
// The share of the base is a fit, so what remains of it is taken from the share at another light.
double specular(const Lit& d) {
    return core(d, std::min(std::pow((1.8 - 1) / (1.8 + 1), 2) * 0.5, 1.0) * 0.6, 0.6);
}
double all_reflected(const Lit& d) {
    return core(d, 0.3);  // ior 0: f0 is the specular colour
}
double stretched(const Lit& d) {
    return schlick(0.04, d.lh) * lobe(d.l, d.v, kAlpha + (1 - kAlpha) * 0.49, kAlpha) +
           (1 - schlick(0.04, d.lh)) * kBase * d.l[2];
}
double half_diffuse(const Lit& d) {
    return core(d, 0.04, 1, kBase * 0.75);
}
double half_clear(const Lit& d) {
    return core(d, 0.04, 1, kBase * 0.6);
}

struct Case {
    const char* name;
    Words words;
    double (*direct)(const Lit&);
};
const Case kCases[] = {
    {"core", {}, [](const Lit& d) { return core(d); }},
    {"clearcoat", {{"clearcoat", "0.7"}, {"clearcoatRoughness", "0.3"}}, clear_coat},
    {"specular", {{"specularFactor", "0.6"}, {"specularColor", "0.5,0.5,0.5"}, {"ior", "1.8"}}, specular},
    {"ior0", {{"specularColor", "0.3,0.3,0.3"}, {"ior", "0"}}, all_reflected},
    {"anisotropy", {{"anisotropy", "0.7"}}, stretched},
    {"anisotropyAcross",
     {{"anisotropy", "0.7"}, {"anisotropyDirection", "0,1"}},
     [](const Lit& d) {
         return stretched({{d.l[1], -d.l[0], d.l[2]}, {d.v[1], -d.v[0], d.v[2]}});
     }},
    {"diffuseTransmission", {{"diffuseTransmission", "0.25"}}, half_diffuse},
    {"transmission", {{"transmission", "0.4"}}, half_clear},
};

class Layer : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Gltf, Layer, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST_P(Layer, EqualsItsClosedForm) {
    Words words = {{"baseColor", "0.6,0.6,0.6"}, {"roughness", "0.6"}};
    words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
    Model model = model_of(words);
    ASSERT_TRUE(model.ok()) << to_text(model.diagnostics().at(0));
    const Sequence points(4);
    for (std::size_t i = 0; i < 300; ++i) {
        const Lit d{on_hemisphere(0.02 + 0.98 * points(i, 0), points(i, 1)),
                    on_hemisphere(0.02 + 0.98 * points(i, 2), points(i, 3))};
        if (dot(d.l, d.v) < -0.95) continue;  // the half vector is limited there
        const double expected = GetParam().direct(d);
        ASSERT_NEAR(light_adds(model, d.l, d.v)[1], expected, 1e-9 * std::max(expected, 1.0)) << i;
    }
}

// A black base shows the fibres alone; against it, a lit base shows what they leave, which is the same for all lights.
TEST(Layers, SheenEqualsItsClosedForm) {
    for (const double roughness : {0.2, 0.5, 1.0}) {
        const Words fibres = {{"baseColor", "0,0,0"},
                              {"specularFactor", "0"},
                              {"sheenColor", "0.2,0.8,0.5"},
                              {"sheenRoughness", std::to_string(roughness)}};
        Words cloth = fibres;
        cloth[0] = {"baseColor", "1,1,1"};
        Model alone = model_of(fibres), over = model_of(cloth);
        const Sequence points(4);
        for (std::size_t i = 0; i < 100; ++i) {
            const Lit d{on_hemisphere(0.05 + 0.95 * points(i, 0), points(i, 1)),
                        on_hemisphere(0.05 + 0.95 * points(i, 2), points(i, 3))};
            if (dot(d.l, d.v) < -0.95) continue;
            const double expected = kPi * charlie(d, roughness * roughness) * d.l[2];
            const Triple seen = alone.direct({.l = d.l, .v = d.v});
            EXPECT_NEAR(seen[0], 0.2 * expected, 1e-9);
            EXPECT_NEAR(seen[1], 0.8 * expected, 1e-9);
            EXPECT_NEAR(seen[2], 0.5 * expected, 1e-9);
            const double left = (over.direct({.l = d.l, .v = d.v})[1] - seen[1]) / d.l[2];
            const double above =
                over.direct({.l = {0, 0, 1}, .v = d.v})[1] - alone.direct({.l = {0, 0, 1}, .v = d.v})[1];
            EXPECT_NEAR(left, above, 1e-9);
            EXPECT_LE(left, 1);
        }
    }
}

// Behind a translucent sheet is Lambert's light; behind a pane is the highlight that a mirrored light would have.
TEST(Layers, LightFromBehindPasses) {
    Model sheet = model_of({{"baseColor", "1,1,1"},
                            {"specularFactor", "0"},
                            {"diffuseTransmission", "0.25"},
                            {"diffuseTransmissionColor", "1,0.5,0"},
                            {"thickness", "2"},
                            {"attenuationDistance", "1"},
                            {"attenuationColor", "0.5,0.5,0.5"}});
    Model pane = model_of({{"baseColor", "0.5,1,0"}, {"roughness", "0.6"}, {"transmission", "0.8"}});
    const Sequence points(4);
    for (std::size_t i = 0; i < 100; ++i) {
        const Direction l = on_hemisphere(0.02 + 0.98 * points(i, 0), points(i, 1));
        const Direction v = on_hemisphere(0.02 + 0.98 * points(i, 2), points(i, 3));
        const Direction behind{l[0], l[1], -l[2]};
        const Triple through = sheet.direct({.l = behind, .v = v});
        // 0.25 of the light, a quarter of it after two metres.
        EXPECT_NEAR(through[0], 0.25 * 0.25 * l[2], 1e-9);
        EXPECT_NEAR(through[1], 0.25 * 0.25 * 0.5 * l[2], 1e-9);
        EXPECT_NEAR(through[2], 0, 1e-9);

        const Direction h = half_of(l, v);
        const double a2 = kAlpha * kAlpha, spread = h[2] * h[2] * (a2 - 1) + 1;
        const auto smith = [&](double c) { return 1 / (c + std::sqrt(a2 + (1 - a2) * c * c)); };
        const double btdf = a2 / (spread * spread) * smith(l[2]) * smith(v[2]) * l[2];
        const double expected = 0.8 * (1 - schlick(0.04, dot(v, h))) * btdf;
        const Triple seen = light_adds(pane, behind, v);
        EXPECT_NEAR(seen[0], 0.5 * expected, 1e-9 * std::max(1.0, expected));
        EXPECT_NEAR(seen[1], expected, 1e-9 * std::max(1.0, expected));
        EXPECT_NEAR(seen[2], 0, 1e-9);
    }
}

// --- the white furnace

constexpr double kViews[] = {0.05, 0.2, 0.5, 0.8, 1.0};

// Light of 1 from above, and from below for what passes.
double from_all_lamps(Model& model, double ndotv, double alpha, const Fineness& fineness) {
    double sum = 0;
    for (const LightPoint& point : light_points(ndotv, alpha, fineness)) {
        for (const double side : {1.0, -1.0}) {
            const Direction l{point.l[0], point.l[1], side * point.l[2]}, mirrored{l[0], -l[1], l[2]};
            const auto seen = [&](const Direction& from) { return light_adds(model, from, view_of(ndotv))[1]; };
            sum += 0.5 * (seen(l) + seen(mirrored)) * point.weight;
        }
    }
    return sum / kPi;
}
double of_surroundings(Model& model, double ndotv) {
    return model.color({.v = view_of(ndotv)}, {.light = {}, .ambient = {1, 1, 1}, .environment = {1, 1, 1}})[1];
}

struct Furnace {
    const char* name;
    Words words;
    double alpha;              // of its narrowest lobe
    bool keeps_energy = true;  // within 1 %
    Fineness fineness = kCoarse;
};
// Over Lambert's white, which has no loss of its own; metals are for lobes that only they show.
const Words kMatt = {{"baseColor", "1,1,1"}, {"specularFactor", "0"}};
const Words kMetal = {{"baseColor", "1,1,1"}, {"metallic", "1"}};
Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}
constexpr Fineness kAround{.azimuth = 96, .per_unit = 4, .with_roots = 64};  // for a lobe that is not round
const Words kWhite = {{"baseColor", "1,1,1"}, {"roughness", "0.4"}};
const Furnace kOpenPbr[] = {
    {"openpbr, dielectric, roughness 0.4", kWhite, 0.16},
    {"openpbr, specularIor 2", joined(kWhite, {{"specularIor", "2"}}), 0.16},
    {"openpbr, specularWeight 0.5", joined(kWhite, {{"specularWeight", "0.5"}}), 0.16},
    {"openpbr, metal", joined(kWhite, {{"metallic", "1"}}), 0.16},
    {"openpbr, metal, roughness 1", {{"baseColor", "1,1,1"}, {"metallic", "1"}, {"roughness", "1"}}, 1},
    {"openpbr, baseDiffuseRoughness 1", joined(kWhite, {{"baseDiffuseRoughness", "1"}, {"specularWeight", "0"}}), 1},
    {"openpbr, coat", joined(kWhite, {{"coatWeight", "1"}, {"specularWeight", "0"}}), 0.002},
    {"openpbr, coat, coatRoughness 0.5",
     joined(kWhite, {{"coatWeight", "1"}, {"coatRoughness", "0.5"}, {"specularWeight", "0"}}), 0.25},
    {"openpbr, fuzz", joined(kWhite, {{"fuzzWeight", "1"}, {"specularWeight", "0"}}), 1},
    {"openpbr, fuzz, fuzzRoughness 1",
     joined(kWhite, {{"fuzzWeight", "1"}, {"fuzzRoughness", "1"}, {"specularWeight", "0"}}), 1},
    {"openpbr, specularAnisotropy 0.5, metal", joined(kWhite, {{"metallic", "1"}, {"specularAnisotropy", "0.5"}}), 0.16,
     false, kAround},
    {"openpbr, thinFilmWeight 1", joined(kWhite, {{"thinFilmWeight", "1"}}), 0.16, false},
};
const Furnace kFurnaces[] = {
    {"specularFactor 0", kMatt, 0.25},
    {"clearcoat, roughness 0", joined(kMatt, {{"clearcoat", "1"}}), 0.002},
    {"clearcoat, roughness 0.2", joined(kMatt, {{"clearcoat", "1"}, {"clearcoatRoughness", "0.2"}}), 0.04, false},
    {"clearcoat, roughness 0.5", joined(kMatt, {{"clearcoat", "1"}, {"clearcoatRoughness", "0.5"}}), 0.25, false},
    {"clearcoat, roughness 1", joined(kMatt, {{"clearcoat", "1"}, {"clearcoatRoughness", "1"}}), 1, false},
    {"sheen, roughness 0.2", joined(kMatt, {{"sheenColor", "1,1,1"}, {"sheenRoughness", "0.2"}}), 1},
    {"sheen, roughness 0.5", joined(kMatt, {{"sheenColor", "1,1,1"}, {"sheenRoughness", "0.5"}}), 1},
    {"sheen, roughness 1", joined(kMatt, {{"sheenColor", "1,1,1"}, {"sheenRoughness", "1"}}), 1},
    {"sheen 0.5, roughness 0.3", joined(kMatt, {{"sheenColor", "0.5,0.5,0.5"}, {"sheenRoughness", "0.3"}}), 1},
    {"diffuse transmission 0.5", joined(kMatt, {{"diffuseTransmission", "0.5"}}), 1},
    {"diffuse transmission 1", joined(kMatt, {{"diffuseTransmission", "1"}}), 1},
    {"transmission 1, roughness 0.1", joined(kMatt, {{"transmission", "1"}, {"roughness", "0.1"}}), 0.01, false},
    {"transmission 1, roughness 0.5", joined(kMatt, {{"transmission", "1"}, {"roughness", "0.5"}}), 0.25, false},
    {"ior 1", {{"baseColor", "1,1,1"}, {"ior", "1"}}, 0.25, false},
    {"ior 2.4", {{"baseColor", "1,1,1"}, {"ior", "2.4"}}, 0.25, false},
    {"anisotropy 0.5, metal, roughness 0.2", joined(kMetal, {{"anisotropy", "0.5"}, {"roughness", "0.2"}}), 0.04,
     false},
    {"anisotropy 1, metal, roughness 0.2", joined(kMetal, {{"anisotropy", "1"}, {"roughness", "0.2"}}), 0.04, false,
     kAround},
    {"iridescence 1, dielectric", {{"baseColor", "1,1,1"}, {"iridescence", "1"}}, 0.25, false},
    {"iridescence 1, metal", joined(kMetal, {{"iridescence", "1"}, {"roughness", "0.1"}}), 0.01, false},
};

std::string row_of(const Furnace& furnace, const char* name = "gltf") {
    Model model(compiler(), {.model = name, .values = furnace.words});
    EXPECT_TRUE(model.ok()) << furnace.name;
    double least[2] = {INFINITY, INFINITY}, most[2] = {0, 0};
    for (const double ndotv : kViews) {
        const double shares[] = {from_all_lamps(model, ndotv, furnace.alpha, furnace.fineness),
                                 of_surroundings(model, ndotv)};
        for (const std::size_t i : {0u, 1u}) {
            least[i] = std::min(least[i], shares[i]);
            most[i] = std::max(most[i], shares[i]);
            if (furnace.keeps_energy) {
                EXPECT_NEAR(shares[i], 1, 0.01) << furnace.name << ", n.v " << ndotv << (i == 0 ? ", lamps" : "");
            }
        }
    }
    char text[120];
    std::snprintf(text, sizeof text, "%.3f to %.3f | %.3f to %.3f |", least[0], most[0], least[1], most[1]);
    return "| " + std::string(furnace.name) + " | " + text;
}

// The numbers behind the first cell of a row.
std::vector<double> numbers_of(const std::string& row) {
    std::vector<double> numbers;
    std::istringstream cells(row.substr(row.find('|', 1)));
    for (std::string word; cells >> word;) {
        if (std::isdigit(static_cast<unsigned char>(word[0]))) numbers.push_back(std::stod(word));
    }
    return numbers;
}

void expect_documented(std::span<const Furnace> furnaces, const char* model) {
    std::ifstream file("docs/proofs.md");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    for (const Furnace& furnace : furnaces) {
        const std::string row = row_of(furnace, model), start = row.substr(0, row.find('|', 1) + 1);
        std::printf("%s\n", row.c_str());
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.starts_with(start); });
        if (line == lines.end()) {
            ADD_FAILURE() << "docs/proofs.md lacks this row:\n" << row;
            continue;
        }
        const std::vector<double> measured = numbers_of(row), documented = numbers_of(*line);
        ASSERT_EQ(measured.size(), documented.size()) << *line;
        for (std::size_t i = 0; i < measured.size(); ++i)
            EXPECT_NEAR(documented[i], measured[i], 0.002) << "documented: " << *line << "\nmeasured:   " << row;
    }
}

TEST(Layers, KeepEnergyAsTheDocumentedTableSays) {
    expect_documented(kFurnaces, "gltf");
}
TEST(Layers, OfOpenPbrKeepEnergyAsTheDocumentedTableSays) {
    expect_documented(kOpenPbr, "openpbr");
}

// --- what an unused layer costs

std::string shader_of(const std::string& lighting, const std::string& more, const char* path) {
    const std::string text = R"json({ "patina": 1, "workflow": "metallic-roughness", "lighting": ")json" + lighting +
                             R"json(", "properties": [ { "name": "_Metallic", "type": "float", "default": 0.3 },
        { "name": "_Tint", "type": "color", "default": "#c9a27e" } ],
      "surface": { "baseColor": "$_Tint.rgb", "roughness": 0.35, "metallic": "$_Metallic", "emission": [0.1, 0, 0])json" +
                             more + " } }";
    CompileOptions options;
    options.targets = {Target::Hlsl};
    options.request = CompileOptions::Passes{.path = path};
    options.include_dirs = {"tests/proof"};
    const Result result = compiler().compile_text("m.graph.json", text, options);
    EXPECT_TRUE(result.ok);
    // Along 'vertex', both say that a texture of the base colour is read at vertices only.
    for (const Diagnostic& diagnostic : result.diagnostics) EXPECT_EQ(diagnostic.code, "path-loses");
    std::string shaders;
    for (const Shader& shader : result.shaders) shaders += shader.text;
    return shaders;
}

// How often each operator, function, texture and input is named. The names of values, and blank lines, do not count.
std::map<std::string, int> work_in(const std::string& shader) {
    std::map<std::string, int> counts;
    const std::regex word(R"re( [-+*/<>?] |[A-Za-z_]\w*\(|\b\w+(?:WS|OS|UV|uv\d|Texture|Table|Map)\b)re");
    for (std::sregex_iterator at(shader.begin(), shader.end(), word), end; at != end; ++at) ++counts[at->str()];
    return counts;
}

TEST(Layers, UnusedOnesCostNothing) {
    for (const char* path : {"forward", "forward-add", "deferred-extended", "vertex"}) {
        const auto without = work_in(shader_of("./gltf-core.lighting.json", "", path));
        EXPECT_EQ(work_in(shader_of("gltf", "", path)), without) << path;
    }
    // The count sees each layer that is used.
    const auto without = work_in(shader_of("gltf", "", "forward"));
    for (const char* used :
         {R"(, "clearcoat": 0.5)", R"(, "sheenColor": [1, 0, 0])", R"(, "specularFactor": 0.5)",
          R"(, "specularColor": [1, 0, 0])", R"(, "ior": 1.4)", R"(, "anisotropy": 0.5)", R"(, "iridescence": 1)",
          R"(, "transmission": 1)", R"(, "diffuseTransmission": 0.5)", R"(, "emissiveStrength": 3)"}) {
        const std::string shader = shader_of("gltf", used, "forward");
        EXPECT_TRUE(work_in(shader) != without || shader != shader_of("gltf", "", "forward")) << used;
    }
}

}  // namespace
}  // namespace patina::proof
