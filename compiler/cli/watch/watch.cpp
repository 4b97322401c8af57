#include "compiler/cli/watch/watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "compiler/cli/failures/failures.h"
#include "compiler/cli/files.h"
#include "compiler/cli/watch/live_page.h"

namespace patina::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kRetry = 1s;            // of errors
constexpr auto kQuiet = 40ms;          // a file that does not change for so long is complete
constexpr int kMostWaits = 25;         // for files that never are
constexpr std::size_t kMostShown = 8;  // graphs whose changes are shown one by one

std::string text_of(std::span<const Diagnostic> diagnostics) {
    std::string text;
    for (const Diagnostic& each : diagnostics) text += to_text(each) + "\n";
    return text;
}

// Editors and version control write several files, and some in two steps.
void wait_until_quiet(const std::vector<Stamps>& read) {
    std::vector<std::string> files;
    for (const Stamps& stamps : read)
        for (const auto& [file, stamp] : stamps) files.push_back(file);
    for (int i = 0; i < kMostWaits; ++i) {
        const Stamps now = stamps_of(files);
        std::this_thread::sleep_for(kQuiet);
        if (!has_changed(now)) return;
    }
}

// Of several languages, the first.
Target shown_target(const CompileArguments& arguments) {
    return arguments.written.empty() ? Target() : arguments.written.front();
}

}  // namespace

bool Watch::Task::is_changed() const {
    return is_new || has_changed(stamps) || (!ok && Clock::now() - tried > kRetry);
}

bool Watch::Task::is_due() const {
    return is_changed() || (!obstacle.empty() && Clock::now() - tried > kRetry);
}

bool Watch::Task::done(bool is_ok, Stamps read, std::string messages) {
    const bool is_news = is_new || messages != said;
    *this = {.stamps = std::move(read),
             .tried = Clock::now(),
             .is_new = false,
             .ok = is_ok,
             .said = std::move(messages),
             .obstacle = std::move(obstacle)};
    return is_news;
}

Watch::Watch(const Console& console, const Compiler& compiler, const WatchArguments& arguments, Inputs inputs)
    : console_(console), compiler_(compiler), arguments_(arguments), inputs_(std::move(inputs)) {
    std::erase_if(inputs_.files, [](const Input& input) { return input.from == Input::From::Folder; });
}

void Watch::tell(const std::string& subject, const std::string& line) {
    say(console_, line);
    if (subject == subject_) text_ += line + "\n";
}

void Watch::find_graphs() {
    std::vector<Input> inputs = inputs_.files;
    for (const std::string& word : arguments_.compile.inputs.words) {
        const std::vector<Input> found = inputs_below(word, {".graph.json"});
        inputs.insert(inputs.end(), found.begin(), found.end());
    }
    take_out_repeated(inputs);
    std::vector<std::string> paths;
    for (const Input& input : inputs) paths.push_back(input.path);
    if (paths == found_) return;
    found_ = std::move(paths);
    take_out_equal_outputs(console_, inputs, ".*", "watch");
    std::map<std::string, Graph> graphs;
    for (const Input& input : inputs) {
        const auto known = graphs_.find(input.path);
        graphs[input.path] = known == graphs_.end() ? Graph{.input = input} : std::move(known->second);
        if (known == graphs_.end() && !is_first_) say(console_, input.path + ": is new");
        if (known != graphs_.end()) graphs_.erase(known);
    }
    for (const auto& [path, gone] : graphs_) say(console_, path + ": is gone; what was made of it stays");
    graphs_ = std::move(graphs);
}

// The scene that is named, or else the graph that was changed last.
void Watch::choose_subject(const std::vector<Input>& changed) {
    const auto is_changed = [&](const std::string& path) {
        return std::ranges::any_of(changed, [&](const Input& input) { return input.path == path; });
    };
    const auto scene = std::ranges::find_if(graphs_, [](const auto& each) { return is_scene(each.first); });
    std::string subject = subject_;
    if (scene != graphs_.end())
        subject = scene->first;
    else if (!changed.empty() && !is_changed(subject_))
        subject = changed.front().path;
    if (subject != subject_) picture_ = {};
    subject_ = std::move(subject);
    if (is_changed(subject_)) picture_.is_new = true;
}

Watch::Made Watch::make(const Input& input, bool counts_costs) const {
    if (is_scene(input.path)) return {.compiled = {.ok = true}};  // which is drawn, and has no files
    const auto begin = std::chrono::system_clock::now();
    Made made;
    try {
        made.compiled = compile_graph(arguments_.compile, compiler_, input);
        if (counts_costs) measure_once(made.compiled);
    } catch (...) {  // an error as others are: the graph is compiled again when it has changed
        made.compiled.ok = false;
        made.compiled.result.diagnostics = {describe_exception(input.path).error};
    }
    const Result& result = made.compiled.result;
    std::vector<std::string> files = result.dependencies;
    files.push_back(input.path);
    files.insert(files.end(), result.missing.begin(), result.missing.end());
    made.stamps = stamps_of(files, begin);
    return made;
}

// Reports why files could not be written, unless that has been reported before. They are tried again.
bool Watch::write(Task& task, const std::string& source, const OutputFiles& files,
                  const std::vector<std::string>& inputs) {
    const std::optional<Diagnostic> obstacle = Outputs(console_).try_write(source, files, inputs);
    std::string text = obstacle ? to_text(*obstacle) : std::string();
    if (obstacle && text != task.obstacle) report(console_, {&*obstacle, 1});
    task.obstacle = std::move(text);
    return !obstacle;
}

