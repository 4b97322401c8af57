#include "witness/term_graphs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>

namespace patina::witness {
namespace {

using reference::Json;

bool begins_word(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool is_in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// Takes `expression` apart: calls `read` with each name that is no member, no call and no part of a number, and `rest`
// with all other text.
void take_apart(const std::string& expression, const std::function<void(const std::string&)>& read,
                const std::function<void(const std::string&)>& rest) {
    for (std::size_t at = 0; at < expression.size();) {
        std::size_t end = at + 1;
        if (!is_in_word(expression[at])) {
            rest(expression.substr(at, 1));
            at = end;
            continue;
        }
        while (end < expression.size() && is_in_word(expression[end])) ++end;
        const std::string word = expression.substr(at, end - at);
        const bool is_member = at > 0 && expression[at - 1] == '.';
        const bool is_called = end < expression.size() && expression[end] == '(';
        begins_word(word[0]) && !is_member && !is_called ? read(word) : rest(word);
        at = end;
    }
}

// Whether it reads an input of the term, or a part of one ("i_7"), that this row does not have.
bool reads_what_is_not_there(const std::string& expression, const Json& term, const RowInputs& inputs) {
    bool found = false;
    const auto read = [&](const std::string& word) {
        if (inputs.names.contains(word)) return;
        for (const Json& input : term["inputs"].GetArray()) {
            const std::string name = input.GetString();
            const bool is_part = word.starts_with(name + "_") &&
                                 word.find_first_not_of("0123456789", name.size() + 1) == std::string::npos;
            found = found || word == name || is_part;
        }
    };
    take_apart(expression, read, [](const std::string&) {});
    return found;
}

std::string quoted(const std::string& text) {
    return "\"" + text + "\"";
}

// The expressions of "out", one behind the other.
void append_parts(const Json& out, std::vector<std::string>& parts) {
    if (out.IsString()) parts.emplace_back(out.GetString());
    if (out.IsArray()) {
        for (const Json& part : out.GetArray()) append_parts(part, parts);
    }
    if (out.IsObject()) {
        for (const auto& member : out.GetObject()) append_parts(member.value, parts);
    }
}

std::string padded(const std::string& name, std::size_t width) {
    static const char* const kRest[] = {"", ", 0, 0, 0", ", 0, 0", ", 0", ""};
    return "float4(" + name + kRest[width] + ")";
}

// Writes the nodes of one graph.
struct Writer {
    const Compiler& compiler;
    const Json& term;
    const RowInputs& inputs;
    std::map<std::string, std::string> names = inputs.names;
    std::string nodes{};

    void add(const std::string& node) { nodes += (nodes.empty() ? "" : ",\n") + node; }
    void add_expression(const std::string& id, const std::string& expression) {
        add("{ \"id\": " + quoted(id) + ", \"expr\": " + quoted(renamed(expression, names)) + " }");
    }

    void add_node() {
        const std::string name = term["node"].GetString();
        const std::vector<NodeInfo> library = compiler.nodes();
        const auto info =
            std::find_if(library.begin(), library.end(), [&](const NodeInfo& n) { return n.name == name; });
        ASSERT_NE(info, library.end()) << name;
        std::string ports;
        for (const auto& member : term["in"].GetObject()) {
            const std::optional<std::string> text = port_text(member.value, term, inputs);
            if (!text) continue;
            const std::string port_name = member.name.GetString();
            const auto port = std::find_if(info->ports.begin(), info->ports.end(),
                                           [&](const PortInfo& p) { return !p.is_output && p.name == port_name; });
            ASSERT_NE(port, info->ports.end()) << name << "." << port_name;
            ports += (ports.empty() ? "" : ", ") + quoted(port_name) + ": " +
                     quoted(port->enumerators.empty() ? "= " + renamed(*text, names) : *text);
        }
        add("{ \"id\": \"value\", \"node\": " + quoted(name) + ", \"in\": { " + ports + " } }");
        for (const PortInfo& port : info->ports) {
            if (port.is_output) names[port.name] = port.name == "out" ? "value" : "value." + port.name;
        }
    }
};

}  // namespace

std::string renamed(const std::string& expression, const std::map<std::string, std::string>& names) {
    std::string text;
    const auto rest = [&](const std::string& part) { text += part; };
    const auto read = [&](const std::string& word) {
        const auto found = names.find(word);
        text += found == names.end() ? word : found->second;
    };
    take_apart(expression, read, rest);
    return text;
}

RowInputs row_inputs(const Json& row, const Json& term) {
    RowInputs inputs;
    const auto add = [&](const std::string& name, std::span<const double> numbers) {
        Texel texel{};
        std::copy(numbers.begin(), numbers.end(), texel.begin());
        inputs.names[name] =
            "t" + std::to_string(inputs.texels.size()) + "." + std::string("xyzw").substr(0, numbers.size());
        inputs.numbers[name] = {numbers.begin(), numbers.end()};
        inputs.texels.push_back(texel);
    };
    for (const auto& [name, word] : reference::inputs_of(row)) inputs.words[name] = word;
    for (const auto& member : row["inputs"].GetObject()) {
        const std::string name = member.name.GetString();
        std::vector<double> numbers;
        reference::append_numbers(member.value, numbers);
        if (numbers.empty()) continue;
        const bool has_width = term.HasMember("widths") && term["widths"].HasMember(name.c_str());
        if (!has_width && numbers.size() <= 4) {
            add(name, numbers);
            continue;
        }
        const std::size_t width = has_width ? term["widths"][name.c_str()].GetUint() : 1;
        for (std::size_t i = 0; (i + 1) * width <= numbers.size(); ++i)
            add(name + "_" + std::to_string(i), std::span(numbers).subspan(i * width, width));
    }
    return inputs;
}

std::optional<std::string> port_text(const Json& mapping, const Json& term, const RowInputs& inputs) {
    if (mapping.IsString()) {
        const std::string text = mapping.GetString();
        return reads_what_is_not_there(text, term, inputs) ? std::nullopt : std::optional(text);
    }
    const auto word = inputs.words.find(mapping["by"].GetString());
    if (word == inputs.words.end()) return {};
    EXPECT_TRUE(mapping.HasMember(word->second.c_str())) << word->second;
    return mapping[word->second.c_str()].GetString();
}

std::string term_graph(const Compiler& compiler, const Json& term, const RowInputs& inputs,
                       const std::vector<std::size_t>& widths) {
    Writer writer{.compiler = compiler, .term = term, .inputs = inputs};
    for (std::size_t i = 0; i < inputs.texels.size(); ++i)
        writer.add(load_node("t" + std::to_string(i), "@fragCoord.x", std::to_string(i)));
    if (term.HasMember("let")) {
        for (const auto& member : term["let"].GetObject()) {
            const std::string name = member.name.GetString();
            writer.add_expression("let_" + name, member.value.GetString());
            writer.names[name] = "let_" + name;
        }
    }
    if (term.HasMember("node")) writer.add_node();

    std::vector<std::string> parts;
    if (term.HasMember("channel")) {
        parts.emplace_back("out.x");
    } else if (term.HasMember("out")) {
        append_parts(term["out"], parts);
    } else {
        parts.emplace_back("out");
    }
    std::erase_if(parts, [&](const std::string& part) { return reads_what_is_not_there(part, term, inputs); });
    for (std::size_t i = 0; i < parts.size(); ++i) writer.add_expression("part" + std::to_string(i), parts[i]);
    if (widths.empty()) return writer.nodes;

    EXPECT_EQ(widths.size(), parts.size());
    std::string all;
    for (std::size_t i = 0; i + 1 < widths.size(); ++i)
        all +=
            "@fragCoord.y < " + std::to_string(i + 1) + " ? " + padded("part" + std::to_string(i), widths[i]) + " : ";
    all += padded("part" + std::to_string(widths.size() - 1), widths.back());
    writer.add_expression("all", all);
    return R"({ "patina": 1, "workflow": "unlit", "properties": [ )" + data_property() + " ],\n\"nodes\": [\n" +
           writer.nodes + " ],\n\"surface\": { \"color\": \"= all.xyz\", \"alpha\": \"= all.w\" } }";
}

}  // namespace patina::witness
