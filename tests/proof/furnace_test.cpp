// The white furnace: a white surface under light of 1 from everywhere sends 1 to every viewer, or its model loses or
// makes light. Held for the model that promises it; of the others, the table in docs/proofs.md must say the truth.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "proof/closed_models.h"
#include "proof/hemisphere.h"
#include "runtime/lighting/model.h"

namespace patina::proof {
namespace {

using runtime::Model;
using runtime::ModelChoice;

constexpr double kViews[] = {0.05, 0.2, 0.5, 0.8, 1.0};

const Compiler& compiler() {
    static const Compiler made;
    return made;
}

// The same white surface in both workflows. A white metal has no diffuse colour.
using Words = std::vector<std::pair<std::string, std::string>>;
Words metallic_surface(double metallic, double roughness) {
    return {{"baseColor", "1,1,1"}, {"metallic", std::to_string(metallic)}, {"roughness", std::to_string(roughness)}};
}
Words specular_surface(double metallic, double roughness) {
    const std::string specular = std::to_string(0.04 * (1 - metallic) + metallic);
    return {{"baseColor", metallic < 1 ? "1,1,1" : "0,0,0"},
            {"specular", specular + "," + specular + "," + specular},
            {"glossiness", std::to_string(1 - roughness)}};
}

// Lamps everywhere: the mean over the hemisphere of what one lamp of every direction gives.
double lamps(Model& model, double ndotv, double roughness) {
    double sum = 0;
    for (const LightPoint& point : light_points(ndotv, std::max(roughness * roughness, 0.002), kCoarse))
        sum += model.direct({.l = point.l, .v = view_of(ndotv)})[1] * point.weight;
    return sum / kPi;
}

double surroundings(Model& model, double ndotv) {
    return model.color({.v = view_of(ndotv)}, {.light = {}, .ambient = {1, 1, 1}, .environment = {1, 1, 1}})[1];
}

class EnergyConserving : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Workflow, EnergyConserving, testing::Values("metallic-roughness", "specular-glossiness"),
                         [](const auto& info) { return info.index == 0 ? "Metallic" : "Specular"; });

TEST_P(EnergyConserving, SendsBackAllLight) {
    const bool is_metallic = std::string(GetParam()) == "metallic-roughness";
    double least[2] = {INFINITY, INFINITY}, most[2] = {0, 0};
    for (int step = 0; step <= 10; step += kSanitized ? 5 : 1) {
        for (const double metallic : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const double roughness = step / 10.0;
            Model model(compiler(), {.model = "energy-conserving",
                                     .workflow = GetParam(),
                                     .values = is_metallic ? metallic_surface(metallic, roughness)
                                                           : specular_surface(metallic, roughness)});
            ASSERT_TRUE(model.ok()) << to_text(model.diagnostics().at(0));
            for (const double ndotv : kViews) {
                const double shares[] = {lamps(model, ndotv, roughness), surroundings(model, ndotv)};
                for (std::size_t i : {0u, 1u}) {
                    EXPECT_NEAR(shares[i], 1, 0.01) << (i == 0 ? "lamps" : "surroundings") << ", roughness "
                                                    << roughness << ", metallic " << metallic << ", n.v " << ndotv;
                    least[i] = std::min(least[i], shares[i]);
                    most[i] = std::max(most[i], shares[i]);
                }
            }
        }
    }
    std::printf("%s: of lamps %.4f to %.4f, of surroundings %.4f to %.4f\n", GetParam(), least[0], most[0], least[1],
                most[1]);
}

// --- the table of all models

std::string title(const ClosedModel& model) {
    std::string text = model.name;
    for (const auto& [property, word] : model.variant) text += ", " + word;
    return text;
}

std::string range_of(Model& model, double roughness) {
    double least = INFINITY, most = 0;
    for (const double ndotv : kViews) {
        const double share = lamps(model, ndotv, roughness);
        least = std::min(least, share);
        most = std::max(most, share);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.2f to %.2f", least, most);
    return text;
}

std::string row_of(const ClosedModel& closed) {
    std::string row = "| " + title(closed) + " |";
    for (const double metallic : {0.0, 1.0}) {
        for (const double roughness : {0.1, 0.5, 1.0}) {
            ModelChoice choice{.model = closed.name, .values = closed.variant};
            for (const auto& word : metallic_surface(metallic, roughness)) choice.values.push_back(word);
            Model model(compiler(), choice);
            EXPECT_TRUE(model.ok()) << closed.name;
            row += " " + range_of(model, roughness) + " |";
        }
    }
    return row;
}

// The numbers of a row of the table.
std::vector<double> numbers_of(const std::string& row) {
    std::vector<double> numbers;
    std::istringstream cells(row.substr(row.find('|', 1)));
    for (std::string word; cells >> word;) {
        if (std::isdigit(word[0])) numbers.push_back(std::stod(word));
    }
    return numbers;
}

TEST(Furnace, TheDocumentedTableIsTrue) {
    std::ifstream file("docs/proofs.md");
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    for (const ClosedModel& closed : closed_models()) {
        const bool is_part = !closed.variant.empty() && closed.variant[0].first == "_Part";
        if (closed.name == "unlit" || is_part || (kSanitized && closed.name != "lambert")) continue;
        const std::string row = row_of(closed), start = row.substr(0, row.find('|', 1) + 1);
        std::printf("%s\n", row.c_str());
        const auto line = std::find_if(lines.begin(), lines.end(), [&](const auto& l) { return l.starts_with(start); });
        if (line == lines.end()) {
            ADD_FAILURE() << "docs/proofs.md lacks this row:\n" << row;
            continue;
        }
        const std::vector<double> measured = numbers_of(row), documented = numbers_of(*line);
        ASSERT_EQ(measured.size(), documented.size()) << *line;
        for (std::size_t i = 0; i < measured.size(); ++i)
            EXPECT_NEAR(documented[i], measured[i], 0.0101) << "documented: " << *line << "\nmeasured:   " << row;
    }
}

}  // namespace
}  // namespace patina::proof
