#include <algorithm>

#include "compiler/ir/builder.h"
#include "compiler/writers/shaderlab/dialect.h"

namespace patina::writers::shaderlab {

using namespace ir;
using namespace languages;

namespace {

bool is_global(const Function& function, Value v, std::uint32_t global) {
    return function[v].op == Op::Global && function[v].data == global;
}

bool reads_texel(Op op) {
    return op == Op::Sample || op == Op::SampleBias || op == Op::SampleLevel || op == Op::SampleGrad ||
           op == Op::TexelLoad;
}

// The calls of the follower on texels of one texture. It is not `all` if a texel has another reader.
struct Calls {
    std::vector<std::uint32_t> insts;
    bool is_all = true;
};

Calls calls_of(const Module& module, const Function& function, std::uint32_t texture) {
    Calls made;
    std::vector<bool> is_texel(function.insts.size());
    for (std::uint32_t i = 0; i < function.insts.size(); ++i) {
        const Inst& inst = function.insts[i];
        const auto args = function.args(inst);
        is_texel[i] = reads_texel(inst.op) && is_global(function, args[0], texture);
        for (std::size_t k = 0; k < args.size(); ++k) {
            if (!is_texel[args[k].index]) continue;
            const bool follows =
                inst.op == Op::Call && k == 0 && module.functions[inst.data].name == module.globals[texture].follower;
            if (follows) made.insts.push_back(i);
            made.is_all = made.is_all && follows;
        }
    }
    return made;
}

std::uint32_t foreign_function(Module& module, const Function& like, const std::string& name) {
    const auto found = std::find_if(module.functions.begin(), module.functions.end(),
                                    [&](const Function& each) { return each.name == name; });
    if (found != module.functions.end()) return static_cast<std::uint32_t>(found - module.functions.begin());
    Function made{.name = name, .params = like.params, .result = like.result, .linkage = Linkage::Foreign};
    {
        Builder builder(module, made);
        builder.ret(builder.zero(made.result));  // never printed
    }
    // A callee comes before its callers, so it goes to the front and all others move up.
    for (Function& function : module.functions) {
        for (Inst& inst : function.insts) {
            if (inst.op == Op::Call) ++inst.data;
        }
    }
    ++module.stage.entry.index;
    module.functions.insert(module.functions.begin(), std::move(made));
    return 0;
}

}  // namespace

Module decode_at_once(Module module) {
    for (std::uint32_t texture = 0; texture < module.globals.size(); ++texture) {
        if (module.globals[texture].at_once.empty()) continue;
        std::vector<Calls> calls;
        std::size_t moved = 0;  // number of functions added at the front
        for (const Function& function : module.functions) calls.push_back(calls_of(module, function, texture));
        if (!std::all_of(calls.begin(), calls.end(), [](const Calls& each) { return each.is_all; })) continue;
        for (std::size_t f = 0; f < calls.size(); ++f) {
            for (const std::uint32_t call : calls[f].insts) {
                const Function follower = module.functions[module.functions[f + moved].insts[call].data];
                const std::size_t before = module.functions.size();
                const std::uint32_t both = foreign_function(module, follower, module.globals[texture].at_once);
                moved += module.functions.size() - before;
                module.functions[f + moved].insts[call].data = both;
            }
        }
        module.globals[texture].decoder.clear();
    }
    return module;
}

}  // namespace patina::writers::shaderlab
