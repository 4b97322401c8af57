#include "compiler/link/canonical_hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/bits.h"

namespace patina::link {
namespace {

using ir::Builtin;
using ir::Op;
using ir::Value;

// The finaliser of SplitMix64 (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// A hash in progress. The two halves start differently, so that only equal 128 bits are a match.
class Hash {
public:
    explicit Hash(std::string_view kind) { add(kind); }
    Hash& add(std::uint64_t number) {
        value_.high = mixed(value_.high * 3 + number + 0x9e3779b97f4a7c15u);
        value_.low = mixed(value_.low * 5 + number + 0xc2b2ae3d27d4eb4fu);
        return *this;
    }
    Hash& add(std::string_view text) {
        add(text.size());
        for (const char c : text) add(static_cast<unsigned char>(c));
        return *this;
    }
    Hash& add(const CanonicalHash& part) { return add(part.high).add(part.low); }
    // Adds the parts in an order-independent way.
    Hash& add_all(std::vector<CanonicalHash> parts) {
        std::sort(parts.begin(), parts.end());
        add(parts.size());
        for (const CanonicalHash& part : parts) add(part);
        return *this;
    }
    operator CanonicalHash() const { return value_; }

private:
    CanonicalHash value_{.high = 0x243f6a8885a308d3u, .low = 0x13198a2e03707344u};  // digits of pi
};

// The hashes of the stage's inputs, by name. A function's parameter that passes on an input has the input's name.
using Inputs = std::map<std::string_view, CanonicalHash>;

class Stage {
public:
    Stage(const ir::Module& module, Inputs inputs) : module_(module), inputs_(std::move(inputs)) {
        for (const ir::Function& function : module.functions) functions_.push_back(hash_function(function));
    }

    // The values that the stage outputs, by output, and its side effects.
    struct Result {
        std::vector<CanonicalHash> outputs;
        CanonicalHash effects;
    };
    Result result() {
        const ir::Function& entry = module_[module_.stage.entry];
        const std::vector<CanonicalHash> values = hash_values(entry);
        Result made;
        Hash effects("stage");
        for (const Value value : entry.blocks[0].insts) {
            const ir::Inst& inst = entry[value];
            if (!ir::has(inst.op, ir::Effect)) continue;
            if (inst.op != Op::Return) {
                effects.add(values[value.index]);
                continue;
            }
            const Value outputs = entry.args(inst)[0];
            const bool is_construct = entry[outputs].op == Op::Construct;
            for (std::size_t i = 0; i < module_.stage.outputs.size(); ++i) {
                made.outputs.push_back(is_construct ? values[entry.args(outputs)[i].index]
                                                    : CanonicalHash(Hash("part").add(values[outputs.index]).add(i)));
            }
        }
        made.effects = effects;
        return made;
    }

private:
    CanonicalHash type(ir::Type t) const {
        Hash hash("type");
        hash.add(static_cast<std::uint64_t>(t.kind)).add(static_cast<std::uint64_t>(t.scalar)).add(t.rows).add(t.cols);
        if (t.kind == ir::Kind::Array) hash.add(type(module_.arrays[t.ref].element)).add(module_.arrays[t.ref].count);
        if (t.kind == ir::Kind::Struct) {
            for (const ir::Member& member : module_.structs[t.ref].members) hash.add(type(member.type));
        }
        return hash;
    }

    CanonicalHash global(const ir::Global& global) const {
        Hash hash("global");
        hash.add(global.name)
            .add(type(global.type))
            .add(static_cast<std::uint32_t>(global.group))
            .add(global.place.set)
            .add(global.place.slot);
        if (global.in_block()) {
            const ir::UniformBlock& block = module_.blocks[global.block];
            hash.add(block.name).add(block.members[global.member].offset);
        } else if (global.is_keyword()) {
            const ir::Keyword& keyword = module_.keywords[global.keyword];
            hash.add(keyword.constant_id.value_or(~0u)).add(bits_as<std::uint64_t>(keyword.value));
        }
        return hash;
    }

    // Hashes a parameter. The parameters that pass on the stage's inputs are in the order of the graph's nodes, so
    // their hash is that of their input. Other parameters are hashed by position.
    CanonicalHash param(const ir::Function& function, std::uint32_t index) const {
        const ir::Param& param = function.params[index];
        const bool is_entry = module_.stage.entry && &function == &module_[module_.stage.entry];
        const auto input = param.is_semantic || is_entry ? inputs_.find(param.name) : inputs_.end();
        if (input != inputs_.end()) return Hash("input").add(input->second);
        if (param.is_semantic) return Hash("semantic").add(param.name);
        const auto is_own = [](const ir::Param& p) { return !p.is_semantic; };
        const auto place = std::count_if(function.params.begin(), function.params.begin() + index, is_own);
        return Hash("param").add(static_cast<std::uint64_t>(place)).add(type(param.type));
    }

    CanonicalHash hash_function(const ir::Function& function) {
        if (function.linkage == ir::Linkage::External) return Hash("external").add(function.name);
        if (function.linkage == ir::Linkage::Verbatim) {
            Hash hash("verbatim");
            for (const ir::ForeignCode::Part& part : function.code.parts) hash.add(part.text).add(part.name);
            return hash;
        }
        const std::vector<CanonicalHash> values = hash_values(function);
        Hash hash("function");
        for (const Value value : function.blocks[0].insts) {
            if (ir::has(function[value].op, ir::Effect)) hash.add(values[value.index]);
        }
        return hash;
    }

