// A measured table on the GPU, through GLSL and HLSL, and on the CPU: every entry is found again, each of the narrow
// rows at the highlight, either way round; and a table sampled from a known BRDF draws what the BRDF itself draws.
#include "runtime/lighting/merl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "witness/bench.h"

namespace patina::witness {
namespace {

using runtime::DirectionPair;
using runtime::MerlTable;
using Vector = std::array<double, 3>;

constexpr double kPi = std::numbers::pi;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// --- looking up

// One pair of directions about a normal of the world.
struct TurnedPair {
    Vector normal{0, 0, 1};
    DirectionPair pair;
};

// The same pair about a normal that points elsewhere.
TurnedPair turned(const DirectionPair& pair, double about_x, double about_z) {
    const auto turn = [&](const Vector& d) -> Vector {
        const double s = std::sin(about_x), c = std::cos(about_x), p = std::sin(about_z), q = std::cos(about_z);
        const Vector tilted = {d[0], d[1] * c - d[2] * s, d[1] * s + d[2] * c};
        return {tilted[0] * q - tilted[1] * p, tilted[0] * p + tilted[1] * q, tilted[2]};
    };
    return {turn({0, 0, 1}), {turn(pair.light), turn(pair.view)}};
}

class MerlTest : public testing::Test {
protected:
    static void SetUpTestSuite() { bench = std::make_unique<Bench>(); }
    static void TearDownTestSuite() { bench.reset(); }
    void TearDown() override { bench->expect_silence(); }
    static inline std::unique_ptr<Bench> bench;

    // Red of MeasuredBRDF at each place, by each witness.
    static std::map<std::string, std::vector<double>> looked_up(const MerlTable& table,
                                                                const std::vector<TurnedPair>& places) {
        const auto material =
            bench->compile(R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() +
                           R"(, { "name": "_Table", "type": "texture2d", "usage": "data" } ],
"nodes": [ )" + load_node("n", "@fragCoord.x", "0") +
                           ",\n" + load_node("l", "@fragCoord.x", "1") + ",\n" + load_node("v", "@fragCoord.x", "2") +
                           R"(,
{ "id": "f", "node": "MeasuredBRDF",
  "in": { "table": "$_Table", "normal": "= n.xyz", "lightDir": "= l.xyz", "view": "= v.xyz" } } ],
"surface": { "color": "f" } })");
        if (!material) return {};
        const int width = static_cast<int>(places.size());
        Image data = runtime::make_image(width, 3);
        for (int x = 0; x < width; ++x) {
            const TurnedPair& place = places[static_cast<std::size_t>(x)];
            const Vector* rows[] = {&place.normal, &place.pair.light, &place.pair.view};
            for (int y = 0; y < 3; ++y) {
                for (std::size_t c = 0; c < 3; ++c) data.at(x, y)[c] = static_cast<float>((*rows[y])[c]);
            }
        }
        const Inputs inputs{
            .width = width, .data = texture_of(data), .textures = {{"_Table", texture_of(runtime::as_texture(table))}}};
        std::map<std::string, std::vector<double>> result;
        const auto keep = [&](const char* witness, const Image& image) {
            for (int x = 0; x < image.width; ++x) result[witness].push_back(static_cast<double>(image.at(x, 0)[0]));
        };
        keep("GLSL", bench->draw(*material, Target::Glsl, inputs));
        keep("HLSL", bench->draw(*material, Target::Hlsl, inputs));
        keep("the CPU in float", bench->run(*material, Precision::Float, inputs));
        keep("the CPU in double", bench->run(*material, Precision::Double, inputs));
        return result;
    }
};

// Reflectances (pi times the BRDF) that have nothing to do with one another, from 0 to 1.
MerlTable noisy_table(int half, int difference, int azimuth) {
    MerlTable table{.half = half, .difference = difference, .azimuth = azimuth};
    std::uint32_t state = 7;
    for (std::size_t i = 0; i < table.entries(); ++i) {
        state = state * 1664525u + 1013904223u;
        for (std::vector<double>& channel : table.channels) channel.push_back((state >> 8) / 16777216.0 / kPi);
    }
    return table;
}

TEST_F(MerlTest, EveryEntryIsFoundAgain) {
    const MerlTable table = noisy_table(6, 6, 8);
    std::vector<TurnedPair> places;
    for (int h = 0; h < table.half; ++h) {
        for (int d = 0; d < table.difference; ++d) {
            for (int a = 0; a < table.azimuth; ++a)
                places.push_back(turned(directions_of(table, h, d, a), 0.4 * h, 0.3 * d));
        }
    }
    for (const auto& [witness, values] : looked_up(table, places)) {
        ASSERT_EQ(values.size(), table.entries());
        for (std::size_t i = 0; i < values.size(); ++i)
            EXPECT_NEAR(values[i], table.channels[0][i] * kPi, 1e-4) << witness << ", entry " << i;
    }
}

