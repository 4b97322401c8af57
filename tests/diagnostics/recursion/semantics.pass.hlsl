[semantic("pixel")]
float3 first(float3 value = second) {
    return value;
}
[semantic("vertex")]
float3 second(float3 value = first) {
    return value;
}
[semantic("pixel")]
float4 own(float4 value = own) {
    return value;
}

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = first) {
    return float4(litByAll(lightingSurface(), position), 1);
}
