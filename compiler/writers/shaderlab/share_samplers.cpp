#include "compiler/writers/shaderlab/share_samplers.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "compiler/writers/shaderlab/dialect.h"

namespace patina::writers::shaderlab {
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

template <class Visit>
void for_each_global(const ir::Module& stage, Visit visit) {
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == Op::Global) visit(stage.globals[inst.data]);
        }
    }
}

const format::Property* property_of(const resolve::Material& material, std::string_view sampler) {
    for (const resolve::MaterialProperty& each : material.properties) {
        if (sampler.ends_with(each.property->name) && sampler.size() == each.property->name.size() + 7)
            return each.property;
    }
    return nullptr;
}

std::string sampler_of(std::string_view texture) {
    return fmt::format("sampler{}", texture);
}

// What the fragment stages do with a sampler.
struct Sampler {
    std::string name;
    const format::Property* property = nullptr;  // null if it belongs to no property
    std::vector<bool> reads;                     // for each pass
    // False if some stage needs a declaration of texture and sampler in one: a vertex stage, a pass that only loads
    // texels, or a texture that is not 2D, for which Unity has no other macro.
    bool is_free = true;
};

std::vector<Sampler> samplers_of(std::span<const LinkedPass> passes) {
    std::vector<Sampler> all;
    std::map<std::string, std::size_t, std::less<>> index;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const ir::Module& stage = passes[i].fragment;
        for_each_read(stage, [&](std::uint32_t texture, std::uint32_t sampler) {
            const std::string& name = stage.globals[sampler].name;
            const auto [found, is_new] = index.try_emplace(name, all.size());
            if (is_new) all.push_back({.name = name, .property = nullptr, .reads = std::vector<bool>(passes.size())});
            Sampler& each = all[found->second];
            each.property = property_of(*passes[i].material, name);
            each.reads[i] = true;
            each.is_free &= stage.globals[texture].type.kind == ir::Kind::Texture2D;
        });
    }
    for (std::size_t i = 0; i < passes.size(); ++i) {
        for (const ir::Module* stage : {&passes[i].fragment, &passes[i].vertex}) {
            for_each_global(*stage, [&](const ir::Global& global) {
                const auto found = index.find(global.type.is_texture() ? sampler_of(global.name) : global.name);
                if (found == index.end()) return;
                Sampler& each = all[found->second];
                each.is_free &= stage == &passes[i].fragment && each.reads[i];
            });
        }
    }
    return all;
}

}  // namespace

SamplerUse sampler_use(std::span<const LinkedPass> passes, std::size_t most) {
    SamplerUse use;
    std::vector<Sampler> samplers = samplers_of(passes);
    for (std::size_t i = 0; i < passes.size(); ++i) {
        std::set<std::string_view> of_engine;
        const std::vector<ir::StageText> texts = link::texts_of(passes[i]);
        for (const ir::StageText& text : texts) {
            if (text.place == "sampler") of_engine.insert(text.line);
        }
        const auto reads = [&](const Sampler& each) { return each.reads[i]; };
        const auto count = std::count_if(samplers.begin(), samplers.end(), reads);
        use.passes.push_back(
            {.of_engine = of_engine.size(), .of_material = static_cast<std::size_t>(count), .shared = 0});
    }
    // A texture that many passes read can lend its sampler to the most others.
    std::stable_sort(samplers.begin(), samplers.end(), [](const Sampler& a, const Sampler& b) {
        return std::count(a.reads.begin(), a.reads.end(), true) > std::count(b.reads.begin(), b.reads.end(), true);
    });
    const auto can_lend = [](const Sampler& owner, const Sampler& to) {
        bool is_there = owner.is_free && owner.property && owner.property->sampler == to.property->sampler;
        for (std::size_t i = 0; i < to.reads.size(); ++i) is_there &= owner.reads[i] || !to.reads[i];
        return is_there;
    };
    // The last textures share first, with the first texture of the same sampler, which therefore shares with no other.
    for (auto last = samplers.rbegin(); last != samplers.rend(); ++last) {
        bool is_needed = false;
        for (std::size_t i = 0; i < passes.size(); ++i) is_needed |= last->reads[i] && use.passes[i].count() > most;
        if (!is_needed || !last->is_free || !last->property) continue;
        const auto before = std::prev(last.base());
        const auto owner =
            std::find_if(samplers.begin(), before, [&](const Sampler& other) { return can_lend(other, *last); });
        if (owner == before) continue;
        use.shared.emplace_back(last->name, owner->name);
        for (std::size_t i = 0; i < passes.size(); ++i) use.passes[i].shared += last->reads[i] ? 1 : 0;
    }
    return use;
}

void share_samplers(ir::Module& stage, const SamplerUse& use) {
    const auto index_of = [&](std::string_view name) {
        const auto found = std::find_if(stage.globals.begin(), stage.globals.end(),
                                        [&](const ir::Global& each) { return each.name == name; });
        return static_cast<std::uint32_t>(found - stage.globals.begin());
    };
    for (const auto& [sampler, owner] : use.shared) {
        const std::uint32_t from = index_of(sampler), to = index_of(owner);
        if (from == stage.globals.size() || to == stage.globals.size()) continue;
        for (ir::Function& function : stage.functions) {
            for (ir::Inst& inst : function.insts) {
                if (inst.op == Op::Global && inst.data == from) inst.data = to;
            }
        }
    }
}

bool has_no_sampler(const ir::Module& stage, std::uint32_t texture) {
    bool is_sampled = false, has_own = false;
    for_each_read(stage, [&](std::uint32_t read, std::uint32_t sampler) {
        is_sampled |= read == texture;
        has_own |= stage.globals[sampler].name == sampler_of(stage.globals[texture].name);
    });
    return is_sampled && !has_own;
}

}  // namespace patina::writers::shaderlab
