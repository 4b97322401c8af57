// Conditions and choices. All inputs of these nodes are computed: a branch picks a value, it does not skip work.

/// How Compare compares.
enum Comparison {
    Less,            ///< left < right
    LessOrEqual,     ///< left <= right
    Greater,         ///< left > right
    GreaterOrEqual,  ///< left >= right
    Equal,           ///< exactly the same number
    NotEqual         ///< any other number
};

/// Picks one of two values by a condition.
///
/// test: Branch(true, 1, 2) == 1
/// test: Branch(false, float2(1, 2), 3) == float2(3, 3)
[node("Logic/Branch")] [also("Switch", "If")]
floatN Branch(
    bool condition = true,  ///< decides which value is picked
    floatN ifTrue = 1,     ///< the value where the condition holds
    floatN ifFalse = 0     ///< the value where it does not
) {
    return condition ? ifTrue : ifFalse;
}

/// Whether a comparison of two numbers holds.
///
/// Computed numbers are seldom exactly equal: compare with Less or Greater where you can.
///
/// test: Compare(1, 2) == true
/// test: Compare(2, 2, Less) == false
/// test: Compare(2, 2, LessOrEqual) == true
/// test: Compare(2, 1, Greater) == true
/// test: Compare(1, 2, GreaterOrEqual) == false
/// test: Compare(3, 3, Equal) == true
/// test: Compare(3, 3, NotEqual) == false
[node("Logic/Compare")] [also("Comparison", "IfGreater", "IfGreaterEq", "IfEqual")]
bool Compare(
    float left = 0,                     ///< first number
    float right = 0,                    ///< second number
    const Comparison comparison = Less  ///< the comparison
) {
    if (comparison == Less) { return left < right; }
    if (comparison == LessOrEqual) { return left <= right; }
    if (comparison == Greater) { return left > right; }
    if (comparison == GreaterOrEqual) { return left >= right; }
    if (comparison == Equal) { return left == right; }
    return left != right;
}

/// Whether both conditions hold.
///
/// test: And(true, true) == true
/// test: And(true, false) == false
[node("Logic/And")]
bool And(
    bool left = true,  ///< first condition
    bool right = true  ///< second condition
) {
    return left && right;
}

/// Whether at least one of two conditions holds.
///
/// test: Or(false, true) == true
/// test: Or(false, false) == false
[node("Logic/Or")]
bool Or(
    bool left = false,  ///< first condition
    bool right = false  ///< second condition
) {
    return left || right;
}

/// Whether the condition does not hold.
///
/// test: Not(true) == false
/// test: Not(false) == true
[node("Logic/Not")]
bool Not(
    bool condition = false  ///< any condition
) {
    return !condition;
}

/// Whether a value is not a number (NaN): the result of 0 / 0, and of everything computed from it.
///
/// test: IsNan(asfloat(0x7fc00000u)) == true
/// test: IsNan(0) == false
/// test: IsNan(asfloat(0x7f800000u)) == false
[node("Logic/Is NaN")]
bool IsNan(
    float value = 0  ///< any value
) {
    return isnan(value);
}
