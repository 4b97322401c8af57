// What a value's name hint says. A hint of the author's is a plain word. A value from an inlined call also knows the
// function. If nobody named the result of the call, the printer names it after the function. It also uses the
// function's name, instead of a number, to distinguish two locals of one name.
//
//   NameId m = inlined_local(module, "SchlickWeight", module.intern("m"));
//   hint_of(module, m)       // name "m", callee "schlickWeight": on a clash it is schlickWeightM
//   NameId w = inlined_result(module, "SchlickWeight", {});
//   hint_of(module, w)       // name "", callee "schlickWeight": a name if nothing better is found
#pragma once

#include "compiler/ir/ir.h"

namespace patina::ir {

struct Hint {
    std::string_view name{};    // empty: the value has no name, and gets a statement only where it needs one
    std::string_view callee{};  // the function that brought it in, in camelCase; empty: none
    std::string_view local{};   // what the function itself calls it; otherwise the name
};
Hint hint_of(const Module& module, NameId id);

// A named value in the body of a function that is inlined. If a name has its function already, it does not change.
NameId inlined_local(Module& module, std::string_view callee, NameId name);
// The result of a call that nobody named; `name` is what the function calls it.
NameId inlined_result(Module& module, std::string_view callee, NameId name);

}  // namespace patina::ir
