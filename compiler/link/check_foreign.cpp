// Functions whose code is text ([foreign]): only some languages can take it, and the interpreter cannot.
#include <fmt/format.h>

#include <optional>
#include <vector>

#include "compiler/languages/print.h"
#include "compiler/link/check_reads.h"

namespace patina::link {
namespace {

struct Found {
    std::string_view function;
    ir::OriginId where;  // of the innermost node on the way
};

class Search {
public:
    explicit Search(const ir::Module& stage) : stage_(stage), seen_(stage.functions.size()) {}

    std::optional<Found> run() {
        if (stage_.stage.entry) return visit(stage_.stage.entry.index, {});
        for (std::uint32_t i = static_cast<std::uint32_t>(seen_.size()); i-- > 0;)
            if (std::optional<Found> found = visit(i, {})) return found;
        return {};
    }

private:
    std::optional<Found> visit(std::uint32_t index, ir::OriginId origin) {
        if (seen_[index]) return {};
        seen_[index] = true;
        const ir::Function& function = stage_.functions[index];
        if (function.linkage == ir::Linkage::Verbatim) return Found{function.name, origin};
        for (const ir::Inst& inst : function.insts) {
            if (inst.op != ir::Op::Call) continue;
            if (std::optional<Found> found = visit(inst.data, inst.origin ? inst.origin : origin)) return found;
        }
        return {};
    }

    const ir::Module& stage_;
    std::vector<bool> seen_;
};

// `at`: where it is reported if no node leads to it.
void report(Diagnostics& diagnostics, const ir::Module& stage, const Found& found, std::string_view reader, Span at) {
    std::string_view taker;
    for (const languages::LanguageInfo& each : languages::all_languages())
        if (each.takes_foreign) taker = each.name;
    const ir::Origin where = found.where ? stage.origins[found.where.index] : ir::Origin{.span = at};
    diagnostics.report(Code::ForeignText, where.span, found.function, reader)
        .note(fmt::format("compile the graph for {0} alone, and draw it with --via {0}. For all other uses write the "
                          "function in the node language, without [foreign]",
                          taker))
        .at(where.id);
}

}  // namespace

void check_foreign(resolve::Session& session, std::span<const ir::Module* const> stages, Span at) {
    for (const Target& target : session.options.targets) {
        if (languages::find_language(target.language)->takes_foreign) continue;
        for (const ir::Module* stage : stages) {
            const std::optional<Found> found = Search(*stage).run();
            if (!found) continue;
            return report(session.diagnostics, *stage, *found, fmt::format("the language '{}'", target.language), at);
        }
    }
}

bool has_no_foreign(Diagnostics& diagnostics, const ir::Module& stage, std::string_view reader, Span at) {
    const std::optional<Found> found = Search(stage).run();
    if (found) report(diagnostics, stage, *found, reader, at);
    return !found;
}

}  // namespace patina::link
