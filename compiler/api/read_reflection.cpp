#include "compiler/reflection/read_reflection.h"

#include "compiler/api/report.h"
#include "compiler/seam/seam.h"

namespace patina {

ReadReflection Reflection::from_json(std::string_view text, std::string file) {
    return guarded<ReadReflection>(file, [&](Trail&) {
        SourceMap sources;
        Diagnostics diagnostics;
        const std::uint32_t base = sources.add(file, std::string(text));
        ReadReflection made{.reflection = reflection::read_reflection(sources, base, diagnostics), .diagnostics = {}};
        made.diagnostics = to_public(diagnostics, sources);
        made.ok = !diagnostics.has_errors();
        return made;
    });
}

}  // namespace patina
