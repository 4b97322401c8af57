#include "compiler/api/compile_targets.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "compiler/api/report.h"
#include "compiler/link/dumps.h"

namespace patina {
namespace {

void join(Result& into, Result from) {
    into.ok = into.ok && from.ok;
    const auto is_new = [&](const Diagnostic& d) {
        const std::string text = to_json(d);
        return std::none_of(into.diagnostics.begin(), into.diagnostics.end(),
                            [&](const Diagnostic& other) { return to_json(other) == text; });
    };
    for (Diagnostic& d : from.diagnostics)
        if (is_new(d)) into.diagnostics.push_back(std::move(d));
    for (Shader& shader : from.shaders) into.shaders.push_back(std::move(shader));
    std::set<std::string> known(into.dependencies.begin(), into.dependencies.end());
    for (std::string& file : from.dependencies)
        if (known.insert(file).second) into.dependencies.push_back(std::move(file));
    into.missing = joined(into.missing, from.missing);
    for (Dump& dump : from.dumps) into.dumps.push_back(std::move(dump));
    if (into.ok) return;
    into.shaders.clear();
    into.program = nullptr;
}

struct EngineTargets {
    const engines::Engine* engine = nullptr;
    std::vector<Target> targets;
};

// Groups the targets by engine, in the order in which the engines are first named. Engines with passes of their own
// come last.
std::vector<EngineTargets> by_engine(const resolve::Library& library, const std::vector<Target>& targets) {
    std::vector<EngineTargets> made;
    for (const Target& target : targets) {
        const engines::Engine* engine = library.engine(target.engine);
        auto found = std::find_if(made.begin(), made.end(), [&](const auto& each) { return each.engine == engine; });
        if (found == made.end()) found = made.insert(found, {.engine = engine, .targets = {}});
        // The default engine may be given by its name, too.
        const auto is_same = [&](const Target& other) { return other.language == target.language; };
        if (std::none_of(found->targets.begin(), found->targets.end(), is_same)) found->targets.push_back(target);
    }
    std::stable_partition(made.begin(), made.end(),
                          [](const EngineTargets& each) { return !each.engine || !each.engine->has_own_passes(); });
    return made;
}

// An error for a target whose engine or language is not in the library.
std::optional<Diagnostic> unknown_target(const resolve::Library& library, const Target& target) {
    const engines::Engine* engine = library.engine(target.engine);
    const auto& languages = engine ? engine->languages : std::vector<std::string>{};
    if (engine && std::find(languages.begin(), languages.end(), target.language) != languages.end()) return {};
    Diagnostics diagnostics;
    DiagnosticRecord& record = diagnostics.report(Code::UnknownWord, {}, engine ? target.language : target.engine,
                                                  engine ? "a language of this engine" : "an engine");
    std::vector<std::string_view> known(languages.begin(), languages.end());
    if (!engine) {
        for (const auto& [name, each] : library.engines) known.push_back(name);
    }
    record.note(Diagnostics::suggestion(engine ? target.language : target.engine, known));
    return to_public(diagnostics, library.sources).front();
}

std::optional<Diagnostic> unknown_dump(const resolve::Library& library, std::string_view step) {
    if (std::find(link::kDumps.begin(), link::kDumps.end(), step) != link::kDumps.end()) return {};
    Diagnostics diagnostics;
    diagnostics.report(Code::UnknownWord, {}, step, "a step that can be dumped")
        .note(Diagnostics::suggestion(step, link::kDumps));
    return to_public(diagnostics, library.sources).front();
}

// A switch with two different values. No value means "true".
std::optional<Diagnostic> two_values(const resolve::Library& library, const CompileOptions& options) {
    std::map<std::string_view, std::string_view> values;
    for (const auto& [name, given] : options.switches) {
        const std::string_view value = given.empty() ? std::string_view("true") : given;
        const auto [first, is_new] = values.emplace(name, value);
        if (is_new || first->second == value) continue;
        Diagnostics diagnostics;
        diagnostics.report(Code::TwoValues, {}, name, first->second, value);
        return to_public(diagnostics, library.sources).front();
    }
    return {};
}

void check_shader_bytes(const resolve::Library& library, std::size_t most, Result& result) {
    std::size_t bytes = 0;
    for (const Shader& shader : result.shaders) bytes += shader.text.size();
    if (bytes <= most) return;
    Diagnostics diagnostics;
    diagnostics.report(Code::OverBudget, {}, "bytes of shader text", bytes, most);
    result.diagnostics.push_back(to_public(diagnostics, library.sources).front());
    result.ok = false;
    result.shaders.clear();
    result.program = nullptr;
}

Result refused(Diagnostic why) {
    Result result;
    result.diagnostics.push_back(std::move(why));
    return result;
}

}  // namespace

bool is_cancelled(const Result& result) {
    return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                       [](const Diagnostic& each) { return each.code == info(Code::Cancelled).name; });
}

std::vector<std::string> joined(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    std::vector<std::string> both;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    return both;
}

void without_switches(std::vector<std::pair<std::string, std::string>>& given, const Reflection& of_path) {
    std::erase_if(given, [&](const auto& each) {
        return std::any_of(of_path.switches.begin(), of_path.switches.end(),
                           [&](const Switch& s) { return s.name == each.first; });
    });
}

bool holds_variants(const resolve::Library& library, const Target& target) {
    const engines::Engine* engine = library.engine(target.engine);
    return engine && engine->variants == engines::Variants::Keywords;
}

Result compile_targets(const resolve::Library& library, const CompileOptions& options,
                       const CompileForEngine& compile) {
    if (std::optional<Diagnostic> twice = two_values(library, options)) return refused(std::move(*twice));
    for (const Target& target : options.targets) {
        if (std::optional<Diagnostic> unknown = unknown_target(library, target)) return refused(std::move(*unknown));
    }
    for (const std::string& step : options.dump) {
        if (std::optional<Diagnostic> unknown = unknown_dump(library, step)) return refused(std::move(*unknown));
    }
    std::optional<Result> result;
    std::vector<EngineTargets> engines = by_engine(library, options.targets);
    // A program for the interpreter needs one of the library's paths.
    const bool has_usual = !engines.empty() && !engines.front().engine->has_own_passes();
    if (engines.empty() || (options.keep_programs && !has_usual)) {
        CompileOptions usual = options;
        usual.targets.clear();
        result = compile(usual);
    }
    for (EngineTargets& each : engines) {
        if (result && is_cancelled(*result)) break;  // the program has asked for this already
        CompileOptions own = options;
        own.targets = std::move(each.targets);
        own.keep_programs = options.keep_programs && !result;
        if (each.engine->has_own_passes()) {
            own.keep_programs = false;
            if (CompileOptions::Passes* passes = own.passes()) passes->only.clear();
        }
        if (each.engine->variants == engines::Variants::Keywords) own.keep_variants = true;
        if (result && each.engine->has_own_passes()) without_switches(own.switches, result->reflection);
        if (result)
            join(*result, compile(own));
        else
            result = compile(own);
    }
    check_shader_bytes(library, options.limits.shader_bytes, *result);
    return std::move(*result);
}

}  // namespace patina
