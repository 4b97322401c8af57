// A node of your own. A graph uses it by "node": "./rings.node.hlsl". Look at it: patina node rings.node.hlsl

/// Rings that run outwards, as when a drop falls into water.
///
/// formula: 0.5 + 0.5 cos(2 pi (count d - seconds)), d: distance to the centre
/// test: Rings(float2(0.5, 0.5), 8, 0) == 1
/// test: Rings(float2(0.5, 0.5), 8, 0.5) == 0
[node("Procedural/Rings")] [range(0, 1)]
float Rings(
    float2 uv = uv0,                  ///< where; (0.5, 0.5) is the centre
    [range(1, 50)] float count = 8,   ///< rings in one unit of uv
    [unit("s")] float seconds = time  ///< the clock: one ring passes in each second
) {
    float away = length(uv - 0.5);
    return 0.5 + 0.5 * cos(TWO_PI * (count * away - seconds));
}
