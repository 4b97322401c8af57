#include "compiler/link/check_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace patina::link {
namespace {

// A block that some devices do not take; that of the instances is one only if a single instance is so large.
void check_guaranteed(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered) {
    const std::uint32_t most = session.engine.guaranteed_block_bytes;
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const lower::PropertyGlobals& own = lowered.property_globals[i];
        const ir::GlobalId value = own.value ? own.value : own.tiling;
        if (!value || !lowered.module.globals[value.index].in_block()) continue;
        const ir::Global& global = lowered.module.globals[value.index];
        const ir::UniformBlock& block = lowered.module.blocks[global.block];
        const ir::BlockMember& member = block.members[global.member];
        if (member.offset + lower::extent(lowered.module, member.type).size <= most) continue;
        session.diagnostics
            .report(Code::LargeBlock, material.properties[i].property->name_span, block.name, block.size, most)
            .note(
                "check whether the device supports a block of this size, which the reflection has; or use fewer "
                "properties, or store some of them in a texture");
        return;
    }
}

void check_block(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered) {
    const std::uint32_t most = session.engine.most_block_bytes;
    if (most == 0) return;
    for (std::size_t i = 0; i < material.properties.size(); ++i) {
        const lower::PropertyGlobals& own = lowered.property_globals[i];
        const ir::GlobalId value = own.value ? own.value : own.tiling;
        if (!value || lowered.instance_globals.contains(value.index)) continue;  // instances.cpp fits those
        const ir::Global& global = lowered.module.globals[value.index];
        if (!global.in_block()) continue;
        const ir::UniformBlock& block = lowered.module.blocks[global.block];
        if (block.size <= most || block.members[global.member].offset < most) continue;
        session.diagnostics
            .report(Code::TooMany, material.properties[i].property->name_span, block.size,
                    "bytes of properties in a uniform block", most)
            .note(
                "the block ends before this property: make some properties constants of the graph, or store them in a "
                "texture");
        return;
    }
}

// The samplers that a stage reads. Each is named by its texture, or by the first of the textures that share it. A
// sampler that nodes name comes before all textures, and is a property itself.
std::vector<std::string_view> samplers_of(const ir::Module& stage) {
    std::set<std::uint32_t> read;
    for (const ir::Function& function : stage.functions) {
        for (const ir::Inst& inst : function.insts) {
            if (inst.op == ir::Op::Global) read.insert(inst.data);
        }
    }
    std::vector<std::string_view> names;
    for (const std::uint32_t i : read) {
        if (stage.globals[i].type.kind != ir::Kind::Sampler) continue;
        const bool has_texture = i > 0 && stage.globals[i - 1].type.is_texture();
        names.push_back(stage.globals[has_texture ? i - 1 : i].name);
    }
    return names;
}

void check_samplers(resolve::Session& session, const resolve::Material& material, const LinkedPass& pass) {
    const std::uint32_t most = session.engine.most_samplers;
    for (const ir::Module* stage : {&pass.vertex, &pass.fragment}) {
        const std::vector<std::string_view> samplers = samplers_of(*stage);
        if (samplers.size() <= most) continue;
        const auto is_over = [&](const resolve::MaterialProperty& entry) {
            const auto found = std::find(samplers.begin(), samplers.end(), entry.property->name);
            return found != samplers.end() && std::size_t(found - samplers.begin()) >= most;
        };
        const auto first = std::find_if(material.properties.begin(), material.properties.end(), is_over);
        if (first == material.properties.end()) continue;
        session.diagnostics
            .report(Code::TooMany, first->property->name_span, samplers.size(), "samplers in one stage", most)
            .note(fmt::format("the pass '{}' reads a texture with each of them; textures can share one: \"sampler\": "
                              "\"trilinearRepeat\"",
                              pass.pass->name));
        return;
    }
}

}  // namespace

void check_limits(resolve::Session& session, const resolve::Material& material, const lower::Lowered& lowered,
                  std::span<const LinkedPass> passes) {
    const std::size_t errors = session.diagnostics.error_count();
    check_block(session, material, lowered);
    if (session.diagnostics.error_count() == errors) check_guaranteed(session, material, lowered);
    if (session.engine.is_one_file() || session.engine.most_samplers == 0) return;
    const std::size_t before = session.diagnostics.error_count();
    for (const LinkedPass& pass : passes) {
        check_samplers(session, material, pass);
        if (session.diagnostics.error_count() > before) return;
    }
}

}  // namespace patina::link
