#include <algorithm>

#include "compiler/paths/reading.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::FunctionDecl;
using nodelang::VariableDecl;

std::optional<SemanticSource> source_of(const VariableDecl& variable) {
    if (variable.attribute("attribute")) return SemanticSource::Attribute;
    if (variable.attribute("builtin")) return SemanticSource::Builtin;
    if (variable.attribute("given")) return SemanticSource::Given;
    if (variable.attribute("extern") && variable.attribute("semantic")) return SemanticSource::Extern;
    return {};
}

std::optional<SemanticSource> source_of(std::string_view rate) {
    if (rate == "vertex") return SemanticSource::Vertex;
    if (rate == "pixel") return SemanticSource::Pixel;
    if (rate == "uniform") return SemanticSource::Uniform;
    return {};
}

class Collector {
public:
    Collector(const nodelang::Declarations& declarations, const SourceMap& sources, PathDeclarations& paths,
              Diagnostics& diagnostics)
        : declarations_(declarations), sources_(sources), paths_(paths), diagnostics_(diagnostics) {}

    void variable(const VariableDecl& variable) {
        if (variable.attribute("extern") || variable.attribute("reads")) read_extern(variable);
        if (const Attribute* attribute = variable.attribute("static")) read_static(variable, *attribute);
        if (variable.attribute("foreign")) foreign(variable);
        if (const Attribute* attribute = variable.attribute("switch")) read_switch(variable, *attribute);
        if (const std::optional<SemanticSource> source = source_of(variable)) {
            add({.name = variable.name,
                 .source = *source,
                 .variable = &variable,
                 .builtin = builtin_of(variable),
                 .is_vertex_output = variable.attribute("vertexOutput") != nullptr,
                 .is_uv = variable.attribute("uv") != nullptr,
                 .is_of_pass = is_of_pass(sources_, variable.span)});
        }
    }

    void function(const FunctionDecl& function) {
        if (function.attribute("slot")) read_slot(function);
        if (function.attribute("extern")) paths_.extern_functions.push_back(&function);
        if (const Attribute* attribute = function.attribute("wraps")) read_wrap(function, *attribute);
        if (const Attribute* attribute = function.attribute("export"))
            paths_.exports.push_back({.function = &function, .name = nodelang::attribute_text(*attribute)});
        if (function.attribute("foreign"))
            paths_.foreign_functions.push_back({.function = &function, .texts = texts_of(function)});
        if (const Attribute* attribute = function.attribute("decodes"))
            paths_.decoders[nodelang::attribute_text(*attribute)] = {.function = &function,
                                                                     .follower = word(*attribute, 1),
                                                                     .at_once = word(*attribute, 2),
                                                                     .texts = texts_of(function)};
        if (const Attribute* attribute = function.attribute("semantic")) {
            if (const std::optional<SemanticSource> source = source_of(nodelang::attribute_text(*attribute))) {
                add({.name = function.name,
                     .source = *source,
                     .function = &function,
                     .is_of_pass = is_of_pass(sources_, function.span)});
            } else {
                diagnostics_.report(Code::BadAttribute, attribute->span, "semantic", "takes vertex, pixel or uniform");
            }
        }
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name == "pass") stage_of(function, attribute);
            if (attribute.name != "gives") continue;
            paths_.given.push_back({.what = nodelang::attribute_text(attribute),
                                    .function = &function,
                                    .passes = attribute_words(attribute, 1),
                                    .is_of_file = attribute.args.size() == 1,
                                    .is_of_fragment = function.attribute("fragment") != nullptr,
                                    .path = stem(sources_.resolve(function.span.begin).file)});
            if (attribute.args.empty())
                diagnostics_.report(Code::BadAttribute, attribute.span, "gives",
                                    "takes a semantic or function, and passes: [gives(\"positionWS\", \"mine\")]");
        }
    }

