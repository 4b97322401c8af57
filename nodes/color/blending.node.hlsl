// Blending of a layer over another one, as pictures are composed. BlendColors has the usual modes; BlendUnity computes
// those of Unity's node of that name, some of which differ from the usual ones.

/// How BlendColors combines two colours.
enum BlendMode {
    Mix,         ///< the upper colour covers the lower one
    Multiply,    ///< the product: never brighter, like a coloured filter
    Screen,      ///< the opposite of Multiply: never darker
    Overlay,     ///< Multiply where the lower colour is dark, Screen where it is bright
    Add,         ///< the sum, like two lights; also called linear dodge
    Darken,      ///< the darker of the two
    Lighten,     ///< the brighter of the two
    Difference,  ///< how far they are apart
    Exclusion,   ///< like Difference, with less contrast
    Subtract,    ///< the lower colour minus the upper one
    Divide,      ///< the lower colour divided by the upper one
    Dodge,       ///< brightens the lower colour by the upper one, up to white
    Burn,        ///< darkens the lower colour by what the upper one lacks, down to black
    LinearBurn,  ///< the sum minus 1
    HardLight,   ///< Overlay with the layers exchanged: Multiply where the upper colour is dark
    SoftLight,   ///< a soft spotlight: darkens where the upper colour is dark, brightens where it is bright
    LinearLight, ///< LinearBurn where the upper colour is dark, Add where it is bright
    VividLight,  ///< Burn where the upper colour is dark, Dodge where it is bright
    PinLight,    ///< Darken where the upper colour is dark, Lighten where it is bright
    HardMix      ///< 0 or 1: whether the sum reaches 1
};

// The smallest divisor of a blend mode: a colour divided by it is far beyond white.
const float BLEND_FLOOR = 1e-5;

/// Dodge: black stays black, and white covers all that is not black.
floatN ColorDodge(floatN base, floatN blend) {
    return saturate(base / max(1 - blend, BLEND_FLOOR));
}

/// Burn: white stays white, and black covers all that is not white.
floatN ColorBurn(floatN base, floatN blend) {
    return 1 - saturate((1 - base) / max(blend, BLEND_FLOOR));
}

/// SoftLight of the specification, which has no step in its slope.
floatN SoftLightOf(floatN base, floatN blend) {
    floatN curve = base <= 0.25 ? ((16 * base - 12) * base + 4) * base : sqrt(max(base, 0));
    floatN dark = base - (1 - 2 * blend) * base * (1 - base);
    floatN bright = base + (2 * blend - 1) * (curve - base);
    return blend <= 0.5 ? dark : bright;
}

