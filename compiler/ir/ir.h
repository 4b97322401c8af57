// The intermediate representation: what a graph means, apart from any language.
//
// A Module holds functions. A Function is one structured block of instructions in SSA form: an instruction is a value,
// computed once, used by those after it in its own block or in blocks nested in it. There are no jumps: `If` and `For`
// own blocks, and their blocks end in a Yield whose operands become the Results of the If or For. Everything is pure
// but Yield, Return and DiscardIf; derivatives and samples that need them are pure but may not be moved into control
// flow. Types are values (types.h); what each op means and takes is ops.def. The textual dump (dump.h) reads like this:
//
//   func tint(uv0: float2 pixel) -> float4 {
//     %0 = param float2 uv0
//     %1 = global texture2d _MainTex
//     %2 = global sampler sampler_MainTex
//     %3 = sample float4 (%1, %2, %0)  ; albedo
//     return (%3)
//   }
//
// Lifetime is the Module's: everything is an index into one of its vectors. Passes do not edit a function in place,
// they rebuild it through a Builder (builder.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/base/ids.h"
#include "compiler/base/source.h"
#include "compiler/ir/ops.h"
#include "compiler/ir/types.h"

namespace patina::ir {

using Value = Id<struct ValueTag>;    // into Function::insts
using BlockId = Id<struct BlockTag>;  // into Function::blocks
using FunctionId = Id<struct FunctionTag>;
using GlobalId = Id<struct GlobalTag>;
using SemanticId = Id<struct SemanticTag>;
using OriginId = Id<struct OriginTag>;
using NameId = Id<struct NameTag>;  // into Module::names

// How often a value changes; decides where it is computed. Ordered: an instruction's rate is the highest of its
// operands'.
enum class Rate : std::uint8_t { Constant, Uniform, Vertex, Pixel, Light };
std::string_view to_string(Rate rate);

struct Inst {
    Op op = Op::Constant;
    bool is_light_loop = false;  // on For: each iteration is one light, so LoopIndex has rate Light
    Type type{};
    std::uint32_t first_operand = 0;  // into Function::operands
    std::uint32_t operand_count = 0;
    std::uint32_t data = 0;  // meaning is the op's; see ops.def
    OriginId origin{};       // the graph node that it comes from
    NameId name{};           // hint (ir/hints.h); a value with a name is printed as a statement of its own
};

struct Block {
    std::vector<Value> insts{};
};

struct Param {
    std::string name{};
    Type type{};
    Rate rate = Rate::Pixel;
    bool is_semantic = false;  // handed down by link(): of no concern where the function does not read it
};

// Who knows a function beside the module that it is in.
enum class Linkage : std::uint8_t {
    Internal,  // nobody: its signature may change
    Exported,  // whoever calls the text that is printed: it loses semantics that it does not read, and nothing else
    External,  // it is defined elsewhere: its body stands for nothing, and it is called as it is
    Foreign,   // the same, and what defines it is included: the text declares it nowhere
};

// A value that has a name in a graph, for whoever watches the function run (interpret/). Rebuilding a function drops
// them: only the unoptimised stages have any.
struct Probe {
    enum class Kind : std::uint8_t {
        Node,    // of the graph, by its id path
        Output,  // of the graph itself: "surface", "direct"
        Given,   // to the graph: "@light"
    };
    Kind kind = Kind::Node;
    std::string_view graph{};          // "material", "workflow", "lighting"
    std::string id{};                  // "rust/height"
    std::vector<std::string> ports{};  // "out", or one for each member of a struct
    Value value{};
    Span span{};
};

// Lines that a pass wants at a place of the stage's text, for a language that writes whole files of another tool:
// "interpolators", "vertex begin".
struct StageText {
    std::string place{}, line{};
};
struct Function {
    std::string name{};
    std::vector<Param> params{};
    Type result{};
    std::vector<Inst> insts{};
    std::vector<Value> operands{};
    std::vector<Block> blocks{};  // blocks[0] is the body
    OriginId origin{};
    std::string comment{};       // lines, printed above the function
    bool always_inline = false;  // recipes and pass bodies: they are spelled out where they are called
    Linkage linkage = Linkage::Internal;
    // Foreign: how a call is written, "MACRO({0}, {1})". With {result} in it, it is a statement, or several, that
    // declares its result. Empty: the name and the arguments.
    std::string spelling{};
    std::vector<StageText> texts{};  // Foreign: lines that a stage needs that calls it
    bool is_of_object = false;       // Foreign: it depends on the object that is drawn
    std::vector<Probe> probes{};