    std::vector<CanonicalHash> hash_values(const ir::Function& function) {
        std::vector<CanonicalHash> values(function.insts.size());
        hash_block(function, 0, 0, values);
        return values;
    }

    // `depth`: the number of loops around the block.
    CanonicalHash hash_block(const ir::Function& function, std::uint32_t block, std::uint64_t depth,
                             std::vector<CanonicalHash>& values) {
        Hash effects("block");
        for (const Value value : function.blocks[block].insts) {
            values[value.index] = hash_inst(function, function[value], depth, values);
            if (ir::has(function[value].op, ir::Effect)) effects.add(values[value.index]);
        }
        return effects;
    }

    CanonicalHash hash_inst(const ir::Function& function, const ir::Inst& inst, std::uint64_t depth,
                            std::vector<CanonicalHash>& values) {
        if (inst.op == Op::Param) return param(function, inst.data);
        Hash hash(ir::info(inst.op).text);
        hash.add(type(inst.type));
        std::vector<CanonicalHash> args;
        for (const Value arg : function.args(inst)) args.push_back(values[arg.index]);
        if (inst.op == Op::Call) {
            const ir::Function& callee = module_.functions[inst.data];
            for (std::uint32_t i = 0; i < args.size(); ++i) args[i] = Hash("arg").add(param(callee, i)).add(args[i]);
            return hash.add(functions_[inst.data]).add_all(std::move(args));
        }
        if (ir::has(inst.op, ir::Commutes)) {
            hash.add_all(std::move(args));
        } else {
            for (const CanonicalHash& arg : args) hash.add(arg);
        }
        if (inst.op == Op::Constant) {
            for (const double number : module_.numbers_of(module_.constants[inst.data]))
                hash.add(bits_as<std::uint64_t>(number));
        } else if (inst.op == Op::Global) {
            hash.add(global(module_.globals[inst.data]));
        } else if (inst.op == Op::If) {
            hash.add(hash_block(function, inst.data, depth, values));
            hash.add(hash_block(function, inst.data + 1, depth, values));
        } else if (inst.op == Op::For) {
            hash.add(inst.is_while).add(hash_block(function, inst.data, depth + 1, values));
        } else if (inst.op == Op::LoopIndex || inst.op == Op::LoopCarried) {
            hash.add(depth).add(inst.data);
        } else {
            hash.add(inst.data);
        }
        return hash;
    }

    const ir::Module& module_;
    Inputs inputs_;
    std::vector<CanonicalHash> functions_;
};

std::string_view word_of(Builtin builtin) {
    switch (builtin) {
        case Builtin::None: return "none";
        case Builtin::Position: return "position";
        case Builtin::FragCoord: return "fragCoord";
        case Builtin::FrontFacing: return "frontFacing";
        case Builtin::VertexIndex: return "vertexIndex";
        case Builtin::InstanceIndex: return "instanceIndex";
    }
    return {};
}

// The entry's own parameters are the stage's inputs, under the same names.
CanonicalHash hash_input(const ir::StageVariable& input) {
    if (input.builtin != Builtin::None) return Hash("builtin").add(word_of(input.builtin));
    if (!input.semantic.empty()) return Hash("attribute").add(input.semantic);
    return Hash("location").add(input.location);
}

Inputs inputs_of(const ir::Module& stage) {
    Inputs inputs;
    for (const ir::StageVariable& input : stage.stage.inputs) inputs.emplace(input.name, hash_input(input));
    return inputs;
}

}  // namespace

std::string CanonicalHash::text() const {
    return fmt::format("{:016x}{:016x}", high, low);
}

CanonicalHash hash_text(std::string_view text) {
    return Hash("text").add(text);
}

std::vector<CanonicalHash> hash_outputs(const ir::Module& stage) {
    return Stage(stage, inputs_of(stage)).result().outputs;
}

CanonicalHash hash_stage(const ir::Module& stage) {
    const Stage::Result result = Stage(stage, inputs_of(stage)).result();
    Hash hash("stage");
    hash.add(result.effects);
    std::vector<CanonicalHash> outputs;
    for (std::size_t i = 0; i < result.outputs.size(); ++i) {
        const ir::StageVariable& output = stage.stage.outputs[i];
        outputs.push_back(Hash(word_of(output.builtin)).add(output.location).add(result.outputs[i]));
    }
    return hash.add_all(std::move(outputs));
}

CanonicalHash hash_pass(const ir::Module& vertex, const ir::Module& fragment) {
    const Stage::Result before = Stage(vertex, inputs_of(vertex)).result();
    Hash hash("pass");
    hash.add(before.effects);
    std::map<std::uint32_t, CanonicalHash> handed;  // by location
    for (std::size_t i = 0; i < before.outputs.size(); ++i) {
        const ir::StageVariable& output = vertex.stage.outputs[i];
        if (output.builtin != Builtin::None) {
            hash.add(word_of(output.builtin)).add(before.outputs[i]);
        } else {
            handed[output.location] = Hash("interpolated").add(before.outputs[i]).add(output.flat);
        }
    }
    Inputs inputs;
    for (const ir::StageVariable& input : fragment.stage.inputs) {
        const auto found = handed.find(input.location);
        const bool is_handed = input.builtin == Builtin::None && found != handed.end();
        inputs.emplace(input.name, is_handed ? found->second : hash_input(input));
    }
    const Stage::Result after = Stage(fragment, std::move(inputs)).result();
    hash.add(after.effects);
    for (std::size_t i = 0; i < after.outputs.size(); ++i)
        hash.add(fragment.stage.outputs[i].location).add(after.outputs[i]);
    return hash;
}

}  // namespace patina::link
