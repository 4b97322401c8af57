#include "compiler/engines/shaderlab/share_samplers.h"

#include <algorithm>
#include <set>

#include "compiler/engines/shaderlab/dialect.h"

namespace patina::engines::shaderlab {
namespace {

using ir::Op;

// Calls `visit` with the indices of the texture and the sampler of each read that filters.
template <class Visit>
void for_each_read(const ir::Module& stage, Visit visit) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            const bool samples = inst.op == Op::Sample || inst.op == Op::SampleBias || inst.op == Op::SampleLevel ||
                                 inst.op == Op::SampleGrad;
            if (!samples) continue;
            const ir::Inst &texture = function[function.args(inst)[0]], &sampler = function[function.args(inst)[1]];
            if (texture.op == Op::Global && sampler.op == Op::Global) visit(texture.data, sampler.data);
        }
    }
}

std::set<std::uint32_t> samplers_of(const ir::Module& stage) {
    std::set<std::uint32_t> found;
    for_each_read(stage, [&](std::uint32_t, std::uint32_t sampler) { found.insert(sampler); });
    return found;
}

const graph::Property* property_of(const graph::Material& material, std::string_view sampler) {
    for (const graph::MaterialProperty& each : material.properties) {
        if (sampler.ends_with(each.property->name) && sampler.size() == each.property->name.size() + 7)
            return each.property;
    }
    return nullptr;
}

}  // namespace

SamplerUse sampler_use(const LinkedPass& pass, std::size_t most) {
    SamplerUse use;
    std::set<std::string_view> of_engine;
    const std::vector<ir::StageText> texts = link::texts_of(pass);
    for (const ir::StageText& text : texts) {
        if (text.place == "sampler") of_engine.insert(text.line);
    }
    use.of_engine = of_engine.size();
    const std::set<std::uint32_t> used = samplers_of(*pass.fragment), at_vertices = samplers_of(*pass.vertex);
    use.of_material = used.size();
    const auto has_own_macro = [&](std::uint32_t sampler) {
        bool is = false;
        for_each_read(*pass.fragment, [&](std::uint32_t texture, std::uint32_t with) {
            is |= with == sampler && pass.fragment->globals[texture].type.kind != ir::Kind::Texture2D;
        });
        return is;
    };
    // The last textures share first, with the first texture of the same sampler.
    for (auto last = used.rbegin(); last != used.rend() && use.count() > most; ++last) {
        const graph::Property* own = property_of(*pass.material, pass.fragment->globals[*last].name);
        if (!own || at_vertices.contains(*last) || has_own_macro(*last)) continue;
        const auto owner = std::find_if(used.begin(), used.end(), [&](std::uint32_t other) {
            const graph::Property* property = property_of(*pass.material, pass.fragment->globals[other].name);
            return other < *last && property && property->sampler == own->sampler && !at_vertices.contains(other) &&
                   !has_own_macro(other);
        });
        if (owner != used.end()) use.shared.emplace_back(*last, *owner);
    }
    return use;
}

void share_samplers(ir::Module& stage, const SamplerUse& use) {
    for (ir::Function& function : stage.functions) {
        for (ir::Inst& inst : function.insts) {
            if (inst.op != Op::Global) continue;
            for (const auto& [sampler, owner] : use.shared) {
                if (inst.data == sampler) inst.data = owner;
            }
        }
    }
}

bool has_no_sampler(const ir::Module& stage, std::uint32_t texture) {
    bool is_sampled = false, has_own = false;
    for_each_read(stage, [&](std::uint32_t read, std::uint32_t sampler) {
        is_sampled |= read == texture;
        has_own |= stage.globals[sampler].name == "sampler" + stage.globals[texture].name;
    });
    return is_sampled && !has_own;
}

}  // namespace patina::engines::shaderlab
