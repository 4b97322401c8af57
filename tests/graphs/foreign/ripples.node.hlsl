// Text that is HLSL and no node language: loops without a known end, and static arrays.
[foreign]
float below(float x, float limit)
{
    while (x > limit)
        x -= limit;  // a brace in a comment: }
    return x;
}

[foreign]
float next(float x) { return below(x * 1.5, 4.0); }

/// Ripples that fade.
[node("Custom/Ripples")]
[foreign]
void Ripples(
    float2 uv = uv0,
    out float height,
    [range(0, 8)] float scale = 4,  ///< how fine they are
    out float3 tint
) {
    static const float kSteps[3] = { 1.0, 0.5, 0.25 };
    height = 0;
    float at = length(uv) * scale;
    int i = 0;
    do
    {
        height += kSteps[i] * sin(at);
        at = next(at);
        if (height > 1.5) break;
        i++;
    } while (i < 3);
    tint = float3(uv, below(height, 1.0));
}
