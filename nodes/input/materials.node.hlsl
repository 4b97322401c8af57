// The colours of known substances: what metals and dielectrics reflect when seen straight on, and what hot bodies shine in.

/// Metals whose reflectance has been measured.
enum Metal {
    Iron,       ///< dark grey
    Silver,     ///< nearly white
    Aluminium,  ///< light, slightly bluish
    Gold,       ///< yellow
    Copper,     ///< reddish
    Chromium,   ///< neutral grey
    Nickel,     ///< warm grey
    Titanium,   ///< dark, warm grey
    Cobalt,     ///< slightly warm grey
    Platinum    ///< warm, light grey
};

/// The reflectance of a metal seen straight on (f0), linear: the base colour of a pure metal.
///
/// source: Lagarde, "Feeding a physically based shading model", 2011, from measured indices of refraction
/// test: MetalReflectance(Iron) == float3(0.56, 0.57, 0.58)
/// test: MetalReflectance(Silver) == float3(0.972, 0.96, 0.915)
/// test: MetalReflectance(Aluminium) == float3(0.913, 0.921, 0.925)
/// test: MetalReflectance(Gold) == float3(1, 0.766, 0.336)
/// test: MetalReflectance(Copper) == float3(0.955, 0.637, 0.538)
/// test: MetalReflectance(Chromium) == float3(0.55, 0.556, 0.554)
/// test: MetalReflectance(Nickel) == float3(0.66, 0.609, 0.526)
/// test: MetalReflectance(Titanium) == float3(0.542, 0.497, 0.449)
/// test: MetalReflectance(Cobalt) == float3(0.662, 0.655, 0.634)
/// test: MetalReflectance(Platinum) == float3(0.672, 0.637, 0.585)
[node("Input/Material/Metal Reflectance")]
float3 MetalReflectance(
    const Metal metal = Iron  ///< which metal
) {
    if (metal == Iron) { return float3(0.56, 0.57, 0.58); }
    if (metal == Silver) { return float3(0.972, 0.96, 0.915); }
    if (metal == Aluminium) { return float3(0.913, 0.921, 0.925); }
    if (metal == Gold) { return float3(1, 0.766, 0.336); }
    if (metal == Copper) { return float3(0.955, 0.637, 0.538); }
    if (metal == Chromium) { return float3(0.55, 0.556, 0.554); }
    if (metal == Nickel) { return float3(0.66, 0.609, 0.526); }
    if (metal == Titanium) { return float3(0.542, 0.497, 0.449); }
    if (metal == Cobalt) { return float3(0.662, 0.655, 0.634); }
    return float3(0.672, 0.637, 0.585);
}

/// Substances that are no metals.
enum Dielectric {
    Common,       ///< most substances: 0.034 to 0.048
    RustedMetal,  ///< rust
    Water,        ///< water
    Ice,          ///< ice
    Glass,        ///< window glass
    Custom        ///< by its index of refraction
};

/// The reflectance of a substance that is no metal, seen straight on (f0).
///
/// formula: Common: lerp(0.034, 0.048, place); Custom: ((ior - 1) / (ior + 1))^2
/// source: Fresnel's equations at normal incidence; the numbers: Unity Shader Graph, node Dielectric Specular
/// test: DielectricSpecular(Common, 0.5) == 0.041
/// test: DielectricSpecular(Common, 0) == 0.034
/// test: DielectricSpecular(RustedMetal) == 0.03
/// test: DielectricSpecular(Water) == 0.02
/// test: DielectricSpecular(Ice) == 0.018
/// test: DielectricSpecular(Glass) == 0.04
/// test: DielectricSpecular(Custom, 0, 1.5) == 0.04
/// test: DielectricSpecular(Custom, 0, 1) == 0
[node("Input/Material/Dielectric Specular")] [range(0, 1)]
float DielectricSpecular(
    const Dielectric substance = Common,  ///< which substance
    [range(0, 1)] float place = 0.5,      ///< of Common: how much it reflects, among those of its kind
    [range(1, 3)] float ior = 1           ///< of Custom: its index of refraction
) {
    if (substance == Common) { return lerp(0.034, 0.048, place); }
    if (substance == RustedMetal) { return 0.03; }
    if (substance == Water) { return 0.02; }
    if (substance == Ice) { return 0.018; }
    if (substance == Glass) { return 0.04; }
    float ratio = (ior - 1) / (ior + 1);
    return ratio * ratio;
}

