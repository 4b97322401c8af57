#include "compiler/ir/dump.h"

#include <fmt/format.h>

#include "compiler/base/text.h"
#include "compiler/ir/passes/passes.h"

namespace patina::ir {
namespace {

std::string_view opaque_name(Kind kind) {
    if (kind == Kind::Texture2D) return "texture2d";
    if (kind == Kind::TextureCube) return "texturecube";
    if (kind == Kind::Texture2DArray) return "texture2darray";
    if (kind == Kind::Texture3D) return "texture3d";
    return "sampler";
}

// Prints functions that are not sound, too, because verify() shows them to the reader: so every index is checked.
class Dumper {
public:
    Dumper(const Module& module, const Function& function, const Mark& mark, bool with_rates)
        : module_(module), function_(function), mark_(mark) {
        if (with_rates) rates_ = rates(module, function);
    }

    std::string text() {
        out_ = fmt::format("func {}(", function_.name);
        for (const Param& param : function_.params) {
            if (&param != function_.params.data()) out_ += ", ";
            out_ += fmt::format("{}: {} {}", param.name, type(param.type), to_string(param.rate));
        }
        out_ += fmt::format(") -> {} {{\n", type(function_.result));
        if (function_.linkage == Linkage::Verbatim)
            out_ += "  verbatim\n";
        else
            block(0, 1);
        if (!mark_.reason.empty() && !mark_.value) out_ += fmt::format("^ {}\n", mark_.reason);
        return out_ + "}\n";
    }

private:
    std::string type(Type type) const {
        return type.is_opaque() ? std::string(opaque_name(type.kind)) : module_.type_name(type);
    }

    void block(std::uint32_t index, int indent) {
        if (index >= function_.blocks.size()) {
            out_ += fmt::format("{:{}}<no block {}>\n", "", 2 * indent, index);
            return;
        }
        // A block that two structures share, or that holds itself, would never end.
        if (printed_.size() < function_.blocks.size()) printed_.resize(function_.blocks.size());
        if (printed_[index]) {
            out_ += fmt::format("{:{}}<block {} again>\n", "", 2 * indent, index);
            return;
        }
        printed_[index] = true;
        for (const Value value : function_.blocks[index].insts) line(value, indent);
    }

    void line(Value value, int indent) {
        const bool marked = mark_.value && value == mark_.value;
        out_ += fmt::format("{:<{}}", marked ? ">" : "", 2 * indent);
        if (value.index >= function_.insts.size()) {
            out_ += fmt::format("<no instruction {}>\n", value.index);
        } else {
            instruction(value, indent, marked);
        }
    }

    void instruction(Value value, int indent, bool marked) {
        const Inst& inst = function_[value];
        if (inst.type.kind != Kind::Void || has(inst.op, Structure)) out_ += fmt::format("%{} = ", value.index);
        out_ += info(inst.op).text;
        if (inst.op == Op::For && inst.is_light_loop) out_ += " light";
        if (inst.is_while) out_ += " while";
        if (inst.type.kind != Kind::Void) out_ += " " + type(inst.type);
        if (inst.op == Op::Call) out_ += " " + callee(inst);
        operands(inst);
        data(inst);
        const bool has_blocks = inst.op == Op::If || inst.op == Op::For;
        if (has_blocks) out_ += " {";
        if (inst.name.index < module_.names.size()) out_ += fmt::format("  ; {}", module_.names[inst.name.index]);
        if (value.index < rates_.size()) out_ += fmt::format("  @{}", to_string(rates_[value.index]));
        out_ += '\n';
        if (marked) out_ += fmt::format("{:{}}^ {}\n", "", 2 * indent, mark_.reason);
        if (!has_blocks) return;
        block(inst.data, indent + 1);
        if (inst.op == Op::If) {
            out_ += fmt::format("{:{}}}} else {{\n", "", 2 * indent);
            block(inst.data + 1, indent + 1);
        }
        out_ += fmt::format("{:{}}}}\n", "", 2 * indent);
    }

    void operands(const Inst& inst) {
        if (inst.operand_count == 0 && inst.op != Op::Call) return;
        out_ += " (";
        for (std::uint32_t i = 0; i < inst.operand_count; i++) {
            const std::size_t at = std::size_t{inst.first_operand} + i;
            out_ += i == 0 ? "" : ", ";
            out_ += at < function_.operands.size() ? fmt::format("%{}", function_.operands[at].index) : "<no operand>";
        }
        out_ += ")";
    }

