// What the passes of a file state, held against each other: a state that no renderer can give, targets that differ from
// pass to pass, members of a surface that nobody has. Each is told where the file says it.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compiler/base/text.h"
#include "compiler/resolve/material.h"

namespace patina::graph {
namespace {

using nodelang::Attribute;
using nodelang::Expr;
using nodelang::FunctionDecl;
using nodelang::StructDecl;

constexpr std::string_view kShown = "color";
constexpr std::string_view kDepthFormat = "depth";

// Where the function says it; else the function itself.
Span place_of(const FunctionDecl& function, std::string_view attribute) {
    const Attribute* found = function.attribute(attribute);
    return found ? found->span : function.name_span;
}

// A target as a pass draws into it.
struct Use {
    std::string_view name, format;
    bool from_light = false;
    std::string_view attribute;  // that says so
    Span span;
};

class Check {
public:
    Check(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const Stages& stages,
          Diagnostics& diagnostics)
        : ast_(ast), declarations_(declarations), stages_(stages), diagnostics_(diagnostics) {}

    void run() {
        for (const std::string_view path : stages_.paths()) {
            const std::vector<const PassDecl*> passes = stages_.passes_of(path);
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
        if (state.draws == "light-volumes" && state.lights != "local") {
            bad(pass, "draws", "takes volumes of lights, and only those of [lights(\"local\")] have one");
        } else if (state.draws != "objects" && state.lights == "shadowed") {
            bad(pass, "draws", "shows no objects, and [lights(\"shadowed\")] draws those that a light sees");
        }
        if (state.each == "light" && state.lights == "none")
            bad(pass, "each", "asks for a drawing for each light, and [lights(\"none\")] leaves none");
    }

    // A number is there to be compared with once a pass has left it.
    void stencils(const std::vector<const PassDecl*>& passes) {
        bool is_left = false;
        for (const PassDecl* each : passes) {
            const Stencil& stencil = each->state.stencil;
            if (stencil.reference.empty()) continue;
            if (stencil.test != "always" && stencil.test != "never" && !is_left && is_own(*each)) {
                bad(*each, "stencil",
                    fmt::format("compares with '{}', which no pass before this one leaves", stencil.reference))
                    .note(fmt::format("a pass that draws objects leaves it: [stencil(\"always\", \"replace\", \"{}\")]",
                                      stencil.reference));
            }
            is_left = is_left || stencil.pass == "replace";
        }
    }

    // --- targets

    void targets(const std::vector<const PassDecl*>& passes) {
        std::vector<Use> uses = {{.name = kShown, .format = {}, .from_light = false, .attribute = {}, .span = {}}};
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

    // What switches bring, and what materials fall back to: the same frame holds their targets.
    std::vector<const PassDecl*> drawn_along(const std::vector<const PassDecl*>& passes) const {
        std::vector<const PassDecl*> others;
        for (const SwitchDecl& each : stages_.switches) {
            if (const PassDecl* brought = stages_.pass(each.brings)) others.push_back(brought);
        }
        std::set<std::string_view> fallbacks;
        for (const PassDecl* each : passes) {
            if (!each->state.fallback.empty() && fallbacks.insert(each->state.fallback).second) {
                for (const PassDecl* other : stages_.passes_of(each->state.fallback)) others.push_back(other);
            }
        }
        std::erase_if(others, [&](const PassDecl* other) {
            return !other->fragment || std::find(passes.begin(), passes.end(), other) != passes.end();
        });
        return others;
    }

    std::vector<Use> uses_of(const PassDecl& pass) const {
        const bool from_light = pass.state.lights == "shadowed";
        std::vector<Use> uses;
        if (!pass.state.depth_target.empty())
            uses.push_back({.name = pass.state.depth_target,
                            .format = kDepthFormat,
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
            if (!other.format.empty() && other.format != use.format)
                differs = fmt::format("makes '{}' {}, which is {} elsewhere", use.name, use.format, other.format);
            else if (other.from_light != use.from_light)
                differs =
                    fmt::format("has '{}' drawn from {}, which elsewhere is drawn from {}", use.name,
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
    const Stages& stages_;
    Diagnostics& diagnostics_;
    std::set<const FunctionDecl*> seen_;
};

// The struct that the slots take first.
const StructDecl* lighting_surface(const Session& session) {
    for (const FunctionDecl* slot : session.stages->slots) {
        if (slot->params.empty()) return session.declarations->structure(slot->result.name);
    }
    return nullptr;
}

// Whether anything finds out if a material has this slot.
bool is_asked_for(const Stages& stages, std::string_view slot) {
    const auto needs = [&](const PassDecl& pass) {
        return std::find(pass.needs.begin(), pass.needs.end(), slot) != pass.needs.end();
    };
    const auto asks = [&](const nodelang::VariableDecl* variable) {
        const std::vector<std::string_view> words = attribute_words(*variable->attribute("static"));
        return !words.empty() && words[0] == "slot" && std::find(words.begin() + 1, words.end(), slot) != words.end();
    };
    return std::any_of(stages.passes.begin(), stages.passes.end(), needs) ||
           std::any_of(stages.statics.begin(), stages.statics.end(), asks);
}

}  // namespace

void check_passes(const nodelang::Ast& ast, const nodelang::Declarations& declarations, const Stages& stages,
                  Diagnostics& diagnostics) {
    Check(ast, declarations, stages, diagnostics).run();
}

void check_surface_members(Session& session, const Material& material) {
    const StructDecl* surface = session.pass_file ? lighting_surface(session) : nullptr;
    if (!surface) return;
    std::vector<std::string_view> known;
    for (const auto& member : surface->members) known.push_back(member.name);
    if (material.lighting) {
        for (const Input& input : material.lighting->graph->inputs) known.push_back(input.name);
    }
    std::vector<std::string_view> held = known;
    for (const FunctionDecl* slot : session.stages->slots) held.push_back(slot->name);
    // Another lighting model may declare what this one does not, where a pass goes without: then only a word that is
    // near a known one is a mistake.
    const auto check = [&](const Expr& given, std::string_view word, const std::vector<std::string_view>& words,
                           bool may_be_absent) {
        if (std::find(words.begin(), words.end(), word) != words.end()) return;
        const std::string_view near = nearest(word, words);
        if (!near.empty() || !may_be_absent)
            session.diagnostics.report(Code::UnknownName, given.span, "member", given.text)
                .note(near.empty() ? Diagnostics::suggestion(word, words) : fmt::format("did you mean '{}'?", near));
    };
    for (const FunctionDecl& function : session.pass_file->ast.functions) {
        for (const Attribute& attribute : function.attributes) {
            if (attribute.name == "holds") {
                for (const Expr* given : attribute.args) check(*given, given->text, held, true);
            }
            const bool is_part = attribute.name == "part" || attribute.name == "without";
            if (!is_part || attribute.args.size() < 2) continue;
            const Expr& given = *attribute.args[1];
            const std::size_t dot = given.text.find('.');
            for (const nodelang::ParamDecl& param : function.params) {
                if (dot != given.text.npos && param.name == given.text.substr(0, dot) &&
                    param.type.name == surface->name)
                    check(given, given.text.substr(dot + 1), known, is_asked_for(*session.stages, function.name));
            }
        }
    }
}

}  // namespace patina::graph
