#include "compiler/writers/writers.h"

#include <algorithm>

#include "compiler/output/print_shaders.h"
#include "compiler/writers/shaderlab/shaderlab.h"

namespace patina::writers {
namespace {

// The formats of files that hold all passes of a material, which engine.json selects by name.
constexpr const output::Writer* kFormats[] = {&shaderlab::kWriter};

}  // namespace

const output::Writer& writer_of(const resolve::Session& session) {
    if (session.request.functions) return output::kFunctions;
    const auto* const found = std::find_if(std::begin(kFormats), std::end(kFormats), [&](const output::Writer* each) {
        return each->format == session.engine.file;
    });
    return found == std::end(kFormats) ? output::kStageFiles : **found;
}

engines::Printable printable() {
    engines::Printable all;
    for (const languages::LanguageInfo& each : languages::all_languages()) all.languages.push_back(each.name);
    for (const output::Writer* each : kFormats) all.formats.push_back(each->format);
    return all;
}

}  // namespace patina::writers
