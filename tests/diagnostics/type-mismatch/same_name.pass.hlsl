struct SurfaceExtras {
    float4 first;
    float4 second;
    float4 third;
};
[slot] [pack("direct")] [holds("diffuseColor", "f0", "roughness", "normalWS", "occlusion")]
SurfaceExtras packSurface(LightingSurface surface);
[slot] [unpack("packSurface")]
LightingSurface unpackSurface(LightingSurface surface, SurfaceExtras extras);

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float2 uv = uv0) {
    return float4(toldInFull(uv).normalWS, 1);
}
