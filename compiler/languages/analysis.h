// Facts about a function that plan.cpp needs before it makes variables: the order of the values, their readers, the
// last read of each, and which values cannot fold into an expression. Private to the plan's own files.
#pragma once

#include "compiler/languages/plan.h"

namespace patina::languages {

struct Analysis {
    const ir::Module& module;
    const ir::Function& function;
    bool is_entry;

    std::vector<ir::Value> order = {};         // print order: an If or For, then its content, then what follows
    std::vector<std::uint32_t> position = {};  // by Value: place in that order
    std::vector<std::uint32_t> end = {};       // by Value: for an If or For, the position of the last value inside
    std::vector<ir::BlockId> block = {};       // by Value
    std::vector<ir::Value> owner = {};         // by block: its If or For

    std::vector<ir::Value> same_as = {};  // see Plan
    std::vector<unsigned> reads = {};
    std::vector<ir::BlockId> read_block = {};  // one block that reads the value
    std::vector<bool> read_elsewhere = {};     // a block other than the value's own reads it
    std::vector<ir::Value> only_reader = {};   // null if there are several
    ir::Value outputs = {};

    std::vector<std::uint8_t> tests = {};       // 1: a condition of keywords for the preprocessor; empty: none
    std::vector<bool> stands = {};              // has a variable
    std::vector<std::uint32_t> last_read = {};  // position of the statement with the last read

    const ir::Inst& operator[](ir::Value v) const { return function.insts[v.index]; }
    ir::Value arg(ir::Value v, std::uint32_t i) const { return same_as[function.args(v)[i].index]; }
    std::uint32_t args(ir::Value v) const { return function[v].operand_count; }
    bool has_name(ir::Value v) const { return !module.name_of(function[v].name).empty(); }
    bool is_read(ir::Value v) const { return reads[v.index] > 0; }
    bool is_live(ir::Value v) const;
    bool is_test(ir::Value v) const { return !tests.empty() && tests[v.index] != 0; }
    // The position of the statement that computes the value. If it has no variable, this is the statement that reads
    // it.
    std::uint32_t computed_at(ir::Value v) const;
    // True if something reads the value at this position of a Yield.
    bool is_slot_read(ir::Value structure, std::uint32_t slot) const;
    // True for a value that never gets a variable: reading it costs nothing, so all its readers repeat it.
    bool is_free(ir::Value v) const;

    std::vector<std::vector<ir::Value>> results =
        {};  // by Value: of an If or For, the Result of each slot; none: not read
};

Analysis analyse(const ir::Module& module, const ir::Function& function, bool is_entry);

// sharing.cpp: makes the variables.
void share_variables(const Analysis& analysis, Plan& plan);

}  // namespace patina::languages
