// What the combinations of a material's variants compile to: each different program once.
#include "patina/variants.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "compiler/assemble/canonical_hash.h"

namespace patina {
namespace {

std::string hash_of(const Result& result) {
    std::string passes;
    for (const Pass& pass : result.reflection.passes) passes += pass.name + " " + pass.hash + "\n";
    return assemble::hash_text(passes).text();
}

// The first combination that a message is said of; without one it holds for the first of all.
Diagnostic where_it_is_so(const VariantValues& values) {
    std::string text = "where";
    for (const auto& [property, value] : values)
        text += fmt::format("{} {} = {}", text == "where" ? "" : ",", property, value);
    Diagnostic note;
    note.severity = Severity::Note;
    note.message = std::move(text);
    return note;
}

// Other combinations run it too: its variants have no values of their own.
void forget_choice(Reflection& reflection, const std::vector<VariantAxis>& axes) {
    for (Property& property : reflection.properties) {
        for (const VariantAxis& axis : axes) {
            if (axis.property == property.name) property.value[0] = static_cast<double>(axis.otherwise);
        }
    }
}

}  // namespace

VariantSet Compiler::compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                      const std::function<void(std::size_t)>& progress) const {
    options.hashes = true;
    options.keep_variants = false;
    const auto fixed = options.switches;
    VariantSet made;
    made.ok = plan.ok;
    std::map<std::string, std::size_t> known;
    std::set<std::string> said, read;
    for (std::size_t i = 0; i < plan.count; ++i) {
        if (progress) progress(i);
        const VariantValues values = plan.combination(i);
        options.switches = fixed;
        options.switches.insert(options.switches.end(), values.begin(), values.end());
        Result result = compile_file(path, options);
        for (Diagnostic& diagnostic : result.diagnostics) {
            if (!said.insert(to_text(diagnostic)).second) continue;
            made.diagnostics.push_back(std::move(diagnostic));
            if (!values.empty() && i > 0) made.diagnostics.back().notes.push_back(where_it_is_so(values));
        }
        for (const std::string& file : result.dependencies) {
            if (read.insert(file).second) made.dependencies.push_back(file);
        }
        made.ok = made.ok && result.ok;
        if (!result.ok) continue;
        const auto [found, is_new] = known.emplace(hash_of(result), made.programs.size());
        made.program_of.push_back(found->second);
        if (!is_new) continue;
        forget_choice(result.reflection, plan.axes);
        made.programs.push_back({.hash = found->first, .result = std::move(result)});
    }
    return made;
}

}  // namespace patina
