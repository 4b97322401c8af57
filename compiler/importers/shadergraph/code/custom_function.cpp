// Nodes with code of their own: a string in the node, or a function of a file. The code becomes a node file: in the
// node language if it is valid there, else as the text of [foreign] functions.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/code/engine_words.h"
#include "compiler/importers/shadergraph/code/hlsl_grammar.h"
#include "compiler/importers/shadergraph/code/hlsl_text.h"
#include "compiler/importers/shadergraph/code/includes.h"
#include "compiler/importers/shadergraph/code/texture_reads.h"
#include "compiler/importers/shadergraph/code/unknown_words.h"
#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/source_text.h"

namespace patina::importers::shadergraph {
namespace {

std::string port_of(const Slot& slot) {
    std::string name = identifier(text_of(slot.json, "m_ShaderOutputName"));
    return name.empty() ? identifier(slot.name) : name;
}

struct Code {
    std::vector<HlslFunction> helpers{};  // in the order of their file
    HlslFunction main{};
    std::vector<HlslMacro> macros{};   // that the functions use
    std::string engine_values{};       // more parameters of the node, hidden ones
    std::vector<std::string> ports{};  // of the node's inputs, then of its outputs
    std::string error{};
    bool is_missing = false;  // its file is not there
};

// Functions that are known by their names.
struct Known {
    std::string_view function, output, value;
};
constexpr Known kKnown[] = {
#define FUNCTION(function, output, value) {function, output, value},
#include "compiler/importers/shadergraph/code/functions.def"
#undef FUNCTION
};

std::string plain(std::string_view name) {
    std::string made = spelled_alike(name);
    if (const std::size_t at = made.find("colour"); at != made.npos) made.replace(at, 6, "color");
    return made;
}

const Known* known(std::string_view function, std::string_view output) {
    const auto found = std::ranges::find_if(kKnown, [&](const Known& each) {
        return plain(each.function) == plain(function) && plain(each.output) == plain(output);
    });
    return found == std::end(kKnown) ? nullptr : &*found;
}

// False: one of the outputs that are read is not known.
bool apply_known(GraphMaker& maker, std::size_t index, std::string_view function) {
    const Node& at = maker.node(index);
    int first = -1;
    for (const Slot& slot : at.slots)
        if (slot.is_input && first < 0) first = slot.id;
    for (const Slot& slot : at.slots)
        if (!slot.is_input && maker.is_used(index, slot.id) && !known(function, port_of(slot))) return false;
    for (const Slot& slot : at.slots) {
        if (slot.is_input || !maker.is_used(index, slot.id)) continue;
        std::string value(known(function, port_of(slot))->value);
        if (const std::size_t place = value.find("{0}"); place != value.npos)
            value.replace(place, 3, first < 0 ? "@normalWS" : maker.named(maker.input(index, first)).text());
        maker.set(index, slot.id, expression(value, maker.type_of(index, slot)));
    }
    return true;
}

// Inputs, then outputs: the order of the function's parameters.
std::vector<const Slot*> ordered(const Node& node) {
    std::vector<const Slot*> made;
    for (const bool is_input : {true, false})
        for (const Slot& slot : node.slots)
            if (slot.is_input == is_input) made.push_back(&slot);
    return made;
}

std::string signature(GraphMaker& maker, std::size_t index) {
    std::string made;
    for (const Slot* slot : ordered(maker.node(index)))
        made += fmt::format("{}{}{} {}", made.empty() ? "" : ", ", slot->is_input ? "" : "out ",
                            word(maker.type_of(index, *slot)), port_of(*slot));
    return made;
}

std::string indented(std::string_view body) {
    std::string made;
    std::size_t depth = 1;
    std::string line;
    for (std::size_t i = 0; i <= body.size(); ++i) {
        if (i < body.size() && body[i] != '\n') {
            line += body[i];
            continue;
        }
        const std::size_t first = line.find_first_not_of(" \t");
        if (first != line.npos) {
            line = line.substr(first);
            if (line.starts_with("}") && depth > 1) --depth;
            made += std::string(depth * 4, ' ') + line + "\n";
            for (std::size_t j = line.starts_with("}") ? 1 : 0; j < line.size(); ++j) {
                if (line[j] == '{') ++depth;
                if (line[j] == '}' && depth > 1) --depth;
            }
        }
        line.clear();
    }
    return made;
}

// The names of parameters: "float3 Normal : NORMAL, out float Out" -> "Normal", "Out".
std::vector<std::string> names_in(std::string_view parameters) {
    std::vector<std::string> made;
    for (const std::string& each : arguments_of(parameters)) {
        const std::string_view head = std::string_view(each).substr(0, each.find_first_of(":=["));
        const std::size_t last = head.find_last_not_of(' ');
        const std::size_t begin = last == head.npos ? last : head.find_last_of(" \t", last);
        made.emplace_back(begin == head.npos ? "" : head.substr(begin + 1, last - begin));
    }
    return made;
}

// "[hidden] float engineTime = time, ..." -> "engineTime", ...
std::vector<std::string> hidden_names_in(std::string_view parameters) {
    std::vector<std::string> made;
    for (const std::string& each : arguments_of(parameters)) {
        const std::vector<std::string_view> words = split(each, " ");
        if (words.size() > 2) made.emplace_back(words[2]);
    }
    return made;
}

// The first output that the code leaves as it is.
std::string unassigned(const Node& node, const Code& code, std::string_view body) {
    const std::vector<const Slot*> slots = ordered(node);
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (!slots[i]->is_input && !assigns(body, code.ports[i]))
            return fmt::format("its code never assigns its output '{}'", code.ports[i]);
    return {};
}

Code from_string(GraphMaker& maker, std::size_t index) {
    for (const Slot& slot : maker.node(index).slots)
        if (port_of(slot).empty())
            return {.error = fmt::format("its {} '{}' has a name without any letter of English",
                                         slot.is_input ? "input" : "output", slot.name)};
    HlslText body = in_node_language(text_of(maker.node(index).json, "m_FunctionBody"));
    if (!body.error.empty()) return {.error = body.error};
    std::set<std::string, std::less<>> samplers;
    for (const Slot& slot : maker.node(index).slots)
        if (maker.type_of(index, slot) == Type::Sampler) samplers.insert(port_of(slot));
    body.code = with_texture_reads(std::move(body.code), std::move(samplers));
    Code made{.main = {.parameters = signature(maker, index), .body = body.code},
              .macros = std::move(body.macros),
              .engine_values = body.parameters};
    for (const Slot* slot : ordered(maker.node(index))) made.ports.push_back(port_of(*slot));
    made.error = unassigned(maker.node(index), made, body.code);
    return made;
}

// Those of the functions with a name that a call in the code may mean: by the count of its arguments; and of a pair for
// both precisions the one for full precision.
std::vector<const HlslFunction*> overloads(const std::vector<HlslFunction>& functions, const std::string& name,
                                           std::string_view body) {
    std::vector<const HlslFunction*> made;
    for (const HlslFunction& each : functions)
        if (each.name == name) made.push_back(&each);
    const auto is_half = [](const HlslFunction* each) {
        return each->parameters.find("half") != each->parameters.npos;
    };
    if (const auto count = std::ranges::count_if(made, is_half); count > 0 && count < std::ssize(made))
        std::erase_if(made, is_half);
    if (made.size() < 2) return made;
    const std::vector<std::size_t> counts = argument_counts(body, name);
    std::erase_if(made, [&](const HlslFunction* each) {
        return std::ranges::find(counts, arguments_of(each->parameters).size()) == counts.end();
    });
    return made;
}

// The function of the node, and those of the file that it calls.
Code from_file(GraphMaker& maker, std::size_t index, std::string_view own) {
    const Json* json = maker.node(index).json;
    const std::string source(text_of(json, "m_FunctionSource"));
    const std::filesystem::path as_path(source);
    const bool is_path = source.find('.') != source.npos;
    const auto found =
        maker.project().assets.find(is_path ? "" : source, is_path ? as_path.stem().string() : "", kIncludes);
    if (!found)
        return {
            .error = fmt::format("the file of its function '{}' is not in {}", own, maker.project().assets.folders()),
            .is_missing = true};
    std::string why;
    const std::optional<std::string> text = read_named_text(found->path, kIncludes, why);
    if (!text) return {.error = std::move(why)};
    const Included whole = with_includes(found->path, *text, maker.project().assets.searched());
    HlslText code = in_node_language(whole.text);
    if (!code.error.empty())
        return {.error = code.error + (whole.count > 0 ? ", counted with the files that it includes" : "")};
    code.code = with_texture_reads(std::move(code.code), {});
    const std::vector<HlslFunction> functions = functions_in(code.code);
    const auto main = std::ranges::find(functions, own, &HlslFunction::name);
    if (main == functions.end()) return {.error = fmt::format("'{}' has no function '{}_float'", found->path, own)};
    std::vector<const HlslFunction*> needed = {&*main};
    for (std::size_t i = 0; i < needed.size(); ++i)
        for (const HlslFunction& each : functions) {
            // A type or a variable may have the name, too.
            if (each.name == needed[i]->name || argument_counts(needed[i]->body, each.name).empty()) continue;
            if (std::ranges::find(needed, each.name, &HlslFunction::name) != needed.end()) continue;
            const std::vector<const HlslFunction*> fitting = overloads(functions, each.name, needed[i]->body);
            if (fitting.empty())
                return {.error = fmt::format("it calls '{}' with a count of arguments that no function of its file has",
                                             each.name)};
            needed.insert(needed.end(), fitting.begin(), fitting.end());
        }
    Code made{.main = *main, .ports = names_in(main->parameters)};
    for (const HlslMacro& each : code.macros) {
        const bool is_used =
            std::ranges::any_of(
                needed, [&](const HlslFunction* function) { return has_identifier(function->body, each.name); }) ||
            std::ranges::any_of(code.macros, [&](const HlslMacro& other) {
                return other.name != each.name && has_identifier(other.text, each.name);
            });
        if (is_used) made.macros.push_back(each);
    }
    // Of the whole file; only what these functions read is a parameter.
    const std::vector<std::string> names = hidden_names_in(code.parameters), values = arguments_of(code.parameters);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 1; j < needed.size(); ++j)
            if (has_identifier(needed[j]->body, names[i]))
                return {.error = fmt::format("it calls '{}', which reads values of the engine", needed[j]->name)};
        if (has_identifier(main->body, names[i]))
            made.engine_values += (made.engine_values.empty() ? "" : ", ") + values[i];
    }
    const std::size_t slots = maker.node(index).slots.size();
    if (made.ports.size() != slots)
        return {.error = fmt::format("its function '{}' has {} parameters, and the node has {} inputs and outputs", own,
                                     made.ports.size(), slots)};
    made.error = unassigned(maker.node(index), made, main->body);
    for (const HlslFunction& each : functions)
        if (&each != needed[0] && std::ranges::find(needed, &each) != needed.end()) made.helpers.push_back(each);
    return made;
}

