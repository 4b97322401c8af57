// Curves as values: a graph writes one as its keys, and a property holds one that can be set.

/// A curve: up to sixteen keys, which are joined by cubic pieces.
struct Curve {
    /// [0].x: how many keys there are. [1] to [16]: the time and the value of a key, and the slopes before and after it.
    float4 keys[17];
};

/// A cubic between two keys that has their values and slopes (Hermite); constant before and after them.
[inline]
float CurvePiece(float4 from, float4 to, float time) {
    float span = to.x - from.x;
    float t = saturate((time - from.x) / max(span, 1e-6));
    float rise = to.y - from.y;
    float start = from.w * span;
    float end = to.z * span;
    return from.y + t * (start + t * (3 * rise - 2 * start - end + t * (start + end - 2 * rise)));
}

/// The value of a curve at a time.
///
/// Before the first key and after the last one, it is constant. Two keys at one time are a step.
///
/// formula: t = saturate((time - t0) / (t1 - t0)); v = cubic Hermite of the two keys around the time: v0, v1, and their slopes
/// source: de Boor, "A Practical Guide to Splines", 1978, ch. IV (cubic Hermite interpolation)
[node("Math/Range/Sample Curve")] [inline] [inFloat] [also("Curve", "AnimationCurve", "FloatCurve")]
float SampleCurve(
    Curve curve,    ///< { "keys": [[0, 0, 0, 0], [1, 1, 0, 0]] }, or a property
    float time = 0  ///< where on the curve
) {
    float value = CurvePiece(curve.keys[1], curve.keys[2], time);
    [unroll] for (int i = 3; i < min(int(curve.keys[0].x) + 1, 17); i++) {
        float4 from = curve.keys[i - 1];
        float next = CurvePiece(from, curve.keys[i], time);
        value = time > from.x ? next : value;
    }
    return value;
}