private:
    // Empty if the attribute has fewer arguments.
    static std::string_view word(const Attribute& attribute, std::size_t index) {
        return index < attribute.args.size() ? attribute.args[index]->text : std::string_view();
    }

    // check_declarations() reports errors in them.
    static std::vector<ir::StageText> texts_of(const FunctionDecl& function) {
        Diagnostics ignored;
        return paths::texts_of(function.attributes, ignored);
    }

    static ir::Builtin builtin_of(const VariableDecl& variable) {
        const Attribute* attribute = variable.attribute("builtin");
        for (const BuiltinWord& row : builtin_words()) {
            if (attribute && row.text == nodelang::attribute_text(*attribute)) return row.builtin;
        }
        return ir::Builtin::None;
    }

    void read_switch(const VariableDecl& variable, const Attribute& attribute) {
        const Attribute* otherwise = variable.attribute("otherwise");
        paths_.switches.push_back({.variable = &variable,
                                   .brings = nodelang::attribute_text(attribute),
                                   .otherwise = otherwise ? word(*otherwise, 0) : std::string_view()});
    }

    void read_extern(const VariableDecl& variable) {
        ExternDecl& made = paths_.externs.emplace_back();
        made.variable = &variable;
        if (const Attribute* attribute = variable.attribute("extern"))
            made.block = nodelang::attribute_text(*attribute);
        else
            made.reads = nodelang::attribute_text(*variable.attribute("reads"));
        if (const Attribute* with = variable.attribute("with")) made.with = attribute_words(*with);
        made.is_per_object = variable.attribute("perObject") != nullptr;
    }

    void read_wrap(const FunctionDecl& function, const Attribute& attribute) {
        for (const WrapWord& row : wrap_words()) {
            if (row.text != nodelang::attribute_text(attribute)) continue;
            WrapDecl& made = paths_.wraps.emplace_back();
            made.function = &function;
            made.what = row.what;
            if (const Attribute* with = function.attribute("with")) made.with = attribute_words(*with);
        }
    }

    void read_static(const VariableDecl& variable, const Attribute& attribute) {
        StaticDecl& made = paths_.statics.emplace_back();
        made.variable = &variable;
        made.words = attribute_words(attribute, 1);
        for (const StaticWord& row : static_words()) {
            if (row.text == nodelang::attribute_text(attribute)) made.about = row.about;
        }
    }

    void read_slot(const FunctionDecl& function) {
        using Making = SlotDecl::Making;
        SlotDecl& made = paths_.slots.emplace_back();
        made.function = &function;
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name == "part" || attribute.name == "without") {
                made.making = attribute.name == "part" ? Making::Part : Making::Without;
                made.of = word(attribute, 0);
                made.source = word(attribute, 1);
                made.is_componentwise = word(attribute, 2) == "componentwise";
            } else if (attribute.name == "pack") {
                made.making = Making::Pack;
                made.readers = attribute_words(attribute);
            } else if (attribute.name == "unpack") {
                made.making = Making::Unpack;
                made.of = word(attribute, 0);
            } else if (attribute.name == "holds") {
                made.holds = attribute_words(attribute);
            } else if (attribute.name == "otherwise") {
                made.otherwise = word(attribute, 0);
            }
        }
        for (std::size_t i = 0; i < function.params.size(); ++i) {
            for (const Attribute& attribute : function.params[i].attributes) {
                if (attribute.name == "perLight") made.light_param = i;
            }
        }
    }

    void foreign(const VariableDecl& variable) {
        ForeignDecl& made = paths_.foreign.emplace_back();
        made.variable = &variable;
        made.spelling = nodelang::attribute_text(*variable.attribute("foreign"));
        if (made.spelling.empty()) made.spelling = variable.name;
        Diagnostics ignored;
        const std::vector<ir::StageText> texts = paths::texts_of(variable.attributes, ignored);
        if (!texts.empty()) made.include = texts.front().line;
        if (const Attribute* attribute = variable.attribute("gives"))
            paths_.given.push_back({.what = nodelang::attribute_text(*attribute),
                                    .variable = &variable,
                                    .passes = {},
                                    .is_of_file = true,
                                    .path = stem(sources_.resolve(variable.span.begin).file)});
    }

    void add(SemanticDecl semantic) {
        const auto [found, is_new] =
            paths_.semantic_index.emplace(semantic.name, static_cast<std::uint32_t>(paths_.semantics.size()));
        if (is_new) return paths_.semantics.push_back(semantic);
        // The latest declaration of a name counts, and graphs can read it if they could before.
        SemanticDecl& older = paths_.semantics[found->second];
        semantic.is_of_pass = semantic.is_of_pass && older.is_of_pass;
        older = semantic;
    }

    // Adds one of the two functions of a pass.
    void stage_of(const FunctionDecl& function, const Attribute& attribute) {
        const std::string_view name = nodelang::attribute_text(attribute);
        const bool is_vertex = function.attribute("vertex") != nullptr;
        if (name.empty() || is_vertex == (function.attribute("fragment") != nullptr)) {
            diagnostics_.report(Code::BadAttribute, attribute.span, "pass",
                                "takes a name, and needs either [vertex] or [fragment]");
            return;
        }
        auto pass =
            std::find_if(paths_.passes.begin(), paths_.passes.end(), [&](const PassDecl& p) { return p.name == name; });
        if (pass == paths_.passes.end()) {
            pass = paths_.passes.emplace(pass);
            pass->name = name;
            pass->state.name = name;
            pass->span = attribute.span;
        }
        const FunctionDecl*& stage = is_vertex ? pass->vertex : pass->fragment;
        bool& is_older = is_vertex ? pass->is_older_vertex : pass->is_older_fragment;
        if (stage && !is_older) {
            diagnostics_
                .report(Code::DuplicateId, attribute.span,
                        is_vertex ? "[vertex] function of a pass" : "[fragment] function of a pass", name)
                .note(stage->name_span, "the first one is here");
            return;
        }
        stage = &function;
        is_older = false;
        if (is_vertex) {
            pass->vertex_texts = texts_of(function);
            return;
        }
        PassDecl fresh;
        fresh.name = name;
        fresh.state.name = name;
        fresh.span = attribute.span;
        fresh.vertex = pass->vertex;
        fresh.is_older_vertex = pass->is_older_vertex;
        fresh.vertex_texts = std::move(pass->vertex_texts);
        fresh.fragment_texts = texts_of(function);
        fresh.fragment = &function;
        *pass = std::move(fresh);
        pass->path = stem(sources_.resolve(function.span.begin).file);
        Diagnostics said;  // if one function is several passes, only the first one reports
        const bool is_first = &attribute == function.attribute("pass");
        read_pass_state(function, declarations_, *pass, is_first ? diagnostics_ : said);
    }

    const nodelang::Declarations& declarations_;
    const SourceMap& sources_;
    PathDeclarations& paths_;
    Diagnostics& diagnostics_;
};

