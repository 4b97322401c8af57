#include "compiler/api/check_library.h"

#include "compiler/api/compiler_impl.h"
#include "compiler/api/evaluate.h"
#include "compiler/api/report.h"
#include "compiler/nodelang/parse.h"

namespace patina {
namespace {

void add(std::vector<Diagnostic>& all, const Diagnostics& some, const resolve::Library& library) {
    for (Diagnostic& each : to_public(some, library.sources)) all.push_back(std::move(each));
}

// The errors in the files of models from `first` on.
void add_models(std::vector<Diagnostic>& all, const resolve::Library& library, std::uint32_t first) {
    for (const auto* graphs : {&library.workflows, &library.lighting_models}) {
        for (const auto& [name, graph] : *graphs)
            if (graph.base() >= first) add(all, graph.diagnostics(), library);
    }
}

}  // namespace

std::vector<Diagnostic> check_overlay(resolve::Library& library) {
    if (!library.diagnostics.has_errors())
        check_functions({library, library.declarations, library.sources}, library.ast, library.diagnostics,
                        library.overlay_functions);
    std::vector<Diagnostic> all;
    add(all, library.diagnostics, library);
    add_models(all, library, library.overlay_begin);
    std::erase_if(all, [](const Diagnostic& each) { return each.severity != Severity::Error; });
    return all;
}

std::vector<Diagnostic> Compiler::library_diagnostics() const {
    const std::unique_ptr<resolve::Library> whole =
        impl_->library->unread.empty() ? nullptr : resolve::read_whole(*impl_->library);
    const resolve::Library& library = whole ? *whole : *impl_->library;
    std::vector<Diagnostic> all;
    add(all, library.diagnostics, library);
    for (const nodelang::FunctionDecl& function : library.ast.functions) {
        if (const Diagnostics* errors = nodelang::body_errors(function)) add(all, *errors, library);
    }
    for (const auto& [name, engine] : library.engines) add(all, engine.diagnostics(), library);
    add_models(all, library, 0);
    return all;
}

}  // namespace patina
