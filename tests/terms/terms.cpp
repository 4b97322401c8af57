#include "tests/terms/terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>

#include "compiler/json/memory/json_document.h"
#include "runtime/lighting/model.h"
#include "tests/terms/term_data.h"

namespace patina::reference {
namespace {

using Json = JsonValue;

const JsonDocument& terms() {
    static const JsonDocument kTerms = [] {
        JsonDocument document;
        document.Parse(kTermData);
        return document;
    }();
    return kTerms;
}

// --- inputs

// The values that expressions read, and the words that make choices.
struct Inputs {
    std::vector<NamedValue> values;
    std::map<std::string, std::string> words;

    bool has(const std::string& name) const {
        return std::any_of(values.begin(), values.end(), [&](const NamedValue& v) { return v.name == name; });
    }
};

// A list of more than four numbers is read in parts of `width`: name_0, name_1, ...
void add_input(Inputs& inputs, const std::string& name, std::vector<double> numbers, std::size_t width) {
    if (width == 0 && numbers.size() <= 4) {
        inputs.values.push_back({name, std::move(numbers)});
        return;
    }
    const std::size_t step = std::max<std::size_t>(width, 1);
    for (std::size_t at = 0, i = 0; at + step <= numbers.size(); at += step, ++i) {
        const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(at);
        inputs.values.push_back({name + "_" + std::to_string(i), {begin, begin + static_cast<std::ptrdiff_t>(step)}});
    }
}

// Whether an expression reads an input that is not given: "NoH" of "sqrt(NoH)".
bool reads_unknown(const std::string& expression, const std::vector<std::string>& known, const Inputs& inputs) {
    for (std::size_t at = 0; at < expression.size();) {
        if (!std::isalpha(static_cast<unsigned char>(expression[at])) && expression[at] != '_') {
            const bool is_number = std::isdigit(static_cast<unsigned char>(expression[at])) != 0;
            ++at;
            while (is_number && at < expression.size() && std::isalnum(static_cast<unsigned char>(expression[at])))
                ++at;
            continue;
        }
        std::size_t end = at;
        while (end < expression.size() &&
               (std::isalnum(static_cast<unsigned char>(expression[end])) || expression[end] == '_'))
            ++end;
        const std::string word = expression.substr(at, end - at);
        if (std::find(known.begin(), known.end(), word) != known.end() && !inputs.has(word)) return true;
        at = end;
    }
    return false;
}

// --- one evaluation

class Evaluation {
public:
    Evaluation(const Compiler& compiler, const Json& term, bool single)
        : compiler_(compiler), term_(term), single_(single) {}

    TermResult run(const TermInputs& given) {
        const bool good = read_inputs(given) && (!term_.HasMember("let") || let()) &&
                          (!term_.HasMember("node") || node()) && (!term_.HasMember("model") || model()) && outputs();
        result_.ok = good;
        return std::move(result_);
    }

private:
    bool fail(std::string error) {
        result_.error = std::move(error);
        return false;
    }

    // The names in a list of the term, "optional" or "words".
    std::vector<std::string> names_in(const char* list) const {
        std::vector<std::string> names;
        const auto found = term_.FindMember(list);
        if (found == term_.MemberEnd()) return names;
        for (const Json& name : found->value.GetArray()) names.emplace_back(name.GetString());
        return names;
    }
    static bool contains(const std::vector<std::string>& names, const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    }

