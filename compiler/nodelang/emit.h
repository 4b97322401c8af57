// Syntax trees -> IR, checking types on the way. One Emitter per IR module; it keeps the functions that it has already
// made, one per combination of width, precision and constant arguments ("instances"). Names that are not the language's
// own (nodes, properties, semantics) are asked of an Environment, so that function bodies and graph expressions are
// emitted by the same code.
//
//   Emitter emitter(module, sources, diagnostics, {});
//   Scope scope{.builder = &b, .declarations = &library, .environment = &graph};
//   Typed mask = emitter.expression(*expr, scope);
//
// Not here: what a graph is (lower/lower.h), how stages are put together (assemble/).
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/builder.h"
#include "compiler/nodelang/library.h"

namespace patina::nodelang {

// The outputs of a call or node with more than one, as members of one struct value.
struct Outputs {
    std::vector<std::string> names;  // in member order
    bool has_primary = true;         // member 0 is what the bare name means
};

// A value while it is being emitted.
struct Typed {
    ir::Value value;
    ir::Type type = ir::Type::error();
    bool literal = false;  // a literal (or arithmetic of literals): becomes whatever number is needed
    const Outputs* outputs = nullptr;
    const std::vector<std::string_view>* enumerators = nullptr;  // an enum's value: what == may compare it with

    bool ok() const { return !type.is_error(); }
};

struct Scope;

// Numbers from here on are infinite in 16 bits.
inline constexpr double kHalfLimit = 65520;
// Scalar kinds that convert to each other in an operator: half joins float as float.
bool joins(ir::Scalar a, ir::Scalar b);
// "xy" for 2
std::string_view swizzle_prefix(unsigned width);

// What a name means beyond the language itself.
class Environment {
public:
    virtual ~Environment() = default;
    // Each reports its own error and returns a Typed that is not ok() when there is no such thing.
    virtual Typed name(const Expr& expr, Scope& scope) = 0;
    virtual Typed property(const Expr& expr, Scope& scope) = 0;
    virtual Typed semantic(std::string_view name, Span span, Scope& scope) = 0;
    virtual Typed file(const Expr& expr, Scope& scope) = 0;
    // True if a bare name is the environment's own (a node's id) and hides a constant of the library.
    virtual bool hides(std::string_view) const { return false; }
    // Of the vertex stage: adds to a complaint who asks there for the value.
    virtual void tell_reader(DiagnosticRecord&) const {}
};

// A port that is left open, whose default is emitted: where the call stands, and what is called.
struct OpenPort {
    Span call;
    std::string_view function, port;
};

struct Local {
    std::string_view name;
    Typed value;
    bool is_const = false;
    std::optional<double> constant;  // a const parameter's value
};

// Where an expression or statement is being emitted.
struct Scope {
    ir::Builder* builder = nullptr;
    const Declarations* declarations = nullptr;
    Environment* environment = nullptr;  // null in function bodies
    std::vector<Local> locals{};
    unsigned generic_width = 0;  // of floatN; 0 outside generic functions
    bool half = false;           // `float` means half
    // The function being emitted, for returns.
    const FunctionDecl* function = nullptr;
    ir::Type result{};
    bool* needs_quad = nullptr;  // set when something needs neighbouring pixels
    std::string_view flow{};     // "if" or "for" when inside one
    const OpenPort* open_port = nullptr;
    bool in_vertex_stage = false;
    double rounds_around = 1;  // of the loops that enclose what is emitted, multiplied
    double rounds = 0;         // of all loops so far, those of called functions included
};

// What a pass function may call that the graph provides.
struct Slot {
    ir::FunctionId function;
    ir::Type result{};
    bool needs_quad = false;
};

// One of the functions that a declaration has become.
struct InstanceInfo {
    ir::FunctionId id;
    bool half = false;
};

class Emitter {
public:
    Emitter(ir::Module& module, Diagnostics& diagnostics, ir::BuildOptions options);

    ir::Module& module() { return module_; }
    Diagnostics& diagnostics() { return diagnostics_; }
    const ir::BuildOptions& options() const { return options_; }

    // --- expressions
    Typed expression(const Expr& expr, Scope& scope);
    // Converted to `type` by the implicit conversions, or reported. `what` opens the message: "the input 'uv'".
    Typed expression_as(const Expr& expr, ir::Type type, Scope& scope, std::string_view what);
    Typed convert(Typed value, ir::Type type, Scope& scope, Span span, std::string_view what);
    // A call's or node's primary output; anything else is itself.
    Typed primary(Typed value, Scope& scope, Span span);
    Typed member(Typed object, std::string_view name, Span span, Scope& scope);
    // Calls a function of the language with one expression per parameter (null: its default).
    Typed call(const FunctionDecl& function, const Declarations& home, std::span<const Expr* const> arguments,
               Scope& scope, Span span, bool half);
    // The value of an expression that is known without running anything: literals, const parameters, enumerators.
    std::optional<double> constant_value(const Expr& expr, const Scope& scope);

