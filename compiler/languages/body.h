// Prints one function: the names of its variables, its expressions (expressions.cpp) and its statements
// (statements.cpp). The plan (plan.h) has decided which values are variables.
#pragma once

#include <unordered_map>

#include "compiler/languages/plan.h"
#include "compiler/languages/writer.h"

namespace patina::languages {

class Body {
public:
    // `entry` if it is the stage's entry function, else null.
    Body(Writer& writer, ir::FunctionId id, const EntryPoint* entry);

    void print();
    // Prints only the signature.
    void print_declaration();
    // Prints the text of a function that is text, and a function around it if its results are a struct.
    void print_verbatim();

    // --- for a language's own expressions
    const ir::Module& module() const { return writer_.module; }
    const ir::Function& function() const { return function_; }
    const Writer& writer() const { return writer_; }
    const ir::Inst& operator[](ir::Value v) const { return function_.insts[v.index]; }
    ir::Value arg(ir::Value v, std::uint32_t i) const { return plan_.resolve(function_.args(v)[i]); }
    std::uint32_t args(ir::Value v) const { return function_[v].operand_count; }
    bool is_variable(ir::Value v) const { return plan_.variable[v.index] != Plan::kNone; }
    // The value's variable, or the expression that computes it.
    Text expression(ir::Value v) const;
    std::string argument(ir::Value v, std::uint32_t i) const { return expression(arg(v, i)).text; }
    // The operands from the given one on, separated by commas.
    std::string arguments(ir::Value v, std::uint32_t from = 0) const;
    Text ternary(ir::Value v) const;
    // The matrix whose first rows and columns a construct is; null if it is something else.
    ir::Value corner_of(ir::Value v) const;

    // --- for a language's own statements
    void statement(ir::Value v, std::string_view text);
    // Declares a name for a helper variable of this value's statements, free in the current block.
    std::string declare_helper(std::string_view wanted) { return writer_.names.declare(wanted); }
    // "vec3 x" the first time, then "x".
    std::string target(ir::Value v);

private:
    // expressions.cpp
    Text formula(ir::Value v) const;
    Text leaf(ir::Value v) const;
    std::string spelled(ir::Value v, std::string_view spelling, std::string_view result) const;
    Text constant(ir::Value v) const;
    bool repeats_scalar(ir::Value v) const;
    Text scalar_of(ir::Value v) const;
    Text operand(ir::Value v, std::uint32_t i, bool as_scalar) const;
    Text infix(ir::Value v, const Spelling& spelling) const;
    Text prefix(ir::Value v, const Spelling& spelling) const;
    Text call(ir::Value v, const Spelling& spelling) const;
    Text shared(ir::Value v) const;
    Text construct(ir::Value v) const;
    Text vector_of_parts(ir::Value v) const;
    Text matrix_of_rows(ir::Value v) const;
    bool is_start_of_row(ir::Value v, std::uint32_t row) const;
    Text extract(ir::Value v) const;
    Text swizzle(ir::Value v) const;
    bool may_end_in_swizzle(ir::Value v) const;
    Text row(ir::Value matrix, const std::string& index) const;

    // statements.cpp
    const Syntax& syntax() const { return *writer_.language.syntax; }
    std::string signature();
    void print_block(ir::BlockId block);
    void print_statement(ir::Value v);
    void print_assignment(ir::Value v);
    bool print_spelled(ir::Value v);
    void print_struct(ir::Value v);
    void print_array(ir::Value v);
    void print_insert(ir::Value v);
    void print_select(ir::Value v);
    void print_if(ir::Value v);
    void print_if_defined(ir::Value v, const std::string& test);
    std::string keyword_test(ir::Value condition) const;
    ir::Value only_if_in_else(ir::Value v) const;
    bool says_nothing(ir::BlockId block, ir::Value structure) const;
    void print_branch(ir::BlockId block, ir::Value structure);
    void print_for(ir::Value v);
    void print_return(ir::Value v);
    void print_yields(ir::Value yield, ir::Value structure);
    // "x = text;", or "x += y;" if the text is x + y. `value`: the value that the text computes.
    void assign(std::uint32_t variable, ir::Value value, const Text& text, ir::Value from);
    std::string assignment(std::uint32_t variable, ir::Value value, const Text& text);
    void enter(ir::OriginId origin);

    std::string target(std::uint32_t variable);
    bool is_declared(std::uint32_t variable) const { return !names_[variable].empty(); }
    std::uint32_t slot(ir::Value structure, std::uint32_t i) const {
        return plan_.slots[plan_.first_slot[structure.index] + i];
    }
    // ".member", "[2]", ".y"
    std::string part(ir::Type type, std::uint32_t index) const;

    // value_names.cpp
    std::string declare(ir::NameId hint, std::string_view otherwise, ir::OriginId origin);
    std::string_view node_of(ir::OriginId origin) const;
    std::string_view path_of(ir::OriginId origin) const;
    void find_paths();
    std::string instance_of(std::string_view name, bool is_authors, ir::OriginId origin);
    std::string name_without_hint(ir::Value v) const;
    std::string name_of_operands(ir::Value v) const;
    std::string noun(ir::Value v) const;
    void find_member_names();

    Writer& writer_;
    const ir::Function& function_;
    const EntryPoint* entry_;
    const Plan& plan_;
    std::vector<std::string> params_;  // names
    std::vector<std::string> names_;   // of variables; empty: not declared yet
    // The id paths of the nodes with this name in the graph and its sub-graphs: "coarse/edge" and "fine/edge" by
    // "edge".
    std::unordered_map<std::string, std::vector<std::string>> paths_;
    bool has_paths_ = false;
    std::vector<std::string_view> member_of_;  // by Value: the struct member that it is stored in; empty: none
    unsigned indent_ = 1;
    unsigned loops_ = 0;           // number of open loops
    ir::OriginId origin_;          // that of the last statement
    std::vector<bool> commented_;  // by origin
    bool at_block_start_ = true;
};

}  // namespace patina::languages