    bool read_inputs(const TermInputs& given) {
        known_ = names_in("inputs");
        const std::vector<std::string> words = names_in("words"), optional = names_in("optional");
        for (const auto& [name, word] : given) {
            if (!contains(known_, name)) {
                return fail(known_.empty()
                                ? fmt::format("the term has no inputs, and so no '{}'", name)
                                : fmt::format("the term has no input '{}'; it has {}", name, fmt::join(known_, ", ")));
            }
            if (inputs_.words.contains(name)) return fail(fmt::format("'{}' is given twice", name));
            inputs_.words[name] = word;
            std::optional<std::vector<double>> numbers = runtime::read_numbers(word);
            if (!numbers) {
                if (contains(words, name)) continue;
                return fail(fmt::format("'{}' is a number or a list of them, not '{}'", name, word));
            }
            std::size_t width = 0;
            if (const auto widths = term_.FindMember("widths"); widths != term_.MemberEnd()) {
                const auto found = widths->value.FindMember(name.c_str());
                if (found != widths->value.MemberEnd()) width = found->value.GetUint();
            }
            add_input(inputs_, name, std::move(*numbers), width);
        }
        std::vector<std::string> missing = not_given();
        std::erase_if(missing, [&](const std::string& name) { return contains(optional, name); });
        if (!missing.empty()) return fail(fmt::format("the term needs a value for {}", fmt::join(missing, ", ")));
        return true;
    }

    // The text for a port: an expression, or a choice by an input's word.
    std::optional<std::string> text_of(const Json& mapping) {
        if (mapping.IsString()) {
            const std::string expression = mapping.GetString();
            if (reads_unknown(expression, not_given(), inputs_)) return {};
            if (is_beyond(expression)) {
                fail(fmt::format("the inputs have too few numbers for '{}'", expression));
                return {};
            }
            return expression;
        }
        const std::string by = mapping["by"].GetString();
        const auto word = inputs_.words.find(by);
        if (word == inputs_.words.end()) return {};
        const auto chosen = mapping.FindMember(word->second.c_str());
        if (chosen == mapping.MemberEnd()) {
            std::vector<std::string> words;
            for (const auto& member : mapping.GetObject()) {
                if (std::string_view(member.name.GetString()) != "by") words.emplace_back(member.name.GetString());
            }
            fail(fmt::format("'{}' is no '{}'; there are {}", word->second, by, fmt::join(words, ", ")));
            return {};
        }
        return chosen->value.GetString();
    }
    std::vector<std::string> not_given() const {
        std::vector<std::string> names;
        for (const std::string& name : known_) {
            if (!inputs_.words.contains(name)) names.push_back(name);
        }
        return names;
    }

    std::optional<std::vector<double>> value(const std::string& expression) {
        EvalResult made = compiler_.evaluate_expression(expression, inputs_.values, single_);
        if (!made.ok) {
            result_.diagnostics = std::move(made.diagnostics);
            return {};
        }
        return std::move(made.outputs.front().values);
    }

    bool let() {
        for (const auto& member : term_["let"].GetObject()) {
            std::optional<std::vector<double>> made = value(member.value.GetString());
            if (!made) return false;
            inputs_.values.push_back({member.name.GetString(), std::move(*made)});
        }
        return true;
    }

    bool node() {
        std::vector<std::pair<std::string, std::string>> arguments;
        for (const auto& port : term_["in"].GetObject()) {
            const std::optional<std::string> text = text_of(port.value);
            if (!result_.error.empty()) return false;
            if (text) arguments.emplace_back(port.name.GetString(), *text);
        }
        EvalResult made = compiler_.evaluate(term_["node"].GetString(), arguments, single_, inputs_.values);
        if (!made.ok) {
            result_.diagnostics = std::move(made.diagnostics);
            return false;
        }
        for (EvalOutput& output : made.outputs) inputs_.values.push_back({output.name, std::move(output.values)});
        return true;
    }

