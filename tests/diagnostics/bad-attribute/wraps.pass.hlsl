[wraps("position")] [with("tiles")]
float4 moved(float4 position) {
    return position;
}

[with("tiles")]
float half(float value) {
    return value / 2;
}

[pass("wraps")] [vertex]
float4 wrapsVertex(float3 position = positionOS) {
    return float4(position, 1);
}
[pass("wraps")] [fragment]
float4 wrapsFragment() {
    return float4(1);
}