/// Blends one colour over another.
///
/// formula: lerp(a, f(a, b), opacity); mix: f = b; multiply: f = a b; screen: f = 1 - (1 - a)(1 - b); add: f = a + b
/// formula: overlay: f = 2 a b where a < 0.5, else 1 - 2 (1 - a)(1 - b); hard light: the same with a and b exchanged
/// formula: darken: f = min(a, b); lighten: f = max(a, b); difference: f = |a - b|; exclusion: f = a + b - 2 a b
/// formula: subtract: f = a - b; divide: f = a / b; dodge: f = a / (1 - b); burn: f = 1 - (1 - a) / b
/// formula: linear burn: f = a + b - 1; linear light: f = a + 2 b - 1; hard mix: f = 1 where a + b >= 1, else 0
/// formula: soft light: f = a - (1 - 2 b) a (1 - a) where b <= 0.5, else a + (2 b - 1)(d - a), with
/// formula: d = ((16 a - 12) a + 4) a where a <= 0.25, else sqrt(a)
/// formula: vivid light: burn with 2 b where b <= 0.5, else dodge with 2 b - 1
/// formula: pin light: f = min(a, 2 b) where b <= 0.5, else max(a, 2 b - 1)
/// source: W3C, "Compositing and Blending Level 1", section 10; the modes that it does not have: Adobe, "PDF Blend
/// source: Modes: Addendum", 2006, and the usual practice of picture editors
/// test: BlendColors(float3(0.2, 0.4, 0.6), float3(1, 0, 0.5), 0.5, Mix) == float3(0.6, 0.2, 0.55)
/// test: BlendColors(float3(0.2, 0.4, 0.6), float3(0.5, 1, 0), 1, Multiply) == float3(0.1, 0.4, 0)
/// test: BlendColors(float3(0.2, 0.4, 0.6), float3(0.5, 1, 0), 1, Screen) == float3(0.6, 1, 0.6)
/// test: BlendColors(float3(0.2, 0.4, 0.75), float3(0.5, 1, 0.5), 1, Overlay) == float3(0.2, 0.8, 0.75)
/// test: BlendColors(float3(0.2, 0.4, 0.6), float3(0.5, 1, 0), 0.5, Add) == float3(0.45, 0.9, 0.6)
/// test: BlendColors(float2(0.2, 0.75), float2(0.5, 0.25), 1, Darken) == float2(0.2, 0.25)
/// test: BlendColors(float2(0.2, 0.75), float2(0.5, 0.25), 1, Lighten) == float2(0.5, 0.75)
/// test: BlendColors(float2(0.2, 0.75), float2(0.5, 0.25), 1, Difference) == float2(0.3, 0.5)
/// test: BlendColors(float2(0.2, 0.75), float2(0.5, 1), 1, Exclusion) == float2(0.5, 0.25)
/// test: BlendColors(float2(0.75, 0.25), 0.5, 1, Subtract) == float2(0.25, -0.25)
/// test: BlendColors(float2(0.25, 0.2), float2(0.5, 0.1), 1, Divide) == float2(0.5, 2)
/// test: BlendColors(float4(0.25, 0.6, 0, 0.5), float4(0.5, 0.5, 0.5, 1), 1, Dodge) == float4(0.5, 1, 0, 1)
/// test: BlendColors(float4(0.75, 0.25, 1, 0.5), float4(0.5, 0.5, 0, 0), 1, Burn) == float4(0.5, 0, 1, 0)
/// test: BlendColors(float2(0.75, 0.25), 0.5, 1, LinearBurn) == float2(0.25, -0.25)
/// test: BlendColors(float2(0.5, 0.2), float2(0.25, 0.75), 1, HardLight) == float2(0.25, 0.6)
/// test: BlendColors(float4(0.5, 0.25, 0.2, 0.64), float4(0.25, 0.5, 0.75, 1), 1, SoftLight) == float4(0.375, 0.25, 0.324, 0.8)
/// test: BlendColors(float2(0.5, 0.25), float2(0.375, 0.75), 1, LinearLight) == float2(0.25, 0.75)
/// test: BlendColors(float4(0.75, 0.25, 0.5, 0), float4(0.25, 0.75, 0.5, 0.9), 1, VividLight) == float4(0.5, 0.5, 0.5, 0)
/// test: BlendColors(float4(0.75, 0.25, 0.6, 0.9), float4(0.25, 0.25, 0.9, 0.9), 1, PinLight) == float4(0.5, 0.25, 0.8, 0.9)
/// test: BlendColors(float3(0.75, 0.25, 0.5), float3(0.25, 0.5, 0.75), 1, HardMix) == float3(1, 0, 1)
[node("Color/Blend")] [also("BlendMode")]
floatN BlendColors(
    [color] floatN base = 0,          ///< the lower colour
    [color] floatN blend = 1,         ///< the upper colour
    [range(0, 1)] float opacity = 1,  ///< how much of the upper colour shows
    const BlendMode mode = Mix        ///< how they are combined
) {
    floatN screen = 1 - (1 - base) * (1 - blend);
    floatN combined = blend;
    if (mode == Multiply) { combined = base * blend; }
    if (mode == Screen) { combined = screen; }
    if (mode == Overlay) { combined = base < 0.5 ? 2 * base * blend : 2 * screen - 1; }
    if (mode == Add) { combined = base + blend; }
    if (mode == Darken) { combined = min(base, blend); }
    if (mode == Lighten) { combined = max(base, blend); }
    if (mode == Difference) { combined = abs(base - blend); }
    if (mode == Exclusion) { combined = base + blend - 2 * base * blend; }
    if (mode == Subtract) { combined = base - blend; }
    if (mode == Divide) { combined = base / max(blend, BLEND_FLOOR); }
    if (mode == Dodge) { combined = ColorDodge(base, blend); }
    if (mode == Burn) { combined = ColorBurn(base, blend); }
    if (mode == LinearBurn) { combined = base + blend - 1; }
    if (mode == HardLight) { combined = blend < 0.5 ? 2 * base * blend : 2 * screen - 1; }
    if (mode == SoftLight) { combined = SoftLightOf(base, blend); }
    if (mode == LinearLight) { combined = base + 2 * blend - 1; }
    if (mode == VividLight) {
        combined = blend <= 0.5 ? ColorBurn(base, 2 * blend) : ColorDodge(base, 2 * blend - 1);
    }
    if (mode == PinLight) { combined = blend <= 0.5 ? min(base, 2 * blend) : max(base, 2 * blend - 1); }
    if (mode == HardMix) { combined = step(1, base + blend); }
    return lerp(base, combined, opacity);
}