Exit Watch::finish(const Input& input, Made& made, bool shows_changes) {
    Graph& graph = graphs_.at(input.path);
    Compiled& now = made.compiled;
    const std::string messages = text_of(now.result.diagnostics);
    const bool was_unsure =
        std::ranges::any_of(graph.task.stamps, [](const auto& each) { return each.second.is_unsure; });
    if (input.path == subject_) text_ += messages;
    if (graph.task.done(now.ok, std::move(made.stamps), messages)) {
        report(console_, now.result.diagnostics);
        if (!now.ok) tell(input.path, input.path + ": is wrong; its files stay as they were");
    }
    const bool was_written = graph.task.obstacle.empty();
    if (!now.ok) graph.task.obstacle.clear();
    if (!now.ok || is_scene(input.path)) return Exit::Ok;
    std::vector<std::string> changes;
    if (graph.compiled && shows_changes) {
        measure_once(*graph.compiled);
        changes = changes_of(*graph.compiled, made.compiled, shown_target(arguments_.compile));
    }
    if (!write(graph.task, input.path, now.files, now.result.dependencies)) return Exit::Ok;
    if (!is_first_ && !(was_unsure && was_written && changes.empty())) {
        tell(input.path, input.path + (graph.compiled && shows_changes && changes.empty() ? ": the files are the same"
                                                                                          : ": compiled"));
        for (const std::string& line : changes) tell(input.path, "  " + line);
    }
    graph.compiled = std::move(made.compiled);
    return Exit::Ok;
}

OutputFiles Watch::page_files(bool ok) {
    const std::int64_t now =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::system_clock::now().time_since_epoch())
            .count();
    page_version_ = std::max(page_version_ + 1, now);
    OutputFiles files;
    files.add(page_path(arguments_.picture), page_text(arguments_.picture));
    files.add(state_path(arguments_.picture),
              state_text({.version = page_version_, .subject = subject_, .ok = ok, .text = text_}));
    return files;
}

Exit Watch::draw() {
    const Graph& graph = graphs_.at(subject_);
    if (!graph.task.ok) {  // what is wrong stays on the page until the graph changes
        if (picture_.is_new || !picture_.obstacle.empty()) write(picture_, subject_, page_files(false), {});
        picture_.is_new = false;
        picture_.tried = Clock::now();
        return Exit::Ok;
    }
    runtime::RenderRequest request = arguments_.request;
    request.graph = subject_;
    request.options.progress = [&](double share, std::string_view) { show_share(console_, share, subject_); };
    const auto begin = std::chrono::system_clock::now();
    runtime::RenderOutcome drawn;
    try {
        drawn = runtime::render(compiler_, request, machine_);
    } catch (...) {
        drawn.diagnostics = {describe_exception(subject_).error};
    }
    end_progress(console_);
    // The compiler has reported these already.
    std::erase_if(drawn.diagnostics,
                  [&](const Diagnostic& each) { return graph.task.said.find(to_text(each)) != std::string::npos; });
    drawn.dependencies.push_back(subject_);
    const std::string messages =
        text_of(drawn.diagnostics) + (drawn.error.empty() ? "" : "cannot draw it: " + drawn.error + "\n");
    const bool is_news = picture_.done(drawn.ok, stamps_of(drawn.dependencies, begin), messages);
    text_ += messages;
    if (is_news) report(console_, drawn.diagnostics);
    if (is_news && !drawn.error.empty()) complain(console_, Complaint::CannotRender, {drawn.error});
    if (drawn.missing_machine) return Exit::Machine;
    if (!drawn.ok && !is_news && picture_.obstacle.empty()) return Exit::Ok;
    OutputFiles files = page_files(drawn.ok);
    if (drawn.ok) files.add(arguments_.picture, runtime::encode_png(drawn.image).value);
    if (write(picture_, subject_, files, drawn.dependencies) && drawn.ok) say(console_, arguments_.picture);
    return Exit::Ok;
}

Exit Watch::look() {
    find_graphs();
    std::vector<Input> due, changed;
    std::vector<Stamps> read;
    for (const auto& [path, graph] : graphs_) {
        if (!graph.task.is_due()) continue;
        due.push_back(graph.input);
        read.push_back(graph.task.stamps);
        if (graph.task.is_changed()) changed.push_back(graph.input);
    }
    if (!arguments_.picture.empty()) choose_subject(changed);
    const bool draws = graphs_.contains(subject_) && picture_.is_due();
    if (due.empty() && !draws) return Exit::Ok;
    if (!is_first_) wait_until_quiet(read);
    text_.clear();
    const bool shows_changes = !is_first_ && due.size() <= kMostShown;
    work_on(
        console_, due, arguments_.compile.inputs.jobs, [&](const Input& input) { return make(input, shows_changes); },
        [&](const Input& input, Made& made) { return finish(input, made, shows_changes); });
    end_progress(console_);
    const Exit exit = draws ? draw() : Exit::Ok;
    if (is_first_)
        say(console_,
            fmt::format("watching {} file{}; Ctrl-C ends it", graphs_.size(), graphs_.size() == 1 ? "" : "s"));
    is_first_ = false;
    std::fflush(stdout);
    return exit;
}

}  // namespace patina::cli
