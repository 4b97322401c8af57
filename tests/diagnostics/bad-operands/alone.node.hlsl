// Nothing calls these: their errors are found all the same.
enum Way {
    Plain,
    Bent
};

float helper(float3 a) {
    return a + float2(1, 2);
}

/// A node.
[node("Test/Alone")]
floatN Alone(floatN a = 1, const Way way = Plain) {
    if (way == Bent) { return a + Missing(a); }
    return a;
}
