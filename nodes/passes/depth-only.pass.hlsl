// Depth, and nothing else but what alpha clipping asks for.

[pass("depth-only")] [pass("depth-normals")] [vertex]
float4 depth_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("depth-only")] [fragment] [lights("none")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void depth_fragment() {
    if (alpha_clip) {
        LightingSurface lit = lighting_surface();
        discard_if(lit.alpha < lit.alphaClip);
    }
}
