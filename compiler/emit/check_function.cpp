// Checks a function that nothing may call: emits each of its forms, and so reports its errors.
#include <algorithm>

#include "compiler/emit/arguments.h"
#include "compiler/emit/functions.h"

namespace patina::emit {

void check_function(Emitter& emitter, const FunctionDecl& function, const Declarations& home) {
    const bool is_generic = function.result.name == "floatN" ||
                            std::any_of(function.params.begin(), function.params.end(),
                                        [](const ParamDecl& param) { return param.type.name == "floatN"; });
    std::vector<Argument> arguments(function.params.size());
    const std::size_t errors = emitter.diagnostics.error_count();
    const auto emit = [&] {
        for (unsigned width = 1; width <= (is_generic ? 4u : 1u); ++width) {
            // After the first form with an error stop: the others have the same error.
            if (emitter.diagnostics.error_count() != errors) return;
            instantiate(emitter, function, home, arguments, width, false, function.name_span);
        }
    };
    Scope outside{.declarations = &home};
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const ParamDecl& param = function.params[i];
        if (!param.is_const) continue;
        arguments[i] = param.initial ? const_argument(emitter, param, home, *param.initial, outside) : Argument{};
        if (!arguments[i].constant) arguments[i].constant = 0;
    }
    emit();
    // The other values of each drop-down decide other branches. One drop-down is changed at a time.
    for (std::size_t i = 0; i < function.params.size(); ++i) {
        const EnumDecl* enumeration = home.enumeration(function.params[i].type.name);
        if (!function.params[i].is_const || !enumeration) continue;
        const Argument usual = arguments[i];
        for (std::size_t value = 0; value < enumeration->values.size(); ++value) {
            arguments[i].constant = static_cast<double>(value);
            emit();
        }
        arguments[i] = usual;
    }
}

}  // namespace patina::emit
