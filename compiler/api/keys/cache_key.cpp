// Compiler::library_hash() and cache_key(): what must be equal for two results to be equal.
#include <algorithm>

#include "compiler/api/compiler_impl.h"
#include "compiler/api/keys/request_fields.h"
#include "compiler/base/source_hash.h"
#include "compiler/link/canonical_hash.h"
#include "compiler/resolve/material.h"

namespace patina {
namespace {

// Each file that was asked for: whether it is there, and its text. The bytes of a texture were not asked for.
void add_files(Fields& fields, const resolve::Files& files) {
    for (const auto& [path, answer] : files.answers()) {
        const bool is_there = answer.text.has_value() || answer.exists.value_or(false);
        fields.add("file").add(path).add_flag(is_there).add(answer.why);
        if (answer.text) fields.add(link::hash_text(*answer.text).text());
    }
}

// The key of a part would be that of another graph, too.
bool is_cancelled(const Diagnostics& diagnostics) {
    const std::vector<DiagnosticRecord>& all = diagnostics.records();
    return std::any_of(all.begin(), all.end(),
                       [](const DiagnosticRecord& each) { return each.code == Code::Cancelled; });
}

std::string key_of(const Compiler& compiler, const resolve::Library& library, const std::string& path,
                   const std::string* text, const CompileOptions& options) {
    resolve::Files files(options);
    CompileOptions asked = options;
    asked.targets.clear();
    if (text && asked.accept_parts) files.give_part(path, *text);
    resolve::Session session(library, asked, &files);
    resolve::until_stopped(session, [&] {
        std::optional<std::uint32_t> base =
            text ? std::optional(session.sources.add(path, *text)) : resolve::load_source(session, path, {});
        if (!session.request.functions) resolve::find_path(session);
        if (base) resolve::read_material(session, *base, path);
    });
    if (is_cancelled(session.diagnostics)) return {};
    Fields fields;
    fields.add(compiler.library_hash()).add(path);
    fields.add_flag(text != nullptr);
    if (text) fields.add(*text);
    add_options(fields, options);
    add_files(fields, files);
    return link::hash_text(fields.text()).text();
}

}  // namespace

std::string Compiler::library_hash() const {
    return impl_->hash.get([&] {
        const resolve::Library& library = *impl_->library;
        Fields fields;
        fields.add(version()).add(source_hash());
        for (const std::uint32_t file : library.files)
            fields.add(library.sources.file(file)).add(library.sources.file_text(file));
        return std::make_unique<std::string>(link::hash_text(fields.text()).text());
    });
}

std::string Compiler::cache_key(const std::string& path, const CompileOptions& options) const {
    return key_of(*this, *impl_->library, path, nullptr, options);
}

std::string Compiler::cache_key(const std::string& path, std::string text, const CompileOptions& options) const {
    return key_of(*this, *impl_->library, path, &text, options);
}

}  // namespace patina