// 90 rows, each with its number: the first ends at 0.011 degrees, where the cosine of a float is still 1.
TEST_F(MerlTest, TheNarrowRowsAtTheHighlightStayApart) {
    MerlTable table{.half = 90, .difference = 90, .azimuth = 180};
    std::vector<TurnedPair> places;
    for (int h = 0; h < table.half; ++h) {
        for (std::vector<double>& channel : table.channels)
            channel.insert(channel.end(), std::size_t(table.difference * table.azimuth), h / kPi);
        places.push_back(turned(directions_of(table, h, 20, 70), 0.7, 0.3));
    }
    for (const auto& [witness, values] : looked_up(table, places)) {
        ASSERT_EQ(values.size(), 90u);
        for (std::size_t h = 0; h < values.size(); ++h) EXPECT_NEAR(values[h], double(h), 0.01) << witness;
    }
}

TEST_F(MerlTest, LightAndViewMayBeExchanged) {
    const MerlTable table = noisy_table(6, 6, 8);
    std::vector<TurnedPair> places;
    std::uint32_t state = 1;
    const auto next = [&] { return ((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0; };
    for (int i = 0; i < 400; ++i) {
        const auto above = [&]() -> Vector {
            const double z = next(), sine = std::sqrt(1 - z * z), angle = 2 * kPi * next();
            return {sine * std::cos(angle), sine * std::sin(angle), z};
        };
        const TurnedPair place = turned({above(), above()}, next(), next());
        places.push_back(place);
        places.push_back({place.normal, {place.pair.view, place.pair.light}});
    }
    for (const auto& [witness, values] : looked_up(table, places)) {
        ASSERT_EQ(values.size(), places.size());
        for (std::size_t i = 0; i < values.size(); i += 2) EXPECT_NEAR(values[i], values[i + 1], 2e-4) << witness;
    }
}

// --- a known BRDF

// GGX (Walter 2007) with Smith's joint visibility (Heitz 2014) and Schlick's Fresnel, over Lambert; in 1/sr. Nothing is
// measured where light or view is below the horizon.
struct Known {
    double alpha;
    Vector diffuse{0.35, 0.1, 0.05}, f0{0.04, 0.06, 0.08};

    Vector operator()(const DirectionPair& pair) const {
        const double nl = pair.light[2], nv = pair.view[2];
        if (nl <= 0 || nv <= 0) return {-1, -1, -1};
        Vector h = {pair.light[0] + pair.view[0], pair.light[1] + pair.view[1], nl + nv};
        const double length = std::sqrt(dot(h, h));
        const double nh = h[2] / length, vh = dot(h, pair.view) / length, a2 = alpha * alpha;
        // The sine, for digits at the peak.
        const double sine2 = (h[0] * h[0] + h[1] * h[1]) / (length * length), spread = nh * nh * a2 + sine2;
        const double d = a2 / (kPi * spread * spread);
        const double v = 0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
        Vector f;
        for (std::size_t c = 0; c < 3; ++c)
            f[c] = diffuse[c] / kPi + d * v * (f0[c] + (1 - f0[c]) * std::pow(1 - vh, 5));
        return f;
    }
};

// From the middle of the highlight outwards, with the table's own angle between light and view and with others.
TEST_F(MerlTest, ThePeakKeepsItsHeight) {
    const Known known{.alpha = 0.02};
    std::vector<TurnedPair> places;
    std::vector<double> expected;
    for (const double theta_d : {0.1, 0.35, 0.61}) {
        for (int i = 0; i <= 40; ++i) {
            const double theta_h = 0.06 * i * i / 1600.0, s = std::sin(theta_h), c = std::cos(theta_h);
            const auto beside = [&](double sign) -> Vector {  // the half vector, across its own tilt
                return {s * std::cos(theta_d), sign * std::sin(theta_d), c * std::cos(theta_d)};
            };
            const DirectionPair pair{.light = beside(1), .view = beside(-1)};
            places.push_back(turned(pair, 0.5, 0.2));
            expected.push_back(kPi * known(pair)[0]);
        }
    }
    const auto fine = looked_up(runtime::sampled_table(known, 90, 90, 180), places);
    const auto coarse = looked_up(runtime::sampled_table(known, 45, 45, 90), places);
    for (const auto& [witness, values] : fine) {
        ASSERT_EQ(values.size(), expected.size());
        const std::vector<double>& halved = coarse.at(witness);
        double worst = 0, predicted = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            worst = std::max(worst, std::abs(values[i] - expected[i]) / expected[i]);
            predicted = std::max(predicted, std::abs(halved[i] - values[i]) / expected[i]);
        }
        EXPECT_LE(worst, predicted / 3) << witness;
        // At the very top: rows of one degree would be a third lower.
        for (std::size_t i = 0; i < values.size(); i += 41) EXPECT_NEAR(values[i] / expected[i], 1, 1e-3) << witness;
        EXPECT_GT(expected[0], 20);
    }
}

std::string numbers(const Vector& v) {
    return literal(v[0]) + "," + literal(v[1]) + "," + literal(v[2]);
}

// The same BRDF made of nodes.
constexpr const char* kAnalytic = R"json({ "patina": 1, "workflow": "metallic-roughness", "lighting": {
"properties": [ { "name": "_Alpha", "type": "float" }, { "name": "_Diffuse", "type": "float3" },
                { "name": "_F0", "type": "float3" } ],
"nodes": [
{ "id": "ndotl", "node": "NdotL" },
{ "id": "ndotv", "node": "NdotV" },
{ "id": "h", "node": "HalfVectorExact" },
{ "id": "ndoth", "node": "NdotH", "in": { "halfVector": "h" } },
{ "id": "ldoth", "node": "LdotH", "in": { "halfVector": "h" } },
{ "id": "d", "node": "DistributionGGX", "in": { "ndoth": "ndoth", "alpha": "$_Alpha" } },
{ "id": "v", "node": "VisibilitySmithJoint", "in": { "ndotl": "ndotl", "ndotv": "ndotv", "alpha": "$_Alpha" } },
{ "id": "f", "node": "FresnelSchlick", "in": { "cosine": "ldoth", "f0": "$_F0" } },
{ "id": "matt", "node": "LambertBrdf", "in": { "albedo": "$_Diffuse" } } ],
"direct": "= PI * (matt + d * v * f) * ndotl * @light.radiance" } })json";