std::string node_file(const Code& code, std::string_view name, std::string_view own, bool is_foreign) {
    const std::string_view mark = is_foreign ? "[foreign]\n" : "";
    std::string made = is_foreign ? "" : "#pragma hlsl\n\n";
    for (const HlslMacro& each : code.macros) made += each.text + "\n";
    if (!code.macros.empty()) made += "\n";
    for (const HlslFunction& each : code.helpers)
        made +=
            fmt::format("{}{} {}({}) {{\n{}}}\n\n", mark, each.result, each.name, each.parameters, indented(each.body));
    return made + fmt::format(
                      "/// The custom function '{0}' of the shader graph.\n[node(\"Custom/{1}\")]\n{2}"
                      "void {1}({3}{4}{5}) {{\n{6}}}\n",
                      own, name, mark, code.main.parameters,
                      code.main.parameters.empty() || code.engine_values.empty() ? "" : ", ", code.engine_values,
                      indented(code.main.body));
}

// A word that is declared outside of the functions: by the engine, or as a constant of the file. Empty: there is none.
std::string engine_word(const Code& code) {
    std::vector<std::string> functions;
    for (const HlslFunction& each : code.helpers) functions.push_back(each.name);
    for (std::string& each : hidden_names_in(code.engine_values)) functions.push_back(std::move(each));
    const auto unknown = [&](const HlslFunction& function) {
        std::vector<std::string> known = functions;
        for (std::string& each : names_in(function.parameters)) known.push_back(std::move(each));
        return unknown_word(function.body, known);
    };
    for (const HlslFunction& each : code.helpers)
        if (std::string word = unknown(each); !word.empty()) return word;
    return unknown(code.main);
}

