// The combinations of a material's variants: which there are, and what they compile to.
#include "patina/variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "compiler/assemble/canonical_hash.h"
#include "compiler/graph/json.h"
#include "compiler/graph/material.h"
#include "compiler/graph/read_graph.h"
#include "compiler/impl.h"
#include "compiler/report.h"

namespace patina {
namespace {

struct Axis {
    const graph::Property* property;
    VariantAxis told;
};

std::vector<Axis> open_axes(const graph::Material& material) {
    std::vector<Axis> axes;
    for (const graph::MaterialProperty& entry : material.properties) {
        if (entry.property->binding != graph::Binding::Variant || entry.is_chosen) continue;
        axes.push_back({.property = entry.property,
                        .told = {.property = entry.property->name,
                                 .values = {},
                                 .otherwise = static_cast<std::size_t>(entry.property->value[0])}});
        for (const std::string_view word : graph::keyword_words(*entry.property))
            axes.back().told.values.emplace_back(word);
    }
    return axes;
}

double product(const std::vector<Axis>& axes) {
    double count = 1;
    for (const Axis& axis : axes) count *= static_cast<double>(axis.told.values.size());
    return count;
}

// `count` is what all axes together make; each note says what the combinations are without that axis.
void refuse(graph::Session& session, const graph::Graph& graph, const std::vector<Axis>& axes, std::string count,
            std::size_t limit) {
    DiagnosticRecord& record = session.diagnostics.report(Code::TooMany, {graph.span.begin, graph.span.begin + 1},
                                                          count, "combinations of variants", limit);
    for (const Axis& axis : axes) {
        std::vector<Axis> others;
        std::copy_if(axes.begin(), axes.end(), std::back_inserter(others),
                     [&](const Axis& other) { return other.property != axis.property; });
        record.note(axis.property->name_span,
                    fmt::format("'{}' multiplies them by {}: without it there are {:.0f}", axis.told.property,
                                axis.told.values.size(), product(others)));
    }
    record.note("-D NAME=VALUE fixes one");
}

std::vector<VariantValues> all_of(const std::vector<Axis>& axes) {
    std::vector<VariantValues> combinations = {{}};
    for (const Axis& axis : axes) {
        std::vector<VariantValues> longer;
        for (const VariantValues& values : combinations) {
            for (const std::string& value : axis.told.values) {
                longer.push_back(values);
                longer.back().emplace_back(axis.told.property, value);
            }
        }
        combinations = std::move(longer);
    }
    return combinations;
}

std::vector<VariantValues> listed_in(const graph::Graph& graph, const std::vector<Axis>& axes) {
    std::vector<VariantValues> combinations;
    for (const graph::ListedVariant& listed : graph.variants) {
        VariantValues& values = combinations.emplace_back();
        for (const Axis& axis : axes) {
            const auto given = std::find_if(listed.values.begin(), listed.values.end(),
                                            [&](const auto& each) { return each.name == axis.told.property; });
            values.emplace_back(axis.told.property,
                                given == listed.values.end() ? axis.told.values[axis.told.otherwise] : given->word);
        }
        if (std::find(combinations.begin(), combinations.end() - 1, values) != combinations.end() - 1)
            combinations.pop_back();
    }
    return combinations;
}

// A tree of choices: the first property that is still read after the choices so far is the next one.
class Reachable {
public:
    Reachable(const Compiler& compiler, const std::string& path, const CompileOptions& options,
              const std::vector<Axis>& axes, std::size_t limit)
        : compiler_(compiler), path_(path), options_(options), axes_(axes), limit_(limit) {
        options_.targets.clear();
        options_.keep_variants = true;
        options_.keep_programs = options_.hashes = false;
        options_.dump.clear();
    }

    // False: there are more than the limit, or the graph is wrong.
    bool walk(const VariantValues& chosen) {
        CompileOptions options = options_;
        options.switches.insert(options.switches.end(), chosen.begin(), chosen.end());
        const Result result = compiler_.compile_file(path_, options);
        if (!result.ok) {
            diagnostics = result.diagnostics;
            return false;
        }
        const Axis* next = first_read(result.reflection);
        if (!next) {
            combinations.push_back(in_order(chosen));
            return combinations.size() <= limit_;
        }
        return std::all_of(next->told.values.begin(), next->told.values.end(), [&](const std::string& value) {
            VariantValues longer = chosen;
            longer.emplace_back(next->told.property, value);
            return walk(longer);
        });
    }

