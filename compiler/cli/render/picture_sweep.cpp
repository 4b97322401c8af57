#include "compiler/cli/render/picture_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "compiler/cli/eval/sweep.h"
#include "compiler/cli/files.h"
#include "compiler/cli/render/unread_inputs.h"
#include "patina/name_value.h"
#include "runtime/picture/contact_sheet.h"

namespace patina::cli {
namespace {

constexpr std::size_t kMostPictures = 400;

std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
        end = text.find(',', begin);
        words.push_back(text.substr(begin, end == text.npos ? end : end - begin));
    }
    return words;
}

SweepAxis read_axis(const std::string& text) {
    const auto [name, value] = split_name_value(text);
    if (name.empty() || !value || value->empty())
        throw CLI::ValidationError("--sweep", "'" + text + "' is not of the form NAME=FROM..TO:COUNT or NAME=A,B,C");
    SweepAxis axis{.name = std::string(name), .values = {}};
    std::string error;
    if (const auto numbers = numbers_of_range(*value, error, kMostPictures)) {
        for (double number : *numbers) axis.values.push_back(fmt::format("{}", float(number)));
    } else if (!error.empty()) {
        throw CLI::ValidationError("--sweep", error);
    } else {
        axis.values = words_of(std::string(*value));
    }
    for (const std::string& each : axis.values) {
        if (each.empty()) throw CLI::ValidationError("--sweep", "'" + text + "' has an empty value");
    }
    return axis;
}

// The file of a lighting graph is named from the current folder; its name in a graph is from the graph's.
std::string lighting_name(const std::string& word) {
    return word.ends_with(".json") ? std::filesystem::absolute(word).lexically_normal().string() : word;
}

// The last part of a file's name; a label has little room.
std::string label_of(const SweepAxis& axis, const std::string& value) {
    if (!axis.is_lighting) return axis.name + " = " + value;
    const std::string stem = std::filesystem::path(value).filename().string();
    const std::size_t ending = stem.rfind(".lighting.json");
    return ending == stem.npos ? stem : stem.substr(0, ending);
}

// At spaces, with further lines indented.
std::string folded(std::string text) {
    constexpr std::size_t kColumns = 100;
    for (std::size_t line = 0; text.size() - line > kColumns;) {
        const std::size_t space = text.rfind(' ', line + kColumns);
        if (space == text.npos || space <= line + 2) break;
        text.replace(space, 1, "\n  ");
        line = space + 1;
    }
    return text;
}

void choose(const SweepAxis& axis, const std::string& value, runtime::RenderRequest& request) {
    if (axis.is_lighting) {
        request.options.lighting = value;
    } else if (is_scene(request.graph)) {
        request.options.switches.emplace_back(axis.name, value);
    } else {
        request.overrides[axis.name] = value;
    }
}

runtime::SheetLayout layout_of(const std::vector<SweepAxis>& axes) {
    runtime::SheetLayout layout;
    const auto labels = [&](const SweepAxis& axis) {
        std::vector<std::string> all;
        for (const std::string& value : axis.values) all.push_back(label_of(axis, value));
        return all;
    };
    if (axes.size() == 2) {
        layout.columns = int(axes[1].values.size());
        layout.row_labels = labels(axes[0]);
        layout.column_labels = labels(axes[1]);
    } else if (axes[0].is_lighting) {
        layout.columns = int(std::ceil(std::sqrt(double(axes[0].values.size()))));
        layout.cell_labels = labels(axes[0]);
    } else {
        layout.columns = int(axes[0].values.size());
        layout.column_labels = labels(axes[0]);
    }
    return layout;
}

// One picture after the other, in rows.
class Sheet {
public:
    Sheet(const Compiler& compiler, const runtime::RenderRequest& request, const Sweep& sweep,
          const runtime::Tone& tone, runtime::RenderMachine& machine)
        : compiler_(compiler), request_(request), axes_(sweep.axes), tone_(tone), machine_(machine) {}

    SheetOutcome make() {
        for (SweepAxis& axis : axes_) {
            has_all_models_ |= axis.values.empty();
            if (axis.values.empty())
                for (const ModelInfo& model : compiler_.lighting_models()) axis.values.push_back(model.name);
        }
        std::size_t count = 1;
        for (const SweepAxis& axis : axes_) count *= axis.values.size();
        if (count > kMostPictures)
            return failed(fmt::format("{} pictures are too many for a sheet: the limit is {}", count, kMostPictures));
        const runtime::SheetLayout whole = layout_of(axes_);
        const int height = request_.height ? request_.height : request_.size;
        if (const auto size = runtime::sheet_size(whole, count, request_.size, height); !size)
            return failed(size.error);
        if (!draw_all(count)) return std::move(made_);
        const runtime::Outcome<runtime::Image> sheet = runtime::contact_sheet(layout_of(axes_), cells_);
        if (!sheet) return failed(sheet.error);
        made_.drawn.image = sheet.value;
        made_.drawn.ok = true;
        return std::move(made_);
    }

private:
    SheetOutcome failed(std::string error) {
        made_.drawn.ok = false;
        made_.drawn.error = std::move(error);
        return std::move(made_);
    }

