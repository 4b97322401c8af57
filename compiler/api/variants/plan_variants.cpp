// Plans the combinations of a material's variants: all, those that the graph lists, or those with different shaders. If
// there are too many, reports how much each variant contributes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compiler/api/compile_source.h"
#include "compiler/api/report.h"
#include "compiler/base/text.h"
#include "compiler/resolve/material.h"
#include "patina/variants.h"

namespace patina {
namespace {

// A variant without a value, and its declaration.
struct Axis {
    const format::Property* property;
    VariantAxis info;
};

std::vector<Axis> open_axes(const resolve::Material& material) {
    std::vector<Axis> axes;
    for (const resolve::MaterialProperty& entry : material.properties) {
        if (entry.property->binding != Binding::Variant || entry.is_chosen) continue;
        axes.push_back({.property = entry.property,
                        .info = {.property = entry.property->name,
                                 .values = {},
                                 .otherwise = static_cast<std::size_t>(entry.property->value[0]),
                                 .is_bool = entry.property->type == PropertyType::Bool}});
        for (const std::string_view word : resolve::keyword_words(*entry.property))
            axes.back().info.values.emplace_back(word);
    }
    return axes;
}

// The number of combinations without one axis.
using Without = std::function<std::string(const Axis&)>;

void refuse(resolve::Session& session, const format::Graph& graph, const std::vector<Axis>& axes, std::string count,
            std::size_t limit, const Without& without) {
    DiagnosticRecord& record = session.diagnostics.report(Code::TooMany, {graph.span.begin, graph.span.begin + 1},
                                                          count, "combinations of variants", limit);
    for (const Axis& axis : axes) {
        const std::string left = without(axis);
        if (left == count) continue;
        record.note(axis.property->name_span,
                    fmt::format("'{}' has {} values: if it has one value, the number of combinations is {}",
                                axis.info.property, axis.info.values.size(), left));
    }
    record.note("give some of them a value, or set another limit");
}

std::string count_text(double count) {
    return fmt::format("{:.0f}", count);
}

void plan_all(resolve::Session& session, const format::Graph& graph, const std::vector<Axis>& axes, std::size_t limit,
              VariantPlan& made) {
    const double count = combinations_of(made.axes);
    if (count > static_cast<double>(limit))
        return refuse(session, graph, axes, count_text(count), limit, [&](const Axis& axis) {
            return count_text(std::round(count / static_cast<double>(axis.info.values.size())));
        });
    made.count = static_cast<std::size_t>(count);
}

// --- listed

// The word that the caller has given a property, or null.
const std::string* fixed_word(const resolve::Session& session, const std::string& property) {
    const auto& switches = session.options.switches;
    const auto found =
        std::find_if(switches.rbegin(), switches.rend(), [&](const auto& each) { return each.first == property; });
    return found == switches.rend() ? nullptr : &found->second;
}

bool contradicts(const resolve::Session& session, const format::ListedVariant& listed) {
    return std::any_of(listed.values.begin(), listed.values.end(), [&](const auto& value) {
        const std::string* fixed = fixed_word(session, value.name);
        return fixed && (fixed->empty() ? "true" : *fixed) != value.word;
    });
}

void plan_listed(resolve::Session& session, const resolve::Material& material, const std::vector<Axis>& axes,
                 std::size_t limit, VariantPlan& made) {
    const format::Graph& graph = *material.graph->graph;
    if (graph.variants.empty()) {
        session.diagnostics.report(Code::MissingKey, {graph.span.begin, graph.span.begin + 1}, "the graph", "variants")
            .note("list the combinations: \"variants\": [ { \"_DETAIL\": true }, { \"_Mode\": \"Wet\" } ]");
        return;
    }
    std::set<VariantValues> known;
    for (const format::ListedVariant& listed : graph.variants) {
        if (contradicts(session, listed)) continue;
        VariantValues values;
        for (const Axis& axis : axes) {
            const auto given = std::find_if(listed.values.begin(), listed.values.end(),
                                            [&](const auto& each) { return each.name == axis.info.property; });
            values.emplace_back(axis.info.property,
                                given == listed.values.end() ? axis.info.values[axis.info.otherwise] : given->word);
        }
        if (known.insert(values).second) made.picked.push_back(std::move(values));
    }
    made.count = made.picked.size();
    if (made.count > limit) return refuse(session, graph, {}, std::to_string(made.count), limit, {});
    if (made.count > 0) return;
    std::vector<std::string> fixed;
    for (const resolve::MaterialProperty& entry : material.properties) {
        if (entry.property->binding == Binding::Variant && entry.is_chosen)
            fixed.push_back(
                fmt::format("{} = {}", entry.property->name,
                            resolve::keyword_words(*entry.property)[static_cast<std::size_t>(entry.chosen)]));
    }
    const std::vector<std::string_view> views(fixed.begin(), fixed.end());
    const bool is_one = views.size() == 1;
    session.diagnostics.report(Code::NothingListed, graph.variants[0].span, enumerate(views),
                               is_one ? "excludes" : "exclude", is_one ? "remove it, or " : "remove one, or ");
}

// --- reachable

// A tree of choices: the next choice is the first property that is still read after the choices so far.
class Reachable {
public:
    Reachable(const CompilerImpl& compiler, const std::string& path, const CompileOptions& options,
              resolve::Files& files, const std::vector<Axis>& axes, std::size_t most,
              std::function<bool(std::size_t)> progress, Trail& trail)
        : compiler_(compiler),
          source_{.path = path},
          options_(options),
          files_(files),
          axes_(axes),
          most_(most),
          progress_(std::move(progress)),
          trail_(trail) {
        options_.targets.clear();
        options_.keep_variants = true;
        options_.keep_programs = options_.hashes = false;
        options_.dump.clear();
    }

