/// How a ring fades.
enum RingShape {
    Soft,  ///< a sine
    Sharp  ///< on or off
};

float ring(float radius, float frequency) {
    return 0.5 + 0.5 * sin(TWO_PI * radius * frequency);
}

/// Rings around the middle, each finer than the one before.
[node("Custom/Rings")]
float Rings(
    float2 uv = uv0,               ///< where
    [range(1, 16)] int count = 4,  ///< how many octaves
    const RingShape shape = Soft,  ///< how a ring fades
    out float2 outwards            ///< away from the middle
) {
    float2 fromMiddle = uv - 0.5;
    float radius = length(fromMiddle);
    outwards = radius > 0 ? fromMiddle / radius : float2(0);
    float sum = 0;
    float frequency = 1;
    for (int i = 0; i < min(count, 16); i++) {
        float amount = ring(radius, frequency);
        if (shape == Sharp) amount = step(0.5, amount);
        sum += amount / frequency;
        frequency *= 2;
    }
    return sum * 0.5;
}
