// Every value of the lighting reference (tests/data/brdf-values.json) through the node or model that
// tests/data/terms.json names: in double, where closed forms hold to 1e-9 and integrals to 1e-3, and in float to the
// row's own tolerance.
#include "compiler/cli/terms.h"

#include <gtest/gtest.h>
#include <rapidjson/document.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace patina::cli {
namespace {

using Json = rapidjson::Value;

const rapidjson::Document& rows() {
    static const rapidjson::Document kRows = [] {
        std::ifstream file("tests/data/brdf-values.json");
        std::stringstream text;
        text << file.rdbuf();
        rapidjson::Document document;
        document.Parse<rapidjson::kParseFullPrecisionFlag>(text.str().c_str());
        return document;
    }();
    return kRows;
}

void append_word(const Json& value, std::string& word) {
    if (value.IsArray()) {
        for (const Json& element : value.GetArray()) append_word(element, word);
        return;
    }
    if (!word.empty()) word += ",";
    if (value.IsString()) {
        word += value.GetString();
    } else if (value.IsBool()) {
        word += value.GetBool() ? "true" : "false";
    } else {
        std::ostringstream digits;
        digits.precision(17);
        digits << value.GetDouble();
        word += digits.str();
    }
}

TermInputs inputs_of(const Json& row) {
    TermInputs inputs;
    for (const auto& member : row["inputs"].GetObject()) {
        std::string word;
        append_word(member.value, word);
        inputs.emplace_back(member.name.GetString(), word);
    }
    return inputs;
}

void append_numbers(const Json& value, std::vector<double>& numbers) {
    if (value.IsArray()) {
        for (const Json& element : value.GetArray()) append_numbers(element, numbers);
    } else {
        numbers.push_back(value.GetDouble());
    }
}

std::map<std::string, std::vector<double>> expected_of(const Json& row) {
    std::map<std::string, std::vector<double>> expected;
    const Json& value = row["expected"];
    if (value.IsObject()) {
        for (const auto& member : value.GetObject()) append_numbers(member.value, expected[member.name.GetString()]);
    } else {
        append_numbers(value, expected["out"]);
    }
    return expected;
}

std::string shown(const Json& row) {
    std::string text = row["term"].GetString();
    for (const auto& [name, word] : inputs_of(row)) text += " " + name + "=" + word;
    return text;
}

// Worked out by quadrature.
bool is_integral(const std::string& term) {
    return term.starts_with("DFG_") || term.starts_with("directional_albedo");
}

// The largest error of a row relative to its tolerance.
double worst(const Json& row, const TermResult& result, double relative, double absolute) {
    double largest = 0;
    for (const auto& [name, numbers] : expected_of(row)) {
        const auto output = std::find_if(result.outputs.begin(), result.outputs.end(),
                                         [&](const EvalOutput& o) { return o.name == name; });
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
    EXPECT_GE(count, 640u);
}

TEST(Terms, EveryValueInFloat) {
    const Compiler compiler;
    for (const Json& row : rows().GetArray()) {
        const std::string term = row["term"].GetString();
        const TermResult result = evaluate_term(compiler, term, inputs_of(row), true);
        const double relative = is_integral(term) ? 1e-3 : row["rtol_f32"].GetDouble();
        worst(row, result, relative, 1e-6);
    }
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
    EXPECT_EQ(error("OneMinusReflectivityFromMetallic", {{"metallic", "0"}, {"colorspace", "srgb"}}),
              "'srgb' is no 'colorspace'; there are linear, gamma");
}

}  // namespace
}  // namespace patina::cli