// The first place where the code is no HLSL; empty: it is well-formed.
std::string grammar_mistake(const Code& code, bool is_file) {
    const auto said = [&](const HlslFunction& function) -> std::string {
        const std::optional<SyntaxError> wrong = syntax_error(function.body);
        if (!wrong) return {};
        std::string_view line = function.body;
        for (int i = 1; i < wrong->line; ++i) line.remove_prefix(std::min(line.find('\n') + 1, line.size()));
        line = line.substr(0, line.find('\n'));
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        return fmt::format("line {} of its {}: {}, in '{}'", wrong->line,
                           is_file ? fmt::format("function '{}'", function.name) : "code", wrong->text,
                           line.substr(0, 80));
    };
    for (const HlslFunction& each : code.helpers)
        if (std::string wrong = said(each); !wrong.empty()) return wrong;
    return said(code.main);
}

// What is wrong with the node file; empty: nothing.
std::string mistake(const std::string& file, const std::string& text) {
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        if (path == file) return text;
        return std::nullopt;
    };
    const NodeFileResult result = library().check_node_file(file, options);
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error) {
            const std::size_t begin = std::min(each.source_line.find_first_not_of(' '), each.source_line.size());
            return fmt::format("{}, in '{}'", each.message, as_written(each.source_line.substr(begin)).substr(0, 80));
        }
    return result.ok ? "" : "it is not valid";
}

}  // namespace