bool is_in(const std::vector<std::string_view>& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

// A file may begin as a copy of a library file. Its declarations then replace those of the same names: passes, slots,
// values of the engine.
void make_way(const nodelang::Ast& ast, PathDeclarations& paths) {
    std::vector<std::string_view> names;
    for (const VariableDecl& variable : ast.variables) names.push_back(variable.name);
    for (const FunctionDecl& function : ast.functions) {
        names.push_back(function.name);
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name != "gives") continue;
            const std::vector<std::string_view> passes = attribute_words(attribute, 1);
            for (GivenDecl& given : paths.given) {
                if (given.what == nodelang::attribute_text(attribute))
                    std::erase_if(given.passes, [&](std::string_view pass) { return is_in(passes, pass); });
            }
        }
    }
    for (PassDecl& pass : paths.passes) pass.is_older_vertex = pass.is_older_fragment = true;
    std::erase_if(paths.slots, [&](const SlotDecl& slot) { return is_in(names, slot.name()); });
    const auto is_repeated = [&](const VariableDecl* variable) {
        const bool found = is_in(names, variable->name);
        if (found) paths.repeated.push_back(variable);
        return found;
    };
    const auto of_repeated = [&](const auto& each) { return is_repeated(each.variable); };
    std::erase_if(paths.externs, of_repeated);
    std::erase_if(paths.switches, of_repeated);
}

// What a pass can lack.
std::vector<std::string_view> values_of(const PathDeclarations& paths) {
    std::vector<std::string_view> values;
    for (const SemanticDecl& each : paths.semantics) values.push_back(each.name);
    for (const ExternDecl& each : paths.externs) {
        for (const std::string_view name : {std::string_view(each.variable->name), each.block, each.reads})
            if (!name.empty() && !is_in(values, name)) values.push_back(name);
    }
    return values;
}

// A pass can exclude switches. A variable can exist with switches or paths.
void check_conditions(const nodelang::Ast& ast, const PathDeclarations& paths, Diagnostics& diagnostics) {
    const auto check = [&](const Attribute* attribute, std::vector<std::string_view> known, const char* what) {
        for (const SwitchDecl& each : paths.switches) known.push_back(each.variable->name);
        for (const std::string_view word : attribute_words(*attribute)) {
            if (std::find(known.begin(), known.end(), word) != known.end()) continue;
            diagnostics.report(Code::UnknownWord, attribute->span, word, what)
                .note(Diagnostics::suggestion(word, known));
        }
    };
    std::optional<std::vector<std::string_view>> values;  // asked for by few files
    for (const FunctionDecl& function : ast.functions) {
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name != "lacks") continue;
            if (!values) values = values_of(paths);
            check(&attribute, *values, "a value, a block, a target or a switch");
        }
        if (const Attribute* excluded = function.attribute("excludes")) check(excluded, {}, "a switch of a pass");
        if (const Attribute* with = function.attribute("with")) check(with, {}, "a switch");
    }
    for (const VariableDecl& variable : ast.variables) {
        if (const Attribute* with = variable.attribute("with")) check(with, paths.names(), "a switch or a path");
    }
}

}  // namespace

bool GivenDecl::is_for(const PassDecl& pass) const {
    return is_of_file ? pass.path == path : is_in(passes, pass.name);
}

const PassDecl* PathDeclarations::pass(std::string_view name) const {
    const auto found = std::find_if(passes.begin(), passes.end(), [&](const PassDecl& p) { return p.name == name; });
    return found == passes.end() ? nullptr : &*found;
}

