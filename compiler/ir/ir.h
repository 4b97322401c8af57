// The room `ir` makes, checks and rewrites the intermediate representation (IR): what a graph means, apart from any
// language. It knows nothing of graphs, of the node language, of GLSL or HLSL, or of engines. It stores text for them
// (names, registers, semantics, spellings) and never reads it.
//
// A Module holds functions. A Function is one structured block of instructions in SSA form. An instruction is a value
// that is computed once. Later instructions of its block, and of blocks nested in that, can use it. There are no jumps:
// `If` and `For` own blocks, and their blocks end in a Yield whose operands become the Results of the If or For.
// Everything is pure except Yield, Return and DiscardIf. Derivatives, and samples that need derivatives, may not be
// moved into control flow. Types are values (types.h); what each op means and takes is ops.def. The textual dump
// (dump.h) reads like this:
//
//   func tint(uv0: float2 pixel) -> float4 {
//     %0 = param float2 uv0
//     %1 = global texture2d _MainTex
//     %2 = global sampler sampler_MainTex
//     %3 = sample float4 (%1, %2, %0)  ; albedo
//     return (%3)
//   }
//
// Lifetime is the Module's: everything is an index into one of its vectors.
//
// An IR pass does not edit the instructions of a function in place. It rebuilds the function through a Builder
// (builder.h), which folds again. There are two exceptions. If functions have moved, renumber_calls() (rebuild.h)
// corrects the indices in calls. link() and make_instanced() replace reads of semantics and globals in place, because a
// rebuilt function would lose its probes.
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

// How often a value changes, which decides where it is computed. The rates are in order: an instruction has the highest
// rate of its operands, but the result of a loop over lights does not change with the light.
enum class Rate : std::uint8_t { Constant, Uniform, Vertex, Pixel, Light };
std::string_view to_string(Rate rate);

struct Inst {
    Op op = Op::Constant;
    bool is_light_loop = false;  // on For: each iteration is one light, so LoopIndex has rate Light
    // On For: the last value that it carries is a bool, and a round begins only if that is true.
    bool is_while = false;
    Type type{};
    std::uint32_t first_operand = 0;  // into Function::operands
    std::uint32_t operand_count = 0;
    std::uint32_t data = 0;  // what it means depends on the op: see ops.def
    OriginId origin{};       // the graph node that it comes from
    NameId name{};           // a hint (ir/hints.h): a value that has one is printed as a statement of its own
};

struct Block {
    std::vector<Value> insts{};
};

struct Param {
    std::string name{};
    Type type{};
    Rate rate = Rate::Pixel;
    bool is_semantic = false;  // added by link() for a semantic; may be removed where the function does not read it
    bool from_bottom = false;  // as Semantic::from_bottom
    bool is_unit = false;      // as Semantic::is_unit
};

// Which code outside of the module calls or defines a function.
enum class Linkage : std::uint8_t {
    Internal,  // nobody: its signature may change
    Exported,  // other texts call it: only unread parameters of semantics may be removed
    External,  // another text defines it: its body here means nothing, and its signature must stay
    Foreign,   // an included file defines it: as External, and the text does not declare it
    Verbatim,  // its definition is text (ForeignCode), which only some languages can take: as External otherwise
};

// A value that has a name in a graph, so that a trace can show it (interpret/). Rebuilding a function drops its probes:
// only functions that no pass has rebuilt have any.
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

// A line that a pass adds at a named position of the stage's text, if an engine compiles the file and needs lines of
// its own: {"include", "AutoLight.cginc"}. The writer of the engine's files knows the places.
struct StageText {
    std::string place{}, line{};
};

// Functions as text that nothing here reads. The last of them has the name, the parameters and the result of the
// Function. If the result is a struct, the text has an `out` parameter for each member instead, after the others.
struct ForeignCode {
    static constexpr std::uint32_t kEnd = 0xffffffffu, kOwn = 0;
    struct Part {
        std::string text{};
        std::uint32_t name = kEnd;  // behind the text: the function's own name, or that of helpers[name - 1]
    };
    std::vector<std::string> helpers{};  // names that are wanted for the functions before the last one
    std::vector<Part> parts{};
};

