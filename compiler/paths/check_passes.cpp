// Checks the passes of a file against each other: states that no renderer can have, and render targets that differ
// between passes. Each error is reported where the file has it.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/paths/reading.h"

namespace patina::paths {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::StructDecl;

constexpr std::string_view kShown = "color";

// The place of the attribute in the function; without it, the function's name.
Span place_of(const FunctionDecl& function, std::string_view attribute) {
    const Attribute* found = function.attribute(attribute);
    return found ? found->span : function.name_span;
}

// A render target as one pass uses it.
struct Use {
    std::string_view name;
    std::optional<TargetFormat> format{};  // nothing: any
    bool from_light = false;
    std::string_view attribute;  // the attribute that names the target
    Span span;
};

class Check {
public:
    Check(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const PathDeclarations& paths,
          Diagnostics& diagnostics)
        : ast_(ast), declarations_(declarations), paths_(paths), diagnostics_(diagnostics) {}

    void run() {
        for (const std::string_view path : paths_.names()) {
            const std::vector<const PassDecl*> passes = paths_.passes_of(path);
            if (std::none_of(passes.begin(), passes.end(), [&](const PassDecl* p) { return is_own(*p); })) continue;
            for (const PassDecl* each : passes) {
                if (is_own(*each) && seen_.insert(each->fragment).second) state(*each);
            }
            stencils(passes);
            targets(passes);
        }
    }

private:
    bool is_own(const PassDecl& pass) const {
        return std::any_of(ast_.functions.begin(), ast_.functions.end(),
                           [&](const FunctionDecl& function) { return &function == pass.fragment; });
    }

    DiagnosticRecord& bad(const PassDecl& pass, std::string_view attribute, std::string_view why) {
        return diagnostics_.report(Code::BadAttribute, place_of(*pass.fragment, attribute), attribute, why);
    }

    void state(const PassDecl& pass) {
        const Pass& state = pass.state;
        if (state.draws == PassDraws::LightVolumes && state.lights != PassLights::Local) {
            bad(pass, "draws", "asks for light volumes, which only the lights of [lights(\"local\")] have");
        } else if (state.draws != PassDraws::Objects && state.lights == PassLights::Shadowed) {
            bad(pass, "draws", "selects no objects, but [lights(\"shadowed\")] draws the objects that a light sees");
        }
        if (state.each == PassEach::Light && state.lights == PassLights::None)
            bad(pass, "each", "asks for one draw for each light, but [lights(\"none\")] selects no lights");
    }

    // A pass can compare with a shared number only after another pass has written it to the stencil.
    void stencils(const std::vector<const PassDecl*>& passes) {
        bool is_left = false;
        for (const PassDecl* each : passes) {
            const Stencil& stencil = each->state.stencil;
            if (!stencil.is_of_lighting()) continue;
            if (stencil.test != Compare::Always && stencil.test != Compare::Never && !is_left && is_own(*each)) {
                bad(*each, "stencil",
                    fmt::format("compares with '{}', which no earlier pass writes", to_string(stencil.reference)))
                    .note(
                        fmt::format("write it in a pass that draws objects: [stencil(\"always\", \"replace\", \"{}\")]",
                                    to_string(stencil.reference)));
            }
            is_left = is_left || stencil.pass == StencilOp::Replace;
        }
    }

    // --- targets

    void targets(const std::vector<const PassDecl*>& passes) {
        std::vector<Use> uses = {{.name = kShown, .from_light = false, .attribute = {}, .span = {}}};
        for (const PassDecl* each : drawn_along(passes)) {
            for (const Use& use : uses_of(*each)) {
                if (use.name != kShown) uses.push_back(use);  // a frame holds one picture, in one format
            }
        }
        for (const PassDecl* each : passes) {
            for (const Use& use : uses_of(*each)) {
                if (!is_own(*each) || agrees(use, uses)) uses.push_back(use);
            }
        }
    }

    // Passes that switches add, and passes of the paths that materials fall back to. The same frame holds their
    // targets.
    std::vector<const PassDecl*> drawn_along(const std::vector<const PassDecl*>& passes) const {
        std::vector<const PassDecl*> others;
        for (const SwitchDecl& each : paths_.switches) {
            if (const PassDecl* brought = paths_.pass(each.brings)) others.push_back(brought);
        }
        std::set<std::string_view> fallbacks;
        for (const PassDecl* each : passes) {
            if (!each->state.fallback.empty() && fallbacks.insert(each->state.fallback).second) {
                for (const PassDecl* other : paths_.passes_of(each->state.fallback)) others.push_back(other);
            }
        }
        std::erase_if(others, [&](const PassDecl* other) {
            return !other->fragment || std::find(passes.begin(), passes.end(), other) != passes.end();
        });
        return others;
    }

    std::vector<Use> uses_of(const PassDecl& pass) const {
        const bool from_light = pass.state.lights == PassLights::Shadowed;
        std::vector<Use> uses;
        if (!pass.state.depth_target.empty())
            uses.push_back({.name = pass.state.depth_target,
                            .format = TargetFormat::Depth,
                            .from_light = from_light,
                            .attribute = "depthTarget",
                            .span = place_of(*pass.fragment, "depthTarget")});
        const StructDecl* structure = declarations_.structure(pass.fragment->result.name);
        for (const RenderTarget& target : pass.state.targets) {
            Span span = place_of(*pass.fragment, "target");
            if (structure && target.location < structure->members.size()) {
                const Attribute* said = structure->members[target.location].attribute("target");
                if (said) span = said->span;
            }
            uses.push_back({.name = target.name,
                            .format = target.format,
                            .from_light = from_light,
                            .attribute = "target",
                            .span = span});
        }
        return uses;
    }

    bool agrees(const Use& use, const std::vector<Use>& before) {
        for (const Use& other : before) {
            if (other.name != use.name) continue;
            std::string differs;
            if (other.format && use.format && other.format != use.format)
                differs = fmt::format("declares '{}' as {}, but it is {} elsewhere", use.name, to_string(*use.format),
                                      to_string(*other.format));
            else if (other.from_light != use.from_light)
                differs =
                    fmt::format("draws '{}' from {}, but elsewhere it is drawn from {}", use.name,
                                use.from_light ? "a light" : "the camera", use.from_light ? "the camera" : "a light");
            if (differs.empty()) continue;
            DiagnosticRecord& record = diagnostics_.report(Code::BadAttribute, use.span, use.attribute, differs);
            if (other.span) record.note(other.span, "the other one is here");
            return false;
        }
        return true;
    }

    const nodelang::Ast& ast_;
    const nodelang::Declarations& declarations_;
    const PathDeclarations& paths_;
    Diagnostics& diagnostics_;
    std::set<const FunctionDecl*> seen_;
};

}  // namespace

void check_passes(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const PathDeclarations& paths,
                  Diagnostics& diagnostics) {
    Check(ast, declarations, paths, diagnostics).run();
}

}  // namespace patina::paths
