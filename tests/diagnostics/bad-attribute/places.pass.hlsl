[fragment] [cull("off")] float3 noPass() {
    return float3(0);
}
[vertex] float3 noPassEither() {
    return float3(0);
}
[part("final", "sum.direct")] float3 noSlot(LightingSurface surface, LightSum sum) {
    return float3(0);
}
[with("fog")] const float MIST = 3;
[perObject] [switch] bool mist;
[node("Mine/Foo")] [also("Bar")] [is("direction")] [range(0, 1)] float3 notANode(float3 x) {
    return x;
}
[gives("positionWS", "forward-add")] float3 elsewhere(float3 position = positionOS) {
    return position;
}
[gives("positionWS", "forward")] float3 inTheFallback(float3 position = positionOS) {
    return position;
}

[pass("mine")] [vertex] [blend("one", "one")]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment] [gives("uv0", "mine")] [fallback("forward")]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}