std::vector<const PassDecl*> PathDeclarations::passes_of(std::string_view path) const {
    std::vector<const PassDecl*> of;
    for (const PassDecl& each : passes) {
        if (each.path == path && each.fragment && !each.draws_extra_alone) of.push_back(&each);
    }
    std::sort(of.begin(), of.end(),
              [](const PassDecl* a, const PassDecl* b) { return a->fragment->span.begin < b->fragment->span.begin; });
    return of;
}

std::vector<std::string_view> PathDeclarations::names() const {
    std::vector<std::string_view> names;
    for (const PassDecl& each : passes) {
        if (!each.path.empty() && !is_in(names, each.path)) names.push_back(each.path);
    }
    return names;
}

bool PathDeclarations::is_drawn_along(std::string_view path, const PassDecl& pass) const {
    if (pass.path == path || &pass == pass_for_extra(path)) return true;
    std::vector<std::string_view> drawn = {path};
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        for (const PassDecl* each : passes_of(drawn[i])) {
            if (!each->state.fallback.empty() && !is_in(drawn, each->state.fallback))
                drawn.push_back(each->state.fallback);
        }
    }
    return is_in(drawn, pass.path) || std::any_of(switches.begin(), switches.end(),
                                                  [&](const SwitchDecl& each) { return each.brings == pass.name; });
}

const PassDecl* PathDeclarations::pass_for_extra(std::string_view path) const {
    const PassDecl* found = nullptr;
    for (const PassDecl& each : passes) {
        if (each.draws_extra && each.fragment && (!found || each.path == path)) found = &each;
    }
    return found;
}

const SemanticDecl* PathDeclarations::semantic(std::string_view name) const {
    const auto found = semantic_index.find(name);
    return found == semantic_index.end() ? nullptr : &semantics[found->second];
}

const SlotDecl* PathDeclarations::slot(std::string_view name) const {
    const auto found = std::find_if(slots.begin(), slots.end(), [&](const SlotDecl& s) { return s.name() == name; });
    return found == slots.end() ? nullptr : &*found;
}

bool PathDeclarations::is_hdr(std::string_view member) const {
    return is_in(hdr_members, member);
}

const SwitchDecl* PathDeclarations::switch_named(std::string_view name) const {
    const auto found = std::find_if(switches.begin(), switches.end(),
                                    [&](const SwitchDecl& each) { return each.variable->name == name; });
    return found == switches.end() ? nullptr : &*found;
}

const SwitchDecl* PathDeclarations::switch_of(const VariableDecl* variable) const {
    const auto found = std::find_if(switches.begin(), switches.end(),
                                    [&](const SwitchDecl& each) { return each.variable == variable; });
    return found == switches.end() ? nullptr : &*found;
}

const ExternDecl* PathDeclarations::extern_of(const VariableDecl* variable) const {
    const auto found =
        std::find_if(externs.begin(), externs.end(), [&](const ExternDecl& each) { return each.variable == variable; });
    return found == externs.end() ? nullptr : &*found;
}

std::string stem(std::string_view path) {
    const std::string_view name = path.substr(path.find_last_of("/\\") + 1);
    return std::string(name.substr(0, name.find('.', 1)));
}

std::vector<std::string_view> attribute_words(const Attribute& attribute, std::size_t first) {
    std::vector<std::string_view> words;
    for (std::size_t i = first; i < attribute.args.size(); ++i) words.push_back(attribute.args[i]->text);
    return words;
}

void collect(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
             PathDeclarations& paths, Diagnostics& diagnostics) {
    make_way(ast, paths);
    Collector collector(declarations, sources, paths, diagnostics);
    for (const nodelang::StructDecl& structure : ast.structs) {
        for (const nodelang::MemberDecl& member : structure.members) {
            if (member.attribute("hdr")) paths.hdr_members.push_back(member.name);
        }
    }
    for (const VariableDecl& variable : ast.variables) collector.variable(variable);
    for (const FunctionDecl& function : ast.functions) collector.function(function);
    check_conditions(ast, paths, diagnostics);
    // The first match is used, so recipes for named passes come first.
    std::stable_partition(paths.given.begin(), paths.given.end(),
                          [](const GivenDecl& given) { return !given.is_of_file; });
    for (const PassDecl& pass : paths.passes) {
        if (pass.vertex && pass.fragment) continue;
        diagnostics.report(Code::BadAttribute, pass.span, "pass",
                           pass.vertex ? "also needs a [fragment] function" : "also needs a [vertex] function");
    }
    check_declarations(ast, declarations, sources, paths, diagnostics);
    check_passes(ast, declarations, paths, diagnostics);
}

}  // namespace patina::paths
