// Decides, before a function is printed, which of its values become variables, and which fold into the expressions that
// read them. Some values share a variable because a reader sees them as one: a loop's `sum`, a struct that is filled
// member by member, `x = x * 2.0`.
//
// A value has a variable of its own in these cases: it is read twice, it samples, it is differentiated, or it has a
// name hint; it is read in another block, where a loop would compute it again; or it would make an expression too wide
// or too deep.
//
//   Plans plans(module);
//   const Plan& plan = plans.of(function);
//   plan.variable[v.index]  // index into plan.variables, or kNone
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compiler/languages/print.h"

namespace patina::languages {

struct Variable {
    ir::Type type;
    ir::NameId hint;
    ir::Value like;       // a value of the variable, which names it if there is no hint
    ir::Value result;     // for an If: the Result that it was made for; else none
    ir::BlockId block;    // where it is declared
    unsigned writes = 0;  // number of values that it has, one after the other
};

struct Plan {
    static constexpr std::uint32_t kNone = 0xffffffffu;

    std::vector<std::uint32_t> variable;    // by Value; kNone: a leaf, folded, or never read
    std::vector<ir::Value> same_as;         // by Value: the value whose text replaces it, usually itself
    std::vector<unsigned> reads;            // by Value; 0: not printed
    std::vector<bool> stands;               // by Value: has a variable
    std::vector<std::uint32_t> first_slot;  // by If and For: its first entry in `slots`
    std::vector<std::uint32_t> slots;       // variables of the values that If and For yield; kNone: not read
    std::vector<Variable> variables;
    ir::Value outputs;  // entry function: the struct whose members are the stage's outputs, if it is made in the return

    ir::Value resolve(ir::Value v) const { return same_as[v.index]; }
    bool is_printed(const ir::Function& function, ir::Value v) const;
};

// The plans of a module's functions, each made when it is first asked for. The module must outlive them.
class Plans {
public:
    explicit Plans(const ir::Module& module) : module_(module), plans_(module.functions.size()) {}
    const Plan& of(ir::FunctionId function);

private:
    const ir::Module& module_;
    std::vector<std::optional<Plan>> plans_;
};

// Number of values that an If or For yields.
std::uint32_t slot_count(const ir::Function& function, ir::Value structure);
// True if the else block of an If computes nothing, so that the variables can start with its values.
bool has_plain_else(const Plan& plan, const ir::Function& function, ir::Value structure);
// Calls `visit` with every variable that the value's expression reads, including those of values folded into it.
void for_each_read(const Plan& plan, const ir::Function& function, ir::Value value,
                   const std::function<void(ir::Value)>& visit);

bool is_leaf(ir::Op op);
// True for a vector made of one scalar.
bool is_splat(const ir::Function& function, ir::Value v);
bool is_aggregate(ir::Type type);

}  // namespace patina::languages