    // What `data` says beyond the operands.
    void data(const Inst& inst) {
        if (inst.op == Op::Constant) out_ += " " + constant(inst.data);
        if (inst.op == Op::Param) out_ += " " + name_in(function_.params, inst.data);
        if (inst.op == Op::Global) out_ += " " + name_in(module_.globals, inst.data);
        if (inst.op == Op::Semantic) out_ += " " + name_in(module_.semantics, inst.data);
        if (inst.op == Op::Extract || inst.op == Op::Insert) out_ += " ." + part(inst);
        if (inst.op == Op::Swizzle) {
            out_ += " .";
            for (unsigned i = 0; i < inst.type.width() && i < 4; i++) out_ += "xyzw"[inst.data >> (2 * i) & 3u];
        }
        if (inst.op == Op::Result || inst.op == Op::LoopCarried) out_ += fmt::format(" {}", inst.data);
    }

    template <class Named>
    static std::string name_in(const std::vector<Named>& table, std::uint32_t index) {
        return index < table.size() ? table[index].name : fmt::format("<no {}>", index);
    }

    std::string callee(const Inst& inst) const { return name_in(module_.functions, inst.data); }

    std::string part(const Inst& inst) const {
        if (inst.operand_count > 0 && inst.first_operand < function_.operands.size()) {
            const std::uint32_t operand = function_.operands[inst.first_operand].index;
            const Type composite = operand < function_.insts.size() ? function_.insts[operand].type : Type::error();
            if (composite.kind == Kind::Struct && composite.ref < module_.structs.size()) {
                return name_in(module_.structs[composite.ref].members, inst.data);
            }
        }
        return std::to_string(inst.data);
    }

    std::string constant(std::uint32_t index) const {
        if (index >= module_.constants.size()) return fmt::format("<no constant {}>", index);
        const Constant& constant = module_.constants[index];
        const unsigned count = constant.type.components();
        if (std::size_t{constant.first} + count > module_.numbers.size()) return "<no numbers>";
        std::string text;
        for (unsigned i = 0; i < count; i++) {
            const double number = module_.numbers[constant.first + i];
            text += i == 0 ? "" : ", ";
            if (constant.type.is_bool()) {
                text += number == 0 ? "false" : "true";
            } else {
                const bool is_float = static_cast<double>(static_cast<float>(number)) == number;
                text += is_float ? shortest(static_cast<float>(number)) : shortest(number);
            }
        }
        return count == 1 ? text : "(" + text + ")";
    }

    const Module& module_;
    const Function& function_;
    const Mark& mark_;
    std::vector<Rate> rates_;
    std::vector<bool> printed_;
    std::string out_;
};

std::string dump_members(const Module& module, std::string_view head, const auto& members) {
    std::string text = fmt::format("{} {{", head);
    for (const auto& member : members) {
        text +=
            fmt::format("{} {} {}", &member == members.data() ? "" : ",", module.type_name(member.type), member.name);
    }
    return text + " }\n";
}

std::string dump_stage(const Module& module) {
    const StageInterface& stage = module.stage;
    if (!stage.entry) return {};
    std::string text = fmt::format("stage {} {}\n", stage.kind == StageKind::Vertex ? "vertex" : "fragment",
                                   stage.entry.index < module.functions.size() ? module[stage.entry].name : "<none>");
    const auto list = [&](std::string_view direction, const std::vector<StageVariable>& variables) {
        for (const StageVariable& v : variables) {
            text +=
                fmt::format("  {} {} {}: {} {}\n", direction, module.type_name(v.type), v.name, v.semantic, v.location);
        }
    };
    list("in", stage.inputs);
    list("out", stage.outputs);
    return text;
}

}  // namespace

std::string dump(const Module& module, const Function& function, const Mark& mark) {
    return Dumper(module, function, mark, false).text();
}

std::string dump(const Module& module, const Function& function, bool with_rates) {
    return Dumper(module, function, {}, with_rates).text();
}

std::string dump(const Module& module) {
    std::string text = dump_stage(module);
    for (const Struct& s : module.structs) text += dump_members(module, "struct " + s.name, s.members);
    for (const UniformBlock& b : module.blocks) text += dump_members(module, "block " + b.name, b.members);
    for (const Function& function : module.functions) text += "\n" + dump(module, function);
    return text;
}

}  // namespace patina::ir
