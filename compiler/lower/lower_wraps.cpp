// Lowers the functions that the library puts around what all passes have: [wraps].
#include <algorithm>

#include "compiler/lower/lowering.h"

namespace patina::lower {
namespace {

// True if no pass draws into the target from a light: it has the size of the picture then.
bool is_of_picture(const paths::PathDeclarations& paths, std::string_view target) {
    return std::none_of(paths.passes.begin(), paths.passes.end(), [&](const paths::PassDecl& pass) {
        const Pass& state = pass.state;
        return state.lights == PassLights::Shadowed &&
               (state.depth_target == target ||
                std::any_of(state.targets.begin(), state.targets.end(),
                            [&](const RenderTarget& written) { return written.name == target; }));
    });
}

// The semantic that is the default of the function's parameter, if the library computes it: a pass file may compute
// something else.
std::optional<ir::SemanticId> own_pixel(const Lowering& lowering, const nodelang::FunctionDecl& reads) {
    const paths::PathDeclarations& paths = *lowering.session.paths;
    const nodelang::Expr* initial = reads.params.empty() ? nullptr : reads.params[0].initial;
    const auto found = initial ? paths.semantic_index.find(initial->text) : paths.semantic_index.end();
    if (found == paths.semantic_index.end()) return {};
    const paths::SemanticDecl* librarys = lowering.session.library.paths.semantic(initial->text);
    if (!librarys || librarys->function != paths.semantics[found->second].function) return {};
    return ir::SemanticId{found->second};
}

}  // namespace

void lower_wraps(Lowering& lowering, std::span<const std::string_view> on) {
    const paths::PathDeclarations& paths = *lowering.session.paths;
    Lowered& out = lowering.out;
    for (const auto& [global, target] : out.reads) {
        if (is_of_picture(paths, target)) out.picture_reads.insert(global);
    }
    for (const paths::WrapDecl& wrap : paths.wraps) {
        if (wrap.what == paths::WrapDecl::What::Reads) out.wraps.own_pixel = own_pixel(lowering, *wrap.function);
        if (std::find_first_of(wrap.with.begin(), wrap.with.end(), on.begin(), on.end()) == wrap.with.end()) continue;
        const ir::FunctionId made =
            emit::plain_function(lowering.emitter, *wrap.function, *lowering.session.declarations);
        switch (wrap.what) {
            case paths::WrapDecl::What::Position: out.wraps.position = made; break;
            case paths::WrapDecl::What::Pixel: out.wraps.pixel = made; break;
            case paths::WrapDecl::What::Reads: out.wraps.reads = made; break;
        }
    }
}

}  // namespace patina::lower
