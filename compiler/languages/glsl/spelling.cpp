// How GLSL writes the operations that it writes in its own way.
#include "compiler/languages/c/spelling.h"

#include "compiler/languages/glsl/glsl.h"

namespace patina::languages::glsl {

constexpr Spelling kRows[] = {
    {Op::Select, Form::Own},
    {Op::Less, Form::Infix, "<", Precedence::Relational, "lessThan"},
    {Op::LessEqual, Form::Infix, "<=", Precedence::Relational, "lessThanEqual"},
    {Op::Greater, Form::Infix, ">", Precedence::Relational, "greaterThan"},
    {Op::GreaterEqual, Form::Infix, ">=", Precedence::Relational, "greaterThanEqual"},
    {Op::Equal, Form::Infix, "==", Precedence::Equality, "equal"},
    {Op::NotEqual, Form::Infix, "!=", Precedence::Equality, "notEqual"},
    {Op::And, Form::Infix, "&&", Precedence::LogicalAnd},
    {Op::Or, Form::Infix, "||", Precedence::LogicalOr},
    {Op::Not, Form::Prefix, "!", Precedence::Unary, "not"},
    {Op::Round, Form::Function, "roundEven"},
    {Op::Frac, Form::Function, "fract"},
    {Op::Saturate, Form::Own},
    {Op::Rsqrt, Form::Function, "inversesqrt"},
    {Op::Atan2, Form::Function, "atan"},
    {Op::Lerp, Form::Function, "mix", Precedence::Postfix, "", kThird},
    {Op::MatMul, Form::Own},
    {Op::Transpose, Form::Own},
    {Op::TextureSize, Form::Own},
    {Op::Ddx, Form::Function, "dFdx"},
    {Op::Ddy, Form::Function, "dFdy"},
};

constexpr SpellingTable kTable = by_op(kCRows, kRows);
const SpellingTable kSpellings = kTable;

}  // namespace patina::languages::glsl