    bool draw_all(std::size_t count) {
        std::vector<std::string> fitting;
        runtime::RenderOutcome first_refused;
        for (const std::string& value : std::vector<std::string>(axes_[0].values)) {
            if (axes_.size() == 1) {
                if (!draw({value}, count, fitting, first_refused)) return false;
                continue;
            }
            for (std::size_t i = 0; i < axes_[1].values.size(); ++i) {
                const std::size_t before = made_.left_out.size();
                if (!draw({value, axes_[1].values[i]}, count, fitting, first_refused)) return false;
                if (made_.left_out.size() > before) break;  // the model does not fit: it has no row
            }
        }
        if (cells_.empty()) {
            made_.drawn = std::move(first_refused);
            return false;
        }
        if (has_all_models_) axes_[0].values = fitting;
        mark_partial();
        return true;
    }

    // The labels of models that do not read all that the graph sets get a star.
    void mark_partial() {
        if (!axes_[0].is_lighting || is_scene(request_.graph)) return;
        CompileOptions options;
        options.include_dirs = request_.options.include_dirs;
        for (std::string& model : axes_[0].values) {
            std::vector<std::string> unread =
                unread_inputs(compiler_, request_.graph, options, made_.drawn.reflection.workflow, model);
            if (unread.empty()) continue;
            made_.partial.push_back({model, std::move(unread)});
            model += " *";
        }
    }

    // False: nothing more can be drawn.
    bool draw(const std::vector<std::string>& values, std::size_t count, std::vector<std::string>& fitting,
              runtime::RenderOutcome& first_refused) {
        runtime::RenderRequest request = request_;
        for (std::size_t i = 0; i < values.size(); ++i) choose(axes_[i], values[i], request);
        const std::size_t at = done_++;
        if (request_.options.progress)
            request.options.progress = [&, at](double share, std::string_view file) {
                request_.options.progress((double(at) + share) / double(count), file);
            };
        runtime::RenderOutcome drawn = runtime::render(compiler_, request, machine_);
        say_swept(drawn);
        if (!drawn.ok && has_all_models_ && !drawn.missing_machine &&
            (fitting.empty() || fitting.back() != values[0])) {
            if (made_.left_out.empty()) first_refused = drawn;
            made_.left_out.push_back({values[0], why(drawn, values[0])});
            return true;
        }
        if (fitting.empty() || fitting.back() != values[0]) fitting.push_back(values[0]);
        take(std::move(drawn));
        return made_.drawn.ok;
    }

    // A scene and a model have no property to set, so their axes are switches, as those of -D.
    void say_swept(runtime::RenderOutcome& drawn) const {
        if (!is_scene(request_.graph)) return;
        const auto is_property = [](const Diagnostic& each) { return each.code == "not-a-keyword"; };
        const auto found = std::ranges::find_if(drawn.diagnostics, is_property);
        if (found == drawn.diagnostics.end()) return;
        const bool is_imported = request_.options.files != nullptr;
        drawn.error = fmt::format(
            "--sweep {}: of a {}, only variants and constants can be swept, and this is a property: {}", swept(*found),
            is_imported ? "model" : "scene",
            is_imported ? "'patina import' makes graphs of it, and each can be swept alone" : "sweep its graph alone");
        std::erase_if(drawn.diagnostics, is_property);
    }
    // The axis that the message names.
    std::string swept(const Diagnostic& refusal) const {
        for (const SweepAxis& axis : axes_)
            if (refusal.message.find("'" + axis.name + "'") != std::string::npos) return axis.name;
        return {};
    }

    // All reasons, without the model's name, so that equal reasons are equal.
    static std::string why(const runtime::RenderOutcome& drawn, const std::string& model) {
        std::string reasons = drawn.error, last;
        const std::string name = "the lighting model '" + model + "'";
        for (const Diagnostic& each : drawn.diagnostics) {
            if (each.severity != Severity::Error) continue;
            std::string reason = each.message;
            if (const std::size_t at = reason.find(name); at != reason.npos)
                reason.replace(at, name.size(), "the lighting model");
            // Reasons that differ in their last word alone are joined: "have no surface input 'a', 'b'".
            const std::string start = reason.substr(0, reason.rfind(" '"));
            if (start != reason && start == last)
                reasons += "," + reason.substr(start.size());
            else
                reasons += (reasons.empty() ? "" : "; ") + reason;
            last = start;
        }
        return reasons;
    }

