// Compiles the combinations of a material's variants, and keeps each different program once.
#include "patina/variants.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "compiler/api/compile_source.h"
#include "compiler/api/compile_targets.h"
#include "compiler/api/report.h"
#include "compiler/link/canonical_hash.h"

namespace patina {
namespace {

std::string hash_of(const Result& result) {
    std::string passes;
    for (const Pass& pass : result.reflection.passes) passes += pass.name + " " + pass.hash + "\n";
    return link::hash_text(passes).text();
}

// Adds the first combination that a message applies to. Without a combination it applies to all.
Diagnostic where_it_is_so(const VariantValues& values) {
    std::string text = "where";
    for (const auto& [property, value] : values)
        text += fmt::format("{} {} = {}", text == "where" ? "" : ",", property, value);
    Diagnostic note;
    note.severity = Severity::Note;
    note.message = std::move(text);
    return note;
}

// Other combinations run the same program, so the reflection must not state this combination's values.
void forget_choice(Reflection& reflection, const std::vector<VariantAxis>& axes) {
    for (Property& property : reflection.properties) {
        for (const VariantAxis& axis : axes) {
            if (axis.property == property.name) property.value[0] = static_cast<double>(axis.otherwise);
        }
    }
}

// Compiles, and collects the diagnostics and dependencies that the results share.
class Gathering {
public:
    Gathering(const CompilerImpl& compiler, const std::string& path, resolve::Files& files, Trail& trail,
              VariantSet& set)
        : compiler_(compiler), source_{.path = path}, files_(files), trail_(trail), set_(set) {}

    // `values`: the combination; empty if the messages apply to all combinations, as they do if `is_first`.
    Result compile(const CompileOptions& options, const VariantValues& values, bool is_first) {
        Result result = compile_source(compiler_, source_, options, files_, trail_);
        for (Diagnostic& diagnostic : result.diagnostics) {
            if (!said_.insert(to_text(diagnostic)).second) continue;
            set_.diagnostics.push_back(diagnostic);
            if (!values.empty() && !is_first) set_.diagnostics.back().notes.push_back(where_it_is_so(values));
        }
        for (const std::string& file : result.dependencies) {
            if (read_.insert(file).second) set_.dependencies.push_back(file);
        }
        set_.missing = joined(set_.missing, result.missing);
        set_.ok = set_.ok && result.ok;
        return result;
    }

private:
    const CompilerImpl& compiler_;
    Source source_;
    resolve::Files& files_;
    Trail& trail_;
    VariantSet& set_;
    std::set<std::string> said_, read_;
};

// The programs of all combinations, one combination after the other.
class Variants {
public:
    Variants(const CompilerImpl& compiler, const std::string& path, const VariantPlan& plan, CompileOptions options,
             const std::function<void(VariantProgram)>& finished, Trail& trail)
        : plan_(plan),
          options_(std::move(options)),
          finished_(finished),
          files_(options_),
          gathering_(compiler, path, files_, trail, made_) {
        options_.hashes = true;
        options_.keep_variants = false;
        // Files that hold all combinations are written once.
        whole_ = options_;
        const resolve::Library& library = *compiler.library;
        std::erase_if(whole_.targets, [&](const Target& target) { return !holds_variants(library, target); });
        std::erase_if(options_.targets, [&](const Target& target) { return holds_variants(library, target); });
        fixed_ = options_.switches;
        made_.ok = plan.ok;
        if (!plan.ok) made_.diagnostics = plan.diagnostics;
        if (plan.ok && std::holds_alternative<CompileOptions::Functions>(options_.request)) refuse(Code::NoProgram);
    }

    VariantSet make(const std::function<void(std::size_t)>& progress) {
        if (!made_.ok) return std::move(made_);
        const std::size_t count = options_.targets.empty() ? 0 : plan_.count;
        for (std::size_t i = 0; i < count; ++i) {
            if (progress && !call([&] { progress(i); })) return std::move(made_);
            if (!compile(i)) return std::move(made_);
        }
        if (count == 0 && !whole_.targets.empty()) compile_whole_alone();
        return std::move(made_);
    }

private:
    // Calls a function of the program's. False: it has thrown, which ends the work.
    template <class Call>
    bool call(const Call& function) {
        std::string why;
        if (resolve::succeeds(function, why)) return true;
        refuse(Code::Cancelled, ": " + why);
        return false;
    }
    template <class... Words>
    void refuse(Code code, const Words&... words) {
        made_.diagnostics.push_back(diagnostic_of(code, words...));
        made_.ok = false;
    }

    // False if no other combination is to be compiled.
    bool compile(std::size_t index) {
        const VariantValues values = plan_.combination(index);
        options_.switches = fixed_;
        options_.switches.insert(options_.switches.end(), values.begin(), values.end());
        Result result = gathering_.compile(options_, values, index == 0);
        if (!result.ok) return !is_cancelled(result);
        if (made_.programs.empty() && !whole_.targets.empty()) compile_whole(result.reflection);
        const auto [found, is_new] = known_.emplace(hash_of(result), made_.programs.size());
        made_.program_of.push_back(found->second);
        if (!is_new) return true;
        forget_choice(result.reflection, plan_.axes);
        result.shaders.insert(result.shaders.end(), of_whole_.begin(), of_whole_.end());
        return deliver({.hash = found->first, .result = std::move(result)});
    }

    // False if no other combination is to be compiled.
    bool deliver(VariantProgram program) {
        made_.programs.push_back({.hash = program.hash, .result = {}});
        if (finished_) return call([&] { finished_(std::move(program)); });
        made_.programs.back() = std::move(program);
        return true;
    }

    void compile_whole(const Reflection& first) {
        without_switches(whole_.switches, first);
        of_whole_ = gathering_.compile(whole_, {}, true).shaders;
    }

    void compile_whole_alone() {
        Result file = gathering_.compile(whole_, {}, true);
        if (!file.ok) return;
        made_.program_of.assign(plan_.count, 0);
        const std::string hash = hash_of(file);
        deliver({.hash = hash, .result = std::move(file)});
    }

    const VariantPlan& plan_;
    CompileOptions options_, whole_;
    const std::function<void(VariantProgram)>& finished_;
    resolve::Files files_;
    VariantSet made_;
    Gathering gathering_;
    std::vector<std::pair<std::string, std::string>> fixed_;  // switches that the caller has given
    std::map<std::string, std::size_t> known_;                // programs by hash
    std::vector<Shader> of_whole_;
};

}  // namespace

VariantSet Compiler::compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                      const std::function<void(std::size_t)>& progress,
                                      const std::function<void(VariantProgram)>& finished) const {
    return guarded<VariantSet>(path, [&](Trail& trail) {
        return Variants(*impl_, path, plan, std::move(options), finished, trail).make(progress);
    });
}

}  // namespace patina
