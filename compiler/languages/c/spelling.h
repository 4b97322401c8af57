// How languages that descend from C write the operations that they all write alike. A language adds the other rows:
//
//   constexpr Spelling kRows[] = {{Op::Frac, Form::Function, "fract"}, ...};
//   constexpr SpellingTable kTable = by_op(kCRows, kRows);
#pragma once

#include "compiler/languages/language.h"

namespace patina::languages {

using ir::Op;

inline constexpr Spelling kCRows[] = {
    // --- leaves and composites: expressions.cpp
    {Op::Constant, Form::Shared},
    {Op::Param, Form::Shared},
    {Op::Global, Form::Shared},
    {Op::Semantic, Form::Statement},  // a linked stage has none
    {Op::Construct, Form::Shared},
    {Op::Extract, Form::Shared},
    {Op::Insert, Form::Statement},
    {Op::Swizzle, Form::Shared},
    {Op::Index, Form::Shared},
    {Op::Convert, Form::Shared},
    {Op::Bitcast, Form::Shared},

    // --- control: statements.cpp
    {Op::Call, Form::Shared},
    {Op::If, Form::Statement},
    {Op::For, Form::Statement},
    {Op::LoopIndex, Form::Statement},
    {Op::LoopCarried, Form::Statement},
    {Op::Result, Form::Statement},
    {Op::Yield, Form::Statement},
    {Op::Return, Form::Statement},
    {Op::DiscardIf, Form::Statement},

    // --- operators
    {Op::Add, Form::Infix, "+", Precedence::Additive, "", kEither},
    {Op::Sub, Form::Infix, "-", Precedence::Additive, "", kEither},
    {Op::Mul, Form::Infix, "*", Precedence::Multiplicative, "", kEither},
    {Op::Div, Form::Infix, "/", Precedence::Multiplicative, "", kEither},
    {Op::Mod, Form::Infix, "%", Precedence::Multiplicative, "", kEither},  // uint only: legalize() rewrites the others
    {Op::Neg, Form::Prefix, "-", Precedence::Unary},
    {Op::BitAnd, Form::Infix, "&", Precedence::BitAnd, "", kEither},
    {Op::BitOr, Form::Infix, "|", Precedence::BitOr, "", kEither},
    {Op::BitXor, Form::Infix, "^", Precedence::BitXor, "", kEither},
    {Op::BitNot, Form::Prefix, "~", Precedence::Unary},
    {Op::ShiftLeft, Form::Infix, "<<", Precedence::Shift, "", kSecond},
    {Op::ShiftRight, Form::Infix, ">>", Precedence::Shift, "", kSecond},

    // --- functions, component by component
    {Op::Abs, Form::Function, "abs"},
    {Op::Sign, Form::Function, "sign"},
    {Op::Floor, Form::Function, "floor"},
    {Op::Ceil, Form::Function, "ceil"},
    {Op::Trunc, Form::Function, "trunc"},
    {Op::Sqrt, Form::Function, "sqrt"},
    {Op::Exp, Form::Function, "exp"},
    {Op::Exp2, Form::Function, "exp2"},
    {Op::Log, Form::Function, "log"},
    {Op::Log2, Form::Function, "log2"},
    {Op::Sin, Form::Function, "sin"},
    {Op::Cos, Form::Function, "cos"},
    {Op::Tan, Form::Function, "tan"},
    {Op::Asin, Form::Function, "asin"},
    {Op::Acos, Form::Function, "acos"},
    {Op::Atan, Form::Function, "atan"},
    {Op::Sinh, Form::Function, "sinh"},
    {Op::Cosh, Form::Function, "cosh"},
    {Op::Tanh, Form::Function, "tanh"},
    {Op::Radians, Form::Function, "radians"},
    {Op::Degrees, Form::Function, "degrees"},
    {Op::Min, Form::Function, "min", Precedence::Postfix, "", kSecond},
    {Op::Max, Form::Function, "max", Precedence::Postfix, "", kSecond},
    {Op::Pow, Form::Function, "pow"},
    {Op::Step, Form::Function, "step", Precedence::Postfix, "", kFirst},
    {Op::Clamp, Form::Function, "clamp", Precedence::Postfix, "", kSecond | kThird},
    {Op::Smoothstep, Form::Function, "smoothstep", Precedence::Postfix, "", kFirst | kSecond},
    {Op::IsNan, Form::Function, "isnan"},
    {Op::IsInf, Form::Function, "isinf"},

    // --- vectors and matrices
    {Op::Any, Form::Function, "any"},
    {Op::All, Form::Function, "all"},
    {Op::Dot, Form::Function, "dot"},
    {Op::Length, Form::Function, "length"},
    {Op::Distance, Form::Function, "distance"},
    {Op::Normalize, Form::Function, "normalize"},
    {Op::Cross, Form::Function, "cross"},
    {Op::Reflect, Form::Function, "reflect"},
    {Op::Refract, Form::Function, "refract"},
    {Op::Determinant, Form::Function, "determinant"},

    // --- textures and derivatives
    {Op::Sample, Form::Own},
    {Op::SampleBias, Form::Own},
    {Op::SampleLevel, Form::Own},
    {Op::SampleGrad, Form::Own},
    {Op::TexelLoad, Form::Own},
    {Op::Fwidth, Form::Function, "fwidth"},
};

}  // namespace patina::languages