struct Errors {
    float worst = 0, sum = 0;

    void add(float value, float expected) {
        worst = std::max(worst, std::abs(value - expected));
        sum += std::abs(value - expected);
    }
};

// True for the background, and for pixels beside it: there a cell of the table reaches below the horizon, where a
// measurement holds nothing.
bool is_at_edge(const Image& image, std::size_t pixel) {
    const int x = int(pixel) % image.width, y = int(pixel) / image.width;
    for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int column = std::clamp(x + dx, 0, image.width - 1), row = std::clamp(y + dy, 0, image.height - 1);
        if (std::ranges::equal(image.at(column, row), image.at(0, 0))) return true;
    }
    return false;
}

// Between entries the error goes with the square of their distance: a table of half the angles is four times as far
// off, and a third of what lies between the two tables is what the finer one may be off.
TEST_F(MerlTest, ATableDrawsWhatItWasSampledFrom) {
    for (const double alpha : {0.3, 0.1}) {
        const Known known{.alpha = alpha};
        const auto analytic = bench->compile(kAnalytic);
        const auto measured =
            bench->compile(R"({ "patina": 1, "workflow": "metallic-roughness", "lighting": "merl" })");
        ASSERT_TRUE(analytic && measured);
        runtime::Scene scene = runtime::default_scene("sphere");
        scene.ambient = runtime::constant_ambient(glm::vec3(0));
        scene.width = scene.height = 64;
        const auto look = [&](int half) {
            const MerlTable table = runtime::sampled_table(known, half, half, 2 * half);
            return Inputs{.data = texture_of(runtime::as_texture(table)), .scene = &scene};
        };
        const Inputs fine = look(90), coarse = look(45);
        const auto compare = [&](const char* witness,
                                 const std::function<Image(const Material&, const Inputs&)>& draw) {
            const Inputs parameters{
                .scene = &scene,
                .values = {
                    {"_Alpha", literal(alpha)}, {"_Diffuse", numbers(known.diffuse)}, {"_F0", numbers(known.f0)}}};
            const Image exact = draw(*analytic, parameters), of_fine = draw(*measured, fine),
                        of_coarse = draw(*measured, coarse);
            Errors error, halving;
            for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
                if (is_at_edge(exact, i / 4)) continue;
                error.add(of_fine.pixels[i], exact.pixels[i]);
                halving.add(of_coarse.pixels[i], of_fine.pixels[i]);
            }
            EXPECT_LE(error.worst, halving.worst / 3) << witness << ", alpha " << alpha;
            EXPECT_LE(error.sum, halving.sum / 3) << witness << ", alpha " << alpha;
            // The highlight is there, and it is met within one hundredth.
            EXPECT_LE(error.worst, *std::max_element(exact.pixels.begin(), exact.pixels.end()) / 100);
        };
        compare("GLSL", [&](const Material& m, const Inputs& i) { return bench->draw(m, Target::Glsl, i); });
        compare("HLSL", [&](const Material& m, const Inputs& i) { return bench->draw(m, Target::Hlsl, i); });
        compare("CPU", [&](const Material& m, const Inputs& i) { return bench->run(m, Precision::Float, i); });
    }
}

}  // namespace
}  // namespace patina::witness
