// Compiles the combinations of a material's variants, and keeps each different program once.
#include "patina/variants.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "compiler/api/compile_targets.h"
#include "compiler/api/compiler_impl.h"
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
    Gathering(const Compiler& compiler, const std::string& path, VariantSet& set)
        : compiler_(compiler), path_(path), set_(set) {}

    // `values`: the combination; empty if the messages apply to all combinations, as they do if `is_first`.
    Result compile(const CompileOptions& options, const VariantValues& values, bool is_first) {
        Result result = compiler_.compile_file(path_, options);
        for (Diagnostic& diagnostic : result.diagnostics) {
            if (!said_.insert(to_text(diagnostic)).second) continue;
            set_.diagnostics.push_back(std::move(diagnostic));
            if (!values.empty() && !is_first) set_.diagnostics.back().notes.push_back(where_it_is_so(values));
        }
        for (const std::string& file : result.dependencies) {
            if (read_.insert(file).second) set_.dependencies.push_back(file);
        }
        set_.ok = set_.ok && result.ok;
        return result;
    }

private:
    const Compiler& compiler_;
    const std::string& path_;
    VariantSet& set_;
    std::set<std::string> said_, read_;
};

}  // namespace

VariantSet Compiler::compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                      const std::function<void(std::size_t)>& progress) const {
    options.hashes = true;
    options.keep_variants = false;
    VariantSet made;
    made.ok = plan.ok;
    Gathering gathering(*this, path, made);
    // Files that hold all combinations are written once.
    CompileOptions whole = options;
    std::erase_if(whole.targets, [&](const Target& target) { return !holds_variants(*impl_->library, target); });
    std::erase_if(options.targets, [&](const Target& target) { return holds_variants(*impl_->library, target); });
    const auto fixed = options.switches;
    std::map<std::string, std::size_t> known;
    for (std::size_t i = 0; i < plan.count && !options.targets.empty(); ++i) {
        if (progress) progress(i);
        const VariantValues values = plan.combination(i);
        options.switches = fixed;
        options.switches.insert(options.switches.end(), values.begin(), values.end());
        Result result = gathering.compile(options, values, i == 0);
        if (!result.ok) continue;
        const auto [found, is_new] = known.emplace(hash_of(result), made.programs.size());
        made.program_of.push_back(found->second);
        if (!is_new) continue;
        forget_choice(result.reflection, plan.axes);
        made.programs.push_back({.hash = found->first, .result = std::move(result)});
    }
    if (whole.targets.empty() || !made.ok) return made;
    if (!made.programs.empty()) without_switches(whole.switches, made.programs.front().result.reflection);
    Result file = gathering.compile(whole, {}, true);
    if (!file.ok) return made;
    for (VariantProgram& program : made.programs)
        program.result.shaders.insert(program.result.shaders.end(), file.shaders.begin(), file.shaders.end());
    if (!made.programs.empty()) return made;
    made.program_of.assign(plan.count, 0);
    made.programs.push_back({.hash = hash_of(file), .result = std::move(file)});
    return made;
}

}  // namespace patina