    // False if there are more combinations than the limit, the graph has errors, or the program stops it.
    bool walk(const VariantValues& chosen) {
        // No property is left, so there is nothing to find out by compiling.
        if (chosen.size() == axes_.size()) return add(chosen);
        CompileOptions options = options_;
        options.switches.insert(options.switches.end(), chosen.begin(), chosen.end());
        const Result result = compile_source(compiler_, source_, options, files_, trail_);
        if (!result.ok) {
            diagnostics = result.diagnostics;
            return false;
        }
        const std::vector<const Axis*> read = read_in(result.reflection);
        if (chosen.empty()) multiplying = read;
        if (read.empty()) return add(chosen);
        const Axis* next = read.front();
        return std::all_of(next->info.values.begin(), next->info.values.end(), [&](const std::string& value) {
            VariantValues longer = chosen;
            longer.emplace_back(next->info.property, value);
            return walk(longer);
        });
    }

    std::vector<VariantValues> combinations{};
    std::vector<const Axis*> multiplying{};  // read while none has a value: no others make a difference
    std::vector<Diagnostic> diagnostics{};

private:
    bool add(const VariantValues& chosen) {
        if (combinations.size() == most_) return false;
        combinations.push_back(in_order(chosen));
        return progress_(combinations.size());
    }
    std::vector<const Axis*> read_in(const Reflection& reflection) const {
        std::vector<const Axis*> read;
        for (const Axis& axis : axes_) {
            const bool is_read = std::any_of(reflection.passes.begin(), reflection.passes.end(), [&](const Pass& pass) {
                return std::count(pass.keywords.begin(), pass.keywords.end(), axis.info.property) > 0;
            });
            if (is_read) read.push_back(&axis);
        }
        return read;
    }
    VariantValues in_order(VariantValues values) const {
        const auto place = [&](const auto& value) {
            return std::find_if(axes_.begin(), axes_.end(),
                                [&](const Axis& axis) { return axis.info.property == value.first; });
        };
        std::sort(values.begin(), values.end(), [&](const auto& a, const auto& b) { return place(a) < place(b); });
        return values;
    }

