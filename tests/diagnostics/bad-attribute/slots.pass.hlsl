struct Thin {
    float2 first;
};

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}

[slot]
float3 filledByNobody(LightingSurface surface);
[slot] [part("final")]
float3 ofWhat(LightingSurface surface, LightSum sum);
[slot] [part("final", "sum.direct")]
float3 unlikeFinal(LightingSurface surface);
[slot] [pack("direct")] [holds("f0")]
Thin packed(LightingSurface surface);
[slot] [pack]
SurfaceExtras packedOfNothing(LightingSurface surface);
[slot] [unpack("direct")]
LightingSurface unpacked(LightingSurface surface, SurfaceExtras extras);
[slot] [unpack("packSurface")]
LightingSurface unpackedOfNothing(LightingSurface surface);
[slot] [part("final", "sum.direct")] [without("final", "sum.direct")]
float3 madeTwice(LightingSurface surface, LightSum sum);