    std::vector<VariantValues> combinations{};
    std::vector<Diagnostic> diagnostics{};

private:
    const Axis* first_read(const Reflection& reflection) const {
        const auto is_read = [&](const Axis& axis) {
            return std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
                return std::count(pass.keywords.begin(), pass.keywords.end(), axis.told.property) > 0;
            });
        };
        const auto found = std::find_if(axes_.begin(), axes_.end(), is_read);
        return found == axes_.end() ? nullptr : &*found;
    }
    VariantValues in_order(VariantValues values) const {
        const auto place = [&](const auto& value) {
            return std::find_if(axes_.begin(), axes_.end(),
                                [&](const Axis& axis) { return axis.told.property == value.first; });
        };
        std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
        return values;
    }

    const Compiler& compiler_;
    const std::string& path_;
    CompileOptions options_;
    const std::vector<Axis>& axes_;
    std::size_t limit_;
};

void plan(const Compiler& compiler, graph::Session& session, const std::string& path, VariantsWanted wanted,
          std::size_t limit, VariantPlan& made) {
    const std::optional<std::uint32_t> base = graph::load_source(session, path, {});
    const auto json = base ? graph::parse_json(session.sources, *base, session.diagnostics) : nullptr;
    if (!json) return;
    const auto read =
        graph::read_graph(*json, path, session.sources, session.ast, session.diagnostics, graph::GraphKind::Material);
    if (!read) return;
    const auto material = graph::resolve_material(session, read, {});
    if (!material || session.diagnostics.has_errors()) return;
    const std::vector<Axis> axes = open_axes(*material);
    for (const Axis& axis : axes) made.axes.push_back(axis.told);
    switch (wanted) {
        case VariantsWanted::All:
            if (const double count = product(axes); count > static_cast<double>(limit))
                return refuse(session, *read, axes, fmt::format("{:.0f}", count), limit);
            made.combinations = all_of(axes);
            return;
        case VariantsWanted::Listed:
            made.combinations = listed_in(*read, axes);
            if (made.combinations.size() > limit)
                return refuse(session, *read, {}, std::to_string(made.combinations.size()), limit);
            if (!made.combinations.empty()) return;
            session.diagnostics
                .report(Code::MissingKey, {read->span.begin, read->span.begin + 1}, "the graph", "variants")
                .note("it lists combinations: \"variants\": [ { \"_DETAIL\": true }, { \"_Mode\": \"Wet\" } ]");
            return;
        case VariantsWanted::Reachable: {
            Reachable reachable(compiler, path, session.options, axes, limit);
            const bool fits = reachable.walk({});
            made.combinations = std::move(reachable.combinations);
            made.diagnostics = std::move(reachable.diagnostics);
            if (!fits && made.diagnostics.empty())
                refuse(session, *read, axes, fmt::format("more than {}", limit), limit);
            return;
        }
    }
}

std::string hash_of(const Result& result) {
    std::string passes;
    for (const Pass& pass : result.reflection.passes) passes += pass.name + " " + pass.hash + "\n";
    return assemble::hash_text(passes).text();
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

std::string_view to_string(VariantsWanted wanted) {
    switch (wanted) {
        case VariantsWanted::All: return "all";
        case VariantsWanted::Listed: return "listed";
        case VariantsWanted::Reachable: return "reachable";
    }
    return {};
}

VariantPlan Compiler::plan_variants(const std::string& path, VariantsWanted wanted, const CompileOptions& options,
                                    std::size_t limit) const {
    graph::Session session(*impl_->library, options);
    VariantPlan made;
    plan(*this, session, path, wanted, std::min(limit, kMostVariants), made);
    const std::vector<Diagnostic> own = to_public(session.diagnostics, session.sources);
    made.diagnostics.insert(made.diagnostics.end(), own.begin(), own.end());
    made.ok = std::none_of(made.diagnostics.begin(), made.diagnostics.end(),
                           [](const Diagnostic& d) { return d.severity == Severity::Error; });
    if (!made.ok) made.combinations.clear();
    return made;
}

VariantSet Compiler::compile_variants(const std::string& path, const VariantPlan& plan, CompileOptions options,
                                      const std::function<void(std::size_t)>& progress) const {
    options.hashes = true;
    options.keep_variants = false;
    const auto fixed = options.switches;
    VariantSet made;
    made.ok = plan.ok;
    std::map<std::string, std::size_t> known;
    std::set<std::string> said, read;
    for (std::size_t i = 0; i < plan.combinations.size(); ++i) {
        if (progress) progress(i);
        options.switches = fixed;
        options.switches.insert(options.switches.end(), plan.combinations[i].begin(), plan.combinations[i].end());
        Result result = compile_file(path, options);
        for (Diagnostic& diagnostic : result.diagnostics) {
            if (said.insert(to_text(diagnostic)).second) made.diagnostics.push_back(std::move(diagnostic));
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
