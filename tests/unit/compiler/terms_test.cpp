// Every value of the lighting reference (tests/data/brdf-values.json) through the node or model that
// tests/terms/terms.json names: in double, where closed forms hold to 1e-9 and integrals to 1e-3, and in float to
// the row's own tolerance.
#include "tests/terms/terms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/terms/reference_values.h"

namespace patina::reference {
namespace {

// The largest error of a row relative to its tolerance.
double worst(const Json& row, const TermResult& result, double relative, double absolute) {
    double largest = 0;
    for (const auto& [name, numbers] : expected_of(row)) {
        const auto output = std::find_if(result.outputs.begin(), result.outputs.end(),
                                         [&, &wanted = name](const EvalOutput& o) { return o.name == wanted; });
        if (output == result.outputs.end() || output->values.size() != numbers.size()) {
            ADD_FAILURE() << shown(row) << ": no output '" << name << "' of " << numbers.size() << " numbers";
            return 0;
        }
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const double error =
                std::abs(output->values[i] - numbers[i]) / (absolute + relative * std::abs(numbers[i]));
            EXPECT_LE(error, 1) << shown(row) << "\n  " << name << "[" << i << "] is " << output->values[i] << ", not "
                                << numbers[i];
            largest = std::max(largest, error);
        }
    }
    return largest;
}

TEST(Terms, EveryTermOfTheReferenceHasOne) {
    std::set<std::string> named;
    for (const Json& row : rows().GetArray()) named.insert(row["term"].GetString());
    EXPECT_GT(named.size(), 100u);
    const std::vector<std::string> known = term_names();
    EXPECT_EQ(named, std::set<std::string>(known.begin(), known.end()));
}

TEST(Terms, EveryValueInDouble) {
    const Compiler compiler;
    std::size_t count = 0;
    for (const Json& row : rows().GetArray()) {
        const std::string term = row["term"].GetString();
        const TermResult result = evaluate_term(compiler, term, inputs_of(row), false);
        ASSERT_TRUE(result.ok) << shown(row) << "\n"
                               << result.error
                               << (result.diagnostics.empty() ? "" : to_text(result.diagnostics.front()));
        // What is zero in exact arithmetic is the rounding of a sum of ones.
        worst(row, result, is_integral(term) ? 1e-3 : 1e-9, 1e-15);
        ++count;
    }
    EXPECT_EQ(count, kRows);
}

TEST(Terms, EveryValueInFloat) {
    const Compiler compiler;
    for (const Json& row : rows().GetArray()) {
        const std::string term = row["term"].GetString();
        const TermResult result = evaluate_term(compiler, term, inputs_of(row), true);
        const double relative = is_integral(term) ? 1e-3 : row["rtolF32"].GetDouble();
        worst(row, result, relative, 1e-6);
    }
}

// Schlick's curve of each channel: 0.04 + 0.96 / 32, 0.5 + 0.5 / 32 and 1 at a cosine of a half.
TEST(Terms, WorkOnColoursWhereTheirNodesDo) {
    const Compiler compiler;
    const TermResult result = evaluate_term(compiler, "F_Schlick", {{"F0", "[0.04, 0.5, 1]"}, {"cos", "0.5"}}, false);
    ASSERT_TRUE(result.ok) << result.error;
    ASSERT_EQ(result.outputs.front().values.size(), 3u);
    EXPECT_NEAR(result.outputs.front().values[0], 0.07, 1e-15);
    EXPECT_NEAR(result.outputs.front().values[1], 0.515625, 1e-15);
    EXPECT_NEAR(result.outputs.front().values[2], 1, 1e-15);
}

TEST(Terms, BadWordsAreToldApart) {
    const Compiler compiler;
    const auto error = [&](const std::string& term, const TermInputs& inputs) {
        const TermResult result = evaluate_term(compiler, term, inputs, false);
        EXPECT_FALSE(result.ok);
        return result.error;
    };
    EXPECT_EQ(error("D_GXX", {}), "there is no term 'D_GXX'; did you mean 'D_GGX'?");
    EXPECT_EQ(error("D_GGX", {{"a2", "0.5"}, {"NdotH", "1"}}), "the term has no input 'NdotH'; it has a2, NoH");
    EXPECT_EQ(error("D_GGX", {{"a2", "0.5"}}), "the term needs a value for NoH");
    EXPECT_EQ(error("D_GGX", {{"a2", "0.5"}, {"a2", "1"}}), "'a2' is given twice");
    for (const char* word : {"abc", "", "nan", "1e-400", "0.5x"}) {
        EXPECT_EQ(error("D_GGX", {{"a2", word}, {"NoH", "1"}}),
                  std::string("'a2' is a number or a list of them, not '") + word + "'");
    }
    EXPECT_EQ(error("unity_sh_pack", {{"radiance_sh_zup", "1,2,3"}}),
              "the inputs have too few numbers for 'radiance_sh_zup_0'");
    EXPECT_EQ(error("sh_cosine_factors", {{"x", "1"}}), "the term has no input 'x'; it has l");
    EXPECT_EQ(error("OneMinusReflectivityFromMetallic", {{"metallic", "0"}, {"colorspace", "srgb"}}),
              "'srgb' is no 'colorspace'; there are linear, gamma");
}

}  // namespace
}  // namespace patina::reference
