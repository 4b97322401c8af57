#include "compiler/paths/stages.h"

#include <algorithm>

namespace patina::graph {
namespace {

using nodelang::Attribute;
using nodelang::FunctionDecl;
using nodelang::VariableDecl;

std::string stem(std::string_view path) {
    const std::string_view name = path.substr(path.find_last_of("/\\") + 1);
    return std::string(name.substr(0, name.find('.', 1)));
}

std::optional<Source> source_of(const VariableDecl& variable) {
    if (variable.attribute("attribute")) return Source::Attribute;
    if (variable.attribute("builtin")) return Source::Builtin;
    if (variable.attribute("given")) return Source::Given;
    if (variable.attribute("extern") && variable.attribute("semantic")) return Source::Extern;
    return {};
}

std::optional<Source> source_of(std::string_view rate) {
    if (rate == "vertex") return Source::Vertex;
    if (rate == "pixel") return Source::Pixel;
    if (rate == "uniform") return Source::Uniform;
    return {};
}

class Collector {
public:
    Collector(const nodelang::Declarations& declarations, const SourceMap& sources, Stages& stages,
              Diagnostics& diagnostics)
        : declarations_(declarations), sources_(sources), stages_(stages), diagnostics_(diagnostics) {}

    void variable(const VariableDecl& variable) {
        if (variable.attribute("extern") || variable.attribute("reads")) stages_.externs.push_back(&variable);
        if (variable.attribute("static")) stages_.statics.push_back(&variable);
        if (variable.attribute("foreign")) foreign(variable);
        if (const Attribute* attribute = variable.attribute("switch"))
            stages_.switches.push_back({.variable = &variable, .brings = nodelang::attribute_text(*attribute)});
        if (const std::optional<Source> source = source_of(variable)) {
            add({.name = variable.name,
                 .source = *source,
                 .variable = &variable,
                 .is_vertex_output = variable.attribute("vertexOutput") != nullptr,
                 .is_of_pass = is_of_pass(sources_, variable.span)});
        }
    }

