[reads("depth")] float depth_number;
[reads] Texture2D of_nothing;
[extern] float of_no_block;
[extern("Frame")] Light no_number;
[extern("Material")] float of_the_material;
[static("surface", "cutout")] float no_answer;
[static] bool no_question;
[switch] int many_ways;
[attribute(7, "TEXCOORD7")] float4 of_no_mesh;
[given] float4 of_no_graph;

[pass("mine")] [vertex]
float4 mine_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mine_fragment(float3 position = position_ws) {
    return float4(lit_by_all(lighting_surface(), position), 1);
}