/// The colour in which a hot body shines, linear; its largest component is 1. Multiply it by how bright the body is.
///
/// The colour lies on the Planckian locus. Below about 1900 K, it is more red than a screen can show: blue and green end at 0.
///
/// formula: u, v of CIE 1960 as quotients of polynomials of the temperature; x = 3 u / (2 u - 8 v + 4), y = 2 v / (2 u - 8 v + 4)
/// source: Krystek, "An algorithm to calculate correlated colour temperature", Color Research & Application 10(1), 1985;
/// source: the matrix: IEC 61966-2-1 (sRGB)
/// test: Blackbody(6500) == float3(1.0, 0.9418596832140064, 0.9922907545668003)
/// test: Blackbody(3000) == float3(1.0, 0.47733926412972655, 0.15297008193010514)
/// test: Blackbody(1000) == float3(1.0, 0.008643091886246007, 0.0)
/// test: Blackbody(15000) == float3(0.4590803071189682, 0.5808331361294748, 1.0)
[node("Input/Material/Blackbody")] [also("ColorTemperature", "Kelvin", "PlanckianLocus")]
float3 Blackbody(
    [range(1000, 15000)] [unit("K")] float temperature = 6500  ///< in kelvin: 1900 a candle, 2700 a bulb, 5800 the sun
) {
    // Tens of thousands of kelvin, so that the squares stay small.
    float t = clamp(temperature, 1000, 15000) / 10000;
    float u = (0.860117757 + 1.54118254 * t + 12.8641212 * t * t) / (1 + 8.42420235 * t + 70.8145163 * t * t);
    float v = (0.317398726 + 0.422806245 * t + 4.20481691 * t * t) / (1 - 0.289741816 * t + 16.1456053 * t * t);
    // X, Y and Z for Y = 1: x / y, 1, (1 - x - y) / y.
    float x = 1.5 * u / v;
    float z = (2 - 0.5 * u) / v - 5;
    float3 color = float3(3.2404542 * x - 1.5371385 - 0.4985314 * z, -0.969266 * x + 1.8760108 + 0.041556 * z,
                          0.0556434 * x - 0.2040259 + 1.0572252 * z);
    color = max(color, 0);
    return color / max(color.r, max(color.g, color.b));
}

/// The colour of a hot body as Unity's Shader Graph computes it: a fit of a table of colours for screens, dark below 1000 K.
///
/// Its numbers are those of an encoded colour and are used as they are; Blackbody is linear.
///
/// formula: red 56100000 T^-1.5 + 148; green 100.04 log(T) - 623.6, from 6500 K on 35200000 T^-1.5 + 184; blue 194.18 log(T) - 1448.6;
/// formula: each limited to 0..255 and divided by 255; below 1000 K times T / 1000
/// source: Unity Shader Graph, node Blackbody; the table: Charity, "What color is a blackbody?", 2001
/// test: BlackbodyUnity(800) == float3(0.8, 0.1415797874067432, 0) within 1e-3
/// test: BlackbodyUnity(3000) == float3(1.0, 0.6955176920303163, 0.41598609524048963) within 1e-3
/// test: BlackbodyUnity(10000) == float3(0.8003921568627451, 0.8596078431372549, 1.0)
[node("Input/Material/Blackbody (Unity)")] [inFloat]
float3 BlackbodyUnity(
    [range(1, 40000)] [unit("K")] float temperature = 512  ///< in kelvin; above zero
) {
    float t = max(temperature, 1);
    float power = 1 / (t * sqrt(t));
    float logarithm = log(t);
    float green = t > 6500 ? 35200000 * power + 184 : 100.04 * logarithm - 623.6;
    float3 color = float3(56100000 * power + 148, green, 194.18 * logarithm - 1448.6);
    return saturate(color / 255) * min(t / 1000, 1);
}