struct Function {
    std::string name{};
    std::vector<Param> params{};
    Type result{};
    std::vector<Inst> insts{};
    std::vector<Value> operands{};
    std::vector<Block> blocks{};  // blocks[0] is the body
    OriginId origin{};
    std::string comment{};  // lines, printed above the function
    // What each member of the result is, for a function that loses members. The comment describes the member whose text
    // is the comment itself. May be empty.
    std::vector<std::string> result_docs{};
    bool always_inline = false;      // recipes and pass bodies: their instructions are copied to where they are called
    bool inline_if_shorter = false;  // a sub-graph: it is a function only where that makes the text shorter
    Linkage linkage = Linkage::Internal;
    // Foreign: how a call is written, "MACRO({0}, {1})". If it contains {result}, it consists of one or more statements
    // that declare the result. Empty: a call is written as usual.
    std::string spelling{};
    std::vector<StageText> texts{};  // Foreign: lines that a stage needs if it calls the function
    bool is_of_object = false;       // Foreign: its result depends on the object that is drawn
    ForeignCode code{};              // Verbatim
    std::vector<Probe> probes{};

    const Inst& operator[](Value v) const { return insts[v.index]; }
    std::span<const Value> args(const Inst& inst) const {
        return {operands.data() + inst.first_operand, inst.operand_count};
    }
    std::span<const Value> args(Value v) const { return args(insts[v.index]); }
};