    void take(runtime::RenderOutcome drawn) {
        std::vector<Diagnostic> diagnostics = std::move(made_.drawn.diagnostics);
        for (Diagnostic& each : drawn.diagnostics) {
            const std::string text = to_text(each);
            if (std::ranges::none_of(diagnostics, [&](const Diagnostic& d) { return to_text(d) == text; }))
                diagnostics.push_back(std::move(each));
        }
        std::vector<std::string> dependencies = std::move(made_.drawn.dependencies);
        for (std::string& each : drawn.dependencies) {
            if (std::ranges::find(dependencies, each) == dependencies.end()) dependencies.push_back(std::move(each));
        }
        runtime::DataSummary values = drawn.values;
        if (!cells_.empty()) {
            const runtime::DataSummary& before = made_.drawn.values;
            values.is_empty = values.is_empty && before.is_empty;
            values.low = std::min(values.low, before.low);
            values.high = std::max(values.high, before.high);
        }
        if (drawn.ok)
            cells_.push_back(runtime::toned(
                std::move(drawn.image), {.exposure = tone_.exposure.value_or(drawn.exposure), .curve = tone_.curve}));
        made_.drawn = std::move(drawn);
        made_.drawn.diagnostics = std::move(diagnostics);
        made_.drawn.dependencies = std::move(dependencies);
        made_.drawn.values = values;
    }

    const Compiler& compiler_;
    const runtime::RenderRequest& request_;
    std::vector<SweepAxis> axes_;
    const runtime::Tone& tone_;
    runtime::RenderMachine& machine_;
    bool has_all_models_ = false;
    std::size_t done_ = 0;
    std::vector<runtime::Image> cells_{};
    SheetOutcome made_{};
};

}  // namespace

void add_sweep_options(CLI::App& command, Sweep& sweep) {
    command
        .add_option(
            "--sweep", sweep.texts,
            "Draw a picture for each value of a property, in a labelled row: _Roughness=0..1:5 is five numbers, "
            "_Mode=Dry,Wet are two words. A second --sweep makes a grid: its values are the columns")
        ->type_name("NAME=VALUES")
        ->allow_extra_args(false);
    command
        .add_option("--lighting", sweep.lighting,
                    "Light it with this lighting model, or with a lighting graph of your own, instead of the graph's. "
                    "Several with commas make a labelled sheet; 'all' means all models that fit")
        ->type_name("MODEL|FILE|all");
}

void read_sweep(Sweep& sweep, runtime::RenderRequest& request) {
    sweep.axes.clear();
    if (!sweep.lighting.empty()) {
        std::vector<std::string> models;
        for (const std::string& word : words_of(sweep.lighting)) {
            if (word.empty()) throw CLI::ValidationError("--lighting", "'" + sweep.lighting + "' has an empty name");
            if (word == "all" && sweep.lighting != "all")
                throw CLI::ValidationError("--lighting", "'all' means every model: name no other one");
            if (std::ranges::count(models, lighting_name(word)) > 0)
                throw CLI::ValidationError("--lighting", "'" + word + "' is named twice: leave one out");
            models.push_back(lighting_name(word));
        }
        if (sweep.lighting == "all") {
            sweep.axes.push_back({.name = "lighting", .values = {}, .is_lighting = true});
        } else if (models.size() > 1) {
            sweep.axes.push_back({.name = "lighting", .values = std::move(models), .is_lighting = true});
        } else {
            request.options.lighting = models.front();
        }
    }
    for (const std::string& text : sweep.texts) {
        sweep.axes.push_back(read_axis(text));
        const std::string& name = sweep.axes.back().name;
        const auto is_given = [&](const auto& each) { return each.first == name; };
        if (request.overrides.contains(name) || std::ranges::any_of(request.options.switches, is_given))
            throw CLI::ValidationError("--sweep", "'" + name + "' has a value already: leave out its -D or --set");
        for (std::size_t i = 0; i + 1 < sweep.axes.size(); ++i) {
            if (sweep.axes[i].name == name)
                throw CLI::ValidationError("--sweep", "'" + name + "' is swept twice: leave one out");
        }
    }
    if (sweep.axes.size() > 2)
        throw CLI::ValidationError("--sweep",
                                   "a sheet has rows and columns: at most two of --sweep, and --lighting "
                                   "with several models counts as one");
}

std::vector<std::string> lines_of(const std::vector<LeftOut>& left_out, const std::vector<Partial>& partial) {
    std::vector<std::pair<std::string, std::vector<std::string>>>
        groups;  // models by the reason that is reported for them
    const auto add = [&](std::string said, const std::string& model) {
        auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.first == said; });
        if (group == groups.end()) group = groups.insert(groups.end(), {std::move(said), {}});
        group->second.push_back(model);
    };
    for (const Partial& each : partial)
        add(fmt::format("not read '{}', which the graph sets", fmt::join(each.inputs, "', '")), each.model + " *");
    for (const LeftOut& each : left_out) add("not fit: " + each.why, each.model);
    std::vector<std::string> lines;
    for (const auto& [said, models] : groups)
        lines.push_back(
            folded(fmt::format("{} {} {}", fmt::join(models, ", "), models.size() == 1 ? "does" : "do", said)));
    return lines;
}

SheetOutcome render_sheet(const Compiler& compiler, const runtime::RenderRequest& request, const Sweep& sweep,
                          const runtime::Tone& tone, runtime::RenderMachine& machine) {
    return Sheet(compiler, request, sweep, tone, machine).make();
}

}  // namespace patina::cli