    const Inst& operator[](Value v) const { return insts[v.index]; }
    std::span<const Value> args(const Inst& inst) const {
        return {operands.data() + inst.first_operand, inst.operand_count};
    }
    std::span<const Value> args(Value v) const { return args(insts[v.index]); }
};

// Defined in another text than the module's.
inline bool is_elsewhere(const Function& function) {
    return function.linkage == Linkage::External || function.linkage == Linkage::Foreign;
}

struct Member {
    std::string name{};
    Type type{};
};
struct Struct {
    std::string name{};
    std::vector<Member> members{};
};
struct Array {
    Type element{};
    std::uint32_t count = 0;
    friend bool operator==(const Array&, const Array&) = default;
};

// A constant's components in order (columns of a matrix are not reordered: row by row), each exact in a double.
// Structs and arrays of constants are Constructs, so a constant is always numeric.
struct Constant {
    Type type{};
    std::uint32_t first = 0;  // into Module::numbers; type.components() of them
};

// A bool, or an enum as an int, that is known before a shader runs: a specialization constant, or a keyword, for an
// engine that compiles the text once for each of its values.
struct Keyword {
    std::string property{};
    std::optional<std::uint32_t> constant_id{};  // of a specialization constant
    double value = 0;                            // until somebody sets another
    std::vector<std::string> values{};           // of an enum: its words
};

// Where a global lives. The printers place it, the runtime and the interpreter fill it.
struct Global {
    std::string name{};
    Type type{};
    // For a member of a uniform block: the block and the member in it. For a texture, sampler or keyword, and for what
    // another tool fills under its name: neither.
    std::uint32_t block = 0xffffffffu;
    std::uint32_t member = 0;
    std::uint32_t keyword = 0xffffffffu;  // of Module::keywords
    std::uint32_t slot = 0;               // texture or sampler: number of its binding (t0.., s0..) within the set
    std::uint32_t set = 0;                // texture or sampler: descriptor set
    Span span{};
    std::string spelling{};  // not empty: an included file declares it, and it is written so
    std::string decoder{};   // a foreign function that whatever is read goes through; may be empty
    std::string follower{};  // a function of what is decoded, which the foreign function `at_once` computes with it
    std::string at_once{};
    bool is_of_object = false;  // included: it depends on the object that is drawn
    bool in_block() const { return block != 0xffffffffu; }
    bool is_keyword() const { return keyword != 0xffffffffu; }
    bool is_foreign() const { return !spelling.empty(); }
};

struct BlockMember {
    std::string name{};
    Type type{};
    std::uint32_t offset =
        0;  // bytes; equal in std140 and in an HLSL cbuffer, with `padding` members printed before it
    std::uint32_t padding = 0;    // number of floats of padding before it
    std::string stored_as{};      // the word for its type, where a language declares it as another; may be empty
    bool is_of_instance = false;  // each instance has its own, where a language has words for that
    std::string declared_in{};    // the other tool's file that declares it; empty: the text does
};
struct UniformBlock {
    std::string name{};
    std::uint32_t set = 0;
    std::uint32_t slot = 0;  // b0.. within the set
    std::uint32_t size = 0;  // bytes, a multiple of 16
    std::vector<BlockMember> members{};
};

// A value of the mesh, camera or engine that a graph reads by name, before link() gives it a recipe.
struct Semantic {
    std::string name{};
    Type type{};
    Rate rate = Rate::Pixel;
};

// The graph node (or library function) that an instruction comes from.
struct Origin {
    std::string label{};   // "SampleTexture2D"; empty: no comment is printed
    bool is_note = false;  // the label is what somebody wrote about it
    std::string id{};      // "albedo"
    Span span{};           // where it stands in the graph's JSON
};

// Stage inputs are the entry function's params; stage outputs are the members of the struct that it returns.
enum class Builtin : std::uint8_t { None, Position, FragCoord, FrontFacing, VertexIndex, InstanceIndex };
struct StageVariable {
    std::string name{};
    Type type{};
    std::uint32_t location = 0;
    Builtin builtin = Builtin::None;
    std::string semantic{};  // HLSL semantic: "POSITION", "TEXCOORD0", "SV_Target0", "SV_Position"
    bool flat = false;
    std::string spelling{};  // of an output: not empty: no member, but written to this
    std::string guard{};     // of an output: a condition of the preprocessor under which it exists; may be empty
};
enum class StageKind : std::uint8_t { Vertex, Fragment };
struct StageInterface {
    StageKind kind = StageKind::Fragment;
    FunctionId entry{};
    std::vector<StageVariable> inputs{};   // one per param of entry
    std::vector<StageVariable> outputs{};  // one per member of entry's result struct
    std::vector<StageText> texts{};
};

struct Module {
    std::vector<Function> functions;  // a callee stands before its callers
    std::vector<Struct> structs;
    std::vector<Array> arrays;
    std::vector<Constant> constants;
    std::vector<double> numbers;
    std::vector<UniformBlock> blocks;
    std::vector<Global> globals;
    std::vector<Keyword> keywords;
    bool tests_keywords = false;  // what keywords alone decide is decided by the text's preprocessor
    std::vector<Semantic> semantics;
    std::vector<Origin> origins;
    std::vector<std::string> names;
    StageInterface stage;  // only in a linked stage

    Function& operator[](FunctionId id) { return functions[id.index]; }
    const Function& operator[](FunctionId id) const { return functions[id.index]; }
    std::span<const double> numbers_of(const Constant& c) const {
        return {numbers.data() + c.first, c.type.components()};
    }

    NameId intern(std::string_view name);
    Type array_of(Type element, std::uint32_t count);
    std::string type_name(Type type) const;     // HLSL spelling: "float3", "Surface", "float[4]"
    std::string_view name_of(NameId id) const;  // empty: it has none; hint_of (ir/hints.h) says more

private:
    void index_name(std::uint32_t index);
    // Hash table of indices into `names`, a power of two of slots and at most half full: it copies as a block.
    std::vector<std::uint32_t> name_slots_;
};

// Members of composite types, seen alike: type of part `index` of a vector (scalar), matrix (row), array or struct.
Type part_type(const Module& module, Type composite, std::uint32_t index);
std::uint32_t part_count(const Module& module, Type composite);

// By struct: true if it is part of the signature of a function that is defined elsewhere.
std::vector<bool> shared_structs(const Module& module);

// Result type that the op's rule gives for these operand types, or Error where they do not fit.
// For TypeRule::Declared ops it returns Error: their verifier rules are in verify.cpp.
Type result_type(Op op, std::span<const Type> operands);

}  // namespace patina::ir
