// A ramp over the pixels, in a target of ten bits: how does the device round?

[pass("ten_bits")] [vertex]
float4 tenBitsVertex(float3 position = positionOS) {
    return float4(position.xy, 0, 1);
}

[pass("ten_bits")] [fragment] [lights("none")] [cull("off")] [target("color", "rgb10a2")] [blend("opaque", "one", "zero")]
float4 tenBitsFragment(float4 pixel = fragCoord) {
    float number = (pixel.y - 0.5) * screenSize.x + pixel.x - 0.5;
    return float4(float3(number / (screenSize.x * screenSize.y)), 1);
}