    // "in" may give n, l, v, t, light, ambient and environment, each as an expression.
    bool model() {
        runtime::ModelChoice choice{.model = term_["model"].GetString(), .workflow = term_["workflow"].GetString()};
        runtime::ModelPoint point;
        runtime::ModelLight light;
        const std::map<std::string, runtime::Triple*> triples = runtime::named_inputs(point, light);
        for (const auto& port : term_["in"].GetObject()) {
            const std::optional<std::string> text = text_of(port.value);
            if (!result_.error.empty()) return false;
            if (!text) continue;
            std::optional<std::vector<double>> numbers = value(*text);
            if (!numbers) return false;
            const auto triple = triples.find(port.name.GetString());
            if (triple == triples.end()) {
                choice.values.emplace_back(port.name.GetString(), fmt::format("{}", fmt::join(*numbers, ",")));
            } else if (numbers->size() == 3) {
                std::copy(numbers->begin(), numbers->end(), triple->second->begin());
            }
        }
        runtime::Model evaluated(compiler_, choice, single_ ? Precision::Float : Precision::Double);
        if (!evaluated.ok()) {
            result_.diagnostics = evaluated.diagnostics();
            return false;
        }
        const runtime::Triple color = evaluated.color(point, light);
        inputs_.values.push_back({"out", {color.begin(), color.end()}});
        return true;
    }

    // Whether an expression reads more parts of an input than it has: "i_7" if the input has seven.
    bool is_beyond(const std::string& part) const {
        const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
        for (const std::string& name : known_) {
            const std::size_t at = part.find(name + "_");
            if (at == part.npos || (at > 0 && is_word(part[at - 1]))) continue;
            const std::size_t digits = at + name.size() + 1;
            const std::size_t end = part.find_first_not_of("0123456789", digits);
            if (end == digits || digits == part.size()) continue;
            if (!inputs_.has(part.substr(at, end - at))) return true;
        }
        return false;
    }

    bool add_output(const std::string& name, const Json& mapping) {
        EvalOutput output{.name = name, .type = {}, .values = {}};
        const auto append = [&](const Json& part) {
            std::optional<std::vector<double>> made = value(part.GetString());
            if (!made) return false;
            output.values.insert(output.values.end(), made->begin(), made->end());
            result_.widths.push_back(made->size());
            return true;
        };
        if (!mapping.IsArray()) {
            if (!append(mapping)) return false;
        } else {
            for (const Json& part : mapping.GetArray()) {
                if (!is_beyond(part.GetString()) && !append(part)) return false;
            }
        }
        result_.outputs.push_back(std::move(output));
        return true;
    }

    bool outputs() {
        const auto out = term_.FindMember("out");
        if (term_.HasMember("channel")) {
            const bool has_color = std::any_of(inputs_.values.begin(), inputs_.values.end(), [&](const NamedValue& v) {
                return v.values.size() == 3 && inputs_.words.contains(v.name);
            });
            const Json channel(rapidjson::StringRef(has_color ? "out" : "out.x"));
            return add_output("out", channel);
        }
        if (out == term_.MemberEnd()) {
            static const Json kPrimary("out");
            return add_output("out", kPrimary);
        }
        if (!out->value.IsObject()) return add_output("out", out->value);
        for (const auto& member : out->value.GetObject()) {
            if (!add_output(member.name.GetString(), member.value)) return false;
        }
        return true;
    }

    const Compiler& compiler_;
    const Json& term_;
    bool single_;
    Inputs inputs_;
    std::vector<std::string> known_;
    TermResult result_;
};

}  // namespace

TermResult evaluate_term(const Compiler& compiler, const std::string& term, const TermInputs& inputs, bool single) {
    const auto found = terms().FindMember(term.c_str());
    if (found == terms().MemberEnd()) {
        const std::string near = suggestion(term, term_names());
        return {.ok = false,
                .error = near.empty()
                             ? fmt::format("there is no term '{}'; there are {}", term, fmt::join(term_names(), ", "))
                             : fmt::format("there is no term '{}'; {}", term, near),
                .diagnostics = {},
                .outputs = {},
                .widths = {}};
    }
    return Evaluation(compiler, found->value, single).run(inputs);
}

std::vector<std::string> term_names() {
    std::vector<std::string> names;
    for (const auto& member : terms().GetObject()) names.emplace_back(member.name.GetString());
    return names;
}

}  // namespace patina::reference
