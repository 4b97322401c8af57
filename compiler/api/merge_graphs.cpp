// merge_graphs(): reads the three texts, and compiles what is merged of them.
#include <algorithm>

#include "compiler/api/compile_source.h"
#include "compiler/api/report.h"
#include "compiler/base/cancellation.h"
#include "compiler/edit/merge_texts.h"
#include "compiler/seam/seam.h"
#include "patina/graph_merge.h"

namespace patina {
namespace {

bool has_carriage_returns(std::string_view text) {
    const auto newlines = std::count(text.begin(), text.end(), '\n');
    std::ptrdiff_t returns = 0;
    for (std::size_t at = text.find("\r\n"); at != text.npos; at = text.find("\r\n", at + 2)) ++returns;
    return newlines > 0 && returns == newlines;
}

std::string without_carriage_returns(std::string text) {
    if (has_carriage_returns(text)) text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
    return text;
}

std::string with_carriage_returns(std::string_view text) {
    std::string made;
    for (const char c : text) {
        if (c == '\n') made += '\r';
        made += c;
    }
    return made;
}

std::unique_ptr<edit::GraphText> read_input(const MergeInput& input, MergeResult& result) {
    std::unique_ptr<edit::GraphText> text = edit::read_graph_text(input.name, without_carriage_returns(input.text));
    if (!text->ok) {
        for (Diagnostic& error : to_public(text->diagnostics, text->sources))
            result.diagnostics.push_back(std::move(error));
    }
    return text;
}

// Of a file that both sides added: one in which nothing is.
std::unique_ptr<edit::GraphText> nothing(const MergeInput& base, const edit::GraphText& ours) {
    std::unique_ptr<edit::GraphText> text = edit::read_graph_text(base.name, "{}");
    text->kind = ours.kind;
    return text;
}

void keep_errors(std::vector<Diagnostic>& diagnostics) {
    const auto is_no_error = [](const Diagnostic& each) { return each.severity != Severity::Error; };
    diagnostics.erase(std::remove_if(diagnostics.begin(), diagnostics.end(), is_no_error), diagnostics.end());
}

bool is_of_cancelling(const Diagnostic& diagnostic) {
    return diagnostic.code == info(Code::Cancelled).name;
}

// A compilation of what has been merged was cancelled, and so is the merge.
struct Cancelled {
    Diagnostic why;
};

std::vector<Diagnostic> errors_of(const Compiler& compiler, const MergeOptions& options, const std::string& text,
                                  Trail& trail) {
    CompileOptions compile;
    compile.include_dirs = options.compile.include_dirs;
    compile.files = options.compile.files;
    compile.limits = options.compile.limits;
    compile.targets = {Target::Glsl};
    compile.accept_parts = true;
    std::vector<Diagnostic> errors =
        compile_text(CompilerAccess::impl(compiler), options.path, text, compile, trail).diagnostics;
    keep_errors(errors);
    if (std::any_of(errors.begin(), errors.end(), is_of_cancelling)) throw Cancelled{std::move(errors.front())};
    return errors;
}

// A scene is not compiled, nor is a workflow by itself. Errors in how its parts use each other are found without other
// files.
std::vector<Diagnostic> errors_of_form(const MergeOptions& options, const std::string& text) {
    const std::unique_ptr<edit::GraphText> read = edit::read_graph_text(options.path, text);
    std::vector<Diagnostic> errors = to_public(read->diagnostics, read->sources);
    keep_errors(errors);
    return errors;
}

MergeResult merge(const Compiler& compiler, const MergeInput& base, const MergeInput& ours, const MergeInput& theirs,
                  const MergeOptions& options, Trail& trail) {
    MergeResult result{.text = ours.text};
    edit::Sides sides{.base = nullptr, .ours = read_input(ours, result), .theirs = read_input(theirs, result)};
    sides.base = base.text.empty() ? nothing(base, *sides.ours) : read_input(base, result);
    if (!sides.ours->ok || !sides.theirs->ok || (!base.text.empty() && !sides.base->ok)) return result;

    const bool is_compiled =
        sides.ours->kind != format::ObjectKind::Scene && sides.ours->kind != format::ObjectKind::Workflow;
    const auto check = [&](const std::string& text) {
        return is_compiled ? errors_of(compiler, options, text, trail) : errors_of_form(options, text);
    };
    if (ours.text == base.text) return edit::take_text(sides, theirs.text, check);
    if (theirs.text == base.text || theirs.text == ours.text) return edit::take_text(sides, ours.text, check);
    result = edit::merge_texts(sides, options, check);
    if (has_carriage_returns(ours.text)) result.text = with_carriage_returns(result.text);
    return result;
}

MergeResult merge_until_cancelled(const Compiler& compiler, const MergeInput& base, const MergeInput& ours,
                                  const MergeInput& theirs, const MergeOptions& options, Trail& trail) {
    const Cancellation cancellation(options.compile.limits.cancelled);
    try {
        return merge(compiler, base, ours, theirs, options, trail);
    } catch (const Stopped& stopped) {
        return {.text = ours.text, .diagnostics = {diagnostic_of(stopped)}};
    } catch (Cancelled& cancelled) {
        return {.text = ours.text, .diagnostics = {std::move(cancelled.why)}};
    }
}

}  // namespace

MergeResult merge_graphs(const Compiler& compiler, const MergeInput& base, const MergeInput& ours,
                         const MergeInput& theirs, const MergeOptions& options) {
    return guarded<MergeResult>(
        options.path, [&](Trail& trail) { return merge_until_cancelled(compiler, base, ours, theirs, options, trail); },
        [&](MergeResult& failed) { failed.text = ours.text; });
}

}  // namespace patina
