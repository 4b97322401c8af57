// Spherical harmonics: summing nine coefficients, exchanging axes, and the coefficients of a single light.
// Coefficients are numbered l (l + 1) + m, without the Condon-Shortley sign, as in EvaluateSH9.

/// Evaluates nine coefficients in a direction: radiance from radiance, irradiance from irradiance.
///
/// The node neither convolves (EvaluateSH9 does) nor clamps: opposite to a strong light the sum can swing below
/// zero.
///
/// formula: sum over l, m of c_lm Y_lm(d)
/// source: Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps", SIGGRAPH 2001
/// test: SumSH9(float3(0.6, 0, 0.8), ZUp, 3.5449077018110318, 0, 0, 0, 0, 0, 0, 0, 0) == float3(1, 1, 1)
/// test: SumSH9(float3(0, 0, 1), ZUp, 2.7841639984158535, 0, 2.1432504452712773, 0, 0, 0, 0.38909874756034163, 0, 0) == 2.0780326406557483
/// test: SumSH9(float3(0, 0, 1), ZUp, 0, 0, 2, 0, 0, 0, 0, 0, 0) == 0.9772050238058398
/// test: SumSH9(float3(0, 1, 0), YUp, 0, 0, 2, 0, 0, 0, 0, 0, 0) == 0.9772050238058398
/// test: SumSH9(float3(0, 0, -1), ZUp, 0, 0, 2, 0, 0, 0, 1, 0, 0) == -0.3464218933007994
/// test: SumSH9(float3(0.6, 0.8, 0), ZUp, 0, 1, 0, 1, 1, 0, 0, 0, 1) == 1.055509983065395
[node("Lighting/Ambient/Sum SH9")]
float3 SumSH9(
    float3 direction = normalWS,  ///< unit direction
    const SHOrder order = ZUp,     ///< which axis is up
    float3 sh0,                    ///< l = 0
    float3 sh1,                    ///< l = 1: along y; y-up: along z
    float3 sh2,                    ///< l = 1: along z; y-up: along y
    float3 sh3,                    ///< l = 1: along x
    float3 sh4,                    ///< l = 2: x y; y-up: x z
    float3 sh5,                    ///< l = 2: y z
    float3 sh6,                    ///< l = 2: 3 z^2 - 1; y-up: 3 y^2 - 1
    float3 sh7,                    ///< l = 2: x z; y-up: x y
    float3 sh8                     ///< l = 2: x^2 - y^2; y-up: x^2 - z^2
) {
    float3 l1 = SHBasis(direction, order).l1;
    float4 l2 = SHBasis(direction, order).l2;
    float3 sum = sh0 * SHBasis(direction, order).l0 + sh1 * l1.x + sh2 * l1.y + sh3 * l1.z;
    sum += sh4 * l2.x + sh5 * l2.y + sh6 * l2.z + sh7 * l2.w;
    return sum + sh8 * SHBasis(direction, order).l2Last;
}

/// Converts nine coefficients of an environment to the other up axis: from z-up to y-up, and back.
///
/// The first coefficient is the same in both.
///
/// formula: c1' = c2, c2' = c1, c3' = c3, c4' = c7, c5' = c5, c7' = c4,
/// formula: c6' = -c6 / 2 - sqrt(3) / 2 c8, c8' = -sqrt(3) / 2 c6 + c8 / 2
/// source: the basis with y and z exchanged, expressed in the basis
/// test: SwapSHAxes(1, 2, 3, 4, 5, 0, 7, 0).swapped1 == float3(2, 2, 2)
/// test: SwapSHAxes(1, 2, 3, 4, 5, 0, 7, 0).swapped4 == float3(7, 7, 7)
/// test: SwapSHAxes(0, 0, 0, 0, 0, 1, 0, 0).swapped6 == -0.5
/// test: SwapSHAxes(0, 0, 0, 0, 0, 1, 0, 0).swapped8 == -0.8660254037844386
/// test: SwapSHAxes(0, 0, 0, 0, 0, 0, 0, 1).swapped6 == -0.8660254037844386
/// test: SwapSHAxes(0, 0, 0, 0, 0, 0, 0, 1).swapped8 == 0.5
[node("Lighting/Ambient/Swap SH Axes")]
void SwapSHAxes(
    float3 sh1,           ///< l = 1: along y; y-up: along z
    float3 sh2,           ///< l = 1: along z; y-up: along y
    float3 sh3,           ///< l = 1: along x
    float3 sh4,           ///< l = 2: x y; y-up: x z
    float3 sh5,           ///< l = 2: y z
    float3 sh6,           ///< l = 2: 3 z^2 - 1; y-up: 3 y^2 - 1
    float3 sh7,           ///< l = 2: x z; y-up: x y
    float3 sh8,           ///< l = 2: x^2 - y^2; y-up: x^2 - z^2
    out float3 swapped1,  ///< l = 1, m = -1
    out float3 swapped2,  ///< l = 1, m = 0
    out float3 swapped3,  ///< l = 1, m = 1
    out float3 swapped4,  ///< l = 2, m = -2
    out float3 swapped5,  ///< l = 2, m = -1
    out float3 swapped6,  ///< l = 2, m = 0
    out float3 swapped7,  ///< l = 2, m = 1
    out float3 swapped8   ///< l = 2, m = 2
) {
    const float root = 0.86602540378443865;  // sqrt(3) / 2
    swapped1 = sh2;
    swapped2 = sh1;
    swapped3 = sh3;
    swapped4 = sh7;
    swapped5 = sh5;
    swapped6 = -0.5 * sh6 - root * sh8;
    swapped7 = sh4;
    swapped8 = 0.5 * sh8 - root * sh6;
}

