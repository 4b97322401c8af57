#include "compiler/resolve/session.h"

#include <algorithm>
#include <set>

#include "compiler/base/disk/disk.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/parse.h"
#include "compiler/resolve/check_graph.h"

namespace patina::resolve {
namespace {

// The targets have been grouped by engine (api/compile_targets.cpp). If none is requested, the default engine is used.
const engines::Engine& engine_of(const Library& library, const CompileOptions& options) {
    const std::vector<Target>& targets = options.targets;
    const engines::Engine* engine = library.engine(targets.empty() ? std::string() : targets.front().engine);
    return engine ? *engine : *library.engine({});
}

// A search for a file counts as so many steps.
constexpr std::size_t kStepsOfAFile = 16;

// The files for which a failed compilation has searched. A program that watches files must notice when one of them
// appears.
void add_missing(Session& session, const std::vector<std::string>& paths) {
    session.dependencies.insert(session.dependencies.end(), paths.begin(), paths.end());
}

// The paths that `name` in the file `from` may mean, in order of preference.
std::vector<std::string> candidates(Session& session, const std::string& name, const std::string& from, Span where) {
    std::vector<std::string> paths;
    const auto add = [&](const std::string& at) {
        Files::Path found = session.files.resolve(at, name);
        if (!found.why.empty()) session.diagnostics.report(Code::CannotRead, where, name, found.why);
        if (!found.path.empty() && std::find(paths.begin(), paths.end(), found.path) == paths.end())
            paths.push_back(std::move(found.path));
    };
    add(from);
    for (const std::string& folder : session.request.folders) {
        Cancellation::step(kStepsOfAFile);
        add(folder);
    }
    return paths;
}

// What the program's file system fails at is reported. On the disk, `obstacle` is what is there and is no file.
std::string first_that_exists(Session& session, const std::vector<std::string>& paths, Span where,
                              std::string& obstacle) {
    for (const std::string& path : paths) {
        const Files::Answer& answer = session.files.find(path);
        if (*answer.exists) return path;
        session.missing.insert(path);
        if (answer.why.empty()) continue;
        if (!session.files.looks_on_disk())
            session.diagnostics.report(Code::CannotRead, where, path, answer.why);
        else if (obstacle.empty())
            obstacle = answer.why;
    }
    return {};
}

// load_source() reports a file that is there and cannot be read.
std::string first_with_text(Session& session, const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
        const Files::Answer& answer = session.files.read(path);
        if (answer.text || !answer.why.empty()) return path;
        session.missing.insert(path);
    }
    return {};
}

bool has_own_ending(std::string_view path) {
    constexpr std::string_view kEndings[] = {".graph.json",    ".subgraph.json", ".lighting.json",
                                             ".workflow.json", ".scene.json",    ".hlsl"};
    return std::any_of(std::begin(kEndings), std::end(kEndings),
                       [&](std::string_view ending) { return path.ends_with(ending); });
}

// Whether a text of the disk may stand in messages. One that a graph names may be any file of the machine. The file is
// of Patina if its name says so, with all links resolved. It is also of Patina if it is a JSON object with the key
// "patina" or has the attribute of a node or a pass.
bool is_ours(const std::string& path, std::string_view text) {
    if (has_own_ending(without_links(path))) return true;
    if (text.find("[node(") != text.npos || text.find("[pass(") != text.npos) return true;
    const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
    const bool begins_as_json = first != text.npos && (text[first] == '{' || text[first] == '/');  // a comment
    return begins_as_json && text.find("\"patina\"") != text.npos;
}

// A name that is given twice means what it means once.
std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> made;
    std::set<std::string_view> known;
    for (const std::string& name : names)
        if (known.insert(name).second) made.push_back(name);
    return made;
}

}  // namespace

Request::Request(const CompileOptions& options) {
    for (const std::string& folder : options.include_dirs)
        folders.push_back(folder.ends_with('/') ? folder : folder + '/');
    folders = each_once(folders);
    if (const CompileOptions::Passes* wanted = options.passes()) {
        path = wanted->path;
        passes = each_once(wanted->only);
    }
    if (const auto* wanted = std::get_if<CompileOptions::Functions>(&options.request)) functions = wanted->prefix;
    if (const auto* wanted = std::get_if<CompileOptions::Preview>(&options.request)) preview = wanted->port;
}

Session::Session(const Library& the_library, const CompileOptions& the_options, Files* the_files)
    : library(the_library),
      options(the_options),
      cancellation(the_options.limits.cancelled),
      request(the_options),
      engine(engine_of(the_library, the_options)),
      declarations(&the_library.declarations),
      paths(&the_library.paths),
      path(request.path),
      sources(&the_library.sources),
      own_files(the_options),
      files(the_files ? *the_files : *own_files) {}

