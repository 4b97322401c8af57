[static("pass", "depth-only")] bool glows;

[semantic("pixel")]
float brightness() {
    return glows ? 2 : 1;
}

[pass("answers")] [vertex]
float4 answersVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}

[pass("answers")] [fragment] [blend("one", "zero")]
float4 answersFragment(float bright = brightness) {
    return float4(bright);
}
