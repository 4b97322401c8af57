[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment] [needs("aded")]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}

[static("slot", "aded")] bool hasAdded;
[slot] [part("finl", "sum.direct")]
float3 halfOfIt(LightingSurface surface, LightSum sum);
[slot] [unpack("packSurfaces")]
LightingSurface unpacked(LightingSurface surface, SurfaceExtras extras);
