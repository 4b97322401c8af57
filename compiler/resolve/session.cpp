#include "compiler/resolve/session.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/base/near_file.h"
#include "compiler/json/json.h"
#include "compiler/nodelang/parse.h"
#include "compiler/resolve/check_graph.h"

namespace patina::graph {
namespace {

std::optional<std::string> read_text(const std::string& path, std::string& why) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) {
        why = "it is a folder";
        return {};
    }
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        why = std::strerror(errno);
        return {};
    }
    std::ostringstream text;
    text << file.rdbuf();
    return std::move(text).str();
}

// What the caller's loader says of a path. It is asked once.
std::optional<std::string>& loaded(Session& session, const std::string& path) {
    const auto [entry, is_new] = session.loaded.try_emplace(path);
    if (is_new) entry->second = session.options.loader(path);
    return entry->second;
}

bool exists(Session& session, const std::string& path) {
    if (const auto known = session.loaded.find(path); known != session.loaded.end()) return known->second.has_value();
    if (session.options.loader) return loaded(session, path).has_value();
    std::error_code error;
    return std::filesystem::is_regular_file(path, error);
}

// The paths that `name` in the file `from` may mean, in order of preference.
std::vector<std::string> candidates(const Session& session, const std::string& name, const std::string& from) {
    namespace fs = std::filesystem;
    if (fs::path(name).is_absolute()) return {name};
    const auto join = [&](const fs::path& folder) { return (folder / name).lexically_normal().generic_string(); };
    std::vector<std::string> paths = {join(fs::path(from).parent_path())};
    for (const std::string& folder : session.options.include_dirs) paths.push_back(join(folder));
    return paths;
}

}  // namespace

namespace {

// The targets have been grouped by engine (api/compile_targets.cpp). If none is requested, the default engine is used.
const engines::Engine& engine_of(const Library& library, const CompileOptions& options) {
    const std::vector<Target>& targets = options.targets;
    const engines::Engine* engine = library.engine(targets.empty() ? std::string() : targets.front().engine);
    return engine ? *engine : *library.engine({});
}

}  // namespace

Session::Session(const Library& the_library, const CompileOptions& the_options)
    : library(the_library),
      options(the_options),
      engine(engine_of(the_library, the_options)),
      declarations(&the_library.declarations),
      paths(&the_library.paths),
      path(the_options.path),
      sources(&the_library.sources) {}

std::string find_file(Session& session, const std::string& name, const std::string& from) {
    for (std::string& path : candidates(session, name, from)) {
        if (exists(session, path)) return std::move(path);
    }
    return {};
}

void report_not_found(Session& session, const std::string& name, const std::string& from, Span where) {
    const std::vector<std::string> paths = candidates(session, name, from);
    std::error_code ignored;
    const bool is_folder = !session.options.loader && std::any_of(paths.begin(), paths.end(), [&](const auto& path) {
        return std::filesystem::is_directory(path, ignored);
    });
    if (is_folder) {
        session.diagnostics.report(Code::CannotRead, where, name, "it is a folder");
    } else {
        session.diagnostics.report(Code::MissingFile, where, name);
    }
}

namespace {

// `why`: the reason of the system; empty: there is no file.
void report_unread(Session& session, const std::string& path, Span where, const std::string& why) {
    std::error_code ignored;
    const bool is_there = !session.options.loader && std::filesystem::exists(path, ignored);
    if (is_there && !why.empty()) {
        session.diagnostics.report(Code::CannotRead, where, path, why);
        return;
    }
    DiagnosticRecord& record = session.diagnostics.report(Code::MissingFile, where, path);
    const std::string advice = session.options.loader ? std::string() : near_file(path);
    if (!advice.empty()) record.note(advice);
}

}  // namespace

std::optional<std::uint32_t> load_source(Session& session, const std::string& path, Span where) {
    std::string why;
    const bool is_known = session.options.loader || session.loaded.count(path) != 0;
    std::optional<std::string> text = is_known ? loaded(session, path) : read_text(path, why);
    if (!text) {
        report_unread(session, path, where, why);
        return {};
    }
    if (text->size() > kMaxJsonBytes) {
        const std::uint32_t base = session.sources.add(path, {});
        session.diagnostics.report(Code::TooLarge, {base, base}, text->size(), kMaxJsonBytes);
        return {};
    }
    session.dependencies.push_back(path);
    return session.sources.add(path, std::move(*text));
}

namespace {

bool is_in(const std::vector<std::string_view>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

void check_along(Session& session, const PassDecl& pass) {
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

// What the file's pass draws along the requested path: materials, only what materials add, or nothing. An engine
// selects its own passes, so those of the library draw nothing there.
void choose_what_is_drawn(const Session& session, std::string_view own_path, PassDecl& pass) {
    if (pass.path != session.path) {
        if (session.engine.has_own_passes()) pass.draws_extra = false;
        return;
    }
    const bool is_of_other = !pass.along.empty() && !is_in(pass.along, own_path);
    pass.draws_extra_alone = is_of_other && is_in(pass.extra_along, own_path);
    if (pass.is_older_fragment || (is_of_other && !pass.draws_extra_alone)) pass.path.clear();
}

// Adds the passes of a loaded file to those of the library.
void read_passes(Session& session, std::uint32_t base, std::string path) {
    auto file = std::make_unique<PassFile>();
    nodelang::parse_file({.text = session.sources.file_text(base), .base = base}, file->ast, session.diagnostics);
    file->declarations.parent = &session.library.declarations;
    nodelang::index_declarations(file->ast, file->declarations, session.diagnostics);
    file->paths = session.library.paths;
    collect(file->ast, file->declarations, session.sources, file->paths, session.diagnostics);
    session.path = std::move(path);
    // The file replaces the whole path, even if the library has one of that name. An engine's file holds the passes of
    // several paths.
    const std::string_view own_path = session.engine.own_path(session.options.path);
    for (PassDecl& pass : file->paths.passes) {
        if (pass.path == session.path) check_along(session, pass);
        choose_what_is_drawn(session, own_path, pass);
    }
    if (file->paths.passes_of(session.path).empty() && !session.diagnostics.has_errors())
        session.diagnostics.report(Code::NoNodeInFile, {base, base}, "[pass]");
    // If the file has errors, the library's passes are used, so that errors in the graph are still found.
    if (session.diagnostics.has_errors()) return;
    session.declarations = &file->declarations;
    session.paths = &file->paths;
    session.pass_file = std::move(file);
}

}  // namespace

void find_path(Session& session) {
    if (session.engine.has_own_passes()) return read_passes(session, *session.engine.passes, session.engine.name);
    const std::string& wanted = session.options.path;
    if (!wanted.ends_with(".pass.hlsl")) {
        std::vector<std::string_view> known = session.paths->names();
        known.push_back(kAllPaths);
        if (std::find(known.begin(), known.end(), wanted) != known.end()) return;
        const bool is_file = wanted.find_first_of("./\\") != wanted.npos;
        std::string advice =
            is_file ? "name a file with passes NAME.pass.hlsl" : Diagnostics::suggestion(wanted, known);
        const std::string file = wanted + ".pass.hlsl";
        if (exists(session, file)) advice = fmt::format("did you mean '{}{}'?", is_file ? "" : "./", file);
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

}  // namespace patina::graph
