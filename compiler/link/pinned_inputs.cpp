#include "compiler/link/pinned_inputs.h"

#include <algorithm>
#include <map>

#include "compiler/ir/rebuild.h"
#include "compiler/link/canonical_hash.h"

namespace patina::link {
namespace {

// An input of the fragment stage, by its position, with the hash of its computation in the vertex stage.
struct Pinned {
    std::uint32_t place;
    CanonicalHash hash;
};

bool is_pinned(const Linked& linked, const ir::StageVariable& input) {
    if (input.builtin != ir::Builtin::None) return false;
    const auto& semantics = linked.lowered.module.semantics;
    const auto found =
        std::find_if(semantics.begin(), semantics.end(), [&](const ir::Semantic& s) { return s.name == input.name; });
    if (found == semantics.end()) return false;
    const lower::SemanticRecipe& recipe = linked.lowered.semantics[static_cast<std::size_t>(found - semantics.begin())];
    return recipe.source == paths::SemanticSource::Vertex && !recipe.declaration;
}

// In the order of the fragment stage's inputs. Empty if there is only one, which needs no comparison.
std::vector<Pinned> find_pinned(const Linked& linked, const ir::Module& fragment, const ir::Module& vertex) {
    std::vector<Pinned> pinned;
    const std::vector<ir::StageVariable>& inputs = fragment.stage.inputs;
    for (std::uint32_t i = 0; i < inputs.size(); ++i) {
        if (is_pinned(linked, inputs[i])) pinned.push_back({i, {}});
    }
    if (pinned.size() < 2) return {};
    const std::vector<CanonicalHash> hashes = hash_outputs(vertex);
    const std::vector<ir::StageVariable>& outputs = vertex.stage.outputs;
    for (Pinned& each : pinned) {
        const auto output = std::find_if(outputs.begin(), outputs.end(),
                                         [&](const auto& o) { return o.name == inputs[each.place].name; });
        if (output != outputs.end()) each.hash = hashes[static_cast<std::size_t>(output - outputs.begin())];
    }
    return pinned;
}

}  // namespace

bool share_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex) {
    std::map<CanonicalHash, std::uint32_t> first;
    std::map<std::uint32_t, std::uint32_t> equal;  // position -> position of the first equal one
    for (const Pinned& each : find_pinned(linked, fragment, vertex)) {
        const auto [found, is_new] = first.emplace(each.hash, each.place);
        if (!is_new) equal[each.place] = found->second;
    }
    if (equal.empty()) return false;
    ir::Function& entry = fragment.functions[fragment.stage.entry.index];
    const ir::Function from = std::move(entry);
    ir::Function made = ir::shell(from);
    ir::Builder builder(fragment, made, {});
    ir::Copy copy{.from = from, .to = builder, .rewrite = [&](ir::Copy& c, ir::Value v) {
                      const auto found = equal.find(from[v].data);
                      if (from[v].op != ir::Op::Param || found == equal.end()) return false;
                      c.map[v.index] = c.to.param(found->second);
                      return true;
                  }};
    ir::copy_body(copy);
    fragment.functions[fragment.stage.entry.index] = std::move(made);
    return true;
}

bool order_pinned(const Linked& linked, ir::Module& fragment, const ir::Module& vertex) {
    const std::vector<Pinned> found = find_pinned(linked, fragment, vertex);
    const auto by_hash = [](const Pinned& a, const Pinned& b) { return a.hash < b.hash; };
    if (std::is_sorted(found.begin(), found.end(), by_hash)) return false;
    std::vector<Pinned> sorted = found;
    std::stable_sort(sorted.begin(), sorted.end(), by_hash);
    ir::Function& entry = fragment.functions[fragment.stage.entry.index];
    const std::vector<ir::StageVariable> inputs = fragment.stage.inputs;
    const std::vector<ir::Param> params = entry.params;
    std::map<std::uint32_t, std::uint32_t> moved;
    for (std::size_t i = 0; i < found.size(); ++i) {
        fragment.stage.inputs[found[i].place] = inputs[sorted[i].place];
        entry.params[found[i].place] = params[sorted[i].place];
        moved[sorted[i].place] = found[i].place;
    }
    for (ir::Inst& inst : entry.insts) {
        if (inst.op != ir::Op::Param) continue;
        if (const auto place = moved.find(inst.data); place != moved.end()) inst.data = place->second;
    }
    return true;
}

}  // namespace patina::link