std::string find_file(Session& session, const std::string& name, const std::string& from, Span where) {
    std::string ignored;
    return first_that_exists(session, candidates(session, name, from, where), where, ignored);
}

std::string require_file(Session& session, const std::string& name, const std::string& from, Span where) {
    const std::size_t errors = session.diagnostics.error_count();
    const std::vector<std::string> paths = candidates(session, name, from, where);
    std::string obstacle;
    std::string path = first_that_exists(session, paths, where, obstacle);
    if (!path.empty()) return path;
    add_missing(session, paths);
    if (session.diagnostics.error_count() != errors) return {};
    if (!obstacle.empty())
        session.diagnostics.report(Code::CannotRead, where, name, obstacle);
    else
        session.diagnostics.report(Code::MissingFile, where, name);
    return {};
}

std::string require_source(Session& session, const std::string& name, const std::string& from, Span where) {
    const std::size_t errors = session.diagnostics.error_count();
    const std::vector<std::string> paths = candidates(session, name, from, where);
    std::string path = first_with_text(session, paths);
    if (path.empty()) add_missing(session, paths);
    if (path.empty() && session.diagnostics.error_count() == errors)
        session.diagnostics.report(Code::MissingFile, where, name);
    return path;
}

namespace {

// Reports a file of the disk that is not one of ours.
bool may_be_quoted(Session& session, const std::string& path, std::string_view text, Span where) {
    if (!session.files.reads_disk() || is_ours(path, text)) return true;
    session.diagnostics.report(Code::CannotRead, where, path, "it is neither a graph nor a file of nodes")
        .note("the name of a graph ends with .graph.json or .subgraph.json, and that of a file of nodes with .hlsl");
    return false;
}

// Of a text that was not read, or is not used.
void report_too_large(Session& session, const std::string& path, std::size_t bytes, const std::string& why,
                      Span where) {
    const std::uint32_t base = session.sources.add(path, {});
    if (bytes > json::kMaxJsonBytes) {
        session.diagnostics.report(Code::TooLarge, {base, base}, bytes, json::kMaxJsonBytes);
        return;
    }
    session.files.add_bytes(bytes);
    const Span place = where ? where : Span{base, base};
    if (!is_over_bytes(session, place)) session.diagnostics.report(Code::CannotRead, place, path, why);
}

}  // namespace

std::string require_graph(Session& session, const std::string& name, const std::string& from, Span where) {
    std::string path = require_source(session, name, from, where);
    if (path.empty()) return path;
    const Files::Answer& answer = session.files.read(path);
    if (!answer.text)
        session.diagnostics.report(Code::CannotRead, where, path, answer.why);
    else if (may_be_quoted(session, path, *answer.text, where))
        return path;
    return {};
}

std::optional<std::uint32_t> load_source(Session& session, const std::string& path, Span where) {
    const Files::Answer& answer = session.files.read(path);
    session.dependencies.push_back(path);
    if (answer.too_large > 0) {
        report_too_large(session, path, answer.too_large, answer.why, where);
        return {};
    }
    if (!answer.text && !answer.why.empty()) {
        session.diagnostics.report(Code::CannotRead, where, path, answer.why);
        return {};
    }
    if (!answer.text) {
        session.missing.insert(path);
        DiagnosticRecord& record = session.diagnostics.report(Code::MissingFile, where, path);
        const std::string advice = session.files.advice_for(path);
        if (!advice.empty()) record.note(advice);
        return {};
    }
    if (answer.text->size() > json::kMaxJsonBytes) {
        report_too_large(session, path, answer.text->size(), answer.why, where);
        return {};
    }
    // A file that a user names is read under any name. But a user who names a folder does not know where its links
    // lead.
    if ((where || has_own_ending(path)) && !may_be_quoted(session, path, *answer.text, where)) return {};
    const std::uint32_t base = session.sources.add(path, *answer.text);
    if (is_over_bytes(session, where ? where : Span{base, base})) return {};
    return base;
}

bool is_over_bytes(Session& session, Span where) {
    const std::size_t most = session.options.limits.source_bytes;
    if (session.files.bytes() <= most) return false;
    session.diagnostics.report(Code::OverBudget, where, "bytes of source text", session.files.bytes(), most);
    session.stopped = true;
    return true;
}

bool must_stop(Session& session) {
    Stopped stopped;
    if (!session.stopped && session.cancellation.is_cancelled(stopped.why)) report_stop(session, stopped);
    return session.stopped;
}

void report_stop(Session& session, const Stopped& stopped) {
    if (session.stopped) return;
    session.stopped = true;
    if (stopped.is_reported) return;
    session.diagnostics.report(Code::Cancelled, {}, stopped.why.empty() ? "" : ": " + stopped.why);
}

bool call_program(Session& session, const std::function<void()>& function) {
    std::string why;
    if (succeeds(function, why)) return true;
    report_stop(session, {.why = std::move(why)});
    return false;
}

