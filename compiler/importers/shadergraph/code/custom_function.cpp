// Nodes with code of their own: a string in the node, or a function of a file. The code becomes a node file: in the
// node language if it is valid there, else as the text of [foreign] functions.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ranges>

#include "compiler/base/text.h"
#include "compiler/importers/shadergraph/code/engine_words.h"
#include "compiler/importers/shadergraph/code/includes.h"
#include "compiler/importers/shadergraph/code/reads.h"
#include "compiler/importers/shadergraph/code/source.h"
#include "compiler/importers/shadergraph/graph_maker.h"
#include "compiler/importers/source_text.h"

namespace patina::importers::shadergraph {
namespace {

std::string port_of(const Slot& slot) {
    std::string name = identifier(text_of(slot.json, "m_ShaderOutputName"));
    return name.empty() ? identifier(slot.name) : name;
}

using nodelang::FunctionDecl;

// Before where it is not.
const std::string kNoHlsl = "its code is neither the node language nor HLSL: ";

struct Code {
    std::unique_ptr<Source> source{};
    std::vector<const FunctionDecl*> functions{};  // of the node, then those that it reaches
    std::vector<const nodelang::StructDecl*> structs{};
    std::vector<const nodelang::VariableDecl*> constants{};
    std::set<const EngineValue*> engine_values{};  // in the order of their table
    std::set<std::string_view> assigned{};         // variables of the node's function
    std::vector<std::string> ports{};              // of the node's inputs, then of its outputs
    std::string error{};
    bool is_missing = false;  // its file is not there

    const FunctionDecl& main() const { return *functions[0]; }
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

// --- which parts of the code are needed

// Those of the functions with a name that a call in the code may mean: by the count of its arguments; and of a pair for
// both precisions the one for full precision.
std::vector<const FunctionDecl*> overloads(const Source& source, std::string_view name, const Reads& reads) {
    std::vector<const FunctionDecl*> made;
    const bool is_own = source.is_own(source.function(name)->span);
    for (const FunctionDecl& each : source.ast().functions)
        if (each.name == name && source.is_own(each.span) == is_own) made.push_back(&each);
    const auto is_half = [](const FunctionDecl* each) {
        return std::ranges::any_of(each->params, [](const auto& param) { return param.type.name.starts_with("half"); });
    };
    if (const auto count = std::ranges::count_if(made, is_half); count > 0 && count < std::ssize(made))
        std::erase_if(made, is_half);
    if (made.size() < 2) return made;
    std::erase_if(made, [&](const FunctionDecl* each) {
        return std::ranges::none_of(reads.words, [&](const Word& word) {
            return word.kind == Word::Kind::Call && word.text == name && word.arguments == each->params.size();
        });
    });
    return made;
}

// The declaration with the name, if it was not needed before.
template <class Decl>
const Decl* newly_needed(const StableList<Decl>& all, std::string_view name, std::vector<const Decl*>& needed) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Decl& each) { return each.name == name; });
    if (found == all.end() || std::ranges::find(needed, &*found) != needed.end()) return nullptr;
    return needed.emplace_back(&*found);
}

// Adds what the function of the node reaches. Returns why it cannot have it.
std::string find_needed(Code& code) {
    const nodelang::Ast& ast = code.source->ast();
    std::vector<Reads> reads(1);
    std::vector<const FunctionDecl*> readers = code.functions;  // null: a constant or a struct
    reads[0].add(*readers[0]);
    code.assigned = reads[0].assigned;
    const auto add = [&](const auto& from, const FunctionDecl* reader) {
        reads.emplace_back().add(from);
        readers.push_back(reader);
    };
    for (std::size_t i = 0; i < reads.size(); ++i) {
        const Reads now = reads[i];
        for (const Word& word : now.words) {
            const bool is_name = word.kind == Word::Kind::Name;
            if (is_name && now.declared.contains(word.text)) continue;
            if (is_name) {
                const nodelang::VariableDecl* constant = newly_needed(ast.variables, word.text, code.constants);
                if (constant && code.source->is_constant(*constant)) {
                    add(constant->type, nullptr);
                    add(constant->value, nullptr);
                } else if (constant) {
                    code.constants.pop_back();
                }
            } else if (const nodelang::StructDecl* type = newly_needed(ast.structs, word.text, code.structs)) {
                for (const nodelang::MemberDecl& member : type->members) add(member.type, nullptr);
            }
            const auto value = std::ranges::find(kEngineValues, word.text, &EngineValue::name);
            if (is_name && value != std::end(kEngineValues)) {
                if (readers[i] != &code.main())
                    return fmt::format("it {}, which reads values of the engine",
                                       readers[i] ? fmt::format("calls '{}'", readers[i]->name) : "has a constant");
                code.engine_values.insert(&*value);
            }
            const bool is_new =
                word.kind == Word::Kind::Call && code.source->function(word.text) &&
                std::ranges::find(code.functions, word.text, &FunctionDecl::name) == code.functions.end();
            if (!is_new) continue;
            const std::vector<const FunctionDecl*> fitting = overloads(*code.source, word.text, now);
            if (fitting.empty())
                return fmt::format("it calls '{}' with a count of arguments that no function of its file has",
                                   word.text);
            for (const FunctionDecl* each : fitting) {
                code.functions.push_back(each);
                add(*each, each);
            }
        }
    }
    std::ranges::sort(code.functions.begin() + 1, code.functions.end(), {},
                      [](const FunctionDecl* each) { return each->span.begin; });
    return {};
}

