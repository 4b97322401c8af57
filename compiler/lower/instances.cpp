#include "compiler/lower/instances.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "compiler/base/spelling.h"

namespace patina::lower {
namespace {

using ir::Op;
using ir::Type;
using ir::Value;

std::uint32_t instance_semantic(const Lowered& lowered) {
    const auto is_instance = [](const SemanticRecipe& recipe) {
        return recipe.declaration && recipe.declaration->builtin == ir::Builtin::InstanceIndex;
    };
    const auto found = std::find_if(lowered.semantics.begin(), lowered.semantics.end(), is_instance);
    return static_cast<std::uint32_t>(found - lowered.semantics.begin());
}

// What the passes of a material may read, by functions that call each other.
class Readers {
public:
    explicit Readers(const Lowered& lowered) : lowered_(lowered) {}

    bool reads(std::uint32_t semantic) {
        for (const LoweredPass& pass : lowered_.passes) {
            visit(pass.vertex);
            visit(pass.fragment);
            for (const Given<ir::SemanticId>& given : pass.recipes) visit(given.by);
            for (const Given<ir::FunctionId>& given : pass.replaced) visit(given.by);
        }
        return semantics_.contains(semantic);
    }

private:
    void visit(ir::FunctionId id) {
        if (!id || !functions_.insert(id.index).second) return;
        for (const ir::Inst& inst : lowered_.module[id].insts) {
            if (inst.op == Op::Call) visit({inst.data});
            if (inst.op != Op::Semantic || !semantics_.insert(inst.data).second) continue;
            visit(lowered_.semantics[inst.data].recipe);
            visit(lowered_.semantics[inst.data].override);
        }
    }

    const Lowered& lowered_;
    std::set<std::uint32_t> functions_, semantics_;
};

std::uint32_t bytes_of_element(const ir::Module& module, Type type) {
    return (extent(module, type).size + 15) / 16 * 16;
}

// The number of elements for which every block of these globals has room.
std::uint32_t count_of(const std::vector<InstanceSize>& sizes) {
    std::uint32_t count = std::numeric_limits<std::uint32_t>::max();
    for (const InstanceSize& size : sizes) {
        if (size.bytes > 0) count = std::min(count, size.room / size.bytes);
    }
    return count;
}

// By block.
std::vector<InstanceSize> sizes_of(const ir::Module& module, const std::set<std::uint32_t>& globals,
                                   const OptionalValues& optional, std::uint32_t most_bytes) {
    std::uint32_t absent = 0;
    for (const Type type : optional.absent) absent += bytes_of_element(module, type);
    std::vector<InstanceSize> sizes;
    for (std::uint32_t block = 0; block < module.blocks.size(); ++block) {
        std::uint32_t alike = 0, each = 0;
        for (std::uint32_t i = 0; i < module.globals.size(); ++i) {
            const ir::Global& global = module.globals[i];
            if (global.block != block) continue;
            (globals.contains(i) ? each : alike) += bytes_of_element(module, global.type);
        }
        if (each > 0) each += absent;
        sizes.push_back({.bytes = each, .room = most_bytes - std::min(alike, most_bytes)});
    }
    return sizes;
}

// Members of optional values last.
void lay_out(ir::Module& module, std::uint32_t block, const std::set<std::uint32_t>& optional) {
    const std::vector<ir::BlockMember> members = std::exchange(module.blocks[block].members, {});
    module.blocks[block].size = 0;
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < module.globals.size(); ++i)
        if (module.globals[i].block == block) order.push_back(i);
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t i) { return !optional.contains(i); });
    for (const std::uint32_t i : order) {
        const ir::BlockMember& member = members[module.globals[i].member];
        add_member(module.blocks[block], module, member.name, member.type);
        module.globals[i].member = static_cast<std::uint32_t>(module.blocks[block].members.size() - 1);
    }
}

// Each read becomes `array[instance]`; the arrays and the instance are read once, at the head of the function. Edited
// in place, so that probes still find their values (ir.h).
void index_reads(ir::Module& module, ir::Function& function, const std::set<std::uint32_t>& globals,
                 const std::vector<Type>& elements, std::uint32_t semantic) {
    std::map<std::uint32_t, Value> arrays;
    std::vector<Value> first;
    const auto add = [&](Op op, Type type, std::uint32_t data) {
        ir::Inst inst{};
        inst.op = op;
        inst.type = type;
        inst.data = data;
        function.insts.push_back(inst);
        first.push_back({static_cast<std::uint32_t>(function.insts.size() - 1)});
        return first.back();
    };
    Value instance{};
    const std::size_t count = function.insts.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t global = function.insts[i].data;
        if (function.insts[i].op != Op::Global || !globals.contains(global)) continue;
        if (first.empty()) instance = add(Op::Semantic, module.semantics[semantic].type, semantic);
        const auto [array, is_new] = arrays.try_emplace(global);
        if (is_new) array->second = add(Op::Global, module.globals[global].type, global);
        ir::Inst& read = function.insts[i];
        const std::string& name = module.globals[global].name;
        if (!read.name) read.name = module.intern(joined("own", name));
        read.op = Op::Index;
        read.type = elements[global];
        read.data = 0;
        read.first_operand = static_cast<std::uint32_t>(function.operands.size());
        read.operand_count = 2;
        function.operands.push_back(array->second);
        function.operands.push_back(instance);
    }
    if (first.empty()) return;
    std::vector<Value>& body = function.blocks[0].insts;
    body.insert(body.begin(), first.begin(), first.end());
}

}  // namespace

bool is_instanced(const resolve::Material& material) {
    return std::any_of(
        material.properties.begin(), material.properties.end(),
        [](const resolve::MaterialProperty& each) { return each.property->binding == Binding::Instance; });
}

bool reads_instance(const Lowered& lowered) {
    return Readers(lowered).reads(instance_semantic(lowered));
}

InstanceSize size_of_instance(const Lowered& lowered, const std::set<std::uint32_t>& globals,
                              const OptionalValues& optional, std::uint32_t most_bytes) {
    const std::vector<InstanceSize> sizes = sizes_of(lowered.module, globals, optional, most_bytes);
    return *std::max_element(sizes.begin(), sizes.end(),
                             [](const auto& a, const auto& b) { return a.bytes < b.bytes; });
}

std::uint32_t make_instanced(Lowered& lowered, const std::set<std::uint32_t>& globals, const OptionalValues& optional,
                             std::uint32_t most_bytes) {
    ir::Module& module = lowered.module;
    const std::uint32_t count = count_of(sizes_of(module, globals, optional, most_bytes));
    if (count == 0) return 0;
    std::vector<Type> elements;
    for (const ir::Global& global : module.globals) elements.push_back(global.type);
    for (const std::uint32_t each : globals) {
        ir::Global& global = module.globals[each];
        global.type = module.blocks[global.block].members[global.member].type = module.array_of(global.type, count);
    }
    for (std::uint32_t block = 0; block < module.blocks.size(); ++block) lay_out(module, block, optional.declared);
    const std::uint32_t semantic = instance_semantic(lowered);
    for (ir::Function& function : module.functions) index_reads(module, function, globals, elements, semantic);
    return count;
}

}  // namespace patina::lower