/// The irradiance of a directional light that nine coefficients represent: a soft light, with a faint one opposite.
///
/// It is E(n) divided by the E of a surface that faces the light. Nine coefficients make that 17 / 16, so a light of
/// E / pi is added to them with the factor 16 pi / 17.
///
/// formula: 1 / 4 + c / 2 + 5 / 32 (3 c^2 - 1), c = n.l
/// source: Sloan, "Stupid Spherical Harmonics Tricks", GDC 2008: the addition theorem, convolved with the cosine
/// test: SHDirectionalLight(float3(1, 2, 2) / 3, float3(1, 2, 2) / 3) == 1.0625
/// test: SHDirectionalLight(float3(0, 0, 1), float3(0, 0, -1)) == 0.0625
/// test: SHDirectionalLight(float3(0, 0, 1), float3(1, 0, 0)) == 0.09375
[node("Lighting/Ambient/SH Directional Light")]
float SHDirectionalLight(
    float3 normal = normalWS,          ///< unit normal
    float3 lightDir = light.direction  ///< unit direction to the light
) {
    float c = dot(normal, lightDir);
    return 0.25 + 0.5 * c + 0.15625 * (3 * c * c - 1);
}

/// The built-in environment of the shader CL/pbr-specular: nine coefficients of a bright sky, with y up.
///
/// The coefficients are those of E / pi. Below the horizon, blue swings a little below zero: the encoded form clamps it
/// before its power, the linear one keeps it.
///
/// formula: sum over l, m of c_lm Y_lm(n), y and z exchanged; gamma: max(1.055 max(sum, 0)^0.416666667 - 0.055, 0)
/// source: the coefficients: the shader CL/pbr-specular of the notes "Lighting models"
/// test: StudioSkySH(float3(0, 1, 0)) == float3(0.4623682976584511, 0.5989277753568758, 0.77809948882419)
/// test: StudioSkySH(float3(0, 0, -1)) == float3(0.6251481851714252, 0.5839359521728683, 0.4527443166202885)
/// test: StudioSkySH(float3(0, -1, 0), Gamma) == float3(0.41032653351109655, 0.3077833271159935, 0)
/// test: StudioSkySH(float3(0, 1, 0), Gamma) == float3(0.710004776159182, 0.7971024527280397, 0.8952774649119528)
[node("Lighting/Ambient/Studio Sky SH")]
float3 StudioSkySH(
    float3 normal = normalWS,         ///< unit normal in the world, y up
    const WorkingSpace space = Linear  ///< colour space that lighting is computed in
) {
    float3 sum = SumSH9(normal, YUp, float3(1.81877, 1.86597, 1.7507), float3(0.155764, 0.164684, 0.186911),
                        float3(0.329662, 0.533947, 0.816486), float3(-0.020924, -0.0446067, -0.076697),
                        float3(0.0514308, 0.0588754, 0.0774349), float3(0.11579, 0.109153, 0.109399),
                        float3(-0.335727, -0.298582, -0.181839), float3(0.0867315, 0.0715153, 0.0523889),
                        float3(-0.150664, -0.0802716, 0.0130783));
    return space == Linear ? sum : LinearToSrgbApproximate(sum);
}
