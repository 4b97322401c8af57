#include "compiler/link/functions.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/spelling.h"
#include "compiler/ir/passes/passes.h"
#include "compiler/languages/names.h"

namespace patina::link {
namespace {

// GLSL reserves names with two underscores in a row.
std::string prefixed(std::string_view prefix, std::string_view name) {
    if (prefix.ends_with('_') && name.starts_with('_')) name.remove_prefix(1);
    return fmt::format("{}{}", prefix, name);
}

// Gives structs and functions the names that the printers will use; each name is used once.
void name_all(ir::Module& module, std::string_view prefix) {
    languages::Names names;
    for (const ir::UniformBlock& block : module.blocks) {
        names.declare(block.name);
        for (const ir::BlockMember& member : block.members) names.declare(member.name);
    }
    for (const ir::Global& global : module.globals) {
        if (!global.in_block()) names.declare(global.name);
    }
    const std::vector<bool> shared = ir::shared_structs(module);
    for (std::size_t i = 0; i < module.structs.size(); ++i) {
        std::string& name = module.structs[i].name;
        name = names.declare(shared[i] ? name : prefixed(prefix, name));
    }
    for (ir::Function& function : module.functions) {
        const bool is_engines = function.linkage == ir::Linkage::External;
        function.name = names.declare(is_engines ? function.name : prefixed(prefix, function.name));
    }
}

// Describes a parameter, from the semantic of its name.
std::string doc_of(const lower::Lowered& lowered, std::string_view param) {
    for (std::size_t i = 0; i < lowered.semantics.size(); ++i) {
        if (lowered.module.semantics[i].name != param) continue;
        const paths::SemanticDecl* declared = lowered.semantics[i].declaration;
        if (!declared)
            return lowered.semantics[i].recipe ? fmt::format("interpolated, from {}()", joined("vertex", param)) : "";
        const std::string doc =
            nodelang::first_sentence(declared->function ? declared->function->doc : declared->variable->doc);
        return doc.substr(0, doc.find(". "));
    }
    return {};
}

void tell_about(ir::Function& function, const lower::Lowered& lowered) {
    for (const ir::Param& param : function.params) {
        const std::string doc = param.is_semantic ? doc_of(lowered, param.name) : "";
        if (!doc.empty()) function.comment += fmt::format("\n  {}: {}", param.name, doc);
    }
}

}  // namespace

void prefix_interface(ir::Module& module, std::string_view prefix) {
    for (ir::UniformBlock& block : module.blocks) {
        if (block.group != ir::Group::Material) continue;
        block.name = prefixed(prefix, block.name);
        for (ir::BlockMember& member : block.members) member.name = prefixed(prefix, member.name);
    }
    for (ir::Global& global : module.globals) {
        if (global.group == ir::Group::Material) global.name = prefixed(prefix, global.name);
    }
}

ir::Module link_functions(const Linked& linked, Stage stage, std::string_view prefix) {
    ir::Module module = linked.lowered.module;
    module.functions = linked.functions;
    bool is_empty = true;
    for (const lower::LoweredFunction& function : linked.lowered.functions) {
        if (function.is_vertex != (stage == Stage::Vertex)) continue;
        module[function.id].linkage = ir::Linkage::Exported;
        is_empty = false;
    }
    if (is_empty) {
        module.functions.clear();
        return module;
    }
    module = ir::tidy(std::move(module));
    for (ir::Function& function : module.functions) {
        if (function.linkage == ir::Linkage::Exported) tell_about(function, linked.lowered);
    }
    name_all(module, prefix);
    return module;
}

std::vector<ShaderFunction> describe_functions(const ir::Module& module, Stage stage) {
    std::vector<ShaderFunction> described;
    for (const ir::Function& function : module.functions) {
        if (function.linkage == ir::Linkage::Internal || function.linkage == ir::Linkage::Verbatim) continue;
        ShaderFunction& made = described.emplace_back();
        made.name = function.name;
        made.stage = stage;
        made.is_engines = function.linkage == ir::Linkage::External;
        made.result = module.type_name(function.result);
        for (const ir::Param& param : function.params)
            made.parameters.push_back({.name = param.name, .type = module.type_name(param.type)});
    }
    return described;
}

}  // namespace patina::link
