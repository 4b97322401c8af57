[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
LightSum mineFragment(float3 position = positionWS) {
    LightSum made; return made;
}