// True if the function is not defined by its instructions: another text defines it, or text that nothing reads.
inline bool is_elsewhere(const Function& function) {
    return function.linkage == Linkage::External || function.linkage == Linkage::Foreign ||
           function.linkage == Linkage::Verbatim;
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

// A constant's components in order, those of a matrix row by row, each exact in a double. A constant is always numeric:
// a struct or array of constants is a Construct.
struct Constant {
    Type type{};
    std::uint32_t first = 0;  // into Module::numbers; type.components() of them
};

// A bool, or an enum as an int, whose value is known before a shader runs: a specialization constant, or a keyword of
// an engine that compiles the text once for each value.
struct Keyword {
    std::string property{};
    std::optional<std::uint32_t> constant_id{};  // of a specialization constant
    double value = 0;                            // the default
    std::vector<std::string> values{};           // of an enum: its words
};

// The source of a global's value.
enum class Group : std::uint8_t {
    Engine,    // values of camera, frame, object and lights: numbers are finite
    Material,  // properties
    Targets,   // what other passes have drawn
    Included,  // the engine, and an included file declares it: it is bound nowhere; numbers are finite
};

// Where a global is bound: by Vulkan's numbers, and by HLSL's register, which counts from 0 for each kind of a set. An
// engine decides it (lower/place.h).
struct BindingPlace {
    std::uint32_t set = 0, binding = 0, slot = 0;
    friend bool operator==(const BindingPlace&, const BindingPlace&) = default;
};

// Where a global lives. The printers place it, the runtime and the interpreter fill it.
struct Global {
    std::string name{};
    Type type{};
    // Of a member of a uniform block: the block, and which of its members. Textures, samplers, keywords and what an
    // engine fills by name are in no block.
    std::uint32_t block = 0xffffffffu;
    std::uint32_t member = 0;
    std::uint32_t keyword = 0xffffffffu;  // of Module::keywords
    Group group = Group::Engine;
    BindingPlace place{};  // of a texture or sampler
    Span span{};
    std::string spelling{};  // not empty: an included file declares it, and the text writes it like this
    // An engine may store values encoded. `decoder` is the foreign function that decodes every value that is read. If
    // the function `follower` is then called with the decoded value, the foreign function `at_once` may replace both
    // calls. Each may be empty.
    std::string decoder{};
    std::string follower{};
    std::string at_once{};
    bool is_of_object = false;  // of an included declaration: it depends on the object that is drawn
    bool from_bottom = false;   // as Semantic::from_bottom; of float4: the tiling of a texture
    bool in_block() const { return block != 0xffffffffu; }
    bool is_keyword() const { return keyword != 0xffffffffu; }
    bool is_foreign() const { return !spelling.empty(); }
};

struct BlockMember {
    std::string name{};
    Type type{};
    std::uint32_t offset = 0;     // bytes; the same in std140 and in an HLSL cbuffer with `padding` before the member
    std::uint32_t padding = 0;    // floats that the text declares before it
    std::string stored_as{};      // the type's name in the text, if an engine stores it as another type; may be empty
    bool is_of_instance = false;  // each instance of a draw has a value of its own, if the engine can declare that
    std::string declared_in{};    // the engine's file that declares it; empty: the text itself does
};
struct UniformBlock {
    std::string name{};
    Group group = Group::Engine;
    BindingPlace place{};
    bool matrices_by_rows = false;
    std::uint32_t size = 0;  // bytes, a multiple of 16
    std::vector<BlockMember> members{};
};

// A value of the mesh, camera or engine that a graph reads by name. link() replaces its reads by a parameter.
struct Semantic {
    std::string name{};
    Type type{};
    Rate rate = Rate::Pixel;
    bool from_bottom = false;  // texture coordinates of an engine that counts y from the bottom (turn_textures())
    bool is_unit = false;      // in all passes, a vector of length 1
};

// The graph node (or library function) that an instruction comes from.
struct Origin {
    std::string label{};   // "SampleTexture2D"; empty: no comment is printed
    bool is_note = false;  // the label is the author's note
    std::string id{};      // "albedo"; in a sub-graph, a path: "rust/edge"
    // If the node is in the function of a sub-graph: the length of the part of `path` that leads to this function; then
    // the path is that of the first use. inline_calls() gives what it copies to another use the path of that.
    std::uint32_t function_path = 0;
    Span span{};  // where it stands in the graph's JSON

    std::string_view path_in_function() const { return std::string_view(id).substr(function_path); }
};

// Stage inputs are the entry function's params; stage outputs are the members of the struct that it returns.
enum class Builtin : std::uint8_t { None, Position, FragCoord, FrontFacing, VertexIndex, InstanceIndex };
struct StageVariable {
    std::string name{};
    Type type{};
    std::uint32_t location = 0;
    Builtin builtin = Builtin::None;
    std::string semantic{};  // of a vertex input: the HLSL semantic of the engine's meshes, "POSITION"
    bool flat = false;
    bool from_bottom = false;  // as Semantic::from_bottom
    std::string spelling{};    // of an output: what the text assigns it to, instead of a member; may be empty
    std::string guard{};       // of an output: the preprocessor condition under which it exists; may be empty
};
enum class StageKind : std::uint8_t { Vertex, Fragment };
struct StageInterface {
    StageKind kind = StageKind::Fragment;
    FunctionId entry{};
    std::vector<StageVariable> inputs{};   // one per param of entry
    std::vector<StageVariable> outputs{};  // one per member of entry's result struct
    std::vector<StageText> texts{};
    // The stages of other passes have the same functions, and all are printed into one file. So this stage's calls
    // should not change a function.
    bool shares_functions = false;
};

struct Module {
    std::vector<Function> functions;  // a callee comes before its callers; verify() checks that
    std::vector<Struct> structs;
    std::vector<Array> arrays;
    std::vector<Constant> constants;
    std::vector<double> numbers;
    std::vector<UniformBlock> blocks;
    std::vector<Global> globals;
    std::vector<Keyword> keywords;
    bool tests_keywords = false;  // the text's preprocessor decides what depends on keywords alone
    bool has_values_from_bottom = false;
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
    // A hash table of indices into `names`, at most half full. It is one vector, so that copying a module is cheap.
    std::vector<std::uint32_t> name_slots_;
};

// The type of a part: of a vector a component, of a matrix a row, of an array an element, of a struct a member.
Type part_type(const Module& module, Type composite, std::uint32_t index);
std::uint32_t part_count(const Module& module, Type composite);

// By struct: true if the signature of an External function contains it.
std::vector<bool> shared_structs(const Module& module);

// The result type that the op's rule computes from these operand types, or Error if they do not fit the rule. An op of
// TypeRule::Declared has no such rule and gives Error: declared_types.h checks it.
Type result_type(Op op, std::span<const Type> operands);

}  // namespace patina::ir
