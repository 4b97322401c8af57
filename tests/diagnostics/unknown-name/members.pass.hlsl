// Members that nothing has, and that are near to what is there.
[slot] [part("final", "sum.dirct")]
float3 addedTwice(LightingSurface surface, LightSum sum);
[slot] [part("final", "total.direct")]
float3 addedThrice(LightingSurface surface, LightSum sum);
[slot] [part("indirect", "EnvironmentRadiants")]
float3 mirrored(LightingSurface surface);

[pass("members")] [vertex]
float4 membersVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("members")] [fragment] [lights("none")]
float4 membersFragment() {
    return float4(lightingSurface().diffuseColor, 1);
}
