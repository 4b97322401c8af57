// Depth and shaded normals in one texture of four bytes, as Unity's camera offers them: red and green hold the normal in
// view space, blue and alpha the distance along the camera's axis as a share of the far plane's.

[pass("depth-normals")] [fragment] [lights("none")] [target("color", "rgba8")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 depth_normals_fragment(float3 position = position_ws) {
    LightingSurface lit = lighting_surface();
    if (alpha_clip) {
        discard_if(lit.alpha < lit.alphaClip);
    }
    float share = saturate(-position_vs(position).z / clip_planes.y);
    return float4(EncodeNormalStereographic(normal_vs(lit.normal_ws)), EncodeFloatRG(share));
}
