// The functions of patina/patina_c.h for variants.
#include <memory>
#include <optional>
#include <string_view>

#include "compiler/capi/handles.h"
#include "compiler/json/json_writer.h"

struct patina_plan {
    std::string path{};
    patina::CompileOptions options{};
    patina::VariantPlan plan{};
    std::string messages{}, diagnostics{}, axes{};
    std::vector<std::string> combinations{};
};

struct patina_variants {
    patina::VariantSet set{};
    std::string messages{}, diagnostics{};
    std::vector<std::unique_ptr<patina_result>> programs{};
};

namespace patina::capi {
namespace {

std::optional<VariantsWanted> wanted_by(std::string_view word) {
    for (const VariantsWanted each : {VariantsWanted::All, VariantsWanted::Listed, VariantsWanted::Reachable})
        if (to_string(each) == word) return each;
    return std::nullopt;
}

std::string json_of_axes(const std::vector<VariantAxis>& axes) {
    JsonWriter json;
    json.begin('[');
    for (const VariantAxis& axis : axes) {
        json.begin('{');
        json.if_any("property", axis.property);
        json.if_any("values", axis.values);
        json.if_any("default", axis.values[axis.otherwise]);
        json.end();
    }
    json.end();
    return json.take();
}

std::string json_of_values(const VariantValues& values) {
    JsonWriter json;
    json.begin('{');
    for (const auto& [property, value] : values) json.if_any(property, value);
    json.end();
    return json.take();
}

}  // namespace
}  // namespace patina::capi

using namespace patina::capi;

extern "C" {

patina_status patina_plan_variants(const patina_compiler* compiler, const char* path, const char* wanted, size_t limit,
                                   const char* options, const patina_callbacks* callbacks, patina_plan** plan) {
    if (!plan) return PATINA_BAD_ARGUMENT;
    *plan = nullptr;
    if (!compiler || !path || !wanted) return PATINA_BAD_ARGUMENT;
    const std::optional<patina::VariantsWanted> chosen = wanted_by(wanted);
    if (!chosen) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        auto made = std::make_unique<patina_plan>();
        made->path = path;
        made->plan.diagnostics = settle(*compiler, options, callbacks, made->options);
        if (made->plan.diagnostics.empty())
            made->plan = compiler->compiler.plan_variants(path, *chosen, made->options, limit);
        refuse_without_memory(made->plan.ok, made->plan.diagnostics);
        made->messages = messages_of(made->plan.diagnostics);
        made->diagnostics = json_of(made->plan.diagnostics);
        made->axes = json_of_axes(made->plan.axes);
        for (std::size_t i = 0; i < made->plan.count; ++i)
            made->combinations.push_back(json_of_values(made->plan.combination(i)));
        const bool is_ok = made->plan.ok;
        *plan = made.release();
        return is_ok ? PATINA_OK : PATINA_HAS_ERRORS;
    });
}

size_t patina_plan_count(const patina_plan* plan) {
    return plan ? plan->combinations.size() : 0;
}

const char* patina_plan_combination(const patina_plan* plan, size_t index) {
    return plan && index < plan->combinations.size() ? plan->combinations[index].c_str() : nullptr;
}

const char* patina_plan_axes(const patina_plan* plan) {
    return plan ? plan->axes.c_str() : "[]";
}

const char* patina_plan_messages(const patina_plan* plan) {
    return plan ? plan->messages.c_str() : "";
}

const char* patina_plan_diagnostics(const patina_plan* plan) {
    return plan ? plan->diagnostics.c_str() : "[]";
}

void patina_plan_free(patina_plan* plan) {
    delete plan;
}

patina_status patina_compile_variants(const patina_compiler* compiler, const patina_plan* plan,
                                      patina_variants** variants) {
    if (!variants) return PATINA_BAD_ARGUMENT;
    *variants = nullptr;
    if (!compiler || !plan) return PATINA_BAD_ARGUMENT;
    return guarded([&] {
        auto made = std::make_unique<patina_variants>();
        made->set = compiler->compiler.compile_variants(plan->path, plan->plan, plan->options);
        patina::VariantSet& set = made->set;
        refuse_without_memory(set.ok, set.diagnostics);
        made->messages = messages_of(set.diagnostics);
        made->diagnostics = json_of(set.diagnostics);
        if (!set.ok) set.programs.clear(), set.program_of.clear();
        for (patina::VariantProgram& program : set.programs) {
            program.result.diagnostics.clear();
            program.result.dependencies.clear();
            program.result.missing.clear();
            made->programs.push_back(std::make_unique<patina_result>());
            made->programs.back()->result = std::move(program.result);
            complete(*made->programs.back());
        }
        const bool is_ok = set.ok;
        *variants = made.release();
        return is_ok ? PATINA_OK : PATINA_HAS_ERRORS;
    });
}

size_t patina_variants_program_count(const patina_variants* variants) {
    return variants ? variants->programs.size() : 0;
}

const patina_result* patina_variants_program(const patina_variants* variants, size_t index) {
    return variants && index < variants->programs.size() ? variants->programs[index].get() : nullptr;
}

const char* patina_variants_hash(const patina_variants* variants, size_t index) {
    return variants && index < variants->programs.size() ? variants->set.programs[index].hash.c_str() : nullptr;
}

size_t patina_variants_program_of(const patina_variants* variants, size_t combination) {
    return variants && combination < variants->set.program_of.size() ? variants->set.program_of[combination]
                                                                     : static_cast<size_t>(-1);
}

const char* patina_variants_messages(const patina_variants* variants) {
    return variants ? variants->messages.c_str() : "";
}

const char* patina_variants_diagnostics(const patina_variants* variants) {
    return variants ? variants->diagnostics.c_str() : "[]";
}

size_t patina_variants_dependency_count(const patina_variants* variants) {
    return size_of(variants ? &variants->set.dependencies : nullptr);
}

const char* patina_variants_dependency(const patina_variants* variants, size_t index) {
    return text_at(variants ? &variants->set.dependencies : nullptr, index);
}

size_t patina_variants_missing_count(const patina_variants* variants) {
    return size_of(variants ? &variants->set.missing : nullptr);
}

const char* patina_variants_missing(const patina_variants* variants, size_t index) {
    return text_at(variants ? &variants->set.missing : nullptr, index);
}

void patina_variants_free(patina_variants* variants) {
    delete variants;
}

}  // extern "C"
