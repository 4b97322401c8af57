[static("surfaces", "cutout")] bool asksNothing;
[static("surface", "cutuot")] bool asksSurface;
[static("cull", "of")] bool asksCull;
[builtin("fragcoord")] float4 pixel;
[reads("gbufferNormals")] Texture2D normals;

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}
