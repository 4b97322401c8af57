// Gradients as values: a graph writes one as its keys, and a property holds one that can be set.

/// A gradient: up to eight colours and up to eight alphas, each at a time from 0 to 1.
struct Gradient {
    /// [0]: how many colours and alphas there are, and the blend (0 linear, 1 fixed, 2 perceptual). [1] to [8]: red, green, blue
    /// and the time of a colour. [9] to [16]: an alpha, 0, 0 and its time.
    float4 keys[17];
};

/// The share of the next key: from 0 at the time of the one before to 1 at its own; with the blend "fixed" all of it.
[inline]
float GradientShare(float time, float before, float at, bool isFixed) {
    float share = saturate((time - before) / max(at - before, 1e-6));
    float reached = time > before ? 1 : 0;
    return isFixed ? reached : share;
}

/// The colour and the alpha of a gradient at a time.
///
/// Before the first key and after the last one, they are constant. Colours and alphas have keys of their own. With the blend
/// "fixed", each key's value begins at the key before it. With "perceptual", colours are blended in OkLab.
///
/// formula: c = c_0, then for each further key i: lerp(c, c_i, saturate((time - t_(i-1)) / (t_i - t_(i-1))))
/// source: perceptual: Ottosson, "A perceptual color space for image processing", 2020
[node("Color/Gradient/Sample Gradient")] [inline] [inFloat] [also("Gradient")]
float4 SampleGradient(
    Gradient gradient,             ///< { "colors": [[0, "#000000"], [1, "#ffffff"]] }, or a property
    [range(0, 1)] float time = 0  ///< where in the gradient
) {
    bool isFixed = gradient.keys[0].z == 1;
    bool isPerceptual = gradient.keys[0].z == 2;
    float3 color = isPerceptual ? LinearToOkLab(gradient.keys[1].rgb) : gradient.keys[1].rgb;
    [unroll] for (int i = 2; i < min(int(gradient.keys[0].x) + 1, 9); i++) {
        float4 before = gradient.keys[i - 1];
        float4 key = gradient.keys[i];
        float3 next = isPerceptual ? LinearToOkLab(key.rgb) : key.rgb;
        color = lerp(color, next, GradientShare(time, before.w, key.w, isFixed));
    }
    float alpha = gradient.keys[9].x;
    [unroll] for (int k = 10; k < min(int(gradient.keys[0].y) + 9, 17); k++) {
        float4 before = gradient.keys[k - 1];
        float4 key = gradient.keys[k];
        alpha = lerp(alpha, key.x, GradientShare(time, before.w, key.w, isFixed));
    }
    return float4(isPerceptual ? OkLabToLinear(color) : color, alpha);
}