void make_custom_function(GraphMaker& maker, std::size_t index) {
    const Node& at = maker.node(index);
    const bool is_file = whole_of(at.json, "m_SourceType") == 0;
    const std::string_view written = text_of(at.json, "m_FunctionName");
    std::string own = identifier(written);
    if (own.empty() && (written.empty() || is_file)) {
        maker.refuse(index, written.empty()
                                ? "its function has no name"
                                : fmt::format("its function is called '{}', without any letter of English", written));
        return;
    }
    if (own.empty()) own = "Function";  // of code in the node, nobody else reads the name
    std::string name = own;
    name[0] = name[0] >= 'a' && name[0] <= 'z' ? static_cast<char>(name[0] - 32) : name[0];
    if (library().node(name)) name += "Custom";
    const Code code = is_file ? from_file(maker, index, own) : from_string(maker, index);
    if (code.is_missing && apply_known(maker, index, own)) {
        maker.approximate(index, code.error + ": it is taken for the usual function of this name");
        return;
    }
    if (!code.error.empty()) {
        maker.refuse(index, code.error);
        return;
    }
    std::string text = node_file(code, name, own, false);
    const std::string any_file = name + ".node.hlsl";
    if (const std::string wrong = mistake(any_file, text); !wrong.empty()) {
        if (const std::string no_hlsl = grammar_mistake(code, is_file); !no_hlsl.empty()) {
            maker.refuse(index, "its code is neither the node language nor HLSL: " + no_hlsl);
            return;
        }
        const std::string word = engine_word(code);
        if (word == "clip" || word == "discard") {
            maker.refuse(index, fmt::format("its code leaves out pixels ('{}'), which a function of the surface cannot "
                                            "do: use Alpha Clip Threshold",
                                            word));
            return;
        }
        if (!word.empty()) {
            maker.refuse(index, fmt::format("its code is not valid in the node language: {}. Nor is it whole as HLSL: "
                                            "the engine, or another part of its file, declares '{}'",
                                            wrong, as_written(word)));
            return;
        }
        text = node_file(code, name, own, true);
        if (!code.macros.empty() || !mistake(any_file, text).empty()) {
            maker.refuse(index, fmt::format("its code is not valid in the node language: {}", wrong));
            return;
        }
        maker.approximate(index, fmt::format("only HLSL takes its code, the text of a [foreign] function, because it "
                                             "is not valid in the node language: {}",
                                             wrong));
    }
    const std::string file = maker.node_file(name, text);
    maker.keep_node_file(file, text);
    if (code.engine_values.find("engineLight") != code.engine_values.npos)
        maker.approximate(index, "its main light is '@light', the light of the library");
    ImportedNode made{.id = {}, .node = "./" + file};
    Term holds;
    const std::vector<const Slot*> slots = ordered(at);
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (!slots[i]->is_input) continue;
        std::vector<Term> term = {maker.input(index, slots[i]->id, true)};
        maker.shorten(index, term, 0);
        holds.add_nodes(term[0]);
        made.inputs.push_back({code.ports[i], term[0].value()});
    }
    const std::string id = maker.add_node(index, std::move(made), camel_case(own));
    maker.written(holds, fmt::format("the node '{}'", id));
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (!slots[i]->is_input && maker.is_used(index, slots[i]->id))
            maker.set(index, slots[i]->id, link(id + "." + code.ports[i], maker.type_of(index, *slots[i])));
}

}  // namespace patina::importers::shadergraph
