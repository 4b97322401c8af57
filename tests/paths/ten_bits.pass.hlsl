// A ramp over the pixels, in a target of ten bits: how does the device round?

[pass("ten_bits")] [vertex]
float4 ten_bits_vertex(float3 position = position_os) {
    return float4(position.xy, 0, 1);
}

[pass("ten_bits")] [fragment] [lights("none")] [cull("off")] [target("color", "rgb10a2")] [blend("opaque", "one", "zero")]
float4 ten_bits_fragment(float4 pixel = frag_coord) {
    float number = (pixel.y - 0.5) * screen_size.x + pixel.x - 0.5;
    return float4(float3(number / (screen_size.x * screen_size.y)), 1);
}
