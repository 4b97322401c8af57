// Fog: the share of a colour that is still visible at a distance; the rest is the fog's own colour.

/// Linear fog: begins at one distance and hides everything at another.
///
/// If both distances are equal, the fog is a wall.
///
/// formula: saturate((end - distance) / (end - start))
/// source: Direct3D 9 and Unity built-in shaders, linear fog
/// test: FogLinear(15, 10, 30) == 0.75
/// test: FogLinear(5, 10, 30) == 1
/// test: FogLinear(40, 10, 30) == 0
/// test: FogLinear(9, 10, 10) == 1
/// test: FogLinear(11, 10, 10) == 0
[node("Lighting/Fog/Linear")] [range(0, 1)]
float FogLinear(
    [range(0, 1000)] [unit("m")] float distance,   ///< distance from the camera
    [range(0, 1000)] [unit("m")] float start = 0,  ///< where the fog begins
    [range(0, 1000)] [unit("m")] float end = 300   ///< where everything is hidden
) {
    return saturate((end - distance) / max(end - start, 1e-4));
}

/// Exponential fog of constant density: each metre removes the same share of light.
///
/// formula: exp(-density distance)
/// source: the law of Bouguer, Lambert and Beer; Unity built-in shaders, exponential fog
/// test: FogExponential(10, 0.1) == 0.36787944117144233
/// test: FogExponential(1, 0.6931471805599453) == 0.5
/// test: FogExponential(0, 5) == 1
[node("Lighting/Fog/Exponential")] [range(0, 1)]
float FogExponential(
    [range(0, 1000)] [unit("m")] float distance,  ///< distance from the camera
    [range(0, 10)] float density = 0.01           ///< density per metre
) {
    return exp(-max(density * distance, 0));
}

/// Squared exponential fog: near objects stay clear, and visibility falls along a bell curve.
///
/// formula: exp(-(density distance)^2)
/// source: Direct3D 9 and Unity built-in shaders, squared exponential fog
/// test: FogExponentialSquared(10, 0.1) == 0.36787944117144233
/// test: FogExponentialSquared(20, 0.1) == 0.01831563888873418
/// test: FogExponentialSquared(0, 5) == 1
[node("Lighting/Fog/Exponential Squared")] [range(0, 1)]
float FogExponentialSquared(
    [range(0, 1000)] [unit("m")] float distance,  ///< distance from the camera
    [range(0, 10)] float density = 0.01           ///< density per metre
) {
    float thickness = density * distance;
    return exp(-thickness * thickness);
}

/// The fog that an engine describes by four numbers.
///
/// test: FogFactor(15, float4(0, 0.1, 10, 30)) == 1
/// test: FogFactor(15, float4(1, 0.1, 10, 30)) == 0.75
/// test: FogFactor(10, float4(2, 0.05, 10, 30)) == 0.6065306597126334
/// test: FogFactor(20, float4(3, 0.1, 10, 30)) == 0.01831563888873418
[node("Lighting/Fog/Factor")] [range(0, 1)]
float FogFactor(
    [range(0, 1000)] [unit("m")] float distance,  ///< distance from the camera
    float4 settings = 0  ///< x: 0 no fog, 1 linear, 2 exponential, 3 exponential squared; y: density; z: start; w: end
) {
    float bent = settings.x < 2.5 ? FogExponential(distance, settings.y) : FogExponentialSquared(distance, settings.y);
    float factor = settings.x < 1.5 ? FogLinear(distance, settings.z, settings.w) : bent;
    return settings.x < 0.5 ? 1 : factor;
}