namespace {

bool is_in(const std::vector<std::string_view>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

void check_along(Session& session, const paths::PassDecl& pass) {
    const std::vector<std::string_view> known(session.engine.paths.begin(), session.engine.paths.end());
    for (const auto* paths : {&pass.along, &pass.extra_along}) {
        for (const std::string_view path : *paths) {
            if (is_in(known, path)) continue;
            session.diagnostics.report(Code::UnknownWord, pass.span, path, "a path of this engine's own passes")
                .note(known.empty() ? std::string("this engine has no passes of its own: leave out [along]")
                                    : Diagnostics::suggestion(path, known));
        }
    }
}

// Decides what the file's pass draws along the requested path: materials, only what materials add, or nothing. An
// engine selects its own passes, so those of the library draw nothing there.
void choose_what_is_drawn(const Session& session, std::string_view own_path, paths::PassDecl& pass) {
    if (pass.path != session.path) {
        if (session.engine.has_own_passes()) pass.draws_extra = false;
        return;
    }
    const bool is_of_other = !pass.along.empty() && !is_in(pass.along, own_path);
    pass.draws_extra_alone = is_of_other && is_in(pass.extra_along, own_path);
    if (pass.is_older_fragment || (is_of_other && !pass.draws_extra_alone)) pass.path.clear();
}

void use_passes(Session& session, std::shared_ptr<const PassFile> file) {
    session.declarations = &file->declarations;
    session.paths = &file->paths;
    session.pass_file = std::move(file);
}

// Adds the passes of a loaded file to those of the library.
void read_passes(Session& session, std::uint32_t base, std::string path) {
    auto file = std::make_shared<PassFile>();
    nodelang::parse_file({.text = session.sources.file_text(base), .base = base}, file->ast, session.diagnostics);
    file->declarations.parent = &session.library.declarations;
    nodelang::index_declarations(file->ast, file->declarations, session.diagnostics);
    file->paths = session.library.paths;
    collect(file->ast, file->declarations, session.sources, file->paths, session.diagnostics);
    session.path = std::move(path);
    // The file replaces the whole path, even if the library has one of that name. An engine's file holds the passes of
    // several paths.
    const std::string_view own_path = session.engine.own_path(session.request.path);
    for (paths::PassDecl& pass : file->paths.passes) {
        if (pass.path == session.path) check_along(session, pass);
        choose_what_is_drawn(session, own_path, pass);
    }
    if (file->paths.passes_of(session.path).empty() && !session.diagnostics.has_errors())
        session.diagnostics.report(Code::NoNodeInFile, {base, base}, "[pass]");
    // If the file has errors, the library's passes are used, so that errors in the graph are still found.
    if (session.diagnostics.has_errors()) return;
    use_passes(session, std::move(file));
}

// All compilations for the engine have the same passes of its own.
void find_own_passes(Session& session) {
    const LibraryEngine& engine = session.library.engines.find(session.engine.name)->second;
    const std::string path(session.engine.own_path(session.request.path));
    if (std::shared_ptr<const PassFile> known = engine.passes(path)) {
        session.path = session.engine.name;
        return use_passes(session, std::move(known));
    }
    read_passes(session, *session.engine.passes, session.engine.name);
    if (session.pass_file) engine.keep_passes(path, session.pass_file);
}

}  // namespace

void find_path(Session& session) {
    if (session.engine.has_own_passes()) return find_own_passes(session);
    const std::string& wanted = session.request.path;
    if (!wanted.ends_with(".pass.hlsl")) {
        std::vector<std::string_view> known = session.paths->names();
        known.push_back(kAllPaths);
        if (std::find(known.begin(), known.end(), wanted) != known.end()) return;
        const bool is_file = wanted.find_first_of("./\\") != wanted.npos;
        std::string advice =
            is_file ? "name a file with passes NAME.pass.hlsl" : Diagnostics::suggestion(wanted, known);
        const std::string file = wanted + ".pass.hlsl";
        if (session.files.read(file).text)
            advice = fmt::format("did you mean '{}{}'?", is_file ? "" : "./", file);
        else
            session.missing.insert(file);
        session.diagnostics.report(Code::UnknownWord, {}, wanted, "a rendering path").note(std::move(advice));
        return;
    }
    const std::optional<std::uint32_t> base = load_source(session, wanted, {});
    if (!base) return;
    read_passes(session, *base, file_stem(wanted));
}

std::string file_stem(std::string_view path) {
    const std::size_t slash = path.find_last_of("/\\");
    std::string_view name = slash == std::string_view::npos ? path : path.substr(slash + 1);
    const std::size_t dot = name.find('.', 1);
    return std::string(name.substr(0, dot));
}

}  // namespace patina::resolve
