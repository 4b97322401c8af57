#include "compiler/api/report.h"
#include "compiler/format/read_fields.h"
#include "compiler/seam/seam.h"
#include "patina/reflection.h"

namespace patina {

ReadNumbers read_array_value(PropertyType type, std::string_view json) {
    return guarded<ReadNumbers>("value", [&](Trail&) {
        SourceMap sources;
        Diagnostics diagnostics;
        nodelang::Ast ast;
        ReadNumbers made;
        format::Reading reading{sources, ast, diagnostics};
        const std::uint32_t base = sources.add("value", std::string(json));
        const std::unique_ptr<json::Json> root = json::parse_json(sources, base, diagnostics);
        if (root && is_array(type)) {
            if (std::optional<std::vector<double>> numbers = format::read_array_value(reading, *root, type))
                made.numbers = std::move(*numbers);
        }
        made.ok = !made.numbers.empty() && !diagnostics.has_errors();
        made.diagnostics = to_public(diagnostics, sources);
        return made;
    });
}

}  // namespace patina
