// How HLSL writes the operations that it writes in its own way.
#include "compiler/languages/c/spelling.h"

#include "compiler/languages/hlsl/hlsl.h"

namespace patina::languages::hlsl {

constexpr Spelling kRows[] = {
    {Op::Select, Form::Shared},
    {Op::Less, Form::Infix, "<", Precedence::Relational, "", kEither},
    {Op::LessEqual, Form::Infix, "<=", Precedence::Relational, "", kEither},
    {Op::Greater, Form::Infix, ">", Precedence::Relational, "", kEither},
    {Op::GreaterEqual, Form::Infix, ">=", Precedence::Relational, "", kEither},
    {Op::Equal, Form::Infix, "==", Precedence::Equality, "", kEither},
    {Op::NotEqual, Form::Infix, "!=", Precedence::Equality, "", kEither},
    {Op::And, Form::Infix, "&&", Precedence::LogicalAnd, "", kEither},
    {Op::Or, Form::Infix, "||", Precedence::LogicalOr, "", kEither},
    {Op::Not, Form::Prefix, "!", Precedence::Unary},
    {Op::Round, Form::Function, "round"},
    {Op::Frac, Form::Function, "frac"},
    {Op::Saturate, Form::Function, "saturate"},
    {Op::Rsqrt, Form::Function, "rsqrt"},
    {Op::Atan2, Form::Function, "atan2"},
    {Op::Lerp, Form::Function, "lerp", Precedence::Postfix, "", kThird},
    {Op::MatMul, Form::Function, "mul"},
    {Op::Transpose, Form::Function, "transpose"},
    {Op::TextureSize, Form::Statement},  // GetDimensions
    {Op::Ddx, Form::Function, "ddx"},
    {Op::Ddy, Form::Function, "ddy"},
};

constexpr SpellingTable kTable = by_op(kCRows, kRows);
const SpellingTable kSpellings = kTable;

}  // namespace patina::languages::hlsl