// The first output that the code leaves as it is.
std::string unassigned(const Node& node, const Code& code) {
    const std::vector<const Slot*> slots = ordered(node);
    for (std::size_t i = 0; i < slots.size(); ++i)
        if (!slots[i]->is_input && !code.assigned.contains(code.ports[i]))
            return fmt::format("its code never assigns its output '{}'", code.ports[i]);
    return {};
}

Code from_string(GraphMaker& maker, std::size_t index) {
    std::set<std::string, std::less<>> samplers;
    for (const Slot& slot : maker.node(index).slots) {
        if (port_of(slot).empty())
            return {.error = fmt::format("its {} '{}' has a name without any letter of English",
                                         slot.is_input ? "input" : "output", slot.name)};
        if (maker.type_of(index, slot) == Type::Sampler) samplers.insert(port_of(slot));
    }
    constexpr std::string_view kName = "Main";
    Code made;
    made.source =
        std::make_unique<Source>(std::string(text_of(maker.node(index).json, "m_FunctionBody")),
                                 fmt::format("void {}({})", kName, signature(maker, index)), std::move(samplers));
    made.error = made.source->error();
    if (made.error.empty() && !made.source->mistake().empty()) made.error = kNoHlsl + made.source->mistake();
    if (!made.error.empty()) return made;
    made.functions = {made.source->function(kName)};
    for (const Slot* slot : ordered(maker.node(index))) made.ports.push_back(port_of(*slot));
    made.error = find_needed(made);
    if (made.error.empty()) made.error = unassigned(maker.node(index), made);
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
    Included whole = with_includes(found->path, *text, maker.project().assets.searched());
    Code made;
    made.source = std::make_unique<Source>(std::move(whole.text), "", std::set<std::string, std::less<>>());
    const std::string_view counted = whole.count > 0 ? ", counted with the files that it includes" : "";
    made.error = made.source->error();
    if (!made.error.empty()) {
        made.error += counted;
        return made;
    }
    const FunctionDecl* main = made.source->function(own);
    if (!main || !made.source->is_own(main->span)) {
        made.error = fmt::format("'{}' has no function '{}_float'", found->path, own);
        if (const std::string& mistake = made.source->mistake(); !mistake.empty())
            made.error += fmt::format(" that can be read: {}{}", mistake, counted);
        return made;
    }
    made.functions = {main};
    for (const nodelang::ParamDecl& param : main->params) made.ports.emplace_back(param.name);
    made.error = find_needed(made);
    if (!made.error.empty()) return made;
    const std::size_t slots = maker.node(index).slots.size();
    made.error = made.ports.size() == slots
                     ? unassigned(maker.node(index), made)
                     : fmt::format("its function '{}' has {} parameters, and the node has {} inputs and outputs", own,
                                   made.ports.size(), slots);
    return made;
}

// --- the node file

struct NodeText {
    std::string text{};
    std::vector<int> lines{};  // of the code, for each line of the text

    void add(std::string_view part, int line = 0) {
        text += part;
        lines.insert(lines.end(), static_cast<std::size_t>(std::ranges::count(part, '\n')), line);
    }
};

void add_body(const Source& source, const FunctionDecl& function, NodeText& into) {
    const std::string_view body = source.body(function);
    std::ptrdiff_t number = source.line_of(body);
    const char* counted = body.data();
    std::size_t depth = 1;
    for (std::string_view line : split(body, "\n")) {
        number += std::count(counted, line.data(), '\n');
        counted = line.data();
        line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        if (line.empty()) continue;
        const bool closes = line.starts_with("}");
        if (closes && depth > 1) --depth;
        into.add(fmt::format("{}{}\n", std::string(depth * 4, ' '), line), static_cast<int>(number));
        for (const char c : line.substr(closes ? 1 : 0)) {
            if (c == '{') ++depth;
            if (c == '}' && depth > 1) --depth;
        }
    }
}

std::string declared(const Source& source, const nodelang::TypeName& type, std::string_view name) {
    return fmt::format("{} {}{}", type.name, name,
                       type.array_size ? fmt::format("[{}]", source.text(type.array_size->span)) : "");
}

std::string parameters(const Source& source, const FunctionDecl& function) {
    std::string made;
    for (const nodelang::ParamDecl& each : function.params)
        made += fmt::format("{}{}{}{}", made.empty() ? "" : ", ",
                            each.is_inout ? "inout "
                            : each.is_out ? "out "
                                          : "",
                            declared(source, each.type, each.name),
                            each.initial ? fmt::format(" = {}", source.text(each.initial->span)) : "");
    return made;
}

