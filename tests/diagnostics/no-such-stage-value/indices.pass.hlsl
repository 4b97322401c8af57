[builtin("vertexIndex")] int vertexIndex;

[semantic("pixel")]
float number(int index = vertexIndex) {
    return float(index);
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float shown = number) {
    return float4(shown);
}
