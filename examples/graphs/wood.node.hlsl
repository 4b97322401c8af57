/// Growth rings of a log that stands along y: pale early wood that darkens slowly, then ends at a sharp line.
///
/// test: Wood(float3(0, 5, 0)) == 0
/// test: Wood(float3(0.8, 0, 0), 0, 1) == 1
/// test: Wood(float3(0, 3, 2), 0, 1.4) == 1
[node("Examples/Wood")]
float Wood(
    float3 position = positionOS,     ///< in the log
    float wobble = 0,                  ///< moves the rings, in rings: noise makes them uneven
    [range(0, 50)] float rings = 8,    ///< in one unit from the middle
    out float fibre                    ///< fine streaks along the log, 0 to 1
) {
    float ring = frac(length(position.xz) * rings + wobble);
    // Streaks: noise that is forty times as long as it is wide.
    float across = GradientNoise(float2(position.x + 0.37 * position.z, position.y * 0.025), 60);
    float through = GradientNoise(float2(position.z - 0.37 * position.x, position.y * 0.025 + 7), 60);
    fibre = saturate(0.5 * (across + through));
    return smoothstep(0, 0.75, ring) * (1 - smoothstep(0.88, 1, ring));
}
