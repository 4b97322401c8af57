// Holds the measured cost of passes to a budget.
#include <fmt/format.h>

#include <algorithm>

#include "patina/complaints.h"
#include "patina/cost.h"

namespace patina {
namespace {

constexpr std::size_t kShown = 3;  // of the heaviest nodes

Diagnostic at(const CostLimit& limit, Diagnostic diagnostic) {
    return limit.place.file.empty() ? std::move(diagnostic)
                                    : diagnostic_at(limit.place, diagnostic.code, diagnostic.message);
}

void add_heaviest(Diagnostic& diagnostic, const StageCost& cost) {
    std::size_t shown = 0;
    for (const NodeCost& node : cost.nodes) {
        if (node.node.empty() || shown++ == kShown) continue;
        Diagnostic note = diagnostic_at({.file = node.file, .line = node.line}, diagnostic.code,
                                        fmt::format("'{}' adds {} of them", node.node, node.total()));
        note.severity = Severity::Note;
        note.node = node.node;
        diagnostic.notes.push_back(std::move(note));
    }
}

std::string text(std::uint32_t number) {
    return std::to_string(number);
}

}  // namespace

std::vector<Diagnostic> over_budget(const MaterialCost& measured, const Budget& budget) {
    std::vector<Diagnostic> diagnostics;
    for (const PassCost& pass : measured.passes) {
        if (const auto& limit = budget.textures; limit && pass.textures > limit->most)
            diagnostics.push_back(at(
                *limit, complaint(Complaint::TooManyTextures, {pass.name, text(pass.textures),
                                                               text(pass.textures - limit->most), text(limit->most)})));
        for (const Stage stage : {Stage::Vertex, Stage::Fragment}) {
            const StageCost& cost = stage == Stage::Vertex ? pass.vertex : pass.fragment;
            const auto& limit = budget.instructions;
            if (!limit || cost.total() <= limit->most) continue;
            diagnostics.push_back(at(*limit, complaint(Complaint::TooManyInstructions,
                                                       {to_string(stage), pass.name, text(cost.total()),
                                                        stage == Stage::Vertex ? "vertex" : "pixel",
                                                        text(cost.total() - limit->most), text(limit->most)})));
            add_heaviest(diagnostics.back(), cost);
        }
    }
    return diagnostics;
}

}  // namespace patina
