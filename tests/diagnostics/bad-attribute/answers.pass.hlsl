[static("pass", "depth-only")] bool glows;

[semantic("pixel")]
float brightness() {
    return glows ? 2 : 1;
}

[pass("answers")] [vertex]
float4 answers_vertex(float3 position = position_ws) {
    return mul(world_to_clip, float4(position, 1));
}

[pass("answers")] [fragment] [blend("one", "zero")]
float4 answers_fragment(float bright = brightness) {
    return float4(bright);
}