    void function(const FunctionDecl& function) {
        if (function.attribute("slot")) stages_.slots.push_back(&function);
        if (function.attribute("export")) stages_.exports.push_back(&function);
        if (const Attribute* attribute = function.attribute("decodes"))
            stages_.decoders[nodelang::attribute_text(*attribute)] = &function;
        if (const Attribute* attribute = function.attribute("semantic")) {
            if (const std::optional<Source> source = source_of(nodelang::attribute_text(*attribute))) {
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
            stages_.given.push_back({.what = nodelang::attribute_text(attribute),
                                     .function = &function,
                                     .passes = attribute_words(attribute, 1),
                                     .is_of_file = attribute.args.size() == 1,
                                     .path = stem(sources_.resolve(function.span.begin).file)});
            if (attribute.args.empty())
                diagnostics_.report(Code::BadAttribute, attribute.span, "gives",
                                    "takes what is given, and passes: [gives(\"positionWS\", \"mine\")]");
        }
    }

private:
    void foreign(const VariableDecl& variable) {
        stages_.foreign.push_back(&variable);
        if (const Attribute* attribute = variable.attribute("gives"))
            stages_.given.push_back({.what = nodelang::attribute_text(*attribute),
                                     .variable = &variable,
                                     .passes = {},
                                     .is_of_file = true,
                                     .path = stem(sources_.resolve(variable.span.begin).file)});
    }

    void add(SemanticDecl semantic) {
        const auto [found, is_new] =
            stages_.semantic_index.emplace(semantic.name, static_cast<std::uint32_t>(stages_.semantics.size()));
        if (is_new) return stages_.semantics.push_back(semantic);
        // The latest declaration of a name counts, and graphs can read it if they could before.
        SemanticDecl& older = stages_.semantics[found->second];
        semantic.is_of_pass = semantic.is_of_pass && older.is_of_pass;
        older = semantic;
    }

    // One of the two functions of a pass.
    void stage_of(const FunctionDecl& function, const Attribute& attribute) {
        const std::string_view name = nodelang::attribute_text(attribute);
        const bool is_vertex = function.attribute("vertex") != nullptr;
        if (name.empty() || is_vertex == (function.attribute("fragment") != nullptr)) {
            diagnostics_.report(Code::BadAttribute, attribute.span, "pass",
                                "takes a name, and stands beside [vertex] or [fragment]");
            return;
        }
        auto pass = std::find_if(stages_.passes.begin(), stages_.passes.end(),
                                 [&](const PassDecl& p) { return p.name == name; });
        if (pass == stages_.passes.end()) {
            pass = stages_.passes.emplace(pass);
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
        if (is_vertex) return;
        PassDecl fresh;
        fresh.name = name;
        fresh.state.name = name;
        fresh.span = attribute.span;
        fresh.vertex = pass->vertex;
        fresh.is_older_vertex = pass->is_older_vertex;
        fresh.fragment = &function;
        *pass = std::move(fresh);
        pass->path = stem(sources_.resolve(function.span.begin).file);
        Diagnostics said;  // of several passes by one function, the first one says what is wrong
        const bool is_first = &attribute == function.attribute("pass");
        read_pass_state(function, declarations_, *pass, is_first ? diagnostics_ : said);
    }

    const nodelang::Declarations& declarations_;
    const SourceMap& sources_;
    Stages& stages_;
    Diagnostics& diagnostics_;
};

bool is_in(const std::vector<std::string_view>& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

// A file that begins as a copy of one of the library takes its place: passes, slots and the like go by their names.
void make_way(const nodelang::Ast& ast, Stages& stages) {
    std::vector<std::string_view> names;
    for (const VariableDecl& variable : ast.variables) names.push_back(variable.name);
    for (const FunctionDecl& function : ast.functions) {
        names.push_back(function.name);
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name != "gives") continue;
            const std::vector<std::string_view> passes = attribute_words(attribute, 1);
            for (GivenDecl& given : stages.given) {
                if (given.what == nodelang::attribute_text(attribute))
                    std::erase_if(given.passes, [&](std::string_view pass) { return is_in(passes, pass); });
            }
        }
    }
    for (PassDecl& pass : stages.passes) pass.is_older_vertex = pass.is_older_fragment = true;
    std::erase_if(stages.slots, [&](const FunctionDecl* slot) { return is_in(names, slot->name); });
    const auto is_repeated = [&](const VariableDecl* variable) {
        const bool found = is_in(names, variable->name);
        if (found) stages.repeated.push_back(variable);
        return found;
    };
    std::erase_if(stages.externs, is_repeated);
    std::erase_if(stages.statics, is_repeated);
    std::erase_if(stages.switches, [&](const SwitchDecl& each) { return is_repeated(each.variable); });
}

// What a pass excludes are switches; what a variable is there with, these or paths.
void check_conditions(const nodelang::Ast& ast, const Stages& stages, Diagnostics& diagnostics) {
    const auto check = [&](const Attribute* attribute, std::vector<std::string_view> known, const char* what) {
        if (!attribute) return;
        for (const SwitchDecl& each : stages.switches) known.push_back(each.variable->name);
        for (const std::string_view word : attribute_words(*attribute)) {
            if (std::find(known.begin(), known.end(), word) != known.end()) continue;
            diagnostics.report(Code::UnknownWord, attribute->span, word, what)
                .note(Diagnostics::suggestion(word, known));
        }
    };
    for (const FunctionDecl& function : ast.functions) check(function.attribute("excludes"), {}, "a switch of a pass");
    for (const VariableDecl& variable : ast.variables)
        check(variable.attribute("with"), stages.paths(), "a switch or a path");
}

}  // namespace

bool GivenDecl::is_for(const PassDecl& pass) const {
    return is_of_file ? pass.path == path : is_in(passes, pass.name);
}

const PassDecl* Stages::pass(std::string_view name) const {
    const auto found = std::find_if(passes.begin(), passes.end(), [&](const PassDecl& p) { return p.name == name; });
    return found == passes.end() ? nullptr : &*found;
}

std::vector<const PassDecl*> Stages::passes_of(std::string_view path) const {
    std::vector<const PassDecl*> of;
    for (const PassDecl& each : passes) {
        if (each.path == path && each.fragment) of.push_back(&each);
    }
    std::sort(of.begin(), of.end(),
              [](const PassDecl* a, const PassDecl* b) { return a->fragment->span.begin < b->fragment->span.begin; });
    return of;
}

std::vector<std::string_view> Stages::paths() const {
    std::vector<std::string_view> names;
    for (const PassDecl& each : passes) {
        if (!each.path.empty() && !is_in(names, each.path)) names.push_back(each.path);
    }
    return names;
}

const PassDecl* Stages::pass_for_extra(std::string_view path) const {
    const PassDecl* found = nullptr;
    for (const PassDecl& each : passes) {
        if (each.draws_extra && each.fragment && (!found || each.path == path)) found = &each;
    }
    return found;
}

const SemanticDecl* Stages::semantic(std::string_view name) const {
    const auto found = semantic_index.find(name);
    return found == semantic_index.end() ? nullptr : &semantics[found->second];
}

std::vector<std::string_view> attribute_words(const Attribute& attribute, std::size_t first) {
    std::vector<std::string_view> words;
    for (std::size_t i = first; i < attribute.args.size(); ++i) words.push_back(attribute.args[i]->text);
    return words;
}

void collect_stages(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const SourceMap& sources,
                    Stages& stages, Diagnostics& diagnostics) {
    make_way(ast, stages);
    Collector collector(declarations, sources, stages, diagnostics);
    for (const VariableDecl& variable : ast.variables) collector.variable(variable);
    for (const FunctionDecl& function : ast.functions) collector.function(function);
    check_conditions(ast, stages, diagnostics);
    for (const PassDecl& pass : stages.passes) {
        if (pass.vertex && pass.fragment) continue;
        diagnostics.report(Code::BadAttribute, pass.span, "pass",
                           pass.vertex ? "needs a [fragment] function, too" : "needs a [vertex] function, too");
    }
    check_stages(ast, declarations, sources, stages, diagnostics);
    check_passes(ast, declarations, stages, diagnostics);
}

}  // namespace patina::graph