NodeText node_file(const Code& code, std::string_view name, std::string_view own, bool is_foreign) {
    const Source& source = *code.source;
    const std::string_view mark = is_foreign ? "[foreign]\n" : "";
    NodeText made;
    if (!is_foreign) made.add(fmt::format("{}\n\n", nodelang::kHlslMark));
    for (const nodelang::StructDecl* each : code.structs) {
        made.add(fmt::format("struct {} {{\n", each->name));
        for (const nodelang::MemberDecl& member : each->members)
            made.add(fmt::format("    {};\n", declared(source, member.type, member.name)));
        made.add("};\n\n");
    }
    for (const nodelang::VariableDecl* each : code.constants)
        made.add(fmt::format("static const {} = {};\n", declared(source, each->type, each->name),
                             source.text(each->value->span)),
                 source.line_of(source.text(each->span)));
    if (!code.constants.empty()) made.add("\n");
    const auto add = [&](const FunctionDecl& each, std::string_view before, std::string_view called,
                         std::string_view more) {
        made.add(before);
        made.add(fmt::format("{} {}({}{}) {{\n", each.result.name, called, parameters(source, each), more),
                 source.line_of(source.text(each.span)));
        add_body(source, each, made);
        made.add("}\n");
    };
    for (const FunctionDecl* each : code.functions | std::views::drop(1)) {
        add(*each, mark, each->name, "");
        made.add("\n");
    }
    std::string more;
    for (const EngineValue* each : code.engine_values)
        more += fmt::format("{}{}", more.empty() && code.main().params.empty() ? "" : ", ", each->parameter);
    add(code.main(),
        fmt::format("/// The custom function '{}' of the shader graph.\n[node(\"Custom/{}\")]\n{}", own, name, mark),
        name, more);
    return made;
}

// A word that is declared outside of the functions: by the engine, or as a constant of the file. Empty: there is none.
std::string engine_word(const Code& code) {
    std::set<std::string_view> functions, values;
    for (const FunctionDecl* each : code.functions)
        if (code.source->is_own(each->span)) functions.insert(each->name);
    for (const EngineValue* each : code.engine_values) values.insert(each->name);
    for (std::size_t i = 1; i <= code.functions.size(); ++i) {  // that of the node is the last one
        const FunctionDecl& function = *code.functions[i % code.functions.size()];
        Reads reads;
        if (code.source->is_own(function.span)) reads.add(function);
        for (const Word& word : reads.words) {
            const bool is_known = word.kind == Word::Kind::Name
                                      ? reads.declared.contains(word.text) || values.contains(word.text)
                                      : is_of_hlsl(word.text) || functions.contains(word.text);
            if (!is_known) return std::string(word.text);
        }
    }
    return {};
}

struct Mistake {
    std::string text{};
    bool is_no_hlsl = false;
};
// What is wrong with the node file; nothing: it is valid.
std::optional<Mistake> mistake(const Source& source, const std::string& file, const NodeText& made) {
    CompileOptions options;
    options.files.read = [&](const std::string& path) -> std::optional<std::string> {
        if (path == file) return made.text;
        return std::nullopt;
    };
    const NodeFileResult result = library().check_node_file(file, options);
    if (result.ok) return {};
    nodelang::Ast ast;
    Diagnostics wrong;
    nodelang::parse_file({.text = made.text}, ast, wrong);
    const auto line = [&](std::size_t number) { return number < made.lines.size() ? made.lines[number] : 0; };
    for (const DiagnosticRecord& each : wrong.records()) {
        const std::string_view before = std::string_view(made.text).substr(0, each.span.begin);
        const int at = line(static_cast<std::size_t>(std::ranges::count(before, '\n')));
        if (is_no_hlsl(each.code)) return Mistake{source.at_line(at, each.message), true};
    }
    for (const Diagnostic& each : result.diagnostics)
        if (each.severity == Severity::Error)
            return Mistake{each.message +
                           source.quoted(each.line > 0 ? line(static_cast<std::size_t>(each.line) - 1) : 0)};
    return Mistake{"it is not valid"};
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
    NodeText text = node_file(code, name, own, false);
    const std::string any_file = name + ".node.hlsl";
    if (const std::optional<Mistake> wrong = mistake(*code.source, any_file, text)) {
        if (wrong->is_no_hlsl) {
            maker.refuse(index, kNoHlsl + wrong->text);
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
                                            wrong->text, word));
            return;
        }
        text = node_file(code, name, own, true);
        if (mistake(*code.source, any_file, text)) {
            maker.refuse(index, fmt::format("its code is not valid in the node language: {}", wrong->text));
            return;
        }
        maker.approximate(index, fmt::format("only HLSL takes its code, the text of a [foreign] function, because it "
                                             "is not valid in the node language: {}",
                                             wrong->text));
    }
    const std::string file = maker.node_file(name, text.text);
    maker.keep_node_file(file, text.text);
    if (code.engine_values.contains(&kEngineValues[0]))
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