/// The modes of BlendUnity, under Unity's names.
enum BlendModeUnity {
    Burn,               ///< 1 - (1 - b) / a: the layers exchanged
    Darken,             ///< the darker of the two
    Difference,         ///< how far they are apart
    Dodge,              ///< a / (1 - b), without a limit
    Divide,             ///< a / b
    Exclusion,          ///< a + b - 2 a b
    HardLight,          ///< the product where b is dark, its opposite where it is bright
    HardMix,            ///< 1 where the sum reaches 1, else 0
    Lighten,            ///< the brighter of the two
    LinearBurn,         ///< a + b - 1
    LinearDodge,        ///< the sum
    LinearLight,        ///< a + 2 b - 1, not below 0 where b is dark, not above 1 where it is bright
    LinearLightAddSub,  ///< b + 2 a - 1: the layers exchanged
    Multiply,           ///< the product
    Negation,           ///< 1 - |1 - a - b|: like Difference, but brighter
    Overlay,            ///< the product where a is dark, its opposite where it is bright
    PinLight,           ///< the layers exchanged: the darker of a 2 and b where b is dark
    Screen,             ///< the opposite of Multiply
    SoftLight,          ///< as old picture editors compute it
    Subtract,           ///< a - b
    VividLight,         ///< the layers exchanged: decided by a
    Overwrite           ///< the upper colour
};

