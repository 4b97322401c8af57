// Depth and shading normals in one texture of four bytes, as Unity's camera offers them: red and green hold the normal
// in view space, blue and alpha the distance along the camera's axis as a fraction of the far plane's.

[pass("depth-normals")] [fragment] [lights("none")] [target("color", "rgba8")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 depthNormalsFragment(float3 position = positionWS) {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    float share = saturate(-positionVS(position).z / clipPlanes.y);
    return float4(EncodeNormalStereographic(normalVS(lit.normalWS)), EncodeFloatRG(share));
}
