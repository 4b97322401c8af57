// The lighting reference as tests read it: rows of tests/data/brdf-values.json, each a term, its inputs, and what comes
// out. Tests run in the project's folder.
//
//   for (const reference::Json& row : reference::rows().GetArray()) evaluate(row["term"].GetString(), inputs_of(row));
#pragma once

#include <rapidjson/document.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/terms/terms.h"

namespace patina::reference {

using Json = rapidjson::Value;

inline const rapidjson::Document& read_json(const char* path) {
    static std::map<std::string, rapidjson::Document> documents;
    rapidjson::Document& document = documents[path];
    if (!document.IsNull()) return document;
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    document.Parse<rapidjson::kParseFullPrecisionFlag>(text.str().c_str());
    return document;
}

inline const rapidjson::Document& rows() {
    return read_json("tests/data/brdf-values.json");
}
inline constexpr std::size_t kRows = 780;

inline void append_word(const Json& value, std::string& word) {
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

inline TermInputs inputs_of(const Json& row) {
    TermInputs inputs;
    for (const auto& member : row["inputs"].GetObject()) {
        std::string word;
        append_word(member.value, word);
        inputs.emplace_back(member.name.GetString(), word);
    }
    return inputs;
}

// The numbers in a value, however deep.
inline void append_numbers(const Json& value, std::vector<double>& numbers) {
    if (value.IsArray()) {
        for (const Json& element : value.GetArray()) append_numbers(element, numbers);
    } else if (value.IsNumber()) {
        numbers.push_back(value.GetDouble());
    }
}

// By the output's name; "out" where there is but one.
inline std::map<std::string, std::vector<double>> expected_of(const Json& row) {
    std::map<std::string, std::vector<double>> expected;
    const Json& value = row["expected"];
    if (value.IsObject()) {
        for (const auto& member : value.GetObject()) append_numbers(member.value, expected[member.name.GetString()]);
    } else {
        append_numbers(value, expected["out"]);
    }
    return expected;
}

inline std::string shown(const Json& row) {
    std::string text = row["term"].GetString();
    for (const auto& [name, word] : inputs_of(row)) text += " " + name + "=" + word;
    return text;
}

// Worked out by quadrature.
inline bool is_integral(const std::string& term) {
    return term.starts_with("DFG_") || term.starts_with("directional_albedo");
}

}  // namespace patina::reference
