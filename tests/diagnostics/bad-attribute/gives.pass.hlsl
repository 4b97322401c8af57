[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}

[gives("positonWS", "mine")]
float3 misspelt() {
    return float3(0);
}
[gives("positionWS")]
float3 toNobody() {
    return float3(0);
}
[gives("time", "mine")]
float noSemantic() {
    return 0;
}
[gives("uv0", "mine")]
float2 first() {
    return float2(0);
}
[gives("uv0", "mine")]
float2 second() {
    return float2(1);
}
