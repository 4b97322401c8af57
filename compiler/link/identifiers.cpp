#include "compiler/link/identifiers.h"

#include "compiler/languages/names.h"
#include "compiler/lower/declare.h"

namespace patina::link {
namespace {

void name_group(ir::Module& module, ir::Group group, languages::Names& names) {
    for (const ir::UniformBlock& block : module.blocks) {
        for (const ir::Global& global : module.globals) {
            if (global.group != group || !global.in_block() || &module.blocks[global.block] != &block) continue;
            std::string& name = module.blocks[global.block].members[global.member].name;
            name = names.declare(name);
        }
    }
    for (ir::Global& global : module.globals) {
        if (!global.in_block() && global.group == group) global.name = names.declare(global.name);
    }
}

void name_members(ir::Module& module) {
    for (ir::Global& global : module.globals) {
        if (global.in_block()) global.name = module.blocks[global.block].members[global.member].name;
    }
}

// True if the included file declares a property under that name.
bool is_property(const ir::Module& module, std::string_view name) {
    for (const ir::UniformBlock& block : module.blocks) {
        for (const ir::BlockMember& member : block.members) {
            if (!member.declared_in.empty() && member.name == name) return true;
        }
    }
    return false;
}

}  // namespace

void name_interface(ir::Module& module) {
    languages::Names names;
    bool is_included = false;  // included files declare the engine's values, and the text has no blocks
    for (const ir::Global& global : module.globals) {
        is_included = is_included || global.is_foreign();
        if (!global.is_foreign() || is_property(module, global.spelling)) continue;
        names.declare(global.spelling.substr(0, global.spelling.find('.')));
    }
    if (is_included) {
        name_group(module, ir::Group::Material, names);
        return name_members(module);
    }
    for (ir::UniformBlock& block : module.blocks) block.name = names.declare(block.name);
    name_group(module, ir::Group::Engine, names);  // first: hosts know these by name
    name_group(module, ir::Group::Material, names);
    name_members(module);
}

}  // namespace patina::link