    // --- types
    ir::Type type(const TypeName& name, const Scope& scope);  // reports unknown types
    ir::Type structure(const StructDecl& decl, const Declarations& home);
    ir::Type texture2d();     // the struct {texture, sampler, texelSize, tiling}
    ir::Type texture_cube();  // the struct {texture, sampler}
    // (1/width, 1/height, width, height), asked of the texture.
    ir::Value texel_size(ir::Value texture, Scope& scope);
    // Makes a texture's value from its parts.
    Typed make_texture(ir::Value texture, ir::Value sampler, ir::Value texel_size, ir::Value tiling, Scope& scope);
    Typed make_cube(ir::Value texture, ir::Value sampler, Scope& scope);
    bool is_texture(ir::Type type) const;
    const Outputs* intern(Outputs outputs);

    // --- functions
    // Emits a function whose parameters are all semantics (a recipe or a pass entry). `always_inline` is set on it.
    ir::FunctionId semantic_function(const FunctionDecl& function, const Declarations& home, Environment& environment,
                                     bool in_vertex_stage, bool* needs_quad = nullptr);
    // Emits a function in each of its forms (widths of floatN, values of a drop-down) for the errors that are in it.
    void check_function(const FunctionDecl& function, const Declarations& home);
    // A function that is not generic and takes only plain parameters, as it stands.
    ir::FunctionId plain_function(const FunctionDecl& function, const Declarations& home);
    // A function in the place of another: parameters without a default are its own, the others are semantics.
    ir::FunctionId given_function(const FunctionDecl& function, const Declarations& home, Environment& environment,
                                  bool half);
    std::vector<InstanceInfo> instances_of(const FunctionDecl& function) const;
    void set_slot(std::string_view name, Slot slot) { slots_[std::string(name)] = slot; }
    const Slot* find_slot(std::string_view name) const;
    std::string_view slot_name(ir::FunctionId function) const;  // empty: it is no slot's
    // Asked for a slot, or a static, that has not been set. A maker that has none reports why at the place.
    using SlotMaker = std::function<const Slot*(const FunctionDecl& slot, Span at)>;
    using StaticMaker = std::function<std::optional<double>(const VariableDecl& variable)>;
    void set_slot_maker(SlotMaker maker) { slot_maker_ = std::move(maker); }
    void set_static_maker(StaticMaker maker) { static_maker_ = std::move(maker); }
    // The static maker says that its answer holds only until these are forgotten: functions that have got one are
    // emitted again where they are called after that.
    void answers_for_now() { ++passing_answers_; }
    void forget_answers();
    unsigned passing_answers() const { return passing_answers_; }
    // extern variables and functions are known by their declaration.
    void set_extern(const VariableDecl* variable, ir::GlobalId global) { externs_[variable] = global; }
    // Two declarations of one thing.
    void share_extern(const VariableDecl* variable, const VariableDecl* known) {
        if (const auto found = externs_.find(known); found != externs_.end()) externs_[variable] = found->second;
    }

    std::optional<ir::GlobalId> extern_global(const VariableDecl& variable) const {
        const auto found = externs_.find(&variable);
        return found == externs_.end() ? std::nullopt : std::optional(found->second);
    }
    Typed extern_value(const VariableDecl& variable, Scope& scope);
    // A [static] variable: a constant of the material's render block.
    void set_static(const VariableDecl* variable, double value) { statics_[variable] = value; }

    // Adds members to a struct that has not been emitted yet (what a lighting model declares).
    void extend_structure(const StructDecl& decl, std::vector<ir::Member> members) {
        extensions_[&decl] = std::move(members);
    }

private:
    struct Instance {
        ir::FunctionId id;
        ir::Type result{};
        const Outputs* outputs = nullptr;
        bool needs_quad = false;
        double rounds = 0;        // of its loops
        bool is_passing = false;  // holds until answers are forgotten
    };
    struct Argument {
        Typed value;
        std::optional<double> constant;  // of a const parameter
        std::vector<double> choices{};   // of a const parameter whose `value` is known later: by value, what it chooses
    };

    // expressions (emit_expression.cpp)
    Typed number(const Expr& expr, Scope& scope);
    Typed list(const Expr& expr, Scope& scope);
    Typed name(const Expr& expr, Scope& scope);
    Typed file_constant(const VariableDecl& variable, Scope& scope);
    Typed index(const Expr& expr, Scope& scope);
    Typed swizzle(Typed object, std::string_view letters, Scope& scope);
    Typed at_border(Typed value, const Scope& scope);

    // operators (emit_operator.cpp)
    Typed unary(const Expr& expr, Scope& scope);
    Typed binary(const Expr& expr, Scope& scope);
    Typed ternary(const Expr& expr, Scope& scope);
    Typed enum_operand(const Expr& expr, const std::vector<std::string_view>& enumerators, Scope& scope);
    Typed literal_as(Typed value, ir::Scalar scalar, Scope& scope, Span span);
    bool unify(std::span<Typed> operands, Scope& scope, Span span, std::string_view op);