    const CompilerImpl& compiler_;
    Source source_;
    CompileOptions options_;
    resolve::Files& files_;
    const std::vector<Axis>& axes_;
    std::size_t most_;
    std::function<bool(std::size_t)> progress_;
    Trail& trail_;
};

// Calls the program's function. False: it has thrown, which ends the work as `cancelled` does.
bool tell(resolve::Session& session, const std::function<void(const VariantPlan&)>& progress, const VariantPlan& made) {
    if (!progress) return true;
    return resolve::call_program(session, [&] { progress(made); });
}

void plan_reachable(const CompilerImpl& compiler, resolve::Session& session, const std::string& path,
                    const format::Graph& graph, const std::vector<Axis>& axes, std::size_t limit,
                    const std::function<void(const VariantPlan&)>& progress, Trail& trail, VariantPlan& made) {
    if (!tell(session, progress, made)) return;
    const auto told = [&](std::size_t count) {
        made.count = count;
        return tell(session, progress, made);
    };
    Reachable reachable(compiler, path, session.options, session.files, axes, limit, told, trail);
    const bool is_whole = reachable.walk({});
    made.diagnostics = std::move(reachable.diagnostics);
    if (!made.diagnostics.empty() || session.stopped) return;
    if (is_whole) {
        made.picked = std::move(reachable.combinations);
        return;
    }
    // Not all combinations were counted. The note gives the number of all combinations of the properties that are read,
    // without one of them.
    std::vector<Axis> multiplying;
    double all = 1;
    for (const Axis* axis : reachable.multiplying) {
        multiplying.push_back(*axis);
        all *= static_cast<double>(axis->info.values.size());
    }
    refuse(session, graph, multiplying, "the reachable", limit, [&](const Axis& axis) {
        return "at most " + count_text(std::round(all / static_cast<double>(axis.info.values.size())));
    });
}

void plan(const CompilerImpl& compiler, resolve::Session& session, const std::string& path, VariantsWanted wanted,
          std::size_t limit, const std::function<void(const VariantPlan&)>& progress, Trail& trail, VariantPlan& made) {
    if (session.request.functions) {
        session.diagnostics.report(Code::NoProgram, {});
        return;
    }
    resolve::find_path(session);
    const std::optional<std::uint32_t> base = resolve::load_source(session, path, {});
    if (!base) return;
    const resolve::MaterialFile file = resolve::read_material(session, *base, path);
    if (!file.material || session.diagnostics.has_errors()) return;
    const format::Graph& graph = *file.material->graph->graph;
    const std::vector<Axis> axes = open_axes(*file.material);
    for (const Axis& axis : axes) made.axes.push_back(axis.info);
    const auto& properties = file.material->properties;
    made.fixed = static_cast<std::size_t>(
        std::count_if(properties.begin(), properties.end(), [](const resolve::MaterialProperty& entry) {
            return entry.property->binding == Binding::Variant && entry.is_chosen;
        }));
    switch (wanted) {
        case VariantsWanted::All: return plan_all(session, graph, axes, limit, made);
        case VariantsWanted::Listed: return plan_listed(session, *file.material, axes, limit, made);
        case VariantsWanted::Reachable:
            return plan_reachable(compiler, session, path, graph, axes, limit, progress, trail, made);
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

double combinations_of(const std::vector<VariantAxis>& axes) {
    double count = 1;
    for (const VariantAxis& axis : axes) count *= static_cast<double>(axis.values.size());
    return count;
}

VariantValues VariantPlan::combination(std::size_t index) const {
    if (!picked.empty()) return picked[index];
    VariantValues values(axes.size());
    // The last axis changes fastest.
    for (std::size_t i = axes.size(); i-- > 0; index /= axes[i].values.size())
        values[i] = {axes[i].property, axes[i].values[index % axes[i].values.size()]};
    return values;
}

VariantPlan Compiler::plan_variants(const std::string& path, VariantsWanted wanted, const CompileOptions& options,
                                    std::size_t limit, const std::function<void(const VariantPlan&)>& progress) const {
    return guarded<VariantPlan>(path, [&](Trail& trail) {
        resolve::Session session(*impl_->library, options);
        const TrailGuard guard(trail, session.diagnostics);
        VariantPlan made;
        if (made.diagnostics = impl_->overlay_errors; !made.diagnostics.empty()) return made;
        resolve::until_stopped(session, [&] {
            plan(*impl_, session, path, wanted, std::min(limit, kMostVariants), progress, trail, made);
        });
        const std::vector<Diagnostic> own = to_public(session.diagnostics, session.sources);
        made.diagnostics.insert(made.diagnostics.end(), own.begin(), own.end());
        made.ok = std::none_of(made.diagnostics.begin(), made.diagnostics.end(),
                               [](const Diagnostic& d) { return d.severity == Severity::Error; });
        if (!made.ok) made.count = 0;
        return made;
    });
}

}  // namespace patina