/// Blends one colour over another as Unity's node Blend does.
///
/// It is for graphs from there: some modes differ from the usual ones, and most results are not limited. A divisor of
/// zero counts as 1e-12.
///
/// formula: lerp(a, f(a, b), opacity); f as the modes say
/// formula: soft light: f = 2 a b + a^2 (1 - 2 b) where b < 0.5, else sqrt(a) (2 b - 1) + 2 a (1 - b)
/// formula: pin light: f = min(2 a, b) where b < 0.5, else max(2 a - 1, b)
/// formula: vivid light: f = 1 - (1 - b) / (2 a) where a < 0.5, else b / (2 (1 - a))
/// source: Unity Shader Graph, Blend
/// test: BlendUnity(float2(0.5, 1), float2(0.75, 0.25), 1, Burn) == float2(0.5, 0.25)
/// test: BlendUnity(float2(0.2, 0.75), float2(0.5, 0.25), 1, Darken) == float2(0.2, 0.25)
/// test: BlendUnity(float2(0.2, 0.75), float2(0.5, 0.25), 1, Difference) == float2(0.3, 0.5)
/// test: BlendUnity(float3(0.25, 0.6, 0), float3(0.5, 0.5, 1), 1, Dodge) == float3(0.5, 1.2, 0)
/// test: BlendUnity(float2(0.25, 0.2), float2(0.5, 0.1), 1, Divide) == float2(0.5, 2)
/// test: BlendUnity(float2(0.2, 0.75), float2(0.5, 1), 1, Exclusion) == float2(0.5, 0.25)
/// test: BlendUnity(float2(0.5, 0.2), float2(0.25, 0.75), 1, HardLight) == float2(0.25, 0.6)
/// test: BlendUnity(float2(0.75, 0.25), float2(0.5, 0.5), 1, HardMix) == float2(1, 0)
/// test: BlendUnity(float2(0.2, 0.75), float2(0.5, 0.25), 1, Lighten) == float2(0.5, 0.75)
/// test: BlendUnity(float2(0.75, 0.25), 0.5, 1, LinearBurn) == float2(0.25, -0.25)
/// test: BlendUnity(float2(0.75, 0.25), 0.5, 0.5, LinearDodge) == float2(1, 0.5)
/// test: BlendUnity(float4(0.5, 0.25, 0.75, 0.1), float4(0.375, 0.75, 0.75, 0.25), 1, LinearLight) == float4(0.25, 0.75, 1, 0)
/// test: BlendUnity(float2(0.5, 0.25), float2(0.375, 0.75), 1, LinearLightAddSub) == float2(0.375, 0.25)
/// test: BlendUnity(float3(0.2, 0.4, 0.6), float3(0.5, 1, 0), 1, Multiply) == float3(0.1, 0.4, 0)
/// test: BlendUnity(float2(0.2, 0.75), float2(0.5, 0.75), 1, Negation) == float2(0.7, 0.5)
/// test: BlendUnity(float3(0.2, 0.4, 0.75), float3(0.5, 1, 0.5)) == float3(0.2, 0.8, 0.75)
/// test: BlendUnity(float4(0.75, 0.1, 0.6, 0.9), float4(0.25, 0.25, 0.9, 0.7), 1, PinLight) == float4(0.25, 0.2, 0.9, 0.8)
/// test: BlendUnity(float3(0.2, 0.4, 0.6), float3(0.5, 1, 0), 1, Screen) == float3(0.6, 1, 0.6)
/// test: BlendUnity(float3(0.5, 0.25, 0.64), float3(0.25, 0.5, 1), 1, SoftLight) == float3(0.375, 0.25, 0.8)
/// test: BlendUnity(float2(0.75, 0.25), 0.5, 1, Subtract) == float2(0.25, -0.25)
/// test: BlendUnity(float2(0.75, 0.25), float2(0.25, 0.75), 1, VividLight) == float2(0.5, 0.5)
/// test: BlendUnity(float2(0.75, 0.25), float2(0.25, 0.75), 0.5, Overwrite) == float2(0.5, 0.5)
[node("Color/Blend Unity")] [inFloat]
floatN BlendUnity(
    [color] floatN base = 0,             ///< the lower colour, a
    [color] floatN blend = 0,            ///< the upper colour, b
    [range(0, 1)] float opacity = 1,     ///< how much of the result shows
    const BlendModeUnity mode = Overlay  ///< how they are combined
) {
    const float least = 1e-12;
    floatN product = 2 * base * blend;
    floatN opposite = 1 - 2 * (1 - base) * (1 - blend);
    floatN combined = blend;
    if (mode == Burn) { combined = 1 - (1 - blend) / (base + least); }
    if (mode == Darken) { combined = min(base, blend); }
    if (mode == Difference) { combined = abs(blend - base); }
    if (mode == Dodge) { combined = base / (1 - clamp(blend, 0.000001, 0.999999)); }
    if (mode == Divide) { combined = base / (blend + least); }
    if (mode == Exclusion) { combined = base + blend - product; }
    if (mode == HardLight) { combined = blend <= 0.5 ? product : opposite; }
    if (mode == HardMix) { combined = step(1 - base, blend); }
    if (mode == Lighten) { combined = max(base, blend); }
    if (mode == LinearBurn) { combined = base + blend - 1; }
    if (mode == LinearDodge) { combined = base + blend; }
    if (mode == LinearLight) {
        floatN sum = base + 2 * blend - 1;
        combined = blend < 0.5 ? max(sum, 0) : min(sum, 1);
    }
    if (mode == LinearLightAddSub) { combined = blend + 2 * base - 1; }
    if (mode == Multiply) { combined = base * blend; }
    if (mode == Negation) { combined = 1 - abs(1 - blend - base); }
    if (mode == Overlay) { combined = base <= 0.5 ? product : opposite; }
    if (mode == PinLight) { combined = blend >= 0.5 ? max(2 * (base - 0.5), blend) : min(2 * base, blend); }
    if (mode == Screen) { combined = 1 - (1 - blend) * (1 - base); }
    if (mode == SoftLight) {
        floatN dark = product + base * base * (1 - 2 * blend);
        floatN bright = sqrt(max(base, 0)) * (2 * blend - 1) + 2 * base * (1 - blend);
        combined = blend >= 0.5 ? bright : dark;
    }
    if (mode == Subtract) { combined = base - blend; }
    if (mode == VividLight) {
        // The half that is not taken must not divide by zero, either.
        floatN bright = blend / (2 * max(1 - base, least));
        floatN dark = 1 - (1 - blend) / (2 * max(base, least));
        combined = base >= 0.5 ? bright : dark;
    }
    return lerp(base, combined, opacity);
}
