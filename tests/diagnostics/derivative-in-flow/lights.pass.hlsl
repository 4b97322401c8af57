[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    float3 sum = float3(0);
    [light] for (int i = 0; i < min(lightCount, MAX_LIGHTS); i++) {
        sum += ddx(lightAt(i, position).radiance);
    }
    return float4(sum, 1);
}
