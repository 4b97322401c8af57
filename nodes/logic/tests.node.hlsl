// Tests of numbers, and conditions made of them.

/// Whether every component is other than zero.
///
/// test: All(float3(1, -2, 0.5)) == true
/// test: All(float3(1, 0, 0.5)) == false
/// test: All(0) == false
[node("Logic/All")]
bool All(
    floatN value = 0  ///< a number or a vector
) {
    return all(value != 0);
}

/// Whether at least one component is other than zero.
///
/// test: Any(float3(0, 0, -0.5)) == true
/// test: Any(float3(0, 0, 0)) == false
/// test: Any(2) == true
[node("Logic/Any")]
bool Any(
    floatN value = 0  ///< a number or a vector
) {
    return any(value != 0);
}

/// Whether at least one of two conditions does not hold: the opposite of And.
///
/// test: Nand(true, true) == false
/// test: Nand(true, false) == true
/// test: Nand(false, false) == true
[node("Logic/Nand")]
bool Nand(
    bool left = false,  ///< first condition
    bool right = false  ///< second condition
) {
    return !(left && right);
}

/// Whether exactly one of two conditions holds.
///
/// test: Xor(true, false) == true
/// test: Xor(true, true) == false
/// test: Xor(false, false) == false
[node("Logic/Xor")]
bool Xor(
    bool left = false,  ///< first condition
    bool right = false  ///< second condition
) {
    return left != right;
}

/// Whether a value is infinite: the result of 1 / 0, or of a number too large for a float.
///
/// test: IsInfinite(asfloat(0x7f800000u)) == true
/// test: IsInfinite(asfloat(0xff800000u)) == true
/// test: IsInfinite(3e38) == false
/// test: IsInfinite(asfloat(0x7fc00000u)) == false
[node("Logic/Is Infinite")] [also("IsInf")]
bool IsInfinite(
    float value = 0  ///< any value
) {
    return isinf(value);
}

/// Whether the camera sees the front of the surface: the side from which a triangle's vertices run counter-clockwise.
///
/// test: IsFrontFace(true) == true
/// test: IsFrontFace(false) == false
[node("Logic/Is Front Face")] [also("TwoSidedSign", "FrontFacing")]
bool IsFrontFace(
    [hidden] bool front = frontFacing  ///< read from the rasteriser
) {
    return front;
}
