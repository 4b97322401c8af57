[extern("Wind")] float3 windDirection;

[pass("wind")] [vertex]
float4 windVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position + 0.1 * windDirection, 1));
}

[pass("wind")] [fragment] [lights("none")]
[blend("opaque", "one", "zero")]
float4 windFragment() {
    return float4(0.5, 0.5, 0.5, 1);
}
