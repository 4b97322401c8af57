// Depth only, with alpha clipping.

[pass("depth-only")] [pass("depth-normals")] [vertex]
float4 depthVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}

[pass("depth-only")] [fragment] [lights("none")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void depthFragment() {
    if (alphaClip) {
        LightingSurface lit = lightingSurface();
        discardIf(lit.alpha < lit.alphaClip);
    }
}
