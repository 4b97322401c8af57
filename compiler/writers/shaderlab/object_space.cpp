// Finds passes that batching would break. Unity batches objects into one mesh with vertices in world space, so a pass
// that uses an object's own space or position would compute wrong values.
#include <algorithm>

#include "compiler/writers/shaderlab/shader_file.h"

namespace patina::writers::shaderlab {
namespace {

using ir::Function;
using ir::Inst;
using ir::Op;

bool is_of_object(const ir::Module& module, const Inst& inst) {
    if (inst.op == Op::Call) return module.functions[inst.data].is_of_object;
    return inst.op == Op::Global && module.globals[inst.data].is_of_object;
}

// Follows values of the mesh in object space to the place where they are transformed.
class Vertices {
public:
    Vertices(const ir::Module& module, const lower::LoweredPass& pass, const ir::Module& semantics) : module_(module) {
        for (const auto& [semantic, global] : pass.attributes) {
            if (semantics.semantics[semantic.index].name.ends_with("OS")) mesh_.push_back(global.index);
        }
    }

    // True if a value is used without being transformed. The fourth component of a tangent does not count: it is a
    // sign.
    bool keep(ir::FunctionId id, const std::vector<bool>& params) const {
        const Function& function = module_[id];
        std::vector<bool> is_os(function.insts.size(), false);
        const auto any = [&](const Inst& inst) {
            const auto args = function.args(inst);
            return std::any_of(args.begin(), args.end(), [&](ir::Value arg) { return is_os[arg.index]; });
        };
        for (std::size_t i = 0; i < function.insts.size(); ++i) {
            const Inst& inst = function.insts[i];
            if (inst.op == Op::Global) is_os[i] = std::find(mesh_.begin(), mesh_.end(), inst.data) != mesh_.end();
            if (inst.op == Op::Param) is_os[i] = inst.data < params.size() && params[inst.data];
            if (inst.op == Op::MatMul && !any(inst) && reads_object(function, inst)) return true;
            if (inst.operand_count == 0 || !any(inst)) continue;
            if (inst.op == Op::MatMul || is_of_object(module_, inst) || is_sign(function, inst)) continue;
            const bool is_moved = inst.op == Op::Construct || inst.op == Op::Swizzle || inst.op == Op::Extract;
            if (is_moved && inst.type.kind != ir::Kind::Struct) {
                is_os[i] = true;
            } else if (inst.op != Op::Call || passes_on(function, inst, is_os)) {
                return true;
            }
        }
        return false;
    }

private:
    bool reads_object(const Function& function, const Inst& inst) const {
        const auto args = function.args(inst);
        return std::any_of(args.begin(), args.end(),
                           [&](ir::Value arg) { return is_of_object(module_, function[arg]); });
    }
    static bool is_sign(const Function& function, const Inst& inst) {
        if (inst.op != Op::Extract && inst.op != Op::Swizzle) return false;
        const ir::Type whole = function[function.args(inst)[0]].type;
        return inst.type.width() == 1 && whole.is_vector() && whole.width() == 4 && inst.data == 3;
    }
    // True if the call passes the values to a function that keeps them.
    bool passes_on(const Function& function, const Inst& call, const std::vector<bool>& is_os) const {
        if (ir::is_elsewhere(module_.functions[call.data])) return true;
        std::vector<bool> given;
        for (const ir::Value arg : function.args(call)) given.push_back(is_os[arg.index]);
        return keep({call.data}, given);
    }

    const ir::Module& module_;
    std::vector<std::uint32_t> mesh_;
};

}  // namespace

bool knows_object(const LinkedPass& pass) {
    for (const Function& function : pass.fragment.functions) {
        for (const Inst& inst : function.insts) {
            if (is_of_object(pass.fragment, inst)) return true;
        }
    }
    const Vertices vertices(pass.vertex, *pass.pass, pass.lowered->module);
    const ir::Module& vertex = pass.vertex;
    for (std::uint32_t i = 0; i < vertex.functions.size(); ++i) {
        if (!ir::is_elsewhere(vertex.functions[i]) && vertices.keep({i}, {})) return true;
    }
    return false;
}

}  // namespace patina::writers::shaderlab
