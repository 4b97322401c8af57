// Periodic waves without a sine: each period is one unit of the value, and the results run from -1 to 1.

/// A saw: rises from -1 to 1 in each unit, and falls back at once. It is 0 at whole numbers.
///
/// formula: 2 (value - floor(value + 0.5))
/// test: SawtoothWave(0.25) == 0.5
/// test: SawtoothWave(float3(0, 0.5, -0.25)) == float3(0, -1, -0.5)
/// test: SawtoothWave(7.375) == 0.75
[node("Math/Wave/Sawtooth")] [range(-1, 1)]
floatN SawtoothWave(
    floatN value = 0  ///< periods
) {
    return 2 * (value - floor(value + 0.5));
}

/// A square wave: 1 in the first half of each unit, -1 in the second.
///
/// formula: 1 - 2 round(frac(value)), a half rounds down
/// test: SquareWave(0.25) == 1
/// test: SquareWave(float3(0.75, -0.25, 3)) == float3(-1, -1, 1)
/// test: SquareWave(0.5) == 1
[node("Math/Wave/Square")] [range(-1, 1)]
floatN SquareWave(
    floatN value = 0  ///< periods
) {
    return 2 * step(frac(value), 0.5) - 1;
}

/// A triangle wave: 1 half-way between whole numbers, -1 at them, straight in between.
///
/// formula: 2 |2 (value - floor(value + 0.5))| - 1
/// test: TriangleWave(0.125) == -0.5
/// test: TriangleWave(float3(0, 0.5, -0.25)) == float3(-1, 1, 0)
/// test: TriangleWave(5.75) == 0
[node("Math/Wave/Triangle")] [range(-1, 1)]
floatN TriangleWave(
    floatN value = 0  ///< periods
) {
    return 2 * abs(2 * (value - floor(value + 0.5))) - 1;
}

/// A fraction that looks random, from the digits that a sine loses: two machines may differ in it.
floatN LostDigits(floatN value) {
    return frac(sin(value) * 43758.5453);
}

/// A sine with noise on it.
///
/// The noise is a hash of sines, as shaders have used it for long: it differs a little from machine to machine.
///
/// formula: sin(value) + lerp(minimum, maximum, h), h = frac(43758.5453 sin(91.2228 (sin(value) - sin(value + 1))))
/// source: the hash: Rey, "On generating random numbers, with help of y = [(a+x)sin(bx)] mod 1", 1998, with the
/// source: constants 12.9898 + 78.233 that Unity's Noise Sine Wave uses
/// test: NoiseSineWave(0.5235987755982988, 0, 0) == 0.5
/// test: NoiseSineWave(float2(0, 1.5707963267948966), 0.25, 0.25) == float2(0.25, 1.25)
[node("Math/Wave/Noise Sine")] [inFloat]
floatN NoiseSineWave(
    [unit("rad")] floatN value = 0,  ///< angle of the sine
    float minimum = -0.5,            ///< the lowest that the noise adds
    float maximum = 0.5              ///< the highest that it adds
) {
    floatN sine = sin(value);
    return sine + lerp(minimum, maximum, LostDigits((sine - sin(value + 1)) * 91.2228));
}

/// A number in a range, for each seed another one.
///
/// The hash is one of sines, which differs a little from machine to machine; Random is the same everywhere, and constant
/// within a cell. Near seeds have unlike numbers: give it a value that is the same for a whole object or cell.
///
/// formula: lerp(minimum, maximum, frac(43758.5453 sin(12.9898 seed.x + 78.233 seed.y)))
/// source: Rey, "On generating random numbers, with help of y = [(a+x)sin(bx)] mod 1", 1998; the constants: Unity's
/// source: Random Range
/// test: RandomRange(float2(0, 0), 2, 6) == 2
/// test: RandomRange(float2(3, 8), 5, 5) == 5
/// test: RandomRange(float2(0.001, 0), 0, 1) == 0.3987666380378414 within 1e-2
[node("Math/Random Range")] [inFloat]
float RandomRange(
    float2 seed = 0,    ///< what the number depends on
    float minimum = 0,  ///< the lowest number
    float maximum = 1   ///< the highest number
) {
    return lerp(minimum, maximum, LostDigits(dot(seed, float2(12.9898, 78.233))));
}
