// Reads a function's body with the types of its values, and writes conversions around its tokens (conversions.h).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/importers/shadergraph/code/hlsl_text.h"
#include "compiler/importers/shadergraph/code/hlsl_tokens.h"
#include "compiler/importers/shadergraph/conversions/hlsl_types.h"

namespace patina::importers::shadergraph {

struct Parameter {
    Type type{};
    std::string_view name{};
    bool is_out = false;
};
// "float2 UV, [hidden] float engineTime = time, out float3 Out"
std::vector<Parameter> parameters_in(std::string_view text);

class TypedReader {
public:
    TypedReader(const HlslFunction& function, const std::vector<HlslFunction>& others, std::string_view values);
    std::string run();

private:
    struct Variable {
        Type type{};
        std::string_view read_as{};  // a loop's counter is an int: "float"
    };
    using Scope = std::map<std::string_view, Variable>;
    // An expression: the tokens from `begin` to before `end`.
    struct Value {
        Type type{};
        std::size_t begin = 0, end = 0;
        bool is_primary = true;     // operators behind it belong to all of it
        bool is_bracketed = false;  // "(...)"
    };

    const Token& at(std::size_t ahead = 0) const;
    bool is(std::string_view text) const { return at().text == text; }
    bool is_word(std::size_t ahead = 0) const { return !at(ahead).text.empty() && is_letter(at(ahead).text[0]); }
    bool take(std::string_view text);
    void need(std::string_view text);
    void give_up() { is_lost_ = true; }
    std::string written(std::size_t begin, std::size_t end) const;

    // --- statements
    void find_limits();
    void statement(bool is_in_block);
    void if_statement();
    void return_statement();
    void attribute();
    void for_loop();
    bool whole_limit(std::size_t begin, std::size_t end, bool is_included);
    bool declaration(bool is_in_block);
    void list_of(const Type& type);
    void sincos(bool is_in_block);
    bool is_void_call() const;
    void void_call(bool is_in_block);
    void replace_statement(std::size_t begin, const std::string& text, bool is_in_block);
    const HlslFunction* own_function(std::string_view name) const;
    void assignment_statement();

    // --- expressions
    Value expression();
    Value binary(int strength);
    Value unary();
    Value cast(std::size_t begin, const Type& to);
    Value postfix();
    Value call(std::string_view function, std::size_t begin);
    Value choice(Value condition);
    std::vector<Value> arguments();
    void arithmetic(std::vector<Value*> values, Type& result, bool is_float);
    Type of_operator(std::string_view op, Value& a, Value& b);
    Type of_rule(Rule rule, std::vector<Value>& values);

    // --- what is written
    void wrap(Value& value, const std::string& function);
    void convert(Value& value, const Type& to);
    void to_bool(Value& value);

    struct Text {
        std::string before{}, text{}, after{};
    };
    std::string_view body_;
    std::vector<Token> tokens_;
    std::vector<Text> texts_;  // of each token
    const HlslFunction& function_;
    const std::vector<HlslFunction>& others_;
    Scope scope_{};
    std::set<std::string_view> limits_{};  // variables that limit loops
    static constexpr int kDeepest = 200;   // the reader calls itself
    static constexpr std::size_t kNone = std::string::npos;
    std::size_t next_ = 0;
    std::size_t return_ = kNone;  // the last statement ends with this "return;"
    std::size_t blocks_ = 0;      // around the statement
    std::size_t open_ = 0;        // brackets that the end of the body closes
    int depth_ = 0;
    bool is_lost_ = false;
};

}  // namespace patina::importers::shadergraph
