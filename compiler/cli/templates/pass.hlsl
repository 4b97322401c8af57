// A rendering path of your own: patina render rust.graph.json --path ./mine.pass.hlsl
// Each pass is two functions, one for each stage. This one shows where the surface faces.

[pass("facing")] [vertex]
float4 facingVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}

// It needs no lights, and replaces what was drawn before.
[pass("facing")] [fragment] [lights("none")]
[blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
float4 facingFragment() {
    LightingSurface lit = lightingSurface();
    if (alphaClip) {
        discardIf(lit.alpha < lit.alphaClip);
    }
    return float4(0.5 + 0.5 * lit.normalWS, 1);
}