    // calls (emit_call.cpp, emit_intrinsic.cpp)
    Typed call_expression(const Expr& expr, Scope& scope);
    Typed method(const Expr& expr, Scope& scope);
    Typed constructor(ir::Type type, const Expr& expr, Scope& scope);
    Typed intrinsic(std::string_view name, const Expr& expr, Scope& scope, bool& found);
    void warn_unless_finite(ir::Op op, ir::Type type, std::span<const ir::Value> values, const Scope& scope, Span span,
                            std::string_view what);
    Typed spelled_out(const FunctionDecl& function, std::span<const ir::Value> arguments, const Scope& border,
                      Scope& scope, Span span);
    bool gather_arguments(const FunctionDecl& function, const Declarations& home,
                          std::span<const Expr* const> arguments, Scope& scope, Span span,
                          std::vector<Argument>& gathered);
    Argument const_argument(const ParamDecl& param, const Declarations& home, const Expr& expr, Scope& scope);
    Argument choosing_argument(const ParamDecl& param, const EnumDecl* enumeration, const Expr& expr, Scope& scope);
    Typed call_gathered(const FunctionDecl& function, const Declarations& home, std::span<const Expr* const> arguments,
                        std::vector<Argument>& gathered, Scope& scope, Span span, bool half);
    Typed choose(ir::Value chooser, std::span<const Typed> choices, Scope& scope);
    Typed default_value(const Expr& expr, const Declarations& home, Scope& scope, ir::Type wanted,
                        const OpenPort* port = nullptr);
    unsigned deduce_width(const FunctionDecl& function, std::span<const Argument> arguments);
    Typed call_slot(const FunctionDecl& function, const Expr& expr, Scope& scope);
    // `samples`: because it samples a texture; else because it is a derivative.
    void need_quad(Scope& scope, Span span, std::string_view what, bool samples);

    // functions and statements (emit_function.cpp, emit_statement.cpp)
    const Instance& instantiate(const FunctionDecl& function, const Declarations& home,
                                std::span<const Argument> arguments, unsigned width, bool half, Span call_span);
    Instance emit_function(const FunctionDecl& function, const Declarations& home, std::span<const Argument> arguments,
                           unsigned width, bool half, std::string name);
    // Emits statements[first..]; returns true if they always return (the value is then in `returned`).
    bool statements(const Statements& list, std::size_t first, Scope& scope, ir::Value& returned);
    bool if_statement(const Stmt& stmt, const Statements& list, std::size_t next, Scope& scope, ir::Value& returned);
    void for_statement(const Stmt& stmt, Scope& scope);
    std::optional<double> rounds_of(const Stmt& loop, const Scope& scope);
    void count_rounds(double rounds, Scope& scope, Span span);
    void declare(const Stmt& stmt, Scope& scope);
    void assign(const Stmt& stmt, Scope& scope);
    bool store(const Expr& target, Typed value, Scope& scope);
    ir::Value return_value(const Stmt* stmt, Scope& scope);
    std::optional<double> static_value(const VariableDecl* variable) const;
    ir::FunctionId outer_function(const FunctionDecl& function, const Declarations& home, Environment& environment,
                                  Scope scope, bool may_take, bool* needs_quad);

    ir::Module& module_;
    Diagnostics& diagnostics_;
    ir::BuildOptions options_;
    // One version of a function for each width of floatN, precision and list of const arguments.
    struct InstanceKey {
        const FunctionDecl* function = nullptr;
        unsigned width = 0;
        bool half = false;
        std::vector<std::uint64_t> constants;  // bits of doubles
        friend bool operator<(const InstanceKey& a, const InstanceKey& b) {
            const auto key = [](const InstanceKey& k) { return std::tie(k.function, k.width, k.half, k.constants); };
            return key(a) < key(b);
        }
    };
    std::map<InstanceKey, Instance> instances_;
    std::map<const StructDecl*, ir::Type> structs_;
    std::map<const StructDecl*, std::vector<ir::Member>> extensions_;
    std::map<std::string, Slot> slots_;
    std::map<const VariableDecl*, ir::GlobalId> externs_;
    std::map<const VariableDecl*, double> statics_;
    SlotMaker slot_maker_;
    StaticMaker static_maker_;
    unsigned passing_answers_ = 0;
    std::optional<ir::Type> texture2d_, texture_cube_;
    std::deque<Outputs> outputs_;
    std::vector<const FunctionDecl*> active_;  // for recursion
    std::deque<std::vector<std::string_view>> enumerator_lists_;
};

// Of a declaration's comment, without its slashes, on one line.
std::string first_sentence(std::string_view doc);

// Names of all intrinsic functions, for suggestions.
std::vector<std::string_view> intrinsic_names();

}  // namespace patina::nodelang
